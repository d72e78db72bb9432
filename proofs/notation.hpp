// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The journal's notation of a formula of the transcription: pstar_n as p with star and index, tgamma as Gamma, sums and products with
/// their limits. Written from the text, not from an evaluated expression, so that nothing is reordered.
#pragma once

#include "proofs/print.hpp"

#include <string>

namespace touchstone::proofs {

enum class Notation { tex, mathml };

/// A formula of the print, its pieces (sums, products, integrals, functions) written out. \throws std::invalid_argument if it does not
/// parse.
std::string in_notation(const std::string& formula, const Print&, Notation);
/// A relation sign: "<=", "->", ...
std::string relation_in_notation(const std::string& relation, Notation);

} // namespace touchstone::proofs
