// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The rows that `touchstone eval` is asked for: from a file, or all combinations of ranges on the command line.
#pragma once

#include "touchstone/catalogue/named_inputs.hpp"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace touchstone::program {

/// One row: its inputs as they are printed, and as numbers, or why it has none.
struct OwnRow {
    std::size_t number = 0;             ///< from 1
    std::vector<std::string> words;     ///< one a column, without blanks
    std::optional<Inputs> inputs;
    std::string place;                  ///< "rows.txt:7: row 5"
    std::string printed;                ///< the last column, if that was asked for
    std::string refusal;                ///< "rows.txt:7: row 5: load = -1: must be > 0"
};

class OwnRows {
public:
    virtual ~OwnRows() = default;
    /// The inputs' names, in the quantity's order; D and gamma in the place of G where they are given.
    virtual const std::vector<std::string>& columns() const = 0;
    /// The next row; false at the end. \throws Failure, BadRows where no more rows can be read
    virtual bool next(OwnRow&) = 0;
    /// How many there are, for a progress bar; 0: not known before they are read.
    virtual std::size_t count() const { return 0; }
};

/// Whether a word asks for more than one value.
bool is_range(const std::string& key_value);

struct OwnRowsOptions {
    bool binary64 = false; ///< round each input to the nearest binary64 number first
    bool printed = false;  ///< of a file: the last column, whatever its name, is what was printed
};

/// \throws Failure (usage_error), with the nearest name
const Quantity& quantity_named(const std::string& name);
/// \throws Failure (usage_error)
NamedTexts key_values(const Quantity&, const std::vector<std::string>& words);

/// \throws Failure, WrongKeys, DomainError, BadRows
std::unique_ptr<OwnRows> rows_of_file(const Quantity&, const std::string& path, const NamedTexts& constants, OwnRowsOptions);
std::unique_ptr<OwnRows> rows_of_ranges(const Quantity&, const NamedTexts&, OwnRowsOptions);

} // namespace touchstone::program
