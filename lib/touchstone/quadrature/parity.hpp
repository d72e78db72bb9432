// SPDX-License-Identifier: MIT
/// \file
/// Whether a formula is even or odd about a point, as far as its parts show (internal to quadrature/).
#pragma once

#include "touchstone/quadrature/exact_sum.hpp"
#include "touchstone/quadrature/expression.hpp"

namespace touchstone::quadrature {

enum class Parity { unknown, even, odd };

/// f(c - t) = f(c + t), or f(c - t) = -f(c + t), c the centre, at every real t at which the formula has a value; unknown where the parts do
/// not show it. By induction: a function of even arguments is even, and so on; sin and cos of an odd number and multiples of pi/2 are even
/// or odd. Nothing is said of where f is analytic: sqrt(x^2) is even.
Parity parity(const Expression&, const ExactSum& centre = 0);

} // namespace touchstone::quadrature
