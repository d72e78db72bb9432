# SPDX-License-Identifier: GPL-3.0-or-later
# (7.16) 1 - 2^-(n+1) in binary64, paper/archard.hpp, delta: exact up to n = 52, then one rounding. `h` is 2^-(n+1). Nothing is assumed.
# lib/touchstone/paper/archard.hpp:
#   return 1 - power_of_two<T>(-(n + 1));
@rnd = float<ieee_64, ne>;
{ h in [0, 0.5] -> |rnd(1 - h) -/ (1 - h)| <= 1b-53 }
