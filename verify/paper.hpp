// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The ledger as `touchstone paper --json` prints it.
#pragma once

#include <nlohmann/json.hpp>

#include <string>

namespace touchstone::program {

/// Judges every entry.
nlohmann::ordered_json ledger_json();

/// What the program itself rests on, all of it or one lemma. \returns an exit code
int print_own(const std::string& id, bool json);

} // namespace touchstone::program
