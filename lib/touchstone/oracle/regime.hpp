// SPDX-License-Identifier: MIT
/// \file
/// Where a code is right and where it is not: a judgement told apart by regime.
#pragma once

#include "touchstone/oracle/judge.hpp"

namespace touchstone::oracle {

/// One part of the rows, and how the code does there.
struct Regime {
    std::string name; ///< "ordinary", "near the edge", "nearly full contact", "full contact", "tiny load", "subnormal", "true value zero"
    std::size_t rows = 0, failed = 0, undecided = 0; ///< how many
    double worst_absolute = 0;          ///< |answer - truth|, of the answers that are finite numbers
    std::optional<double> worst_relative; ///< nothing where the truth is zero
    std::optional<Forced> forced;       ///< of the row that is worst relatively, in ulps; nothing if not worked out
    double forced_relative = 0;         ///< forced->least as a relative error
    std::vector<std::string> faults;    ///< "123 of 153 answers are 0"
    /// How many decimal digits of the worst answer are right.
    double right_digits() const;
};

/// The regime a row belongs to: the first that fits of true value zero, subnormal (the value or an input), near the edge (of the
/// contact in x, of the pressures in p, within a part in 1000), nearly full contact (load in [0.999, 1)), full contact
/// (load >= 1), tiny load (< 1e-6), ordinary.
std::string regime_of(const Quantity&, const Question&);

/// The regimes that occur, in the order above reversed: ordinary first.
std::vector<Regime> regimes(const Quantity&, const std::vector<Question>&, const Judgement&);

} // namespace touchstone::oracle
