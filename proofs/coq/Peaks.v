(* SPDX-License-Identifier: GPL-3.0-or-later *)
(** * Section 5: the iteration (5.6) of the peak pressures tends to x_P of (5.8), (5.9)

    f(x) = 1 + x for x > 1 (5.4) and 2 sqrt x for 0 < x <= 1 (5.5); x_n = f(x_(n-1))/G (5.6), with G = gamma^(D-1) > 1 and any start
    x_0 > 0. The proof uses nothing of f but that it increases and lies under a tangent at each of its points. *)

From Coq Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
Open Scope R_scope.

Definition f (x : R) : R := if Rlt_dec 1 x then 1 + x else 2 * sqrt x.

Fixpoint iterate (G x0 : R) (n : nat) : R :=
  match n with
  | O => x0
  | S k => f (iterate G x0 k) / G
  end.

Definition x_P (G : R) : R := if Rlt_dec 2 G then 4 / (G * G) else 1 / (G - 1).

(** The slope of f, both one-sided slopes at 1 being 1. *)
Definition slope (u : R) : R := if Rlt_dec 1 u then 1 else / sqrt u.

Lemma sqrt_below_tangent (u x : R) : 0 < u -> 0 < x -> 2 * sqrt x <= 2 * sqrt u + / sqrt u * (x - u).
Proof.
  intros u_positive x_positive.
  pose proof (sqrt_lt_R0 u u_positive) as root_positive.
  pose proof (sqrt_sqrt u (Rlt_le _ _ u_positive)) as u_square.
  pose proof (sqrt_sqrt x (Rlt_le _ _ x_positive)) as x_square.
  apply Rmult_le_reg_l with (sqrt u); [exact root_positive |].
  replace (sqrt u * (2 * sqrt u + / sqrt u * (x - u))) with (2 * (sqrt u * sqrt u) + (x - u)) by (field; lra).
  pose proof (Rle_0_sqr (sqrt u - sqrt x)) as square. unfold Rsqr in square. nra.
Qed.

Lemma two_sqrt_below_line (x : R) : 0 < x -> 2 * sqrt x <= 1 + x.
Proof.
  intro x_positive. pose proof (sqrt_below_tangent 1 x Rlt_0_1 x_positive) as bound.
  rewrite sqrt_1, Rinv_1 in bound. lra.
Qed.

Lemma line_below_tangent (u x : R) : 0 < u <= 1 -> 1 < x -> 1 + x <= 2 * sqrt u + / sqrt u * (x - u).
Proof.
  intros [u_positive u_small] x_large.
  pose proof (sqrt_lt_R0 u u_positive) as root_positive.
  pose proof (sqrt_sqrt u (Rlt_le _ _ u_positive)) as u_square.
  apply Rmult_le_reg_l with (sqrt u); [exact root_positive |].
  replace (sqrt u * (2 * sqrt u + / sqrt u * (x - u))) with (2 * (sqrt u * sqrt u) + (x - u)) by (field; lra).
  assert (sqrt u <= 1) by (rewrite <- sqrt_1; apply sqrt_le_1; lra).
  nra.
Qed.

Theorem f_below_tangent (u x : R) : 0 < u -> 0 < x -> f x <= f u + slope u * (x - u).
Proof.
  intros u_positive x_positive. unfold f, slope.
  destruct (Rlt_dec 1 x) as [x_large | x_small]; destruct (Rlt_dec 1 u) as [u_large | u_small]; try lra.
  - apply line_below_tangent; lra.
  - pose proof (two_sqrt_below_line x x_positive). lra.
  - apply sqrt_below_tangent; assumption.
Qed.

Lemma slope_positive (u : R) : 0 < u -> 0 < slope u.
Proof.
  intro u_positive. unfold slope. destruct (Rlt_dec 1 u); [lra |].
  apply Rinv_0_lt_compat, sqrt_lt_R0, u_positive.
Qed.

Lemma f_positive (x : R) : 0 < x -> 0 < f x.
Proof.
  intro x_positive. unfold f. destruct (Rlt_dec 1 x); [lra |].
  pose proof (sqrt_lt_R0 x x_positive). lra.
Qed.

(** f increases: the tangent at the larger point lies over f at the smaller one and rises. *)
Lemma f_increases (x y : R) : 0 < x -> x <= y -> f x <= f y.
Proof.
  intros x_positive order.
  pose proof (f_below_tangent y x ltac:(lra) x_positive) as bound.
  pose proof (slope_positive y ltac:(lra)). nra.
Qed.

(** Concavity, as it follows from the tangent at the middle point. *)
Lemma f_concave (a x b : R) : 0 < a -> a <= x <= b -> (b - x) * f a + (x - a) * f b <= (b - a) * f x.
Proof.
  intros a_positive [left right].
  pose proof (f_below_tangent x a ltac:(lra) a_positive).
  pose proof (f_below_tangent x b ltac:(lra) ltac:(lra)).
  nra.
Qed.

(** ** The fixed point *)

Lemma x_P_positive (G : R) : 1 < G -> 0 < x_P G.
Proof.
  intro G_large. unfold x_P. destruct (Rlt_dec 2 G).
  - apply Rdiv_lt_0_compat; nra.
  - apply Rdiv_lt_0_compat; lra.
Qed.

Lemma sqrt_of_square_quotient (G : R) : 0 < G -> sqrt (4 / (G * G)) = 2 / G.
Proof.
  intro G_positive. replace (4 / (G * G)) with ((2 / G) * (2 / G)) by (field; lra).
  apply sqrt_square. apply Rlt_le, Rdiv_lt_0_compat; lra.
Qed.

Lemma partial_below_one (G : R) : 2 < G -> 4 / (G * G) < 1.
Proof. intro. apply Rlt_div_l; nra. Qed.

Lemma full_above_one (G : R) : 1 < G < 2 -> 1 < 1 / (G - 1).
Proof. intro. apply Rlt_div_r; lra. Qed.

(** (5.7) x_P = f(x_P)/G, from (5.8) for G > 2 and (5.9) for G <= 2, where both agree. *)
Theorem x_P_is_fixed (G : R) : 1 < G -> f (x_P G) = G * x_P G.
Proof.
  intro G_large. unfold x_P. destruct (Rlt_dec 2 G) as [partial | full].
  - pose proof (partial_below_one G partial) as below.
    unfold f. destruct (Rlt_dec 1 (4 / (G * G))); [lra |].
    rewrite sqrt_of_square_quotient by lra. field. lra.
  - unfold f. destruct (Rlt_dec 1 (1 / (G - 1))) as [above | not_above].
    + field. lra.
    + assert (G = 2) as -> by (destruct (Req_dec G 2); [assumption | pose proof (full_above_one G); lra]).
      replace (1 / (2 - 1)) with 1 by field. rewrite sqrt_1. lra.
Qed.

Lemma slope_at_x_P (G : R) : 1 < G -> slope (x_P G) < G.
Proof.
  intro G_large. unfold x_P. destruct (Rlt_dec 2 G) as [partial | full].
  - pose proof (partial_below_one G partial) as below.
    unfold slope. destruct (Rlt_dec 1 (4 / (G * G))); [lra |].
    rewrite sqrt_of_square_quotient by lra.
    replace (/ (2 / G)) with (G / 2) by (field; lra). lra.
  - unfold slope. destruct (Rlt_dec 1 (1 / (G - 1))) as [above | not_above]; [lra |].
    assert (G = 2) as -> by (destruct (Req_dec G 2); [assumption | pose proof (full_above_one G); lra]).
    replace (1 / (2 - 1)) with 1 by field. rewrite sqrt_1. lra.
Qed.

(** Between 0 and x_P the iteration rises: G x < f(x). *)
Lemma f_above_line (G x : R) : 1 < G -> 0 < x < x_P G -> G * x < f x.
Proof.
  intros G_large [x_positive x_below].
  pose proof (x_P_positive G G_large) as positive.
  pose proof (x_P_is_fixed G G_large) as fixed.
  pose proof (f_below_tangent x (x_P G) x_positive positive) as tangent_at_x.
  pose proof (f_below_tangent (x_P G) x positive x_positive) as tangent_at_P.
  pose proof (slope_at_x_P G G_large) as gentle.
  unfold f in *. destruct (Rlt_dec 1 x) as [x_large | x_small].
  - destruct (Rlt_dec 1 (x_P G)); [| lra]. nra.
  - pose proof (sqrt_lt_R0 x x_positive) as root_positive.
    pose proof (sqrt_sqrt x (Rlt_le _ _ x_positive)) as square.
    destruct (Rlt_dec 1 (x_P G)) as [P_large | P_small].
    + (* G = 1 + 1/x_P < 2 and sqrt x <= 1 *)
      assert (sqrt x <= 1) by (rewrite <- sqrt_1; apply sqrt_le_1; lra).
      assert (G < 2) by nra. nra.
    + (* sqrt x < sqrt x_P = 2/G *)
      pose proof (sqrt_lt_R0 (x_P G) positive) as P_root.
      pose proof (sqrt_sqrt (x_P G) (Rlt_le _ _ positive)) as P_square.
      assert (sqrt x < sqrt (x_P G)) by (apply sqrt_lt_1; lra).
      assert (G * sqrt (x_P G) = 2) by nra. nra.
Qed.

(** ** Convergence, with its rate *)

Lemma iterate_positive (G x0 : R) (n : nat) : 1 < G -> 0 < x0 -> 0 < iterate G x0 n.
Proof.
  intros G_large start. induction n as [| n IH]; [exact start |].
  simpl. apply Rdiv_lt_0_compat; [apply f_positive, IH | lra].
Qed.

(** From above: each step leaves at most slope(x_P)/G < 1 of the distance, and never crosses x_P. *)
Lemma step_from_above (G x : R) : 1 < G -> x_P G <= x -> 0 <= f x / G - x_P G <= slope (x_P G) / G * (x - x_P G).
Proof.
  intros G_large above.
  pose proof (x_P_positive G G_large) as positive.
  pose proof (x_P_is_fixed G G_large) as fixed.
  pose proof (f_below_tangent (x_P G) x positive ltac:(lra)) as bound.
  pose proof (f_increases (x_P G) x positive above) as monotone.
  assert (scaled : f x / G - x_P G = (f x - f (x_P G)) / G) by (rewrite fixed; field; lra).
  rewrite scaled. split.
  - apply Rmult_le_pos; [lra | apply Rlt_le, Rinv_0_lt_compat; lra].
  - replace (slope (x_P G) / G * (x - x_P G)) with ((slope (x_P G) * (x - x_P G)) / G) by (field; lra).
    apply Rmult_le_compat_r; [apply Rlt_le, Rinv_0_lt_compat; lra | lra].
Qed.

(** From below, started at a < x_P: each step leaves at most (x_P - f(a)/G)/(x_P - a) < 1 of the distance, and never crosses x_P. *)
Lemma step_from_below (G a x : R) : 1 < G -> 0 < a < x_P G -> a <= x <= x_P G ->
  a <= f x / G <= x_P G /\ x_P G - f x / G <= (x_P G - f a / G) / (x_P G - a) * (x_P G - x).
Proof.
  intros G_large [a_positive a_below] [x_above x_below].
  pose proof (x_P_positive G G_large) as positive.
  pose proof (x_P_is_fixed G G_large) as fixed.
  pose proof (f_above_line G a G_large (conj a_positive a_below)) as rises.
  pose proof (f_increases a x a_positive x_above) as monotone.
  pose proof (f_increases x (x_P G) ltac:(lra) x_below) as under.
  pose proof (f_concave a x (x_P G) a_positive (conj x_above x_below)) as concave.
  assert (G_inverse : 0 < / G) by (apply Rinv_0_lt_compat; lra).
  split; [split |].
  - apply Rmult_le_reg_l with G; [lra |]. unfold Rdiv. replace (G * (f x * / G)) with (f x) by (field; lra). lra.
  - apply Rmult_le_reg_l with G; [lra |]. unfold Rdiv. replace (G * (f x * / G)) with (f x) by (field; lra). lra.
  - apply Rmult_le_reg_l with (G * (x_P G - a)); [apply Rmult_lt_0_compat; lra |].
    replace (G * (x_P G - a) * (x_P G - f x / G)) with ((x_P G - a) * (G * x_P G - f x)) by (field; lra).
    replace (G * (x_P G - a) * ((x_P G - f a / G) / (x_P G - a) * (x_P G - x))) with ((G * x_P G - f a) * (x_P G - x)) by (field; lra).
    rewrite fixed in concave. nra.
Qed.

Lemma geometric_squeeze (u : nat -> R) (limit q c : R) :
  0 <= q < 1 -> (forall n, Rabs (u n - limit) <= c * q ^ n) -> is_lim_seq u limit.
Proof.
  intros [q_positive q_small] bound.
  apply is_lim_seq_ext with (fun n => limit + (u n - limit)); [intro; ring |].
  replace (Finite limit) with (Rbar_plus limit 0) by (simpl; f_equal; ring).
  apply is_lim_seq_plus'; [apply is_lim_seq_const |].
  apply is_lim_seq_abs_0.
  apply is_lim_seq_le_le with (fun _ => 0) (fun n => c * q ^ n).
  - intro n. split; [apply Rabs_pos | apply bound].
  - apply is_lim_seq_const.
  - replace (Finite 0) with (Rbar_mult c 0) by (simpl; f_equal; ring).
    apply is_lim_seq_scal_l. apply is_lim_seq_geom. rewrite Rabs_pos_eq; lra.
Qed.

(** The iteration (5.6) tends to x_P of (5.8), (5.9) for every G > 1 and every positive start. *)
Theorem iteration_converges (G x0 : R) : 1 < G -> 0 < x0 -> is_lim_seq (iterate G x0) (x_P G).
Proof.
  intros G_large start.
  destruct (Rle_lt_dec (x_P G) x0) as [above | below].
  - apply geometric_squeeze with (slope (x_P G) / G) (x0 - x_P G).
    + pose proof (slope_at_x_P G G_large). pose proof (slope_positive (x_P G) (x_P_positive G G_large)).
      split; [apply Rlt_le, Rdiv_lt_0_compat; lra |].
      apply Rmult_lt_reg_r with G; [lra |]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l; lra.
    + assert (stays : forall n, 0 <= iterate G x0 n - x_P G <= (x0 - x_P G) * (slope (x_P G) / G) ^ n).
      { induction n as [| n IH]; [simpl; lra |].
        pose proof (step_from_above G (iterate G x0 n) G_large ltac:(lra)) as step.
        pose proof (slope_positive (x_P G) (x_P_positive G G_large)) as slope_pos.
        assert (factor : 0 <= slope (x_P G) / G) by (apply Rlt_le, Rdiv_lt_0_compat; lra).
        simpl iterate. simpl pow. split; [lra |].
        apply Rle_trans with (slope (x_P G) / G * (iterate G x0 n - x_P G)); [lra |].
        replace ((x0 - x_P G) * (slope (x_P G) / G * (slope (x_P G) / G) ^ n))
          with (slope (x_P G) / G * ((x0 - x_P G) * (slope (x_P G) / G) ^ n)) by ring.
        apply Rmult_le_compat_l; [exact factor | lra]. }
      intro n. rewrite Rabs_pos_eq; apply stays.
  - set (q := (x_P G - f x0 / G) / (x_P G - x0)).
    assert (q_range : 0 <= q < 1).
    { pose proof (step_from_below G x0 x0 G_large (conj start below) ltac:(lra)) as [[_ under] _].
      pose proof (f_above_line G x0 G_large (conj start below)) as rises.
      assert (x0 < f x0 / G).
      { apply Rmult_lt_reg_l with G; [lra |]. unfold Rdiv. replace (G * (f x0 * / G)) with (f x0) by (field; lra). lra. }
      unfold q. split.
      - apply Rmult_le_pos; [lra | apply Rlt_le, Rinv_0_lt_compat; lra].
      - apply Rmult_lt_reg_r with (x_P G - x0); [lra |]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l; lra. }
    apply geometric_squeeze with q (x_P G - x0); [exact q_range |].
    assert (stays : forall n, x0 <= iterate G x0 n <= x_P G /\ x_P G - iterate G x0 n <= (x_P G - x0) * q ^ n).
    { induction n as [| n [range distance]]; [simpl; lra |].
      destruct (step_from_below G x0 (iterate G x0 n) G_large (conj start below) range) as [next step].
      simpl iterate. simpl pow. split; [exact next |].
      fold q in step. apply Rle_trans with (q * (x_P G - iterate G x0 n)); [exact step |].
      replace ((x_P G - x0) * (q * q ^ n)) with (q * ((x_P G - x0) * q ^ n)) by ring.
      apply Rmult_le_compat_l; lra. }
    intro n. destruct (stays n) as [range distance]. rewrite Rabs_left1; lra.
Qed.

(** x_P is the only positive solution of (5.7): started there, the iteration stays, and it tends to x_P. *)
Theorem x_P_is_unique (G x : R) : 1 < G -> 0 < x -> f x = G * x -> x = x_P G.
Proof.
  intros G_large positive solves.
  assert (constant : forall n, iterate G x n = x).
  { induction n as [| n IH]; [reflexivity |]. simpl. rewrite IH, solves. field. lra. }
  pose proof (iteration_converges G x G_large positive) as limit.
  apply (is_lim_seq_ext _ (fun _ => x)) in limit; [| exact constant].
  apply is_lim_seq_unique in limit. rewrite Lim_seq_const in limit.
  now injection limit.
Qed.

