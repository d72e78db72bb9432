// SPDX-License-Identifier: MIT
// Ranges that doubles do not hold, what has no value at all, and what is said of a reversed range.
#include "touchstone/quadrature/integrate.hpp"

#include <doctest/doctest.h>

using namespace touchstone;
using namespace touchstone::quadrature;

namespace {

Integral over(const char* formula, const char* from, const char* to, long digits)
{
    IntegralOptions options;
    options.digits = digits;
    return integrate(parse_expression(formula), parse_limit(from), parse_limit(to), options);
}

} // namespace

TEST_CASE("a range may be smaller than any double: the discs about its ends are what they are said to be")
{
    const WorkingPrecision precision(2600); // the root cancels as many digits as the range has zeros
    const Ball a = Ball(Rational(4)) * pow(Ball(10), Ball(-323)), c = pow(Ball(10), Ball(-324));
    const Ball truth = (a * sqrt(a * a + c * c) + c * c * log(a / c + sqrt(1 + a * a / (c * c)))) / 2 - c * a;
    for (const long digits : {30L, 60L, 100L}) {
        CAPTURE(digits);
        const Integral i = over("sqrt(x^2+1e-648)-1e-324", "0", "4e-323", digits);
        REQUIRE(i.value.is_finite());
        CHECK(i.value.overlaps(truth));
    }
    const Integral small =
        over("(1-cos(x))/x^2", "0", "1e-400", 30); // what cancels is more than the digits asked for: few are proven, or none
    CHECK((!small.value.is_finite() || small.value.overlaps(pow(Ball(10), Ball(-400)) / 2)));
    const Integral plain = over("exp(x)*sqrt(x)", "0", "1e-400", 30);
    CHECK(plain.status == Status::certified);
    CHECK(plain.value.overlaps(Ball(2) / Ball(3) * pow(Ball(10), Ball(-600)) * (1 + pow(Ball(10), Ball(-400)))));
}

TEST_CASE("a range may be larger than any double")
{
    const Integral far = over("1/(2+x)", "0", "1e309", 20);
    CHECK(far.status == Status::certified);
    const WorkingPrecision precision(256);
    CHECK(far.value.overlaps(log((2 + pow(Ball(10), Ball(309))) / 2)));
    const Integral bell = over("1/(1+x^2)", "0", "1e309", 20);
    CHECK((!bell.value.is_finite() || bell.value.overlaps(pi<Ball>() / 2)));
}

TEST_CASE("what has no value has no power, not even the zeroth")
{
    for (const char* formula : {"(1/0)^0", "(x/(x-x))^0", "x+(log(0))^0", "(1/(x-x))^0+x"}) {
        CAPTURE(std::string(formula));
        try {
            CHECK_FALSE(over(formula, "0", "1", 20).value.is_finite());
        }
        catch (const ExpressionError&) { // or it is refused as it is read
        }
    }
    for (const char* formula : {"x^0", "log(x)^0", "(1/x)^0", "sin(x)^0"}) {
        CAPTURE(std::string(formula));
        const Integral one = over(formula, "0", "1", 20);
        CHECK(one.status == Status::certified);
        CHECK(one.value.contains(Rational(1)));
    }
}

TEST_CASE("what is said of a reversed range has its sign")
{
    for (const bool folded : {false, true}) {
        IntegralOptions options;
        options.digits = 10;
        if (folded) options.principal_value = {parse_limit("0")};
        const Parameters known{{"a", parse_parameter("1+/-1e-3")}};
        const ExpressionPtr e = parse_expression(folded ? "exp(x+a)/x" : "x^a", known);
        const Integral i = integrate(e, parse_limit(folded ? "2" : "1"), parse_limit(folded ? "-1" : "0"), options);
        CAPTURE(i.reason);
        CHECK(i.status == Status::undecided);
        CHECK(arb_is_negative(i.value.get()));
        CHECK(i.reason.find("lies in [-") != std::string::npos);
    }
}
