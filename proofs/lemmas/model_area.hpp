// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The area (6.7) of the model at given scales, certified, for the cases of figure 3: D = 1.5 and 1.05, gamma = 5 and 10.
#pragma once

#include "proofs/ledger.hpp"

#include "touchstone/scalar/ball.hpp"

#include <vector>

namespace touchstone::proofs {

/// The loads at which these figures are looked at: 10^-3, 10^-2, 10^-1, 1.
const std::vector<Rational>& loads_tried();

/// A_n/lambda_0 of (6.7) at D = 1.5, load <= 1, through the library's transfer operator (touchstone/transfer/contact.hpp).
Ball model_area(long n, const Rational& load, long gamma);
/// (7.18), corrected, at the same parameters.
Ball hertz_area(long n, const Rational& load, long gamma);

/// The curves of figure 5a: q_n p_n^max/A_n at p = share p_n^max, 0 < share < 1, D = 1.5, gamma = 10, load < 1; about nine digits
/// (touchstone/recursion/from_the_edge/forward.hpp).
Ball normalised_density(long n, const Rational& load, const Rational& share);
/// The area under such a curve from the levels' own polynomials, n >= 1.
Ball under_normalised_density(long n, const Rational& load);

/// The area at D = 1.05, figures 3a and 3b, where part of the contact is full: 1 <= n <= 20, load <= 10, within 3e-6
/// (1.5e-8 at load 0.001), through touchstone/transfer/proven_levels.hpp.
Ball model_area_low_D(long n, const Rational& load, long gamma);
Ball hertz_area_low_D(long n, const Rational& load, long gamma);
Ball ratios_to_hertz_low_D(long first, long last, long gamma, const std::vector<Rational>& loads);
/// -log(A_{n+1}/A_n)/log G there, n >= 0.
Ball local_slope_low_D(long n, const Rational& load, long gamma);

/// The hull of A_n/(7.18), over the loads and the scales from first to last.
Ball ratios_to_hertz(long first, long last, long gamma, const std::vector<Rational>& loads = loads_tried());

/// -log(A_{n+1}/A_n)/log G at the loads tried: 1 in the limit. The hull.
Ball local_slopes(long n, long gamma);
/// The same at one load.
Ball local_slope(long n, const Rational& load, long gamma);

} // namespace touchstone::proofs
