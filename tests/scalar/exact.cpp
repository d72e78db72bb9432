// SPDX-License-Identifier: MIT
#include "touchstone/scalar/exact_text.hpp"

#include <doctest/doctest.h>

#include <limits>
#include <string>
#include <utility>

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
    const Exact y = 2 * sqrt(Exact(3)); // a factor beside the root
    CHECK(sqrt(y) * sqrt(y) == y);
    CHECK(pi<Exact>().power(Rational(2)) == pi<Exact>() * pi<Exact>());
    CHECK(powm1(Exact(4), Exact(Rational(1, 2))).rational() == 1);
    CHECK_FALSE(Exact(1) == Exact(0));
    CHECK_FALSE(Exact(0) == Exact(1));
}

TEST_CASE("angles with exact sines are recognised, and no others")
{
    const Exact third = Exact(Rational(1, 3)), quarter = Exact(Rational(1, 4));
    CHECK(cos_pi(third).rational() == Rational(1, 2));
    CHECK((sin_pi(quarter) * sin_pi(quarter)).rational() == Rational(1, 2));
    CHECK(sin_pi(Exact(Rational(1, 6))).rational() == Rational(1, 2));
    CHECK(sin_pi(Exact(Rational(-1, 6))).rational() == Rational(-1, 2));
    CHECK(cos_pi(Exact(Rational(7, 3))).rational() == Rational(1, 2));
    CHECK(cos_pi(Exact(Rational(-4, 3))).rational() == Rational(-1, 2));
    CHECK_THROWS_AS(cos_pi(Exact(Rational(1, 5))), NotExact);
    CHECK(atan2(Exact(1), sqrt(Exact(3))) == pi<Exact>() / 6);
    CHECK(asin(Exact(Rational(1, 2))) == pi<Exact>() / 6);
    CHECK(acos(Exact(-1)) == pi<Exact>());
    CHECK(atan2(Exact(1), Exact(-1)) == 3 * pi<Exact>() / 4);
    CHECK_THROWS_AS(atan2(Exact(1), Exact(2)), NotExact);
    CHECK_THROWS_AS(atan2(sqrt(Exact(2)), Exact(1)), NotExact);
    CHECK(atan2(Exact(3), Exact(0)) == pi<Exact>() / 2);
    CHECK(atan2(Exact(-3), Exact(0)) == -pi<Exact>() / 2);
    CHECK_THROWS_AS(atan2(Exact(0), Exact(0)), NotExact);
}

TEST_CASE("logarithms, exponentials and powers of two have exact values where they are said to")
{
    CHECK(log(Exact(1)) == Exact(0));
    CHECK_THROWS_AS(log(Exact(2)), NotExact);
    CHECK(exp(Exact(0)) == Exact(1));
    CHECK_THROWS_AS(exp(Exact(1)), NotExact);
    CHECK(ScalarTraits<Exact>::power_of_two(5) == Exact(32));
    CHECK(ScalarTraits<Exact>::power_of_two(-3) == Exact(Rational(1, 8)));
}

TEST_CASE("the cosines of all angles that have exact ones, on the whole circle")
{
    const Exact half(Rational(1, 2)), root_half = sqrt(half), root_three_quarters = sqrt(Exact(Rational(3, 4)));
    const std::pair<Rational, Exact> first[] = {
        {0, 1}, {Rational(1, 6), root_three_quarters}, {Rational(1, 4), root_half}, {Rational(1, 3), half}, {Rational(1, 2), 0}};
    for (const auto& [angle, cosine] : first) {
        CAPTURE(angle.get_str());
        for (const int turns : {-2, 0, 2, 4}) {
            CHECK(cos_pi(Exact(Rational(turns + angle))) == cosine);
            CHECK(cos_pi(Exact(Rational(turns - angle))) == cosine);
            CHECK(cos_pi(Exact(Rational(turns + 1 - angle))) == -cosine);
            CHECK(cos_pi(Exact(Rational(turns + 1 + angle))) == -cosine);
        }
    }
}

TEST_CASE("Gamma at integers and half-integers")
{
    CHECK(gamma_function(Exact(5)).rational() == 24);
    const Exact g = gamma_function(Exact(Rational(5, 2)));
    CHECK(g == Exact(Rational(3, 4)) * sqrt(pi<Exact>()));
    CHECK_THROWS_AS(gamma_function(Exact(Rational(1, 3))), NotExact);
    for (const long pole : {0, -1, -1001}) CHECK_THROWS_AS(gamma_function(Exact(pole)), NotExact);
    CHECK((gamma_function(Exact(1000)) / gamma_function(Exact(999))).rational() == 999);
    CHECK_THROWS_AS(gamma_function(Exact(1001)), NotExact);
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
    CHECK_THROWS_AS(Exact(3).power(Rational(2000000)), NotExact); // 3 has two bits
    CHECK_THROWS_AS(Exact(3).power(Rational(power(Rational(2), 64) + 1)), NotExact);
    CHECK(Exact(1).power(Rational(1, 1000003)).rational() == 1);
    CHECK(Exact(1).power(Rational(100000000)).rational() == 1);
    const Exact highest = Exact(3).power(Rational(1, 4096));
    CHECK((highest * 2).degree() == 4096);
    CHECK_THROWS_AS(highest * Exact(3).power(Rational(1, 4095)), NotExact);
    CHECK_THROWS_AS(sqrt(highest), NotExact);
}

TEST_CASE("a product of powers is read to its end or refused")
{
    CHECK(parse_exact("1e-3*2")->rational() == Rational(1, 500));
    CHECK(parse_exact("1E+3*2")->rational() == 2000);
    CHECK(parse_exact("0x1p-1*4")->rational() == 2);
    CHECK(parse_exact("0X1p-1*4")->rational() == 2);
    const auto nested = [](std::size_t brackets) { return std::string(brackets, '(') + "1" + std::string(brackets, ')'); };
    CHECK(parse_exact(nested(49))->rational() == 1);
    CHECK_FALSE(parse_exact(nested(50)));
    CHECK_FALSE(parse_exact("2*3-1"));
    CHECK_FALSE(parse_exact("1e*2"));
}

TEST_CASE("a root is found by its least degree, in whatever form it is typed")
{
    const auto root = [](const char* text) { return as_root(*parse_exact(text)); };
    const auto is = [&](const char* text, const Rational& base, unsigned long degree) {
        const Root r = root(text);
        return r.base == base && r.degree == degree;
    };
    CHECK(is("sqrt(10)", Rational(10), 2));
    CHECK(is("-3/2", Rational(-3, 2), 1)); // a rational number is its own root
    CHECK(is("4^(1/2)", Rational(2), 1));
    CHECK(is("8^(1/6)", Rational(2), 2));
    CHECK(is("3/sqrt(2)", Rational(9, 2), 2));
    CHECK(is("7^(2/14)", Rational(7), 7));
    CHECK(is("2^(1/4093)", Rational(2), 4093)); // a prime
    CHECK(is("3^.383", power(Rational(3), 383), 1000));
    CHECK(is("3^.999", power(Rational(3), 999), 1000)); // 3^(999 k) is too long for most k below 1000
    CHECK(is("sqrt(2)*2^(1/3)", Rational(32), 6));
    CHECK_THROWS_AS(Exact(3).power(Rational(std::numeric_limits<long>::min())), NotExact);
}
