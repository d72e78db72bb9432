// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// How much is wrong with a refuted print, and what must be said beside a verdict.
#pragma once

#include "proofs/ledger.hpp"

#include <string>
#include <string_view>

namespace touchstone::proofs {

/// A misprint (the authors computed with the right form), imprecise (right with a word more) or false: Correction::fault.
std::string_view severity(const Correction&);

/// The entry that makes the same claim first, or nothing: a claim that the paper makes four times is counted once.
std::string same_as(const std::string& id);

/// What must be read with the verdict, or nothing.
std::string caveat(const std::string& id);

} // namespace touchstone::proofs
