// SPDX-License-Identifier: MIT
/// C(G) from any Phi (docs/limit.md, theorem 4): against the other proof where both hold, against estimates where only it does, and with
/// Phi spoilt.
#include "touchstone/limit/area_constant.hpp"
#include "touchstone/limit/limit_law.hpp"
#include "touchstone/limit/poisson.hpp"
#include "touchstone/scalar/refusal.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace touchstone;

namespace {

Ball enclosure(const limit::Poisson& p)
{
    Ball C = p.c;
    arb_add_error(C.get(), Ball::exactly(p.error).get());
    return C;
}

} // namespace

TEST_CASE("two proofs that share neither grid nor bound agree where both hold")
{
    const WorkingPrecision precision(160);
    const Ball G = Ball(5) / 2;
    const limit::Poisson p = limit::solve_poisson({}, G, 1e-7);
    const Ball other = limit::area_constant(transfer::Scheme::force_weighted, [&] { return G; }, {15});
    CHECK(p.error < 1e-5);
    CHECK(enclosure(p).overlaps(other));
}

TEST_CASE("below 2 the estimate lies in the enclosure")
{
    const WorkingPrecision precision(160);
    const Ball G = Ball(3) / 2;
    const limit::Poisson p = limit::solve_poisson({}, G, 1e-6);
    const Witness w = limit::area_constant_by_law(G);
    CHECK(p.error < 1e-4);
    CHECK(certainly(less(abs(w.value - p.c), Ball::exactly(p.error))));
}

TEST_CASE("the bound falls as the tolerance does: nothing is lost beyond the mesh")
{
    const WorkingPrecision precision(256);
    CHECK(limit::solve_poisson({limit::Question::Of::pressure, Ball(*parse_rational("0.499"))}, Ball(3), 1e-15).error < 1e-13);
}

TEST_CASE("a search for digits ends")
{
    const WorkingPrecision precision(256);
    CHECK_THROWS_AS(limit::mean_by_poisson({}, [] { return Ball(3); }, {24}), BeyondReach);
}

TEST_CASE("Phi may be anything: what it is made worse by is in the bound")
{
    const WorkingPrecision precision(160);
    const Ball G = Ball(3) / 2, C = limit::area_constant_by_law(G).value;
    const limit::Poisson good = limit::solve_poisson({}, G, 1e-5);
    for (const bool everywhere : {true, false}) {
        const limit::Poisson bad =
            limit::solve_poisson({}, G, 1e-5, [=](double y0, double y1) { return everywhere || (y0 < 0.7 && y1 > 0.7) ? 1e-2 : 0.; });
        CAPTURE(everywhere);
        CHECK(bad.error > 10 * good.error);
        CHECK(enclosure(bad).overlaps(C));
    }
}

TEST_CASE("no constant is claimed where the mesh cannot be made")
{
    const WorkingPrecision precision(256);
    CHECK_THROWS_AS(limit::solve_poisson({}, Ball(1), 1e-9), BeyondReach);
    CHECK_THROWS_AS(limit::solve_poisson({}, Ball(*parse_rational("1001/1000")), 1e-9), BeyondReach);
    Ball vague = Ball(3) / 2;
    arb_add_error_2exp_si(vague.get(), -80);
    CHECK_THROWS_AS(limit::solve_poisson({}, vague, 1e-9), BeyondReach);
}
