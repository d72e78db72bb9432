// SPDX-License-Identifier: MIT
/// \file
/// Why a formula is not analytic where it is to be integrated: the commonest reason (internal to quadrature/).
#pragma once

#include "touchstone/quadrature/integrand.hpp"

#include <optional>
#include <string>

namespace touchstone::quadrature {

/// What function of the formula takes an argument on its branch cut at a point inside the range, or what is divided by 0 all along it, in a
/// few words: a hint beside a refusal, and no proof. Looked for at a few points. Of formulas without inner integrals.
std::optional<std::string> argument_on_cut(const ExpressionPtr&, const Limit& from, const Limit& to);

} // namespace touchstone::quadrature
