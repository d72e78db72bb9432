# SPDX-License-Identifier: GPL-3.0-or-later
# (2.17) (2/pi) arctan sqrt(n/d), n = 4 load - p^2, d = 2(1 - load) + 2 R + p^2, in binary64, paper/westergaard.hpp, exceedance_partial,
# load < 1, as (2/pi) arcsin sqrt(n/(n + d)) where n <= d; where d is the smaller n and d change places, and the value is 1 minus this.
# Assumed: `R` within 3.04 units 2^-53, what westergaard_radius.g proves; the library's arcsine of the rounded root, `A`, is within one ulp,
# at most 2^-52 relative (`A6`: 0.6 ulp), and a relative error of the root is at most 1.28 times that of its arcsine (Conditions.v,
# arcsine_condition). Before the last rounding the value is within 8.85 (8.05) units 2^-53: the worst of eleven roundings added up. The
# fused n rounds once, at the edge too.
# lib/touchstone/paper/westergaard.hpp:
#   return 2 * atan_minus_square_over_pi(T(4 * load), p, T(2 * (1 - load) + (2 * R + p * p)));
# lib/touchstone/scalar/scalar.hpp:
#   return atan_sqrt_over_pi(std::fma(-b, b, a), d);
#   const double r = std::asin(std::sqrt(std::min(n, d) / (n + d))) / std::numbers::pi;
@rnd = float<ieee_64, ne>;
P = 0x1.921fb54442d18p1;
n = rnd(4 * load - p * p);
d = rnd(2 * rnd(1 - load) + rnd(2 * R + rnd(p * p)));
sum = rnd(n + d);
quotient = rnd(n / sum);
root = rnd(sqrt(quotient));
z = A / P;
z6 = A6 / P;
r = rnd(z);
N = 4 * load - p * p;
D = 2 * (1 - load) + (2 * Radius + p * p);
Share = N / (N + D);
{ load in [1b-200, 1] /\ 1 - load in [1b-53, 1] /\ p in [1b-200, 2] /\ N in [1b-400, 4] /\ D in [1b-100, 10] /\ Radius in [1b-100, 2]
  /\ Pi in [3.14159265358979323846, 3.14159265358979323847] /\ Arc in [1b-540, 1] /\ |R -/ Radius| <= 194b-59
  /\ |ArcOfRoot -/ Arc| <= 415b-59 /\ |A -/ ArcOfRoot| <= 1b-52 /\ |A6 -/ ArcOfRoot| <= 77b-59 ->
  |d -/ D| <= 324b-59 /\ |root -/ sqrt(Share)| <= 324b-59 /\ |z -/ (Arc / Pi)| <= 566b-59 /\ |z6 -/ (Arc / Pi)| <= 515b-59
  /\ |r -/ (Arc / Pi)| <= 631b-59 }
d ~ D;
n / sum ~ Share;
n / (n + d) ~ Share;
quotient ~ Share;
sqrt(quotient) ~ sqrt(Share);
(n / (n + d) - Share) / Share -> ((n - N) / N - (d - D) / D) / (n / D + d / D) { N <> 0, D <> 0, n + d <> 0, N + D <> 0 };
A ~ Arc;
A6 ~ Arc;
