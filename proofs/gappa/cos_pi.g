# SPDX-License-Identifier: GPL-3.0-or-later
# cos(pi x) in binary64 for 0 <= x <= 1/4 as the sine of pi (1/2 - x): three roundings of the angle. Above 1/4 the difference is exact and
# sin_pi.g holds. Assumed: the library's sine of the rounded angle, `S`, is within one ulp of the sine of that angle, at most 2^-52 relative
# (`S6`: 0.6 ulp, absolutely `U`), and of an error of an angle in [pi/4, pi/2] at most 0.787 is a relative error of its sine
# (Conditions.v, sine_condition_steep) and 0.5625 an absolute one (sine_condition_absolute). Bounds: 2.36, 3.88 and 3.08 units 2^-53, and
# 1.94 of the ulp 2^-53 for `U`.
# lib/touchstone/scalar/scalar.hpp:
#   static double cos_pi(double x) { return std::sin(std::numbers::pi * (0.5 - std::fabs(within_a_turn(x)))); }
@rnd = float<ieee_64, ne>;
P = 0x1.921fb54442d18p1;
angle = rnd(P * rnd(0.5 - x));
{ x in [0, 0.25] /\ Pi in [3.14159265358979323846, 3.14159265358979323847] /\ Sine in [0.7, 1] /\ |SineOfAngle -/ Sine| <= 119b-59
  /\ |S -/ SineOfAngle| <= 1b-52 /\ |S6 -/ SineOfAngle| <= 77b-59 /\ |SineOfAngle - Sine| <= 85b-59 /\ |U - SineOfAngle| <= 77b-60 ->
  |angle -/ (Pi * (0.5 - x))| <= 151b-59 /\ |S -/ Sine| <= 248b-59 /\ |S6 -/ Sine| <= 197b-59 /\ |U - Sine| <= 124b-59 }
rnd(0.5 - x) ~ 0.5 - x;
U - Sine -> (U - SineOfAngle) + (SineOfAngle - Sine);
