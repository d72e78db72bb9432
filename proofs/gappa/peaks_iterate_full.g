# SPDX-License-Identifier: GPL-3.0-or-later
# (5.6) one step (1 + x)/G in binary64, paper/peaks.hpp, iterate, where x >= 1, on x that is within e units 2^-53, e <= 4.1: the two
# roundings add 2.02 units to e x/(1 + x). Steps with x <= 3 stay within 8.1 units, since 8.1 * 3/4 + 2.02 <= 8.1. Nothing is assumed.
# lib/touchstone/paper/peaks.hpp:
#   [](const T& s) -> T { return 1 + s; });
#   for (long k = 0; k <= n; ++k) x = f(x) / G;
@rnd = float<ieee_64, ne>;
z = rnd(1 + x) / G;
{ X in [1, 3] /\ G in [1, 1b300] /\ |x -/ X| <= 518b-59 -> |rnd(z) -/ ((1 + X) / G)| <= 518b-59 }
1 + x ~ 1 + X;
1 + X -> 4 - (3 - X);
