// SPDX-License-Identifier: MIT
#include "touchstone/paper/weierstrass_profile.hpp"

#include "touchstone/paper/weierstrass.hpp"
#include "touchstone/rounding/decimal.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
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
    // n phases that grow by the bits of gamma's numerator each: the work, in bits to be touched
    constexpr double work_limit = 4e9;
    if (n * (static_cast<double>(bits) + n * log2_of(Rational(gamma.get_num()))) > work_limit)
        throw std::length_error("a phase of millions of bits for each of its terms");
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
    // An integer gamma keeps whole turns whole: they are dropped and the phase shortens. Any other needs them all.
    const bool whole = gamma.get_den() == 1;
    const slong size = 64 + static_cast<slong>(mpz_sizeinbase(x.get_num_mpz_t(), 2)); // of x, generously
    Ball amplitude(1), z(0), phase;
    {
        const WorkingPrecision full(bits + static_cast<slong>(growth * static_cast<double>(N)) + size);
        phase = Ball(Rational(2 * (whole ? fraction(x) : x)));
    }
    for (long n = 0; n < N; ++n) {
        const slong length = bits + static_cast<slong>(growth * static_cast<double>(whole ? N - n : N)) + size;
        const WorkingPrecision full(length);
        // subtract the nearest even integer, exactly, so that the cosine works at `bits` only
        arf_t even;
        arf_init(even);
        arf_mul_2exp_si(even, arb_midref(phase.get()), -1);
        arf_floor(even, even);
        arf_mul_2exp_si(even, even, 1);
        Ball reduced;
        arb_sub_arf(reduced.get(), phase.get(), even, length);
        arf_clear(even);
        phase = (whole ? reduced : phase) * Ball(gamma);
        const WorkingPrecision back(bits);
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

    // gamma = a/b, x = p/q: gamma^n x = a^n p/(b^n q), whole turns dropped only where gamma is an integer
    const bool whole = gamma.get_den() == 1;
    Integer numerator = x.get_num(), denominator = x.get_den();
    const auto next_cosine = [&] {
        Integer turn;
        mpz_fdiv_r(turn.get_mpz_t(), numerator.get_mpz_t(), denominator.get_mpz_t());
        const Ball phase = 2 * Ball(Rational(turn)) / Ball(Rational(denominator));
        numerator *= gamma.get_num();
        denominator *= gamma.get_den();
        if (whole) mpz_fdiv_r(numerator.get_mpz_t(), numerator.get_mpz_t(), denominator.get_mpz_t());
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

double profile(double x, double D, double gamma)
{
    const Rational X = exact_rational(x), d = exact_rational(D), g = exact_rational(gamma);
    try {
        for (slong bits = 80; bits <= 4096; bits *= 2) {
            const WorkingPrecision precision(bits);
            if (const auto z = nearest_double(profile_by_terms(X, d, g))) return *z;
        }
        return profile_exact(X, d, g).is_zero() ? 0.0 : std::numeric_limits<double>::quiet_NaN();
    }
    catch (const std::length_error&) {
        return std::numeric_limits<double>::quiet_NaN();
    }
    catch (const NotExact&) {
        return std::numeric_limits<double>::quiet_NaN();
    }
}

namespace {

/// The phases gamma^n x mod 1 for an integer gamma: distinct up to where they run into a cycle.
struct Orbit {
    std::vector<Rational> phases;
    std::size_t start = 0; ///< of the cycle
    long period() const { return static_cast<long>(phases.size() - start); }
};

Orbit orbit_of(const Rational& x, const Rational& gamma)
{
    constexpr std::size_t longest = 64;
    if (gamma.get_den() != 1) throw NotExact();
    std::map<Rational, std::size_t> seen;
    Orbit orbit;
    Rational phase = fraction(x);
    while (!seen.contains(phase)) {
        if (seen.size() > longest) throw NotExact();
        seen[phase] = orbit.phases.size();
        orbit.phases.push_back(phase);
        phase = fraction(phase * gamma);
    }
    orbit.start = seen[phase];
    return orbit;
}

/// Whether z(x) = 0 is proven. With s = gamma^(1/q), D = p/q, r = s^-t, t = 2q - p, and L the period,
///     N = 2 s^(t M) [ (1 - r^L) sum_{n<start} r^n c_n + sum_{n>=start} r^n c_n ],  M = number of phases,
/// is z times a positive number. The 2 c_n are algebraic integers and no power of s in N is negative, so N
/// is an algebraic integer, of degree at most d = q m, m the denominator of x. Every conjugate of s has the modulus
/// of s and every conjugate of 2 c_n is at most 2 in modulus, so every conjugate of N is at most B (conjugates_bound), as
/// 2 s^(t M) is. The product of all conjugates of a nonzero N is an integer: |N| >= B^-(d-1), and the bracket is at least B^-d.
bool vanishes(const Orbit& orbit, const Rational& x, const Rational& D, const Rational& gamma)
{
    constexpr double bit_limit = 20'000;
    const Rational e = 2 - D, d = x.get_den() * D.get_den();
    const auto bracket = [&] {
        const Ball r = pow(Ball(gamma), Ball(Rational(-e)));
        Ball before(0), cycle(0), amplitude(1);
        for (std::size_t n = 0; n < orbit.phases.size(); ++n) {
            (n < orbit.start ? before : cycle) += amplitude * cos_pi(Ball(Rational(2 * orbit.phases[n])));
            amplitude *= r;
        }
        Ball rL(1);
        for (long k = 0; k < orbit.period(); ++k) rL *= r;
        return (1 - rL) * before + cycle;
    };
    const auto smallest = [&] { return pow(conjugates_bound(static_cast<long>(orbit.phases.size()), e, gamma), Ball(Rational(-d))); };
    double bits_needed = 0;
    {
        const WorkingPrecision precision(64);
        if (!bracket().contains_zero()) return false; // the ordinary case
        bits_needed = -arf_get_d(arb_midref((log(smallest()) / log(Ball(2))).get()), ARF_RND_DOWN);
    }
    if (!(bits_needed < bit_limit)) return false;
    const WorkingPrecision precision(static_cast<slong>(bits_needed) + 128);
    return certainly(less(abs(bracket()), smallest()));
}

} // namespace

Ball conjugates_bound(long phases, const Rational& e, const Rational& gamma)
{
    return 4 * phases * pow(Ball(gamma), Ball(Rational(e * phases)));
}

Exact profile_exact(const Rational& x, const Rational& D, const Rational& gamma)
{
    if (x == 0) return Exact(1) / (Exact(1) - Exact(gamma).power(D - 2)); // (3.4), whatever gamma is
    const Orbit orbit = orbit_of(x, gamma);
    try {
        // r^n is asked for only where a cosine is not zero: at x = 1/4 and gamma = 5 none is
        const auto amplitude = [&](long n) { return n == 0 ? Exact(1) : Exact(gamma).power((D - 2) * n); };
        Exact z, cycle;
        for (std::size_t n = 0; n < orbit.phases.size(); ++n) {
            const Exact cosine = cos_pi(Exact(Rational(2 * orbit.phases[n])));
            if (cosine.is_zero()) continue;
            Exact& sum = n < orbit.start ? z : cycle;
            sum = sum + amplitude(static_cast<long>(n)) * cosine;
        }
        return cycle.is_zero() ? z : z + cycle / (Exact(1) - amplitude(orbit.period()));
    }
    catch (const NotExact&) {
        if (vanishes(orbit, x, D, gamma)) return Exact(0);
        throw;
    }
}

} // namespace touchstone::weierstrass
