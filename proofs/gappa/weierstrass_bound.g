# SPDX-License-Identifier: GPL-3.0-or-later
# (3.4) -1/(gamma^(D-2) - 1) in binary64, paper/weierstrass.hpp, bound, with y = D - 2, an exact difference for D in [1, 2). Assumed: the C
# library's logarithm `L` and expm1 `E` are within one ulp, at most 2^-52 relative, and an error of the argument t < 0 is no larger a
# relative error of exp(t) - 1, since |t| exp(t) <= 1 - exp(t) (Conditions.v, expm1_condition). Before the last rounding the value is within
# 5.03 units 2^-53, so that it is within 5.53 ulp.
# lib/touchstone/scalar/scalar.hpp:
#   static double powm1(double x, double y) { return std::expm1(y * std::log(x)); } ///< x^y - 1 for x > 0
# lib/touchstone/paper/weierstrass.hpp:
#   return -1 / powm1(gamma, T(D - 2));
@rnd = float<ieee_64, ne>;
t = rnd(y * L);
z = -1 / E;
b = rnd(z);
{ y in [-1, -1b-53] /\ Log in [1b-53, 710] /\ Power in [-1, -1b-110]
  /\ |L -/ Log| <= 1b-52 /\ |PowerOfT -/ Power| <= 193b-59 /\ |E -/ PowerOfT| <= 1b-52 ->
  |t -/ (y * Log)| <= 193b-59 /\ |z -/ (-1 / Power)| <= 322b-59 /\ |b -/ (-1 / Power)| <= 386b-59 }
E ~ Power;
