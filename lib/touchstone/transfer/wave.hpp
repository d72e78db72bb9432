// SPDX-License-Identifier: MIT
/// \file
/// What one wave does to load ratios, in full and in partial contact, forwards and backwards; fast, without bounds.
///
/// With theta uniform on [0, pi] and c = cos theta a region of load ratio x gets y = (x + c)/G if x >= 1; if x < 1, y = sqrt(R^2 -
/// (1-x)^2)/G with R = x + c where R > 1 - x, and contact is lost elsewhere. So y has the density
///
///     x >= 1:  1/(pi sqrt((hi - y)(y - lo))),                                    lo, hi = (x -+ 1)/G             (W1)
///     x < 1:   (G y/(pi R)) sqrt((1+x+R)/((1-x+R)(hi - y)(hi + y))),  R^2 = (1-x)^2 + G^2 y^2, 0 < y < hi = (2/G) sqrt x    (W2)
///
/// The share of the wave with pressure above P = G y, F(x; P) = (1/pi) arccos(P - x) or (1/pi) arccos(R - x), R^2 = (1-x)^2 + P^2, rises
/// with x from 0 to 1: it is the distribution function of the ratio x(theta; P) that the wave needs at theta to get to P,
/// x = P - c if c <= P - 1, else (1 + P^2 - c^2)/(2(1 + c)). Its density, for exceedances one level further, is
///
///     x >= 1:  1/(pi sqrt((hi - x)(x - lo))),                              lo, hi = P -+ 1                       (W3)
///     x < 1:   sqrt((1+R-x)(1+R+x)/(x - lo))/(2 pi R),                     lo = P^2/4 < x                        (W4)
///
/// and where x moves with P, the derivative of an exceedance with respect to P, it has the weight 1 or P/(1+R-x).
///
/// The ends lose their square roots in the angle: y = hi - 2 r sin^2(angle/2) and so on for (W1) to (W3), x = lo + angle^2 for (W4).
/// Every formula takes distances from the ends. They are had to full relative accuracy though hi and lo are
/// rounded, because the rounding errors of hi and lo are kept with them.
#pragma once

#include "touchstone/scalar/ball.hpp"
#include "touchstone/wave/wave.hpp"

#include <cmath>
#include <limits>
#include <type_traits>

#include <boost/multiprecision/cpp_bin_float.hpp>

namespace touchstone::transfer {

/// Arithmetic of the estimated routes: 64 bits or more. (x86: long double; where that is `double`: in software, slow.)
using Extended = std::conditional_t<(std::numeric_limits<long double>::digits >= 64), long double,
                                    boost::multiprecision::cpp_bin_float_quad>;

/// An unevaluated sum: a number to twice the digits.
template <class Real>
struct Pair {
    Real high{}, low{};
};

/// The midpoint of a ball.
Pair<Extended> extended_pair(const Ball&);
/// The same number as a ball of radius zero.
Ball exact_ball(const Extended&);

template <class Real>
Pair<Real> sum(const Pair<Real>& a, const Real& b)
{
    const Real s = a.high + b, t = s - a.high;
    return {s, (a.high - (s - t)) + (b - t) + a.low};
}
template <class Real>
Pair<Real> product(const Pair<Real>& a, const Pair<Real>& b)
{
    using std::fma;
    const Real p = a.high * b.high;
    return {p, fma(a.high, b.high, -p) + a.high * b.low + a.low * b.high};
}
template <class Real>
Pair<Real> quotient(const Pair<Real>& a, const Pair<Real>& b)
{
    using std::fma;
    const Real q = a.high / b.high;
    return {q, (fma(-q, b.high, a.high) - q * b.low + a.low) / b.high};
}

/// One of the densities (W1) to (W4) on a stretch of the line.
template <class Real>
class Arc {
public:
    enum class Kind { full, partial, needed_full, needed_partial };

    /// How close to [a, b] the density has a singular point: an end or a zero of R.
    Real clearance(const Real& a, const Real& b) const
    {
        using std::abs;
        const auto least = [](const Real& p, const Real& q) { return p < q ? p : q; };
        switch (kind) {
        case Kind::partial: return least(below_hi(b), a > knot ? a : knot);
        case Kind::needed_partial: return least(above_lo(a), 1 - b > knot ? Real(1 - b) : knot);
        default: return least(below_hi(b), above_lo(a));
        }
    }
    bool meets(const Real& a, const Real& b) const { return b > begin && a < end && below_hi(a) > 0 && above_lo(b) > 0; }
    Real below_hi(const Real& y) const { return (hi.high - y) + hi.low; }
    Real above_lo(const Real& y) const { return (y - lo.high) - lo.low; }

    /// The density at y, given with its distances from the ends and from 1.
    Real density(const Real& y, const Real& to_hi, const Real& to_lo, const Real& to_one) const
    {
        using std::sqrt;
        switch (kind) {
        case Kind::partial: {
            const Real gy = G * y, R = wave::radius<Real>(one_minus_x, gy * gy);
            return inverse_pi() * wave::kernel_partial<Real>(x, one_minus_x, R, gy, to_hi, hi.high + y);
        }
        case Kind::needed_partial: {
            const Real R = wave::radius<Real>(to_one, P * P);
            return (moves ? wave::needed_slope_partial<Real>(P, to_one, R) : Real(1)) * inverse_pi() *
                   wave::needed_kernel_partial_rest<Real>(y, to_one, R) / sqrt(to_lo);
        }
        default: return inverse_pi() * wave::kernel_full<Real>(to_hi, to_lo);
        }
    }
    /// Density of the angle.
    Real angular_density(const Real& y, const Real& to_one) const
    {
        switch (kind) {
        case Kind::partial: {
            const Real gy = G * y;
            return inverse_pi() * wave::kernel_partial_rest<Real>(x, one_minus_x, wave::radius<Real>(one_minus_x, gy * gy), gy);
        }
        case Kind::needed_partial: {
            const Real R = wave::radius<Real>(to_one, P * P);
            return (moves ? wave::needed_slope_partial<Real>(P, to_one, R) : Real(1)) * inverse_pi() * 2 *
                   wave::needed_kernel_partial_rest<Real>(y, to_one, R);
        }
        default: return inverse_pi();
        }
    }
    Real angle(const Real& distance) const
    {
        using std::asin, std::sqrt;
        if (distance <= 0) return Real(0);
        return kind == Kind::needed_partial ? Real(sqrt(distance)) : Real(2 * asin(sqrt(distance / (2 * radius))));
    }
    Real distance(const Real& angle) const
    {
        using std::sin;
        if (kind == Kind::needed_partial) return angle * angle;
        const Real s = sin(angle / 2);
        return 2 * radius * s * s;
    }
    /// The stretches of [a, b] to integrate over the angle: visit(from lo?, first, last), distances from that end; and,
    /// next to the zeros of R at 1 +- iP, plain(first, last): 1 - x.
    template <class Visit, class Plain>
    void stretches(const Real& a, const Real& b, const Visit& visit, const Plain& plain) const
    {
        const Real up_a = below_hi(a), up_b = below_hi(b), down_a = above_lo(a), down_b = above_lo(b);
        switch (kind) {
        case Kind::partial: { // halved towards the zeros of R, y = +-i knot
            Real from = b;
            for (Real to = b / 2; to > a && to > knot && from - to > knot; to /= 2) {
                if (below_hi(to) > 0) visit(false, below_hi(from), below_hi(to));
                from = to;
            }
            if (below_hi(a) > 0) visit(false, below_hi(from), up_a < radius ? up_a : radius);
            break;
        }
        case Kind::needed_partial: {
            const Real middle = (1 + (lo.high > a ? lo.high : a)) / 2;
            if (b < 1 || knot >= 1 - middle) {
                visit(true, down_a, down_b);
                break;
            }
            visit(true, down_a, above_lo(middle));
            Real from = 1 - middle;
            for (; from > knot; from /= 2) plain(from / 2, from);
            plain(Real(0), from);
            break;
        }
        default:
            if (up_b < radius) visit(false, up_b, up_a < radius ? up_a : radius);
            if (down_a < radius) visit(true, down_a, down_b < radius ? down_b : radius);
        }
    }

    Kind kind = Kind::full;
    Pair<Real> hi{}, lo{};
    Real begin{}, end{}; ///< where it applies, as far as hi and lo do not say so; ends of the grid's intervals
    Real radius{}, knot{};
    Real x{}, one_minus_x{}, G{}, P{};
    bool moves = false;

private:
    static const Real& inverse_pi()
    {
        static const Real value = [] {
            using std::atan;
            return 1 / (4 * atan(Real(1)));
        }();
        return value;
    }
};

/// One or two arcs.
template <class Real>
struct Wave {
    Arc<Real> arcs[2];
    int count = 1;
};

/// The next ratio after x: (W1) or (W2).
template <class Real>
Wave<Real> wave_from(const Pair<Real>& x, const Pair<Real>& G)
{
    using std::sqrt, std::fma;
    Wave<Real> wave;
    Arc<Real>& arc = wave.arcs[0];
    arc.G = G.high;
    if (x.high > 1 || (x.high == 1 && x.low >= 0)) {
        arc.kind = Arc<Real>::Kind::full;
        arc.hi = quotient(sum(x, Real(1)), G);
        arc.lo = quotient(sum(x, Real(-1)), G);
        arc.radius = 1 / G.high;
    }
    else {
        arc.kind = Arc<Real>::Kind::partial;
        const Real s = sqrt(x.high);
        arc.hi = quotient({2 * s, (fma(-s, s, x.high) + x.low) / s}, G);
        arc.lo = {Real(0), Real(0)};
        arc.radius = arc.hi.high;
        arc.x = x.high;
        arc.one_minus_x = (1 - x.high) - x.low;
        arc.knot = arc.one_minus_x / G.high;
    }
    arc.end = 2 * arc.hi.high;
    return wave;
}

/// The ratio needed to get above pressure P, in units of p* of that wave: (W3), (W4).
/// \param moves weigh with dx/dP
template <class Real>
Wave<Real> wave_to(Pair<Real> P, bool moves)
{
    using std::ldexp;
    if (P.high <= 0)
        P = {ldexp(Real(1), std::numeric_limits<Real>::min_exponent / 5),
             Real(0)}; // P = 0 has 1/sqrt(1 - x) at x = 1, which no angle removes; sqrt(P) is what is left
    Wave<Real> wave;
    Arc<Real>& arc = wave.arcs[0];
    arc.kind = Arc<Real>::Kind::needed_full;
    arc.hi = sum(P, Real(1));
    arc.lo = sum(P, Real(-1));
    arc.radius = 1;
    arc.begin = P.high < 2 ? Real(1) : Real(0);
    arc.end = 2 * arc.hi.high;
    if (P.high >= 2) return wave;
    wave.count = 2;
    Arc<Real>& below = wave.arcs[1];
    below.kind = Arc<Real>::Kind::needed_partial;
    below.P = P.high;
    below.moves = moves;
    below.lo = product(P, P);
    below.lo = {below.lo.high / 4, below.lo.low / 4};
    below.hi = {Real(2), Real(0)}; // no end of the density there
    below.begin = 0;
    below.end = 1;
    below.knot = P.high;
    return wave;
}

} // namespace touchstone::transfer
