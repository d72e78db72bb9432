// SPDX-License-Identifier: MIT
// An integral is the sum of its parts, wherever the range is cut, in whichever variable a part is taken and in whichever direction: against
// closed forms, with the digits that are claimed.
#include "touchstone/quadrature/integrate.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>

using namespace touchstone;
using namespace touchstone::quadrature;

namespace {

IntegralOptions with_digits(long digits)
{
    IntegralOptions o;
    o.digits = digits;
    return o;
}

Integral integral(const char* formula, const char* from, const char* to, const IntegralOptions& options = with_digits(20),
                  const Parameters& parameters = {})
{
    return integrate(parse_expression(formula, parameters), parse_limit(from), parse_limit(to), options);
}

/// Certified, right, and as sharp as is said.
void is(const Integral& i, const char* truth, long digits = 20)
{
    CAPTURE(std::string(truth));
    CHECK_MESSAGE(i.status == Status::certified, i.reason);
    CHECK(i.digits == digits);
    const WorkingPrecision precision(400);
    const Ball value = truth[0] == '\0' ? Ball(0) : parse_limit(truth).ball();
    CHECK_MESSAGE(i.value.overlaps(value), i.value.to_string(20), " is not ", value.to_string(20));
    CHECK(i.value.relative_bits() >= static_cast<slong>(3.3219 * static_cast<double>(digits)));
}

} // namespace

TEST_CASE("essential singularities at both ends, or at one of a half-line, each beside its own end in the inverse distance")
{
    is(integral("exp(-1/x-1/(1-x))", "0", "1"), "2*exp(-2)*(besselk(1,2)-besselk(0,2))");
    is(integral("exp(-1/(x-1)-1/(3-x))", "1", "3"), "2*exp(-1)*(besselk(1,1)-besselk(0,1))");
    is(integral("exp(1/x-1/(x+2))", "-2", "0"), "2*exp(-1)*(besselk(1,1)-besselk(0,1))");
    is(integral("exp(-1/(x-5)-1/(6-x))", "5", "6"), "2*exp(-2)*(besselk(1,2)-besselk(0,2))");
    is(integral("exp(-1/(x+6)+1/(x+5))", "-6", "-5"), "2*exp(-2)*(besselk(1,2)-besselk(0,2))");
    is(integral("exp(-1/(x-2)-x)", "2", "inf"), "2*exp(-2)*besselk(1,2)");
    is(integral("exp(1/(x+2)+x)", "-inf", "-2"), "2*exp(-2)*besselk(1,2)");
}

TEST_CASE("a wave beside one end and an essential singularity at the other: two halves, wherever the range lies and whichever end is which")
{
    const Integral one = integral("sin(1/x)*exp(-1/(2-x))", "0", "2");
    for (const auto& [formula, from, to] : {std::tuple("sin(1/(x-1))*exp(-1/(3-x))", "1", "3"),
                                            {"sin(1/(x-5))*exp(-1/(7-x))", "5", "7"},
                                            {"sin(1/(x+7))*exp(1/(x+5))", "-7", "-5"},
                                            {"sin(1/(3-x))*exp(-1/(x-1))", "1", "3"},
                                            {"sin(1/(9-x))*exp(-1/(x-7))", "7", "9"},
                                            {"-sin(1/(x+7))*exp(-1/(x+9))", "-9", "-7"}}) {
        CAPTURE(std::string(formula));
        const Integral other = integral(formula, from, to);
        CHECK_MESSAGE(other.status == Status::certified, other.reason);
        CHECK(other.value.overlaps(one.value));
        CHECK(other.parts.size() > 1);
    }
    is(integral("exp(-sqrt(x))", "4", "inf"), "6*exp(-2)");
    is(integral("x*exp(-x^2)", "2", "inf"), "exp(-4)/2");
    is(integral("x*exp(-x^2)", "-inf", "-2"), "-exp(-4)/2");
}

TEST_CASE("a range that is run through backwards has the negative of both parts, whichever of its ends is infinite")
{
    is(integral("exp(-x)", "inf", "1"), "-exp(-1)");
    is(integral("exp(x)", "1", "-inf"), "-exp(1)");
    is(integral("exp(-x^2)", "inf", "-inf"), "-sqrt(pi)");
    const Integral complex = integral("exp(i*x)", "1", "0");
    is(complex, "-sin(1)");
    CHECK(complex.is_complex);
    CHECK(complex.imaginary.overlaps(parse_limit("cos(1)-1").ball()));
    CHECK(complex.imaginary.relative_bits() > 60);
}

TEST_CASE("a range without length holds nothing, and ends that cannot be told apart are refused")
{
    for (const char* end : {"0", "1", "pi", "-sqrt(2)"}) {
        const Integral nothing = integral("1/x", end, end);
        CHECK(nothing.status == Status::certified);
        CHECK(nothing.digits == 20);
        CHECK(nothing.value.is_exact());
        CHECK(nothing.value.contains_zero());
    }
    CHECK_THROWS_AS(integral("x", "zeta(3)", "zeta(3)"), DomainError);
    is(integral("x", "1", "zeta(3)"), "(zeta(3)^2-1)/2");
    is(integral("x", "zeta(3)", "1"), "(1-zeta(3)^2)/2");
    is(integral("x", "zeta(3)", "zeta(5)"), "(zeta(5)^2-zeta(3)^2)/2");
}

TEST_CASE("tails that oscillate begin anywhere, and have parts that do not")
{
    is(integral("sin(x)/x", "1/2", "inf"), "pi/2-si(1/2)");
    is(integral("sin(x)/x", "zeta(3)", "inf"), "pi/2-si(zeta(3))");
    is(integral("sin(x)/x", "-5/2", "inf"), "pi/2+si(5/2)");
    is(integral("sin(x)/x", "-inf", "-7/3"), "pi/2-si(7/3)");
    is(integral("(1+cos(x))/x^2", "3/2", "inf"), "2/3+cos(3/2)/(3/2)+si(3/2)-pi/2");
    is(integral("(sin(x)^2+1/x)/x^2", "2", "inf"), "1/8+1/4-(cos(4)/2+2*si(4)-pi)/2");
    is(integral("cos(x)/(x+40)", "0", "inf"), "-cos(40)*ci(40)+sin(40)*(pi/2-si(40))");
    // ends that cannot be mirrored, nor gone on from, exactly
    for (const auto& [formula, from, to] : {std::tuple("sin(x)/x", "-inf", "-zeta(3)"),
                                            {"x*sin(x)", "zeta(3)", "inf"},
                                            {"exp(sin(x))/x", "zeta(3)", "inf"},
                                            {"x*cos(x^2)", "-inf", "-zeta(3)"},
                                            {"exp(-1/(zeta(3)-x))", "1", "zeta(3)"},
                                            {"exp(-x^2)*abs(x-zeta(3))^x", "-zeta(3)", "inf"}}) {
        CAPTURE(std::string(formula));
        const Integral inexact = integral(formula, from, to);
        CHECK(inexact.status != Status::certified);
        CHECK_FALSE(inexact.reason.empty());
    }
}

TEST_CASE("parts that cancel are repeated until the digits are those of the sum")
{
    IntegralOptions cut = with_digits(20);
    cut.at = {parse_limit("0")};
    is(integral("x", "-1", "1+1e-30", cut), "1e-30+5e-61");
    is(integral("sign(x)*exp(-abs(x))", "-1", "1+1e-9", cut), "exp(-1)-exp(-1-1e-9)");
    cut.at = {parse_limit("1/3"), parse_limit("-1/3")};
    is(integral("x^3", "-1", "1+1e-12", cut), "((1+1e-12)^4-1)/4");
}

TEST_CASE("an absolute error that is asked for is enough, and none that is larger")
{
    const Parameters parameters{{"a", {Rational(1, 2), Rational(1, 1000000)}}};
    for (const char* formula : {"x^a", "x^a+i*x^a"})
        for (const auto& [tolerance, enough] :
             {std::pair(Rational(1, 1000), true), {Rational(1, 100000), true}, {Rational(1, 10000000), false}}) {
            CAPTURE(std::string(formula));
            CAPTURE(tolerance.get_str());
            IntegralOptions o = with_digits(20);
            o.tolerance = tolerance;
            const Integral i = integral(formula, "0", "1", o, parameters); // the error is some 4e-7
            CHECK((i.status == Status::certified) == enough);
            CHECK(i.reason.empty() == enough);
            CHECK(i.value.radius_bound() < 1e-6);
        }
}

TEST_CASE("the digits said to be proven are those of the ball, of a complex value those of its modulus")
{
    for (const long exponent : {4L, 7L, 11L}) {
        const Parameters parameters{{"a", {Rational(3), 1 / power(Rational(10), exponent)}}};
        for (const auto& [formula, complex] : {std::pair("a*x", false), {"a*x+i*1000*x", true}, {"1000*x+i*a*x", true}}) {
            CAPTURE(std::string(formula));
            const Integral i = integral(formula, "0", "1", with_digits(20), parameters);
            CHECK(i.status == Status::undecided);
            CHECK(i.is_complex == complex);
            // radius 10^-exponent/2 beside 3/2 or 500
            const double digits = static_cast<double>(exponent) + (complex ? 3 : std::log10(3.));
            CHECK(static_cast<double>(i.digits) <= digits + 0.01);
            CHECK(static_cast<double>(i.digits) >= digits - 2);
            CHECK(i.reason.find("only " + std::to_string(i.digits) + " of 20 digits proven") == 0);
            CHECK((i.reason.find(" + i ") != std::string::npos) == complex);
        }
    }
    const Parameters about_zero{{"a", {Rational(0), Rational(1, 100)}}};
    const Integral none = integral("a*x", "0", "1", with_digits(20), about_zero);
    CHECK(none.digits == 0);
    CHECK(none.reason.find("none of 20 digits proven") == 0);
    CHECK(none.reason.find("--tolerance") != std::string::npos);
}

TEST_CASE("what diverges at an end is said with its power there")
{
    const auto reason = [](const char* formula, const char* from, const char* to) {
        const Integral i = integral(formula, from, to);
        CHECK(i.divergent);
        CHECK(i.status == Status::indeterminate);
        return i.reason;
    };
    const auto has = [](const std::string& text, const char* part) { return text.find(part) != std::string::npos; };
    CHECK(has(reason("x^(-3)", "0", "1"), "diverges at x = 0: the formula behaves there like |x - 0|^-3"));
    CHECK(has(reason("(x-1)^(-3/2)", "1", "2"), "diverges at x = 1: the formula behaves there like |x - 1|^(-3/2)"));
    CHECK_FALSE(has(reason("x^(-2)", "0", "1"), "--principal-value"));
    CHECK(has(reason("1/x", "0", "1"), "|x - 0|^-1 (inside the range, --principal-value 0"));
    CHECK(has(reason("1/(1-x)", "0", "1"), "diverges at x = 1"));
    CHECK(has(reason("sqrt(x)", "1", "inf"), "diverges at x = inf: the formula behaves there like |x|^(1/2)"));
    CHECK(has(reason("x/(1+x^2)", "1", "inf"), "diverges at x = inf: the formula behaves there like |x|^-1"));
    CHECK(has(reason("1+0*x", "-inf", "1"), "diverges at x = -inf: the formula behaves there like |x|^0"));
    for (const auto& [formula, from, to] :
         {std::tuple("x^(-1/2)*abs(x-1/2)", "0", "1"), {"1/x^2", "1", "inf"}, {"x^2/x^(7/2)", "1", "inf"}}) {
        CAPTURE(std::string(formula));
        CHECK_FALSE(integral(formula, from, to).divergent);
    }
}

namespace {

/// The range is cut, untold, at the point with a name where the proof stops, and the sum is that of the range which is told to be cut
/// there.
void is_cut_at(const char* cut, const char* formula, const char* from, const char* to)
{
    CAPTURE(std::string(formula));
    IntegralOptions told = with_digits(10);
    const Integral found = integral(formula, from, to, told);
    told.at = {parse_limit(cut)};
    const Integral same = integral(formula, from, to, told);
    CHECK_MESSAGE(found.status == Status::certified, found.reason);
    CHECK(same.status == Status::certified);
    CHECK(found.value.overlaps(same.value));
    CHECK(std::any_of(found.parts.begin(), found.parts.end(), [&](const Part& p) { return p.from == cut; }));
}

} // namespace

TEST_CASE("where a proof stops is found in x, and the range cut there, if what it is taken in is a fraction or algebraic in one")
{
    is_cut_at("7/3", "cbrt((x-7/3)^2)", "1", "3");
    is_cut_at("7/3", "cbrt((x-7/3)^2)/x^4", "1", "inf");
    is_cut_at("-7/3", "cbrt((x+7/3)^2)/x^4", "-inf", "-1");
    is_cut_at("1/2", "cbrt((x-1/2)^2)/(1+x^4)", "-inf", "inf");
    is_cut_at("-1/2", "cbrt((x+1/2)^2)/(1+x^4)", "-inf", "inf");
}

TEST_CASE("where a proof stops is found in x, and the range cut there, if what it is taken in is a logarithm")
{
    is_cut_at("7/3", "exp(-x)*cbrt((x-7/3)^2)", "1", "inf");
    is_cut_at("-7/3", "exp(x)*cbrt((x+7/3)^2)", "-inf", "-1");
    is_cut_at("1/2", "sech(x)*cbrt((x-1/2)^2)", "-inf", "inf");
    is_cut_at("-1/2", "sech(x)*cbrt((x+1/2)^2)", "-inf", "inf");
}

TEST_CASE("a kink that is no root of a polynomial is cut at where the proof stops there")
{
    for (const auto& [formula, value] : {std::pair("exp(-3*x)*max(exp(x-1/2),1)", "(1-exp(-3/2))/3+exp(-3/2)/2"),
                                         {"exp(-3*x)*min(-exp(x-1/2),-1)", "(exp(-3/2)-1)/3-exp(-3/2)/2"},
                                         {"exp(-3*x)*abs(exp(x-1/2)-1)", "(1-exp(-3/2))/3-exp(-1/2)*(1-exp(-1))/2+exp(-3/2)/6"},
                                         {"exp(-x)*sign(exp(x-1/2)-1)", "2*exp(-1/2)-1"}}) {
        CAPTURE(std::string(formula));
        const Integral i = integral(formula, "0", "inf");
        is(i, value);
        CHECK(std::any_of(i.parts.begin(), i.parts.end(), [](const Part& p) { return p.from == "1/2"; }));
    }
}

TEST_CASE("where Gauss-Legendre quadrature is not to be chosen it is not, beside kinks and singular ends either")
{
    IntegralOptions without = with_digits(15);
    without.gauss_legendre = false;
    for (const char* formula :
         {"abs(exp(x-1/2)-1)", "sqrt(x)*abs(x-1/3)", "max(exp(x-1/2),1)", "exp(x)", "sqrt(x*(1-x))", "x^(1/3)*abs(x-1/2)"}) {
        CAPTURE(std::string(formula));
        const Integral i = integral(formula, "0", "1", without), other = integral(formula, "0", "1", with_digits(15));
        CHECK_MESSAGE(i.status == Status::certified, i.reason);
        CHECK(i.value.overlaps(other.value));
        for (const Part& p : i.parts) CHECK_FALSE(p.rule.starts_with("gauss"));
    }
    // a kink so near to the end that the formula is not analytic about it
    for (const char* formula : {"abs(exp(x-1/100000)-1)", "abs(exp(x-1+1/100000)-1)"}) {
        CAPTURE(std::string(formula));
        CHECK(integral(formula, "0", "1", with_digits(15)).parts.at(0).rule == "gauss-legendre");
        for (const Part& p : integral(formula, "0", "1", without).parts) CHECK_FALSE(p.rule.starts_with("gauss"));
    }
}

TEST_CASE("where a proof stops at no point with a name it is told as a number")
{
    for (const auto& [formula, from, to, near] : {std::tuple("1/(x-zeta(3))^2", "1", "2", 1.202),
                                                  {"1/((x-zeta(3))^2*(1+x^2))", "1", "inf", 1.202},
                                                  {"exp(-x)/(x-zeta(3))^2", "1/2", "inf", 1.202},
                                                  {"1/((x+zeta(3))^2*(1+x^2))", "-inf", "-1", -1.202},
                                                  {"exp(x)/(x+zeta(3))^2", "-inf", "-1/2", -1.202}}) {
        CAPTURE(std::string(formula));
        const Integral refused = integral(formula, from, to, with_digits(10));
        CHECK(refused.status != Status::certified);
        const std::string words = "near x = ";
        const auto place = refused.reason.find(words);
        REQUIRE(place != std::string::npos);
        CHECK(std::fabs(std::stod(refused.reason.substr(place + words.size())) - near) < 0.02);
        const bool infinite = std::string(from) == "-inf" || std::string(to) == "inf";
        if (refused.reason.find(" end ") != std::string::npos) // what can be done there
            CHECK((refused.reason.find("a tail that oscillates") != std::string::npos) == infinite);
    }
}
