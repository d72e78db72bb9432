// SPDX-License-Identifier: GPL-3.0-or-later
/// Figures 3 and 4, and what follows from the same areas.
#include "verify/figures/contact.hpp"

#include "touchstone/paper/archard.hpp"
#include "touchstone/paper/segments.hpp"
#include "touchstone/rounding/decimal.hpp"

#include <fmt/format.h>

#include <functional>

namespace touchstone::figures {
namespace {

constexpr slong bits = 192;

Ball power(const Surface& s, long n) { return pow(Ball(s.gamma), Ball(n)); }

Ball exact(double x) { return Ball::exactly(x); }

/// K_n of (7.13), n = -1 for the limit, as the catalogue certifies it.
Ball K(long n)
{
    const Quantity& q = *find_quantity(n < 0 ? "archard.K_inf" : "archard.K");
    const Inputs in = n < 0 ? Inputs() : Inputs({{"n", Rational(n)}});
    return evaluate(q, in, {.digits = 30}).ball;
}

const std::vector<Ball>& all_K()
{
    static const std::vector<Ball> all = [] {
        std::vector<Ball> k;
        for (long n = 0; n <= last_scale; ++n) k.push_back(K(n));
        return k;
    }();
    return all;
}

Ball archard_area(const Surface& s, double load, long n)
{
    return archard::area(n, exact(load), exact(s.G), all_K()[static_cast<std::size_t>(n)]);
}

/// One curve a load, y(n) from n = first.
using Value = std::function<Point(const Surface&, const Load&, long)>;

Curve curve(const Surface& s, const Load& load, int colour, Style style, const std::string& what, const std::string& legend, long first,
            const Value& y)
{
    Curve c{fmt::format("{}, load {}", what, load.text), legend, style, colour, {}};
    for (long n = first; n <= last_scale; ++n) c.points.push_back(y(s, load, n));
    return c;
}

std::string load_legend(const Load& l) { return fmt::format("load {}", l.text); }

/// The four panels of figures 3 and 4; `curves` fills one for a load.
std::vector<Panel> four_panels(const Axis& x, const std::function<Axis(const Surface&)>& y, const std::string& key,
                               const std::function<void(Panel&, const Surface&, const Load&, int)>& curves)
{
    std::vector<Panel> panels;
    for (const Surface& s : surfaces()) {
        Panel p{title(s), name(s), x, y(s), {}, {}, {}, panels.empty() ? key : std::string()};
        for (std::size_t k = 0; k < loads.size(); ++k) curves(p, s, loads[k], static_cast<int>(k) + 1);
        panels.push_back(std::move(p));
    }
    return panels;
}

/// What dashes mean, whatever the colour.
void in_legend(Figure& f, const char* name, Style style) { f.panels.front().curves.push_back({name, name, style, 0, {}}); }

const std::string scale_label = "scale {/:Italic n}";

} // namespace

Areas::Areas() : partial_("contact_area"), full_("contact_area_full"), heavy_("contact_area_heavy") {}

const Data& Areas::table(double load, double G) const { return G < 2 ? full_ : load > 1 ? heavy_ : partial_; }
const Ball& Areas::at(long n, double load, double G) const { return table(load, G).at({static_cast<double>(n), load, G}); }
std::string Areas::status(double load, double G) const { return table(load, G).status(); }

std::string name(const Surface& s)
{
    return fmt::format("({}) D = {}, gamma = {}", s.letter, s.D == Rational(3, 2) ? "1.5" : "1.05", s.gamma);
}
std::string title(const Surface& s)
{
    return fmt::format("({}) {{/:Italic D}} = {}, γ = {}", s.letter, s.D == Rational(3, 2) ? "1.5" : "1.05", s.gamma);
}

Point no_better_than(const std::string& status, Point p)
{
    if (p.status == "certified" && status != "certified" && status != "exact") p.status = status;
    return p;
}

Figure figure_3()
{
    const WorkingPrecision precision(bits);
    const Areas areas;
    Figure f{"figure3", "Figure 3. Total contact area against scale",
             "Variation of the total contact area A_n with the scale n, from equation (6.7), for five loads p̃ = p̄/p*_0. Each marker "
             "is a certified value (data/reference); "
             "the thin lines join them. Dashed: the Hertzian approximation (7.18), with the arguments of Γ corrected. Every curve tends "
             "to a straight line whose slope, "
             "−(D − 1) ln γ, does not depend on the load; at loads of 1 and more the first scales are in full contact.",
             "Four panels of contact area on a logarithmic scale falling with n, one for each pair of D and gamma, five loads each; the "
             "dashed approximation lies on the curves except at load 10.",
             {}, 2, 320};
    f.panels = four_panels(
        {scale_label, 0, last_scale, false, 5},
        [](const Surface& s) {
            return Axis{"contact area {/:Italic A_n} / λ_0",
                        s.G < 2        ? 1e-5
                        : s.gamma == 5 ? 1e-11
                                       : 1e-14,
                        s.G < 2 ? 4. : 10., true, s.G < 2 ? 10. : 100.};
        },
        above_all,
        [&](Panel& p, const Surface& s, const Load& l, int colour) {
            p.curves.push_back(curve(s, l, colour, Style::dashed, "(7.18)", "", 0, [](const Surface& t, const Load& load, long n) {
                return certified(static_cast<double>(n), archard_area(t, load.value, n));
            }));
            p.curves.push_back(
                curve(s, l, colour, Style::marked_line, "(6.7)", load_legend(l), 0, [&areas](const Surface& t, const Load& load, long n) {
                    return no_better_than(areas.status(load.value, t.G), certified(static_cast<double>(n), areas.at(n, load.value, t.G)));
                }));
        });
    in_legend(f, "Hertz, (7.18)", Style::dashed);
    return f;
}

Figure figure_4()
{
    const WorkingPrecision precision(bits);
    const Areas areas;
    Figure f{"figure4", "Figure 4. Number of contact segments against resolution",
             "Expected number N of contact segments in λ_0 against the resolution ε = λ_n/λ_0 = γ^(−n), for n = 1 to 20. Markers: "
             "certified, (8.1) with A_(n−1) of (6.7). Dashed: the Hertzian "
             "approximation (8.2). Dotted: its limit (8.3), of slope −(2 − D). Below N = 1 (grey line) the paper counts one segment.",
             "Four panels of the number of segments against resolution, both logarithmic; the curves of five loads become parallel "
             "lines of slope minus (2 - D) as the resolution grows finer.",
             {}, 2, 320};
    f.panels = four_panels(
        {"resolution ε = λ_{/:Italic n} / λ_0", 0, 1, true, 1e4},
        [](const Surface& s) {
            return Axis{"segments {/:Italic N}", 1e-2, s.D == Rational(3, 2) ? (s.gamma == 5 ? 1e9 : 1e12) : (s.gamma == 5 ? 1e15 : 1e21),
                        true, s.D == Rational(3, 2) ? 1e2 : 1e4};
        },
        above_all,
        [&](Panel& p, const Surface& s, const Load& l, int colour) {
            p.x.low = std::pow(static_cast<double>(s.gamma), -20.5);
            p.x.step = s.gamma == 5 ? 1e2 : 1e4;
            const auto epsilon = [](const Surface& t, long n) { return std::pow(static_cast<double>(t.gamma), static_cast<double>(-n)); };
            if (colour == 1)
                p.curves.push_back({"one segment", "", Style::line, grey, {{p.x.low, "1", "0", "exact"}, {1, "1", "0", "exact"}}});
            p.curves.push_back(curve(s, l, colour, Style::dotted, "(8.3)", "", 1, [&](const Surface& t, const Load& load, long n) {
                return certified(epsilon(t, n), archard::segments_limit(n, exact(load.value), Ball(t.D), Ball(t.gamma), K(-1)));
            }));
            p.curves.push_back(curve(s, l, colour, Style::dashed, "(8.2)", "", 1, [&](const Surface& t, const Load& load, long n) {
                return certified(epsilon(t, n), archard::segments(n, exact(load.value), Ball(t.D), Ball(t.gamma),
                                                                  all_K()[static_cast<std::size_t>(n - 1)]));
            }));
            p.curves.push_back(
                curve(s, l, colour, Style::marked_line, "(8.1)", load_legend(l), 1, [&](const Surface& t, const Load& load, long n) {
                    return no_better_than(areas.status(load.value, t.G),
                                          certified(epsilon(t, n), areas.at(n - 1, load.value, t.G) * power(t, n)));
                }));
        });
    in_legend(f, "Hertz, (8.2)", Style::dashed);
    in_legend(f, "limit (8.3)", Style::dotted);
    return f;
}

Figure hertz_error()
{
    const WorkingPrecision precision(bits);
    const Areas areas;
    Figure f{"hertz-error",
             "Relative error of the Hertzian approximation",
             "|A_n by (7.18) / A_n by (6.7) − 1| against the scale. \"An extremely good approximation … at large n\", says §7: the "
             "error does not vanish with n, it tends to a constant that depends on γ^(D−1) alone, "
             "8 % at D = 1.5, γ = 10 and 17 % at γ = 5. At D = 1.05 it is still changing at n = 20. Where a curve dips, the error "
             "changes sign.",
             "Four panels of relative error against scale for five loads; each set of curves tends to one constant at large n.",
             {},
             2,
             300};
    f.panels = four_panels(
        {scale_label, 0, last_scale, false, 5},
        [](const Surface&) {
            return Axis{"relative error of (7.18)", 1e-4, 10, true, 10};
        },
        above_all,
        [&](Panel& p, const Surface& s, const Load& l, int colour) {
            p.curves.push_back(curve(s, l, colour, Style::marked_line, "|(7.18)/(6.7) - 1|", load_legend(l), 0,
                                     [&areas](const Surface& t, const Load& load, long n) {
                                         return no_better_than(
                                             areas.status(load.value, t.G),
                                             certified(static_cast<double>(n),
                                                       abs(archard_area(t, load.value, n) / areas.at(n, load.value, t.G) - Ball(1)), 6));
                                     }));
        });
    return f;
}

Figure apparent_dimension()
{
    const WorkingPrecision precision(bits);
    const Areas areas;
    Figure f{"apparent-dimension", "Apparent fractal dimension against scale and load",
             "Slope of figure 4 between scales n and n + 1, log_γ(N_(n+1)/N_n), which §8 calls the apparent fractal dimension. It "
             "depends on the load at coarse scales, as Borri-Brunetto et al. (1998) observed, "
             "and tends to 2 − D (grey line) at every load. A simulation that spans 2^8 between its largest and smallest scale sees n "
             "up to 3.4 at γ = 5 and 2.4 at γ = 10. The slope is that of (8.1) as it stands: where N is below 1 the paper counts one "
             "segment, "
             "and the slope it sees is 0 (negative slopes are not drawn).",
             "Four panels of slope against scale; curves of heavy loads begin at 1, those of light loads low, and all meet the line 2 - "
             "D.", {}, 2, 300};
    f.panels = four_panels(
        {scale_label, 0, last_scale, false, 5},
        [](const Surface&) {
            return Axis{"apparent dimension", 0, 1.05, false, 0.25};
        },
        above_all,
        [&](Panel& p, const Surface& s, const Load& l, int colour) {
            if (colour == 1) {
                const Point limit = certified(0, Ball(Rational(2 - s.D)), 6);
                p.curves.push_back(
                    {"limit 2 - D, (8.7)", "", Style::line, grey, {limit, {last_scale, limit.value, limit.error, limit.status}}});
            }
            Curve c{fmt::format("slope, load {}", l.text), load_legend(l), Style::marked_line, colour, {}};
            for (long n = 1; n <= last_scale; ++n) {
                const Ball ratio = areas.at(n, l.value, s.G) / areas.at(n - 1, l.value, s.G) * Ball(s.gamma);
                c.points.push_back(
                    no_better_than(areas.status(l.value, s.G), certified(static_cast<double>(n), log(ratio) / log(Ball(s.gamma)), 6)));
            }
            p.curves.push_back(std::move(c));
        });
    return f;
}

} // namespace touchstone::figures
