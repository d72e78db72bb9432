// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// What is known of a symbol before any equation: its dimension and its sign. The paper's are in data/paper/symbols.json, those of a
/// ledger of one's own in that ledger.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace touchstone::proofs {

/// "force/length^2" as powers of base dimensions; "1" is a number.
using DimensionText = std::string;

struct SymbolKind {
    std::optional<DimensionText> dimension;
    bool real = false; ///< may be negative or zero; else positive
    std::map<std::string, DimensionText> in_section; ///< where the same letter means something else
};

struct FunctionKind {
    DimensionText argument, value;
};

struct Alphabet {
    std::map<std::string, SymbolKind> symbols;
    std::map<std::string, FunctionKind> functions;
    /// Letters that stand for one another in a careless hand: of one kind, or alike in shape.
    std::vector<std::vector<std::string>> alike;
};

/// The alphabet in use: the paper's, until another takes its place.
const Alphabet& alphabet();
/// From now on; before the first formula is read, as symbols keep the sign they were made with.
void use_alphabet(Alphabet);
bool paper_alphabet_in_use();

} // namespace touchstone::proofs
