// SPDX-License-Identifier: MIT
/// \file
/// The infinite sum (3.1), enclosed: as many terms as the precision needs, the rest bounded.
#pragma once

#include "touchstone/scalar/exact.hpp"

namespace touchstone::weierstrass {

/// How many terms leave a rest below 2^-bits: N with N (2 - D) log2(gamma) >= bits + log2(bound).
/// \throws std::length_error above ten million terms (D too near 2 or gamma too near 1).
long terms_needed(const Rational& D, const Rational& gamma, slong bits);

/// z(x)/g0 of (3.1) to about 2^-bits absolute, bits = working precision. Route: outside in, the
/// phase gamma^n x a ball whose precision falls from N log2(gamma) + bits to bits (a phase of
/// hundreds of thousands of bits is no special case). The tail, below r^N/(1 - r), is in the radius.
Ball profile_by_terms(const Rational& x, const Rational& D, const Rational& gamma);

/// The same by the scaling relation (3.5), z(x) = cos(2 pi x) + r z(gamma x), from the smallest scale
/// outward, the phases exact rational numbers reduced modulo 1, the innermost z in [-bound, bound].
Ball profile_by_scaling(const Rational& x, const Rational& D, const Rational& gamma);

/// The exact value where gamma is an integer and the phases gamma^n x mod 1 run into a cycle
/// on which every cosine is rational (x = 0, 1/2, 1/3, 1/6, ... and all that fall onto them).
/// \throws NotExact elsewhere
Exact profile_exact(const Rational& x, const Rational& D, const Rational& gamma);

} // namespace touchstone::weierstrass
