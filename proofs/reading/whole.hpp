// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// A print read with a meaning that comes with it: that of a ledger of one's own.
#pragma once

#include "proofs/reading/reading.hpp"

namespace touchstone::proofs {

/// As read_whole, with this meaning.
Check read_whole_as(const Print&, const Meaning&);

} // namespace touchstone::proofs
