// SPDX-License-Identifier: MIT
/// The limiting density (docs/limit.md, theorem 6) against certified exceedances, forces and densities at finite scales, and the distance
/// of a distribution from its limit (theorem 7).
#include "touchstone/catalogue/evaluate.hpp"
#include "touchstone/limit/approach.hpp"
#include "touchstone/limit/limit_law.hpp"
#include "touchstone/limit/poisson.hpp"
#include "touchstone/scalar/refusal.hpp"
#include "touchstone/recursion/from_the_edge/forward.hpp"
#include "touchstone/transfer/contact.hpp"
#include "touchstone/transfer/two_waves.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace touchstone;
using limit::Question;

namespace {

Ball enclosure(const limit::Poisson& p)
{
    Ball mean = p.c;
    arb_add_error(mean.get(), Ball::exactly(p.error).get());
    return mean;
}
Ball mean(Question::Of of, const Ball& P, const Ball& G, double tolerance)
{
    return enclosure(limit::solve_poisson({of, P}, G, tolerance));
}

Evaluation eval(const char* name, std::map<std::string, Rational> in, long digits)
{
    return evaluate(*find_quantity(name), Inputs(std::move(in)), {digits});
}

} // namespace

TEST_CASE("the density is the slope of the exceedance, with full contact too")
{
    const WorkingPrecision precision(256);
    const Ball P = Ball(3) / 5, h = Ball(1) / 10;
    for (const auto& [G, tolerance] : {std::pair{Ball(3), 1e-5}, {Ball(19) / 10, 2e-4}}) {
        const Ball fall = mean(Question::Of::pressure, P - h, G, tolerance) - mean(Question::Of::pressure, P + h, G, tolerance),
                   slope = 2 * h * G * mean(Question::Of::density, P, G, tolerance);
        CAPTURE(G.to_string());
        CHECK(slope.radius_bound() < 1e-2);
        CHECK(certainly(less(abs(slope / fall - 1), Ball(Rational(1, 20)))));
        CHECK(certainly(less(Ball(Rational(1, 100)), fall)));
    }
}

TEST_CASE("the density at scale 4 is the limiting one, as near as that has to be")
{
    const Evaluation limiting = eval("limit.density", {{"p", Rational(1, 2)}, {"G", 3}}, 6);
    CHECK(limiting.status == Status::certified);
    CHECK(limiting.second_look->agrees);
    constexpr long n = 4;
    const WorkingPrecision precision(128);
    const transfer::Arguments at{[] { return Ball(1) / 10; }, [] { return Ball(3); }};
    const Ball unit = pow(Ball(3), Ball(n));
    const Ball density = transfer::density(transfer::Law::density, n, [&] { return unit / 2; }, at, {5}) * unit /
                         transfer::area(transfer::Scheme::force_weighted, n, at, {8});
    CHECK(certainly(less(abs(density / limiting.ball - 1), Ball(Rational(1, 10)))));
    CHECK_FALSE(certainly(less(abs(density / limiting.ball - 1), Ball(Rational(1, 1'000'000))))); // not yet in the limit
}

TEST_CASE("the second look's density after two waves is the proof's")
{
    const WorkingPrecision precision(256);
    for (const auto& [P, x] : {std::pair{0.5, 0.3}, {0.5, 0.9}, {1.5, 1.8}, {2.5, 2.0}, {0.75, 3.1}}) {
        const transfer::TwoWaves waves(Ball(3) / 2, Ball::exactly(P), 1e-12);
        const auto [value, error] = waves.value(Ball::exactly(x));
        CAPTURE(P);
        CAPTURE(x);
        CHECK(limit::density_after_two_waves(1.5, P, x) ==
              doctest::Approx(double(value)).epsilon(3e-5)); // inverse square roots near one another
    }
}

TEST_CASE("edges of the limiting density")
{
    CHECK(eval("limit.density", {{"p", Rational(4, 3)}, {"G", 3}}, 6).value == "0");
    CHECK(eval("limit.density", {{"p", Rational(1, 513)}, {"G", 3}}, 6).status == Status::undecided);
    CHECK(eval("limit.density", {{"p", 1}, {"G", Rational(101, 100)}}, 6).status == Status::undecided);
    CHECK_THROWS_AS(eval("limit.density", {{"p", 0}, {"G", 3}}, 6), DomainError);
    CHECK_THROWS_AS(eval("limit.density", {{"p", 1}, {"G", 1}}, 6), DomainError);
    const WorkingPrecision precision(256);
    CHECK_THROWS_AS(limit::solve_poisson({Question::Of::density, Ball(Rational(1, 5000))}, Ball(3), 1e-6), BeyondReach);
}

TEST_CASE("a density's Phi may be anything too")
{
    const WorkingPrecision precision(256);
    const Ball G(3), P = Ball(1) / 2;
    const limit::Poisson good = limit::solve_poisson({Question::Of::density, P}, G, 1e-5),
                         bad = limit::solve_poisson({Question::Of::density, P}, G, 1e-5,
                                                    [](double y0, double y1) { return y0 < 0.1 && y1 > 0.1 ? 1e-2 : 0.; });
    CHECK(good.error < 1e-2);
    CHECK(bad.error > 10 * good.error);
    CHECK(enclosure(good).overlaps(enclosure(bad)));
}

TEST_CASE("the distance from the limit is a difference of certified shares, and below the bound for all pressures")
{
    const Evaluation at_5 = eval("limit.distance", {{"n", 5}, {"p", Rational(1, 2)}, {"load", Rational(1, 10)}, {"G", 3}}, 4);
    CHECK(at_5.status == Status::certified);
    CHECK(at_5.value == "-0.002490");
    CHECK(at_5.second_look->agrees);
    CHECK(at_5.second_look->digits >= 4);
    const Evaluation at_8 = eval("limit.distance", {{"n", 8}, {"p", Rational(1, 2)}, {"load", Rational(1, 10)}, {"G", 3}}, 3);
    const WorkingPrecision precision(128);
    const Ball C = limit::area_constant_by_law(Ball(3)).value;
    for (const auto& [e, n] : {std::pair{&at_5, 5L}, {&at_8, 8L}})
        CHECK(certainly(less(abs(e->ball), 2 * limit::distance_from_limit(n, Ball(3), Ball(Rational(1, 10))) / C)));
    CHECK(certainly(less(6 * abs(at_8.ball), abs(at_5.ball)))); // by about 1/2 a scale
    CHECK(eval("limit.distance", {{"n", 5}, {"p", 10}, {"load", Rational(1, 10)}, {"G", 3}}, 4).value == "0");
    CHECK_THROWS_AS(eval("limit.distance", {{"n", 101}, {"p", 1}, {"load", 1}, {"G", 3}}, 4), DomainError);
    CHECK_THROWS_AS(eval("limit.distance", {{"n", 1}, {"p", 0}, {"load", 1}, {"G", 3}}, 4), DomainError);
}

TEST_CASE("the share of one wave above a pressure, over its ratio, changes by at most 2 x^(-1/2) |log x - log x'|^(1/2), theorem 1 step 3")
{
    const auto over_x = [](double P, double x) { // P = 0: in contact
        const double c = x >= 1 ? P - x : std::sqrt((1 - x) * (1 - x) + P * P) - x;
        return std::acos(std::fmin(1, std::fmax(-1, c))) / (3.141592653589793 * x);
    };
    double most = 0;
    for (const double P : {0., 0.1, 0.5, 1., 1.9, 2.1, 4.})
        for (double x = 1e-3; x < 20; x *= 1.03)
            for (double ratio = 1.0005; ratio < 50; ratio *= 1.07)
                most = std::fmax(most, std::fabs(over_x(P, x) - over_x(P, x * ratio)) * std::sqrt(x / std::log(ratio)));
    CHECK(most <= 2);
    CHECK(most > 0.5); // what is looked at is not all far below
}

TEST_CASE("the rate of approach for every load: in partial contact 1/2 a scale, and never above 1")
{
    const WorkingPrecision precision(128);
    const auto ratio = [](long n, const Ball& G, const Ball& load) {
        return limit::distance_from_limit(n + 1, G, load) / limit::distance_from_limit(n, G, load);
    };
    CHECK(ratio(3, Ball(4), Ball(1) / 10).overlaps(sqrt(Ball(1) / 2)));
    CHECK(certainly(
        less(abs(ratio(3, Ball(Rational(21, 10)), Ball(1) / 10) - sqrt(Ball(*parse_rational("0.75425")))), Ball(Rational(1, 10000)))));
    CHECK(certainly(less(ratio(30, Ball(3) / 2, Ball(20)), Ball(Rational(95, 100)))));
    CHECK(certainly(less(ratio(3, Ball(3) / 2, Ball(20)), Ball(1))));
}
