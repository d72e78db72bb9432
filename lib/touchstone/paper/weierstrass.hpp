// SPDX-License-Identifier: MIT
/// \file
/// Section 3: the Weierstrass profile. Units: heights in g0, lengths in lambda0.
/// gamma > 1, 1 < D < 2 throughout; gamma^(D-2) < 1 is the ratio of successive amplitudes. `double`: 4 ulp beyond the inputs' rounding,
/// profile_sum apart.
#pragma once

#include "touchstone/scalar/scalar.hpp"

namespace touchstone::weierstrass {

/// (3.2), (3.6)  g_{n+1}/g_n = gamma^(D-2).
template <Scalar T>
T amplitude_ratio(const T& D, const T& gamma)
{
    return pow(gamma, T(D - 2));
}

/// (3.8)  G = p*_{n+1}/p*_n = gamma^(D-1), on which alone sections 5 to 7 depend.
template <Scalar T>
T pressure_ratio(const T& D, const T& gamma)
{
    return pow(gamma, T(D - 1));
}

/// (3.4)  zhat/g0 = 1/(1 - gamma^(D-2)), the bound of |z|/g0; it is reached at x = 0.
template <Scalar T>
T bound(const T& D, const T& gamma)
{
    return -1 / powm1(gamma, T(D - 2));
}

/// The first `terms` terms of (3.1), z(x)/g0 = sum gamma^((D-2)n) cos(2 pi gamma^n x).
/// What is left out is below amplitude_ratio^terms * bound in absolute value.
/// The phase gamma^n x carries an error that grows like gamma^n: a ball needs n log2(gamma)
/// extra bits, and in `double` a few terms already have no right digit: use profile(double, double, double)
/// of weierstrass_profile.hpp, or the enclosures there.
template <Scalar T>
T profile_sum(const T& x, const T& D, const T& gamma, long terms)
{
    const T r = amplitude_ratio(D, gamma);
    T amplitude = integer<T>(1);
    T phase = 2 * x;
    T z = integer<T>(0);
    for (long n = 0; n < terms; ++n) {
        z = z + amplitude * cos_pi(phase);
        amplitude = amplitude * r;
        phase = phase * gamma;
    }
    return z;
}

} // namespace touchstone::weierstrass
