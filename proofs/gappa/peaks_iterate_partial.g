# SPDX-License-Identifier: GPL-3.0-or-later
# (5.6) one step 2 sqrt(x)/G in binary64, paper/peaks.hpp, iterate, where x <= 1: of an error within 4.1 units 2^-53 of x it makes one
# within 4.1 units. So any number of such steps from an exact load stays within 4.1 units, and within 3.56 ulp, as the last rounding is half
# an ulp. Nothing is assumed.
# lib/touchstone/paper/peaks.hpp:
#   [](const T& s) -> T { return 2 * sqrt(s); },
#   for (long k = 0; k <= n; ++k) x = f(x) / G;
@rnd = float<ieee_64, ne>;
z = 2 * rnd(sqrt(x)) / G;
{ X in [1b-600, 1] /\ G in [1, 1b300] /\ |x -/ X| <= 262b-59 ->
  |z -/ (2 * sqrt(X) / G)| <= 196b-59 /\ |rnd(z) -/ (2 * sqrt(X) / G)| <= 262b-59 }
sqrt(x) ~ sqrt(X);
