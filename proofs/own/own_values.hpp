// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Whether a print of a ledger of one's own has a value as it is written.
///
/// Formulas are simplified while they are read: sin(asin(x)) becomes x, which has a value where the print has none. What has none anywhere
/// says nothing that could be proved, nor has a number of a table that was computed from it.
#pragma once

#include "proofs/own/own_ledger.hpp"

#include <optional>
#include <string>

namespace touchstone::proofs {

/// Whether at the point asin, acos, log or sqrt of the text have an argument for which they surely have no real value (powers are not
/// looked at); `text` is one that read takes.
bool surely_has_no_value(const OwnLedger&, const std::string& text, const Point& at);
/// The same of symbols that stand for nothing but their numbers.
bool surely_has_no_value(const std::string& text, const Point& at);

/// Undecided where a side of the print has surely no value: at any point of the printed range, or, of what is not said over a range, at all
/// points at which its condition may hold.
std::optional<Check> value_forbids(const OwnLedger&, const OwnEntry&, const Print&);

} // namespace touchstone::proofs
