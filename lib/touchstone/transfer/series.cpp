// SPDX-License-Identifier: MIT
#include "touchstone/transfer/series.hpp"

#include "touchstone/scalar/refusal.hpp"
#include "touchstone/transfer/chain.hpp"

#include <cmath>
#include <numbers>
#include <vector>

namespace touchstone::transfer {
namespace {

using Traits = ScalarTraits<Ball>;

/// (2/G)^s Beta(1/2, 1 + s/2)/pi = (2/G)^s Gamma(1 + s/2)/(sqrt(pi) Gamma(3/2 + s/2))
Ball leading(const Ball& s, const Ball& G)
{
    Ball reciprocal;
    arb_rgamma(reciprocal.get(), ((3 + s) / 2).get(), WorkingPrecision::bits());
    return pow(2 / G, s) * Traits::gamma(1 + s / 2) * reciprocal / sqrt(Traits::pi());
}

} // namespace

Ball geometric_sum(const Ball& first, const Ball& ratio) { return first / (1 - ratio); }

/// By its series: once (1-s)/2 + k >= 0 the terms' ratio is below x.
Ball hypergeometric(const Ball& s, const Ball& x)
{
    Ball sum(0), term(1);
    for (long k = 0;; ++k) {
        sum += term;
        term = term * ((1 - s) / 2 + k) * (2 * k + 1) * x / (((3 + s) / 2 + k) * (2 * (k + 1)));
        if (!certainly(less((1 - s) / 2 + k, Ball(0))) && certainly(less(abs(term), Traits::power_of_two(-WorkingPrecision::bits()))))
            break;
        if (k == 100'000) throw BeyondReach("the power series converges too slowly this near load = 1");
    }
    arb_add_error(sum.get(), upper(geometric_sum(abs(term), x)).get());
    return sum;
}

namespace {

/// A term of the series is about e^-decay of the one before it: Y^(2^-(n-1)), Y the largest ratio after one step.
Ball decay(long n, const Ball& load, const Ball& G) { return -log(2 / G * sqrt(load)) * Traits::power_of_two(1 - n); }

} // namespace

double terms_of_area_series(long n, const Ball& load, const Ball& G, slong bits)
{
    const double nats = arf_get_d(arb_midref(decay(n, load, G).get()), ARF_RND_DOWN);
    return nats > 0 ? std::ceil(static_cast<double>(bits) * std::numbers::ln2 / nats) + 2 : HUGE_VAL;
}

Ball area_series(long n, const Ball& load, const Ball& G)
{
    if (!certainly(less(Ball(0), load)) || !certainly(less(Ball(2), G))) throw BeyondReach("the series needs load > 0 and G > 2");
    if (n == 0) return 2 * asin(sqrt(load)) / Traits::pi();
    if (n > 20 || !certainly(less(load, Ball(1)))) throw BeyondReach("the power series needs load < 1 and small n");
    const long m_last = n - 1;
    const Ball Y = 2 / G * sqrt(load), largest = Traits::power_of_two(-m_last);
    if (!certainly(less(Y, Ball(1)))) throw BeyondReach("the power series does not converge for this load");
    const double count = terms_of_area_series(n, load, G, WorkingPrecision::bits());
    if (!(count < 20'000)) throw BeyondReach("the power series would need too many terms");
    const auto terms = static_cast<std::size_t>(count);
    const WorkingPrecision guard(WorkingPrecision::bits() + 64);

    std::vector<Ball> d{2 / Traits::pi()}; // (2/pi) (2i)!/(4^i i!^2 (2i+1))
    for (std::size_t i = 1; i < terms; ++i) {
        const auto k = static_cast<long>(i);
        d.push_back(d.back() * ((2 * k - 1) * (2 * k - 1)) / Ball(2 * k * (2 * k + 1)));
    }
    Ball exponent = Traits::quotient(1, 2); // delta_m
    for (long m = 0; m < m_last; ++m) {
        const Ball step = Traits::power_of_two(-m);
        const std::size_t stride = std::size_t{2} << m; // a factor x is so many steps of x^(2^-(m+1))
        std::vector<Ball> next(terms, Ball(0));
        for (std::size_t i = 0; i < terms; ++i) {
            const Ball s = exponent + static_cast<long>(i) * step;
            Ball c = d[i] * leading(s, G);
            for (std::size_t at = i, k = 0; at < terms; at += stride, ++k) {
                next[at] += c;
                const auto j = static_cast<long>(k);
                c = c * ((1 - s) / 2 + j) * (2 * j + 1) / (((3 + s) / 2 + j) * (2 * (j + 1)));
            }
        }
        d = std::move(next);
        exponent = (1 + exponent) / 2;
    }
    Ball sum(0);
    for (std::size_t i = 0; i < terms; ++i) {
        const Ball s = exponent + static_cast<long>(i) * largest;
        sum += d[i] * leading(s, G) * pow(load, (1 + s) / 2) * hypergeometric(s, load);
    }
    const Ball first_left_out = pow(Y, exponent + static_cast<long>(terms) * largest);
    Ball tail = 2 * asin(sqrt(load)) / Traits::pi() * magnitudes(G, m_last).back() * geometric_sum(first_left_out, pow(Y, largest));
    for (long m = 0; m < m_last; ++m) tail /= G;
    arb_add_error(sum.get(), upper(tail).get());
    return sum;
}

} // namespace touchstone::transfer
