// SPDX-License-Identifier: MIT
/// \file
/// Section 7: Archard's recursion with Hertzian contact at every scale.
///
/// A_n/lambda0 = K_n G^-(n-1+2^-n) load^delta_n, G = gamma^(D-1). The product printed in (7.17)
/// and (7.18) does not satisfy the recursion (7.13) it is derived from (proofs/section_7.cpp);
/// what is computed here follows (7.13), as Table 1 does. load > 0, G > 1. `double`: 4 ulp beyond the inputs' rounding.
#pragma once

#include "touchstone/scalar/scalar.hpp"

namespace touchstone::archard {

/// (7.16)  delta_n = 1 - 2^-(n+1), n >= 0.
template <Scalar T>
T delta(long n)
{
    return 1 - power_of_two<T>(-(n + 1));
}

/// n - 1 + 2^-n, the number of times that G divides the area at scale n.
template <Scalar T>
T decay_exponent(long n)
{
    return integer<T>(n - 1) + power_of_two<T>(-n);
}

/// (7.16)  alpha_n = (1 - D)(n - 1 + 2^-n), n >= 0.
template <Scalar T>
T alpha(long n, const T& D)
{
    return (1 - D) * decay_exponent<T>(n);
}

/// (7.13)  K_{n+1}/K_n = 2^delta Gamma(1 + delta/2) / (sqrt(pi) Gamma(3/2 + delta/2)), delta = delta_n in [1/2, 1).
template <Scalar T>
T step(const T& delta)
{
    const T half = delta / 2;
    return pow(integer<T>(2), delta) * gamma_function(T(1 + half))
           / (sqrt(pi<T>()) * gamma_function(T(ratio<3, 2, T>() + half)));
}

/// (7.13) with K_0 = 2/pi: K_n, n >= 0, by the recursion itself, n steps with two Gamma functions each. In `double` errors of all steps
/// add.
template <Scalar T>
T K_by_recursion(long n)
{
    T K = 2 / pi<T>();
    for (long i = 0; i < n; ++i) K = K * step(delta<T>(i));
    return K;
}

/// eta(k) = 1 - 2^-k + 3^-k - ..., k >= 1, by the first `terms` terms of Cohen, Rodriguez Villegas and
/// Zagier's acceleration (Experiment. Math. 9, 2000, Algorithm 1). The terms are the moments of a
/// positive measure on [0, 1], so by their Proposition 1 the error is below 2 (3 + sqrt 8)^-terms.
template <Scalar T>
T eta(long k, long terms)
{
    // d = ((3 + sqrt 8)^n + (3 - sqrt 8)^n)/2 is an integer: d_0 = 1, d_1 = 3, d_j = 6 d_{j-1} - d_{j-2}.
    T before = integer<T>(1);
    T d = integer<T>(3);
    for (long j = 1; j < terms; ++j) {
        const T next = 6 * d - before;
        before = d;
        d = next;
    }
    T b = integer<T>(-1);
    T c = -d;
    T sum = integer<T>(0);
    for (long j = 0; j < terms; ++j) {
        c = b - c;
        sum = sum + c / pow(integer<T>(j + 1), integer<T>(k));
        b = b * integer<T>(2 * (j + terms) * (j - terms)) / integer<T>((2 * j + 1) * (j + 1));
    }
    return sum / d;
}

/// K_n as one convergent series, n >= 0 (n < 0 stands for n = infinity, (7.20)):
///     K_n = exp( sum_{k>=2} eta(k)/k (1 - 2^{-kn})/(2^k - 1) ) / (pi (1 - 2^-(n+1))).
/// Proof: with h = 2^-(i+1) the logarithm of step(delta_i) is, by the Taylor series of log Gamma
/// at 3/2 and 2, -h log 2 + sum_{k>=1} (eta(k) - 1 + 2^-k) h^k/k; eta(1) = log 2 cancels the first
/// term, the -1 + 2^-k make log((1 - h)/(1 - h/2)), which telescopes over i, and the powers of h
/// are geometric sums. Left out after `terms`: less than 2^-terms in the exponent.
/// `double`: terms = 56, eta_terms = 24 give 2 ulp for every n.
template <Scalar T>
T K_by_series(long n, long terms, long eta_terms)
{
    T exponent = integer<T>(0);
    for (long k = terms; k >= 2; --k) { // small terms first
        const T geometric = n < 0 ? integer<T>(1) : T(1 - power_of_two<T>(-k * n));
        exponent = exponent + eta<T>(k, eta_terms) / integer<T>(k) * geometric / (power_of_two<T>(k) - 1);
    }
    const T last = n < 0 ? integer<T>(1) : T(1 - power_of_two<T>(-(n + 1)));
    return exp(exponent) / (pi<T>() * last);
}

/// (7.13)  K_n in double, within 2 ulp for every n >= 0; n < 0 stands for the limit (7.20).
inline double K(long n) { return K_by_series<double>(n, 56, 24); }

/// (7.18) with the right K_n: A_n/lambda0, given K_n in the wanted arithmetic. G > 1, load > 0.
/// G^-(n-1+2^-n) load^(1-2^-(n+1)) = (G sqrt(load))^-(2^-n) load G^-(n-1), the last in two halves: no exponent
/// is rounded however large n is, and nothing under- or overflows before the result does.
template <Scalar T>
T area(long n, const T& load, const T& G, const T& K_n)
{
    const T half = pow(G, T(integer<T>(1 - n) / 2));
    const T rest = pow(T(G * sqrt(load)), T(-power_of_two<T>(-n)));
    return K_n * rest * half * load * half;
}

/// (7.21)  the limiting form of A_n/lambda0 at large n: K_inf G^-(n-1) load. load > 0, G > 1; K_inf of (7.20).
template <Scalar T>
T area_limit(long n, const T& load, const T& G, const T& K_inf)
{
    return K_inf * pow(G, integer<T>(1 - n)) * load;
}

} // namespace touchstone::archard
