// SPDX-License-Identifier: MIT
/// Twenty digits: minutes of work.
#include "touchstone/catalogue/quantity.hpp"
#include "touchstone/transfer/contact.hpp"
#include "touchstone/recursion/from_the_edge/forward.hpp"
#include "touchstone/transfer/heavy_load.hpp"
#include "touchstone/transfer/proven_levels.hpp"

#include <doctest/doctest.h>

using namespace touchstone;
using transfer::ProvenLevels;

/// What the precision of these balls is meant for.
static Accuracy wanted() { return {accuracy_of(WorkingPrecision::bits()).digits + 1}; }

TEST_CASE("to fifteen digits: against partial contact's proof, and under load 10 against the one that tracks singular points")
{
    const Ball G(4);
    const ProvenLevels levels(G, 10, 1e-17);
    const WorkingPrecision precision(110);
    for (const auto& [text, n] : {std::pair{"1/10", 1L}, {"1/10", 20L}, {"1", 3L}, {"10", 1L}, {"10", 2L}, {"10", 20L}}) {
        const Ball load(*parse_rational(text)), proven = levels.share(n, load);
        const transfer::Arguments at{[&] { return load; }, [&] { return G; }};
        const Ball known = n > 0 && text == std::string("10") ? transfer::area_at_heavy_load(transfer::Scheme::area, n, at, wanted())
                                                              : transfer::area(transfer::Scheme::area, n, at, wanted());
        INFO("load ", text, " n ", n, ": ", proven.to_string(), " ", known.to_string());
        CHECK(proven.overlaps(known));
        CHECK(proven.radius_bound() < 1e-14);
        CHECK(known.radius_bound() < 1e-14);
    }
}

TEST_CASE("densities: partial contact's proof, to scale 3")
{
    const WorkingPrecision precision(256);
    { // G = 5/2, load 1/2: partial contact at every scale
        const Ball G = Ball(5) / 2, load = Ball(1) / 2, P = Ball(1) / 4;
        const ProvenLevels levels = ProvenLevels::densities(G, P, 0.5, 1e-6, 4);
        for (const long n : {2L, 3L}) {
            Ball unit(1);
            for (long k = 0; k < n; ++k) unit *= G;
            const Ball share = levels.share(n - 1, load);
            const Ball known =
                transfer::density(
                    transfer::Law::density, n, [&] { return P * unit; }, {[&] { return load; }, [&] { return G; }}, wanted()) *
                unit;
            INFO("n ", n, ": ", share.to_string(), " ", known.to_string());
            CHECK(share.overlaps(known));
            CHECK(share.radius_bound() < 1e-6);
        }
    }
}

TEST_CASE("to twenty digits: areas against partial contact's proof at sqrt 10, figure 5's case")
{
    const auto G_at = [] { return sqrt(Ball(10)); };
    const WorkingPrecision precision(200);
    const ProvenLevels levels(G_at(), 1, 1e-23);
    for (const char* text : {"1/1000", "1/10", "1"})
        for (const long n : {1L, 2L, 3L, 7L, 20L}) {
            const Ball load(*parse_rational(text)), proven = levels.share(n, load);
            const Ball known = transfer::area(transfer::Scheme::area, n, {[&] { return load; }, G_at}, wanted());
            INFO("load ", text, " n ", n, ": ", proven.to_string(), " ", known.to_string());
            CHECK(proven.contains(known));
            CHECK(certainly(less(Ball::exactly(proven.radius_bound()), known * Ball(*parse_rational("1e-20")))));
        }
}

TEST_CASE("to twenty digits: a share above a pressure")
{
    const auto G_at = [] { return Ball(5) / 2; };
    const WorkingPrecision precision(150);
    const Ball pressure(*parse_rational("3/4"));
    const ProvenLevels levels(G_at(), pressure, 1, 1e-23);
    for (const long n : {1L, 2L, 3L}) {
        const auto p_at = [&] {
            Ball p = pressure;
            for (long k = 0; k < n; ++k) p *= G_at();
            return p;
        };
        const Ball proven = levels.share(n, Ball(1)),
                   known = transfer::exceedance(transfer::Law::density, n, p_at, {[] { return Ball(1); }, G_at}, wanted());
        INFO("n ", n, ": ", proven.to_string(), " ", known.to_string());
        CHECK(proven.overlaps(known));
        CHECK(proven.radius_bound() < 1e-20);
    }
}
