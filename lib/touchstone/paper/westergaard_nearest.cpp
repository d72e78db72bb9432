// SPDX-License-Identifier: MIT
// Compiled with -ffp-contract=off, as scalar/double_double.hpp asks.
#include "touchstone/paper/westergaard_nearest.hpp"

#include "touchstone/paper/westergaard.hpp"
#include "touchstone/scalar/pair_ball.hpp"

#include <cfenv>

namespace touchstone::westergaard {
namespace {

TOUCHSTONE_INLINE bool to_nearest() { return std::fegetround() == FE_TONEAREST; }

} // namespace

TOUCHSTONE_CLONES [[gnu::flatten]] std::optional<double> nearest_half_width(double load)
{
    if (!(to_nearest() && load > 0 && load <= 1)) return std::nullopt;
    return nearest_double(half_width(PairBall::exactly(load)));
}

TOUCHSTONE_CLONES [[gnu::flatten]] std::optional<double> nearest_exceedance(double p, double load)
{
    if (!(to_nearest() && load > 0 && p >= 0)) return std::nullopt;
    return nearest_double(exceedance(PairBall::exactly(p), PairBall::exactly(load)));
}

TOUCHSTONE_CLONES [[gnu::flatten]] std::optional<double> nearest_density(double p, double load)
{
    if (!(to_nearest() && load > 0 && p >= 0)) return std::nullopt;
    const PairBall pressure = PairBall::exactly(p), s = PairBall::exactly(load);
    const bool at_edge = load < 1 && less(pressure * pressure, 4 * s) ==
                                         less(4 * s, pressure * pressure); // both no, or not known; load >= 1 divides by zero
    return at_edge ? std::nullopt : nearest_double(density(pressure, s));
}

} // namespace touchstone::westergaard
