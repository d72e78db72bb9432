// SPDX-License-Identifier: MIT
#include "touchstone/catalogue/contact_exact.hpp"

#include "touchstone/paper/peaks.hpp"
#include "touchstone/paper/westergaard.hpp"
#include "touchstone/transfer/full_contact.hpp"

namespace touchstone::contact_exact {
namespace {

bool partial_contact(const Inputs& in) { return in.real("load") <= 1 && in.compare_G(2) > 0; }

/// G if it is rational.
std::optional<Rational> rational_G(const Inputs& in)
{
    try {
        if (const Exact G = in.G_exact(); G.is_rational()) return G.rational();
    }
    catch (const NotExact&) {
    }
    return std::nullopt;
}

/// Whether p_n > p almost everywhere, p >= 0: load - (1 + G + ... + G^n) >= p, by (5.2), (5.4).
bool everywhere_above(const Inputs& in, long n, const Rational& p)
{
    const Rational load = in.real("load") - p;
    if (load < 1) return false;
    const WorkingPrecision precision(256);
    const auto tie = [&](long scale) { // G irrational: G^k = r with r rational, and no sum of such powers is rational
        const auto G = rational_G(in);
        if (!G) return false;
        Rational sum = 1, power = 1;
        for (long k = 0; k < scale; ++k) sum += power *= *G;
        return load >= sum;
    };
    return transfer::scales_in_full_contact(Ball(load), in.G_ball(), n + 1, tie) > n;
}

/// p_n^max in p*_0: G^{n+1} x_n by (5.2), (5.6).
Ball highest_pressure(const Inputs& in, long n)
{
    const Ball G = in.G_ball();
    Ball unit;
    arb_pow_ui(unit.get(), G.get(), static_cast<ulong>(n + 1), WorkingPrecision::bits());
    return unit * peaks::iterate(n, Ball(in.real("load")), G);
}

bool above_support(const Inputs& in, long n, const Rational& p)
{
    const WorkingPrecision precision(256);
    return certainly(less(highest_pressure(in, n), Ball(p)));
}

/// Whether p = p_n^max exactly: f(x) = (x + 1)/G for x >= 1, 2 x^(1/2)/G for x < 1 (5.5), once irrational, stays so while G is rational.
bool at_edge(const Inputs& in, long n, const Rational& p)
{
    {
        const WorkingPrecision precision(512);
        if (!highest_pressure(in, n).contains(p)) return false;
    }
    const auto G = rational_G(in);
    if (!G) throw NotExact();
    Rational x = in.real("load"), unit = 1;
    for (long k = 0; k <= n; ++k, unit *= *G) {
        if (x < 1) {
            if (!mpz_perfect_square_p(x.get_num_mpz_t()) || !mpz_perfect_square_p(x.get_den_mpz_t())) return false;
            x = 2 * Rational(mpz_class(sqrt(x.get_num())), mpz_class(sqrt(x.get_den())));
        }
        else x += 1;
        x /= *G;
    }
    return p == x * unit;
}

/// p certainly less than p_n^min > 0, in full contact everywhere.
bool below_support(const Inputs& in, long n, const Rational& p)
{
    const WorkingPrecision precision(256);
    return transfer::scales_in_full_contact(Ball(Rational(in.real("load") - p)), in.G_ball(), n + 1, [](long) { return false; }) > n;
}

/// q_n ~ p towards p = 0, (2.19), while scale n is in partial contact everywhere.
bool density_starts_at_zero(const Inputs& in, long n) { return n == 0 ? in.real("load") < 1 : partial_contact(in); }

} // namespace

Exact area(const Inputs& in, long n)
{
    if (everywhere_above(in, n, 0)) return Exact(1);
    if (n > 0) throw NotExact();
    return 2 * westergaard::half_width(Exact(in.real("load")));
}

Exact segment_count(const Inputs& in)
{
    const long n = in.integer("n");
    if (everywhere_above(in, n - 1, 0)) return Exact(power(in.real("gamma"), n));
    return area(in, n - 1) * Exact(in.real("gamma"));
}

Exact exceedance(const Inputs& in)
{
    const long n = in.integer("n");
    const Rational& p = in.real("p");
    if (above_support(in, n, p) || at_edge(in, n, p)) return Exact(0);
    if (everywhere_above(in, n, p)) return Exact(1);
    throw NotExact();
}

Exact density(const Inputs& in)
{
    const long n = in.integer("n");
    const Rational& p = in.real("p");
    if ((p == 0 && density_starts_at_zero(in, n)) || above_support(in, n, p) || below_support(in, n, p)) return Exact(0);
    if (n >= 2 && (at_edge(in, n, p) || everywhere_above(in, n, p)))
        return Exact(0); // it goes with |p - p_n^max|^((n-1)/2) there, as at p_n^min
    throw NotExact();
}

Exact pressure_of_segments(const Inputs& in)
{
    const auto G = rational_G(in);
    if (!G) throw NotExact();
    const Exact s = sin_pi(Exact(in.real("a")));
    return s * s * Exact(power(*G, in.integer("n")));
}

Exact segment_density(const Inputs& in)
{
    const WorkingPrecision precision(256);
    const long n = in.integer("n");
    const Rational& a = in.real("a");
    if (n > 2 && a == Rational(1, 2)) return Exact(0); // sin(2 pi a) = 0, and q_{n-1} is finite
    if (a == 0 && density_starts_at_zero(in, n - 1)) return Exact(0);
    const Ball s = ScalarTraits<Ball>::sin_pi(Ball(a));
    Ball unit;
    arb_pow_ui(unit.get(), in.G_ball().get(), static_cast<ulong>(n), WorkingPrecision::bits());
    const Ball p = unit * s * s; // no pressures, no segments
    if (certainly(less(highest_pressure(in, n - 1), p))) return Exact(0);
    const auto none = [](long) { return false; };
    if (transfer::scales_in_full_contact(Ball(in.real("load")) - p, in.G_ball(), n, none) >= n) return Exact(0);
    throw NotExact();
}

} // namespace touchstone::contact_exact
