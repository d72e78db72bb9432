// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/figures/figure.hpp"

#include "touchstone/rounding/decimal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace touchstone::figures {

Point certified(double x, const Ball& y, long digits)
{
    if (const auto exact = exact_value(y); exact && *exact == 0) return {x, "0", "0", "exact"};
    for (long d = digits; d > 0; --d)
        if (const auto decimal = round_to_digits(y, d)) return {x, decimal->text(), decimal->half_unit(), "certified"};
    // a ball around zero has no leading digit: its size is the bound
    return {x, "0", fmt::format("{:.2g}", std::max(1e-300, 2 * (abs(y) + Ball(0)).radius_bound())), "undecided"};
}

const std::vector<Recipe>& recipes()
{
    static const std::vector<Recipe> all{
        {"figure1", "Figure 1: the iteration of the peak pressures", true, figure_1},
        {"figure2", "Figure 2: full contact breaks up", true, figure_2},
        {"figure3", "Figure 3: contact area against scale", true, figure_3},
        {"figure4", "Figure 4: number of contact segments against resolution", true, figure_4},
        {"figure5", "Figure 5: distributions of pressure and of segment length", true, figure_5},
        {"hertz-error", "How wrong the Hertzian approximation is", false, hertz_error},
        {"apparent-dimension", "Apparent fractal dimension against scale and load", false, apparent_dimension},
        {"print-errors", "Where printed equations fail", false, print_errors},
        {"hertzian-share", "Share of Hertzian contacts", false, hertzian_share},
        {"area-laws", "How wrong the area laws are at large n", false, area_laws},
        {"edge-error", "Error of two codes beside the edge of the contact", false, edge_error},
        {"certified-digits", "Digits certified over load and G, by method", false, certified_digits},
    };
    return all;
}

const Recipe* find_recipe(const std::string& id)
{
    const auto found = std::find_if(recipes().begin(), recipes().end(), [&](const Recipe& r) { return r.id == id; });
    return found == recipes().end() ? nullptr : &*found;
}

namespace {
std::string quoted(const std::string& text) // the names hold commas, never quotes
{
    return text.find(',') == std::string::npos ? text : '"' + text + '"';
}
} // namespace

std::string csv(const Figure& f)
{
    std::string text = "panel,curve,x,value,error,status\n";
    for (const Panel& p : f.panels)
        for (const Curve& c : p.curves)
            for (const Point& q : c.points)
                text += fmt::format("{},{},{},{},{},{}\n", quoted(p.name), quoted(c.name), shortest(q.x), q.value, q.error, q.status);
    return text;
}

std::string status_line(const Figure& f)
{
    std::map<std::string, std::size_t> count;
    for (const Panel& p : f.panels)
        for (const Curve& c : p.curves)
            for (const Point& q : c.points) ++count[q.status];
    std::string text;
    for (const char* status : {"exact", "certified", "estimated", "measured", "claimed", "undecided"})
        if (count.contains(status)) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count[status], status);
    return text;
}

} // namespace touchstone::figures
