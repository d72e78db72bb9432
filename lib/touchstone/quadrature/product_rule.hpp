// SPDX-License-Identifier: MIT
/// \file
/// Product integration: integrands that are powers and logarithms of the distances to the ends times functions that are analytic about
/// both,
///
///     f dx/du = u^p r^q sum of c_ij (log u)^i (log r)^j,
///
/// such as sqrt(x) log(x)/(1 + x^2), sin(x)^0.4, log(sin(x)). The singular factors are integrated exactly, the c_ij by their values at the
/// nodes of Gauss and Legendre with a bound from an ellipse (ellipse_rule.hpp): a third of the values that tanh-sinh takes and a small part
/// of its proof. Contract and arguments of f as in tanh_sinh.hpp; tanh_sinh.md, section 20.
#pragma once

#include "touchstone/quadrature/tanh_sinh.hpp"

#include <optional>

namespace touchstone::quadrature::detail {

/// Nothing if the integrand is not of that kind, or takes more evaluations than tanh-sinh would.
struct ProductIntegral {
    Ball value;
    long evaluations = 0; ///< at nodes and for the proof
    std::string proof;    ///< one line for a person
};
std::optional<ProductIntegral> integrate_by_product_rule(const MakePanel&, const Options&);

/// Of f dx/du = (u r)^(-1/2) c alone, c analytic about both ends: half-integer powers of either distance and no other root of it, as in
/// sqrt((1 - x)/x), 1/sqrt(1 - x^2), the pressure of Hertz. The nodes of Gauss and Chebyshev are no more than cosines and bring twice as
/// many digits each.
std::optional<ProductIntegral> integrate_by_chebyshev(const PanelIntegrand&, const Options&);

} // namespace touchstone::quadrature::detail
