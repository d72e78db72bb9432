// SPDX-License-Identifier: MIT
/// \file
/// The chain of load ratios behind the recursion (6.1)-(6.7) in partial contact, and what is proven about it.
///
/// Put G = gamma^(D-1) and x = p_{n-1}/p*_n, so that p*_{n+1} = G p*_n by (3.8). In partial contact, x <= 1,
/// (2.4) turns a region of load ratio x into load ratios
///
///     y = (2/G) sqrt(x (1 - u^2)(1 - x u^2)),   u = sin(pi xi/lambda)/sqrt(x),  0 <= u < 1,                   (C1)
///
/// for the next scale. Let B_m(x) be the share of length in contact after m + 1 scales that begin at ratio x:
/// B_0(x) = (2/pi) arcsin sqrt(x) by (6.6) and, summing (6.1) and (6.7) from the last scale back to the first,
///
///     B_{m+1}(x) = (2/pi) sqrt(x) int_0^1 B_m(y) du / sqrt(1 - x u^2),      A_n/lambda_0 = B_n(load).           (C2)
///
/// In units of force, h_m(x) = G^m B_m(x)/x, the same recursion is an average over a fixed distribution:
///
///     h_{m+1}(x) = (4/pi) int_0^1 h_m(y) sqrt(1 - u^2) du                                                      (C3)
///
/// because B_m(y) = y h_m(y)/G^m and y/sqrt(1 - x u^2) = (2/G) sqrt(x (1 - u^2)). With u = tanh v both are integrals
/// over the whole real line of functions analytic in v, where y = (2/G) sqrt(x (1 + (1-x) sinh^2 v))/cosh^2 v.
///
/// **Lemma 1 (half-plane).** Let x = e^-s. If Re s > 0 then, for every u in [0, 1), s_y = -log y, continued
/// from real s, is analytic in s and Re s_y > log(G/2) + Re(s)/2 when G >= 2.
/// *Proof.* s_y = log(G/2) + s/2 - log(1 - u^2)/2 - log(1 - u^2 e^-s)/2; the last logarithm is analytic since
/// |u^2 e^-s| < 1, and (1 - u^2)|1 - u^2 e^-s| <= (1 - u^2)(1 + u^2) <= 1.
///
/// **Lemma 2 (size).** As a function of s, h_m is analytic in Re s > 0 and |h_m| <= c_m |x|^(-a_m) there, with
/// a_m = 2^(-m-1), c_0 = 1, c_{m+1} = c_m (G/2)^{a_m} (2/sqrt(pi)) Gamma(3/2 - a_m)/Gamma(2 - a_m).
/// *Proof.* |arcsin z| <= arcsin |z| <= (pi/2)|z| for |z| <= 1 (positive Taylor coefficients, convexity), so
/// |h_0| <= |x|^(-1/2). By Lemma 1, (C3) extends to Re s > 0, and |y|^-a <= ((2/G)|x|^(1/2)(1 - u^2))^-a because
/// |1 - x u^2| >= 1 - u^2; int_0^1 (1-u^2)^(1/2-a) du = (sqrt(pi)/2) Gamma(3/2-a)/Gamma(2-a).
///
/// So F_m = x^(1/2) h_m obeys |F_m| <= c_m on the whole half-plane: no interpolation or quadrature bound needs more.
/// For load <= 1 every later ratio is at most 2/G, by (C1); G > 2 is what keeps the chain away from x = 1.
#pragma once

#include "touchstone/scalar/ball.hpp"
#include "touchstone/wave/lemmas.hpp"

#include <vector>

namespace touchstone::transfer {

/// c_0 ... c_levels of Lemma 2.
inline std::vector<Ball> magnitudes(const Ball& G, long levels) { return wave::size(G, levels); }

/// The load ratios a quadrature rule is to serve: all of 0 < x <= highest, or the one x = highest <= 1.
struct Ratios {
    Ball highest;
    bool single;
    bool at_one() const; ///< certainly x = 1
    /// Re v of the nearest zeros of 1 + (1-x) sinh^2 v, arccosh(1/sqrt(1-x)) +- i pi/2; 0 where there are none (x = 1).
    Ball zeros() const;
};

/// What the integrands (C2), (C3) can do at complex v, for all x in a set of ratios.
struct ChainBounds {
    Ball modulus;       ///< at least |y|; not finite where nothing could be shown
    Ball cosh_squared;  ///< encloses |cosh v|^2
    Ball factor;        ///< at most |1 - x tanh^2 v|, >= 0
};
/// At least x|1 - x z| for all x in [0, highest] and z in the ball. It increases with x except while xz is in the disc |1 - xz - 1/4| <
/// 1/4, where
/// |1 - xz| <= 1/2 and |xz| <= 1.
Ball largest_product(const ComplexBall& z, const Ball& highest);
ChainBounds chain_bounds(const ComplexBall& v, const Ball& G, const Ratios& x);

Ball upper(const Ball&); ///< exact upper end of a ball (30 bits)
Ball lower(const Ball&); ///< exact lower end of a ball (30 bits)

} // namespace touchstone::transfer
