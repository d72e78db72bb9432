// SPDX-License-Identifier: MIT
#include "touchstone/quadrature/endpoint_functions.hpp"

#include "touchstone/quadrature/lemmas.hpp"
#include "touchstone/quadrature/logarithmic_ends.hpp"
#include "touchstone/quadrature/widen.hpp"

#include <cmath>

namespace touchstone::quadrature {
namespace {

using Real = EndpointNumber<Ball>;
using Complex = EndpointNumber<ComplexBall>;

/// The side whose logarithm the number grows with on this piece, if it does and has no power of the distance there.
std::optional<Side> side_of_growth(const Complex& x)
{
    for (const Side s : {Side::left, Side::right})
        if (x.frame() && x.frame()->reaches(s) && x.order(s).power.is_zero() && Exponent(0) < x.order(s).logs) return s;
    return std::nullopt;
}

double upper(const Ball& x)
{
    Ball top;
    arb_get_ubound_arf(arb_midref(top.get()), x.get(), 53);
    return arf_get_d(arb_midref(top.get()), ARF_RND_UP);
}

constexpr long grain = 4096; // exponents on a piece are multiples of 1/grain

/// The least rho on the piece: A = pi sinh(x1) cos(y2), from what the frame knows of it.
Ball least_rho(const Complex& x, Side s)
{
    // vanishing(s, 0, -1) is the real interval [0, 1/A]
    const ComplexBall most = x.frame()->vanishing(s, Ball(0), Exponent(-1));
    Ball top;
    arb_get_ubound_arf(arb_midref(top.get()), acb_realref(most.get()), 53);
    return Ball(1) / top;
}

/// distance^-kappa times what |exp(kappa rho)| is of it, kappa rounded up.
Complex growing(const Complex& x, Side s, double kappa)
{
    if (!(std::fabs(kappa) < 1e9)) return {x.frame(), {}, {}, ComplexBall::indeterminate()};
    const Exponent k(static_cast<long>(std::ceil(kappa * static_cast<double>(grain))), grain);
    const Ball bound = lemma::far_factor(k.ball(), least_rho(x, s));
    const Order own{-k, 0};
    return {x.frame(), s == Side::left ? own : Order{}, s == Side::right ? own : Order{}, disc(bound)};
}

/// The factor of x there, with the other end's powers multiplied out.
ComplexBall factor_at(const Complex& x, Side s)
{
    const Order rest = x.order(s == Side::left ? Side::right : Side::left);
    return Complex(x.frame(), s == Side::left ? Order{} : rest, s == Side::left ? rest : Order{}, x.factor()).value();
}

Complex unknown(const Complex& x) { return {x.frame(), {}, {}, ComplexBall::indeterminate()}; }

/// distance^power times what is at most `bound` in size.
Complex of_order(const Complex& x, Side s, const Exponent& power, const Ball& bound)
{
    const Order own{power, 0};
    return {x.frame(), s == Side::left ? own : Order{}, s == Side::right ? own : Order{}, disc(bound)};
}

/// How x goes to infinity as a power of a distance, at an end that the strip does not wind around: x = t direction, t = |distance|^-power
/// >= least.
struct Departure {
    Side side;
    Exponent power;
    ComplexBall direction;
    Ball least;

    /// A bound of Re(x)/t from below if it is positive.
    std::optional<Ball> rightwards() const
    {
        Ball low;
        arb_get_lbound_arf(arb_midref(low.get()), acb_realref(direction.get()), 53);
        return arb_is_positive(low.get()) ? std::optional(low) : std::nullopt;
    }
};

std::optional<Departure> departure(const Complex& x)
{
    for (const Side s : {Side::left, Side::right}) {
        const Order own = x.order(s);
        if (!x.frame() || !x.frame()->reaches(s) || !(own.power < Exponent(0)) || !own.logs.is_zero()) continue;
        const auto turn = x.frame()->turn(s);
        if (!turn) return std::nullopt;
        const Exponent power = -own.power;
        const Ball angle = power.ball() * *turn, half_pi = touchstone::pi<Ball>() / Ball(2);
        if (!arb_lt(angle.get(), half_pi.get())) return std::nullopt;
        const ComplexBall arc(hull(cos(angle), Ball(1)), hull(-sin(angle), sin(angle)));
        const Ball A = least_rho(x, s); // |distance| <= exp(-A)/(1 - exp(-A))
        return Departure{s, power, factor_at(x, s) * arc, exp(power.ball() * (A + log(Ball(1) - exp(-A))))};
    }
    return std::nullopt;
}

/// |exp(x)| <= exp(-kappa t) <= t^-N sup(t^N exp(-kappa t)) where Re x <= -kappa t: falls faster than any power. N is where the supremum is
/// at the least t.
Complex falling(const Complex& x, const Departure& d)
{
    Ball high;
    arb_get_ubound_arf(arb_midref(high.get()), acb_realref(d.direction.get()), 53);
    if (!arb_is_negative(high.get())) return unknown(x);
    constexpr double most = 64;
    const double n = std::clamp(std::floor(arf_get_d(arb_midref((-high * d.least).get()), ARF_RND_DOWN)), 1.0, most);
    const Ball N(static_cast<long>(n)), at = at_least(N / -high, d.least);
    return of_order(x, d.side, d.power * Exponent(static_cast<long>(n)), exp(N * log(at) + high * at));
}

Complex exponential(const Complex& x)
{
    if (const auto d = departure(x)) return falling(x, *d);
    const auto side = side_of_growth(x);
    if (!side) return x.map([](const ComplexBall& v) { return analytic::exp(v); });
    const Exponent logs = x.order(*side).logs;
    const Ball c = factor_at(x, *side).real();
    double kappa = upper(c);
    if (Exponent(1) < logs || logs < Exponent(1)) {
        // rho^k c <= -|c| A^(k-1) rho for k > 1, c < 0; for k < 1 it grows or falls too slowly to be told from a constant by powers
        if (logs < Exponent(1) || !(kappa < 0)) return {x.frame(), {}, {}, ComplexBall::indeterminate()};
        kappa = std::max(kappa * arf_get_d(arb_midref(exp((logs - Exponent(1)).ball() * log(least_rho(x, *side))).get()), ARF_RND_DOWN) *
                             (1 - 1e-9),
                         -1e6);
    }
    return growing(x, *side, kappa);
}

Complex trigonometric(Op op, const Complex& x)
{
    const auto side = side_of_growth(x);
    if (!side) return op == Op::sin ? sin(x) : cos(x);
    if (!(x.order(*side).logs == Exponent(1))) return {x.frame(), {}, {}, ComplexBall::indeterminate()};
    return growing(x, *side, upper(touchstone::abs(factor_at(x, *side).imag())));
}

/// Whether x is unbounded as a power of a distance: so it winds around infinity with the strip.
template <class V>
bool has_pole_at_an_end(const EndpointNumber<V>& x)
{
    return x.left().power < Exponent(0) || x.right().power < Exponent(0);
}

/// atan x = 2 atan(x/(1 + sqrt(1 + x^2))): the argument stays bounded, its root keeps the power of the distance.
template <class V>
EndpointNumber<V> arc_tangent_of_pole(const EndpointNumber<V>& x)
{
    const EndpointNumber<V> one(1);
    return EndpointNumber<V>(2) * atan(EndpointNumber<V>(x / (one + sqrt(EndpointNumber<V>(one + x * x)))));
}

Real logarithm(const Real& x) { return log(x); }
Complex logarithm(const Complex& x);

/// asinh x = log x + log(1 + sqrt(1 + 1/x^2)) for Re x > 0, where x grows: what stays is regular. An odd function. Between the half planes
/// is the cut, which neither form shows: what lies beside the powers of the distances has to be proved on one side.
template <class V>
EndpointNumber<V> inverse_hyperbolic_sine_of_large(const EndpointNumber<V>& x)
{
    // which of the two is taken depends on the piece, and with it what stands beside the logarithm
    if (x.frame() && x.frame()->keeps_logarithms()) return {x.frame(), {}, {}, V::indeterminate()};
    const EndpointNumber<V> one(1);
    const auto of_positive = [&](const EndpointNumber<V>& y) {
        return EndpointNumber<V>(logarithm(y) + log(EndpointNumber<V>(one + sqrt(EndpointNumber<V>(one + one / (y * y))))));
    };
    Ball size;
    if constexpr (std::same_as<V, Ball>) size = x.factor();
    else size = x.factor().real();
    if (!arb_is_nonzero(size.get())) return {x.frame(), {}, {}, V::indeterminate()};
    return arb_is_negative(size.get()) ? -of_positive(-x) : of_positive(x);
}

/// +-pi/2 - atan(1/x) where x goes to infinity inside a half plane that the strip does not leave.
Complex arc_tangent(const Complex& x)
{
    if (has_pole_at_an_end(x)) return arc_tangent_of_pole(x);
    const auto side = side_of_growth(x);
    if (!side) return atan(x);
    const Ball c = factor_at(x, *side).real();
    if (!arb_is_nonzero(c.get())) return {x.frame(), {}, {}, ComplexBall::indeterminate()};
    const Ball half_pi = touchstone::pi<Ball>() / Ball(2);
    return Complex(ComplexBall(arb_is_positive(c.get()) ? half_pi : -half_pi)) - atan(Complex(1) / x);
}

/// |erfc(z)| <= |exp(-z^2)| for Re z >= 0: erfc(z) = exp(-z^2) w(iz), |w| <= 1 above the real axis (DLMF 7.7.2).
Complex error_function(Op op, const Complex& x)
{
    const auto side = side_of_growth(x);
    const auto d = departure(x);
    if (!side && !d) return x.map([&](const ComplexBall& v) { return special_function(op, v); });
    const Ball c = d ? d->direction.real() : factor_at(x, *side).real();
    if (!arb_is_nonzero(c.get())) return unknown(x);
    const bool rightwards = arb_is_positive(c.get()) != 0;
    const Complex rest = exponential(-(x * x)) * Complex(disc(Ball(1))); // erfc(|x|)
    if (op == Op::erfc) return rightwards ? rest : Complex(2) - rest;
    return rightwards ? Complex(1) - rest : rest - Complex(1);
}

/// |K_nu(z)| <= K_nu(Re z) <= K_nu(a) exp(a - Re z) for real nu and Re z >= a > 0, from K_nu(z) = integral of exp(-z cosh t) cosh(nu t)
/// (DLMF 10.32.9).
Complex bessel_k(const Ball& order, const Complex& x, Side side)
{
    const Ball c = factor_at(x, side).real();
    if (!(x.order(side).logs == Exponent(1)) || !arb_is_positive(c.get())) return {x.frame(), {}, {}, ComplexBall::indeterminate()};
    Ball low;
    arb_get_lbound_arf(arb_midref(low.get()), (c * least_rho(x, side)).get(), 53);
    const Ball at = touchstone::abs(special_function(Op::bessel_k, order, low)) * exp(low);
    return exponential(-x) * Complex(disc(at));
}

/// The same where x grows as a power.
Complex bessel_k(const Ball& order, const Complex& x, const Departure& d)
{
    const auto rightwards = d.rightwards();
    if (!rightwards) return unknown(x);
    Ball low;
    arb_get_lbound_arf(arb_midref(low.get()), (*rightwards * d.least).get(), 53);
    return exponential(-x) * Complex(disc(touchstone::abs(special_function(Op::bessel_k, order, low)) * exp(low)));
}

/// exp(-z) I_n(z), exp(z) K_nu(z), exp(z^2) erfc(z) for Re z > 0: lemmas of the same names.
Complex scaled(Op op, const Ball& order, const Complex& x, const Departure& d)
{
    const auto rightwards = d.rightwards();
    if (!rightwards) return unknown(x);
    const Exponent half(1, 2);
    if (op == Op::erfc_scaled) return of_order(x, d.side, d.power, lemma::scaled_erfc(*rightwards));
    if (op == Op::bessel_i_scaled)
        return arb_is_int(order.get()) ? of_order(x, d.side, d.power * half, lemma::scaled_bessel_i(*rightwards)) : unknown(x);
    const Ball size = touchstone::abs(d.direction), front = sqrt(touchstone::pi<Ball>() / (Ball(2) * size));
    return of_order(x, d.side, d.power * half, front * (Ball(1) + lemma::bessel_remainder(order, size * d.least, Ball(1))));
}

/// The same where x grows as a logarithm: bounds at the least Re z.
Complex scaled(Op op, const Ball& order, const Complex& x, Side side)
{
    const Ball c = factor_at(x, side).real();
    if (!(x.order(side).logs == Exponent(1)) || !arb_is_positive(c.get())) return unknown(x);
    if (op == Op::erfc_scaled) return Complex(disc(Ball(1)));
    if (op == Op::bessel_i_scaled) return arb_is_int(order.get()) ? Complex(disc(Ball(1))) : unknown(x);
    const Ball least = c * least_rho(x, side);
    return Complex(disc(sqrt(touchstone::pi<Ball>() / (Ball(2) * least)) * (Ball(1) + lemma::bessel_remainder(order, least, Ball(1)))));
}

/// |J_n(z)| <= exp(|Im z|), |I_n(z)| <= exp(|Re z|) for integer n, from J_n(z) = (1/pi) times the integral of cos(n t - z sin t) over (0, pi)
/// and I_n(z) = i^-n J_n(iz) (DLMF 10.9.2, 10.27.6).
Complex bessel_of_integer_order(Op op, const Complex& x, Side side)
{
    if (!(x.order(side).logs == Exponent(1))) return {x.frame(), {}, {}, ComplexBall::indeterminate()};
    const ComplexBall c = factor_at(x, side);
    return growing(x, side, upper(touchstone::abs(op == Op::bessel_j ? c.imag() : c.real())));
}

/// log(u^p rho^k c) = p log u + k log rho + log c, and 0 <= log rho <= (4/e) rho^(1/4) for rho >= 1.
Complex logarithm(const Complex& x)
{
    Order bare[2];
    Complex grown(0);
    for (const Side s : {Side::left, Side::right}) {
        const Order own = x.order(s);
        bare[s == Side::left ? 0 : 1] = {own.power, 0};
        if (own.logs.is_zero()) continue;
        if (!x.frame()->reaches(s) || !arb_ge(least_rho(x, s).get(), Ball(1).get()))
            return {x.frame(), {}, {}, ComplexBall::indeterminate()};
        const Ball most = hull(Ball(0), lemma::logarithm_over_fourth_root()) * own.logs.ball();
        const Order quarter{0, Exponent(1, 4)};
        grown = grown + Complex(x.frame(), s == Side::left ? quarter : Order{}, s == Side::left ? Order{} : quarter, ComplexBall(most));
    }
    return grown + log(Complex(x.frame(), bare[0], bare[1], x.factor()));
}

/// |Ai(z)| <= |exp(-zeta)|/(2 sqrt(pi Re sqrt z)), zeta = (2/3) z^(3/2), for |arg z| < pi: from Ai(z) = exp(-zeta)/pi times the integral of
/// exp(-sqrt(z) t^2) cos(t^3/3) over t > 0 (DLMF 9.5.7).
Complex airy(const Complex& x)
{
    const auto side = side_of_growth(x);
    if (!side) return x.map([](const ComplexBall& v) { return special_function(Op::airy_ai, v); });
    const Ball c = factor_at(x, *side).real();
    if (!arb_is_positive(c.get())) return {x.frame(), {}, {}, ComplexBall::indeterminate()};
    const ComplexBall root = analytic::sqrt(factor_at(x, *side));
    const Ball least = root.real() * exp(x.order(*side).logs.ball() * log(least_rho(x, *side)) / Ball(2));
    if (!arb_is_positive(least.get())) return {x.frame(), {}, {}, ComplexBall::indeterminate()};
    const Complex zeta = to_power(x, Exponent(3, 2)) * Complex(Rational(2, 3));
    return exponential(-zeta) * Complex(disc(Ball(1) / (Ball(2) * sqrt(touchstone::pi<Ball>() * least))));
}

template <class V>
bool is_odd_at_zero(Op op, const EndpointNumber<V>& x)
{
    return (op == Op::sinh || op == Op::tanh || op == Op::asinh || op == Op::atanh) && vanishes_at_an_end(x);
}

/// The odd functions as x times an even one, so that a zero stays one.
template <class V>
EndpointNumber<V> odd(Op op, const EndpointNumber<V>& x)
{
    const V z = x.value();
    const auto f = [op](const V& v) { return special_function(op, v); };
    V ratio;
    if (op == Op::asinh || op == Op::atanh)
        ratio = analytic::odd_over_argument(z, f);
    else {
        // sinh z = z sinc(i z), tanh z = sinh z/cosh z
        if constexpr (std::same_as<V, ComplexBall>) {
            ComplexBall turned;
            acb_mul_onei(turned.get(), z.get());
            ratio = analytic::sinc(turned);
        }
        else
            ratio = arb_contains_zero(z.get()) ? V::indeterminate() : f(z) / z;
        if (op == Op::tanh) {
            if constexpr (std::same_as<V, ComplexBall>) ratio = ratio / special_function(Op::cosh, z);
        }
    }
    return {x.frame(), x.left(), x.right(), x.factor() * ratio};
}

template <class V>
EndpointNumber<V> general(Op op, const EndpointNumber<V>& x)
{
    if (is_odd_at_zero(op, x)) return odd(op, x);
    switch (op) {
    case Op::log: return log(x);
    case Op::sqrt: return sqrt(x);
    case Op::asin: return asin(x);
    case Op::sin: return sin(x);
    case Op::cos: return cos(x);
    case Op::atan: return has_pole_at_an_end(x) ? arc_tangent_of_pole(x) : atan(x);
    case Op::asinh:
        if (has_pole_at_an_end(x)) return inverse_hyperbolic_sine_of_large(x);
        return x.map([op](const V& v) { return special_function(op, v); });
    // the powers of the distances are positive on the interval
    case Op::abs: return {x.frame(), x.left(), x.right(), analytic::abs(x.factor())};
    case Op::sign: return {x.frame(), {}, {}, analytic::sgn(x.factor())};
    default: return x.map([op](const V& v) { return special_function(op, v); });
    }
}

/// The scaled Bessel functions about 0, as products.
template <class V>
std::optional<EndpointNumber<V>> scaled_about_zero(Op op, const Ball& order, const EndpointNumber<V>& x)
{
    if (op != Op::bessel_i_scaled && op != Op::bessel_k_scaled) return std::nullopt;
    const bool is_i = op == Op::bessel_i_scaled;
    auto plain = bessel_about_zero(is_i ? Op::bessel_i : Op::bessel_k, order, x);
    if (plain) *plain *= function_of(Op::exp, EndpointNumber<V>(is_i ? -x : x));
    return plain;
}

} // namespace

Real function_of(Op op, const Real& x)
{
    if (op == Op::elliptic_k_of_complement || op == Op::elliptic_e_of_complement) return elliptic_of_complement(op, x);
    return general(op, x);
}

Complex function_of(Op op, const Complex& x)
{
    switch (op) {
    case Op::elliptic_k_of_complement:
    case Op::elliptic_e_of_complement: return elliptic_of_complement(op, x);
    case Op::exp: return exponential(x);
    case Op::log: return logarithm(x);
    case Op::airy_ai: return airy(x);
    case Op::sin:
    case Op::cos: return trigonometric(op, x);
    case Op::atan: return arc_tangent(x);
    case Op::asinh: return side_of_growth(x) ? inverse_hyperbolic_sine_of_large(x) : general(op, x);
    case Op::erf:
    case Op::erfc: return error_function(op, x);
    case Op::erfc_scaled:
        if (const auto d = departure(x)) return scaled(op, Ball(0), x, *d);
        if (const auto side = side_of_growth(x)) return scaled(op, Ball(0), x, *side);
        return general(op, x);
    default: return general(op, x);
    }
}

Real function_of(Op op, const Ball& order, const Real& x)
{
    if (auto about_zero = bessel_about_zero(op, order, x)) return *about_zero;
    if (auto about_zero = scaled_about_zero(op, order, x)) return *about_zero;
    return x.map([&](const Ball& v) { return special_function(op, order, v); });
}

Complex function_of(Op op, const Ball& order, const Complex& x)
{
    if (const auto d = departure(x)) {
        if (op == Op::bessel_k) return bessel_k(order, x, *d);
        if (op == Op::bessel_i_scaled || op == Op::bessel_k_scaled) return scaled(op, order, x, *d);
    }
    if (const auto side = side_of_growth(x)) {
        if (op == Op::bessel_k) return bessel_k(order, x, *side);
        if (op == Op::bessel_i_scaled || op == Op::bessel_k_scaled) return scaled(op, order, x, *side);
        if ((op == Op::bessel_j || op == Op::bessel_i) && arb_is_int(order.get())) return bessel_of_integer_order(op, x, *side);
    }
    if (auto about_zero = bessel_about_zero(op, order, x)) return *about_zero;
    if (auto about_zero = scaled_about_zero(op, order, x)) return *about_zero;
    return x.map([&](const ComplexBall& v) { return special_function(op, order, v); });
}

} // namespace touchstone::quadrature
