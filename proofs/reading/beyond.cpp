// SPDX-License-Identifier: GPL-3.0-or-later
/// The gap around the contact, its mean and the elastic energy, as the library computes them.
#include "proofs/reading/reading.hpp"

#include "touchstone/paper/gap.hpp"

namespace touchstone::proofs {

void add_meanings_beyond(std::map<std::string, Meaning>& all)
{
    Meaning m;
    for (const Rational& load : {Rational(1, 20), Rational(1, 3), Rational(3, 5)})
        for (const Rational& x : {Rational(2, 5), Rational(9, 20)}) {
            Situation s;
            const Ball S(load), place(x);
            s["S"] = S;
            s["x"] = place;
            s["v"] = ScalarTraits<Ball>::sin_pi(place);
            s["slope"] = westergaard::gap_slope(place, S);
            s["gap"] = westergaard::gap(place, S);
            s["meangap"] = westergaard::mean_gap(S);
            s["energy"] = westergaard::energy(S);
            m.situations.push_back(s);
        }
    for (const char* id : {"beyond.slope", "beyond.gap", "beyond.mean-gap", "beyond.energy"}) all[id] = m;
}

} // namespace touchstone::proofs
