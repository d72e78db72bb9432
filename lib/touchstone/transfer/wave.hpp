// SPDX-License-Identifier: MIT
/// \file
/// What one wave does to a region of load ratio x, in full and in partial contact, for fast arithmetic without bounds.
///
/// With theta uniform on [0, pi] the next load ratio is y = (x + cos theta)/G for x >= 1; for x < 1 it is
/// y = sqrt(R^2 - (1-x)^2)/G with R = x + cos theta where R > 1 - x, and contact is lost elsewhere. So y has the density
///
///     x >= 1:  1/(pi sqrt((hi - y)(y - lo))),                                    lo, hi = (x -+ 1)/G             (W1)
///     x < 1:   (G y/(pi R)) sqrt((1+x+R)/((1-x+R)(hi - y)(hi + y))),  R^2 = (1-x)^2 + G^2 y^2, 0 < y < hi = (2/G) sqrt x    (W2)
///
/// and both ends lose their square roots in y = hi - 2 r sin^2(angle/2), r = (hi - lo)/2 or hi. Every formula takes
/// distances from the ends: those are had to full relative accuracy though hi and lo are rounded, because the
/// rounding errors of hi and lo are kept with them.
#pragma once

#include "touchstone/scalar/ball.hpp"

#include <cmath>
#include <limits>
#include <numbers>
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
class Wave {
public:
    Wave(const Real& x, const Pair<Real>& G) : Wave(Pair<Real>{x, Real(0)}, G) {}
    Wave(const Pair<Real>& x, const Pair<Real>& G) : x_(x.high), G_(G.high), full_(x.high > 1 || (x.high == 1 && x.low >= 0))
    {
        using std::sqrt, std::fma;
        const auto over_G = [&](const Real& p, const Real& p_low) { // (p + p_low)/G
            const Real q = p / G.high;
            return Pair<Real>{q, (fma(-q, G.high, p) - q * G.low + p_low) / G.high};
        };
        const auto sum = [&](const Real& b) { // x + b, |b| = 1
            const Real s = x.high + b, t = s - x.high;
            return Pair<Real>{s, (x.high - (s - t)) + (b - t) + x.low};
        };
        if (full_) {
            const auto up = sum(Real(1)), down = sum(Real(-1));
            hi_ = over_G(up.high, up.low);
            lo_ = over_G(down.high, down.low);
            radius_ = 1 / G_;
        }
        else {
            const Real s = sqrt(x.high), s_low = (fma(-s, s, x.high) + x.low) / (2 * s);
            hi_ = over_G(2 * s, 2 * s_low);
            radius_ = hi_.high;
            one_minus_x_ = (1 - x.high) - x.low;
        }
    }

    bool full() const { return full_; }
    const Real& hi() const { return hi_.high; }
    const Real& lo() const { return lo_.high; }
    Real below_hi(const Real& y) const { return (hi_.high - y) + hi_.low; }
    Real above_lo(const Real& y) const { return (y - lo_.high) - lo_.low; }
    const Real& radius() const { return radius_; }

    /// (W1), (W2), y given with its distances from the ends.
    Real density(const Real& y, const Real& to_hi, const Real& to_lo) const
    {
        using std::sqrt;
        if (full_) return inverse_pi() / sqrt(to_hi * to_lo);
        const Real gy = G_ * y, R = sqrt(one_minus_x_ * one_minus_x_ + gy * gy);
        return inverse_pi() * gy / R * sqrt((1 + x_ + R) / ((one_minus_x_ + R) * to_hi * (hi_.high + y)));
    }
    /// Density of the angle at y, where y = hi - 2 r sin^2(angle/2).
    Real angular_density(const Real& y) const
    {
        using std::sqrt;
        if (full_) return inverse_pi();
        const Real gy = G_ * y, R = sqrt(one_minus_x_ * one_minus_x_ + gy * gy);
        return inverse_pi() * gy / R * sqrt((1 + x_ + R) / (one_minus_x_ + R));
    }
    /// Distance from [a, b] to the nearest singular point of the density: hi, lo, and the zeros of R, y = +-i(1-x)/G.
    Real clearance(const Real& a, const Real& b) const
    {
        const Real up = below_hi(b);
        const Real down = full_ ? above_lo(a) : (a > lost() ? a : lost());
        return up < down ? up : down;
    }
    /// (1 - x)/G in partial contact: how far the zeros of R are from y = 0.
    Real lost() const { return one_minus_x_ / G_; }

private:
    static const Real& inverse_pi()
    {
        static const Real value = [] {
            using std::atan;
            return 1 / (4 * atan(Real(1)));
        }();
        return value;
    }

    Real x_, G_, one_minus_x_{}, radius_;
    bool full_;
    Pair<Real> hi_, lo_{};
};

} // namespace touchstone::transfer
