// SPDX-License-Identifier: MIT
/// \file
/// Exact rational numbers: every input of the program is one.
#pragma once

#include <gmpxx.h>

#include <optional>
#include <string>
#include <string_view>

namespace touchstone {

using Rational = mpq_class; ///< in lowest terms, once canonicalised
using Integer = mpz_class; ///< of any size

/// Read an exact number: an integer (`12`), a decimal (`0.1`, `1e-300`, exactly
/// 1/10 and 10^-300), a quotient of those (`1/3`), or a C99 hexadecimal number
/// (`0x1.8p-3`). Nothing else: no blanks, no `inf`, no `nan`. Exponents are
/// limited to one million so that a typing error cannot fill the memory.
/// \returns nothing if the text is not such a number.
std::optional<Rational> parse_rational(std::string_view text);

/// The rational number that a finite binary64 value is.
Rational exact_rational(double x);

/// The binary64 number nearest to r (ties to even); infinite past the largest.
double nearest_double(const Rational& r);

/// Whether r has a finite decimal expansion, and then its number of significant digits.
std::optional<long> terminating_digits(const Rational& r);

/// b with b^m = r, if r has a rational m-th root (m >= 1, r >= 0).
std::optional<Rational> exact_root(const Rational& r, unsigned long m);

/// r^e for an integer e (r != 0 if e < 0).
Rational power(const Rational& r, long e);

} // namespace touchstone
