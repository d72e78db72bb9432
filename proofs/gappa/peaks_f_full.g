# SPDX-License-Identifier: GPL-3.0-or-later
# (5.4) 1 + x in binary64, paper/peaks.hpp: one rounding.
# lib/touchstone/paper/peaks.hpp:
#   [](const T& s) -> T { return 1 + s; });
@rnd = float<ieee_64, ne>;
sum = rnd(1 + x);
{ x in [1, 1b1000] -> |sum -/ (1 + x)| <= 1b-53 }
