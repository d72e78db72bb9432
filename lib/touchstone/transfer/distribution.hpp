// SPDX-License-Identifier: MIT
/// \file
/// Distribution of the contact pressure at scale n = 1 by the forward recursion (6.1), certified. (n = 0 is section 2.)
///
/// Pressures in units of p*_0, so p*_k = G^k. Two routes that share no variable and no kernel formula:
///
/// **Pressures.** (6.1) as it stands, over p_0 = lo + (hi - lo) sin^2 theta, lo = p^2/(4G) and hi = p_0^max = 2 sqrt(load). Both ends of (2.19) are then taken by their distance: with A(x, P) = P/(pi R) sqrt((1+x+R)/(1-x+R)),
/// R^2 = (1-x)^2 + P^2, (2.19) is q p* = A/sqrt(4x - P^2), 4x - P^2 = (4/G)(hi - lo) sin^2 theta, and
///
///     q_1(p) = G^(-1/2) int_0^(pi/2) A(p_0/G, p/G) A(load, p_0) (hi + p_0)^(-1/2) dtheta.                        (D1)
///
/// **Force chain.** The density f_k of s = -log x_k, x_k = p_{k-1}/p*_k, per unit of force (chain.hpp), begins at s_k,
/// s_0 = -log load, s_{k+1} = log(G/2) + s_k/2. It is f_k = d^((k-2)/2) e^(-3d) g_k(d), d = s - s_k, for k = 1, 2, with
///
///     g_1(d) = 2^(-1/2) K(2d, s_0),
///     g_2(d) = 2 int_0^(pi/2) e^(-3 d sin^2 theta) g_1(2 d sin^2 theta) K(2 d cos^2 theta, s_1 + 2 d sin^2 theta) dtheta,   (D2)
///     K(D, s) = (4/pi) sqrt((1+x+R)/(1-x+R)) / (R sqrt((1 - e^-D)/D)),  x = e^-s,  R^2 = (1-x)^2 + 4x e^-D,
///
/// since of a region with ratio x = e^-s the ratio y, s_y = log(G/2) + (s + D)/2, carries the share of force
/// D^(-1/2) e^(-3D/2) K(D, s) ds_y, from (C3) with u^2 = 2(1 - e^-D)/(1 + x + R). Then q_1(p) = load f_2(s)/p^2.
///
/// In both, the exceedance is the last law against Q of (2.17), its edge again by the distance.
/// **Error.** Every integral is Arb's acb_calc_integrate: Gauss-Legendre with the error bounded on ellipses where the
/// integrand is shown analytic, in balls; its result needs no further proof. Relative accuracy is kept up to the edge p_1^max.
#pragma once

#include "touchstone/scalar/ball.hpp"

namespace touchstone::transfer {

enum class Law { pressures, force_chain };

/// (6.1)  q_1(p) p*_0 for 0 < p < p_1^max, 0 < load <= 1, G > 2; indeterminate where the balls do not prove that.
Ball density_1(Law, const Ball& p, const Ball& load, const Ball& G);

/// Share of lambda_0 with p_1 > p; the same domain.
Ball exceedance_1(Law, const Ball& p, const Ball& load, const Ball& G);

} // namespace touchstone::transfer
