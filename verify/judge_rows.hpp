// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// What `touchstone judge` measures by, apart from stored tables: a file of rows with or without answers.
#pragma once

#include "touchstone/oracle/judge.hpp"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace touchstone::program {

/// `load=1e-6..0.999,n=3`: which rows count. A row does if each input named lies within its ends, both included.
class Where {
public:
    Where() = default;
    /// \throws Failure (usage_error) for a text that is no such condition or names no input of the quantity
    Where(const Quantity&, const std::vector<std::string>& conditions);
    bool holds(const std::vector<double>& inputs) const;
    bool everything() const { return ends_.empty(); }

private:
    struct Ends {
        std::size_t input;
        Rational low, high;
    };
    std::vector<Ends> ends_;
};

/// Rows asked and, if the file has them, answered.
struct JudgedFile {
    std::vector<oracle::Question> questions;       ///< certified values where they could be had
    std::optional<std::vector<double>> answers;    ///< from the column `answer`
    std::size_t left_out = 0;                      ///< rows that no certified value could be had for
    std::string why_left_out;                      ///< of the first
};

/// Reads rows (touchstone/table/rows.hpp): columns by the quantity's inputs, a last column `answer` if the rows are answered already.
/// Inputs that no column gives come from `fixed`. Every input is the binary64 number nearest to what is written, as a code would
/// have read it; D and gamma may stand for G. At most `most_judged_rows` of those that `where` lets through.
/// \throws BadRows, Failure
JudgedFile read_rows(const Quantity&, const std::string& file, const std::map<std::string, Rational>& fixed, const Where&);
inline constexpr std::size_t most_judged_rows = 1'000'000;

} // namespace touchstone::program
