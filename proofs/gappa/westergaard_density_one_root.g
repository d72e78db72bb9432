# SPDX-License-Identifier: GPL-3.0-or-later
# (2.19) p/pi sqrt((1 + load + R)/((1 - load + R) R^2 room)), R^2 = (1 - load)^2 + p^2, room = 4 load - p^2, in binary64,
# paper/westergaard.hpp, density_partial(double, double) where R^2 and load are above 2^-300. Assumed: `room` within 3 units 2^-53, what
# minus_square says of itself, and `R` within 3.04, what westergaard_radius.g proves of the same operations; R^2 itself is within 4.03.
# Before the last rounding the value is within 11.6 units 2^-53: the worst of all roundings added up.
# lib/touchstone/paper/westergaard.hpp:
#   return p / pi<T>() * sqrt((1 + load + R) / (((1 - load) + R) * sum * room));
#   const double share = 1 - load, sum = share * share + p * p;
@rnd = float<ieee_64, ne>;
P = 0x1.921fb54442d18p1;
share = rnd(1 - load);
above = rnd(rnd(1 + load) + R);
below = rnd(share + R);
under = rnd(rnd(below * sum) * room);
ratio = rnd(above / under);
z = rnd(p / P) * rnd(sqrt(ratio));
q = rnd(z);
Ratio = ((1 + load) + Radius) / ((((1 - load) + Radius) * Square) * Room);
Q = (p / Pi) * sqrt(Ratio);
{ load in [1b-300, 1] /\ 1 - load in [1b-53, 1] /\ p in [1b-300, 2] /\ Room in [1b-420, 4] /\ Square in [1b-300, 4] /\ Radius in [1b-150, 2]
  /\ Pi in [3.14159265358979323846, 3.14159265358979323847] /\ |R -/ Radius| <= 195b-59 /\ |sum -/ Square| <= 258b-59 /\ |room -/ Room| <= 192b-59 ->
  |z -/ Q| <= 742b-59 /\ |q -/ Q| <= 806b-59 }
ratio ~ Ratio;
sqrt(ratio) ~ sqrt(Ratio);
