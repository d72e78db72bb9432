// SPDX-License-Identifier: MIT
/// \file
/// From which scale on the fractal limit holds, and the ratio at which it is approached: docs/limit.md.
#pragma once

#include "touchstone/limit/area_constant.hpp"

namespace touchstone::limit {

/// The least n >= 0 with |A_m G^m/(C load) - 1| <= tolerance for every m >= n; G > 2, load <= 1. Above the scale that theorem 2 gives
/// nothing needs to be looked at, below it the certified areas decide.
/// \throws BeyondReach where they cannot (a tolerance that is met exactly, or too small)
long least_scale(transfer::Scheme, const std::function<Ball()>& G, const std::function<Ball()>& load, const Rational& tolerance);

/// The second eigenvalue of T over its first, 1/G, for G > 2: the limit of (h_{n+1} - h_n)/(h_n - h_{n-1}), seen at a scale n where it has
/// settled. An estimate, that looks again at second_eigenvalue.hpp and shares the wave with it and nothing else.
Witness gap(transfer::Scheme, const std::function<Ball()>& G, const Rational& load);

} // namespace touchstone::limit
