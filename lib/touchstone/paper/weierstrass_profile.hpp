// SPDX-License-Identifier: MIT
/// \file
/// The infinite sum (3.1), enclosed: as many terms as the precision needs, the rest bounded.
#pragma once

#include "touchstone/scalar/exact.hpp"

namespace touchstone::weierstrass {

/// How many terms leave a rest below 2^-bits: N with N (2 - D) log2(gamma) >= bits + log2(bound).
/// \throws std::length_error above ten million terms, or where the phases together would have more than
/// 4 10^9 bits (D too near 2 or gamma too near 1): minutes of work.
long terms_needed(const Rational& D, const Rational& gamma, slong bits);

/// z(x)/g0 of (3.1) to about 2^-bits absolute, bits = working precision. Route: outside in, the
/// phase gamma^n x a ball of N log2(gamma) + bits bits, fewer as n grows if gamma is an integer (a phase
/// of hundreds of thousands of bits is no special case). The tail, below r^N/(1 - r), is in the radius.
/// (z has period 1 only for integer gamma: otherwise whole turns of x count at the next scale.)
Ball profile_by_terms(const Rational& x, const Rational& D, const Rational& gamma);

/// The same by the scaling relation (3.5), z(x) = cos(2 pi x) + r z(gamma x), from the smallest scale
/// outward, the phases exact rational numbers, the innermost z in [-bound, bound].
Ball profile_by_scaling(const Rational& x, const Rational& D, const Rational& gamma);

/// z(x)/g0 of (3.1) in binary64, correctly rounded for these binary64 arguments; NaN where the series is
/// too long (terms_needed). Cost: that of the enclosure at about 70 bits, some 10 microseconds a term.
double profile(double x, double D, double gamma);

/// 4 M gamma^(e M), e = 2 - D, M the number of distinct phases gamma^n x mod 1: what no conjugate of the algebraic integer exceeds by which
/// profile_exact proves zeros. It has M terms, those before the cycle twice, each at most 2 gamma^(e M).
Ball conjugates_bound(long phases, const Rational& e, const Rational& gamma);

/// The exact value at x = 0, and where gamma is an integer and the phases gamma^n x mod 1 run into a short cycle, and
/// either every cosine met is rational (x = 0, 1/2, 1/3, 1/6, ... and all that fall onto them), or the sum
/// vanishes: z is then an algebraic number in disguise, and one that is smaller than its conjugates allow
/// is zero (x = 1/10, gamma = 5, D = 3/2: cos 36 degrees is the sum of all that follows).
/// \throws NotExact elsewhere
Exact profile_exact(const Rational& x, const Rational& D, const Rational& gamma);

} // namespace touchstone::weierstrass
