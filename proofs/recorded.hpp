// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The verdicts as a file whose diff a reviewer reads: data/paper/verdicts.txt.
#pragma once

#include "proofs/ledger.hpp"
#include "proofs/operator/own.hpp"

#include <string>
#include <vector>

namespace touchstone::proofs {

/// One entry a paragraph: id, verdict, severity; what is wrong and what holds; the lemmas and how many stored values it rests on. No line
/// numbers and no enclosures, which change when nothing does.
std::string recorded_form(const std::vector<Entry>&);

/// Of our own lemmas: id, verdict, and the ranges over which subdivision proved something; data/paper/own.txt.
std::string recorded_form(const std::vector<CheckedLemma>&);

/// The file compiled into the program.
std::string_view recorded_text();

} // namespace touchstone::proofs
