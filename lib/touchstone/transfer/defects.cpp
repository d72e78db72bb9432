// SPDX-License-Identifier: MIT
#include "touchstone/transfer/defects.hpp"

#include "touchstone/transfer/level_bounds.hpp"
#include "touchstone/transfer/parallel.hpp"
#include "touchstone/transfer/progress.hpp"
#include "touchstone/transfer/step_defect.hpp"
#include "touchstone/wave/lemmas.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>

namespace touchstone::transfer::levels {

using std::max, std::min;
using namespace bounds;

namespace {

/// Of a panel's width w: a part s w, where what increases is off by some s w, counts with the root of its width, (s w)^(3/2).
double smallest_part_for(double tolerance)
{
    constexpr double share = 1.0 / 64, least = 1e-14, most = 1e-6; // share of the tolerance that one such part may take
    return std::clamp(std::pow(share * tolerance, 2.0 / 3), least, most);
}

} // namespace

Defects::Defects(const Rules& rules_, const Layer& V_, int levels_, double tolerance_, bool monotone_)
    : rules(rules_)
    , V(V_)
    , levels(levels_)
    , columns(V_.count)
    , tolerance(tolerance_)
    , monotone(monotone_)
    , smallest_part(smallest_part_for(tolerance))
    , first_check(rules.orders.terms + (monotone ? 7 : 19), 4)
    , defect(V.panels.size() * static_cast<std::size_t>(columns))
    , by_monotony(V.panels.size())
    , holes(static_cast<std::size_t>(levels))
{
    for (const auto& [share, rho] : {std::pair{0.3, 64.0}, {0.45, 24.0}, {0.65, 10.0}, {0.7, 4.0}, {0.8, 4.0}, {0.9, 4.0}, {1.0, 4.0}})
        if (!monotone || share <= 0.65 || share == 1) checks.emplace_back(static_cast<int>(rules.orders.terms * share) + 7, rho);
}

void Defects::add_hole(int m, const Real& low, const Real& high, double defect_, Known known)
{
    const std::lock_guard lock(holes_mutex);
    holes[static_cast<std::size_t>(m)].push_back({low, high, defect_ <= infinite ? defect_ : infinite, known});
}

void Defects::found(int m, const Real& low, const Real& high, std::size_t panel, double defect_, Known known)
{
    const auto [left, right] = domain_of(panel);
    // what increases is bounded below the first panel by what is known all over that one
    const double kept_apart = tolerance_of(m) * (monotone ? 1 : 1.0 / 16); // a few large ones
    const bool apart = !(monotone && panel == 0) && defect_ > kept_apart && double(high - low) < 0.3 * size_of(right - left);
    if (apart) return add_hole(m, low, high, defect_, known);
    raise(defect[at(panel, m)], defect_);
    if (known == Known::by_monotony) by_monotony[panel] = 1;
}

std::pair<Real, Real> Defects::domain_of(std::size_t i) const
{
    const Panel& p = V.panels[i];
    const Real slack = (p.y1 - p.y0) * 1e-3;
    return {max(sqrt(p.left()), p.y0 - slack), p.y1 + slack};
}

void Defects::prove_level_zero(const First& first)
{
    in_parallel(V.panels.size(), [&](std::size_t i) { prove_first(first, i); });
}

void Defects::prove_first(const First& first, std::size_t i)
{
    const auto [left, right] = domain_of(i);
    const Panel& p = V.panels[i];
    const double rounding = V.rounding[V.at(i, 0)], half_z = double(p.half), width = size_of(right - left);
    const Check& check = first_check;
    const WorkingPrecision precision(160);
    double& D = defect[at(i, 0)];
    const double negligible = monotone ? 0 : tolerance / 1024 / largest_second_share(double(V.G), width);
    int intervals = 0;
    std::vector<std::pair<Real, Real>> waiting{{left, right}};
    while (!waiting.empty()) {
        if (++intervals > most_intervals) D = infinite; // nothing is certified with this, nor runs for ever
        if (!(D < infinite)) return;
        const auto [low, high] = waiting.back();
        waiting.pop_back();
        const Interval J(low, high);
        const Real x = J.x;
        const bool share = monotone;
        const double x_ = double(x), h = J.h, r = h * check.spread, small = max(share ? smallest_part * width : 0, 2 * narrowest * x_);
        if (low < 1 && high > 1) { // what is on either side need not be one analytic function
            waiting.emplace_back(low, Real(1));
            waiting.emplace_back(Real(1), high);
            continue;
        }
        const auto local = [&](const Real& v) { return (v * v - p.centre) / p.half; };
        const auto off = [&](const Real& at, const Real& v) { // at least |B_0 there - v|, v a value of V_0
            const auto [nearest, error] = first.value(at);
            return size_of(nearest - v) + error + 2 * rounding;
        };
        const auto [of_value, of_complement] = first.on_disc(low, high, x, r);
        const double rho = ellipse_of_distance(square_moves(x_, r) / half_z), from_one = size_of(V.coefficients[V.row(i, 0)] - 1);
        const double bound =
            margin * min(of_value + V.growth_at(i, 0, rho), of_complement + from_one + V.growth_at(i, 0, rho, 1)) * check.tail;
        double most = infinite;
        if (bound <= (h > small || !share ? max(tolerance / 16, negligible) : infinite) && bound < infinite && h >= narrowest * x_) {
            most = 0;
            for (std::size_t n = check.points.at.size(); n-- > 0 && most < infinite;) {
                const Real at = x + J.half * check.points.at[n];
                raise(most, off(at, V.value(i, 0, local(at))));
            }
        }
        if (most < infinite) found(0, low, high, i, check.anywhere(most, 0, bound));
        else if (h > small) {
            waiting.emplace_back(low, x);
            waiting.emplace_back(x, high);
        }
        else if (!share) add_hole(0, low, high, first.weight_on(double(low), double(high - low), V.size[V.at(i, 0)]), Known::on_average);
        else { // increasing, between its ends
            const Real v = V.value(i, 0, local(low));
            found(0, low, high, i,
                  margin * (off(low * Real{1, -4 * u}, v) + off(high * Real{1, 4 * u}, v) +
                            change_of(V, i, 0, double(high * high - low * low))));
        }
    }
}

double change_of(const Layer& V, std::size_t panel, int m, double dz)
{
    double slope = 0;
    for (int k = 1; k < V.orders.terms; ++k) slope += V.magnitude(panel, k, m) * k * k; // |T_k'| <= k^2
    return margin * min(slope * dz / double(V.panels[panel].half), 2 * V.size[V.at(panel, m)]);
}

std::vector<double> overlap_defects(const Rules& rules, const Layer& V, int levels)
{
    // polynomials of terms - 1, so nodes suffice
    const auto& panels = V.panels;
    std::vector<double> overlap_defect(panels.size() * V.count);
    const double lebesgue = 1.01 * (1 + 2 / pi_below * std::log(rules.orders.terms));
    const int count = static_cast<int>(panels.size());
    in_parallel(panels.size(), [&](std::size_t e) {
        const Panel& p = panels[e];
        thread_local Result mine, its;
        for (const int step : {-1, 1})
            for (int n = static_cast<int>(e) + step; n >= 0 && n < count; n += step) {
                Real low = max(p.left(), panels[n].z0), high = min(p.right(), panels[n].z1);
                if (!(high > low)) break;
                const Real short_of = 2 * narrowest * high - (high - low); // no narrower than points can be told apart
                if (short_of > 0) low -= short_of * 0.5, high += short_of * 0.5;
                std::vector<double> most(static_cast<std::size_t>(levels));
                for (std::size_t i = rules.own.at.size(); i-- > 0;) {
                    const Real z = (low + high) * 0.5 + (high - low) * 0.5 * rules.own.at[i];
                    V.values(e, (z - p.centre) / p.half, mine);
                    V.values(static_cast<std::size_t>(n), (z - panels[n].centre) / panels[n].half, its);
                    for (int m = 0; m + 1 < levels; ++m) raise(most[m], size_of(mine.value[m] - its.value[m]));
                }
                for (int m = 0; m + 1 < levels; ++m) // T V of the last is not asked for
                    raise(overlap_defect[V.at(e, m)], margin * lebesgue * (most[m] + V.rounding[V.at(e, m)] + V.rounding[V.at(n, m)]));
            }
    });
    return overlap_defect;
}

void Defects::prove_steps()
{
    const std::vector<double> overlap_defect = overlap_defects(rules, V, levels);
    const long count = static_cast<long>(V.panels.size());
    std::atomic<long> proven{0};
    in_parallel(V.panels.size(), [&](std::size_t i) {
        prove_panel(i, overlap_defect);
        progress("proof, panel", ++proven, count);
    });
}

std::vector<double> mass_after_steps(double G, double highest, int steps)
{
    std::vector<double> mass{1};
    wave::Power power;
    for (int k = 1; k <= steps; ++k, power = wave::after_steps(power, G))
        mass.push_back(min(mass.back(), margin * power.factor * std::pow(highest, power.exponent)));
    return mass;
}

void Defects::add_up()
{
    // where monotony of B_m was used, T V_{m-1} stood for T B_{m-1}
    double so_far = 0;
    const std::vector<double> mass = mass_after_steps(not_above(V.G), not_below(V.panels.back().y1), levels);
    std::vector<double> effects;
    for (int m = 0; m < levels; ++m) {
        if (m > 0 && monotone) {
            for (std::size_t i = 0; i < V.panels.size(); ++i)
                if (by_monotony[i]) defect[at(i, m)] += margin * so_far;
            for (Hole& h : holes[static_cast<std::size_t>(m)])
                if (h.known == Known::by_monotony) h.defect += margin * so_far;
        }
        sum_of_effects.push_back(so_far); // of the levels before m, for effect(m)
        effects.push_back(effect(m, infinite));
        so_far = 0; // T |B_m - V_m| <= sum of T^(m-k) (T D_k)
        for (int k = 0; k <= m; ++k) so_far += margin * effects[k] * mass[m - k];
        sum_of_effects.back() = so_far;
    }
}

std::vector<Part> Defects::parts(int m, double reach) const
{
    const auto& panels = V.panels;
    std::vector<Part> found;
    for (std::size_t i = 0; i < panels.size() && double(panels[i].y0) <= reach; ++i)
        found.push_back({defect[i * columns + m], panels[i].width(), panels[i].y0, panels[i].y1, false});
    for (const Hole& h : holes[m]) {
        const Real y0 = h.low * Real{1, -2 * u}, y1 = h.high * Real{1, 2 * u};
        if (double(y0) <= reach) found.push_back({h.defect, size_of(y1 - y0), y0, y1, h.known == Known::on_average});
    }
    std::sort(found.begin(), found.end(), [](const Part& a, const Part& b) { return a.defect > b.defect; });
    return found;
}

double Defects::effect(int m, double reach) const
{
    // T D <= d + sum over the parts with D > d of D times the largest share of theta a part can have
    const double best = least_sum(parts(m, reach), [&](const Part& p) { return largest_share(margin * double(V.G), p.width); });
    const double y = double(V.panels.front().y0); // below it V = 0
    double below;
    if (!monotone)
        below = m == 0 ? 0 : margin * (std::sqrt(y) * V.largest[m - 1] + sum_of_effects[m - 1]); // B_m = T B_{m-1}, T 1 <= x^(1/2)
    // B_m(x) <= B_m(y) <= T^(m+1) 1, for B_0(y) <= y^(1/2) as T 1 is
    else
        below = m == 0 ? std::sqrt(y)
                       : min(mass_after_steps(not_above(V.G), not_below(V.panels.front().y0), m + 1).back(),
                             margin * (V.size[m] + defect[m] + sum_of_effects[m - 1]));
    return margin * (best + below * largest_share(double(V.G), y));
}

double Defects::second_effect(int m, double reach) const
{
    return margin * least_sum(parts(m, reach), [&](const Part& p) { return largest_second_share(margin * double(V.G), p.width); });
}

double share_of(const Real& G, const Real& low, const Real& high, const Real& y0, const Real& y1)
{
    const bool full = low >= 1;
    if (!full && high > 1) return infinite; // the two sides of 1 are not compared
    const Kernel a(high, G, full), b(low, G, full); // c falls with x and rises with y
    const double slack = 64 * u * (1 + double(high)), width = size_of(y1 - y0) + slack;
    if (full ? double(G * y0 - 1 - high) > slack || double(low - 1 - G * y1) > slack : double(y0 * y0 / a.end - 1) > slack) return 0;
    const double g = double(G), any = largest_share(g, width);
    const double to_end = double(b.one_minus_c(y1 * y1)) - slack, to_begin = double(a.one_plus_c(y0 * y0)) - slack;
    if (!(to_end > 0 && to_begin > 0)) return any;
    return min(any, margin * g * width / (pi_below * std::sqrt(min(to_end, 1.0) * min(to_begin, 1.0))));
}

double Defects::effect_at(const Real& low, const Real& high) const
{
    return margin * least_sum(parts(0, infinite), [&](const Part& p) { return share_of(V.G, low, high, p.y0, p.y1); });
}

double Defects::blur(int m, const Real& x) const
{
    // theta kept, z G^2 = (x + c)^2, resp. (1 + c)(2x - 1 + c), moves by less than 5 u x (1 + x); an edge that moves by dz loses the jump
    // of V on a share
    const Real low = x * Real{1, -4 * u}, high = x * Real{1, 4 * u};
    const double x_ = double(x), dz = 40 * u * x_ * (1 + x_) / (double(V.G) * double(V.G));
    double sum = 0;
    for (std::size_t i = 0; i < V.panels.size(); ++i) {
        const Panel& p = V.panels[i];
        const double share = share_of(V.G, low, high, p.y0, p.y1);
        if (share == 0) continue;
        const double dy = min(std::sqrt(dz), dz / double(p.y0));
        sum += share * change_of(V, i, m, dz) + V.jump[i * columns + m] * share_of(V.G, low, high, p.y0 - Real(dy), p.y0 + Real(dy));
    }
    return margin * sum;
}

} // namespace touchstone::transfer::levels
