// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/judge_rows.hpp"

#include "touchstone/oracle/subject.hpp"
#include "touchstone/scalar/rational_text.hpp"
#include "touchstone/table/rows.hpp"
#include "touchstone/table/table.hpp"
#include "verify/exit_codes.hpp"
#include "verify/files.hpp"
#include "verify/progress.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iostream>
#include <thread>

namespace touchstone::program {
namespace {

constexpr long row_digits = 20; ///< enough to measure a hundredth of an ulp

Rational end_of(std::string_view condition, std::string_view text)
{
    const auto value = parse_rational(text);
    if (!value) throw Failure(usage_error, fmt::format("--where {}: '{}' {}", condition, text, why_not_rational(text)));
    return *value;
}

/// The inputs of a row, in the quantity's order, as a code in binary64 has them.
std::vector<double> binary64_inputs(const Quantity& q, const RowsReader& rows, const RowsReader::Row& row,
                                    const std::map<std::string, Rational>& fixed)
{
    const auto given = [&](const std::string& name) -> std::optional<Rational> {
        if (const auto column = rows.column(name)) return rows.exact(row, *column);
        const auto it = fixed.find(name);
        return it == fixed.end() ? std::nullopt : std::optional(it->second);
    };
    std::vector<double> inputs;
    for (const auto& name : q.inputs) {
        std::optional<Rational> value = given(name);
        double x = 0;
        if (value) x = nearest_double(*value);
        else { // G by D and gamma: found_inputs() has seen to it that they are there
            const Inputs surface({{"D", *given("D")}, {"gamma", *given("gamma")}});
            try {
                require_surface(surface);
            }
            catch (const DomainError& e) {
                throw rows.fault(row, e.what());
            }
            const WorkingPrecision precision(256);
            x = touchstone::nearest_double(surface.G_ball()).value_or(std::nan(""));
        }
        if (!std::isfinite(x)) throw rows.fault(row, fmt::format("{} is beyond binary64", name));
        inputs.push_back(x);
    }
    return inputs;
}

/// Every input must come from a column or from KEY=VALUE, and from one of them only.
void check_columns(const Quantity& q, const RowsReader& rows, const std::map<std::string, Rational>& fixed, const std::string& file)
{
    const auto has = [&](const std::string& name) { return rows.column(name).has_value() || fixed.contains(name); };
    for (const auto& [name, value] : fixed)
        if (rows.column(name))
            throw Failure(usage_error, fmt::format("{}: '{}' is a column and given as {}={} too", file, name, name, value.get_str()));
    for (const auto& name : q.inputs)
        if (!has(name) && !(name == "G" && has("D") && has("gamma")))
            throw Failure(usage_error, fmt::format("{}: no column '{}'{}; name one, or give {}=VALUE", file, name,
                                                   name == "G" ? " (or D and gamma)" : "", name));
    if (has("G") && std::find(q.inputs.begin(), q.inputs.end(), "G") != q.inputs.end() && (has("D") || has("gamma")))
        throw Failure(usage_error, fmt::format("{}: either G or D and gamma, not both", file));
}

RowsReader::Format format_for(const Quantity& q)
{
    RowsReader::Format format{q.inputs, {"value", "error", "forced", "status", "binary64"}};
    if (std::find(q.inputs.begin(), q.inputs.end(), "G") != q.inputs.end())
        for (const char* name : {"D", "gamma"}) format.known.emplace_back(name);
    format.known.emplace_back("answer");
    for (const auto& name : q.inputs) format.ignored.push_back(name + "_hex");
    return format;
}

/// Rows whose evaluations are held at once: they take twice the memory of what is kept of them.
constexpr std::size_t rows_at_once = 20'000;

/// Certified values on all threads; what has none is left out.
void certify(const Quantity& q, const std::vector<std::vector<double>>& grid, JudgedFile& file, std::vector<double>& answers)
{
    Progress progress("certifying rows", grid.size());
    std::size_t kept = 0; // of the answers
    const std::size_t step = oracle::of_the_recursion(q) ? grid.size() : rows_at_once; // rows of the recursion share their discretisation
    file.questions.reserve(grid.size());
    for (std::size_t begin = 0; begin < grid.size(); begin += step) {
        const std::size_t end = std::min(grid.size(), begin + step);
        TableSpec spec;
        spec.name = "rows";
        spec.quantity = q.name;
        spec.grid = [&] { return std::vector(grid.begin() + static_cast<long>(begin), grid.begin() + static_cast<long>(end)); };
        const Table table = compute(spec, row_digits, std::max(1u, std::thread::hardware_concurrency()),
                                    [&](std::size_t done, std::size_t) { progress.done(begin + done); });
        for (std::size_t i = begin; i < end; ++i) {
            const Evaluation& e = table.rows[i - begin].result;
            if (e.status != Status::exact && e.status != Status::certified) {
                if (file.left_out++ == 0) file.why_left_out = e.note.empty() ? std::string(to_string(e.status)) : e.note;
                continue;
            }
            file.questions.push_back({grid[i], e.value, {*parse_rational(e.value), *parse_rational(e.error_bound)}, false});
            if (!answers.empty()) answers[kept++] = answers[i];
        }
    }
    if (!answers.empty()) answers.resize(kept);
}

} // namespace

Where::Where(const Quantity& q, const std::vector<std::string>& conditions)
{
    for (const auto& all : conditions)
        for (std::size_t begin = 0; begin <= all.size();) {
            const std::string condition = all.substr(begin, std::min(all.find(',', begin), all.size()) - begin);
            begin += condition.size() + 1;
            const auto equals = condition.find('=');
            const std::string name = condition.substr(0, equals);
            const auto input = std::find(q.inputs.begin(), q.inputs.end(), name);
            if (equals == std::string::npos || input == q.inputs.end())
                throw Failure(usage_error, fmt::format("--where '{}': right is INPUT=VALUE or INPUT=LOW..HIGH with one of {}", condition,
                                                       fmt::join(q.inputs, ", ")));
            const std::string range = condition.substr(equals + 1);
            const auto dots = range.find("..");
            const std::string low = range.substr(0, dots), high = dots == std::string::npos ? low : range.substr(dots + 2);
            ends_.push_back({static_cast<std::size_t>(input - q.inputs.begin()), end_of(condition, low), end_of(condition, high)});
            if (ends_.back().low > ends_.back().high)
                throw Failure(usage_error, fmt::format("--where {}: {} is above {}", condition, low, high));
        }
}

bool Where::holds(const std::vector<double>& inputs) const
{
    return std::all_of(ends_.begin(), ends_.end(), [&](const Ends& e) {
        const Rational x = exact_rational(inputs[e.input]);
        return (e.low <= x && x <= e.high) || inputs[e.input] == nearest_double(e.low) || inputs[e.input] == nearest_double(e.high);
    });
}

JudgedFile read_rows(const Quantity& q, const std::string& file, const std::map<std::string, Rational>& fixed, const Where& where)
{
    std::ifstream opened;
    if (file != "-") {
        opened.open(file, std::ios::binary);
        if (!opened) read_file(file); // says why not
    }
    RowsReader rows(file == "-" ? std::cin : opened, file == "-" ? "standard input" : file, format_for(q));
    check_columns(q, rows, fixed, file);
    const auto answer_column = rows.column("answer");
    std::vector<std::vector<double>> grid;
    std::vector<double> answers;
    for (RowsReader::Row row; rows.next(row);) {
        std::vector<double> inputs = binary64_inputs(q, rows, row, fixed);
        try {
            q.check(oracle::exact_inputs(q, inputs));
        }
        catch (const DomainError& e) {
            throw rows.fault(row, e.what());
        }
        if (answer_column) {
            const auto answer = oracle::parse_answer(row.words[*answer_column]);
            if (!answer) throw rows.fault(row, fmt::format("the answer '{:.40}' is not one number", row.words[*answer_column]));
            if (where.holds(inputs)) answers.push_back(*answer);
        }
        if (!where.holds(inputs)) continue;
        grid.push_back(std::move(inputs));
        if (grid.size() > most_judged_rows)
            throw rows.fault(row, fmt::format("more than {} rows to judge at once; choose some by --where", most_judged_rows));
    }
    if (grid.empty()) throw Failure(bad_input, fmt::format("{}: --where leaves no row", file));
    JudgedFile judged;
    certify(q, grid, judged, answers);
    if (answer_column) judged.answers = std::move(answers);
    return judged;
}

} // namespace touchstone::program
