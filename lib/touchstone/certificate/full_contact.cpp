// SPDX-License-Identifier: MIT
#include "touchstone/certificate/full_contact.hpp"

#include "touchstone/scalar/refusal.hpp"
#include "touchstone/transfer/layer.hpp"
#include "touchstone/transfer/proven_levels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>

namespace touchstone::certificate {

mpz_class units(const DoubleDouble<double>& x, long b)
{
    mpf_class f(x.high, 320);
    f += mpf_class(x.low, 320);
    mpf_mul_2exp(f.get_mpf_t(), f.get_mpf_t(), static_cast<mp_bitcnt_t>(b + 1));
    mpz_class n(f);
    n += 1;
    return n >> 1;
}

namespace {

constexpr double smallest = 1e-14; ///< shares

/// What the checker is told to do.
struct Choices {
    long accuracy;                                  ///< defects are looked into down to 2^-accuracy,
    long relative;                                  ///< or to 2^-relative of V where that is more
    double least;                                   ///< the first ratio of the smallest load
    long rise;                                      ///< 2^(m rise/16) V_m is written, for B_m falls like G^-m
    double of_load;                                 ///< of densities at scale 2: the load, whose wave alone counts
    bool twice; ///< whether a wave is taken of what is left out next to a logarithm, as of a root at the end of a wave
    long bits() const { return twice ? 4 * (accuracy + 8) : 2 * accuracy + 64; } ///< a root at an end of a wave loses half of them
    long kept() const { return accuracy + 26; }      ///< of the coefficients: jumps between panels stay as small where one is continued
    long lift(long m) const { return m * rise / 16; }
};

/// The last panel that begins before y.
std::size_t panel_before(double y, const transfer::levels::Layer& V)
{
    std::size_t panel = 0;
    while (panel + 1 < V.panels.size() && V.panels[panel + 1].y0.high < y * (1 - 1e-9)) ++panel;
    return panel;
}

/// Before which panel no density matters: no ratio is met there so many scales below this load, or all levels are 0 there, or so small are
/// ratios that a wave has little of them. P in p*_n.
std::size_t panels_without_density(double load, double G, double P, long levels, const transfer::levels::Layer& V, const Choices& c)
{
    const auto reaches = [G](double y) { return G * y < 2 ? G * G * y * y / 4 : G * y - 1; }; // the load whose largest ratio this is
    const double first = reaches(P < 2 ? P * P / 4 : P - 1);
    double begins = first, lowest = first, x = load;
    for (long k = 1; k < levels; ++k) begins = reaches(begins), lowest = std::min(lowest, begins);
    std::size_t met = 0;
    for (long k = 0; k < levels; ++k) {
        met = panel_before(x > 1 ? (x - 1) / G : 0, V);
        x = V.panels[met].y0.high;
    }
    const double small = std::exp2(-static_cast<double>(c.accuracy + 8));
    return std::max(met, panel_before(std::min(first, std::max(lowest, small)), V));
}

/// How many panels so many scales below this load meet, (2.10), (2.13), from the end of a panel to the end of another; one more for
/// rounding.
std::size_t panels_below(double load, double G, long levels, const transfer::levels::Layer& V)
{
    std::size_t count = 0;
    double x = load;
    for (long k = 0; k < levels; ++k) {
        const double farthest = x < 1 ? 2 * std::sqrt(x) / G : (1 + x) / G;
        while (count < V.panels.size() && V.panels[count].y1.high < farthest) ++count;
        x = std::max(load, V.panels[std::min(count, V.panels.size() - 1)].y1.high);
    }
    return std::min(V.panels.size(), count + 2);
}

/// What the wave of a load has of a narrow panel, some times what it has in its middle; infinite next to its ends.
double share_of_wave(double load, double G, double y, double width)
{
    const double c = load >= 1 ? G * y - load : std::hypot(G * y, 1 - load) - load, inside = std::min(1 - c, 1 + c) - 2 * G * width;
    return inside > 0 ? G * width / std::sqrt(inside) : HUGE_VAL;
}

/// log2 of what the checker is to look for on a panel: relative to the least level there, or to that at the first ratio of the smallest
/// load where ratios are smaller; less on a panel so narrow that of many like it a wave has little (H). Nothing is proved by it.
long aim(const transfer::levels::Layer& V, std::size_t panel, long levels, double G, const Choices& c)
{
    const auto &low = V.panels[panel].y0, &high = V.panels[panel].y1;
    const double width = (high.high - low.high) + (high.low - low.low); // may be less than a unit of the last place of either
    std::size_t at = panel;
    while (at + 1 < V.panels.size() && V.panels[at].y1.high < c.least) ++at;
    double size = 1;
    for (long m = 0; m < levels; ++m) {
        double value = 0; // at the lower end, where T_k = (-1)^k
        for (int k = 0; k < V.orders.terms; ++k)
            value += (k % 2 == 0 ? 1 : -1) * V.coefficients.high[V.row(at, k) + static_cast<std::size_t>(m)];
        size = std::min(size, std::ldexp(std::abs(value), static_cast<int>(c.lift(m))));
    }
    const double bits = std::min(static_cast<double>(c.relative) - std::log2(size), static_cast<double>(c.accuracy));
    constexpr double many = 8; // log2
    const double share = std::min(std::sqrt(G * width / 2), c.of_load > 0 ? share_of_wave(c.of_load, G, low.high, width) : HUGE_VAL);
    return std::clamp(static_cast<long>(bits + std::min(0.0, std::log2(share) + many)), 0L, c.accuracy);
}

/// The numbers of the lines mesh and polynomials.
std::vector<std::size_t> write_mesh(const transfer::levels::Layer& V, const Claim& a, const Rational& load, long levels, double unit,
                                    const Choices& c, Lines& lines)
{
    std::string mesh = fmt::format("G={} p={} scale={:x} load={} bits={:x} kept={:x} accuracy={:x} rise={:x}", named(a.G), a.at.get_str(),
                                   a.at == 0 ? 0 : a.n, load.get_str(), c.bits(), c.kept(), c.accuracy, c.rise);
    const double G = nearest(number(a.G));
    const bool density = a.of == Claim::Of::density;
    const std::size_t panels = panels_below(load.get_d(), G, levels, V),
                      from = density
                                 ? panels_without_density(load.get_d(), G, nearest(Ball(a.at) / pow(number(a.G), Ball(a.n))), levels, V, c)
                                 : 0;
    for (std::size_t i = from; i < panels; ++i) mesh += ' ' + hex(units(V.panels[i].y0, c.bits()));
    mesh += ' ' + hex(units(V.panels[panels - 1].y1, c.bits()));
    std::vector<std::size_t> numbers{lines.add("mesh", {}, mesh)};
    for (std::size_t i = from; i < panels; ++i) {
        const auto& panel = V.panels[i];
        std::string data = fmt::format("panel={:x} middle={} half={} terms={:x} aim={:x}", i - from, hex(units(panel.centre, c.bits())),
                                       hex(units(panel.half, c.bits())), V.orders.terms, aim(V, i, levels, G, c));
        for (int m = 0; m < levels; ++m)
            for (int k = 0; k < V.orders.terms; ++k) {
                const std::size_t at = V.row(i, k) + static_cast<std::size_t>(m);
                data += ' ' + hex(units({unit * V.coefficients.high[at], unit * V.coefficients.low[at]}, c.kept() + c.lift(m)));
            }
        numbers.push_back(lines.add("polynomials", {numbers.front()}, data));
    }
    return numbers;
}

/// The levels of an area, or of a share above the pressure p = P p*_n, p*_n = G^n p*_0, or of the density there, whose first is that of
/// scale 1.
transfer::ProvenLevels levels_of(const Claim& a, double highest, double tolerance, int scales)
{
    const Ball G = number(a.G);
    if (a.at == 0) return {G, highest, tolerance, scales};
    const Ball P = Ball(a.at) / pow(G, Ball(a.n));
    if (a.of == Claim::Of::density) return transfer::ProvenLevels::densities(G, P, highest, tolerance, scales);
    return {G, P, highest, tolerance, scales};
}

} // namespace

void write_full_contact(const std::vector<Claim>& areas, long digits, std::size_t first_claim, std::size_t section, std::string& head,
                        Lines& lines)
{
    const WorkingPrecision precision(256);
    long levels = 1;
    Rational load = areas.front().load, lightest = load;
    const bool density = areas.front().of == Claim::Of::density;
    const long first_scale = density ? 2 : 1; // what a wave makes of the first level
    for (const Claim& a : areas)
        levels = std::max(levels, a.n - first_scale + 1), load = std::max(load, a.load), lightest = std::min(lightest, a.load);
    const double goal = std::pow(10.0, -static_cast<double>(digits)) / 2;
    constexpr double spare = 32; // the checker's bounds of the same defects are wider, by Lebesgue's constant among others
    const long spare_bits = 3 + static_cast<long>(std::bit_width(static_cast<unsigned long>(levels))); // errors add up over the levels
    double tolerance = std::min(goal, transfer::ProvenLevels::coarsest_tolerance);
    std::vector<Ball> values;
    const std::size_t first = lines.count() + 1;
    for (int attempt = 0;; ++attempt) {
        const transfer::ProvenLevels V = levels_of(areas.front(), density ? load.get_d() * (1 + 0x1p-40) : std::max(1.0, load.get_d()),
                                                   tolerance, static_cast<int>(levels));
        values.clear();
        const double G = nearest(number(areas.front().G));
        Choices choices{0,
                        0,
                        2 * std::sqrt(std::min(1.0, lightest.get_d())) / G,
                        static_cast<long>(16 * std::log2(G)),
                        density && levels == 1 ? load.get_d() : 0,
                        density && levels > 1};
        double worst = 0, least = 1;
        for (const Claim& a : areas) {
            values.push_back(V.share(a.n - first_scale + 1, Ball(a.load)));
            const double value = nearest(values.back());
            if (!(value > smallest))
                throw BeyondReach(fmt::format("{} below {} have no certificate", density ? "densities" : "shares", smallest));
            worst = std::max(worst, spare / goal * values.back().radius_bound() / value);
            least = std::min(least, std::ldexp(value, static_cast<int>(choices.lift(a.n - first_scale))));
        }
        if (worst > 1) {
            tolerance /= 2 * worst;
            if (attempt == 3 || tolerance < transfer::ProvenLevels::finest_tolerance)
                throw BeyondReach(fmt::format("the certificate's errors do not come below {:.1e}", goal));
            continue;
        }
        choices.accuracy = static_cast<long>(std::ceil(-std::log2(goal * least))) + spare_bits;
        choices.relative = static_cast<long>(std::ceil(-std::log2(goal))) + spare_bits;
        const std::vector<std::size_t> rests_on = write_mesh(V.layer(), areas.front(), load, levels, V.unit(), choices, lines);
        for (std::size_t i = 0; i < areas.size(); ++i) {
            if (density) values[i] = values[i] / pow(number(areas[i].G), Ball(areas[i].n)); // in 1/p*_0
            lines.add("share", rests_on, fmt::format("claim={}", first_claim + i));
            const double error = goal * nearest(values[i]);
            const std::string p = areas[i].at == 0 ? "" : fmt::format(" p={}", areas[i].at.get_str());
            head += fmt::format("claim {} n={:x}{} load={} G={} value={} error={}\n", first_claim + i, areas[i].n, p,
                                areas[i].load.get_str(), named(areas[i].G), dyadic_midpoint(values[i]), dyadic(rounded_up(error)));
        }
        head +=
            section_line(section, first, lines.count(), {{"meshes", 1}, {"polynomials", rests_on.size() - 1}, {"shares", areas.size()}});
        return;
    }
}

} // namespace touchstone::certificate
