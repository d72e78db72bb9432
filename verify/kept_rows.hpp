// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The rows of a table that is taken up where it ended.
#pragma once

#include "verify/own_rows.hpp"
#include "verify/row_reader.hpp"

#include <fstream>
#include <memory>
#include <optional>
#include <string>

namespace touchstone::program {

/// What there is to go on from for FILE: the longer of the table and of one that was cut off before it became the table. Empty: nothing.
std::string table_to_resume(const std::string& out);

class KeptRows {
public:
    struct Row {
        std::string line; ///< with its end
        std::string place; ///< "t.txt.part:9"
        WrittenRow row;
    };
    /// \throws Failure: a table of another kind or program, or one whose rows do not have the hash that it gives
    KeptRows(std::string path, const RowTableKind&);
    /// The next whole row that has a value; nothing at the end. \throws Failure where a line is none that this program writes
    std::optional<Row> next();

private:
    bool read_line();
    std::string path_, text_;
    RowTableKind kind_;
    std::unique_ptr<std::ifstream> file_;
    std::size_t line_ = 0;
};

/// That all rows of the table are among those asked for, in their order. \throws Failure
void require_rows_of(KeptRows, OwnRows& asked);

} // namespace touchstone::program
