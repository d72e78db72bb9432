// SPDX-License-Identifier: GPL-3.0-or-later
// Who looks at a change (judge.cpp), beside the test cases that are linked.
#pragma once

#include <functional>
#include <string>
#include <vector>

/// Somebody who can find a change.
struct Finder {
    std::string name;
    std::function<bool()> finds;
    double seconds = 0;
    std::vector<unsigned char> reached = {};
};

/// Every claim of the ledger with its controls and every lemma of our own (ledger.cpp). Linked where our proofs are changed; where the
/// library is, tests alone judge.
__attribute__((weak)) std::vector<Finder> finders_of_the_ledger();
