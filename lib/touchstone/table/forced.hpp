// SPDX-License-Identifier: MIT
/// \file
/// What rounded inputs force: how far off a perfect code can be because each real input of a row was rounded once.
///
/// To first order, the sum over the inputs of the larger change of the value within half an ulp of that input, the others kept: the
/// condition number times half an ulp, and still right beside an edge where there is no derivative. Of a closed form it is at least the
/// change at each corner, where all inputs move together. An integer (n) is not rounded.
#pragma once

#include "touchstone/catalogue/quantity.hpp"

#include <optional>
#include <string>
#include <vector>

namespace touchstone {

struct ForcedUlps {
    double ulps = 0;        ///< of the value; absolute where the value is 0, which has no ulp of its own
    bool estimated = false; ///< by the condition number that the recursion has in general, not by values at the ends of the inputs
};

/// From values at the ends of each input's interval: in balls for closed forms, correctly rounded for areas in partial contact
/// (G > 2, load <= 1; at load 1 by the slope from below) and at scale 0.
/// Elsewhere another load or G is another solution of the recursion, seconds to minutes, and it is estimated: a relative change of the load
/// counts once, of G n times (of a count gamma^n A_(n-1) what is left of both), and what falls like
/// (p_max - p)^s towards its upper edge (p_n^max of (5.6), s = (n+1)/2 for an exceedance, |n-1|/2 for a density) moves with the edge.
/// Of limit.area_constant and its ratio the condition number is taken to be 1. Nothing is known of other limits, nor where no ball at the
/// row itself is finite.
std::optional<ForcedUlps> forced_ulps(const Quantity&, const std::vector<double>& inputs, const Rational& value);

/// Three significant digits, as the tables have it; a change below a millionth of an ulp is 0.
std::string forced_text(double ulps);

} // namespace touchstone
