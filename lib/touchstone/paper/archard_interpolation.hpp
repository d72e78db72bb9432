// SPDX-License-Identifier: MIT
/// \file
/// K_n of (7.13) and K_inf of (7.20) by interpolation between the first of them.
///
/// K_n is a function kappa of u = 2^-n: with F(x) = 2^(1-2x) Gamma(3/2 - x)/(sqrt(pi) Gamma(2 - x)), the factor of (7.13) at delta = 1 -
/// 2x,
///     kappa(u) = K_inf prod_{j>=0} 1/F(2^-(j+2) u),
/// analytic for |u| < 8, as 1/F is for |x| < 2 and F(0) = 1. So a polynomial through K_0, ..., K_M, at u = 1, 1/2, ..., 2^-M, is at u = 0,
/// and at all later K_n, off by less than 2^-(M^2/2): with some sqrt(2 bits) Gamma functions, and nothing else, there is K_inf.
#pragma once

#include "touchstone/paper/archard_constants.hpp"

namespace touchstone::archard {

/// K_n (n >= 0, or `infinity`) to about the working precision.
/// Route: K_0, ..., K_M with one Gamma function each, at 1 - 2^-(i+2), by (7.13) and the duplication formula; K_n itself for n <= M, else
/// K_polynomial and interpolation_error. To 1000 digits these Gamma functions are sums of numbers in a table (reciprocal_gamma_below_one)
/// and all of them take a fraction of what K_gamma_product does; beyond, they are dearer.
Ball K_interpolated(long n);

/// The polynomial in u of degree M through K_0, ..., K_M, at u = 2^-n, n > M >= 1, or at u = 0 (`infinity`), to about the working
/// precision: the sizes of its weights add up to less than 9.
Ball K_polynomial(long M, long n);

/// K_n differs from K_polynomial(M, n) by less than 2^ of this, M >= 1.
slong interpolation_error(long M);

} // namespace touchstone::archard
