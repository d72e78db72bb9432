// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Sentences that are about the text itself: a letter it does not define, a finding it quotes, a page, a limit it names again.
#pragma once

#include "proofs/ledger.hpp"

#include <vector>

namespace touchstone::proofs {

std::vector<Claim> sentences_about_the_text();

} // namespace touchstone::proofs
