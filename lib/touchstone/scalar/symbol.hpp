// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// A GiNaC expression as a Scalar: the formulas of the paper become expressions
/// that can be differentiated, expanded and compared with what is printed.
/// (This header alone brings in GiNaC, hence its licence.)
#pragma once

#include "touchstone/scalar/scalar.hpp"

#include <ginac/ginac.h>

namespace touchstone {
/// A GiNaC expression.
using Symbol = GiNaC::ex;
/// Expressions: nothing is evaluated.
template <>
struct ScalarTraits<Symbol> : ComposedTraits<Symbol> {
    static Symbol integer(long n) { return GiNaC::numeric(n); } ///< n
    static Symbol quotient(long p, long q) { return GiNaC::numeric(p, q); } ///< p/q
    static Symbol pi() { return GiNaC::Pi; } ///< the constant
    static Symbol sin_pi(const Symbol& x) { return GiNaC::sin(GiNaC::Pi * x); } ///< sin(pi x)
    static Symbol cos_pi(const Symbol& x) { return GiNaC::cos(GiNaC::Pi * x); } ///< cos(pi x)
    static Symbol powm1(const Symbol& x, const Symbol& y) { return GiNaC::pow(x, y) - 1; } ///< x^y - 1
    /// The branch in which x is positive: a symbol has no sign to ask for.
    static Symbol sqrt_positive_part(const Symbol& x) { return GiNaC::sqrt(x); }
    static Symbol hypot(const Symbol& a, const Symbol& b) { return GiNaC::sqrt(GiNaC::pow(a, 2) + GiNaC::pow(b, 2)); } ///< sqrt(a^2 + b^2)
    static Symbol power_of_two(long e) { return GiNaC::pow(GiNaC::numeric(2), GiNaC::numeric(e)); } ///< 2^e
    static Symbol gamma(const Symbol& x) { return GiNaC::tgamma(x); } ///< Euler's Gamma(x)
};

} // namespace touchstone
