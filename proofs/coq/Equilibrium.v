(* SPDX-License-Identifier: GPL-3.0-or-later *)
(** * Equilibrium: one wave carries its mean, T id = id/G, for x < 1 and for x >= 1

    So the force is the same at every scale ((4.1), the sentence below (3.8)), and 1/G is an eigenvalue of T with eigenfunction id. *)

From Coq Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
Require Import Wave Operator.
Open Scope R_scope.

Lemma is_RInt_times (c : R) (g : R -> R) (a b value : R) : is_RInt g a b value -> is_RInt (fun u => c * g u) a b (c * value).
Proof. exact (is_RInt_scal (V := R_NormedModule) g a b c value). Qed.

Lemma cosine_square_integral : is_RInt (fun t => cos t * cos t) 0 (PI / 2) (PI / 4).
Proof.
  replace (PI / 4) with (minus ((PI / 2 + sin (PI / 2) * cos (PI / 2)) / 2) ((0 + sin 0 * cos 0) / 2)).
  2: { unfold minus, plus, opp; simpl. rewrite sin_0, cos_PI2. field. }
  apply (is_RInt_derive (V := R_CompleteNormedModule) (fun t => (t + sin t * cos t) / 2)).
  - intros t _. auto_derive; [exact I |]. pose proof (sin2_cos2 t) as one. unfold Rsqr in one.
    replace (sin t * sin t) with (1 - cos t * cos t) by lra. lra.
  - intros t _. apply (ex_derive_continuous (V := R_NormedModule)). auto_derive. exact I.
Qed.

Lemma continuous_half_disc (x u : R) : continuous (fun u => sqrt (x - u * u)) u.
Proof.
  apply (continuous_comp (fun u => x - u * u) sqrt); [| apply continuous_sqrt].
  apply (ex_derive_continuous (V := R_NormedModule)). auto_derive. exact I.
Qed.

(** The integral of the half disc of radius r = sqrt x, by u = r sin t. *)
Lemma half_disc_integral (x : R) : 0 <= x -> is_RInt (fun u => sqrt (x - u * u)) 0 (sqrt x) (x * (PI / 4)).
Proof.
  intro positive. pose proof (sqrt_sqrt x positive) as square. pose proof (sqrt_pos x) as root. pose proof PI_RGT_0.
  assert (substituted : is_RInt (fun t => scal (sqrt x * cos t) (sqrt (x - (sqrt x * sin t) * (sqrt x * sin t)))) 0 (PI / 2)
                          (RInt (fun u => sqrt (x - u * u)) (sqrt x * sin 0) (sqrt x * sin (PI / 2)))).
  { apply (is_RInt_comp (V := R_CompleteNormedModule) (fun u => sqrt (x - u * u)) (fun t => sqrt x * sin t) (fun t => sqrt x * cos t)).
    - intros t _. apply continuous_half_disc.
    - intros t _. split; [auto_derive; [exact I | ring] |].
      apply (ex_derive_continuous (V := R_NormedModule)). auto_derive. exact I. }
  rewrite sin_0, sin_PI2, Rmult_0_r, Rmult_1_r in substituted.
  assert (value : is_RInt (fun t => scal (sqrt x * cos t) (sqrt (x - (sqrt x * sin t) * (sqrt x * sin t)))) 0 (PI / 2) (x * (PI / 4))).
  { apply (is_RInt_ext (V := R_NormedModule) (fun t => scal x (cos t * cos t))).
    - intros t range. rewrite Rmin_left, Rmax_right in range by lra.
      assert (0 <= cos t) by (apply cos_ge_0; lra). pose proof (sin2_cos2 t) as one. unfold Rsqr in one.
      unfold scal; simpl; unfold mult; simpl.
      replace (x - sqrt x * sin t * (sqrt x * sin t)) with ((sqrt x * cos t) * (sqrt x * cos t)).
      + rewrite sqrt_square by nra.
        transitivity ((sqrt x * sqrt x) * (cos t * cos t)); [rewrite square |]; ring.
      + transitivity ((sqrt x * sqrt x) * (cos t * cos t)); [ring |].
        transitivity (x - (sqrt x * sqrt x) * (sin t * sin t)); [rewrite square |]; nra.
    - apply (is_RInt_times x). apply cosine_square_integral. }
  pose proof (is_RInt_unique (V := R_CompleteNormedModule) _ _ _ _ substituted) as first.
  pose proof (is_RInt_unique (V := R_CompleteNormedModule) _ _ _ _ value) as second.
  rewrite first in second. rewrite <- second. apply (RInt_correct (V := R_CompleteNormedModule)).
  apply (ex_RInt_continuous (V := R_CompleteNormedModule)). intros u _. apply continuous_half_disc.
Qed.

(** The semicircle law: (4/pi) int_0^1 sqrt(1 - u^2) du = 1. *)
Theorem semicircle : is_RInt (fun u => 4 / PI * sqrt (1 - u * u)) 0 1 1.
Proof.
  pose proof (half_disc_integral 1 ltac:(lra)) as disc. rewrite sqrt_1 in disc.
  pose proof (is_RInt_times (4 / PI) _ _ _ _ disc) as scaled.
  replace (4 / PI * (1 * (PI / 4))) with 1 in scaled by (field; apply PI_neq0).
  exact scaled.
Qed.

(** The mean pressure over a wave is its load, in full contact ... *)
Lemma mean_in_full_contact (x : R) : 1 <= x -> is_RInt (pressure x) 0 (PI / 2) (PI / 2 * x).
Proof.
  intro full. apply (is_RInt_ext (V := R_NormedModule) (fun t => x + cos (2 * t))).
  - intros t _. unfold pressure. destruct (Rle_dec 1 x); [reflexivity | lra].
  - replace (PI / 2 * x) with (minus (x * (PI / 2) + sin (2 * (PI / 2)) / 2) (x * 0 + sin (2 * 0) / 2)).
    2: { unfold minus, plus, opp; simpl. replace (2 * (PI / 2)) with PI by field. replace (2 * 0) with 0 by ring. rewrite sin_PI, sin_0. field. }
    apply (is_RInt_derive (V := R_CompleteNormedModule) (fun t => x * t + sin (2 * t) / 2)).
    + intros t _. auto_derive; [exact I | field].
    + intros t _. apply (ex_derive_continuous (V := R_NormedModule)). auto_derive. exact I.
Qed.

(** ... and in partial contact, by u = sin xi. *)
Lemma mean_in_partial_contact (x : R) : 0 <= x < 1 -> is_RInt (pressure x) 0 (PI / 2) (PI / 2 * x).
Proof.
  intros [positive partial]. pose proof PI_RGT_0.
  assert (root : 0 <= sqrt x <= 1) by (apply sqrt_in_unit; lra).
  assert (rest : is_RInt (fun u => sqrt (x - u * u)) (sqrt x) 1 0).
  { apply (is_RInt_ext (V := R_NormedModule) (fun _ => 0)).
    - intros u range. rewrite Rmin_left, Rmax_right in range by lra.
      rewrite sqrt_neg_0; [reflexivity |]. pose proof (sqrt_sqrt x positive). nra.
    - pose proof (is_RInt_const (V := R_NormedModule) (sqrt x) 1 0) as nothing.
      unfold scal in nothing; simpl in nothing; unfold mult in nothing; simpl in nothing. rewrite Rmult_0_r in nothing. exact nothing. }
  pose proof (is_RInt_Chasles (V := R_NormedModule) _ _ _ _ _ _ (half_disc_integral x positive) rest) as whole.
  assert (substituted : is_RInt (fun t => scal (cos t) (2 * sqrt (x - sin t * sin t))) 0 (PI / 2)
                          (RInt (fun u => 2 * sqrt (x - u * u)) (sin 0) (sin (PI / 2)))).
  { apply (is_RInt_comp (V := R_CompleteNormedModule) (fun u => 2 * sqrt (x - u * u)) sin cos).
    - intros t _. apply (continuous_mult (K := R_AbsRing)); [apply continuous_const | apply continuous_half_disc].
    - intros t _. split; [auto_derive; [exact I | ring] |].
      apply (ex_derive_continuous (V := R_NormedModule)). auto_derive. exact I. }
  rewrite sin_0, sin_PI2 in substituted.
  assert (value : RInt (fun u => 2 * sqrt (x - u * u)) 0 1 = PI / 2 * x).
  { apply is_RInt_unique.
    replace (PI / 2 * x) with (2 * (x * (PI / 4) + 0)) by field.
    apply is_RInt_times. exact whole. }
  rewrite value in substituted.
  apply (is_RInt_ext (V := R_NormedModule) (fun t => scal (cos t) (2 * sqrt (x - sin t * sin t)))); [| exact substituted].
  intros t _. unfold pressure. destruct (Rle_dec 1 x); [lra |]. unfold scal; simpl; unfold mult; simpl. ring.
Qed.

Theorem equilibrium (G x : R) : 1 < G -> 0 <= x -> T G (fun y => y) x = x / G.
Proof.
  intros G_large positive. unfold T.
  assert (mean : is_RInt (pressure x) 0 (PI / 2) (PI / 2 * x)).
  { destruct (Rle_lt_dec 1 x); [apply mean_in_full_contact; assumption | apply mean_in_partial_contact; lra]. }
  replace (RInt (fun xi => pressure x xi / G) 0 (PI / 2)) with (PI / 2 * (x / G)).
  - apply whole_wave.
  - symmetry. apply is_RInt_unique.
    apply (is_RInt_ext (V := R_NormedModule) (fun xi => scal (/ G) (pressure x xi))).
    + intros xi _. unfold scal; simpl; unfold mult; simpl. field. lra.
    + replace (PI / 2 * (x / G)) with (/ G * (PI / 2 * x)) by (field; lra).
      apply is_RInt_times. exact mean.
Qed.
