// SPDX-License-Identifier: GPL-3.0-or-later
/// How wrong the two area laws are in the limit: (7.21), and the one with four terms of the series in 4/G^2 (docs/limit.md, theorem 3).
#include "verify/figures/figure.hpp"
#include "verify/figures/tables.hpp"

#include "touchstone/paper/archard_constants.hpp"

namespace touchstone::figures {
namespace {

constexpr double last_G = 100;
const Rational proven_from(3);

/// What the law for use puts in the bracket of (7.21): the coefficients to the six decimals it is stated with.
Ball bracket(const Ball& e)
{
    Ball sum(0);
    for (const int millionths : {5790, 12173, 37321, 208379}) sum = (sum + Ball(Rational(millionths, 1'000'000))) * e;
    return sum + Ball(1);
}

/// What is proven of that from G = 3 on: four terms leave 0.01 e^5, their decimals 10^-6 e.
Ball bound(const Ball& e) { return Ball(Rational(1, 100)) * pow(e, Ball(5)) + Ball(Rational(1, 1'000'000)) * e; }

} // namespace

Figure area_laws()
{
    const WorkingPrecision precision(192);
    Figure f{
        "area-laws",
        "How wrong the area laws are at large n",
        "Relative error of the contact area at large n, A_n/λ0 ≈ K_∞ G^(1−n) p̃ times a bracket, G = γ^(D−1): with 1 for the bracket, which is (7.21), and with "
        "1 + 0.208379 e + 0.037321 e² + 0.012173 e³ + 0.005790 e⁴, e = 4/G², against the certified constant of the limit. In the paper's cases with D = 1.5 (7.21) is "
        "off by 17 % (γ = 5) and by 8 % (γ = 10) of the area, the second law by 0.2 % and 0.004 %. The dotted line is what is proven of the second from G = 3 on. Below G = 2, where full contact never ends, "
        "the series does not converge and only (7.21) is drawn.",
        "Relative error against G on logarithmic axes: that of (7.21) falls slowly, like 0.8/G squared, that of the four-term law like G to the power -10 until its six decimals tell.",
        {},
        1,
        380};
    Panel p{"",
            "error",
            {"{/:Italic G} = γ^{{/:Italic D}−1}", 1, last_G, true},
            {"relative error of the area", 1e-10, 1, true},
            {},
            {},
            {},
            above_all};
    Curve print{"(7.21)", "(7.21)", Style::marked_line, 1, {}},
        improved{"four terms", "four terms in 4/{/:Italic G}²", Style::marked_line, 3, {}},
        proven{"proven of four terms", "proven of four terms", Style::dotted, grey, {}};
    const Ball K = archard::K_gamma_product(archard::infinity);
    for (const char* table : {"limit_constant_full", "limit_constant"}) {
        const Data constants(table);
        for (const auto& row : constants.rows()) {
            const double at = row.inputs[0];
            if (at > last_G) continue;
            const Ball G = Ball::exactly(at), C = constants.ball(row), e = Ball(4) / (G * G);
            print.points.push_back(certified(at, abs(K * G / C - 1)));
            if (at <= 2) continue;
            improved.points.push_back(certified(at, abs(K * G * bracket(e) / C - 1)));
            if (certainly(less(G, Ball(proven_from)))) continue;
            proven.points.push_back(certified(at, bound(e)));
        }
    }
    p.curves = {std::move(print), std::move(improved), std::move(proven)};
    f.panels = {std::move(p)};
    return f;
}

} // namespace touchstone::figures
