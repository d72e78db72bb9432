// SPDX-License-Identifier: MIT
/// \file
/// A file of rows: columns by name, exact numbers, read one line at a time.
///
///     # x load answer            a `#` (or `%`) line names the columns; so does a first line of bare names, as CSV has it
///     0.1  0x1.8p-3  0.41        blanks or commas between; numbers exact as on the command line (1/3, 1e-300, 0x1p-3, Fortran's 1D-3)
///     0.2, 1/3, 0.52             other `#` lines and empty lines are passed over; line ends LF, CR LF or CR, also mixed; a UTF-8 mark too
///     0.3 1 0.63 # why          what follows a `#` in a row is no part of it
///
/// A canonical table is such a file. How to use it:
///
///     std::ifstream in(path);
///     RowsReader rows(in, path, {.known = {"x", "load", "answer"}, .ignored = {"value", "error"}});
///     for (const auto& name : quantity.inputs) { if (!rows.column(name)) ... }          // which inputs does the file give?
///     for (RowsReader::Row row; rows.next(row);) {
///         const Rational x = rows.exact(row, *rows.column("x"));                        // or row.words[column] as text
///         try { quantity.check(...) } catch (const DomainError& e) { throw rows.fault(row, e.what()); }
///     }
///
/// Whatever is wrong throws BadRows, one line with the file, its line, the row and the reason. No more than one line and the
/// names of the columns are ever in memory, and no line may be longer than `longest_line` bytes.
#pragma once

#include "touchstone/scalar/rational.hpp"

#include <cstddef>
#include <istream>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace touchstone {

/// A file of rows that cannot be read. One line: "grid.txt:7: row 5: load = 'nan' is not a number such as ...".
class BadRows : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

class RowsReader {
public:
    struct Format {
        std::vector<std::string> known;                 ///< columns that may be there; any other name is a mistake
        std::vector<std::string> ignored{};             ///< columns that may be there and are of no interest
        bool free_last = false;                         ///< the last column may have any name
        std::size_t longest_line = std::size_t{1} << 20; ///< a line beyond this is refused, and never held whole
    };
    struct Row {
        std::size_t number = 0;         ///< from 1, comments not counted
        std::size_t line = 0;           ///< of the file, from 1
        std::vector<std::string> words; ///< as they stand, one a column
    };

    /// Reads up to the first row. `file` is what messages call it. The stream must outlive the reader.
    /// \throws BadRows if no line names the columns, or one is unknown or there twice
    RowsReader(std::istream&, std::string file, Format);

    const std::vector<std::string>& columns() const { return columns_; }
    /// The place of a column among the words of a row; nothing if the file has none of that name.
    std::optional<std::size_t> column(std::string_view name) const;

    /// The next row; false at the end. \throws BadRows for a ragged row, an endless line, a read error
    bool next(Row&);
    /// A word as an exact number. \throws BadRows
    Rational exact(const Row&, std::size_t column) const;
    /// What to throw for a row that the caller finds wrong.
    BadRows fault(const Row&, std::string_view reason) const;

    /// A number as exact as it stands: what parse_rational takes, and Fortran's exponents D and d.
    static std::optional<Rational> number(std::string_view word);

private:
    bool read_line();
    void find_columns();
    void name_columns(std::string_view names, std::size_t at);
    BadRows bad(std::string_view reason) const;

    std::istream& in_;
    std::string file_;
    Format format_;
    std::vector<std::string> columns_;
    std::string text_;              ///< the line read last
    std::size_t line_ = 0, rows_ = 0;
    bool after_return_ = false;     ///< a line feed now belongs to the carriage return before it
    bool waiting_ = false;          ///< text_ is a row that nobody has asked for yet
};

} // namespace touchstone
