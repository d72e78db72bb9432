// SPDX-License-Identifier: GPL-3.0-or-later
/// A code that trusts the print: section 2's formulas as they stand in the paper, in plain double.
/// They are right, and lose up to all their digits where they subtract what is nearly equal.
#include "touchstone/paper/as_printed.hpp"
#include "verify/subjects/rows.hpp"

#include <functional>
#include <map>

using touchstone::subjects::Row;
namespace printed = touchstone::as_printed;

int main(int argc, char** argv)
{
    const std::map<std::string, std::function<double(const Row&)>> quantities{
        {"westergaard.half_width", [](const Row& r) { return printed::half_width(r[0]); }},
        {"westergaard.pressure", [](const Row& r) {
             const double x = r[0], load = r[1];
             return load < 1 ? printed::pressure_partial(x, load) : printed::pressure_full(x, load);
         }},
        {"westergaard.exceedance", [](const Row& r) {
             const double p = r[0], load = r[1];
             if (load < 1) return p < 2 * std::sqrt(load) ? printed::exceedance_partial(p, load) : 0;
             return p < load - 1 ? 1 : p > load + 1 ? 0 : printed::exceedance_full(p, load);
         }},
        {"westergaard.density", [](const Row& r) {
             const double p = r[0], load = r[1];
             if (load < 1) return p < 2 * std::sqrt(load) ? printed::density_partial(p, load) : 0;
             return p < load - 1 || p > load + 1 ? 0 : printed::density_full(p, load);
         }},
        {"hertz.half_width", [](const Row& r) { return std::sqrt(r[0]) / std::numbers::pi; }},
        {"hertz.pressure", [](const Row& r) { return printed::hertz_pressure(r[0], r[1]); }},
        // not in the paper, but what one writes down after a textbook: differences that vanish at the edge
        {"westergaard.gap", [](const Row& r) {
             const double v = std::sin(std::numbers::pi * std::fabs(r[0])), load = r[1];
             if (load >= 1 || v * v <= load) return 0.0;
             return 2 * (v * std::sqrt(v * v - load) - load * std::acosh(v / std::sqrt(load)));
         }},
        {"westergaard.mean_gap", [](const Row& r) { return r[0] < 1 ? 1 - r[0] + r[0] * std::log(r[0]) : 0; }},
        {"westergaard.energy", [](const Row& r) { return r[0] < 1 ? r[0] * r[0] * (1 - 2 * std::log(r[0])) / 4 : 0.25; }},
    };
    const auto chosen = quantities.find(argc == 2 ? argv[1] : "");
    if (chosen == quantities.end()) {
        std::cerr << "usage: printed_formulas QUANTITY, one of section 2\n";
        return 64;
    }
    return touchstone::subjects::answer_rows(chosen->second);
}
