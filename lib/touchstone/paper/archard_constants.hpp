// SPDX-License-Identifier: MIT
/// \file
/// Certified K_n of (7.13) and K_inf of (7.20), for any n and to thousands of digits. The bare product needs 3.3 factors for each digit
/// of K_inf; this takes about sqrt(bits) of them and sums the rest in closed form. A second route, which shares neither series nor Gamma
/// functions with it: archard_interpolation.hpp.
///
/// Cost for d digits: about d^2.3 from 1000 to 10 000 digits, measured by tests/bench/archard_constants.cpp.
#pragma once

#include "touchstone/scalar/ball.hpp"

#include <vector>

namespace touchstone::archard {

/// n standing for the limit n -> infinity.
inline constexpr long infinity = -1;

/// K_n (n >= 0, or `infinity`) to about the working precision.
/// Route: m factors (7.13) with one Gamma function each, Gamma(3/2 - 2^-(i+2)), the other by the duplication formula, all of them
/// at once (gamma_product.hpp); the factors after them through the Taylor series of log Gamma at 3/2 and 2. The k-th coefficient of log
/// step in x = 2^-(i+2) is, for k >= 2, (zeta(k, 3/2) - zeta(k, 2))/k, an alternating sum below (2/3)^k/k, which bounds what is left out;
/// the first is -1. Riemann's zeta is for even k a Bernoulli number times pi^k, for odd k by Ramanujan's formula, whose sums shrink like
/// e^(-2 pi n).
Ball K_gamma_product(long n);

/// zeta(2), ..., zeta(last), the k-th to about 2^-(bits - k step).
std::vector<Ball> zeta_values(long last, slong bits, slong step);

} // namespace touchstone::archard
