// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// A table that grows row by row: written as it comes, valid whenever it ends, taken up again where it ended.
#pragma once

#include "touchstone/catalogue/directed.hpp"

#include <cstdio>
#include <fstream>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace touchstone::program {

struct RowTableKind {
    const Quantity* quantity = nullptr;
    std::vector<std::string> columns;
    long digits = 20;
    Rounding rounding = Rounding::nearest;
    bool binary64 = false;
    bool json = false; ///< one object a line, no banner
};

/// What a row came to.
struct RowOutcome {
    Evaluation result;
    std::string refusal; ///< not empty: the row has no value, for this reason
};

/// One line of the table, with its end.
std::string row_line(const RowTableKind&, std::size_t number, const std::vector<std::string>& words, const RowOutcome&);

/// How many rows have which status.
using StatusCounts = std::map<std::string, std::size_t>;

/// The table on standard output, whose last line says how many rows and which hash, or in a file: there it grows in FILE.part and becomes FILE,
/// with the same in its first lines, once it is finished or broken off.
class RowTable {
public:
    /// \param out empty: standard output \throws Failure (cannot_write)
    RowTable(RowTableKind, std::string out, bool resume);
    ~RowTable();

    struct Kept {
        std::string line, status;
    };
    /// The row, if the table that is taken up again has it next.
    std::optional<Kept> kept(const std::vector<std::string>& words);
    void write(const std::string& line, const std::string& status);
    void flush();
    /// All rows are there, or as many as there will be. \throws Failure
    void finish(bool complete);
    const StatusCounts& counts() const { return counts_; }
    std::size_t rows() const { return rows_; }

private:
    struct Hash;
    void open_before(const std::string& path);
    bool next_kept();
    std::string place() const { return !part_.empty() ? part_ : !out_.empty() ? out_ : "standard output"; }
    std::string header(const std::string& summary) const;
    std::string summary(bool complete) const;
    void put(const std::string& bytes);

    RowTableKind kind_;
    std::string out_, part_;
    bool stream_ = false;                      ///< standard output, a device or a pipe: written through
    std::FILE* file_ = nullptr;
    std::unique_ptr<std::ifstream> before_;    ///< the table taken up again
    std::string kept_line_, kept_words_, kept_status_;
    std::unique_ptr<Hash> hash_;
    StatusCounts counts_;
    std::size_t rows_ = 0;
};

} // namespace touchstone::program
