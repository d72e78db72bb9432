// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// What the symbols of a ledger of one's own stand for, and of what sign that is.
#pragma once

#include "proofs/own/own_ledger.hpp"

#include <functional>
#include <set>
#include <string>

namespace touchstone::proofs {

/// The words of a text: what may be a symbol of it.
std::set<std::string> words(const std::string&);
std::set<std::string> symbols_of(const ex&);

/// e with what the symbols stand for, as far as `is_meant` says.
ex written_out(const OwnLedger&, const ex& e, const std::function<bool(const std::string&)>& is_meant);
ex written_out(const OwnLedger&, const ex& e);

/// About how many terms e has when it is multiplied out, its denominators too.
double terms_of(const ex& e);
inline constexpr double most_terms = 300; ///< beyond as many normal forms take minutes

/// e >= 0 for all values of its symbols in their ranges.
Check not_negative(const OwnLedger&, const ex& e);

} // namespace touchstone::proofs
