# SPDX-License-Identifier: GPL-3.0-or-later
# (2.6) 2 sqrt(load - (pi x)^2) in binary64, paper/westergaard.hpp, hertz::pressure. The operations commute with doubling x and quadrupling
# load, so that x in [1/8, 1/4] stands for all x. The difference may cancel 44 bits: beyond, the inputs' own rounding moves the value by
# 2^43 ulp. Assumed: the C library's sine of the rounded pi, `S`, which is what pi is off by, is within 2^-52 of itself. The fused
# operations round once. The value is within 2.04 units 2^-53, before its last rounding (the root's) within 1.04: within 1.54 ulp.
# lib/touchstone/scalar/scalar.hpp:
#   const double y = std::numbers::pi * x;
#   const double low = std::fma(std::numbers::pi, x, -y) + std::sin(std::numbers::pi) * x; // sin(fl(pi)) = pi - fl(pi) to all digits
#   return std::fma(-y, y, a) - 2 * y * low;
# lib/touchstone/paper/westergaard.hpp:
#   return 2 * sqrt_minus_pi_square(load, x);
@rnd = float<ieee_64, ne>;
P = 0x1.921fb54442d18p1;
y = rnd(P * x);
low = rnd(rnd(P * x - y) + rnd(S * x));
first = rnd(load - y * y);
second = rnd(2 * y * low);
difference = rnd(first - second);
root = rnd(sqrt(difference));
p = 2 * root;
True = load - (Pi * x) * (Pi * x);
Low = (P * x - y) + (Pi - P) * x;
Tail = 2 * y * Low + Low * Low;
{ x in [0.125, 0.25] /\ Pi in [3.14159265358979323846264338327950288, 3.14159265358979323846264338327950289]
  /\ |S -/ (Pi - P)| <= 1b-52 /\ True in [1b-44, 1b40] ->
  |difference -/ True| <= 130b-59 /\ |sqrt(difference) -/ sqrt(True)| <= 66b-59 /\ |root -/ sqrt(True)| <= 130b-59 }
low ~ Low;
first - second ~ True;
difference ~ True;
sqrt(difference) ~ sqrt(True);
(first - second - True) / True ->
  ((first - (load - y * y)) / (load - y * y)) * (1 + Tail / True) - (second - Tail) / True { True <> 0, load - y * y <> 0 };
second - Tail -> (second - 2 * y * low) + 2 * y * (low - Low) - Low * Low;
load - y * y -> True + Tail;
