// SPDX-License-Identifier: MIT
/// \file
/// K and E of real numbers in fixed point (internal to quadrature/).
#pragma once

#include "touchstone/quadrature/elliptic.hpp"

#include <optional>

namespace touchstone::quadrature {

/// K/pi and E/pi of m = 1 - v for v > 0 with a middle in [2^-32, 2^32] other than 1, at half of the cost of balls; E where it is asked
/// for. None of other v, nor where the means do not come near each other. (tanh_sinh.md, section 20, "K and E at real points")
std::optional<Elliptic<Ball>> by_fixed_means(const Ball& v, bool with_e);

} // namespace touchstone::quadrature
