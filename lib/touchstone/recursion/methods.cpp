// SPDX-License-Identifier: MIT
#include "touchstone/recursion/methods.hpp"

#include "touchstone/paper/peaks.hpp"
#include "touchstone/recursion/light_load.hpp"
#include "touchstone/recursion/regimes/regimes.hpp"
#include "touchstone/scalar/refusal.hpp"
#include "touchstone/transfer/full_contact.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace touchstone::recursion {

transfer::Arguments arguments(const Problem& p)
{
    return {[&p] { return Ball(p.load); }, p.G.ball};
}

double about_G(const Problem& p)
{
    const WorkingPrecision precision(64);
    return arf_get_d(arb_midref(p.G.ball().get()), ARF_RND_NEAR);
}

bool G_above(const Problem& p, const Rational& least) { return p.compare_G(least) > 0; }
bool G_below_10_9(const Problem& p) { return p.compare_G(1'000'000'000) < 0; }
bool p_is_0(const Problem& p) { return p.asked == Asked::density && p.p.exact && p.p.exact->is_zero(); }
bool too_near_1(const Rational& load) { return load < 1 && 1 - load < power(Rational(10), -300); }
double growth(Accuracy a, double power) { return std::pow(static_cast<double>(std::max(a.digits, 10L)) / 20, power); }

bool above_support(const Problem& p)
{
    const WorkingPrecision precision(256);
    return certainly(less(highest_pressure(p), p.p.ball()));
}

namespace {

using transfer::Grid;

Witness observe(Grid grid, const Problem& p, Accuracy a)
{
    const WorkingPrecision precision(256);
    const Ball load(p.load), G = p.G.ball();
    switch (p.asked) {
    case Asked::area: return transfer::estimated_area(grid, p.n, load, G, a);
    case Asked::exceedance: return transfer::estimated_exceedance(grid, p.n, p.p.ball(), load, G, a);
    default: return transfer::estimated_density(grid, p.n, p.p.ball(), load, G, a);
    }
}

/// Scales up to which the two grids resolve what they compute, in seconds.
long observed_scales(Asked asked) { return asked == Asked::density ? 20 : 100; }

} // namespace

std::string to_text(const Budget& budget)
{
    std::string text = budget.text;
    if (!text.empty() && text.back() != '\n') text += '\n';
    for (const Budget& part : budget.parts) {
        std::string lines = to_text(part);
        for (std::size_t at = 0; at < lines.size(); at = lines.find('\n', at) + 1) lines.insert(at, "  ");
        text += lines;
    }
    return text;
}

Ball unit_pressure(const Problem& p)
{
    Ball unit;
    arb_pow_ui(unit.get(), p.G.ball().get(), static_cast<ulong>(p.n), WorkingPrecision::bits());
    return unit;
}

Ball highest_pressure(const Problem& p)
{
    const Ball G = p.G.ball();
    return unit_pressure(p) * G * peaks::iterate(p.n, Ball(p.load), G);
}

long Method::most_digits(const Problem& p) const { return fewer_digits ? std::min(digits, fewer_digits(p)) : digits; }

const std::vector<Method>& methods()
{
    static const std::vector<Method> all{single_wave_area(),  single_wave_exceedance(), single_wave_density(), one_integral(),
                                         second_area(),       power_series(),           partial_area(),        partial_distribution(),
                                         heavy_load(),        proven_shares(),          third_wave_density(),  proven_densities(),
                                         area_in_any_limit(), exceedance_in_any_limit()};
    return all;
}

const std::vector<Observer>& observers()
{
    static const std::vector<Observer> all{
        {"blind-halving", [](const Problem& p, Accuracy a) { return observe(Grid::blind, p, a); }},
        {"tracked-singular-points", [](const Problem& p, Accuracy a) { return observe(Grid::tracked, p, a); }}};
    return all;
}

std::string observers_reach(Asked asked)
{
    return fmt::format("n <= {}, load from 1e-300 to 10^6, 1.000001 < G < 10^9", observed_scales(asked));
}

std::string observers_refusal(const Problem& p)
{
    if (p.n > observed_scales(p.asked))
        return p.asked == Asked::area
                   ? fmt::format("not computed for n > {} where full contact occurs (G <= 2 or load > 1)", observed_scales(p.asked))
                   : fmt::format("{} of pressure are computed for the scales n <= {} only",
                                 p.asked == Asked::density ? "densities" : "exceedances", observed_scales(p.asked));
    if (!G_above(p, Rational(1'000'001, 1'000'000))) return "not computed for G within 1e-6 of 1";
    if (!G_below_10_9(p)) return "not computed for G of 10^9 and more";
    if (p.load > 1'000'000 || p.load < power(Rational(10), -300))
        return "not computed for loads outside 1e-300 to 1e6 where full contact occurs (G <= 2 or load > 1)";
    return p_is_0(p) ? no_density_at_0 : "";
}

Choice choose(const Problem& p, Accuracy a)
{
    Choice best;
    double least = 0;
    for (const Method& m : methods()) {
        if (std::find(m.asked.begin(), m.asked.end(), p.asked) == m.asked.end()) continue;
        std::string refused = m.refusal(p);
        const long digits = refused.empty() ? std::min(m.most_digits(p), a.digits) : 0;
        if (refused.empty() && digits < 1)
            refused = fmt::format("'{}' proves no digit of this: the inputs are too near an end of its reach", m.name);
        if (!refused.empty()) { // the last method of this scale is the one that reaches farthest: its reason counts
            if (!best.method && (best.refusal.empty() || !refused.starts_with("n must be"))) best.refusal = refused;
            continue;
        }
        const double cost = m.cost(p, {digits});
        if (best.method && (digits < best.digits || (digits == best.digits && cost >= least))) continue;
        best = {&m, digits, {}};
        least = cost;
    }
    if (best.method) {
        best.digits = best.method->most_digits(p);
        if (best.digits < a.digits) best.refusal = fmt::format("'{}' proves at most {} digits here", best.method->name, best.digits);
    }
    return best;
}

std::string reach_in_words(Asked asked)
{
    std::string text = "certified for ";
    bool first = true;
    for (const Method& m : methods()) {
        if (std::find(m.asked.begin(), m.asked.end(), asked) == m.asked.end()) continue;
        text += fmt::format("{}{}{}", first ? "" : "; ", m.reach, m.digits == any_digits ? "" : fmt::format(" (to {} digits)", m.digits));
        first = false;
    }
    return text + fmt::format("; else estimated (to {} digits) for {}", observed_digits, observers_reach(asked));
}

std::vector<Reach> reach(Asked asked)
{
    std::vector<Reach> rows;
    for (const Method& m : methods()) {
        if (std::find(m.asked.begin(), m.asked.end(), asked) == m.asked.end()) continue;
        rows.push_back({m.reach, m.digits == any_digits ? "any" : fmt::format("{}", m.digits), m.name,
                        m.second.empty() ? "witness " + (m.witness ? *m.witness : observers().front()).name : "proof " + m.second,
                        m.shares});
    }
    rows.push_back({observers_reach(asked), fmt::format("{}", observed_digits), "",
                    fmt::format("estimates {} and {}", observers()[0].name, observers()[1].name),
                    "the wave (2.2), (2.4) and nothing else: neither grid nor splitting rule nor quadrature"});
    return rows;
}

std::string reach_as_table()
{
    std::string text = "| value | where | digits | proof | second look | what the two share |\n|---|---|---|---|---|---|\n";
    constexpr const char* names[] = {"area", "exceedance", "density"};
    for (const Asked asked : {Asked::area, Asked::exceedance, Asked::density})
        for (const Reach& r : reach(asked))
            text += fmt::format("| {} | {} | {} | {} | {} | {} |\n", names[static_cast<int>(asked)], r.where, r.digits,
                                r.proof.empty() ? "none" : "`" + r.proof + "`", r.second_look, r.shares);
    return text;
}

} // namespace touchstone::recursion
