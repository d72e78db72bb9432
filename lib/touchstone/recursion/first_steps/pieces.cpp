// SPDX-License-Identifier: MIT
#include "touchstone/recursion/first_steps/pieces.hpp"

#include "touchstone/scalar/refusal.hpp"

#if __has_include(<flint/acb_calc.h>)
#include <flint/acb_calc.h>
#else
#include <acb_calc.h>
#endif

namespace touchstone::transfer::first_steps {
namespace {

using C = ComplexBall;
/// `analytic` asks for an indeterminate result unless the integrand is analytic on the whole ball.
using Integrand = std::function<C(const C& t, bool analytic)>;

constexpr slong end_bits = 4096; // beyond the thread's precision

slong bits() { return WorkingPrecision::bits(); }

int call(acb_ptr result, const acb_t t, void* f, slong order, slong precision)
{
    const WorkingPrecision scope(precision);
    C z;
    acb_set(z.get(), t);
    const C r = (*static_cast<const Integrand*>(f))(z, order != 0);
    acb_set(result, r.get());
    return 0;
}

/// int_0^end f
Ball integrate(const Integrand& f, const Ball& end, slong tolerance_bits)
{
    C sum;
    acb_calc_integrate_opt_t options;
    acb_calc_integrate_opt_init(options);
    options->depth_limit = 10'000;
    options->eval_limit = 400'000;
    mag_t tolerance;
    mag_init(tolerance);
    mag_set_ui_2exp_si(tolerance, 1, -tolerance_bits);
    acb_calc_integrate(sum.get(), call, const_cast<Integrand*>(&f), C(0).get(), C(end).get(), bits(), tolerance, options, bits());
    mag_clear(tolerance);
    return sum.real();
}

} // namespace

WorkingPrecision wide() { return WorkingPrecision(bits() + end_bits); }

Ball narrow(const Ball& b)
{
    Ball r;
    arb_set_round(r.get(), b.get(), bits());
    return r;
}

C root(const C& z, bool analytic)
{
    C r;
    acb_sqrt_analytic(r.get(), z.get(), analytic, bits());
    return r;
}

C two_angles(const C& top, const C& bottom, bool analytic)
{
    const C z = top / bottom;
    if (analytic && !certainly(less(Ball(0), z.real())) && !certainly(less(abs(z), Ball(1)))) return C::indeterminate();
    C r;
    acb_atan(r.get(), z.get(), bits());
    return 2 * r / C(pi<Ball>());
}

End End::rational(const Rational& r)
{
    const WorkingPrecision w = wide();
    return {Ball(r), r};
}

int order(const End& a, const End& b)
{
    if (same(a, b)) return 0;
    if (a.exact && b.exact) return *a.exact < *b.exact ? -1 : *a.exact > *b.exact ? 1 : 0;
    if (certainly(less(a.at(), b.at()))) return -1;
    if (certainly(less(b.at(), a.at()))) return 1;
    throw BeyondReach("two ends of waves are too close to be told from one another");
}

Ball difference(const End& a, const End& b)
{
    if (same(a, b)) return Ball(0);
    if (a.exact && b.exact) return Ball(Rational(*b.exact - *a.exact));
    Ball d;
    arb_sub(d.get(), b.at().get(), a.at().get(), bits() + end_bits);
    return narrow(d);
}

C Piece::Point::distance(const Beyond& b) const
{
    const C& s = b.left ? sine : cosine;
    return C(b.gap) + C(piece->width_) * s * s;
}

C Piece::Point::root_of(const Beyond& b) const
{
    if (b.zero()) return C(sqrt(piece->width_)) * (b.left ? sine : cosine);
    return root(distance(b), analytic);
}

Ball Piece::integral(const Function& f, const std::vector<Beyond>& roots) const
{
    int at_left = 0, at_right = 0;
    for (const Beyond& b : roots)
        if (b.zero()) ++(b.left ? at_left : at_right);
    if (at_left > 1 || at_right > 1) throw BeyondReach("the density is infinite at this pressure");
    Ball scale = 2 * width_;
    for (int k = 0; k < at_left + at_right; ++k) scale = scale / sqrt(width_);
    constexpr slong tolerance_bits = 6000; // of the value's own size: p may be 1e-300
    return scale * integrate([&](const C& t, bool analytic) {
               const C s = sin(t), c = cos(t);
               const Point x{this, from_left_ ? s : c, from_left_ ? c : s, analytic};
               C value = f(x);
               if (!at_left) value = value * x.sine;
               if (!at_right) value = value * x.cosine;
               for (const Beyond& b : roots)
                   if (!b.zero()) value = value / x.root_of(b);
               return value;
           }, pi<Ball>() / 4, tolerance_bits);
}

Ball Piece::integral_to_logarithm(const Function& f, const std::function<Ball(const Ball& distance)>& rest) const
{
    // the share of the piece at the near end that is left out: doubled in digits until its bound is below the tolerance
    const Ball half = width_ / 2;
    const slong tolerance_bits = bits();
    Ball left_out, lost;
    slong depth = tolerance_bits / 2;
    do {
        depth += depth / 4 + 1;
        left_out = Ball(1);
        arb_mul_2exp_si(left_out.get(), left_out.get(), -depth);
        lost = rest(half * left_out);
        if (depth > 16 * tolerance_bits) throw BeyondReach("an integral does not converge at a singular point");
    } while (!(arf_cmpabs_2exp_si(arb_midref(lost.get()), -tolerance_bits) < 0));
    const Ball end = -log(left_out);
    Ball sum = half * integrate([&](const C& v, bool analytic) {
                   const C share = exp(-v) / 2, near = exp(-v / 2) / C(sqrt(Ball(2))), far = root(1 - share, analytic);
                   return f({this, from_left_ ? near : far, from_left_ ? far : near, analytic}) * 2 * share;
               }, end, tolerance_bits);
    arb_add_error(sum.get(), lost.get());
    return sum;
}

Ball over(const End& a, const End& b, const std::function<Ball(const Piece&)>& half)
{
    if (!below(a, b)) return Ball(0);
    return half(Piece(a, b, true)) + half(Piece(a, b, false));
}

} // namespace touchstone::transfer::first_steps
