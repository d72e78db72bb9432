// SPDX-License-Identifier: MIT
/// \file
/// The reciprocal Gamma function just below 1, where binary arithmetic has its Taylor series for nothing but sums.
#pragma once

#include "touchstone/scalar/ball.hpp"

#include <array>

namespace touchstone {

/// 1/Gamma(1 - 2^-e), e >= 2, to about the working precision.
/// Route: 1/Gamma(1 + x) = sum_k c_k x^k, whose powers of x = -2^-e are shifts, with the c_k of Arb's table; beyond its 3456 bits Arb's
/// Gamma function.
Ball reciprocal_gamma_below_one(slong e);

/// |c_k| < 2^(log_size - k log_radius) for all k, by Cauchy's estimate on |z| = 2^log_radius.
struct TaylorBound {
    slong log_radius, log_size;
};

/// With R = |z|: 1/Gamma(1 + z) = (z + 1) ... (z + R)/Gamma(1 + z + R). The factors are at most R + 1, ..., 2R; and u = Re(1 + z + R) >= 1,
/// where
/// |Gamma(u + iv)| >= Gamma(u)/sqrt(cosh(pi v)) (DLMF 5.6.7), cosh(pi v) <= e^(pi R) and Gamma(u) > 22/25. So |1/Gamma(1 + z)| is below
/// 25/22 e^(pi R/2) (2R)!/R!.
inline constexpr std::array<TaylorBound, 4> reciprocal_gamma_bounds{{{3, 48}, {4, 110}, {5, 252}, {6, 566}}};

/// sum_{k>=K} |c_k| 2^-ek is below 2^ of this, as each term of the bounds is at most half of the one before.
slong reciprocal_gamma_rest(slong e, slong K);

} // namespace touchstone
