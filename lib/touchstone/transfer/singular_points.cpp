// SPDX-License-Identifier: MIT
#include "touchstone/transfer/singular_points.hpp"

#include <algorithm>

namespace touchstone::transfer {

std::vector<SingularPoint> singular_points(const Ball& G, const Ball& reach, int generations, double merge)
{
    const auto mid_less = [](const Ball& a, const Ball& b) { return arf_cmp(arb_midref(a.get()), arb_midref(b.get())) < 0; };
    const auto same = [merge](const Ball& a, const Ball& b) { // a <= b by their midpoints
        return a.overlaps(b) || certainly(less(b - a, Ball::exactly(merge) * b));
    };
    std::vector<SingularPoint> all{{Ball(1), 0}};
    std::vector<Ball> last{Ball(1)};
    for (int g = 1; g <= generations; ++g) {
        std::vector<Ball> next;
        for (const Ball& s : last) {
            const Ball below = G * s - 1;
            next.push_back(G * s + 1);
            // a ball that cannot tell which side of 1 it is on: both forms give the same point, 1
            next.push_back(certainly(less(below, Ball(1))) ? Ball(G * G * s * s / 4) : below);
        }
        std::erase_if(next, [&](const Ball& s) { return certainly(less(reach, s)); });
        std::sort(next.begin(), next.end(), mid_less);
        next.erase(std::unique(next.begin(), next.end(), same), next.end());
        std::erase_if(next, [&](const Ball& s) { // what an earlier generation has, it has more strongly, with all its images
            return std::any_of(all.begin(), all.end(), [&](const SingularPoint& p) {
                return mid_less(s, p.position) ? same(s, p.position) : same(p.position, s);
            });
        });
        for (const Ball& s : next) all.push_back({s, g});
        last = std::move(next);
    }
    std::sort(all.begin(), all.end(), [&](const auto& a, const auto& b) { return mid_less(a.position, b.position); });
    return all;
}

} // namespace touchstone::transfer
