// SPDX-License-Identifier: MIT
/// \file
/// Sections 8 and 9: the contact area as a set of segments. Numbers N_n are per lambda_0, widths in lambda_n. `double`: 4 ulp beyond the
/// inputs' rounding.
#pragma once

#include "touchstone/paper/archard.hpp"
#include "touchstone/paper/peaks.hpp"
#include "touchstone/paper/westergaard.hpp"

namespace touchstone::archard {

/// (8.2)  number of segments at scale n >= 1 in the Hertzian approximation, given K_{n-1}:
/// K_{n-1} gamma^((2-D)n + 2(D-1)(1-2^-n)) load^(1-2^-n) = K_{n-1} gamma^((2-D)n) L^(1-2^-n), L = gamma^(2(D-1)) load,
/// the power of gamma in two halves, as in area().
template <Scalar T>
T segments(long n, const T& load, const T& D, const T& gamma, const T& K_before)
{
    const T half = pow_product(gamma, T(2 - D), T(integer<T>(n) / 2));
    const T L = pow(gamma, T(2 * (D - 1))) * load;
    return K_before * pow(L, T(-power_of_two<T>(-n))) * half * L * half;
}

/// (8.3)  its limiting form at large n: K_inf gamma^((2-D)n + 2(D-1)) load. load > 0, 1 < D < 2, gamma > 1, both here and in (8.2).
template <Scalar T>
T segments_limit(long n, const T& load, const T& D, const T& gamma, const T& K_inf)
{
    const T half = pow_product(gamma, T(2 - D), T(integer<T>(n) / 2));
    return K_inf * half * (pow(gamma, T(2 * (D - 1))) * load) * half;
}

} // namespace touchstone::archard

namespace touchstone::segments {

/// The largest half-width at scale n, a_n^max/lambda_n: (6.6) at the highest pressure p_{n-1}^max,
/// arcsin(sqrt(min(x_{n-1}, 1)))/pi with x_{n-1} of (5.6). n >= 0; 1/2 where the highest peaks are in full contact.
/// ((9.4) prints arcsin(x_P) for the limit, without the square root: see proofs/section_9.cpp.)
template <OrderedScalar T>
T max_half_width(long n, const T& load, const T& G)
{
    if (n == 0) return westergaard::half_width(T(at_most(load, integer<T>(1))));
    // x_{n-1} = y/G with y = f(x_{n-2}): the angle of (2.5) from y : G - y, so that a tiny x_{n-1} is not formed
    const T y = peaks::f(n == 1 ? load : peaks::iterate(n - 2, load, G));
    return atan2(sqrt(y), sqrt_positive_part(T(G - y))) / pi<T>();
}

} // namespace touchstone::segments
