// SPDX-License-Identifier: MIT
/// \file
/// What the levels of a law hold far from the edge, and where they are cut off for small pressures. Internal to from_the_edge/.
#pragma once

#include "touchstone/recursion/from_the_edge/boxes.hpp"

namespace touchstone::transfer::from_the_edge {

/// T_{k+1} from T_k; see forward.hpp. Force density f_k <= T_k e^(-5 delta/2) for delta >= 4; so also T_k e^(2-3 delta), with
/// (delta+1.2)/5.2 more at k = 2.
///
/// f_{k+1}(d) = int_0^2d f_k(delta) e^(-3D/2) K dD-part, K <= k2 (1 - e^-D)^(-1/2), k2 = (4/pi)(1-e_k)^(-3/2) since R, M/2 >= 1 - x and
/// (1+x+R)/(1-x+R) falls with R. Let d >= 4. The part delta < 4 (total force 1) gives at most 1.01 k2 e^(-3d+6); the part delta >= 4
/// T_k k2 e^(-3d) int e^-delta (1-e^-D)^(-1/2) ddelta <= 4.1 T_k k2 e^(-3d-4): D >= 1 weighs at most 1.26 e^-4, D < 1 at most 2.83 e^-4.
/// First, f_1 <= (8/pi) a e^(-3 delta/2) (1 - e^(-2 delta))^(-1/2), a = min((2 load^(1/2))^(-3/2), (1-load)^(-3/2)), from R >= 2 load^(1/2)
/// e^-delta, R >= 1 - load and (1+x+R)/(1-x+R) <= (R+2)/R <= 4/R; so f_2(d) <= (8a/pi) k2 e^(-3d) 2.02 (d + 1.2).
double next_tail(long k, const Ball& edge_bound, double tail, double load);

/// Where E_n is cut off for small p, so that what is left out, relative to q_n, and what the cut makes of the levels' errors, e^(cut/2),
/// both come to about e^-a where levels have the accuracy a + cut/2.
double cut_for_small(double accuracy, long n, const Ball& G, const Ball& load);

/// Whether p is small for levels of this accuracy, and more: they are cut off more than 1 before 2 d.
bool small_for(double accuracy, long n, double d, const Ball& G, const Ball& load);

/// The accuracy of levels for q_n to e^-accuracy by the form for small p, or 0 where p is not small.
double accuracy_for_small(double accuracy, long n, double d, const Ball& G, const Ball& load);

} // namespace touchstone::transfer::from_the_edge
