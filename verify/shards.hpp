// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Shares of a table as files: written whole, and not made twice.
#pragma once

#include "touchstone/table/shard.hpp"
#include "verify/own_rows.hpp"
#include "verify/row_table.hpp"

#include <optional>
#include <string>
#include <vector>

namespace touchstone::program {

/// Where a share goes: `out` is a folder, made if need be, or a file if its name ends in .txt; nowhere: standard output.
/// \throws Failure (cannot_write)
std::string shard_path(const std::string& out, const Shard&);

/// If that file holds this very share already: the exit code with which it was made, after saying so.
std::optional<int> code_if_there(const std::string& path, const Shard& wanted);

/// Written to a temporary file and renamed. \throws Failure (cannot_write)
void put_shard(const std::string& path, const Shard&);

/// `touchstone table NAME --shard i/N`. \returns the exit code
int table_share(const TableSpec&, long digits, unsigned jobs, Share, const std::string& out);

/// The share of rows that are asked for, without them, and which they are. \param rows are read to their end
/// \param file they come from, which names the table
struct RowsShare {
    Shard shard;
    std::vector<bool> mine; ///< by the row's number less 1
};
RowsShare rows_share(OwnRows& rows, const RowTableKind&, Share, const std::string& file);

/// All that the table of these rows is: each row's hash covers those before it.
class RowsSpec {
public:
    explicit RowsSpec(const RowTableKind& kind) : chain_(kind_text(kind)) {}
    void add(const std::vector<std::string>& words);
    std::string text() const;

private:
    std::string chain_, block_;
};

/// That a share of rows holds none that this program would not write. \throws CorruptTable: which of its rows, and what is wrong
void check_rows(const Shard&);

/// Collects the rows of a share, and writes it once they are all there: of a share broken off nothing is left behind.
class ShardSink : public RowSink {
public:
    ShardSink(Shard shard, std::string path)
        : shard_(std::move(shard))
        , path_(std::move(path))
    {
    }
    void finish(bool complete) override;

protected:
    void add(std::size_t number, const std::string& line) override;

private:
    Shard shard_;
    std::string path_;
};

} // namespace touchstone::program
