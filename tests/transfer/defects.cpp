// SPDX-License-Identifier: MIT
/// D_m >= |T V_(m-1) - V_m| at random ratios, for V_m that jump at every edge of the mesh: whether the intervals of the proof leave none out, and whether
/// what it takes from finitely many points holds between them. The values of T V are those of layer.hpp, which has a test of its own.
#include "touchstone/transfer/defects.hpp"

#include <doctest/doctest.h>

#include <random>

using namespace touchstone;
using namespace touchstone::transfer;
using namespace touchstone::transfer::levels;

namespace {

constexpr double tolerance = 1e-6;
constexpr int levels_made = 4;

/// The largest defect known about x.
double defect_at(const std::vector<Part>& parts, const Real& x)
{
    double found = 0;
    for (const Part& p : parts)
        if (p.y0 <= x && x <= p.y1) found = std::max(found, p.defect);
    return found;
}

struct Seen {
    long points = 0;
    double closest = 0; ///< largest of difference/defect
};

Seen look(double G_, double jumps, double highest)
{
    const Real G = G_;
    const Rules rules(tolerance);
    const auto first = in_contact();
    std::mt19937_64 random(20261122);
    std::uniform_real_distribution<double> unit(0, 1);
    const Spoiled spoiled = [&](int m, double, double) { return m == 1 ? jumps * unit(random) : 0; };
    const auto V = collocate(rules, *first, G, highest, tolerance, levels_made, spoiled);
    Defects D(rules, *V, levels_made, tolerance, true);
    D.prove_level_zero(*first);
    D.prove_steps();
    D.add_up();
    Seen seen;
    Result there;
    for (int m = 1; m < levels_made; ++m) {
        const auto parts = D.parts(m, bounds::infinite);
        for (std::size_t i = 1; i + 1 < V->panels.size(); ++i)
            for (int k = 0; k < 12; ++k) {
                const Panel& p = V->panels[i];
                const Real x = p.y0 + (p.y1 - p.y0) * unit(random);
                if ((x + 1) / G * ((x + 1) / G) > V->panels.back().z1) continue; // sees beyond the mesh
                V->apply(x, there);
                const double difference = std::fabs(double(there.value[m - 1] - V->value(i, m, (x * x - p.centre) / p.half))) - there.error[m - 1];
                INFO("G = ", G_, ", level ", m, ", x = ", double(x), ": ", difference, " <= ", defect_at(parts, x));
                REQUIRE(difference <= defect_at(parts, x));
                seen.closest = std::max(seen.closest, difference / defect_at(parts, x));
                ++seen.points;
            }
    }
    return seen;
}

} // namespace

TEST_CASE("defects hold between the points they were found from")
{
    for (const double jumps : {0.0, 1e-5, 1e-2})
        for (const double G : {1.25, 2.5}) {
            const Seen seen = look(G, jumps, 6);
            INFO("jumps ", jumps, ", G = ", G, ": ", seen.points, " points, at most ", seen.closest, " of the defect");
            CHECK(seen.points > 1000);
            CHECK(seen.closest > 0.05); // the test would see a defect that is too small
        }
}
