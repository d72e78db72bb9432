// SPDX-License-Identifier: MIT
/// \file
/// How accurate a value is wanted, and how accurate one believes itself to be: both said, neither guessed.
#pragma once

#include "touchstone/scalar/ball.hpp"

#include <algorithm>

namespace touchstone {

/// What is asked of a computation: a relative error of about 10^-digits or less. What it reached is in the ball it returns.
struct Accuracy {
    long digits = 20; ///< significant decimal digits
};

/// No limit but that of the program: see evaluate().
inline constexpr long any_digits = 10'000;

/// The bits a formula works with for this accuracy: 48 are left for what it loses on the way. At least 2.
constexpr slong working_bits(Accuracy a) { return std::max<slong>(2, bits_for_digits(a.digits) + 48); }
/// The accuracy that so many working bits, and no more, are meant for. (Not positive for few bits: a search may start there.)
constexpr Accuracy accuracy_of(slong bits) { return {(bits - bits_for_digits(0) - 48) * 1000 / 3322}; }

/// A value found without proof. It is evidence for or against a proof, and never becomes a ball that claims to enclose.
struct Witness {
    Ball value; ///< radius zero
    Ball error; ///< >= 0: how far off its own method thinks it is; no bound
};

} // namespace touchstone
