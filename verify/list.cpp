// SPDX-License-Identifier: GPL-3.0-or-later
/// `touchstone list`: all quantities, a line each.
#include "touchstone/catalogue/quantity.hpp"
#include "verify/commands.hpp"
#include "verify/exit_codes.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

namespace touchstone::program {

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
                    fmt::print("{:<26} {:<16} ({})  {}\n{:<26} unit {}; {}\n", q.name, fmt::join(q.inputs, " "), q.equation,
                               q.description, "", q.unit, q.domain);
            }
            if (*json) fmt::print("{}\n", all.dump());
            return static_cast<int>(holds);
        };
    });
}

} // namespace touchstone::program
