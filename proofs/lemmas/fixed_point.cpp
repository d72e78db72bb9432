// SPDX-License-Identifier: GPL-3.0-or-later
#include "proofs/lemmas/fixed_point.hpp"

#include "proofs/symbolic/symbolic.hpp"

namespace touchstone::proofs {

Check unique_fixed_point(const ex& above, const ex& below)
{
    // each difference that must be positive is written out, in symbols that are: a bare inequality could be weakened unseen
    const ex x = sym("x"), y = sym("y"), u = sym("u"), G = sym("G");
    const ex low = below.subs(x == y * y) / G; // h(y^2), 0 < y <= 1
    const ex high = above / G;                 // h(x), x >= 1
    const Points g{"G=3 y=1/2 x=3/2 u=1/2", "G=3/2 y=1/2 x=7/4 u=1/3"};
    const ex x_P = 4 / (G * G), x_F = 1 / (G - 1);
    // v in (0, 1), i.e. G = 2/(1 + v) in (1, 2), as v = 1/(1 + u)
    const ex G_below_2 = 2 / (1 + 1 / (1 + u));
    for (const Check& check : {
             identity(above.subs(x == 1), below.subs(x == 1), g),                 // f is continuous at 1
             identity(low * low, y * y * x_P, g),                                 // G >= 2, x <= 1: h(x)^2 = x x_P
             identity(x_P.subs(G == 2 + u) - 1, -u * (4 + u) / pow(2 + u, 2), g), // ... and x_P <= 1
             identity(x - high.subs(G == 2), (x - 1) / 2, g),                     // G >= 2, x > 1: h(x) <= (1 + x)/2 < x (h decreases in G)
             identity((high.subs(x == 1) - x_P).subs(G == 2 + u), 2 * u / pow(2 + u, 2), g),            // ... h(1) >= x_P
             identity(high.subs(x == 1 + u) - high.subs(x == 1), u / G, g),                             // ... h increases
             identity(high - x_F, (x - x_F) / G, g),                                                    // G < 2, x >= 1
             identity((x_F - 1).subs(G == G_below_2), 2 / u, g),                                        // ... x_P > 1
             identity(low.subs(G == G_below_2) / y - 1, 1 / (1 + u), g),                                // G < 2, x < 1: h(x) > sqrt(x)
             identity((x_F - below.subs(x == 1) / G).subs(G == G_below_2), (2 + u) / (u * (1 + u)), g), // ... h(1) < x_P
         })
        if (check.verdict != Verdict::proved) return check;
    return as_lemma({Verdict::proved, "ten identities by normal form, from which each inequality is read off, G >= 2 and 1 < G < 2, x >= 1 "
                                      "and x < 1 (fixed_point.hpp)"});
}

} // namespace touchstone::proofs
