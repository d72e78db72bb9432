// SPDX-License-Identifier: MIT
/// \file
/// Panels between the singular points of a function of the load ratio, shrinking towards them (heavy_load.hpp).
///
/// Internal to transfer/.
#pragma once

#include "touchstone/transfer/contact.hpp"
#include "touchstone/transfer/fixed.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <map>
#include <numbers>
#include <vector>

namespace touchstone::transfer::heavy_load {

inline double approximate(const Ball& b) { return arf_get_d(arb_midref(b.get()), ARF_RND_NEAR); }
inline double upper_double(const Ball& b)
{
    const Ball u = upper(b);
    return arf_get_d(arb_midref(u.get()), ARF_RND_UP);
}
/// An exact number at most / at least b, as near as the precision allows.
inline Ball below(const Ball& b)
{
    Ball r;
    arb_get_lbound_arf(arb_midref(r.get()), b.get(), WorkingPrecision::bits());
    return r;
}
inline Ball above(const Ball& b)
{
    Ball r;
    arb_get_ubound_arf(arb_midref(r.get()), b.get(), WorkingPrecision::bits());
    return r;
}
inline bool is_below(const Ball& a, const Ball& b) { return certainly(less(a, b)); }

/// From a to b >= a, rounded; 0 where they cannot be told apart.
inline double distance(const Ball& a, const Ball& b) { return std::max(approximate(b - a), 0.0); }
/// Less than the distance from a to b > a.
inline double room_between(const Ball& a, const Ball& b) { return approximate(below(b - a)) * 0.999; }
inline double room_to_one(const Ball& a) { return room_between(a, Ball(1)); }

/// A point of S, or an end of a range: somewhere in [lo, hi], both exact.
struct Bracket {
    Ball lo, hi;
};

// ---- Lemma 3

/// At least c_m of Lemma 2 for every m: from c_64 on the factors are 1 + O(2^-65).
Ball largest_size(const Ball& G);

/// Q(X) and M(X), c = lim c_m: Q G^-m is at least B_m on [0, X], M G^-m at least |B_m| on every disc D(J), J within [0, X]. \pre X >= 0
Ball largest_real(const Ball& X, const Ball& G, const Ball& c);
Ball largest_in_disc(const Ball& X, const Ball& G, const Ball& c);

/// The points of S from 0 to beyond `top`, in order, those that cannot be told apart in one bracket.
std::vector<Bracket> singular_points(const Ball& top, const Ball& G);

/// The ends of a wave and the points of S between them, in order, and how far B goes on analytically beyond either end: 0 where a point of
/// S cannot be told apart from it.
struct Cuts {
    std::vector<Bracket> at;
    double room_lo, room_hi;
};
Cuts cuts_between(const Ball& lo, const Ball& hi, const std::vector<Bracket>& S);

// ---- bounds, for functions of which no more is known than the size on an ellipse, and for the kernels

constexpr double margin = 1.000001; ///< on what is computed with a few roundings of binary64

/// Of the n-point Gauss rule on a panel of half-length `half`, the integrand at most `most` on the ellipse of parameter rho: its
/// Chebyshev coefficients are <= 2 most rho^-k, and from k = 2n on the rule and the integral of T_k differ by at most 2 + 2/3 (rule.hpp).
inline double gauss_error(double half, double most, double rho, long n)
{
    return half * 16 / 3 * most * std::pow(rho, -2 * static_cast<double>(n)) / (1 - 1 / rho) * margin;
}

/// Of the interpolation at p Chebyshev points of a function that is at most 1 on the ellipse of parameter rho: twice the sum of the
/// coefficients from k = p on, <= 2 rho^-k each.
inline double interpolation_error(long p, double rho) { return 4 * std::pow(rho, -static_cast<double>(p - 1)) / (rho - 1) * margin; }

/// What the radii of a weight and of its place, in a panel with p points, may change of the interpolant's sum: each of the p moments by
/// that of the weight, and twice their sum counts; the function by Cauchy's bound of its derivative, (rho + 1/rho)/2 - 1 being above
/// 1/100.
inline double entry_error(double weight, double radius, double radius_of_place, long p)
{
    return 2 * static_cast<double>(p) * radius + 100 * weight * radius_of_place;
}

/// What the roundings of fixed point change of the sum of weights times a function that is at most 1, |weights| adding up to `entered` in
/// so many `terms`, in panels of at most p points. Of w T_k(t), by T_k = 2 t T_(k-1) - T_(k-2): t is off by a unit, k^2 |w| units; w is,
/// 1 unit; and the j-th product is, which goes on as U_(k-j), |U_m| <= m + 1, k (k + 1)/2 units. Twice their sum over k < p is at most
/// p^3 (entered + terms) for p > 1.
inline double rounding_error(double entered, double terms, long p, double unit)
{
    const double points = static_cast<double>(p);
    return points * points * points * (entered + terms) * unit;
}

/// At least |kernel of (F1)| at complex y so far from the ends of the wave.
inline double full_kernel_bound(double from_low, double from_high)
{
    return 1 / (std::numbers::pi * std::sqrt(from_low * from_high)) * margin;
}

/// At least |k(x, y)| of (F2), 0 < x < 1, at complex y with Re y >= right > 0, |y| <= largest, `from_high` or more from the end 2
/// x^(1/2)/G of the wave. For Re R > 0, |R| >= G Re y, |1 - x + R| >= |R|, |1 + x + R| <= 2 + |R|; and x - G^2 y^2/4 = (G/2) (2 x^(1/2)/G
/// - y) (x^(1/2) + G y/2), whose last factor is at least x^(1/2).
inline double partial_kernel_bound(double G, double root_x, double right, double from_high, double largest)
{
    const double R = G * right;
    return G * G * largest / (2 * std::numbers::pi) * std::sqrt(2 / R + 1) / R / std::sqrt(G / 2 * from_high * root_x) * margin;
}

/// The same where y = end -+ v^2, times dy/dv = 2 v: the root of the distance from that end cancels v.
inline double full_kernel_end_bound(double from_other) { return 2 * full_kernel_bound(1, from_other); }
inline double partial_kernel_end_bound(double G, double root_x, double right, double largest)
{
    return 2 * partial_kernel_bound(G, root_x, right, 1, largest);
}

/// At least int_0^start y^(1/2) |k(x, y)| dy of (F2), where 2/G < x < 1, G start <= 0.1 and (G start)^2 <= 0.04 x: R is at least G y and
/// 1 + x + R at most 2.1, x - G^2 y^2/4 at least 0.99 x, so that k <= (2.13 G/(x y))^(1/2)/(2 pi), and G/x < G^2/2. The conditions, with
/// room for their own roundings:
inline bool is_dropped_below(double G, double x, double start) { return G * start < 0.09 && G * start * (G * start) < 0.03 * x; }
inline double dropped_below(double G, double start) { return 0.167 * G * start; }

/// area_at_heavy_load (heavy_load.hpp) with an error of about e^-accuracy, accuracy > 0, made anew: where accuracy is low, the error is
/// seen beside its bound. What adds up to the bound, by level: times G^-(n - level), and what was moved to another ratio (Lemma 4), times
/// G^-(n - level)/2.
struct Made {
    Ball area;
    std::map<long, double> errors, moved;
};
Made made(Scheme, long n, const Arguments&, double accuracy, long scales);

// ---- panels

/// How panels are graded.
struct Shape {
    double ratio, rho;
    /// Half the length of the ellipse of parameter rho about [-1, 1], and how far the one about [0, 1] goes beyond its ends.
    double major() const { return (rho + 1 / rho) / 2; }
    double beyond() const { return (major() - 1) / 2; }
    /// Whether the ellipse of parameter rho about a panel from d/ratio to d leaves out the end that the panels shrink to.
    bool stays_in_disc() const { return major() < (ratio + 1) / (ratio - 1) * 0.99; }
};

/// One panel: mid +- half, its distance to the nearer end of the interval, and its Chebyshev points.
struct Panel {
    Ball mid, half;
    long points;
    std::size_t first;
    double entered = 0; ///< sum of |weights|, rounded up
};

/// An interval between points of S, or a piece of one: panels shrinking towards both ends.
struct Graded {
    Ball lo, hi, middle, reach; ///< reach = (hi - lo)/2
    double ratio;
    long depth;                 ///< panels on either side; the last ends at reach ratio^-depth from the end
    Ball power(long k) const
    {
        Ball r = Ball::exactly(ratio);
        arb_pow_ui(r.get(), r.get(), static_cast<ulong>(std::abs(k)), WorkingPrecision::bits());
        return k < 0 ? 1 / r : r;
    }
};
inline Graded graded(const Ball& lo, const Ball& hi, double ratio, double last)
{
    Graded g{lo, hi, (lo + hi) / 2, (hi - lo) / 2, ratio, 1};
    g.depth = std::max(1L, static_cast<long>(std::ceil(std::log(approximate(g.reach) / last) / std::log(ratio))));
    return g;
}

// ---- measures

struct Node {
    Ball x, weight;
};

/// cos(pi k/(2p)), k < 4p.
std::vector<Ball> cosines(long p);

/// A measure on an interval, its weights at Chebyshev points of graded panels.
struct Grid {
    Graded g;
    Shape shape;
    Ball bound; ///< M
    FixedFormat format;
    std::vector<Panel> left, right;
    std::size_t nodes = 0;
    long most_points = 0;
    std::vector<mp_limb_t> moments; ///< sums of w T_k
    double terms = 0, held = 0;     ///< entries; |weights| x sqrt(distance) of what was moved to a panel's edge
    double loose = 0;               ///< what the radii of weights and of their places may change, where the function is at most 1
    std::vector<mp_limb_t> buffer;

    /// \param last panels shrink to this width, \param wanted accuracy in nats of what is at most `bound` on the panels' ellipses
    Grid(const Ball& lo, const Ball& hi, const Shape&, double last, double wanted, const Ball& bound, const FixedFormat&);
    /// Adds weight w at y.
    void enter(const Ball& y, const Ball& w);
    /// What the sum over the nodes of a function that is at most `bound` on the panels' ellipses may differ by from that over what has
    /// entered, but for `held`.
    double lost() const;
    /// \param cosines_for `cosines`, or what has kept them
    std::vector<Node> as_nodes(const std::function<const std::vector<Ball>&(long)>& cosines_for) const;
};

// ---- integrals over a piece of the wave

struct Gauss {
    std::vector<Ball> root, weight; ///< the n roots, all of them, the largest first
};

/// One piece of an integral, [a, b] without a point of S inside, and what is left of it at either end.
struct Piece {
    Ball a, b;
    double tolerance, finest;
    /// Where the kernel's own end is that of the piece and B goes on: how far, until a point of S. Else 0.
    double room_a = 0, room_b = 0;
    Ball farthest() const { return upper(b + Ball::exactly(room_b)); } ///< that an ellipse may reach
    Ball from, to; ///< the part the rules have covered
};

/// Gauss rules on panels of a piece, shrinking towards an end down to `finest`, or to what the room beyond the end allows: then the last
/// stretch, l long, is taken in v = (distance from the end)^(1/2), which removes the kernel's square root there, over the ellipse of
/// parameter rho^(1/2), whose image in y is the one of parameter rho about the stretch.
/// \param most at least |B| on the ellipses
/// \param rules the Gauss rule of so many points
/// \param take takes y and its share of the integral, \param note a bound of a rule's error
/// \param bound of the kernel on an ellipse by (least distance from a, from b, largest |y|)
/// \param kernel_at_end (left, y) with 2 v, \param bound_at_end (left, l and how far the ellipse goes beyond it, least distance from the
/// other end) with 2 v
template <class Rules, class Take, class Note, class Kernel, class Bound, class KernelAtEnd, class BoundAtEnd>
void integrate(Piece& piece, const Shape& shape, double most, const Rules& rules, const Take& take, const Note& note, const Kernel& kernel,
               const Bound& bound, const KernelAtEnd& kernel_at_end, const BoundAtEnd& bound_at_end)
{
    const Graded g = graded(piece.a, piece.b, shape.ratio, piece.finest);
    const double length = 2 * approximate(g.reach), share_of_tolerance = piece.tolerance / static_cast<double>(2 * g.depth + 2);
    // the rule for a panel of half-length `half`, the kernel at most `here` on the ellipse; its error is noted
    const auto rule_for = [&](double half, double here, double rho) -> const Gauss& {
        const double needed = std::log(gauss_error(half, most * here, rho, 0) / share_of_tolerance) / (2 * std::log(rho));
        const long n = 2 * std::max(1L, static_cast<long>(std::ceil(needed / 2)));
        note(gauss_error(half, most * here, rho, n));
        return rules(n);
    };
    for (const bool left : {true, false}) {
        const double room = left ? piece.room_a : piece.room_b;
        const Ball& end = left ? piece.a : piece.b;
        const Ball inward = left ? Ball(1) : Ball(-1);
        Ball far = g.reach;
        bool reached = false;
        for (long k = 0; k < g.depth && !reached; ++k) {
            reached = approximate(far) * shape.beyond() * 1.01 < room;
            if (reached) {
                const double l = approximate(far), reach = l * (1 + shape.beyond());
                const double here = bound_at_end(left, reach, length - reach);
                const Gauss& rule = rule_for(std::sqrt(l), here, std::sqrt(shape.rho)); // of an even function, twice the integral
                const Ball half = sqrt(far);
                for (std::size_t q = 0; q < rule.root.size() / 2; ++q) { // the positive roots
                    const Ball v = half * rule.root[q], y = end + inward * v * v;
                    take(y, half * rule.weight[q] * kernel_at_end(left, y));
                }
                break;
            }
            const Ball near = g.reach * g.power(-k - 1), half = (far - near) / 2, at = (far + near) / 2;
            const double mid = approximate(at), radius = approximate(half) * shape.major();
            const double from_this = mid - radius, from_other = length - (mid + radius), b = approximate(piece.b);
            const double here = left ? bound(from_this, from_other, b - from_other) : bound(from_other, from_this, b - from_this);
            const Gauss& rule = rule_for(approximate(half), here, shape.rho);
            for (std::size_t q = 0; q < rule.root.size(); ++q) {
                const Ball y = end + inward * (at + half * rule.root[q]);
                take(y, half * rule.weight[q] * kernel(y));
            }
            far = near;
        }
        (left ? piece.from : piece.to) = reached ? end : end + inward * far;
    }
}

} // namespace touchstone::transfer::heavy_load
