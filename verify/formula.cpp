// SPDX-License-Identifier: GPL-3.0-or-later
/// `touchstone formula`: a quantity's formula as source code.
#include "touchstone/formula/formulas.hpp"
#include "verify/commands.hpp"
#include "verify/exit_codes.hpp"
#include "verify/own_rows.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace touchstone::program {
namespace {

struct FormulaOptions {
    std::string quantity, language;
    std::vector<std::string> assignments;
};

int print_formula(const FormulaOptions& o)
{
    const Quantity& q = quantity_named(o.quantity);
    std::optional<long> n;
    for (const auto& [key, text] : key_values(q, o.assignments)) {
        const auto value = parse_rational(text);
        if (key != "n" || n)
            throw Failure(usage_error, fmt::format("'{}={}': only n is given, once; the other inputs stay open", key, text));
        if (!value || value->get_den() != 1 || abs(*value) > 1'000'000)
            throw Failure(bad_input, fmt::format("n = '{:.40}' is not an integer such as 3", text));
        n = value->get_num().get_si();
    }
    fmt::print("{}", formula::emit(formula::formula_of(q.name, n), o.language));
    return holds;
}

} // namespace

void add_formula(CLI::App& app, Run& run)
{
    auto* command = app.add_subcommand("formula", "A formula as source code: touchstone formula westergaard.pressure --as c");
    auto o = std::make_shared<FormulaOptions>();
    command->add_option("quantity", o->quantity, "Name, as `touchstone list` gives it")->required();
    command->add_option("n", o->assignments, "n=3, where the quantity has a scale: the recursion is written out for it");
    command->add_option("--as", o->language, "latex, c, fortran, python, julia, octave, fpcore or sympy")
        ->check(CLI::IsMember(formula::languages()))
        ->required();
    command->callback([&run, o] { run = [o] { return print_formula(*o); }; });
}

} // namespace touchstone::program
