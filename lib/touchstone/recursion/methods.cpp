// SPDX-License-Identifier: MIT
#include "touchstone/recursion/methods.hpp"

#include "touchstone/limit/area_constant.hpp"
#include "touchstone/paper/as_printed.hpp"
#include "touchstone/paper/peaks.hpp"
#include "touchstone/paper/westergaard.hpp"
#include "touchstone/recursion/first_steps/area_by_slope.hpp"
#include "touchstone/recursion/first_steps/nested.hpp"
#include "touchstone/recursion/first_steps/scale_one.hpp"
#include "touchstone/recursion/light_load.hpp"
#include "touchstone/scalar/refusal.hpp"
#include "touchstone/transfer/contact.hpp"
#include "touchstone/recursion/from_the_edge/forward.hpp"
#include "touchstone/transfer/full_contact.hpp"
#include "touchstone/transfer/heavy_load.hpp"
#include "touchstone/transfer/proven_levels.hpp"
#include "touchstone/transfer/three_waves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace touchstone::recursion {
namespace {

using transfer::Grid, transfer::Law, transfer::ProvenLevels, transfer::Scheme, transfer::Variable;

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

bool above_support(const Problem& p)
{
    const WorkingPrecision precision(256);
    return certainly(less(highest_pressure(p), p.p.ball()));
}

/// f at the precision that a formula needs for this accuracy.
template <class F>
auto with_precision(Accuracy a, F f)
{
    const WorkingPrecision precision(working_bits(a));
    return f();
}

double growth(Accuracy a, double power) { return std::pow(static_cast<double>(std::max(a.digits, 10L)) / 20, power); }

// ---- one scale: the closed forms of section 2

const char* const n_not_0 = "n must be 0";

Method single_wave_area()
{
    return {
        .name = "arcsine",
        .asked = {Asked::area},
        .reach = "n = 0",
        .refusal = [](const Problem& p) -> std::string { return p.n == 0 ? "" : n_not_0; },
        .cost = [](const Problem&, Accuracy a) { return 1e-5 * growth(a, 1); },
        .enclose = [](const Problem& p, Accuracy a) { return with_precision(a, [&] { return p.load >= 1 ? Ball(1) : 2 * westergaard::half_width(Ball(p.load)); }); },
        .budget = [](const Problem&, Accuracy) { return Budget{"A_0 = (2/pi) arcsin sqrt(load), (6.6), in balls"}; },
        .second = "arctangent",
        .enclose_again = [](const Problem& p, Accuracy a) {
            return with_precision(a, [&] { return p.load >= 1 ? Ball(1) : 2 * atan2(sqrt(Ball(p.load)), sqrt(1 - Ball(p.load))) / pi<Ball>(); });
        },
        .shares = "(6.6), by another inverse function",
    };
}

Method single_wave_exceedance()
{
    return {
        .name = "cancellation-free",
        .asked = {Asked::exceedance},
        .reach = "n = 0",
        .refusal = [](const Problem& p) -> std::string { return p.n == 0 ? "" : n_not_0; },
        .cost = [](const Problem&, Accuracy a) { return 1e-5 * growth(a, 1); },
        .enclose = [](const Problem& p, Accuracy a) { return with_precision(a, [&] { return westergaard::exceedance(p.p.ball(), Ball(p.load)); }); },
        .budget = [](const Problem&, Accuracy) { return Budget{"(2.14), (2.17), in balls"}; },
        .second = "as-printed",
        .enclose_again = [](const Problem& p, Accuracy a) {
            return with_precision(a, [&] {
                const Ball pressure = p.p.ball(), load(p.load);
                return p.load < 1 ? as_printed::exceedance_partial(pressure, load) : as_printed::exceedance_full(pressure, load);
            });
        },
        .shares = "(2.14), (2.17), in another algebraic form",
    };
}

/// At p_0^max, and at p_0^min > 0 and load = 1, p = 0, where (2.19) goes with p^(-1/2).
bool infinite_first_density(const Rational& p, const Rational& load)
{
    return load < 1 ? p * p == 4 * load : p == load + 1 || p == load - 1;
}

Method single_wave_density()
{
    const auto off_support = [](const Problem& p) { return certainly(less(p.p.ball(), Ball(p.load) - 1)) || above_support(p); };
    return {
        .name = "cancellation-free",
        .asked = {Asked::density},
        .reach = "n = 0",
        .refusal = [](const Problem& p) -> std::string {
            if (p.n != 0) return n_not_0;
            return p.p.exact && p.p.exact->is_rational() && infinite_first_density(p.p.exact->rational(), p.load) ? "q_0 is infinite at this pressure, an end of its support" : "";
        },
        .cost = [](const Problem&, Accuracy a) { return 1e-5 * growth(a, 1); },
        .enclose = [off_support](const Problem& p, Accuracy a) {
            return with_precision(a, [&] { return off_support(p) ? Ball(0) : westergaard::density(p.p.ball(), Ball(p.load)); });
        },
        .budget = [](const Problem&, Accuracy) { return Budget{"(2.15), (2.19), in balls"}; },
        .second = "as-printed",
        .enclose_again = [off_support](const Problem& p, Accuracy a) {
            return with_precision(a, [&] {
                const Ball pressure = p.p.ball(), load(p.load);
                if (off_support(p)) return Ball(0);
                return p.load < 1 ? as_printed::density_partial(pressure, load) : as_printed::density_full(pressure, load);
            });
        },
        .shares = "(2.15), (2.19), in another algebraic form",
    };
}

// ---- one integral: scale 1

const char* const no_density_at_0 = "not computed at p = 0, where q_n is 0 unless a singular point lies there; ask for p > 0";

bool p_is_0(const Problem& p) { return p.asked == Asked::density && p.p.exact && p.p.exact->is_zero(); }

Ball scale_one(Variable v, const Problem& p, Accuracy a)
{
    return with_precision(a, [&] {
        if (p.asked == Asked::area) return transfer::scale_one_exceedance(v, {[] { return Ball(0); }, p.load, p.G.ball, Exact(0), p.G.exact});
        const transfer::ScaleOne q{p.p.ball, p.load, p.G.ball, p.p.exact, p.G.exact};
        if (p.asked == Asked::exceedance) return transfer::scale_one_exceedance(v, q);
        return above_support(p) ? Ball(0) : transfer::scale_one_density(v, q);
    });
}

Method one_integral()
{
    return {
        .name = "scale-one-by-ratio",
        .asked = {Asked::area, Asked::exceedance, Asked::density},
        .reach = "n = 1",
        .refusal = [](const Problem& p) -> std::string { return p.n != 1 ? "n must be 1" : p_is_0(p) ? no_density_at_0 : ""; },
        .cost = [](const Problem&, Accuracy a) { return 0.02 * growth(a, 2); },
        .enclose = [](const Problem& p, Accuracy a) { return scale_one(Variable::ratio, p, a); },
        .budget = [](const Problem&, Accuracy) {
            return Budget{"n = 1: one integral by the pressure at scale 0 and by the angle of the wave of scale 1, in complex balls (recursion/first_steps/scale_one.hpp)"};
        },
        .second = "scale-one-by-angle",
        .enclose_again = [](const Problem& p, Accuracy a) { return scale_one(Variable::angle, p, a); },
        .shares = "the closed forms of one wave and acb_calc_integrate; another variable, hence another integrand and other singular points",
    };
}

// ---- one integral over closed forms: the area at scale 2

/// The zeros of 1 + (1 - load) sinh^2 v go out like -log(1 - load), and the strips of the discretised operator's rules become so much narrower (measured to 1e-300).
bool too_near_1(const Rational& load) { return load < 1 && 1 - load < power(Rational(10), -300); }

/// Where the discretised operator does not serve.
bool two_waves_serve_better(const Problem& p)
{
    return p.load > 1 || p.compare_G(Rational(2'000'001, 1'000'000)) < 0 || too_near_1(p.load);
}

Witness nested_quadrature(const Problem& p)
{
    const auto [value, error] = transfer::nested_area(p.load.get_d(), about_G(p));
    return {Ball::exactly(value), Ball::exactly(error)};
}

Method second_area()
{
    return {
        .name = "slope-of-two-waves",
        .asked = {Asked::area},
        .reach = "n = 2, and load > 1 or G < 2.000001 or 0 < 1 - load < 1e-300",
        .refusal = [](const Problem& p) -> std::string {
            if (p.n != 2) return "n must be 2";
            return two_waves_serve_better(p) ? "" : "in partial contact there are two proofs";
        },
        .cost = [](const Problem&, Accuracy a) { return 0.5 * growth(a, 2); },
        .enclose = [](const Problem& p, Accuracy a) {
            constexpr slong guard = 40; // of the 48 bits beyond the digits
            return with_precision(a, [&] { return transfer::area_by_slope(2, {p.load, p.G.ball, p.G.exact}, working_bits(a) - guard); });
        },
        .budget = [](const Problem&, Accuracy) {
            return Budget{"n = 2: one integral of the share above each pressure at scale 0 times the slope of A_1, a complete integral of genus 1 or 2 (recursion/first_steps/area_by_slope.hpp)"};
        },
        .witness = Observer{"nested-quadrature", [](const Problem& p, Accuracy) { return nested_quadrature(p); }},
        .shares = "the wave (2.2), (2.4) and nothing else: quadrature within quadrature in binary64, some ten digits; its error is an estimate",
    };
}

// ---- partial contact at every scale

/// Areas of so many scales are not followed scale by scale.
constexpr long last_followed_scale = 10'000;
/// From here on they are taken from the limit where it leaves the digits asked for: docs/limit.md, theorem 2.
constexpr long first_scale_of_limit = 200;

long digits_of_limit(const Problem& p)
{
    const WorkingPrecision precision(128);
    return limit::most_digits_of_area_in_the_limit(p.n, Ball(p.load), p.G.ball());
}
bool in_the_limit(const Problem& p, Accuracy a)
{
    return p.n > last_followed_scale || (p.n > first_scale_of_limit && a.digits <= digits_of_limit(p));
}

Method partial_area()
{
    const auto by = [](Scheme s) {
        return [s](const Problem& p, Accuracy a) {
            return in_the_limit(p, a) ? limit::area_in_the_limit(s, p.n, arguments(p), a) : transfer::area(s, p.n, arguments(p), a);
        };
    };
    return {
        .name = "force-weighted-chebyshev",
        .asked = {Asked::area},
        .reach = "load <= 1 - 1e-300 or load = 1, 2.000001 <= G < 10^9",
        .refusal = [](const Problem& p) -> std::string {
            if (p.load > 1) return "no proof for load > 1, where the first scale is in full contact";
            if (p.n > 0 && too_near_1(p.load)) return "load within 1e-300 of 1, and not 1: the region of analyticity is too narrow";
            if (!G_below_10_9(p)) return "G = gamma^(D-1) must be below 10^9";
            return p.compare_G(Rational(2'000'001, 1'000'000)) < 0 ? "no proof for G = gamma^(D-1) <= 2, where some regions stay in full contact at every scale" : "";
        },
        .fewer_digits = [](const Problem& p) {
            const WorkingPrecision precision(128);
            if (p.n > last_followed_scale) return digits_of_limit(p);
            return transfer::most_digits_of_area(Ball(p.load), p.G.ball());
        },
        .cost = [](const Problem& p, Accuracy a) { return 0.2 * growth({a.digits + static_cast<long>(digits_lost_to_light_load(p))}, 2.5); },
        .enclose = by(Scheme::force_weighted),
        .budget = [](const Problem& p, Accuracy a) {
            if (in_the_limit(p, a))
                return Budget{"A_n = C(G) G^-n load (1 +- delta_n), docs/limit.md, theorem 2", {{limit::area_constant_certificate(Scheme::force_weighted, p.G.ball, a)}}};
            return Budget{"", {{transfer::area_certificate(Scheme::force_weighted, p.n, arguments(p), a)}, {transfer::area_certificate(Scheme::area, p.n, arguments(p), looked_at_again(a))}}};
        },
        .second = "area-gauss-panels",
        .enclose_again = by(Scheme::area),
        .shares = "lemmas 1 and 2 of the operator, the fixed-point arithmetic and how errors add; neither grid, variable, form of the step nor quadrature rule",
    };
}

/// Any load, and full contact too: docs/limit.md, theorem 1.
Method area_in_any_limit()
{
    return {
        .name = "limit-of-scales",
        .asked = {Asked::area},
        .reach = "n > 200, as far as the rate of approach leaves digits (n = 2000: 15 for G = 3/2, load = 1), 1e-300 <= load <= 10^6, 1.02 <= G < 10^9",
        .refusal = [](const Problem& p) -> std::string {
            if (p.n <= first_scale_of_limit) return "no proof by the limit for n <= 200";
            if (p.load > 1'000'000 || p.load < power(Rational(10), -300)) return "load must be from 1e-300 to 10^6";
            if (p.compare_G(Rational(102, 100)) < 0) return "the constant of the limit is certified for G = gamma^(D-1) >= 1.02 only";
            if (!G_below_10_9(p)) return "G = gamma^(D-1) must be below 10^9";
            const WorkingPrecision precision(128);
            return limit::most_digits_of_area_in_any_limit(p.n, Ball(p.load), p.G.ball()) > 0 ? "" : "the limit is not reached at that scale, as far as its rate is proven";
        },
        .fewer_digits = [](const Problem& p) {
            const WorkingPrecision precision(128);
            return limit::most_digits_of_area_in_any_limit(p.n, Ball(p.load), p.G.ball());
        },
        .cost = [](const Problem&, Accuracy a) { return 2 + 10 * growth(a, 2.5); },
        .enclose = [](const Problem& p, Accuracy a) { return limit::area_in_any_limit(p.n, arguments(p), a); },
        .budget = [](const Problem&, Accuracy) { return Budget{"A_n = G^-n load (C(G) +- 3 (m + G^2)^(1/2) (lambda^n d)^(1/2)), docs/limit.md, theorem 1"}; },
        .witness = Observer{"limit-law", [](const Problem& p, Accuracy) { return limit::area_by_limit_law(p.n, arguments(p)); }},
        .shares = "the wave (2.2), (2.4) and where it is not smooth: it goes forwards, to the limiting distribution; grid, quadrature and arithmetic are others",
    };
}

/// Whether no highest ratio e_k, (5.6), k <= n, is so near 1 that what is left of the levels' sector is too narrow (measured: from 0.999 on
/// they refuse). Only a choice between proofs, hence in binary64.
bool edges_clear_of_1(const Problem& p)
{
    const double G = about_G(p);
    double e = p.load.get_d();
    for (long k = 0; k <= std::min(p.n, transfer::Forward::largest_n); ++k, e = 2 * std::sqrt(e) / G)
        if (e > 0.998 && e < 1) return false;
    return true;
}

Method partial_distribution()
{
    const auto by = [](Law law) {
        return [law](const Problem& p, Accuracy a) -> Ball {
            if (above_support(p)) return Ball(0);
            return p.asked == Asked::exceedance ? transfer::exceedance(law, p.n, p.p.ball, arguments(p), a) : transfer::density(law, p.n, p.p.ball, arguments(p), a);
        };
    };
    return {
        .name = "forward-density",
        .asked = {Asked::exceedance, Asked::density},
        .reach = fmt::format("1 <= n <= {}, load <= 1, G > 2, no p_k^max within 0.2% below p*_(k+1)", transfer::Forward::largest_n),
        .refusal = [](const Problem& p) -> std::string {
            if (p.n < 1) return "n must be at least 1";
            if (p.load > 1) return "no proof for load > 1, where the first scale is in full contact";
            if (!G_above(p, 2)) return "no proof for G = gamma^(D-1) <= 2, where some regions stay in full contact at every scale";
            if (p.n > transfer::Forward::largest_n)
                return fmt::format("distributions of pressure are computed for the scales n <= {} only", transfer::Forward::largest_n);
            if (p_is_0(p)) return no_density_at_0;
            return edges_clear_of_1(p) ? "" : "some scale's highest pressure is too near p*: the region of analyticity is too narrow";
        },
        .digits = 290,
        .fewer_digits = [](const Problem& p) {
            try {
                return above_support(p) ? any_digits : transfer::most_digits_of_distribution(p.n, p.p.ball, arguments(p), p.asked == Asked::density);
            }
            catch (const BeyondReach&) { // p cannot be told from the edge: enclose() says so
                return any_digits;
            }
        },
        .cost = [](const Problem& p, Accuracy a) { return 0.25 * static_cast<double>(p.n) * growth(a, 2); },
        .enclose = by(Law::density),
        .budget = [](const Problem& p, Accuracy a) {
            if (above_support(p)) return Budget{"above the support"};
            return Budget{"", {{transfer::distribution_certificate(Law::density, p.n, p.p.ball, arguments(p), a)},
                               {transfer::distribution_certificate(Law::exceedance, p.n, p.p.ball, arguments(p), looked_at_again(a))}}};
        },
        .second = "forward-exceedance",
        .enclose_again = by(Law::exceedance),
        .shares = "boxes, panels, quadrature and arithmetic of one engine; the recursion of another law: kernel, closed first step and unknown are others",
    };
}

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
        .reach = "1 < load < 1000, 2.02 < G < 10^9",
        .refusal = [](const Problem& p) -> std::string {
            if (p.load <= 1 || p.load >= 1000) return "load must be above 1 and below 1000";
            if (p.n > last_followed_scale) return "for load > 1 areas are certified for n <= 10^4 only";
            if (!G_below_10_9(p)) return "G = gamma^(D-1) must be below 10^9";
            return G_above(p, Rational(101, 50)) ? "" : "for load > 1 so near G = 2 it would take hours: many scales have ratios about 1";
        },
        .digits = 60, // 160 nats, heavy_load.cpp
        .cost = [](const Problem& p, Accuracy a) { return (0.5 + 6.5 * std::pow(1.2 / (about_G(p) - 2), 2)) * growth(a, 2.5); },
        .enclose = by(Scheme::force_weighted),
        .budget = [](const Problem& p, Accuracy a) {
            return Budget{"", {{transfer::heavy_load_certificate(Scheme::force_weighted, p.n, arguments(p), a)}, {transfer::heavy_load_certificate(Scheme::area, p.n, arguments(p), looked_at_again(a))}}};
        },
        .second = "heavy-load-area",
        .enclose_again = by(Scheme::area),
        .shares = "lemmas 3 and 4 and the way the first scales are taken; every node is another, and below load ratio 1 so are grid, form of the step and rule",
    };
}

Ball by_proven_levels(const Problem& p, Accuracy a)
{
    const WorkingPrecision precision(256);
    const auto ratio = [&p] { return p.p.ball() / unit_pressure(p); };
    if (p.asked == Asked::area) return transfer::area_by_proven_levels(p.n, arguments(p), a);
    if (p.asked == Asked::exceedance) return transfer::exceedance_by_proven_levels(p.n, ratio, arguments(p), a);
    if (above_support(p)) return Ball(0);
    return transfer::density_by_proven_levels(p.n, ratio, arguments(p), a) / unit_pressure(p);
}

Budget proven_levels_budget(const Problem& p, Accuracy a)
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
std::string refusal_of_levels(const Problem& p, const LevelsReach& reach)
{
    if (p.n > reach.scales)
        return fmt::format("with full contact, {} are certified for n <= {} only", p.asked == Asked::density ? "densities" : "areas and exceedances", reach.scales);
    if (p.load > reach.load) return fmt::format("with full contact and so many digits, certified for load <= {} only", reach.load.get_str());
    if (!G_above(p, Rational(1003, 1000))) return "G too near 1 for the proven levels";
    const double G = about_G(p); // below: the first panel of the finest mesh begins above all ratios
    return 4 * p.load.get_d() < 1e-53 * G * G ? "load too small for the proven levels" : "";
}

const char* const witness_shares = "the wave (2.2), (2.4) and nothing else: grid, interpolation, quadrature and arithmetic are others; its error is an estimate";

Method proven_shares()
{
    return {
        .name = "proven-levels",
        .asked = {Asked::area, Asked::exceedance},
        .reach = fmt::format("1 <= n <= {}, load <= {}, G > 1.003", shares_reach.scales, shares_reach.load.get_str()),
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
bool pressure_too_low(const Problem& p)
{
    const WorkingPrecision precision(128);
    return !certainly(less(unit_pressure(p), 1024 * p.p.ball()));
}

Method proven_densities()
{
    return {
        .name = "proven-levels",
        .asked = {Asked::density},
        .reach = fmt::format("2 <= n <= {}, load <= {}, G > 1.003, p >= p*_n/1024", densities_reach.scales, densities_reach.load.get_str()),
        .refusal = [](const Problem& p) -> std::string {
            if (p.n < 2) return "n must be at least 2";
            if (p_is_0(p)) return no_density_at_0;
            if (const std::string refused = refusal_of_levels(p, densities_reach); !refused.empty()) return refused;
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

transfer::ThreeWaves after_three_waves(const Problem& p, Accuracy a)
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
        .reach = fmt::format("n = 2, load <= {}, G > 1.003, p >= p*_n/1024", densities_reach.load.get_str()),
        .refusal = [levels = proven_densities()](const Problem& p) -> std::string { return p.n == 2 ? levels.refusal(p) : "n must be 2"; },
        .digits = 22, // of the 31 of two binary64
        .cost = [](const Problem&, Accuracy a) { return 6 * growth(a, 2); },
        .enclose = [](const Problem& p, Accuracy a) {
            const WorkingPrecision precision(256);
            return above_support(p) ? Ball(0) : after_three_waves(p, a).value / unit_pressure(p);
        },
        .budget = [](const Problem& p, Accuracy a) { return Budget{above_support(p) ? "above the support" : after_three_waves(p, a).certificate}; },
        .second = "",
        .shares = witness_shares,
    };
}

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
    static const std::vector<Method> all{single_wave_area(),     single_wave_exceedance(), single_wave_density(), one_integral(),    second_area(), power_series(), partial_area(),
                                         partial_distribution(), heavy_load(),             proven_shares(),       third_wave_density(), proven_densities(), area_in_any_limit()};
    return all;
}

Accuracy looked_at_again(Accuracy wanted)
{
    constexpr long least = 10;
    return {std::max(std::min(wanted.digits, least), (wanted.digits + 1) / 2)};
}

const std::vector<Observer>& observers()
{
    static const std::vector<Observer> all{{"blind-halving", [](const Problem& p, Accuracy a) { return observe(Grid::blind, p, a); }},
                                           {"tracked-singular-points", [](const Problem& p, Accuracy a) { return observe(Grid::tracked, p, a); }}};
    return all;
}

std::string observers_reach(Asked asked) { return fmt::format("n <= {}, load from 1e-300 to 10^6, G > 1.000001", observed_scales(asked)); }

std::string observers_refusal(const Problem& p)
{
    if (p.n > observed_scales(p.asked))
        return p.asked == Asked::area ? fmt::format("not computed for n > {} where full contact occurs (G <= 2 or load > 1)", observed_scales(p.asked))
                                      : fmt::format("{} of pressure are computed for the scales n <= {} only", p.asked == Asked::density ? "densities" : "exceedances", observed_scales(p.asked));
    if (!G_above(p, Rational(1'000'001, 1'000'000))) return "not computed for G within 1e-6 of 1";
    if (p.load > 1'000'000 || p.load < power(Rational(10), -300)) return "not computed for loads outside 1e-300 to 1e6 where full contact occurs (G <= 2 or load > 1)";
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
        if (refused.empty() && digits < 1) refused = fmt::format("'{}' proves no digit of this: the inputs are too near an end of its reach", m.name);
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
                        m.second.empty() ? "witness " + (m.witness ? *m.witness : observers().front()).name : "proof " + m.second, m.shares});
    }
    rows.push_back({observers_reach(asked), fmt::format("{}", observed_digits), "", fmt::format("estimates {} and {}", observers()[0].name, observers()[1].name),
                    "the wave (2.2), (2.4) and nothing else: neither grid nor splitting rule nor quadrature"});
    return rows;
}

std::string reach_as_table()
{
    std::string text = "| value | where | digits | proof | second look | what the two share |\n|---|---|---|---|---|---|\n";
    constexpr const char* names[] = {"area", "exceedance", "density"};
    for (const Asked asked : {Asked::area, Asked::exceedance, Asked::density})
        for (const Reach& r : reach(asked))
            text += fmt::format("| {} | {} | {} | {} | {} | {} |\n", names[static_cast<int>(asked)], r.where, r.digits, r.proof.empty() ? "none" : "`" + r.proof + "`", r.second_look, r.shares);
    return text;
}

} // namespace touchstone::recursion
