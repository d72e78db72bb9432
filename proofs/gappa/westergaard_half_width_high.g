# SPDX-License-Identifier: GPL-3.0-or-later
# (2.5) 1/2 - arcsin(sqrt(t))/pi in binary64, paper/westergaard.hpp, half_width, for s > 1/2, where t = 1 - s is exact (Sterbenz). Assumed:
# what westergaard_half_width_low.g assumes of the library's arcsine, `A` within one ulp, `A6` within 0.6. The value lies in [1/4, 1/2],
# where an ulp is 2^-54: it is within 2.82 (2.42) of these.
# lib/touchstone/scalar/scalar.hpp:
#   const double r = std::asin(std::sqrt(std::min(std::max(1.0 - s, 0.0), s))) / std::numbers::pi;
#   return (s > 0.5 ? 0.5 : 0.0) + std::copysign(r, 0.5 - s);
@rnd = float<ieee_64, ne>;
P = 0x1.921fb54442d18p1;
root = rnd(sqrt(t));
a = rnd(0.5 - rnd(A / P));
a6 = rnd(0.5 - rnd(A6 / P));
{ t in [1b-53, 0.5] /\ Pi in [3.14159265358979323846, 3.14159265358979323847] /\ Arc in [1b-27, 0.785398163397448309616]
  /\ |ArcOfRoot -/ Arc| <= 82b-59 /\ |A -/ ArcOfRoot| <= 1b-52 /\ |A6 -/ ArcOfRoot| <= 77b-59 ->
  |root -/ sqrt(t)| <= 1b-53 /\ |a - (0.5 - Arc / Pi)| <= 181b-60 /\ |a6 - (0.5 - Arc / Pi)| <= 155b-60 }
A ~ Arc;
A6 ~ Arc;
