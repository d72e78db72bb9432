# SPDX-License-Identifier: GPL-3.0-or-later
# sum m^j/((2j + 1)(2j + 3)) in binary64 by sixteen terms, paper/gap.hpp, gap_terms, for m <= 1/8 that is within 13.6 units 2^-53 of `M`.
# Assumed: the sixteen terms with their rounded coefficients are within 2^-53 of the infinite sum, relatively (what they leave out is below
# 2^-57). Nothing of the C library is called. Bound: 2.97 units 2^-53.
# lib/touchstone/scalar/scalar.hpp:
#   even = even * square + terms[j - 2];
#   odd = odd * square + terms[j - 1];
#   return even + x * odd;
# lib/touchstone/paper/gap.hpp:
#   for (int j = 0; j < 16; ++j) terms[static_cast<std::size_t>(j)] = 1.0 / ((2 * j + 1) * (2 * j + 3));
@rnd = float<ieee_64, ne>;
t0 = 0x1.5555555555555p-2;
t1 = 0x1.1111111111111p-4;
t2 = 0x1.d41d41d41d41dp-6;
t3 = 0x1.0410410410410p-6;
t4 = 0x1.4afd6a052bf5bp-7;
t5 = 0x1.ca4b3055ee191p-8;
t6 = 0x1.5015015015015p-8;
t7 = 0x1.0101010101010p-8;
t8 = 0x1.95cbb0be377aep-9;
t9 = 0x1.4880522014880p-9;
t10 = 0x1.0f5edfab325a2p-9;
t11 = 0x1.c7e7115d0ce95p-10;
t12 = 0x1.845c8a0ce5129p-10;
t13 = 0x1.4ecb5c86b3d24p-10;
t14 = 0x1.239858d86b11fp-10;
t15 = 0x1.0040100401004p-10;
square = rnd(m * m);
even rnd= ((((((t14 * square + t12) * square + t10) * square + t8) * square + t6) * square + t4) * square + t2) * square + t0;
odd rnd= ((((((t15 * square + t13) * square + t11) * square + t9) * square + t7) * square + t5) * square + t3) * square + t1;
sum = rnd(even + rnd(m * odd));
Square = M * M;
Even = ((((((t14 * Square + t12) * Square + t10) * Square + t8) * Square + t6) * Square + t4) * Square + t2) * Square + t0;
Odd = ((((((t15 * Square + t13) * Square + t11) * Square + t9) * Square + t7) * Square + t5) * Square + t3) * Square + t1;
{ M in [0, 0.125] /\ |m -/ M| <= 867b-59 /\ Sum in [0.33, 0.36] /\ |Even + M * Odd -/ Sum| <= 1b-53 -> |sum -/ Sum| <= 190b-59 }
sum ~ Even + M * Odd;
sum ~ Sum;
