// SPDX-License-Identifier: GPL-3.0-or-later
#include "proofs/lemmas/elasticity.hpp"

#include "proofs/symbolic/symbolic.hpp"

namespace touchstone::proofs {

ex displacement_of_pressure(const ex& pressure, const ex& k)
{
    return 2 * (1 - pow(sym("nu"), 2)) / (sym("E") * k) * pressure;
}

ex amplitude_of_pressure(const ex& displacement_amplitude, const ex& k)
{
    return displacement_amplitude * sym("E") * k / (2 * (1 - pow(sym("nu"), 2)));
}

Check half_plane_mode()
{
    using GiNaC::ex_to;
    const GiNaC::symbol& x = ex_to<GiNaC::symbol>(sym("x"));
    const GiNaC::symbol& y = ex_to<GiNaC::symbol>(sym("y"));
    const ex c = sym("c"), k = sym("k"), nu = sym("nu"), E = sym("E");
    const ex decay = exp(-k * y), wave = cos(k * x);
    const ex airy = c / (k * k) * (1 + k * y) * decay * wave;
    const ex stress_xx = airy.diff(y, 2), stress_yy = airy.diff(x, 2), stress_xy = -airy.diff(x).diff(y);
    const ex u = (1 + nu) * c / (E * k) * (2 * nu - 1 + k * y) * decay * sin(k * x); // along the surface
    const ex v = (1 + nu) * c / (E * k) * (2 * (1 - nu) + k * y) * decay * wave;     // into the body
    const ex hooke_xx = (1 + nu) / E * ((1 - nu) * stress_xx - nu * stress_yy);
    const ex hooke_yy = (1 + nu) / E * ((1 - nu) * stress_yy - nu * stress_xx);
    const ex hooke_xy = 2 * (1 + nu) / E * stress_xy;
    const Points at{"x=1/3 y=1/2 c=2 k=3 nu=1/4 E=5"};
    for (const Check& check : {
             identity(u.diff(x), hooke_xx, at),
             identity(v.diff(y), hooke_yy, at),
             identity(u.diff(y) + v.diff(x), hooke_xy, at),
             identity(stress_yy.subs(sym("y") == 0), -c * wave, at),
             identity(stress_xy.subs(sym("y") == 0), 0, at),
             identity(v.subs(sym("y") == 0), displacement_of_pressure(c * wave, k), at),
         })
        if (check.verdict != Verdict::proved) return check;
    return as_lemma({Verdict::proved, "six identities by normal form; the stresses come from an Airy function and vanish at depth"});
}

} // namespace touchstone::proofs
