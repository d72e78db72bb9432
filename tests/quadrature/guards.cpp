// SPDX-License-Identifier: MIT
// Conditions under which something is not taken for what it resembles, each of several alone: what a wave, a power or an expansion is not.
#include "touchstone/quadrature/compiled.hpp"
#include "touchstone/quadrature/endpoint_functions.hpp"
#include "touchstone/quadrature/exact_series.hpp"
#include "touchstone/quadrature/integrand.hpp"
#include "touchstone/quadrature/integrate.hpp"
#include "touchstone/quadrature/oscillation.hpp"
#include "touchstone/quadrature/path.hpp"
#include "touchstone/quadrature/special.hpp"
#include "touchstone/quadrature/split.hpp"
#include "touchstone/quadrature/strip.hpp"
#include "touchstone/scalar/refusal.hpp"

#include <doctest/doctest.h>

#include <limits>
#include <string>
#include <tuple>

using namespace touchstone;
using namespace touchstone::quadrature;

namespace {

using N = EndpointNumber<ComplexBall>;

Integral integral(const std::string& formula, const char* from, const char* to, IntegralOptions options = {})
{
    options.digits = 15;
    return integrate(parse_expression(formula), parse_limit(from), parse_limit(to), options);
}

/// A ball without bounds overlaps everything: what is refused is not right.
bool is(const Integral& i, const Ball& truth) { return i.status == Status::certified && i.value.overlaps(truth); }

ComplexBall at(double x, double y) { return {Ball::exactly(x), Ball::exactly(y)}; }

} // namespace

TEST_CASE("what has another argument, order or factor than a wave has is none")
{
    for (const char* formula : {"cos(x^2)", "sin(x+x^2)", "cos(exp(x))", "sin(sqrt(x))", "cos(x)*exp(sin(x))", "exp(sin(x))*cos(x)",
                                "cos(x)+exp(sin(x))", "exp(sin(x))+cos(x)", "besselj(0,x^2)", "besselj(0,sqrt(x))", "besselj(0,x+1)",
                                "besselj(x,x)", "besselj(x,2*x)", "besselj(0,-x)"}) {
        CAPTURE(formula);
        CHECK_FALSE(waves(parse_expression(formula)).has_value());
    }
}

TEST_CASE("a number with logarithms has no power and no logarithm, one on either side alone")
{
    const WorkingPrecision precision(64);
    const StripPiece piece = StripPiece::at(Side::left, 1, 1.1, 0.2, 0.3);
    const Order logs{0, 1}, none{};
    for (const bool left : {true, false}) {
        const N x(&piece, left ? logs : none, left ? none : logs, ComplexBall(2));
        CHECK_FALSE(log(x).factor().is_finite());
        CHECK_FALSE(pow(x, Ball(1) / Ball(3)).factor().is_finite());
    }
    const N plain(&piece, {1, 0}, {}, ComplexBall(2));
    CHECK(log(plain).factor().is_finite());
    CHECK(pow(plain, Ball(1) / Ball(3)).factor().is_finite());
    CHECK_FALSE(pow(plain, Ball(1LL << 40)).factor().is_finite()); // no exponent that is told exactly
    CHECK_FALSE(pow(plain, Ball::indeterminate()).factor().is_finite());
}

TEST_CASE("what grows with rho = |Re w| is bounded where rho is at least 1, and in the half-plane where the bound holds")
{
    const WorkingPrecision precision(64);
    constexpr double endless = std::numeric_limits<double>::infinity();
    const Ball order(0);
    for (const Side side : {Side::left, Side::right}) {
        const StripPiece far = StripPiece::at(side, 1, endless, 0, 0.3), near = StripPiece::at(side, 0.2, endless, 0, 0.3);
        REQUIRE(certainly(less(Ball(1), far.depth())));
        REQUIRE(certainly(less(near.depth(), Ball(1))));
        const auto grows = [side](const StripPiece& piece, const Exponent& logs, const ComplexBall& c) {
            return side == Side::left ? N(&piece, {0, logs}, {}, c) : N(&piece, {}, {0, logs}, c);
        };
        CHECK(function_of(Op::log, grows(far, 1, ComplexBall(2))).factor().is_finite());
        CHECK_FALSE(function_of(Op::log, grows(near, 1, ComplexBall(2))).factor().is_finite());
        CHECK(function_of(Op::bessel_k, order, grows(far, 1, ComplexBall(2))).factor().is_finite());
        CHECK_FALSE(function_of(Op::bessel_k, order, grows(far, 1, ComplexBall(-2))).factor().is_finite());
        CHECK_FALSE(function_of(Op::bessel_k, order, grows(far, 1, at(0, 2))).factor().is_finite());
        CHECK_FALSE(function_of(Op::bessel_k, order, grows(near, 2, ComplexBall(2))).factor().is_finite());
        CHECK_FALSE(function_of(Op::bessel_k, order, grows(far, Exponent(1, 2), ComplexBall(2))).factor().is_finite());
    }
}

TEST_CASE("no expansion by a power that is no fraction, nor of a Bessel function of an order that is no integer")
{
    for (const char* formula :
         {"x^sqrt(2)", "(1+x)^pi", "besselj(1/2,x)", "besselj(sqrt(2),x)", "besseli(3/2,x)", "besselj(0,log(x))",
          "besselj(1,abs(log(x)))"}) {
        CAPTURE(formula);
        CHECK_FALSE(expand(*parse_expression(formula), ExactSum(0), 1).has_value());
    }
    CHECK(expand(*parse_expression("besselj(1,x)"), ExactSum(0), 1).has_value());
    for (const long n : {65L, -65L, 1000L, -1000L}) CHECK_FALSE(ExactSum(3).power(n).has_value());
    CHECK(ExactSum(2).power(-64).has_value());
}

TEST_CASE("real and imaginary parts by formulas are had of small integer powers alone")
{
    for (const char* power : {"(1+i*x)^1.5", "(1+i*x)^2.5", "(1+i*x)^0.5", "(1+i*x)^(-1.5)", "(1+i*x)^9", "(1+i*x)^x"}) {
        CAPTURE(power);
        CHECK_FALSE(real_and_imaginary(parse_expression(power)).has_value());
    }
    CHECK(real_and_imaginary(parse_expression("(1+i*x)^8")).has_value());
    CHECK(real_and_imaginary(parse_expression("(1+i*x)^(-3)")).has_value());
}

TEST_CASE("a power of a multiple of x is not the multiple of a power")
{
    for (const auto& [formula, other] : {std::pair("cos((4*x)^(3/2))", "cos(8*x^(3/2))"),
                                         {"sin((9*x^3)^(1/2))", "sin(3*x^(3/2))"},
                                         {"exp(i*(5*x)^(3/2))", "exp(i*sqrt(125)*x^(3/2))"}}) {
        CAPTURE(formula);
        const Integral one = integral(formula, "0", "inf"), two = integral(other, "0", "inf");
        CHECK(two.status == Status::certified);
        if (one.status == Status::certified) CHECK(one.value.overlaps(two.value)); // else it is refused
    }
}

TEST_CASE("sums may be long where powers may not be deep; steps may be many, but not without end")
{
    std::string sum = "x", deep = "x";
    for (int k = 0; k < 60; ++k) sum += "+x", deep = "sqrt(1+" + deep + ")";
    CHECK(is(integral(sum, "0", "1"), Ball(61) / Ball(2)));
    CHECK_THROWS_AS(integral(deep, "0", "1"), ExpressionError);
    // what the parser goes deeper by is counted before it begins; what only follows one another is not
    const auto repeated = [](const std::string& part, int times) {
        std::string all;
        for (int k = 0; k < times; ++k) all += part;
        return all;
    };
    const auto parses = [](const std::string& text) {
        try {
            parse_expression(text);
            return std::string();
        }
        catch (const ExpressionError& e) {
            return std::string(e.what());
        }
    };
    for (const auto& [part, rest, what] :
         {std::tuple{"(", "x", "brackets"}, {"- ", "x", "signs"}, {"x^-", "x", "powers"}, {"(x)^", "x", "powers"}}) {
        CAPTURE(part);
        CHECK(parses(repeated(part, 257) + rest).find(std::string(what) + " nest deeper than 256") != std::string::npos);
        CHECK(parses(repeated(part, 256) + rest).find("256") == std::string::npos);
    }
    CHECK(parses(repeated("x^2-", 300) + "(x)^2").empty());
    CHECK(parses(repeated("(x)^2*", 300) + "x").empty());
    CHECK(parses(repeated("-x+(-x)", 300) + "-x").empty());
    CHECK_THROWS_AS(integral("floor(1000000*x)", "0", "1"), DomainError);
    CHECK(is(integral("floor(x)", "10000000000000000", "10000000000000002"), Ball(20000000000000001L)));
    CHECK(is(integral("floor(3*x)", "0", "1"), Ball(1)));
}

TEST_CASE("break points are inside the range, and of a path neither they nor principal values are asked")
{
    for (const char* outside : {"2", "-1", "inf", "0", "1"}) {
        CAPTURE(outside);
        IntegralOptions options;
        options.at = {parse_limit(outside)};
        CHECK_THROWS_AS(integrate_several({parse_expression("x"), parse_expression("x^2")}, parse_limit("0"), parse_limit("1"), options),
                        DomainError);
    }
    IntegralOptions inside;
    inside.digits = 15;
    inside.at = {parse_limit("1/2"), parse_limit("1/3")};
    for (const auto& [from, to, value] : {std::tuple("0", "1", "1-exp(-1)"), {"0", "inf", "1"}, {"-1", "inf", "e"}})
        CHECK(is(
            integrate_several({parse_expression("exp(-x)"), parse_expression("exp(-2*x)")}, parse_limit(from), parse_limit(to), inside)[0],
            parse_limit(value).ball()));
    const std::vector<Vertex> path{parse_vertex("0"), parse_vertex("1+i")};
    IntegralOptions broken, principal;
    broken.at = {parse_limit("1/2")};
    principal.principal_value = {parse_limit("1/2")};
    CHECK_THROWS_AS(integrate_along(parse_expression("x"), path, broken), DomainError);
    CHECK_THROWS_AS(integrate_along(parse_expression("x"), path, principal), DomainError);
}

TEST_CASE("an essential singularity at an end other than 0, on either side: the same as at 0")
{
    const WorkingPrecision precision(120);
    for (const auto& [formula, from, to, other] : {std::tuple("exp(-1/(x-1))", "1", "2", "exp(-1/x)"),
                                                   {"exp(-1/(3-x))", "2", "3", "exp(-1/x)"},
                                                   {"exp(-1/(x+2))", "-2", "-1", "exp(-1/x)"},
                                                   {"exp(-1/(x-5))*cos(x-5)", "5", "6", "exp(-1/x)*cos(x)"},
                                                   {"sin(1/(x-1))", "1", "2", "sin(1/x)"}}) {
        CAPTURE(formula);
        const Integral one = integral(formula, from, to), two = integral(other, "0", "1");
        CHECK_MESSAGE(one.status == Status::certified, one.reason);
        CHECK(one.value.overlaps(two.value));
        CHECK(one.value.relative_bits() > 40);
    }
}

TEST_CASE("a step is one number only where it is, to both ends of the range")
{
    const WorkingPrecision precision(64);
    for (const auto& [formula, from, to] : {std::tuple("floor(x)", "0.2", "1.6"),
                                            {"floor(x)", "-0.7", "0.5"},
                                            {"ceil(x)", "0.2", "1.6"},
                                            {"ceil(x)", "-1.7", "-0.2"},
                                            {"floor(2*x)", "0", "0.9"},
                                            {"floor(x)", "0.6", "1.9"},
                                            {"ceil(x)", "0.8", "1.9"},
                                            {"floor(x)", "-1.4", "-0.3"},
                                            {"ceil(x)", "-1.9", "-0.8"},
                                            {"floor(-x)", "0.6", "1.9"},
                                            {"ceil(3-x)", "0.3", "1.2"}}) {
        CAPTURE(formula);
        const Integrand f(parse_expression(formula), Range{parse_limit(from), parse_limit(to), Map::finite});
        const ComplexBall whole = f.in_plane(ComplexBall(hull(parse_limit(from).ball(), parse_limit(to).ball())));
        CHECK_FALSE(whole.is_finite());
    }
    const Integrand steady(parse_expression("floor(x)"), Range{parse_limit("1/4"), parse_limit("1"), Map::finite});
    CHECK(steady.in_plane(ComplexBall(Ball(1) / 2)).is_finite());
    for (const auto& [formula, from, to, step] : {std::tuple("floor(x)", "0", "1", 0L),
                                                  {"floor(x)", "5/4", "2", 1L},
                                                  {"floor(-x)", "0", "1", -1L},
                                                  {"floor(2*x-7)", "1/2", "1", -6L},
                                                  {"ceil(x)", "0", "1", 1L},
                                                  {"ceil(x)", "5/4", "2", 2L},
                                                  {"ceil(-x)", "0", "1", 0L},
                                                  {"ceil(2*x-7)", "1/2", "1", -5L}}) {
        CAPTURE(std::string(formula));
        const Integrand one(parse_expression(formula), Range{parse_limit(from), parse_limit(to), Map::finite});
        const ComplexBall value =
            one.in_plane(ComplexBall(hull(parse_limit(from).ball(), parse_limit(to).ball()))); // analytic across the whole range
        CHECK(acb_equal_si(value.get(), step) != 0);
    }
    // of more bits than a step is counted in
    const Integrand far_out(parse_expression("floor(x)-1e20"), Range{parse_limit("1e20"), parse_limit("1e20+1/2"), Map::finite});
    const WorkingPrecision more(128);
    CHECK(far_out.at_real(parse_limit("1e20+1/4").ball()).contains_zero());
    const Integrand of_many(parse_expression("floor(x)"), Range{parse_limit("2^70"), parse_limit("2^70+1024"), Map::finite});
    CHECK(of_many.at_real(parse_limit("2^70+7/2").ball()).contains(Rational(power(Rational(2), 70) + 3)));
}

TEST_CASE("on a half-line the distances to both ends are s and 1/(1 + s), or exp(-s)")
{
    const WorkingPrecision precision(80);
    const Ball s = Ball(3) / Ball(7);
    for (const auto& [from, to, side] : {std::tuple("2", "inf", Side::left), {"-inf", "2", Side::right}})
        for (const bool algebraic : {true, false}) {
            const bool left = side == Side::left;
            const Map on_the_right = algebraic ? Map::right_algebraic : Map::right_exponential,
                      on_the_left = algebraic ? Map::left_algebraic : Map::left_exponential;
            const Range range{parse_limit(from), parse_limit(to), left ? on_the_right : on_the_left};
            const compiled::Disc<Ball> disc(side, s);
            const auto point = compiled::point_about(disc, compiled::Place{&range});
            const Ball other = algebraic ? Ball(1) / (Ball(1) + s) : exp(-s);
            CHECK((left ? point.left : point.right).value().overlaps(s));
            CHECK((left ? point.right : point.left).value().overlaps(other));
            CHECK(point.x.value().overlaps(left ? Ball(2) + s : Ball(2) - s));
        }
}

TEST_CASE("odd functions beside their zero are what they are elsewhere, and vanish as their argument does")
{
    const WorkingPrecision precision(100);
    for (const Op op : {Op::sinh, Op::tanh, Op::asinh, Op::atanh})
        for (const ComplexBall& s : {at(0.3, 0.2), at(0.7, -0.4), at(1e-5, 1e-6), at(0, 0.5)}) {
            CAPTURE(static_cast<int>(op));
            const compiled::Disc<ComplexBall> disc(Side::left, s);
            const N f = function_of(op, N(&disc, {1, 0}, {}, ComplexBall(1)));
            CHECK(f.left().power == Exponent(1));
            const ComplexBall truth = special_function(op, s), value = f.value();
            CHECK(value.overlaps(truth));
            CHECK(acb_rel_accuracy_bits(value.get()) > 60);
            const compiled::Disc<Ball> line(Side::left, s.real() + Ball(Rational(1, 8)));
            const auto on_the_line = function_of(op, EndpointNumber<Ball>(&line, {1, 0}, {}, Ball(1)));
            CHECK(on_the_line.value().overlaps(special_function(op, s.real() + Ball(Rational(1, 8)))));
        }
}
