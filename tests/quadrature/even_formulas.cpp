// SPDX-License-Identifier: MIT
// Even formulas, of which half is enough, and powers of products and quotients.
#include "touchstone/quadrature/ellipse_rule.hpp"
#include "touchstone/quadrature/endpoint_number.hpp"
#include "touchstone/quadrature/integrate.hpp"
#include "touchstone/quadrature/lemmas.hpp"
#include "touchstone/quadrature/parity.hpp"
#include "touchstone/quadrature/rules.hpp"
#include "touchstone/quadrature/widen.hpp"

#include <doctest/doctest.h>

#include <string>

using namespace touchstone;
using namespace touchstone::quadrature;

namespace {

Ball at(const char* formula, const Rational& x) { return evaluate_at(*parse_expression(formula), Ball(x)); }

Integral integral(const char* formula, const char* from, const char* to, long digits = 30)
{
    IntegralOptions options;
    options.digits = digits;
    return integrate(parse_expression(formula), parse_limit(from), parse_limit(to), options);
}

/// About re + i im, in either direction as far as that.
ComplexBall square(double re, double im, double half_side)
{
    ComplexBall z(Ball::exactly(re), Ball::exactly(im));
    widen(z, Ball::exactly(half_side));
    return z;
}

} // namespace

TEST_CASE("even and odd formulas are told by their parts, and what is neither is not taken for it")
{
    const auto of = [](const char* text) { return parity(*parse_expression(text)); };
    for (const char* even : {"x^2",      "sqrt(1-x^2)",      "cos(x)",    "abs(x)*exp(-x^2)", "x*sin(x)",
                             "tan(x)/x", "x^3/sinh(x)",      "3",         "besselj(0,x^2)",   "max(x^2,cos(x))",
                             "x^(-4)",   "cosh(3*x)^(-1/2)", "sqrt(x^2)", "2^(x^2)",          "abs(x)",
                             "sec(x)",   "cosh(x)",          "sech(x)",   "sinc(x)",          "integral(cos(t),t,0,1)"}) {
        CAPTURE(even);
        CHECK(of(even) == Parity::even);
    }
    for (const char* odd : {"x", "-x^3", "sin(x)*cos(x)", "x+atan(x)", "x/(1+x^2)", "erf(x)", "x^(-1)", "(x^3)^5"}) {
        CAPTURE(odd);
        CHECK(of(odd) == Parity::odd);
    }
    for (const char* neither : {"x+1", "exp(x)", "x+x^2", "sqrt(x)", "cos(x+1)", "x^(1/3)", "x^x", "acos(x)", "max(x,x^2)", "(x^2)^x",
                                "log(x)", "integral(exp(t*x),t,0,1)", "floor(x)", "x^0.5", "x^0.2", "(1+x)^2", "x*exp(x)"}) {
        CAPTURE(neither);
        CHECK(of(neither) == Parity::unknown);
    }
}

TEST_CASE("even and odd about another point: multiples of pi/2 in waves, constants that cancel, and nothing else")
{
    const auto of = [](const char* text, const char* centre) { return parity(*parse_expression(text), *parse_limit(centre).exact); };
    struct Row {
        const char *formula, *centre;
        Parity parity;
    };
    constexpr Parity even = Parity::even, odd = Parity::odd, unknown = Parity::unknown;
    for (const Row& row :
         {Row{"sin(x)", "pi/2", even},         Row{"cos(x)", "pi/2", odd},        Row{"tan(x)", "pi/2", odd},
          Row{"cot(x)", "pi/2", odd},          Row{"sec(x)", "pi/2", odd},        Row{"csc(x)", "pi/2", even},
          Row{"sin(x)", "pi", odd},            Row{"cos(x)", "pi", even},         Row{"tan(x)", "pi", odd},
          Row{"sin(x)", "-3*pi/2", even},      Row{"sin(2*x)", "pi/2", odd},      Row{"sin(x/2)", "pi", even},
          Row{"sin(3*x-pi)", "pi/2", even},    Row{"cos(pi*x)", "1/2", odd},      Row{"sin(pi-x)", "pi/2", even},
          Row{"x-1", "1", odd},                Row{"(1-x)^3", "1", odd},          Row{"(2*x-1)^2", "1/2", even},
          Row{"(x-1)/2+(1-x)^3", "1", odd},    Row{"cosh(x-sqrt(2))", "sqrt(2)", even}, Row{"x*sin(x)", "pi/2", unknown},
          Row{"sin(x)", "pi/3", unknown},      Row{"sin(x)", "1", unknown},       Row{"sin(x)", "pi/4", unknown},
          Row{"cos(x)+x", "pi/2", unknown},    Row{"sinh(x)", "pi/2", unknown},   Row{"cosh(x)", "pi", unknown},
          Row{"x", "1", unknown},              Row{"x^2", "1", unknown},          Row{"abs(x)", "1/2", unknown},
          Row{"x-1", "2", unknown},            Row{"sin(x)^3*cos(x)", "pi/2", odd}, Row{"log(sin(x))", "pi/2", even},
          Row{"sin(x+zeta(3))", "pi/2", unknown}, Row{"sin(zeta(3)*x)", "pi/2", unknown}, Row{"sinc(x)", "pi", unknown},
          Row{"2*(x-1)+2", "0", odd},          Row{"2*(x-1)-2", "0", unknown},
          Row{"exp(sin(x))+tan(x)^2", "-pi/2", even}, Row{"sin(1/x)", "pi/2", unknown}, Row{"1/(x-1)", "1", odd}, Row{"2/x", "1", unknown}}) {
        CHECK_MESSAGE(of(row.formula, row.centre) == row.parity, std::string(row.formula), " about ", std::string(row.centre));
        // and by values
        if (row.parity == unknown) continue;
        const WorkingPrecision precision(100);
        const Ball c = parse_limit(row.centre).ball(), t(Rational(1, 7));
        const auto f = parse_expression(row.formula);
        const Ball right = evaluate_at(*f, c + t), left = evaluate_at(*f, c - t);
        CHECK(left.overlaps(row.parity == even ? right : -right));
        CHECK_FALSE(left.overlaps(row.parity == even ? -right : right));
    }
}

TEST_CASE("logarithms and powers at both ends of an even formula: half of the values, and the same integral as of one that hides it")
{
    struct Row {
        const char *even, *hidden, *from, *to;
    };
    for (const Row& row : {Row{"log(sin(x))", "log(2*sin(x/2)*cos(x/2))", "0", "pi"},
                           Row{"log(1-x)*log(1+x)/(2+x^2)", "log(1-x)*log(1+x)/(2+x*x+0*x^3)", "-1", "1"},
                           Row{"(sin(x))^(-7/10)", "(2*sin(x/2)*cos(x/2))^(-7/10)", "0", "pi"}}) {
        CAPTURE(row.even);
        const Integral even = integral(row.even, row.from, row.to, 40), other = integral(row.hidden, row.from, row.to, 40);
        CHECK(even.status == Status::certified);
        CHECK(other.status == Status::certified);
        CHECK(even.value.overlaps(other.value));
        CHECK(even.parts.front().rule == "product integration");
    }
    const auto evaluations = [](const char* formula) { return integral(formula, "0", "pi", 40).parts.front().evaluations; };
    CHECK(evaluations("log(sin(x))") * 4 < evaluations("log(2*sin(x/2)*cos(x/2))") * 3);
    // a left and a right logarithm with coefficients that differ: c_10(-z) = c_01(z), on half of the ellipse either may be the larger one
    EllipseFunction f;
    f.weights = {SingularWeight{}, SingularWeight{0, 0, 1, 0}, SingularWeight{0, 0, 0, 1}};
    const auto all = [](const auto& z, auto& c) { c.assign({exp(z) + exp(-z), exp(z * 3), exp(z * -3)}); };
    f.in_plane = [&](const EllipseBox& box, std::vector<ComplexBall>& c) { all(box.z, c); };
    f.at_node = [&](const GaussNodes::Entry& e, bool mirrored, std::vector<Ball>& c) { all(mirrored ? -e.z : e.z, c); };
    const WorkingPrecision precision(200);
    const auto whole = by_ellipse(f, 120, false, 700);
    f.is_even = true;
    CHECK(f.partner(0) == 0);
    CHECK(f.partner(1) == 2);
    CHECK(f.partner(2) == 1);
    const auto half = by_ellipse(f, 120, false, 700);
    REQUIRE(whole);
    REQUIRE(half);
    CHECK(half->value.overlaps(whole->value));
    CHECK(half->value.relative_bits() >= 120);
    CHECK(half->nodes < whole->nodes);
    // the two logarithms alone
    EllipseFunction g = f;
    g.weights.erase(g.weights.begin());
    g.in_plane = [&](const EllipseBox& box, std::vector<ComplexBall>& c) { f.in_plane(box, c), c.erase(c.begin()); };
    g.at_node = [&](const GaussNodes::Entry& e, bool mirrored, std::vector<Ball>& c) { f.at_node(e, mirrored, c), c.erase(c.begin()); };
    const auto half_alone = by_ellipse(g, 120, false, 700);
    g.is_even = false;
    const auto alone = by_ellipse(g, 120, false, 700);
    REQUIRE(half_alone);
    REQUIRE(alone);
    CHECK(half_alone->value.overlaps(alone->value));
    CHECK(half_alone->value.relative_bits() >= 120);
    // exp(-3z) is small on the right half: it has the bound that its mirror image has there
    const long n = 2 * half->nodes;
    const Ball one = lemma::interpolation(half->bound, Ball::exactly(half->sigma), WeightedNodes::get(f.weights[1], n, 200)->size(), n);
    CHECK(arb_gt(half->discretisation.get(), (one * Ball(Rational(19, 10))).get()) != 0);
}

TEST_CASE("values at nodes are counted as they are taken, of an even function half of them")
{
    long taken = 0;
    EllipseFunction f;
    f.in_plane = [](const EllipseBox& box, std::vector<ComplexBall>& c) { c.assign(1, ComplexBall(1) / (2 + box.z * box.z)); };
    f.at_node = [&](const GaussNodes::Entry& e, bool, std::vector<Ball>& c) {
        taken += WorkingPrecision::bits() > strip_bits; // not those from which an ellipse is guessed
        c.assign(1, 1 / (2 + e.z * e.z));
    };
    for (const double bits : {70., 75., 80., 90., 100., 300.}) {
        CAPTURE(bits);
        long of_all = 0;
        for (const bool even : {false, true}) {
            f.is_even = even;
            taken = 0;
            const auto found = by_ellipse(f, bits, false, 700);
            REQUIRE(found);
            CHECK(found->nodes == taken);
            if (even) CHECK(4 * taken < 3 * of_all);
            of_all = taken;
        }
    }
}

TEST_CASE("an even formula with a root at an end: half of the integral over both sides, where that is one without a singularity in between")
{
    const auto is_both_sides = [](const Integral& i) { return i.parts.front().rule.find("both sides") != std::string::npos; };
    for (const auto& [from, to] : {std::pair("0", "1"), std::pair("-1", "0")}) {
        const Integral i = integral("sqrt(1-x^2)", from, to, 50);
        CHECK(is_both_sides(i));
        CHECK(arb_overlaps(i.value.get(), (pi<Ball>() / Ball(4)).get()));
        CHECK(i.value.relative_bits() > 166);
        CHECK(i.parts.front().evaluations > 10);
        CHECK(i.parts.front().evaluations < 50);
    }
    // singular at 0 as well, a wave, another half width, an end that is no rational number
    const Integral kink = integral("sqrt(x^2)*sqrt(1-x^2)", "0", "1");
    CHECK_FALSE(is_both_sides(kink));
    CHECK(kink.value.contains(Rational(1, 3)));
    const WorkingPrecision precision(256);
    const Integral bessel = integral("cos(3*x)/sqrt(4-x^2)", "0", "2", 40);
    CHECK(is_both_sides(bessel));
    CHECK(arb_overlaps(bessel.value.get(), (at("besselj(0,6)", 0) * pi<Ball>() / Ball(2)).get()));
    CHECK(bessel.value.relative_bits() > 132);
    const Integral to_pi = integral("1/sqrt(pi^2-x^2)", "0", "pi", 40);
    CHECK(arb_overlaps(to_pi.value.get(), (pi<Ball>() / Ball(2)).get()));
    // neither even nor about 0
    for (const auto& [formula, from, to] : {std::tuple("x*sqrt(1-x^2)", "0", "1"), std::tuple("sqrt(1-x^2)", "1/2", "1"),
                                            std::tuple("sqrt(1-x^2)*(1+x)", "0", "1"), std::tuple("sqrt(1-x^2)", "-1/2", "1")}) {
        CAPTURE(formula);
        CHECK_FALSE(is_both_sides(integral(formula, from, to)));
    }
    CHECK(integral("x*sqrt(1-x^2)", "-1", "1/2", 20).value.overlaps(at("-sqrt(27)/24", 0)));
}

TEST_CASE("about the middle an even formula takes half of the values, also where the middle is not 0; one whose parts hide it all")
{
    const long even = integral("1/(2+x^2)", "-1", "1", 40).parts.front().evaluations;
    const long shifted = integral("1/(2+(x-1)^2)", "0", "2", 40).parts.front().evaluations;
    const long hidden = integral("1/(3-2*x+x^2)", "0", "2", 40).parts.front().evaluations;
    CHECK(even == shifted);
    CHECK(even * 3 < hidden * 2);
    CHECK(arb_overlaps(integral("1/(2+x^2)", "-1", "1", 40).value.get(), integral("1/(2+(x-1)^2)", "0", "2", 40).value.get()));
    // of ends without an exact form nothing is said of their middle
    const Ball inexact = integral("1/(2+x^2)", "-zeta(3)", "zeta(3)", 40).value;
    CHECK(inexact.overlaps(integral("2/(2+x^2)", "0", "zeta(3)", 40).value));
    CHECK(inexact.relative_bits() > 132);
    CHECK(integral("1/(2+x^2)", "-zeta(3)", "1", 40).value.overlaps(at("(atan(zeta(3)/sqrt(2))+atan(1/sqrt(2)))/sqrt(2)", 0)));
    CHECK(integral("cos(x)/sqrt(zeta(3)^2-x^2)", "0", "zeta(3)", 12).status != Status::certified);
    CHECK(integral("exp(x)", "-1", "1", 40).value.overlaps(at("exp(1)-exp(-1)", 0)));
}

TEST_CASE("a power of a product or quotient: by its two factors where both lie in the right half plane, else its principal value or none")
{
    const WorkingPrecision precision(64);
    const auto value = [](const char* text, const ComplexBall& z) { return PlainFormula(parse_expression(text)).at(z); };
    struct Row {
        const char *power, *base;
        Exponent exponent;
    };
    // the quotient of these wide balls meets the cut, neither of them does
    CHECK_FALSE(analytic::sqrt(value("sin(x)/cos(x)", square(0.75, 0, 0.4))).is_finite());
    CHECK(value("sqrt(sin(x)/cos(x))", square(0.75, 0, 0.4)).is_finite());
    // so does their product
    CHECK_FALSE(analytic::sqrt(value("exp(x)*cosh(x)", square(0, 0, 0.65))).is_finite());
    const ComplexBall product = value("sqrt(exp(x)*cosh(x))", square(0, 0, 0.65));
    CHECK(product.is_finite());
    CHECK(acb_contains_int(product.get()) != 0); // 1 at 0
    CHECK(arb_lt(touchstone::abs(product).get(), Ball(4).get()) != 0);
    int finite = 0, wide_ones = 0;
    for (const Row& row : {Row{"sqrt(exp(x)/cosh(x))", "exp(x)/cosh(x)", {1, 2}}, Row{"sqrt(exp(x)*cosh(x))", "exp(x)*cosh(x)", {1, 2}},
                           Row{"(sin(x)/exp(x))^(1/3)", "sin(x)/exp(x)", {1, 3}}, Row{"(exp(x)*sin(x))^(-3/2)", "exp(x)*sin(x)", {-3, 2}},
                           Row{"sqrt(sin(x)*cos(x))", "sin(x)*cos(x)", {1, 2}}})
        for (const double re : {-2.5, -1.0, 0.4, 1.1, 2.0, 3.9, 5.0})
            for (const double im : {-1.5, -0.3, 0.2, 0.9}) {
                CAPTURE(row.power);
                CAPTURE(re);
                CAPTURE(im);
                for (const double half_side : {0.05, 0.3, 0.6, 0.9}) {
                    const ComplexBall wide = value(row.power, square(re, im, half_side));
                    if (!wide.is_finite()) continue;
                    ++(half_side > 0.1 ? wide_ones : finite);
                    const ComplexBall principal = analytic::rational_power(value(row.base, square(re, im, 0)), row.exponent);
                    CHECK(acb_overlaps(wide.get(), principal.get()) != 0);
                }
            }
    CHECK(finite > 100);
    CHECK(wide_ones > 20);
}

TEST_CASE("a formula that is even and analytic about 0 is known, and one that is even alone is not taken for it")
{
    const auto is_one = [](const char* formula, const char* from, const char* to) {
        return even_and_analytic_about_zero(parse_expression(formula), Range{parse_limit(from), parse_limit(to), Map::finite}).has_value();
    };
    for (const char* formula : {"ellipk(x^2)", "ellipe(x^2)*cos(x)", "log(1-x^2)*x^2", "1/(1-x^4)"}) {
        CAPTURE(std::string(formula));
        CHECK(is_one(formula, "0", "1"));
        CHECK(is_one(formula, "-1", "0"));
        CHECK_FALSE(is_one(formula, "1/2", "1"));
    }
    for (const char* formula : {"sqrt(x^2)*ellipk(x^2)", "log(x^2)", "x^(-2)", "x*ellipk(x^2)", "(x^2)^(3/2)*log(1-x^2)", "cos(x+1)"}) {
        CAPTURE(std::string(formula));
        CHECK_FALSE(is_one(formula, "0", "1"));
    }
}

TEST_CASE("of a part beside 0 about which the formula is even half of the nodes are enough; its other end is the nearer one")
{
    for (const char* formula : {"ellipk(x^2)", "ellipe(x^2)"}) {
        CAPTURE(std::string(formula));
        const Integral i = integral(formula, "0", "1", 50), mirrored = integral(formula, "-1", "0", 50);
        REQUIRE(i.parts.size() == 1);
        CHECK(i.parts.front().evaluations < 195); // 211 and 230 where all nodes of the part are asked for
        CHECK(mirrored.parts.front().evaluations < 195);
        CHECK(mirrored.value.overlaps(i.value));
    }
    struct Case {
        const char *formula, *value;
    };
    // even as text alone, and about 0 too: (2 G + 1)/4, G Catalan's constant
    const Case cases[] = {{"sqrt(x^2)*ellipk(x^2)", "1"},
                          {"sqrt(x^2)*ellipe(x^2)", "2/3"},
                          {"x^2*ellipk(x^2)", "0.7079827970886095075273017574661920553871"}};
    for (const Case& c : cases) {
        CAPTURE(std::string(c.formula));
        for (const auto& [from, to] : {std::pair("0", "1"), {"-1", "0"}}) {
            const Integral i = integral(c.formula, from, to, 30);
            CHECK(i.status == Status::certified);
            Ball value = evaluate_at(*parse_expression(c.value), Ball(0));
            widen(value, Ball(1) / ScalarTraits<Ball>::power_of_two(104));
            CHECK(i.value.overlaps(value));
        }
    }
}
