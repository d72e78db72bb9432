// SPDX-License-Identifier: MIT
/// \file
/// Values rounded in a direction: a bound to compute with instead of the nearest number.
#pragma once

#include "touchstone/catalogue/evaluate.hpp"

namespace touchstone {
/// Where to round: to the nearest decimal (ties to even), towards +infinity, -infinity or 0, or away from 0.
enum class Rounding { nearest, up, down, zero, away };
std::optional<Rounding> rounding_named(std::string_view); ///< nothing for a name that is none of them
inline const std::vector<std::string>& rounding_names()
{
    static const std::vector<std::string> all{"nearest", "up", "down", "zero", "away"};
    return all;
}

/// r rounded to `digits` significant digits in that direction (nearest: ties to even).
Decimal round_to_digits(const Rational& r, long digits, Rounding);

/// evaluate(), with the value rounded in that direction: up is >= the true value, down <=, zero no larger in modulus, away no smaller.
/// The error bound is then one unit of the last digit. Found from a value to nearest with a few digits more, whose proven
/// error interval has to lie between two neighbouring decimals; more digits are asked for until it does.
/// binary64 stays the nearest one.
Evaluation evaluate(const Quantity&, const Inputs&, const EvaluationOptions&, Rounding);

} // namespace touchstone
