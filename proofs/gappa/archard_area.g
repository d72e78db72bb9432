# SPDX-License-Identifier: GPL-3.0-or-later
# (7.18) K_n (G sqrt(load))^-(2^-n) load G^-(n-1) in binary64, paper/archard.hpp, area, the last power as two halves; away from the ends of
# the range. Assumed: `K` within 4 units 2^-53 (K_by_series says 2 ulp); both powers of the C library within one ulp, at most 2^-52 relative
# (`Half`, of exact arguments, and `Rest`, of a product that is 2.02 units off, of which the exponent 2^-n <= 1 leaves at most that:
# `RestOfProduct`). Before the last rounding the value is within 15.04 units 2^-53: at most 15.54 ulp, and the library's powers are most of
# it.
# lib/touchstone/paper/archard.hpp:
#   const T half = pow(G, T(integer<T>(1 - n) / 2));
#   const T rest = pow(T(G * sqrt(load)), T(-power_of_two<T>(-n)));
#   return K_n * rest * half * load * half;
@rnd = float<ieee_64, ne>;
product = rnd(G * rnd(sqrt(load)));
z = rnd(rnd(rnd(K * rest) * half) * load) * half;
a = rnd(z);
True = KTrue * Rest * Half * load * Half;
{ load in [1b-300, 1b300] /\ G in [1, 1b100] /\ KTrue in [0.39, 0.64] /\ Half in [1b-200, 1] /\ Rest in [1b-100, 1b100]
  /\ |K -/ KTrue| <= 1b-51 /\ |half -/ Half| <= 1b-52 /\ |RestOfProduct -/ Rest| <= 129b-59 /\ |rest -/ RestOfProduct| <= 1b-52 ->
  |product -/ (G * sqrt(load))| <= 129b-59 /\ |z -/ True| <= 962b-59 /\ |a -/ True| <= 1026b-59 }
rest ~ Rest;
