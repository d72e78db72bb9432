// SPDX-License-Identifier: MIT
/// \file
/// The limiting distributions of section 9 and figure 5. Internal to catalogue/.
#pragma once

#include "touchstone/catalogue/quantity.hpp"

namespace touchstone {

/// limit.exceedance, limit.force, limit.density and limit.segments
void add_limiting_distributions(std::vector<Quantity>&);
/// limit.distance
void add_distance_from_limit(std::vector<Quantity>&);

/// Of limit.exceedance, at the p and the surface of these inputs.
Plan plan_of_limiting_exceedance(const Inputs&);
/// The share of one wave of mean x in contact, over x: in binary64.
double contact_over_x(double x);

} // namespace touchstone
