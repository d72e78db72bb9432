// SPDX-License-Identifier: MIT
// The odd difference that a principal value is folded to: on which disc it is bounded, and by what.
#include "touchstone/quadrature/compiled.hpp"
#include "touchstone/quadrature/integrate.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cmath>
#include <string>
#include <tuple>

using namespace touchstone;
using namespace touchstone::quadrature;

namespace {

/// What is known of h(s) - h(-s) at s = 0, on [0, reach].
std::optional<compiled::Zero> zero_of_fold(const std::string& h, const char* reach = "1")
{
    const WorkingPrecision precision(64);
    const Range range{parse_limit("0"), parse_limit(reach), Map::finite};
    const compiled::Place place{&range};
    const compiled::NodePtr node = compiled::compile(make(Op::odd_difference, {parse_expression(h)}), place);
    return node->zero[0];
}

double number(const Ball& x) { return arf_get_d(arb_midref(x.get()), ARF_RND_UP); }

} // namespace

TEST_CASE("an odd difference is bounded on a disc without a singular point, whatever the direction in which the next one is")
{
    for (int k = 0; k < 16; ++k) {
        const double angle = (k + 0.3) * M_PI / 8; // no pole on the range
        const auto pole = [&](double distance) {
            return fmt::format("exp(x)/(x-({:.6f})-({:.6f})*i)", distance * std::cos(angle), distance * std::sin(angle));
        };
        CAPTURE(k);
        const auto beyond = zero_of_fold(pole(0.8)), inside = zero_of_fold(pole(0.49)), near = zero_of_fold(pole(0.1));
        REQUIRE((beyond && inside && near));
        CHECK(number(beyond->radius) == 0.5); // half the range
        CHECK(number(inside->radius) == 0.25);
        CHECK(number(near->radius) == 0.0625);
    }
    CHECK_FALSE(zero_of_fold("exp(x)/x"));
}

TEST_CASE("an odd difference vanishes where its variable does, and at the beginning of no other range")
{
    for (const auto& [from, to] : {std::pair("1/4", "1"), {"zeta(3)", "2"}, {"-1", "1"}}) {
        CAPTURE(std::string(from));
        const WorkingPrecision precision(64);
        const Range range{parse_limit(from), parse_limit(to), Map::finite};
        const compiled::NodePtr node =
            compiled::compile(make(Op::odd_difference, {parse_expression("exp(x)+x^2")}), compiled::Place{&range});
        CHECK_FALSE(node->zero[0]);
        CHECK_FALSE(node->zero[1]);
    }
}

TEST_CASE("a zero that terms do not show is bounded on a disc without a singular point, by what it is and not by much more")
{
    const WorkingPrecision precision(64);
    const Range range{parse_limit("0"), parse_limit("1"), Map::finite};
    const compiled::Place place{&range};
    const auto zero = [&](const std::string& formula) { return compiled::compile(parse_expression(formula), place)->zero[0]; };
    for (int k = 0; k < 16; ++k) {
        const double angle = (k + 0.3) * M_PI / 8;
        const auto with_pole = [&](double distance) {
            return zero(fmt::format("1+x^3/(x-({:.6f})-({:.6f})*i)-cos(x)", distance * std::cos(angle), distance * std::sin(angle)));
        };
        CAPTURE(k);
        const auto beyond = with_pole(0.8), inside = with_pole(0.49);
        REQUIRE((beyond && inside));
        CHECK(beyond->order == 2);
        CHECK(number(beyond->radius) == 0.5);
        CHECK(number(inside->radius) < 0.5);
    }
    const auto even = zero("1-cos(x)"), third = zero("x-sin(x)");
    REQUIRE((even && third));
    CHECK(number(even->bound) >= 0.5);
    CHECK(number(even->bound) <= 4 * 0.5);
    CHECK(third->order == 3);
    CHECK(number(third->bound) >= 1 / 6.0);
    CHECK(number(third->bound) <= 32 / 6.0); // |x| + |sin x| over the cube of the radius: the terms do not cancel in boxes
}

TEST_CASE("an odd difference over s is bounded by what it is, and not by much more")
{
    const auto odd = zero_of_fold("exp(x)"), power = zero_of_fold("x^3*exp(x)"), far = zero_of_fold("exp(x)", "6");
    REQUIRE((odd && power && far));
    CHECK(odd->order == 1);
    const double half = 2 * std::sinh(0.5) / 0.5, of_power = 2 * 0.25 * std::cosh(0.5), three = 2 * std::sinh(3) / 3; // at s = R
    CHECK(number(odd->bound) >= half);
    CHECK(number(odd->bound) <= 4 * half);
    CHECK(number(power->bound) >= of_power);
    CHECK(number(power->bound) <= 8 * of_power); // of boxes that reach beyond the disc
    CHECK(number(far->radius) == 3);
    CHECK(number(far->bound) >= three);
    CHECK(number(far->bound) <= 8 * three);
}

TEST_CASE("what is another function on the other side of a pole has no odd difference, wherever its cut meets the circle")
{
    for (const char* reach : {"1", "8"})
        for (int k = 0; k < 50; ++k) { // sqrt((w s)^2) is w s on one side of the line on which w s is imaginary
            const double angle = (k + 0.5) * M_PI / 50;
            const std::string turned = fmt::format("(x*(({:.6f})+({:.6f})*i))", std::cos(angle), std::sin(angle));
            CAPTURE(turned);
            CHECK_FALSE(zero_of_fold(fmt::format("x/sqrt({}^2)", turned), reach));
            CHECK(zero_of_fold(fmt::format("x/sqrt(100+{}^2)", turned), reach));
        }
    for (const char* h : {"x/abs(x)", "sign(x)", "floor(x)", "ceil(x)", "max(0,x)/x", "atan(1/x)", "x/abs(x*(1+i))", "x/abs(sin(x))",
                          "floor(x+1/1000)"}) {
        CAPTURE(h);
        CHECK_FALSE(zero_of_fold(h));
    }
    // a step or kink beyond the disc is none on it
    for (const char* h : {"floor(x+1/4)", "sign(x-1/20)*cos(x)", "abs(x-1/8)"}) {
        CAPTURE(h);
        CHECK(zero_of_fold(h));
    }
}

TEST_CASE("about a pole the fold reaches to the nearer end, and half way to the next pole")
{
    const auto value = [](const char* formula, const char* from, const char* to, std::vector<const char*> poles) {
        IntegralOptions o;
        o.digits = 15;
        for (const char* p : poles) o.principal_value.push_back(parse_limit(p));
        return integrate(parse_expression(formula), parse_limit(from), parse_limit(to), o);
    };
    const auto is = [](const Integral& i, const char* truth) {
        return i.status == Status::certified && i.value.overlaps(parse_limit(truth).ball());
    };
    CHECK(is(value("1/(x-1/3)", "-1", "1", {"1/3"}), "-log(2)"));
    CHECK(is(value("1/(x+1/3)", "-1", "1", {"-1/3"}), "log(2)"));
    CHECK(value("sqrt(1-x)/(x-1/3)", "-1", "1", {"1/3"}).status == Status::certified); // there is nothing beyond either end
    CHECK(value("sqrt(1+x)/(x+1/3)", "-1", "1", {"-1/3"}).status == Status::certified);
    CHECK(is(value("1/(x*(x-1))", "-1/8", "9/8", {"0", "1"}), "-4*log(3)"));
    // what is left of another power than the first has no principal value, in whichever form it is folded
    for (const auto& [formula, from, to] :
         {std::tuple("1/x^2", "-1", "1"), {"exp(x)/x^2", "-1", "1"}, {"1/abs(x)", "-1", "2"}, {"1/x^2", "-inf", "inf"}}) {
        CAPTURE(std::string(formula));
        const Integral none = value(formula, from, to, {"0"});
        CHECK_FALSE(none.value.is_finite());
        CHECK_FALSE(none.reason.empty());
        CHECK(none.reason.find("--principal-value") == std::string::npos);
    }
    for (const char* outside : {"3", "-1", "2", "inf", "-inf", "zeta(3)"}) {
        CAPTURE(std::string(outside));
        CHECK_THROWS_AS(value("1/x", "-1", "2", {outside}), DomainError);
    }
    CHECK_THROWS_AS(value("1/x", "-1", "2", {"0", "0"}), DomainError);
    CHECK_THROWS_AS(value("exp(-x)/x", "1", "inf", {"0"}), DomainError);
    CHECK_THROWS_AS(value("exp(x)/x", "-inf", "-1", {"0"}), DomainError);
    CHECK_THROWS_AS(value("1/x", "-zeta(3)", "2", {"0"}), DomainError);
    // half-lines and lines reach to 1 where nothing is nearer
    CHECK(is(value("exp(-x)/(x-2)", "0", "inf", {"2"}), "-exp(-2)*ei(2)"));
    CHECK(is(value("exp(x)/(x+2)", "-inf", "0", {"-2"}), "exp(-2)*ei(2)"));
    CHECK(is(value("1/((x-1)*(1+x^2))", "-inf", "inf", {"1"}), "-pi/2"));
    CHECK(is(value("x/((x-1)*(x-4)*(1+x^2))", "-inf", "inf", {"4", "1"}), "-5*pi/34"));
    CHECK(is(value("1/(x*(x-1))", "-4", "9/8", {"0", "1"}), "-log(45/4)"));
    CHECK(is(value("1/(x*(x-1))", "-1/8", "5", {"0", "1"}), "-log(45/4)"));
    CHECK(is(value("1/(x*(x-1)*(x-2))", "-1", "4", {"2", "0", "1"}), "log(32/27)/2"));
}
