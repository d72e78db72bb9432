// SPDX-License-Identifier: MIT
#include "touchstone/quadrature/elliptic.hpp"

#include "touchstone/quadrature/endpoint_number.hpp"
#include "touchstone/quadrature/lemmas.hpp"
#include "touchstone/quadrature/upper.hpp"
#include "touchstone/quadrature/widen.hpp"

namespace touchstone::quadrature {
namespace {

Ball real_part(const Ball& x) { return x; }
Ball real_part(const ComplexBall& z) { return z.real(); }

void shift(Ball& x, slong e) { arb_mul_2exp_si(x.get(), x.get(), e); }
void shift(ComplexBall& z, slong e) { acb_mul_2exp_si(z.get(), z.get(), e); }

/// About log2 of an exact number >= 0.
slong exponent_of(const Ball& x)
{
    constexpr slong none = -(WORD(1) << 40);
    return arb_is_zero(x.get()) ? none : arf_abs_bound_lt_2exp_si(arb_midref(x.get()));
}

Ball lower_ball(const Ball& x)
{
    Ball low;
    arb_get_lbound_arf(arb_midref(low.get()), x.get(), 53);
    return low;
}

/// The least real part of either, as a number.
template <class V>
Ball least_real_part(const V& a, const V& b)
{
    const Ball of_a = lower_ball(real_part(a)), of_b = lower_ball(real_part(b));
    return arb_lt(of_a.get(), of_b.get()) != 0 ? of_a : of_b;
}

/// a_0 = 1, b_0 = sqrt v, c_n = (a_(n-1) - b_(n-1))/2: K = pi/(2 a), E = K (1 - m/2 - sum over n >= 1 of 2^(n-1) c_n^2), a the limit; all
/// means have a real part of delta = min(Re a_n, Re b_n) at least from n on (lemmas.hpp).
template <class V>
Elliptic<V> by_means(const V& v)
{
    constexpr int most = 64;
    const slong bits = WorkingPrecision::bits();
    V a(1), b = analytic::sqrt(v), sum = V(1) - v, c, product;
    shift(sum, -1);
    Ball size;
    slong before = WORD_MAX;
    int n = 0;
    for (slong now = 0; n < most; before = now) {
        ++n;
        c = a;
        c -= b;
        shift(c, -1);
        product = a;
        product *= b;
        a += b; // not a - c, whose ball is wider
        shift(a, -1);
        b = analytic::sqrt(product);
        c *= c;
        size = upper_ball(c);
        shift(c, n - 1);
        sum += c;
        now = exponent_of(size);
        if (now < -bits - 4 || now >= before) break; // no smaller than the balls are wide
    }
    const Ball delta = least_real_part(a, b);
    if (!arb_is_positive(delta.get())) return {V::indeterminate(), V::indeterminate()};
    widen(a, lemma::limit_of_means(size, delta));
    widen(sum, lemma::rest_of_means(size, delta, n));
    shift(a, 1);
    const V k = V(pi<Ball>()) / a;
    return {k, k * (V(1) - sum)};
}

} // namespace

Elliptic<Ball> elliptic_of_complement(const Ball& v) { return by_means(v); }
Elliptic<ComplexBall> elliptic_of_complement(const ComplexBall& v) { return by_means(v); }

Ball first_kind_of_complement(const Ball& v)
{
    if (!arb_is_positive(v.get())) return Ball::indeterminate();
    Ball mean;
    arb_agm(mean.get(), Ball(1).get(), sqrt(v).get(), WorkingPrecision::bits());
    return pi<Ball>() / (mean + mean);
}
ComplexBall first_kind_of_complement(const ComplexBall& v) { return by_means(v).k; }

} // namespace touchstone::quadrature
