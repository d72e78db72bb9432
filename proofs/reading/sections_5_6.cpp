// SPDX-License-Identifier: GPL-3.0-or-later
/// What the symbols of sections 5 and 6 stand for: the peaks' iteration, and the law of the pressure at scale n given that at scale n - 1.
#include "proofs/reading/reading.hpp"

#include "touchstone/paper/peaks.hpp"
#include "touchstone/paper/westergaard.hpp"

namespace touchstone::proofs {

namespace {

Rational q(long a, long b) { return Rational(a, b); }

/// G = gamma^(D-1) with D = 3/2 or 5/4, so that gamma is rational.
Situation peaks_at(const Rational& G, bool flat, const Rational& load, long n)
{
    Situation s;
    const Ball g(G), gamma = flat ? g * g * g * g : g * g;
    s["gamma"] = gamma;
    s["D"] = Ball(flat ? q(5, 4) : q(3, 2));
    const Ball pstar_0(q(3, 7));
    const auto pstar = [&](long k) { return pstar_0 * pow(g, Ball(k)); };
    const auto x = [&](long k) { return k < 0 ? Ball(load) : peaks::iterate(k, Ball(load), g); };
    s["pstar_0"] = pstar_0;
    s["pbar"] = Ball(load) * pstar_0;
    s["ptilde"] = Ball(load);
    s["pstar_n"] = pstar(n);
    s["pstar_np1"] = pstar(n + 1);
    s["x_n"] = x(n);
    s["x_nm1"] = x(n - 1);
    s["pmax_n"] = pstar(n) * westergaard::peak_pressure(x(n - 1));
    s["pmax_nm1"] = n > 0 ? pstar(n - 1) * westergaard::peak_pressure(x(n - 2)) : Ball(load) * pstar_0;
    s["x_P"] = peaks::fixed_point(g);
    s["x"] = s["x_P"];
    s.function["f"] = [](const Ball& at) { return peaks::f(at); };
    s.large_n = n > 30;
    return s;
}

Meaning over_peaks()
{
    Meaning m;
    for (const Rational& G : {q(3, 2), q(19, 10), q(21, 10), q(3, 1), q(5, 1)})
        for (const bool flat : {false, true})
            for (const Rational& load : {q(1, 9), q(5, 2)})
                for (const long n : {0L, 1L, 3L, 90L}) m.situations.push_back(peaks_at(G, flat, load, n));
    return m;
}

Meaning over_x()
{
    Meaning m;
    for (const Rational& x :
         {q(0, 1), q(1, 1), q(1, 50), q(1, 3), q(9, 10), q(99, 100), q(101, 100), q(11, 10), q(3, 2), q(19, 10), q(21, 10), q(5, 1)}) {
        Situation s;
        s.at_equality = x == 0 || x == 1;
        s["x"] = Ball(x);
        s["f"] = peaks::f(Ball(x));
        m.situations.push_back(s);
    }
    return m;
}

/// "x_P is below the bound" as a condition on G.
Meaning threshold(const Rational& bound, const std::vector<Rational>& Gs)
{
    Meaning m;
    m.stated = {0};
    for (const Rational& G : Gs)
        for (const bool flat : {false, true}) {
            Situation s = peaks_at(G, flat, q(1, 9), 1);
            s.wanted = certainly(less(s["x_P"], Ball(bound)));
            m.situations.push_back(s);
        }
    return m;
}

/// "Every x_n stays below the bound" as a condition on the load.
Meaning load_threshold(std::size_t part, const Rational& bound, const Rational& G, const std::vector<Rational>& loads)
{
    Meaning m;
    m.stated = {part};
    for (const Rational& load : loads) {
        Situation s = peaks_at(G, false, load, 1);
        bool below = certainly(less(Ball(load), Ball(bound)));
        for (long n = 0; n < 8; ++n) below = below && certainly(less(peaks::iterate(n, Ball(load), Ball(G)), Ball(bound)));
        s.wanted = below;
        m.situations.push_back(s);
    }
    return m;
}

/// One pressure y = p_{n-1} of the scale before, one pressure p_n, in units of p*_n.
Situation law(const Rational& p, const Rational& y, const Ball& pstar = Ball(q(5, 3)))
{
    Situation s;
    const Ball before(q(3, 11)), lambda(q(7, 5)), L(q(9, 4));
    s["pstar_n"] = pstar;
    s["p_n"] = Ball(p) * pstar;
    s["p_nm1"] = Ball(y) * pstar;
    s["q_nm1"] = before;
    const Ball density = westergaard::density(Ball(p), Ball(y)) / pstar;
    s["q"] = density;
    s["q_n"] = density * before;
    s["I1"] = y < 1 ? Ball(density * before) : Ball(0);
    s["I2"] = y < 1 ? Ball(0) : Ball(density * before);
    const Ball share = y < 1 ? Ball(2 * westergaard::half_width(Ball(y))) : Ball(1);
    s["lambda"] = lambda;
    s["a"] = share * lambda / 2;
    s["L"] = L;
    s["A_n"] = L * share * before;
    s["x"] = Ball(q(1, 9));
    s["p_0"] = Ball(q(2, 9));
    s["pstar_0"] = Ball(q(4, 7));
    s["pbar"] = Ball(q(3, 8));
    s["ptilde"] = s["pbar"] / s["pstar_0"];
    s.pointwise = "p_nm1";
    return s;
}

Meaning over_pressures(const std::vector<Rational>& ps)
{
    Meaning m;
    for (std::size_t i = 0; i < ps.size(); ++i) {
        const Rational& p = ps[i];
        std::vector<Rational> ys;
        for (Rational y = q(1, 101); y < 6; y += y < 2 ? q(7, 101) : q(33, 101)) ys.push_back(y);
        for (const Rational& end : {Rational(p * p / 4), q(1, 1), Rational(p - 1), Rational(p + 1)}) // beside every end of the support
            for (const Rational& side : {q(99, 100), q(101, 100)})
                if (end > 0) ys.push_back(Rational(end * side));
        for (const Rational& y : ys) {
            m.situations.push_back(law(p, y));
            m.situations.back().group = i;
        }
    }
    return m;
}

} // namespace

void add_meanings_of_sections_5_6(std::map<std::string, Meaning>& all)
{
    Meaning substituted;
    for (const auto& [p, y] : {std::pair{q(1, 2), q(1, 3)}, std::pair{q(3, 2), q(9, 4)}}) {
        Situation s = law(p, y);
        s["p"] = s["p_n"]; // the symbols of section 2 at scale n
        s["pbar"] = s["p_nm1"];
        s["pstar"] = s["pstar_n"];
        substituted.situations.push_back(s);
    }
    all["5.1"] = substituted;
    all["5.2"] = all["5.3"] = all["5.6"] = all["5.7"] = all["5.8"] = all["5.9"] = all["5.10"] = over_peaks();
    for (const char* id : {"5.8", "5.9"}) {
        for (const bool flat : {false, true}) {
            all[id].situations.push_back(peaks_at(q(2, 1), flat, q(1, 9), 1));
            all[id].situations.back().at_equality = true;
        }
        for (Situation& s : all[id].situations) s.value.erase("x");
    }
    all["5.4"] = all["5.5"] = over_x();
    all["5.11"] =
        threshold(q(1, 5), {q(11, 10), q(2, 1), q(4, 1), q(43, 10), q(441, 100), q(446, 100), q(448, 100), q(453, 100), q(5, 1), q(21, 1)});
    all["5.12"] =
        load_threshold(1, q(1, 5), q(5, 1), {q(1, 100), q(11, 100), q(19, 100), q(199, 1000), q(201, 1000), q(21, 100), q(3, 10), q(5, 2)});
    all["5.13"] = threshold(q(1, 1), {q(11, 10), q(3, 2), q(19, 10), q(199, 100), q(201, 100), q(21, 10), q(3, 1), q(5, 1)});
    all["5.14"] = load_threshold(0, q(1, 1), q(3, 1), {q(1, 100), q(1, 2), q(9, 10), q(99, 100), q(101, 100), q(11, 10), q(3, 2), q(5, 1)});
    const std::vector<Rational> pressures{q(1, 5), q(1, 2), q(9, 10), q(11, 10), q(3, 2), q(19, 10), q(21, 10), q(5, 2), q(7, 2)};
    for (const char* id : {"6.1", "6.2", "6.3", "6.4", "6.5"}) all[id] = over_pressures(pressures);
    for (const char* id : {"6.2", "6.3", "6.4", "6.5"})
        for (const Rational& y : {q(1, 5), q(4, 5), q(6, 5), q(5, 2), q(7, 2)}) {
            all[id].situations.push_back(law(q(2, 1), y));
            all[id].situations.back().at_equality = true;
        }
    for (const char* id : {"6.6", "6.7"}) all[id] = over_pressures({q(1, 2)});
    for (Situation& s : all["6.6"].situations) s.group.reset();
    all["6.6"].situations.push_back(law(q(1, 2), q(1, 1), Ball(2))); // p*_n a power of two: the quotient is 1 and not a ball around it
    all["6.6"].situations.back().at_equality = true;
    Meaning names;
    names.situations = {law(q(1, 2), q(1, 3))};
    all["6.8"] = names;
}

} // namespace touchstone::proofs
