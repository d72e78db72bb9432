// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The codes of verify/subjects, judged while the report is made.
#pragma once

#include <nlohmann/json.hpp>

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace touchstone::program::report {

/// A code, what it is judged by, and what `touchstone judge` said.
struct Judged {
    std::string code;    ///< "GSL"
    std::string table;
    std::string command; ///< as a reader would type it
    nlohmann::json said; ///< of `judge --json`
};

/// The judged codes that were built with this program; none for an installed one, which has none.
std::optional<std::filesystem::path> shipped_codes();
/// How many judgements judge_shipped() makes.
std::size_t judgements();
/// Each by the program itself, in a process of its own. \param judged_one is called after each
std::vector<Judged> judge_shipped(const std::filesystem::path& codes, const std::function<void(std::size_t)>& judged_one);
/// The picture of `judge --svg` for the first of them.
std::string drawn_judgement(const std::filesystem::path& codes);

std::string judged_section(const std::vector<Judged>&, const std::string& drawing);

} // namespace touchstone::program::report
