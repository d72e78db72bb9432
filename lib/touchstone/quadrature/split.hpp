// SPDX-License-Identifier: MIT
/// \file
/// Real and imaginary part of a formula in a real variable, as formulas (internal to quadrature/).
#pragma once

#include "touchstone/quadrature/expression.hpp"

#include <optional>
#include <utility>

namespace touchstone::quadrature {

/// u and v of e = u + iv, null where zero: for sums, products, quotients, whole powers and exp, sin, cos, sinh, cosh of such.
std::optional<std::pair<ExpressionPtr, ExpressionPtr>> real_and_imaginary(const ExpressionPtr& e);

} // namespace touchstone::quadrature
