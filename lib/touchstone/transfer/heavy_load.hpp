// SPDX-License-Identifier: MIT
/// \file
/// Contact area (6.7) when the first scales are in full contact: load > 1, G = gamma^(D-1) > 2.
///
/// B_m as in chain.hpp, now for every x > 0: at x >= 1 (2.2) turns a region of load ratio x into ratios y = (x + cos theta)/G, so
///
///     B_{m+1}(x) = (1/pi) int_{e-}^{e+} B_m(y) dy/sqrt((y - e-)(e+ - y)),   e+- = (x +- 1)/G,   x >= 1,            (F1)
///     B_{m+1}(x) = int_0^{2 sqrt(x)/G} B_m(y) k(x, y) dy,   k = (G^2 y/2pi)/(R sqrt(x - G^2 y^2/4)) sqrt((1+x+R)/(1-x+R)),
///                  R^2 = (1-x)^2 + G^2 y^2,   x < 1,                                                                  (F2)
///
/// (F2) being (C2) with y for variable, (2.19). B_{-1} = 1, so B_0 = 1 for x >= 1.
///
/// **Lemma 3 (singular points).** Let S be the least set that holds 0, 1 and, with s, those of Gs - 1, Gs + 1 that are
/// >= 1. Let J be an interval without a point of S inside, J within [0, X], D(J) the disc whose diameter J is. Every B_m is analytic in
/// D(J), and |B_m| <= M(X) G^-m there: M(X) = c for X <= 1, else M(X) = Q(X) + (4/pi) sqrt(X/4) G M((X+1)/G); Q(X) = c for X <= 1,
/// else G Q((X+1)/G); c = lim c_m.
/// *Proof.* X <= 1: Lemma 2, D(J) being within |x| < 1. J beyond 1: e-(J) and e+(J) have no point of S inside, so B_{m-1} is
/// analytic in D(e+-(J)) = e+-(D(J)). In (F1), taken at complex x, let the path go from e- straight to Re e-, along the real axis to Re e+,
/// straight to e+. That is B_m for real x, and analytic: the ends of the real part may be held fixed as x moves (Cauchy in the two
/// discs), and on it y - e- and e+ - y do not vanish. On the real part |y - e-| >= |y - Re e-| and so on: at most B_m(Re x), and
/// 0 <= B_m(x) <= B_{m-1}((X+1)/G) <= Q(X) G^-m since B_{m-1} increases. On the upright parts |y - e+-| >= 2/G for the
/// farther end: at most 2 (1/pi) 2 sqrt(G |Im x|/(2G)) M((X+1)/G) G^-(m-1), and |Im x| <= X/2.
///
/// **Lemma 4 (continuity).** 0 <= B_m(x + h) - B_m(x) <= (h/G^m)^(1/2) for x >= 0, h >= 0.
/// *Proof.* B_0 = (2/pi) arcsin sqrt(x) up to 1, then 1: arcsin sqrt(x+h) - arcsin sqrt(x) is greatest where x = 0 or x + h = 1, and
/// <= (pi/2) sqrt(h) there. At a fixed place of the wave the pressure increases with the load, (2.2), (2.4), and its mean is the load, so
/// the ratios y <= y' there have mean difference h/G; B_{m+1}(x + h) - B_{m+1}(x) is the mean of B_m(y') - B_m(y) >= 0, at most that
/// of ((y' - y)/G^m)^(1/2), at most (h/G^(m+1))^(1/2) because the square root is concave. (Out of contact y = 0, B_m(0) = 0.)
///
/// **Method.** The point x = load is a measure; (F1) turns it into one over the ratios of the next scale, kept as weights at Chebyshev
/// points of panels, and so on while there are ratios above 1. Panels shrink by `ratio` towards both ends of each interval between points
/// of S, down to a width h. What reaches ratios below 1 is a sum of weights times B_m, B_m from discretisation.hpp; nodes in (2/G, 1) are
/// taken one scale further by (F2). n enters only in the last step. Integrals are Gauss-Legendre on panels graded in the same way towards
/// the ends of each piece of [e-, e+] between points of S.
///
/// **Error**, every part summed up in balls as the weights are made:
///  1. Gauss rules: bound of rule.hpp, l (16/3) M W rho^(-2n)/(1 - 1/rho), W the kernel on the ellipse by its distances. An ellipse lies in
///  D(J) if its real ends
///     do: (xi^2 + zeta^2 - |J| xi) is convex along cos phi.
///  2. interpolation: 4 M rho^-(p-1)/(rho - 1) times the sum of |weights| that enter a panel.
///  3. what is left out next to the ends, of measure mu: taken at a point at most d away, at most mu (d/G^m)^(1/2) by Lemma 4.
///  4. weights too small to follow: |w| Q. 5. fixed-point roundings, and the radii of weights and of their places as they enter.
///  6. the error of B_m itself: in its ball.
///
/// **Cost.** Grows like the square to the cube of the digits, in proportion to the weights above 2/G, and with the number of scales that
/// have ratios above 1, which is large near G = 2. At 19 digits, one core: 1 s for load 10, G = 4; 6 s for G = sqrt 10; 30 s for G = sqrt
/// 5.
///
/// The routes differ in ratio and ellipse, hence in every node, and in the scheme of discretisation.hpp below 1.
#pragma once

#include "touchstone/transfer/contact.hpp"

namespace touchstone::transfer {

/// (6.7)  A_n/lambda_0 for load > 1, n >= 0. What one load needs beside n is kept for later calls, for a few loads.
/// \throws BeyondReach unless 1 < load < 1001 and G > 2.019 are proven, or for more than 66 digits, which would cost too much
Ball area_at_heavy_load(Scheme, long n, const Arguments&, Accuracy);

/// Do binary64 numbers hold the finest panels, some G^(-n/2) wide, at few digits?
bool heavy_load_has_panels(long n, const Ball& G);

/// How its error is made up.
std::string heavy_load_certificate(Scheme, long n, const Arguments&, Accuracy);

} // namespace touchstone::transfer
