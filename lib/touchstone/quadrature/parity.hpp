// SPDX-License-Identifier: MIT
/// \file
/// Whether a formula is even or odd in x, as far as its parts show (internal to quadrature/).
#pragma once

#include "touchstone/quadrature/expression.hpp"

namespace touchstone::quadrature {

enum class Parity { unknown, even, odd };

/// f(-x) = f(x), or f(-x) = -f(x), at every real x at which the formula has a value; unknown where the parts do not show it.
/// By induction: a function of even arguments is even, and so on. Nothing is said of where f is analytic: sqrt(x^2) is even.
Parity parity(const Expression&);

} // namespace touchstone::quadrature
