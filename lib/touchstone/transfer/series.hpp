// SPDX-License-Identifier: MIT
/// \file
/// The contact area as a convergent power series: no grid, no quadrature, no interpolation.
///
/// With T the operator B_{m+1} = T B_m of (C2) in chain.hpp, while every ratio is below 1,
///
///     T[y^s](x) = (2/G)^s (1/pi) Beta(1/2, 1 + s/2) x^((1+s)/2) 2F1((1-s)/2, 1/2; (3+s)/2; x),                  (S1)
///
/// Euler's integral in t = u^2. B_0 = (2/pi) arcsin sqrt(x) is a series in x^(1/2 + i), so by induction
///
///     B_m(x) = sum_i d_i^(m) x^(delta_m + i 2^-m),   delta_m = 1 - 2^(-m-1),                                    (S2)
///
/// where each d_i^(m+1) is a finite sum over d_j^(m), j <= i. The first term is Archard's law (7.18).
///
/// **Tail.** B_n(load) = sum_i d_i^(n-1) T[y^s_i](load) is cut after I terms. As a function of w = x^(2^-m),
/// x^(-delta_m) B_m is analytic in |w| < 1 and at most c_m G^-m there (Lemma 2: a turn of w is 2^m turns of x), so
/// |d_i^(m)| <= c_m G^-m (Cauchy); and 0 <= T[y^s] <= Y^s T1, Y = (2/G) sqrt(load) the largest y, T1 = (2/pi) arcsin sqrt(load).
/// So the tail is at most T1 c G^-(n-1) Y^(s_I)/(1 - Y^(2^-(n-1))), and about Y^(I 2^-(n-1)) of the first term, however light the load.
///
/// **Cost.** About 2^(n-1) (digits log 10)/(-log Y) terms: n <= 8 or so unless the load is small, n <= 14 at load 1e-300.
#pragma once

#include "touchstone/scalar/ball.hpp"

namespace touchstone::transfer {

/// A_n/lambda_0 (6.7) for 0 < load < 1, G > 2, n >= 0, at the thread's precision.
/// \throws BeyondReach if that takes more than 20 000 terms
Ball area_series(long n, const Ball& load, const Ball& G);

/// The terms it takes to so many bits; infinite where the series need not converge.
double terms_of_area_series(long n, const Ball& load, const Ball& G, slong bits);

/// 2F1((1-s)/2, 1/2; (3+s)/2; x) for 0 < x < 1, s > 0.
/// \throws BeyondReach after 100 000 terms
Ball hypergeometric(const Ball& s, const Ball& x);

/// The sum of first ratio^k over k >= 0, for 0 <= ratio < 1: what terms that shrink so at least leave out from `first` on.
Ball geometric_sum(const Ball& first, const Ball& ratio);

} // namespace touchstone::transfer
