// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The certified tables that figures are drawn from: those of data/reference that hold the paper's cases, and those
/// of data/figures, which are denser where a curve must look smooth. Compiled in; their hashes are checked when read.
#pragma once

#include "touchstone/table/format.hpp"

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace touchstone::figures {

/// The tables of data/figures.
const std::vector<TableSpec>& figure_tables();

/// A table of data/figures as its file holds it, naming the command that makes it.
std::string stored_form(const Table&);

/// The text of a table of data/figures, as compiled in.
std::string_view compiled_in(const std::string& table);

/// The command that makes the tables of data/figures anew.
inline constexpr std::string_view recompute_command = "touchstone report --recompute --out DIR (DIR/data)";

/// A proven value of a table. \throws std::out_of_range where the table has no such row.
class Data {
public:
    explicit Data(const std::string& table);
    const Ball& at(const std::vector<double>& inputs) const;
    const std::vector<StoredTable::Row>& rows() const { return table_.rows; }
    Ball ball(const StoredTable::Row&) const;
    /// The table's status: what a point made from it can claim at most.
    const std::string& status() const { return status_; }

private:
    StoredTable table_;
    std::string status_;
    std::map<std::vector<double>, Ball> values_;
};

} // namespace touchstone::figures
