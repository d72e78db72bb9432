// SPDX-License-Identifier: MIT
/// \file
/// Polynomials for moments as functions of their order a, with what they are off by (docs/limit.md, theorem 3). Internal to
/// area_series.cpp.
#pragma once

#include "touchstone/scalar/ball.hpp"

#include <cmath>
#include <vector>

namespace touchstone::limit {

constexpr double to_pole = 2.5; ///< what is proven of the moments is proven where Re a >= -to_pole; their pole is at -3

using Balls = std::vector<Ball>;

inline Ball within(Ball value, const Ball& error)
{
    arb_add_error(value.get(), error.get());
    return value;
}

/// Interpolation in the n + 1 Chebyshev points of -1 <= a <= top, for functions that are analytic where Re a >= -to_pole.
class MomentInterpolation {
public:
    MomentInterpolation(int top, double digits)
        : centre_(Rational(top - 1, 2))
        , half_(Rational(top + 1, 2))
    {
        const double half = (top + 1) / 2.0, semi_major = 1 + (to_pole - 1) / half;
        const double rho = semi_major + std::sqrt(semi_major * semi_major - 1);
        rho_ = Ball::exactly(rho * (1 - 1e-9)); // the ellipse ends before -to_pole
        height_ = half_ * (rho_ - 1 / rho_) / 2;
        n_ = static_cast<int>(std::ceil(digits * std::log(10.0) / std::log(rho))) + 1;
        for (int i = 0; i < 2 * n_; ++i) cosines_.push_back(ScalarTraits<Ball>::cos_pi(Ball(i) / Ball(n_)));
    }
    int points() const { return n_ + 1; }
    Ball point(int i) const { return centre_ - half_ * ScalarTraits<Ball>::cos_pi(Ball(i) / Ball(n_)); } ///< the first is -1
    const Ball& height() const { return height_; }                                                       ///< |Im a| on the ellipse

    /// A function by its coefficients, sum c_k T_k, and how far off that is for an error of the values. Radii are kept out of the sums:
    /// what an interpolant does to them is Lebesgue's constant, 1 + (2/pi) log n at most, not n.
    struct Series {
        Balls c;
        Ball error;
    };
    Series series(const Balls& values) const
    {
        Balls mid;
        Ball off(0);
        for (const Ball& v : values) {
            mid.emplace_back();
            arb_get_mid_arb(mid.back().get(), v.get());
            off = at_least(off, Ball::exactly(v.radius_bound()));
        }
        Series s{{}, off * (1 + log(Ball(n_)))};
        for (int k = 0; k <= n_; ++k) {
            Ball sum(0);
            for (int i = 0; i <= n_; ++i) { // T_k at point(i) is cos(k (pi - pi i/n))
                const Ball term = mid[static_cast<std::size_t>(i)] * cosines_[static_cast<std::size_t>(k * (n_ - i) % (2 * n_))];
                sum += i == 0 || i == n_ ? term / 2 : term;
            }
            s.c.push_back((k == 0 || k == n_ ? sum : 2 * sum) / n_);
        }
        return s;
    }
    /// T_0 ... T_n at a. In balls the recurrence would lose a bit and more a step. An error d of one step counts for d U_k-j later, at most
    /// d k, so that all of them come to d k^2/2; an error of a to that times |T_k'| <= k^2.
    Balls polynomials(const Ball& a) const
    {
        const Ball t = (a - centre_) / half_;
        Ball mid;
        arb_get_mid_arb(mid.get(), t.get());
        mid = at_least(at_most(mid, Ball(1)), Ball(-1)); // t is in [-1, 1]: this comes no further from it
        const Ball step = Ball::exactly(t.radius_bound()) + ScalarTraits<Ball>::power_of_two(3 - WorkingPrecision::bits());
        Balls T{Ball(1), mid};
        while (static_cast<int>(T.size()) <= n_) {
            T.push_back(2 * mid * T[T.size() - 1] - T[T.size() - 2]);
            arb_get_mid_arb(T.back().get(), T.back().get());
        }
        for (std::size_t k = 1; k < T.size(); ++k) T[k] = within(T[k], Ball(static_cast<long>(k * k)) * step);
        return T;
    }
    /// Of a function bounded by 1 on the ellipse: 4 rho^-n/(rho - 1), for its coefficients are at most 2 rho^-k and each beyond n is met
    /// twice.
    Ball error() const { return 4 / (pow(rho_, Ball(n_)) * (rho_ - 1)); }

private:
    Ball centre_, half_, rho_, height_;
    int n_ = 0;
    Balls cosines_;
};

} // namespace touchstone::limit
