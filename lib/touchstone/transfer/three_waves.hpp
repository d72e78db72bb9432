// SPDX-License-Identifier: MIT
/// \file
/// The density of pressure after three waves, full contact or not: q_2 (6.1) as one integral over the density after two waves.
///
///     D_2(x) = (T D_1)(x) = (1/pi) int D_1(y) dtheta,     D_1 as in two_waves.hpp, y = y(x, theta) as in proven_levels.hpp (T).
///
/// With t = sin(theta/2) the ratio y is analytic in t up to the end of the wave: G y = x + 1 - 2 t^2 where x >= 1, G y = 2 ((1 - t^2)(x -
/// t^2))^(1/2) where x < 1; where x >= 1 the lower half of the wave is seen from its other end, t = cos(theta/2), G y = x - 1 + 2 t^2. [0,
/// t_end] is halved until on each interval either D_1 is analytic on a disc about it (TwoWaves::on_disc), where Gauss-Legendre errs by at
/// most (64/15) M rho^(-2(N-1))/(1 - rho^-2), or what it holds, a logarithm or a jump of D_1 included, is negligible (TwoWaves::weight_on).
/// y is known to 250 bits at every node, so a node may be as near to a singular point as 2^-101 of t. No mesh and no interpolation:
/// proven_levels.md, 5.
///
/// Reach: G > 1 and load > 0 to 250 bits, P > 0; some 22 digits, those of 106 bits. Cost: about 3 s to 15 digits, growing with the digits'
/// square.
///
/// Internal to transfer/.
#pragma once

#include "touchstone/scalar/ball.hpp"

#include <string>

namespace touchstone::transfer {

struct ThreeWaves {
    Ball value; ///< q_2 p*_2 at p = P p*_2, with its proven error
    std::string certificate;
};

/// \param tolerance of the error, relative to P where P < 1; 1e-25 ... 1e-4
ThreeWaves density_after_three_waves(const Ball& G, const Ball& pressure, const Ball& load, double tolerance);

} // namespace touchstone::transfer
