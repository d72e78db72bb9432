// SPDX-License-Identifier: MIT
/// \file
/// What the answers of a failing code have in common with those of a well-known mistake.
///
/// Contact codes go wrong by conventions far more often than by arithmetic: a factor pi or 2, the
/// wave's peak-to-valley for its amplitude, E for E/(1 - nu^2), the mean pressure for p* as the unit,
/// a full width for a half width, the phase for the position, another of the paper's formulas, one of
/// its misprints, a series cut off. Each is tried against the data: no guess is reported that the data do not bear out.
#pragma once

#include "touchstone/oracle/judge.hpp"

namespace touchstone::oracle {

/// How close an answer must come to be the same: relative, and absolute beside it.
struct Tolerance {
    double relative = 0; ///< of the true value
    double absolute = 0; ///< beside it
};

/// Looks at the data from tight to loose (a part in 2^20, then 1e-4, 1e-3, 1e-2, 5e-2; never tighter than the tolerance asked for):
/// a code with noise of a percent and a factor 2 is told both. At each, the simplest candidate that gives nine tenths of the
/// telling answers; failing all, the best that gives two fifths of them to a part in 1000, with what it leaves over.
/// Telling are the rows where answer or candidate differ from the truth by more than that, and a candidate counts only if it
/// explains twice as many rows as the certified values themselves do. Before two fifths of all rows are thought enough, nine tenths of the
/// ordinary rows are looked for (regime.hpp): beside an edge a code often loses all digits, and its factor is seen elsewhere alone.
/// At most 96 rows are tried, spread over the table without a period that a grid might share; the
/// ratio is taken over all, also where no mix-up is looked for because nothing is wrong. For a quantity of the recursion a mistake in
/// the inputs is tried only where it leads to another row.
Diagnosis diagnose(const Quantity&, const std::vector<Question>&, const std::vector<double>& answers, const Tolerance&,
                   bool look_for_mixup);

} // namespace touchstone::oracle
