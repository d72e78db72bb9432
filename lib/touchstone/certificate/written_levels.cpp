// SPDX-License-Identifier: MIT
#include "touchstone/certificate/written_levels.hpp"

#include <fmt/format.h>

namespace touchstone::certificate {

Counts WrittenSection::counts() const
{
    return {{"grids", 1}, {"panels", panels.size()}, {"levels", panels.size() * levels.size()}};
}

WrittenSection write_levels(const Grid& g, const std::vector<Level>& levels, Lines& lines)
{
    WrittenSection w;
    w.grid = lines.add("grid", {}, fmt::format("G={} bits={:x} step={} points={:x}", named(g.root), g.bits, dyadic(g.step), g.points));
    for (std::size_t p = 0; p + 1 < g.edges.size(); ++p)
        w.panels.push_back(lines.add(
            "panel", {w.grid},
            fmt::format("low={} high={} terms={:x} rho={}", dyadic(g.edges[p]), dyadic(g.edges[p + 1]), g.terms, dyadic(ellipse()))));
    for (std::size_t m = 0; m < levels.size(); ++m) {
        w.levels.emplace_back();
        for (std::size_t p = 0; p < w.panels.size(); ++p) {
            std::vector<std::size_t> rests_on{w.grid, w.panels[p]};
            if (m > 0) rests_on.insert(rests_on.end(), w.levels[m - 1].begin(), w.levels[m - 1].end());
            const Polynomial& v = levels[m].panels[p];
            std::string data = fmt::format("m={:x} error={} exponent={}", m, dyadic(rounded_up(v.error)), -g.kept_bits);
            for (const auto& c : v.coefficients) data += ' ' + hex(c);
            w.levels.back().push_back(lines.add("level", rests_on, data));
        }
    }
    return w;
}

} // namespace touchstone::certificate
