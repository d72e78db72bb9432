// SPDX-License-Identifier: MIT
#include "touchstone/transfer/singular_points.hpp"

#include "touchstone/wave/wave.hpp"

#include <algorithm>

namespace touchstone::transfer {
namespace {

bool below(const Ball& a, const Ball& b) { return arf_cmp(arb_midref(a.get()), arb_midref(b.get())) < 0; }

/// `seeds` and their images, generation by generation.
template <class Images>
std::vector<SingularPoint> orbit(std::vector<Ball> seeds, const Images& images, const Tracking& t)
{
    const auto same = [&](const Ball& a, const Ball& b) { // a <= b by their midpoints
        return a.overlaps(b) || certainly(less(b - a, Ball::exactly(t.merge) * b));
    };
    std::vector<SingularPoint> all;
    std::vector<Ball> next = std::move(seeds);
    for (int g = 0; g < t.generations; ++g) {
        std::erase_if(next, [&](const Ball& s) { return !certainly(less(Ball(0), s)); });
        std::sort(next.begin(), next.end(), below);
        next.erase(std::unique(next.begin(), next.end(), same), next.end());
        std::erase_if(next, [&](const Ball& s) { // what an earlier generation has, it has more strongly, with all its images
            return std::any_of(all.begin(), all.end(),
                               [&](const SingularPoint& p) { return below(s, p.position) ? same(s, p.position) : same(p.position, s); });
        });
        std::vector<Ball> last = std::move(next);
        next.clear();
        for (const Ball& s : last) {
            all.push_back({s, g});
            if (certainly(less(t.reach, s))) continue; // beyond: a neighbour of what is inside, no more
            for (const Ball& image : images(s)) next.push_back(image);
        }
    }
    std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return below(a.position, b.position); });
    return all;
}

} // namespace

std::vector<SingularPoint> area_points(const Ball& G, const Tracking& t, std::vector<Ball> of_B0)
{
    const auto images = [&](const Ball& s) {
        const Ball down = wave::meets_upper_end_full(s, G); // a ball that cannot tell which side of 1 it is on: both forms give 1
        return std::vector<Ball>{wave::meets_lower_end(s, G), certainly(less(down, Ball(1))) ? wave::meets_upper_end_partial(s, G) : down};
    };
    of_B0.emplace_back(1);
    return orbit(std::move(of_B0), images, t);
}

std::vector<SingularPoint> exceedance_points(const Ball& load, const Ball& G, const Tracking& t)
{
    const auto images = [&](const Ball& s) { // s = 1: both forms give 2/G
        if (certainly(less(s, Ball(1)))) return std::vector<Ball>{wave::highest_partial(s, G)};
        return std::vector<Ball>{wave::highest_full(s, G), wave::lowest_full(s, G)};
    };
    std::vector<Ball> seeds = images(load);
    seeds.push_back(2 / G);
    std::vector<SingularPoint> all = orbit(std::move(seeds), images, t);
    const auto at = std::find_if(all.begin(), all.end(), [](const SingularPoint& p) { return !below(p.position, Ball(1)); });
    if (at == all.end() || !at->position.overlaps(Ball(1))) all.insert(at, {Ball(1), t.generations - 1});
    return all;
}

} // namespace touchstone::transfer
