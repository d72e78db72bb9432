// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The report as one HTML file that asks nothing of the network.
#pragma once

#include "verify/figures/figure.hpp"
#include "verify/report/judged.hpp"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace touchstone::program::report {

struct Drawn {
    figures::Figure figure;
    bool of_paper = true;
    std::string wide, narrow; ///< SVG
    std::string pdf;
};

struct Contents {
    std::vector<Drawn> drawn;
    nlohmann::ordered_json ledger;
    std::vector<Judged> judged; ///< none where there are no codes to judge
    std::string judged_drawing; ///< SVG
};

std::string page(const Contents&);

// ---- its parts, ledger.cpp

/// What `touchstone paper --json` wrote. \throws Failure if it is something else
nlohmann::ordered_json parse_ledger(const std::string& text, const std::string& file);
/// Every entry, unfolding, with the boxes that filter them.
std::string ledger_section(const nlohmann::ordered_json& ledger);
/// What is refuted, as the authors would print it.
std::string erratum_section(const nlohmann::ordered_json& ledger);
/// Table 1 with certified digits beside the print.
std::string table_1_section();
/// "94 proved, 24 verified, ..."
std::string tally(const nlohmann::ordered_json& ledger);

} // namespace touchstone::program::report
