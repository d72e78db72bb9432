// SPDX-License-Identifier: MIT
#include "touchstone/paper/gamma_product.hpp"

#include "touchstone/scalar/flint_headers.hpp"
#include "touchstone/scalar/log_factorial.hpp"
#if __has_include(<flint/bernoulli.h>)
#include <flint/bernoulli.h>
#else
#include <bernoulli.h>
#endif

#include <algorithm>
#include <cmath>
#include <numeric>

namespace touchstone::archard {
namespace {

/// The product with what all its parts need: z = twice_z/2 and the sum W of the weights.
struct Shifted {
    long twice_z, first;
    const std::vector<unsigned long>& weights;
    unsigned long W;
    slong bits;

    long last() const { return first + static_cast<long>(weights.size()) - 1; }
    unsigned long weight(long t) const { return weights[static_cast<std::size_t>(t - first)]; }
    Ball z() const { return Ball(twice_z) / 2; }
    /// z - 2^-t is this over 2^t
    Integer numerator(long t) const { return (Integer(twice_z) << static_cast<mp_bitcnt_t>(t - 1)) - 1; }
};

/// Add +-2^exponent to the ball.
void widen(Ball& b, slong exponent)
{
    const Ball error = power_of_two<Ball>(exponent);
    arb_add_error(b.get(), error.get());
}

/// sum_t weight 2^-kt to about so many bits of it.
Ball sum_of_powers_of_x(const Shifted& g, long k, slong bits)
{
    Ball sum(0), term;
    for (long t = g.first; t <= g.last(); ++t) {
        if ((t - g.first) * k > bits) {
            widen(sum, static_cast<slong>(FLINT_BIT_COUNT(g.W)) - t * k);
            break;
        }
        arb_set_ui(term.get(), g.weight(t));
        arb_mul_2exp_si(term.get(), term.get(), -t * k);
        arb_add(sum.get(), sum.get(), term.get(), bits);
    }
    return sum;
}

/// sum_t weight (z - x - 1/2) log(1 - x/z) = -sum_{k>=1} z^-k/k ((z - 1/2) s_k - s_{k+1}), s_k = sum_t weight x^k.
/// The terms after K are below z W (2^-first/z)^k each, together below twice the first of them.
Ball sum_of_logarithms(const Shifted& g)
{
    const double bits_a_term = std::log2(static_cast<double>(g.twice_z)) - 1 + static_cast<double>(g.first);
    const auto size = static_cast<slong>(FLINT_BIT_COUNT(g.W)) + static_cast<slong>(FLINT_BIT_COUNT(g.twice_z));
    const long K = static_cast<long>(static_cast<double>(g.bits + size) / bits_a_term) + 1;
    Ball sum(0), power(1), s = sum_of_powers_of_x(g, 1, g.bits + size);
    for (long k = 1; k <= K; ++k) {
        const WorkingPrecision precision(std::max<slong>(64, g.bits + size - static_cast<slong>(bits_a_term * static_cast<double>(k - 1))));
        Ball next = sum_of_powers_of_x(g, k + 1, WorkingPrecision::bits());
        power = 2 * power / g.twice_z;
        const Ball term = power * ((g.z() - Ball(1) / 2) * s - next) / k;
        {
            const WorkingPrecision whole(g.bits + size);
            sum -= term;
        }
        s = std::move(next);
    }
    widen(sum, size + 1 - static_cast<slong>(std::floor(bits_a_term * static_cast<double>(K + 1))));
    return sum;
}

/// How many terms of Stirling's series are needed: the first one left out, (2L)! |B_{2L+2}|/(2L+2)! y^-(2L+1), is small enough. At most
/// z/3, which the shift makes more than are needed.
long stirling_terms(const Shifted& g)
{
    const double z = static_cast<double>(g.twice_z - 1) / 2, wanted = -static_cast<double>(g.bits) * std::log(2.0);
    long L = 1;
    const auto left_out = [&](long terms) { // its logarithm; B_2l as below
        const double after = static_cast<double>(2 * terms);
        return std::log(4.0 * static_cast<double>(g.W)) + log_factorial(after) - (after + 2) * std::log(2 * M_PI) -
               (after + 1) * std::log(z);
    };
    while (left_out(L) > wanted && 6 * L < g.twice_z) ++L;
    return L;
}

constexpr long terms_a_word = 13; ///< B_2l/(2l)! falls by (2 pi)^2 a term: by more than 2^64 in so many

/// sums[l - 1] = sum_t weight (2l - 2)!/y^(2l-1), y = z - x, in units of 2^-F 2^(64 floor((l-1)/terms_a_word)). Each u is the one
/// before times (2l - 1)(2l)/y^2 < 1/2 (as l <= z/3), rounded down: within 2 units.
std::vector<Integer> sums_over_x(const Shifted& g, long L, slong F)
{
    std::vector<Integer> sums(static_cast<std::size_t>(L));
    Integer u;
    for (long t = g.first; t <= g.last(); ++t) {
        const Integer y = g.numerator(t); // over 2^t
        const auto shift = static_cast<mp_bitcnt_t>(t);
        u = (Integer(1) << (static_cast<mp_bitcnt_t>(F) + shift)) / y;
        for (long l = 1; l <= L; ++l) {
            mpz_addmul_ui(sums[static_cast<std::size_t>(l - 1)].get_mpz_t(), u.get_mpz_t(), g.weight(t));
            const auto factor = static_cast<unsigned long>((2 * l - 1) * (2 * l));
            if (2 * mpz_sizeinbase(y.get_mpz_t(), 2) <= 64) { // then 2^2t times the factor, below 2^2t y^2/2, is a word too
                const unsigned long word = y.get_ui();
                mpz_mul_ui(u.get_mpz_t(), u.get_mpz_t(), factor << (2 * shift));
                mpz_tdiv_q_ui(u.get_mpz_t(), u.get_mpz_t(), word * word);
            }
            else {
                mpz_mul_ui(u.get_mpz_t(), u.get_mpz_t(), factor);
                for (int twice = 0; twice < 2; ++twice) {
                    mpz_mul_2exp(u.get_mpz_t(), u.get_mpz_t(), shift);
                    mpz_tdiv_q(u.get_mpz_t(), u.get_mpz_t(), y.get_mpz_t());
                }
            }
            if (l % terms_a_word == 0) mpz_tdiv_q_2exp(u.get_mpz_t(), u.get_mpz_t(), 64);
        }
    }
    return sums;
}

/// sum_t weight (sum_l B_2l/(2l (2l - 1)) y^(1-2l)), Stirling's series behind its elementary part.
Ball stirling_series(const Shifted& g)
{
    const long L = stirling_terms(g);
    const auto size = static_cast<slong>(FLINT_BIT_COUNT(g.W));
    const slong F = g.bits + size + 8;
    const std::vector<Integer> sums = sums_over_x(g, L, F);
    bernoulli_cache_compute(2 * L + 1);
    Ball series(0), inverse_factorial(1), bernoulli;
    for (long l = 1; l <= L; ++l) {
        const WorkingPrecision precision(std::max<slong>(64, F - 5 * (l - 1)));
        inverse_factorial = inverse_factorial / ((2 * l - 1) * (2 * l));
        arb_bernoulli_ui(bernoulli.get(), static_cast<ulong>(2 * l), WorkingPrecision::bits());
        Ball v{Rational(sums[static_cast<std::size_t>(l - 1)])};
        widen(v, size + 1);
        arb_mul_2exp_si(v.get(), v.get(), 64 * ((l - 1) / terms_a_word) - F);
        const Ball term = bernoulli * inverse_factorial * v;
        const WorkingPrecision whole(F);
        series += term;
    }
    const WorkingPrecision short_numbers(64);
    const Ball rest = Ball(Rational(Integer(g.W))) * stirling_remainder(L, g.twice_z);
    arb_add_error(series.get(), rest.get());
    return series;
}

/// The product over j in [from, to) of 2^t (z - j - x) = (2 z - 2 j) 2^(t-1) - 1, an integer: of as many factors as fit into a word,
/// of words, of halves.
Integer exact_factors(const Shifted& g, long t, long from, long to)
{
    const slong bits = static_cast<slong>(FLINT_BIT_COUNT(g.twice_z)) + t - 1; // of one factor
    const long in_a_word = std::max<long>(1, 64 / bits);
    if (to - from > 16 * in_a_word) {
        const long middle = (from + to) / 2;
        return exact_factors(g, t, from, middle) * exact_factors(g, t, middle, to);
    }
    Integer product = 1;
    mpz_realloc2(product.get_mpz_t(), static_cast<mp_bitcnt_t>((to - from + 2) * bits + 64));
    for (long j = from; j < to; j += in_a_word) {
        if (bits > 64) {
            product *= (Integer(g.twice_z - 2 * j) << static_cast<mp_bitcnt_t>(t - 1)) - 1;
            continue;
        }
        unsigned long word = 1;
        for (long i = j; i < std::min(to, j + in_a_word); ++i)
            word *= (static_cast<unsigned long>(g.twice_z - 2 * i) << (t - 1)) - 1;
        mpz_mul_ui(product.get_mpz_t(), product.get_mpz_t(), word);
    }
    return product;
}

/// The same, rounded as soon as it is longer than the working precision.
Ball factors(const Shifted& g, long t, long from, long to)
{
    const long size = (to - from) * (static_cast<long>(FLINT_BIT_COUNT(g.twice_z)) + t - 1);
    if (size <= WorkingPrecision::bits() || to - from < 2) return Ball(Rational(exact_factors(g, t, from, to)));
    const long middle = (from + to) / 2;
    return factors(g, t, from, middle) * factors(g, t, middle, to);
}

} // namespace

Ball stirling_remainder(long L, long twice_z)
{
    const Ball y = Ball(twice_z - 1) / 2;
    Ball factorial;
    arb_fac_ui(factorial.get(), static_cast<ulong>(2 * L), WorkingPrecision::bits());
    return 4 * factorial / pow(2 * pi<Ball>(), Ball(2 * L + 2)) / pow(y, Ball(2 * L + 1));
}

Ball gamma_product(long halves, long first, const std::vector<unsigned long>& weights)
{
    const slong target = std::max<slong>(64, WorkingPrecision::bits());
    const long N = static_cast<long>(static_cast<double>(target) * 0.6) + 8;
    const Shifted g{halves + 2 * N, first, weights, std::accumulate(weights.begin(), weights.end(), 0ul), target + 8};
    if (g.W == 0) return Ball(1);
    const slong size_of_logarithm = static_cast<slong>(FLINT_BIT_COUNT(g.W) + FLINT_BIT_COUNT(g.twice_z)) + 5;
    const WorkingPrecision precision(g.bits + size_of_logarithm);

    const Ball z = g.z(), W(Rational(Integer(g.W))), X = sum_of_powers_of_x(g, 1, WorkingPrecision::bits());
    Ball log_twice_z, half_log_2_pi;
    arb_log_ui(log_twice_z.get(), static_cast<ulong>(g.twice_z), WorkingPrecision::bits());
    arb_const_log_sqrt2pi(half_log_2_pi.get(), WorkingPrecision::bits());
    const Ball log_z = log_twice_z - log(Ball(2));
    const Ball logarithm = log_z * (W * (z - Ball(1) / 2) - X) + sum_of_logarithms(g) - W * z + X + W * half_log_2_pi + stirling_series(g);

    const WorkingPrecision narrow(g.bits);
    Ball below(1);
    slong denominators = 0;
    for (long t = first; t <= g.last(); ++t) {
        Ball row = factors(g, t, 1, N + 1);
        arb_pow_ui(row.get(), row.get(), g.weight(t), WorkingPrecision::bits());
        below *= row;
        denominators += t * N * static_cast<slong>(g.weight(t));
    }
    Ball product = exp(logarithm) / below;
    arb_mul_2exp_si(product.get(), product.get(), denominators);
    return product;
}

} // namespace touchstone::archard
