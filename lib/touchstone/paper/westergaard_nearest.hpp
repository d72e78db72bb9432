// SPDX-License-Identifier: MIT
/// \file
/// The formulas of westergaard.hpp at binary64 arguments, correctly rounded: in numbers of 106 bits with their error carried along, some
/// 0.3 microseconds a value. Each returns the binary64 number nearest to the true value where those bits prove it; nothing where they do
/// not, where the value may be a binary64 number itself (zero outside the support excepted), at an edge, and out of the domain: ask the
/// catalogue then.
#pragma once

#include <optional>

namespace touchstone::westergaard {

std::optional<double> nearest_half_width(double load); ///< (2.5)
std::optional<double> nearest_exceedance(double p, double load); ///< (2.11)-(2.18)
std::optional<double> nearest_density(double p, double load); ///< (2.15)-(2.20)

} // namespace touchstone::westergaard
