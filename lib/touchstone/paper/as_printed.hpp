// SPDX-License-Identifier: MIT
/// \file
/// Section 2 in the very form the paper prints it, in its units (lambda = p* = 1).
///
/// Not for computing with: near an edge these lose half the digits of a `double`.
/// They are the independent second route of the certified values, and what a code
/// that trusts the print would do. (Printed forms found false are not here but in data/paper.)
#pragma once

#include "touchstone/scalar/scalar.hpp"

namespace touchstone::as_printed {

/// (2.5)  a/lambda, 0 < load <= 1
template <Scalar T>
T half_width(const T& load) { return asin(sqrt(load)) / pi<T>(); }

/// (2.2)  p/p*, load >= 1
template <Scalar T>
T pressure_full(const T& x, const T& load) { return load + cos(2 * pi<T>() * x); }

/// (2.4)  p/p*, with a from (2.5); 0 < load <= 1, |x| <= 1/2, 0 outside the contact
template <Scalar T>
T pressure_partial(const T& x, const T& load)
{
    const T sa = sin(pi<T>() * half_width(load));
    const T sx = sin(pi<T>() * x);
    return 2 * load * cos(pi<T>() * x) / (sa * sa) * sqrt_positive_part(sa * sa - sx * sx);
}

/// (2.6)  p/p*, with a from (2.7); load > 0, 0 outside the contact
template <Scalar T>
T hertz_pressure(const T& x, const T& load)
{
    const T a = sqrt(load) / pi<T>();
    return 2 * load / (pi<T>() * a) * sqrt_positive_part(1 - x * x / (a * a));
}

/// (2.14)  Q/lambda, whose first factor is lambda/pi with lambda = 1; load >= 1, load - 1 <= p <= load + 1
template <Scalar T>
T exceedance_full(const T& p, const T& load) { return acos(p - load) / pi<T>(); }

/// (2.17)  Q/lambda, load <= 1, 0 <= p <= 2 sqrt(load)
template <Scalar T>
T exceedance_partial(const T& p, const T& load)
{
    const T R = sqrt((1 - load) * (1 - load) + p * p);
    return 2 / pi<T>() * asin(sqrt_positive_part(ratio<1, 2, T>() * ((load + 1) - R)));
}

/// (2.15)  q p*, load >= 1, load - 1 < p < load + 1
template <Scalar T>
T density_full(const T& p, const T& load) { return 1 / (pi<T>() * sqrt(1 - (p - load) * (p - load))); }

/// (2.19)  q p*, load <= 1, 0 <= p < 2 sqrt(load)
template <Scalar T>
T density_partial(const T& p, const T& load)
{
    const T m = 1 - load;
    return p / (pi<T>() * sqrt((m * m + p * p) * (2 * load * (m + sqrt(m * m + p * p)) - p * p)));
}

} // namespace touchstone::as_printed
