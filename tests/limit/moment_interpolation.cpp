// SPDX-License-Identifier: MIT
/// Polynomials for moments (docs/limit.md, theorem 3): what they are said to be off by, against Lebesgue's constant by trying and a
/// function with a pole.
#include "touchstone/limit/moment_interpolation.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace touchstone;
using namespace touchstone::limit;

namespace {

double number(const Ball& b) { return arf_get_d(arb_midref(b.get()), ARF_RND_NEAR); }

/// sum c_k T_k(t)
double sum_at(const Balls& c, double t)
{
    double total = 0;
    for (std::size_t k = 0; k < c.size(); ++k) total += number(c[k]) * std::cos(static_cast<double>(k) * std::acos(t));
    return total;
}

/// sup of sum_i |l_i(t)|, l_i the polynomial that is 1 at point i and 0 at the others
double lebesgue(const MomentInterpolation& grid)
{
    std::vector<Balls> each;
    for (int i = 0; i < grid.points(); ++i) {
        Balls values(static_cast<std::size_t>(grid.points()), Ball(0));
        values[static_cast<std::size_t>(i)] = Ball(1);
        each.push_back(grid.series(values).c);
    }
    double most = 0;
    for (int j = 0; j <= 400; ++j) {
        double total = 0;
        for (const Balls& c : each) total += std::fabs(sum_at(c, std::cos(j * 0.0078539816)));
        most = std::max(most, total);
    }
    return most;
}

} // namespace

TEST_CASE("errors of the values come to Lebesgue's constant times as much, and to little more")
{
    const WorkingPrecision precision(128);
    for (const int top : {2, 8}) {
        const MomentInterpolation grid(top, 12);
        Balls values(static_cast<std::size_t>(grid.points()), Ball(0));
        const Ball exact = grid.series(values).error;
        for (Ball& v : values) v = within(Ball(3), Ball::exactly(1e-9));
        const double said = number(grid.series(values).error) / 1e-9, constant = lebesgue(grid);
        CHECK(number(exact) == 0);
        CHECK(said >= constant);
        CHECK(said <= 2 * constant);
    }
}

TEST_CASE("a function with a pole just beyond the ellipse is off by less than is said, and not by much less")
{
    const WorkingPrecision precision(128);
    const int top = 4;
    for (const double digits : {6., 9.}) {
        const MomentInterpolation grid(top, digits);
        const double pole = to_pole + 0.02, bound = pole - to_pole; // |bound/(a + pole)| <= 1 on the ellipse, which ends at -to_pole
        Balls values;
        for (int i = 0; i < grid.points(); ++i) values.push_back(Ball::exactly(bound) / (grid.point(i) + Ball::exactly(pole)));
        CHECK(number(grid.point(0)) == -1);
        CHECK(number(grid.point(grid.points() - 1)) == top);
        const Balls c = grid.series(values).c;
        double off = 0;
        for (int j = 0; j <= 1000; ++j) {
            const double t = std::cos(j * 0.0031415926), a = (top - 1) / 2. + (top + 1) / 2. * t;
            off = std::max(off, std::fabs(sum_at(c, t) - bound / (a + pole)));
        }
        CHECK(off <= number(grid.error()));
        CHECK(off >= number(grid.error()) / 500);
        CHECK(number(grid.error()) <= std::pow(10, -digits));
    }
}

TEST_CASE("polynomials at a ball hold those at its points")
{
    const WorkingPrecision precision(64);
    const MomentInterpolation grid(5, 15);
    for (const double a : {-1., -0.3, 2., 4.9, 5.})
        for (const double radius : {0., 1e-12, 1e-4}) {
            const Balls T = grid.polynomials(within(Ball::exactly(a), Ball::exactly(radius)));
            REQUIRE(static_cast<int>(T.size()) == grid.points());
            for (const double at : {a - radius, a, a + radius}) {
                const double t = (at - 2) / 3;
                if (std::fabs(t) > 1) continue;
                for (std::size_t k = 0; k < T.size(); ++k) {
                    const double true_value = std::cos(static_cast<double>(k) * std::acos(t));
                    CHECK(std::fabs(true_value - number(T[k])) <= T[k].radius_bound() + 1e-12);
                }
            }
            const double last = static_cast<double>(T.size() - 1);
            CHECK(T.back().radius_bound() <= last * last * (radius / 3 + 1e-17) * 1.01);
            CHECK(T.back().radius_bound() >= last * last * radius / 3);
        }
}
