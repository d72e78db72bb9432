// SPDX-License-Identifier: MIT
/// \file
/// The limiting distributions of section 9 and figure 5. Internal to catalogue/.
#pragma once

#include "touchstone/catalogue/quantity.hpp"

namespace touchstone {

/// limit.exceedance, limit.force and limit.segments
void add_limiting_distributions(std::vector<Quantity>&);

} // namespace touchstone
