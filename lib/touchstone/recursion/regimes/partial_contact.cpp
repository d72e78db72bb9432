// SPDX-License-Identifier: MIT
#include "touchstone/recursion/regimes/regimes.hpp"

#include "touchstone/limit/area_constant.hpp"
#include "touchstone/limit/far_exceedance.hpp"
#include "touchstone/recursion/from_the_edge/forward.hpp"
#include "touchstone/recursion/light_load.hpp"
#include "touchstone/scalar/refusal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace touchstone::recursion {

using transfer::Law, transfer::Scheme;

// ---- partial contact at every scale

/// From here on they are taken from the limit where it leaves the digits asked for: docs/limit.md, theorem 2.
constexpr long first_scale_of_limit = 200;

static long digits_of_limit(const Problem& p)
{
    const WorkingPrecision precision(128);
    return limit::most_digits_of_area_in_the_limit(p.n, Ball(p.load), p.G.ball());
}
static bool in_the_limit(const Problem& p, Accuracy a)
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
        .budget = [](const Problem&, Accuracy) { return Budget{"A_n = G^-n load (C(G) +- 2 (m + G^2)^(1/2) (lambda^n d)^(1/2)), docs/limit.md, theorem 1"}; },
        .witness = Observer{"limit-law", [](const Problem& p, Accuracy) { return limit::area_by_limit_law(p.n, arguments(p)); }},
        .shares = "the wave (2.2), (2.4) and where it is not smooth: it goes forwards, to the limiting distribution; grid, quadrature and arithmetic are others",
    };
}

static limit::FarPressure in_own_units(const Problem& p)
{
    return {p.n, [&p] { return p.p.ball() / unit_pressure(p); }};
}

/// Scales whose exceedances levels are computed for, with full contact too.
constexpr long last_scale_of_levels = 100;

/// Beyond the levels: docs/limit.md, theorem 7.
Method exceedance_in_any_limit()
{
    return {
        .name = "limiting-distribution",
        .asked = {Asked::exceedance},
        .reach = fmt::format("n > {}, p*_n/1024 < p < the highest pressure of the limit, as far as the rate of approach leaves digits (n = 10^4: 15 for G = 3/2, load = 1), "
                             "1e-300 <= load <= 10^6, 1.02 < G < 1000", last_scale_of_levels),
        .refusal = [](const Problem& p) -> std::string {
            if (p.n <= last_scale_of_levels) return fmt::format("no proof by the limit for n <= {}", last_scale_of_levels);
            if (p.load > 1'000'000 || p.load < power(Rational(10), -300)) return "load must be from 1e-300 to 10^6";
            const WorkingPrecision precision(128);
            if (std::string refused = limit::no_far_exceedance(in_own_units(p), p.G.ball()); !refused.empty()) return refused;
            return limit::most_digits_of_far_exceedance(p.n, Ball(p.load), p.G.ball()) > 0 ? "" : "the limit is not reached at that scale, as far as its rate is proven";
        },
        .digits = 15,
        .fewer_digits = [](const Problem& p) {
            const WorkingPrecision precision(128);
            return limit::most_digits_of_far_exceedance(p.n, Ball(p.load), p.G.ball());
        },
        .cost = [](const Problem&, Accuracy a) { return 2 + 10 * growth(a, 2.5); },
        .enclose = [](const Problem& p, Accuracy a) { return limit::far_exceedance(in_own_units(p), arguments(p), a); },
        .budget = [](const Problem& p, Accuracy a) { return Budget{limit::far_exceedance_certificate(in_own_units(p), arguments(p), a)}; },
        .witness = Observer{"limit-law", [](const Problem& p, Accuracy) { return limit::far_exceedance_by_limit_law(in_own_units(p), arguments(p)); }},
        .shares = "the wave (2.2), (2.4) and where it is not smooth: it goes forwards, to the limiting distribution; grid, quadrature and arithmetic are others",
    };
}

/// Whether no highest ratio e_k, (5.6), k <= n, is so near 1 that what is left of the levels' sector is too narrow (measured: from 0.999 on
/// they refuse). Only a choice between proofs, hence in binary64.
static bool edges_clear_of_1(const Problem& p)
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

} // namespace touchstone::recursion
