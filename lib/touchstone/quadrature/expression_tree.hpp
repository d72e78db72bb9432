// SPDX-License-Identifier: MIT
/// \file
/// What is done to the tree of a formula after it was read. Internal to quadrature/.
#pragma once

#include "touchstone/quadrature/expression.hpp"

namespace touchstone::quadrature {

/// Names become parameters, the variable of the integral they stand in, or an error that names the column.
ExpressionPtr with_names_bound(const ExpressionPtr&, const Parameters&);

/// The same formula, equal parts of it one and the same node.
ExpressionPtr with_shared_parts(const ExpressionPtr&);

/// The tree with every node replaced for which `leaf` gives another, inside inner integrals too.
ExpressionPtr rebuilt(const ExpressionPtr&, const std::function<ExpressionPtr(const ExpressionPtr&)>& leaf);

} // namespace touchstone::quadrature
