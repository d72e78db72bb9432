// SPDX-License-Identifier: MIT
// Integrals that other quadratures get wrong, at 30, 100 and 1000 digits.
#include "tests/quadrature/closed_form.hpp"

#include <doctest/doctest.h>

using namespace touchstone;
using namespace touchstone::quadrature;
using namespace touchstone::quadrature::testing;

namespace {

constexpr long digits_tried[] = {30, 100, 1000};

Ball atan_of(const Ball& x)
{
    Ball y;
    arb_atan(y.get(), x.get(), WorkingPrecision::bits());
    return y;
}

} // namespace

TEST_CASE("x^-0.9 on [0, 1]: an integrable pole, where ball integrators give NaN and doubles lose everything")
{
    for (const long d : digits_tried)
        check_integral([](auto, auto l, auto) { return to_power(l, Rational(-9, 10)); }, Interval::finite(0, 1), d,
                       [] { return Ball(10); });
}

TEST_CASE("(1 + x)^-0.9 on [-1, 1]: the same away from zero")
{
    for (const long d : digits_tried)
        check_integral([](auto, auto l, auto) { return to_power(l, Rational(-9, 10)); }, Interval::finite(-1, 1), d,
                       [] { return Ball(10) * pow(Ball(2), Ball(1) / Ball(10)); });
}

TEST_CASE("1/sqrt(1 - x) and sqrt(1 - x) on [0, 1]")
{
    for (const long d : digits_tried) {
        check_integral([](auto, auto, auto r) { return 1 / sqrt(r); }, Interval::finite(0, 1), d, [] { return Ball(2); });
        check_integral([](auto, auto, auto r) { return sqrt(r); }, Interval::finite(0, 1), d, [] { return Ball(2) / Ball(3); });
    }
}

TEST_CASE("1/(x^2 + 1e-4) on [-1, 1]: poles close to the middle")
{
    for (const long d : digits_tried)
        check_integral([](auto x, auto, auto) { return 1 / (x * x + Rational(1, 10000)); }, Interval::finite(-1, 1), d,
                       [] { return 200 * atan_of(Ball(100)); });
}

TEST_CASE("branch points just outside the interval: the strip must not reach across their cuts")
{
    const Rational e(1, 1000);
    for (const long d : {3L, 10L, 30L, 100L}) {
        check_integral([e](auto x, auto, auto) { return sqrt(x + e); }, Interval::finite(0, 1), d, [e] {
            const Ball low(e), high(Rational(1 + e));
            return 2 * (high * sqrt(high) - low * sqrt(low)) / 3;
        });
        check_integral([e](auto x, auto, auto) { return log(x + e); }, Interval::finite(0, 1), d, [e] {
            const Ball low(e), high(Rational(1 + e));
            return high * log(high) - low * log(low) - 1;
        });
    }
}

TEST_CASE("|x - 1/3| on [-1, 1]: refused whole, right in two parts")
{
    const Rational third(1, 3);
    for (const long d : digits_tried) {
        Options options;
        options.digits = d;
        check_refused([third](auto x, auto, auto) { return abs(x - third); }, Interval::finite(-1, 1), options);
        const Enclosure left = tanh_sinh([](auto, auto, auto r) { return r; }, Interval::finite(-1, third), options);
        const Enclosure right = tanh_sinh([](auto, auto l, auto) { return l; }, Interval::finite(third, 1), options);
        const WorkingPrecision precision(bits_for_digits(d) + 60);
        CHECK((left.value + right.value).contains(Rational(10, 9)));
        CHECK(proven_digits(left.value + right.value) > static_cast<double>(d - 3));
    }
}

TEST_CASE("cos(64 sin x) on [0, pi] = pi J_0(64): oscillation that two coarse levels can agree on")
{
    for (const long d : digits_tried) {
        check_integral([](auto x, auto, auto) { return cos(64 * sin(x)); }, Interval::finite(0, Endpoint([] { return pi<Ball>(); })), d,
                       [] {
                           Ball j;
                           arb_hypgeom_bessel_j(j.get(), Ball(0).get(), Ball(64).get(), WorkingPrecision::bits());
                           return pi<Ball>() * j;
                       });
    }
}

TEST_CASE("sqrt(sin^2 a - sin^2 x) up to the contact edge x = a, through the distance to it")
{
    // cos x sqrt(sin^2 a - sin^2 x) over [0, a] is pi sin^2(a) / 4; here a = 1/2.
    for (const long d : digits_tried) {
        check_integral([](auto x, auto, auto r) { return cos(x) * sqrt(sin(r) * sin(1 - r)); }, Interval::finite(0, Rational(1, 2)), d, [] {
            const Ball s = sin(Ball(1) / Ball(2));
            return pi<Ball>() * s * s / 4;
        });
    }
}

TEST_CASE("logarithms at the ends")
{
    for (const long d : digits_tried) {
        check_integral([](auto, auto l, auto) { return log(l); }, Interval::finite(0, 1), d, [] { return Ball(-1); });
        // d^2 B(a, b)/da db at a = b = 1
        check_integral([](auto, auto l, auto r) { return log(l) * log(r); }, Interval::finite(0, 1), d, [] {
            const Ball p = pi<Ball>();
            return 2 - p * p / 6;
        });
        check_integral([](auto, auto l, auto) { return log(l) * log(l) / sqrt(l); }, Interval::finite(0, 1), d, [] { return Ball(16); });
    }
}

TEST_CASE("half-infinite and infinite intervals")
{
    for (const long d : digits_tried) {
        check_integral([](auto x, auto, auto) { return 1 / (1 + x * x); }, Interval::whole_line(Decay::algebraic), d,
                       [] { return pi<Ball>(); });
        check_integral([](auto x, auto l, auto) { return 1 / (sqrt(l) * (1 + x)); }, Interval::right_half_line(0, Decay::algebraic), d,
                       [] { return pi<Ball>(); });
        check_integral([](auto, auto l, auto r) { return r / sqrt(l); }, Interval::right_half_line(0, Decay::exponential), d,
                       [] { return sqrt(pi<Ball>()); });
        check_integral([](auto, auto l, auto r) { return l * sqrt(r); }, Interval::left_half_line(2, Decay::exponential), d,
                       [] { return sqrt(pi<Ball>()) / 2; });
        // sech x = 2 l r / (l^2 + r^2) with exp(x) = l/r
        check_integral([](auto, auto l, auto r) { return 2 * l * r / (l * l + r * r); }, Interval::whole_line(Decay::exponential), d,
                       [] { return pi<Ball>(); });
    }
}
