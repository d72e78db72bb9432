// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// A ledger of one's own, as data: DIR/ledger.json says what a text prints, what its symbols are and what follows from what
/// (docs/ledger.md). Nothing in it is code.
#pragma once

#include "proofs/enclosure/enclosure.hpp"
#include "proofs/print.hpp"

#include <map>
#include <optional>
#include <regex>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace touchstone::proofs {

/// One line: the file, the entry and what is wrong.
class OwnLedgerError : public std::runtime_error {
public:
    OwnLedgerError(const std::string& line, bool no_file = false) : std::runtime_error(line), no_file_(no_file) {}
    bool no_file() const { return no_file_; }

private:
    bool no_file_;
};

/// "this side is that of equation X with these substitutions, or the derivative of it"
struct Follows {
    std::string equation, side = "rhs";
    std::vector<std::pair<std::string, std::string>> with; ///< symbol -> formula; @ID stands for the right side of ID
    std::string derivative_by;
};

/// Printed numbers: a formula in the columns, each row's inputs and the number as printed.
struct OwnTable {
    std::string formula, rounding = "nearest"; ///< nearest, down
    std::vector<std::string> columns;
    std::vector<std::vector<std::string>> inputs; ///< by row, exact
};

struct OwnCorrection {
    std::string wrong, severity;
    std::vector<Edit> edits;
};

struct OwnEntry {
    Print print;
    bool definition = false;
    std::optional<Follows> follows;
    std::vector<Range> over;
    std::optional<OwnTable> table;
    std::optional<OwnCorrection> correction;
    std::map<std::string, std::string> excuses; ///< change -> reason
    std::vector<std::string> rests_on;
};

struct OwnSymbol {
    std::string is;                ///< what it stands for in terms of others; empty: free
    Rational low, high;            ///< where it is sampled
    bool positive = true;          ///< as it is declared
};

struct OwnLedger {
    std::string title, file;
    std::map<std::string, OwnSymbol> symbols;
    std::vector<OwnEntry> entries;

    const OwnEntry& at(const std::string& id) const;
    bool has(const std::string& id) const;
};

/// What "@H2 + x" refers to an entry by, and its id therein.
const std::regex& reference();

/// Reads DIR/ledger.json and puts its alphabet in use. \throws OwnLedgerError
OwnLedger load_ledger(const std::string& dir);

/// The same from its text; its tables' files are in DIR. \throws OwnLedgerError
OwnLedger read_ledger(const std::string& text, const std::string& dir);

} // namespace touchstone::proofs
