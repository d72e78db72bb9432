# SPDX-License-Identifier: GPL-3.0-or-later
# (9.4) arctan(sqrt(y)/sqrt(G - y))/pi in binary64, paper/segments.hpp, max_half_width, from y = f(x) of (5.4), (5.5), where y <= G/2.
# Assumed: `y` within 2^-53, as at n = 1 from an exact load; the C library's arctangent, `A`, within one ulp, at most 2^-52 relative (`A6`:
# 0.6 ulp); and an error of the ratio of the two roots is no larger a relative error of its arctangent (Conditions.v, arctangent_condition).
# Before the last rounding the value is within 5.91 (5.11) units 2^-53.
# lib/touchstone/paper/segments.hpp:
#   const T y = peaks::f(n == 1 ? load : peaks::iterate(n - 2, load, G));
#   return atan2(sqrt(y), sqrt_positive_part(T(G - y))) / pi<T>();
@rnd = float<ieee_64, ne>;
P = 0x1.921fb54442d18p1;
opposite = rnd(sqrt(y));
adjacent = rnd(sqrt(rnd(G - y)));
z = A / P;
z6 = A6 / P;
{ Y in [1b-600, 1b300] /\ G - Y in [1b-600, 1b300] /\ Y / (G - Y) in [1b-900, 1] /\ Pi in [3.14159265358979323846, 3.14159265358979323847]
  /\ Angle in [1b-500, 1] /\ |y -/ Y| <= 1b-53
  /\ |AngleOfRatio -/ Angle| <= 226b-59 /\ |A -/ AngleOfRatio| <= 1b-52 /\ |A6 -/ AngleOfRatio| <= 77b-59 ->
  |opposite / adjacent -/ (sqrt(Y) / sqrt(G - Y))| <= 226b-59 /\ |z -/ (Angle / Pi)| <= 378b-59 /\ |z6 -/ (Angle / Pi)| <= 327b-59 }
sqrt(y) ~ sqrt(Y);
G - y ~ G - Y;
rnd(G - y) ~ G - Y;
sqrt(rnd(G - y)) ~ sqrt(G - Y);
((G - y) - (G - Y)) / (G - Y) -> - ((y - Y) / Y) * (Y / (G - Y)) { Y <> 0, G - Y <> 0 };
A ~ Angle;
A6 ~ Angle;
