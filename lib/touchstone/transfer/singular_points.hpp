// SPDX-License-Identifier: MIT
/// \file
/// Where the functions of the recursion are not smooth in the load ratio, once full contact occurs.
///
/// **Areas.** B_0 has a square root at x = 1, (6.6). If B_m has a singular point s, then B_{m+1} has one where s meets an end of
/// a wave: at x = G s + 1; at x = G s - 1 if that is >= 1, else at x = G^2 s^2/4 (exactly one of the two, since
/// G s - 1 >= 1 means s >= 2/G); and s = 0, the lower end of all waves with x <= 1, adds x = 1 afresh at every
/// level. So the singular points of all levels are the images of 1, and a point of generation g is singular from
/// level g on. Near an image of generation g the function behaves, on one side or both, as c eps^((g+1)/2), times log eps
/// where the wave's end passes inside: the square-root end of the wave's density adds half a power each time.
///
/// **Exceedances.** E_k(x), the share of lambda_0 where the k-th ratio is above x, has square roots at the ends of the first
/// wave's range: x = (load +- 1)/G, or 2 sqrt(load)/G. A singular point s of E_k is met by an end of (W3), (W4) at the pressures
/// P = s + 1, s - 1 for s >= 1 and P = 2 sqrt(s) for s < 1: so E_{k+1} has one at x = P/G. At P = 2 full contact takes
/// over from partial contact and (W4) ends: x = 2/G is singular at every level.
#pragma once

#include "touchstone/scalar/ball.hpp"

#include <vector>

namespace touchstone::transfer {

struct SingularPoint {
    Ball position;
    int generation; ///< of the strongest of the points merged here
};

struct Tracking {
    Ball reach;      ///< points in (0, reach], and their images beyond it: an interval that ends at the reach has them as neighbours
    int generations; ///< 0 to this, exclusive
    double merge;    ///< points closer than this, relative to the larger, are one, the stronger: the caller says what that neglects
};

/// The singular points of the areas, ascending, and with them those of another B_0, of generation 0, and their images. Points whose balls
/// overlap at the thread's precision are one. \pre G > 1
std::vector<SingularPoint> area_points(const Ball& G, const Tracking&, std::vector<Ball> of_B0 = {});
/// The singular points of the exceedances, ascending, and 1, where (W3) and (W4) meet.
std::vector<SingularPoint> exceedance_points(const Ball& load, const Ball& G, const Tracking&);

} // namespace touchstone::transfer
