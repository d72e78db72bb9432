// SPDX-License-Identifier: MIT
// What cannot be proved is refused, with a reason: never a ball.
#include "tests/quadrature/closed_form.hpp"

#include <doctest/doctest.h>

using namespace touchstone;
using namespace touchstone::quadrature;
using namespace touchstone::quadrature::testing;

namespace {

bool mentions(const Enclosure& e, const char* text) { return e.reason.find(text) != std::string::npos; }

} // namespace

TEST_CASE("a pole inside the interval is refused and located")
{
    const Enclosure e = check_refused([](auto x, auto, auto) { return 1 / (x - Rational(1, 3)); }, Interval::finite(0, 1));
    CHECK_MESSAGE(mentions(e, "0.3333"), e.reason);
    check_refused([](auto x, auto, auto) { return 1 / ((x - Rational(1, 3)) * (x - Rational(1, 3))); }, Interval::finite(0, 1));
    check_refused([](auto x, auto, auto) { return 1 / x; }, Interval::finite(-1, 1));
    check_refused([](auto x, auto, auto) { return 1 / ((x - 5) * x); }, Interval::right_half_line(1, Decay::algebraic));
}

TEST_CASE("a jump and a kink are refused")
{
    check_refused([](auto x, auto, auto) { return sgn(x - Rational(1, 7)); }, Interval::finite(0, 1));
    check_refused([](auto x, auto, auto) { return abs(x - Rational(1, 2)); }, Interval::finite(0, 1));
    // sqrt((x - 1/2)^2) is |x - 1/2|, not x - 1/2
    check_refused([](auto x, auto, auto) { return sqrt((x - Rational(1, 2)) * (x - Rational(1, 2))); }, Interval::finite(0, 1));
}

TEST_CASE("a branch point or branch cut inside the interval is refused")
{
    check_refused([](auto x, auto, auto) { return sqrt(x); }, Interval::finite(-1, 1));
    check_refused([](auto x, auto, auto) { return log(x); }, Interval::finite(-1, 1));
    check_refused([](auto x, auto, auto) { return asin(2 * x); }, Interval::finite(0, 1));
    // not through its distance: the square root winds around the end with the strip
    check_refused([](auto x, auto, auto) { return sqrt(1 - x); }, Interval::finite(0, 1));
}

TEST_CASE("an exponent that the integral does not survive is refused")
{
    CHECK(mentions(check_refused([](auto, auto l, auto) { return 1 / l; }, Interval::finite(0, 1)), "-1"));
    check_refused([](auto, auto, auto r) { return to_power(r, Rational(-11, 10)); }, Interval::finite(0, 1));
    check_refused([](auto x, auto, auto) { return 1 / x; }, Interval::right_half_line(1, Decay::algebraic));
    check_refused([](auto, auto, auto) { return Rational(1); }, Interval::right_half_line(1, Decay::exponential));
    check_refused([](auto, auto l, auto) { return 1 / (l * log(l)); }, Interval::finite(0, Rational(1, 2)));
}

TEST_CASE("a declared exponent that is better than what is proved is refused; a weaker one is harmless")
{
    const auto f = [](auto, auto l, auto) { return to_power(l, Rational(-9, 10)); };
    Options options;
    options.left_exponent = Rational(1, 2);
    CHECK(mentions(check_refused(f, Interval::finite(0, 1), options), "declared exponent 1/2"));
    for (const Rational& declared : {Rational(-1), Rational(-9, 10)}) {
        options.left_exponent = declared + 1; // of u^(e + 1) dw
        CHECK(tanh_sinh(f, Interval::finite(0, 1), options).status == Status::certified);
    }
    options.right_exponent = Rational(3, 2);
    check_refused(f, Interval::finite(0, 1), options);
}

TEST_CASE("NaN, at a point or everywhere, is refused")
{
    check_refused([](auto x, auto, auto) { return x * Ball::indeterminate(); }, Interval::finite(0, 1));
    check_refused([](auto x, auto, auto) { return x / (x - x); }, Interval::finite(0, 1));
    check_refused([](auto x, auto, auto) { return log(x - x); }, Interval::finite(0, 1));
}

TEST_CASE("an integrand without double-exponential decay on its map is refused")
{
    // exp(-x) does not decay where the strip winds around infinity
    check_refused([](auto x, auto, auto) { return exp(-x); }, Interval::right_half_line(0, Decay::algebraic));
    check_refused([](auto x, auto, auto) { return sin(x) / x; }, Interval::right_half_line(1, Decay::algebraic));
}

TEST_CASE("ends that are no interval are refused")
{
    const auto one = [](auto, auto, auto) { return Rational(1); };
    CHECK(mentions(check_refused(one, Interval::finite(1, 0)), "a < b"));
    check_refused(one, Interval::finite(1, 1));
    check_refused(one, Interval::finite(0, Ball::indeterminate()));
    Options none;
    none.digits = 0;
    check_refused(one, Interval::finite(0, 1), none);
    none.digits = 1;
    CHECK(tanh_sinh(one, Interval::finite(0, 1), none).status == Status::certified);
}

TEST_CASE("an exhausted proof budget is a refusal, not a guess")
{
    Options options;
    options.proof_budget = 3;
    check_refused([](auto x, auto, auto) { return exp(x); }, Interval::finite(0, 1), options);
}

TEST_CASE("an exponent too long for exact arithmetic is refused")
{
    const Rational fine = 1 - 1 / power(Rational(2), 70);
    CHECK(mentions(check_refused([fine](auto, auto l, auto) { return to_power(l, fine); }, Interval::finite(0, 1)), "exponent"));
}

TEST_CASE("fewer digits than asked for are no success: how many there are is said, and that the enclosure holds")
{
    const auto cases = [](const auto& f, const Interval& interval, long digits, long at_most) {
        Options options;
        options.digits = digits;
        const Enclosure e = tanh_sinh(f, interval, options);
        INFO(e.reason, " ", e.value.to_string());
        CHECK(e.status == Status::undecided);
        CHECK(to_string(e.status) == "undecided");
        CHECK(e.digits <= at_most);
        CHECK(e.value.is_finite());
        CHECK(mentions(e, "digit"));
        return e;
    };
    // e^31623 next to the interval: no answer with a radius of 1e6962
    const Rational thousandth(1, 1000);
    const auto wild = [thousandth](auto x, auto, auto) { return sin(to_power(thousandth + (1 - x) * (1 - x), Rational(-3, 2))); };
    CHECK(mentions(check_refused(wild, Interval::finite(0, 3)), "bits"));
    // 1000!, a peak 10^2567 high: the digits asked for, or how many there are, or none and why
    const auto peak = [](const auto& f, long digits) {
        Options options;
        options.digits = digits;
        const Enclosure e = tanh_sinh(f, Interval::right_half_line(0, Decay::exponential), options);
        INFO(to_string(e.status), " ", e.reason, " ", e.value.to_string());
        const WorkingPrecision precision(400);
        if (e.value.is_finite()) CHECK(e.value.overlaps(ScalarTraits<Ball>::gamma(Ball(1001))));
        if (e.status == Status::certified) {
            CHECK(e.digits == digits);
            CHECK(e.value.relative_bits() > bits_for_digits(digits) - 4);
        }
        else CHECK_FALSE(e.reason.empty());
        if (e.status == Status::undecided) CHECK(mentions(e, "digit"));
    };
    for (const long digits : {10L, 30L}) {
        peak([](auto, auto l, auto) { return to_power(l, Rational(1000)) * exp(-l); }, digits);
        peak([](auto x, auto l, auto) { return to_power(l, Rational(1000)) * exp(-x); }, digits);
    }
    peak([](auto x, auto, auto) { return to_power(x, Rational(1000)) * exp(-x); }, 10);
    // 10^-200 beside a sum that cancels: none of its digits, but where it is
    const Rational small = 1 / power(Rational(10), 200);
    CHECK(cases([small](auto x, auto, auto) { return sin(x) + small; }, Interval::finite(-1, 1), 10, 0).value.contains(2 * small));
    // exactly 0: no relative digit, a sharp enclosure
    const Enclosure zero = cases([](auto x, auto, auto) { return sin(x); }, Interval::finite(-1, 1), 20, 0);
    CHECK(zero.value.contains(Rational(0)));
    CHECK(zero.value.radius_bound() < 1e-20);
    // what is certified has what was asked for
    Options options;
    options.digits = 40;
    const Enclosure e = tanh_sinh([](auto x, auto, auto) { return exp(x); }, Interval::finite(0, 1), options);
    CHECK(e.status == Status::certified);
    CHECK(e.digits == 40);
    CHECK(e.value.relative_bits() > 132);
}
