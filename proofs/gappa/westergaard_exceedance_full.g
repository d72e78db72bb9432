# SPDX-License-Identifier: GPL-3.0-or-later
# (2.14) (2/pi) arctan sqrt(n/d) in binary64, paper/westergaard.hpp, exceedance_full, as (2/pi) arcsin sqrt(n/(n + d)) for the smaller of
# the distances n and d to the ends of the spectrum; for the other the value is 1 minus this, and the absolute error is what it is here, one
# rounding added. Assumed: `n` and `d` within 1.02 units 2^-53, what westergaard_ends.g proves; the library's arcsine of the rounded root,
# `A`, is within one ulp, at most 2^-52 relative (`A6`: 0.6 ulp), and a relative error of the root is at most 1.28 times that of its arcsine
# (Conditions.v, arcsine_condition). Before the last rounding the value is within 6.27 (5.47) units 2^-53.
# lib/touchstone/paper/westergaard.hpp:
#   return 2 * atan_sqrt_over_pi(T(below_highest(p, load)), T(above_lowest(p, load)));
# lib/touchstone/scalar/scalar.hpp:
#   const double r = std::asin(std::sqrt(std::min(n, d) / (n + d))) / std::numbers::pi;
#   return (n > d ? 0.5 : 0.0) + std::copysign(r, d - n);
@rnd = float<ieee_64, ne>;
P = 0x1.921fb54442d18p1;
sum = rnd(n + d);
quotient = rnd(n / sum);
root = rnd(sqrt(quotient));
z = A / P;
z6 = A6 / P;
r = rnd(z);
Share = N / (N + D);
{ N in [1b-60, 1] /\ D in [1, 2] /\ Pi in [3.14159265358979323846, 3.14159265358979323847] /\ Arc in [1b-540, 1]
  /\ |n -/ N| <= 65b-59 /\ |d -/ D| <= 65b-59
  /\ |ArcOfRoot -/ Arc| <= 250b-59 /\ |A -/ ArcOfRoot| <= 1b-52 /\ |A6 -/ ArcOfRoot| <= 77b-59 ->
  |root -/ sqrt(Share)| <= 195b-59 /\ |z -/ (Arc / Pi)| <= 401b-59 /\ |z6 -/ (Arc / Pi)| <= 350b-59 /\ |r -/ (Arc / Pi)| <= 465b-59 }
n / sum ~ Share;
n / (n + d) ~ Share;
quotient ~ Share;
sqrt(quotient) ~ sqrt(Share);
(n / (n + d) - Share) / Share -> ((n - N) / N - (d - D) / D) / (n / D + d / D) { N <> 0, D <> 0, n + d <> 0, N + D <> 0 };
A ~ Arc;
A6 ~ Arc;
