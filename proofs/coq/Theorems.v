(* SPDX-License-Identifier: GPL-3.0-or-later *)
(** * What is proved, and on which axioms: those of Coq's real numbers, and no other *)

Require Import Wave Peaks Operator Areas Equilibrium Archard Numbers Conditions Forms.

Print Assumptions iteration_converges.
Print Assumptions x_P_is_unique.
Print Assumptions x_P_is_fixed.
Print Assumptions doubled_half_width.
Print Assumptions pressure_as_printed.
Print Assumptions semicircle.
Print Assumptions equilibrium.
Print Assumptions T_positive.
Print Assumptions error_under_T.
Print Assumptions errors_only_add.
Print Assumptions relative_errors_add.
Print Assumptions area_increases_with_load.
Print Assumptions area_of_one_wave.
Print Assumptions contact_of_one_wave.
Print Assumptions phi_log_convex.
Print Assumptions log_integral.
Print Assumptions K_inf_lower.
Print Assumptions K_inf_upper.
Print Assumptions K_inf_to_eight_places.
Print Assumptions table_1.
Print Assumptions arctangent_condition.
Print Assumptions expm1_condition.
Print Assumptions sine_condition.
Print Assumptions sine_condition_steep.
Print Assumptions sine_condition_absolute.
Print Assumptions arcsine_condition.
Print Assumptions half_width_in_binary64.
