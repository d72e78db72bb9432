// SPDX-License-Identifier: MIT
/// \file
/// Section 5: the pressure at the highest peaks, scale after scale. Pressures in p*_n; G = gamma^(D-1) > 1. `double`: 4 ulp beyond the
/// inputs' rounding.
#pragma once

#include "touchstone/scalar/scalar.hpp"

namespace touchstone::peaks {

/// (5.4), (5.5)  f(x) = p_n^max/p*_n for x = p_{n-1}^max/p*_n > 0: 1 + x for x > 1, 2 sqrt(x) for x < 1; both are 2 at x = 1.
template <OrderedScalar T>
T f(const T& x)
{
    return across_seam(
        x, integer<T>(1),
        [](const T& s) -> T { return 2 * sqrt(s); },
        [](const T& s) -> T { return 1 + s; });
}

/// (5.6)  x_n = p_n^max/p*_{n+1} = f(x_{n-1})/G, n >= 0, started from x_{-1} = load = pbar/p*_0.
/// One step halves the relative error in partial contact and divides it by G in full
/// contact, so nothing is lost over many steps. load > 0. Cost: n + 1 steps.
template <OrderedScalar T>
T iterate(long n, const T& load, const T& G)
{
    T x = load;
    for (long k = 0; k <= n; ++k) x = f(x) / G;
    return x;
}

/// (5.8), (5.9)  x_P, the positive solution of x = f(x)/G: 4/G^2 for G > 2, 1/(G - 1) for G < 2; both are 1 at G = 2.
template <OrderedScalar T>
T fixed_point(const T& G)
{
    return across_seam(
        G, integer<T>(2),
        [](const T& g) -> T { return 1 / (g - 1); },
        [](const T& g) -> T { return (2 / g) * (2 / g); });
}

} // namespace touchstone::peaks
