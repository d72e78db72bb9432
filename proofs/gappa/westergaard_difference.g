# SPDX-License-Identifier: GPL-3.0-or-later
# load - sin^2(pi x) in binary64 for x <= 1/4, of which (2.4) takes the root, as load - y^2 + (y^2 - sin^2 y), y = pi x; scalar.hpp,
# minus_sin_square. For x > 1/4 the same operations form (1 - load) - sin^2(pi (1/2 - x)), both differences exact where it matters, and its
# negative is the value. The difference vanishes at the edge of the contact, so that the bound is absolute: 2.22 units 2^-53 for differences
# from -0.38 to 0.49, where rounding load and x moves it by up to 1.28. Assumed: the C library's sine of the rounded pi, `S`, is within
# 2^-52 of itself; the series `rest` is within 12.5 units, what sine_series.g proves, of y^2 - sin^2 y, `Rest`, at most 0.1169. The fused
# operations round once.
# lib/touchstone/scalar/scalar.hpp:
#   return minus_pi_square(a, x) + z * z * sum_of_powers(sine_terms, z);
#   const double low = std::fma(std::numbers::pi, x, -y) + std::sin(std::numbers::pi) * x; // sin(fl(pi)) = pi - fl(pi) to all digits
#   return std::fma(-y, y, a) - 2 * y * low;
@rnd = float<ieee_64, ne>;
P = 0x1.921fb54442d18p1;
y = rnd(P * x);
low = rnd(rnd(P * x - y) + rnd(S * x));
first = rnd(load - y * y);
second = rnd(2 * y * low);
parabola = rnd(first - second);
difference = rnd(parabola + rest);
Low = (P * x - y) + (Pi - P) * x;
Parabola = load - (Pi * x) * (Pi * x);
True = Parabola + Rest;
{ x in [1b-30, 0.25] /\ Pi in [3.14159265358979323846264338327950288, 3.14159265358979323846264338327950289]
  /\ |S -/ (Pi - P)| <= 1b-52 /\ Rest in [1b-140, 0.1169] /\ |rest -/ Rest| <= 795b-59 /\ load in [0, 1] /\ True in [-0.38, 0.49] ->
  |difference - True| <= 142b-59 }
low ~ Low;
rest ~ Rest;
parabola - Parabola -> (parabola - (first - second)) + (first - (load - y * y)) - ((second - 2 * y * low) + 2 * y
  * (low - Low) - Low * Low);
Parabola -> True - Rest;
