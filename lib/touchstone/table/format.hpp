// SPDX-License-Identifier: MIT
/// \file
/// The canonical text form of a table and the views made from it; see data/reference/README.md.
#pragma once

#include "touchstone/table/table.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace touchstone {

/// The formats that format() knows.
inline const std::vector<std::string>& table_formats()
{
    static const std::vector<std::string> all{"txt", "csv", "json", "hpp", "ipp"};
    return all;
}

/// The whole file, byte for byte the same on every machine.
/// txt: banner, JSON header, column names, rows for numpy.loadtxt, Fortran, MATLAB, >>.
/// csv, json: with hexfloats and each row's exact half-width interval. hpp: a constexpr array. ipp: Boost.Math's SC_ rows.
std::string format(const Table&, std::string_view format);

/// Lower-case hexadecimal SHA-256.
std::string sha256(std::string_view bytes);

/// A canonical table read back.
struct StoredTable {
    std::string name;                ///< of the table
    std::string quantity;            ///< as the catalogue names it
    std::string header_json;         ///< the header line as it stands
    std::string sha256;              ///< of the rows, as the header gives it and parse_table() found it
    std::vector<std::string> inputs; ///< column names
    long digits = 0;                 ///< significant decimal digits of each value
    /// One line.
    struct Row {
        std::vector<double> inputs;  ///< in the order of the columns
        std::string value;           ///< decimal, as it stands
        std::string error;           ///< proven bound (or estimate) of |value - true value|, decimal
        std::optional<double> forced{};  ///< ulps; see forced.hpp
    };
    std::vector<Row> rows;         ///< in the order of the file
    bool has_forced = false;       ///< the column is there
    bool forced_estimated = false; ///< and holds estimates
};

/// A file that is not a canonical table, or not the one its hash says it is. One line, with the line number.
class CorruptTable : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Parse a canonical txt table; checks the header, the columns, every number, that each error bound is one a
/// rounding to nearest can prove, that no row is there twice, and the hash.
/// \throws CorruptTable
StoredTable parse_table(std::string_view text, std::string_view file_name);

/// The same table with what rounded inputs force beside each row, worked out now (forced.hpp); the values are kept as they stand. As
/// format() writes it when all is computed anew.
std::string with_forced(const StoredTable&, std::string_view text);

/// The program's version, as tables carry it.
std::string_view version();

} // namespace touchstone
