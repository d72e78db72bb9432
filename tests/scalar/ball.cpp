// SPDX-License-Identifier: MIT
#include "touchstone/scalar/accuracy.hpp"
#include "touchstone/scalar/ball.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>
#include <sstream>

using namespace touchstone;

namespace {

/// A random ball and a random point in it.
struct Sample {
    Ball ball;
    Ball point;
};

Sample sample(std::mt19937_64& random, double low, double high)
{
    const auto uniform = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
    Sample s;
    s.point = Ball::exactly(low + (high - low) * uniform());
    const double radius = std::ldexp(uniform(), -static_cast<int>(random() % 60));
    s.ball = s.point + Ball::exactly(radius * (2 * uniform() - 1));
    arb_add_error(s.ball.get(), Ball::exactly(radius).get());
    return s;
}

} // namespace

TEST_CASE("a function of a ball contains the function of each of its points, and is no wider than it must be")
{
    const unsigned seed = 19570101;
    std::mt19937_64 random(seed);
    INFO("seed " << seed);
    const auto check = [](const Ball& wide, const Ball& exact) { CHECK(wide.overlaps(exact)); };
    for (int i = 0; i < 500; ++i) {
        const WorkingPrecision precision(64 + static_cast<slong>(random() % 100));
        const Sample a = sample(random, 0.1, 3), b = sample(random, 0.1, 3);
        check(a.ball + b.ball, a.point + b.point);
        check(a.ball - b.ball, a.point - b.point);
        check(a.ball * b.ball, a.point * b.point);
        check(a.ball / b.ball, a.point / b.point);
        check(sqrt(a.ball), sqrt(a.point));
        check(exp(a.ball), exp(a.point));
        check(log(a.ball), log(a.point));
        check(sin_pi(a.ball), sin_pi(a.point));
        check(cos_pi(a.ball), cos_pi(a.point));
        check(atan2(a.ball, b.ball), atan2(a.point, b.point));
        check(pow(a.ball, b.ball), pow(a.point, b.point));
        check(powm1(a.ball, b.ball), powm1(a.point, b.point));
        check(gamma_function(a.ball), gamma_function(a.point));
        check(hypot_of(a.ball, b.ball), hypot_of(a.point, b.point));
        check(at_most(a.ball, b.ball), at_most(a.point, b.point));
        check(at_least(a.ball, b.ball), at_least(a.point, b.point));
        check(hull(a.ball, b.ball), a.point);
        check(sqrt_positive_part(a.ball - b.ball), sqrt_positive_part(a.point - b.point));
        // tightness: on points the result carries nearly the working precision, so [-inf, inf] could not pass
        CHECK(sqrt(a.point).relative_bits() > WorkingPrecision::bits() - 4);
        CHECK(pow(a.point, b.point).relative_bits() > WorkingPrecision::bits() - 16);
    }
}

TEST_CASE("leaving the domain gives an indeterminate ball, never a wrong one")
{
    CHECK_FALSE(sqrt(Ball(-1)).is_finite());
    CHECK_FALSE(log(Ball(0)).is_finite());
    CHECK_FALSE((Ball(1) / Ball(0)).is_finite());
    CHECK_FALSE(asin(Ball(2)).is_finite());
}

TEST_CASE("comparisons say yes, no or unknown")
{
    Ball wide(1);
    arb_add_error(wide.get(), Ball(Rational(1, 2)).get());
    CHECK(less(Ball(1), Ball(2)) == Truth::yes);
    CHECK(less(Ball(2), Ball(2)) == Truth::no);
    CHECK(less(wide, Ball(1)) == Truth::unknown);
    CHECK(possibly(less(wide, Ball(1))));
    CHECK_FALSE(certainly(less(wide, Ball(1))));
}

TEST_CASE("across a seam the hull covers both branches, and neither leaves its domain")
{
    Ball x(1);
    arb_add_error(x.get(), Ball(Rational(1, 4)).get());
    const Ball y = across_seam(x, Ball(1), [](const Ball& s) { return 2 * sqrt(s); }, [](const Ball& s) { return 1 + s; });
    CHECK(y.contains(2 * sqrt(Ball(Rational(3, 4)))));
    CHECK(y.contains(Rational(9, 4)));
    CHECK(y.radius_bound() < 0.3);
    // sqrt(1 - s) exists below 1 only: handing it the whole ball would give nothing
    CHECK(across_seam(
              x, Ball(1), [](const Ball& s) { return sqrt_positive_part(1 - s); }, [](const Ball&) { return Ball(0); })
              .is_finite());
}

TEST_CASE("clipping returns the bound itself when the ball is beyond it")
{
    CHECK(at_most(Ball(2), Ball(1)).is_exact());
    CHECK(at_least(Ball(-2), Ball(0)).is_exact());
    CHECK(at_most(Ball(Rational(1, 3)), Ball(1)).contains(Rational(1, 3)));
}

TEST_CASE("a ball survives text without losing a bit")
{
    const Ball b = sqrt(Ball(2));
    const Ball again = Ball::parse(b.dump());
    CHECK(arb_equal(b.get(), again.get()) != 0);
    CHECK_FALSE(Ball::parse("not a ball").is_finite());
}

TEST_CASE("the working precision is the scope's and the thread's")
{
    const slong before = WorkingPrecision::bits();
    {
        const WorkingPrecision precision(1000);
        CHECK(Ball(Rational(1, 3)).relative_bits() > 990);
    }
    CHECK(WorkingPrecision::bits() == before);
}

TEST_CASE("a formula works with 48 bits more than its digits need, and so many bits are meant for those digits")
{
    for (const long digits : {1L, 20L, 1000L}) {
        CAPTURE(digits);
        CHECK(std::fabs(static_cast<double>(bits_for_digits(digits)) - static_cast<double>(digits) * std::log2(10.0) - 16) < 1);
        CHECK(working_bits({digits}) == bits_for_digits(digits) + 48);
        CHECK(accuracy_of(working_bits({digits})).digits <= digits);
        CHECK(accuracy_of(working_bits({digits}) + 1).digits >= digits);
    }
    CHECK(working_bits({-100}) == 2);
}

TEST_CASE("complex balls contain what they should")
{
    const ComplexBall i(Ball(0), Ball(1));
    CHECK((i * i).overlaps(ComplexBall(-1)));
    CHECK(sqrt(ComplexBall(-1)).overlaps(i));
    CHECK(exp(ComplexBall(Ball(0), pi<Ball>())).overlaps(ComplexBall(-1)));
    CHECK(abs(ComplexBall(Ball(3), Ball(4))).contains(Rational(5)));
    CHECK(atan2(ComplexBall(1), ComplexBall(1)).real().overlaps(pi<Ball>() / 4));
    CHECK(atan2(sqrt(ComplexBall(3)), ComplexBall(3)).real().overlaps(pi<Ball>() / 6)); // arctan(y/x)
}

TEST_CASE("the functions of complex balls that formulas are written with, at arguments where they are known")
{
    using C = ScalarTraits<ComplexBall>;
    const WorkingPrecision precision(120);
    const ComplexBall i(Ball(0), Ball(1)), half = C::quotient(1, 2);
    const auto is = [](const ComplexBall& value, const ComplexBall& known) {
        const ComplexBall off = value - known;
        return off.overlaps(ComplexBall(0)) && abs(off).radius_bound() < 1e-30;
    };
    CHECK(is(half + half, C::integer(1)));
    CHECK(is(C::power_of_two(-3) * C::integer(8), C::integer(1)));
    const ComplexBall e_pi = exp(C::pi()), cosh_pi = (e_pi + ComplexBall(1) / e_pi) / ComplexBall(2);
    CHECK(is(C::sin_pi(half + i), cosh_pi));
    CHECK(is(C::cos_pi(i), cosh_pi));
    CHECK(is(C::powm1(i, ComplexBall(3)), -i - ComplexBall(1)));
    CHECK(is(C::hypot(ComplexBall(3), ComplexBall(4)), ComplexBall(5)));
    CHECK(is(C::hypot(ComplexBall(5) * i, ComplexBall(13)), ComplexBall(12)));
    CHECK(is(C::hypot(ComplexBall(13), ComplexBall(5) * i), ComplexBall(12)));
    CHECK(is(C::gamma(half), sqrt(C::pi())));
    CHECK(is(C::sqrt_positive_part(ComplexBall(-4)), ComplexBall(2) * i));
}
