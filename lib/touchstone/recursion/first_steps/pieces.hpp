// SPDX-License-Identifier: MIT
/// \file
/// Integrals between singular points that are known: their order, their exact distances, and pieces of the line seen from either end.
///
/// **Square roots at the ends.** Two rules that share nothing but the integrand. Either a piece [a, b] is cut in the middle; next to either
/// end the variable is the angle t, x = a + (b-a) sin^2 t, so that a root at an end is sin t, and acb_calc_integrate bisects towards
/// singular points near by. Or the piece is integrated as a whole by quadrature/half_powers.hpp: one Gauss-Legendre rule with an ellipse in
/// the angle, else tanh-sinh. Both are rigorous, and approach a near singular point at a cost of log(1/distance).
/// **Logarithms at the ends.** The trapezoidal rule in u, x = a + (b-a)/(1 + exp(-u)), of step h: |integral - rule| <= N/(exp(2 pi d/h) -
/// 1), N the integral of
/// |F| over both lines Im u = +-d, for F analytic between them (tanh_sinh.md, section 3). N is covered by complex balls where |Re u| < 14, and bounded by a power of
/// exp(-|u|) beyond. A singular point outside of the piece, however near, is at a distance gap + (b-a)/(1 + exp(-u)), of an argument <= d:
/// it costs nothing.
///
/// Integrands are made of distances from ends, each being that of the piece's end (a difference of ends, taken at 4096 bits more) plus a
/// positive term: an end may be as near to another as one likes.
///
/// Internal to recursion/first_steps/.
#pragma once

#include "touchstone/scalar/ball.hpp"
#include "touchstone/scalar/exact.hpp"

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
/// z^(1/2) and a/b from the least discs that hold z and b: narrower in wide balls. Indeterminate where they are not analytic.
ComplexBall root_on_disc(const ComplexBall& z);
ComplexBall quotient_on_disc(const ComplexBall& a, const ComplexBall& b);
/// The disc |z| <= radius, or what encloses it.
ComplexBall within(const Ball& radius);
inline bool right_half(const ComplexBall& z) { return certainly(less(Ball(0), z.real())); }
/// (2/pi) arctan(top/bottom) of two roots: of numbers with a positive real part.
ComplexBall two_angles(const ComplexBall& top, const ComplexBall& bottom, bool analytic);

/// What a sum of roots is not: nothing then, and the balls decide.
template <class F>
std::optional<Exact> exactly(F number)
{
    try {
        return number();
    }
    catch (const NotExact&) {
        return std::nullopt;
    }
}

/// An end: a ball at wide() precision, and the number itself if it is the root of a rational. Copies are known to be the same number.
class End {
public:
    End() = default;
    End(const Ball& b, std::optional<Exact> e) : exact(std::move(e)), ball_(std::make_shared<const Ball>(b)) {}
    static End rational(const Rational&);

    const Ball& at() const { return *ball_; }
    friend bool same(const End& a, const End& b) { return a.ball_ == b.ball_; }

    std::optional<Exact> exact;

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

/// What is integrated of [a, b]: the half next to an end, by acb_calc_integrate, or all of it, by Gauss-Legendre or tanh-sinh.
enum class Extent { left_half, right_half, whole };

/// [a, b], or a half of it seen from its end: the distances of a point from what is not inside.
class Piece {
public:
    Piece(const End& a, const End& b, Extent extent) : a_(a), b_(b), extent_(extent), width_(difference(a, b)) {}

    const Ball& width() const { return width_; }

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
        ComplexBall sine, cosine; ///< roots of
        ComplexBall left, right;  ///< the shares of the piece to the left and to the right
        bool analytic = false;
        ComplexBall distance(const Beyond&) const;
        ComplexBall root_of(const Beyond&) const;
        ComplexBall root_of(const ComplexBall& z) const { return root(z, analytic); }
        Extent extent() const { return piece->extent_; }
    };
    using Function = std::function<ComplexBall(const Point&)>;
    /// Its part of int f dx/(product of the roots of these). \throws BeyondReach if that is infinite, or nothing is proved
    Ball integral(const Function& f, const std::vector<Beyond>& roots) const;
    /// The whole of int f dx, f having a logarithm, or a pole of an order below 1, at either end: the trapezoidal rule in u, x = a +
    /// (b-a)/(1 + exp(-u)).
    /// \param rest a bound of int |f dx| over the x nearer to the left (right) end than this share t of the piece, also along Im u = const
    /// <= height if
    ///        t <= 1e-6; decreasing like an integrable power of t
    /// \param height of the strip of u to try first; \param goal bits, of the value
    using Rest = std::function<Ball(bool left, const Ball& t)>;
    Ball between_logarithms(const Function& f, const Rest& rest, double height, slong goal) const;

private:
    Ball by_half(const Function& f, const std::vector<Beyond>& roots) const;
    Ball as_a_whole(const Function& f, const std::vector<Beyond>& roots) const;
    ComplexBall along_exponentials(const Function& f, const ComplexBall& u, bool analytic) const;
    Ball over_core(const Function& f, double height) const;

    End a_, b_;
    Extent extent_;
    Ball width_;
};

/// Both halves of a piece, if there is one.
Ball over_halves(const End& a, const End& b, const std::function<Ball(const Piece&)>& half);
/// All of a piece, if there is one.
Ball over_whole(const End& a, const End& b, const std::function<Ball(const Piece&)>& whole);

} // namespace touchstone::transfer::first_steps
