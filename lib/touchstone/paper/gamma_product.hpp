// SPDX-License-Identifier: MIT
/// \file
/// A product of Gamma functions whose arguments lie beside one half-integer, all at once: what they share is computed once.
#pragma once

#include "touchstone/scalar/ball.hpp"

#include <vector>

namespace touchstone::archard {

/// prod_t Gamma(halves/2 - 2^-t)^weights[t - first] over t = first, first + 1, ..., to about the working precision;
/// halves >= 2, first >= 1.
/// Route: with the shift N, z = halves/2 + N and x = 2^-t, Gamma(halves/2 - x) = Gamma(z - x)/prod_{j=1}^N (z - j - x), whose factors
/// are integers over 2^t, and Stirling's series for the weighted sum of log Gamma(z - x), in which only the powers of 1/(z - x)
/// differ from t to t: each is the one before divided by words. For real z - x > 0 what is left out is below the first term
/// left out (NIST Handbook of Mathematical Functions, section 5.11(ii)).
/// Cost at 1000 digits: that of three calls of arb_gamma, and of a third of one for each t; the Bernoulli numbers are Arb's.
Ball gamma_product(long halves, long first, const std::vector<unsigned long>& weights);

/// What Stirling's series of log Gamma(y) lacks after L terms is, for every y >= z - 1/2 > 0, z = twice_z/2, at most the first term
/// left out, 4 (2L)!/((2 pi)^(2L+2) y^(2L+1)) by |B_2l|/(2l)! = 2 zeta(2l)/(2 pi)^2l < 4/(2 pi)^2l.
Ball stirling_remainder(long L, long twice_z);

} // namespace touchstone::archard
