// SPDX-License-Identifier: MIT
/// \file
/// Formulas as mathematics, in which nothing is rounded: for papers (LaTeX), for tools that search for accurate forms (FPCore) and for
/// algebra (SymPy).
#pragma once

#include "touchstone/formula/formulas.hpp"

namespace touchstone::formula {

/// \param language latex, fpcore or sympy
/// A formula that would be long if each part stood wherever it is used gives its repeated parts names, so that the text grows with the
/// number of operations: x_30 of (5.6) would have 3^30 parts. LaTeX then is an aligned list, FPCore has let*, SymPy a list of parts as
/// sympy.cse returns it.
std::string mathematics(const Formula&, std::string_view language);

} // namespace touchstone::formula
