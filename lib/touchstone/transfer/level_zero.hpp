// SPDX-License-Identifier: MIT
/// \file
/// B_0: the share of one wave in contact, or under a pressure above P; or the density after two waves. proven_levels.md, 3 and 5. Internal
/// to transfer/.
#pragma once

#include "touchstone/transfer/two_waves.hpp"
#include "touchstone/transfer/wide_balls.hpp"

#include <memory>
#include <utility>
#include <vector>

namespace touchstone::transfer::levels {

using Real = DoubleDouble<double>; // values and positions; bounds of errors are `double`

struct First {
    virtual ~First() = default;
    virtual bool is_area() const { return false; }
    /// Whether B_0, and B_m with it, increases from 0 to 1 and is at most x^(1/2). Else it need not be bounded.
    virtual bool is_share() const { return true; }
    /// B_0(x) and a bound of the error.
    virtual std::pair<Real, double> value(const Real& x) const = 0;
    struct Bounds {
        double value, complement; ///< of |B_0| and |1 - B_0|
    };
    /// On the disc of radius r about a real x, of the function that is B_0 on low <= x <= high; infinite if it may not be analytic there.
    virtual Bounds on_disc(const Real& low, const Real& high, const Real& x, double r) const = 0;
    /// What |B_0| + largest counts for on an interval of that width from x on, singular points and all (two_waves.hpp). Only if it is no
    /// share.
    virtual double weight_on(double, double, double) const { return bounds::infinite; }
};

std::unique_ptr<const First> in_contact();
/// The share above a pressure in p*_n.
std::unique_ptr<const First> exceeding(const Ball& pressure);

/// Of the force x of one wave, what is carried at pressures above that, in p*_n: it increases with x, and is at most x.
std::unique_ptr<const First> force_above(const Ball& pressure);
/// Where exceeding() and force_above() begin, and where they reach everything: they have square roots there.
std::pair<Ball, Ball> ends_of_exceeding(const Ball& pressure);
/// Where D_1 has logarithms or jumps, apart from the images of 1: at the images of those ends.
std::vector<Ball> singular_points_of_density(const Ball& G, const Ball& pressure);

/// D_1/unit: D_1 goes with P where P is small.
struct Density : First {
    Density(const Ball& G, const Ball& pressure, double unit, double tolerance);
    bool is_share() const override { return false; }
    std::pair<Real, double> value(const Real& x) const override;
    Bounds on_disc(const Real& low, const Real& high, const Real& x, double r) const override;
    double weight_on(double x, double width, double largest) const override;
    TwoWaves waves;
    double unit; ///< a power of two
};

} // namespace touchstone::transfer::levels
