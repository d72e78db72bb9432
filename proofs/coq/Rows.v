(* SPDX-License-Identifier: GPL-3.0-or-later *)
(** * What the rows of closed-form tables say, and the lemmas that bring each case within reach of the tactic [interval]

    The definitions are the paper's; the lemmas only choose the branch and write arcsin as arctan, which [interval] knows. *)

From Coq Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
Require Import Wave Peaks.
Open Scope R_scope.

(** |true - value| <= error, the claim of a row. *)
Definition within (true_value value error : R) : Prop := Rabs (true_value - value) <= error.

Definition hertz_half_width (load : R) : R := sqrt load / PI.                        (* (2.7), unit lambda *)
Definition westergaard_half_width (load : R) : R := half_width load / PI.            (* (2.5), unit lambda *)
Definition westergaard_pressure (x load : R) : R := pressure load (PI * x).          (* (2.2), (2.4), unit p* *)

Definition exceedance_full (p load : R) : R := acos (p - load) / PI.                 (* (2.14), corrected: no lambda *)
Definition exceedance_partial (p load : R) : R :=                                    (* (2.17) *)
  2 / PI * asin (sqrt (/ 2 * ((load + 1) - sqrt ((1 - load) * (1 - load) + p * p)))).

Lemma half_width_by_arctangent (x : R) : 0 <= x < 1 -> half_width x = atan (sqrt x / sqrt (1 - x)).
Proof.
  intros [low high]. unfold half_width. pose proof (sqrt_pos x).
  assert (sqrt x < 1) by (rewrite <- sqrt_1; apply sqrt_lt_1; lra).
  rewrite asin_atan by lra. f_equal. f_equal. f_equal.
  unfold Rsqr. rewrite sqrt_sqrt; lra.
Qed.

Lemma westergaard_half_width_row (x : R) : 0 <= x < 1 -> westergaard_half_width x = atan (sqrt x / sqrt (1 - x)) / PI.
Proof. intro. unfold westergaard_half_width. rewrite half_width_by_arctangent by assumption. reflexivity. Qed.

Lemma pressure_full_row (x load : R) : 1 <= load -> westergaard_pressure x load = load + cos (2 * (PI * x)).
Proof. intro. unfold westergaard_pressure, pressure. destruct (Rle_dec 1 load); [reflexivity | lra]. Qed.

Lemma pressure_partial_row (x load : R) : load < 1 ->
  westergaard_pressure x load = 2 * cos (PI * x) * sqrt (load - sin (PI * x) * sin (PI * x)).
Proof. intro. unfold westergaard_pressure, pressure. destruct (Rle_dec 1 load); [lra | reflexivity]. Qed.

Lemma pressure_outside_row (x load : R) : load < 1 -> load <= sin (PI * x) * sin (PI * x) -> westergaard_pressure x load = 0.
Proof. intros partial outside. rewrite pressure_partial_row by assumption. rewrite sqrt_neg_0 by lra. ring. Qed.

(** (2.14) and (2.17) through arctangents of roots: 2 arctan sqrt((1 - c)/(1 + c)) = arccos c, arcsin sqrt s = arctan sqrt(s/(1 - s)). *)
Lemma exceedance_partial_row (p load s : R) :
  s = / 2 * ((load + 1) - sqrt ((1 - load) * (1 - load) + p * p)) -> 0 <= s < 1 ->
  exceedance_partial p load = 2 / PI * atan (sqrt s / sqrt (1 - s)).
Proof.
  intros -> range. unfold exceedance_partial. fold (half_width (/ 2 * ((load + 1) - sqrt ((1 - load) * (1 - load) + p * p)))).
  rewrite half_width_by_arctangent by assumption. reflexivity.
Qed.

Lemma exceedance_full_row (p load : R) : -1 < p - load <= 1 ->
  exceedance_full p load = 2 / PI * atan (sqrt ((1 - (p - load)) / 2) / sqrt (1 - (1 - (p - load)) / 2)).
Proof.
  intro range. unfold exceedance_full.
  replace (p - load) with (1 - 2 * ((1 - (p - load)) / 2)) at 1 by field.
  rewrite <- doubled_half_width by lra. rewrite half_width_by_arctangent by lra. field. apply PI_neq0.
Qed.

Lemma f_full_row (x : R) : 1 < x -> f x = 1 + x.
Proof. intro. unfold f. destruct (Rlt_dec 1 x); [reflexivity | lra]. Qed.

Lemma f_partial_row (x : R) : x <= 1 -> f x = 2 * sqrt x.
Proof. intro. unfold f. destruct (Rlt_dec 1 x); [lra | reflexivity]. Qed.

Lemma x_P_partial_row (G : R) : 2 < G -> x_P G = 4 / (G * G).
Proof. intro. unfold x_P. destruct (Rlt_dec 2 G); [reflexivity | lra]. Qed.

Lemma x_P_full_row (G : R) : G <= 2 -> x_P G = 1 / (G - 1).
Proof. intro. unfold x_P. destruct (Rlt_dec 2 G); [lra | reflexivity]. Qed.
