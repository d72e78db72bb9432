// SPDX-License-Identifier: MIT
/// \file
/// Where the areas B_m of the recursion are not smooth in the load ratio, once full contact occurs.
///
/// B_0 has a square root at x = 1, (6.6). If B_m has a singular point s, then B_{m+1} has one where s meets an end of
/// a wave: at x = G s + 1; at x = G s - 1 if that is >= 1, else at x = G^2 s^2/4 (exactly one of the two, since
/// G s - 1 >= 1 means s >= 2/G); and s = 0, the lower end of all waves with x <= 1, adds x = 1 afresh at every
/// level. So the singular points of all levels are the images of 1, and a point of generation g is singular from
/// level g on. Near an image of generation g the function behaves, on one side or both, as c eps^((g+1)/2), times log eps
/// where the wave's end passes inside: the square-root end of the wave's density adds half a power each time.
#pragma once

#include "touchstone/scalar/ball.hpp"

#include <vector>

namespace touchstone::transfer {

struct SingularPoint {
    Ball position;
    int generation; ///< of the strongest of the points merged here
};

/// The points of generation `generations` and less in (0, reach], ascending; 1 is among them. Points are merged where
/// their balls at the thread's precision overlap or where they are closer than `merge` times the larger:
/// the caller says what that neglects. \pre G > 1
std::vector<SingularPoint> singular_points(const Ball& G, const Ball& reach, int generations, double merge);

} // namespace touchstone::transfer
