// SPDX-License-Identifier: MIT
/// From which scale on the limit holds, areas far beyond it, and the ratio of approach.
#include "touchstone/catalogue/evaluate.hpp"
#include "touchstone/limit/approach.hpp"
#include "touchstone/limit/area_series.hpp"
#include "touchstone/limit/far_exceedance.hpp"
#include "touchstone/limit/poisson.hpp"
#include "touchstone/limit/scale.hpp"
#include "touchstone/transfer/series.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

using namespace touchstone;
using transfer::Scheme;

namespace {

const auto G_4 = [] { return Ball(4); };
const auto load_of_a_tenth = [] { return Ball(Rational(1, 10)); };

Ball off_limit(long n)
{
    const Ball C = limit::area_constant(Scheme::area, G_4, {15});
    return abs(transfer::area(Scheme::area, n, {load_of_a_tenth, G_4}, {20}) * pow(G_4(), Ball(n)) / load_of_a_tenth() / C - 1);
}

Evaluation eval(const char* name, std::map<std::string, Rational> in, long digits)
{
    return evaluate(*find_quantity(name), Inputs(std::move(in)), {digits});
}

} // namespace

TEST_CASE("the least scale is the least")
{
    const WorkingPrecision precision(128);
    const Rational tolerance(1, 10'000);
    const long n = limit::least_scale(Scheme::force_weighted, G_4, load_of_a_tenth, tolerance);
    REQUIRE(n > 2);
    CHECK(n < limit::scale(Ball(tolerance), 1000, G_4(), load_of_a_tenth()).value()); // sharper than the bound
    for (long m = n; m < n + 6; ++m) CHECK(certainly(less(off_limit(m), Ball(tolerance))));
    CHECK(certainly(less(Ball(tolerance), off_limit(n - 1))));
}

TEST_CASE("the least scale at a very light load: the areas next to it, by their power series, are not and are within the tolerance")
{
    const WorkingPrecision precision(128);
    const auto G = [] { return Ball(3); };
    const auto load = [] { return Ball(power(Rational(10), -130)); };
    const Rational tolerance(1, 2);
    const Ball C = limit::area_constant(Scheme::area, G, {15});
    const auto off = [&](long n) { return abs(transfer::area_series(n, load(), G()) * pow(G(), Ball(n)) / load() / C - 1); };
    const long n = limit::least_scale(Scheme::force_weighted, G, load, tolerance);
    CHECK(n == 9);
    CHECK(certainly(less(off(n), Ball(tolerance))));
    CHECK(certainly(less(Ball(tolerance), off(n - 1))));
}

/// (1/pi) int |1 - sin^2 theta/(x (x + cos theta))| dtheta: theorem 1, step 1.
static double contraction_in_full_contact(double x)
{
    constexpr int points = 20'000;
    double sum = 0;
    for (int i = 0; i < points; ++i) {
        const double c = std::cos(std::numbers::pi * (i + 0.5) / points);
        sum += std::fabs(1 - (1 - c * c) / (x * (x + c)));
    }
    return sum / points;
}

TEST_CASE("one wave in full contact brings two chains together by the rate of theorem 1: 0.8996, and beyond 2/3^(1/2) (1 - 1/x^2)^(1/2)")
{
    const WorkingPrecision precision(128);
    const Ball at = 2 / sqrt(Ball(3)), bound = 1 - 1 / (4 * at * (at + 1)); // it grows with x
    CHECK(certainly(less(bound, Ball(Rational(8996, 10'000)))));
    CHECK(certainly(less(Ball(Rational(8995, 10'000)), bound)));
    for (double x = 1.0001; x < 1.1547; x += 0.01) CHECK(contraction_in_full_contact(x) <= 1 - 1 / (4 * x * (x + 1)));
    for (const double x : {1.1548, 1.5, 3., 10., 50.})
        CHECK(contraction_in_full_contact(x) == doctest::Approx(std::sqrt(1 - 1 / (x * x))).epsilon(1e-7));
    // the rate that the bound decays with, where ratios have settled at 1/(G - 1) = 2
    const Ball rate = limit::distance_from_limit(2001, Ball(3) / 2, Ball(1)) / limit::distance_from_limit(2000, Ball(3) / 2, Ball(1));
    CHECK(certainly(less(abs(rate * rate - bound), Ball(Rational(1, 1'000'000)))));
    const Ball t = asin(sqrt(Ball(Rational(2, 3)))); // and of kappa_1, in closed form
    CHECK(limit::contraction(Ball(0), Ball(1)).overlaps((t + 3 * sin(2 * t) / 2) / ScalarTraits<Ball>::pi()));
    CHECK(certainly(less(abs(limit::distance_from_limit(0, Ball(3) / 2, Ball(3)) -
                             2 * sqrt(Ball(Rational(9, 2)) * (2 * log(Ball(3)) + log(Ball(Rational(13, 4)))))),
                         Ball(Rational(1, 1'000'000)))));
}

TEST_CASE("areas far beyond are those of the limit")
{
    const WorkingPrecision precision(256);
    const long n = 230;
    const transfer::Arguments at{load_of_a_tenth, G_4};
    const Ball followed = transfer::area(Scheme::force_weighted, n, at, {15}),
               limit = limit::area_in_the_limit(Scheme::force_weighted, n, at, {15});
    CHECK(followed.overlaps(limit));
    CHECK(limit.relative_bits() > 45);
    CHECK(limit::most_digits_of_area_in_the_limit(n, load_of_a_tenth(), G_4()) > 40);
    CHECK(limit::most_digits_of_area_in_the_limit(10, load_of_a_tenth(), G_4()) == 0);
    const Evaluation far = eval("contact.area", {{"n", 1'000'000}, {"load", Rational(1, 10)}, {"G", 4}}, 12);
    CHECK(far.status == Status::certified);
    const Ball by_hand = limit::area_constant(Scheme::area, G_4, {12}) * load_of_a_tenth() * pow(Ball(4), Ball(-1'000'000));
    CHECK(far.ball.overlaps(by_hand));
    CHECK(far.ball.relative_bits() > 40);
    CHECK_THROWS_AS(eval("contact.area", {{"n", 1'000'001}, {"load", Rational(1, 10)}, {"G", 4}}, 12), DomainError);
    // with full contact, by theorem 1
    CHECK(eval("contact.area", {{"n", 1'000'000}, {"load", 2}, {"G", 4}}, 12).ball.overlaps(20 * by_hand));
    const Evaluation full = eval("contact.area", {{"n", 10'000}, {"load", 20}, {"G", Rational(3, 2)}}, 5);
    CHECK(full.status == Status::certified);
    CHECK(full.ball.overlaps(limit::mean_by_poisson({}, [] { return Ball(3) / 2; }, {6}) * 20 * pow(Ball(3) / 2, Ball(-10'000))));
    CHECK(eval("contact.area", {{"n", 150}, {"load", 2}, {"G", Rational(51, 50)}}, 5).status != Status::certified); // not yet
}

TEST_CASE("slow: exceedances far beyond are those of the limiting distribution" * doctest::skip())
{
    const WorkingPrecision precision(256);
    const auto own_units = [](const Rational& P) { return [P] { return Ball(P); }; };
    const auto far = [&](long n, const Rational& P) { return limit::far_exceedance({n, own_units(P)}, {load_of_a_tenth, G_4}, {8}); };
    const Rational half(1, 2), p = power(Rational(4), 14) / 2;
    const Evaluation followed = eval("contact.exceedance", {{"n", 14}, {"p", p}, {"load", Rational(1, 10)}, {"G", 4}}, 3);
    CHECK(followed.status == Status::certified);
    CHECK(far(14, half).overlaps(followed.ball)); // the rate leaves a digit there
    CHECK_FALSE(far(14, Rational(6, 10)).overlaps(followed.ball));
}

TEST_CASE("exceedances far beyond: digits, and where there is none")
{
    const WorkingPrecision precision(256);
    const auto own_units = [](const Rational& P) { return [P] { return Ball(P); }; };
    CHECK(limit::far_exceedance({10'000, own_units(Rational(1, 2))}, {load_of_a_tenth, G_4}, {8}).relative_bits() > 24);
    CHECK(limit::no_far_exceedance({200, own_units(3)}, Ball(3) / 2) != ""); // G/(G - 1): the highest
    CHECK(limit::no_far_exceedance({200, own_units(Rational(299, 100))}, Ball(3) / 2).empty());
}

TEST_CASE("slow: exceedances far beyond with full contact are those of the limiting distribution" * doctest::skip())
{
    const WorkingPrecision precision(256);
    const Rational G(3, 2), half(1, 2), unit = power(G, 10'000);
    const auto share = [&](const Rational& at) { return eval("contact.exceedance", {{"n", 10'000}, {"p", at}, {"load", 3}, {"G", G}}, 5); };
    const Evaluation full = share(unit / 2), limiting = eval("limit.exceedance", {{"p", half}, {"G", G}}, 6),
                     area = eval("contact.area", {{"n", 10'000}, {"load", 3}, {"G", G}}, 6);
    CHECK(full.status == Status::certified);
    REQUIRE(full.second_look);
    CHECK(full.second_look->agrees);
    CHECK(full.ball.overlaps(limiting.ball * area.ball));
    CHECK(share(unit / 2000).status != Status::certified); // too low
}

TEST_CASE("the ratio of approach is near 1/2 for large G, the Hertzian value, and below it")
{
    const Evaluation e = eval("limit.gap", {{"G", 200}}, 8);
    CHECK(e.status == Status::certified);
    REQUIRE(e.second_look);
    CHECK(e.second_look->agrees);
    // first order in 4/G^2: |ds'/ds| is (1 - x u^2 + ...)/2, x = 4w/G^2, E[u^2] = 1/4, E[w] = m_0(1)
    const WorkingPrecision precision(72);
    const Ball small(Rational(1, 10'000)), first = (1 - limit::hertzian_moment(Ball(1)) / 4 * small) / 2;
    CHECK(certainly(less(abs(e.ball - first), small * small)));
    CHECK_FALSE(certainly(less(abs(e.ball - Ball(Rational(1, 2))), small * small)));
    CHECK(eval("limit.gap", {{"G", Rational(3, 2)}}, 8).status == Status::undecided);
}

TEST_CASE("bad input")
{
    const Rational load(1, 10);
    CHECK_THROWS_AS(eval("limit.scale", {{"G", 4}, {"load", load}, {"tolerance", 1}}, 3), DomainError);
    CHECK_THROWS_AS(eval("limit.scale", {{"G", 4}, {"load", load}, {"tolerance", 0}}, 3), DomainError);
    CHECK_THROWS_AS(eval("limit.scale", {{"G", 4}, {"load", 0}, {"tolerance", load}}, 3), DomainError);
    CHECK_THROWS_AS(eval("limit.gap", {{"G", 1}}, 3), DomainError);
    CHECK(eval("limit.scale", {{"G", 4}, {"load", 2}, {"tolerance", load}}, 3).status == Status::undecided);
    CHECK(eval("limit.scale", {{"G", 2}, {"load", 1}, {"tolerance", load}}, 3).status == Status::undecided);
}
