// SPDX-License-Identifier: MIT
/// \file
/// Panels between the singular points of a function of the load ratio, shrinking towards them (heavy_load.hpp).
///
/// Internal to transfer/.
#pragma once

#include "touchstone/transfer/chain.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace touchstone::transfer::heavy_load {

inline double approximate(const Ball& b) { return arf_get_d(arb_midref(b.get()), ARF_RND_NEAR); }
inline double upper_double(const Ball& b)
{
    const Ball u = upper(b);
    return arf_get_d(arb_midref(u.get()), ARF_RND_UP);
}
/// An exact number at most / at least b, as near as the precision allows.
inline Ball below(const Ball& b)
{
    Ball r;
    arb_get_lbound_arf(arb_midref(r.get()), b.get(), WorkingPrecision::bits());
    return r;
}
inline Ball above(const Ball& b)
{
    Ball r;
    arb_get_ubound_arf(arb_midref(r.get()), b.get(), WorkingPrecision::bits());
    return r;
}
inline bool is_below(const Ball& a, const Ball& b) { return certainly(less(a, b)); }

/// A point of S, or an end of a range: somewhere in [lo, hi], both exact.
struct Bracket {
    Ball lo, hi;
};

/// How panels are graded.
struct Shape {
    double ratio, rho;
};

/// One panel: mid +- half, its distance to the nearer end of the interval, and its Chebyshev points.
struct Panel {
    Ball mid, half;
    long points;
    std::size_t first;
    double entered = 0; ///< sum of |weights|, rounded up
};

/// An interval between points of S, or a piece of one: panels shrinking towards both ends.
struct Graded {
    Ball lo, hi, middle, reach; ///< reach = (hi - lo)/2
    double ratio;
    long depth;                 ///< panels on either side; the last ends at reach ratio^-depth from the end
    Ball last() const { return reach * power(-depth); }
    Ball power(long k) const
    {
        Ball r = Ball::exactly(ratio);
        arb_pow_ui(r.get(), r.get(), static_cast<ulong>(std::abs(k)), WorkingPrecision::bits());
        return k < 0 ? 1 / r : r;
    }
};
inline Graded graded(const Ball& lo, const Ball& hi, double ratio, double last)
{
    Graded g{lo, hi, (lo + hi) / 2, (hi - lo) / 2, ratio, 1};
    g.depth = std::max(1L, static_cast<long>(std::ceil(std::log(approximate(g.reach) / last) / std::log(ratio))));
    return g;
}

} // namespace touchstone::transfer::heavy_load
