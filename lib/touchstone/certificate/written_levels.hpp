// SPDX-License-Identifier: MIT
/// \file
/// The lines grid, panel and level of a section. Internal to certificate/.
#pragma once

#include "touchstone/certificate/discrete_operator.hpp"
#include "touchstone/certificate/text.hpp"

namespace touchstone::certificate {

/// Where they are.
struct WrittenSection {
    std::size_t grid = 0;
    std::vector<std::size_t> panels;
    std::vector<std::vector<std::size_t>> levels; ///< by m, then by panel

    /// How many lines there are of each of these reasons.
    Counts counts() const;
};
WrittenSection write_levels(const Grid&, const std::vector<Level>&, Lines&);

} // namespace touchstone::certificate
