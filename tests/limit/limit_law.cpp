// SPDX-License-Identifier: MIT
/// Two routes to the limit (docs/limit.md): backwards, from the eigenfunction and Poisson's equation, and forwards, from the distribution.
/// They must give the same C(G), the same gap and the same limiting distributions.
#include "touchstone/limit/limit_law.hpp"
#include "touchstone/limit/area_constant.hpp"
#include "touchstone/limit/poisson.hpp"
#include "touchstone/limit/scale.hpp"
#include "touchstone/recursion/from_the_edge/forward.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace touchstone;
using limit::Question;

namespace {

double number(const Ball& b) { return arf_get_d(arb_midref(b.get()), ARF_RND_NEAR); }
Ball enclosure(const limit::Poisson& p)
{
    Ball mean = p.c;
    arb_add_error(mean.get(), Ball::exactly(p.error).get());
    return mean;
}
limit::LimitLaw law_of(double G) { return {Ball::exactly(G), {1e-10, G >= 2 ? 4 / (G * G) : 1 / (G - 1), 1e-6}, 10}; }

} // namespace

TEST_CASE("the constant is the same forwards and backwards")
{
    const WorkingPrecision precision(160);
    for (const double G : {2.25, 3., 10.}) {
        CAPTURE(G);
        const Witness forwards = limit::area_constant_by_law(Ball::exactly(G));
        const Ball backwards = limit::area_constant(transfer::Scheme::force_weighted, [=] { return Ball::exactly(G); }, {15});
        CHECK(number(forwards.value) == doctest::Approx(number(backwards)).scale(0).epsilon(1e-9));
        CHECK(certainly(less(abs(forwards.value - backwards), forwards.error)));
        CHECK(number(forwards.error) < 1e-5);
    }
}

TEST_CASE("slow: the gap is the same forwards and backwards" * doctest::skip()) // as both are the proven one (second_eigenvalue.cpp)
{
    const WorkingPrecision precision(160);
    for (const double G : {3.}) {
        CAPTURE(G);
        const auto [forwards, changed] = law_of(G).second_eigenvalue();
        const Witness backwards = limit::gap(transfer::Scheme::area, [=] { return Ball::exactly(G); }, Rational(1, 7));
        CHECK(changed < 1e-9);
        CHECK(forwards == doctest::Approx(number(backwards.value)).scale(0).epsilon(1e-7));
    }
}

TEST_CASE("the limit law is stationary: force is balanced, and its means do not change over one wave")
{
    const limit::LimitLaw law = law_of(1.5);
    double sum = 0;
    for (const double w : law.weights()) sum += w;
    CHECK(sum == doctest::Approx(1).epsilon(1e-12));
    // E_pi[1/x] = G C (corollary of theorem 1), 1/x being no function of the area
    CHECK(law.mean([](double x) { return 1 / x; }) == doctest::Approx(1.5 * 0.8890100093359493).epsilon(1e-6));
    limit::Vector f = law.nodes();
    for (double& x : f) x = std::log(x);
    const limit::Vector after = law.after(f);
    CHECK(limit::dot(law.weights(), after) == doctest::Approx(limit::dot(law.weights(), f)).scale(0).epsilon(1e-9));
}

TEST_CASE("the limiting distribution is the sixth, by a forward proof, as near as that has to be")
{
    const WorkingPrecision precision(256);
    const Ball G = Ball(3), P = Ball(1) / 2, load = Ball(1) / 10;
    constexpr long n = 6;
    const transfer::Arguments at{[=] { return load; }, [=] { return G; }};
    Ball scale;
    arb_pow_ui(scale.get(), G.get(), n, precision.bits());
    const Ball at_n = transfer::exceedance(transfer::Law::exceedance, n, [=] { return P * scale; }, at, {4}) * scale / load;
    const limit::Poisson p = limit::solve_poisson({Question::Of::pressure, P}, G, 1e-7);
    CHECK(p.error < 1e-4);
    CHECK(std::fabs(number(at_n / enclosure(p)) - 1) < 1e-2); // some 2^-n
    const Witness forwards = limit::mean_in_the_limit(G, {P * P / 4, P + Ball(1)}, [&](double x) {
        const double R = std::sqrt((1 - x) * (1 - x) + 0.25);
        return std::acos(std::min(1., R - x)) / (std::numbers::pi * x);
    });
    CHECK(certainly(less(abs(forwards.value - p.c), forwards.error + Ball::exactly(p.error))));
}

TEST_CASE("force above a pressure: its density is the pressure times that of contact")
{
    // the force between P1 and P2, int P q dP, lies between P1 and P2 times the contact there; at G = 1.7, with full contact, too
    const WorkingPrecision precision(256);
    for (const Ball& G : {Ball(17) / 10, Ball(3)}) {
        const Ball P1 = Ball(1) / 2, P2 = Ball(3) / 4;
        const auto mean = [&](Question::Of of, const Ball& P) { return enclosure(limit::solve_poisson({of, P}, G, 1e-4)); };
        const Ball above_P1 = mean(Question::Of::force, P1), force = above_P1 - mean(Question::Of::force, P2),
                   contact = mean(Question::Of::pressure, P1) - mean(Question::Of::pressure, P2);
        CHECK(certainly(less(P1 * contact, force)));
        CHECK(certainly(less(force, P2 * contact)));
        CHECK(certainly(less(Ball(0), contact)));
        CHECK(certainly(less(above_P1, Ball(1))));
    }
}

TEST_CASE("an interpolant has the values of the polynomial it is made of on every panel, and is constant beyond them")
{
    const limit::LimitLaw law(Ball(3), {1e-3, 4.0 / 9, 1e-3, {}}, 5);
    const auto f = [](double x) { return 1 + x * (2 - x * (3 - x * (1 + x))); };
    limit::Vector values;
    for (const double x : law.nodes()) values.push_back(f(x));
    const limit::LimitLaw::Interpolant interpolant(law, values);
    const auto [first, last] = std::minmax_element(law.nodes().begin(), law.nodes().end());
    for (int k = 0; k <= 200; ++k) {
        const double x = *first * std::pow(*last / *first, k / 200.0);
        CHECK(interpolant(x) == doctest::Approx(f(x)).scale(0).epsilon(1e-12));
    }
    CHECK(interpolant(*first / 1000) == interpolant(*first / 2000));
    CHECK(interpolant(*last * 1000) == interpolant(*last * 2000));
}
