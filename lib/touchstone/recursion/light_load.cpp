// SPDX-License-Identifier: MIT
#include "touchstone/recursion/light_load.hpp"

#include "touchstone/transfer/series.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace touchstone::recursion {
namespace {

constexpr double most_terms = 4000; ///< some ten seconds

/// Above, the discretised operator has two proofs in seconds.
Rational heaviest() { return power(Rational(10), -100); }

double terms(const Problem& p, Accuracy a)
{
    const WorkingPrecision precision(128);
    return transfer::terms_of_area_series(p.n, Ball(p.load), p.G.ball(), working_bits(a));
}

/// The most digits for which most_terms are enough.
long digits_of_series(const Problem& p)
{
    long least = 0, most = any_digits + 1; // served(least) or none is, not served(most)
    while (most - least > 1) {
        const long middle = (least + most) / 2;
        (terms(p, {middle}) <= most_terms ? least : most) = middle;
    }
    return least;
}

Ball enclose(const Problem& p, Accuracy a)
{
    const WorkingPrecision precision(working_bits(a));
    return transfer::area_series(p.n, Ball(p.load), p.G.ball());
}

} // namespace

double digits_lost_to_light_load(const Problem& p)
{
    const WorkingPrecision precision(64);
    const Ball digits = -log(Ball(p.load)) / log(Ball(10)) / 4;
    return std::max(0.0, arf_get_d(arb_midref(digits.get()), ARF_RND_NEAR));
}

Method power_series()
{
    return {
        .name = "power-series",
        .asked = {Asked::area},
        .reach = "n >= 2, load < 1e-100, 2.000001 <= G < 10^9, as far as 4000 terms go (n = 14 at load 1e-300)",
        .refusal = [](const Problem& p) -> std::string {
            if (p.n < 2) return "n must be at least 2";
            if (p.load >= heaviest()) return "load above 1e-100, where there are two proofs";
            if (p.compare_G(Rational(2'000'001, 1'000'000)) < 0 || p.compare_G(1'000'000'000) >= 0)
                return "the series is used for G from 2.000001 to 10^9";
            return p.n <= 20 && terms(p, {1}) <= most_terms ? "" : "the power series would take too many terms";
        },
        .fewer_digits = digits_of_series,
        .cost =
            [](const Problem& p, Accuracy a) {
                const double count = terms(p, a), digits = static_cast<double>(std::max(a.digits, 20L)) / 20;
                return digits * count * (1e-4 * static_cast<double>(p.n) + 5e-7 * count);
            },
        .enclose = enclose,
        .budget =
            [](const Problem& p, Accuracy a) {
                return Budget{fmt::format(
                    "the power series in the load, {:.0f} terms in balls, what is cut off bounded by Cauchy's inequality (transfer/series.hpp)",
                    terms(p, a))};
            },
        .second = "",
        .shares =
            "the wave (2.2), (2.4) and nothing else: the series has no grid, no quadrature and no interpolation; the witness's error is an estimate",
    };
}

} // namespace touchstone::recursion
