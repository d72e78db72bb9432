// SPDX-License-Identifier: GPL-3.0-or-later
/// `touchstone paper`: what the paper prints, one verdict each.
#include "proofs/table_1.hpp"
#include "verify/commands.hpp"
#include "verify/exit_codes.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace touchstone::program {
namespace {

struct Verdict {
    std::string id, verdict, statement, reason, correction;
};

Verdict of_entry(const proofs::PrintedNumber& p)
{
    return {p.id, p.holds ? "verified" : "refuted", fmt::format("K_n = {}", p.printed),
            fmt::format("true value {}, rounded to as many digits {}", p.true_value, p.rounded), p.holds ? "" : p.rounded};
}

/// (7.20) prints 0.391 39...: right as a rounding, wrong if the dots mean that more digits follow these.
Verdict of_limit(const proofs::PrintedNumber& p)
{
    const bool both = p.holds && p.leading;
    return {p.id, both ? "verified" : "refuted", "K_inf = 0.391 39...",
            fmt::format("true value {}: 0.39139 is {} rounding to five digits, but {} the first five digits that the dots announce",
                        p.true_value, p.holds ? "the" : "not the", p.leading ? "also" : "not"),
            both ? "" : p.true_value.substr(0, 9) + "..."};
}

int print_ledger(bool json)
{
    std::vector<Verdict> all;
    for (const auto& p : proofs::check_table_1(proofs::table_1_text())) all.push_back(of_entry(p));
    all.push_back(of_limit(proofs::check_limit_7_20()));
    int entries = 0;
    nlohmann::ordered_json out = nlohmann::ordered_json::array();
    for (const auto& v : all) {
        entries += v.id.starts_with("table1") && v.verdict == "verified" ? 1 : 0;
        if (json)
            out.push_back({{"id", v.id}, {"verdict", v.verdict}, {"method", "certified evaluation"}, {"statement", v.statement},
                           {"reason", v.reason}, {"correction", v.correction}});
        else fmt::print("{:<20} {:<9} {:<20} {}\n", v.id, v.verdict, v.statement, v.reason);
    }
    if (json) fmt::print("{}\n", out.dump());
    else fmt::print("Table 1: {} of 20 entries are the correct rounding of the true K_n\n", entries);
    return entries == 20 ? holds : fails;
}

} // namespace

void add_paper(CLI::App& app, Run& run)
{
    auto* command = app.add_subcommand("paper", "What the paper prints, one verdict each");
    auto json = std::make_shared<bool>(false);
    command->add_flag("--json", *json, "An array of objects");
    command->callback([&run, json] { run = [json] { return print_ledger(*json); }; });
}

} // namespace touchstone::program
