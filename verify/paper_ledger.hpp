// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// `touchstone paper --ledger DIR`: a ledger of one's own.
#pragma once

#include <string>

namespace touchstone::program {

/// Judges all entries, or one; or makes the typesetter's changes. Returns the exit code.
int run_own_ledger(const std::string& dir, const std::string& id, bool json, bool mutate);

} // namespace touchstone::program
