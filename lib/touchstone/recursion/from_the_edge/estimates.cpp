// SPDX-License-Identifier: MIT
#include "touchstone/recursion/from_the_edge/levels.hpp"

namespace touchstone::transfer::from_the_edge {

double Levels::kernel_d(double e, double d, double s) const
{
    const double x = e * std::exp(-2 * d * s), D = 2 * d * (1 - s), R = std::sqrt((1 - x) * (1 - x) + 4 * e * std::exp(-2 * d));
    const double E = D > 1e-9 ? -std::expm1(-D) / D : 1, P = 1 + x + R, M = 1 - x + R;
    return std::sqrt(law == Law::density ? P / (M * E) : P * M / E) / R;
}

void Levels::estimate_first(Level& level) const
{
    for (int i = -60; i <= 60; ++i) {
        const double d = std::exp2(0.5 * i);
        if (d > 2 * delta_max) break;
        const double x = load_d, R = full ? 2 * std::exp(-d) : std::sqrt((1 - x) * (1 - x) + 4 * x * std::exp(-2 * d));
        const double E = -std::expm1(-2 * d) / (2 * d), P = 1 + x + R;
        const double v = law == Law::density ? std::sqrt(P / ((1 - x + R) * E)) / R
                                             : std::asin(std::min(1.0, std::sqrt(2 * x * 2 * d * E / P))) / std::sqrt(2 * d);
        if (!std::isfinite(v)) break;
        level.log_d.push_back(std::log(d));
        level.log_v.push_back(std::log(v));
    }
}

double Levels::estimate(const Level& level, double d) const
{
    const double t = std::log(std::max(d, 1e-300));
    const auto it = std::lower_bound(level.log_d.begin(), level.log_d.end(), t);
    if (it == level.log_d.begin()) return std::exp(level.log_v.front());
    if (it == level.log_d.end()) return std::exp(level.log_v.back());
    const auto i = static_cast<std::size_t>(it - level.log_d.begin());
    const double f = (t - level.log_d[i - 1]) / (level.log_d[i] - level.log_d[i - 1]);
    return std::exp(level.log_v[i - 1] + f * (level.log_v[i] - level.log_v[i - 1]));
}

double Levels::estimate_step(const Level& from, double d) const
{
    const double e = about(from.edge);
    const long m = power(from.k);
    double sum = 0, weight = 0;
    for (int i = 0; i < 60; ++i) {
        const double theta = std::numbers::pi / 2 * (i + 0.5) / 60, s = std::pow(std::sin(theta), 2),
                     w = std::pow(std::sin(theta), static_cast<double>(m));
        weight += w;
        sum += w * kernel_d(e, d, s) * std::exp(-beta * 2 * d * s) * estimate(from, 2 * d * s);
    }
    return sum / weight;
}

double Levels::estimate_share(const Level& from, double d) const
{
    const double e = about(from.edge);
    double sum = 0, weight = 0;
    for (int i = 0; i < 60; ++i) {
        const double theta = std::numbers::pi / 2 * (i + 0.5) / 60, s = std::pow(std::sin(theta), 2),
                     w = std::pow(std::sin(theta), static_cast<double>(power(from.k)));
        const double delta = 2 * d * s, x = e * std::exp(-delta), R = std::sqrt((1 - x) * (1 - x) + 4 * e * std::exp(-2 * d));
        const double z2 = -2 * x * std::expm1(-2 * d * (1 - s)) / (1 + x + R);
        weight += w;
        sum += w * std::cos(theta) * std::asin(std::sqrt(std::min(z2, 1.0))) * std::exp(-2 * delta) * estimate(from, delta);
    }
    return sum / weight;
}

} // namespace touchstone::transfer::from_the_edge
