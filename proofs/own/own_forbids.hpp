// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// What keeps an entry from following although its right side is what it must be.
#pragma once

#include "proofs/own/own_ledger.hpp"

#include <optional>
#include <vector>

namespace touchstone::proofs {

/// Roots and moduli are simplified by the sign of a positive symbol: has what is put for it, or what it stands for over the entry's own
/// ranges, this sign?
std::optional<Check> sign_forbids(const OwnLedger& ledger, const OwnEntry& e, const Print& p);
/// Each reason that there is; `ledger` is `whole` with the ranges of the entry.
std::vector<Check> what_forbids(const OwnLedger& whole, const OwnLedger& ledger, const OwnEntry& e, const Print& p);

} // namespace touchstone::proofs
