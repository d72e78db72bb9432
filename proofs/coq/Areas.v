(* SPDX-License-Identifier: GPL-3.0-or-later *)
(** * Section 6: the areas B_m, equilibrium, and the theorem certificates rest on *)

From Coq Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
Require Import Wave Operator.
Open Scope R_scope.

(** ** Jordan's inequality, by the mean value theorem on both sides of t *)
Lemma jordan (t : R) : 0 <= t <= PI / 2 -> 2 / PI * t <= sin t.
Proof.
  intros [low high]. pose proof PI_RGT_0 as pi_positive.
  destruct (Req_dec t 0) as [-> | not_zero]; [rewrite sin_0; lra |].
  destruct (Req_dec t (PI / 2)) as [-> | not_quarter]; [rewrite sin_PI2; apply Req_le; field; lra |].
  destruct (MVT_cor2 sin cos 0 t ltac:(lra) (fun c _ => derivable_pt_lim_sin c)) as [c1 [mean1 range1]].
  destruct (MVT_cor2 sin cos t (PI / 2) ltac:(lra) (fun c _ => derivable_pt_lim_sin c)) as [c2 [mean2 range2]].
  rewrite sin_0 in mean1. rewrite sin_PI2 in mean2.
  pose proof (cos_decreasing_1 c1 c2 ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra)) as falls.
  apply Rmult_le_reg_l with (PI / 2); [lra |].
  replace (PI / 2 * (2 / PI * t)) with t by (field; lra).
  assert (t * (1 - sin t) <= sin t * (PI / 2 - t)); [| lra].
  rewrite mean2. replace (sin t) with (cos c1 * t) by lra.
  pose proof (Rmult_le_pos (t * (PI / 2 - t)) (cos c1 - cos c2) ltac:(nra) ltac:(lra)). lra.
Qed.

(** ** The share of one wave in contact, (2.5): B_0(x) = 2a/lambda = (2/pi) arcsin sqrt x, 1 in full contact *)

Definition clamp (x : R) : R := Rmax 0 (Rmin 1 x).

Definition B_0 (x : R) : R := 2 / PI * half_width (clamp x).

Lemma clamp_range (x : R) : 0 <= clamp x <= 1.
Proof. unfold clamp. split; [apply Rmax_l |]. apply Rmax_lub; [lra | apply Rmin_l]. Qed.

Lemma clamp_step (x y : R) : x <= y -> 0 <= clamp y - clamp x <= y - x.
Proof. intro order. unfold clamp, Rmax, Rmin. repeat destruct (Rle_dec _ _); lra. Qed.

Lemma half_width_order (x y : R) : 0 <= x <= 1 -> 0 <= y <= 1 -> x <= y -> half_width x <= half_width y.
Proof.
  intros x_range y_range order.
  destruct (Rle_lt_dec (half_width x) (half_width y)) as [| wrong]; [assumption |]. exfalso.
  pose proof (half_width_range x x_range). pose proof (half_width_range y y_range).
  pose proof (sin_increasing_1 (half_width y) (half_width x) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) wrong) as sines.
  assert (0 <= sin (half_width y)) by (apply sin_ge_0; lra).
  pose proof (sine_of_half_width x x_range). pose proof (sine_of_half_width y y_range). nra.
Qed.

(** sin(b - a) sin(b + a) = sin^2 b - sin^2 a and sin(b - a) <= sin(b + a): the half width has the modulus sqrt. *)
Lemma half_width_step (x y : R) : 0 <= x <= 1 -> 0 <= y <= 1 -> x <= y ->
  sin (half_width y - half_width x) <= sqrt (y - x).
Proof.
  intros x_range y_range order.
  pose proof (half_width_order x y x_range y_range order) as widths.
  pose proof (half_width_range x x_range). pose proof (half_width_range y y_range).
  pose proof (sine_of_half_width x x_range) as sx. pose proof (sine_of_half_width y y_range) as sy.
  pose proof (cosine_of_half_width x x_range) as cx. pose proof (cosine_of_half_width y y_range) as cy.
  set (a := half_width x) in *. set (b := half_width y) in *.
  pose proof PI_RGT_0 as pi_positive.
  assert (sa : 0 <= sin a) by (apply sin_ge_0; lra). assert (cb : 0 <= cos b) by (apply cos_ge_0; lra).
  assert (difference : 0 <= sin (b - a)) by (apply sin_ge_0; lra).
  rewrite <- (sqrt_square (sin (b - a))) by assumption. apply sqrt_le_1_alt.
  assert (product : sin (b - a) * sin (b + a) = y - x).
  { rewrite sin_minus, sin_plus.
    replace ((sin b * cos a - cos b * sin a) * (sin b * cos a + cos b * sin a))
      with ((sin b * sin b) * (cos a * cos a) - (cos b * cos b) * (sin a * sin a)) by ring.
    rewrite sx, sy, cx, cy. ring. }
  rewrite <- product. apply Rmult_le_compat_l; [assumption |].
  rewrite sin_minus, sin_plus. nra.
Qed.

Theorem B_0_step (x y : R) : x <= y -> 0 <= B_0 y - B_0 x <= sqrt (y - x).
Proof.
  intro order. pose proof (clamp_step x y order) as [up small].
  pose proof (clamp_range x) as x_range. pose proof (clamp_range y) as y_range.
  pose proof (half_width_order (clamp x) (clamp y) x_range y_range ltac:(lra)) as widths.
  pose proof (half_width_step (clamp x) (clamp y) x_range y_range ltac:(lra)) as step.
  pose proof (half_width_range (clamp x) x_range). pose proof (half_width_range (clamp y) y_range).
  pose proof share_positive as share.
  pose proof (jordan (half_width (clamp y) - half_width (clamp x)) ltac:(lra)) as line.
  assert (sqrt (clamp y - clamp x) <= sqrt (y - x)) by (apply sqrt_le_1_alt; exact small).
  unfold B_0. split; [nra |]. rewrite <- Rmult_minus_distr_l. lra.
Qed.

Lemma B_0_uniformly_continuous : uniformly_continuous B_0.
Proof.
  intros eps positive. exists (eps * eps). split; [nra |]. intros y z order near.
  pose proof (B_0_step y z order) as [up small]. rewrite Rabs_pos_eq by assumption.
  apply Rle_lt_trans with (1 := small). rewrite <- (sqrt_square eps) by lra. apply sqrt_lt_1; nra.
Qed.

Lemma B_0_at_zero : B_0 0 = 0.
Proof.
  unfold B_0, clamp. rewrite Rmin_right, Rmax_left by lra. unfold half_width. rewrite sqrt_0, asin_0. ring.
Qed.

(** T1 <= sqrt x, T1 being B_0: what one wave leaves in contact. *)
Theorem area_of_one_wave (x : R) : 0 <= x -> B_0 x <= sqrt x.
Proof.
  intro positive. pose proof (B_0_step 0 x positive) as [_ small]. rewrite B_0_at_zero, !Rminus_0_r in small. exact small.
Qed.

(** B_0 is the share of the wave where the pressure is positive. *)
Theorem contact_of_one_wave (x xi : R) : 0 < x < 1 -> 0 <= xi < PI / 2 -> (0 < pressure x xi <-> xi < half_width x).
Proof.
  intros x_range range. pose proof PI_RGT_0.
  pose proof (half_width_range x ltac:(lra)) as width. pose proof (sine_of_half_width x ltac:(lra)) as sine.
  assert (cosine : 0 < cos xi) by (apply cos_gt_0; lra).
  assert (sine_xi : 0 <= sin xi) by (apply sin_ge_0; lra).
  assert (sine_a : 0 <= sin (half_width x)) by (apply sin_ge_0; lra).
  unfold pressure. destruct (Rle_dec 1 x); [lra |]. split.
  - intro in_contact. destruct (Rlt_le_dec xi (half_width x)) as [| outside]; [assumption |]. exfalso.
    assert (sin (half_width x) <= sin xi).
    { destruct (Req_dec (half_width x) xi) as [-> |]; [lra |]. apply Rlt_le, sin_increasing_1; lra. }
    rewrite (sqrt_neg_0 (x - sin xi * sin xi)) in in_contact by nra. lra.
  - intro inside. pose proof (sin_increasing_1 xi (half_width x) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) inside) as less.
    assert (0 < sqrt (x - sin xi * sin xi)) by (apply sqrt_lt_R0; nra). nra.
Qed.

(** ** All scales: A_m/lambda_0 = B_m(ptilde) *)

Fixpoint B (G : R) (m : nat) : R -> R :=
  match m with
  | O => B_0
  | S k => T G (B G k)
  end.

Lemma B_uniformly_continuous (G : R) (m : nat) : 1 < G -> uniformly_continuous (B G m).
Proof.
  intro G_large. induction m as [| m IH]; [exact B_0_uniformly_continuous |].
  apply T_uniformly_continuous; assumption.
Qed.

(** The contact area increases with the load, at every scale. *)
Theorem area_increases_with_load (G : R) (m : nat) : 1 < G -> nondecreasing (B G m).
Proof.
  intro G_large. induction m as [| m IH].
  - intros x y order. pose proof (B_0_step x y order). simpl. lra.
  - apply T_nondecreasing; [assumption | apply B_uniformly_continuous; assumption | exact IH].
Qed.

Theorem area_bounded (G x : R) (m : nat) : 1 < G -> 0 <= B G m x <= 1.
Proof.
  intro G_large. revert x. induction m as [| m IH]; intro x.
  - simpl. unfold B_0. pose proof (half_width_range (clamp x) (clamp_range x)) as width. pose proof share_positive.
    split; [nra |]. rewrite <- (whole_wave 1), Rmult_1_r. apply Rmult_le_compat_l; lra.
  - simpl. pose proof (B_uniformly_continuous G m G_large) as uniform.
    assert (constant : forall c, uniformly_continuous (fun _ => c)).
    { intros c eps positive. exists 1. split; [lra |]. intros. rewrite Rminus_eq_0, Rabs_R0. exact positive. }
    split.
    + rewrite <- (T_constant G x 0). apply T_positive; try assumption; [apply constant |]. intros. apply IH.
    + rewrite <- (T_constant G x 1). apply T_positive; try assumption; [apply constant |]. intros. apply IH.
Qed.

(** ** Errors only add: the theorem behind every certificate of an area

    V_0, V_1, ... may be any functions; D_m bounds the defect |T V_m - V_(m+1)|, and E_m, defined by E_(m+1) = T E_m + D_m, the error. *)
Theorem errors_only_add (G : R) (V D E : nat -> R -> R) : 1 < G ->
  (forall m, uniformly_continuous (V m)) -> (forall m, uniformly_continuous (E m)) ->
  (forall y, 0 <= y -> Rabs (B_0 y - V 0%nat y) <= E 0%nat y) ->
  (forall m y, 0 <= y -> Rabs (T G (V m) y - V (S m) y) <= D m y) ->
  (forall m y, 0 <= y -> T G (E m) y + D m y <= E (S m) y) ->
  forall m y, 0 <= y -> Rabs (B G m y - V m y) <= E m y.
Proof.
  intros G_large V_uniform E_uniform first defect total. induction m as [| m IH]; intros y positive.
  - apply first, positive.
  - simpl. replace (T G (B G m) y - V (S m) y) with ((T G (B G m) y - T G (V m) y) + (T G (V m) y - V (S m) y)) by ring.
    eapply Rle_trans; [apply Rabs_triang |]. apply Rle_trans with (2 := total m y positive).
    apply Rplus_le_compat; [| apply defect, positive].
    apply error_under_T; try assumption; [apply B_uniformly_continuous; assumption | apply V_uniform | apply E_uniform].
Qed.

(** Relative errors add (eps_(m+1) = eps_m + eta_m). *)
Theorem relative_errors_add (G eps eta : R) (m : nat) (V V' : R -> R) : 1 < G -> 0 <= eps ->
  uniformly_continuous V ->
  (forall y, 0 <= y -> Rabs (B G m y - V y) <= eps * B G m y) ->
  (forall y, 0 <= y -> Rabs (T G V y - V' y) <= eta * B G (S m) y) ->
  forall y, 0 <= y -> Rabs (B G (S m) y - V' y) <= (eps + eta) * B G (S m) y.
Proof.
  intros G_large eps_positive V_uniform close defect y positive.
  pose proof (B_uniformly_continuous G m G_large) as B_uniform.
  pose proof (error_under_T G y (B G m) V (fun z => eps * B G m z + 0 * B G m z) G_large B_uniform V_uniform
    (combination_uniform eps 0 _ _ B_uniform B_uniform)) as step.
  specialize (step ltac:(intros z z_positive; specialize (close z z_positive); lra)).
  rewrite (T_linear G y eps 0 (B G m) (B G m)) in step by assumption.
  specialize (defect y positive). simpl in *.
  replace (T G (B G m) y - V' y) with ((T G (B G m) y - T G V y) + (T G V y - V' y)) by ring.
  eapply Rle_trans; [apply Rabs_triang | lra].
Qed.
