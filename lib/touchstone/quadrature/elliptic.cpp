// SPDX-License-Identifier: MIT
#include "touchstone/quadrature/elliptic.hpp"

#include "touchstone/quadrature/endpoint_number.hpp"
#include "touchstone/quadrature/fixed_means.hpp"
#include "touchstone/quadrature/lemmas.hpp"
#include "touchstone/quadrature/upper.hpp"
#include "touchstone/quadrature/widen.hpp"

#include <algorithm>
#include <limits>
#include <optional>

namespace touchstone::quadrature {
namespace {

Ball real_part(const Ball& x) { return x; }
Ball real_part(const ComplexBall& z) { return z.real(); }

// These work in place, because the means are most of what K and E cost.
void shift(Ball& x, slong e) { arb_mul_2exp_si(x.get(), x.get(), e); }
void shift(ComplexBall& z, slong e) { acb_mul_2exp_si(z.get(), z.get(), e); }
void subtract(Ball& x, const Ball& a, const Ball& b, slong bits) { arb_sub(x.get(), a.get(), b.get(), bits); }
void subtract(ComplexBall& z, const ComplexBall& a, const ComplexBall& b, slong bits) { acb_sub(z.get(), a.get(), b.get(), bits); }
void multiply(Ball& x, const Ball& a, const Ball& b, slong bits) { arb_mul(x.get(), a.get(), b.get(), bits); }
void multiply(ComplexBall& z, const ComplexBall& a, const ComplexBall& b, slong bits) { acb_mul(z.get(), a.get(), b.get(), bits); }
void principal_root(Ball& x, const Ball& a, slong bits) { arb_sqrt(x.get(), a.get(), bits); }
void principal_root(ComplexBall& z, const ComplexBall& a, slong bits) { acb_sqrt_analytic(z.get(), a.get(), 1, bits); }

Ball lower_ball(const Ball& x)
{
    Ball low;
    arb_get_lbound_arf(arb_midref(low.get()), x.get(), 53);
    return low;
}

double log2_radius(const Ball& x) { return mag_get_d_log2_approx(arb_radref(x.get())); }
double log2_radius(const ComplexBall& z) { return std::max(log2_radius(z.real()), log2_radius(z.imag())); }

/// The least real part of either, as a number.
template <class V>
Ball least_real_part(const V& a, const V& b)
{
    const Ball of_a = lower_ball(real_part(a)), of_b = lower_ball(real_part(b));
    return arb_lt(of_a.get(), of_b.get()) != 0 ? of_a : of_b;
}

/// K/pi and E/pi: a_0 = 1, b_0 = sqrt v, c_n = (a_(n-1) - b_(n-1))/2, K = pi/(2 a), E = K (1 - m/2 - sum over n >= 1 of 2^(n-1) c_n^2), a
/// the limit; all means have a real part of delta = min(Re a_n, Re b_n) at least from n on (lemmas.hpp). E where it is asked for.
template <class V>
Elliptic<V> by_means(const V& v, bool with_e)
{
    constexpr int most = 64;
    constexpr double spare = 4; // bits of a number; of a box the means are no better known than it is wide
    const slong bits = WorkingPrecision::bits();
    V a(1), b = analytic::sqrt(v), sum, c, product;
    if (with_e) {
        sum = V(1) - v;
        shift(sum, -1);
    }
    double before = std::numeric_limits<double>::infinity();
    int n = 0;
    for (double now = 0; n < most; before = now) {
        ++n;
        subtract(c, a, b, bits);
        shift(c, -1);
        multiply(product, a, b, bits);
        a += b; // not a - c, whose ball is wider
        shift(a, -1);
        principal_root(b, product, bits);
        if (with_e) {
            multiply(product, c, c, bits);
            shift(product, n - 1);
            sum += product;
        }
        now = 2 * log2_upper(upper_ball(c));
        if (!(now >= std::max(-static_cast<double>(bits) - spare, log2_radius(a))) || now >= before) break;
    }
    const Ball size = upper_ball(c), square = size * size;
    const Ball delta = least_real_part(a, b);
    if (!arb_is_positive(delta.get())) return {V::indeterminate(), V::indeterminate()};
    widen(a, lemma::limit_of_means(square, delta));
    shift(a, 1);
    const V k = V(1) / a;
    if (!with_e) return {k, V::indeterminate()};
    widen(sum, lemma::rest_of_means(square, delta, n));
    return {k, k * (V(1) - sum)};
}

/// Over pi, of a real v.
Elliptic<Ball> of_real(const Ball& v, bool with_e)
{
    constexpr slong lost_bits = 64; // to the means of huge and of tiny numbers, of which there are many
    if (auto fixed = by_fixed_means(v, with_e)) return std::move(*fixed);
    const WorkingPrecision more(WorkingPrecision::bits() + lost_bits);
    return by_means(v, with_e);
}

/// The same on a wide ball in abs(m) < 1, where the means would be no better known.
std::optional<Elliptic<ComplexBall>> by_size(const ComplexBall& v, bool with_e)
{
    const ComplexBall m = ComplexBall(1) - v;
    if (!is_known_by_size(m)) return std::nullopt;
    const Ball q = upper_ball(m);
    const Elliptic<Ball> there = of_real(Ball(1) - q, with_e);
    const Ball at_zero = Ball(1) / Ball(2);
    Elliptic<ComplexBall> on{ComplexBall(at_zero), with_e ? ComplexBall(at_zero) : ComplexBall::indeterminate()};
    widen(on.k, there.k - at_zero);
    if (with_e) widen(on.e, at_zero - there.e);
    return on;
}

template <class V>
Elliptic<V> times_pi(const Elliptic<V>& x)
{
    const V factor(pi<Ball>());
    return {x.k * factor, x.e * factor};
}

} // namespace

bool is_known_by_size(const ComplexBall& u)
{
    constexpr double wide = 0.0625, largest = 0.96875;
    return arb_gt(radius_of(u).get(), Ball::exactly(wide).get()) && arb_lt(upper_ball(u).get(), Ball::exactly(largest).get());
}

Elliptic<Ball> elliptic_over_pi(const Ball& v, bool with_e) { return of_real(v, with_e); }
Elliptic<ComplexBall> elliptic_over_pi(const ComplexBall& v, bool with_e)
{
    if (auto on = by_size(v, with_e)) return std::move(*on);
    return by_means(v, with_e);
}

Elliptic<Ball> elliptic_of_complement(const Ball& v) { return times_pi(elliptic_over_pi(v, true)); }
Elliptic<ComplexBall> elliptic_of_complement(const ComplexBall& v) { return times_pi(elliptic_over_pi(v, true)); }
Ball first_kind_of_complement(const Ball& v) { return elliptic_over_pi(v, false).k * pi<Ball>(); }
ComplexBall first_kind_of_complement(const ComplexBall& v) { return elliptic_over_pi(v, false).k * ComplexBall(pi<Ball>()); }

} // namespace touchstone::quadrature
