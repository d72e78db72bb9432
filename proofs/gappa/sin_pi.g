# SPDX-License-Identifier: GPL-3.0-or-later
# sin(pi x) in binary64 for 0 < x <= 1/2, to which the other arguments are reduced exactly: the rounded pi and one product, then the C
# library's sine. Assumed: the library's sine of the rounded angle, `S`, is within one ulp of the sine of that angle, at most 2^-52 relative
# (`S6`: 0.6 ulp), and an error of the angle is no larger a relative error of its sine (Conditions.v, sine_condition). Bounds: 1.36, 3.38
# and 2.58 units 2^-53. Counted in ulp, of which there are 2^52 in the power of two `B` below the sine, a library's `U` within 0.6 ulp makes
# less than 2.
# lib/touchstone/scalar/scalar.hpp:
#   return std::copysign(std::sin(std::numbers::pi * std::min(a, 1.0 - a)), turn);
@rnd = float<ieee_64, ne>;
P = 0x1.921fb54442d18p1;
angle = rnd(P * x);
{ x in [1b-1000, 0.5] /\ Pi in [3.14159265358979323846, 3.14159265358979323847] /\ Sine in [1b-1000, 1]
  /\ |SineOfAngle -/ Sine| <= 87b-59 /\ |S -/ SineOfAngle| <= 1b-52 /\ |S6 -/ SineOfAngle| <= 77b-59
  /\ Sine / B in [1, 2] /\ B in [1b-1001, 1] /\ |(U - SineOfAngle) / B| <= 154b-60 ->
  |angle -/ (Pi * x)| <= 87b-59 /\ |S -/ Sine| <= 216b-59 /\ |S6 -/ Sine| <= 165b-59 /\ |(U - Sine) / B| <= 2b-52 }
(U - Sine) / B -> (U - SineOfAngle) / B + ((SineOfAngle - Sine) / Sine) * (Sine / B) { Sine <> 0, B <> 0 };
