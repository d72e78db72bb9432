# SPDX-License-Identifier: GPL-3.0-or-later
# (8.2) K L^-(2^-n) gamma^((2-D)n/2) L gamma^((2-D)n/2), L = gamma^(2(D-1)) load, in binary64, paper/segments.hpp, segments; 2 - D and n/2
# are exact. Assumed: `K` within 4 units 2^-53 (K_by_series says 2 ulp); the powers of the C library and its logarithm within one ulp, at
# most 2^-52 relative. The rounded exponent e of the half power leaves out t = (ab - e) log gamma, of which pow_product puts back 1 + t:
# exp(t), `Correction`, is that to 2^-80 as |t| < 2^-43. The exponent 2^-n <= 1 leaves of L's 3.02 units at most that (`RestOfL`). Before
# the last rounding the value is within 23.04 units 2^-53.
# lib/touchstone/paper/segments.hpp:
#   const T half = pow_product(gamma, T(2 - D), T(integer<T>(n) / 2));
#   const T L = pow(gamma, T(2 * (D - 1))) * load;
#   return K_before * pow(L, T(-power_of_two<T>(-n))) * half * L * half;
# lib/touchstone/scalar/scalar.hpp:
#   const double e = a * b;
#   return std::pow(x, e) * (1.0 + std::fma(a, b, -e) * std::log(x));
@rnd = float<ieee_64, ne>;
e = rnd(a * b);
correction = rnd(1 + rnd(rnd(a * b - e) * Lg));
half = rnd(power * correction);
L = rnd(first * load);
z = rnd(rnd(rnd(K * rest) * half) * L) * half;
t = (a * b - e) * Log;
True = KTrue * Rest * (PowerOfE * Correction) * (First * load) * (PowerOfE * Correction);
{ a in [1b-52, 1] /\ b in [0.5, 1b40] /\ a * b in [1b-53, 1b9] /\ Log in [1b-52, 710] /\ |Lg -/ Log| <= 1b-52
  /\ load in [1b-200, 1b200] /\ PowerOfE in [1, 1b150] /\ First in [1, 1b150] /\ Rest in [1b-100, 1b100] /\ KTrue in [0.39, 0.64]
  /\ |Correction -/ (1 + t)| <= 1b-80
  /\ |K -/ KTrue| <= 1b-51 /\ |power -/ PowerOfE| <= 1b-52 /\ |first -/ First| <= 1b-52 /\ |RestOfL -/ Rest| <= 193b-59
  /\ |rest -/ RestOfL| <= 1b-52 ->
  |half -/ (PowerOfE * Correction)| <= 257b-59 /\ |L -/ (First * load)| <= 193b-59 /\ |z -/ True| <= 1474b-59 }
rest ~ Rest;
correction ~ 1 + t;
1 + t ~ Correction;
correction ~ Correction;
