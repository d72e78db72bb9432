// SPDX-License-Identifier: MIT
#include "touchstone/oracle/judge.hpp"

#include "touchstone/catalogue/evaluate.hpp"
#include "touchstone/oracle/mixup.hpp"
#include "touchstone/rounding/decimal.hpp"
#include "touchstone/rounding/shown.hpp"
#include "touchstone/table/forced.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <random>
#include <set>

namespace touchstone::oracle {
namespace {

/// Of rows held out: eight digits beyond binary64 decide what can be decided; twice as many take a mesh of the recursion four times as
/// long.
constexpr long recursion_digits = 24, closed_form_digits = 40;

/// The most that is allowed for certain, and the least that is certainly too much.
struct Allowance {
    double certain, possible;
};

Allowance allowance(const JudgedRow& row, double own)
{
    if (!row.forced) return {own, own};
    return {own + row.forced->least, own + row.forced->most.value_or(row.forced->least)};
}

Verdict compare(const JudgedRow& row, const Allowance& a)
{
    if (row.error.most <= a.certain) return Verdict::pass;
    return row.error.least > a.possible ? Verdict::fail : Verdict::undecided;
}

/// What is allowed without regard to the inputs, in the units of error_of().
double own_allowance(const Question& question, const Bound& bound)
{
    const double least = question.truth.is_zero() ? bound.absolute : bound.ulps;
    if (bound.relative == 0 && bound.at_least == 0) return least;
    const Rational unit = question.truth.is_zero() ? Rational(1) : ulp_at(question.truth.value);
    const Rational tolerance = (exact_rational(bound.at_least) + exact_rational(bound.relative) * abs(question.truth.value)) / unit;
    return std::max(least, tolerance >= exact_rational(std::numeric_limits<double>::max()) ? std::numeric_limits<double>::max()
                                                                                           : tolerance.get_d());
}

/// What rounding the inputs forces: as the table has it, and at first no more; then with a bound that a row must be over to fail.
Forced forced_on(const Quantity& q, const Question& question, int pieces)
{
    if (question.forced && (pieces == 0 || of_the_recursion(q))) return *question.forced;
    Forced forced = forced_by_inputs(q, question.inputs, question.truth, std::max(pieces, 1));
    // a corner may be farther off than the inputs one by one: outside the contact, where only both together reach it
    if (question.forced) forced.least = std::max(forced.least, question.forced->least);
    if (forced.most) forced.most = std::max(*forced.most, forced.least);
    return forced;
}

JudgedRow judge_row(const Quantity& q, const Question& question, double answer, const Bound& bound)
{
    JudgedRow row;
    row.answer = answer;
    row.special = is_special(answer, question.truth);
    if (row.special) {
        row.error = {std::numeric_limits<double>::max(), std::numeric_limits<double>::max()};
        row.verdict = Verdict::fail;
        row.why = fmt::format("{} where the true value is {}",
                              std::isnan(answer) ? "nan"
                              : answer > 0       ? "inf"
                                                 : "-inf",
                              shown_decimal(question.value));
        return row;
    }
    row.error = error_of(answer, question.truth);
    if (bound.baseline != nullptr && !question.held_out) {
        const double before = bound.baseline->bounds.at(row_key(question.inputs));
        row.verdict = compare(row, {before, before});
        if (row.verdict != Verdict::pass)
            row.why = fmt::format("{} ulps, and {} in the baseline", shortest(row.error.most), shortest(before));
        return row;
    }
    const double own = own_allowance(question, bound);
    row.verdict = compare(row, {own, own});
    for (const int pieces : {0, 1, 2, 4}) { // the table's figure, and else a rough bound of what the inputs force, settle most rows
        if (row.verdict == Verdict::pass || (pieces > 1 && row.verdict == Verdict::fail)) break;
        if (!bound.forgive_inputs || (row.forced && of_the_recursion(q))) break; // pieces tighten the bound of closed forms alone
        if (pieces == 0 && !question.forced) continue;
        row.forced = forced_on(q, question, pieces);
        row.verdict = compare(row, allowance(row, own));
    }
    if (row.verdict == Verdict::pass) return row;
    const std::string_view unit = question.truth.is_zero() ? "off zero" : "ulps";
    row.why = fmt::format("{:.4g} {}, allowed {:.4g}", row.error.least, unit, own);
    if (row.forced) row.why += fmt::format(" and {:.4g} that rounded inputs force", row.forced->most.value_or(row.forced->least));
    return row;
}

/// Rows that differ in one input alone, in its order: where the certified values go one way, so must the answers.
void find_order_violations(const std::vector<Question>& questions, Judgement& result)
{
    if (questions.empty()) return;
    for (std::size_t k = 0; k < questions.front().inputs.size(); ++k) {
        std::map<std::vector<double>, std::vector<std::size_t>> lines;
        for (std::size_t i = 0; i < questions.size(); ++i) {
            auto others = questions[i].inputs;
            others.erase(others.begin() + static_cast<long>(k));
            if (!result.rows[i].special) lines[others].push_back(i);
        }
        for (auto& [others, line] : lines) {
            const auto input = [&](std::size_t i) { return questions[i].inputs[k]; };
            std::sort(line.begin(), line.end(), [&](std::size_t a, std::size_t b) { return input(a) < input(b); });
            for (std::size_t j = 0; j + 1 < line.size(); ++j) {
                const std::size_t a = line[j], b = line[j + 1];
                const Rational rise = questions[b].truth.value - questions[a].truth.value;
                const double found = result.rows[b].answer - result.rows[a].answer;
                if (abs(rise) <= questions[a].truth.error + questions[b].truth.error) continue;
                if ((rise > 0 && found < 0) || (rise < 0 && found > 0)) result.order.push_back({a, b, "out of order"});
            }
            for (const std::size_t a : line) {
                if (!(input(a) > 0)) continue;
                const auto mirror =
                    std::lower_bound(line.begin(), line.end(), -input(a), [&](std::size_t b, double x) { return input(b) < x; });
                if (mirror == line.end() || input(*mirror) != -input(a)) continue;
                const double x = result.rows[a].answer, y = result.rows[*mirror].answer;
                const Rational& u = questions[a].truth.value;
                const Rational& v = questions[*mirror].truth.value;
                if ((u == v && x != y) || (u == -v && x != -y)) result.order.push_back({a, *mirror, "not symmetric"});
            }
        }
    }
}

/// How bad a row is, for ordering: not passed first, then by error beyond what is forced.
std::pair<int, double> badness(const JudgedRow& row, bool zero)
{
    const int verdict = row.special ? 3 : row.verdict == Verdict::fail ? 2 : row.verdict == Verdict::undecided ? 1 : 0;
    if (zero) return {verdict, row.error.least > 0 ? 0.5 : 0.0};
    return {verdict, row.error.least - (row.forced ? std::min(row.error.least, row.forced->most.value_or(0)) : 0) + 1e-6 * row.error.most};
}

} // namespace

std::string_view to_string(Verdict v)
{
    switch (v) {
    case Verdict::pass: return "pass";
    case Verdict::fail: return "fail";
    case Verdict::undecided: break;
    }
    return "undecided";
}

std::vector<Question> questions(const StoredTable& table)
{
    std::vector<Question> all;
    for (const auto& r : table.rows) {
        all.push_back({r.inputs, r.value, {*parse_rational(r.value), *parse_rational(r.error)}, false});
        if (!r.forced) continue;
        all.back().forced = Forced{*r.forced, table.forced_estimated ? std::optional(estimate_slack * *r.forced) : std::nullopt};
    }
    return all;
}

std::vector<std::size_t> quick_rows(const Quantity& q, const std::vector<Question>& table, unsigned long seed)
{
    std::vector<std::size_t> quick, chosen;
    for (std::size_t i = 0; i < table.size(); ++i)
        if (quickly_certified(q, table[i].inputs)) quick.push_back(i);
    if (!of_the_recursion(q) || quick.empty()) return quick;
    const auto surface = [&](std::size_t i) {
        std::vector<double> s;
        for (std::size_t k = 0; k < q.inputs.size(); ++k)
            if (q.inputs[k] == "G" || q.inputs[k] == "D" || q.inputs[k] == "gamma") s.push_back(table[i].inputs[k]);
        return s;
    };
    const auto wanted = surface(quick[seed % quick.size()]);
    std::copy_if(quick.begin(), quick.end(), std::back_inserter(chosen), [&](std::size_t i) { return surface(i) == wanted; });
    return chosen;
}

std::vector<Question> held_out(const Quantity& q, const std::vector<Question>& table, std::size_t count, unsigned long seed)
{
    std::vector<Question> fresh;
    if (table.empty() || table.front().inputs.empty()) return fresh;
    std::set<std::vector<double>> taken;
    for (const auto& t : table) taken.insert(t.inputs);
    std::mt19937_64 random(seed);
    const auto uniform = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
    const std::vector<std::size_t> near = quick_rows(q, table, seed); // rows that others are made of
    if (near.empty()) return fresh;
    const bool recursion = of_the_recursion(q);
    const long digits = recursion ? recursion_digits : closed_form_digits;
    for (std::size_t tries = 0; fresh.size() < count && tries < 20 * count; ++tries) {
        std::vector<double> row = table[near[random() % near.size()]].inputs;
        for (std::size_t k = 0; k < row.size(); ++k) {
            const double change = std::ldexp(uniform() - 0.5, -static_cast<int>(random() % 12));
            const bool surface = recursion && (q.inputs[k] == "G" || q.inputs[k] == "D" || q.inputs[k] == "gamma");
            if (q.inputs[k] == "n" || surface) continue;
            row[k] *= 1 + (recursion && q.inputs[k] == "load" ? -std::fabs(change) : change); // no partial contact becomes full contact
        }
        if (!taken.insert(row).second) continue;
        try {
            const Evaluation e = evaluate(q, exact_inputs(q, row), {.digits = digits});
            if (e.status == Status::exact || e.status == Status::certified)
                fresh.push_back({row, e.value, {*parse_rational(e.value), *parse_rational(e.error_bound)}, true});
        }
        catch (const DomainError&) {
            continue; // moved out of the domain
        }
    }
    return fresh;
}

void recheck(const Quantity& q, const StoredTable& table, const std::vector<std::size_t>& rows, std::string_view file, Recheck how)
{
    const bool fewer = how == Recheck::what_decides && of_the_recursion(q) && table.digits > recursion_digits;
    for (const std::size_t i : rows) {
        const auto& row = table.rows[i];
        Evaluation e;
        try {
            e = evaluate(q, exact_inputs(q, row.inputs), {.digits = fewer ? recursion_digits : table.digits});
        }
        catch (const DomainError& error) {
            throw CorruptTable(fmt::format("{}: row {} ({}): {}", file, i + 1, row_key(row.inputs), error.what()));
        }
        const auto both_hold = [&] { // the two may have the true value in common
            return abs(Rational(*parse_rational(e.value) - *parse_rational(row.value))) <=
                   *parse_rational(e.error_bound) + *parse_rational(row.error);
        };
        if (fewer ? !both_hold() : e.value != row.value || e.error_bound != row.error)
            throw CorruptTable(fmt::format("{}: row {} ({}) holds {} +- {}, certified is {} +- {}", file, i + 1, row_key(row.inputs),
                                           row.value, row.error, e.value, e.error_bound));
        recheck_forced(q, table, i, file);
    }
}

void recheck_forced(const Quantity& q, const StoredTable& table, std::size_t i, std::string_view file)
{
    if (!table.has_forced) return;
    const auto& row = table.rows[i];
    const auto forced = forced_ulps(q, row.inputs, *parse_rational(row.value));
    const std::string right = forced ? forced_text(forced->ulps) : "-1", found = row.forced ? forced_text(*row.forced) : "-1";
    if (right != found)
        throw CorruptTable(fmt::format("{}: row {} ({}) says that rounded inputs force {} ulps; it is {}", file, i + 1, row_key(row.inputs),
                                       found, right));
}

Judgement judge(const Quantity& q, const std::vector<Question>& questions, const std::vector<double>& answers, const Bound& bound,
                const std::function<void(std::size_t, std::size_t)>& progress)
{
    Judgement result;
    std::size_t wrong_in = 0, wrong_out = 0, out = 0;
    for (std::size_t i = 0; i < questions.size(); ++i) {
        const Question& question = questions[i];
        JudgedRow row = judge_row(q, question, answers[i], bound);
        const bool counts = bound.baseline == nullptr || !question.held_out;
        result.failed += counts && row.verdict == Verdict::fail;
        result.undecided += counts && row.verdict == Verdict::undecided;
        result.special += counts && row.special;
        result.held_out_failed += !counts && row.verdict == Verdict::fail;
        out += question.held_out;
        (question.held_out ? wrong_out : wrong_in) += row.special || row.verdict == Verdict::fail;
        if (question.truth.is_zero()) {
            ++result.zeros;
            result.negative_zeros += row.answer == 0 && std::signbit(row.answer);
            if (!row.special) result.worst_at_zero = std::max(result.worst_at_zero, std::fabs(row.answer));
        }
        else {
            result.ulps.least = std::max(result.ulps.least, row.error.least);
            result.ulps.most = std::max(result.ulps.most, row.error.most);
        }
        result.rows.push_back(std::move(row));
        if (progress) progress(i + 1, questions.size());
    }
    for (std::size_t i = 0; i < questions.size(); ++i) result.worst.push_back(i);
    std::stable_sort(result.worst.begin(), result.worst.end(), [&](std::size_t a, std::size_t b) {
        return badness(result.rows[a], questions[a].truth.is_zero()) > badness(result.rows[b], questions[b].truth.is_zero());
    });
    for (std::size_t k = 0; k < std::min(shown_rows, result.worst.size()); ++k) {
        const std::size_t i = result.worst[k];
        JudgedRow& row = result.rows[i];
        if (!row.special && (bound.forgive_inputs || !of_the_recursion(q))) row.forced = forced_on(q, questions[i], 4);
    }
    find_order_violations(questions, result);
    result.looked_up = wrong_in == 0 && out > 0 && 2 * wrong_out > out;
    if (result.failed > 0 || (bound.keep_order && !result.order.empty())) result.verdict = Verdict::fail;
    else if (result.undecided > 0) result.verdict = Verdict::undecided;
    result.diagnosis = diagnose(q, questions, answers, {bound.relative, bound.at_least}, result.failed > 0 && !result.looked_up);
    return result;
}

} // namespace touchstone::oracle
