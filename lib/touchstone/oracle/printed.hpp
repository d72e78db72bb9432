// SPDX-License-Identifier: MIT
/// \file
/// Decimals as they stand in a paper, a supplement or a CSV: is each digit right?
#pragma once

#include "touchstone/catalogue/evaluate.hpp"

#include <string>
#include <string_view>

namespace touchstone::oracle {
/// What a printed number is of the true value.
enum class PrintedVerdict {
    rounded,      ///< the true value rounded to nearest, at as many decimals as are printed (on a tie, either way)
    cut_off,      ///< not rounded: the true value's digits, the rest left out
    one_unit_off, ///< the right rounding and this differ by one unit of the last place printed
    wrong, ///< none of these
    undecided,    ///< the true value is not known, or not proven, well enough
};
std::string_view to_string(PrintedVerdict); ///< in words
/// The verdict on one printed number.
struct PrintedEntry {
    PrintedVerdict verdict = PrintedVerdict::undecided; ///< what it is
    std::string right; ///< the true value rounded to nearest at the place of the last printed digit; empty if undecided
    std::string note;  ///< why undecided
};

/// Whether text is a decimal number with digits that can be judged: no fraction, no hexadecimal.
bool is_printed_decimal(std::string_view text);

/// Judges one printed number against the quantity's true value. `0.39` claims two decimals, `3.90e-1` too, `120` the unit.
/// \throws DomainError for inputs out of domain, or text that is no decimal number
PrintedEntry check_printed(const Quantity&, const Inputs&, std::string_view text);

} // namespace touchstone::oracle
