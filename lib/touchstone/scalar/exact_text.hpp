// SPDX-License-Identifier: MIT
/// \file
/// Exact numbers as they are typed.
#pragma once

#include "touchstone/scalar/exact.hpp"

#include <optional>
#include <string_view>

namespace touchstone {

/// Read what parse_rational() reads, and products, quotients, powers and square roots of it: `sqrt(10)`, `10^(1/2)`, `2^0.25`, `3/sqrt(2)`,
/// `-2^2` = -4, `2^3^2` = 2^9. Blanks are allowed between words.
/// \returns nothing if the text is no such expression, or one without a real value, or too long to be held exactly.
std::optional<Exact> parse_exact(std::string_view text);

/// A number as base^(1/degree), degree 1 if it is rational, else the least there is.
struct Root {
    Rational base; ///< what the root is taken of; any rational where degree is 1, else > 0
    unsigned long degree = 1; ///< >= 1
};
/// \throws NotExact where pi comes in, or for a negative irrational number
Root as_root(const Exact&);

} // namespace touchstone
