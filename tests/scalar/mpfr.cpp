// SPDX-License-Identifier: MIT
#include "touchstone/scalar/mpfr.hpp"

#include "touchstone/scalar/ball.hpp"

#include <doctest/doctest.h>

using namespace touchstone;

namespace {

/// Whether x is what the ball encloses, to 55 of its 60 digits, relative.
bool is(const Mpfr& x, const Ball& y)
{
    Mpfr middle;
    arf_get_mpfr(middle.backend().data(), arb_midref(y.get()), MPFR_RNDN);
    return abs(x - middle) <= abs(middle) * Mpfr("1e-55");
}

} // namespace

TEST_CASE("sines and cosines of multiples of pi keep their digits next to their zeros, all around the circle")
{
    const WorkingPrecision precision(512);
    Mpfr::default_precision(60);
    const double tiny = 0x1p-100;
    for (const double x : {0.1, 0.22, 0.3, 0.45, 0.6, 0.71, 0.9, 1.2, 1.4, 1.6, 1.9, -0.2, -0.7, -1.3, 7.3}) {
        CAPTURE(x);
        CHECK(is(sin_pi(Mpfr(x)), sin_pi(Ball::exactly(x))));
        CHECK(is(cos_pi(Mpfr(x)), cos_pi(Ball::exactly(x))));
    }
    for (const int sign : {-1, 1}) {
        const Mpfr t = Mpfr(sign * tiny);
        const Ball b = Ball::exactly(sign * tiny);
        CHECK(is(sin_pi(t), sin_pi(b)));
        CHECK(is(sin_pi(Mpfr(1 + t)), sin_pi(Ball(1) + b)));
        CHECK(is(cos_pi(Mpfr(Mpfr(1) / 2 + t)), cos_pi(Ball(Rational(1, 2)) + b)));
        CHECK(is(cos_pi(Mpfr(Mpfr(3) / 2 + t)), cos_pi(Ball(Rational(3, 2)) + b)));
    }
}

TEST_CASE("an Mpfr number is not less than itself")
{
    CHECK(less(Mpfr(1), Mpfr(1)) == Truth::no);
    CHECK(less(Mpfr(1), Mpfr(2)) == Truth::yes);
}
