// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The model of section 6 in the limit of large n, certified: docs/limit.md.
#pragma once

#include "touchstone/scalar/ball.hpp"

namespace touchstone::proofs {

/// C(G)/(K_inf G) at D = 1.5: by what (7.21), (8.3) and (8.6) are to be multiplied.
Ball limiting_ratio(long gamma);
/// The share, by number, of the contacts with p_{n-1}/p*_n >= 0.2 at D = 1.5.
Ball limiting_share_outside_hertz(long gamma);
/// The same at D = 1.05.
Ball limiting_share_outside_hertz_low_D(long gamma);
/// The share, by number, of the contacts that are full at D = 1.05.
Ball limiting_full_share(long gamma);
/// The curve that those of figure 5a tend to: q_n p_n^max/A_n at p = share p_n^max, 0 < share < 1, D = 1.5, gamma = 10.
Ball limiting_normalised_density(const Rational& share);

} // namespace touchstone::proofs
