(* SPDX-License-Identifier: GPL-3.0-or-later *)
(** * Section 6: the operator of one scale, its order, and why errors only add

    With x = p_(n-1)/p*_n and G = gamma^(D-1), p_n/p*_(n+1) is pressure x xi/G, xi uniform on [0, pi/2] ((3.8), (5.1)); so
    A_n/lambda_0 = B_n(ptilde) with B_0 the share of one wave in contact and B_(m+1) = T B_m, for functions that vanish at 0. *)

From Coq Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
Require Import Wave.
Open Scope R_scope.

Definition T (G : R) (phi : R -> R) (x : R) : R := 2 / PI * RInt (fun xi => phi (pressure x xi / G)) 0 (PI / 2).

Definition uniformly_continuous (phi : R -> R) : Prop :=
  forall eps, 0 < eps -> exists delta, 0 < delta /\ forall y z, y <= z -> z - y < delta -> Rabs (phi z - phi y) < eps.

Definition nondecreasing (phi : R -> R) : Prop := forall y z, y <= z -> phi y <= phi z.

Lemma share_positive : 0 < 2 / PI.
Proof. apply Rdiv_lt_0_compat; [lra | apply PI_RGT_0]. Qed.

Lemma quarter_positive : 0 <= PI / 2.
Proof. pose proof PI_RGT_0. lra. Qed.

Lemma whole_wave (c : R) : 2 / PI * (PI / 2 * c) = c.
Proof. field. apply PI_neq0. Qed.

Lemma uniform_is_continuous (phi : R -> R) (y : R) : uniformly_continuous phi -> continuous phi y.
Proof.
  intro uniform. apply continuity_pt_filterlim.
  intros eps eps_positive. destruct (uniform eps eps_positive) as [delta [delta_positive close]].
  exists delta. split; [exact delta_positive |].
  intros z [_ near]. simpl in *. unfold R_dist in *.
  destruct (Rle_lt_dec y z).
  - apply close; [assumption |]. rewrite Rabs_pos_eq in near; lra.
  - rewrite Rabs_minus_sym. apply close; [lra |]. rewrite Rabs_left in near; lra.
Qed.

(** The integral of T exists for every uniformly continuous function. *)
Lemma integrable (G x : R) (phi : R -> R) : uniformly_continuous phi -> ex_RInt (fun xi => phi (pressure x xi / G)) 0 (PI / 2).
Proof.
  intro uniform. apply (ex_RInt_continuous (V := R_CompleteNormedModule)). intros xi _.
  apply (continuous_comp (fun t => pressure x t / G) phi); [| apply uniform_is_continuous, uniform].
  apply (continuous_mult (K := R_AbsRing)); [apply continuous_pressure | apply continuous_const].
Qed.

Lemma multiple_uniform (a : R) (phi : R -> R) : uniformly_continuous phi -> uniformly_continuous (fun y => a * phi y).
Proof.
  intros uniform eps positive.
  assert (scale : 0 < Rabs a + 1) by (pose proof (Rabs_pos a); lra).
  destruct (uniform (eps / (Rabs a + 1)) ltac:(apply Rdiv_lt_0_compat; lra)) as [delta [delta_positive close]].
  exists delta. split; [exact delta_positive |]. intros y z order near. specialize (close y z order near).
  replace (a * phi z - a * phi y) with (a * (phi z - phi y)) by ring. rewrite Rabs_mult.
  apply Rle_lt_trans with ((Rabs a + 1) * Rabs (phi z - phi y)); [pose proof (Rabs_pos (phi z - phi y)); nra |].
  apply Rlt_le_trans with ((Rabs a + 1) * (eps / (Rabs a + 1))); [apply Rmult_lt_compat_l; assumption |].
  apply Req_le. field. lra.
Qed.

Lemma sum_uniform (phi chi : R -> R) : uniformly_continuous phi -> uniformly_continuous chi -> uniformly_continuous (fun y => phi y + chi y).
Proof.
  intros phi_uniform chi_uniform eps positive.
  destruct (phi_uniform (eps / 2) ltac:(lra)) as [d1 [p1 c1]]. destruct (chi_uniform (eps / 2) ltac:(lra)) as [d2 [p2 c2]].
  exists (Rmin d1 d2). split; [apply Rmin_pos; assumption |]. intros y z order near.
  pose proof (Rmin_l d1 d2). pose proof (Rmin_r d1 d2).
  specialize (c1 y z order ltac:(lra)). specialize (c2 y z order ltac:(lra)).
  replace (phi z + chi z - (phi y + chi y)) with ((phi z - phi y) + (chi z - chi y)) by ring.
  eapply Rle_lt_trans; [apply Rabs_triang | lra].
Qed.

Lemma combination_uniform (a b : R) (phi chi : R -> R) : uniformly_continuous phi -> uniformly_continuous chi ->
  uniformly_continuous (fun y => a * phi y + b * chi y).
Proof. intros. apply sum_uniform; apply multiple_uniform; assumption. Qed.

(** ** Positivity *)

Theorem T_linear (G x a b : R) (phi chi : R -> R) : uniformly_continuous phi -> uniformly_continuous chi ->
  T G (fun y => a * phi y + b * chi y) x = a * T G phi x + b * T G chi x.
Proof.
  intros phi_uniform chi_uniform. unfold T.
  pose proof (integrable G x phi phi_uniform) as phi_integral. pose proof (integrable G x chi chi_uniform) as chi_integral.
  rewrite (RInt_plus (V := R_CompleteNormedModule) (fun xi => a * phi (pressure x xi / G)) (fun xi => b * chi (pressure x xi / G)))
    by (apply (ex_RInt_scal (V := R_CompleteNormedModule)); assumption).
  rewrite (RInt_scal (V := R_CompleteNormedModule) (fun xi => phi (pressure x xi / G))) by assumption.
  rewrite (RInt_scal (V := R_CompleteNormedModule) (fun xi => chi (pressure x xi / G))) by assumption.
  unfold plus, scal; simpl; unfold mult; simpl. ring.
Qed.

(** phi <= chi implies T phi <= T chi: only values at y >= 0 count. *)
Theorem T_positive (G x : R) (phi chi : R -> R) : 1 < G -> uniformly_continuous phi -> uniformly_continuous chi ->
  (forall y, 0 <= y -> phi y <= chi y) -> T G phi x <= T G chi x.
Proof.
  intros G_large phi_uniform chi_uniform order. unfold T.
  apply Rmult_le_compat_l; [apply Rlt_le, share_positive |].
  apply RInt_le; [apply quarter_positive | apply integrable; assumption | apply integrable; assumption |].
  intros xi range. apply order. apply Rmult_le_pos; [apply pressure_positive; lra | apply Rlt_le, Rinv_0_lt_compat; lra].
Qed.

Theorem T_constant (G x c : R) : T G (fun _ => c) x = c.
Proof.
  unfold T. rewrite RInt_const. unfold scal; simpl; unfold mult; simpl.
  rewrite Rminus_0_r. apply whole_wave.
Qed.

(** |B - V| <= e implies |T B - T V| <= T e: the operator never lets an error grow beyond its own image. *)
Theorem error_under_T (G x : R) (B V e : R -> R) : 1 < G ->
  uniformly_continuous B -> uniformly_continuous V -> uniformly_continuous e ->
  (forall y, 0 <= y -> Rabs (B y - V y) <= e y) -> Rabs (T G B x - T G V x) <= T G e x.
Proof.
  intros G_large B_uniform V_uniform e_uniform close.
  assert (above : T G B x <= 1 * T G V x + 1 * T G e x).
  { rewrite <- (T_linear G x 1 1 V e) by assumption.
    apply T_positive; try assumption.
    - apply combination_uniform; assumption.
    - intros y positive. specialize (close y positive). apply Rabs_le_between in close. lra. }
  assert (below : 1 * T G V x + -1 * T G e x <= T G B x).
  { rewrite <- (T_linear G x 1 (-1) V e) by assumption.
    apply T_positive; try assumption.
    - apply combination_uniform; assumption.
    - intros y positive. specialize (close y positive). apply Rabs_le_between in close. lra. }
  apply Rabs_le_between. lra.
Qed.

(** ** Order and continuity are kept *)

Theorem T_nondecreasing (G : R) (phi : R -> R) : 1 < G -> uniformly_continuous phi -> nondecreasing phi -> nondecreasing (T G phi).
Proof.
  intros G_large uniform monotone x y order. unfold T.
  apply Rmult_le_compat_l; [apply Rlt_le, share_positive |].
  apply RInt_le; [apply quarter_positive | apply integrable; assumption | apply integrable; assumption |].
  intros xi range. apply monotone. apply Rmult_le_compat_r; [apply Rlt_le, Rinv_0_lt_compat; lra |].
  apply pressure_increases; lra.
Qed.

Lemma modulus_small (delta : R) : 0 < delta -> exists d, 0 < d /\ forall t, 0 <= t < d -> modulus t < delta.
Proof.
  intro delta_positive. exists (Rmin 1 ((delta / 4) * (delta / 4))). split.
  - apply Rmin_pos; nra.
  - intros t [low high]. pose proof (Rmin_l 1 ((delta / 4) * (delta / 4))). pose proof (Rmin_r 1 ((delta / 4) * (delta / 4))).
    unfold modulus.
    assert (root : sqrt t <= delta / 4) by (rewrite <- (sqrt_square (delta / 4)) by lra; apply sqrt_le_1; nra).
    assert (unit : sqrt t <= 1) by (rewrite <- sqrt_1; apply sqrt_le_1; lra).
    pose proof (sqrt_pos t). pose proof (sqrt_sqrt t low). nra.
Qed.

Theorem T_uniformly_continuous (G : R) (phi : R -> R) : 1 < G -> uniformly_continuous phi -> uniformly_continuous (T G phi).
Proof.
  intros G_large uniform eps eps_positive.
  destruct (uniform (eps / 2) ltac:(lra)) as [delta [delta_positive close]].
  destruct (modulus_small delta delta_positive) as [d [d_positive small]].
  exists d. split; [exact d_positive |]. intros y z order near.
  assert (pointwise : forall xi, 0 <= xi <= PI / 2 -> Rabs (phi (pressure z xi / G) - phi (pressure y xi / G)) <= eps / 2).
  { intros xi range. apply Rlt_le, close.
    - apply Rmult_le_compat_r; [apply Rlt_le, Rinv_0_lt_compat; lra | apply pressure_increases; lra].
    - pose proof (pressure_continuous_in_load y z xi ltac:(lra) order) as step.
      specialize (small (z - y) ltac:(lra)).
      pose proof (pressure_increases y z xi ltac:(lra) order).
      apply Rle_lt_trans with (pressure z xi - pressure y xi); [| lra].
      replace (pressure z xi / G - pressure y xi / G) with ((pressure z xi - pressure y xi) / G) by (field; lra).
      apply Rle_div_l; [lra | nra]. }
  pose proof (integrable G z phi uniform) as z_integral. pose proof (integrable G y phi uniform) as y_integral.
  assert (split : T G phi z - T G phi y = 2 / PI * RInt (fun xi => phi (pressure z xi / G) - phi (pressure y xi / G)) 0 (PI / 2)).
  { unfold T. rewrite (RInt_minus (V := R_CompleteNormedModule)) by assumption. unfold minus, plus, opp; simpl. ring. }
  rewrite split, Rabs_mult, (Rabs_pos_eq (2 / PI)) by (apply Rlt_le, share_positive).
  apply Rle_lt_trans with (2 / PI * (PI / 2 * (eps / 2))); [| rewrite whole_wave; lra].
  apply Rmult_le_compat_l; [apply Rlt_le, share_positive |].
  replace (PI / 2 * (eps / 2)) with ((PI / 2 - 0) * (eps / 2)) by ring.
  apply (abs_RInt_le_const (fun xi => phi (pressure z xi / G) - phi (pressure y xi / G))).
  - apply quarter_positive.
  - apply (ex_RInt_minus (V := R_CompleteNormedModule)); assumption.
  - exact pointwise.
Qed.
