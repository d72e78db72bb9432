// SPDX-License-Identifier: MIT
#include "touchstone/recursion/from_the_edge/far_end.hpp"

#include <numbers>

namespace touchstone::transfer::from_the_edge {

double next_tail(long k, const Ball& edge_bound, double tail, double load)
{
    const double k2 = up(4 / std::numbers::pi * std::pow(1 - above(edge_bound), -1.5));
    if (k == 1) {
        const double a = up(std::min(std::pow(2 * std::sqrt(load), -1.5), std::pow(std::max(0.0, 1 - load), -1.5)));
        return 8 * a / std::numbers::pi * k2 * 1.43;
    }
    return up(std::exp(-2.0) * k2 * (1.01 * std::exp(6.0) + 4.1 * std::exp(-4.0) * tail));
}

double cut_for_small(double accuracy, long n, const Ball& G, const Ball& load)
{
    const WorkingPrecision low(bound_bits);
    Ball edge = 2 / G * sqrt(load);
    double tail = infinity;
    for (long k = 1; k < n; ++k) {
        tail = next_tail(k, edge, tail, about(load));
        edge = 2 / G * sqrt(edge);
    }
    return (accuracy + std::log(3.5 * std::exp(2.0) * tail) + (n == 2 ? std::log(accuracy) - 1 : 0)) / 2;
}

bool small_for(double accuracy, long n, double d, const Ball& G, const Ball& load)
{
    return n >= 2 && 2 * d > cut_for_small(accuracy, n, G, load) + 1.02;
}

double accuracy_for_small(double accuracy, long n, double d, const Ball& G, const Ball& load)
{
    const double cut = 4.0 / 3 * cut_for_small(accuracy, n, G, load), levels = 4 * std::ceil((accuracy + cut / 2) / 4);
    return small_for(levels, n, d, G, load) ? levels : 0;
}

} // namespace touchstone::transfer::from_the_edge
