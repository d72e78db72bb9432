// SPDX-License-Identifier: GPL-3.0-or-later
/// How many digits are certified where, and by which method: what recursion::choose() answers over the plane of load and G.
#include "verify/figures/figure.hpp"

#include "touchstone/recursion/methods.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace touchstone::figures {
namespace {

using recursion::Asked, recursion::Problem;

constexpr double lowest_load = 1e-6, highest_load = 1e4; ///< of the axes
constexpr double lowest_excess = 1e-3, highest_excess = 1e3; ///< of G - 1
constexpr int loads_a_decade = 8, excesses_a_decade = 16;

Problem problem(Asked asked, long n, const Rational& load, const Rational& G)
{
    Problem p;
    p.asked = asked;
    p.n = n;
    p.load = load;
    p.G = {[G] { return Ball(G); }, G};
    p.compare_G = [G](const Rational& r) { return cmp(G, r); };
    if (asked == Asked::area) return p;
    const WorkingPrecision precision(128); // half way to the highest pressure of the scale
    const Rational middle = exact_rational(arf_get_d(arb_midref(recursion::highest_pressure(p).get()), ARF_RND_NEAR) / 2);
    p.p = {[middle] { return Ball(middle); }, middle};
    return p;
}

/// Who answers at a point, and with how many digits.
struct Answer {
    std::string method; ///< "estimate", or empty: nobody does
    long digits = 0;
};

Answer answer(const Problem& p)
{
    const recursion::Choice c = recursion::choose(p, {any_digits});
    if (c.method != nullptr) return {c.method->name, c.digits};
    if (recursion::observers_refusal(p).empty()) return {"estimate", recursion::observed_digits};
    return {};
}

/// The same method has the same colour in every panel.
int colour_of(const std::string& method)
{
    static const std::map<std::string, int> colours{{"force-weighted-chebyshev", 1},
                                                    {"heavy-load-force-weighted", 5},
                                                    {"proven-levels", 3},
                                                    {"forward-density", 6},
                                                    {"estimate", grey}};
    const auto found = colours.find(method);
    return found == colours.end() ? 4 : found->second;
}

const char* const regime_names[] = {"force-weighted-chebyshev", "forward-density", "heavy-load-force-weighted", "proven-levels",
                                    "estimate"};

/// Where the numbers stand in the map: load, G - 1.
struct Place {
    double load, excess;
};

Panel map_of(Asked asked, long n, const std::string& title, const std::string& name)
{
    Panel p{title,
            name,
            {"load {/:Italic p̄} / {/:Italic p*}_0", lowest_load, highest_load, true, 100},
            {"{/:Italic G} − 1", lowest_excess, highest_excess, true, 10},
            {},
            {},
            {},
            ""};
    const double width = std::pow(10, 0.5 / loads_a_decade), height = std::pow(10, 0.5 / excesses_a_decade);
    for (double excess = lowest_excess * height; excess < highest_excess; excess *= height * height) {
        std::vector<Curve> row; // one for each method
        for (double load = lowest_load * width; load < highest_load; load *= width * width) {
            const Answer a = answer(problem(asked, n, exact_rational(load), exact_rational(1 + excess)));
            if (a.method.empty()) continue;
            const auto same = [&a](const Curve& c) { return c.name.starts_with(a.method + ","); };
            auto found = std::find_if(row.begin(), row.end(), same);
            if (found == row.end())
                found = row.insert(row.end(), Curve{fmt::format("{}, G = {:.6g}", a.method, 1 + excess),
                                                    "",
                                                    Style::cells,
                                                    colour_of(a.method),
                                                    {},
                                                    {excess, width, height}});
            found->points.push_back({load, fmt::format("{}", a.digits), "", a.method == "estimate" ? "estimated" : "claimed"});
        }
        std::move(row.begin(), row.end(), std::back_inserter(p.curves));
    }
    for (const Place& at : {Place{1e-4, 300},
                            {1e-4, 10},
                            {1e-4, 2.4},
                            {1e-4, 0.1},
                            {20, 300},
                            {20, 10},
                            {20, 2.4},
                            {20, 0.1},
                            {3e3, 10},
                            {3e3, 0.1},
                            {0.1, 1.7e-3}}) {
        const Answer a = answer(problem(asked, n, exact_rational(at.load), exact_rational(1 + at.excess)));
        if (!a.method.empty())
            p.notes.push_back({at.load, at.excess, fmt::format("{}{}", a.method == "estimate" ? "≈ " : "", a.digits), true});
    }
    return p;
}

} // namespace

Figure certified_digits()
{
    Figure f{"certified-digits", "Digits certified over load and G, by method",
             "Which proof serves which inputs, and to how many digits (numbers), as the table of methods answers at each point of the "
             "plane of load and G = γ^(D−1). (a), (b) areas A_n; (c) exceedances and (d) densities at "
             "half the highest pressure. Grey: only estimated, never more than 15 digits; blank: refused with a reason. Beyond the "
             "picture the reach of the first two methods goes on to loads of 1e-300; closed forms (n = 0) and one integral (n = 1) "
             "serve the whole plane to as many digits as asked. Too narrow to be seen: distributions where the highest pressure of a "
             "scale is within 0.2 % below p*, which proven-levels serves, and areas at 2 < G < 2.000001. "
             "`ctest -R methods` walks the domain and holds the program to what is drawn.",
             "Four maps of load against G - 1: three proofs divide the plane for areas, two for distributions; most digits where G > 2 "
             "and load <= 1, twenty where full contact occurs.", {}, 2, 330};
    f.panels = {map_of(Asked::area, 5, "(a) area, {/:Italic n} = 5", "(a) area, n = 5"),
                map_of(Asked::area, 30, "(b) area, {/:Italic n} = 30", "(b) area, n = 30"),
                map_of(Asked::exceedance, 5, "(c) exceedance, {/:Italic n} = 5", "(c) exceedance, n = 5"),
                map_of(Asked::density, 5, "(d) density, {/:Italic n} = 5", "(d) density, n = 5")};
    Panel& first = f.panels.front();
    first.key = above_all;
    for (const char* name : regime_names) first.curves.push_back({name, name, Style::cells, colour_of(name), {}});
    return f;
}

} // namespace touchstone::figures
