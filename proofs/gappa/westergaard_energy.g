# SPDX-License-Identifier: GPL-3.0-or-later
# s^2 (1 - 2 log s)/4 in binary64, paper/gap.hpp, energy, for s < 1; the last division is exact but among subnormal numbers. Assumed: the C
# library's logarithm, `L`, is within one ulp, at most 2^-52 relative (`L6`: 0.6 ulp). Before the
# last rounding the value is within 4.02 (3.22) units 2^-53, so that it is within 4.52 (3.72) ulp.
# lib/touchstone/paper/gap.hpp:
#   return s * (s * (1 - 2 * log(s))) / 4; // in this order: s * s alone may underflow
@rnd = float<ieee_64, ne>;
z = s * rnd(s * rnd(1 - 2 * L));
z6 = s * rnd(s * rnd(1 - 2 * L6));
u = rnd(z) * 0.25;
True = s * (s * (1 - 2 * Log));
{ s in [1b-400, 1] /\ Log in [-800, -1b-54] /\ |L -/ Log| <= 1b-52 /\ |L6 -/ Log| <= 77b-59 ->
  |z -/ True| <= 257b-59 /\ |z6 -/ True| <= 206b-59 /\ |u -/ (True * 0.25)| <= 321b-59 }
1 - 2 * L ~ 1 - 2 * Log;
1 - 2 * L6 ~ 1 - 2 * Log;
rnd(z) ~ True;
