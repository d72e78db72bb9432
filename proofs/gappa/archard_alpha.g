# SPDX-License-Identifier: GPL-3.0-or-later
# (7.16) (1 - D)(n - 1 + 2^-n) in binary64, paper/archard.hpp, alpha, n from 1 to 2^50; `h` is 2^-n. Both differences are exact: D in (1, 2)
# is a multiple of 2^-52, and n an integer. Two roundings are left. Nothing is assumed.
# lib/touchstone/paper/archard.hpp:
#   return integer<T>(n - 1) + power_of_two<T>(-n);
#   return (1 - D) * decay_exponent<T>(n);
@rnd = float<ieee_64, ne>;
D = rnd(D0);
alpha = rnd(rnd(1 - D) * rnd(rnd(n - 1) + h));
{ D in [1, 2] /\ 1 - D in [-1, -1b-52] /\ @FIX(n, 0) /\ n in [1, 1b50] /\ h in [1b-1000, 0.5] /\ (n - 1) + h in [0.5, 1b51] ->
  rnd(1 - D) - (1 - D) in [0, 0] /\ rnd(n - 1) - (n - 1) in [0, 0] /\ |alpha -/ ((1 - D) * ((n - 1) + h))| <= 129b-59 }
