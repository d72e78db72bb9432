// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Rows that this program has written, read again: from shares, and from a table that is taken up where it ended. Whether a value is the
/// right one shows only where it is computed again; whether it may stand in such a row at all shows here.
#pragma once

#include "verify/row_table.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace touchstone::program {

struct WrittenRow {
    std::vector<std::string> words; ///< the inputs, one a column
    std::string value, error, status;
    std::optional<Inputs> inputs; ///< a row that was refused may have none
};

/// One line, without its end, as row_line() writes it for people. \throws CorruptTable: what is wrong with it
WrittenRow read_row(const RowTableKind&, std::string_view line);

} // namespace touchstone::program
