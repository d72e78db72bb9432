// SPDX-License-Identifier: MIT
/// \file
/// How far a row of the discretised operator is off, for a level with |F_m| <= c_m, divided by c_m: the parts are told in
/// discretisation.hpp. All bounds are exact balls. Internal to transfer/.
#pragma once

#include "touchstone/transfer/rule.hpp"

#include <cstddef>

namespace touchstone::transfer {

/// How the error bound of one value is made up; each part bounds |error of F|.
struct Budget {
    Ball rule, truncation, interpolation, abscissae, weights, entries;
    Ball total() const { return rule + truncation + interpolation + abscissae + weights + entries; }
};

/// What a row's rule adds up to. Weights are positive and rounded down: `total` is at least the sum of those taken, too.
struct RowSums {
    Ball total;                   ///< sum_q W
    Ball tau_error, weight_error; ///< sum_q W dtau_q, and the largest of dW_q
    long terms = 0;
};

/// What levels are kept by, in fixed-point numbers: values at `nodes` Chebyshev points in blocks, and the coefficients of the polynomials
/// through them.
struct Resolution {
    long points; ///< p, of each block
    double rho;  ///< the ellipse of each block that is proven inside Re s > 0
    std::size_t nodes;
    Ball unit, scale; ///< u, and what F is divided by: a power of two, 2 c_m at most for the limit of c_m

    /// Coefficients of the interpolant of what is at most 1 on the ellipses are below this times rho^-k, aliases and all:
    /// 2 (1 + 2/(rho^2 - 1)).
    Ball coefficient_bound() const;
    /// Coefficients as computed of a level with |values| <= 2 c_m are off by less than this times c_m: Coefficients::of, in
    /// units of scale u.
    Ball coefficient_error() const;
    /// A moment of order k is off by less than this times rho^k: 4 u p^2 a term. 3 u k^2 a term would do (moments.hpp); in a row's
    /// entries the rest, at least 8 u c_m for the limit of c_m, covers the rounding of a nodal value by less than 2 scale u.
    Ball moment_error(long terms) const;
    Budget budget(const RowSums&, const Rule&, const Ball& x) const;
    /// The same for what a row loses when it is multiplied by a weight, known to `radius` and rounded: each moment is off by (radius + u)
    /// of itself, as computed, and by a unit.
    Ball weighting(const RowSums&, const Ball& radius) const;
};

} // namespace touchstone::transfer
