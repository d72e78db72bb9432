// SPDX-License-Identifier: MIT
/// \file
/// How fast the recursion (6.7) approaches its fractal limit, with every constant: docs/limit.md, theorems 1 and 2.
///
/// With G = gamma^(D-1), h_m(x) = G^m B_m(x)/x is the contact area per unit of force after m + 1 scales that begin at load ratio x, so that
///
///     A_n/lambda_0 = load G^-n h_n(load),      C(G) = lim h_n(load) = lim A_n G^n/load,
///
/// and one step is an average over the next ratio, h_{m+1}(x) = E[h_m(y)] (transfer/chain.hpp, C3). In s = -log x two chains driven by the
/// same noise come nearer to one another by the factor |ds'/ds| = |1 - 2xu^2|/(2(1 - xu^2)) a step. That is the whole proof; below are its
/// constants. Valid for G > 2 and 0 < load <= 1. \pre of each function: that is certain of its arguments.
#pragma once

#include "touchstone/scalar/ball.hpp"

#include <optional>

namespace touchstone::limit {

/// Lemma 2: E[(1 - u^2)^-a] = (2/sqrt(pi)) Gamma(3/2 - a)/Gamma(2 - a) of the noise, a < 3/2.
Ball noise_moment(const Ball& a);

/// Lemma 3: at least E[|ds'/ds| (1 - u^2)^-a] for every x <= top <= 1, where 0 <= a < 1/2, or a = 1/2 and top < 1.
/// It is half of noise_moment(a) where top <= 2/3; 0.7543 for a = 0 and any top.
Ball contraction(const Ball& a, const Ball& top);

/// Theorem 2: |h_n(load)/C - 1| <= delta_n for every n >= 2,
///
///     delta_n = 8 (1 - 2/G)^(-1/2) (2 + (G/2)^(1/2) + (4/pi) (2/G)^(1/2) load^(-1/4)) prod_{j=1}^{n-1} contraction(2^-j, 2/G).
Ball relative_error(long n, const Ball& G, const Ball& load);

/// The least n >= 2 for which that is known of delta_m <= tolerance for all m >= n; nothing if it is not one up to `most`.
std::optional<long> scale(const Ball& tolerance, long most, const Ball& G, const Ball& load);

/// Theorem 1, for every G > 1 and load: |h_n(load) - C| <= 2 ((m + G^2) d prod lambda_k)^(1/2) over n scales, m = max(1/load, G^2),
/// lambda_k = 1/2 where X_k <= 2/3, else contraction(0, 1) where X_k < 1, else the larger of 1 - 1/(4x(x + 1)) at x = 2/3^(1/2) and (1 -
/// 1/X_k^2)^(1/2); X_0 = max(load, x_P), X_{k+1} = max(x_P, (X_k + 1)/G), or 2 X_k^(1/2)/G where X_k < 1; x_P = 4/G^2 or, for G <= 2, 1/(G
/// - 1); d = |log load| + log max(1, X_0) + log(1 + G^2). The share of contact above any pressure is within 2/C of that of its limit
/// (theorem 7).
Ball distance_from_limit(long n, const Ball& G, const Ball& load);

} // namespace touchstone::limit
