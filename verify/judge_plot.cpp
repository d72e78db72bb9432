// SPDX-License-Identifier: GPL-3.0-or-later
/// `judge --svg`: each row's error over what it is allowed, against each input and against what makes the quantity hard.
#include "touchstone/paper/westergaard.hpp"
#include "touchstone/rounding/decimal.hpp"
#include "verify/figures/gnuplot.hpp"
#include "verify/judge_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

namespace touchstone::program {
namespace {

using figures::Curve;
using figures::Panel;
using figures::Point;
using figures::Style;
using oracle::Verdict;

/// What a point's height can be: exact answers stand on the lower border, nan and infinite ones on the upper.
constexpr double lowest = 1e-4, highest = 1e6;
/// Where a logarithmic axis of inputs ends: what is beyond stands on the border.
constexpr double smallest = 1e-18, largest = 1e6;

/// Ulps the row may be off.
double allowed(const Case& c, std::size_t i)
{
    const auto& row = c.judgement.rows[i];
    if (c.bound.baseline != nullptr) {
        const auto found = c.bound.baseline->bounds.find(oracle::row_key(c.questions[i].inputs));
        if (found != c.bound.baseline->bounds.end()) return std::max(found->second, 1e-300);
    }
    const double forced = c.bound.forgive_inputs && row.forced ? row.forced->least : 0;
    const auto& truth = c.questions[i].truth;
    double tolerance = 0; // --rtol, --atol in ulps
    if ((c.bound.relative > 0 || c.bound.at_least > 0) && !truth.is_zero())
        tolerance = (c.bound.at_least + c.bound.relative * std::fabs(truth.value.get_d())) / oracle::ulp_at(truth.value).get_d();
    return std::max({c.bound.ulps + forced, tolerance, 1e-300});
}

double height(double share) { return std::clamp(share, lowest, highest); }

/// A coordinate of a row; nothing where it has none.
using Coordinate = std::function<std::optional<double>(const std::vector<double>&)>;

Curve points(const char* name, const std::string& legend, int colour) { return {name, legend, Style::points, colour, {}}; }

void place(Curve& curve, double x, double y) { curve.points.push_back({x, fmt::format("{:.6g}", y), "", "measured"}); }

/// Five kinds of rows and what rounded inputs force, each with a marker of its own.
std::vector<Curve> sorted_rows(const Case& c, const Coordinate& at, const figures::Axis& along)
{
    std::vector<Curve> kinds{points("forced", "forced by rounded inputs", 0),
                             points("passes", "passes", 1),
                             points("fails", "fails", 2),
                             points("undecided", "undecided", 5),
                             points("nan or infinite", "nan or infinite", 4),
                             points("exact", "exact", 3)};
    for (std::size_t i = 0; i < c.questions.size(); ++i) {
        const auto& row = c.judgement.rows[i];
        const auto given = at(c.questions[i].inputs);
        if (!given) continue;
        const std::optional<double> x = std::clamp(*given, along.low, along.high);
        if (row.special) place(kinds[4], *x, highest);
        else if (c.questions[i].truth.is_zero() || row.error.most == 0)
            place(kinds[row.verdict == Verdict::fail ? 2 : 5], *x, row.verdict == Verdict::fail ? highest : lowest);
        else
            place(kinds[row.verdict == Verdict::pass   ? 1
                        : row.verdict == Verdict::fail ? 2
                                                       : 3],
                  *x, height(row.error.most / allowed(c, i)));
        if (c.bound.forgive_inputs && row.forced && row.forced->least > 0 && !row.special)
            place(kinds[0], *x, height(row.forced->least / allowed(c, i)));
    }
    return kinds;
}

/// The range of a coordinate, logarithmic where it spans decades; nothing where all rows share one value.
std::optional<figures::Axis> axis(const Case& c, const Coordinate& at, const std::string& label)
{
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (const auto& q : c.questions)
        if (const auto x = at(q.inputs)) {
            low = std::min(low, *x);
            high = std::max(high, *x);
        }
    if (!(low < high)) return std::nullopt;
    if (low > 0 && high / low > 1000) {
        const double from = std::floor(std::log10(std::max(low, smallest))),
                     to = std::max(from + 1, std::ceil(std::log10(std::min(high, largest))));
        return figures::Axis{label, std::pow(10, from), std::pow(10, to), true, std::pow(10, std::max(1.0, std::ceil((to - from) / 8)))};
    }
    const double margin = 0.03 * (high - low);
    return figures::Axis{label, low - margin, high + margin};
}

void add_panel(figures::Figure& f, const Case& c, const std::string& name, const std::string& label, const Coordinate& at)
{
    const auto x = axis(c, at, label);
    if (!x) return;
    const figures::Axis y{"error / allowed", lowest, highest, true, 100};
    Panel p{"", name, *x, y, sorted_rows(c, at, *x), {}, {}, f.panels.empty() ? figures::above_all : ""};
    p.curves.push_back({"allowed", "allowed", Style::line, 0, {{x->low, "1", "0", "exact"}, {x->high, "1", "0", "exact"}}});
    if (f.panels.empty()) // how many, in the legend; the panels that follow show the same rows
        for (std::size_t k = 1; k < 6; ++k) p.curves[k].legend += fmt::format(" ({})", p.curves[k].points.size());
    std::erase_if(p.curves, [](const Curve& curve) { return curve.points.empty(); });
    f.panels.push_back(std::move(p));
}

} // namespace

std::string as_svg(const Case& c)
{
    figures::Figure f{"judge", fmt::format("{}: error over what is allowed", c.table),
                      "",      fmt::format("Error of {} on each row of {}, over what is allowed.", c.subject, c.table),
                      {},      1,
                      260};
    const auto& inputs = c.quantity->inputs;
    const auto index = [&inputs](const char* name) -> std::optional<std::size_t> {
        const auto found = std::find(inputs.begin(), inputs.end(), name);
        return found == inputs.end() ? std::nullopt : std::optional(static_cast<std::size_t>(found - inputs.begin()));
    };
    for (std::size_t k = 0; k < inputs.size(); ++k)
        add_panel(f, c, inputs[k], inputs[k], [k](const std::vector<double>& row) { return std::optional(row[k]); });
    const auto load = index("load"), x = index("x");
    if (load)
        add_panel(f, c, "1 - load", "1 − load (rows with load < 1)",
                  [&](const std::vector<double>& row) { return row[*load] < 1 ? std::optional(1 - row[*load]) : std::nullopt; });
    if (load && x)
        add_panel(f, c, "distance", "distance from the edge of the contact |{/:Italic x} − {/:Italic a}| / {/:Italic a}",
                  [&](const std::vector<double>& row) -> std::optional<double> {
                      const double s = row[*load], a = s < 1 ? westergaard::half_width(s) : 0.5, d = std::fabs(std::fabs(row[*x]) / a - 1);
                      return a > 0 && d > 0 ? std::optional(d) : std::nullopt;
                  });
    if (f.panels.empty()) { // no inputs, or all rows the same: against the number of the row
        std::size_t number = 0;
        add_panel(f, c, "row", "row", [&number](const std::vector<double>&) { return std::optional(static_cast<double>(number++)); });
        if (f.panels.empty()) {
            Panel p{"",
                    "row",
                    {"row", 0, 2},
                    {"error / allowed", lowest, highest, true, 100},
                    sorted_rows(c, [](const std::vector<double>&) { return std::optional(1.0); }, {"row", 0, 2}),
                    {},
                    {},
                    figures::above_all};
            f.panels.push_back(std::move(p));
        }
    }
    return figures::svg(f, figures::Layout::wide);
}

} // namespace touchstone::program
