// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Integrals of printed formulas, with a proof: the formula is handed over as text, as a user of `touchstone integrate` would type it.
#pragma once

#include "proofs/enclosure/enclosure.hpp"

namespace touchstone::proofs {

/// Encloses the integral of `integrand` over `variable`; the other symbols take their values from the point.
/// Indeterminate where nothing is proved, a divergent integral among them.
Ball integral(const ex& integrand, const ex& variable, const ex& from, const ex& to, const Point&);

} // namespace touchstone::proofs
