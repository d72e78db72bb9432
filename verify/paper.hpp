// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The ledger as `touchstone paper --json` prints it.
#pragma once

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace touchstone::proofs {
struct Claim;
}

namespace touchstone::program {

/// Judges every entry.
nlohmann::ordered_json ledger_json();

/// What the program itself rests on, all of it or one lemma. \returns an exit code
int print_own(const std::string& id, bool json);

/// The verdict on a claim whose print (its corrected form, if that is asked for) has the fields of `changes`, each "FIELD=TEXT". \returns
/// an exit code
int print_changed(const proofs::Claim&, const std::vector<std::string>& changes, bool corrected, bool json);

} // namespace touchstone::program
