// SPDX-License-Identifier: GPL-3.0-or-later
/// Figure 5 and the share of Hertzian contacts: what the distributions of section 6 say.
#include "verify/figures/contact.hpp"

#include "touchstone/paper/segments.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace touchstone::figures {
namespace {

constexpr slong bits = 192;
constexpr double load = 0.001;
constexpr double G = 3.1622776601683795;

/// The highest pressure of scale n, (5.2) with (5.6), in p*_0.
Ball highest_pressure(long n) { return pow(Ball::exactly(G), Ball(n + 1)) * peaks::iterate(n, Ball::exactly(load), Ball::exactly(G)); }

double middle(const Ball& b) { return std::stod(certified(0, b, 15).value); }

struct Scale {
    long n;
    int colour;
    bool from_reference; ///< few rows, of data/reference: markers alone
};
constexpr std::array scales{Scale{0, 6, false}, Scale{1, 1, false},  Scale{2, 3, false}, Scale{3, 5, false},
                            Scale{5, 4, false}, Scale{10, 0, false}, Scale{20, 2, true}};

/// The rows of one scale with value times `y`, against input times `x`: what makes both dimensionless.
Curve normalised(const Data& dense, const Data& sparse, const Scale& s, const Ball& x, const Ball& y, const char* what)
{
    const Data& from = s.from_reference ? sparse : dense;
    Curve c{fmt::format("{}, n = {}", what, s.n),
            fmt::format("{{/:Italic n}} = {}", s.n),
            s.from_reference ? Style::points
            : s.n == 0       ? Style::dashed
                             : Style::line,
            s.colour,
            {}};
    for (const auto& row : from.rows()) {
        if (row.inputs[0] != static_cast<double>(s.n) || row.inputs[2] != load || row.inputs[3] != G) continue;
        const double at = row.inputs[1] / middle(x);
        if (at <= 1) c.points.push_back(no_better_than(from.status(), certified(at, from.ball(row) * y)));
    }
    return c;
}

} // namespace

Figure figure_5()
{
    const WorkingPrecision precision(bits);
    const Data density("figure5_density"), segments_density("figure5_segments"), reference("contact_density"),
        reference_segments("segments_density"), areas("contact_area");
    Figure f{"figure5", "Figure 5. Normalised distributions of pressure and of segment length",
             "D = 1.5, γ = 10, load p̃ = 0.001. (a) q_n p_n^(max)/A_n against p/p_n^(max), with p_n^(max) of (5.2): the density of "
             "pressure in the contact. (b) N̂_n a_n^(max) λ_0/A_(n−1) against a/a_n^(max): the density of the half-lengths of the "
             "segments there are. "
             "Lines join certified points (data/figures); markers: n = 20 (data/reference). Both change character during the first "
             "scales and converge: from n = 10 to 20 hardly a difference is to be seen, while at n = 1 the density of pressure still "
             "ends in a jump and at n = 0 in a singularity.",
             "Two panels of density against normalised pressure and normalised segment length; curves of scales 0 to 10 approach a "
             "single humped curve, marked by the points of scale 20.", {}, 2, 400};
    Panel p{"(a) pressure",
            "(a) pressure",
            {"pressure {/:Italic p} / {/:Italic p_n}^{max}", 0, 1, false, 0.2},
            {"density {/:Italic q_n} {/:Italic p_n}^{max} λ_0 / {/:Italic A_n}", 0, 3, false, 0.5},
            {},
            {},
            {},
            above_all};
    Panel a{"(b) half-length of segments",
            "(b) half-length of segments",
            {"half-length {/:Italic a} / {/:Italic a_n}^{max}", 0, 1, false, 0.2},
            {"density {/:Italic N̂_n} {/:Italic a_n}^{max} λ_0 / {/:Italic A_{n−1}}", 0, 5, false, 1},
            {},
            {},
            {},
            ""};
    for (const Scale& s : scales) {
        const Ball top = highest_pressure(s.n);
        p.curves.push_back(normalised(density, reference, s, top, top / areas.at({static_cast<double>(s.n), load, G}), "q_n"));
        if (s.n == 0) continue;
        const Ball widest = segments::max_half_width(s.n, Ball::exactly(load), Ball::exactly(G));
        a.curves.push_back(
            normalised(segments_density, reference_segments, s, widest, widest / areas.at({static_cast<double>(s.n - 1), load, G}), "N_n"));
    }
    f.panels = {std::move(p), std::move(a)};
    return f;
}

Figure hertzian_share()
{
    const WorkingPrecision precision(bits);
    const Data exceedance("hertzian_share"), areas("contact_area");
    Figure f{"hertzian-share", "Share of Hertzian contacts",
             "Of the contacts at scale n, the share whose load ratio p_(n−1)/p*_n is below 0.2, where (2.8) calls them Hertzian: 1 − "
             "Q_(n−1)(p*_n/5)/A_(n−1), certified. \"Increasingly dominated by … the Hertzian regime\", says §5. "
             "For γ^(D−1) above √20 (here 5) that is so at every scale: the share is 1. Below, the load ratio of the highest contacts "
             "tends to x_P = 4/γ^(2D−2) > 0.2, and the share stays below 1.",
             "Share of Hertzian contacts against scale: equal to one for G = 5, falling away from one for smaller G.", {}, 1, 380};
    Panel p{"",
            "share",
            {"scale {/:Italic n}", 0.8, 4.2, false, 1},
            {"share of contacts with {/:Italic p_{n−1}} < 0.2 {/:Italic p*_n}", 0, 1.05, false, 0.2},
            {},
            {},
            {},
            above_all};
    int colour = 0;
    for (const auto& [at, text] : {std::pair{2.2360679774997896, "√5"}, {G, "√10"}})
        for (const auto& [with, with_text] : {std::pair{0.001, "0.001"}, {0.1, "0.1"}}) {
            Curve c{fmt::format("G = {}, load {}", text, with_text),
                    fmt::format("{{/:Italic G}} = {}, load {}", text, with_text),
                    Style::marked_line,
                    ++colour,
                    {}};
            for (const auto& row : exceedance.rows())
                if (row.inputs[2] == with && row.inputs[3] == at)
                    c.points.push_back(
                        no_better_than(exceedance.status(),
                                       certified(row.inputs[0] + 1, Ball(1) - exceedance.ball(row) / areas.at({row.inputs[0], with, at}))));
            p.curves.push_back(std::move(c));
        }
    Curve all{"G = 5, load 0.1", "{/:Italic G} = 5, load 0.1", Style::marked_line, 0, {}};
    for (long n = 1; n <= 4; ++n) {
        // x_{n-1} < 1/5 at every scale: no contact is above it, so the share is 1
        const bool below = certainly(less(peaks::iterate(n - 1, Ball(Rational(1, 10)), Ball(5)), Ball(Rational(1, 5))));
        if (below) all.points.push_back({static_cast<double>(n), "1", "0", "exact"});
    }
    p.curves.push_back(std::move(all));
    f.panels = {std::move(p)};
    return f;
}

} // namespace touchstone::figures
