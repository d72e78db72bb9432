// SPDX-License-Identifier: MIT
#include "touchstone/recursion/regimes/regimes.hpp"

#include "touchstone/limit/area_constant.hpp"
#include "touchstone/recursion/from_the_edge/forward.hpp"
#include "touchstone/recursion/light_load.hpp"
#include "touchstone/scalar/refusal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace touchstone::recursion {

using transfer::Law, transfer::Scheme;

// ---- partial contact at every scale

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
            return p.compare_G(Rational(2'000'001, 1'000'000)) < 0
                       ? "no proof for G = gamma^(D-1) <= 2, where some regions stay in full contact at every scale"
                       : "";
        },
        .fewer_digits =
            [](const Problem& p) {
                const WorkingPrecision precision(128);
                if (p.n > last_followed_scale) return digits_of_limit(p);
                return transfer::most_digits_of_area(Ball(p.load), p.G.ball());
            },
        .cost = [](const Problem& p,
                   Accuracy a) { return 0.2 * growth({a.digits + static_cast<long>(digits_lost_to_light_load(p))}, 2.5); },
        .enclose = by(Scheme::force_weighted),
        .budget =
            [](const Problem& p, Accuracy a) {
                if (in_the_limit(p, a))
                    return Budget{"A_n = C(G) G^-n load (1 +- delta_n), docs/limit.md, theorem 2",
                                  {{limit::area_constant_certificate(Scheme::force_weighted, p.G.ball, a)}}};
                return Budget{"",
                              {{transfer::area_certificate(Scheme::force_weighted, p.n, arguments(p), a)},
                               {transfer::area_certificate(Scheme::area, p.n, arguments(p), looked_at_again(a))}}};
            },
        .second = "area-gauss-panels",
        .enclose_again = by(Scheme::area),
        .shares =
            "lemmas 1 and 2 of the operator, the fixed-point arithmetic and how errors add; neither grid, variable, form of the step nor quadrature rule",
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
            return p.asked == Asked::exceedance ? transfer::exceedance(law, p.n, p.p.ball, arguments(p), a)
                                                : transfer::density(law, p.n, p.p.ball, arguments(p), a);
        };
    };
    return {
        .name = "forward-density",
        .asked = {Asked::exceedance, Asked::density},
        .reach = fmt::format("1 <= n <= {}, load <= 1, G > 2 + 1e-12, no p_k^max within 0.2% below p*_(k+1)", transfer::Forward::largest_n),
        .refusal = [](const Problem& p) -> std::string {
            if (p.n < 1) return "n must be at least 1";
            if (p.load > 1) return "no proof for load > 1, where the first scale is in full contact";
            if (!G_above(p, 2)) return "no proof for G = gamma^(D-1) <= 2, where some regions stay in full contact at every scale";
            if (!G_above(p, 2 + power(Rational(10), -12)))
                return "no proof for G = gamma^(D-1) so near 2: boxes are searched for in binary64, which must tell it from 2";
            if (p.n > transfer::Forward::largest_n)
                return fmt::format("distributions of pressure are computed for the scales n <= {} only", transfer::Forward::largest_n);
            if (p_is_0(p)) return no_density_at_0;
            return edges_clear_of_1(p) ? "" : "some scale's highest pressure is too near p*: the region of analyticity is too narrow";
        },
        .digits = 290,
        .fewer_digits =
            [](const Problem& p) {
                try {
                    return above_support(p) ? any_digits
                                            : transfer::most_digits_of_distribution(p.n, p.p.ball, arguments(p), p.asked == Asked::density);
                }
                catch (const BeyondReach&) { // p cannot be told from the edge: enclose() says so
                    return any_digits;
                }
            },
        .cost = [](const Problem& p, Accuracy a) { return 0.25 * static_cast<double>(p.n) * growth(a, 2); },
        .enclose = by(Law::density),
        .budget =
            [](const Problem& p, Accuracy a) {
                if (above_support(p)) return Budget{"above the support"};
                return Budget{"",
                              {{transfer::distribution_certificate(Law::density, p.n, p.p.ball, arguments(p), a)},
                               {transfer::distribution_certificate(Law::exceedance, p.n, p.p.ball, arguments(p), looked_at_again(a))}}};
            },
        .second = "forward-exceedance",
        .enclose_again = by(Law::exceedance),
        .shares =
            "boxes, panels, quadrature and arithmetic of one engine; the recursion of another law: kernel, closed first step and unknown are others",
    };
}

} // namespace touchstone::recursion
