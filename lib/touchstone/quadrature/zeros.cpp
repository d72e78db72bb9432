// SPDX-License-Identifier: MIT
#include "touchstone/quadrature/zeros.hpp"

#include "touchstone/quadrature/lemmas.hpp"
#include "touchstone/quadrature/widen.hpp"

#include <cmath>
#include <numbers>

namespace touchstone::quadrature::compiled {
namespace {

double to_double(const Ball& x) { return arf_get_d(arb_midref(x.get()), ARF_RND_NEAR); }

/// A number of few bits about half of x > 0. A double would not do: ranges may be as small as 1e-400 and as large as 1e400.
Ball about_half(const Ball& x)
{
    Ball half;
    arf_set_round(arb_midref(half.get()), arb_midref(x.get()), 53, ARF_RND_DOWN);
    arb_mul_2exp_si(half.get(), half.get(), -1);
    return half;
}

/// x/2^halvings, exactly.
Ball divided(Ball x, slong halvings)
{
    arb_mul_2exp_si(x.get(), x.get(), -halvings);
    return x;
}

constexpr int most_halvings = 6; ///< of the radius of the discs that are tried

/// The radii that are tried, the largest first. Beside a small range a disc may be much larger than that: how a formula behaves has another
/// scale, and on a disc of 1e-20 nothing is seen of exp(s) - 1 with the bits of a proof.
std::vector<Ball> radii_about(const Ball& span, bool beyond_the_range)
{
    std::vector<Ball> all;
    constexpr slong small = 6; // halvings of 1 that such a range begins with
    if (beyond_the_range && arb_lt(span.get(), divided(Ball(1), small).get()))
        for (slong halvings = 0; arb_lt(span.get(), divided(Ball(1), halvings).get()); halvings = 2 * halvings + 2)
            all.push_back(divided(Ball(1), halvings));
    for (slong k = 0; k <= most_halvings; ++k) all.push_back(divided(span, k));
    return all;
}

} // namespace

/// The power of s that n shows on a small box beside the end; nothing if it is not proved analytic there.
std::optional<Exponent> Zeros::order_beside(const Node& n, Side side, const Ball& distance) const
{
    const ComplexBall s(distance);
    const Disc<ComplexBall> disc(side, s);
    const EndpointNumber<ComplexBall> v = evaluate(n, point_about(disc, place_), place_);
    return v.factor().is_finite() ? std::optional(v.order(side).power) : std::nullopt;
}

/// Whether n is a power of s times what is proved analytic and without a zero on the disc |s| <= radius: then no expansion shows more.
bool Zeros::shows_its_order(const Node& n, Side side, const Ball& radius) const
{
    const ComplexBall s = disc(radius);
    const Disc<ComplexBall> about(side, s);
    const ComplexBall c = evaluate(n, point_about(about, place_), place_).factor();
    return c.is_finite() && !acb_contains_zero(c.get());
}

/// On the disc |s| <= radius about the end, n = s^p c: p, and a bound of |c|. Nothing if c is not proved analytic there.
std::optional<std::pair<Exponent, Ball>> Zeros::bound_on_disc(const Node& n, Side side, const Ball& radius) const
{
    constexpr int across = 4; // boxes along a side of the square about the disc
    const Ball half = radius / Ball(across);
    std::optional<Exponent> order;
    Ball most(0);
    for (int i = 0; i < across; ++i)
        for (int j = 0; j < across; ++j) {
            const auto interval = [&](int k) {
                Ball b = Ball(2 * k + 1 - across) * half;
                arb_add_error(b.get(), half.get());
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
std::optional<Zero> Zeros::at(const Node& n, Side side, const Expand& expand, bool beyond_the_range) const
{
    constexpr slong beside = 20;
    const Range& range = *place_.range;
    const Ball span = range.map == Map::finite ? about_half(range.to.ball() - range.from.ball()) : Ball(1);
    if (shows_its_order(n, side, divided(span, beside))) return std::nullopt;
    const auto series = expand();
    if (!series) return std::nullopt;
    const bool whole = series->valuation.get_den() == 1 && series->valuation.get_num().fits_slong_p();
    if (!whole || series->valuation < 0 || series->is_exactly_zero) return std::nullopt;
    Zero zero;
    zero.order = series->valuation.get_num().get_si();
    zero.c = series->c;
    if (const auto own = order_beside(n, side, divided(span, most_halvings)); own && *own == Exponent(zero.order))
        return std::nullopt; // it shows as it is
    std::optional<Zero> best;
    for (const Ball& radius : radii_about(span, beyond_the_range && range.map == Map::finite)) {
        const auto bound = bound_on_disc(n, side, radius);
        if (!bound) continue;
        const auto& [order, size] = *bound;
        if (!order.is_integer()) return std::nullopt;
        if (order == Exponent(zero.order)) return std::nullopt; // it shows as it is
        // |T| on the circle, so inside: |c| R^(order - m)
        zero.radius = radius;
        zero.bound = size * exp((order - Exponent(zero.order)).ball() * log(radius));
        if (!zero.bound.is_finite()) continue;
        best = zero;
        if (zero.c.empty()) break; // all that is known of T is its bound
        const double tail = to_double(zero.bound) * std::pow(0.25, static_cast<double>(zero.c.size()));
        if (tail < 0.05 * to_double(touchstone::abs(zero.c[0].complex_ball()))) break;
    }
    return best;
}

/// Whether a formula that was compiled for no range is analytic on a neighbourhood of the circle |s| = radius: boxes that overlap cover it.
bool Zeros::is_analytic_about_circle(const Node& plain, const Ball& radius)
{
    constexpr int boxes = 64;
    const Ball half = radius * Ball::exactly(1.01 * std::numbers::pi / boxes); // at least the half length of an arc
    const EndpointNumber<ComplexBall> nowhere(ComplexBall::indeterminate());
    for (int i = 0; i < boxes; ++i) {
        const double angle = 2 * std::numbers::pi * i / boxes;
        ComplexBall s(radius * Ball::exactly(std::cos(angle)), radius * Ball::exactly(std::sin(angle)));
        widen(s, half);
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
    const Ball span = about_half(range.to.ball());
    for (int k = 0; k <= most_halvings; ++k) {
        const Ball radius = divided(span, k);
        if (!is_analytic_about_circle(h, radius) || !bound_on_disc(*n.args[1], Side::left, radius)) continue;
        const auto bound = bound_on_disc(*n.args[0], Side::left, radius);
        if (!bound) continue;
        const auto& [order, size] = *bound;
        if (!order.is_integer() || order < Exponent(0)) return std::nullopt; // h itself has a pole or a branch point
        Zero zero;
        zero.order = 1;
        zero.radius = radius;
        zero.bound = lemma::odd_difference(size * exp(order.ball() * log(radius)), radius);
        return zero;
    }
    return std::nullopt;
}

} // namespace touchstone::quadrature::compiled
