// SPDX-License-Identifier: MIT
/// \file
/// C(G) for any G > 1, full contact included: docs/limit.md, theorem 4.
///
/// For any bounded Phi and any number c, |C(G) - c| <= G^(2+k) sup T^k|R|, k >= 0, R = B_0 - c x - Phi + G T Phi. Phi is sought near the
/// solution of R = 0, which is Poisson's equation of the chain, and then R is bounded.
#pragma once

#include "touchstone/scalar/accuracy.hpp"
#include "touchstone/scalar/ball.hpp"

#include <functional>
#include <string>

namespace touchstone::limit {

/// The most digits of area_constant_by_poisson().
constexpr long most_digits_by_poisson = 15;

/// \param G known to 101 bits, from 1.02 to 3
/// \throws BeyondReach where the mesh would be too large, or the residual is not small enough for the digits asked for
Ball area_constant_by_poisson(const std::function<Ball()>& G, Accuracy);

/// What bounds its error.
std::string area_constant_by_poisson_certificate(const std::function<Ball()>& G, Accuracy);

/// C(G) from estimated areas at scales up to 100, extrapolated: no proof.
Witness area_constant_extrapolated(const Ball& G);

/// For tests: what Phi is made worse by on the panel y0 <= y <= y1. Phi may be anything; the proof has to see it.
using SpoiledPhi = std::function<double(double y0, double y1)>;
struct Poisson {
    Ball c;        ///< near C(G)
    double error;  ///< at least |C(G) - c|
    double level_zero, step, polynomial, below; ///< of R: sup T|B_0 - P|, sup T^2|T V_0 - V_1|, the rest on the mesh, sup T of what is below it
    std::size_t panels;
};
Poisson solve_poisson(const Ball& G, double tolerance, const SpoiledPhi& = {});

} // namespace touchstone::limit
