// SPDX-License-Identifier: MIT
#include "touchstone/scalar/pair_ball.hpp"

namespace touchstone {

PairBall PairBall::around(const Ball& b)
{
    const WorkingPrecision precision(256);
    const double high = arf_get_d(arb_midref(b.get()), ARF_RND_NEAR);
    const Ball rest = b - Ball::exactly(high);
    const double low = arf_get_d(arb_midref(rest.get()), ARF_RND_NEAR);
    const Ball off = rest - Ball::exactly(low);
    mag_t radius;
    mag_init(radius);
    arb_get_mag(radius, off.get());
    const double bound = mag_get_d(radius);
    mag_clear(radius);
    return {Pair(high, low), rounded_up(bound)};
}

PairBall::Kept::Kept()
{
    const WorkingPrecision precision(192);
    const Ball turn = touchstone::pi<Ball>();
    pi = around(turn);
    one_over_pi = around(1 / turn);
    half = around(Ball(Rational(1, 2)));
    for (std::size_t j = 0; j < odd.size(); ++j) odd[j] = around(Ball(1) / Ball(2 * j + 1));
    for (std::size_t k = 0; k < angles.size(); ++k) angles[k] = around(atan2(Ball(k), Ball(angles.size() - 1)) / turn);
}

} // namespace touchstone
