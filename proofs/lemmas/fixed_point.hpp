// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The iteration x -> f(x)/G of (5.6), for all G > 1 at once.
#pragma once

#include "proofs/ledger.hpp"

namespace touchstone::proofs {

/// Theorem: let f(x) = above(x) for x >= 1, below(x) for 0 < x <= 1. For every G > 1 the map
/// h(x) = f(x)/G has exactly one positive fixed point x_P, and from every positive start x, x' the
/// iterates approach it monotonically: h(x) lies strictly between x and x_P.
/// A bounded monotone sequence converges, by continuity of h to a fixed point, so to x_P.
///
/// Proof in two cases, each inequality an identity with a quotient of polynomials with positive coefficients:
///   G >= 2, x_P = 4/G^2 <= 1.  x <= 1: h(x) = sqrt(x x_P), the geometric mean.
///                              x > 1:  x_P <= h(1) < h(x) <= (1 + x)/2 < x.
///   G < 2,  x_P = 1/(G-1) > 1. x >= 1: h(x) - x_P = (x - x_P)/G.
///                              x < 1:  x < sqrt(x) < h(x) < h(1) = 2/G < x_P.
/// above and below are the printed branches (5.4), (5.5), in the symbol x.
Check unique_fixed_point(const ex& above, const ex& below);

} // namespace touchstone::proofs
