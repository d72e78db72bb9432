// SPDX-License-Identifier: MIT
/// \file
/// Areas at loads so light that a grid would be spent on getting down to them: the power series in the load. Internal to recursion/.
#pragma once

#include "touchstone/recursion/methods.hpp"

namespace touchstone::recursion {

Method power_series();

/// What accuracy a light load takes from the discretised operator, in digits: an error weighs load^(-1/4) in the value.
double digits_lost_to_light_load(const Problem&);

} // namespace touchstone::recursion
