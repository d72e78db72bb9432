// SPDX-License-Identifier: MIT
/// \file
/// The nodes an integrand is compiled to, and their evaluation (internal; see integrand.hpp).
#pragma once

#include "touchstone/quadrature/integrand.hpp"
#include "touchstone/quadrature/polynomial.hpp"

#include <array>

namespace touchstone::quadrature::compiled {

enum class Kind {
    constant,
    variable,
    factored,
    add,
    multiply,
    divide,
    power,
    ball_power,
    general_power,
    function,
    ordered_function,
    exponential,
    logarithm_of_fraction,
    logarithm_near_one,
    ball,
    real_part,
    imaginary_part,
    conjugate,
    inner_integral
};

struct InnerIntegral;

/// s^order T at one end, s the distance to it.
struct Zero {
    long order = 0;
    std::vector<ExactSum> c; ///< first coefficients of T
    Ball radius;             ///< exact: T is analytic for |s| <= radius
    Ball bound;              ///< of |T| there
};

struct Node;
using NodePtr = std::shared_ptr<Node>;

/// The value at the point that was looked at last.
template <class V>
struct Last {
    unsigned long point = 0;
    bool conjugated = false, mirrored = false, on_the_line = false;
    EndpointNumber<V> value;
};

struct Node {
    Kind kind = Kind::constant;
    Op op = Op::number;
    std::vector<NodePtr> args;
    std::optional<ExactSum> exact; // constant
    ExpressionPtr source;          // ball
    std::shared_ptr<const InnerIntegral> inner;
    Exponent exponent;             // power; exponential: the k of exp(k x) exp(...)
    std::array<long, 2> order{};   // factored: exact multiplicities at the two ends; logarithm_of_fraction: the end whose distance it is of
    Polynomial rest;               // factored: what remains; logarithm_of_fraction: 1 over the range's length
    std::array<std::optional<Zero>, 2> zero;

    /// A constant, a coefficient: computed once at the highest precision asked for so far. So a compiled formula belongs to one thread at a
    /// time.
    struct Kept {
        ComplexBall value;
        slong bits = 0;
    };
    mutable std::vector<Kept> kept;

    bool is_shared = false; ///< stands at several places of the formula: its last value is kept
    mutable Last<Ball> last_real;
    mutable Last<ComplexBall> last_complex;
};

/// Another one each time, on each thread.
inline unsigned long next_point()
{
    thread_local unsigned long last = 0;
    return ++last;
}

/// x, the distances, and exp(x) where the map makes it a power of them.
template <class V>
struct Point {
    EndpointNumber<V> x, left, right;
    std::optional<EndpointNumber<V>> exp_x;
    unsigned long id = next_point();
    const EndpointNumber<V>& distance(Side s) const { return s == Side::left ? left : right; }
};

/// What evaluation needs to know of the range.
struct Place {
    const Range* range = nullptr;
    /// Whether the point is on the real line and an enclosure of the values there is wanted, analytic or not: kinks and steps are taken.
    bool on_the_line = false;
    /// Whether i stands for -i, and whether points of an outer variable stand for their conjugates.
    bool conjugated = false, mirrored = false;
    template <class V>
    std::optional<EndpointNumber<V>> exp_x(const EndpointNumber<V>& left, const EndpointNumber<V>& right) const;
};

template <class V>
EndpointNumber<V> evaluate(const Node&, const Point<V>&, const Place&);

/// At a node, the real and the imaginary part of the value; on a piece of the strip f and its mirror image, which bound both.
std::array<EndpointNumber<Ball>, 2> both_parts(const Node&, const Point<Ball>&, const Place&);
std::array<EndpointNumber<ComplexBall>, 2> both_parts(const Node&, const Point<ComplexBall>&, const Place&);

/// The disc about one end, where only that end's distance keeps its powers.
template <class V>
class Disc : public Frame<V> {
public:
    Disc(Side side, V s)
        : side_(side)
        , s_(std::move(s))
    {
    }
    V distance(Side s) const override { return s == side_ ? s_ : V::indeterminate(); }
    V logarithm(Side) const override { return V::indeterminate(); }
    Side side() const { return side_; }

private:
    Side side_;
    V s_;
};

/// The point at that distance from the end; `disc` must outlive it.
template <class V>
Point<V> point_about(const Disc<V>& disc, const Place& place);

NodePtr compile(const ExpressionPtr&, const Place&);

/// \throws ExpressionError unless its arguments (all but the last, if `all_but_last`) are real.
void require_real_arguments(const Expression&, bool all_but_last = false);

} // namespace touchstone::quadrature::compiled
