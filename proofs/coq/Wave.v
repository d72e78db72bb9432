(* SPDX-License-Identifier: GPL-3.0-or-later *)
(** * Section 2: one wave

    Lengths in units of the wave: xi = pi x/lambda in [0, pi/2] is half a period. Pressures in units of p*; the load is x = pbar/p*.
    [pressure x xi] is (2.2) for x >= 1 (full contact) and (2.4) with (2.5) for x < 1, 0 outside the contact: Coq's square root is 0
    left of 0, and with sin^2(pi a/lambda) = x from (2.5) equation (2.4) reads 2 cos xi sqrt(x - sin^2 xi). *)

From Coq Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
Open Scope R_scope.

Definition pressure (x xi : R) : R :=
  if Rle_dec 1 x then x + cos (2 * xi) else 2 * cos xi * sqrt (x - sin xi * sin xi).

(** ** The half width (2.5) and the arcsine identities *)

Definition half_width (x : R) : R := asin (sqrt x).

Lemma sqrt_in_unit (x : R) : 0 <= x <= 1 -> 0 <= sqrt x <= 1.
Proof.
  intros [low high]. split; [apply sqrt_pos |].
  replace 1 with (sqrt 1) by apply sqrt_1. apply sqrt_le_1; lra.
Qed.

(** sin^2(pi a/lambda) = pbar/p* and cos^2(pi a/lambda) = 1 - pbar/p*, what (2.4) takes from (2.5). *)
Theorem sine_of_half_width (x : R) : 0 <= x <= 1 -> sin (half_width x) * sin (half_width x) = x.
Proof.
  intro range. unfold half_width. pose proof (sqrt_in_unit x range).
  rewrite sin_asin by lra. apply sqrt_sqrt. lra.
Qed.

Theorem cosine_of_half_width (x : R) : 0 <= x <= 1 -> cos (half_width x) * cos (half_width x) = 1 - x.
Proof.
  intro range. pose proof (sine_of_half_width x range) as sine.
  pose proof (sin2_cos2 (half_width x)) as one. unfold Rsqr in one. lra.
Qed.

Lemma half_width_range (x : R) : 0 <= x <= 1 -> 0 <= half_width x <= PI / 2.
Proof.
  intro range. pose proof (sqrt_in_unit x range) as root. unfold half_width. split; [| apply asin_bound].
  destruct (Rle_lt_dec 0 (asin (sqrt x))) as [| negative]; [assumption |]. exfalso.
  pose proof (asin_bound (sqrt x)). pose proof PI_RGT_0.
  pose proof (sin_lt_0_var (asin (sqrt x)) ltac:(lra) negative) as below.
  rewrite sin_asin in below by lra. lra.
Qed.

(** The angle doubled: 2 arcsin sqrt x = arccos(1 - 2x), the form in which (2.5) continues (2.13) at p = 0. *)
Theorem doubled_half_width (x : R) : 0 <= x <= 1 -> 2 * half_width x = acos (1 - 2 * x).
Proof.
  intro range. pose proof (sqrt_in_unit x range) as root.
  pose proof (half_width_range x range).
  rewrite <- (acos_cos (2 * half_width x)); [| lra].
  f_equal. rewrite cos_2a, sine_of_half_width, cosine_of_half_width by assumption. ring.
Qed.

(** (2.4) as printed, 2 pbar cos/sin^2(pi a/lambda) sqrt(sin^2(pi a/lambda) - sin^2 xi), is [pressure] for 0 < x < 1. *)
Theorem pressure_as_printed (x xi : R) : 0 < x < 1 ->
  2 * x * cos xi / (sin (half_width x) * sin (half_width x)) * sqrt (sin (half_width x) * sin (half_width x) - sin xi * sin xi)
  = pressure x xi.
Proof.
  intro range. rewrite sine_of_half_width by lra.
  unfold pressure. destruct (Rle_dec 1 x); [lra |]. field. lra.
Qed.

(** ** Order: the pressure at a place is not negative, and grows with the load *)

Lemma cos_in_quarter (xi : R) : 0 <= xi <= PI / 2 -> 0 <= cos xi.
Proof. intro range. apply cos_ge_0; pose proof PI_RGT_0; lra. Qed.

(** Both branches of [pressure] agree at the seam x = 1. *)
Lemma seam (xi : R) : 0 <= xi <= PI / 2 -> 2 * cos xi * sqrt (1 - sin xi * sin xi) = 1 + cos (2 * xi).
Proof.
  intro range. pose proof (cos_in_quarter xi range) as positive.
  pose proof (sin2_cos2 xi) as one. unfold Rsqr in one.
  replace (1 - sin xi * sin xi) with (cos xi * cos xi) by lra.
  rewrite sqrt_square by assumption. rewrite cos_2a_cos. ring.
Qed.

Theorem pressure_positive (x xi : R) : 0 <= xi <= PI / 2 -> 0 <= pressure x xi.
Proof.
  intro range. unfold pressure. destruct (Rle_dec 1 x).
  - pose proof (COS_bound (2 * xi)). lra.
  - pose proof (cos_in_quarter xi range). pose proof (sqrt_pos (x - sin xi * sin xi)). nra.
Qed.

Theorem pressure_increases (x y xi : R) : 0 <= xi <= PI / 2 -> x <= y -> pressure x xi <= pressure y xi.
Proof.
  intros range order. unfold pressure.
  pose proof (cos_in_quarter xi range) as positive.
  destruct (Rle_dec 1 x); destruct (Rle_dec 1 y); try lra.
  - apply Rle_trans with (2 * cos xi * sqrt (1 - sin xi * sin xi)).
    + apply Rmult_le_compat_l; [lra |]. apply sqrt_le_1_alt. lra.
    + rewrite seam by assumption. lra.
  - apply Rmult_le_compat_l; [lra |]. apply sqrt_le_1_alt. lra.
Qed.

(** ** Continuity in the load, uniform in place *)

Lemma sqrt_difference (a b : R) : a <= b -> sqrt b - sqrt a <= sqrt (b - a).
Proof.
  intro order. destruct (Rle_lt_dec a 0) as [negative | positive].
  - rewrite (sqrt_neg_0 a negative). rewrite Rminus_0_r. apply sqrt_le_1_alt. lra.
  - pose proof (sqrt_pos (b - a)). pose proof (sqrt_pos a).
    assert (sqrt b <= sqrt a + sqrt (b - a)); [| lra].
    apply Rsqr_incr_0; [| apply sqrt_pos | lra].
    unfold Rsqr. rewrite sqrt_sqrt by lra.
    pose proof (sqrt_sqrt (b - a) ltac:(lra)). pose proof (sqrt_sqrt a ltac:(lra)). nra.
Qed.

(** The modulus of continuity: at most 2 sqrt d + d for loads that differ by d. *)
Definition modulus (d : R) : R := 2 * sqrt d + d.

Theorem pressure_continuous_in_load (x y xi : R) : 0 <= xi <= PI / 2 -> x <= y -> pressure y xi - pressure x xi <= modulus (y - x).
Proof.
  intros range order. unfold pressure, modulus.
  pose proof (cos_in_quarter xi range) as positive. pose proof (COS_bound xi) as bound.
  assert (partial : forall a b, a <= b ->
    2 * cos xi * sqrt (b - sin xi * sin xi) - 2 * cos xi * sqrt (a - sin xi * sin xi) <= 2 * sqrt (b - a)).
  { intros a b a_b. pose proof (sqrt_difference (a - sin xi * sin xi) (b - sin xi * sin xi) ltac:(lra)) as root.
    replace (b - sin xi * sin xi - (a - sin xi * sin xi)) with (b - a) in root by ring.
    pose proof (sqrt_pos (b - a)). nra. }
  destruct (Rle_dec 1 x) as [x_full | x_partial]; destruct (Rle_dec 1 y) as [y_full | y_partial]; try lra.
  - pose proof (sqrt_pos (y - x)). lra.
  - specialize (partial x 1 ltac:(lra)). rewrite seam in partial by assumption.
    assert (sqrt (1 - x) <= sqrt (y - x)) by (apply sqrt_le_1_alt; lra). lra.
  - specialize (partial x y order). lra.
Qed.

Lemma continuous_pressure (x xi : R) : continuous (pressure x) xi.
Proof.
  assert (sine : forall t, continuous sin t) by (intro t; apply (ex_derive_continuous (V := R_NormedModule)); auto_derive; exact I).
  assert (cosine : forall t, continuous cos t) by (intro t; apply (ex_derive_continuous (V := R_NormedModule)); auto_derive; exact I).
  unfold pressure. destruct (Rle_dec 1 x).
  - apply (continuous_plus (V := R_NormedModule)); [apply continuous_const |].
    apply (continuous_comp (fun t => 2 * t) cos); [| apply cosine].
    apply (ex_derive_continuous (V := R_NormedModule)). auto_derive. exact I.
  - apply (continuous_mult (K := R_AbsRing)).
    + apply (continuous_mult (K := R_AbsRing)); [apply continuous_const | apply cosine].
    + apply (continuous_comp (fun t => x - sin t * sin t) sqrt); [| apply continuous_sqrt].
      apply (continuous_minus (V := R_NormedModule)); [apply continuous_const |].
      apply (continuous_mult (K := R_AbsRing)); apply sine.
Qed.
