// SPDX-License-Identifier: MIT
#include "touchstone/certificate/limit_scale.hpp"

#include "touchstone/certificate/limit_constant.hpp"
#include "touchstone/certificate/written_levels.hpp"
#include "touchstone/scalar/refusal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace touchstone::certificate {
namespace {

constexpr long first_scale = 2;   ///< one wave and none need no levels: such scales have no certificate
constexpr long most_levels = 60;
constexpr double far_enough = 64; ///< the last level is so much nearer the limit than the tolerance

/// V_m near its limit: what |h_M(load) - v|, M > m, and |C(G) - v| are at most, as the checker finds it.
struct Settled {
    double v, off;
};
Settled settled(const Grid& g, const Level& level, const Rational& load)
{
    const double G = nearest(g.G()), inverse = std::max(1 / load.get_d(), G * G), unit = std::ldexp(1.0, -static_cast<int>(g.kept_bits));
    const double a = std::exp2(-static_cast<double>(level.m) - 1);
    const auto falling = [](double t) { return std::exp2(-std::floor(t * 1.4426)); };
    Settled s{level.panels.front().coefficients.front().get_d() * unit, 0};
    const auto beyond = [&](std::size_t edge) { return (G + std::fabs(s.v)) * inverse * falling((1 - a) * g.edges[edge].get_d()); };
    s.off = beyond(0);
    double sum = 0;
    for (std::size_t p = 0; p < level.panels.size(); ++p) {
        const auto& c = level.panels[p].coefficients;
        mpz_class spread = abs(c.front() - level.panels.front().coefficients.front());
        for (std::size_t i = 1; i < c.size(); ++i) spread += abs(c[i]);
        sum += std::min(1.0, inverse * falling(g.edges[p].get_d())) * (spread.get_d() * unit + level.panels[p].error);
        s.off = std::min(s.off, sum + beyond(p + 1));
    }
    return s;
}

/// All that a section says.
struct Section {
    Grid grid;
    std::vector<Level> levels;
    std::vector<long> scales; ///< of each claim
};

/// The least n from which on all h up to that of the last level are within the tolerance of v; below `first_scale` there is no certificate.
long scale_of(const ScaleClaim& c, const DiscreteOperator& T, const std::vector<Level>& levels, double v)
{
    const Row row = T.row_at(c.load);
    for (std::size_t n = levels.size(); n-- > 1;) {
        const Ball h = T.apply(row, levels[n - 1]).value;
        if (std::fabs(nearest(h / Ball::exactly(v)) - 1) > c.tolerance.get_d()) return static_cast<long>(n) + 1;
    }
    return 0;
}

Section find(const std::vector<ScaleClaim>& claims)
{
    Rational least(1), largest(0), narrowest(1);
    for (const ScaleClaim& c : claims) {
        least = std::min(least, c.load);
        largest = std::max(largest, c.load);
        narrowest = std::min(narrowest, c.tolerance);
    }
    constexpr double spare_digits = 4;
    const double digits =
        spare_digits - std::log10(narrowest.get_d()) - std::log10(least.get_d()) / 2; // far panels count the more, the smaller a load
    constexpr long more = 4;
    for (auto last = static_cast<long>(std::ceil(-std::log2(narrowest.get_d()))) + more; last < most_levels; last += more) {
        Section s{grid_for(claims.front().G, last + 1, digits, least, largest), {}, {}};
        const DiscreteOperator T(s.grid);
        s.levels = T.levels(last + 1);
        for (const ScaleClaim& c : claims) {
            const Settled end = settled(s.grid, s.levels.back(), c.load);
            if (far_enough * end.off > c.tolerance.get_d() * end.v) break;
            const long n = scale_of(c, T, s.levels, end.v);
            if (n < first_scale) throw BeyondReach("the limit holds from scale 1 on: there is no certificate");
            s.scales.push_back(n);
        }
        if (s.scales.size() == claims.size()) return s;
    }
    throw BeyondReach(fmt::format("the limit does not hold soon enough: certificates have levels up to {}", most_levels));
}

void write(const Section& s, const std::vector<ScaleClaim>& claims, std::size_t first_claim, std::size_t section, std::string& head,
           Lines& lines)
{
    const WrittenSection written = write_levels(s.grid, s.levels, lines);
    for (std::size_t i = 0; i < claims.size(); ++i) {
        std::vector<std::size_t> rests_on{written.grid};
        for (auto m = static_cast<std::size_t>(s.scales[i] - first_scale); m < written.levels.size(); ++m)
            rests_on.insert(rests_on.end(), written.levels[m].begin(), written.levels[m].end());
        lines.add("settling", rests_on, fmt::format("claim={} m={:x}", first_claim + i, s.levels.back().m));
        head += fmt::format("claim {} load={} tolerance={} G={} value={} error=0:0\n", first_claim + i, claims[i].load.get_str(),
                            claims[i].tolerance.get_str(), named(claims[i].G), dyadic(mpz_class(s.scales[i]), 0));
    }
    Counts counts = written.counts();
    counts.emplace_back("settlings", claims.size());
    head += section_line(section, written.grid, lines.count(), counts);
}

} // namespace

std::string refusal_of_scale(const ScaleClaim& c)
{
    std::string why = refusal_of_limit(c.G);
    if (!why.empty()) return why;
    if (power(Rational(2009, 1000), static_cast<long>(c.G.degree)) > c.G.base)
        return "the scale from which on the limit holds has a certificate where G >= 2.009";
    Rational least(1);
    mpz_mul_2exp(least.get_den_mpz_t(), least.get_den_mpz_t(), 40);
    if (c.load < least || c.load > 1) return "the scale from which on the limit holds has a certificate where 2^-40 <= load <= 1";
    if (c.tolerance >= 1 || c.tolerance < Rational(1, 1'000'000'000'000'000)) return "tolerances from 10^-15 to 1 have a certificate";
    return "";
}

std::string limit_scales(const std::vector<ScaleClaim>& all)
{
    const auto sections = grouped(all, [](const ScaleClaim& a, const ScaleClaim& b) { return is_same(a.G, b.G); });
    std::string head;
    Lines lines;
    std::size_t claims = 0;
    for (std::size_t i = 0; i < sections.size(); ++i) {
        write(find(sections[i]), sections[i], claims + 1, i + 1, head, lines);
        claims += sections[i].size();
    }
    return certificate_text("limit.scale", claims, sections.size(), head, lines);
}

} // namespace touchstone::certificate
