# SPDX-License-Identifier: GPL-3.0-or-later
# (2.19) p/(pi R root) sqrt((1 + load + R)/(1 - load + R)), root = sqrt(4 load - p^2), in binary64, paper/westergaard.hpp, density_partial,
# load < 1. Assumed: `R` within 3.04 units 2^-53, what westergaard_radius.g proves. The fused 4 load - p^2 rounds once, so that nothing is
# lost at the upper edge. Before the last rounding the value is within 13.2 units 2^-53: the worst of thirteen roundings added up.
# lib/touchstone/paper/westergaard.hpp:
#   return p / (pi<T>() * R * root) * sqrt((1 + load + R) / (1 - load + R));
#   return density_partial(p, load, sqrt_minus_square(T(4 * load), p));
# lib/touchstone/scalar/scalar.hpp:
#   if (e == 0) return sqrt_positive_part(std::fma(-b, b, a));
@rnd = float<ieee_64, ne>;
P = 0x1.921fb54442d18p1;
edge = rnd(4 * load - p * p);
root = rnd(sqrt(edge));
above = rnd(rnd(1 + load) + R);
below = rnd(rnd(1 - load) + R);
ratio = rnd(above / below);
z = rnd(p / rnd(rnd(P * R) * root)) * rnd(sqrt(ratio));
q = rnd(z);
Edge = 4 * load - p * p;
Ratio = ((1 + load) + Radius) / ((1 - load) + Radius);
Q = p / ((Pi * Radius) * sqrt(Edge)) * sqrt(Ratio);
{ load in [1b-200, 1] /\ 1 - load in [1b-53, 1] /\ p in [1b-200, 2] /\ Edge in [1b-400, 4] /\ Radius in [1b-100, 2]
  /\ Pi in [3.14159265358979323846, 3.14159265358979323847] /\ |R -/ Radius| <= 194b-59 ->
  |root -/ sqrt(Edge)| <= 97b-59 /\ |z -/ Q| <= 839b-59 /\ |q -/ Q| <= 903b-59 }
edge ~ Edge;
sqrt(edge) ~ sqrt(Edge);
ratio ~ Ratio;
sqrt(ratio) ~ sqrt(Ratio);
