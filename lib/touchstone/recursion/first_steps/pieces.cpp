// SPDX-License-Identifier: MIT
#include "touchstone/recursion/first_steps/pieces.hpp"

#include "touchstone/quadrature/half_powers.hpp"
#include "touchstone/scalar/accuracy.hpp"
#include "touchstone/scalar/refusal.hpp"

#if __has_include(<flint/acb_calc.h>)
#include <flint/acb_calc.h>
#else
#include <acb_calc.h>
#endif

#include <algorithm>
#include <cmath>

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

namespace {

/// The disc about m of this radius, or what encloses it.
C disc(const C& m, const Ball& radius)
{
    C r = m;
    arb_add_error(acb_realref(r.get()), radius.get());
    arb_add_error(acb_imagref(r.get()), radius.get());
    return r;
}
/// Midpoint, and radius over its modulus
std::pair<C, Ball> relative_disc(const C& z)
{
    C m;
    acb_get_mid(m.get(), z.get());
    return {m, abs(z - m) / abs(m)};
}

} // namespace

C root_on_disc(const C& z)
{
    const auto [m, t] = relative_disc(z);
    const Ball clear = certainly(less(Ball(0), m.real())) ? abs(m) : abs(m.imag());
    if (!certainly(less(t * abs(m), clear))) return C::indeterminate(); // the disc meets the cut
    const C r = sqrt(m); // |(1 + s)^(1/2) - 1| <= 1 - (1 - t)^(1/2), |s| <= t
    return disc(r, abs(r) * (1 - sqrt(1 - t)));
}

C quotient_on_disc(const C& a, const C& b)
{
    const auto [m, t] = relative_disc(b);
    if (!certainly(less(t, Ball(1)))) return C::indeterminate();
    return a * disc(1 / m, t / ((1 - t) * abs(m)));
}

C within(const Ball& radius) { return disc(C(0), radius); }

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
    return {Ball(r), Exact(r)};
}

int order(const End& a, const End& b)
{
    if (same(a, b)) return 0;
    if (a.exact && b.exact) return *a.exact == *b.exact ? 0 : certainly(less(*a.exact, *b.exact)) ? -1 : 1;
    if (certainly(less(a.at(), b.at()))) return -1;
    if (certainly(less(b.at(), a.at()))) return 1;
    throw BeyondReach("two ends of waves are too close to be told from one another");
}

Ball difference(const End& a, const End& b)
{
    if (same(a, b)) return Ball(0);
    if (a.exact && b.exact)
        if (const auto d = exactly([&] { return *b.exact - *a.exact; })) return d->ball();
    Ball d;
    arb_sub(d.get(), b.at().get(), a.at().get(), bits() + end_bits);
    return narrow(d);
}

C Piece::Point::distance(const Beyond& b) const
{
    return C(b.gap) + C(piece->width_) * (b.left ? left : right);
}

C Piece::Point::root_of(const Beyond& b) const
{
    if (b.zero()) return C(sqrt(piece->width_)) * (b.left ? sine : cosine);
    return root(distance(b), analytic);
}

namespace {

/// How many of the roots are those of the piece's own ends, and what they and dx become in shares of the piece.
struct EndRoots {
    EndRoots(const std::vector<Piece::Beyond>& roots, const Ball& width) : scale(width)
    {
        for (const Piece::Beyond& b : roots)
            if (b.zero()) {
                bool& end = b.left ? at_left : at_right;
                if (end) throw BeyondReach("the density is infinite at this pressure");
                end = true;
                scale = scale / sqrt(width);
            }
    }
    bool at_left = false, at_right = false;
    Ball scale;
};

C over_other_roots(C value, const Piece::Point& x, const std::vector<Piece::Beyond>& roots)
{
    for (const Piece::Beyond& b : roots)
        if (!b.zero()) value = value / x.root_of(b);
    return value;
}

} // namespace

Ball Piece::integral(const Function& f, const std::vector<Beyond>& roots) const
{
    return extent_ == Extent::whole ? as_a_whole(f, roots) : by_half(f, roots);
}

Ball Piece::by_half(const Function& f, const std::vector<Beyond>& roots) const
{
    const EndRoots ends(roots, width_);
    const bool from_left = extent_ == Extent::left_half;
    constexpr slong tolerance_bits = 6000; // of the value's own size: p may be 1e-300
    return 2 * ends.scale * integrate([&](const C& t, bool analytic) {
               const C s = sin(t), c = cos(t);
               const C near = s * s, far = c * c;
               const Point x{this, from_left ? s : c, from_left ? c : s, from_left ? near : far, from_left ? far : near, analytic};
               C value = f(x);
               if (!ends.at_left) value = value * x.sine;
               if (!ends.at_right) value = value * x.cosine;
               return over_other_roots(value, x, roots);
           }, pi<Ball>() / 4, tolerance_bits);
}

Ball Piece::as_a_whole(const Function& f, const std::vector<Beyond>& roots) const
{
    using quadrature::EndpointNumber;
    const EndRoots ends(roots, width_);
    const auto on_line = [&]<class V>(const EndpointNumber<V>& left, const EndpointNumber<V>& right) {
        constexpr bool in_plane = std::same_as<V, C>;
        const EndpointNumber<V> sine = sqrt(left), cosine = sqrt(right);
        const Point x{this, C(sine.value()), C(cosine.value()), C(left.value()), C(right.value()), in_plane};
        const C value = over_other_roots(f(x), x, roots);
        EndpointNumber<V> y;
        if constexpr (in_plane) y = value;
        else y = value.real();
        if (ends.at_left) y /= sine;
        if (ends.at_right) y /= cosine;
        return y;
    };
    constexpr long guard = 8; // digits, of the fourteen beyond those asked for that the working precision holds
    quadrature::Options options;
    options.digits = std::max(2L, accuracy_of(bits()).digits + guard);
    options.proof_budget = 4000; // values: a proof that needs more costs more than the halves do
    const auto integrand = [&](auto, auto left, auto right) { return on_line(left, right); };
    const quadrature::Enclosure e = quadrature::proven_integral(integrand, quadrature::Interval::finite(0, 1), options);
    if (e.status == quadrature::Status::indeterminate) // a pair of complex singular points all but pinches an end
        return Piece(a_, b_, Extent::left_half).by_half(f, roots) + Piece(a_, b_, Extent::right_half).by_half(f, roots);
    return ends.scale * e.value;
}

namespace {

constexpr double core = 14; // exp(-core) < 1e-6: beyond, on either side, a bound of the integrand is known
constexpr double column = 0.125;
constexpr int rows = 8;

/// mid +- half
Ball interval(double mid, double half)
{
    Ball b = Ball::exactly(mid);
    arb_add_error(b.get(), Ball::exactly(half).get());
    return b;
}
Ball upper(const Ball& b)
{
    Ball u;
    arb_get_abs_ubound_arf(arb_midref(u.get()), b.get(), WorkingPrecision::bits());
    return u;
}
double nearest(const Ball& b) { return arf_get_d(arb_midref(b.get()), ARF_RND_NEAR); }

} // namespace

C Piece::along_exponentials(const Function& f, const C& u, bool analytic) const
{
    const C one(1);
    const C left = analytic ? quotient_on_disc(one, 1 + exp(-u)) : 1 / (1 + exp(-u)),
            right = analytic ? quotient_on_disc(one, 1 + exp(u)) : 1 / (1 + exp(u));
    const C sine = analytic ? root_on_disc(left) : sqrt(left), cosine = analytic ? root_on_disc(right) : sqrt(right);
    return f({this, sine, cosine, left, right, analytic}) * C(width_) * left * right;
}

/// At least the integral of |F| over |Re u| <= core, Im u = height; infinite unless F is analytic between that and the real line.
Ball Piece::over_core(const Function& f, double height) const
{
    Ball sum(0);
    const double half = height / (2 * rows);
    for (double x = -core; x < core; x += column) // exact in binary64
        for (int k = 0; k < rows; ++k) {
            const C F = along_exponentials(f, {interval(x + column / 2, column / 2), interval((2 * k + 1) * half, half * 1.0001)}, true);
            if (!F.is_finite()) return Ball::indeterminate();
            if (k + 1 == rows) sum += abs(F) * Ball::exactly(column);
        }
    return sum;
}

Ball Piece::between_logarithms(const Function& f, const Rest& rest, double height, slong goal) const
{
    const auto beyond = [](double x) { return exp(-Ball::exactly(x)); };
    Ball on_line;
    {
        const WorkingPrecision precision(64);
        for (;; height *= 0.8) {
            if (height < 0.05) throw BeyondReach("an integrand is not proved analytic next to a singular point");
            on_line = over_core(f, height);
            for (const bool left : {true, false}) on_line += rest(left, beyond(core));
            on_line *= 2;
            if (on_line.is_finite()) break;
        }
    }
    const Ball h_rough = Ball(1) / 2;
    Ball rough(0); // of the integral: only a choice of the tolerance
    for (long k = -80; k <= 80; ++k) rough += h_rough * along_exponentials(f, h_rough * k, false).real();
    Ball tolerance;
    arb_get_mid_arb(tolerance.get(), rough.get());
    tolerance = abs(tolerance) * ScalarTraits<Ball>::power_of_two(-goal);
    const auto cut = [&](bool left) {
        double x = core;
        while (!certainly(less(rest(left, beyond(x)), tolerance))) {
            x *= 1.02;
            if (x > 1e6) throw BeyondReach("an integral does not converge at a singular point");
        }
        return x;
    };
    const double step = 2 * 3.14159 * height / nearest(log(1 + upper(on_line) / tolerance)), left = cut(true), right = cut(false);
    const Ball h = Ball::exactly(step);
    const slong bits = WorkingPrecision::bits();
    const auto term = [&](long k) {
        // terms fall like exp(-|u|/4) at least
        const WorkingPrecision precision(
            std::max(bits - static_cast<slong>(std::fabs(static_cast<double>(k)) * step * 0.36), bits - goal + 16));
        return along_exponentials(f, h * k, false).real();
    };
    Ball sum(0);
    const long from = -static_cast<long>(left / step) - 1, to = static_cast<long>(right / step) + 1;
    for (long k = from; k <= to; ++k) sum += term(k);
    sum = h * sum;
    Ball error = on_line / (exp(2 * pi<Ball>() * Ball::exactly(height) / h) - 1); // of discretisation
    error += rest(true, beyond(left));
    error += rest(false, beyond(right));
    arb_add_error(sum.get(), error.get());
    return sum;
}

Ball over_halves(const End& a, const End& b, const std::function<Ball(const Piece&)>& half)
{
    if (!below(a, b)) return Ball(0);
    return half(Piece(a, b, Extent::left_half)) + half(Piece(a, b, Extent::right_half));
}

Ball over_whole(const End& a, const End& b, const std::function<Ball(const Piece&)>& whole)
{
    return below(a, b) ? whole(Piece(a, b, Extent::whole)) : Ball(0);
}

} // namespace touchstone::transfer::first_steps
