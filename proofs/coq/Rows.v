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

Definition density_full (p load : R) : R := / (PI * sqrt (1 - (p - load) * (p - load))).   (* (2.15), unit 1/p* *)
Definition density_partial (p load : R) : R :=                                       (* (2.19) as printed *)
  p / (PI * sqrt (((1 - load) * (1 - load) + p * p) * (2 * load * (1 - load + sqrt ((1 - load) * (1 - load) + p * p)) - p * p))).
Definition westergaard_density (p load : R) : R :=                                   (* (2.15), (2.16), (2.19), (2.20) *)
  if Rle_dec 1 load then (if Rlt_dec ((p - load) * (p - load)) 1 then density_full p load else 0)
  else (if Rlt_dec (p * p) (4 * load) then density_partial p load else 0).
Definition hertz_pressure (x load : R) : R := 2 * sqrt (load - PI * x * (PI * x)).   (* (2.6), (2.7): Coq's root is 0 outside *)

(** What surrounds one wave, as lib/touchstone/paper/gap.hpp derives it: the gap beyond the edge from v = |sin(pi x)|, of a parabola
    |pi x|. *)
Definition gap_from (v load : R) : R :=
  if Rlt_dec load (v * v) then 2 * (v * sqrt (v * v - load) - load * ln ((v + sqrt (v * v - load)) / sqrt load)) else 0.
Definition hertz_gap (x load : R) : R := gap_from (Rabs (PI * x)) load.
Definition westergaard_gap (x load : R) : R := gap_from (Rabs (sin (PI * x))) load.
Definition westergaard_mean_gap (load : R) : R := if Rlt_dec load 1 then 1 - load + load * ln load else 0.
Definition westergaard_energy (load : R) : R := if Rlt_dec load 1 then load * load * (1 - 2 * ln load) / 4 else 1 / 4.

Definition weierstrass_bound (D gamma : R) : R := / (1 - Rpower gamma (D - 2)).      (* (3.4), unit g0 *)
Definition archard_delta (n : Z) : R := 1 - / IZR (2 ^ (n + 1)).                     (* (7.16) *)
Definition archard_alpha (n : Z) (D : R) : R := (1 - D) * (IZR n - 1 + / IZR (2 ^ n)).
Definition peaks_iterate (n : nat) (load G : R) : R := iterate G load (S n).         (* (5.6), x_{-1} = load *)
Definition segments_max_half_width (n : nat) (load G : R) : R :=                     (* (6.6) at the highest peak, unit lambda_n *)
  half_width (Rmin (iterate G load n) 1) / PI.

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

Lemma density_full_row (p load : R) : 1 <= load -> (p - load) * (p - load) < 1 -> westergaard_density p load = density_full p load.
Proof.
  intros full inside. unfold westergaard_density. destruct (Rle_dec 1 load); [| lra].
  destruct (Rlt_dec ((p - load) * (p - load)) 1); [reflexivity | lra].
Qed.

Lemma density_partial_row (p load : R) : load < 1 -> p * p < 4 * load -> westergaard_density p load = density_partial p load.
Proof.
  intros partial inside. unfold westergaard_density. destruct (Rle_dec 1 load); [lra |].
  destruct (Rlt_dec (p * p) (4 * load)); [reflexivity | lra].
Qed.

Lemma density_above_row (p load : R) : 1 <= load -> 1 <= (p - load) * (p - load) -> westergaard_density p load = 0.
Proof.
  intros full outside. unfold westergaard_density. destruct (Rle_dec 1 load); [| lra].
  destruct (Rlt_dec ((p - load) * (p - load)) 1); [lra | reflexivity].
Qed.

Lemma density_outside_row (p load : R) : load < 1 -> 4 * load <= p * p -> westergaard_density p load = 0.
Proof.
  intros partial outside. unfold westergaard_density. destruct (Rle_dec 1 load); [lra |].
  destruct (Rlt_dec (p * p) (4 * load)); [lra | reflexivity].
Qed.

Lemma density_at_zero_row (load : R) : load < 1 -> westergaard_density 0 load = 0.
Proof.
  intro partial. unfold westergaard_density, density_partial. destruct (Rle_dec 1 load); [lra |].
  destruct (Rlt_dec (0 * 0) (4 * load)); [| reflexivity]. unfold Rdiv. ring.
Qed.

Lemma hertz_outside_row (x load : R) : load <= PI * x * (PI * x) -> hertz_pressure x load = 0.
Proof. intro outside. unfold hertz_pressure. rewrite sqrt_neg_0 by lra. ring. Qed.

Lemma gap_beyond_row (v load : R) : load < v * v ->
  gap_from v load = 2 * (v * sqrt (v * v - load) - load * ln ((v + sqrt (v * v - load)) / sqrt load)).
Proof. intro beyond. unfold gap_from. destruct (Rlt_dec load (v * v)); [reflexivity | lra]. Qed.

Lemma gap_within_row (v load : R) : v * v <= load -> gap_from v load = 0.
Proof. intro inside. unfold gap_from. destruct (Rlt_dec load (v * v)); [lra | reflexivity]. Qed.

Lemma mean_gap_partial_row (load : R) : load < 1 -> westergaard_mean_gap load = 1 - load + load * ln load.
Proof. intro. unfold westergaard_mean_gap. destruct (Rlt_dec load 1); [reflexivity | lra]. Qed.

Lemma mean_gap_full_row (load : R) : 1 <= load -> westergaard_mean_gap load = 0.
Proof. intro. unfold westergaard_mean_gap. destruct (Rlt_dec load 1); [lra | reflexivity]. Qed.

Lemma energy_partial_row (load : R) : load < 1 -> westergaard_energy load = load * load * (1 - 2 * ln load) / 4.
Proof. intro. unfold westergaard_energy. destruct (Rlt_dec load 1); [reflexivity | lra]. Qed.

Lemma energy_full_row (load : R) : 1 <= load -> westergaard_energy load = 1 / 4.
Proof. intro. unfold westergaard_energy. destruct (Rlt_dec load 1); [lra | reflexivity]. Qed.

Lemma max_half_width_partial_row (n : nat) (load G x : R) : iterate G load n = x -> 0 <= x < 1 ->
  segments_max_half_width n load G = atan (sqrt x / sqrt (1 - x)) / PI.
Proof.
  intros <- range. unfold segments_max_half_width. rewrite Rmin_left by lra. rewrite half_width_by_arctangent by assumption. reflexivity.
Qed.

Lemma max_half_width_full_row (n : nat) (load G x : R) : iterate G load n = x -> 1 <= x -> segments_max_half_width n load G = 1 / 2.
Proof.
  intros <- range. unfold segments_max_half_width, half_width.
  rewrite Rmin_right by assumption. rewrite sqrt_1, asin_1. field. apply PI_neq0.
Qed.

(** Chooses the branch of the innermost f in the goal; [prove] shows on which side of 1 its argument lies. *)
Ltac choose_branch prove :=
  match goal with
  | |- context [f ?x] => lazymatch x with
                         | context [f _] => fail
                         | _ => first [rewrite (f_partial_row x) by prove | rewrite (f_full_row x) by prove]
                         end
  end.
