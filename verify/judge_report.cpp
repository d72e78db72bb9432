// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/judge_report.hpp"

#include "touchstone/rounding/decimal.hpp"
#include "touchstone/oracle/stable_form.hpp"
#include "touchstone/rounding/shown.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace touchstone::program {
namespace {

using Json = nlohmann::ordered_json;
using oracle::Verdict;

/// Shown to a person: 12.3 or 1.7e+09; "huge" for what binary64 cannot hold.
std::string brief(double x) { return x >= std::numeric_limits<double>::max() ? "huge" : fmt::format("{:.3g}", x); }

std::string brief(const oracle::Interval& i)
{
    const std::string least = brief(i.least), most = brief(i.most);
    return least == most ? least : least + " to " + most;
}

std::string named_inputs(const Case& c, std::size_t row)
{
    std::string text;
    for (std::size_t k = 0; k < c.quantity->inputs.size(); ++k)
        text += fmt::format("{}{}={}", k > 0 ? " " : "", c.quantity->inputs[k], shortest(c.questions[row].inputs[k]));
    return text.empty() ? "no inputs" : text;
}

std::vector<std::string> hex_inputs(const Case& c, std::size_t row)
{
    std::vector<std::string> hex;
    for (const double x : c.questions[row].inputs) hex.push_back(hexfloat(x));
    return hex;
}

constexpr double oracle_noise = 1e-2; ///< a median ratio this near to 1 is no factor

/// The rows a reader is shown: those not passed, or the worst of those passed if all are.
std::vector<std::size_t> shown(const Case& c)
{
    std::vector<std::size_t> rows;
    for (const std::size_t i : c.judgement.worst)
        if (rows.size() < oracle::shown_rows) rows.push_back(i);
    return rows;
}

Json interval(double least, std::optional<double> most)
{
    Json j = Json::array({least});
    if (most && std::isfinite(*most)) j.push_back(*most);
    else j.push_back(nullptr); // nothing bounds it
    return j;
}

Json forced(const oracle::JudgedRow& row) { return row.forced ? interval(row.forced->least, row.forced->most) : Json(nullptr); }

std::string escaped(std::string_view text)
{
    std::string out;
    for (const char ch : text) {
        const auto u = static_cast<unsigned char>(ch);
        if (ch == '&') out += "&amp;";
        else if (ch == '<') out += "&lt;";
        else if (ch == '>') out += "&gt;";
        else if (ch == '"') out += "&quot;";
        else if ((u < 0x20 && ch != '\n' && ch != '\t') || u >= 0x7f) out += fmt::format("\\x{:02x}", u);
        else out += ch;
    }
    return out;
}

/// What a program wrote, for a terminal or a log: control characters and bytes beyond ASCII become visible, lines stay lines.
std::string printable(std::string_view text)
{
    std::string out;
    for (const char ch : text) {
        const auto u = static_cast<unsigned char>(ch);
        out += (u < 0x20 && ch != '\n' && ch != '\t') || u >= 0x7f ? fmt::format("\\x{:02x}", u) : std::string(1, ch);
    }
    return out;
}

/// The end of a subject's stderr, if it wrote there.
std::string last_words(const Case& c)
{
    constexpr std::size_t most = 300;
    std::string_view words = c.answers.chatter;
    while (!words.empty() && (words.back() == '\n' || words.back() == '\r')) words.remove_suffix(1);
    if (words.empty()) return "";
    if (words.size() > most) words.remove_prefix(words.size() - most);
    return fmt::format("  the end of what it wrote to stderr: {}\n", printable(words));
}

std::string headline(const Case& c)
{
    const auto& j = c.judgement;
    std::string text = fmt::format("{}: {} rows of {}",
                                   j.verdict == Verdict::pass   ? "PASS"
                                   : j.verdict == Verdict::fail ? "FAIL"
                                                                : "UNDECIDED",
                                   c.questions.size(), c.table);
    if (c.held_out > 0) text += fmt::format(" ({} of them held out)", c.held_out);
    if (j.failed > 0) text += fmt::format(", {} fail", j.failed);
    if (j.undecided > 0) text += fmt::format(", {} undecided", j.undecided);
    return text;
}

std::string allowed(const oracle::Bound& b)
{
    std::string text = fmt::format("{:g} ulps", b.ulps);
    if (b.relative > 0 || b.at_least > 0) text += fmt::format(" or {:g} + {:g} |true|", b.at_least, b.relative);
    return text;
}

/// A line a regime: how far off, how many digits that is, and what rounding the inputs forces on the worst row.
std::string by_regime(const Case& c)
{
    std::string text = fmt::format("  {:<20}{:>7}{:>7}{:>16}{:>16}{:>8}   {}\n", "regime", "rows", "wrong", "worst absolute",
                                   "worst relative", "digits", "forced by inputs");
    for (const auto& r : c.regimes) {
        const std::string relative = r.worst_relative ? brief(*r.worst_relative) : "-";
        const std::string forced = !r.worst_relative ? "-" : r.forced ? brief(r.forced_relative) : "not worked out";
        const std::string digits = r.worst_relative ? fmt::format("{:.1f}", r.right_digits()) : "-";
        text += fmt::format("  {:<20}{:>7}{:>7}{:>16}{:>16}{:>8}   {}\n", r.name, r.rows, r.failed + r.undecided, brief(r.worst_absolute),
                            relative, digits, forced);
    }
    for (const auto& r : c.regimes)
        for (const auto& fault : r.faults) text += fmt::format("  {}: {}\n", r.name, fault);
    return text;
}

Json regimes_json(const Case& c)
{
    Json all = Json::array();
    for (const auto& r : c.regimes) {
        Json one{
            {"name", r.name}, {"rows", r.rows}, {"failed", r.failed}, {"undecided", r.undecided}, {"worst_absolute", r.worst_absolute}};
        one["worst_relative"] = r.worst_relative ? Json(*r.worst_relative) : Json(nullptr);
        one["right_digits"] = r.worst_relative ? Json(r.right_digits()) : Json(nullptr);
        one["forced_relative"] = r.forced ? Json(r.forced_relative) : Json(nullptr);
        one["faults"] = r.faults;
        all.push_back(std::move(one));
    }
    return all;
}

/// What the answers have in common, and how the library computes what was lost.
std::string diagnosis(const Case& c)
{
    const auto& j = c.judgement;
    const auto& d = j.diagnosis;
    std::string text;
    if (d.ratio.rows > 0)
        text += fmt::format("  answer/true: median {:.10g}, the middle half from {:.10g} to {:.10g} ({} rows)\n", d.ratio.median,
                            d.ratio.lower, d.ratio.upper, d.ratio.rows);
    if (d.mixup) {
        text += fmt::format("  likely mistake: {} (explains {:.0f} % of the {}rows that tell, to {:.2g} of the value)\n", d.mixup->name,
                            100 * d.mixup->explains, d.mixup->ordinary_only ? "ordinary " : "", d.mixup->to);
        if (d.mixup->ordinary_only) text += "  rows that are not ordinary are wrong in another way too\n";
        if (d.mixup->remains > 0) text += fmt::format("  wrong even with that put right: {} of the rows tried\n", d.mixup->remains);
    }
    else if (j.failed > 0) {
        const bool one = std::fabs(d.ratio.median - 1) <= oracle_noise;
        text += d.ratio.rows > 0 && !one ? "  no known mix-up gives that ratio\n" : "  no known mix-up explains the answers\n";
    }
    for (const auto& finding : d.findings) text += "  " + finding + "\n";
    if (const std::string form = oracle::stable_form(c.quantity->name); j.failed > 0 && !form.empty())
        text += "  the library computes " + form + "\n";
    return text;
}

} // namespace

std::string as_text(const Case& c)
{
    if (c.answers.fault)
        return fmt::format("PROTOCOL: {}: {}, {} rows answered\n{}", c.table, to_string(c.answers.fault->kind), c.answers.fault->answered,
                           last_words(c)); // what happened is the one line on stderr
    const auto& j = c.judgement;
    std::string text = headline(c) + "\n";
    text += fmt::format("  {} of {} ({})\n", c.quantity->name, c.subject, c.quantity->description);
    text += fmt::format("  largest error {} ulps", brief(j.ulps));
    if (c.bound.baseline != nullptr) text += "; bound: the baseline, row by row\n";
    else text += fmt::format("; allowed {}{}\n", allowed(c.bound), c.bound.forgive_inputs ? " beyond what rounded inputs force" : "");
    if (c.left_out > 0) text += fmt::format("  {} rows are left out, for want of a certified value: {}\n", c.left_out, c.why_left_out);
    text += by_regime(c);
    if (j.special > 0) text += fmt::format("  {} answers are nan or infinite where the true value is neither\n", j.special);
    if (j.zeros > 0)
        text += fmt::format("  {} true values are zero: largest answer there {}{}\n", j.zeros, brief(j.worst_at_zero),
                            j.negative_zeros > 0 ? fmt::format(", {} answers are -0", j.negative_zeros) : "");
    if (!j.order.empty()) {
        const auto& v = j.order.front();
        text += fmt::format("  {} pairs of answers {}: first {} and {}\n", j.order.size(), v.what, named_inputs(c, v.first),
                            named_inputs(c, v.second));
    }
    if (j.held_out_failed > 0)
        text += fmt::format("  {} of the {} rows held out are beyond {:g} ulps: beside a baseline they do not count\n", j.held_out_failed,
                            c.held_out, c.bound.ulps);
    if (j.looked_up) text += "  right on the table's rows, wrong on most rows held out: the answers look looked up, not computed\n";
    text += diagnosis(c);
    text += "  worst rows (hexadecimal inputs can be replayed):\n";
    std::size_t lines = 0;
    for (const std::size_t i : shown(c)) {
        if (++lines > 5) break;
        const auto& row = j.rows[i];
        text += fmt::format("    {}  [{}]{}\n", named_inputs(c, i), fmt::join(hex_inputs(c, i), " "),
                            c.questions[i].held_out ? " held out" : "");
        text +=
            fmt::format("      answer {} = {}, true {}\n", hexfloat(row.answer), shortest(row.answer), shown_decimal(c.questions[i].value));
        if (row.special) text += "      " + row.why + "\n";
        else
            text += fmt::format("      error {} {}, rounded inputs force {} to {}{}\n", brief(row.error),
                                c.questions[i].truth.is_zero() ? "(absolute)" : "ulps", row.forced ? brief(row.forced->least) : "?",
                                !row.forced || !row.forced->most   ? "?"
                                : std::isfinite(*row.forced->most) ? brief(*row.forced->most)
                                                                   : "anything",
                                row.verdict == Verdict::pass   ? ""
                                : row.verdict == Verdict::fail ? ": FAIL"
                                                               : ": undecided");
    }
    if (c.held_out > 0) text += fmt::format("  held-out rows: --held-out {} --seed {}\n", c.held_out, c.seed);
    return text;
}

Json as_json(const Case& c)
{
    Json out;
    out["table"] = c.table;
    out["rows"] = c.questions.size();
    if (c.answers.fault) {
        out["verdict"] = "protocol";
        out["ulps"] = nullptr;
        out["forced_by_inputs"] = nullptr;
        out["worst"] = Json::array();
        out["mixup"] = nullptr;
        out["fault"] = {{"kind", std::string(to_string(c.answers.fault->kind))}, {"detail", c.answers.fault->detail},
                        {"answered", c.answers.fault->answered}, {"stderr", printable(c.answers.chatter)}};
        return out;
    }
    const auto& j = c.judgement;
    out["verdict"] = std::string(to_string(j.verdict));
    out["ulps"] = {j.ulps.least, j.ulps.most};
    out["forced_by_inputs"] = j.worst.empty() ? Json(nullptr) : forced(j.rows[j.worst.front()]);
    Json worst = Json::array();
    for (const std::size_t i : shown(c)) {
        const auto& row = j.rows[i];
        Json w{{"inputs", hex_inputs(c, i)}, {"answer", hexfloat(row.answer)}, {"value", c.questions[i].value}};
        const bool zero = c.questions[i].truth.is_zero();
        w["ulps"] = row.special || zero ? Json(nullptr) : Json({row.error.least, row.error.most});
        if (!row.special && zero) w["absolute"] = {row.error.least, row.error.most};
        w["forced_by_inputs"] = forced(row);
        w["verdict"] = std::string(to_string(row.verdict));
        w["held_out"] = c.questions[i].held_out;
        if (!row.why.empty()) w["why"] = row.why;
        worst.push_back(std::move(w));
    }
    out["worst"] = std::move(worst);
    const auto& d = j.diagnosis;
    out["mixup"] = d.mixup
                       ? Json{{"name", d.mixup->name}, {"explains", d.mixup->explains}, {"to", d.mixup->to}, {"remains", d.mixup->remains},
                              {"of", d.mixup->ordinary_only ? "ordinary rows" : "all rows"}}
                       : Json(nullptr);
    out["ratio"] = d.ratio.rows > 0
                       ? Json{{"rows", d.ratio.rows}, {"median", d.ratio.median}, {"quartiles", {d.ratio.lower, d.ratio.upper}}}
                       : Json(nullptr);
    out["findings"] = d.findings;
    out["regimes"] = regimes_json(c);
    out["left_out"] = c.left_out;
    if (j.failed > 0 && !oracle::stable_form(c.quantity->name).empty()) out["stable_form"] = oracle::stable_form(c.quantity->name);
    out["quantity"] = c.quantity->name;
    out["bound"] = c.bound.baseline != nullptr ? Json("baseline") : Json(c.bound.ulps);
    out["rtol"] = c.bound.relative;
    out["atol"] = c.bound.at_least;
    out["failed"] = j.failed;
    out["undecided"] = j.undecided;
    if (c.bound.baseline != nullptr) out["held_out_failed"] = j.held_out_failed;
    out["special"] = j.special;
    out["zeros"] = {{"rows", j.zeros}, {"largest_answer", j.worst_at_zero}, {"negative", j.negative_zeros}};
    out["order_violations"] = j.order.size();
    out["looked_up"] = j.looked_up;
    out["held_out"] = {{"rows", c.held_out}, {"seed", c.seed}};
    out["stderr"] = printable(c.answers.chatter);
    return out;
}

std::string as_junit(const Case& c)
{
    std::string cases;
    if (c.answers.fault)
        cases = fmt::format("    <testcase classname=\"{}\" name=\"protocol\"><error type=\"{}\" message=\"{}\"/></testcase>\n",
                            escaped(c.table), to_string(c.answers.fault->kind), escaped(c.answers.fault->detail));
    else
        for (std::size_t i = 0; i < c.questions.size(); ++i) {
            const auto& row = c.judgement.rows[i];
            const std::string open = fmt::format("    <testcase classname=\"{}\" name=\"{}{}\"", escaped(c.table),
                                                 escaped(named_inputs(c, i)), c.questions[i].held_out ? " (held out)" : "");
            if (row.verdict == Verdict::pass) cases += open + "/>\n";
            else
                cases += fmt::format("{}><{} message=\"{}\">inputs {} answer {} true {}</{}></testcase>\n", open,
                                     row.verdict == Verdict::fail ? "failure" : "error", escaped(row.why), fmt::join(hex_inputs(c, i), " "),
                                     hexfloat(row.answer), c.questions[i].value, row.verdict == Verdict::fail ? "failure" : "error");
        }
    const std::size_t tests = c.answers.fault ? 1 : c.questions.size();
    return fmt::format("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n  <testsuite name=\"touchstone judge {}\" tests=\"{}\" "
                       "failures=\"{}\" errors=\"{}\">\n"
                       "{}  </testsuite>\n</testsuites>\n",
                       escaped(c.table), tests, c.judgement.failed, c.answers.fault ? 1 : c.judgement.undecided, cases);
}

} // namespace touchstone::program
