# SPDX-License-Identifier: GPL-3.0-or-later
# R = sqrt((1 - load)^2 + p^2) in binary64 for load < 1, paper/westergaard.hpp, exceedance_partial and density_partial: hypot_of.g with a
# rounded 1 - load. Nothing is assumed. Bounds: 4.03 units 2^-53 of the square, 3.03 of R; at load = 1 R is p.
# lib/touchstone/paper/westergaard.hpp:
#   const T R = hypot_of(T(1 - load), p);
# lib/touchstone/scalar/scalar.hpp:
#   if (b == 0) return std::fabs(a);
#   const double square = a * a + b * b;
@rnd = float<ieee_64, ne>;
a = rnd(1 - load);
square = rnd(rnd(a * a) + rnd(p * p));
R = rnd(sqrt(square));
{ 1 - load in [1b-53, 1] /\ p in [1b-400, 2] ->
  |square -/ ((1 - load) * (1 - load) + p * p)| <= 258b-59 /\ |R -/ sqrt((1 - load) * (1 - load) + p * p)| <= 194b-59 }
a ~ 1 - load;
square ~ (1 - load) * (1 - load) + p * p;
