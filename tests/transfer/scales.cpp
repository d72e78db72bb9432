// SPDX-License-Identifier: MIT
/// Distributions at all scales: minutes of work.
#include "touchstone/paper/peaks.hpp"
#include "touchstone/transfer/forward.hpp"

#include <doctest/doctest.h>

using namespace touchstone;
using namespace touchstone::transfer;

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

TEST_CASE("scale 20: two laws, mass, force, and the order of things")
{
    const WorkingPrecision precision(bits_for_digits(16) + 48);
    for (const long n : {5L, 20L}) {
        CAPTURE(n);
        const Ball A = area(Scheme::force_weighted, n, figure_5);
        const auto at_zero = share_of_highest(n, Ball(*parse_rational("1e-12")));
        Ball last = A;
        for (const char* share : {"1e-12", "0.01", "0.3", "0.9", "0.999999999999"}) {
            CAPTURE(share);
            const auto p = share_of_highest(n, Ball(*parse_rational(share)));
            const Ball Q = exceedance(Law::density, n, p, figure_5);
            CHECK(Q.overlaps(exceedance(Law::exceedance, n, p, figure_5)));
            CHECK(Q.relative_bits() > 55);
            if (share[1] == 'e') CHECK(certainly(less(abs(Q / A - 1), Ball(*parse_rational("1e-18")))));
            else {
                CHECK(density(Law::density, n, p, figure_5).overlaps(density(Law::exceedance, n, p, figure_5)));
                CHECK(certainly(less(Q, last)));
            }
            last = Q;
        }
        // int Q_n dp = int p q_n dp = load, p = p_max (1 - t^2), by Gauss-Legendre to that rule's accuracy
        Ball sum(0);
        const long points = 40;
        for (long i = 0; i < points; ++i) {
            Ball x, w;
            arb_hypgeom_legendre_p_ui_root(x.get(), w.get(), points, static_cast<ulong>(i), precision.bits());
            const Ball t = (1 + x) / 2;
            sum += w * t * exceedance(Law::density, n, share_of_highest(n, 1 - t * t), figure_5);
        }
        CHECK(certainly(less(abs(sum * highest(n) / figure_5.load() - 1), Ball(*parse_rational("1e-10")))));
    }
}
