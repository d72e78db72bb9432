(* SPDX-License-Identifier: GPL-3.0-or-later *)
(** * A double form, closed: what Gappa proves of variables, said of the functions themselves

    Gappa's theorem on ../gappa/westergaard_half_width_low.g takes the C library's error and what the root's rounding does to the arcsine as
    hypotheses. Here the second is a theorem (Conditions.v): only the library's error is left. [round64] is rounding to binary64, to
    nearest. *)

From Coq Require Import Reals Lra Psatz Classical.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
From Gappa Require Import Gappa_library.
Require Import Wave Conditions.
Require gappa_westergaard_half_width_low.
Open Scope R_scope.

Definition round64 (x : R) : R := rounding_float rndNE 53 (-1074) x.
Definition pi64 : R := 884279719003555 / 281474976710656.

(** A number near another, as Gappa says it. *)
Lemma relation (x y b : R) (i : FF) : 0 < y -> Rabs (x - y) <= b * y -> lower i <= - b -> b <= upper i -> REL x y i.
Proof.
  intros positive near low high. exists ((x - y) / y). apply Rabs_le_between in near. split; [split |].
  - apply Rle_trans with (1 := low). apply Rmult_le_reg_r with y; [assumption |]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. lra.
  - apply Rle_trans with (2 := high). apply Rmult_le_reg_r with y; [assumption |]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. lra.
  - field. lra.
Qed.

Lemma distance (x y b : R) (i : FF) : 0 < y -> REL x y i -> - b <= lower i -> upper i <= b -> Rabs (x - y) <= b * y.
Proof.
  intros positive [e [[low high] ->]] left right. replace (y * (1 + e) - y) with (e * y) by ring.
  rewrite Rabs_mult, (Rabs_pos_eq y) by lra. apply Rmult_le_compat_r; [lra |]. apply Rabs_le. lra.
Qed.

Ltac number := unfold lower, upper, float2R, Defs.F2R; simpl; lra.

Module G := gappa_westergaard_half_width_low.

Lemma pi_between : BND PI G.i2.
Proof. unfold BND, G.i2, G.f3, G.f4, lower, upper, float2R, Defs.F2R. simpl. split; interval with (i_prec 100). Qed.

(** All that Gappa proves of the form. *)
Lemma conclusions (s Arc ArcOfRoot A : R) : BND s G.i1 -> BND Arc G.i3 -> REL ArcOfRoot Arc G.i4 -> REL A ArcOfRoot G.i5 ->
  REL (round64 (sqrt s)) (sqrt s) G.i7 /\ REL (round64 (A / Float2 884279719003555 (-48))) (Arc / PI) G.i9.
Proof.
  intros s_range arc_range arc library.
  assert (same : REL ArcOfRoot ArcOfRoot G.i6).
  { exists 0. split; [unfold G.i6, G.f11, G.f12; split; number | ring]. }
  pose proof (G.l1 s PI Arc ArcOfRoot A ArcOfRoot) as theorem.
  unfold G.s1, G.s2, G.s3, G.s4, G.s5, G.s6, G.s7, G.s8, G.s9, G.s10, G.s11, G.s12 in theorem.
  pose proof pi_between.
  split; apply NNPP; intro wrong; apply theorem; unfold round64 in wrong; tauto.
Qed.

(** (2.5) for loads up to 1/2: with a library's arcsine [A] of the rounded root within one ulp, the value is within 4.66 units 2^-53. *)
Theorem half_width_in_binary64 (s A : R) : / 2 ^ 900 <= s <= 1 / 2 ->
  Rabs (A - asin (round64 (sqrt s))) <= / 2 ^ 52 * asin (round64 (sqrt s)) ->
  Rabs (round64 (A / pi64) - half_width s / PI) <= 298 / 2 ^ 59 * (half_width s / PI).
Proof.
  intros range library.
  assert (s_range : BND s G.i1).
  { unfold BND, G.i1, G.f1, G.f2, lower, upper, float2R, Defs.F2R. simpl. split; [| lra].
    apply Rle_trans with (2 := proj1 range). interval. }
  assert (root_range : / 2 ^ 450 <= sqrt s <= 0.70711).
  { split.
    - rewrite <- (sqrt_square (/ 2 ^ 450)) by (left; apply Rinv_0_lt_compat, pow_lt; lra). apply sqrt_le_1_alt.
      apply Rle_trans with (2 := proj1 range). interval with (i_prec 60).
    - apply Rle_trans with (sqrt (1 / 2)); [apply sqrt_le_1_alt; lra | interval]. }
  assert (small : 0 < / 2 ^ 450) by (apply Rinv_0_lt_compat, pow_lt; lra).
  assert (one : REL 1 1 G.i4 /\ REL 1 1 G.i5 /\ BND 1 G.i3).
  { repeat split; try (exists 0; split; [| ring]).
    - unfold G.i4, G.f7, G.f8. split; number.
    - unfold G.i5, G.f9, G.f10. split; number.
    - unfold lower, G.i3, G.f5, float2R, Defs.F2R. simpl. interval.
    - unfold upper, G.i3, G.f6, float2R, Defs.F2R. simpl. lra. }
  destruct one as [one_arc [one_library one_range]].
  destruct (conclusions s 1 1 1 s_range one_range one_arc one_library) as [[e [[low high] root]] _].
  assert (Rabs e <= / 2 ^ 53) as small_e.
  { unfold G.i7, G.f13, G.f14, lower, upper, float2R, Defs.F2R in low, high. simpl in low, high. apply Rabs_le. simpl. lra. }
  assert (arc : 0 < half_width s) by (unfold half_width; rewrite <- asin_0; apply arcsine_increases; lra).
  pose proof (arcsine_condition (sqrt s) e ltac:(lra)) as condition.
  assert (Rabs e <= 1e-9) as e_bound by (apply Rle_trans with (1 := small_e); interval).
  specialize (condition e_bound). rewrite <- root in condition. fold (half_width s) in condition.
  assert (arc_of_root : REL (asin (round64 (sqrt s))) (half_width s) G.i4).
  { apply relation with (1.28 * / 2 ^ 53); [assumption | | |].
    - apply Rle_trans with (1 := condition). apply Rmult_le_compat_r; [lra |]. nra.
    - unfold G.i4, G.f7, lower, float2R, Defs.F2R. simpl. lra.
    - unfold G.i4, G.f8, upper, float2R, Defs.F2R. simpl. lra. }
  assert (arc_of_root_positive : 0 < asin (round64 (sqrt s))).
  { destruct arc_of_root as [d [[left right] ->]]. unfold G.i4, G.f7, G.f8, lower, upper, float2R, Defs.F2R in left, right.
    simpl in left, right. nra. }
  assert (library_relation : REL A (asin (round64 (sqrt s))) G.i5).
  { apply relation with (/ 2 ^ 52); [assumption | assumption | |].
    - unfold G.i5, G.f9, lower, float2R, Defs.F2R. simpl. lra.
    - unfold G.i5, G.f10, upper, float2R, Defs.F2R. simpl. lra. }
  assert (arc_range : BND (half_width s) G.i3).
  { pose proof (half_width_range s ltac:(lra)). split.
    - apply Rle_trans with (/ 2 ^ 451); [unfold lower, G.i3, G.f5, float2R, Defs.F2R; simpl; interval |].
      apply Rle_trans with (sqrt s); [apply Rle_trans with (2 := proj1 root_range); interval |].
      pose proof (sin_lt_x (half_width s) arc) as above. unfold half_width in above at 1. rewrite sin_asin in above by lra. lra.
    - unfold upper, G.i3, G.f6, float2R, Defs.F2R. simpl. unfold half_width. apply Rle_trans with (asin 0.7072).
      + left. apply arcsine_increases; lra.
      + rewrite asin_atan by lra. interval. }
  destruct (conclusions s (half_width s) _ A s_range arc_range arc_of_root library_relation) as [_ form].
  replace pi64 with (float2R (Float2 884279719003555 (-48))) by (unfold pi64, float2R, Defs.F2R; simpl; lra).
  apply distance with G.i9.
  - apply Rdiv_lt_0_compat; [assumption | apply PI_RGT_0].
  - exact form.
  - unfold G.i9, G.f17, lower, float2R, Defs.F2R. simpl. lra.
  - unfold G.i9, G.f18, upper, float2R, Defs.F2R. simpl. lra.
Qed.
