// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The changes a typesetter makes: one digit, sign, function, index, neighbouring symbol, bound, relation, condition,
/// a factor 2 or pi, a lost root or square. Generated from the print itself, for every field of it.
#pragma once

#include "proofs/print.hpp"

#include <string>
#include <vector>

namespace touchstone::proofs {

struct Change {
    std::string name; ///< "0.rhs: the new text", by which data/paper/excuses.json knows it
    std::string kind; ///< digit, sign, function, ...
    Print print;      ///< with the change made
};

/// Each change that reads differently, once. The member of a chain A = B = C that is printed once and transcribed twice is
/// changed in both copies, and in each alone.
std::vector<Change> typesetters_changes(const Print&);

} // namespace touchstone::proofs
