// SPDX-License-Identifier: MIT
/// \file
/// The quadrant in which a path is turned, as one piece on which an integrand is enclosed. Internal to quadrature/.
#pragma once

#include "touchstone/quadrature/endpoint_number.hpp"
#include "touchstone/quadrature/widen.hpp"

namespace touchstone::quadrature {

/// z in {Re (z - base) >= distance, Im z >= 0}, r = 1/(1 + z - base): r lies in the lower half of the disc that has [0, 1/(1 + distance)]
/// for a diameter, its principal logarithm between -i pi/2 and 0. Here rho = -log|r| >= log(1 + distance).
class Quadrant : public Frame<ComplexBall> {
public:
    explicit Quadrant(long distance)
        : largest_(Ball(1) / Ball(1 + distance))
        , least_rho_(log(Ball(1 + distance)))
        , r_(hull(Ball(0), largest_), hull(-largest_ / Ball(2), Ball(0)))
    {
    }
    ComplexBall distance(Side s) const override { return s == Side::right ? r_ : ComplexBall(1) - r_; }
    ComplexBall logarithm(Side s) const override
    {
        return s == Side::right ? ComplexBall::indeterminate() : analytic::log(ComplexBall(1) - r_);
    }
    bool reaches(Side s) const override { return s == Side::right; }
    ComplexBall vanishing(Side s, const Ball& e, const Exponent& k) const override
    {
        if (s != Side::right) return ComplexBall::indeterminate();
        return disc_of_powers(e, k);
    }
    ComplexBall logarithm_over_rho(Side s) const override
    {
        if (s != Side::right) return ComplexBall::indeterminate();
        return {Ball(-1), hull(-pi<Ball>() / Ball(2) / least_rho_, Ball(0))};
    }

private:
    /// |r^e rho^k| = exp(-e rho) rho^k has its supremum at the least rho or at k/e.
    ComplexBall disc_of_powers(const Ball& e, const Exponent& k) const
    {
        const Ball exponent = k.ball();
        const auto size = [&](const Ball& rho) { return exp(exponent * log(rho) - e * rho); };
        if (arb_is_zero(e.get())) return Exponent(0) < k ? ComplexBall::indeterminate() : ComplexBall(hull(Ball(0), size(least_rho_)));
        if (!arb_is_positive(e.get())) return ComplexBall::indeterminate();
        return disc(Exponent(0) < k ? size(at_least(exponent / e, least_rho_)) : size(least_rho_));
    }
    Ball largest_, least_rho_;
    ComplexBall r_;
};

} // namespace touchstone::quadrature
