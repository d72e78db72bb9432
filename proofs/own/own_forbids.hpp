// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// What keeps an entry from following although its right side is what it must be.
#pragma once

#include "proofs/own/own_ledger.hpp"

#include <optional>
#include <vector>

namespace touchstone::proofs {

/// Roots and moduli are simplified by the sign of a positive symbol: has what is put for it on the way from where it was first used, or
/// what it stands for, this sign over the entry's own ranges? `ledger` is `whole` with these.
std::optional<Check> sign_forbids(const OwnLedger& whole, const OwnLedger& ledger, const OwnEntry& e, const Print& p);
/// Each other reason that there is.
std::vector<Check> what_forbids(const OwnLedger& whole, const OwnLedger& ledger, const OwnEntry& e, const Print& p);

} // namespace touchstone::proofs
