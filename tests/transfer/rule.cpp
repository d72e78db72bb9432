// SPDX-License-Identifier: MIT
/// The quadrature rules against closed forms: h = 1 averages to 1, and h = x^(s-1) to the hypergeometric
/// series of T[y^s]; the proven bounds must hold, and hold tightly.
#include "touchstone/transfer/rule.hpp"

#include <doctest/doctest.h>

using namespace touchstone;
using namespace touchstone::transfer;

namespace {

using Traits = ScalarTraits<Ball>;

/// int (4/pi) sech^3 v (x/y)^(1/2) y^e dv by a rule; e = 1/2 is F = x^(1/2) h with h = 1.
Ball by_rule(const Rule& rule, const Ball& G, const Ball& x, const Ball& e)
{
    Ball sum(0);
    for (const auto& q : rule.nodes) {
        const Ball y = 2 / G * sqrt(x * (1 + (1 - x) * q.sinh_squared)) * q.sech_squared;
        sum += q.area_weight * q.sech_squared * sqrt(x / y) * pow(y, e);
    }
    return sum;
}

/// The same in closed form: with y = (2/G) x^(1/2) (1-u^2)^(1/2) (1-x u^2)^(1/2) and b = e - 1/2,
/// x^(1/2) (2/G)^b x^(b/2) (2/pi) B(1/2, (b+3)/2) 2F1(-b/2, 1/2; b/2 + 2; x).
Ball closed_form(const Ball& G, const Ball& x, const Ball& e)
{
    const Ball b = e - Traits::quotient(1, 2);
    Ball beta = Traits::gamma(Traits::quotient(1, 2)) * Traits::gamma((b + 3) / 2) / Traits::gamma(b / 2 + 2), series;
    arb_hypgeom_2f1(series.get(), (-b / 2).get(), Traits::quotient(1, 2).get(), (b / 2 + 2).get(), x.get(), 0, WorkingPrecision::bits());
    return sqrt(x) * pow(2 / G, b) * pow(x, b / 2) * 2 / Traits::pi() * beta * series;
}

} // namespace

TEST_CASE("both rules agree with closed forms within their proven bounds")
{
    const WorkingPrecision precision(300);
    for (const char* g : {"2.05", "2.25", "10", "1000"}) {
        const Ball G(*parse_rational(g));
        for (const double accuracy : {50.0, 120.0}) {
            const Ratios all{2 / G, false}, one{Ball(1), true}, near{Ball(*parse_rational("0.999")), true};
            for (const Ratios* ratios : {&all, &one, &near})
                for (const bool gauss : {false, true}) {
                    CAPTURE(g); CAPTURE(accuracy); CAPTURE(gauss); CAPTURE(ratios->highest);
                    const double V = cut_off(*ratios, accuracy);
                    const Rule rule = gauss ? gauss_panel_rule(G, *ratios, accuracy, V) : double_exponential_rule(G, *ratios, accuracy, V);
                    for (const char* part : {"1", "0.5", "0.01", "1e-9"}) {
                        const Ball x = ratios->single ? ratios->highest : ratios->highest * Ball(*parse_rational(part));
                        for (const char* exponent : {"0", "1/4", "1/2"}) { // |F| <= 1, the bounds' only assumption
                            const Ball e(*parse_rational(exponent));
                            const Ball off = abs(by_rule(rule, G, x, e) - closed_form(G, x, e));
                            const Ball bound = (rule.discretisation + rule.truncation) * sqrt(sqrt(x));
                            CHECK(certainly(less(off, bound)));
                            CHECK(certainly(less(bound, exp(Ball(-static_cast<long>(accuracy) + 10)))));
                        }
                    }
                }
        }
    }
}

TEST_CASE("the bounds are not idle: with F_0, singular at y = 1, errors come near them")
{
    const WorkingPrecision precision(400);
    for (const char* g : {"2.05", "3.2", "10"}) {
        const Ball G(*parse_rational(g));
        const Ratios all{2 / G, false};
        const Ball& x = all.highest;
        const auto apply = [&](const Rule& rule) { // F_0 = (2/pi) arcsin(sqrt y)/sqrt y
            Ball sum(0);
            for (const auto& q : rule.nodes) {
                const Ball y = 2 / G * sqrt(x * (1 + (1 - x) * q.sinh_squared)) * q.sech_squared;
                sum += q.area_weight * q.sech_squared * sqrt(x / y) * 2 * asin(sqrt(y)) / (sqrt(y) * Traits::pi());
            }
            return sum;
        };
        const double far = cut_off(all, 120); // no truncation worth the name
        const Ball reference = apply(gauss_panel_rule(G, all, 120, far));
        for (const bool gauss : {false, true}) {
            CAPTURE(g); CAPTURE(gauss);
            const Rule rule = gauss ? gauss_panel_rule(G, all, 30, far) : double_exponential_rule(G, all, 30, far);
            const Ball off = abs(apply(rule) - reference), bound = rule.discretisation * sqrt(sqrt(x));
            CHECK(certainly(less(off, bound)));
            CHECK(certainly(less(bound, off * 10'000'000)));
        }
    }
}

TEST_CASE("bounds of the chain hold at complex points, for every load ratio in the range")
{
    const WorkingPrecision precision(128);
    const Ball G(*parse_rational("2.25"));
    const Ratios range{2 / G, false};
    for (int i = 0; i <= 12; ++i)
        for (int k = 0; k <= 12; ++k) {
            const ComplexBall v(Ball(i) / 4, Ball(k) / 9);
            const ChainBounds b = chain_bounds(v, G, range);
            const ComplexBall c = (exp(v) + exp(-v)) / 2, s = (exp(v) - exp(-v)) / 2;
            for (int j = 1; j <= 20; ++j) {
                const Ball x = range.highest * Ball(j) / 20;
                const Ball y = 2 / G * sqrt(x * abs(1 + ComplexBall(1 - x) * s * s)) / abs(c * c);
                CHECK_FALSE(certainly(less(b.modulus, y)));
                CHECK_FALSE(certainly(less(abs(1 - ComplexBall(x) * s * s / (c * c)), b.factor)));
            }
            CHECK(b.cosh_squared.overlaps(abs(c * c)));
        }
}
