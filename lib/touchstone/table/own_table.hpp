// SPDX-License-Identifier: MIT
/// \file
/// A table of one's own, described in a file.
#pragma once

#include "touchstone/table/table.hpp"

#include <string_view>

namespace touchstone {

/// Reads
///
///     {"name": "mine", "quantity": "contact.area", "digits": 20,
///      "inputs": {"n": "0:5:1", "load": ["log:1e-3:1:4", 0.25], "G": "sqrt(10)"}}          all combinations, or
///     {"name": "mine", "quantity": "contact.area", "columns": ["n", "load", "G"], "rows": [[0, 0.1, 4], [1, "1/3", "0x1.4p+1"]]}
///
/// As in every reference table an input stands for the binary64 number it rounds to. Rows that come out twice are refused.
/// \param file what messages call it \throws DomainError, WrongKeys: one line with the file and what would be right
TableSpec own_table(std::string_view json, std::string_view file);

} // namespace touchstone
