// SPDX-License-Identifier: MIT
/// \file
/// What a code has reached on each row of a table, so that it is never worse again unnoticed.
///
/// A baseline belongs to one table (its rows' hash is in it). Every bound in it is a finite number:
/// an infinite tolerance would pass everything, so none can be written or read.
#pragma once

#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace touchstone::oracle {

/// Not a baseline, or one of another table, or with a bound that bounds nothing. One line.
class BadBaseline : public std::runtime_error {
    using std::runtime_error::runtime_error;
};
/// What a code reached before, row by row: it may not get worse.
struct Baseline {
    std::string table; ///< its name
    std::string sha256;                    ///< of the table's rows
    std::map<std::string, double> bounds;  ///< inputs as hexfloats with blanks between -> most ulps
    std::string text() const;              ///< JSON, a row a line
};

/// How the inputs of a row are written in a baseline.
std::string row_key(const std::vector<double>& inputs);

/// \throws BadBaseline
Baseline parse_baseline(std::string_view text, std::string_view file);

/// One line for each row whose bound differs: "raised", "lowered", "new", "gone".
std::vector<std::string> differences(const Baseline& before, const Baseline& after);

} // namespace touchstone::oracle
