// SPDX-License-Identifier: MIT
#include "touchstone/oracle/regime.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace touchstone::oracle {
namespace {

constexpr double near = 1e-3;       ///< of an edge or of full contact, relatively
constexpr double tiny = 1e-6;       ///< a load below
constexpr std::size_t several = 3;  ///< answers alike are a fault worth a sentence
constexpr double most_digits = 17;

const std::vector<std::string>& names()
{
    static const std::vector<std::string> all{"ordinary",  "near the edge", "nearly full contact", "full contact",
                                              "tiny load", "subnormal",     "true value zero"};
    return all;
}

std::optional<double> input(const Quantity& q, const Question& question, std::string_view name)
{
    const auto it = std::find(q.inputs.begin(), q.inputs.end(), name);
    return it == q.inputs.end() ? std::nullopt : std::optional(question.inputs[static_cast<std::size_t>(it - q.inputs.begin())]);
}

bool close_to(double value, double edge) { return std::fabs(value - edge) <= near * edge; }

/// The edge of one wave's contact, or of the pressures in it; for more scales than one there is no single edge.
bool near_the_edge(const Quantity& q, const Question& question, double load)
{
    const bool westergaard = q.name.starts_with("westergaard"), hertz = q.name.starts_with("hertz");
    if (!westergaard && !hertz) return false;
    if (const auto x = input(q, question, "x")) {
        if (westergaard && load >= 1) return false;
        const double edge = westergaard ? std::asin(std::sqrt(load)) / std::numbers::pi : std::sqrt(load) / std::numbers::pi;
        return close_to(std::fabs(*x), edge);
    }
    if (const auto p = input(q, question, "p")) {
        if (load < 1) return close_to(*p, 2 * std::sqrt(load));
        return close_to(*p, load + 1) || close_to(*p, load - 1);
    }
    return false;
}

bool subnormal(double x) { return x != 0 && std::fabs(x) < std::numeric_limits<double>::min(); }

/// What answers that did not pass have in common.
void name_faults(Regime& r, const std::vector<std::size_t>& rows, const std::vector<Question>& questions, const Judgement& judgement)
{
    std::size_t zero = 0, nan = 0, infinite = 0, sign = 0;
    for (const std::size_t i : rows) {
        const JudgedRow& row = judgement.rows[i];
        if (row.verdict == Verdict::pass) continue;
        const int right = sgn(questions[i].truth.value);
        zero += row.answer == 0 && right != 0;
        nan += std::isnan(row.answer);
        infinite += std::isinf(row.answer);
        sign += std::isfinite(row.answer) && right != 0 && row.answer * right < 0;
    }
    for (const auto& [count, what] :
         {std::pair{zero, "0"}, std::pair{nan, "nan"}, std::pair{infinite, "infinite"}, std::pair{sign, "of the wrong sign"}})
        if (count >= std::min(several, rows.size())) r.faults.push_back(fmt::format("{} of {} answers are {}", count, rows.size(), what));
}

Regime summary(const Quantity& q, const std::string& name, const std::vector<std::size_t>& rows, const std::vector<Question>& questions,
               const Judgement& judgement)
{
    Regime r;
    r.name = name;
    r.rows = rows.size();
    std::optional<std::size_t> worst;
    for (const std::size_t i : rows) {
        const JudgedRow& row = judgement.rows[i];
        r.failed += row.verdict == Verdict::fail;
        r.undecided += row.verdict == Verdict::undecided;
        if (!std::isfinite(row.answer)) continue;
        const Rational& truth = questions[i].truth.value;
        const Rational off = abs(Rational(exact_rational(row.answer) - truth)) + questions[i].truth.error;
        r.worst_absolute = std::max(r.worst_absolute, nearest_double(off));
        if (truth == 0) continue;
        const double relative = nearest_double(Rational(off / abs(truth)));
        if (!r.worst_relative || relative > *r.worst_relative) {
            r.worst_relative = relative;
            worst = i;
        }
    }
    if (worst) {
        const JudgedRow& row = judgement.rows[*worst];
        const Question& question = questions[*worst];
        r.forced = row.forced;
        if (!r.forced) r.forced = question.forced;
        if (!r.forced && !of_the_recursion(q)) r.forced = forced_by_inputs(q, question.inputs, question.truth, 1);
        if (r.forced)
            r.forced_relative = r.forced->least * nearest_double(Rational(ulp_at(question.truth.value) / abs(question.truth.value)));
    }
    name_faults(r, rows, questions, judgement);
    return r;
}

} // namespace

double Regime::right_digits() const
{
    if (!worst_relative || *worst_relative == 0) return most_digits;
    return *worst_relative >= 1 ? 0 : std::min(-std::log10(*worst_relative), most_digits);
}

std::string regime_of(const Quantity& q, const Question& question)
{
    if (question.truth.value == 0) return "true value zero";
    bool small = subnormal(nearest_double(question.truth.value)) || nearest_double(question.truth.value) == 0;
    for (const double x : question.inputs) small = small || subnormal(x);
    if (small) return "subnormal";
    const auto load = input(q, question, "load");
    if (!load) return "ordinary";
    if (near_the_edge(q, question, *load)) return "near the edge";
    const bool fills = !q.name.starts_with("hertz") && !q.name.starts_with("archard"); // those have no full contact
    if (fills && *load >= 1) return "full contact";
    if (fills && *load >= 1 - near) return "nearly full contact";
    return *load < tiny ? "tiny load" : "ordinary";
}

std::vector<Regime> regimes(const Quantity& q, const std::vector<Question>& questions, const Judgement& judgement)
{
    std::map<std::string, std::vector<std::size_t>> rows;
    for (std::size_t i = 0; i < questions.size(); ++i) rows[regime_of(q, questions[i])].push_back(i);
    std::vector<Regime> all;
    for (const auto& name : names())
        if (const auto it = rows.find(name); it != rows.end()) all.push_back(summary(q, name, it->second, questions, judgement));
    return all;
}

} // namespace touchstone::oracle
