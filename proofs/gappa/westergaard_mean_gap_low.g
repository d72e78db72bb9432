# SPDX-License-Identifier: GPL-3.0-or-later
# 1 + s (log s - 1) in binary64, paper/gap.hpp, mean_gap, for s <= 1/4, where the second term is above -0.5966 (s (log s - 1) falls).
# Assumed: the C library's logarithm, `L`, is within one ulp, at most 2^-52 relative (`L6`: 0.6 ulp).
# The value, its last rounding included, is within 5.69 (4.5) units 2^-53.
# lib/touchstone/paper/gap.hpp:
#   [](const T& s) -> T { return 1 + s * (log(s) - 1); },
@rnd = float<ieee_64, ne>;
term = rnd(s * rnd(L - 1));
term6 = rnd(s * rnd(L6 - 1));
c = rnd(1 + term);
c6 = rnd(1 + term6);
True = 1 + s * (Log - 1);
{ s in [1b-1000, 0.25] /\ Log in [-800, -1.38] /\ s * (Log - 1) in [-0.5966, 0]
  /\ |L -/ Log| <= 1b-52 /\ |L6 -/ Log| <= 77b-59 ->
  |c -/ True| <= 364b-59 /\ |c6 -/ True| <= 288b-59 }
term ~ s * (Log - 1);
term6 ~ s * (Log - 1);
s * rnd(L - 1) ~ s * (Log - 1);
s * rnd(L6 - 1) ~ s * (Log - 1);
$ s * (Log - 1) in 32;
