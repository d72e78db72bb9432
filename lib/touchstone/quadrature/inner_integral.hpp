// SPDX-License-Identifier: MIT
/// \file
/// An integral inside a formula, F(x) = integral of f(x, y) over y, as a function of a ball of x (internal to quadrature/).
///
/// At a ball X of x the inner integral is computed with X for a constant: the proofs of tanh_sinh.hpp and acb_calc_integrate then hold for
/// every x in X at once, with one integrable bound. So F is analytic inside X and its values there are in the result (tanh_sinh.md,
/// section 15, lemma "inner integral").
#pragma once

#include "touchstone/quadrature/integrand.hpp"

namespace touchstone::quadrature {

bool is_infinite_end(const Expression&);

namespace compiled {

struct InnerIntegral {
    ExpressionPtr integrand;         ///< in its own variable and Op::outer
    std::optional<Limit> fixed[2];   ///< ends that don't depend on x
    bool depends_on_outer = true;    ///< the integrand itself does
};

std::shared_ptr<const InnerIntegral> inner_integral(const Expression&);

/// At x; `from` and `to` are the values of the ends, nothing where infinite. Indeterminate unless it is proved.
template <class V>
V value_of_inner(const InnerIntegral&, const V& x, const std::optional<V>& from, const std::optional<V>& to, bool conjugated);

} // namespace compiled
} // namespace touchstone::quadrature
