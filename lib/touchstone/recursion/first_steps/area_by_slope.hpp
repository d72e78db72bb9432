// SPDX-License-Identifier: MIT
/// \file
/// The contact areas at scales 1 and 2, certified, for any G > 1 and load, as one integral over closed forms:
///
///     A_1/lambda_0 = int_0^load B_1'(y) dy,     A_2/lambda_0 = int E(y) B_1'(y) dy,
///
/// E(y) the share of lambda_0 with a ratio p_0/p*_1 above y (first_wave.hpp), B_1' how the area after two waves grows with the ratio that
/// they meet (area_slope.hpp). The second is A_2/lambda_0 = int -E'(y) B_1(y) dy by parts: B_1(0) = 0, E = 0 beyond the first wave.
///
/// **Evaluation** as in pieces.hpp, between 0, G^2/4, 1, G - 1, G + 1 and the ends of the first wave, with a logarithm at either end of
/// each piece. What is left out there is at most the largest E times the integral of a bound of B_1' (area_slope.hpp).
/// Reach: every load > 0 and G > 1, any digits. Cost: a fraction of a second for 15 digits, a few for 40; it grows with the square of the
/// digits, and with the logarithm of the distance of two singular points.
#pragma once

#include "touchstone/scalar/ball.hpp"
#include "touchstone/scalar/exact.hpp"

#include <functional>
#include <optional>

namespace touchstone::transfer {

struct FirstSteps {
    Rational load;                   ///< > 0
    std::function<Ball()> G;         ///< > 1, at the thread's precision, any precision
    std::optional<Exact> exact_G; ///< if it is the root of a rational: two singular points that coincide can be told then
};

/// A_n/lambda_0, n = 1 or 2, to about `goal` bits (some tens fewer than the thread's precision). \throws BeyondReach if two singular points
/// cannot be told from one another
Ball area_by_slope(long n, const FirstSteps&, slong goal);

} // namespace touchstone::transfer
