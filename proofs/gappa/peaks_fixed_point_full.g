# SPDX-License-Identifier: GPL-3.0-or-later
# (5.9) 1/(G - 1) in binary64, paper/peaks.hpp, for G = 1 + 2^-40 to 2: two roundings at most (the difference is in fact exact).
@rnd = float<ieee_64, ne>;
difference = rnd(G - 1);
inverse = rnd(1 / difference);
{ G in [1.000000000001, 2] -> |inverse -/ (1 / (G - 1))| <= 0x2.0000000000003p-53 }
