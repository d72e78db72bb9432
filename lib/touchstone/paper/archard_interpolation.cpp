// SPDX-License-Identifier: MIT
#include "touchstone/paper/archard_interpolation.hpp"

#include "touchstone/scalar/flint_headers.hpp"
#include "touchstone/scalar/reciprocal_gamma.hpp"

#include <algorithm>
#include <vector>

namespace touchstone::archard {
namespace {

/// Left of the working precision for roundings: of the products, and of weights whose sizes add up to less than 9.
constexpr slong guard_bits = 40;

Ball dyadic(long exponent) { return power_of_two<Ball>(exponent); }

} // namespace

/// With the nodes u_i = 2^-i and the polynomial P, kappa(u) - P(u) is (1/2 pi i) times the integral over |w| = 4 of
/// kappa(w)/(w - u) prod_i (u - u_i)/(w - u_i). There |kappa| < 7: by the series of K_gamma_product, log F(x) = -x + sum_{k>=2} e_k x^k/k
/// with 0 < e_k < (2/3)^k, |log F(x)| <= |x| + sum_{k>=2} (2/3)^k |x|/k < 1.44 |x| for |x| <= 1, so that |log kappa/K_inf| < 1.44 (1 + 1/2
/// + 1/4 + ...) =
/// 2.88, and K_inf < 0.3915, since K_n descends. And |u - u_i| <= u_i, |w - u| >= 3, |w - u_i| >= 4 (1 - 2^-(i+2)), where the product of
/// the brackets is at least 1 - 1/4 - 1/8 - ... = 1/2. So the difference is below 7 (4/3) 2 4^-(M+1) prod_i 2^-i < 2^5 4^-(M+1)
/// 2^-(M(M+1)/2).
slong interpolation_error(long M) { return 5 - 2 * (M + 1) - M * (M + 1) / 2; }

namespace {

/// M for so many bits of K_n.
long last_node(slong bits)
{
    long M = 1;
    while (interpolation_error(M) > -bits) ++M;
    return M;
}

/// K_0, ..., K_last by Gamma functions: K_n = g_{n-1}/(1 - x_{n-1}) prod_{i<n} g_i/sqrt(pi), g_i = 1/Gamma(1 - x_i), x_i = 2^-(i+2).
std::vector<Ball> products(long last)
{
    std::vector<Ball> K{2 / pi<Ball>()};
    Ball product = 1 / sqrt(pi<Ball>());
    for (long n = 1; n <= last; ++n) {
        const Ball g = reciprocal_gamma_below_one(n + 1);
        product *= g;
        K.push_back(product * g / (1 - dyadic(-(n + 1))));
    }
    return K;
}

} // namespace

Ball K_polynomial(long M, long n)
{
    const slong bits = WorkingPrecision::bits();
    // Lagrange's weights at u are prod_{d<=i} (1 - 2^-d)^-1 prod_{d<=M-i} (1 - 2^d)^-1, those at 0, times prod_j (1 - u/u_j) over
    // 1 - u/u_i. The i-th has (M - i)(M - i + 1)/2 bits fewer than the last.
    const std::vector<Ball> K = products(M);
    const auto ratio = [n](long i) { return n < 0 ? Ball(0) : dyadic(i - n); }; // u/u_i
    Ball weight(1), all(1), sum(0);
    for (long d = 1; d <= M; ++d) weight *= 1 - dyadic(-d);
    weight = 1 / weight;
    for (long i = M; i >= 0; --i) {
        const Ball factor = 1 - ratio(i);
        all *= factor;
        const WorkingPrecision shorter(std::max<slong>(64, bits - (M - i) * (M - i + 1) / 2));
        const Ball term = weight * K[static_cast<std::size_t>(i)] / factor;
        weight *= (1 - dyadic(-i)) / (1 - dyadic(M - i + 1));
        const WorkingPrecision whole(bits);
        sum += term;
    }
    return sum * all;
}

Ball K_interpolated(long n)
{
    const slong bits = WorkingPrecision::bits() + guard_bits;
    const WorkingPrecision precision(bits);
    const long M = last_node(bits);
    if (n >= 0 && n <= M) return products(n).back();
    Ball K = K_polynomial(M, n);
    const Ball error = dyadic(interpolation_error(M));
    arb_add_error(K.get(), error.get());
    return K;
}

} // namespace touchstone::archard
