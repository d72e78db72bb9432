// SPDX-License-Identifier: MIT
/// \file
/// How the contact area after two waves grows with the ratio y that the first of the two meets: B_1'(y), B_1 = T(T 1), so A_1 = lambda_0
/// B_1(load). It is a complete integral with branch points known in y, and needs no quadrature.
///
/// **y > 1.** With c the cosine of the wave's angle, z = (y + c)/G and d/dz (6.6) = 1/(pi (z(1-z))^(1/2)),
///
///     B_1'(y) = (1/pi^2) int dc/((1-c^2)(y+c)(G-y-c))^(1/2)  over -1 < c < min(1, G - y)
///             = 1/(pi agm(((G+1-y)(1+y))^(1/2), ((G-1-y)(y-1))^(1/2)))   1 < y < G - 1
///             = 1/(pi agm((2G)^(1/2), ((y-G+1)(y-1))^(1/2)))             G - 1 < y < G + 1,   0 beyond:
///
/// a complete elliptic integral of the first kind, between the two middle ones of four real branch points.
///
/// **y < 1.** With 1 - y + R = (1-y) 2/(1-r^2), that is z = 2 (1-y) r/(G (1-r^2)), in the integral of (W4) of transfer/wave.hpp over d/dz
/// (6.6),
///
///     B_1'(y) = (2^(1/2)/pi^2) int_0^r1 dr/(r (y - r^2)(G(1-r^2) - 2(1-y)r))^(1/2),   r1 = min(y^(1/2), r+).
///
/// r- < -y^(1/2) < 0 < r1 < r2 < oo are the branch points, r+ r- = -1, {r1, r2} = {y^(1/2), r+}: a complete integral on a curve of genus 2,
/// which Richelot's isogeny takes to branch points that approach each other in pairs quadratically:
///
///     int_b^b' dx/|P Q R|^(1/2) = 2 |Delta|^(1/2) int_b1^b1' dx/|U V W|^(1/2),   U = Q'R - Q R' and cyclically, Delta = det(P, Q, R),
///
/// P, Q, R having the roots a < a' < b < b' < c < c', of which UVW has two in each of (a, a'), (b, b'), (c, c') (Bost & Mestre, Moyenne
/// arithmetico-geometrique et periodes des courbes de genre 1 et 2, Gaz. Math. 38 (1988) 36-64). When b and b' are near, the rest is
/// bounded as it stands: the integral is pi times a mean of the other factors over [b, b']. Only distances occur, and sums of them.
///
/// B_1' has logarithms at y = 1, G^2/4 (if below 1) and G - 1 (if above), and goes with y^(-1/4) at 0.
/// Domain: G > 1, 0 < y < G + 1. Errors: enclosures; in complex balls indeterminate where it is not analytic. Cost: six square roots a
/// step, 5 to 8 steps.
///
/// Internal to recursion/first_steps/.
#pragma once

#include "touchstone/scalar/ball.hpp"

namespace touchstone::transfer::first_steps {

class AreaSlope {
public:
    explicit AreaSlope(const Ball& G) : G_(G) {}

    /// y < 1 on one side of G^2/4; distances, with a positive real part
    struct Partial {
        ComplexBall y, to_one, to_crossing; ///< y, 1 - y, |y - G^2/4|
        bool below_crossing;                ///< y < G^2/4
    };
    /// 1 < y < G + 1 on one side of G - 1
    struct Full {
        ComplexBall from_one, to_turn, to_end; ///< y - 1, |y - (G - 1)|, G + 1 - y
        bool below_turn;                       ///< y < G - 1
    };
    /// \param analytic asks for an indeterminate result unless B_1' is analytic on the ball
    ComplexBall at(const Partial&, bool analytic) const;
    ComplexBall at(const Full&, bool analytic) const;

    /// B_1' <= this y^(-3/8) ((1-y) |y - G^2/4|)^(-1/4), y < 1
    Ball partial_bound() const;
    /// B_1' <= this ((y-1) |y - (G-1)|)^(-1/4), y > 1
    Ball full_bound() const;

private:
    Ball G_;
};

} // namespace touchstone::transfer::first_steps
