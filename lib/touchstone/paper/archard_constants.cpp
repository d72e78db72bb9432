// SPDX-License-Identifier: MIT
#include "touchstone/paper/archard_constants.hpp"

#include "touchstone/paper/archard.hpp"

#if __has_include(<flint/arb_poly.h>)
#include <flint/arb_poly.h>
#else
#include <arb_poly.h>
#endif

#include <algorithm>
#include <cmath>
#include <vector>

namespace touchstone::archard {
namespace {

constexpr slong guard_bits = 64;

Ball dyadic(long exponent) { return power_of_two<Ball>(exponent); }

/// Add +-2^exponent to the ball.
void widen(Ball& b, slong exponent)
{
    mag_t error;
    mag_init(error);
    mag_set_ui_2exp_si(error, 1, exponent);
    arb_add_error_mag(b.get(), error);
    mag_clear(error);
}

/// 1 - 2^{-k (n - m)}, the share of the geometric sum over all i >= m that i < n takes.
Ball finite_share(long k, long n, long m) { return n < 0 ? Ball(1) : 1 - dyadic(-k * (n - m)); }

/// eta(2), ..., eta(last), the k-th to about bits - k*step bits.
std::vector<Ball> eta_values(long last, slong bits, slong step)
{
    const long N = static_cast<long>(static_cast<double>(bits) / 2.5431) + 2; // log2(3 + sqrt 8) > 2.5431
    // c_j of the accelerated sum, integers (archard::eta has the same recurrence).
    Integer before = 1, d = 3;
    for (long j = 1; j < N; ++j) {
        Integer next = 6 * d - before;
        before = std::move(d);
        d = std::move(next);
    }
    std::vector<Ball> sums(static_cast<std::size_t>(last + 1), Ball(0));
    Integer b = -1, c = -d;
    Ball term;
    for (long j = 0; j < N; ++j) {
        c = b - c;
        term = Ball(Rational(c));
        for (long k = 1; k <= last; ++k) {
            const WorkingPrecision precision(std::max<slong>(bits - k * step, 32));
            arb_div_ui(term.get(), term.get(), static_cast<ulong>(j + 1), WorkingPrecision::bits());
            if (k >= 2) sums[static_cast<std::size_t>(k)] += term;
            // terms from here on are below the precision wanted of every later sum
            if (std::log2(static_cast<double>(j + 1)) > static_cast<double>(step) + 1
                && arf_cmpabs_2exp_si(arb_midref(term.get()), static_cast<slong>(mpz_sizeinbase(d.get_mpz_t(), 2)) - bits) < 0) {
                // keep the enclosure: what is dropped is a geometric series below twice this term
                for (long l = k + 1; l <= last; ++l) {
                    Ball rest(0);
                    arb_add_error(rest.get(), term.get());
                    sums[static_cast<std::size_t>(l)] += rest;
                }
                break;
            }
        }
        b = b * (2 * (Integer(j) + N) * (Integer(j) - N)) / ((2 * Integer(j) + 1) * (Integer(j) + 1));
    }
    const Ball denominator{Rational(d)};
    for (auto& s : sums) {
        s /= denominator;
        widen(s, 1 - static_cast<slong>(std::floor(2.5431 * static_cast<double>(N))));
    }
    return sums;
}

} // namespace

Ball K_gamma_product(long n)
{
    const slong target = WorkingPrecision::bits();
    const WorkingPrecision precision(target + guard_bits);
    const slong bits = target + guard_bits;
    const long m = std::max(4L, static_cast<long>(0.8 * std::sqrt(static_cast<double>(bits))));
    const long direct = n < 0 ? m : std::min(n, m);
    Ball K = 2 / pi<Ball>();
    for (long i = 0; i < direct; ++i) K *= step(delta<Ball>(i));
    if (direct == n) return K;

    // log step as a power series in x = 2^-(i+2): log Gamma(3/2 - x) - log Gamma(2 - x) + (1 - 2x) log 2 - log(pi)/2;
    // its constant term is zero.
    const long P = static_cast<long>(static_cast<double>(bits) / (static_cast<double>(m) + 2.5)) + 2;
    arb_poly_t argument, upper, lower;
    arb_poly_init(argument);
    arb_poly_init(upper);
    arb_poly_init(lower);
    arb_poly_set_coeff_si(argument, 1, -1);
    arb_poly_set_coeff_arb(argument, 0, Ball(Rational(3, 2)).get());
    arb_poly_lgamma_series(upper, argument, P + 1, bits);
    arb_poly_set_coeff_si(argument, 0, 2);
    arb_poly_lgamma_series(lower, argument, P + 1, bits);
    arb_poly_sub(upper, upper, lower, bits);
    Ball logarithm(0), coefficient;
    for (long k = P; k >= 1; --k) {
        arb_poly_get_coeff_arb(coefficient.get(), upper, k);
        if (k == 1) coefficient -= 2 * log(Ball(2));
        logarithm += coefficient * dyadic(-k * (m + 1)) / (dyadic(k) - 1) * finite_share(k, n, m);
    }
    arb_poly_clear(argument);
    arb_poly_clear(upper);
    arb_poly_clear(lower);
    // sum_{k>P} (2/3)^k/k 2^{-k(m+1)}/(2^k - 1) <= sum_{k>P} 2 q^k, q = 2^-(m+1)/3 < 2^-(m+2.5)
    widen(logarithm, 2 - static_cast<slong>(std::floor(static_cast<double>(P + 1) * (static_cast<double>(m) + 2.5))));
    return K * exp(logarithm);
}

Ball K_eta_series(long n)
{
    const slong target = WorkingPrecision::bits();
    const WorkingPrecision precision(target + guard_bits);
    const slong bits = target + guard_bits;
    const long m = std::max(5L, static_cast<long>(std::sqrt(static_cast<double>(bits))));
    const long direct = n < 0 ? m : std::min(n, m);
    Ball K = 2 / pi<Ball>();
    Ball before = gamma_function(Ball(Rational(3, 2))); // a_{-1}, x_{-1} = 1/2
    for (long i = 0; i < direct; ++i) {
        const Ball a = gamma_function(2 - dyadic(-(i + 2)));
        K *= (1 - dyadic(-(i + 2))) * before / (a * a); // x_{i-1}/2 = x_i
        before = a;
    }
    if (direct == n) return K;

    const long P = bits / (m + 1) + 2;
    const auto eta = eta_values(P, bits, m + 1);
    Ball exponent(0);
    for (long k = P; k >= 2; --k)
        exponent += eta[static_cast<std::size_t>(k)] / k * dyadic(-k * m) / (dyadic(k) - 1) * finite_share(k, n, m);
    // sum_{k>P} 2^{-km}/(k (2^k - 1)) <= sum_{k>P} 2^{-k(m+1)}
    widen(exponent, 1 - (P + 1) * (m + 1));
    const Ball last = n < 0 ? Ball(1) : 1 - dyadic(-(n + 1));
    return K * (1 - dyadic(-(m + 1))) / last * exp(exponent);
}

} // namespace touchstone::archard
