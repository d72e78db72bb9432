(* SPDX-License-Identifier: GPL-3.0-or-later *)
(** * What a relative error of the argument does to the functions that the double forms call

    A form rounds the argument t before it calls the C library, so that the function is taken of t (1 + e) with |e| a few 2^-53. These
    lemmas bound the relative error which that makes; ../gappa takes them as hypotheses, the library's own error beside them. *)

From Coq Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
Open Scope R_scope.

(** A function that starts at 0 or above and does not fall stays there. *)
Lemma nonnegative (g dg : R -> R) (b : R) : 0 <= b ->
  (forall t, 0 <= t <= b -> is_derive g t (dg t)) -> (forall t, 0 <= t <= b -> 0 <= dg t) ->
  0 <= g 0 -> 0 <= g b.
Proof.
  intros b_positive derivative rising start.
  destruct (MVT_gen g 0 b dg) as [c [range difference]].
  - intros t inside. rewrite Rmin_left, Rmax_right in inside by assumption. apply derivative. lra.
  - intros t inside. rewrite Rmin_left, Rmax_right in inside by assumption.
    apply continuity_pt_filterlim, (ex_derive_continuous (V := R_NormedModule)). exists (dg t). apply derivative. lra.
  - rewrite Rmin_left, Rmax_right in range by assumption. pose proof (rising c ltac:(lra)). nra.
Qed.

(** ** Functions that rise from 0 and bend down: a relative error of the argument is no larger a one of the value *)

Lemma relative_error (g : R -> R) (t e : R) : 0 < t -> Rabs e <= 1 / 2 ->
  (forall k s, 0 <= k <= 1 -> 0 <= s <= 2 * t -> k * g s <= g (k * s)) -> (forall s u, 0 <= s <= u -> u <= 2 * t -> g s <= g u) ->
  Rabs (g (t * (1 + e)) - g t) <= Rabs e * g t.
Proof.
  intros positive small concave rising. pose proof (Rabs_le_between e (1 / 2)) as [bounds _]. specialize (bounds small).
  destruct (Rle_lt_dec 0 e) as [above | below].
  - pose proof (rising t (t * (1 + e)) ltac:(nra) ltac:(nra)) as larger.
    pose proof (concave (/ (1 + e)) (t * (1 + e))) as scaled.
    replace (/ (1 + e) * (t * (1 + e))) with t in scaled by (field; lra).
    assert (0 <= / (1 + e) <= 1) as range.
    { split; [left; apply Rinv_0_lt_compat; lra |]. rewrite <- Rinv_1. apply Rinv_le_contravar; lra. }
    specialize (scaled range ltac:(nra)).
    apply (Rmult_le_compat_l (1 + e)) in scaled; [| lra].
    rewrite <- Rmult_assoc, Rinv_r, Rmult_1_l in scaled by lra.
    rewrite !Rabs_pos_eq by lra. lra.
  - pose proof (rising (t * (1 + e)) t ltac:(nra) ltac:(nra)) as smaller.
    pose proof (concave (1 + e) t ltac:(lra) ltac:(lra)) as scaled.
    replace ((1 + e) * t) with (t * (1 + e)) in scaled by ring.
    rewrite (Rabs_left1 e), Rabs_left1 by lra. lra.
Qed.

Theorem arctangent_condition (t e : R) : 0 < t -> Rabs e <= 1 / 2 -> Rabs (atan (t * (1 + e)) - atan t) <= Rabs e * atan t.
Proof.
  intros positive small. apply relative_error; try assumption.
  - intros k s k_range s_range.
    enough (0 <= atan (k * s) - k * atan s) by lra.
    apply (nonnegative (fun s => atan (k * s) - k * atan s) (fun s => k / (1 + (k * s) ^ 2) - k / (1 + s ^ 2))); try lra.
    + intros u _. auto_derive; [exact I |]. field. split; nra.
    + intros u range. enough (k / (1 + u ^ 2) <= k / (1 + (k * u) ^ 2)) by lra.
      apply Rmult_le_compat_l; [lra |]. apply Rinv_le_contravar; [nra |].
      assert (0 <= k * u <= u) by nra. nra.
    + rewrite Rmult_0_r, atan_0. lra.
  - intros s u order _. destruct (Req_dec s u) as [-> | different]; [lra | left; apply atan_increasing; lra].
Qed.

(** exp(t) - 1 for t < 0, with its sign turned: s = -t. *)
Theorem expm1_condition (s e : R) : 0 < s -> Rabs e <= 1 / 2 ->
  Rabs ((1 - exp (- (s * (1 + e)))) - (1 - exp (- s))) <= Rabs e * (1 - exp (- s)).
Proof.
  intros positive small. apply (relative_error (fun s => 1 - exp (- s))); try assumption.
  - intros k u k_range u_range.
    enough (0 <= (1 - exp (- (k * u))) - k * (1 - exp (- u))) by lra.
    apply (nonnegative (fun u => (1 - exp (- (k * u))) - k * (1 - exp (- u))) (fun u => k * exp (- (k * u)) - k * exp (- u))); try lra.
    + intros v _. auto_derive; [exact I |]. ring.
    + intros v range. enough (exp (- v) <= exp (- (k * v))) by nra.
      destruct (Req_dec (k * v) v) as [-> | different]; [lra |]. left. apply exp_increasing. nra.
    + rewrite Rmult_0_r, Ropp_0, exp_0. lra.
  - intros v w order _. enough (exp (- w) <= exp (- v)) by lra.
    destruct (Req_dec v w) as [-> | different]; [lra | left; apply exp_increasing; lra].
Qed.

(** ** The sine up to a quarter of a turn; beyond it, a little, it falls, and its square is what counts *)

Lemma sine_scaled (k s : R) : 0 <= k <= 1 -> 0 <= s <= PI -> k * sin s <= sin (k * s).
Proof.
  intros k_range s_range. enough (0 <= sin (k * s) - k * sin s) by lra.
  apply (nonnegative (fun s => sin (k * s) - k * sin s) (fun s => k * cos (k * s) - k * cos s)); try lra.
  - intros u _. auto_derive; [exact I |]. ring.
  - intros u range. enough (cos u <= cos (k * u)) by nra.
    apply cos_decr_1; try nra. 
  - rewrite Rmult_0_r, sin_0. lra.
Qed.

Lemma sine_and_cosine_of_small (d : R) : Rabs d <= 1 -> 1 - d * d / 2 <= cos d <= 1 /\ Rabs (sin d) <= Rabs d.
Proof.
  intro small. apply Rabs_le_between in small. split; [split |].
  - enough (0 <= cos d - (1 - d * d / 2)) by lra.
    assert (forall b, 0 <= b <= 1 -> 0 <= cos b - (1 - b * b / 2)) as right.
    { intros b range. apply (nonnegative (fun d => cos d - (1 - d * d / 2)) (fun d => d - sin d)); try lra.
      - intros u _. auto_derive; [exact I |]. field.
      - intros u inside. destruct (Req_dec u 0) as [-> | different]; [rewrite sin_0; lra |]. pose proof (sin_lt_x u ltac:(lra)). lra.
      - rewrite cos_0. lra. }
    destruct (Rle_lt_dec 0 d) as [positive | negative]; [apply right; lra |].
    rewrite <- cos_neg. replace (d * d) with (- d * - d) by ring. apply right. lra.
  - apply COS_bound.
  - assert (forall b, 0 <= b <= 1 -> Rabs (sin b) <= b) as right.
    { intros b range. pose proof PI_RGT_0. assert (1 < PI) by interval.
      rewrite Rabs_pos_eq by (apply sin_ge_0; lra).
      destruct (Req_dec b 0) as [-> | different]; [rewrite sin_0; lra |]. pose proof (sin_lt_x b ltac:(lra)). lra. }
    destruct (Rle_lt_dec 0 d) as [positive | negative].
    + rewrite (Rabs_pos_eq d) by assumption. apply right. lra.
    + rewrite (Rabs_left1 d) by lra. rewrite <- (Rabs_Ropp (sin d)), <- sin_neg. apply right. lra.
Qed.

Theorem sine_condition (t e : R) : 0 < t <= PI / 2 -> Rabs e <= 1 / 2 -> Rabs (sin (t * (1 + e)) - sin t) <= Rabs e * sin t.
Proof.
  intros [positive quarter] small. pose proof small as bounds. apply Rabs_le_between in bounds.
  assert (3.14 < PI < 3.15) as pi by (split; interval).
  assert (0 <= sin t) as sine by (apply sin_ge_0; lra).
  destruct (Rle_lt_dec 0 e) as [above | below].
  - rewrite (Rabs_pos_eq e) by assumption.
    pose proof (sine_scaled (/ (1 + e)) (t * (1 + e))) as scaled.
    replace (/ (1 + e) * (t * (1 + e))) with t in scaled by (field; lra).
    assert (0 <= / (1 + e) <= 1) as range.
    { split; [left; apply Rinv_0_lt_compat; lra |]. rewrite <- Rinv_1. apply Rinv_le_contravar; lra. }
    specialize (scaled range ltac:(nra)).
    apply (Rmult_le_compat_l (1 + e)) in scaled; [| lra].
    rewrite <- Rmult_assoc, Rinv_r, Rmult_1_l in scaled by lra.
    assert (Rabs (t * e) <= 1) as little by (rewrite Rabs_pos_eq by nra; nra).
    destruct (sine_and_cosine_of_small (t * e) little) as [[cosine _] _].
    assert (0 <= cos t) by (apply cos_ge_0; lra).
    assert (0 <= sin (t * e)) by (apply sin_ge_0; nra).
    assert (sin (t * (1 + e)) = sin t * cos (t * e) + cos t * sin (t * e)) as sum
      by (replace (t * (1 + e)) with (t + t * e) by ring; apply sin_plus).
    assert (t * e * (t * e) / 2 <= e) by (assert (t * t * e <= 2) by nra; nra).
    apply Rabs_le. split; nra.
  - rewrite (Rabs_left1 e) by lra.
    pose proof (sine_scaled (1 + e) t ltac:(lra) ltac:(lra)) as scaled.
    replace ((1 + e) * t) with (t * (1 + e)) in scaled by ring.
    assert (sin (t * (1 + e)) <= sin t) by (apply sin_incr_1; nra).
    apply Rabs_le. split; lra.
Qed.

Lemma sine_moved (t e : R) : PI / 4 <= t <= PI / 2 -> Rabs e <= 1e-9 ->
  0 <= sin t /\ Rabs (sin (t * (1 + e)) - sin t) <= Rabs e * (t * cos t + 0.001 * sin t).
Proof.
  intros range small.
  assert (3.14 < PI < 3.15) as pi by (split; interval).
  assert (Rabs (t * e) <= 1) as little by (rewrite Rabs_mult, (Rabs_pos_eq t) by lra; pose proof (Rabs_pos e); nra).
  destruct (sine_and_cosine_of_small (t * e) little) as [cosine sine].
  assert (sin (t * (1 + e)) = sin t * cos (t * e) + cos t * sin (t * e)) as sum
    by (replace (t * (1 + e)) with (t + t * e) by ring; apply sin_plus).
  rewrite sum. clear sum.
  assert (0 <= cos t) as cosine_of_t by (apply cos_ge_0; lra).
  assert (0 <= sin t) as sine_of_t by (apply sin_ge_0; lra).
  split; [assumption |].
  replace (sin t * cos (t * e) + cos t * sin (t * e) - sin t) with (sin t * (cos (t * e) - 1) + cos t * sin (t * e)) by ring.
  eapply Rle_trans; [apply Rabs_triang |].
  rewrite !Rabs_mult, (Rabs_pos_eq (sin t)), (Rabs_pos_eq (cos t)) by assumption.
  assert (Rabs (cos (t * e) - 1) <= 0.001 * Rabs e) as second.
  { rewrite Rabs_left1 by lra. assert (t * e * (t * e) / 2 <= 0.001 * Rabs e); [| lra].
    replace (t * e * (t * e) / 2) with (t * t / 2 * (Rabs e * Rabs e)) by (rewrite <- Rabs_mult, Rabs_pos_eq by nra; field).
    pose proof (Rabs_pos e). assert (t * t <= 4) by nra. nra. }
  assert (cos t * Rabs (sin (t * e)) <= Rabs e * (t * cos t)).
  { rewrite Rabs_mult, (Rabs_pos_eq t) in sine by lra. pose proof (Rabs_pos e).
    apply Rle_trans with (cos t * (t * Rabs e)); [apply Rmult_le_compat_l; lra | nra]. }
  nra.
Qed.

Lemma in_decimals (t : R) : PI / 4 <= t <= PI / 2 -> 0.785398 <= t <= 1.5708.
Proof. intro range. split; [apply Rle_trans with (PI / 4); [interval | lra] | apply Rle_trans with (PI / 2); [lra | interval]]. Qed.

Theorem sine_condition_steep (t e : R) : PI / 4 <= t <= PI / 2 -> Rabs e <= 1e-9 ->
  Rabs (sin (t * (1 + e)) - sin t) <= 0.787 * Rabs e * sin t.
Proof.
  intros range small. destruct (sine_moved t e range small) as [positive moved]. apply Rle_trans with (1 := moved).
  pose proof (in_decimals t range). assert (0 <= 0.786 * sin t - t * cos t) by interval with (i_bisect t, i_taylor t, i_prec 60).
  pose proof (Rabs_pos e). nra.
Qed.

Theorem sine_condition_absolute (t e : R) : PI / 4 <= t <= PI / 2 -> Rabs e <= 1e-9 -> Rabs (sin (t * (1 + e)) - sin t) <= 0.5625 * Rabs e.
Proof.
  intros range small. destruct (sine_moved t e range small) as [_ moved]. apply Rle_trans with (1 := moved).
  pose proof (in_decimals t range). assert (t * cos t + 0.001 * sin t <= 0.5625) by interval with (i_bisect t, i_taylor t, i_prec 60).
  pose proof (Rabs_pos e). nra.
Qed.

(** ** The arcsine up to an eighth of a turn, where the double forms take it *)

Lemma tangent_below_line (a : R) : 0 <= a <= 0.786 -> sin a <= 1279 / 1000 * a * cos a.
Proof.
  intro range. enough (0 <= 1279 / 1000 * a * cos a - sin a) by lra.
  destruct (Rle_lt_dec a 0.125) as [low | high].
  - apply (nonnegative (fun a => 1279 / 1000 * a * cos a - sin a) (fun a => 279 / 1000 * cos a - 1279 / 1000 * a * sin a)); try lra.
    + intros u _. auto_derive; [exact I |]. field.
    + intros u inside. assert (0 <= u <= 0.125) by lra. interval with (i_bisect u).
    + rewrite Rmult_0_r, Rmult_0_l, sin_0. lra.
  - assert (0.125 <= a <= 0.786) by lra. interval with (i_bisect a, i_taylor a, i_prec 60).
Qed.

Lemma arcsine_increases (a b : R) : -1 <= a -> a < b -> b <= 1 -> asin a < asin b.
Proof.
  intros low order high. destruct (Rlt_le_dec (asin a) (asin b)) as [| wrong]; [assumption | exfalso].
  pose proof (asin_bound a). pose proof (asin_bound b).
  pose proof (sin_incr_1 (asin b) (asin a) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) wrong) as falls.
  rewrite !sin_asin in falls by lra. lra.
Qed.

Lemma arcsine_derivative (x : R) : -1 < x < 1 -> derivable_pt_lim asin x (/ sqrt (1 - x²)).
Proof.
  intro range. apply (derive_pt_eq_1 asin x _ (derivable_pt_asin x range)). rewrite derive_pt_asin. field.
  apply Rgt_not_eq, sqrt_lt_R0. unfold Rsqr. nra.
Qed.

Theorem arcsine_condition (r e : R) : 0 < r <= 0.7072 -> Rabs e <= 1e-9 -> Rabs (asin (r * (1 + e)) - asin r) <= 1.28 * Rabs e * asin r.
Proof.
  intros range small. pose proof small as bounds. apply Rabs_le_between in bounds.
  assert (0 < asin r) as arc by (rewrite <- asin_0; apply arcsine_increases; lra).
  assert (asin r <= 0.786) as low.
  { apply Rle_trans with (asin 0.7072).
    - destruct (Req_dec r 0.7072) as [-> | different]; [lra | left; apply arcsine_increases; lra].
    - rewrite asin_atan by lra. interval. }
  pose proof (tangent_below_line (asin r) ltac:(lra)) as tangent. rewrite sin_asin in tangent by lra.
  rewrite cos_asin in tangent by lra.
  destruct (MVT_gen asin r (r * (1 + e)) (fun x => / sqrt (1 - x * x))) as [c [between difference]].
  - intros x inside. apply is_derive_Reals. change (x * x) with (Rsqr x). apply arcsine_derivative.
    split; [apply Rlt_trans with (Rmin r (r * (1 + e))); [apply Rmin_glb_lt; nra | lra] |
      apply Rlt_trans with (Rmax r (r * (1 + e))); [lra | apply Rmax_lub_lt; nra]].
  - intros x inside. apply derivable_continuous_pt. exists (/ sqrt (1 - x²)). apply arcsine_derivative.
    split; [apply Rlt_le_trans with (Rmin r (r * (1 + e))); [apply Rmin_glb_lt; nra | lra] |
      apply Rle_lt_trans with (Rmax r (r * (1 + e))); [lra | apply Rmax_lub_lt; nra]].
  - rewrite difference. replace (r * (1 + e) - r) with (r * e) by ring.
    rewrite Rabs_mult, Rabs_mult, (Rabs_pos_eq r) by lra.
    assert (0 <= c <= r * (1 + 1e-9)) as c_range.
    { split; [apply Rle_trans with (Rmin r (r * (1 + e))); [apply Rmin_glb; nra | lra] |].
      apply Rle_trans with (Rmax r (r * (1 + e))); [lra | apply Rmax_lub; nra]. }
    assert (0 < 1 - c * c) as inner by nra.
    assert (0 < sqrt (1 - c * c)) as root by (apply sqrt_lt_R0; assumption).
    rewrite (Rabs_pos_eq (/ sqrt (1 - c * c))) by (left; apply Rinv_0_lt_compat; assumption).
    assert (sqrt (1 - r²) <= (1280 / 1279) * sqrt (1 - c * c)) as near.
    { rewrite <- (sqrt_square (1280 / 1279)) by lra. rewrite <- sqrt_mult by lra. apply sqrt_le_1_alt. unfold Rsqr. nra. }
    assert (r <= 1.28 * asin r * sqrt (1 - c * c)) as ratio by nra.
    replace (1.28 * Rabs e * asin r) with (/ sqrt (1 - c * c) * (1.28 * asin r * sqrt (1 - c * c) * Rabs e)) by (field; lra).
    apply Rmult_le_compat_l; [left; apply Rinv_0_lt_compat; assumption |].
    apply Rmult_le_compat_r; [apply Rabs_pos | assumption].
Qed.
