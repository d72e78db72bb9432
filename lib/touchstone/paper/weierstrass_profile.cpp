// SPDX-License-Identifier: MIT
#include "touchstone/paper/weierstrass_profile.hpp"

#include "touchstone/paper/weierstrass.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <vector>

namespace touchstone::weierstrass {
namespace {

/// x mod 1 in [0, 1)
Rational fraction(const Rational& x)
{
    Integer floor;
    mpz_fdiv_q(floor.get_mpz_t(), x.get_num_mpz_t(), x.get_den_mpz_t());
    return x - Rational(floor);
}

double log2_of(const Rational& r)
{
    // mpq -> double overflows for large terms; a short ball does not
    const WorkingPrecision precision(53);
    const Ball b = log(Ball(r)) / log(Ball(2));
    return arf_get_d(arb_midref(b.get()), ARF_RND_UP);
}

} // namespace

long terms_needed(const Rational& D, const Rational& gamma, slong bits)
{
    const WorkingPrecision precision(64);
    const double per_term = log2_of(gamma) * Rational(2 - D).get_d();
    const Ball z = bound<Ball>(Ball(D), Ball(gamma));
    const double extra = z.is_finite() ? std::log2(arf_get_d(arb_midref(z.get()), ARF_RND_UP)) : 1e9;
    const double n = (static_cast<double>(bits) + extra + 2) / per_term;
    if (!(n < 1e7)) throw std::length_error("more than ten million terms");
    return static_cast<long>(n) + 1;
}

Ball profile_by_terms(const Rational& x, const Rational& D, const Rational& gamma)
{
    const slong target = WorkingPrecision::bits();
    const long N = terms_needed(D, gamma, target);
    const slong bits = target + 32 + static_cast<slong>(std::log2(static_cast<double>(N) + 1));
    const double growth = log2_of(gamma);
    const WorkingPrecision precision(bits);
    const Ball r = amplitude_ratio<Ball>(Ball(D), Ball(gamma));
    Ball amplitude(1), z(0), phase;
    {
        const WorkingPrecision full(bits + static_cast<slong>(growth * static_cast<double>(N)) + 64);
        phase = Ball(Rational(2 * fraction(x)));
    }
    for (long n = 0; n < N; ++n) {
        // subtract the nearest even integer, exactly, so that the cosine works at `bits` only
        const slong remaining = bits + static_cast<slong>(growth * static_cast<double>(N - n)) + 64;
        Ball reduced = phase;
        {
            const WorkingPrecision full(remaining);
            arf_t even;
            arf_init(even);
            arf_mul_2exp_si(even, arb_midref(phase.get()), -1);
            arf_floor(even, even);
            arf_mul_2exp_si(even, even, 1);
            arb_sub_arf(phase.get(), phase.get(), even, remaining);
            arf_clear(even);
            reduced = phase;
            phase *= Ball(gamma);
        }
        z += amplitude * cos_pi(reduced);
        amplitude *= r;
    }
    const Ball rest = amplitude * bound<Ball>(Ball(D), Ball(gamma));
    arb_add_error(z.get(), rest.get());
    return z;
}

Ball profile_by_scaling(const Rational& x, const Rational& D, const Rational& gamma)
{
    const slong target = WorkingPrecision::bits();
    const long N = terms_needed(D, gamma, target);
    const slong bits = target + 32 + static_cast<slong>(std::log2(static_cast<double>(N) + 1));
    const WorkingPrecision precision(bits);
    const Ball log_r = Ball(Rational(D - 2)) * log(Ball(gamma));
    const Ball r = exp(log_r);

    // gamma = a/b, x = p/q: gamma^n x mod 1 is a^n p/(b^n q), its numerator kept modulo its denominator
    Integer numerator = x.get_num(), denominator = x.get_den();
    mpz_fdiv_r(numerator.get_mpz_t(), numerator.get_mpz_t(), denominator.get_mpz_t());
    const auto next_cosine = [&] {
        // floor(2 phase 2^(bits + 8)), so the phase is known to 2^-(bits + 8)
        Integer q = 2 * numerator;
        mpz_mul_2exp(q.get_mpz_t(), q.get_mpz_t(), static_cast<mp_bitcnt_t>(bits + 8));
        Integer remainder;
        mpz_fdiv_qr(q.get_mpz_t(), remainder.get_mpz_t(), q.get_mpz_t(), denominator.get_mpz_t());
        Ball phase(Rational(remainder == 0 ? q : Integer(2 * q + 1), remainder == 0 ? 1 : 2));
        if (remainder != 0) arb_add_error(phase.get(), Ball(Rational(1, 2)).get());
        arb_mul_2exp_si(phase.get(), phase.get(), -(bits + 8));
        numerator *= gamma.get_num();
        denominator *= gamma.get_den();
        mpz_fdiv_r(numerator.get_mpz_t(), numerator.get_mpz_t(), denominator.get_mpz_t());
        return cos_pi(phase);
    };

    const Ball zhat = 1 / (1 - r);
    Ball z(0);
    constexpr long block = 1024; // within a block z(x) = cos + r z(gamma x) from the inside out
    for (long first = 0; first < N; first += block) {
        std::vector<Ball> cosines;
        for (long n = first; n < std::min(N, first + block); ++n) cosines.push_back(next_cosine());
        Ball inner(0);
        if (first + block >= N) arb_add_error(inner.get(), zhat.get()); // z at the innermost scale
        for (auto c = cosines.rbegin(); c != cosines.rend(); ++c) inner = *c + r * inner;
        z += exp(first * log_r) * inner;
    }
    return z;
}

Exact profile_exact(const Rational& x, const Rational& D, const Rational& gamma)
{
    if (gamma.get_den() != 1) throw NotExact();
    constexpr std::size_t longest_orbit = 64; // angles with rational cosines have orbits of a few steps
    std::map<Rational, std::size_t> seen;
    std::vector<Exact> cosines;
    Rational phase = fraction(x);
    while (!seen.contains(phase)) {
        if (seen.size() > longest_orbit) throw NotExact();
        seen[phase] = cosines.size();
        cosines.push_back(cos_pi(Exact(Rational(2 * phase))));
        phase = fraction(phase * gamma);
    }
    const std::size_t start = seen[phase];
    const long period = static_cast<long>(cosines.size() - start);
    // r = gamma^(D-2) is asked for only where a cosine is not zero: at x = 1/4 and gamma = 5 none is
    const auto amplitude = [&](long n) { return n == 0 ? Exact(1) : Exact(gamma).power((D - 2) * n); };
    Exact z, cycle;
    for (std::size_t n = 0; n < cosines.size(); ++n) {
        if (cosines[n].is_zero()) continue;
        Exact& sum = n < start ? z : cycle;
        sum = sum + amplitude(static_cast<long>(n)) * cosines[n];
    }
    return cycle.is_zero() ? z : z + cycle / (Exact(1) - amplitude(period));
}

} // namespace touchstone::weierstrass
