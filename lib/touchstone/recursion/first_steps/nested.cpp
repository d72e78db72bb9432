// SPDX-License-Identifier: MIT
#include "touchstone/recursion/first_steps/nested.hpp"

#include <boost/math/quadrature/tanh_sinh.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace touchstone::transfer {
namespace {

constexpr double pi = 3.14159265358979323846, tolerance = 1e-9;

/// The angle at which a wave of mean x is at y; negative if it isn't anywhere.
double angle_at(double x, double G, double y)
{
    if (x >= 1) return std::fabs(G * y - x) < 1 ? std::acos(G * y - x) : -1;
    const double c = G * y / 2 * (G * y / 2) / x; // (1 - q)(1 - x q), q = sin^2
    return c < 1 ? std::asin(std::sqrt(2 * (1 - c) / (1 + x + std::sqrt((1 - x) * (1 - x) + 4 * x * c)))) : -1;
}

/// (T f)(x), f having these singular points.
template <class F>
double average(F f, double x, double G, std::initializer_list<double> singular)
{
    static boost::math::quadrature::tanh_sinh<double> rule(10);
    const bool full = x >= 1;
    std::vector<double> cuts{0, full ? pi : pi / 2};
    for (const double s : singular)
        if (const double t = angle_at(x, G, s); t > cuts.front() && t < cuts[1]) cuts.push_back(t);
    std::sort(cuts.begin(), cuts.end());
    const auto weighted = [&](double t) {
        if (full) return f((x + std::cos(t)) / G) / pi;
        const double c = std::cos(t), r = std::sqrt(1 - x * (1 - c * c));
        return r > 0 ? 2 / pi * std::sqrt(x) * f(2 / G * std::sqrt(x) * r * c) * c / r : 0.0;
    };
    double sum = 0;
    for (std::size_t k = 0; k + 1 < cuts.size(); ++k)
        if (cuts[k + 1] - cuts[k] > 1e-14) sum += rule.integrate(weighted, cuts[k], cuts[k + 1], tolerance);
    return sum;
}

double first_area(double y) { return y < 1 ? 2 / pi * std::asin(std::sqrt(std::max(y, 0.0))) : 1; }

} // namespace

std::pair<double, double> nested_area(double load, double G)
{
    const auto second = [G](double y) { return average(first_area, y, G, {1}); };
    const double value = average(second, load, G, {1, G * G / 4, G - 1, G + 1});
    return {value, 1e-10 * value};
}

} // namespace touchstone::transfer
