# SPDX-License-Identifier: GPL-3.0-or-later
# C = 1 - s + s log s in binary64, paper/gap.hpp, mean_gap, for 1/4 <= s < 1, as e^2 times a series of positive terms in t = (1 - sqrt s)/(1
# + sqrt s), e = 1 - s. Assumed: `sum` within 2.97 units 2^-53, what gap_series.g proves (m is at most 1/9, and within 13.6 units as it
# wants). No function of the C library but the root is called. Before the last rounding the value is within 6.99 units 2^-53.
# lib/touchstone/paper/gap.hpp:
#   const double root = 1 + std::sqrt(1 - e), t = e / (root * root), m = t * t;
#   return (1 + t * (1 + (1 - m) * sum_of_powers(gap_terms, m))) / 2;
#   return e * e * detail::mean_gap_series(e);
@rnd = float<ieee_64, ne>;
e = rnd(1 - s);
root = rnd(1 + rnd(sqrt(rnd(1 - e))));
t = rnd(e / rnd(root * root));
m = rnd(t * t);
series = rnd(1 + rnd(t * rnd(1 + rnd(rnd(1 - m) * sum)))) * 0.5;
z = rnd(e * e) * series;
E = 1 - s;
Root = 1 + sqrt(1 - E);
T = E / (Root * Root);
M = T * T;
Series = (1 + T * (1 + (1 - M) * Sum)) * 0.5;
True = E * E * Series;
{ s in [0.25, 1] /\ E in [1b-53, 0.75] /\ Sum in [0.33, 0.36] /\ |sum -/ Sum| <= 190b-59 ->
  |m -/ M| <= 867b-59 /\ |z -/ True| <= 447b-59 /\ |rnd(z) -/ True| <= 511b-59 }
e ~ E;
1 - e ~ 1 - E;
rnd(1 - e) ~ 1 - E;
sqrt(rnd(1 - e)) ~ sqrt(1 - E);
sum ~ Sum;
