// SPDX-License-Identifier: MIT
/// \file
/// Panels graded towards the points next to which the functions of the limit are not smooth. A search: any mesh will do for a proof.
/// Internal to limit/.
#pragma once

#include "touchstone/transfer/layer.hpp"

#include <vector>

namespace touchstone::limit {

/// What a mesh is made for.
struct Grading {
    double lowest, highest;      ///< of the load ratio
    double tolerance;            ///< what a panel that holds a singular point may leave
    std::vector<Ball> further{}; ///< with a square root of the function, beside 1; their images come with them
};

/// A panel is halved until every singular point s, of generation g, is so far from it that polynomials fall fast enough: s counts for c_g
/// w^(g/2 + 1) on a panel of width w, w^((g+1)/2) of the function and w^(1/2) of a wave, and for s^(1/2) (w/s)^((g+1)/2) w^(1/2) where s <
/// 1.
std::vector<transfer::levels::Panel> graded_panels(const Ball& G, const Grading&);

} // namespace touchstone::limit
