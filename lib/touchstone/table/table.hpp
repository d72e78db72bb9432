// SPDX-License-Identifier: MIT
/// \file
/// Certified reference tables: a quantity on a grid of binary64 inputs.
#pragma once

#include "touchstone/catalogue/evaluate.hpp"
#include "touchstone/table/forced.hpp"

#include <functional>
#include <string>
#include <vector>

namespace touchstone {

/// What a table holds. Inputs are binary64 numbers (or integers), so that a code under
/// test receives exactly the arguments the certified values belong to.
struct TableSpec {
    std::string name;                       ///< file name without ending: "westergaard_half_width"
    std::string quantity;                   ///< as the catalogue names it
    long digits = 40;                       ///< significant decimal digits of each value
    std::function<std::vector<std::vector<double>>()> grid; ///< rows of inputs, in the quantity's order, distinct
    bool slow = false;                      ///< takes minutes
    bool forced = false;                    ///< with what rounded inputs force beside each row, see forced.hpp
};

/// One line of a table.
struct TableRow {
    std::vector<double> inputs;             ///< in the order of Table::inputs
    Evaluation result;                      ///< the value there, its proven error and status
    std::optional<ForcedUlps> forced;       ///< if the table has it and it is known
};

/// A table as computed.
struct Table {
    std::string name;                       ///< as TableSpec::name
    const Quantity* quantity = nullptr;     ///< what it is a table of; lives as long as the program
    std::vector<std::string> inputs;        ///< column names
    long digits = 0;                        ///< significant decimal digits of each value
    bool forced = false;                    ///< has the column
    std::vector<TableRow> rows;             ///< in the order of the grid
    Status status() const;                  ///< the weakest status of any row
};

/// All tables there are.
const std::vector<TableSpec>& table_specs();
const TableSpec* find_table(std::string_view name); ///< null if there is none of that name
std::vector<std::string> table_names();            ///< of table_specs(), in its order

/// Compute a table on `jobs` threads. Rows come out in grid order whatever the threads do.
/// `progress(done, total)` is called now and then, from one thread at a time.
/// \throws what evaluate() throws
Table compute(const TableSpec&, long digits, unsigned jobs,
              const std::function<void(std::size_t, std::size_t)>& progress = {});

} // namespace touchstone
