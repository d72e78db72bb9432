// SPDX-License-Identifier: MIT
#include "touchstone/rounding/decimal.hpp"
#include "touchstone/rounding/shown.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

using namespace touchstone;

namespace {

Ball around(const Rational& mid, const Rational& radius)
{
    Ball b(mid);
    arb_add_error(b.get(), Ball(radius).get());
    return b;
}

} // namespace

TEST_CASE("digits are given only when the whole ball rounds to them")
{
    const WorkingPrecision precision(200);
    const Rational tiny = power(Rational(10), -30);
    CHECK(round_to_digits(around(Rational(1, 3), tiny), 20)->text() == "0.33333333333333333333");
    CHECK_FALSE(round_to_digits(around(Rational(1, 3), tiny), 40));
    // just under, just over and astride the midpoint between 0.12 and 0.13
    CHECK(round_to_digits(around(Rational(125, 1000) - 2 * tiny, tiny), 2)->text() == "0.12");
    CHECK(round_to_digits(around(Rational(125, 1000) + 2 * tiny, tiny), 2)->text() == "0.13");
    CHECK_FALSE(round_to_digits(around(Rational(125, 1000), tiny), 2));
    CHECK_FALSE(round_to_digits(around(Rational(0), tiny), 5)); // a sign is not known
    CHECK(round_to_digits(Ball(0), 5)->text() == "0");
    CHECK_FALSE(round_to_digits(Ball::indeterminate(), 5));
    // a midpoint of one bit with a tiny radius
    CHECK(round_to_digits(around(Rational(1, 2), power(Rational(2), -199)), 50)->text() ==
          "0.50000000000000000000000000000000000000000000000000");
    // a ball around a power of ten is not astride anything
    CHECK(round_to_digits(around(Rational(1), tiny), 10)->text() == "1.000000000");
}

TEST_CASE("exact ties round to even")
{
    CHECK(round_to_digits(Rational(125, 1000), 2).text() == "0.12");
    CHECK(round_to_digits(Rational(375, 1000), 2).text() == "0.38");
    CHECK(round_to_digits(Rational(-125, 1000), 2).text() == "-0.12");
    CHECK(round_to_digits(Rational(99999), 3).text() == "1.00e+05");
    CHECK(round_to_digits(Rational(149999), 2).text() == "1.5e+05");
    CHECK(round_to_digits(Rational(149999), 1).text() == "1e+05");
    CHECK(round_to_digits(Rational(2, 3), 5).text() == "0.66667");
    CHECK(round_to_digits(power(Rational(10), -300), 4).text() == "1.000e-300");
    CHECK(round_to_digits(power(Rational(10), 300) - 1, 4).text() == "1.000e+300");
}

TEST_CASE("binary64 numbers in hexadecimal, and what is none")
{
    CHECK(hexfloat(0.75) == "0x1.8p-1");
    CHECK(hexfloat(-std::numeric_limits<double>::infinity()) == "-inf");
    CHECK(hexfloat(std::numeric_limits<double>::infinity()) == "inf");
    CHECK(hexfloat(std::numeric_limits<double>::quiet_NaN()) == "nan");
}

TEST_CASE("text form: plain near one, scientific far from it, and it reads back")
{
    for (const Rational& r : {Rational(1), Rational(-12345), Rational(1, 3), Rational(1, 20000), Rational(1, 3000000),
                              power(Rational(7), 99), power(Rational(7), -99)}) {
        const Decimal d = round_to_digits(r, 12);
        CHECK(*parse_rational(d.text()) == d.value());
        CHECK(abs(d.value() - r) <= *parse_rational(d.half_unit()));
    }
    CHECK(round_to_digits(Rational(12345), 5).text() == "12345");
    CHECK(round_to_digits(Rational(123456), 5).text() == "1.2346e+05"); // the sixth digit is not known
    CHECK(round_to_digits(power(Rational(10), -5), 4).text() == "0.00001000");
    CHECK(round_to_digits(power(Rational(10), -6), 4).text() == "1.000e-06");
    CHECK(round_to_digits(Rational(12345), 7).text() == "12345.00");
    CHECK(round_to_digits(Rational(1, 16), 3).half_unit() == "5e-05");
}

TEST_CASE("nearest double of a ball: decided or not given")
{
    const WorkingPrecision precision(200);
    const Rational tiny = power(Rational(2), -150);
    CHECK(*nearest_double(around(Rational(1, 3), tiny)) == 1.0 / 3.0);
    CHECK_FALSE(nearest_double(around(1 + power(Rational(2), -53), tiny))); // astride a tie
    CHECK(*nearest_double(Ball(1 + power(Rational(2), -53))) == 1.0);       // the tie itself: to even
    CHECK(*nearest_double(Ball(power(Rational(2), -1074))) == std::numeric_limits<double>::denorm_min());
    CHECK(*nearest_double(Ball(3 * power(Rational(2), -1075))) == 2 * std::numeric_limits<double>::denorm_min());
    CHECK(*nearest_double(Ball(power(Rational(2), -1076))) == 0.0);
    CHECK(std::signbit(*nearest_double(Ball(-power(Rational(2), -1076)))));
    CHECK(*nearest_double(Ball(power(Rational(2), 1024))) == std::numeric_limits<double>::infinity());
    CHECK_FALSE(nearest_double(Ball::indeterminate()));
    CHECK(nearest_double(Ball(0)) == 0.0);
    CHECK_FALSE(nearest_double(around(0, power(Rational(2), -1100)))); // 0 or -0
}

TEST_CASE("the exact value of a ball: where it is one number, which is not so far out that its digits are none")
{
    const Rational small = 3 * power(Rational(2), -70), far = power(Rational(2), 4096);
    for (const Rational& r : {Rational(0), Rational(5), Rational(-small), far, Rational(-1 / far)}) CHECK(exact_value(Ball(r)) == r);
    CHECK_FALSE(exact_value(Ball(2 * far)));
    CHECK_FALSE(exact_value(Ball(1 / (2 * far))));
    CHECK_FALSE(exact_value(around(1, power(Rational(2), -100))));
    CHECK_FALSE(exact_value(Ball::indeterminate()));
}

TEST_CASE("a decimal is shown as it was typed where it is short or none, and else to so many digits")
{
    CHECK(shown_decimal("1.50", 4) == "1.50");
    CHECK(shown_decimal("1.504", 3) == "1.50");
    CHECK(shown_decimal("12345e-100", 5) == "12345e-100");
    CHECK(shown_decimal("0.123456789", 5) == "0.12346");
    CHECK(shown_decimal("no number", 3) == "no number");
}

TEST_CASE("hexfloats are C99's, whatever the C library prints")
{
    CHECK(hexfloat(0.1) == "0x1.999999999999ap-4");
    CHECK(hexfloat(-1.0) == "-0x1p+0");
    CHECK(std::strtod(hexfloat(5e-324).c_str(), nullptr) == 5e-324);
    CHECK(hexfloat(std::numeric_limits<double>::infinity()) == "inf");
    CHECK(hexfloat(std::nan("")) == "nan");
    CHECK(shortest(0.1) == "0.1");
}
