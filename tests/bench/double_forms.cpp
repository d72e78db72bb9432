// SPDX-License-Identifier: MIT
/// \file
/// What the double forms cost beside the printed ones, written as a user would, on random points of partial contact (p <= 2 sqrt(load), x
/// in the contact or, for the gap, beside it) and, for the second exceedance, of full contact. Best of many passes over 8192 points.
///     bench_double_forms
#include "touchstone/paper/as_printed.hpp"
#include "touchstone/paper/gap.hpp"
#include "touchstone/paper/westergaard.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <limits>
#include <random>
#include <vector>

using namespace touchstone;

namespace {

struct Point {
    double load, pressure, inside, beside;
};

double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// Nanoseconds an evaluation.
template <class F>
double cost(const std::vector<Point>& points, F f)
{
    constexpr int passes = 20;
    double best = std::numeric_limits<double>::infinity();
    for (int repeat = 0; repeat < 40; ++repeat) {
        const double start = cpu_seconds();
        double sum = 0;
        for (int pass = 0; pass < passes; ++pass)
            for (const Point& point : points) sum += f(point);
        best = std::min(best, cpu_seconds() - start);
        if (std::isnan(sum)) std::puts("no number"); // and so the sum is needed
    }
    return best / (passes * static_cast<double>(points.size())) * 1e9;
}

template <class Ours, class Printed>
void compare(const char* name, const std::vector<Point>& points, Ours ours, Printed printed)
{
    const double a = cost(points, ours), b = cost(points, printed);
    std::printf("%-24s %6.1f ns, as printed %6.1f ns, ratio %.2f\n", name, a, b, a / b);
}

} // namespace

int main()
{
    std::mt19937_64 random(20261123);
    std::uniform_real_distribution<double> unit(0, 1);
    std::vector<Point> points(8192);
    for (Point& p : points) {
        p.load = unit(random);
        const double a = std::asin(std::sqrt(p.load)) / M_PI;
        p.pressure = 2 * std::sqrt(p.load) * unit(random);
        p.inside = a * unit(random);
        p.beside = a + (0.5 - a) * unit(random);
    }
    compare(
        "half_width", points, [](const Point& p) { return westergaard::half_width(p.load); },
        [](const Point& p) { return as_printed::half_width(p.load); });
    compare("pressure", points, [](const Point& p) { return westergaard::pressure(p.inside, p.load); },
            [](const Point& p) { return as_printed::pressure_partial(p.inside, p.load); });
    compare("exceedance", points, [](const Point& p) { return westergaard::exceedance(p.pressure, p.load); },
            [](const Point& p) { return as_printed::exceedance_partial(p.pressure, p.load); });
    compare("exceedance, full contact", points, [](const Point& p) { return westergaard::exceedance(p.load + p.pressure, 1 + p.load); },
            [](const Point& p) { return as_printed::exceedance_full(p.load + p.pressure, 1 + p.load); });
    compare("density", points, [](const Point& p) { return westergaard::density(p.pressure, p.load); },
            [](const Point& p) { return as_printed::density_partial(p.pressure, p.load); });
    compare("gap", points, [](const Point& p) { return westergaard::gap(p.beside, p.load); }, [](const Point& p) {
        const double v = std::sin(M_PI * p.beside), w = std::sqrt(v * v - p.load);
        return 2 * (v * w - p.load * std::log((v + w) / std::sqrt(p.load)));
    });
    compare("mean_gap", points, [](const Point& p) { return westergaard::mean_gap(p.load); },
            [](const Point& p) { return 1 - p.load + p.load * std::log(p.load); });
}
