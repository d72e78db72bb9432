// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The limit of K_n (7.20) and the Beta integral of (7.13), in balls.
#pragma once

#include "proofs/ledger.hpp"

#include "touchstone/scalar/ball.hpp"

namespace touchstone::proofs {

/// K_{n+1}/K_n = step(delta_n) with delta_n = 1 - h, h = 2^-(n+1). On 0 <= h <= 1/2 the derivative of
/// log step is enclosed and positive, and log step(1) = 0: so every step is below 1, K_n decreases, and
/// the sum of the |log step| is at most that enclosure times the geometric sum of the h: K_n converges
/// to a positive limit.
Check K_converges();

/// The derivative of log step on [1/2, 1] exceeds a number everywhere.
Check least_step_slope_exceeds(const Ball& number);

/// Encloses K_inf: K_N by (7.13), the tail by the derivative of log step on the last range of h.
Ball K_infinity();

/// Encloses the derivative of log step at delta in the given ball.
Ball log_step_slope(const Ball& delta);

/// The integral of `integrand` (in xi, delta_n) from `from` to `to` against the closed form, both in
/// balls at delta = 1/2, 3/4, 7/8, 1: the library's certified quadrature of the formula as printed.
Check beta_integral(const ex& integrand, const ex& from, const ex& to, const ex& closed);

} // namespace touchstone::proofs
