# SPDX-License-Identifier: GPL-3.0-or-later
# sqrt(a^2 + b^2) in binary64 where neither square comes near the ends of the range: two roundings of positive terms, which the root halves,
# and its own. Before its own the root is within 1.01 units 2^-53, so that the value is within 1.51 ulp. Nothing is assumed.
# lib/touchstone/scalar/scalar.hpp:
#   const double square = a * a + b * b;
#   return square > 0x1p-900 && square < 0x1p900 ? std::sqrt(square) : std::hypot(a, b);
@rnd = float<ieee_64, ne>;
square = rnd(rnd(a * a) + rnd(b * b));
R = rnd(sqrt(square));
{ a in [1b-400, 1b400] /\ b in [1b-400, 1b400] ->
  |sqrt(square) -/ sqrt(a * a + b * b)| <= 65b-59 /\ |R -/ sqrt(a * a + b * b)| <= 130b-59 }
square ~ a * a + b * b;
