// SPDX-License-Identifier: MIT
/// \file
/// The ratio y that a wave meets as a function of t = sin(theta/2), and what of the wave lies where (three_waves.hpp).
///
/// Internal to transfer/.
#pragma once

#include "touchstone/transfer/wide_balls.hpp"

#include <algorithm>
#include <cmath>

namespace touchstone::transfer {

/// One half of a wave, or the whole of it in partial contact, as a function of t.
class Arc {
public:
    using Real = DoubleDouble<double>;
    enum class Kind { from_top, from_bottom, partial };
    Arc(Kind kind, const Ball& G, const Ball& x) : kind_(kind), G_(G), x_(x), g_(double(to_real(G))) {}

    /// y at t, at the thread's precision.
    Ball ratio(const Ball& t) const
    {
        if (kind_ == Kind::from_top) return (x_ + 1 - 2 * t * t) / G_;
        if (kind_ == Kind::from_bottom) return (x_ - 1 + 2 * t * t) / G_;
        return 2 * sqrt((1 - t * t) * (x_ - t * t)) / G_;
    }
    /// What y moves by at most where t moves by r, any complex way; infinite where y need not be analytic there.
    double moved(const Real& t, double r) const
    {
        const double square = r * (2 * double(t) + r) * bounds::margin; // of t^2
        if (kind_ != Kind::partial) return bounds::margin * 2 * square / g_;
        const double to_one = double((1 - t) * (1 + t)), q = to_one * to_end(t);
        const double off = square * (to_one + to_end(t) + square); // of q = (1 - t^2)(x - t^2)
        // |(q + z)^(1/2) - q^(1/2)| <= |z|/((1 + 0.7) q^(1/2))
        return off < 0.5 * q ? bounds::margin * 2 * off / (1.7 * g_ * std::sqrt(q)) : bounds::infinite;
    }
    /// At least dtheta/(pi dt) on the disc.
    static double weight_near(const Real& t, double r)
    {
        const double to_one = double(1 - t);
        if (!(r < 0.5 * to_one)) return bounds::infinite;
        return bounds::margin * 2 / (bounds::pi_below * std::sqrt((to_one - r) * (1 + double(t) - r)));
    }
    static Real weight(const Real& t) { return 2 * inverse_pi / sqrt((1 - t) * (1 + t)); }
    /// A share s(l) of theta that sets of length l of y between a and b have at most, s(l)/l^(1/2) not decreasing, at l = all of it:
    /// (2) of proven_levels.md, twice for two ends, or the largest dtheta/(pi dy).
    double share(const Real& a, const Real& b, double length) const
    {
        const double any = std::sqrt(g_ * length), to_one = double((1 - b) * (1 + b)), per_length = g_ / (bounds::pi_below * double(a));
        double density = bounds::infinite;
        if (a > 0 && kind_ != Kind::partial) density = per_length / (2 * std::sqrt(to_one)); // b^2 is about 1/2 at most
        if (a > 0 && kind_ == Kind::partial) density = per_length * std::sqrt(to_end(a)) / (to_one + to_end(b));
        return bounds::margin * std::min(any, density * length);
    }

private:
    /// x - t^2
    double to_end(const Real& t) const
    {
        const Ball b = to_ball(t);
        return std::max(0.0, double(to_real(x_ - b * b)));
    }
    Kind kind_;
    Ball G_, x_;
    double g_;
};

} // namespace touchstone::transfer
