# SPDX-License-Identifier: GPL-3.0-or-later
# y^2 - sin^2 y = y^4 (1/3 - 2 y^2/45 + ...) in binary64, y = pi x, 0 < x <= 1/4, by ten terms of its series; scalar.hpp, minus_sin_square.
# Assumed: the ten terms with their rounded coefficients are within 2^-53 of (y^2 - sin^2 y)/y^4, `Series`, relatively (the first left out
# is below 2^-64). Bound: 12.5 units 2^-53, of which 8.5 are the square's that is squared again.
# lib/touchstone/scalar/scalar.hpp:
#   const double z = (std::numbers::pi * x) * (std::numbers::pi * x);
#   return minus_pi_square(a, x) + z * z * sum_of_powers(sine_terms, z);
#   even = even * square + terms[j - 2];
#   odd = odd * square + terms[j - 1];
#   return even + x * odd;
@rnd = float<ieee_64, ne>;
P = 0x1.921fb54442d18p1;
t0 = 0x1.5555555555555p-2;
t1 = -0x1.6c16c16c16c16p-5;
t2 = 0x1.a01a01a01a019p-9;
t3 = -0x1.27e4fb7789f5cp-13;
t4 = 0x1.1eed8eff8d897p-18;
t5 = -0x1.93974a8c07c9dp-24;
t6 = 0x1.ae7f3e733b81fp-30;
t7 = -0x1.6827863b97d98p-36;
t8 = 0x1.e542ba4020226p-43;
t9 = -0x1.0ce396db7f853p-49;
y = rnd(P * x);
z = rnd(y * y);
square = rnd(z * z);
even rnd= (((t8 * square + t6) * square + t4) * square + t2) * square + t0;
odd rnd= (((t9 * square + t7) * square + t5) * square + t3) * square + t1;
sum = rnd(even + rnd(z * odd));
rest = rnd(rnd(z * z) * sum);
Z = (Pi * x) * (Pi * x);
Square = Z * Z;
Even = (((t8 * Square + t6) * Square + t4) * Square + t2) * Square + t0;
Odd = (((t9 * Square + t7) * Square + t5) * Square + t3) * Square + t1;
{ x in [1b-30, 0.25] /\ Pi in [3.14159265358979323846, 3.14159265358979323847]
  /\ Series in [0.25, 0.34] /\ |Even + Z * Odd -/ Series| <= 1b-53 -> |rest -/ ((Z * Z) * Series)| <= 795b-59 }
sum ~ Even + Z * Odd;
sum ~ Series;
