(* SPDX-License-Identifier: GPL-3.0-or-later *)
(** * Table 1 and K_inf in numbers

    The tactic [integral] encloses phi(delta_n) from t = 2^-17 on; what lies before is smaller than 2^-41. *)

From Coq Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
Require Import Wave Operator Equilibrium Archard.
Open Scope R_scope.

Definition cut : R := 1 / 131072.

Definition body (n : nat) : R := RInt (fun t => exp ((1 - h n) * ln (2 * sin t)) * sin t) cut (PI / 2).

(** Near 0 the integrand is at most sqrt(2 t) t, as (2 sin t)^delta with 1/2 <= delta < 1 is at most the root. *)
Lemma before_the_cut (n : nat) : 0 <= RInt (integrand (1 - h n)) 0 cut <= 1e-12.
Proof.
  pose proof (h_range n) as h_bounds. pose proof PI2_1 as pi_large.
  pose proof (RInt_correct (V := R_CompleteNormedModule) _ _ _ (integrand_integrable (1 - h n) 0 cut ltac:(lra))) as value.
  assert (bounds : forall t, 0 < t < cut -> 0 <= integrand (1 - h n) t <= / 256 * cut).
  { unfold cut. intros t range. rewrite integrand_inside by lra.
    pose proof (sine_positive t ltac:(lra)) as sine. pose proof (sin_lt_x t ltac:(lra)) as below.
    assert (log_negative : ln (2 * sin t) <= ln (/ 65536)) by (apply Rlt_le, ln_increasing; lra).
    assert (log_value : ln (/ 65536) < 0) by (rewrite <- ln_1; apply ln_increasing; lra).
    assert (root : exp ((1 - h n) * ln (2 * sin t)) <= / 256).
    { assert (half : exp (/ 2 * ln (/ 65536)) = / 256).
      { apply Rsqr_inj; [apply Rlt_le, exp_pos | lra |]. unfold Rsqr. rewrite <- exp_plus.
        replace (/ 2 * ln (/ 65536) + / 2 * ln (/ 65536)) with (ln (/ 65536)) by field. rewrite exp_ln by lra. lra. }
      rewrite <- half. assert (order : (1 - h n) * ln (2 * sin t) <= / 2 * ln (/ 65536)) by nra.
      destruct order as [less | ->]; [apply Rlt_le, exp_increasing, less | apply Rle_refl]. }
    pose proof (exp_pos ((1 - h n) * ln (2 * sin t))). split; [nra |].
    apply Rmult_le_compat; lra. }
  split.
  - apply (is_RInt_le (fun _ => 0) (integrand (1 - h n)) 0 cut 0 _); [unfold cut; lra | | exact value | intros t range; apply bounds, range].
    pose proof (is_RInt_const (V := R_NormedModule) 0 cut 0) as nothing.
    unfold scal in nothing; simpl in nothing; unfold mult in nothing; simpl in nothing. rewrite Rmult_0_r in nothing. exact nothing.
  - apply Rle_trans with ((cut - 0) * (/ 256 * cut)); [| unfold cut; lra].
    apply (is_RInt_le (integrand (1 - h n)) (fun _ => / 256 * cut) 0 cut _ _); [unfold cut; lra | exact value | | intros t range; apply bounds, range].
    exact (is_RInt_const (V := R_NormedModule) 0 cut (/ 256 * cut)).
Qed.

Lemma step_in_parts (n : nat) : phi (1 - h n) = 2 / PI * (RInt (integrand (1 - h n)) 0 cut + body n).
Proof.
  pose proof (h_range n) as h_bounds. pose proof PI2_1 as pi_large.
  unfold phi, body. f_equal.
  rewrite <- (RInt_Chasles (V := R_CompleteNormedModule) (integrand (1 - h n)) 0 cut (PI / 2)) by (apply integrand_integrable; lra).
  unfold plus; simpl. f_equal. apply RInt_ext. intros t range. unfold cut in range. rewrite Rmin_left, Rmax_right in range by lra.
  apply integrand_inside. lra.
Qed.

(** From an enclosure of the body to one of the step. *)
Lemma step_within (n : nat) (b v : R) : Rabs (body n - b) <= 1e-11 -> 0 <= b <= 2 -> Rabs (2 / PI * b - v) <= 2e-12 -> Rabs (phi (1 - h n) - v) <= 1e-11.
Proof.
  intros near range rounding. rewrite step_in_parts. pose proof (before_the_cut n) as head.
  set (first := RInt (integrand (1 - h n)) 0 cut) in *. set (second := body n) in *. clearbody first second.
  apply Rabs_le_between in near. apply Rabs_le_between in rounding.
  assert (share : 0 < 2 / PI <= 0.64) by (split; interval).
  replace (2 / PI * (first + second) - v) with (2 / PI * (first + (second - b)) + (2 / PI * b - v)) by ring.
  apply Rabs_le. split; nra.
Qed.

Ltac enclose_step b := apply step_within with b; [unfold body, cut, h; simpl pow; integral with (i_fuel 4000, i_degree 12) | lra | interval].

(** The steps phi(delta_n), each to 1e-11. *)
Lemma step_0 : Rabs (phi (1 - h 0) - 0.7868937326774) <= 1e-11.
Proof. enclose_step 1.23604978486758. Qed.
Lemma step_1 : Rabs (phi (1 - h 1) - 0.8846288125116) <= 1e-11.
Proof. enclose_step 1.38957168927011. Qed.
Lemma step_2 : Rabs (phi (1 - h 2) - 0.9399618706014) <= 1e-11.
Proof. enclose_step 1.47648865366796. Qed.
Lemma step_3 : Rabs (phi (1 - h 3) - 0.9693725564938) <= 1e-11.
Proof. enclose_step 1.52268685103624. Qed.
Lemma step_4 : Rabs (phi (1 - h 4) - 0.9845315414198) <= 1e-11.
Proof. enclose_step 1.54649852887600. Qed.
Lemma step_5 : Rabs (phi (1 - h 5) - 0.9922267491618) <= 1e-11.
Proof. enclose_step 1.55858613293095. Qed.
Lemma step_6 : Rabs (phi (1 - h 6) - 0.9961035765803) <= 1e-11.
Proof. enclose_step 1.56467583919957. Qed.
Lemma step_7 : Rabs (phi (1 - h 7) - 0.9980493334353) <= 1e-11.
Proof. enclose_step 1.56773222692028. Qed.
Lemma step_8 : Rabs (phi (1 - h 8) - 0.9990240523329) <= 1e-11.
Proof. enclose_step 1.56926331178421. Qed.
Lemma step_9 : Rabs (phi (1 - h 9) - 0.9995118724862) <= 1e-11.
Proof. enclose_step 1.57002957788927. Qed.
Lemma step_10 : Rabs (phi (1 - h 10) - 0.9997558978126) <= 1e-11.
Proof. enclose_step 1.57041289197551. Qed.
Lemma step_11 : Rabs (phi (1 - h 11) - 0.9998779392973) <= 1e-11.
Proof. enclose_step 1.57060459429149. Qed.
Lemma step_12 : Rabs (phi (1 - h 12) - 0.9999389672463) <= 1e-11.
Proof. enclose_step 1.57070045676951. Qed.
Lemma step_13 : Rabs (phi (1 - h 13) - 0.9999694830225) <= 1e-11.
Proof. enclose_step 1.57074839083875. Qed.

(** A product of two enclosed numbers. *)
Lemma product_within (k p k0 p0 ek ep e : R) : Rabs (k - k0) <= ek -> Rabs (p - p0) <= ep -> 0 <= k0 -> 0 <= p0 ->
  k0 * ep + p0 * ek + ek * ep <= e -> forall v, Rabs (k0 * p0 - v) <= 1e-12 -> Rabs (k * p - v) <= e + 1e-12.
Proof.
  intros near_k near_p k0_positive p0_positive total v rounding.
  replace (k * p - v) with ((k0 * (p - p0) + p0 * (k - k0)) + (k - k0) * (p - p0) + (k0 * p0 - v)) by ring.
  pose proof (Rabs_pos (k - k0)). pose proof (Rabs_pos (p - p0)).
  eapply Rle_trans; [apply Rabs_triang |]. apply Rplus_le_compat; [| exact rounding].
  eapply Rle_trans; [apply Rabs_triang |]. apply Rle_trans with (2 := total). apply Rplus_le_compat.
  - eapply Rle_trans; [apply Rabs_triang |]. rewrite !Rabs_mult, (Rabs_pos_eq k0), (Rabs_pos_eq p0) by assumption. nra.
  - rewrite Rabs_mult. apply Rmult_le_compat; assumption.
Qed.

(** Table 1: K_n to within (n + 1) 1e-11. *)
Lemma K_0 : Rabs (K 0 - 0.6366197723676) <= 1e-11.
Proof. simpl. interval with (i_prec 60). Qed.
Lemma K_1 : Rabs (K 1 - 0.5009521089746) <= 2e-11.
Proof.
  change (K 1) with (K 0 * phi (1 - h 0)).
  apply Rle_trans with (1.8e-11 + 1e-12); [| lra].
  refine (product_within _ _ 0.6366197723676 0.7868937326774 _ _ _ K_0 step_0 _ _ _ _ _); try lra. apply Rabs_le. lra.
Qed.
Lemma K_2 : Rabs (K 2 - 0.4431566692873) <= 3e-11.
Proof.
  change (K 2) with (K 1 * phi (1 - h 1)).
  apply Rle_trans with (2.8e-11 + 1e-12); [| lra].
  refine (product_within _ _ 0.5009521089746 0.8846288125116 _ _ _ K_1 step_1 _ _ _ _ _); try lra. apply Rabs_le. lra.
Qed.
Lemma K_3 : Rabs (K 3 - 0.4165503718328) <= 4e-11.
Proof.
  change (K 3) with (K 2 * phi (1 - h 2)).
  apply Rle_trans with (3.8e-11 + 1e-12); [| lra].
  refine (product_within _ _ 0.4431566692873 0.9399618706014 _ _ _ K_2 step_2 _ _ _ _ _); try lra. apply Rabs_le. lra.
Qed.
Lemma K_4 : Rabs (K 4 - 0.4037924988520) <= 5e-11.
Proof.
  change (K 4) with (K 3 * phi (1 - h 3)).
  apply Rle_trans with (4.8e-11 + 1e-12); [| lra].
  refine (product_within _ _ 0.4165503718328 0.9693725564938 _ _ _ K_3 step_3 _ _ _ _ _); try lra. apply Rabs_le. lra.
Qed.
Lemma K_5 : Rabs (K 5 - 0.3975464513085) <= 6e-11.
Proof.
  change (K 5) with (K 4 * phi (1 - h 4)).
  apply Rle_trans with (5.8e-11 + 1e-12); [| lra].
  refine (product_within _ _ 0.4037924988520 0.9845315414198 _ _ _ K_4 step_4 _ _ _ _ _); try lra. apply Rabs_le. lra.
Qed.
Lemma K_6 : Rabs (K 6 - 0.3944562230227) <= 7e-11.
Proof.
  change (K 6) with (K 5 * phi (1 - h 5)).
  apply Rle_trans with (6.8e-11 + 1e-12); [| lra].
  refine (product_within _ _ 0.3975464513085 0.9922267491618 _ _ _ K_5 step_5 _ _ _ _ _); try lra. apply Rabs_le. lra.
Qed.
Lemma K_7 : Rabs (K 7 - 0.3929192545572) <= 8e-11.
Proof.
  change (K 7) with (K 6 * phi (1 - h 6)).
  apply Rle_trans with (7.8e-11 + 1e-12); [| lra].
  refine (product_within _ _ 0.3944562230227 0.9961035765803 _ _ _ K_6 step_6 _ _ _ _ _); try lra. apply Rabs_le. lra.
Qed.
Lemma K_8 : Rabs (K 8 - 0.3921528001047) <= 9e-11.
Proof.
  change (K 8) with (K 7 * phi (1 - h 7)).
  apply Rle_trans with (8.8e-11 + 1e-12); [| lra].
  refine (product_within _ _ 0.3929192545572 0.9980493334353 _ _ _ K_7 step_7 _ _ _ _ _); try lra. apply Rabs_le. lra.
Qed.
Lemma K_9 : Rabs (K 9 - 0.3917700794943) <= 10e-11.
Proof.
  change (K 9) with (K 8 * phi (1 - h 8)).
  apply Rle_trans with (9.8e-11 + 1e-12); [| lra].
  refine (product_within _ _ 0.3921528001047 0.9990240523329 _ _ _ K_8 step_8 _ _ _ _ _); try lra. apply Rabs_le. lra.
Qed.
Lemma K_10 : Rabs (K 10 - 0.3915788457395) <= 11e-11.
Proof.
  change (K 10) with (K 9 * phi (1 - h 9)).
  apply Rle_trans with (10.8e-11 + 1e-12); [| lra].
  refine (product_within _ _ 0.3917700794943 0.9995118724862 _ _ _ K_9 step_9 _ _ _ _ _); try lra. apply Rabs_le. lra.
Qed.
Lemma K_11 : Rabs (K 11 - 0.3914832604867) <= 12e-11.
Proof.
  change (K 11) with (K 10 * phi (1 - h 10)).
  apply Rle_trans with (11.8e-11 + 1e-12); [| lra].
  refine (product_within _ _ 0.3915788457395 0.9997558978126 _ _ _ K_10 step_10 _ _ _ _ _); try lra. apply Rabs_le. lra.
Qed.
Lemma K_12 : Rabs (K 12 - 0.3914354757648) <= 13e-11.
Proof.
  change (K 12) with (K 11 * phi (1 - h 11)).
  apply Rle_trans with (12.8e-11 + 1e-12); [| lra].
  refine (product_within _ _ 0.3914832604867 0.9998779392973 _ _ _ K_11 step_11 _ _ _ _ _); try lra. apply Rabs_le. lra.
Qed.
Lemma K_13 : Rabs (K 13 - 0.3914115853798) <= 14e-11.
Proof.
  change (K 13) with (K 12 * phi (1 - h 12)).
  apply Rle_trans with (13.8e-11 + 1e-12); [| lra].
  refine (product_within _ _ 0.3914354757648 0.9999389672463 _ _ _ K_12 step_12 _ _ _ _ _); try lra. apply Rabs_le. lra.
Qed.
Lemma K_14 : Rabs (K 14 - 0.3913996406813) <= 15e-11.
Proof.
  change (K 14) with (K 13 * phi (1 - h 13)).
  apply Rle_trans with (14.8e-11 + 1e-12); [| lra].
  refine (product_within _ _ 0.3914115853798 0.9999694830225 _ _ _ K_13 step_13 _ _ _ _ _); try lra. apply Rabs_le. lra.
Qed.

(** (7.20): K_inf to eight places. *)
Theorem K_inf_to_eight_places : Rabs (K_inf - 0.39138770) <= 0.5e-8.
Proof.
  pose proof (K_inf_lower 13) as lower. pose proof (K_inf_upper 13) as upper.
  pose proof K_13 as near. pose proof K_14 as next. apply Rabs_le_between in near. apply Rabs_le_between in next.
  assert (exponential : 1 - 0.0000610351563 <= exp (- h 13)) by (unfold h; simpl; interval with (i_prec 60)).
  apply Rabs_le. split.
  - pose proof (Rmult_le_compat (0.3914115853798 - 14e-11) (K 13) (1 - 0.0000610351563) (exp (- h 13)) ltac:(lra) ltac:(lra) ltac:(lra) exponential). lra.
  - assert (K 14 * K 14 / K 13 <= 0.391387705); [| lra].
    apply Rle_div_l; [lra |].
    pose proof (Rmult_le_compat (K 14) (0.3913996406813 + 15e-11) (K 14) (0.3913996406813 + 15e-11) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra)). lra.
Qed.

(** The entries of Table 1 for n = 1 to 14, as printed. *)
Theorem table_1 :
  Rabs (K 1 - 0.500952) <= 0.5e-6 /\
  Rabs (K 2 - 0.443157) <= 0.5e-6 /\
  Rabs (K 3 - 0.416550) <= 0.5e-6 /\
  Rabs (K 4 - 0.403792) <= 0.5e-6 /\
  Rabs (K 5 - 0.397546) <= 0.5e-6 /\
  Rabs (K 6 - 0.394456) <= 0.5e-6 /\
  Rabs (K 7 - 0.392919) <= 0.5e-6 /\
  Rabs (K 8 - 0.392153) <= 0.5e-6 /\
  Rabs (K 9 - 0.391770) <= 0.5e-6 /\
  Rabs (K 10 - 0.391579) <= 0.5e-6 /\
  Rabs (K 11 - 0.391483) <= 0.5e-6 /\
  Rabs (K 12 - 0.391435) <= 0.5e-6 /\
  Rabs (K 13 - 0.391412) <= 0.5e-6 /\
  Rabs (K 14 - 0.391400) <= 0.5e-6.
Proof.
  pose proof K_1 as k1. apply Rabs_le_between in k1.
  pose proof K_2 as k2. apply Rabs_le_between in k2.
  pose proof K_3 as k3. apply Rabs_le_between in k3.
  pose proof K_4 as k4. apply Rabs_le_between in k4.
  pose proof K_5 as k5. apply Rabs_le_between in k5.
  pose proof K_6 as k6. apply Rabs_le_between in k6.
  pose proof K_7 as k7. apply Rabs_le_between in k7.
  pose proof K_8 as k8. apply Rabs_le_between in k8.
  pose proof K_9 as k9. apply Rabs_le_between in k9.
  pose proof K_10 as k10. apply Rabs_le_between in k10.
  pose proof K_11 as k11. apply Rabs_le_between in k11.
  pose proof K_12 as k12. apply Rabs_le_between in k12.
  pose proof K_13 as k13. apply Rabs_le_between in k13.
  pose proof K_14 as k14. apply Rabs_le_between in k14.
  repeat split; apply Rabs_le; lra.
Qed.
