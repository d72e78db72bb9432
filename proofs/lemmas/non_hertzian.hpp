// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// How many contacts are outside the Hertzian range (2.8), certified at a scale.
#pragma once

#include "touchstone/scalar/ball.hpp"

namespace touchstone::proofs {

/// The share, by number, of the contacts of scale n + 1 with p_n/p*_{n+1} >= 0.2 at D = 1.5, load < 1, n odd: Q_n(0.2 p*_{n+1})/A_n.
Ball share_outside_hertz(long n, const Rational& load, long gamma);

} // namespace touchstone::proofs
