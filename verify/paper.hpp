// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The ledger as `touchstone paper --json` prints it.
#pragma once

#include <nlohmann/json.hpp>

namespace touchstone::program {

/// Judges every entry.
nlohmann::ordered_json ledger_json();

} // namespace touchstone::program
