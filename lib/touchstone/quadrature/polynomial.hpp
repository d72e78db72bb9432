// SPDX-License-Identifier: MIT
/// \file
/// Polynomials in x with exact coefficients.
#pragma once

#include "touchstone/quadrature/exact_sum.hpp"
#include "touchstone/quadrature/expression.hpp"

#include <optional>
#include <vector>

namespace touchstone::quadrature {

/// c_0 + c_1 x + ...; no trailing zeros, so zero has no coefficients.
using Polynomial = std::vector<ExactSum>;

/// The formula as a polynomial, if it is one (degree at most 32).
std::optional<Polynomial> polynomial(const Expression&);
ExactSum value(const Polynomial&, const ExactSum& x);
/// p/(x - root) for a root of p.
Polynomial without_root(const Polynomial& p, const ExactSum& root);

} // namespace touchstone::quadrature
