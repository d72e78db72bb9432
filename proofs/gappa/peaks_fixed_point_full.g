# SPDX-License-Identifier: GPL-3.0-or-later
# (5.9) 1/(G - 1) in binary64, paper/peaks.hpp, for G = 1 + 2^-40 to 2: the difference is exact, so that one rounding is left. Nothing is
# assumed.
# lib/touchstone/paper/peaks.hpp:
#   [](const T& g) -> T { return 1 / (g - 1); },
@rnd = float<ieee_64, ne>;
G = rnd(G0);
difference = rnd(G - 1);
inverse = rnd(1 / difference);
{ G in [1.000000000001, 2] -> difference - (G - 1) in [0, 0] /\ |inverse -/ (1 / (G - 1))| <= 1b-53 }
