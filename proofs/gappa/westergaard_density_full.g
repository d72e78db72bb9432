# SPDX-License-Identifier: GPL-3.0-or-later
# (2.15) 1/(pi sqrt((p - load + 1)(load + 1 - p))) in binary64, paper/westergaard.hpp, density_full, from the distances of p to both ends.
# Assumed: the distances `above` and `below` within 1.02 units 2^-53, what westergaard_ends.g proves. Before the last rounding the value is
# within 3.89 units 2^-53, so that it is within 4.39 ulp.
# lib/touchstone/paper/westergaard.hpp:
#   return 1 / (pi<T>() * sqrt(above_lowest(p, load) * below_highest(p, load)));
@rnd = float<ieee_64, ne>;
P = 0x1.921fb54442d18p1;
product = rnd(above * below);
z = 1 / rnd(P * rnd(sqrt(product)));
q = rnd(z);
{ Above in [1b-200, 2] /\ Below in [1b-200, 2] /\ Pi in [3.14159265358979323846, 3.14159265358979323847]
  /\ |above -/ Above| <= 65b-59 /\ |below -/ Below| <= 65b-59 ->
  |z -/ (1 / (Pi * sqrt(Above * Below)))| <= 249b-59 /\ |q -/ (1 / (Pi * sqrt(Above * Below)))| <= 313b-59 }
product ~ Above * Below;
sqrt(product) ~ sqrt(Above * Below);
