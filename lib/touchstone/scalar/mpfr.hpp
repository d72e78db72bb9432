// SPDX-License-Identifier: MIT
/// \file
/// Boost.Multiprecision's MPFR number at run-time precision as a Scalar.
///
/// Its precision is Boost's own default, `Mpfr::default_precision(decimal digits)`,
/// which in Boost 1.74 is one setting for the whole process. Results are rounded,
/// not enclosed: nothing computed here is ever called certified.
#pragma once

#include "touchstone/scalar/scalar.hpp"

#include <boost/multiprecision/mpfr.hpp>

namespace touchstone {
/// As many digits as default_precision says.
using Mpfr = boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<0>, boost::multiprecision::et_off>;
/// MPFR numbers: rounded to nearest, nothing proven.
template <>
struct ScalarTraits<Mpfr> : ComposedTraits<Mpfr> {
    static Mpfr integer(long n) { return Mpfr(n); } ///< n
    static Truth less(const Mpfr& x, const Mpfr& y) { return truth(x < y); } ///< always decided; no for a NaN
    static Mpfr hull(const Mpfr& x, const Mpfr& y) { return x == y ? x : std::numeric_limits<Mpfr>::quiet_NaN(); } ///< NaN unless equal
    static Mpfr quotient(long p, long q) { return Mpfr(p) / q; } ///< p/q, rounded
    static Mpfr pi()
    {
        Mpfr r;
        mpfr_const_pi(r.backend().data(), MPFR_RNDN);
        return r;
    } ///< pi, rounded
    /// pi x after an exact reduction, so that sin_pi(1/2 - tiny) keeps its digits.
    static Mpfr sin_pi(const Mpfr& x)
    {
        const Mpfr turn = nearest_even_remainder(x);
        const Mpfr a = abs(turn);
        const Mpfr r = 2 * a > 1 ? Mpfr(1 - a) : a;
        const Mpfr s = 4 * r > 1 ? cos(pi() * (Mpfr(1) / 2 - r)) : sin(pi() * r);
        return turn < 0 ? Mpfr(-s) : s;
    }
    static Mpfr cos_pi(const Mpfr& x)
    {
        const Mpfr a = abs(nearest_even_remainder(x));
        const Mpfr r = 2 * a > 1 ? Mpfr(1 - a) : a;
        const Mpfr c = 4 * r > 1 ? sin(pi() * (Mpfr(1) / 2 - r)) : cos(pi() * r);
        return 2 * a > 1 ? Mpfr(-c) : c;
    } ///< cos(pi x), after the same reduction
    static Mpfr powm1(const Mpfr& x, const Mpfr& y)
    {
        Mpfr r = y * log(x);
        mpfr_expm1(r.backend().data(), r.backend().data(), MPFR_RNDN);
        return r;
    } ///< x^y - 1, x > 0, by expm1(y log x)
    static Mpfr sqrt_positive_part(const Mpfr& x) { return x > 0 ? sqrt(x) : Mpfr(0); } ///< sqrt(max(x, 0))
    static Mpfr hypot(const Mpfr& a, const Mpfr& b)
    {
        Mpfr r;
        mpfr_hypot(r.backend().data(), a.backend().data(), b.backend().data(), MPFR_RNDN);
        return r;
    } ///< sqrt(a^2 + b^2), rounded once
    static Mpfr power_of_two(long e)
    {
        Mpfr r(1);
        mpfr_mul_2si(r.backend().data(), r.backend().data(), e, MPFR_RNDN);
        return r;
    } ///< 2^e, exact
    static Mpfr gamma(const Mpfr& x)
    {
        Mpfr r;
        mpfr_gamma(r.backend().data(), x.backend().data(), MPFR_RNDN);
        return r;
    } ///< Euler's Gamma(x), rounded once

private:
    /// x - 2k in [-1, 1], exactly.
    static Mpfr nearest_even_remainder(const Mpfr& x)
    {
        Mpfr r;
        mpfr_remainder(r.backend().data(), x.backend().data(), Mpfr(2).backend().data(), MPFR_RNDN);
        return r;
    }
};

} // namespace touchstone
