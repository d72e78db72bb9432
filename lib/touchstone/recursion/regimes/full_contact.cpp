// SPDX-License-Identifier: MIT
#include "touchstone/recursion/regimes/regimes.hpp"

#include "touchstone/scalar/refusal.hpp"
#include "touchstone/transfer/full_contact.hpp"
#include "touchstone/transfer/heavy_load.hpp"
#include "touchstone/transfer/proven_levels.hpp"
#include "touchstone/transfer/three_waves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace touchstone::recursion {

using transfer::ProvenLevels, transfer::Scheme;

// ---- full contact

/// Above load 1 it has two proofs, but is slow towards G = 2.
Method heavy_load()
{
    const auto by = [](Scheme s) {
        return [s](const Problem& p, Accuracy a) { return transfer::area_at_heavy_load(s, p.n, arguments(p), a); };
    };
    return {
        .name = "heavy-load-force-weighted",
        .asked = {Asked::area},
        .reach = "1 < load <= 1000, 2.02 < G < 10^9, G^(n/2) up to 10^270 or so",
        .refusal = [](const Problem& p) -> std::string {
            if (p.load <= 1 || p.load > 1000) return "load must be above 1 and at most 1000";
            if (p.n > last_followed_scale) return "for load > 1 areas are certified for n <= 10^4 only";
            if (!G_below_10_9(p)) return "G = gamma^(D-1) must be below 10^9";
            if (!transfer::heavy_load_has_panels(p.n, p.G.ball()))
                return "for load > 1 and G^(n/2) beyond some 10^270 panels would be too narrow for binary64 numbers";
            return G_above(p, Rational(101, 50)) ? "" : "for load > 1 so near G = 2 it would take hours: many scales have ratios about 1";
        },
        .digits = 60, // 160 nats, heavy_load.cpp
        .cost =
            [](const Problem& p, Accuracy a) {
                const double near_2 = 1.2 / (about_G(p) - 2),
                             nats = static_cast<double>(p.n) * std::log(about_G(p)); // panels shrink to G^(-n/2)
                return (0.5 + 6.5 * near_2 * near_2 + 3e-7 * nats * nats * nats) * growth(a, 2.5);
            },
        .enclose = by(Scheme::force_weighted),
        .budget =
            [](const Problem& p, Accuracy a) {
                return Budget{"",
                              {{transfer::heavy_load_certificate(Scheme::force_weighted, p.n, arguments(p), a)},
                               {transfer::heavy_load_certificate(Scheme::area, p.n, arguments(p), looked_at_again(a))}}};
            },
        .second = "heavy-load-area",
        .enclose_again = by(Scheme::area),
        .shares =
            "lemmas 3 and 4 and the way the first scales are taken; every node is another, and below load ratio 1 so are grid, form of the step and rule",
    };
}

static Ball by_proven_levels(const Problem& p, Accuracy a)
{
    const WorkingPrecision precision(256);
    const auto ratio = [&p] { return p.p.ball() / unit_pressure(p); };
    if (p.asked == Asked::area) return transfer::area_by_proven_levels(p.n, arguments(p), a);
    if (p.asked == Asked::exceedance) return transfer::exceedance_by_proven_levels(p.n, ratio, arguments(p), a);
    if (above_support(p)) return Ball(0);
    return transfer::density_by_proven_levels(p.n, ratio, arguments(p), a) / unit_pressure(p);
}

static Budget proven_levels_budget(const Problem& p, Accuracy a)
{
    const auto ratio = [&p] { return p.p.ball() / unit_pressure(p); };
    if (p.asked == Asked::area) return {transfer::area_by_proven_levels_certificate(p.n, arguments(p), a)};
    if (p.asked == Asked::exceedance) return {transfer::exceedance_by_proven_levels_certificate(p.n, ratio, arguments(p), a)};
    return {transfer::density_by_proven_levels_certificate(p.n, ratio, arguments(p), a)};
}

struct LevelsReach {
    long scales;
    Rational load;
};
const LevelsReach shares_reach{ProvenLevels::most_levels, 1000}, densities_reach{20, 100};

/// What the levels of every law need.
static std::string refusal_of_levels(const Problem& p, const LevelsReach& reach)
{
    if (p.n > reach.scales)
        return fmt::format("with full contact, {} are certified for n <= {} only",
                           p.asked == Asked::density ? "densities" : "areas and exceedances", reach.scales);
    if (p.load > reach.load)
        return fmt::format("with full contact and so many digits, certified for load <= {} only", reach.load.get_str());
    if (!G_above(p, Rational(1003, 1000))) return "G too near 1 for the proven levels";
    if (!G_below_10_9(p)) return "G = gamma^(D-1) must be below 10^9";
    const double G = about_G(p); // below: the first panel of the finest mesh begins above all ratios
    return 4 * p.load.get_d() < 1e-53 * G * G ? "load too small for the proven levels" : "";
}

const char* const witness_shares =
    "the wave (2.2), (2.4) and nothing else: grid, interpolation, quadrature and arithmetic are others; its error is an estimate";

Method proven_shares()
{
    return {
        .name = "proven-levels",
        .asked = {Asked::area, Asked::exceedance},
        .reach = fmt::format("1 <= n <= {}, load <= {}, 1.003 < G < 10^9", shares_reach.scales, shares_reach.load.get_str()),
        .refusal = [](const Problem& p) -> std::string { return p.n < 1 ? "n must be at least 1" : refusal_of_levels(p, shares_reach); },
        .digits = 20,
        .cost = [](const Problem& p, Accuracy a) { return (p.load > 10 ? 20 : 4) * (1 + static_cast<double>(p.n) / 40) * growth(a, 2); },
        .enclose = by_proven_levels,
        .budget = proven_levels_budget,
        .second = "",
        .shares = witness_shares,
    };
}

/// p*_n/1024: below, the mesh takes minutes and more (proven_levels.md).
static bool pressure_too_low(const Problem& p)
{
    const WorkingPrecision precision(128);
    return !certainly(less(unit_pressure(p), 1024 * p.p.ball()));
}

/// Singular points at 1 - load and next to it are resolved in double-double arithmetic, which must tell them from 0.
static bool load_next_to_1(const Problem& p)
{
    const Rational off = abs(Rational(p.load - 1));
    return off > 0 && off < power(Rational(10), -27);
}

Method proven_densities()
{
    return {
        .name = "proven-levels",
        .asked = {Asked::density},
        .reach = fmt::format("2 <= n <= {}, load <= {}, load = 1 or at least 1e-27 off it, 1.003 < G < 10^9, p >= p*_n/1024",
                             densities_reach.scales, densities_reach.load.get_str()),
        .refusal = [](const Problem& p) -> std::string {
            if (p.n < 2) return "n must be at least 2";
            if (p_is_0(p)) return no_density_at_0;
            if (const std::string refused = refusal_of_levels(p, densities_reach); !refused.empty()) return refused;
            if (p.n > 2 && load_next_to_1(p)) return "the load is too near 1 for the proven levels of densities, and not 1";
            return pressure_too_low(p) ? "the pressure is too low for the proven levels of densities: below p*_n/1024" : "";
        },
        .digits = 15, // beyond, the meshes grow without end (proven_levels.md)
        .cost = [](const Problem&, Accuracy a) { return 60 * growth(a, 3); },
        .enclose = by_proven_levels,
        .budget = proven_levels_budget,
        .second = "",
        .shares = witness_shares,
    };
}

static transfer::ThreeWaves after_three_waves(const Problem& p, Accuracy a)
{
    constexpr long fewest = 4, most = 23;
    if (a.digits > most) throw BeyondReach("numbers of 106 bits prove no more digits of a density");
    const double tolerance = std::pow(10.0, -static_cast<double>(std::max(a.digits, fewest)) - 2);
    const WorkingPrecision precision(256);
    return transfer::density_after_three_waves(p.G.ball(), p.p.ball() / unit_pressure(p), Ball(p.load), tolerance);
}

/// q_2 needs no level but the first: one integral instead of a mesh.
Method third_wave_density()
{
    return {
        .name = "three-waves",
        .asked = {Asked::density},
        .reach = fmt::format("n = 2, load <= {}, 1.003 < G < 10^9, p >= p*_n/1024", densities_reach.load.get_str()),
        .refusal = [levels = proven_densities()](const Problem& p) -> std::string { return p.n == 2 ? levels.refusal(p) : "n must be 2"; },
        .digits = 22, // of the 31 of two binary64
        .cost = [](const Problem&, Accuracy a) { return 6 * growth(a, 2); },
        .enclose =
            [](const Problem& p, Accuracy a) {
                const WorkingPrecision precision(256);
                return above_support(p) ? Ball(0) : after_three_waves(p, a).value / unit_pressure(p);
            },
        .budget = [](const Problem& p,
                     Accuracy a) { return Budget{above_support(p) ? "above the support" : after_three_waves(p, a).certificate}; },
        .second = "",
        .shares = witness_shares,
    };
}

} // namespace touchstone::recursion
