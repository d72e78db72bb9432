// SPDX-License-Identifier: GPL-3.0-or-later
/// `touchstone eval`: one value, correctly rounded.
#include "touchstone/catalogue/evaluate.hpp"
#include "touchstone/scalar/rational_text.hpp"
#include "verify/commands.hpp"
#include "verify/exit_codes.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace touchstone::program {
namespace {

struct EvalOptions {
    std::string quantity;
    std::vector<std::string> assignments;
    long digits = 20;
    long start_precision = 0;
    long max_precision = 0;
    bool json = false;
    bool explain = false;
};

const Quantity& quantity_named(const std::string& name)
{
    if (const Quantity* q = find_quantity(name)) return *q;
    throw Failure(usage_error, fmt::format("unknown quantity '{}'; nearest is '{}' (all: touchstone list)", name,
                                           nearest_name(name, quantity_names())));
}

/// KEY=VALUE words into exact inputs; D and gamma may stand for G.
Inputs read_inputs(const Quantity& q, const std::vector<std::string>& words)
{
    const auto takes = [&q](const std::string& key) { return std::find(q.inputs.begin(), q.inputs.end(), key) != q.inputs.end(); };
    const std::string wanted = q.inputs.empty() ? "no inputs" : fmt::format("{}", fmt::join(q.inputs, ", "));
    const bool surface = takes("G");
    std::map<std::string, Rational> values;
    for (const auto& word : words) {
        const auto equals = word.find('=');
        if (equals == std::string::npos || equals == 0)
            throw Failure(usage_error, fmt::format("'{}' is not KEY=VALUE; {} takes {}", word, q.name, wanted));
        const std::string key = word.substr(0, equals);
        const std::string text = word.substr(equals + 1);
        if (!takes(key) && !(surface && (key == "D" || key == "gamma"))) {
            if (key == "G" && takes("D") && takes("gamma"))
                throw Failure(usage_error, fmt::format("G does not determine {}; it takes {}", q.name, wanted));
            throw Failure(usage_error, fmt::format("unknown key '{}'; {} takes {}", key, q.name, wanted));
        }
        if (values.contains(key)) throw Failure(usage_error, fmt::format("key '{}' is given twice", key));
        const auto value = parse_rational(text);
        if (!value) throw Failure(bad_input, fmt::format("{} = '{}' {}", key, text, why_not_rational(text)));
        values[key] = *value;
    }
    const bool pair = values.contains("D") && values.contains("gamma");
    if (surface && values.contains("G") && (values.contains("D") || values.contains("gamma")))
        throw Failure(usage_error, "give either G or D and gamma, not both");
    for (const auto& key : q.inputs)
        if (!values.contains(key) && !(key == "G" && pair))
            throw Failure(usage_error, fmt::format("missing key '{}'{}; {} takes {}", key,
                                                   key == "G" ? " (or D and gamma)" : "", q.name, wanted));
    return Inputs(values);
}

/// What looked at a proven value beside its proof.
nlohmann::ordered_json as_json(const SecondLook& look)
{
    nlohmann::ordered_json j{{"name", look.name}, {"kind", look.is_proof ? "proof" : "witness"}, {"agrees", look.agrees}, {"digits", look.digits}};
    if (!look.shares.empty()) j["shares"] = look.shares;
    return j;
}

/// For --explain: on what the digits rest.
std::string grounds(const Evaluation& e)
{
    if (!e.proven) return fmt::format("no proof; {}\n", e.routes.empty() ? "nothing computed" : fmt::format("from {}", fmt::join(e.routes, ", ")));
    std::string text = fmt::format("'{}' proves the digits", e.routes.empty() ? "" : e.routes.front());
    if (const auto& look = e.second_look) {
        text += look->is_proof ? fmt::format("; '{}', another proof, alone proves the same", look->name)
                               : fmt::format("; '{}', a witness without proof, {} to {} digits", look->name, look->agrees ? "agrees" : "DISAGREES: equal", look->digits);
        if (!look->shares.empty()) text += fmt::format("\n  the two share {}", look->shares);
    }
    return text + "\n";
}

int evaluate_and_print(const EvalOptions& o)
{
    const Quantity& q = quantity_named(o.quantity);
    const Inputs in = read_inputs(q, o.assignments);
    const Evaluation e = evaluate(q, in, {.digits = o.digits, .start_bits = o.start_precision, .limit_bits = o.max_precision});
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
        if (!e.note.empty()) j["note"] = e.note;
        if (o.explain && explained) j["explain"] = q.explain(in, o.digits);
        fmt::print("{}\n", j.dump());
    }
    else {
        fmt::print("{}\n  {} {}: {}, {} digits, {} {}, unit {}, equation {}\n", e.value, q.name, fmt::join(o.assignments, " "), to_string(e.status), e.digits,
                   e.proven ? "|error| <=" : "error, not proven, about", e.error_bound, q.unit, q.equation);
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
    command->add_option("inputs", o->assignments, "KEY=VALUE, exact: 12, 0.1, 1e-300, 1/3, 0x1.8p-3");
    command->add_option("--digits", o->digits, "Significant digits, 1 to 10000")->capture_default_str();
    command->add_option("--start-precision", o->start_precision, "First precision tried, in bits (the result is the same)")->check(CLI::Range(2L, 1L << 30));
    command->add_option("--max-precision", o->max_precision, "No precision above this is tried, in bits")->check(CLI::Range(2L, 1L << 30));
    command->add_flag("--json", o->json, "One JSON object");
    command->add_flag("--explain", o->explain, "How the value was proven");
    command->callback([&run, o] { run = [o] { return evaluate_and_print(*o); }; });
}

} // namespace touchstone::program
