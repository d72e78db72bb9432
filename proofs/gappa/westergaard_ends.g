# SPDX-License-Identifier: GPL-3.0-or-later
# The distances p - (load - 1) and (load + 1) - p to the ends of the spectrum in binary64, paper/westergaard.hpp, above_lowest and
# below_highest. The inner difference is exact but in one case (Sterbenz): load - 1 for load <= 2, p - load for load >= 2 or p >= load/2.
# There the outer one rounds once, 2^-53. Left is below_highest for load <= 2 and p < load/2, where -1 <= p - load < -1/2: the two roundings
# come to no more than 1.02 units. Nothing is assumed.
# lib/touchstone/paper/westergaard.hpp:
#   T below_highest(const T& p, const T& load) { return 1 - (p - load); } ///< to the highest pressure
#   inline double above_lowest(double p, double load) { return load <= 2 ? p - (load - 1) : 1 + (p - load); } ///< (2.16)
@rnd = float<ieee_64, ne>;
load = rnd(load0);
fall = rnd(p - load);
{ load in [1, 2] /\ p in [0, 1] /\ p - load in [-1, -0.5] ->
  rnd(load - 1) - (load - 1) in [0, 0] /\ |rnd(1 - fall) -/ (1 - (p - load))| <= 65b-59 }
rnd(1 - fall) ~ 1 - (p - load);
fall ~ p - load;
