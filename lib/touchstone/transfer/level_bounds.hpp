// SPDX-License-Identifier: MIT
/// \file
/// What the proofs of levels bound in binary64: numbers of 106 bits and their sums, the ratios that waves lead to, two roots next to one
/// another.
///
/// Internal to transfer/.
#pragma once

#include "touchstone/transfer/wide_balls.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace touchstone::transfer::levels {

/// At least, and at most, x > 0, whose upper part alone would be a rounding away.
inline double not_below(const DoubleDouble<double>& x) { return double(x) * (1 + 0x1p-50); }
inline double not_above(const DoubleDouble<double>& x) { return double(x) * (1 - 0x1p-50); }

/// Whether the ball is this number and no other.
inline bool is_exactly(const Ball& b, const DoubleDouble<double>& x)
{
    const Ball off = to_ball(x) - b;
    return off.is_exact() && off.contains_zero();
}

/// At least |x|, as bounds are computed.
inline double magnitude(const DoubleDouble<double>& x) { return std::fabs(x.high) * bounds::margin; }

/// What roundings take of a sum of so many positive terms, each of them within 64 u.
inline double rounding_of_sum(const DoubleDouble<double>& sum, std::size_t terms)
{
    return bounds::u * (static_cast<double>(terms) + 64) * std::fabs(sum.high);
}

/// At least the highest ratio that k waves lead to from ratios up to `highest`, k = 0 ... steps. \param G at most the true one
inline std::vector<double> highest_ratios(double highest, double G, int steps)
{
    std::vector<double> reach{highest};
    for (int k = 1; k <= steps; ++k) {
        const double y = reach.back();
        reach.push_back((y < 1 ? 2 * std::sqrt(y) / G : (y + 1) / G) * (1 + 0x1p-50));
    }
    return reach;
}

/// The integral of |y - s|^(-1/2) |y - e|^(-1/2) over |y - s| <= near is at most this, up to bounds::margin, where e is delta away from s:
/// pi between the two, and 2 arsinh (near/delta)^(1/2) at most on either side, where 4 arsinh t^(1/2) <= 2 log(4 t + 2).
inline double two_roots(double near, double delta) { return bounds::pi_below + 2 * std::log(4 * (1 + near / delta)); }

/// What that counts for where e moves by at least 1/G of x, on an interval of x of the given width, as TwoWaves::weight_on counts:
/// log(1/delta) counts as if delta were width/(2 G), plus 2.
inline double two_roots_on(double near, double width, double G)
{
    return two_roots(near, width) + 2 * (std::max(0.0, std::log(2 * G)) + 2);
}

} // namespace touchstone::transfer::levels
