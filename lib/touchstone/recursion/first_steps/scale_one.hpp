// SPDX-License-Identifier: MIT
/// \file
/// The distribution of pressure at scale 1, certified, for any G > 1 and load: (6.1) as one integral over closed forms.
///
/// With x = p_0/p*_1 and P = p/p*_1 there are two waves: E(x), the share of lambda_0 above x after the first, and F(x; P), the share of a
/// region of ratio x above P after the second (wave.hpp, (W1) to (W4)):
///
/// | variable | Q_1                                                    | q_1 p*_1                                                  |
/// |----------|--------------------------------------------------------|-----------------------------------------------------------|
/// | ratio    | int -E'(x) F(x; P) dx                                  | int -E'(x) (-dF/dP) dx                                    |
/// | angle    | (1/pi) int E(x(u)) du/sqrt(u(2-u)), 0 < u < 2          | (1/pi) int -E'(x(u)) (dx/dP) du/sqrt(u(2-u))              |
///
/// u = 1 + cos(theta) of the second wave: x = P + 1 - u, dx/dP = 1 for u < P (full contact), 1 - x = (u-P)(u+P)/(2u), dx/dP = P/u beyond.
/// At p = 0, Q_1 is the area A_1, F(x; 0) that of one wave, (6.6), and u = 2(1 - x).
/// In both, q_1 has its singular points where two ends meet: logarithms inside the support, p = load +- 1 +- G, and so on.
///
/// **Evaluation** as in pieces.hpp, with the singular points ordered exactly: by ratio in halves (acb_calc_integrate), by angle each piece
/// as a whole (one Gauss-Legendre rule or tanh-sinh; in halves too where a pair of complex singular points all but pinches an end, |1 -
/// load| < 1e-20, say). Reach: every load > 0 and G > 1, p >= 0 for Q_1, p > 0 for q_1, any digits; milliseconds for 15 digits and tens of
/// them for 100, more for each decade by which two singular points are nearer than the rest.
#pragma once

#include "touchstone/scalar/ball.hpp"
#include "touchstone/scalar/exact.hpp"

#include <functional>
#include <optional>

namespace touchstone::transfer {

enum class Variable { ratio, angle };

/// What is asked for; balls at the thread's precision, any precision.
struct ScaleOne {
    std::function<Ball()> p;      ///< >= 0, in p*_0
    Rational load;                ///< > 0
    std::function<Ball()> G;      ///< > 1
    std::optional<Exact> exact_p, exact_G; ///< if they are roots of rationals: two ends that coincide can be told then
};

/// Q_1(p). \throws BeyondReach if two ends cannot be told from one another, or the integral does not converge
Ball scale_one_exceedance(Variable, const ScaleOne&);
/// q_1(p) p*_0. \throws BeyondReach as above, or where it is infinite
Ball scale_one_density(Variable, const ScaleOne&);

} // namespace touchstone::transfer
