// SPDX-License-Identifier: MIT
/// \file
/// Integrands that behave at both ends like half-integer powers of the distance times a power series in its square root:
/// roots of a zero at an end, the weights of Chebyshev, the densities of a contact.
///
/// With u = sin^2(a), r = cos^2(a), 0 < a < pi/2, each half-integer power of u or r is an integer power of sin a or cos a, and
///
///     f dx = f (dx/du) 2 sin(a) cos(a) da
///
/// is analytic about both ends. So Gauss-Legendre quadrature in a, with its bounds on an ellipse, takes a fifth of the values that
/// tanh-sinh takes. Where f dx/da is an even function of a about both ends, f dx/du = c(u)/sqrt(u r) with c analytic, the trapezoidal rule
/// in a, which is that of Gauss and Chebyshev in u, takes about half of these (product_rule.hpp). Contract and arguments of f as in
/// tanh_sinh.hpp; tanh_sinh.md, sections 19 and 20.
#pragma once

#include "touchstone/quadrature/tanh_sinh.hpp"

#include <optional>

namespace touchstone::quadrature {

namespace detail {
/// Whether the integrand is analytic in the angle about both ends.
bool is_analytic_in_the_angle(const PanelIntegrand&);

/// Nothing if the integrand is not of that kind, or takes more evaluations than tanh-sinh would.
struct HalfPowers : Enclosure {
    long evaluations = 0; ///< at nodes and for the proof
    std::string rule, proof; ///< one line each for a person
};
std::optional<HalfPowers> integrate_half_powers(const PanelIntegrand& whole, const Interval&, const Options&);
} // namespace detail

/// The integral of f, by Gauss-Chebyshev or by Gauss-Legendre in the angle if one of them takes it, else by tanh-sinh.
template <class F>
Enclosure proven_integral(F f, Interval interval, const Options& options = {})
{
    const auto shared = std::make_shared<Interval>(interval);
    if (auto e = detail::integrate_half_powers(detail::panel_integrand(f, shared, 0, 1), *shared, options)) return std::move(*e);
    return tanh_sinh(std::move(f), std::move(interval), options);
}

} // namespace touchstone::quadrature
