# SPDX-License-Identifier: GPL-3.0-or-later
# (2.5) arcsin(sqrt(s))/pi in binary64, paper/westergaard.hpp, half_width, for s <= 1/2: a root, the C library's arcsine, a division by the
# rounded pi. Assumed: the library's arcsine of the rounded root, `A`, is within one ulp of the arcsine of that root, at most 2^-52 relative
# (`A6`: 0.6 ulp, what glibc's sources say of themselves), and a relative error of the root, at most 2^-53, is at most 1.28 times that of
# its arcsine (Conditions.v, arcsine_condition). Before the last rounding the value is within 3.64 (2.84) units 2^-53, so that it is within
# 4.14 (3.34) ulp.
# lib/touchstone/scalar/scalar.hpp:
#   const double r = std::asin(std::sqrt(std::min(std::max(1.0 - s, 0.0), s))) / std::numbers::pi;
#   return (s > 0.5 ? 0.5 : 0.0) + std::copysign(r, 0.5 - s);
# lib/touchstone/paper/westergaard.hpp:
#   return asin_sqrt_over_pi(load);
@rnd = float<ieee_64, ne>;
P = 0x1.921fb54442d18p1;
root = rnd(sqrt(s));
r = rnd(A / P);
{ s in [1b-1000, 0.5] /\ Pi in [3.14159265358979323846, 3.14159265358979323847] /\ Arc in [1b-540, 1]
  /\ |ArcOfRoot -/ Arc| <= 82b-59 /\ |A -/ ArcOfRoot| <= 1b-52 /\ |A6 -/ ArcOfRoot| <= 77b-59 ->
  |root -/ sqrt(s)| <= 1b-53 /\ |A / P -/ (Arc / Pi)| <= 234b-59 /\ |r -/ (Arc / Pi)| <= 298b-59 /\ |A6 / P -/ (Arc / Pi)| <= 183b-59 }
A ~ Arc;
A6 ~ Arc;
