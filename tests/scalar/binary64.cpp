// SPDX-License-Identifier: MIT
/// What formulas of the paper are made of, as double forms, against balls: all around the circle, next to where differences vanish, and
/// where squares underflow.
#include "touchstone/scalar/ball.hpp"
#include "touchstone/scalar/rational.hpp"
#include "touchstone/scalar/scalar.hpp"
#include "touchstone/scalar/second_look.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <utility>
#include <vector>

using namespace touchstone;

namespace {

/// Within so many ulp of all that the ball encloses.
bool is(double x, const Ball& y, double ulps = 4)
{
    const double middle = arf_get_d(arb_midref(y.get()), ARF_RND_NEAR);
    return y.is_finite() && std::fabs(x - middle) <= ulps * std::numeric_limits<double>::epsilon() * std::fabs(middle) +
                                                         std::numeric_limits<double>::denorm_min();
}

/// The root of D, a difference from a: as accurate as D to within an ulp of a.
bool is_root(double x, const Ball& D, double a)
{
    const double d = std::max(0.0, arf_get_d(arb_midref(D.get()), ARF_RND_NEAR));
    return std::fabs(x * x - d) <= std::numeric_limits<double>::epsilon() * (8 * d + a);
}

/// Numbers on both sides of x, at distances from an ulp to a quarter of it.
std::vector<double> around(double x)
{
    std::vector<double> all{x};
    for (const double off : {0x1p-52, 0x1p-50, 0x1p-40, 0x1p-20, 0x1p-10, 0x1p-5, 0x1p-2}) {
        all.push_back(x * (1 - off));
        all.push_back(x * (1 + off));
    }
    return all;
}

} // namespace

TEST_CASE("sines and cosines of multiples of pi in double")
{
    const WorkingPrecision precision(256);
    for (const double turns : {0.0, 2.0, -4.0})
        for (const double x : {0x1p-30, 0.1, 0.25, 0.3, 0.49, 0.5, 0.51, 0.7, 0.75, 0.99, 1.01, 1.25, 1.5, 1.75, 1.9})
            for (const int sign : {-1, 1}) {
                const double at = turns + sign * x;
                CAPTURE(at);
                CHECK(is(sin_pi(at), sin_pi(Ball::exactly(at))));
                CHECK((std::fabs(cos_pi(at)) < 1e-300 || is(cos_pi(at), cos_pi(Ball::exactly(at)))));
            }
    CHECK(sin_pi(1.0) == 0);
    CHECK(cos_pi(0.5) == 0);
    CHECK(cos_pi(1.5) == 0);
}

TEST_CASE("roots of differences keep their digits where the difference vanishes and where squares underflow")
{
    const WorkingPrecision precision(2400);
    const auto pi_times = [](double x) { return touchstone::pi<Ball>() * Ball::exactly(x); };
    const auto root_of = [](const Ball& d) { return sqrt_positive_part(d); };
    for (const double a : {0x1p-1000, 1e-290, 0x1p-810, 0x1p-790, 1e-20, 1e-3, 0.2, 0.45, 0.55, 0.9, 1.0}) {
        CAPTURE(a);
        const Ball A = Ball::exactly(a);
        for (const double b : around(std::sqrt(a))) {
            CAPTURE(b);
            CHECK(is(sqrt_minus_square(a, b), root_of(A - Ball::exactly(b) * Ball::exactly(b))));
        }
        for (const double x : around(std::sqrt(a) / M_PI)) {
            CAPTURE(x);
            const Ball square = pi_times(x) * pi_times(x);
            CHECK(is(sqrt_minus_pi_square(a, x), root_of(A - square)));
            CHECK(is(sqrt_pi_square_minus(x, a), root_of(square - A)));
        }
        CHECK(is(sqrt_pi_square_minus(0.3, a), root_of(pi_times(0.3) * pi_times(0.3) - A)));
        for (const double x : around(std::asin(std::sqrt(a)) / M_PI)) {
            CAPTURE(x);
            if (x > 0.5) continue;
            const Ball sine = sin_pi(Ball::exactly(x)), square = sine * sine;
            CHECK(is_root(sqrt_minus_sin_pi_square(a, x), A - square, a));
            CHECK(is_root(sqrt_sin_pi_square_minus(x, a), square - A, a));
        }
    }
}

TEST_CASE("a difference from a square is rounded once where 40 bits of it cancel, whatever its size")
{
    std::mt19937_64 random(20261126);
    std::uniform_real_distribution<double> uniform(1, 4);
    for (const int exponent : {-180, -60, 0, 60, 180, 600})
        for (int i = 0; i < 50; ++i) {
            const double a = std::ldexp(uniform(random), exponent), b = std::sqrt(a) * (1 + std::ldexp(uniform(random), -44 - i % 8));
            CAPTURE(a);
            CAPTURE(b);
            CHECK(ScalarTraits<double>::minus_square(a, b) == std::fma(-b, b, a));
        }
}

TEST_CASE("hypotenuses neither overflow nor underflow, and a power by a product has the digits of the product")
{
    const WorkingPrecision precision(256);
    for (const double a : {3e-300, 3e-200, 3.0, 3e150, 3e300})
        for (const double b : {4e-300, 4e-200, 4.0, 4e150, 4e300, 0.0}) {
            CAPTURE(a);
            CAPTURE(b);
            CHECK(is(hypot_of(a, b), hypot_of(Ball::exactly(a), Ball::exactly(b)), 2));
        }
    for (const double x : {1e-100, 0.3, 1e100})
        for (const double a : {0.7, 1.0 / 3})
            for (const double b : {1.3, -2.7})
                CHECK(is(pow_product(x, a, b), pow(Ball::exactly(x), Ball::exactly(a) * Ball::exactly(b))));
}

TEST_CASE("the terms of sin^2 beyond y^2 are those of (1 - cos 2y)/2, exactly rounded or nearly")
{
    Rational term(8, 24); // 2^3/4!
    for (long k = 2; k <= 11; ++k) {
        CAPTURE(k);
        CHECK(std::fabs(sine_terms[static_cast<std::size_t>(k) - 2] / term.get_d() - 1) < 1e-15);
        term *= Rational(-4, (2 * k + 1) * (2 * k + 2));
    }
    for (const double y : {0.01, 0.3, 0.785})
        CHECK(y * y - y * y * y * y * sum_of_powers(sine_terms, y * y) ==
              doctest::Approx(std::sin(y) * std::sin(y)).scale(0).epsilon(1e-15));
}

TEST_CASE("a second look goes half as far, ten digits at least, and never farther than the first")
{
    for (const auto& [digits, looked_at] :
         {std::pair{1L, 1L}, {9L, 9L}, {10L, 10L}, {15L, 10L}, {20L, 10L}, {21L, 11L}, {30L, 15L}, {1000L, 500L}})
        CHECK(looked_at_again({digits}).digits == looked_at);
}
