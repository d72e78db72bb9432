// SPDX-License-Identifier: MIT
/// \file
/// C(G)/(K_inf G) as a power series in 4/G^2, from the moments of the limiting distribution: docs/limit.md, theorems 3 and 4.
///
/// Put e = 4/G^2 and let w = x/e be the load ratio of a randomly chosen unit of force in the limit, in units of the largest; w'^2 = w
/// (1-u^2)(1-e w u^2), u of density (4/pi)(1-u^2)^(1/2). Its moments M(a) = E[w^a] are stationary under one more wave,
///
///     M(a) = beta(a) sum_j e^j delta_j(a) M(a/2 + j),     M(0) = 1,     C(G) = E[1/x]/G = (G/4) M(-1),
///     beta(a) = (2/sqrt(pi)) Gamma((3+a)/2)/Gamma(2+a/2),     delta_j(a) = (-a/2)_j (1/2)_j/(j! (2+a/2)_j).
///
/// In powers of e, M = sum e^N m_N: m_0(a) = prod_k beta(a/2^k), where m_0(-1) = 4 K_inf, and with g_N(a) = beta(a) sum_{j>0} delta_j(a)
/// m_{N-j}(a/2+j)
///
///     m_N(a) = sum_k m_0(a)/m_0(a/2^k) g_N(a/2^k),     C(G)/(K_inf G) = sum_N R_N e^N,   R_N = m_N(-1)/m_0(-1),
///     R_1 = sum_{k>=0} b_k/(2(4-b_k)) m_0(1-b_{k+1})/m_0(-b_{k+1}),   b_k = 2^-k.
///
/// Nothing here is shared with the recursion of areas: it is the distribution that is computed, forwards.
#pragma once

#include "touchstone/scalar/accuracy.hpp"

#include <vector>

namespace touchstone::limit {

/// m_0(a), a > -3
Ball hertzian_moment(const Ball& a);

/// R_0 = 1, R_1, ... R_last, last <= 24, to about so many digits each. |R_N| <= 2 for every N (theorem 3). Cost: a second for 24 of them.
std::vector<Ball> area_coefficients(int last, Accuracy);

/// C(G)/(K_inf G) by up to 8 terms of the series and |R_N| <= 2 beyond. \throws BeyondReach where they do not carry so many digits
Ball area_ratio_by_series(const Ball& G, Accuracy);
/// The most digits they carry: 30 from G = 120 on.
long most_digits_of_series(const Ball& G);
/// 1 + R_1 e with R_1 by the sum above: what looks again at the series.
Witness area_ratio_to_first_order(const Ball& G);

} // namespace touchstone::limit
