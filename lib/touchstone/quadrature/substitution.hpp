// SPDX-License-Identifier: MIT
/// \file
/// Formulas after a change of variable, exact: the new formula is again one in x.
#pragma once

#include "touchstone/quadrature/exact_sum.hpp"
#include "touchstone/quadrature/expression.hpp"

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

} // namespace touchstone::quadrature
