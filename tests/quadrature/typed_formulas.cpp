// SPDX-License-Identifier: MIT
// What a typed formula is made of: parser, exact constants, exact expansions, cuts; and that each says no where it must.
#include "touchstone/quadrature/integrate.hpp"

#include <doctest/doctest.h>

#include <string>

using namespace touchstone;
using namespace touchstone::quadrature;

namespace {

std::size_t column_of_error(const char* text)
{
    try {
        parse_expression(text);
    }
    catch (const ExpressionError& e) {
        return e.column();
    }
    return 0;
}

Ball at(const char* formula, const Rational& x) { return evaluate_at(*parse_expression(formula), Ball(x)); }

std::optional<ExactSeries> series(const char* formula, const ExactSum& centre, int direction = 1)
{
    return expand(*parse_expression(formula), centre, direction);
}

Integral integral(const char* formula, const char* from, const char* to, long digits = 30)
{
    return integrate(parse_expression(formula), parse_limit(from), parse_limit(to), {.digits = digits});
}

} // namespace

TEST_CASE("formulas are read with the usual precedence")
{
    CHECK(at("-x^2", 3).contains(Rational(-9)));
    CHECK(at("2^3^2", 0).contains(Rational(512)));
    CHECK(at("2**-1*x", 3).contains(Rational(3, 2)));
    CHECK(at("1-2-3", 0).contains(Rational(-4)));
    CHECK(at("8/4/2", 0).contains(Rational(1)));
    CHECK(at("-2^-2", 0).contains(Rational(-1, 4)));
    CHECK(at("0.1+1e-1", 0).contains(Rational(1, 5)));
    CHECK(at("max(x,2,min(7,5))", 3).contains(Rational(5)));
    CHECK(!at("log(x)", -1).is_finite());
}

TEST_CASE("a text that is no formula is refused at its column")
{
    CHECK(column_of_error("x*(1+") == 6);
    CHECK(column_of_error("2x") == 2);
    CHECK(column_of_error("x+foo(x)") == 3);
    CHECK(column_of_error("x+y") == 3);
    CHECK(column_of_error("sin x") == 1);
    CHECK(column_of_error("") == 1);
    CHECK(column_of_error("(x") == 3);
    CHECK(column_of_error("x)") == 2);
    CHECK(column_of_error("besselj(x)") == 1);
    CHECK(column_of_error("x^(1/2)") == 0);
    CHECK(column_of_error(std::string(5000, '(').c_str()) > 0);
}

TEST_CASE("exact constants: zero is recognised, and only zero")
{
    const ExactSum two = *ExactSum(2).sqrt(), three = *ExactSum(3).sqrt(), six = *ExactSum(6).sqrt();
    CHECK((two * three - six).is_zero());
    CHECK(((two + three) * (two + three) - ExactSum(5) - ExactSum(2) * six).is_zero());
    CHECK((*ExactSum(Rational(1, 8)).sqrt() * ExactSum(4) - two).is_zero());
    CHECK(!(two * three - six + ExactSum(1 / power(Rational(10), 300))).is_zero());
    CHECK(!(ExactSum(Rational(355, 113)) - ExactSum::pi()).is_zero());
    CHECK((ExactSum::pi(1) * ExactSum::pi(1) - ExactSum::pi()).is_zero());
    CHECK(!(two + three).inverse());
    const WorkingPrecision precision(200);
    CHECK((two + ExactSum::pi(-1)).ball().overlaps(sqrt(Ball(2)) + Ball(1) / sqrt(pi<Ball>())));
}

TEST_CASE("exact expansions begin where the function does")
{
    const auto first = [](const char* formula, const ExactSum& centre, int direction = 1) {
        const auto s = series(formula, centre, direction);
        return s && !s->c.empty() ? s->valuation : Rational(1000);
    };
    CHECK(first("1-cos(x)", 0) == 2);
    CHECK(series("1-cos(x)", 0)->c[0] == ExactSum(Rational(1, 2)));
    CHECK(first("x-sin(x)", 0) == 3);
    CHECK(first("exp(x)-1-x", 0) == 2);
    CHECK(first("log(x)", 1, -1) == 1);
    CHECK(series("log(x)", 1, -1)->c[0] == ExactSum(-1));
    CHECK(first("sin(x)", ExactSum::pi(), -1) == 1);
    CHECK(first("cos(x)", ExactSum(Rational(1, 2)) * ExactSum::pi(), -1) == 1);
    CHECK(first("sin(x)-cos(x)", ExactSum(Rational(1, 4)) * ExactSum::pi()) == 1);
    CHECK(first("1/x-1/(exp(x)-1)", 0) == 0);
    CHECK(first("sqrt(1-x^2)", 1, -1) == Rational(1, 2));
    CHECK(first("2-x^2", *ExactSum(2).sqrt(), -1) == 1);
    CHECK(first("tan(x)-x", 0) == 3);
    CHECK(first("atan(x)-asin(x)", 0) == 3);
    CHECK(first("lambertw(x)-x+x^2", 0) == 3);
    CHECK(first("besselj(2,x)", 0) == 2);
    CHECK(first("erf(x)", 0) == 1);
    // and none where there is none
    CHECK(!series("log(x)", 0));
    CHECK(!series("abs(x)", 0));
    CHECK(!series("exp(x)-exp(1)", 1));
    CHECK(!series("sqrt(x-1)", 0));
}

TEST_CASE("the coefficients of an expansion are those of the function")
{
    const WorkingPrecision precision(400);
    const Rational small(1, 1000);
    for (const char* formula : {"exp(x)-1", "log(1+x)", "tan(x)", "x/sinh(x)", "asin(x)", "atan(x)", "asinh(x)", "atanh(x)", "lambertw(x)",
                                "erf(x)", "sec(x)", "(1+x)^(1/3)", "besselj(1,x)", "tanh(x)", "1/(2-x)^2", "si(x)"}) {
        CAPTURE(formula);
        const auto s = series(formula, 0);
        REQUIRE(s);
        Ball sum(0);
        for (std::size_t k = s->c.size(); k-- > 0;) sum = sum * Ball(small) + s->c[k].ball();
        Ball difference = abs(at(formula, small) - sum * pow(Ball(small), Ball(s->valuation)));
        // what is left out is of the order of the next power
        CHECK(arb_lt(difference.get(), Ball(Rational(power(small, static_cast<long>(s->c.size()) - 1))).get()));
    }
}

TEST_CASE("the range is cut at kinks and steps, where they are exact")
{
    const auto cuts = [](const char* formula, const char* from, const char* to) {
        return branch_points(*parse_expression(formula), parse_limit(from), parse_limit(to));
    };
    CHECK(cuts("abs(x-1/3)", "0", "1") == std::vector{ExactSum(Rational(1, 3))});
    CHECK(cuts("abs(x)", "0", "1").empty());
    CHECK(cuts("floor(2*x)", "0", "2").size() == 3);
    CHECK(cuts("abs(sin(x))", "0", "7").size() == 2);
    CHECK(cuts("abs(x^2-2)", "0", "2") == std::vector{*ExactSum(2).sqrt()});
    CHECK_THROWS_AS(cuts("floor(1000000*x)", "0", "1"), DomainError);
}

TEST_CASE("integrals of what has no branch cut hidden from the proof")
{
    CHECK(integral("sqrt(x)", "-1", "1").status != Status::certified);
    CHECK(integral("log(x)", "-1", "1").status != Status::certified);
    CHECK(integral("asin(2*x)", "0", "1").status != Status::certified);
    CHECK(integral("1/(x^2-1/2)", "0", "1").status != Status::certified);
    CHECK(integral("gamma(x)", "-1/2", "1/2").status != Status::certified);
    CHECK(integral("exp(x)", "0", "inf").status != Status::certified);
    CHECK(integral("1/x", "1", "inf").status != Status::certified);
    CHECK(integral("exp(-x)*cosh(x)", "0", "inf").status != Status::certified);
    CHECK(integral("1/(x-1/3)", "0", "1").divergent);
    CHECK(integral("x^(-1)", "0", "1").divergent);
    CHECK(integral("1/(1-cos(x))", "0", "1").divergent);
    CHECK(integral("(1-cos(x))/x^3", "0", "1").divergent);
    CHECK(!integral("(1-cos(x))/x^2.9", "0", "1").divergent);
}

TEST_CASE("parts are added at the precision of the digits asked for")
{
    IntegralOptions options;
    options.digits = 200;
    options.at = {parse_limit("1/3"), parse_limit("log(2)")};
    const Integral e = integrate(parse_expression("exp(x)"), parse_limit("0"), parse_limit("1"), options);
    CHECK(e.status == Status::certified);
    CHECK(e.parts.size() == 3);
    const WorkingPrecision precision(900);
    CHECK(e.value.overlaps(exp(Ball(1)) - Ball(1)));
    CHECK(e.value.relative_bits() > 664);
}

TEST_CASE("both rules agree where both serve")
{
    for (const char* formula : {"exp(x)", "cos(10*x)", "1/(1+x^2)", "x/(exp(x)-1)", "(1-cos(x))/x^2", "gamma(1+x)", "besselj(0,5*x)"}) {
        CAPTURE(formula);
        const Integral one = integral(formula, "0", "1", 40);
        const Integral other = integrate(parse_expression(formula), parse_limit("0"), parse_limit("1"),
                                         {.digits = 40, .at = {}, .tolerance = {}, .gauss_legendre = false});
        CHECK(one.parts.at(0).rule == "gauss-legendre");
        CHECK(other.parts.at(0).rule == "tanh-sinh");
        CHECK(other.status == Status::certified);
        CHECK(one.value.overlaps(other.value));
    }
}
