// SPDX-License-Identifier: MIT
/// \file
/// |T V_(m-1) - V_m| on one panel, for all m: proven_levels.md, 4 and, for densities, 5.
#include "touchstone/transfer/step_defect.hpp"

#include "touchstone/transfer/defects.hpp"

#include "touchstone/wave/lemmas.hpp"

#include <algorithm>
#include <cmath>

namespace touchstone::transfer::levels {

using std::max, std::min;
using namespace bounds;

namespace {

/// The most that f~ takes one polynomial on: 0.8 of 1 -+ c, which grows to less than 2.
constexpr double end_part = 0.8;
static_assert(end_part * wave::disc_full.grown < 2);

Real left_of(const Layer& V, int panel) { return max(V.panels[panel].left(), V.panels.front().z0); }

/// The panel whose polynomial f~ may use furthest around y = z^(1/2), on its interval and above the first panel's left end: the half width
/// of J is about a third of the way from y to the inner end of the polynomial's interval, and at most all of the way to its outer end.
int end_panel(const Layer& V, const Real& z, bool upper)
{
    constexpr double thirds = 2.7; // 1 + 2.125/0.79, from rho = 4, is 3.7 from the other end of J
    const auto& panels = V.panels;
    const int j = V.find(z), last = static_cast<int>(panels.size()) - 1;
    if (upper && j > 0 && (panels[j - 1].right() - z) * thirds > z - left_of(V, j)) return j - 1;
    if (!upper && j < last && (z - left_of(V, j + 1)) * thirds > panels[j].right() - z) return j + 1;
    return j;
}

/// Whether the images of the ends of J are on the interval of a panel's polynomial.
bool on_interval(const Layer& V, int panel, const Real& z_low, const Real& z_high)
{
    return z_low >= left_of(V, panel) * Real{1, 8 * u} && z_high <= V.panels[panel].right() * Real{1, -8 * u};
}

/// At least the share of theta where V is another panel's polynomial on this one's interval.
double overlap_share(const Layer& V, int panel)
{
    const Panel& p = V.panels[panel];
    const auto share = [&](const Real& length) { return largest_share(double(V.G), size_of(positive_part(length))); };
    return share(sqrt(p.right()) - p.y1) + share(p.y0 - sqrt(left_of(V, panel)));
}

Fit with_full_contact(const Layer& V, const Interval& J, double r, Continuation& f)
{
    const double G = double(V.G);
    if (double(J.x - 1) <= r * margin) return Fit::no;
    for (const bool upper : {false, true}) {
        const auto image = [&](const Real& v) { return (upper ? v + 1 : v - 1) / V.G; };
        const Real y = image(J.x), y_low = image(J.low), y_high = image(J.high);
        if (y < V.panels.front().y0 * 1.3) return Fit::never;
        const int e = end_panel(V, y * y, upper);
        if (!on_interval(V, e, y_low * y_low, y_high * y_high)) return Fit::no;
        const Panel& q = V.panels[e];
        const Real inner = upper ? max(sqrt(left_of(V, e)), y - end_part / V.G) : min(sqrt(q.right()), y + end_part / V.G);
        const double gap = double(upper ? 1 + J.x - V.G * inner : V.G * inner - J.x + 1);
        if (r > wave::disc_full.reach * gap) return Fit::no;
        f.ends[upper] = {e,
                         inner,
                         gap,
                         end_share(wave::disc_full.grown * gap),
                         square_moves(double(max(y, inner)), r / G) / double(q.half),
                         overlap_share(V, e)};
    }
    f.middle = wave::disc_full.middle;
    return Fit::yes;
}

Fit with_partial_contact(const Layer& V, const Interval& J, double r, Continuation& f)
{
    const double x = double(J.x), G = double(V.G);
    if (r > wave::disc_partial.reach * double(1 - J.x) || r > 0.5 * x) return Fit::no;
    const Kernel k(J.x, V.G, false);
    const auto image = [&](const Real& v) { return 4 * v / k.G2; };
    const Real z = image(J.x);
    if (z < V.panels.front().z0 * 1.7) return Fit::never;
    const int e = end_panel(V, z, true);
    if (!on_interval(V, e, image(J.low), image(J.high))) return Fit::no;
    const Real at_gap = positive_part((2 - Real(end_part)) * (2 * J.x - end_part)) / k.G2; // 1 - c = end_part
    const Real inner = max(left_of(V, e), at_gap);
    const double gap = double(k.one_minus_c(inner)), dc = wave::disc_partial.cosine_moves * r;
    if (dc > wave::disc_full.reach * gap) return Fit::no;
    f.ends[0] = {};
    f.ends[1] = {e,
                 sqrt(inner),
                 gap,
                 end_share(wave::disc_full.grown * gap),
                 force_moves(x, r, dc) / (G * G) / double(V.panels[e].half),
                 overlap_share(V, e)};
    f.middle = wave::disc_partial.middle;
    return Fit::yes;
}

} // namespace

Fit continue_wave(const Layer& V, const Interval& J, double r, Continuation& f)
{
    if (J.low < 1 && J.high > 1) return Fit::no;
    return J.low < 1 ? with_partial_contact(V, J, r, f) : with_full_contact(V, J, r, f);
}

double Continuation::bound(const Layer& V, int m) const
{
    double sum = middle * V.largest[static_cast<std::size_t>(m)];
    for (const End& e : ends)
        if (e.panel >= 0) sum += e.factor * V.growth_at(static_cast<std::size_t>(e.panel), m, ellipse_of_distance(e.distance));
    return margin * sum;
}

double size_on_disc(const Layer& V, std::size_t panel, int m, const Interval& J, double r, const Continuation& f)
{
    const double rho = ellipse_of_distance(square_moves(double(J.x), r) / double(V.panels[panel].half));
    return margin * (V.growth_at(panel, m, rho) + f.bound(V, m - 1));
}

double off(const Layer& V, const Result& next, std::size_t panel, int m, const Real& v)
{
    return margin * (size_of(next.value[m - 1] - v) + next.error[m - 1] + 2 * V.rounding[V.at(panel, m)]);
}

/// Covers the panel with intervals J of x, each as wide as one of the proofs allows.
class StepOnPanel {
public:
    StepOnPanel(Defects& proof, std::size_t panel, const std::vector<double>& overlap_defect_)
        : d(proof), V(proof.V), i(panel), p(V.panels[panel]), overlap_defect(overlap_defect_), G(double(V.G)), domain(d.domain_of(panel)),
          width(size_of(domain.second - domain.first))
    {
    }
    void prove();

private:
    double smallest(const Interval& J) const { return max(d.monotone ? d.smallest_part * width : 0, 2 * narrowest * double(J.x)); }
    /// Bounds of f~ - V_m on the disc of a check, times what is left of it between the points; false where they are too large to be of use.
    bool bounded(const Interval&, const Check&, double r, const Continuation&, std::vector<double>&) const;
    /// The check with the fewest points that serves J.
    Fit choose(const Interval&, const Check*&, Continuation&, std::vector<double>& between) const;
    void by_values(const Interval&, const Check&, const Continuation&, const std::vector<double>& between);
    void by_monotony(const Interval&);
    void as_hole(const Interval&);
    double change(const Interval& J, int m) const { return change_of(V, i, m, double(J.high * J.high - J.low * J.low)); }

    Defects& d;
    const Layer& V;
    const std::size_t i;
    const Panel& p;
    const std::vector<double>& overlap_defect;
    const double G;
    const std::pair<Real, Real> domain;
    const double width;
    Result here, there;
};

bool StepOnPanel::bounded(const Interval& J, const Check& check, double r, const Continuation& f, std::vector<double>& between) const
{
    const double negligible = d.monotone ? 0 : d.tolerance / 1024 / largest_second_share(G, width);
    const bool as_it_is = d.monotone && J.h <= 100 * smallest(J) && &check == &d.checks.back(); // monotony would bound it no better
    for (int m = 1; m < d.levels; ++m) {
        between[m] = size_on_disc(V, i, m, J, r, f) * check.tail;
        if (!(between[m] <= max(d.tolerance_of(m) / 4, negligible) || (as_it_is && between[m] < infinite))) return false;
    }
    return true;
}

Fit StepOnPanel::choose(const Interval& J, const Check*& chosen, Continuation& f, std::vector<double>& between) const
{
    Fit fit = Fit::no;
    if (J.h < narrowest * double(J.x)) return fit; // points that cannot be told apart
    for (const Check& check : d.checks) {
        const double r = J.h * check.spread;
        fit = continue_wave(V, J, r, f);
        if (fit == Fit::never) return fit;
        if (fit == Fit::yes && bounded(J, check, r, f, between)) {
            chosen = &check;
            return fit;
        }
    }
    return Fit::no;
}

void StepOnPanel::by_values(const Interval& J, const Check& check, const Continuation& f, const std::vector<double>& between)
{
    std::vector<double> most(static_cast<std::size_t>(d.levels));
    for (std::size_t n = check.points.at.size(); n-- > 0;) {
        const Real x = J.x + J.half * check.points.at[n];
        V.apply(x, here);
        V.values(i, (x * x - p.centre) / p.half, there);
        for (int m = 1; m < d.levels; ++m) raise(most[m], off(V, here, i, m, there.value[m]));
    }
    for (int m = 1; m < d.levels; ++m) {
        double overlap = 0;
        for (const Continuation::End& e : f.ends)
            if (e.panel >= 0) overlap += e.overlap * overlap_defect[d.at(e.panel, m - 1)];
        d.found(m, J.low, J.high, i, check.anywhere(most[m], overlap, between[m]));
    }
}

/// B_m increases: between its values at the ends.
void StepOnPanel::by_monotony(const Interval& J)
{
    V.apply(J.low * Real{1, -4 * u}, here);
    V.apply(J.high * Real{1, 4 * u}, there);
    for (int m = 1; m < d.levels; ++m) {
        const Real v = V.value(i, m, (J.low * J.low - p.centre) / p.half);
        d.found(m, J.low, J.high, i, margin * (off(V, here, i, m, v) + off(V, there, i, m, v) + change(J, m)), Defects::Known::by_monotony);
    }
}

/// T V at the middle, and what two laws mu_x of ratios, h apart, may differ by.
void StepOnPanel::as_hole(const Interval& J)
{
    V.apply(J.x, here);
    for (int m = 1; m < d.levels; ++m) {
        const Real v = V.value(i, m, (J.x * J.x - p.centre) / p.half);
        d.add_hole(m, J.low, J.high, margin * (off(V, here, i, m, v) + std::sqrt(wave::shift * J.h) * V.largest[m - 1] + change(J, m)));
    }
}

void StepOnPanel::prove()
{
    constexpr double narrower = 0.7, wider = 1.6, remainder = 1.3; // a search: any J that cover the panel will do
    constexpr double wide_enough = 0.02;                           // of the panel's width, where no narrower J would do
    std::vector<double> between(static_cast<std::size_t>(d.levels), infinite);
    double next = width;
    int intervals = 0;
    for (Real low = domain.first; low < domain.second;) {
        if (++intervals > Defects::most_intervals) { // nothing is certified with this, nor runs for ever
            std::fill_n(&d.defect[d.at(i, 0)], d.columns, infinite);
            return;
        }
        const Real stop = low < 1 && domain.second > 1 ? Real(1) : domain.second;
        for (;; next *= narrower) {
            const Interval J(low, double(stop - low) <= remainder * next ? stop : low + Real(next));
            const Check* check = nullptr;
            Continuation f;
            const Fit fit = choose(J, check, f, between);
            const double small = smallest(J);
            if (!check && J.h > small && !(fit == Fit::never && J.h < wide_enough * width)) {
                next = max(min(next, 2 * J.h), small / narrower); // h is at least small/2, for the points of a J to be told apart
                continue;
            }
            if (check) by_values(J, *check, f, between);
            else if (d.monotone) by_monotony(J);
            else as_hole(J);
            low = J.high;
            next = 2 * J.h * wider;
            break;
        }
    }
}

void Defects::prove_panel(std::size_t panel, const std::vector<double>& overlap_defect)
{
    StepOnPanel(*this, panel, overlap_defect).prove();
}

} // namespace touchstone::transfer::levels
