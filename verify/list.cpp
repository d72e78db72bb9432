// SPDX-License-Identifier: GPL-3.0-or-later
/// `touchstone list`: all quantities, a line each; one quantity with an adapter to copy; or all as a page of the documentation.
#include "touchstone/catalogue/quantity.hpp"
#include "touchstone/table/table.hpp"
#include "verify/commands.hpp"
#include "verify/exit_codes.hpp"
#include "verify/judge_adapter.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <sstream>
#include <utility>

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

struct ListOptions {
    std::string quantity;
    bool json = false, markdown = false;
};

nlohmann::ordered_json as_json(const Quantity& q)
{
    nlohmann::ordered_json certified = nlohmann::ordered_json::array();
    for (const Certified& c : certified_where(q))
        certified.push_back(
            {{"where", c.where}, {"digits", c.digits}, {"proof", c.proof}, {"second_look", c.second_look}, {"shares", c.shares}});
    return {{"name", q.name},     {"equation", q.equation},       {"unit", q.unit},        {"domain", q.domain},
            {"inputs", q.inputs}, {"description", q.description}, {"certified", certified}};
}

std::vector<std::string> tables_of(const Quantity& q)
{
    std::vector<std::string> names;
    for (const TableSpec& t : table_specs())
        if (t.quantity == q.name) names.push_back(t.name);
    return names;
}

/// What a value takes, roughly: docs/measured.md has figures.
std::string cost(const Quantity& q)
{
    if (q.costly) return "seconds to minutes, the first value of a surface and scale most";
    return q.plan ? "milliseconds for n <= 1, about a second for the first value of a G > 2 with load <= 1, else seconds to minutes"
                  : "milliseconds";
}

/// "20 digits", "any number of digits"; what is more than a number stays as it is said.
std::string digits_in_words(const std::string& digits)
{
    if (digits == "any") return "any number of digits";
    if (digits.starts_with("what ")) return "the digits that " + digits.substr(5);
    return digits + " digits";
}

/// One line of what is certified where, and what its second look shares with the proof.
std::string in_words(const Certified& c)
{
    if (c.proof.empty())
        return fmt::format("{}: only estimated, up to {} digits{}", c.where, c.digits, c.second_look.empty() ? "" : ", " + c.second_look);
    return fmt::format("{}: {}; proof {}, second look: {}; they share {}", c.where, digits_in_words(c.digits), c.proof, c.second_look,
                       c.shares);
}

/// For Markdown: an asterisk is one, and a bar is not the end of a table's cell.
std::string literal(const std::string& text)
{
    std::string all;
    for (const char c : text) all += c == '*' || c == '|' ? std::string("\\") + c : std::string(1, c);
    return all;
}

/// Where a method is not the same everywhere: a table of its own.
std::string certified_table(const Quantity& q)
{
    std::string all = "| certified where | digits | proof | second look | what the two share |\n|---|---|---|---|---|\n";
    for (const Certified& c : certified_where(q))
        all += fmt::format("| {} | {} | {} | {} | {} |\n", literal(c.where), c.digits, c.proof.empty() ? "none: estimated" : c.proof,
                           c.second_look, literal(c.shares));
    return all + "\n";
}

std::string section(const Quantity& q)
{
    return fmt::format("## {}\n\n{}. Equation {}.\n\n| | |\n|---|---|\n| inputs | {} |\n| unit | {} |\n| domain | {} |\n| cost | {} |\n"
                       "| tables | {} |\n\n{}",
                       q.name, literal(q.description), q.equation, q.inputs.empty() ? "none" : fmt::format("{}", fmt::join(q.inputs, ", ")),
                       literal(q.unit), literal(q.domain), cost(q), fmt::join(tables_of(q), ", "), certified_table(q));
}

/// "  domain    n from 0 ...", in lines of at most 80 columns.
std::string field(const std::string& name, const std::string& text)
{
    constexpr std::size_t indent = 12;
    const std::string lines = wrapped(text, indent);
    return fmt::format("  {:<10}{}", name, lines.size() > indent ? lines.substr(indent) : "\n");
}

int print_markdown()
{
    fmt::print("# Quantities\n\nMade by `touchstone list --markdown`. [Units](units.md) says what the inputs are; `touchstone list "
               "QUANTITY` adds an adapter to copy.\n"
               "Unless the domain says otherwise a value is certified to as many digits as asked, up to 10000.\n\n");
    for (const Quantity& q : catalogue()) fmt::print("{}", section(q));
    return holds;
}

int print_one(const std::string& name, bool json)
{
    const Quantity* q = find_quantity(name);
    if (q == nullptr)
        throw Failure(usage_error, fmt::format("unknown quantity '{}'; nearest is '{}' (all: touchstone list)", name,
                                               nearest_name(name, quantity_names())));
    if (json) {
        fmt::print("{}\n", as_json(*q).dump());
        return holds;
    }
    const auto tables = tables_of(*q);
    fmt::print("{}  {}\n\n{}{}{}{}", q->name, q->description, field("equation", q->equation),
               field("inputs", q->inputs.empty() ? "none" : fmt::format("{}", fmt::join(q->inputs, " "))), field("unit", q->unit),
               field("domain", q->domain));
    for (const char* name = "certified"; const Certified& c : certified_where(*q))
        fmt::print("{}", field(std::exchange(name, ""), in_words(c)));
    fmt::print("{}{}\n", field("cost", cost(*q)), field("tables", fmt::format("{}", fmt::join(tables, " "))));
    fmt::print("To judge your own code, put it where the adapter says `your code here`:\n  touchstone judge {} -- COMMAND\n\n",
               tables.empty() ? "TABLE" : tables.front());
    fmt::print("-- Python --\n{}\n-- C and C++ --\n{}\n-- Fortran --\n{}", adapter(*q, "python"), adapter(*q, "c"), adapter(*q, "fortran"));
    return holds;
}

int list(const ListOptions& o)
{
    if (o.markdown) return print_markdown();
    if (!o.quantity.empty()) return print_one(o.quantity, o.json);
    nlohmann::ordered_json all = nlohmann::ordered_json::array();
    for (const Quantity& q : catalogue()) {
        all.push_back(as_json(q));
        if (!o.json)
            fmt::print("{}{}{}{}", wrapped(fmt::format("{} {}", q.name, fmt::join(q.inputs, " ")), 0),
                       wrapped(fmt::format("{}; equation {}", q.description, q.equation), 4), wrapped("unit: " + q.unit, 4),
                       wrapped("domain: " + q.domain, 4));
    }
    if (o.json) fmt::print("{}\n", all.dump());
    return holds;
}

} // namespace

void add_list(CLI::App& app, Run& run)
{
    auto* command = app.add_subcommand("list", "All quantities, or one with an adapter to copy: touchstone list westergaard.pressure");
    auto o = std::make_shared<ListOptions>();
    command->add_option("quantity", o->quantity, "One quantity: its definition, and adapters in Python, C, C++ and Fortran for judge");
    command->add_flag("--json", o->json, "An array of objects, or one object");
    command->add_flag("--markdown", o->markdown, "docs/quantities.md");
    command->callback([&run, o] { run = [o] { return list(*o); }; });
}

} // namespace touchstone::program
