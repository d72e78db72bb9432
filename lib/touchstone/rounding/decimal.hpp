// SPDX-License-Identifier: MIT
/// \file
/// From a ball to digits: a digit is shown only if every number in the ball rounds to it.
#pragma once

#include "touchstone/scalar/ball.hpp"

#include <optional>
#include <string>

namespace touchstone {

/// A decimal number of so many significant digits: +-0.d1d2d3... 10^exponent, or zero.
struct Decimal {
    bool negative = false; ///< the sign
    std::string digits;  ///< d1 is not '0'; empty for zero
    long exponent = 0; ///< of ten

    /// 10^-5 <= |value| < 10^width prints as a plain number, anything else as d.ddde+XX.
    /// Trailing zeros are kept: they are digits too.
    std::string text(long width) const;
    std::string text() const { return text(static_cast<long>(digits.size())); } ///< with all its digits
    /// Half a unit in the last digit, as text (`5e-31`): the bound of |this - true value|.
    std::string half_unit() const;
    Rational value() const; ///< exactly
    friend bool operator==(const Decimal&, const Decimal&) = default;
};

/// The common rounding to `digits` significant digits (to nearest) of all numbers in the
/// ball; nothing if they don't share one. Monotone rounding makes the two ends enough.
std::optional<Decimal> round_to_digits(const Ball&, long digits);

/// r rounded to `digits` significant digits, ties to even.
Decimal round_to_digits(const Rational& r, long digits);

/// The binary64 number to which all numbers in the ball round (to nearest even; gradual
/// underflow and overflow to infinity as IEEE 754 has them), if there is one.
std::optional<double> nearest_double(const Ball&);

/// The number itself when the ball is one short dyadic number, radius zero.
std::optional<Rational> exact_value(const Ball&);

/// C99 %a form, the same on every platform: 0x1.8p-3, 0x0p+0, the smallest subnormal as 0x0.0000000000001p-1022.
std::string hexfloat(double x);

/// The shortest decimal that reads back as x.
std::string shortest(double x);

} // namespace touchstone
