// SPDX-License-Identifier: MIT
/// \file
/// Two quadrature rules, with proven errors, for the chain's average (C3) in the form
///
///     F_{m+1}(x) = int_0^inf g(v) dv,   g(v) = (4/pi) sech^3(v) (x/y)^(1/2) F_m(y),   F_m = x^(1/2) h_m,        (R1)
///
/// y = y(x, v) as in chain.hpp. Where Re(-log y) > 0, Lemma 2 gives |F_m(y)| <= c_m, and then
///
///     |g(v)| <= c_m (4/pi) (G/2)^(1/2) x^(1/4) |cosh v|^(-5/2) |1 - x tanh^2 v|^(-1/4).                         (R2)
///
/// Both rules prove on the boundary of a complex region, by subdivision in balls, that |y| < 1 there and add up
/// (R2); inside, log|y| is subharmonic, so |y| < 1 holds too, provided cosh v and 1 + (1-x) sinh^2 v have no
/// zero in the region, so that log y and g are analytic. The cut-off at v = V costs at most
///
///     int_V^inf |g| dv <= c_m (4/pi) (G/2)^(1/2) x^(1/4) min( 2^(5/2) e^(-5V/2) / (5/2 (1-x)^(1/4)),  2 e^(-2V) ).       (R3)
///
/// **Trapezoid in r, v = c sinh r** (double exponential). g v' is analytic in |Im r| <= d; the error of the
/// doubly infinite sum of step h is at most J/(e^(2 pi d/h) - 1), J = int |g v'| along Im r = d, for the half line
/// (Trefethen & Weideman, SIAM Review 56, 2014, theorem 5.1). Zeros of cosh v are outside since c sin d < pi/2;
/// those of 1 + (1-x) sinh^2 v, at +-A + i pi/2, are outside the image of the strip, the region between the branches
/// of a hyperbola, when (pi/2)^2/(c sin d)^2 - A^2/(c cos d)^2 > 1.
///
/// **Gauss-Legendre on panels of [0, V]** (the first one symmetric about 0). If g <= M on the Bernstein ellipse
/// E_rho of a panel of half-length l, its Chebyshev coefficients are <= 2 M rho^-k; the n-point rule is exact below
/// degree 2n, and |int T_k - rule(T_k)| <= 2/3 + 2. So the error is at most l (16/3) M rho^(-2n)/(1 - 1/rho).
#pragma once

#include "touchstone/transfer/chain.hpp"

#include <string>
#include <vector>

namespace touchstone::transfer {

struct Rule {
    struct Node {
        Ball v, sinh_squared, sech_squared, log_cosh;
        Ball force_weight; ///< (4/pi) sech^2(v) dv, dv the weight of g(v) in int_0^inf g dv
        Ball area_weight;  ///< (4/pi) sech(v) dv
    };
    std::vector<Node> nodes;
    Ball discretisation; ///< proven bound of the rule's error, divided by c_m x^(1/4)
    Ball truncation;     ///< (R3), divided by c_m x^(1/4)
    std::string text;    ///< the parameters, for the certificate
};

/// Rules with errors of about e^-accuracy, reaching out to v = V. Work at the thread's precision.
/// \throws BeyondReach where the region of analyticity could not be proven
Rule double_exponential_rule(const Ball& G, const Ratios& x, double accuracy, double V);
Rule gauss_panel_rule(const Ball& G, const Ratios& x, double accuracy, double V);

// What proves, whatever the parameters are:

/// The trapezoid rule for v = c sinh r to about v = V, with everything about it proven for the strip |Im r| <= d.
/// \throws BeyondReach where that cannot be done
Rule proven_double_exponential(const Ball& G, const Ratios& x, double accuracy, double V, double c, double d);
/// At least int |g v'| over Im r = d, Re v >= alpha, divided by c_m x^(1/4); not finite unless |y| < 1 is proven there.
Ball beyond_on_strip(const Ball& G, const Ratios& x, const Ball& alpha, const Ball& d);
/// The error of the n-point Gauss rule (of the positive half of the 2n-point rule, if even) on mid +- half by the ellipse E_rho, divided by
/// c_m x^(1/4).
Ball proven_panel_error(const Ball& G, const Ratios& x, const Ball& mid, const Ball& half, double rho, bool even, long n);

/// The v at which (R3) is about e^-accuracy.
double cut_off(const Ratios& x, double accuracy);

} // namespace touchstone::transfer
