(* SPDX-License-Identifier: GPL-3.0-or-later *)
(** * Section 7: the constants K_n of (7.13) and two-sided bounds of their limit K_inf (7.20)

    K_(n+1) = K_n phi(delta_n) with delta_n = 1 - 2^-(n+1) (7.16), K_0 = 2/pi (7.15) and, (7.13) with xi = cos t,
    phi(delta) = (1/pi) int_0^pi (2 sin t)^delta sin t dt = (2/pi) int_0^(pi/2) (2 sin t)^delta sin t dt.
    phi is log-convex, phi(1) = 1 and phi'(1) = 1/2; the bounds use nothing else, and no Gamma function. *)

From Coq Require Import Reals Lra Psatz Arith.
From Coquelicot Require Import Coquelicot.
Require Import Wave Operator Equilibrium.
Open Scope R_scope.

(** ** Powers that vanish at 0 *)

Definition power (x a : R) : R := if Rle_dec x 0 then 0 else exp (a * ln x).

Lemma power_positive (x a : R) : 0 < x -> power x a = exp (a * ln x).
Proof. intro. unfold power. destruct (Rle_dec x 0); [lra | reflexivity]. Qed.

Lemma power_at_zero (x a : R) : x <= 0 -> power x a = 0.
Proof. intro. unfold power. destruct (Rle_dec x 0); [reflexivity | lra]. Qed.

Lemma power_nonnegative (x a : R) : 0 <= power x a.
Proof. unfold power. destruct (Rle_dec x 0); [lra | apply Rlt_le, exp_pos]. Qed.

(** A function that is 0 left of 0, continuous right of 0 and small near 0 is continuous. *)
Lemma continuous_from_zero (g : R -> R) (x : R) : (forall y, y <= 0 -> g y = 0) -> (forall y, 0 < y -> continuous g y) ->
  (forall eps, 0 < eps -> exists delta, 0 < delta /\ forall y, 0 < y < delta -> Rabs (g y) < eps) -> continuous g x.
Proof.
  intros left right near. destruct (Rlt_le_dec 0 x) as [positive | negative]; [apply right, positive |].
  apply continuity_pt_filterlim. intros eps eps_positive.
  destruct (near eps eps_positive) as [delta [delta_positive small]].
  exists (if Rlt_dec x 0 then - x else delta). split; [destruct (Rlt_dec x 0); lra |].
  intros y [_ close]. simpl in *. unfold R_dist in *. rewrite (left x negative), Rminus_0_r.
  destruct (Rle_lt_dec y 0) as [y_left | y_right].
  - rewrite (left y y_left), Rabs_R0. exact eps_positive.
  - destruct (Rlt_dec x 0) as [x_left | x_zero].
    + rewrite Rabs_pos_eq in close; lra.
    + apply small. rewrite Rabs_pos_eq in close; lra.
Qed.

Lemma continuous_power (a x : R) : 0 < a -> continuous (fun y => power y a) x.
Proof.
  intro a_positive. apply continuous_from_zero.
  - intros y negative. apply power_at_zero, negative.
  - intros y positive. apply (continuous_ext_loc _ (fun y => exp (a * ln y))).
    + exists (mkposreal y positive). intros z close. unfold ball in close; simpl in close; unfold AbsRing_ball, abs, minus, plus, opp in close; simpl in close.
      symmetry. apply power_positive. apply Rabs_def2 in close. lra.
    + apply (ex_derive_continuous (V := R_NormedModule)). auto_derive. lra.
  - intros eps positive. exists (exp (ln eps / a)). split; [apply exp_pos |]. intros y [y_positive y_small].
    rewrite power_positive by assumption. rewrite Rabs_pos_eq by (apply Rlt_le, exp_pos).
    rewrite <- (exp_ln eps) by assumption. apply exp_increasing.
    assert (ln y < ln eps / a) by (rewrite <- (ln_exp (ln eps / a)); apply ln_increasing; assumption).
    apply Rmult_lt_reg_r with (/ a); [apply Rinv_0_lt_compat; lra |].
    replace (a * ln y * / a) with (ln y) by (field; lra). exact H.
Qed.

(** ** The step phi *)

Definition integrand (delta t : R) : R := power (2 * sin t) delta * sin t.

Definition phi (delta : R) : R := 2 / PI * RInt (integrand delta) 0 (PI / 2).

Lemma sine_positive (t : R) : 0 < t < PI / 2 -> 0 < sin t.
Proof. intro. apply sin_gt_0; pose proof PI_RGT_0; lra. Qed.

Lemma continuous_sine (t : R) : continuous sin t.
Proof. apply (ex_derive_continuous (V := R_NormedModule)). auto_derive. exact I. Qed.

Lemma integrand_integrable (delta a b : R) : 0 < delta -> ex_RInt (integrand delta) a b.
Proof.
  intro positive. apply (ex_RInt_continuous (V := R_CompleteNormedModule)). intros t _.
  apply (continuous_mult (K := R_AbsRing)); [| apply continuous_sine].
  apply (continuous_comp (fun t => 2 * sin t) (fun y => power y delta)); [| apply continuous_power, positive].
  apply (continuous_mult (K := R_AbsRing)); [apply continuous_const | apply continuous_sine].
Qed.

Lemma integrand_inside (delta t : R) : 0 < t < PI / 2 -> integrand delta t = exp (delta * ln (2 * sin t)) * sin t.
Proof. intro range. unfold integrand. rewrite power_positive; [reflexivity |]. pose proof (sine_positive t range). lra. Qed.

Lemma phi_positive (delta : R) : 0 < delta -> 0 < phi delta.
Proof.
  intro positive. unfold phi. apply Rmult_lt_0_compat; [apply share_positive |].
  apply RInt_gt_0.
  - pose proof PI_RGT_0. lra.
  - intros t range. rewrite integrand_inside by assumption. apply Rmult_lt_0_compat; [apply exp_pos | apply sine_positive, range].
  - intros t _. apply (continuous_mult (K := R_AbsRing)); [| apply continuous_sine].
    apply (continuous_comp (fun t => 2 * sin t) (fun y => power y delta)); [| apply continuous_power, positive].
    apply (continuous_mult (K := R_AbsRing)); [apply continuous_const | apply continuous_sine].
Qed.

Lemma sine_square_integral : is_RInt (fun t => sin t * sin t) 0 (PI / 2) (PI / 4).
Proof.
  replace (PI / 4) with (minus ((PI / 2 - sin (PI / 2) * cos (PI / 2)) / 2) ((0 - sin 0 * cos 0) / 2)).
  2: { unfold minus, plus, opp; simpl. rewrite sin_0, cos_PI2. field. }
  apply (is_RInt_derive (V := R_CompleteNormedModule) (fun t => (t - sin t * cos t) / 2)).
  - intros t _. auto_derive; [exact I |]. pose proof (sin2_cos2 t) as one. unfold Rsqr in one.
    replace (sin t * sin t) with (1 - cos t * cos t) by lra. lra.
  - intros t _. apply (ex_derive_continuous (V := R_NormedModule)). auto_derive. exact I.
Qed.

(** phi(1) = 1. *)
Theorem phi_at_one : phi 1 = 1.
Proof.
  unfold phi. pose proof PI_RGT_0.
  replace (RInt (integrand 1) 0 (PI / 2)) with (2 * (PI / 4)).
  - field. apply PI_neq0.
  - symmetry. apply is_RInt_unique. apply (is_RInt_ext (V := R_NormedModule) (fun t => 2 * (sin t * sin t))).
    + intros t range. rewrite Rmin_left, Rmax_right in range by lra.
      rewrite integrand_inside by assumption. pose proof (sine_positive t range).
      rewrite Rmult_1_l, exp_ln by lra. simpl. ring.
    + apply is_RInt_times, sine_square_integral.
Qed.

(** Log-convexity at the midpoint: phi((a+b)/2)^2 <= phi(a) phi(b), by uv <= (c u^2 + v^2/c)/2 with the best c. *)
Theorem phi_log_convex (a b : R) : 0 < a -> 0 < b -> phi ((a + b) / 2) * phi ((a + b) / 2) <= phi a * phi b.
Proof.
  intros a_positive b_positive. pose proof PI_RGT_0 as pi_positive.
  pose proof (phi_positive a a_positive) as phi_a. pose proof (phi_positive b b_positive) as phi_b.
  pose proof (phi_positive ((a + b) / 2) ltac:(lra)) as phi_m.
  assert (young : forall c, 0 < c -> 2 * phi ((a + b) / 2) <= c * phi a + / c * phi b).
  { intros c c_positive. unfold phi.
    replace (2 * (2 / PI * RInt (integrand ((a + b) / 2)) 0 (PI / 2))) with (2 / PI * (2 * RInt (integrand ((a + b) / 2)) 0 (PI / 2))) by ring.
    replace (c * (2 / PI * RInt (integrand a) 0 (PI / 2)) + / c * (2 / PI * RInt (integrand b) 0 (PI / 2)))
      with (2 / PI * (c * RInt (integrand a) 0 (PI / 2) + / c * RInt (integrand b) 0 (PI / 2))) by ring.
    apply Rmult_le_compat_l; [apply Rlt_le, share_positive |].
    pose proof (RInt_correct (V := R_CompleteNormedModule) _ _ _ (integrand_integrable ((a + b) / 2) 0 (PI / 2) ltac:(lra))) as m_value.
    pose proof (RInt_correct (V := R_CompleteNormedModule) _ _ _ (integrand_integrable a 0 (PI / 2) a_positive)) as a_value.
    pose proof (RInt_correct (V := R_CompleteNormedModule) _ _ _ (integrand_integrable b 0 (PI / 2) b_positive)) as b_value.
    apply (is_RInt_times 2) in m_value. apply (is_RInt_times c) in a_value. apply (is_RInt_times (/ c)) in b_value.
    pose proof (is_RInt_plus (V := R_NormedModule) _ _ _ _ _ _ a_value b_value) as sum.
    apply (is_RInt_le _ _ 0 (PI / 2) _ _ ltac:(lra) m_value sum).
    intros t range. unfold plus; simpl. rewrite !integrand_inside by assumption.
    pose proof (sine_positive t range) as sine. set (l := ln (2 * sin t)).
    replace (exp (a * l)) with (exp (a * l / 2) * exp (a * l / 2)) by (rewrite <- exp_plus; f_equal; field).
    replace (exp (b * l)) with (exp (b * l / 2) * exp (b * l / 2)) by (rewrite <- exp_plus; f_equal; field).
    replace (exp ((a + b) / 2 * l)) with (exp (a * l / 2) * exp (b * l / 2)) by (rewrite <- exp_plus; f_equal; field).
    set (u := exp (a * l / 2)). set (v := exp (b * l / 2)).
    apply Rmult_le_reg_l with c; [assumption |].
    replace (c * (c * (u * u * sin t) + / c * (v * v * sin t))) with (((c * u) * (c * u) + v * v) * sin t) by (field; lra).
    replace (c * (2 * (u * v * sin t))) with (2 * (c * u) * v * sin t) by ring.
    apply Rmult_le_compat_r; [lra |]. pose proof (Rle_0_sqr (c * u - v)) as square. unfold Rsqr in square. lra. }
  pose proof (sqrt_lt_R0 (phi b / phi a) ltac:(apply Rdiv_lt_0_compat; assumption)) as c_positive.
  pose proof (sqrt_sqrt (phi b / phi a) ltac:(apply Rlt_le, Rdiv_lt_0_compat; assumption)) as c_square.
  set (c := sqrt (phi b / phi a)) in *.
  pose proof (young c c_positive) as bound.
  assert (balance : / c * phi b = c * phi a).
  { apply Rmult_eq_reg_l with c; [| lra]. replace (c * (/ c * phi b)) with (phi b) by (field; lra).
    replace (c * (c * phi a)) with ((c * c) * phi a) by ring. rewrite c_square. field. lra. }
  rewrite balance in bound.
  apply Rle_trans with ((c * phi a) * (c * phi a)).
  - assert (phi ((a + b) / 2) <= c * phi a) by lra. apply Rmult_le_compat; lra.
  - replace (c * phi a * (c * phi a)) with ((c * c) * (phi a * phi a)) by ring. rewrite c_square. apply Req_le. field. lra.
Qed.

(** ** phi'(1) = 1/2: the integral of sin^2 t ln(2 sin t) over a quarter wave is pi/8

    By t -> 2t it equals 8 (I - I4), I4 that of sin^4 t ln(2 sin t); by parts 4 I4 = 3 I + pi/16. Every integrand is continuous. *)

Definition square_log (c : R) : R := if Rle_dec c 0 then 0 else c * c * ln (2 * c).

Lemma square_log_positive (c : R) : 0 < c -> square_log c = c * c * ln (2 * c).
Proof. intro. unfold square_log. destruct (Rle_dec c 0); [lra | reflexivity]. Qed.

(** |c ln(2c)| <= 1 for 0 < c <= 1/2, from ln y <= y - 1. *)
Lemma log_small (c : R) : 0 < c <= / 2 -> Rabs (c * ln (2 * c)) <= 1.
Proof.
  intros [positive small].
  assert (negative : ln (2 * c) <= 0) by (rewrite <- ln_1; destruct (Req_dec (2 * c) 1) as [-> |]; [lra | apply Rlt_le, ln_increasing; lra]).
  pose proof (exp_ineq1_le (- ln (2 * c))) as above. rewrite exp_Ropp, exp_ln in above by lra.
  rewrite Rabs_left1 by nra.
  apply Rmult_le_reg_r with (/ c); [apply Rinv_0_lt_compat; lra |].
  replace (- (c * ln (2 * c)) * / c) with (- ln (2 * c)) by (field; lra).
  rewrite Rmult_1_l. rewrite Rinv_mult in above. pose proof (Rinv_0_lt_compat c positive). lra.
Qed.

Lemma continuous_square_log (c : R) : continuous square_log c.
Proof.
  apply continuous_from_zero.
  - intros y negative. unfold square_log. destruct (Rle_dec y 0); [reflexivity | lra].
  - intros y positive. apply (continuous_ext_loc _ (fun c => c * c * ln (2 * c))).
    + exists (mkposreal y positive). intros z close. unfold ball in close; simpl in close; unfold AbsRing_ball, abs, minus, plus, opp in close; simpl in close.
      symmetry. apply square_log_positive. apply Rabs_def2 in close. lra.
    + apply (ex_derive_continuous (V := R_NormedModule)). auto_derive. lra.
  - intros eps positive. exists (Rmin (/ 2) eps). split; [apply Rmin_pos; lra |]. intros y [y_positive y_small].
    pose proof (Rmin_l (/ 2) eps). pose proof (Rmin_r (/ 2) eps).
    rewrite square_log_positive by assumption. rewrite Rmult_assoc, Rabs_mult, (Rabs_pos_eq y) by lra.
    pose proof (log_small y ltac:(lra)). pose proof (Rabs_pos (y * ln (2 * y))). nra.
Qed.

Definition I2 : R := RInt (fun t => square_log (sin t)) 0 (PI / 2).
Definition I4 : R := RInt (fun t => sin t * sin t * square_log (sin t)) 0 (PI / 2).

Lemma continuous_cosine (t : R) : continuous cos t.
Proof. apply (ex_derive_continuous (V := R_NormedModule)). auto_derive. exact I. Qed.

Lemma continuous_log_sine (t : R) : continuous (fun t => square_log (sin t)) t.
Proof. apply (continuous_comp sin square_log); [apply continuous_sine | apply continuous_square_log]. Qed.

Lemma I2_value : is_RInt (fun t => square_log (sin t)) 0 (PI / 2) I2.
Proof. apply (RInt_correct (V := R_CompleteNormedModule)), (ex_RInt_continuous (V := R_CompleteNormedModule)). intros t _. apply continuous_log_sine. Qed.

Lemma I4_value : is_RInt (fun t => sin t * sin t * square_log (sin t)) 0 (PI / 2) I4.
Proof.
  apply (RInt_correct (V := R_CompleteNormedModule)), (ex_RInt_continuous (V := R_CompleteNormedModule)). intros t _.
  apply (continuous_mult (K := R_AbsRing)); [apply (continuous_mult (K := R_AbsRing)); apply continuous_sine | apply continuous_log_sine].
Qed.

Lemma substitute (g : R -> R) (u v a b value : R) : is_RInt g (u * a + v) (u * b + v) value -> is_RInt (fun t => u * g (u * t + v)) a b value.
Proof. exact (is_RInt_comp_lin (V := R_NormedModule) g u v a b value). Qed.

Lemma turn (g : R -> R) (a b value : R) : is_RInt g b a value -> is_RInt g a b (- value).
Proof. exact (is_RInt_swap (V := R_NormedModule) g a b value). Qed.

(** t -> c - t, for c = pi/2 and pi. *)
Lemma reflect_about (c a b value : R) (g : R -> R) : is_RInt g a b value -> is_RInt (fun t => g (c - t)) (c - b) (c - a) value.
Proof.
  intro direct.
  pose proof (substitute g (-1) c (c - a) (c - b) value) as turned.
  replace (-1 * (c - a) + c) with a in turned by ring. replace (-1 * (c - b) + c) with b in turned by ring.
  specialize (turned direct). apply turn in turned. apply (is_RInt_times (-1)) in turned.
  replace (-1 * - value) with value in turned by ring.
  apply (is_RInt_ext (V := R_NormedModule) (fun t => -1 * (-1 * g (-1 * t + c)))); [| exact turned].
  intros t _. simpl. replace (-1 * t + c) with (c - t) by ring. ring.
Qed.

Lemma reflect (g : R -> R) (value : R) : is_RInt g 0 (PI / 2) value -> is_RInt (fun t => g (PI / 2 - t)) 0 (PI / 2) value.
Proof.
  intro direct. pose proof (reflect_about (PI / 2) 0 (PI / 2) value g direct) as turned.
  replace (PI / 2 - PI / 2) with 0 in turned by ring. rewrite Rminus_0_r in turned. exact turned.
Qed.

Lemma join (g : R -> R) (a b c first second : R) : is_RInt g a b first -> is_RInt g b c second -> is_RInt g a c (first + second).
Proof. exact (is_RInt_Chasles (V := R_NormedModule) g a b c first second). Qed.

Lemma add (g h : R -> R) (a b first second : R) : is_RInt g a b first -> is_RInt h a b second -> is_RInt (fun t => g t + h t) a b (first + second).
Proof. exact (is_RInt_plus (V := R_NormedModule) g h a b first second). Qed.

Lemma subtract (g h : R -> R) (a b first second : R) : is_RInt g a b first -> is_RInt h a b second -> is_RInt (fun t => g t - h t) a b (first - second).
Proof. exact (is_RInt_minus (V := R_NormedModule) g h a b first second). Qed.

Lemma unique (g : R -> R) (a b first second : R) : is_RInt g a b first -> is_RInt g a b second -> first = second.
Proof.
  intros one two. apply (is_RInt_unique (V := R_CompleteNormedModule)) in one. apply (is_RInt_unique (V := R_CompleteNormedModule)) in two.
  rewrite <- one. exact two.
Qed.

Lemma replace_integrand (g h : R -> R) (a b value : R) : a <= b -> (forall t, a < t < b -> g t = h t) -> is_RInt g a b value -> is_RInt h a b value.
Proof.
  intros order equal. apply (is_RInt_ext (V := R_NormedModule)). intros t range.
  rewrite Rmin_left, Rmax_right in range by assumption. apply equal, range.
Qed.

(** t -> 2t, and the second half of the half wave is the first one reflected. *)
Lemma doubled : is_RInt (fun t => square_log (sin (2 * t))) 0 (PI / 2) I2.
Proof.
  pose proof PI_RGT_0 as pi_positive.
  assert (second : is_RInt (fun t => square_log (sin t)) (PI / 2) PI I2).
  { pose proof (reflect_about PI 0 (PI / 2) I2 _ I2_value) as turned.
    replace (PI - PI / 2) with (PI / 2) in turned by field. rewrite Rminus_0_r in turned.
    refine (replace_integrand _ _ _ _ _ _ _ turned); [lra |]. intros t _. simpl. f_equal. apply sin_PI_x. }
  pose proof (join _ _ _ _ _ _ I2_value second) as whole.
  pose proof (substitute (fun t => square_log (sin t)) 2 0 0 (PI / 2) (I2 + I2)) as stretched.
  replace (2 * 0 + 0) with 0 in stretched by ring. replace (2 * (PI / 2) + 0) with PI in stretched by field.
  specialize (stretched whole). apply (is_RInt_times (/ 2)) in stretched.
  replace (/ 2 * (I2 + I2)) with I2 in stretched by field.
  refine (replace_integrand _ _ _ _ _ _ _ stretched); [lra |]. intros t _. simpl. rewrite Rplus_0_r. field.
Qed.

Lemma doubling : I2 = 8 * (I2 - I4).
Proof.
  pose proof PI_RGT_0 as pi_positive.
  pose proof (subtract _ _ _ _ _ _ I2_value I4_value) as near.
  pose proof (is_RInt_times 4 _ _ _ _ (add _ _ _ _ _ _ near (reflect _ _ near))) as both. simpl in both.
  assert (same : is_RInt (fun t => square_log (sin (2 * t))) 0 (PI / 2) (4 * ((I2 - I4) + (I2 - I4)))).
  { refine (replace_integrand _ _ _ _ _ _ _ both); [lra |]. intros t range. simpl.
    assert (sine : 0 < sin t) by (apply sine_positive; lra). assert (cosine : 0 < cos t) by (apply cos_gt_0; lra).
    rewrite sin_shift.
    pose proof (Rmult_lt_0_compat _ _ sine cosine) as both_positive.
    rewrite sin_2a. rewrite (square_log_positive (sin t)), (square_log_positive (cos t)), (square_log_positive (2 * sin t * cos t)) by lra.
    replace (2 * (2 * sin t * cos t)) with ((2 * sin t) * (2 * cos t)) by ring. rewrite (ln_mult (2 * sin t) (2 * cos t)) by lra.
    pose proof (sin2_cos2 t) as one. unfold Rsqr in one.
    set (ls := ln (2 * sin t)). set (lc := ln (2 * cos t)).
    transitivity (4 * (sin t * sin t * ls * (1 - sin t * sin t) + cos t * cos t * lc * (1 - cos t * cos t))); [ring |].
    replace (1 - sin t * sin t) with (cos t * cos t) by lra. replace (1 - cos t * cos t) with (sin t * sin t) by lra. ring. }
  pose proof (unique _ _ _ _ _ same doubled). lra.
Qed.

(** The product whose derivative gives the relation by parts; at 0 it is flat because sin t ln(2 sin t) sin t is small. *)
Definition product (t : R) : R := cos t * sin t * square_log (sin t).
Definition product' (t : R) : R := 3 * square_log (sin t) - 4 * (sin t * sin t * square_log (sin t)) + sin t * sin t * (cos t * cos t).

Lemma product_derivative (t : R) : 0 <= t <= PI / 2 -> is_derive product t (product' t).
Proof.
  intro range. pose proof PI_RGT_0 as pi_positive. destruct (Req_dec t 0) as [-> | nonzero].
  - unfold product'. rewrite sin_0. replace (square_log 0) with 0 by (unfold square_log; destruct (Rle_dec 0 0); [reflexivity | lra]).
    replace (3 * 0 - 4 * (0 * 0 * 0) + 0 * 0 * (cos 0 * cos 0)) with 0 by ring.
    apply is_derive_Reals. intros eps eps_positive.
    pose proof (continuous_log_sine 0) as near. apply continuity_pt_filterlim in near.
    destruct (near eps eps_positive) as [delta [delta_positive small]].
    exists (mkposreal delta delta_positive). intros h h_nonzero h_small. simpl in h_small.
    unfold product. rewrite Rplus_0_l, sin_0, Rmult_0_r, Rmult_0_l, Rminus_0_r, Rminus_0_r.
    assert (value : Rabs (square_log (sin h)) < eps).
    { specialize (small h). simpl in small. unfold R_dist in small. rewrite sin_0 in small.
      replace (square_log 0) with 0 in small by (unfold square_log; destruct (Rle_dec 0 0); [reflexivity | lra]).
      rewrite !Rminus_0_r in small. apply small. split; [| exact h_small]. split; [exact I | lra]. }
    replace (cos h * sin h * square_log (sin h) / h) with (cos h * (sin h / h) * square_log (sin h)) by (field; exact h_nonzero).
    rewrite !Rabs_mult.
    assert (cosine : Rabs (cos h) <= 1) by (apply Rabs_le, COS_bound).
    assert (ratio : Rabs (sin h / h) <= 1).
    { unfold Rdiv. rewrite Rabs_mult, Rabs_inv by assumption.
      apply Rmult_le_reg_r with (Rabs h); [apply Rabs_pos_lt, h_nonzero |]. rewrite Rmult_assoc, Rinv_l, Rmult_1_r, Rmult_1_l by (apply Rabs_no_R0, h_nonzero).
      destruct (Rle_lt_dec 0 h).
      - rewrite (Rabs_pos_eq h) by assumption. apply Rabs_le. split; [| pose proof (sin_lt_x h ltac:(lra)); lra].
        pose proof (sin_lt_x h ltac:(lra)). destruct (Rle_lt_dec h PI); [pose proof (sin_ge_0 h ltac:(lra) ltac:(lra)); lra | pose proof (SIN_bound h); pose proof PI2_1; lra].
      - rewrite (Rabs_left h) by assumption. rewrite <- Rabs_Ropp, <- sin_neg. apply Rabs_le. split; [| pose proof (sin_lt_x (- h) ltac:(lra)); lra].
        destruct (Rle_lt_dec (- h) PI); [pose proof (sin_ge_0 (- h) ltac:(lra) ltac:(lra)); lra | pose proof (SIN_bound (- h)); pose proof PI2_1; lra]. }
    pose proof (Rabs_pos (cos h)). pose proof (Rabs_pos (sin h / h)). pose proof (Rabs_pos (square_log (sin h))).
    apply Rle_lt_trans with (1 * 1 * Rabs (square_log (sin h))); [| lra].
    apply Rmult_le_compat_r; [assumption |]. apply Rmult_le_compat; assumption.
  - assert (sine : 0 < sin t) by (apply sin_gt_0; lra).
    apply (is_derive_ext_loc (fun t => cos t * sin t * (sin t * sin t * ln (2 * sin t)))).
    + pose proof (continuous_sine t) as near. apply continuity_pt_filterlim in near.
      destruct (near (sin t) sine) as [delta [delta_positive close]].
      exists (mkposreal delta delta_positive). intros z z_close. unfold product. rewrite square_log_positive; [reflexivity |].
      destruct (Req_dec z t) as [-> | different]; [exact sine |].
      specialize (close z). simpl in close. unfold R_dist in close.
      assert (inside : Rabs (sin z - sin t) < sin t).
      { apply close. split; [split; [exact I | lra] |].
        unfold ball in z_close; simpl in z_close; unfold AbsRing_ball, abs, minus, plus, opp in z_close; simpl in z_close. exact z_close. }
      apply Rabs_def2 in inside. lra.
    + auto_derive; [lra |]. unfold product'. rewrite square_log_positive by assumption.
      pose proof (sin2_cos2 t) as one. unfold Rsqr in one.
      set (l := ln (2 * sin t)).
      field_simplify; [| lra].
      replace (cos t ^ 2) with (1 - sin t * sin t) by (simpl; lra). ring.
Qed.

Lemma quarter_product_integral : is_RInt (fun t => sin t * sin t * (cos t * cos t)) 0 (PI / 2) (PI / 16).
Proof.
  replace (PI / 16) with (minus (PI / 2 / 8 - sin (4 * (PI / 2)) / 32) (0 / 8 - sin (4 * 0) / 32)).
  2: { unfold minus, plus, opp; simpl. replace (4 * (PI / 2)) with (2 * PI) by field. replace (4 * 0) with 0 by ring. rewrite sin_2PI, sin_0. field. }
  apply (is_RInt_derive (V := R_CompleteNormedModule) (fun t => t / 8 - sin (4 * t) / 32)).
  - intros t _. auto_derive; [exact I |].
    replace (4 * t) with (2 * (2 * t)) by ring. rewrite cos_2a_sin, sin_2a. field.
  - intros t _. apply (ex_derive_continuous (V := R_NormedModule)). auto_derive. exact I.
Qed.

Lemma by_parts : 4 * I4 = 3 * I2 + PI / 16.
Proof.
  assert (zero_integral : is_RInt product' 0 (PI / 2) (minus (product (PI / 2)) (product 0))).
  { apply (is_RInt_derive (V := R_CompleteNormedModule) product).
    - intros t range. pose proof PI_RGT_0. rewrite Rmin_left, Rmax_right in range by lra. apply product_derivative, range.
    - intros t _. unfold product'. apply (continuous_plus (V := R_NormedModule)).
      + apply (continuous_minus (V := R_NormedModule)).
        * apply (continuous_mult (K := R_AbsRing)); [apply continuous_const | apply continuous_log_sine].
        * apply (continuous_mult (K := R_AbsRing)); [apply continuous_const |].
          apply (continuous_mult (K := R_AbsRing)); [apply (continuous_mult (K := R_AbsRing)); apply continuous_sine | apply continuous_log_sine].
      + apply (ex_derive_continuous (V := R_NormedModule)). auto_derive. exact I. }
  pose proof (add _ _ _ _ _ _ (subtract _ _ _ _ _ _ (is_RInt_times 3 _ _ _ _ I2_value) (is_RInt_times 4 _ _ _ _ I4_value)) quarter_product_integral) as sum.
  pose proof (unique _ _ _ _ _ zero_integral sum) as equal.
  unfold minus, plus, opp in equal; simpl in equal. unfold product in equal. rewrite cos_PI2, sin_0 in equal. lra.
Qed.

Theorem log_integral : I2 = PI / 8.
Proof. pose proof doubling. pose proof by_parts. lra. Qed.

(** phi(1 - h) >= e^(-h/2): Jensen's inequality in the form e^x >= e^m (1 + x - m). *)
Theorem phi_lower (h : R) : 0 <= h < 1 -> exp (- (h / 2)) <= phi (1 - h).
Proof.
  intros [low high]. pose proof PI_RGT_0 as pi_positive.
  pose proof (subtract _ _ _ _ _ _ (is_RInt_times (2 * (1 + h / 2)) _ _ _ _ sine_square_integral) (is_RInt_times (2 * h) _ _ _ _ I2_value)) as tangent.
  apply (is_RInt_times (exp (- (h / 2)))) in tangent. rewrite log_integral in tangent.
  pose proof (RInt_correct (V := R_CompleteNormedModule) _ _ _ (integrand_integrable (1 - h) 0 (PI / 2) ltac:(lra))) as value.
  assert (order : exp (- (h / 2)) * (2 * (1 + h / 2) * (PI / 4) - 2 * h * (PI / 8)) <= RInt (integrand (1 - h)) 0 (PI / 2)).
  { refine (is_RInt_le _ _ _ _ _ _ _ tangent value _); [lra |]. intros t range.
    pose proof (sine_positive t range) as sine. rewrite integrand_inside by assumption. rewrite square_log_positive by assumption.
    set (l := ln (2 * sin t)).
    replace (exp ((1 - h) * l)) with (2 * sin t * (exp (- (h / 2)) * exp (h / 2 - h * l))).
    - pose proof (exp_ineq1_le (h / 2 - h * l)) as line. pose proof (exp_pos (- (h / 2))) as e_positive.
      replace (2 * sin t * (exp (- (h / 2)) * exp (h / 2 - h * l)) * sin t)
        with ((exp (- (h / 2)) * (2 * (sin t * sin t))) * exp (h / 2 - h * l)) by ring.
      replace (exp (- (h / 2)) * (2 * (1 + h / 2) * (sin t * sin t) - 2 * h * (sin t * sin t * l)))
        with ((exp (- (h / 2)) * (2 * (sin t * sin t))) * (1 + (h / 2 - h * l))) by ring.
      apply Rmult_le_compat_l; [| exact line]. apply Rmult_le_pos; nra.
    - assert (whole : exp l = 2 * sin t) by (unfold l; apply exp_ln; lra).
      rewrite <- whole, <- !exp_plus. f_equal. field. }
  replace (exp (- (h / 2))) with (2 / PI * (exp (- (h / 2)) * (2 * (1 + h / 2) * (PI / 4) - 2 * h * (PI / 8)))) by (field; lra).
  unfold phi. apply Rmult_le_compat_l; [apply Rlt_le, share_positive | exact order].
Qed.

(** ** K_n, and the two-sided bounds of its limit *)

Definition h (n : nat) : R := (/ 2) ^ S n.                 (* 1 - delta_n, (7.16) *)

Fixpoint K (n : nat) : R :=                                 (* (7.13), (7.15) *)
  match n with
  | O => 2 / PI
  | S m => K m * phi (1 - h m)
  end.

Definition K_inf : R := real (Lim_seq K).                   (* (7.20) *)

Lemma h_range (n : nat) : 0 < h n <= / 2.
Proof.
  unfold h. induction n as [| n [low high]]; [simpl; lra |].
  change ((/ 2) ^ S (S n)) with (/ 2 * (/ 2) ^ S n). lra.
Qed.

Lemma h_next (n : nat) : h (S n) = h n / 2.
Proof. unfold h. change ((/ 2) ^ S (S n)) with (/ 2 * (/ 2) ^ S n). field. Qed.

Lemma step_positive (n : nat) : 0 < phi (1 - h n).
Proof. apply phi_positive. pose proof (h_range n). lra. Qed.

Lemma K_positive (n : nat) : 0 < K n.
Proof. induction n as [| n IH]; [exact share_positive |]. simpl. apply Rmult_lt_0_compat; [exact IH | apply step_positive]. Qed.

(** phi(delta_(n+1))^2 <= phi(delta_n) phi(1), as delta_(n+1) = (delta_n + 1)/2 (7.12). *)
Lemma steps_square (n : nat) : phi (1 - h (S n)) * phi (1 - h (S n)) <= phi (1 - h n).
Proof.
  pose proof (h_range n). pose proof (phi_log_convex (1 - h n) 1 ltac:(lra) ltac:(lra)) as convex.
  rewrite phi_at_one, Rmult_1_r in convex. rewrite h_next.
  replace (1 - h n / 2) with ((1 - h n + 1) / 2) by field. exact convex.
Qed.

(** phi(1/2) <= 1, from y^(1/2) <= (1 + y)/2. *)
Lemma first_step : phi (1 - h 0) <= 1.
Proof.
  pose proof PI_RGT_0 as pi_positive. unfold h. simpl. replace (1 - / 2 * 1) with (/ 2) by field.
  assert (sine_integral : is_RInt sin 0 (PI / 2) 1).
  { replace 1 with (minus (- cos (PI / 2)) (- cos 0)) by (unfold minus, plus, opp; simpl; rewrite cos_PI2, cos_0; ring).
    apply (is_RInt_derive (V := R_CompleteNormedModule) (fun t => - cos t)).
    - intros t _. auto_derive; [exact I | ring].
    - intros t _. apply continuous_sine. }
  pose proof (add _ _ _ _ _ _ (is_RInt_times (/ 2) _ _ _ _ sine_integral) sine_square_integral) as chord.
  pose proof (RInt_correct (V := R_CompleteNormedModule) _ _ _ (integrand_integrable (/ 2) 0 (PI / 2) ltac:(lra))) as value.
  assert (order : RInt (integrand (/ 2)) 0 (PI / 2) <= / 2 * 1 + PI / 4).
  { refine (is_RInt_le _ _ _ _ _ _ _ value chord _); [lra |]. intros t range.
    pose proof (sine_positive t range) as sine. rewrite integrand_inside by assumption.
    set (u := exp (/ 2 * ln (2 * sin t))).
    assert (square : u * u = 2 * sin t).
    { unfold u. rewrite <- exp_plus. replace (/ 2 * ln (2 * sin t) + / 2 * ln (2 * sin t)) with (ln (2 * sin t)) by field. apply exp_ln. lra. }
    pose proof (Rle_0_sqr (u - 1)) as young. unfold Rsqr in young. nra. }
  unfold phi. apply Rmult_le_reg_l with PI; [lra |].
  replace (PI * (2 / PI * RInt (integrand (/ 2)) 0 (PI / 2))) with (2 * RInt (integrand (/ 2)) 0 (PI / 2)) by (field; lra).
  pose proof PI2_1. pose proof PI2_3_2. lra.
Qed.

Lemma step_at_most_one (n : nat) : phi (1 - h n) <= 1.
Proof.
  induction n as [| n IH]; [exact first_step |].
  pose proof (steps_square n). pose proof (step_positive (S n)). nra.
Qed.

Lemma K_decreases (n : nat) : K (S n) <= K n.
Proof. simpl. pose proof (step_at_most_one n). pose proof (K_positive n). nra. Qed.

Lemma K_converges : is_lim_seq K K_inf.
Proof.
  destruct (ex_finite_lim_seq_decr K 0 K_decreases (fun n => Rlt_le _ _ (K_positive n))) as [limit converges].
  unfold K_inf. rewrite (is_lim_seq_unique _ _ converges). exact converges.
Qed.

(** K_n e^(-h_n) never falls, K_n phi(delta_n)^2 = K_(n+1)^2/K_n never rises. *)
Lemma lower_rises (n : nat) : K n * exp (- h n) <= K (S n) * exp (- h (S n)).
Proof.
  simpl. rewrite h_next. pose proof (h_range n). pose proof (phi_lower (h n) ltac:(lra)) as bound.
  replace (exp (- h n)) with (exp (- (h n / 2)) * exp (- (h n / 2))) by (rewrite <- exp_plus; f_equal; field).
  rewrite Rmult_assoc. apply Rmult_le_compat_l; [apply Rlt_le, K_positive |].
  apply Rmult_le_compat_r; [apply Rlt_le, exp_pos | exact bound].
Qed.

Lemma upper_falls (n : nat) : K (S n) * (phi (1 - h (S n)) * phi (1 - h (S n))) <= K n * (phi (1 - h n) * phi (1 - h n)).
Proof.
  simpl. rewrite Rmult_assoc. apply Rmult_le_compat_l; [apply Rlt_le, K_positive |].
  apply Rmult_le_compat_l; [apply Rlt_le, step_positive | apply steps_square].
Qed.

Lemma monotone_along (u : nat -> R) (up : forall n, u n <= u (S n)) (N j : nat) : u N <= u (N + j)%nat.
Proof.
  induction j as [| j IH]; [rewrite Nat.add_0_r; apply Rle_refl |].
  rewrite Nat.add_succ_r. apply Rle_trans with (1 := IH), up.
Qed.

Lemma h_vanishes : is_lim_seq h 0.
Proof.
  apply (is_lim_seq_ext (fun n => / 2 * (/ 2) ^ n)); [reflexivity |].
  replace (Finite 0) with (Rbar_mult (/ 2) 0) by (simpl; f_equal; ring).
  apply is_lim_seq_scal_l, is_lim_seq_geom. rewrite Rabs_pos_eq; lra.
Qed.

(** K_N e^(-2^-(N+1)) <= K_inf. *)
Theorem K_inf_lower (N : nat) : K N * exp (- h N) <= K_inf.
Proof.
  pose proof (proj1 (is_lim_seq_incr_n K N K_inf) K_converges) as tail.
  refine (is_lim_seq_le (fun _ => K N * exp (- h N)) (fun n => K (n + N)%nat) _ _ _ (is_lim_seq_const _) tail).
  intro n. rewrite Nat.add_comm. apply Rle_trans with (1 := monotone_along (fun n => K n * exp (- h n)) lower_rises N n).
  rewrite <- (Rmult_1_r (K (N + n))) at 2. apply Rmult_le_compat_l; [apply Rlt_le, K_positive |].
  rewrite <- exp_0. pose proof (h_range (N + n)). apply Rlt_le, exp_increasing. lra.
Qed.

(** K_inf <= K_(N+1)^2/K_N. *)
Theorem K_inf_upper (N : nat) : K_inf <= K (S N) * K (S N) / K N.
Proof.
  assert (form : K (S N) * K (S N) / K N = K N * (phi (1 - h N) * phi (1 - h N))) by (simpl; pose proof (K_positive N); field; lra).
  rewrite form.
  pose proof (proj1 (is_lim_seq_incr_n K N K_inf) K_converges) as tail.
  pose proof (proj1 (is_lim_seq_incr_n h N 0) h_vanishes) as h_tail.
  assert (exponential : is_lim_seq (fun n => exp (- h (n + N)%nat)) 1).
  { rewrite <- exp_0. apply (is_lim_seq_continuous exp (fun n => - h (n + N)%nat) 0).
    - apply derivable_continuous_pt, derivable_pt_exp.
    - replace (Finite 0) with (Rbar_opp 0) by (simpl; f_equal; ring). apply -> is_lim_seq_opp. exact h_tail. }
  pose proof (is_lim_seq_mult' _ _ _ _ tail exponential) as weighted. rewrite Rmult_1_r in weighted.
  refine (is_lim_seq_le _ (fun _ => K N * (phi (1 - h N) * phi (1 - h N))) _ _ _ weighted (is_lim_seq_const _)).
  intro n. rewrite Nat.add_comm.
  assert (falls : K (N + n) * (phi (1 - h (N + n)) * phi (1 - h (N + n))) <= K N * (phi (1 - h N) * phi (1 - h N))).
  { pose proof (monotone_along (fun n => - (K n * (phi (1 - h n) * phi (1 - h n)))) (fun n => Ropp_le_contravar _ _ (upper_falls n)) N n) as along.
    simpl in along. lra. }
  apply Rle_trans with (2 := falls). apply Rmult_le_compat_l; [apply Rlt_le, K_positive |].
  pose proof (h_range (N + n)). pose proof (phi_lower (h (N + n)) ltac:(lra)) as bound.
  replace (exp (- h (N + n))) with (exp (- (h (N + n) / 2)) * exp (- (h (N + n) / 2))) by (rewrite <- exp_plus; f_equal; field).
  pose proof (exp_pos (- (h (N + n) / 2))). apply Rmult_le_compat; lra.
Qed.
