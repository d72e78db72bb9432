// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// What can be proved about the model of sections 5 and 6 for all its parameters without computing it.
///
/// With x the load ratio p_{n-1}/p*_n and G = gamma^(D-1), one scale turns x into
///   y = (2/G) sqrt(x) cos psi sqrt(1 - x sin^2 psi)  with weight (2/pi) sqrt(x) cos psi/sqrt(1 - x sin^2 psi) d psi, x < 1,
///   y = (x + cos theta)/G                            with weight d theta/pi,                                         x >= 1,
/// psi in (0, pi/2), theta in (0, pi). Weighted with the force it carries (times G y/x) this is a Markov chain x_0 = load,
/// x_1, ... and
///   A_n/lambda_0 = load G^-n E[h(x_n)],  h(x) = (2/pi) arcsin(sqrt(x))/x for x < 1, 1/x for x >= 1.
/// In partial contact u = sin psi then has the density (4/pi) sqrt(1 - u^2) on (0, 1) whatever x is.
#pragma once

#include "proofs/ledger.hpp"

#include "touchstone/scalar/ball.hpp"

namespace touchstone::proofs {

/// Lemma: the force-weighted chain as above follows from (2.2), (2.4), (6.6), and the mean of y is x/G.
Check force_weighting();

/// Lemma: E[x_n^(-1/2)] <= max(load^(-1/2), G) for every n, and in the limit at most G; in partial contact
/// throughout (G > 2, load < 1) in the limit at most 8 G/pi^2.
Check inverse_root_moment();

/// Theorem: min(2/pi, 1/X) <= A_n G^n/(lambda_0 load) <= max(load^(-1/2), G), X = max(load, x_P), for every n >= 0,
/// every G > 1 and every load. So log(A_n)/n tends to -log G, and A_n to zero.
Check area_bounds();

/// Theorem: for G > 2 and load < 1 the area (6.7) is at least the Hertzian one (7.18), corrected, at every scale, and
/// liminf A_n G^n/(lambda_0 load) >= K_inf G + pi/(24 G) > K_inf G, the value of (7.21).
Check hertz_from_below();
/// The factor by which the area exceeds (7.21) in the limit is at least 1 + pi/(24 G^2 K_inf).
Ball least_excess(const Ball& G);

/// Theorem: for G > 2 and load < 1 limsup A_n G^n/(lambda_0 load) is at most (2/pi) (8 G/pi^2 + (pi/2 - 1) 2/G): arcsin t <= t + (pi/2 - 1)
/// t^3 on (0, 1), E[x^(-1/2)] is at most 8 G/pi^2 in the limit and x at most x_P = 4/G^2.
Check area_from_above();
/// That over K_inf G, the value of (7.21).
Ball most_excess(const Ball& G);

/// Theorem: for G >= 2 and load <= 1 the force-weighted chain has one limiting law, whatever the load, and
/// A_n G^n/(lambda_0 load) one limit C(G). In s = -log x one step is s' = log(G/2) + s/2 - log(1 - u^2)/2 - log(1 - u^2 e^-s)/2
/// with the law of u the same for all s, and ds'/ds = (1 - 2t)/(2(1 - t)), t = u^2 x < u^2. Its absolute value is at most 1/2 for
/// t <= 1/2 and at most max(1, (2u^2 - 1)/(1 - u^2))/2 otherwise, in the mean at most
///     (sqrt(2) + arcsin(sqrt(2/3)))/pi = 0.754...
/// so one step brings any two laws closer by that factor (in the Wasserstein distance of s). The factor E[x_n^-a] stays bounded for
/// a < 3/2, so the limits extend to functions that grow like x^-1: shares by number of contacts, and h.
Check one_limiting_law();
/// That factor.
Ball contraction();

/// Theorem: for 1 < G < 2 the share of the contacting asperities that are in full contact stays above a positive
/// number at all large n.
Check full_contact_share_stays();
/// Such a number for G < sqrt(2), from t in (G^2/4, 1/G^2).
Ball least_full_share(const Ball& G, const Ball& root_of_t);

/// Theorem: for 1 < G < sqrt(20) the share of the contacting asperities with load ratio at least 1/5, outside the
/// Hertzian range (2.8), stays above a positive number at all large n.
Check non_hertzian_share_stays();
/// Such a number for G > 2, load <= x_P: (pi^2/32)(1 - 8 G sqrt(t)/pi^2), t = 1/5.
Ball least_non_hertzian_share(const Ball& G);

} // namespace touchstone::proofs
