// SPDX-License-Identifier: MIT
/// Full contact at every load and scale of figures 3 and 4, and where the chain stays long in full contact.
#include "touchstone/paper/peaks.hpp"
#include "touchstone/transfer/full_contact.hpp"
#include "touchstone/recursion/first_steps/scale_one.hpp"
#include "touchstone/transfer/singular_points.hpp"

#include <boost/math/quadrature/tanh_sinh.hpp>
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace touchstone;
using namespace touchstone::transfer;

namespace {

Rational exactly(const char* text) { return *parse_rational(text); }

double number(const Ball& b) { return arf_get_d(arb_midref(b.get()), ARF_RND_NEAR); }

double apart(const Ball& a, const Ball& b) { return std::fabs(number(a / b - 1)); }

} // namespace

TEST_CASE("the two grids agree to 1e-17 up to n = 20")
{
    const WorkingPrecision precision(256);
    for (const char* G : {"1.0838", "1.12", "1.01", "1.9", "2", "2.2360679774997896"})
        for (const char* load : {"1e-12", "0.001", "0.1", "1", "10"})
            for (long n = 1; n <= 20; ++n) {
                CAPTURE(G); CAPTURE(load); CAPTURE(n);
                const Ball x(*parse_rational(load)), g(*parse_rational(G));
                const Ball off = abs(estimated_area(Grid::blind, n, x, g).value / estimated_area(Grid::tracked, n, x, g).value - 1);
                CHECK(certainly(less(off, Ball::exactly(1e-17))));
            }
}

TEST_CASE("scale 2: both grids against one more integral over scale 1, cut at all singular points")
{
    // Q_2(p) = (1/pi) int_0^pi Q_1(G^2 x) dtheta, q_2 = (1/pi) int q_1(G^2 x) (dx/dP) dtheta; u = 1 + cos(theta), x(u) as in scale_one.hpp
    const double pi = 4 * std::atan(1.0);
    boost::math::quadrature::tanh_sinh<double> rule(12);
    const auto at = [](const Rational& p, const Rational& load, const Rational& G) -> ScaleOne {
        return {[p] { return Ball(p); }, load, [G] { return Ball(G); }, p, G};
    };
    for (const auto& [load, G, p] :
         {std::tuple{"3", "1.5", "2.2"}, {"1", "2", "0.9"}, {"0.5", "1.2", "1.1"}, {"1.000001", "1.9999999", "3"}}) {
        CAPTURE(load); CAPTURE(G); CAPTURE(p);
        const WorkingPrecision precision(80);
        const Rational g = exactly(G);
        const double P = Rational(exactly(p) / (g * g)).get_d();
        std::vector<double> cuts{0, pi};
        std::vector<SingularPoint> points = exceedance_points(Ball(exactly(load)), Ball(g), {Ball(8), 2, 1e-15});
        for (const SingularPoint& point : points) {
            const double s = number(point.position), c = s >= 1 ? P - s : std::hypot(1 - s, P) - s;
            if (std::fabs(c) < 1) cuts.push_back(std::acos(c));
        }
        std::sort(cuts.begin(), cuts.end());
        const auto mean = [&](bool density) {
            double sum = 0;
            for (std::size_t i = 1; i < cuts.size(); ++i) {
                if (cuts[i] - cuts[i - 1] < 1e-12) continue;
                const auto f = [&](double theta) {
                    const double u = 2 * std::pow(std::cos(theta / 2), 2), x = u <= P ? P + 1 - u : 1 - (u - P) * (u + P) / (2 * u);
                    if (x <= 0) return 0.0;
                    const ScaleOne q = at(Rational(x) * g * g, exactly(load), g);
                    const Ball value = density ? scale_one_density(Variable::ratio, q) : scale_one_exceedance(Variable::ratio, q);
                    return number(value) * (density && u > P ? P / u : 1);
                };
                sum += rule.integrate(f, cuts[i - 1], cuts[i], 1e-11);
            }
            return sum / pi;
        };
        const double Q = mean(false), q = mean(true);
        for (const Grid grid : {Grid::blind, Grid::tracked}) {
            CHECK(apart(estimated_exceedance(grid, 2, Ball(exactly(p)), Ball(exactly(load)), Ball(g)).value, Ball::exactly(Q)) < 1e-13);
            CHECK(apart(estimated_density(grid, 2, Ball(exactly(p)), Ball(exactly(load)), Ball(g)).value, Ball::exactly(q)) < 1e-9);
        }
    }
}

TEST_CASE(
    "distributions everywhere: no nan, no refusal, each grid off by no more than it says, at seams, singular points, ends, and p -> 0")
{
    const WorkingPrecision precision(256);
    const char* loads[] = {"0.001", "0.1", "0.999999", "1", "1.000001", "1.5", "2", "10", "100"};
    for (const char* G_text : {"1.05", "1.2", "1.5", "1.9999999", "2", "2.0000001", "2.5", "3.16"})
        for (const char* load_text : loads)
            for (const long n : {1L, 2L, 3L, 6L}) {
                const Ball G(exactly(G_text)), load(exactly(load_text));
                Ball unit;
                arb_pow_ui(unit.get(), G.get(), static_cast<ulong>(n + 1), 256);
                const Ball top = unit * peaks::iterate(n, load, G);
                std::vector<Ball> pressures{Ball(exactly("1e-300")), Ball(exactly("1e-9"))};
                for (const char* share : {"0.001", "0.05", "0.2", "0.45", "0.7", "0.9", "0.999", "0.999999"})
                    pressures.push_back(Ball(exactly(share)) * top);
                const auto points = exceedance_points(load, G, {Ball((load + 1) / G + 2), static_cast<int>(std::min(n + 1, 3L)), 1e-18});
                for (std::size_t i = 0; i < points.size(); i += 1 + points.size() / 8)
                    for (const char* off : {"0", "1e-3", "-1e-3", "1e-9", "-1e-9", "1e-30"})
                        if (const Ball p = unit * points[i].position * (1 + Ball(exactly(off))); certainly(less(p, top)))
                            pressures.push_back(p);
                for (const Ball& p : pressures)
                    for (const bool density : {false, true}) {
                        CAPTURE(G_text); CAPTURE(load_text); CAPTURE(n); CAPTURE(number(p)); CAPTURE(density);
                        Witness e[2];
                        for (const Grid grid : {Grid::blind, Grid::tracked})
                            e[grid == Grid::tracked] =
                                density ? estimated_density(grid, n, p, load, G) : estimated_exceedance(grid, n, p, load, G);
                        const double off = number(abs(e[0].value - e[1].value)), claimed = number(e[0].error + e[1].error),
                                     size = std::fabs(number(e[0].value));
                        if (!density) CHECK(off < 64 * claimed + 1e-17 * size + 1e-19);
                        // 0.3 of what is not resolved at all, within 1e-16 of a singular point or 1e-12 of the value next to the upper end
                        else CHECK(off < 64 * claimed + 1e-12 * size + 1e-10);
                    }
            }
}
