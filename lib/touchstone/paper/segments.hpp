// SPDX-License-Identifier: MIT
/// \file
/// Sections 8 and 9: the contact area as a set of segments. Lengths in lambda_0 (numbers) or lambda_n (widths).
#pragma once

#include "touchstone/paper/archard.hpp"
#include "touchstone/paper/peaks.hpp"
#include "touchstone/paper/westergaard.hpp"

namespace touchstone::archard {

/// (8.2)  number of segments at scale n >= 1 in the Hertzian approximation, given K_{n-1}:
/// K_{n-1} gamma^((2-D)n + 2(D-1)(1-2^-n)) load^(1-2^-n).
template <Scalar T>
T segments(long n, const T& load, const T& D, const T& gamma, const T& K_before)
{
    const T e = 1 - power_of_two<T>(-n);
    return K_before * pow_product(gamma, T(2 - D), integer<T>(n)) * pow_product(gamma, T(2 * (D - 1)), e) * pow(load, e);
}

/// (8.3)  its limiting form at large n: K_inf gamma^((2-D)n + 2(D-1)) load.
template <Scalar T>
T segments_limit(long n, const T& load, const T& D, const T& gamma, const T& K_inf)
{
    return K_inf * pow_product(gamma, T(2 - D), integer<T>(n)) * pow(gamma, T(2 * (D - 1))) * load;
}

} // namespace touchstone::archard

namespace touchstone::segments {

/// The largest half-width at scale n, a_n^max/lambda_n: (6.6) at the highest pressure p_{n-1}^max,
/// arcsin(sqrt(min(x_{n-1}, 1)))/pi with x_{n-1} of (5.6). n >= 0; 1/2 where the highest peaks are in full contact.
/// ((9.4) prints arcsin(x_P) for the limit, without the square root: see proofs/section_9.)
template <OrderedScalar T>
T max_half_width(long n, const T& load, const T& G)
{
    const T x = n == 0 ? load : peaks::iterate(n - 1, load, G);
    return westergaard::half_width(T(at_most(x, integer<T>(1))));
}

} // namespace touchstone::segments
