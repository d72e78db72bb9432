// SPDX-License-Identifier: MIT
/// \file
/// Tails that oscillate: the integral of f from X to oo where f is a sum of g(x) cos(w x + p), g sin, g J_n(w x), g Y_n(w x), g alone, and
/// g tends to 0 only as a power.
///
/// The path is turned by a right angle. On Q = {Re z >= X, Im z >= 0} let g be analytic with g(z) -> 0 uniformly as |z| -> oo; then
///
///     integral_X^oo g(x) exp(i w x) dx = integral from X to X + i oo of g(z) exp(i w z) dz,     w > 0,
///
/// and what lies beyond X + iS is at most sup_Q |g| exp(-w S)/w (tanh_sinh.md, section 9, proves this and the bounds for J and Y). Both
/// premises and the supremum are proved on one enclosure of Q; the rest is Arb's acb_calc_integrate on a finite path, where the integrand
/// falls like exp(-w s) instead of oscillating.
#pragma once

#include "touchstone/quadrature/integrand.hpp"
#include "touchstone/quadrature/polynomial.hpp"

namespace touchstone::quadrature {

/// One term: the amplitude times cos(phase + frequency x), sin(...), or J_order(frequency x), Y_order; Op::number is the amplitude alone.
struct Wave {
    ExpressionPtr amplitude;
    Op kernel = Op::number;
    ExactSum phase, frequency;
    ExpressionPtr order;
};

/// The formula as a sum of them (products of sines are multiplied out); nothing if it is none, or has no term that oscillates.
std::optional<std::vector<Wave>> waves(const ExpressionPtr&);

/// sup |f| in the quadrant of the term without its exp(i w z), and whether the term tends to 0 there; nothing if that is not proved.
std::optional<Ball> supremum_in_quadrant(const Wave&, long base, long distance);

struct Tail {
    Ball value;
    long evaluations = 0;
};

/// The integral of the term from base + distance to oo, `supremum` being that of the quadrant there; nothing if it is not proved.
std::optional<Tail> tail(const Wave&, long base, long distance, const Ball& supremum, long digits);

} // namespace touchstone::quadrature
