// SPDX-License-Identifier: GPL-3.0-or-later
/// The library's own formulas, instantiated for double: what the toolkit offers to codes that want speed.
#include "touchstone/paper/gap.hpp"
#include "touchstone/paper/segments.hpp"
#include "touchstone/paper/weierstrass.hpp"
#include "verify/subjects/rows.hpp"

#include <functional>
#include <map>

using namespace touchstone;
using touchstone::subjects::Row;

int main(int argc, char** argv)
{
    const auto n = [](const Row& r) { return static_cast<long>(r[0]); };
    const std::map<std::string, std::function<double(const Row&)>> quantities{
        {"westergaard.half_width", [](const Row& r) { return westergaard::half_width(r[0]); }},
        {"westergaard.pressure", [](const Row& r) { return westergaard::pressure(r[0], r[1]); }},
        {"westergaard.exceedance", [](const Row& r) { return westergaard::exceedance(r[0], r[1]); }},
        {"westergaard.density", [](const Row& r) { return westergaard::density(r[0], r[1]); }},
        {"westergaard.gap", [](const Row& r) { return westergaard::gap(r[0], r[1]); }},
        {"westergaard.mean_gap", [](const Row& r) { return westergaard::mean_gap(r[0]); }},
        {"westergaard.energy", [](const Row& r) { return westergaard::energy(r[0]); }},
        {"hertz.half_width", [](const Row& r) { return hertz::half_width(r[0]); }},
        {"hertz.pressure", [](const Row& r) { return hertz::pressure(r[0], r[1]); }},
        {"hertz.gap", [](const Row& r) { return hertz::gap(r[0], r[1]); }},
        {"weierstrass.bound", [](const Row& r) { return weierstrass::bound(r[0], r[1]); }},
        {"peaks.f", [](const Row& r) { return peaks::f(r[0]); }},
        {"peaks.iterate", [n](const Row& r) { return peaks::iterate(n(r), r[1], r[2]); }},
        {"peaks.fixed_point", [](const Row& r) { return peaks::fixed_point(r[0]); }},
        {"archard.K", [n](const Row& r) { return archard::K(n(r)); }},
        {"archard.K_inf", [](const Row&) { return archard::K(-1); }},
        {"archard.delta", [n](const Row& r) { return archard::delta<double>(n(r)); }},
        {"archard.alpha", [n](const Row& r) { return archard::alpha(n(r), r[1]); }},
        {"archard.area", [n](const Row& r) { return archard::area(n(r), r[1], r[2], archard::K(n(r))); }},
        {"archard.segments", [n](const Row& r) { return archard::segments(n(r), r[1], r[2], r[3], archard::K(n(r) - 1)); }},
        {"archard.segments_limit", [n](const Row& r) { return archard::segments_limit(n(r), r[1], r[2], r[3], archard::K(-1)); }},
        {"segments.max_half_width", [n](const Row& r) { return segments::max_half_width(n(r), r[1], r[2]); }},
    };
    const auto chosen = quantities.find(argc == 2 ? argv[1] : "");
    if (chosen == quantities.end()) {
        std::cerr << "usage: library_forms QUANTITY (touchstone list), one in closed form\n";
        return 64;
    }
    return touchstone::subjects::answer_rows(chosen->second);
}
