// SPDX-License-Identifier: MIT
#include "touchstone/paper/archard_constants.hpp"

#include "touchstone/paper/archard.hpp"

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

/// eta(2), ..., eta(last), the k-th to about 2^-(bits - k step): in fixed point, the k-th sum in units of
/// 2^-(F - k step). A term loses less than one unit to each of two truncations, the first divided by
/// (j + 1) 2^step at the next k: in all below 4 units, so a sum of N terms is within 4N units.
std::vector<Ball> eta_values(long last, slong bits, slong step)
{
    const slong F = bits + 32;
    const long N = static_cast<long>(static_cast<double>(bits) / 2.5431) + 2; // log2(3 + sqrt 8) > 2.5431
    // c_j of the accelerated sum, integers (archard::eta has the same recurrence)
    Integer before = 1, d = 3;
    for (long j = 1; j < N; ++j) {
        Integer next = 6 * d - before;
        before = std::move(d);
        d = std::move(next);
    }
    std::vector<Integer> sums(static_cast<std::size_t>(last + 1));
    Integer b = -1, c = -d, term;
    for (long j = 0; j < N; ++j) {
        c = b - c;
        mpz_mul_2exp(term.get_mpz_t(), c.get_mpz_t(), static_cast<mp_bitcnt_t>(F));
        mpz_tdiv_q(term.get_mpz_t(), term.get_mpz_t(), d.get_mpz_t());
        for (long k = 1; k <= last && term != 0; ++k) {
            if (step < 40) mpz_tdiv_q_ui(term.get_mpz_t(), term.get_mpz_t(), static_cast<unsigned long>(j + 1) << step);
            else {
                mpz_tdiv_q_2exp(term.get_mpz_t(), term.get_mpz_t(), static_cast<mp_bitcnt_t>(step));
                mpz_tdiv_q_ui(term.get_mpz_t(), term.get_mpz_t(), static_cast<unsigned long>(j + 1));
            }
            sums[static_cast<std::size_t>(k)] += term;
        }
        b = b * (2 * (Integer(j) + N) * (Integer(j) - N)) / ((2 * Integer(j) + 1) * (Integer(j) + 1));
    }
    std::vector<Ball> eta(sums.size());
    for (long k = 2; k <= last; ++k) {
        Ball& value = eta[static_cast<std::size_t>(k)];
        value = Ball(Rational(sums[static_cast<std::size_t>(k)]));
        arb_mul_2exp_si(value.get(), value.get(), k * step - F);
        widen(value, k * step - F + 2 + static_cast<slong>(mpz_sizeinbase(Integer(N).get_mpz_t(), 2)));
        widen(value, 1 - static_cast<slong>(std::floor(2.5431 * static_cast<double>(N))));
    }
    return eta;
}

/// zeta(2), ..., zeta(last), the k-th to about 2^-(bits - k step), a block of equal precision at a time.
std::vector<Ball> zeta_values(long last, slong bits, slong step)
{
    constexpr long block = 16;
    std::vector<Ball> zeta(static_cast<std::size_t>(last + 1));
    for (long first = 2; first <= last; first += block) { // first is even, like block
        const long size = std::min(block, last - first + 1);
        arb_ptr values = _arb_vec_init(size);
        const slong precision = std::max<slong>(bits - first * step, 64);
        for (long k = first; k < first + size; k += 2) // even ones are Bernoulli numbers times powers of pi
            arb_zeta_ui_bernoulli(zeta[static_cast<std::size_t>(k)].get(), static_cast<ulong>(k), precision);
        arb_zeta_ui_vec_odd(values, static_cast<ulong>(first + 1), size / 2, precision);
        for (long k = 0; k < size / 2; ++k) arb_swap(zeta[static_cast<std::size_t>(first + 1 + 2 * k)].get(), values + k);
        _arb_vec_clear(values, size);
    }
    return zeta;
}

} // namespace

Ball K_gamma_product(long n)
{
    const slong target = WorkingPrecision::bits();
    const WorkingPrecision precision(target + guard_bits);
    const slong bits = target + guard_bits;
    const long m = std::max(4L, static_cast<long>(0.3 * std::sqrt(static_cast<double>(bits))));
    const long direct = n < 0 ? m : std::min(n, m);
    Ball K = 2 / pi<Ball>();
    for (long i = 0; i < direct; ++i) K *= step(delta<Ball>(i));
    if (direct == n) return K;

    // log step as a power series in x = 2^-(i+2): -x + sum_{k>=2} e_k x^k/k,
    // e_k = zeta(k, 3/2) - zeta(k, 2) = (2^k - 2) zeta(k) - 2^k + 1, which loses k log2(3) leading bits
    const long P = static_cast<long>(static_cast<double>(bits) / (static_cast<double>(m) + 2.5)) + 2;
    const auto zeta = zeta_values(P, bits, m + 1);
    Ball logarithm(0);
    for (long k = P; k >= 2; --k) {
        const WorkingPrecision wider(bits + 2 * P);
        const Ball e = (dyadic(k) - 2) * zeta[static_cast<std::size_t>(k)] - dyadic(k) + 1;
        logarithm += e / k * dyadic(-k * (m + 1)) / (dyadic(k) - 1) * finite_share(k, n, m);
    }
    logarithm -= dyadic(-(m + 1)) * finite_share(1, n, m);
    // sum_{k>P} (2/3)^k/k 2^{-k(m+1)}/(2^k - 1) <= sum_{k>P} 2 q^k, q = 2^-(m+1)/3 < 2^-(m+2.5)
    widen(logarithm, 2 - static_cast<slong>(std::floor(static_cast<double>(P + 1) * (static_cast<double>(m) + 2.5))));
    return K * exp(logarithm);
}

Ball K_eta_series(long n)
{
    const slong target = WorkingPrecision::bits();
    const WorkingPrecision precision(target + guard_bits);
    const slong bits = target + guard_bits;
    const long m = std::max(5L, static_cast<long>(0.5 * std::sqrt(static_cast<double>(bits))));
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
