// SPDX-License-Identifier: MIT
/// \file
/// The recursion (6.1)-(6.7) where full contact occurs: any G = gamma^(D-1) > 1, any load. Estimated, not proven.
///
/// Two discretisations of one operator (chain.hpp, wave.hpp) that share neither grid nor splitting rule nor quadrature:
/// blind halving (piecewise.hpp) and a grid graded towards the tracked singular points (graded.hpp). All levels and loads of one G
/// share the work; it is kept for later calls. See full_contact.md for what is known about the functions.
/// What proven_levels.hpp certifies is witnessed by a value from here.
#pragma once

#include "touchstone/scalar/accuracy.hpp"

#include <functional>

namespace touchstone::transfer {

enum class Grid { blind, tracked };

/// What these grids can do; a blind grid that is asked for less is coarser, and several times cheaper.
constexpr Accuracy finest_estimate{16};

/// (6.7)  A_n/lambda_0, n >= 0, load > 0, G > 1. Accurate to about 1e-18, relative, or to the digits wanted.
/// \throws BeyondReach for n > 100, or loads not within 1e-300 and 1e6
Witness estimated_area(Grid, long n, const Ball& load, const Ball& G, Accuracy wanted = finest_estimate);

/// Share of lambda_0 with p_n > p, and its density q_n p*_0 (6.1): n >= 1, p > 0 in p*_0. Absolute accuracy about 1e-18;
/// towards the upper edge of the support fewer digits agree, next to a singular point of the density too.
/// \throws BeyondReach as estimated_area, and for n > 40
Witness estimated_exceedance(Grid, long n, const Ball& p, const Ball& load, const Ball& G, Accuracy wanted = finest_estimate);
Witness estimated_density(Grid, long n, const Ball& p, const Ball& load, const Ball& G, Accuracy wanted = finest_estimate);

/// The first n for which min p_n > 0 does not hold, so that contact is lost: load >= 1 + G + ... + G^n is what
/// keeps it, by (5.2), (5.4). Decided in balls; `tie` says where they cannot tell (load and the sum equal: contact is just kept).
/// \returns the number of scales n = 0, 1, ... in full contact everywhere, at most `most`
long scales_in_full_contact(const Ball& load, const Ball& G, long most, const std::function<bool(long n)>& tie);

} // namespace touchstone::transfer
