// SPDX-License-Identifier: GPL-3.0-or-later
/// `touchstone eval`: one value, correctly rounded.
#include "verify/commands.hpp"
#include "verify/eval.hpp"
#include "verify/exit_codes.hpp"
#include "verify/own_rows.hpp"
#include "verify/progress.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace touchstone::program {
namespace {

Rounding rounding_of(const EvalOptions& o) { return *rounding_named(o.round); }

/// What looked at a proven value beside its proof.
nlohmann::ordered_json as_json(const SecondLook& look)
{
    nlohmann::ordered_json j{
        {"name", look.name}, {"kind", look.is_proof ? "proof" : "witness"}, {"agrees", look.agrees}, {"digits", look.digits}};
    if (!look.shares.empty()) j["shares"] = look.shares;
    return j;
}

/// For --explain: on what the digits rest.
std::string grounds(const Evaluation& e)
{
    if (!e.proven)
        return fmt::format("no proof; {}\n", e.routes.empty() ? "nothing computed" : fmt::format("from {}", fmt::join(e.routes, ", ")));
    std::string text = fmt::format("'{}' proves the digits", e.routes.empty() ? "" : e.routes.front());
    if (const auto& look = e.second_look) {
        text += look->is_proof ? fmt::format("; '{}', another proof, alone proves {}", look->name,
                                             look->digits < e.digits ? fmt::format("the first {}", look->digits) : "the same")
                               : fmt::format("; '{}', a witness without proof, {} to {} digits", look->name,
                                             look->agrees ? "agrees" : "DISAGREES: equal", look->digits);
        if (!look->shares.empty()) text += fmt::format("\n  the two share {}", look->shares);
    }
    return text + "\n";
}

int evaluate_and_print(const EvalOptions& o)
{
    const Quantity& q = quantity_named(o.quantity);
    const NamedTexts named = key_values(q, o.assignments);
    if (!o.rows.empty() || std::any_of(named.begin(), named.end(), [](const auto& n) { return is_range(n.second); }))
        return evaluate_rows(o, q, named);
    if (o.resume || o.binary64 || !o.out.empty())
        throw Failure(usage_error, "--out, --resume and --binary64 go with --rows or a range such as load=0.1:0.9:0.1");
    const Inputs in = read_inputs(q, named);
    const Evaluation e = [&] {
        const Progress progress(q.name);
        return evaluate(q, in, {.digits = o.digits, .start_bits = o.start_precision, .limit_bits = o.max_precision}, rounding_of(o));
    }();
    const bool explained = e.status == Status::certified && q.explain; // else there is no proof to explain
    if (o.json) {
        nlohmann::ordered_json inputs = nlohmann::ordered_json::object();
        for (const auto& word : o.assignments) inputs[word.substr(0, word.find('='))] = word.substr(word.find('=') + 1);
        nlohmann::ordered_json j{{"quantity", q.name}, {"inputs", inputs}, {"value", e.value}, {"digits", e.digits},
                                 {"status", std::string(to_string(e.status))}};
        if (e.binary64) j["binary64"] = hexfloat(*e.binary64);
        j["routes"] = e.routes;
        if (e.second_look) j["second_look"] = as_json(*e.second_look);
        j[e.proven ? "error" : "error_estimate"] = e.error_bound;
        j["equation"] = q.equation;
        j["unit"] = q.unit;
        if (o.round != "nearest") j["rounding"] = o.round;
        if (!e.note.empty()) j["note"] = e.note;
        if (o.explain && explained) j["explain"] = q.explain(in, o.digits);
        fmt::print("{}\n", j.dump());
    }
    else {
        fmt::print("{}\n  {} {}: {}, {} digits, {} {}, unit {}, equation {}\n", e.value, q.name, fmt::join(o.assignments, " "),
                   to_string(e.status), e.digits, e.proven ? "|error| <=" : "error, not proven, about", e.error_bound, q.unit, q.equation);
        if (e.binary64) fmt::print("  nearest binary64 {} = {}\n", hexfloat(*e.binary64), shortest(*e.binary64));
        if (!e.note.empty()) fmt::print("  {}\n", e.note);
        if (o.explain) {
            fmt::print("  {}", grounds(e));
            if (explained) fmt::print("{}", q.explain(in, o.digits));
        }
    }
    return e.status == Status::undecided ? undecided : holds;
}

} // namespace

void add_eval(CLI::App& app, Run& run)
{
    auto* command = app.add_subcommand("eval", "One value, correctly rounded: touchstone eval archard.K n=3 --digits 30");
    auto o = std::make_shared<EvalOptions>();
    command->add_option("quantity", o->quantity, "Name, as `touchstone list` gives it")->required();
    command->add_option("inputs", o->assignments,
                        "KEY=VALUE, exact: 12, 0.1, 1e-300, 1/3, 0x1.8p-3, G=sqrt(10), 2^-5; ranges: 0.1:0.9:0.1, log:1e-9:1:50, 1,2,3");
    command->add_option("--digits", o->digits, "Significant digits, 1 to 10000")->capture_default_str();
    command->add_option("--start-precision", o->start_precision, "First precision tried, in bits (the result is the same)")
        ->check(CLI::Range(2L, 1L << 30));
    command->add_option("--max-precision", o->max_precision, "No precision above this is tried, in bits (rounded up to whole digits)")->check(CLI::Range(2L, 1L << 30));
    command->add_flag("--json", o->json, "One JSON object (rows: one a line)");
    command->add_option("--round", o->round, "nearest, up, down, zero or away: a bound instead of the nearest decimal")
        ->check(CLI::IsMember(rounding_names()))
        ->capture_default_str();
    command->add_option("--rows", o->rows, "File of rows, or - for standard input: inputs by column names; the others as KEY=VALUE");
    command->add_option("--out", o->out, "With rows or ranges: file for the table (default: standard output)");
    command->add_option("--shard", o->shard,
                        "With rows or ranges: I/N, only share I of N, a file of its own in the folder --out, for touchstone merge; kept if "
                        "it is there already");
    command->add_flag("--resume", o->resume, "Keep the rows that the file given to --out has already");
    command->add_flag("--binary64", o->binary64, "Rows: round each input to the nearest binary64 number first");
    command->add_option("--jobs", o->jobs, "Rows: threads")->check(CLI::Range(1u, 1024u));
    command->add_flag("--explain", o->explain, "How the value was proven");
    command->callback([&run, o] { run = [o] { return evaluate_and_print(*o); }; });
}

} // namespace touchstone::program
