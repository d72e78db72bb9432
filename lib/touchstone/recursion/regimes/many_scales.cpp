// SPDX-License-Identifier: MIT
/// \file
/// So many scales that the limit of docs/limit.md and its rate of approach give the digits: any load, full contact too.
#include "touchstone/recursion/regimes/regimes.hpp"

#include "touchstone/limit/area_constant.hpp"
#include "touchstone/limit/far_exceedance.hpp"

#include <fmt/format.h>

namespace touchstone::recursion {

static bool beyond_loads_of_limit(const Problem& p) { return p.load > 1'000'000 || p.load < power(Rational(10), -300); }

constexpr const char* shared_with_limit_law =
    "the wave (2.2), (2.4) and where it is not smooth: it goes forwards, to the limiting distribution; grid, quadrature and arithmetic are others";

/// Without full contact there are two proofs of areas up to here; with it, few scales leave no digits of the limit.
static long last_scale_before_limit(const Problem& p)
{
    const bool full_contact = p.load > 1 || p.compare_G(2) <= 0;
    return full_contact ? 20 : first_scale_of_limit;
}

/// docs/limit.md, theorem 1.
Method area_in_any_limit()
{
    return {
        .name = "limit-of-scales",
        .asked = {Asked::area},
        .reach =
            "n > 20 with full contact, n > 200 without, as far as the rate of approach leaves digits (n = 2000: 15 for G = 3/2, load = 1), 1e-300 <= load <= 10^6, 1.02 <= G < 10^9",
        .refusal = [](const Problem& p) -> std::string {
            if (const long first = last_scale_before_limit(p); p.n <= first) return fmt::format("no proof by the limit for n <= {}", first);
            if (beyond_loads_of_limit(p)) return "load must be from 1e-300 to 10^6";
            if (p.compare_G(Rational(51, 50)) < 0) return "the constant of the limit is certified for G = gamma^(D-1) >= 1.02 only";
            if (!G_below_10_9(p)) return "G = gamma^(D-1) must be below 10^9";
            const WorkingPrecision precision(128);
            return limit::most_digits_of_area_in_any_limit(p.n, Ball(p.load), p.G.ball()) > 0
                       ? ""
                       : "the limit is not reached at that scale, as far as its rate is proven";
        },
        .fewer_digits =
            [](const Problem& p) {
                const WorkingPrecision precision(128);
                return limit::most_digits_of_area_in_any_limit(p.n, Ball(p.load), p.G.ball());
            },
        .cost =
            [](const Problem& p, Accuracy a) {
                return G_above(p, Rational(2'000'001, 1'000'000)) ? 1.2 * growth(a, 2) : 2 + 10 * growth(a, 2.5);
            }, // of C(G), which is proven in two ways
        .enclose = [](const Problem& p, Accuracy a) { return limit::area_in_any_limit(p.n, arguments(p), a); },
        .budget =
            [](const Problem&, Accuracy) {
                return Budget{"A_n = G^-n load (C(G) +- 2 (m + G^2)^(1/2) (lambda^n d)^(1/2)), docs/limit.md, theorem 1"};
            },
        .witness = Observer{"limit-law", [](const Problem& p, Accuracy) { return limit::area_by_limit_law(p.n, arguments(p)); }},
        .shares = shared_with_limit_law,
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
        .reach = fmt::format(
            "n > {}, p*_n/1024 < p < the highest pressure of the limit, as far as the rate of approach leaves digits (n = 10^4: 15 for G = 3/2, load = 1), "
            "1e-300 <= load <= 10^6, 1.02 < G < 1000",
            last_scale_of_levels),
        .refusal = [](const Problem& p) -> std::string {
            if (p.n <= last_scale_of_levels) return fmt::format("no proof by the limit for n <= {}", last_scale_of_levels);
            if (beyond_loads_of_limit(p)) return "load must be from 1e-300 to 10^6";
            const WorkingPrecision precision(128);
            if (std::string refused = limit::no_far_exceedance(in_own_units(p), p.G.ball()); !refused.empty()) return refused;
            return limit::most_digits_of_far_exceedance(p.n, Ball(p.load), p.G.ball()) > 0
                       ? ""
                       : "the limit is not reached at that scale, as far as its rate is proven";
        },
        .digits = 15,
        .fewer_digits =
            [](const Problem& p) {
                const WorkingPrecision precision(128);
                return limit::most_digits_of_far_exceedance(p.n, Ball(p.load), p.G.ball());
            },
        .cost = [](const Problem&, Accuracy a) { return 2 + 10 * growth(a, 2.5); },
        .enclose = [](const Problem& p, Accuracy a) { return limit::far_exceedance(in_own_units(p), arguments(p), a); },
        .budget = [](const Problem& p, Accuracy a) { return Budget{limit::far_exceedance_certificate(in_own_units(p), arguments(p), a)}; },
        .witness = Observer{"limit-law",
                            [](const Problem& p, Accuracy) { return limit::far_exceedance_by_limit_law(in_own_units(p), arguments(p)); }},
        .shares = shared_with_limit_law,
    };
}

} // namespace touchstone::recursion
