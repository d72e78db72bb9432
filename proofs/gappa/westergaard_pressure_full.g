# SPDX-License-Identifier: GPL-3.0-or-later
# (2.2) (load - 1) + 2 cos^2(pi x) in binary64, paper/westergaard.hpp, pressure_full, load > 1: a sum of positive terms (load = 1 leaves the
# second). Assumed: the cosine `c` within 3.88 units 2^-53, what cos_pi.g proves for a library's sine within one ulp (`c6`: 3.08 for one
# within 0.6 ulp). Before the last rounding the value is within 8.77 (7.17) units 2^-53. The program's cosine is nearer most of the time:
# the bound adds the worst of all.
# lib/touchstone/paper/westergaard.hpp:
#   const T c = cos_pi(x);
#   return (load - 1) + 2 * (c * c);
@rnd = float<ieee_64, ne>;
square = rnd(c * c);
square6 = rnd(c6 * c6);
z = rnd(load - 1) + 2 * square;
z6 = rnd(load - 1) + 2 * square6;
p = rnd(z);
{ load in [1, 1b900] /\ load - 1 in [1b-52, 1b900] /\ C in [1b-500, 1] /\ |c -/ C| <= 248b-59 /\ |c6 -/ C| <= 197b-59 ->
  |z -/ ((load - 1) + 2 * (C * C))| <= 561b-59 /\ |z6 -/ ((load - 1) + 2 * (C * C))| <= 459b-59 /\ |p -/ ((load - 1)
  + 2 * (C * C))| <= 625b-59 }
square ~ C * C;
square6 ~ C * C;
