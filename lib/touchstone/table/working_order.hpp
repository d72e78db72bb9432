// SPDX-License-Identifier: MIT
/// \file
/// In which order rows are best computed, so that what one of them makes serves the others.
#pragma once

#include "touchstone/catalogue/quantity.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace touchstone {

/// The places 0 ... n - 1 of the rows (nullptr: not to be computed), reordered. The recursion keeps its discretisations by surface, and for
/// distributions by load (partial contact) or pressure (full contact): rows that share those come together, in the order in which
/// they first occur; among them the most demanding comes first, because what is made for it serves all others. The rest keep their order.
std::vector<std::size_t> working_order(const Quantity&, const std::vector<const Inputs*>& rows);

/// What the rows of one surface have in common, G or D and gamma; empty for a quantity without a surface.
std::string surface_text(const Quantity&, const Inputs&);

} // namespace touchstone
