// SPDX-License-Identifier: MIT
/// \file
/// From which scale on the fractal limit holds: a certificate (docs/certificate.md, lemma Y), in partial contact.
///
/// The levels h_m of one G, up to one that is near C(G) at all ratios that are likely enough; nobody has to trust which.
#pragma once

#include "touchstone/scalar/accuracy.hpp"
#include "touchstone/scalar/exact_text.hpp"

#include <string>
#include <vector>

namespace touchstone::certificate {

/// The least n with |A_m G^m/(C(G) load) - 1| <= tolerance for every m >= n (limit.scale).
struct ScaleClaim {
    Root G;
    Rational load, tolerance;
};

/// 2.009 <= G <= 2^20, 2^-40 <= load <= 1, 10^-15 <= tolerance < 1. \returns why not; empty: there is a certificate if the scale is between
/// 2 and 50 or so
std::string refusal_of_scale(const ScaleClaim&);

/// A certificate of these claims, a section for each G in the order in which they first come.
/// \pre refusal_of_scale() is empty for each \throws BeyondReach where a scale is not found among these
std::string limit_scales(const std::vector<ScaleClaim>&);

} // namespace touchstone::certificate
