// SPDX-License-Identifier: MIT
#include "touchstone/paper/archard_constants.hpp"

#include "touchstone/paper/archard.hpp"
#include "touchstone/paper/gamma_product.hpp"

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

/// x as an integer number of 2^-F, towards zero. The radius of x is at most 2^-F, or the answer is false.
bool to_fixed_point(Integer& result, const Ball& x, slong F)
{
    if (mag_cmp_2exp_si(arb_radref(x.get()), -F) > 0) return false;
    fmpz_t units;
    fmpz_init(units);
    arf_get_fmpz_fixed_si(units, arb_midref(x.get()), -F);
    fmpz_get_mpz(result.get_mpz_t(), units);
    fmpz_clear(units);
    return true;
}

} // namespace

/// zeta(2), ..., zeta(last), the k-th to about 2^-(bits - k step): the even ones are Bernoulli numbers times powers of pi,
/// the odd ones by Ramanujan's formula (Berndt, Rocky Mountain J. Math. 7, 1977, theorem 2.2): for s = 2n + 1 > 1 and alpha beta = pi^2,
///     alpha^-n (zeta(s)/2 + S(alpha)) - (-beta)^-n (zeta(s)/2 + S(beta))
///         = -2^(2n) sum_{j=0}^{n+1} (-1)^j b_j b_{n+1-j} alpha^(n+1-j) beta^j,
/// S(alpha) = sum_k k^-s/(e^(2 alpha k) - 1), b_j = B_2j/(2j)! = -(-1)^j 2 zeta(2j)/(2 pi)^(2j), zeta(0) = -1/2.
/// At alpha = pi with odd n, and for even n from its derivative there, with h = n + 1, x_k = 1/(e^(2 pi k) - 1), X_s = sum x_k k^-s
/// and Y_s = sum x_k (1 + x_k) k^-s:
///     zeta(s) = -2 X_s - (1/pi) sum_{j=0}^h (-1)^j zeta(2j) zeta(2h - 2j)                         s = 3, 7, 11, ...
///     zeta(s) = -2 X_s - (4 pi/n) Y_{s-1} + (2/(n pi)) sum_{j=0}^h (-1)^j j zeta(2j) zeta(2h - 2j)    s = 5, 9, 13, ...
/// X and Y in fixed point, 2^-F at first and 2^(4 step) times larger units at each next t: u = x_k/k^(4t+3) gives s = 4t + 3 and, times
/// k^2, 4t + 1. u is within 4 of them: its error is divided by k^4 2^(4 step) and joined by two truncations, neither of which happens where
/// that is 1. The terms k > N of either sum are below 1.01 e^(-2 pi (N+1)) together.
std::vector<Ball> zeta_values(long last, slong bits, slong step)
{
    std::vector<Ball> zeta(static_cast<std::size_t>(last + 2), Ball::indeterminate());
    const long N = static_cast<long>(static_cast<double>(bits) / 9.0647) + 2; // log2 e^(2 pi) > 9.0647
    const slong size_of_N = static_cast<slong>(FLINT_BIT_COUNT(N));
    const slong F = bits + 3 * size_of_N + 8;
    const auto drop = static_cast<mp_bitcnt_t>(4 * step);
    std::vector<Integer> X(static_cast<std::size_t>(last + 4)), Y(X.size());
    Integer u, v;
    Ball q, q_to_k(1);
    {
        const WorkingPrecision precision(F + 32);
        q = exp(-2 * pi<Ball>());
    }
    for (long k = 1; k <= N; ++k) {
        const WorkingPrecision precision(std::max<slong>(64, F + 32 - 9 * k));
        q_to_k *= q;
        const Ball x = q_to_k / (1 - q_to_k);
        if (!to_fixed_point(u, x, F) || !to_fixed_point(v, x * (1 + x), F)) return zeta; // of which nothing is known then
        const auto square = static_cast<unsigned long>(k) * static_cast<unsigned long>(k);
        mpz_tdiv_q_ui(u.get_mpz_t(), u.get_mpz_t(), square * static_cast<unsigned long>(k));
        for (long s = 0; s <= last && v != 0; s += 4) { // u <= v
            X[static_cast<std::size_t>(s + 3)] += u;
            mpz_addmul_ui(X[static_cast<std::size_t>(s + 1)].get_mpz_t(), u.get_mpz_t(), square);
            Y[static_cast<std::size_t>(s)] += v;
            for (Integer* term : {&u, &v}) {
                mpz_tdiv_q_2exp(term->get_mpz_t(), term->get_mpz_t(), drop);
                mpz_tdiv_q_ui(term->get_mpz_t(), term->get_mpz_t(), square * square);
            }
        }
    }
    const auto sum = [&](const Integer& units, long s) {
        Ball value{Rational(units)};
        widen(value, 3 * size_of_N + 3); // 4 N units of u, times k^2; the terms after N make less than N^3/64
        arb_mul_2exp_si(value.get(), value.get(), static_cast<slong>(drop) * (s / 4) - F);
        return value;
    };

    const long h_last = (last + 1) / 2;
    std::vector<Ball> Z(static_cast<std::size_t>(h_last + 1)), alternating(Z.size()), weighted(Z.size());
    for (long j = 0; j <= h_last; ++j) {
        Ball& value = Z[static_cast<std::size_t>(j)];
        if (j == 0) value = Ball(-1) / 2;
        else arb_zeta_ui_bernoulli(value.get(), static_cast<ulong>(2 * j), std::max<slong>(64, bits + 32 - 2 * (j - 1) * step));
        if (j > 0 && 2 * j <= last) zeta[static_cast<std::size_t>(2 * j)] = value;
        alternating[static_cast<std::size_t>(j)] = j % 2 == 0 ? value : -value;
        arb_mul_si(weighted[static_cast<std::size_t>(j)].get(), alternating[static_cast<std::size_t>(j)].get(), j, bits + 32);
    }
    static_assert(sizeof(Ball) == sizeof(arb_struct)); // so that a vector of balls is a vector of Arb's
    for (long s = 3; s <= last; s += 2) {
        const WorkingPrecision precision(std::max<slong>(64, bits + 32 - s * step));
        const long n = (s - 1) / 2, h = n + 1;
        const auto& left = n % 2 == 1 ? alternating : weighted;
        Ball closed;
        arb_dot(closed.get(), nullptr, 0, left.front().get(), 1, Z[static_cast<std::size_t>(h)].get(), -1, h + 1, WorkingPrecision::bits());
        Ball value = -2 * sum(X[static_cast<std::size_t>(s)], s);
        if (n % 2 == 1) value -= closed / pi<Ball>();
        else value += 2 * closed / (n * pi<Ball>()) - 4 * pi<Ball>() / n * sum(Y[static_cast<std::size_t>(s - 1)], s);
        zeta[static_cast<std::size_t>(s)] = std::move(value);
    }
    return zeta;
}

Ball K_gamma_product(long n)
{
    const slong target = WorkingPrecision::bits();
    const WorkingPrecision precision(target + guard_bits);
    const slong bits = target + guard_bits;
    const long m = std::max(4L, static_cast<long>(0.33 * std::sqrt(static_cast<double>(bits))));
    const long direct = n < 0 ? m : std::min(n, m);
    // With x_i = 2^-(i+2), b_i = Gamma(3/2 - x_i) and a_i = Gamma(2 - x_i) the factor is 2^(1 - x_{i-1}) b_i/(sqrt(pi) a_i), and by the
    // duplication formula a_i b_i = 2^(x_{i-1} - 2) sqrt(pi) (2 - x_{i-1}) a_{i-1}, from a_{-1} = sqrt(pi)/2. So b_i is left in a_i and in
    // all after it, and in its own factor: direct + 1 - i times.
    const Ball root_pi = sqrt(pi<Ball>());
    Ball K = 2 / pi<Ball>(), a = root_pi / 2, power = sqrt(Ball(2)); // 2^x_{i-1}
    std::vector<unsigned long> times_b;
    for (long i = 0; i < direct; ++i) {
        a *= power * root_pi * (2 - dyadic(-(i + 1))) / 4; // a_i b_0 ... b_i
        K *= 2 / (power * root_pi * a);
        power = sqrt(power);
        times_b.push_back(static_cast<unsigned long>(direct + 1 - i));
    }
    K *= gamma_product(3, 2, times_b);
    if (direct == n) return K;

    // log step as a power series in x = 2^-(i+2): -x + sum_{k>=2} e_k x^k/k,
    // e_k = zeta(k, 3/2) - zeta(k, 2) = (2^k - 2) zeta(k) - 2^k + 1, which loses k log2(3) leading bits
    const long P = static_cast<long>(static_cast<double>(bits) / (static_cast<double>(m) + 2.5)) + 2;
    const auto zeta = zeta_values(P, bits, m + 1);
    Ball logarithm(0);
    for (long k = P; k >= 2; --k) {
        const WorkingPrecision wider(std::max<slong>(64, bits + 2 * P - k * (m + 1)));
        const Ball e = (dyadic(k) - 2) * zeta[static_cast<std::size_t>(k)] - dyadic(k) + 1;
        const Ball term = e / k * dyadic(-k * (m + 1)) / (dyadic(k) - 1) * finite_share(k, n, m);
        const WorkingPrecision all(bits);
        logarithm += term;
    }
    logarithm -= dyadic(-(m + 1)) * finite_share(1, n, m);
    // sum_{k>P} (2/3)^k/k 2^{-k(m+1)}/(2^k - 1) <= sum_{k>P} 2 q^k, q = 2^-(m+1)/3 < 2^-(m+2.5)
    widen(logarithm, 2 - static_cast<slong>(std::floor(static_cast<double>(P + 1) * (static_cast<double>(m) + 2.5))));
    return K * exp(logarithm);
}

} // namespace touchstone::archard
