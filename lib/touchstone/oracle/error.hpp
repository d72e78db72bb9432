// SPDX-License-Identifier: MIT
/// \file
/// How wrong a binary64 answer is, as an interval that certainly holds the truth, and how much of it the
/// rounding of the inputs alone could have forced.
///
/// One ulp is the distance of binary64 numbers at the true value: 2^(e-52) for 2^e <= |value| < 2^(e+1),
/// never less than 2^-1074. All of this is exact rational or ball arithmetic; only the two ends of a
/// reported interval are rounded to binary64, outwards.
#pragma once

#include "touchstone/catalogue/quantity.hpp"
#include "touchstone/rounding/ulp.hpp"

#include <optional>
#include <vector>

namespace touchstone::oracle {

/// least <= true figure <= most. Figures beyond binary64 end at its largest finite number.
struct Interval {
    double least = 0;
    double most = 0; ///< an upper bound
};

/// A certified value: the true one is within `error` of `value`.
struct CertifiedValue {
    Rational value; ///< the middle
    Rational error; ///< >= 0
    bool is_zero() const { return value == 0 && error == 0; } ///< exactly zero
};

using touchstone::ulp_at;

/// |answer - truth| in ulps; in absolute terms where the truth is zero, which has no ulp of its own.
/// An infinite answer to a value that rounds to infinity is right. `answer` is no NaN.
Interval error_of(double answer, const CertifiedValue& truth);

/// Whether an answer is beyond comparison: a NaN, or infinite where the true value is not.
bool is_special(double answer, const CertifiedValue& truth);

/// What a perfect code can lose because each real input was rounded once: the largest
/// |f(x') - f(x)| over the box of inputs x' within half an ulp of x, in the units of error_of().
struct Forced {
    double least = 0;           ///< reached by an input of the box
    std::optional<double> most; ///< exceeded by none; infinite where f is unbounded on the box; nothing if not known
};

/// For a closed form the corners of the box give `least` (or it is `known`), ball enclosures over its parts `most`, the tighter the
/// more `pieces` each side of each input is cut into; inputs outside the quantity's domain do not count.
/// Cost for k real inputs: 3^k (nothing if known) + (2 pieces)^k evaluations at 192 bits.
/// For the recursion it is as in table/forced.hpp, and an estimate may be off by a factor of `estimate_slack`.
Forced forced_by_inputs(const Quantity&, const std::vector<double>& inputs, const CertifiedValue& truth, int pieces,
                        std::optional<double> known = {});

/// How far an estimated condition number is trusted: beyond this many times it a row fails, between it and that it is undecided.
inline constexpr double estimate_slack = 4;

/// Whether a row is certified anew in less than seconds. (A distribution beyond scale 1, or an area with full contact, is not.)
bool quickly_certified(const Quantity&, const std::vector<double>& inputs);

/// Whether another load or G needs another solution of the recursion: seconds a row, where a closed form takes microseconds.
bool of_the_recursion(const Quantity&);

/// The exact inputs of a row.
Inputs exact_inputs(const Quantity&, const std::vector<double>& row);

} // namespace touchstone::oracle
