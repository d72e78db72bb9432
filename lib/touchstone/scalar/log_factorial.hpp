// SPDX-License-Identifier: MIT
/// \file
/// The logarithm of a factorial in binary64, for estimates in any thread.
#pragma once

#include <math.h> // lgamma_r is POSIX's, not the standard library's

namespace touchstone {

/// log n!, to a few units in the last place, n >= 0. std::lgamma is not for threads: it writes the sign of Gamma to one variable of all of
/// them.
inline double log_factorial(double n)
{
    int sign = 1;
    return ::lgamma_r(n + 1, &sign);
}

} // namespace touchstone
