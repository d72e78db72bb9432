// SPDX-License-Identifier: MIT
/// \file
/// Between balls and numbers of 106 bits, and what bounds in binary64 are made with. Internal to transfer/.
#pragma once

#include "touchstone/scalar/ball.hpp"
#include "touchstone/transfer/wave_kernel.hpp"

#include <cmath>
#include <limits>

namespace touchstone::transfer {

namespace bounds {
constexpr double u = 0x1p-101; // twice the largest relative error of one operation on 106 bits
constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double pi_below = 3.14159265358979311;
constexpr double margin = 1.001; // on bounds that are themselves computed with roundings
} // namespace bounds

inline Ball to_ball(const DoubleDouble<double>& x)
{
    if (!std::isfinite(x.high)) return Ball::indeterminate();
    const WorkingPrecision precision(256);
    return Ball::exactly(x.high) + Ball::exactly(x.low);
}

/// The midpoint, within 2^-101 of it.
inline DoubleDouble<double> to_real(const Ball& x)
{
    const WorkingPrecision precision(256);
    const double high = arf_get_d(arb_midref(x.get()), ARF_RND_NEAR);
    const Ball rest = x - Ball::exactly(high);
    return {high, arf_get_d(arb_midref(rest.get()), ARF_RND_NEAR)};
}

/// Gauss-Legendre on [-1, 1].
struct Gauss {
    Wide nodes, weights;
    explicit Gauss(int count) : nodes(static_cast<std::size_t>(count)), weights(static_cast<std::size_t>(count))
    {
        const WorkingPrecision precision(200);
        for (int i = 0; i < count; ++i) {
            Ball x, w;
            arb_hypgeom_legendre_p_ui_root(x.get(), w.get(), static_cast<ulong>(count), static_cast<ulong>(i), precision.bits());
            nodes.set(static_cast<std::size_t>(i), to_real(x));
            weights.set(static_cast<std::size_t>(i), to_real(w));
        }
    }
};

} // namespace touchstone::transfer
