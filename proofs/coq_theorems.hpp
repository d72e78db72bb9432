// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Which entries of the ledger Coq's kernel has checked too: data/paper/coq.txt, theorems in proofs/coq.
#pragma once

#include "proofs/ledger.hpp"

#include <string>
#include <string_view>

namespace touchstone::proofs {

struct CoqTheorem {
    std::string theorem, file;
    bool whole = false; ///< all that the entry says
    std::string sense;
};
/// nullptr: none
const CoqTheorem* coq_theorem(const std::string& id);

/// What a verdict of proved, verified or argued rests on: "Coq" where a theorem says the whole entry, else "balls" where enclosures come
/// into the method, "symbols" where none do, "argument"; empty for other verdicts.
std::string_view ground(const Entry&);

} // namespace touchstone::proofs
