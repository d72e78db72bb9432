// SPDX-License-Identifier: GPL-3.0-or-later
/// What the symbols of sections 2 and 3 stand for, from the library's formulas and the elastic half-plane.
#include "proofs/lemmas/elasticity.hpp"
#include "proofs/reading/reading.hpp"
#include "proofs/enclosure/enclosure.hpp"

#include "touchstone/paper/weierstrass.hpp"
#include "touchstone/paper/weierstrass_profile.hpp"
#include "touchstone/paper/peaks.hpp"
#include "touchstone/paper/westergaard.hpp"

namespace touchstone::proofs {

namespace {

Rational q(long a, long b) { return Rational(a, b); }

/// Lengths, elastic constants and p*, for which nothing is one and nothing is equal.
struct Body {
    Rational g, lambda, E, nu;
};
const std::vector<Body> bodies{{q(1, 7), q(3, 1), q(5, 1), q(1, 4)}, {q(2, 9), q(7, 5), q(11, 3), q(1, 3)}};

Ball pstar_of(const Ball& g, const Ball& lambda, const Body& b)
{
    const ex amplitude = amplitude_of_pressure(sym("g"), 2 * GiNaC::Pi / sym("lambda"));
    return evaluate(amplitude, std::map<std::string, Ball>{{"g", g}, {"lambda", lambda}, {"E", Ball(b.E)}, {"nu", Ball(b.nu)}});
}

/// One wave: load pbar/p*, place x/lambda in (-1/2, 1/2), pressure p/p*.
Situation wave(const Body& b, const Rational& load, const Rational& x, const std::optional<Rational>& p = {})
{
    Situation s;
    const Ball pstar = pstar_of(Ball(b.g), Ball(b.lambda), b), share(load), place(x);
    s["g"] = Ball(b.g);
    s["lambda"] = Ball(b.lambda);
    s["E"] = Ball(b.E);
    s["nu"] = Ball(b.nu);
    s["pstar"] = pstar;
    s["pbar"] = share * pstar;
    s["x"] = place * Ball(b.lambda);
    s["pmax"] = pstar * westergaard::peak_pressure(share);
    if (load < 1) s["a"] = Ball(b.lambda) * westergaard::half_width(share);
    const Ball here = pstar * westergaard::pressure(place, share);
    s["p"] = p ? Ball(*p) * pstar : here;
    if (p) {
        s["Q"] = *p < 0 ? Ball(1) : westergaard::exceedance(Ball(*p), share);
        s["q"] = *p < 0 ? Ball(0) : westergaard::density(Ball(*p), share) / pstar;
        s.derivative[{"Q", "p"}] = -s["q"];
    }
    // the profile that this pressure displaces the surface by, where the contact is full
    s["z"] = evaluate(
        displacement_of_pressure(sym("c"), 2 * GiNaC::Pi / sym("lambda")),
        std::map<std::string, Ball>{
            {"c", pstar * ScalarTraits<Ball>::cos_pi(2 * place)}, {"lambda", Ball(b.lambda)}, {"E", Ball(b.E)}, {"nu", Ball(b.nu)}});
    return s;
}

const std::vector<Rational> full_loads{q(21, 20), q(3, 2), q(5, 2)}, partial_loads{q(1, 20), q(1, 3), q(3, 4)};

std::vector<Rational> steps(const Rational& from, const Rational& to, const Rational& by)
{
    std::vector<Rational> all;
    for (Rational v = from; v <= to; v += by) all.push_back(v);
    return all;
}
const std::vector<Rational> places = steps(q(-49, 100), q(49, 100), q(7, 100));

/// Situations over loads, places and pressures; `keep` selects.
Meaning over(const std::vector<Rational>& loads, const std::vector<Rational>& xs, const std::vector<Rational>& ps,
             const std::function<bool(const Rational& load, const Rational& p)>& keep = {})
{
    Meaning m;
    for (const Body& b : bodies)
        for (const Rational& load : loads)
            for (const Rational& x : xs) {
                if (ps.empty()) m.situations.push_back(wave(b, load, x));
                for (const Rational& p : ps)
                    if (!keep || keep(load, p)) m.situations.push_back(wave(b, load, x, p));
            }
    return m;
}

std::vector<Rational> both(std::vector<Rational> a, const std::vector<Rational>& b)
{
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

/// The points of equality of the printed conditions, beside the others.
void add_points_of_equality(Meaning& all, const Meaning& points)
{
    for (Situation s : points.situations) {
        s.at_equality = true;
        all.situations.push_back(std::move(s));
    }
}

/// One wave in numbers whose quotients are exact in binary, so that equality is met and not approached: p* = 2, whatever E is.
Situation exact_wave(const Rational& load, const Rational& p)
{
    const Ball pstar(2);
    Situation s;
    s["pstar"] = pstar;
    s["pbar"] = Ball(load) * pstar;
    s["p"] = Ball(p) * pstar;
    s["Q"] = westergaard::exceedance(Ball(p), Ball(load));
    s["q"] = westergaard::density(Ball(p), Ball(load)) / pstar;
    s["lambda"] = Ball(q(7, 4));
    s.derivative[{"Q", "p"}] = -s["q"];
    return s;
}

/// Where the pressure of full contact begins and ends: p = pbar -+ p*.
Meaning ends_of_full_contact()
{
    Meaning m;
    for (const Rational& load : {q(9, 8), q(3, 2), q(5, 2)})
        for (const int side : {-1, 1}) m.situations.push_back(exact_wave(load, Rational(load + side)));
    return m;
}

/// Where that of partial contact does: p = 0 and the peak 2 sqrt(pbar p*), at loads that are squares.
Meaning ends_of_partial_contact()
{
    Meaning m;
    for (const Rational& root : {q(1, 4), q(1, 2), q(7, 8)})
        for (const Rational& p : {q(0, 1), Rational(2 * root)}) m.situations.push_back(exact_wave(Rational(root * root), p));
    return m;
}

Meaning hertz_limit()
{
    Meaning m;
    for (const Body& b : bodies)
        for (const Rational& load : partial_loads)
            for (const Rational& part : {q(-7, 8), q(0, 1), q(1, 9), q(1, 2)}) {
                Situation s = wave(b, load, q(0, 1));
                const Ball half = hertz::half_width(Ball(load)), x = Ball(part) * half;
                s["a"] = half * Ball(b.lambda);
                s["x"] = x * Ball(b.lambda);
                s["p"] = s["pstar"] * hertz::pressure(x, Ball(load));
                m.situations.push_back(s);
            }
    return m;
}

/// (2.8): its number is the one (5.11) goes on with, x_P at the threshold of G.
Meaning hertz_range()
{
    Meaning m;
    m.stated = {0};
    const Ball threshold = peaks::fixed_point(evaluate(prints().at("5.11")("rhs"), Point{}));
    for (const Rational& load : {q(1, 10), q(19, 100), q(199, 1000), q(201, 1000), q(21, 100), q(3, 10), q(2, 1)}) {
        Situation s = wave(bodies[0], load, q(0, 1));
        s.wanted = certainly(less(Ball(load), threshold));
        m.situations.push_back(s);
    }
    return m;
}

/// (2.13): x lies in the segment if and only if the pressure at x exceeds p.
Meaning segment()
{
    Meaning m;
    m.stated = {0, 1};
    for (const Body& b : bodies)
        for (const Rational& load : full_loads)
            for (const Rational& level : {q(-4, 5), q(1, 5), q(9, 10)})
                for (const Rational& x : places) {
                    Situation s = wave(b, load, x, Rational(load + level));
                    s.wanted = certainly(less(Ball(Rational(load + level)), westergaard::pressure(Ball(x), Ball(load))));
                    m.situations.push_back(s);
                }
    return m;
}

/// --- section 3

struct Surface {
    Rational gamma, D, g_0, lambda_0;
};
const std::vector<Surface> surfaces{{q(5, 1), q(3, 2), q(1, 3), q(2, 1)}, {q(7, 1), q(5, 4), q(3, 4), q(5, 3)}};

Situation surface(const Surface& f, long n, const Rational& x, long last_term = 3)
{
    Situation s;
    const Ball gamma(f.gamma), D(f.D), g_0(f.g_0), lambda_0(f.lambda_0);
    const Body& b = bodies[0];
    const auto g_at = [g_0, D, gamma](long k) { return g_0 * pow(weierstrass::amplitude_ratio(D, gamma), Ball(k)); };
    const auto lambda_at = [lambda_0, gamma](long k) { return lambda_0 / pow(gamma, Ball(k)); };
    const auto pstar_at = [g_at, lambda_at, b](long k) { return pstar_of(g_at(k), lambda_at(k), b); };
    s["gamma"] = gamma;
    s["D"] = D;
    s["g_0"] = g_0;
    s["lambda_0"] = lambda_0;
    s["E"] = Ball(b.E);
    s["nu"] = Ball(b.nu);
    s["x"] = Ball(x) * lambda_0;
    s["n"] = Ball(n);
    s["g_n"] = g_at(n);
    s["lambda_n"] = lambda_at(n);
    s["g_nm1"] = g_at(n - 1);
    s["lambda_nm1"] = lambda_at(n - 1);
    s["pstar_n"] = pstar_at(n);
    s["pbar"] = Ball(q(13, 2));
    s["zhat"] = g_0 * weierstrass::bound(D, gamma);
    s["z"] = g_0 * weierstrass::profile_by_terms(x, f.D, f.gamma);
    s.last_term = last_term;
    Ball phat(0), p = s["pbar"];
    for (long k = 0; k <= last_term; ++k) {
        phat += pstar_at(k);
        p += pstar_at(k) * cos(2 * ScalarTraits<Ball>::pi() * s["x"] / lambda_at(k));
    }
    s["phat"] = phat;
    s.of_index["pstar_n"] = pstar_at;
    s["p"] = p;
    const Rational unit = f.lambda_0;
    s.function["z"] = [f, x, g_0](const Ball& at) { // at x or at gamma x, whichever it is
        for (const Rational& factor : {Rational(1), f.gamma})
            if (at.contains(Rational(factor * x * f.lambda_0)))
                return g_0 * weierstrass::profile_by_terms(Rational(factor * x), f.D, f.gamma);
        return Ball::indeterminate();
    };
    return s;
}

Meaning at_surfaces(const std::vector<long>& scales, const std::vector<Rational>& xs, const std::vector<const char*>& without = {},
                    long last_term = 3)
{
    Meaning m;
    for (const Surface& f : surfaces)
        for (const long n : scales)
            for (const Rational& x : xs) {
                Situation s = surface(f, n, x, last_term);
                for (const char* name : without) s.value.erase(name);
                m.situations.push_back(s);
            }
    return m;
}

} // namespace

void add_meanings_of_sections_2_3(std::map<std::string, Meaning>& all)
{
    const std::vector<Rational> peak{q(0, 1)}, loads = both(partial_loads, full_loads);
    const std::vector<Rational> levels = both(steps(q(-31, 60), q(4, 1), q(8, 61)), {q(399, 1000), q(401, 1000)});
    all["2.1"] = over({q(3, 2)}, places, {});
    for (Situation& s : all["2.1"].situations) { s.value.erase("p"); s.value.erase("pmax"); }
    all["2.2"] = over(loads, places, {});
    all["2.3"] = over({q(1, 3)}, peak, {});
    all["2.4"] = over(partial_loads, places, {});
    all["2.5"] = over(partial_loads, {q(1, 9)}, {});
    all["2.6"] = all["2.7"] = hertz_limit();
    all["2.8"] = hertz_range();
    all["2.9"] = all["2.10"] = over(both(loads, {q(19, 20), q(2, 1), q(4, 1)}), {q(1, 9)}, {});
    for (const char* id : {"2.11", "2.12", "2.14", "2.15", "2.16"}) all[id] = over(full_loads, {q(1, 9)}, levels);
    all["2.13"] = segment();
    for (const char* id : {"2.17", "2.18"}) all[id] = over(partial_loads, {q(1, 9)}, levels);
    all["2.20"] = over(partial_loads, {q(1, 9)}, levels, [](const Rational&, const Rational& p) { return p > 0; });
    all["2.19"] = over(partial_loads, {q(1, 9)}, levels, [](const Rational& load, const Rational& p) { return p > 0 && p * p < 4 * load; });
    add_points_of_equality(all["2.2"], over({q(1, 1)}, places, {}));
    add_points_of_equality(all["2.9"], over({q(1, 1)}, {q(1, 9)}, {}));
    add_points_of_equality(all["2.10"], over({q(0, 1), q(1, 1)}, {q(1, 9)}, {}));
    for (const char* id : {"2.11", "2.12", "2.14", "2.15", "2.16"}) add_points_of_equality(all[id], ends_of_full_contact());
    for (const char* id : {"2.17", "2.18", "2.20"}) add_points_of_equality(all[id], ends_of_partial_contact());

    const std::vector<Rational> xs{q(0, 1), q(1, 7), q(-2, 9), q(1, 2)};
    all["3.1"] = at_surfaces({3}, xs, {"n", "z"});
    for (Situation& s : all["3.1"].situations) { // the sum as far as it is read
        Ball z(0);
        for (long k = 0; k <= s.last_term; ++k)
            z += s["g_0"] * pow(weierstrass::amplitude_ratio(s["D"], s["gamma"]), Ball(k)) *
                 cos(2 * ScalarTraits<Ball>::pi() * s["x"] * pow(s["gamma"], Ball(k)) / s["lambda_0"]);
        s["z"] = z;
    }
    all["3.2"] = all["3.6"] = all["3.8"] = at_surfaces({0, 2, 3}, {q(1, 7)});
    all["3.3"] = at_surfaces({3}, xs);
    all["3.3"].bounds_are_reached = true;
    all["3.4"] = at_surfaces({3}, {q(1, 7)});
    all["3.5"] = at_surfaces({3}, {q(1, 7), q(-2, 9)}, {"z"});
    all["3.7"] = at_surfaces({3}, xs, {"n", "pstar_n"});
    all["3.9"] = at_surfaces({3}, xs);
    all["3.9"].bounds_are_reached = true;
    all["3.10"] = at_surfaces({3}, {q(1, 7)}, {"n", "pstar_n"});
}

} // namespace touchstone::proofs
