// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Dimensional analysis of a print: pressures, lengths and their powers. A formula whose sides
/// or summands differ in dimension is false whatever the numbers.
#pragma once

#include "proofs/ledger.hpp"

namespace touchstone::proofs {

/// Every part of the print has equal dimensions on both sides, every sum has equal terms, every
/// function of a number gets a number.
Check units(const Print&);

} // namespace touchstone::proofs
