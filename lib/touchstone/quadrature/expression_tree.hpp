// SPDX-License-Identifier: MIT
/// \file
/// What is done to the tree of a formula after it was read, and how one is made of others. Internal to quadrature/.
#pragma once

#include "touchstone/quadrature/expression.hpp"

namespace touchstone::quadrature {

/// Names become parameters, the variable of the integral they stand in, or an error that names the column.
ExpressionPtr with_names_bound(const ExpressionPtr&, const Parameters&);

/// The same formula, equal parts of it one and the same node.
ExpressionPtr with_shared_parts(const ExpressionPtr&);

/// The tree with every node replaced for which `leaf` gives another, inside inner integrals too.
ExpressionPtr rebuilt(const ExpressionPtr&, const std::function<ExpressionPtr(const ExpressionPtr&)>& leaf);

/// Formulas of formulas, as they stand.
namespace tree {
inline ExpressionPtr number(long n) { return make_number(Rational(n)); }
inline ExpressionPtr sum(const ExpressionPtr& a, const ExpressionPtr& b) { return make(Op::add, {a, b}); }
inline ExpressionPtr difference(const ExpressionPtr& a, const ExpressionPtr& b) { return make(Op::add, {a, make(Op::negate, {b})}); }
inline ExpressionPtr product(const ExpressionPtr& a, const ExpressionPtr& b) { return make(Op::multiply, {a, b}); }
inline ExpressionPtr quotient(const ExpressionPtr& a, const ExpressionPtr& b) { return make(Op::divide, {a, b}); }
inline ExpressionPtr of(Op op, const ExpressionPtr& a) { return make(op, {a}); }

/// The summands of a sum, of its sums, of what a minus stands before; of anything else itself.
std::vector<ExpressionPtr> summands(const ExpressionPtr&);
ExpressionPtr sum_of(const std::vector<ExpressionPtr>&);
/// A sum with the numbers among its summands added up, so that 1 - (1 - g) is g, whose zero shows; itself if there are no two.
ExpressionPtr with_numbers_collected(const ExpressionPtr&);
} // namespace tree

} // namespace touchstone::quadrature
