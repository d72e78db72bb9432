# SPDX-License-Identifier: GPL-3.0-or-later
# (2.4) 2 cos(pi x) sqrt(load - sin^2(pi x)) in binary64, paper/westergaard.hpp, pressure_partial, where the difference under the root is
# from 1/4 to 0.49. Nearer the edge the first term of the bound grows like 1.11/difference, as what the inputs' rounding does to the value.
# Assumed: the difference within 2.22 units 2^-53, absolutely, what westergaard_difference.g proves; the cosine within 3.88 units, what
# cos_pi.g proves for a library's sine within one ulp (`c6`: 3.08 for one within 0.6 ulp). Before the last rounding the value is within 9.33
# (8.54) units 2^-53.
# lib/touchstone/paper/westergaard.hpp:
#   return 2 * (cos_pi(x) * sqrt_minus_sin_pi_square(load, x));
# lib/touchstone/scalar/scalar.hpp:
#   return sqrt_positive_part(far ? -difference : difference);
@rnd = float<ieee_64, ne>;
root = rnd(sqrt(difference));
p = 2 * rnd(c * root);
{ True in [0.25, 0.49] /\ C in [0.5, 1] /\ |difference - True| <= 142b-59 /\ |c -/ C| <= 248b-59 /\ |c6 -/ C| <= 197b-59 ->
  |c * root -/ (C * sqrt(True))| <= 597b-59 /\ |c6 * root -/ (C * sqrt(True))| <= 546b-59 /\ |p -/ (2 * (C * sqrt(True)))| <= 661b-59 }
difference ~ True;
sqrt(difference) ~ sqrt(True);
c * root ~ C * sqrt(True);
c6 * root ~ C * sqrt(True);
