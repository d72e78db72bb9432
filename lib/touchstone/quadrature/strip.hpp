// SPDX-License-Identifier: MIT
/// \file
/// Enclosures of the map on pieces of the strip |Im t| < d < pi/2.
///
/// With w = pi sinh t (tanh-sinh), or w = t (logistic), u = 1/(1 + exp(-w)) is the fraction of the interval to its left end and
/// r = 1 - u = 1/(1 + exp(w)) to its right one. sinh maps the strip onto the plane slit along
/// i[1, oo) and -i[1, oo), so exp(w) = -1 has no solution there: u and r are analytic and
/// never zero, and log u, log r are analytic on the whole strip.
///
/// For Re t >= 0, |E| <= 1 with E = exp(-w), so log(1 + E) is the principal one and
/// log u = -log(1 + E), log r = -w - log(1 + E). The left half follows from
/// u(-t) = r(t), u(conj t) = conj u(t).
///
/// The logistic map takes the strip to a domain that winds around neither end: |arg u|, |arg r| stay below d and a little. On a half-line,
/// x = u/r = exp(t), it is the sector |arg x| < d.
#pragma once

#include "touchstone/quadrature/endpoint_number.hpp"

namespace touchstone::quadrature {

/// What w is of t.
enum class Transformation { tanh_sinh, logistic };

/// A finite piece {x1 <= |Re t| <= x2, y1 <= Im t <= y2} on one side, or, with x2 infinite, the
/// half-infinite piece {|Re t| >= x1, 0 <= Im t <= y2}. Corners are exact binary64 numbers.
class StripPiece : public Frame<ComplexBall> {
public:
    /// A copy: of the pieces enclosed before some are kept, until there are too many.
    static StripPiece at(Side side, double x1, double x2, double y1, double y2, Transformation = Transformation::tanh_sinh);
    /// One piece for everything: no enclosure at all, yet a formula that depends on u and r
    /// through powers alone is finite on it.
    static const StripPiece& everywhere();

    ComplexBall distance(Side s) const override { return s == side_ ? near_ : far_; }
    ComplexBall logarithm(Side s) const override { return s == side_ ? log_near_ : log_far_; }
    bool reaches(Side s) const override { return endless_ && s == side_; }
    bool is_on_the_half_away_from(Side s) const override { return s != side_; }
    ComplexBall vanishing(Side s, const Ball& e, const Exponent& k) const override;
    ComplexBall logarithm_over_rho(Side s) const override;
    std::optional<Ball> turn(Side s) const override;

    /// For an endless piece: A, the least value of rho = |Re w|: pi sinh(x1) cos(y2), or x1.
    const Ball& depth() const { return depth_; }
    /// Upper bound of |dw/dt| on a finite piece: of pi |cosh t|, or 1.
    const Ball& stretch() const { return stretch_; }
    double x1() const { return x1_; }
    double x2() const { return x2_; }

private:
    StripPiece() = default;
    static StripPiece finite(Side, double x1, double x2, double y1, double y2, Transformation);
    static StripPiece endless(Side, double x1, double y2, Transformation);

    Side side_ = Side::right;
    bool endless_ = false;
    double x1_ = 0, x2_ = 0;
    ComplexBall near_, far_, log_near_, log_far_;
    Ball depth_, stretch_, slope_;
    std::optional<Ball> turn_;
};

/// Precision at which pieces are enclosed and integrands are bounded.
inline constexpr slong strip_bits = 53;

} // namespace touchstone::quadrature
