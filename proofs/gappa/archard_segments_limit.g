# SPDX-License-Identifier: GPL-3.0-or-later
# (8.3) K_inf gamma^((2-D)n/2) (gamma^(2(D-1)) load) gamma^((2-D)n/2) in binary64, paper/segments.hpp, segments_limit, away from the ends of
# the range. Assumed: `K` within 4 units 2^-53 (K_by_series says 2 ulp), `half` within 4.02, what archard_segments.g proves of pow_product,
# and the C library's power, `first`, of an exact exponent within one ulp, at most 2^-52 relative. Before the last rounding the value is
# within 17.1 units 2^-53.
# lib/touchstone/paper/segments.hpp:
#   const T half = pow_product(gamma, T(2 - D), T(integer<T>(n) / 2));
#   return K_inf * half * (pow(gamma, T(2 * (D - 1))) * load) * half;
@rnd = float<ieee_64, ne>;
z = rnd(rnd(K * half) * rnd(first * load)) * half;
True = KTrue * Half * (First * load) * Half;
{ load in [1b-200, 1b200] /\ KTrue in [0.39, 0.4] /\ Half in [1, 1b150] /\ First in [1, 1b150]
  /\ |K -/ KTrue| <= 1b-51 /\ |half -/ Half| <= 257b-59 /\ |first -/ First| <= 1b-52 ->
  |z -/ True| <= 1091b-59 /\ |rnd(z) -/ True| <= 1155b-59 }
