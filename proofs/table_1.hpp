// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Table 1, "Values of K_n", and the limit quoted in (7.20), against the certified K_n of (7.13).
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace touchstone::proofs {

/// One printed number and what is proven about it.
struct PrintedNumber {
    std::string id;           ///< "table1.n07", "text.limit-0.39139"
    std::string printed;      ///< as printed, without the grouping blank
    std::string true_value;   ///< correctly rounded, 20 digits, certified
    std::string rounded;      ///< the true value rounded to as many digits as are printed
    bool holds = false;       ///< printed == rounded
};

/// The text of data/paper/table_1.txt, as compiled in.
std::string_view table_1_text();

/// Judge every entry of a transcription in the format of data/paper/table_1.txt.
std::vector<PrintedNumber> check_table_1(std::string_view transcription);

} // namespace touchstone::proofs
