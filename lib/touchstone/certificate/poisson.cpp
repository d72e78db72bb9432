// SPDX-License-Identifier: MIT
#include "touchstone/certificate/poisson.hpp"

#include "touchstone/certificate/full_contact.hpp"
#include "touchstone/certificate/law_pieces.hpp"
#include "touchstone/scalar/refusal.hpp"
#include "touchstone/transfer/wide_balls.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace touchstone::certificate {
namespace {

constexpr long spare_bits = 6;     ///< the checker adds up what some hundred narrow intervals leave
constexpr double least_mean = 1e-6;
constexpr double least_spare = 6;  ///< polynomials leave that much less than what is claimed
constexpr double spare_next_to_logarithms = 16; ///< as panels next to these leave more

/// The same, where G is near 1: what is left next to each singular point adds up, and ratios reach as far as (G - 1)^-1.
double spare_tolerance(double G) { return std::max(least_spare, 1 / (G - 1)); }

Rational rounded_above(double x)
{
    constexpr long unit = 1024;
    return {static_cast<long>(std::ceil(x * unit)) + 1, unit};
}

/// The largest residual with which E[f/x] = c is known to `goal` of itself.
double residual_for(double goal, double c, double G) { return goal * c / (G * G * G); }

/// C(G), about: it grows like the root of G - 1 from 0.2 at G = 1.02 on.
double about_C(double G) { return 0.2 * std::sqrt(std::min(25.0, (G - 1) * 50)); }

} // namespace

WrittenMean write_mean(const limit::Question& q, const Rational& p, const Root& root, double goal, Lines& lines)
{
    const WorkingPrecision precision(256);
    const Ball G = number(root);
    const double g = nearest(G);
    const bool density = q.of == limit::Question::Of::density;
    const limit::PoissonSearch::Real times =
        density ? transfer::to_real(G) : limit::PoissonSearch::Real(1); // the mean of G D_1 is what is written
    double residual = residual_for(goal, about_C(g), g);
    const double spare = spare_tolerance(g) * (density ? spare_next_to_logarithms : 1);
    const auto search = [&] { return limit::search_poisson(q, G, residual / (spare * double(times))); };
    limit::PoissonSearch found = search();
    const auto value = [&] { return (times * found.c).high; };
    if (value() < about_C(g) / 2) { // the mean is a smaller one
        if (!(value() > least_mean)) throw BeyondReach(fmt::format("means below {:g} have no certificate", least_mean));
        residual = residual_for(goal, value(), g);
        found = search();
    }
    const long accuracy = static_cast<long>(std::ceil(-std::log2(residual))) + spare_bits, kept = accuracy + 26;
    const long bits =
        density ? 4 * (accuracy + 8)
                : 2 * accuracy + 96; // a root at the end of a wave takes half of them, and so does what is left out next to a logarithm
    Rational load = rounded_above(1 / (g - 1)); // no ratio of the limit is above
    load.canonicalize();

    std::string mesh = fmt::format("G={} p={} scale=0 load={} bits={:x} kept={:x} accuracy={:x} rise=0", named(root), p.get_str(),
                                   load.get_str(), bits, kept, accuracy);
    for (const auto& panel : found.panels) mesh += ' ' + hex(units(panel.y0, bits));
    mesh += ' ' + hex(units(found.panels.back().y1, bits));
    std::vector<std::size_t> rests_on{lines.add("mesh", {}, mesh)};
    for (std::size_t i = 0; i < found.panels.size(); ++i) {
        const auto& panel = found.panels[i];
        std::string data = fmt::format("panel={:x} middle={} half={} terms={:x} aim={:x}", i, hex(units(panel.centre, bits)),
                                       hex(units(panel.half, bits)), panel.coefficients.size(), accuracy);
        for (const auto& c : panel.coefficients) data += ' ' + hex(units(times * c, kept));
        rests_on.push_back(lines.add("polynomials", {rests_on.front()}, data));
    }
    return {std::move(rests_on), exactly(value()), goal * value()};
}

void write_poisson(const Root& root, long digits, std::size_t claim, std::size_t section, std::string& head, Lines& lines)
{
    const WrittenMean mean = write_mean({}, 0, root, std::pow(10.0, -static_cast<double>(digits)) / 2, lines);
    lines.add("share", mean.lines, fmt::format("claim={}", claim));
    head += fmt::format("claim {} G={} value={} error={}\n", claim, named(root), dyadic(mean.value), dyadic(rounded_up(mean.error)));
    head +=
        section_line(section, mean.lines.front(), lines.count(), {{"meshes", 1}, {"polynomials", mean.lines.size() - 1}, {"shares", 1}});
}

} // namespace touchstone::certificate
