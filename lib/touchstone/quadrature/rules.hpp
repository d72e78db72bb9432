// SPDX-License-Identifier: MIT
/// \file
/// The rules that integrate() chooses from, for one range of one formula or several (internal to quadrature/).
#pragma once

#include "touchstone/quadrature/integrate.hpp"

#include <memory>
#include <optional>
#include <vector>

namespace touchstone::quadrature {

/// What became of one part.
struct Attempt {
    Ball value = Ball::indeterminate(), imaginary;
    std::string reason;
    std::optional<double> at; ///< where the proof stopped, in x
    Part part;
};

/// Arb's adaptive Gauss-Legendre quadrature: each panel by a rule with a bound from an ellipse on which the formula is proved analytic.
/// Across `kinks` panels are halved down to the tolerance, where an enclosure of the values is enough.
std::optional<Attempt> by_gauss_legendre(const Integrand&, bool complex, long digits, bool kinks, bool quick);

/// One panel with one ellipse (ellipse_rule.hpp), of a real formula without kinks that is analytic about both ends. `even`: about the
/// middle of the range.
std::optional<Attempt> by_one_ellipse(const Integrand&, bool even, long digits, bool of_absolute);

/// half_powers.hpp, of a real formula without kinks on a finite range or an algebraic map.
std::optional<Attempt> by_half_powers(const std::shared_ptr<const Integrand>&, bool even, long digits, bool of_absolute);

/// Whether it is analytic in the angle about both ends, as every formula is that the rule above or the one below serves.
bool may_have_half_powers_alone(const std::shared_ptr<const Integrand>&);

/// The same, of an even formula whose range is on one side of 0: half of the integral over both sides. What is singular beyond 0, at the
/// distance of the other end, is then at an end.
std::optional<Attempt> by_half_powers_on_both_sides(const ExpressionPtr&, const Range&, long digits, bool of_absolute);

/// Whether the range is finite and the formula's parts show that it is even about the middle.
bool is_even_about_the_middle(const Expression&, const Range&);
/// Whether the range is finite and 0 is one of its ends.
bool begins_or_ends_at_zero(const Range&);

/// The formula as it stands, if it is even about 0 and analytic there, and 0 is an end of the range.
std::optional<PlainFormula> even_and_analytic_about_zero(const ExpressionPtr&, const Range&);

/// product_rule.hpp, of a real formula without kinks. `even_about_zero`: what the function above says of it.
std::optional<Attempt> by_product_rule(const std::shared_ptr<const Integrand>&, bool even,
                                       const std::optional<PlainFormula>& even_about_zero, long digits, bool of_absolute);

/// tanh_sinh.hpp; of a complex formula both parts, by one proof.
Attempt by_tanh_sinh(const std::shared_ptr<const Integrand>&, bool complex, long digits, const IntegralOptions&,
                     Transformation = Transformation::tanh_sinh);

/// Real formulas of one range by one proof and the same nodes; their values are non-finite if it fails.
std::vector<Attempt> by_one_tanh_sinh(const std::vector<std::shared_ptr<const Integrand>>&, long digits);

/// The maps for a range, the likely one first.
std::vector<Map> maps_for(const Limit& from, const Limit& to, bool exponential);

/// Whether a function that decays (or grows) exponentially is named: which map is tried first.
bool names_exponential(const Expression&);

/// Whether a function is named that may bring a logarithm of the distance to an end.
bool names_logarithm(const Expression&);

/// Whether the formula has branches that may lie where no exact number is.
bool has_kinks(const Expression&);

} // namespace touchstone::quadrature
