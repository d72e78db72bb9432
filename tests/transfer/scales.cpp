// SPDX-License-Identifier: MIT
/// Distributions at all scales: minutes of work.
#include "touchstone/paper/peaks.hpp"
#include "touchstone/recursion/from_the_edge/forward.hpp"

#include <doctest/doctest.h>

using namespace touchstone;
using namespace touchstone::transfer;

/// What the precision of these balls is meant for.
static Accuracy wanted() { return {accuracy_of(WorkingPrecision::bits()).digits + 1}; }

namespace {

const char* const G_text = "3.1622776601683795";
const Arguments figure_5{[] { return Ball(*parse_rational("0.001")); }, [] { return Ball(*parse_rational(G_text)); }};

Ball highest(long n)
{
    Ball unit;
    arb_pow_ui(unit.get(), figure_5.G().get(), static_cast<ulong>(n + 1), WorkingPrecision::bits());
    return unit * peaks::iterate(n, figure_5.load(), figure_5.G());
}
std::function<Ball()> share_of_highest(long n, const Ball& share)
{
    const WorkingPrecision precision(400);
    Ball p = highest(n) * share;
    arb_get_mid_arb(p.get(), p.get());
    return [p] { return p; };
}

} // namespace

TEST_CASE("scale 20: two laws, all of the area above p -> 0, and the order of things")
{
    const WorkingPrecision precision(bits_for_digits(16) + 48);
    for (const long n : {5L, 20L}) {
        CAPTURE(n);
        const Ball A = area(Scheme::force_weighted, n, figure_5, wanted());
        Ball last = A;
        for (const char* share : {"1e-12", "0.01", "0.3", "0.9", "0.999999999999"}) {
            CAPTURE(share);
            const auto p = share_of_highest(n, Ball(*parse_rational(share)));
            const Ball Q = exceedance(Law::density, n, p, figure_5, wanted());
            CHECK(Q.overlaps(exceedance(Law::exceedance, n, p, figure_5, wanted())));
            CHECK(Q.relative_bits() > 55);
            if (share[1] == 'e') CHECK(certainly(less(abs(Q / A - 1), Ball(*parse_rational("1e-18")))));
            else {
                CHECK(density(Law::density, n, p, figure_5, wanted()).overlaps(density(Law::exceedance, n, p, figure_5, wanted())));
                CHECK(certainly(less(Q, last)));
            }
            last = Q;
        }
    }
}

TEST_CASE("force and length are conserved at the scales 1 to 20, in balls")
{
    const WorkingPrecision precision(bits_for_digits(16) + 48);
    const Rational load = *parse_rational("0.001");
    for (long n = 1; n <= 20; ++n) {
        CAPTURE(n);
        const Ball length = mass(n, figure_5, wanted());
        CHECK(length.overlaps(area(Scheme::force_weighted, n, figure_5, wanted())));
        CHECK(length.relative_bits() > 35);
        for (const Law law : {Law::density, Law::exceedance}) {
            const Ball p = force(law, n, figure_5, wanted());
            CHECK(p.contains(load));
            CHECK(p.relative_bits() > 35);
        }
    }
}
