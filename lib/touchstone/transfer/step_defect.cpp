// SPDX-License-Identifier: MIT
/// \file
/// |T V_(m-1) - V_m| on one panel, for all m: proven_levels.md, 4 and, for densities, 5.
#include "touchstone/transfer/defects.hpp"

#include "touchstone/wave/lemmas.hpp"

#include <algorithm>
#include <cmath>

namespace touchstone::transfer::levels {

using std::max, std::min;
using namespace bounds;

namespace {

/// The larger, and infinite where v is not a number: nothing is known then.
void raise(double& bound, double v) { bound = v <= infinite ? max(bound, v) : infinite; }

/// The part of an end of the wave that f~ takes one polynomial on: 0.8 of 1 -+ c.
constexpr double end_part = 0.8, largest_gap = 0.9;

} // namespace

/// Covers the panel with intervals J of x, each as wide as one of the proofs allows.
class StepOnPanel {
public:
    StepOnPanel(Defects& proof, std::size_t panel, const std::vector<double>& overlap_defect_)
        : d(proof), V(proof.V), i(panel), p(V.panels[panel]), overlap_defect(overlap_defect_), G(double(V.G)), half_z(double(p.half)), domain(d.domain_of(panel)),
          width(size_of(domain.second - domain.first))
    {
    }
    void prove();

private:
    /// J, with a margin for the rounding of its ends.
    struct Interval {
        Real low, high, x, half;
        double h;
        Interval(const Real& low_, const Real& high_)
            : low(low_), high(high_), x((low + high) * 0.5), half((high - low) * (0.5 + 0x1p-30) + 2 * u * x), h(size_of(half))
        {
        }
    };
    /// An end of the wave in f~, whose polynomial is that of one panel.
    struct End {
        int panel = -1;
        double factor = 0;   ///< |the end's part of f~| per unit of |V_e|
        double distance = 0; ///< of the arguments of V_e from its interval, in halves of that
        double overlap = 0;  ///< share of theta where V is a neighbour's polynomial
    };
    /// f~ on a disc about the middle of J.
    struct Continuation {
        End ends[2];
        double middle = 0; ///< |the middle part of f~| per unit of |V|
    };
    enum class Fit { yes, no, never }; ///< never: no narrower J would do

    double smallest(const Interval& J) const { return max(d.monotone ? d.smallest_part * width : 0, 2 * narrowest * double(J.x)); }
    /// The panel whose polynomial f~ may use furthest around y = z^(1/2), on its interval and above the first panel's left end.
    int end_panel(const Real& z, bool upper) const;
    Real left_of(const Panel& q) const { return max(q.left(), V.panels.front().z0); }
    double overlap_share(const Real& length) const { return length > 0 ? std::sqrt(G * size_of(length) / 2) : 0; }
    Fit continuation(const Interval&, double r, Continuation&) const;
    Fit with_full_contact(const Interval&, double r, Continuation&) const;
    Fit with_partial_contact(const Interval&, double r, Continuation&) const;
    /// Bounds of f~ - V_m on the disc of a check, times what is left of it between the points; false where they are too large to be of use.
    bool bounded(const Interval&, const Check&, double r, const Continuation&, std::vector<double>&) const;
    /// The check with the fewest points that serves J.
    Fit choose(const Interval&, const Check*&, Continuation&, std::vector<double>& between) const;
    void by_values(const Interval&, const Check&, const Continuation&, const std::vector<double>& between);
    void by_monotony(const Interval&);
    void as_hole(const Interval&);
    /// At least what V_m changes by on J.
    double change(const Interval&, int m) const;

    Defects& d;
    const Layer& V;
    const std::size_t i;
    const Panel& p;
    const std::vector<double>& overlap_defect;
    const double G, half_z;
    const std::pair<Real, Real> domain;
    const double width;
    Result here, there;
};

/// The half width of J is about a third of the way from y to the inner end of the polynomial's interval, and at most all of the way to its outer end.
int StepOnPanel::end_panel(const Real& z, bool upper) const
{
    constexpr double thirds = 2.7; // 1 + 2.125/0.79, from rho = 4, is 3.7 from the other end of J
    const auto& panels = V.panels;
    const int j = V.find(z), last = static_cast<int>(panels.size()) - 1;
    if (upper && j > 0 && (panels[j - 1].right() - z) * thirds > z - left_of(panels[j])) return j - 1;
    if (!upper && j < last && (z - left_of(panels[j + 1])) * thirds > panels[j].right() - z) return j + 1;
    return j;
}

StepOnPanel::Fit StepOnPanel::with_full_contact(const Interval& J, double r, Continuation& f) const
{
    const wave::DiscFull disc;
    if (double(J.x - 1) <= r * margin) return Fit::no;
    for (const bool upper : {false, true}) {
        const auto image = [&](const Real& v) { return (upper ? v + 1 : v - 1) / V.G; };
        const Real y = image(J.x), y_low = image(J.low), y_high = image(J.high);
        if (y < V.panels.front().y0 * 1.3) return Fit::never;
        const int e = end_panel(y * y, upper);
        const Panel& q = V.panels[e];
        if (y_low * y_low < left_of(q) * Real{1, 8 * u} || y_high * y_high > q.right() * Real{1, -8 * u}) return Fit::no;
        const Real q_low = sqrt(left_of(q)), q_high = sqrt(q.right());
        const Real inner = upper ? max(q_low, y - end_part / V.G) : min(q_high, y + end_part / V.G); // any point of the polynomial's interval will do
        const double gap = double(upper ? 1 + J.x - V.G * inner : V.G * inner - J.x + 1);
        if (r > disc.reach * gap || gap > largest_gap) return Fit::no;
        const double g = disc.grown * gap;
        f.ends[upper] = {e, std::sqrt(g) * 2 / std::sqrt(2 - g) / pi_below, (2 * double(max(y, inner)) * r + r * r / G) / G / double(q.half),
                         overlap_share(q_high - q.y1) + overlap_share(q.y0 - q_low)};
    }
    f.middle = disc.middle;
    return Fit::yes;
}

StepOnPanel::Fit StepOnPanel::with_partial_contact(const Interval& J, double r, Continuation& f) const
{
    const wave::DiscPartial disc;
    const double x = double(J.x);
    if (r > disc.reach * double(1 - J.x) || r > 0.5 * x) return Fit::no;
    const Kernel k(J.x, V.G, false);
    const Real z = 4 * J.x / k.G2;
    if (z < V.panels.front().z0 * 1.7) return Fit::never;
    const int e = end_panel(z, true);
    const Panel& q = V.panels[e];
    if (4 * J.low / k.G2 < left_of(q) * Real{1, 8 * u} || 4 * J.high / k.G2 > q.right() * Real{1, -8 * u}) return Fit::no;
    const Real at_gap = positive_part((2 - Real(end_part)) * (2 * J.x - end_part)) / k.G2; // 1 - c = end_part
    const double gap = double(k.one_minus_c(max(left_of(q), at_gap))), dc = disc.cosine_moves * r;
    if (dc > wave::disc_full.reach * gap || gap > largest_gap) return Fit::no;
    const double g = wave::disc_full.grown * gap;
    f.ends[0] = {};
    f.ends[1] = {e, std::sqrt(g) * 2 / std::sqrt(2 - g) / pi_below, (2 * (2 * r + dc) + 2 * x * dc + dc * (2 * r + dc)) / (G * G) / double(q.half),
                 overlap_share(sqrt(q.right()) - q.y1) + overlap_share(q.y0 - sqrt(left_of(q)))};
    f.middle = disc.middle;
    return Fit::yes;
}

StepOnPanel::Fit StepOnPanel::continuation(const Interval& J, double r, Continuation& f) const
{
    if (J.low < 1 && J.high > 1) return Fit::no;
    return J.low < 1 ? with_partial_contact(J, r, f) : with_full_contact(J, r, f);
}

bool StepOnPanel::bounded(const Interval& J, const Check& check, double r, const Continuation& f, std::vector<double>& between) const
{
    const double own_rho = ellipse_of_distance((2 * double(J.x) * r + r * r) / half_z);
    const double negligible = d.monotone ? 0 : d.tolerance / 1024 / largest_second_share(G, width);
    const bool as_it_is = d.monotone && J.h <= 100 * smallest(J) && &check == &d.checks.back(); // monotony would bound it no better
    for (int m = 1; m < d.levels; ++m) {
        double bound = V.growth_at(i, m, own_rho) + f.middle * V.largest[m - 1];
        for (const End& e : f.ends)
            if (e.panel >= 0) bound += e.factor * V.growth_at(e.panel, m - 1, ellipse_of_distance(e.distance));
        between[m] = margin * bound * check.tail;
        if (!(between[m] <= max(d.tolerance_of(m) / 4, negligible) || (as_it_is && between[m] < infinite))) return false;
    }
    return true;
}

StepOnPanel::Fit StepOnPanel::choose(const Interval& J, const Check*& chosen, Continuation& f, std::vector<double>& between) const
{
    Fit fit = Fit::no;
    if (J.h < narrowest * double(J.x)) return fit; // points that cannot be told apart
    for (const Check& check : d.checks) {
        const double r = J.h * check.spread;
        fit = continuation(J, r, f);
        if (fit == Fit::never) return fit;
        if (fit == Fit::yes && bounded(J, check, r, f, between)) {
            chosen = &check;
            return fit;
        }
    }
    return Fit::no;
}

double StepOnPanel::change(const Interval& J, int m) const
{
    double slope = 0;
    for (int k = 1; k < d.rules.orders.terms; ++k) slope += V.magnitude(i, k, m) * k * k;
    return margin * min(slope * double(J.high * J.high - J.low * J.low) / half_z, 2 * V.size[d.at(i, m)]);
}

void StepOnPanel::by_values(const Interval& J, const Check& check, const Continuation& f, const std::vector<double>& between)
{
    std::vector<double> most(static_cast<std::size_t>(d.levels));
    for (std::size_t n = 0; n < check.points.at.size(); ++n) {
        const Real x = J.x + J.half * check.points.at[n];
        V.apply(x, here);
        V.values(i, (x * x - p.centre) / p.half, there);
        for (int m = 1; m < d.levels; ++m) raise(most[m], size_of(here.value[m - 1] - there.value[m]) + here.error[m - 1] + 2 * V.rounding[d.at(i, m)]);
    }
    for (int m = 1; m < d.levels; ++m) {
        double overlap = 0;
        for (const End& e : f.ends)
            if (e.panel >= 0) overlap += e.overlap * overlap_defect[d.at(e.panel, m - 1)];
        d.found(m, J.low, J.high, i, margin * (check.lebesgue * (most[m] + overlap) + overlap + between[m]));
    }
}

/// B_m increases: between its values at the ends.
void StepOnPanel::by_monotony(const Interval& J)
{
    V.apply(J.low * Real{1, -4 * u}, here);
    V.apply(J.high * Real{1, 4 * u}, there);
    for (int m = 1; m < d.levels; ++m) {
        const Real v = V.value(i, m, (J.low * J.low - p.centre) / p.half);
        const double off = size_of(there.value[m - 1] - v) + size_of(v - here.value[m - 1]);
        d.found(m, J.low, J.high, i, margin * (off + change(J, m) + here.error[m - 1] + there.error[m - 1] + 2 * V.rounding[d.at(i, m)]), Defects::Known::by_monotony);
    }
}

/// T V at the middle, and what two laws mu_x of ratios, h apart, may differ by.
void StepOnPanel::as_hole(const Interval& J)
{
    V.apply(J.x, here);
    for (int m = 1; m < d.levels; ++m) {
        const Real v = V.value(i, m, (J.x * J.x - p.centre) / p.half);
        const double off = size_of(here.value[m - 1] - v) + here.error[m - 1] + std::sqrt(wave::shift * J.h) * V.largest[m - 1];
        d.add_hole(m, J.low, J.high, margin * (off + change(J, m) + 2 * V.rounding[d.at(i, m)]));
    }
}

void StepOnPanel::prove()
{
    constexpr double narrower = 0.7, wider = 1.6, remainder = 1.3; // a search: any J that cover the panel will do
    constexpr double wide_enough = 0.02;                           // of the panel's width, where no narrower J would do
    std::vector<double> between(static_cast<std::size_t>(d.levels));
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

void Defects::prove_panel(std::size_t panel, const std::vector<double>& overlap_defect) { StepOnPanel(*this, panel, overlap_defect).prove(); }

} // namespace touchstone::transfer::levels
