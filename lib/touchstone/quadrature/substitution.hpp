// SPDX-License-Identifier: MIT
/// \file
/// Formulas after a change of variable, exact: the new formula is again one in x.
#pragma once

#include "touchstone/quadrature/exact_sum.hpp"
#include "touchstone/quadrature/expression.hpp"

#include <optional>

namespace touchstone::quadrature {

/// The constant as a formula.
ExpressionPtr formula_of(const ExactSum&);

/// The formula with another in place of x.
ExpressionPtr substituted(const ExpressionPtr&, const ExpressionPtr& x);

/// f(centre + direction x).
ExpressionPtr shifted(const ExpressionPtr&, const ExactSum& centre, int direction);

/// f(end + direction/x)/x^2: what is integrated over [1/L, oo) in place of f over the part of length L beside the end. Quotients of
/// quotients are cleared, so exp(-1/x)/x^2 about 0 becomes exp(-x).
ExpressionPtr about_infinity(const ExpressionPtr&, const ExactSum& end, int direction);

/// The m != 1 for which x stands in the arguments of exponentials, sines, cosines and Bessel functions as x^m and in no other way, if there
/// is one: with t = x^m they are exponentials and waves of t.
std::optional<Rational> power_in_arguments(const Expression&);

/// f(t^(1/m)) t^(1/m - 1)/m, in x for t: what is integrated over [a^m, oo) in place of f over [a, oo), a >= 0. Powers of x become powers of
/// t.
ExpressionPtr in_power(const ExpressionPtr&, const Rational& m);

} // namespace touchstone::quadrature
