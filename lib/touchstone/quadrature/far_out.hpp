// SPDX-License-Identifier: MIT
/// \file
/// Formulas written anew so that what they do far out on a half-line shows (tanh_sinh.md, sections 21 and 22). Internal to quadrature/.
#pragma once

#include "touchstone/quadrature/expression.hpp"

namespace touchstone::quadrature {

/// v, if e is written 1 + v, a quotient of polynomials, or a hyperbolic tangent or cotangent: tanh y = 1 - 2/(exp(2y) + 1). Nothing else.
ExpressionPtr less_one(const ExpressionPtr& e);

/// The product with exp(-y) besseli(n, y), exp(y) besselk(nu, y), exp(y^2) erfc(y) as one function each: apart one of the two grows without
/// end where x does, and the other falls. Nothing if there is none.
ExpressionPtr with_scaled_functions(const ExpressionPtr& e);

} // namespace touchstone::quadrature
