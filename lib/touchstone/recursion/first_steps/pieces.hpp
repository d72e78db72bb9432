// SPDX-License-Identifier: MIT
/// \file
/// Integrals between singular points that are known: their order, their exact distances, and pieces of the line seen from either end.
///
/// A piece [a, b] is cut in the middle. Next to either end the variable is the angle t, x = a + (b-a) sin^2 t, so that a square root at an end is
/// sin t; or, where the end has a logarithm, v in [0, oo), x = a + ((b-a)/2) exp(-v), cut off where a bound of the rest is small enough. Integrands
/// are made of distances from ends, each being that of the piece's end (a difference of ends, taken at 4096 bits more) plus a positive term: an end may
/// be as near to another as one likes. Integrals by acb_calc_integrate, rigorous, whose bisections approach a near singular point at a cost of
/// log(1/distance).
///
/// Internal to recursion/first_steps/.
#pragma once

#include "touchstone/scalar/ball.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace touchstone::transfer::first_steps {

/// More bits than the thread's, for ends and their differences.
WorkingPrecision wide();
/// At the thread's precision.
Ball narrow(const Ball&);
/// z^(1/2), indeterminate where `analytic` and z meets the cut.
ComplexBall root(const ComplexBall& z, bool analytic);
/// (2/pi) arctan(top/bottom) of two roots: of numbers with a positive real part.
ComplexBall two_angles(const ComplexBall& top, const ComplexBall& bottom, bool analytic);

/// An end: a ball at wide() precision, and the number itself if it is rational. Copies are known to be the same number.
class End {
public:
    End() = default;
    End(const Ball& b, std::optional<Rational> e) : exact(std::move(e)), ball_(std::make_shared<const Ball>(b)) {}
    static End rational(const Rational&);

    const Ball& at() const { return *ball_; }
    friend bool same(const End& a, const End& b) { return a.ball_ == b.ball_; }

    std::optional<Rational> exact;

private:
    std::shared_ptr<const Ball> ball_;
};

/// -1, 0, 1. \throws BeyondReach if the two can't be told from one another
int order(const End& a, const End& b);
inline bool below(const End& a, const End& b) { return order(a, b) < 0; }
inline const End& larger(const End& a, const End& b) { return below(a, b) ? b : a; }
inline const End& lesser(const End& a, const End& b) { return below(b, a) ? b : a; }
/// b - a >= 0; exactly 0 if they are one
Ball difference(const End& a, const End& b);

/// A half of [a, b], seen from one of its ends: the distances of a point from what is not inside.
class Piece {
public:
    Piece(const End& a, const End& b, bool from_left) : a_(a), b_(b), from_left_(from_left), width_(difference(a, b)) {}

    const Ball& width() const { return width_; }
    bool from_left() const { return from_left_; }

    /// A point s <= a or s >= b of the line, and the distance of x from it.
    struct Beyond {
        Ball gap; ///< from the piece; 0: it is the piece's end
        bool left;
        bool zero() const { return arb_is_zero(gap.get()); }
    };
    Beyond left(const End& s) const { return {difference(s, a_), true}; }
    Beyond right(const End& s) const { return {difference(b_, s), false}; }

    struct Point {
        const Piece* piece = nullptr;
        ComplexBall sine, cosine; ///< roots of the shares of the piece to the left and to the right
        bool analytic = false;
        ComplexBall distance(const Beyond&) const;
        ComplexBall root_of(const Beyond&) const;
        ComplexBall root_of(const ComplexBall& z) const { return root(z, analytic); }
        bool near_left() const { return piece->from_left_; }
    };
    using Function = std::function<ComplexBall(const Point&)>;
    /// Its half of int f dx/(product of the roots of these). \throws BeyondReach if that is infinite
    Ball integral(const Function& f, const std::vector<Beyond>& roots) const;
    /// Its half of int f dx, f having a logarithm, or a pole of order 1/4 or 1/2, at the near end.
    /// \param rest a bound of |int f dx| over the points nearer to that end than `distance`
    Ball integral_to_logarithm(const Function& f, const std::function<Ball(const Ball& distance)>& rest) const;

private:
    End a_, b_;
    bool from_left_;
    Ball width_;
};

/// Both halves of a piece, if there is one.
Ball over(const End& a, const End& b, const std::function<Ball(const Piece&)>& half);

} // namespace touchstone::transfer::first_steps
