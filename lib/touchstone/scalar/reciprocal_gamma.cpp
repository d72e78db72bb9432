// SPDX-License-Identifier: MIT
#include "touchstone/scalar/reciprocal_gamma.hpp"

#include "touchstone/scalar/flint_headers.hpp"

#include <algorithm>
#include <limits>

namespace touchstone {

slong reciprocal_gamma_rest(slong e, slong K)
{
    slong least = std::numeric_limits<slong>::max();
    for (const auto& [log_radius, log_size] : reciprocal_gamma_bounds) least = std::min(least, log_size + 1 - (e + log_radius) * K);
    return least;
}

namespace {

/// For the roundings of the sum, of which there are some hundred.
constexpr slong guard_bits = 16;

/// The least logarithm among the bounds of |c_k|.
slong coefficient_bound(slong k)
{
    slong least = 0; // |c_k| <= 1
    for (const auto& [log_radius, log_size] : reciprocal_gamma_bounds) least = std::min(least, log_size - k * log_radius);
    return least;
}

/// By Horner's rule; false where the table has not the digits.
bool sum_series(Ball& sum, slong e, slong bits)
{
    slong K = 1;
    while (reciprocal_gamma_rest(e, K) > -bits) ++K;
    if (K > ARB_HYPGEOM_GAMMA_TAB_NUM) return false;
    sum = 0;
    for (slong k = K - 1; k >= 0; --k) {
        arb_struct c; // looks into the table, and is not to be cleared
        arb_init(&c);
        const slong wanted = std::max<slong>(2, bits - e * k + coefficient_bound(k));
        if (!_arb_hypgeom_gamma_coeff_shallow(arb_midref(&c), arb_radref(&c), k, wanted)) return false;
        arb_mul_2exp_si(sum.get(), sum.get(), -e);
        arb_sub(sum.get(), &c, sum.get(), std::max<slong>(64, bits - e * k));
    }
    const Ball rest = power_of_two<Ball>(reciprocal_gamma_rest(e, K));
    arb_add_error(sum.get(), rest.get());
    return true;
}

} // namespace

Ball reciprocal_gamma_below_one(slong e)
{
    const WorkingPrecision precision(WorkingPrecision::bits() + guard_bits);
    Ball value;
    if (sum_series(value, e, WorkingPrecision::bits())) return value;
    const Ball below_one = 1 - power_of_two<Ball>(-e);
    arb_rgamma(value.get(), below_one.get(), WorkingPrecision::bits());
    return value;
}

} // namespace touchstone
