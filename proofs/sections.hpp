// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The headings of the paper, and of what stands beside its sections (Table 1, the figures, the references), as data.
#pragma once

#include <string>
#include <vector>

namespace touchstone::proofs {

struct Section {
    std::string id, heading; ///< the id is what a print calls its section
};

/// In the order of the paper, from data/paper/sections.json. \throws std::logic_error if a print belongs to none of them
const std::vector<Section>& sections();

} // namespace touchstone::proofs
