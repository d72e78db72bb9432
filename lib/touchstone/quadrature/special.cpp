// SPDX-License-Identifier: MIT
#include "touchstone/quadrature/special.hpp"

#include "touchstone/quadrature/elliptic.hpp"
#include "touchstone/quadrature/endpoint_number.hpp"
#include "touchstone/quadrature/lemmas.hpp"
#include "touchstone/quadrature/strip.hpp"
#include "touchstone/quadrature/upper.hpp"
#include "touchstone/quadrature/widen.hpp"

#if __has_include(<flint/acb_hypgeom.h>)
#include <flint/acb_hypgeom.h>
#else
#include <acb_hypgeom.h>
#endif

#include <cmath>

namespace touchstone::quadrature {

/// Near 0 about the middle: Arb's value of a box is some times as wide as sinc varies there. Farther out sinc varies less than near 0, and
/// Arb's value is the narrower one.
ComplexBall analytic::sinc(const ComplexBall& z)
{
    constexpr long far = 2;
    ComplexBall middle, w;
    Ball least;
    acb_get_abs_lbound_arf(arb_midref(least.get()), z.get(), strip_bits);
    const bool is_far = arb_gt(least.get(), Ball(far).get()) != 0;
    if (!is_far) acb_get_mid(middle.get(), z.get());
    acb_sinc(w.get(), is_far ? z.get() : middle.get(), WorkingPrecision::bits());
    if (is_far || acb_is_exact(z.get()) != 0) return w;
    const WorkingPrecision coarse(strip_bits);
    widen(w, upper_ball(z - middle) * lemma::slope_of_sinc(upper_ball(z), upper_ball(z.imag())));
    return w;
}

namespace {

slong bits() { return WorkingPrecision::bits(); }

template <class F>
ComplexBall by(F&& f, const ComplexBall& z)
{
    ComplexBall w;
    f(w.get(), z.get(), bits());
    return w;
}

/// Whether z may meet the real numbers up to (from) the bound.
bool meets_up_to(const ComplexBall& z, const Ball& bound)
{
    return arb_contains_zero(acb_imagref(z.get())) && !arb_gt(acb_realref(z.get()), bound.get());
}
bool meets_from(const ComplexBall& z, const Ball& bound)
{
    return arb_contains_zero(acb_imagref(z.get())) && !arb_lt(acb_realref(z.get()), bound.get());
}

ComplexBall lambert_w(const ComplexBall& z)
{
    if (meets_up_to(z, -exp(Ball(-1)))) return ComplexBall::indeterminate();
    ComplexBall w;
    fmpz_t branch;
    fmpz_init(branch);
    acb_lambertw(w.get(), z.get(), branch, 0, bits());
    fmpz_clear(branch);
    return w;
}

/// -E1(-z) left of the imaginary axis, Ei right of it.
ComplexBall exponential_integral(const ComplexBall& z)
{
    if (arb_is_negative(acb_realref(z.get()))) {
        ComplexBall w;
        const ComplexBall minus = -z;
        acb_hypgeom_expint(w.get(), ComplexBall(1).get(), minus.get(), bits());
        return -w;
    }
    return arb_is_positive(acb_realref(z.get())) ? by(acb_hypgeom_ei, z) : ComplexBall::indeterminate();
}

/// The ball that knows more of its number.
ComplexBall better(const ComplexBall& a, const ComplexBall& b)
{
    return acb_rel_accuracy_bits(a.get()) > acb_rel_accuracy_bits(b.get()) ? a : b;
}

/// Arb takes asinh z by the arctangent of z/(1 + z^2)^(1/2), which comes near to that one's singular points where z is large. For Re z > 0
/// it is log(z + (1 + z^2)^(1/2)) as well: there 1 + z^2 is off the cut and both terms have positive real parts. For Re z < 0 it is odd.
ComplexBall inverse_hyperbolic_sine(const ComplexBall& z)
{
    const ComplexBall plain = by(acb_asinh, z);
    const bool in_left = arb_is_negative(acb_realref(z.get())) != 0;
    if (!in_left && !arb_is_positive(acb_realref(z.get()))) return plain;
    const ComplexBall y = in_left ? -z : z, logarithm = analytic::log(y + analytic::sqrt(ComplexBall(1) + y * y));
    return better(in_left ? -logarithm : logarithm, plain);
}

/// exp(z^2) erfc(z) = U(1/2, 1/2, z^2)/sqrt(pi) in the right half plane (DLMF 7.11.5), where erfc itself is too small; else the product.
ComplexBall scaled_erfc(const ComplexBall& z)
{
    const ComplexBall square = z * z, half(Ball(1) / Ball(2));
    ComplexBall w;
    acb_hypgeom_erfc(w.get(), z.get(), bits());
    const ComplexBall plain = w * analytic::exp(square);
    if (!arb_is_positive(acb_realref(z.get()))) return plain;
    acb_hypgeom_u(w.get(), half.get(), half.get(), square.get(), bits());
    w = w / ComplexBall(sqrt(pi<Ball>()));
    return better(w, plain);
}

ComplexBall airy(Op op, const ComplexBall& z)
{
    ComplexBall w;
    acb_hypgeom_airy(op == Op::airy_ai ? w.get() : nullptr, nullptr, op == Op::airy_bi ? w.get() : nullptr, nullptr, z.get(), bits());
    return w;
}

bool is_integer(const Ball& order) { return arb_is_int(order.get()) != 0; }

ComplexBall bessel_k_of(const Ball& order, const ComplexBall& z)
{
    ComplexBall w;
    acb_hypgeom_bessel_k(w.get(), ComplexBall(order).get(), z.get(), bits());
    return w;
}

/// K_n off the cut. It is made of I_n and I_-n, exp(2 Re z) larger, so that far from 0 bits are lost, and any uncertainty of z grows as
/// much. There: at the middle of a small ball with as many bits more, over the ball by K_n' = -(K_(n-1) + K_(n+1))/2.
ComplexBall bessel_k(const Ball& order, const ComplexBall& z)
{
    const ComplexBall plain = bessel_k_of(order, z);
    const slong had = std::min(bits(), acb_rel_accuracy_bits(z.get()));
    constexpr slong bits_spared = 16; // z itself loses log2 |z|
    if (had <= 0 || acb_rel_accuracy_bits(plain.get()) >= had - bits_spared) return plain;
    ComplexBall middle;
    acb_get_mid(middle.get(), z.get());
    const double lost = 2 * std::fabs(arf_get_d(arb_midref(acb_realref(z.get())), ARF_RND_NEAR)) / M_LN2;
    ComplexBall k;
    {
        const WorkingPrecision more(bits() + static_cast<slong>(std::min(lost, 2.0 * static_cast<double>(bits()))));
        k = bessel_k_of(order, middle);
    }
    const Ball slope =
        touchstone::abs(bessel_k_by_its_size(order - Ball(1), z)) + touchstone::abs(bessel_k_by_its_size(order + Ball(1), z));
    widen(k, touchstone::abs(z - middle) * slope / Ball(2));
    return acb_rel_accuracy_bits(k.get()) > acb_rel_accuracy_bits(plain.get()) ? k : plain;
}

/// exp(z) K_nu(z): far out the exponential loses the bits of z, near 0 Arb's own function those of K.
ComplexBall scaled_bessel_k(const Ball& order, const ComplexBall& z)
{
    ComplexBall w;
    acb_hypgeom_bessel_k_scaled(w.get(), ComplexBall(order).get(), z.get(), bits());
    const slong known = std::min(bits(), acb_rel_accuracy_bits(z.get()));
    constexpr slong spared = 8;
    return acb_rel_accuracy_bits(w.get()) >= known - spared ? w : better(w, analytic::exp(z) * bessel_k(order, z));
}

} // namespace

ComplexBall bessel_k_by_its_size(const Ball& order, const ComplexBall& z)
{
    Ball least;
    const Ball size = touchstone::abs(z);
    arb_get_lbound_arf(arb_midref(least.get()), size.get(), 53);
    const ComplexBall front = analytic::sqrt(ComplexBall(pi<Ball>() / Ball(2)) / z) * analytic::exp(-z);
    return front * (ComplexBall(1) + disc(lemma::bessel_remainder(order, least, pi<Ball>() / Ball(2))));
}

ComplexBall special_function(Op op, const ComplexBall& z)
{
    const auto off = [&](bool meets, auto&& f) { return meets ? ComplexBall::indeterminate() : by(f, z); };
    const auto asinh_off_its_cuts = [&] {
        const Ball y = touchstone::abs(z.imag());
        const bool may_meet = arb_contains_zero(acb_realref(z.get())) && !arb_lt(y.get(), Ball(1).get());
        return may_meet ? ComplexBall::indeterminate() : inverse_hyperbolic_sine(z);
    };
    switch (op) {
    case Op::exp: return analytic::exp(z);
    case Op::log: return analytic::log(z);
    case Op::sin: return touchstone::sin(z);
    case Op::cos: return touchstone::cos(z);
    case Op::tan: return by(acb_tan, z);
    case Op::sinh: return by(acb_sinh, z);
    case Op::cosh: return by(acb_cosh, z);
    case Op::tanh: return by(acb_tanh, z);
    case Op::sech: return by(acb_sech, z);
    case Op::asin: return analytic::asin(z);
    case Op::acos: return off(meets_up_to(z, Ball(-1)) || meets_from(z, Ball(1)), acb_acos);
    case Op::atan: return analytic::atan(z);
    case Op::asinh: return asinh_off_its_cuts();
    case Op::acosh: return off(meets_up_to(z, Ball(1)), acb_acosh);
    case Op::atanh: return off(meets_up_to(z, Ball(-1)) || meets_from(z, Ball(1)), acb_atanh);
    case Op::expm1: return by(acb_expm1, z);
    case Op::log1p: return off(meets_up_to(z, Ball(-1)), acb_log1p);
    case Op::sinc: return analytic::sinc(z);
    case Op::gamma: return by(acb_gamma, z);
    case Op::rgamma: return by(acb_rgamma, z);
    case Op::lgamma: return off(meets_up_to(z, Ball(0)), acb_lgamma);
    case Op::digamma: return by(acb_digamma, z);
    case Op::zeta: return by(acb_zeta, z);
    case Op::erf: return by(acb_hypgeom_erf, z);
    case Op::erfc: return by(acb_hypgeom_erfc, z);
    case Op::erfi: return by(acb_hypgeom_erfi, z);
    case Op::erfc_scaled: return scaled_erfc(z);
    case Op::ei: return exponential_integral(z);
    case Op::si: return by(acb_hypgeom_si, z);
    case Op::ci: return off(meets_up_to(z, Ball(0)), acb_hypgeom_ci);
    case Op::li: {
        if (meets_up_to(z, Ball(1))) return ComplexBall::indeterminate();
        ComplexBall w;
        acb_hypgeom_li(w.get(), z.get(), 0, bits());
        return w;
    }
    case Op::dilog: return off(meets_from(z, Ball(1)), acb_hypgeom_dilog);
    case Op::airy_ai:
    case Op::airy_bi: return airy(op, z);
    case Op::lambert_w: return lambert_w(z);
    case Op::elliptic_k: return first_kind_of_complement(ComplexBall(1) - z);
    case Op::elliptic_e: return elliptic_of_complement(ComplexBall(1) - z).e;
    case Op::floor: {
        ComplexBall w;
        acb_real_floor(w.get(), z.get(), 1, bits());
        return w;
    }
    case Op::ceil: {
        ComplexBall w;
        acb_real_ceil(w.get(), z.get(), 1, bits());
        return w;
    }
    default: return ComplexBall::indeterminate();
    }
}

Ball special_function(Op op, const Ball& x)
{
    const auto real = [&](auto&& f) { return touchstone::detail::ball_of(f, x); };
    switch (op) {
    case Op::exp: return exp(x);
    case Op::log: return log(x);
    case Op::sin: return sin(x);
    case Op::cos: return cos(x);
    case Op::tan: return real(arb_tan);
    case Op::sinh: return real(arb_sinh);
    case Op::cosh: return real(arb_cosh);
    case Op::tanh: return real(arb_tanh);
    case Op::sech: return real(arb_sech);
    case Op::asin: return asin(x);
    case Op::acos: return acos(x);
    case Op::atan: return real(arb_atan);
    case Op::asinh: return real(arb_asinh);
    case Op::acosh: return real(arb_acosh);
    case Op::atanh: return real(arb_atanh);
    case Op::expm1: return real(arb_expm1);
    case Op::log1p: return real(arb_log1p);
    case Op::sinc: return analytic::sinc(x);
    case Op::gamma: return real(arb_gamma);
    case Op::elliptic_k: return first_kind_of_complement(Ball(1) - x);
    case Op::elliptic_e: return elliptic_of_complement(Ball(1) - x).e;
    default: return special_function(op, ComplexBall(x)).real();
    }
}

ComplexBall special_function(Op op, const Ball& order, const ComplexBall& z)
{
    ComplexBall w;
    const ComplexBall nu(order);
    const bool cut = op == Op::bessel_y || op == Op::bessel_k || op == Op::bessel_k_scaled || (op != Op::polylog && !is_integer(order));
    if (cut && meets_up_to(z, Ball(0))) return ComplexBall::indeterminate();
    switch (op) {
    case Op::bessel_j: acb_hypgeom_bessel_j(w.get(), nu.get(), z.get(), bits()); break;
    case Op::bessel_y: acb_hypgeom_bessel_y(w.get(), nu.get(), z.get(), bits()); break;
    case Op::bessel_i: acb_hypgeom_bessel_i(w.get(), nu.get(), z.get(), bits()); break;
    case Op::bessel_k: return bessel_k(order, z);
    case Op::bessel_i_scaled: acb_hypgeom_bessel_i_scaled(w.get(), nu.get(), z.get(), bits()); break;
    case Op::bessel_k_scaled: return scaled_bessel_k(order, z);
    case Op::polylog:
        if (arb_is_zero(order.get())) return z / (ComplexBall(1) - z); // without a cut, which the library does not have for wide z
        if (meets_from(z, Ball(1))) return ComplexBall::indeterminate();
        acb_polylog(w.get(), nu.get(), z.get(), bits());
        break;
    default: return ComplexBall::indeterminate();
    }
    return w;
}

Ball special_function(Op op, const Ball& order, const Ball& x) { return special_function(op, order, ComplexBall(x)).real(); }

} // namespace touchstone::quadrature
