// SPDX-License-Identifier: MIT
// What was once refused, or took a minute, for no good reason: each against a value that was had in another way (mpmath, 50 digits).
#include "touchstone/quadrature/expression_tree.hpp"
#include "touchstone/quadrature/integrate.hpp"

#include <doctest/doctest.h>

#include <algorithm>

using namespace touchstone;
using namespace touchstone::quadrature;

namespace {

Integral over(const char* formula, const char* from, const char* to, long digits = 15)
{
    IntegralOptions options;
    options.digits = digits;
    return integrate(parse_expression(formula), parse_limit(from), parse_limit(to), options);
}

/// Certified, and within 1e-20 (relative) of a value whose decimals are right that far.
Integral check(const char* formula, const char* from, const char* to, const char* decimals)
{
    const Integral found = over(formula, from, to);
    CAPTURE(std::string(formula));
    INFO(found.reason);
    CHECK(found.status == Status::certified);
    const WorkingPrecision precision(256);
    const Ball known = parse_limit(decimals).ball();
    Ball about = known;
    const Ball slack = abs(known) * pow(Ball(10), Ball(-20));
    arb_add_error(about.get(), slack.get());
    CHECK(found.value.overlaps(about));
    return found;
}

} // namespace

TEST_CASE("a range is cut at a simple fraction of it where the formula is singular there, whatever the scale of x")
{
    const Integral scaled = over("(7*x)^(-2/3)*ellipe(28*x*(1-7*x))^(1/3)", "0", "1/7");
    const Integral plain = over("x^(-2/3)*ellipe(4*x*(1-x))^(1/3)", "0", "1");
    CHECK(scaled.status == Status::certified);
    CHECK(scaled.parts.size() == 2);
    CHECK((7 * scaled.value).overlaps(plain.value));
    // the singular point is where a bisection cuts: what a part says of its end is not said of the range's
    const Integral shifted =
        check("log(ellipk(2*(1000*(x-1000))/(1+(1000*(x-1000))^2)))", "1000", "1000.002", "0.00195614843293699883253661681877");
    CHECK(shifted.parts.size() == 2);
}

TEST_CASE("the ends of a narrow range are told apart, and x is counted from one of them")
{
    check("exp(x)", "1", "1+1e-80", "e*1e-80"); // to 80 digits
    check("exp(x)", "1+1e-80", "1", "-e*1e-80");
    check("(x-pi)^(-1/3)", "pi", "pi+1e-15", "1.5e-10");
    check("(1-cos(x-1))/(x-1)^2", "1", "1+1e-20", "5e-21");
    check("log(1+x-2)/(x-2)", "2", "2+1e-20", "1e-20*(1-1e-20/4)");
    check("(2+1e-20-x)^(-1/2)", "2", "2+1e-20", "2e-10");
    check("abs(x-1-1e-80)*1e160", "1", "1+2e-80", "1"); // with its kink inside
    // ends that are no exact numbers are sharpened by as many digits as cancel
    const Integral rough = over("exp(x)", "exp(1)", "exp(1)+1e-15");
    CHECK(rough.status == Status::certified);
    CHECK(rough.value.overlaps(parse_limit("exp(exp(1))*(exp(1e-15)-1)").ball()));
    check("(x-exp(1)+1)^(-1/3)", "exp(1)", "exp(1)+1e-15", "(3/2)*((1+1e-15)^(2/3)-1)");
    // what is no number a < b is still refused
    CHECK_THROWS_AS(over("x", "exp(log(2))", "2"), DomainError);
    IntegralOptions beyond;
    beyond.at = {parse_limit("1+2e-80")};
    CHECK_THROWS_AS(integrate(parse_expression("x"), parse_limit("1"), parse_limit("1+1e-80"), beyond), DomainError);
}

TEST_CASE("beside a small range a zero is expanded on a disc as large as the formula allows")
{
    check("x/(exp(x)-1)", "0", "1e-20", "1e-20*(1-1e-20/4)");
    check("x/log(1+x)", "0", "1e-20", "1e-20*(1+1e-20/4)");
    check("x^2/(1-cos(x))", "0", "1e-30", "2e-30");
    check("(exp(x)-1)^(-1/2)", "0", "1e-30", "2e-15");
    check("sqrt(1-cos(x))", "0", "1e-400", "1e-800/sqrt(8)");
    check("(1-cos(x))/x^2", "0", "1e-400", "5e-401");
    // the formula's own scale, between that of the range and 1
    check("x/(exp(1e10*x)-1)", "0", "1e-20", "1e-30*(1-1e-10/4+1e-20/36)");
    check("x/sin(1e25*x)", "0", "1e-26", "1.000555944737572892963228e-51");
    // a zero at the other end too, which the disc must not have in it
    check("(1e-20-x)^(1/2)/log(1+x)^(1/2)", "0", "1e-20", "(pi/2)*1e-20*(1+1e-20/8)");
    check("sqrt(log(1+x)*log(1+1e-20-x))", "0", "1e-20", "(pi/8)*1e-40*(1-1e-20/4)");
}

TEST_CASE("sinc has its zeros at an end, and its bound far out, as the sine has")
{
    check("sqrt(sinc(x))", "0", "pi", "2.27782121555060432213032256504");
    check("log(sinc(x))", "0", "pi", "-2.63226843644296709012404726660");
    check("sinc(x)^(-1/3)", "1", "pi", "3.47084947296994731083863214557");
    check("sqrt(sinc(x))", "-1", "pi", "3.25017614792570554779502547307"); // sin(x)/x would have no value at 0
    check("sqrt(sinc(pi*sqrt(x)))", "0", "1", "0.585275363940382076617249864828");
    check("sinc(x)*exp(-x)", "0", "inf", "pi/4");
    check("sinc(x)*exp(-x^2)", "-inf", "inf", "pi*erf(1/2)");
    check("sinc(x)*exp(-x)", "-1", "inf", "2.38776985151052241926279208910");
    check("sinc(x-1)*exp(x)", "-inf", "1", "e*pi/4");
}

TEST_CASE("the numbers of a sum are added up, so that 1 - (1 - g) vanishes with g, whatever root g is")
{
    check("ellipk(1-sqrt(x))", "0", "1", "16/9");
    check("ellipk(1-x^(1/3))", "0", "1", "128/75");
    check("ellipk(1-sqrt(x)/2)", "0", "1", "2.074192392111753059410580975231");
    check("ellipe(1-x^(1/3))", "0", "1", "256/175");
    check("acos(1-sqrt(x))", "0", "1", "2-pi/4");
    check("acos(1-2*sqrt(x))", "0", "1", "5*pi/8"); // -1 at the other end
    check("acosh(1+sqrt(x))", "0", "1", "1.0735718591064689392149231678519");
    check("atanh(1-sqrt(x))", "0", "1", "2*log(2)-1");
    check("asin(1-x^(1/3))", "0", "1", "0.26032415032057488141163756243271");
    check("asin(sqrt(x)-1)", "0", "1", "-0.356194490192344928846982537460");
    check("log(1-(1-sqrt(x)))", "0", "1", "-1/2");
    for (const char* beyond : {"acos(1+sqrt(x))", "acosh(1-sqrt(x))", "ellipk(1+sqrt(x))", "atanh(1+sqrt(x))", "log(1-(1+sqrt(x)))"}) {
        CAPTURE(std::string(beyond));
        CHECK(over(beyond, "0", "1").reason.find("on its cut") != std::string::npos);
    }
}

TEST_CASE("with its numbers collected a sum is the same function, and one without two of them is itself")
{
    for (const char* text : {"1-(1-x)", "2-(x-(3-x*x))-1", "-(1-(exp(x)-2))", "1+(x+(2+x))", "x-(-1-1)", "1/3-(1/3-x)"}) {
        CAPTURE(std::string(text));
        const ExpressionPtr e = parse_expression(text), collected = tree::with_numbers_collected(e);
        const Ball x(Rational(5, 7));
        CHECK(evaluate_at(*e, x).overlaps(evaluate_at(*collected, x)));
        const auto all = tree::summands(collected);
        CHECK(std::count_if(all.begin(), all.end(), [](const ExpressionPtr& a) { return a->op == Op::number; }) <= 1);
    }
    for (const char* text : {"x", "x+1", "2*(1-x)", "sin(1-(1-x))"}) {
        const ExpressionPtr e = parse_expression(text);
        CHECK(tree::with_numbers_collected(e) == e);
    }
    CHECK(tree::with_numbers_collected(parse_expression("1-x-(1-x)+x-1+1"))->op == Op::add); // terms in x are not added up
}

TEST_CASE("what tends to 1 far out has its distance to 1 there, in elliptic integrals and inverse functions")
{
    check("ellipk(x/(1+x))/(1+x)^2", "0", "inf", "2");
    check("ellipk(1-1/x^2)/x^2", "1", "inf", "pi^2/4");
    check("ellipe(x/(1+x))/(1+x)^2", "0", "inf", "4/3");
    check("ellipk(tanh(x))*exp(-x)", "0", "inf", "2.27006328852826191366079454562");
    check("ellipk(x/(x-1))/(1-x)^2", "-inf", "0", "2");
    check("ellipk(x^2/(1+x^2))/(1+x^2)", "-inf", "inf", "2*3.43759290901018641374504788991");
    check("ellipk(1/(1+x^2))/(1+x^2)", "0", "inf", "3.43759290901018641374504788991"); // 1 at the finite end
    check("acos(x/(1+x))/(1+x)", "0", "inf", "2.92072423350623909535955147898");
    check("atanh(x/(1+x))/(1+x)^2", "0", "inf", "log(2)");
    check("acosh(1+1/x)/x", "1", "inf", "2.75867237188297002857647825988");
    check("asin(x/(1+x))/(1+x)^2", "0", "inf", "pi/2-1");
    CHECK(over("ellipk(1+1/x)/x^2", "1", "inf").status != Status::certified);
}

TEST_CASE("the elliptic integrals have their expansions at 0")
{
    const auto coefficients = [](const char* formula) { return expand(*parse_expression(formula), ExactSum(0), 1); };
    const ExactSum quarter_turn = ExactSum(Rational(1, 2)) * ExactSum::pi();
    const auto k = coefficients("ellipk(x)"), e = coefficients("ellipe(x)");
    REQUIRE((k && e));
    const std::vector<Rational> of_k{1, {1, 4}, {9, 64}, {25, 256}}, of_e{1, {-1, 4}, {-3, 64}, {-5, 256}}; // DLMF 19.5.1, 19.5.2
    for (std::size_t n = 0; n < of_k.size(); ++n) {
        CHECK(k->c[n] == ExactSum(of_k[n]) * quarter_turn);
        CHECK(e->c[n] == ExactSum(of_e[n]) * quarter_turn);
    }
    check("(ellipk(x)-pi/2)/x", "0", "1", "0.691309803898328200782963736746");
    check("(ellipk(x)-ellipe(x))/x", "0", "1", "pi-2");
    check("(ellipk(x)-ellipe(x))/x", "0", "1/2", "0.440304891494442233422293912602");
    check("sqrt(ellipk(x)-pi/2)", "0", "1", "0.575262996154970478038162730050");
    check("(ellipk(-x)-pi/2)/x", "0", "1", "-0.315328353041659662324909920010");
    check("(ellipk(sin(x)^2)-pi/2)/x", "0", "pi/4", "0.130752230387832485971431825641");
}

TEST_CASE("branches beyond the range are no cuts of it, and a cut is found beside an end that no exact number is")
{
    for (const char* formula : {"abs(x+1/2)", "abs(x-3/2)"}) {
        const Integral i = integrate(parse_expression(formula), parse_limit("0"), parse_limit("1"));
        CHECK(i.status == Status::certified);
        CHECK(i.parts.size() == 1);
        CHECK(i.value.contains(Ball(1)));
    }
    const Integral i = integrate(parse_expression("((x-1/3)^2)^(1/4)"), parse_limit("0"), parse_limit("log(2)"));
    CHECK(i.status == Status::certified);
    CHECK(i.parts.size() == 2);
    const Ball third = Ball(1) / Ball(3), beyond = log(Ball(2)) - third;
    CHECK(i.value.overlaps((third * sqrt(third) + beyond * sqrt(beyond)) * Ball(2) / Ball(3)));
}
