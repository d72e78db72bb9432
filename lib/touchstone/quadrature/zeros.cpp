// SPDX-License-Identifier: MIT
#include "touchstone/quadrature/zeros.hpp"

#include "touchstone/quadrature/lemmas.hpp"
#include "touchstone/quadrature/widen.hpp"

#include <cmath>
#include <numbers>

namespace touchstone::quadrature::compiled {
namespace {

double to_double(const Ball& x) { return arf_get_d(arb_midref(x.get()), ARF_RND_NEAR); }

} // namespace

/// The power of s that n shows on a small box beside the end; nothing if it is not proved analytic there.
std::optional<Exponent> Zeros::order_beside(const Node& n, Side side, double distance) const
{
    const ComplexBall s(Ball::exactly(distance));
    const Disc<ComplexBall> disc(side, s);
    const EndpointNumber<ComplexBall> v = evaluate(n, point_about(disc, place_), place_);
    return v.factor().is_finite() ? std::optional(v.order(side).power) : std::nullopt;
}

/// Whether n is a power of s times what is proved analytic and without a zero on the disc |s| <= radius: then no expansion shows more.
bool Zeros::shows_its_order(const Node& n, Side side, double radius) const
{
    const ComplexBall s = disc(Ball::exactly(radius));
    const Disc<ComplexBall> about(side, s);
    const ComplexBall c = evaluate(n, point_about(about, place_), place_).factor();
    return c.is_finite() && !acb_contains_zero(c.get());
}

/// On the disc |s| <= radius about the end, n = s^p c: p, and a bound of |c|. Nothing if c is not proved analytic there.
std::optional<std::pair<Exponent, Ball>> Zeros::bound_on_disc(const Node& n, Side side, double radius) const
{
    constexpr int across = 4; // boxes along a side of the square about the disc
    const double half = radius / across;
    std::optional<Exponent> order;
    Ball most(0);
    for (int i = 0; i < across; ++i)
        for (int j = 0; j < across; ++j) {
            const auto interval = [&](int k) {
                Ball b = Ball::exactly((2 * k + 1 - across) * half);
                mag_t m;
                mag_init(m);
                mag_set_d(m, half);
                arb_add_error_mag(b.get(), m);
                mag_clear(m);
                return b;
            };
            const ComplexBall s(interval(i), interval(j));
            const Disc<ComplexBall> disc(side, s);
            const EndpointNumber<ComplexBall> v = evaluate(n, point_about(disc, place_), place_);
            if (!v.factor().is_finite()) return std::nullopt;
            if (order && !(*order == v.order(side).power)) return std::nullopt;
            order = v.order(side).power;
            Ball size = touchstone::abs(v.factor()), top;
            arb_get_ubound_arf(arb_midref(top.get()), size.get(), 53);
            if (!arb_gt(most.get(), top.get())) most = top;
        }
    return std::pair(*order, most);
}

/// The zero that the exact expansion shows and the sum of terms does not.
std::optional<Zero> Zeros::at(const Node& n, Side side, const Expand& expand) const
{
    constexpr double beside = 0x1p-20;
    const Range& range = *place_.range;
    const double span = range.map == Map::finite ? to_double(range.to.ball() - range.from.ball()) / 2 : 1;
    if (shows_its_order(n, side, span * beside)) return std::nullopt;
    const auto series = expand();
    if (!series) return std::nullopt;
    const bool whole = series->valuation.get_den() == 1 && series->valuation.get_num().fits_slong_p();
    if (!whole || series->valuation < 0 || series->is_exactly_zero) return std::nullopt;
    Zero zero;
    zero.order = series->valuation.get_num().get_si();
    zero.c = series->c;
    if (const auto own = order_beside(n, side, span / 64); own && *own == Exponent(zero.order)) return std::nullopt; // it shows as it is
    std::optional<Zero> best;
    for (double radius = span; radius >= span / 64; radius /= 2) {
        const auto bound = bound_on_disc(n, side, radius);
        if (!bound) continue;
        const auto& [order, size] = *bound;
        if (!order.is_integer()) return std::nullopt;
        if (order == Exponent(zero.order)) return std::nullopt; // it shows as it is
        // |T| on the circle, so inside: |c| R^(order - m)
        zero.radius = radius;
        zero.bound = size * exp((order - Exponent(zero.order)).ball() * log(Ball::exactly(radius)));
        if (!zero.bound.is_finite()) continue;
        best = zero;
        if (zero.c.empty()) break; // all that is known of T is its bound
        const double tail = to_double(zero.bound) * std::pow(0.25, static_cast<double>(zero.c.size()));
        if (tail < 0.05 * to_double(touchstone::abs(zero.c[0].complex_ball()))) break;
    }
    return best;
}

/// Whether a formula that was compiled for no range is analytic on a neighbourhood of the circle |s| = radius: boxes that overlap cover it.
bool Zeros::is_analytic_about_circle(const Node& plain, double radius)
{
    constexpr int boxes = 64;
    const double half = 1.01 * radius * std::numbers::pi / boxes; // at least the half length of an arc
    const EndpointNumber<ComplexBall> nowhere(ComplexBall::indeterminate());
    for (int i = 0; i < boxes; ++i) {
        const double angle = 2 * std::numbers::pi * i / boxes;
        ComplexBall s(Ball::exactly(radius * std::cos(angle)), Ball::exactly(radius * std::sin(angle)));
        widen(s, Ball::exactly(half));
        if (!evaluate(plain, Point<ComplexBall>{s, nowhere, nowhere, std::nullopt}, Place{}).value().is_finite()) return false;
    }
    return true;
}

/// h(s) - h(-s) = s T(s): if h is analytic on |s| <= R, so is T, and |T| <= 2 sup|h|/R (tanh_sinh.md, section 11).
/// What is compiled for the range is what continues h(s), and h(-s), from s > 0: with an abs, or a cut through 0, these are two functions.
/// Both are analytic on the disc; that the second is the first at -s is known if h as it stands is analytic about the circle, on which one
/// leads to the other.
std::optional<Zero> Zeros::of_odd_difference(const Node& n, const Node& h) const
{
    const Range& range = *place_.range;
    if (range.map != Map::finite) return std::nullopt;
    const double span = to_double(range.to.ball()) / 2;
    for (double radius = span; radius >= span / 64; radius /= 2) {
        if (!is_analytic_about_circle(h, radius) || !bound_on_disc(*n.args[1], Side::left, radius)) continue;
        const auto bound = bound_on_disc(*n.args[0], Side::left, radius);
        if (!bound) continue;
        const auto& [order, size] = *bound;
        if (!order.is_integer() || order < Exponent(0)) return std::nullopt; // h itself has a pole or a branch point
        Zero zero;
        zero.order = 1;
        zero.radius = radius;
        const Ball R = Ball::exactly(radius);
        zero.bound = lemma::odd_difference(size * exp(order.ball() * log(R)), R);
        return zero;
    }
    return std::nullopt;
}

} // namespace touchstone::quadrature::compiled
