// SPDX-License-Identifier: MIT
// Several integrands by one proof: each value is right, whatever the others are; the majorant bounds every one of them.
#include "touchstone/quadrature/integrate.hpp"

#include "touchstone/quadrature/strip.hpp"

#include <doctest/doctest.h>

#include <string>
#include <tuple>

using namespace touchstone;
using namespace touchstone::quadrature;

namespace {

std::vector<Integral> several(const std::vector<const char*>& formulas, const char* from, const char* to, long digits = 30)
{
    std::vector<ExpressionPtr> all;
    for (const char* f : formulas) all.push_back(parse_expression(f));
    IntegralOptions options;
    options.digits = digits;
    return integrate_several(all, parse_limit(from), parse_limit(to), options);
}

} // namespace

TEST_CASE("several integrals over one range, the strip proved once")
{
    const auto all = several({"1/sqrt(x)", "log(x)/sqrt(x)", "1e-40*x", "x^(-0.9)", "1/sqrt(x*(1-x))"}, "0", "1");
    const char* values[] = {"2", "-4", "5e-41", "10", "pi"};
    REQUIRE(all.size() == 5);
    for (std::size_t k = 0; k < all.size(); ++k) {
        CAPTURE(values[k]);
        CHECK_MESSAGE(all[k].status == Status::certified, all[k].reason);
        CHECK(all[k].value.overlaps(parse_limit(values[k]).ball()));
        CHECK(all[k].value.relative_bits() >= 99);
        REQUIRE(all[k].parts.size() == 1);
        CHECK(all[k].parts[0].certificate.to_json() == all[0].parts[0].certificate.to_json());
    }
}

TEST_CASE("several integrals: a weight serves neighbours with the same powers at both ends, and no others")
{
    const std::vector<const char*> powers{"x^(-1/3)",              "x^(-2/3)",     "x^(-2/3)*cos(x)", "x^(-2/3)*(1-x)^(-1/4)",
                                          "x^(-1/3)*(1-x)^(-1/4)", "(1-x)^(-1/4)", "1"};
    const auto all = several(powers, "0", "1");
    for (std::size_t k = 0; k < powers.size(); ++k) {
        CAPTURE(std::string(powers[k]));
        CHECK(all[k].parts.at(0).rule == "tanh-sinh, the strip proved for all formulas");
        const Integral alone = integrate(parse_expression(powers[k]), parse_limit("0"), parse_limit("1"));
        CHECK(all[k].status == Status::certified);
        CHECK(alone.status == Status::certified);
        CHECK(all[k].value.overlaps(alone.value));
    }
}

TEST_CASE("several integrals: one that fails takes no other with it")
{
    const auto all = several({"1/sqrt(x)", "1/x", "abs(x-1/3)^(-1/2)", "i*x", "sign(x-1/2)*x"}, "0", "1", 20);
    CHECK(all[0].status == Status::certified);
    CHECK(all[1].divergent);
    CHECK(all[2].status == Status::certified);
    CHECK(all[2].value.overlaps(parse_limit("2*(sqrt(1/3)+sqrt(2/3))").ball()));
    CHECK(all[3].imaginary.overlaps(parse_limit("1/2").ball()));
    CHECK(all[4].value.overlaps(parse_limit("1/4").ball()));
    const auto tails = several({"exp(-x)", "exp(-x)*x^3", "exp(-x)/sqrt(x)"}, "0", "inf");
    CHECK(tails[1].value.overlaps(parse_limit("6").ball()));
    CHECK(tails[2].value.overlaps(parse_limit("sqrt(pi)").ball()));
    CHECK(several({"x", "exp(x)"}, "1", "0")[0].value.overlaps(parse_limit("-1/2").ball()));
    CHECK(several({"x", "exp(-x)"}, "inf", "0", 10)[1].value.overlaps(Ball(-1)));
    CHECK_THROWS_AS(
        [] {
            IntegralOptions options;
            options.at = {parse_limit("2")};
            return integrate_several({parse_expression("x"), parse_expression("x^2")}, parse_limit("0"), parse_limit("1"), options);
        }(),
        DomainError);
}

TEST_CASE("several integrals over what is no ascending range, or with a pole that is folded, are what each is by itself")
{
    const auto both = [](const char* from, const char* to, const IntegralOptions& options) {
        return integrate_several({parse_expression("1/x"), parse_expression("exp(x)/x")}, parse_limit(from), parse_limit(to), options);
    };
    IntegralOptions cut;
    cut.at = {parse_limit("3/2")};
    const auto back = both("2", "1", cut);
    CHECK_MESSAGE(back[0].status == Status::certified, back[0].reason);
    CHECK(back[0].value.overlaps(parse_limit("-log(2)").ball()));
    CHECK(back[1].value.overlaps(parse_limit("ei(1)-ei(2)").ball()));
    CHECK(back[1].parts.size() == 2);
    IntegralOptions folded;
    folded.principal_value = {parse_limit("0")};
    const auto poles = both("-1", "2", folded);
    CHECK_MESSAGE(poles[0].status == Status::certified, poles[0].reason);
    CHECK(poles[0].value.overlaps(parse_limit("log(2)").ball()));
    CHECK(poles[1].value.overlaps(parse_limit("ei(2)-ei(-1)").ball()));
}

TEST_CASE("several integrals over half-lines and lines in either direction are what each is by itself, and one alone is by its own rule")
{
    const auto is = [](const Integral& i, const char* value) {
        CHECK_MESSAGE(i.status == Status::certified, i.reason);
        CHECK(i.value.overlaps(parse_limit(value).ball()));
    };
    const auto shared = [](const Integral& i) { return i.parts.front().rule.find("for all formulas") != std::string::npos; };
    const struct {
        std::vector<const char*> formulas;
        const char *from, *to, *first, *second;
        bool together;
    } cases[] = {{{"exp(x)/sqrt(1-x)", "exp(x)"}, "-inf", "0", "e*gamma(1/2)*erfc(1)", "1", true},
                 {{"exp(x)", "exp(2*x)"}, "0", "-inf", "-1", "-1/2", false},
                 {{"exp(-x^2)", "exp(-4*x^2)"}, "-inf", "inf", "sqrt(pi)", "sqrt(pi)/2", true},
                 {{"exp(-x^2)", "exp(-4*x^2)"}, "inf", "-inf", "-sqrt(pi)", "-sqrt(pi)/2", false},
                 {{"exp(-x)", "exp(-2*x)"}, "inf", "1", "-exp(-1)", "-exp(-2)/2", false},
                 {{"1/sqrt(x)", "x^(-1/3)"}, "0", "1", "2", "3/2", true},
                 {{"1/sqrt(x)", "integral(x*y,y,0,1)/sqrt(x)"}, "0", "1", "2", "1/3", false},
                 {{"1/sqrt(x)", "re((1+i)/sqrt(x))"}, "0", "1", "2", "2", true},
                 {{"x", "x^2"}, "0", "1", "1/2", "1/3", false}};
    for (const auto& c : cases) {
        CAPTURE(std::string(c.formulas.back()));
        CAPTURE(c.from);
        const auto both = several(c.formulas, c.from, c.to, 20);
        REQUIRE(both.size() == 2);
        is(both[0], c.first);
        is(both[1], c.second);
        CHECK(shared(both[0]) == c.together);
        CHECK(both[0].parts.front().from == (c.together ? c.from : both[0].parts.front().from));
    }
    const auto alone = several({"x^(-1/3)*cos(x)"}, "0", "1", 20);
    REQUIRE(alone.size() == 1);
    CHECK(alone[0].status == Status::certified);
    CHECK_FALSE(shared(alone[0]));
    for (const char* end : {"inf", "-inf"}) CHECK_THROWS_AS(several({"exp(-x^2)", "exp(-4*x^2)"}, end, end), DomainError);
    IntegralOptions cut;
    cut.digits = 15;
    for (const auto& [from, to, inside] : {std::tuple("0", "1", "1/3"), {"-inf", "0", "-3"}, {"0", "inf", "5"}, {"-inf", "inf", "1/2"}}) {
        cut.at = {parse_limit(inside)};
        const auto all =
            integrate_several({parse_expression("1/(1+x^2)"), parse_expression("i/(1+x^2)")}, parse_limit(from), parse_limit(to), cut);
        CHECK(all[0].parts.size() == 2);
        CHECK(all[1].is_complex);
        CHECK_FALSE(all[0].is_complex);
        CHECK(all[1].imaginary.overlaps(all[0].value));
        CHECK(all[0].status == Status::certified);
    }
    for (const auto& [from, to, outside] :
         {std::tuple("-inf", "0", "1"), {"0", "inf", "-1"}, {"0", "inf", "0"}, {"-inf", "0", "0"}, {"-inf", "inf", "inf"}}) {
        CAPTURE(outside);
        cut.at = {parse_limit(outside)};
        CHECK_THROWS_AS(
            integrate_several({parse_expression("exp(-x^2)"), parse_expression("exp(-4*x^2)")}, parse_limit(from), parse_limit(to), cut),
            DomainError);
    }
}

TEST_CASE("the majorant of numbers u^p r^q c is at least each of them, and no more than the largest of their kind")
{
    const WorkingPrecision precision(strip_bits);
    const StripPiece piece = StripPiece::at(Side::left, 1, 1.25, 0, 0.25);
    using N = EndpointNumber<ComplexBall>;
    const N a(&piece, {Exponent(-1, 2), 0}, {}, ComplexBall(3)),
        b(&piece, {Exponent(1), 0}, {Exponent(-1, 3), 0}, ComplexBall(Ball(0), Ball(-2)));
    const auto size = [&](const N& g) { return abs(g.value()); };
    for (const auto& all : {std::vector{a, b}, std::vector{b, a}, std::vector{a}}) {
        const N m = quadrature::detail::majorant(all, piece);
        for (const N& g : all) {
            const Ball low = size(g), high = size(m);
            CHECK(!arb_gt(low.get(), high.get()));
        }
        CHECK(m.left().power == Exponent(-1, 2));
    }
    // of one kind: the larger, and hardly more
    const N c(&piece, {Exponent(-1, 2), 0}, {}, ComplexBall(Ball(-4)));
    const Ball larger = quadrature::detail::majorant({a, c}, piece).factor().real(), more = Ball(4) + Ball(1) / Ball(1000000);
    CHECK(arb_ge(larger.get(), Ball(4).get()));
    CHECK(arb_le(larger.get(), more.get()));
    // an end's piece, where a logarithm is the larger
    const StripPiece end = StripPiece::at(Side::left, 1, std::numeric_limits<double>::infinity(), 0, 0.25);
    const N plain(&end, {}, {}, ComplexBall(1)), logarithm(&end, {0, 1}, {}, ComplexBall(1));
    CHECK(quadrature::detail::majorant({plain, logarithm}, end).left().logs == Exponent(1));
    CHECK(!quadrature::detail::majorant({plain, N(&end, {}, {}, ComplexBall::indeterminate())}, end).factor().is_finite());
}
