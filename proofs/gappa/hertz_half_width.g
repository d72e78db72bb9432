# SPDX-License-Identifier: GPL-3.0-or-later
# (2.7) sqrt(load)/pi in binary64, paper/westergaard.hpp, hertz::half_width: a root and a division by the rounded pi. Nothing is assumed.
# Before the last rounding the value is within 1.36 units 2^-53, so that it is within 1.86 ulp.
# lib/touchstone/paper/westergaard.hpp:
#   return sqrt(load) / pi<T>();
@rnd = float<ieee_64, ne>;
P = 0x1.921fb54442d18p1;
z = rnd(sqrt(load)) / P;
a = rnd(z);
{ load in [1b-1000, 1b1000] /\ Pi in [3.14159265358979323846, 3.14159265358979323847] ->
  |z -/ (sqrt(load) / Pi)| <= 87b-59 /\ |a -/ (sqrt(load) / Pi)| <= 151b-59 }
