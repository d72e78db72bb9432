# SPDX-License-Identifier: GPL-3.0-or-later
# (7.21) K_inf G^-(n-1) load in binary64, paper/archard.hpp, area_limit, away from the ends of the range. Assumed: `K` within 4 units 2^-53
# (K_by_series says 2 ulp), and the C library's power, `power`, of exact arguments within one ulp, at most 2^-52 relative. Before the last
# rounding the value is within 7.02 units 2^-53.
# lib/touchstone/paper/archard.hpp:
#   return K_inf * pow(G, integer<T>(1 - n)) * load;
@rnd = float<ieee_64, ne>;
z = rnd(K * power) * load;
{ load in [1b-300, 1b300] /\ KTrue in [0.39, 0.4] /\ Power in [1b-400, 1] /\ |K -/ KTrue| <= 1b-51 /\ |power -/ Power| <= 1b-52 ->
  |z -/ (KTrue * Power * load)| <= 449b-59 /\ |rnd(z) -/ (KTrue * Power * load)| <= 513b-59 }
