// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Verdicts on a ledger of one's own, and on what a typesetter could have made of its prints.
#pragma once

#include "proofs/ledger.hpp"
#include "proofs/own/own_ledger.hpp"

namespace touchstone::proofs {

struct OwnResult {
    const OwnEntry* entry = nullptr;
    Finding finding;
    std::optional<Finding> corrected;
};

/// proved: the side is that of the equation it follows from, by normal form, or the bound holds over the whole range; verified: every
/// printed number of a table, or every side in balls at the samples; definition; refuted with the first wrong place; undecided otherwise.
Finding judge_own(const OwnLedger&, const OwnEntry&, const Print&);

/// All entries, in order.
std::vector<OwnResult> judge_all(const OwnLedger&);

struct OwnSurvivor {
    std::string id, change, kind, verdict, excuse;
};
struct OwnMutation {
    int changes = 0, refuted = 0;
    std::vector<OwnSurvivor> survivors;
    std::vector<std::string> unjudged; ///< definitions of which nothing says what they should be: no change of theirs can be seen
    int unexcused() const;
};
/// The typesetter's changes of one entry, or of all if id is empty; of the corrected form where the print is refuted.
OwnMutation mutate_own(const OwnLedger&, const std::string& id);

} // namespace touchstone::proofs
