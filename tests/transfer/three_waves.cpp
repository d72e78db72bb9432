// SPDX-License-Identifier: MIT
#include "touchstone/transfer/three_waves.hpp"

#include "touchstone/scalar/refusal.hpp"
#include "touchstone/transfer/contact.hpp"
#include "touchstone/recursion/from_the_edge/forward.hpp"
#include "touchstone/transfer/proven_levels.hpp"

#include <doctest/doctest.h>

using namespace touchstone;
using transfer::density_after_three_waves;

namespace {

Ball number(const char* text) { return Ball(*parse_rational(text)); }

} // namespace

TEST_CASE("three waves in partial contact: the forward chain's densities, to twenty digits")
{
    const WorkingPrecision precision(256);
    struct {
        const char *G, *P, *load;
    } const cases[] = {{"5/2", "1/4", "1/2"}, {"3", "1/100", "1"}, {"5/2", "3/5", "9/10"}};
    for (const auto& c : cases) {
        const Ball G = number(c.G), P = number(c.P), load = number(c.load);
        const Ball known = transfer::density(transfer::Law::density, 2, [&] { return P * G * G; }, {[&] { return load; }, [&] { return G; }}, Accuracy{24}) * G * G;
        const Ball own = density_after_three_waves(G, P, load, 1e-20).value;
        INFO("G ", c.G, " P ", c.P, " load ", c.load, ": ", own.to_string(), " ", known.to_string());
        CHECK(own.overlaps(known));
        CHECK(own.radius_bound() < 2e-20);
        CHECK(known.radius_bound() < 1e-22);
    }
}

TEST_CASE("three waves with full contact: the levels proven on a mesh, and a third route")
{
    const WorkingPrecision precision(256);
    {
        const Ball G(2), own = density_after_three_waves(G, Ball(9) / 40, Ball(1), 1e-17).value / (G * G);
        INFO(own.to_string());
        CHECK(own.overlaps(number("0.02439282952663530310"))); // nested integrals, cut at singular points
        CHECK(own.radius_bound() < 1e-17);
    }
    const Ball G = Ball(3) / 2, P = Ball(1) / 2;
    const auto levels = transfer::ProvenLevels::densities(G, P, 3, 1e-6, 1);
    for (const char* load : {"1/10", "1", "3", "2.640625"}) { // the last one's wave ends on a logarithm
        const Ball own = density_after_three_waves(G, P, number(load), 1e-12).value, known = levels.share(1, number(load));
        INFO("load ", load, ": ", own.to_string(), " ", known.to_string());
        CHECK(own.overlaps(known));
        CHECK(own.radius_bound() < 1e-12);
        CHECK(known.radius_bound() < 1e-5);
    }
}

TEST_CASE("three waves: what is claimed coarsely holds what is claimed finely, next to singular points too")
{
    const WorkingPrecision precision(256);
    struct {
        const char *G, *P, *load;
    } const cases[] = {{"3/2", "6/5", "1.31"}, {"2", "1", "1"}, {"3/2", "6/5", "1.31000000000000000000001"}, {"3/2", "1/2", "0.999999999999999999999999999999"}, {"21/20", "3", "90"}};
    for (const auto& c : cases) {
        const Ball coarse = density_after_three_waves(number(c.G), number(c.P), number(c.load), 1e-4).value;
        const Ball fine = density_after_three_waves(number(c.G), number(c.P), number(c.load), 1e-14).value;
        INFO("G ", c.G, " P ", c.P, " load ", c.load, ": ", coarse.to_string(), " ", fine.to_string());
        CHECK(coarse.overlaps(fine));
        CHECK(coarse.radius_bound() < 1e-4);
        CHECK(fine.radius_bound() < 1e-14);
    }
}

TEST_CASE("three waves: the finest tolerance that is offered ends, where a wave's end and a logarithm meet (G = 2, load 1)")
{
    const WorkingPrecision precision(256);
    const Ball own = density_after_three_waves(Ball(2), Ball(9) / 40, Ball(1), 1e-24).value, coarse = density_after_three_waves(Ball(2), Ball(9) / 40, Ball(1), 1e-10).value;
    INFO(own.to_string(), " ", coarse.to_string());
    CHECK(own.overlaps(coarse));
    CHECK(own.radius_bound() < 1e-23);
}

TEST_CASE("three waves: what cannot be had is refused")
{
    CHECK_THROWS_AS(density_after_three_waves(Ball(1), Ball(1), Ball(1), 1e-9), BeyondReach);
    CHECK_THROWS_AS(density_after_three_waves(Ball(2), Ball(0), Ball(1), 1e-9), BeyondReach);
    CHECK_THROWS_AS(density_after_three_waves(Ball(2), Ball(1), Ball(0), 1e-9), BeyondReach);
    Ball vague(1);
    arb_add_error_2exp_si(vague.get(), -60);
    CHECK_THROWS_AS(density_after_three_waves(Ball(2), Ball(1), vague, 1e-9), BeyondReach);
}
