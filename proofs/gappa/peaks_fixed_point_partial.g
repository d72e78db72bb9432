# SPDX-License-Identifier: GPL-3.0-or-later
# (5.8) (2/G)(2/G) in binary64, paper/peaks.hpp: three roundings, (1 + 2^-53)^3 - 1 < 3 2^-53 (1 + 2^-51).
# lib/touchstone/paper/peaks.hpp:
#   [](const T& g) -> T { return (2 / g) * (2 / g); });
@rnd = float<ieee_64, ne>;
quotient = rnd(2 / G);
square = rnd(quotient * quotient);
{ G in [2, 1b400] -> |square -/ ((2 / G) * (2 / G))| <= 0x3.0000000000003p-53 }
