// SPDX-License-Identifier: GPL-3.0-or-later
/// Figures 1 and 2: the peak pressures, and how full contact breaks up.
#include "verify/figures/figure.hpp"

#include "touchstone/paper/peaks.hpp"
#include "touchstone/paper/westergaard.hpp"

#include <cmath>

namespace touchstone::figures {
namespace {

constexpr slong bits = 128;

double shown(const Point& p) { return std::stod(p.value); }

/// y at points of [0, last], from balls.
template <class F>
Curve along(const std::string& name, const std::string& legend, Style style, int colour, double last, int pieces, F y)
{
    Curve c{name, legend, style, colour, {}};
    for (int k = 0; k <= pieces; ++k) {
        const double x = last * k / pieces;
        c.points.push_back(certified(x, y(Ball::exactly(x))));
    }
    return c;
}

/// Up to f, across to the line of slope G, up to f: the corners of (5.6).
Curve staircase(const std::string& name, const std::string& legend, int colour, const Rational& start, const Rational& G, int steps)
{
    Curve c{name, legend, Style::steps, colour, {}};
    Ball x(start);
    const auto corner = [&c](const Ball& at, const Ball& y) { c.points.push_back(certified(shown(certified(0, at, 12)), y)); };
    corner(x, Ball(0));
    for (int k = 0; k < steps; ++k) {
        const Ball y = peaks::f(x);
        corner(x, y);
        x = y / Ball(G);
        corner(x, y);
    }
    return c;
}

Panel iteration(const std::string& letter, const std::string& regime, const Rational& G, const std::string& G_text, double last, double top,
                const Rational& low, const Rational& high, const std::string& fixed)
{
    Panel p{"(" + letter + ") {/:Italic G} = γ^{{/:Italic D}−1} = " + G_text + ": " + regime,
            "(" + letter + ") G = " + G_text,
            {"load ratio {/:Italic x_{n−1}} = {/:Italic p_{n−1}}^{max} / {/:Italic p*_n}", 0, last},
            {"{/:Italic f}({/:Italic x}) = "
             "{/:Italic p_n}^{max} / {/:Italic "
             "p*_n}",
             0, top},
            {},
            {},
            {},
            "bottom right"};
    p.curves.push_back(
        along("f", "{/:Italic f}({/:Italic x}), (5.4), (5.5)", Style::line, 1, last, 200, [](const Ball& x) { return peaks::f(x); }));
    p.curves.push_back(along("G x", "line of slope {/:Italic G}", Style::line, 0, last, 1, [&G](const Ball& x) { return Ball(G) * x; }));
    p.curves.push_back(staircase("iteration from below", "(5.6), from below", 2, low, G, 12));
    p.curves.push_back(staircase("iteration from above", "(5.6), from above", 3, high, G, 12));
    for (std::size_t k = 1; k <= 4; ++k) { // the paper's A, B, C, D: f, line, f, line
        const Point& corner = p.curves.back().points[k];
        p.notes.push_back({corner.x + last * (k % 2 == 1 ? 0.012 : -0.035), shown(corner) + top * (k % 2 == 1 ? -0.035 : 0.035),
                           std::string(1, static_cast<char>('A' + k - 1))});
    }
    const Ball x_P = peaks::fixed_point(Ball(G));
    const double at = shown(certified(0, x_P, 12));
    const Point top_point = certified(at, peaks::f(x_P), 12);
    p.curves.push_back({"fixed point", "", Style::points, 0, {top_point}});
    p.notes.push_back({at + last * 0.04, shown(top_point) - top * 0.055, "P: {/:Italic x}_P = " + fixed});
    return p;
}

/// The pressure at scale `n` where the wave 0 has the phase x: each wave is loaded by the local pressure of the one before it.
Ball decoupled_pressure(long n, const Rational& x, const Rational& load, const Rational& G, long gamma)
{
    Ball p(load), unit(1); // of the scale before, and p*_k
    Rational waves = x;
    for (long k = 0; k <= n; ++k) {
        // a phase within half a wave of a crest, exactly
        Rational phase = waves - Rational(mpz_class(waves.get_num() / waves.get_den()));
        if (phase > Rational(1, 2)) phase -= 1;
        if (phase < Rational(-1, 2)) phase += 1;
        const Ball mean = p / unit;
        if (certainly(less(Ball(0), p))) p = unit * westergaard::pressure(Ball(phase), mean);
        waves *= gamma;
        unit = unit * Ball(G);
    }
    return p;
}

} // namespace

Figure figure_1()
{
    const WorkingPrecision precision(bits);
    Figure f{"figure1", "Figure 1. The iteration (5.6) of the peak pressures",
             "x_n = f(x_(n−1))/G: up to f, across to the line of slope G = γ^(D−1), and again. (a) G = √10, as at D = 1.5, γ = 10: the "
             "fixed point P lies on the branch 2√x, the highest asperities stay in partial contact, "
             "x_P = 4/G² (5.8). (b) G = 3/2: P lies on the branch 1 + x, the highest asperities stay in full contact, x_P = 1/(G − 1) "
             "(5.9). Both staircases, from below and from above, are monotone. The grey area is full contact, x > 1.",
             "Two panels: the curve f, a straight line through the origin, and staircases between them that climb or descend to their "
             "crossing point P.", {}, 2, 380};
    // sqrt(10) as the rational number 3162277660168379/10^15 is as good as a drawing can show; the CSV says so
    f.panels.push_back(iteration("a", "partial contact", Rational(3162277660168379L, 1000000000000000L), "√10", 1.2, 2.4, Rational(1, 100),
                                 Rational(11, 10), "4 / {/:Italic G}^2 = 0.4"));
    f.panels.push_back(
        iteration("b", "full contact", Rational(3, 2), "3/2", 4, 5.5, Rational(1, 50), Rational(18, 5), "1 / ({/:Italic G} − 1) = 2"));
    f.panels[0].bands.push_back({1, 1.2});
    f.panels[1].bands.push_back({1, 4});
    return f;
}

Figure figure_2()
{
    const WorkingPrecision precision(bits);
    constexpr long gamma = 8;
    const Rational G(9, 5), load(3, 2);
    Figure f{"figure2", "Figure 2. Evolution of the contact pressure for γ^(D−1) < 2",
             "The pressure over one wavelength λ_0 at the first three scales, by the paper's own decoupled rule (5.1): each wave is "
             "loaded by the local pressure of the wave before it. G = γ^(D−1) = 9/5, γ = 8, load p̃ = 3/2. "
             "At scale 0 there is full contact (1). At scale 1 it has become (2): full contact persists where p_0 > p*_1 (2A, grey) and "
             "separate contacts appear beside it (2B). At scale 2 each region (2A) has evolved to (2) again, and the regions (2B) to "
             "separate contacts (3). "
             "The paper's sketch leaves out that the highest contacts of (2B), those with p_0/p*_1 above G²/4, still hold some full "
             "contact.",
             "Three panels of pressure along one wavelength: a smooth wave, a wave with gaps at its sides, and a finer one with gaps "
             "everywhere but under the middle.", {}, 1, 230};
    const double tops[] = {3, 6, 12}, steps[] = {1, 2, 4};
    for (long n = 0; n < 3; ++n) {
        Panel p{"scale " + std::to_string(n),
                "scale " + std::to_string(n),
                {"{/:Italic x} / λ_0", -0.5, 0.5, false, 0.25},
                {"{/:Italic p_" + std::to_string(n) + "} / {/:Italic p*}_0", 0, tops[n], false, steps[n]},
                {},
                {},
                {},
                ""};
        Curve c{"p_" + std::to_string(n), "", Style::line, 1, {}};
        const long pieces = 256 * (n + 1) * (n + 1); // 36 points a wave at the finest
        for (long k = 0; k <= pieces; ++k) {
            const Rational x = Rational(k, pieces) - Rational(1, 2);
            Rational canonical = x;
            canonical.canonicalize();
            c.points.push_back(certified(canonical.get_d(), decoupled_pressure(n, canonical, load, G, gamma), 6));
        }
        p.curves.push_back(std::move(c));
        // p_0 > p*_1 = G: cos(2 pi x) > G - load
        const double edge = std::acos(G.get_d() - load.get_d()) / (2 * 3.14159265358979323846);
        if (n > 0) p.bands.push_back({-edge, edge});
        const double high = 0.93 * tops[n];
        if (n == 0) p.notes.push_back({0, high, "(1)", true});
        if (n == 1) p.notes.insert(p.notes.end(), {{0, high, "(2A)", true}, {-0.36, high, "(2B)", true}, {0.36, high, "(2B)", true}});
        if (n == 2)
            p.notes.insert(p.notes.end(),
                           {{0, high, "(2A) → (2)", true}, {-0.36, high, "(2B) → (3)", true}, {0.36, high, "(2B) → (3)", true}});
        f.panels.push_back(std::move(p));
    }
    return f;
}

} // namespace touchstone::figures
