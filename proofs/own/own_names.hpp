// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// A name means one thing in the whole of a ledger of one's own.
#pragma once

#include "proofs/own/own_ledger.hpp"

#include <optional>
#include <set>
#include <string>

namespace touchstone::proofs {

/// What the entry follows from, and what that follows from in turn.
std::set<std::string> all_sources(const OwnLedger& ledger, const OwnEntry& e);

/// What is put in, or a derivative, does not reach what depends on it by another entry: with y = a*x and a = x^2, y at x = 0 is not a*0.
std::optional<Check> hidden_dependence(const OwnLedger& ledger, const OwnEntry& e);

/// A symbol that names the right side may have another meaning already: y = x^2 and y = 2*x, its derivative.
std::optional<Check> named_before(const OwnLedger& ledger, const OwnEntry& e, const Print& p);

} // namespace touchstone::proofs
