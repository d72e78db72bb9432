// SPDX-License-Identifier: GPL-3.0-or-later
/// `touchstone list`: all quantities, a line each.
#include "touchstone/catalogue/quantity.hpp"
#include "verify/commands.hpp"
#include "verify/exit_codes.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <sstream>

namespace touchstone::program {
namespace {

constexpr std::size_t columns = 80;

/// Words in lines of at most 80 columns, each begun with `indent` blanks.
std::string wrapped(const std::string& text, std::size_t indent)
{
    std::string out, line;
    std::istringstream words(text);
    const auto end_line = [&] {
        if (!line.empty()) out += line + "\n";
        line.clear();
    };
    for (std::string word; words >> word;) {
        if (!line.empty() && line.size() + 1 + word.size() > columns) end_line();
        line += line.empty() ? std::string(indent, ' ') + word : " " + word;
    }
    end_line();
    return out;
}

} // namespace

void add_list(CLI::App& app, Run& run)
{
    auto* command = app.add_subcommand("list", "All quantities: inputs, equation, unit, domain");
    auto json = std::make_shared<bool>(false);
    command->add_flag("--json", *json, "An array of objects");
    command->callback([&run, json] {
        run = [json] {
            nlohmann::ordered_json all = nlohmann::ordered_json::array();
            for (const auto& q : catalogue()) {
                all.push_back({{"name", q.name}, {"equation", q.equation}, {"unit", q.unit}, {"domain", q.domain},
                               {"inputs", q.inputs}, {"description", q.description}});
                if (!*json)
                    fmt::print("{}{}{}{}", wrapped(fmt::format("{} {}", q.name, fmt::join(q.inputs, " ")), 0),
                               wrapped(fmt::format("{}; equation {}", q.description, q.equation), 4), wrapped("unit: " + q.unit, 4), wrapped("domain: " + q.domain, 4));
            }
            if (*json) fmt::print("{}\n", all.dump());
            return static_cast<int>(holds);
        };
    });
}

} // namespace touchstone::program
