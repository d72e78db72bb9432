// SPDX-License-Identifier: MIT
/// \file
/// Which well-known mistake a failing code has made, if its answers are those of one.
///
/// Contact codes go wrong by conventions far more often than by arithmetic: a factor pi or 2, the
/// wave's peak-to-valley for its amplitude, E for E/(1 - nu^2), the mean pressure for p* as the unit,
/// a full width for a half width, the phase for the position, another of the paper's formulas, or
/// one of its misprints. Each is tried against the data: no guess is reported that the data do not bear out.
#pragma once

#include "touchstone/oracle/judge.hpp"

namespace touchstone::oracle {

/// The simplest candidate that gives at least nine tenths of the telling answers to a part in 2^20, if any.
/// Telling are the rows where answer or candidate differ from the truth by more than that.
/// At most 96 rows are looked at, spread over the table.
std::optional<MixUp> find_mixup(const Quantity&, const std::vector<Question>&, const std::vector<double>& answers);

} // namespace touchstone::oracle
