// SPDX-License-Identifier: MIT
#include "touchstone/scalar/exact_text.hpp"

#include <doctest/doctest.h>

#include <limits>

using namespace touchstone;

TEST_CASE("products and powers of radicals are exact")
{
    const Exact root2 = sqrt(Exact(2));
    CHECK_FALSE(root2.is_rational());
    CHECK((root2 * root2).rational() == 2);
    CHECK(sqrt(Exact(8)) == 2 * root2);
    CHECK((sqrt(Exact(8)) + root2 - 3 * root2).is_zero());
    CHECK(pow(Exact(4), Exact(Rational(1, 2))).rational() == 2);
    CHECK(pow(Exact(Rational(8, 27)), Exact(Rational(-2, 3))).rational() == Rational(9, 4));
    CHECK_THROWS_AS(root2 + 1, NotExact);
    CHECK_THROWS_AS(sqrt(Exact(-1)), NotExact);
    CHECK_THROWS_AS(Exact(1) / Exact(0), NotExact);
}

TEST_CASE("angles with exact sines are recognised, and no others")
{
    const Exact third = Exact(Rational(1, 3)), quarter = Exact(Rational(1, 4));
    CHECK(cos_pi(third).rational() == Rational(1, 2));
    CHECK((sin_pi(quarter) * sin_pi(quarter)).rational() == Rational(1, 2));
    CHECK(cos_pi(Exact(Rational(7, 3))).rational() == Rational(1, 2));
    CHECK(cos_pi(Exact(Rational(-4, 3))).rational() == Rational(-1, 2));
    CHECK_THROWS_AS(cos_pi(Exact(Rational(1, 5))), NotExact);
    CHECK(atan2(Exact(1), sqrt(Exact(3))) == pi<Exact>() / 6);
    CHECK(asin(Exact(Rational(1, 2))) == pi<Exact>() / 6);
    CHECK(acos(Exact(-1)) == pi<Exact>());
    CHECK_THROWS_AS(atan2(Exact(1), Exact(2)), NotExact);
}

TEST_CASE("Gamma at integers and half-integers")
{
    CHECK(gamma_function(Exact(5)).rational() == 24);
    const Exact g = gamma_function(Exact(Rational(5, 2)));
    CHECK(g == Exact(Rational(3, 4)) * sqrt(pi<Exact>()));
    CHECK_THROWS_AS(gamma_function(Exact(Rational(1, 3))), NotExact);
}

TEST_CASE("order is always decided")
{
    CHECK(less(sqrt(Exact(2)), Exact(Rational(141421357, 100000000))) == Truth::yes);
    CHECK(less(sqrt(Exact(4)), Exact(2)) == Truth::no);
    CHECK(less(pi<Exact>(), Exact(Rational(22, 7))) == Truth::yes);
}

TEST_CASE("the ball of an exact number contains it")
{
    const WorkingPrecision precision(200);
    const Exact x = sqrt(Exact(2)) * pi<Exact>() / 3;
    CHECK((x.ball() * x.ball()).overlaps(Ball(Rational(2, 9)) * touchstone::pi<Ball>() * touchstone::pi<Ball>()));
    CHECK(x.ball().relative_bits() > 190);
}

TEST_CASE("sizes that exactness is not worth are refused, not computed")
{
    CHECK_THROWS_AS(Exact(3).power(Rational(1, 1000003)), NotExact);
    CHECK_THROWS_AS(Exact(3).power(Rational(100000000)), NotExact);
    CHECK(Exact(1).power(Rational(1, 1000003)).rational() == 1);
}

TEST_CASE("a root is found by its least degree, in whatever form it is typed")
{
    const auto root = [](const char* text) { return as_root(*parse_exact(text)); };
    const auto is = [&](const char* text, const Rational& base, unsigned long degree) {
        const Root r = root(text);
        return r.base == base && r.degree == degree;
    };
    CHECK(is("sqrt(10)", Rational(10), 2));
    CHECK(is("8^(1/6)", Rational(2), 2));
    CHECK(is("3/sqrt(2)", Rational(9, 2), 2));
    CHECK(is("7^(2/14)", Rational(7), 7));
    CHECK(is("2^(1/4093)", Rational(2), 4093)); // a prime
    CHECK(is("3^.383", power(Rational(3), 383), 1000));
    CHECK(is("3^.999", power(Rational(3), 999), 1000)); // 3^(999 k) is too long for most k below 1000
    CHECK(is("sqrt(2)*2^(1/3)", Rational(32), 6));
    CHECK_THROWS_AS(Exact(3).power(Rational(std::numeric_limits<long>::min())), NotExact);
}
