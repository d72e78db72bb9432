# SPDX-License-Identifier: GPL-3.0-or-later
# (5.5) 2 sqrt(x) in binary64, paper/peaks.hpp: the root is within half an ulp (relative 2^-53), and doubling it is exact.
# lib/touchstone/paper/peaks.hpp:
#   [](const T& s) -> T { return 2 * sqrt(s); },
@rnd = float<ieee_64, ne>;
root = rnd(sqrt(x));
{ x in [1b-1000, 1] -> |root -/ sqrt(x)| <= 1b-53 }
