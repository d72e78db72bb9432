// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// What the ledger says of a print with one of the typesetter's changes in it. Every verdict but `refuted` is a survivor; one that says the
/// same as the print in other words is excused in data/paper/excuses.json, with its reason.
#pragma once

#include "proofs/ledger.hpp"

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace touchstone::proofs {

struct Survivor {
    std::string id, change, kind;
    std::string verdict; ///< the verdict's name, or "exception"
    std::string reason;
    std::string excuse;  ///< empty: unexcused
};

struct Mutation {
    int changes = 0, refuted = 0;
    std::vector<Survivor> survivors;
    std::vector<Survivor> caught;             ///< the refuted ones, each with its reason
    std::map<std::string, int> by_kind;       ///< changes of each kind
    std::vector<std::string> idle_excuses;    ///< excuses of these entries that no survivor needed: to be deleted
    int unexcused() const;
};

/// Judges each `stride`-th change of the claims' prints (of their corrected forms, where they have one), from `offset` on; idle excuses are
/// known at stride 1 only. `judged` hears after each claim how many are done.
Mutation mutate(const std::vector<const Claim*>&, int stride = 1, int offset = 0, const std::function<void(std::size_t)>& judged = {});

} // namespace touchstone::proofs
