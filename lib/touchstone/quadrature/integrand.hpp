// SPDX-License-Identifier: MIT
/// \file
/// A typed formula as an integrand: compiled for one interval, evaluated on endpoint numbers.
///
/// What is typed seldom says how it behaves at the ends: 1 - x, sin(pi x), log(x) or (1 - cos x)/x^2 vanish there, and in balls the
/// difference loses what matters. So the formula is compiled for its interval:
///
/// - a polynomial in x with exact coefficients is divided by its zeros at the ends, exactly: on [0, 1], 1 - x^2 becomes right (1 + x);
/// - any other sum or function whose exact expansion (exact_series.hpp) begins with s^m at an end, m > 0 or more than its terms show, is
/// s^m T with T
///   analytic on a disc |s| < R about the end: near the end T is its first exact coefficients and a Cauchy bound of the rest, sup|T|
///   (|s|/R)^n/(1 - |s|/R), farther away the quotient of balls;
/// - exp(k x + c) on a range where x is a logarithm is a power of the distances;
/// - asin, acos, acosh, atanh of what reaches +-1, at a finite end or far out, are written by roots and logarithms of 1 -+ it;
/// - abs, sign, max, min of what has no zero inside the range lose their branch.
///
/// Contract: at() on Ball and on ComplexBall encloses one and the same function, that of the text.
#pragma once

#include "touchstone/quadrature/exact_series.hpp"
#include "touchstone/quadrature/interval.hpp"

#include <array>

namespace touchstone::quadrature {

/// An end of the range: a constant formula, or -oo or oo.
struct Limit {
    int infinite = 0; ///< -1, 0, 1
    ExpressionPtr formula;
    std::optional<ExactSum> exact;
    std::string text;

    Ball ball() const; ///< at the working precision
    Endpoint endpoint() const;

private:
    mutable Ball kept_; ///< at the highest precision asked for so far: a limit belongs to one thread at a time
    mutable slong kept_bits_ = 0;
};

/// `1/3`, `pi/2`, `log(2)`, `inf`, `-inf`. \throws ExpressionError
Limit parse_limit(std::string_view text);
Limit limit_at(const ExactSum& value, std::string text);
/// As people would write it where that is short, else some digits of it.
std::string text_of(const ExactSum&);

/// Where x is what function of the fractions u and r: see interval.hpp.
enum class Map { finite, right_algebraic, right_exponential, left_algebraic, left_exponential, line_algebraic, line_exponential };

struct Range {
    Limit from, to;
    Map map = Map::finite;
    Interval interval() const;
};

/// \throws DomainError if the value is no number (log(-1))
Ball evaluate_at(const Expression&, const Ball& x);

namespace compiled {
struct Node;
}

/// A formula at points of the plane, no end in sight: non-finite unless analytic on the whole ball.
class PlainFormula {
public:
    explicit PlainFormula(const ExpressionPtr&);
    ComplexBall at(const ComplexBall& z) const;

private:
    std::shared_ptr<const compiled::Node> root_;
};

class RealFormula;

class Integrand {
public:
    Integrand(const ExpressionPtr&, Range);
    ~Integrand();
    Integrand(Integrand&&) noexcept;

    EndpointNumber<Ball> at(const EndpointNumber<Ball>& x, const EndpointNumber<Ball>& left, const EndpointNumber<Ball>& right) const;
    EndpointNumber<ComplexBall> at(const EndpointNumber<ComplexBall>& x, const EndpointNumber<ComplexBall>& left,
                                   const EndpointNumber<ComplexBall>& right) const;
    /// Of a complex formula, the two parts of its value at a node; on a piece f and f*, which bound them (tanh_sinh.md, section 13).
    template <class V>
    std::array<EndpointNumber<V>, 2> both_parts(const EndpointNumber<V>& x, const EndpointNumber<V>& left,
                                                const EndpointNumber<V>& right) const;
    /// On a ball of the plane that has points of the range in it: non-finite unless analytic on the whole ball. For finite ranges.
    ComplexBall in_plane(const ComplexBall& z) const;
    /// As it goes on from that end of the range, or the same from both: what sqrt(x^2) is left of 0 depends on the way there.
    ComplexBall in_plane_from(std::optional<Side> end, const ComplexBall& z) const;
    /// The values of a real formula on a ball of the finite range, in real arithmetic.
    Ball at_real(const Ball& x) const;
    /// The values on a real ball (z without imaginary part), across kinks and steps too.
    ComplexBall on_the_line(const ComplexBall& z) const;
    /// The formula as it stands, in balls; nothing if it has other than elementary functions, or is not real.
    const RealFormula* straight() const;
    /// Whether it is analytic and bounded on a neighbourhood of each end of the finite range.
    bool is_regular_at_ends() const;
    const Range& range() const;
    bool has_inner_integral() const;

private:
    ComplexBall about_an_end(const ComplexBall& z, bool on_the_line) const;
    struct Body;
    std::unique_ptr<Body> body_;
};

/// Points strictly inside the range where the formula has a branch of its own: zeros of what abs, sign, max, min are taken of, steps of
/// floor and ceil, as far as they can be named exactly. \throws DomainError where there are too many.
std::vector<ExactSum> branch_points(const Expression&, const Limit& from, const Limit& to);

} // namespace touchstone::quadrature
