// SPDX-License-Identifier: MIT
#include "touchstone/scalar/rational.hpp"
#include "touchstone/scalar/rational_text.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <random>

using namespace touchstone;

TEST_CASE("exact numbers are read exactly")
{
    CHECK(*parse_rational("12") == 12);
    CHECK(*parse_rational("-0.1") == Rational(-1, 10));
    CHECK(*parse_rational("1/3") == Rational(1, 3));
    CHECK(*parse_rational("0.5/1.5") == Rational(1, 3));
    CHECK(*parse_rational("1e-300") == power(Rational(10), -300));
    CHECK(*parse_rational("2.5E3") == 2500);
    CHECK(*parse_rational("0x1.8p-3") == Rational(3, 16));
    CHECK(*parse_rational("0x.8p1") == 1);
    CHECK(*parse_rational("0xff") == 255);
    CHECK(*parse_rational(".5") == Rational(1, 2));
    CHECK(*parse_rational("5.") == 5);
}

TEST_CASE("what is not a number is refused")
{
    for (const char* text : {"",   " ",      "1 ",  " 1",  "abc",        "1e",    "1e+", "--1",         "1..2", "1/0", "1/-3",
                             "0x", "0x1e5p", "inf", "nan", "1e10000001", "1/2/3", "1,5", "0x1.8e3p1.5", ".",    "1x5"})
        CHECK_FALSE_MESSAGE(parse_rational(text).has_value(), "'" << text << "'");
}

TEST_CASE("what is wrong with a number is said")
{
    CHECK(parse_rational("1e1000000"));
    CHECK_FALSE(parse_rational("1e1000001"));
    const std::string other = why_not_rational("abc");
    for (const char* text : {"1e", "1e+", "1ez", "1ez5", "1e+z5", "x/3", "/3", "3/", "1/2/3", "0x1p", "1e1e1000001", "abce5"}) {
        CAPTURE(text);
        CHECK(why_not_rational(text) == other);
    }
    const std::string beyond = why_not_rational("1e1000001");
    CHECK(beyond == "has an exponent beyond 1000000");
    for (const char* text : {"1e+1000001", "-1e-1000001", "1e2000000/3", "3/1e2000000", "0x1p9999999"}) {
        CAPTURE(text);
        CHECK(why_not_rational(text) == beyond);
    }
    CHECK(why_not_rational("1/0") == "has 0 as its denominator");
    CHECK(why_not_rational("1/-3").starts_with("has a negative denominator"));
    CHECK(why_not_rational("").starts_with("is empty"));
}

TEST_CASE("nearest double agrees with the hardware's own rounding, subnormals and ties included")
{
    std::mt19937_64 random(20000101);
    for (int i = 0; i < 2000; ++i) {
        const auto word = random();
        double x;
        static_assert(sizeof x == sizeof word);
        __builtin_memcpy(&x, &word, sizeof x);
        if (!std::isfinite(x)) continue;
        const Rational r = exact_rational(x);
        CHECK(nearest_double(r) == x);
        // a quarter of the way to the neighbour still rounds to x, the midpoint to the even one
        const double up = std::nextafter(x, std::numeric_limits<double>::infinity());
        if (!std::isfinite(up)) continue;
        const Rational gap = exact_rational(up) - r;
        CHECK(nearest_double(r + gap / 4) == x);
        CHECK(nearest_double(r + 3 * gap / 4) == up);
        const double middle = nearest_double(r + gap / 2);
        std::uint64_t bits;
        __builtin_memcpy(&bits, &middle, sizeof bits);
        CHECK(bits % 2 == 0);
    }
    CHECK(nearest_double(power(Rational(10), 400)) == std::numeric_limits<double>::infinity());
    CHECK(nearest_double(power(Rational(10), -400)) == 0.0);
}

TEST_CASE("terminating expansions and exact roots")
{
    CHECK(*terminating_digits(Rational(1, 8)) == 3);
    CHECK(*terminating_digits(Rational(1200)) == 2);
    CHECK(*terminating_digits(Rational(1, 5)) == 1);
    CHECK(*terminating_digits(Rational(3, 40)) == 2);
    CHECK(*terminating_digits(Rational(0)) == 1);
    CHECK_FALSE(terminating_digits(Rational(1, 3)));
    CHECK_FALSE(terminating_digits(Rational(1, 6)));
    CHECK(*exact_root(Rational(0), 2) == 0);
    CHECK_FALSE(exact_root(Rational(-4), 2));
    CHECK(*exact_root(Rational(27, 8), 3) == Rational(3, 2));
    CHECK_FALSE(exact_root(Rational(2), 2));
    CHECK(power(Rational(2, 3), -2) == Rational(9, 4));
}
