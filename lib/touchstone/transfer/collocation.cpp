// SPDX-License-Identifier: MIT
#include "touchstone/transfer/collocation.hpp"

#include "touchstone/scalar/refusal.hpp"
#include "touchstone/transfer/parallel.hpp"
#include "touchstone/transfer/progress.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>

namespace touchstone::transfer::levels {

using std::max, std::min;
using namespace bounds;

double largest_share(double G, double width) { return std::sqrt(G * width / 2); }
double largest_second_share(double G, double width)
{
    const double l = G * width;
    return min(largest_share(G, width),
               margin * l * (1 + 2 * std::sqrt(G) + std::sqrt(2 * G) / pi_below * max(0.0, std::log(1 / (2 * l)))));
}

Layer layer_on(const Rules& r, const Real& G, double tolerance, std::vector<Panel> panels, int columns)
{
    return Layer(r.orders, r.gauss, r.kernel_points, r.exact, G, tolerance, std::move(panels), columns);
}

Wide series_of(const Rules& r, const Wide& nodal)
{
    const std::size_t terms = static_cast<std::size_t>(r.orders.terms);
    Wide series(nodal.size());
    in_parallel(nodal.size() / terms, [&](std::size_t j) {
        Wide here(terms);
        for (std::size_t i = 0; i < terms; ++i) here.set(i, nodal[j * terms + i]);
        for (std::size_t k = 0; k < terms; ++k)
            series.set(j * terms + k, dot(r.own.T, k * terms, here) * (k == 0 ? 1 : 2) / r.orders.terms);
    });
    return series;
}

Wide series_through(const Rules& r, const std::vector<Panel>& panels, const std::function<Real(const Real&)>& f)
{
    const std::size_t terms = static_cast<std::size_t>(r.orders.terms);
    Wide nodal(panels.size() * terms);
    in_parallel(nodal.size(), [&](std::size_t i) {
        const Panel& p = panels[i / terms];
        nodal.set(i, f(p.centre + p.half * r.own.at[i % terms]));
    });
    return series_of(r, nodal);
}

namespace {

struct Search {
    const Rules& rules;
    const First& first;
    Real G;
    double tolerance;
};

struct Series {
    std::vector<Panel> panels;
    Wide coefficients; ///< [panel * terms + k]
};

/// Halves panels of `on` until f, a function of z, is resolved on each of them. \param series the polynomials through f on them
Series resolve(const Search& s, std::vector<Panel> on, Wide series, const std::function<Real(const Real&)>& f, int m)
{
    const auto& orders = s.rules.orders;
    constexpr std::size_t most = 30'000;
    const std::size_t terms = static_cast<std::size_t>(orders.terms);
    double largest = 0; // late levels are small all over
    for (std::size_t j = 0; j < on.size(); ++j) largest = max(largest, std::fabs(series.high[j * terms]));
    const double tolerance = s.tolerance * min(1.0, largest), small = 1e-6 * min(1.0, largest);
    const Real lowest = on.front().z0;
    std::vector<std::pair<Panel, std::vector<Real>>> done;
    while (!on.empty()) {
        std::vector<Panel> halves;
        for (std::size_t j = 0; j < on.size(); ++j) {
            const auto c = [&](std::size_t k) { return std::fabs(series.high[j * terms + k]); };
            const double left = 4 * max({c(terms - 1), c(terms - 2), c(terms - 3)}), width = on[j].width();
            const bool unbounded = !s.first.is_share() && m == 0, resolved = left <= s.tolerance * max(c(0), small);
            bool negligible = left * largest_share(double(s.G), width) <= tolerance / 1024; // the narrow ones are many
            if (unbounded) { // a constant will do there
                double change = 0;
                for (std::size_t k = 1; k < terms; ++k) change += c(k);
                negligible = change * largest_second_share(double(s.G), width) <= tolerance / 1024;
            }
            if (resolved || negligible || width <= 8 * narrowest * double(on[j].y1)) {
                done.emplace_back(on[j], std::vector<Real>());
                for (std::size_t k = 0; k < terms; ++k)
                    done.back().second.push_back(unbounded && !resolved && k > 0 ? Real(0) : series[j * terms + k]);
                continue;
            }
            const Real &z0 = on[j].z0, &z1 = on[j].z1, middle = (z0 + z1) * 0.5;
            halves.push_back(panel(z0, middle, z0 == lowest));
            halves.push_back(panel(middle, z1, false));
        }
        if (done.size() + halves.size() > most) throw BeyondReach("the mesh would be too large");
        on = std::move(halves);
        series = series_through(s.rules, on, f);
    }
    std::sort(done.begin(), done.end(), [](const auto& a, const auto& b) { return a.first.z0 < b.first.z0; });
    Series result{{}, Wide(done.size() * terms)};
    for (const auto& [p, c] : done) {
        for (std::size_t k = 0; k < terms; ++k) result.coefficients.set(result.panels.size() * terms + k, c[k]);
        result.panels.push_back(p);
    }
    return result;
}

std::vector<Panel> first_panels(const Search& s, double highest)
{
    std::vector<Panel> start;
    for (Real y = s.first.is_share() ? s.tolerance / 10 : lowest_of_densities; y < highest;) {
        const Real next = y * (1 + min(0.6, 0.35 / double(y)));
        start.push_back(panel(y * y, next * next, start.empty()));
        y = next;
    }
    return start;
}

/// T at the nodes of a mesh. Levels that keep the mesh follow the plan of the first of them: what is sparse and expensive to find is the
/// kernel, not the sums.
class Step {
public:
    Wide at_nodes(const Search& s, const Layer& V)
    {
        constexpr std::size_t most_memory = std::size_t{384} << 20; // of nodes beyond it, no plan is kept
        const auto& own = s.rules.own.at;
        const std::size_t nodes = V.panels.size() * own.size();
        const bool again = nodes == nodes_before; // halving is all that changes a mesh
        if (!again) plans = {};
        else if (plans.empty()) plans.resize(nodes);
        nodes_before = nodes;
        std::atomic<std::size_t> memory{0};
        Wide nodal(nodes);
        in_parallel(nodes, [&](std::size_t i) {
            if (again && !plans[i].sums.empty()) return nodal.set(i, V.follow(plans[i]));
            thread_local Result result;
            const Panel& p = V.panels[i / own.size()];
            result.plan = again && memory < most_memory ? &plans[i] : nullptr;
            V.apply(sqrt(p.centre + p.half * own[i % own.size()]), result);
            if (result.plan) memory += plans[i].memory();
            nodal.set(i, result.value[0]);
        });
        return nodal;
    }

private:
    std::size_t nodes_before = 0;
    std::vector<Plan> plans;
};

/// V_m, each on the mesh it needs, which is that of V_(m-1) or finer.
std::vector<Series> level_by_level(const Search& s, double highest, int levels)
{
    std::vector<Series> found;
    const std::vector<Panel> start = first_panels(s, highest);
    const auto first = [&](const Real& z) { return s.first.value(sqrt(z)).first; };
    found.push_back(resolve(s, start, series_through(s.rules, start, first), first, 0));
    Step step;
    for (int m = 1; m < levels; ++m) {
        progress("mesh, level", m, levels);
        Layer before = layer_on(s.rules, s.G, s.tolerance, found.back().panels, 1);
        before.set(0, found.back().coefficients);
        const auto next = [&](const Real& z) {
            thread_local Result result;
            before.apply(sqrt(z), result);
            return result.value[0];
        };
        found.push_back(resolve(s, before.panels, series_of(s.rules, step.at_nodes(s, before)), next, m));
    }
    return found;
}

/// The polynomials of `of` on panels each of which is a part of one of them.
Wide on_finer_panels(const Search& s, Series of, const std::vector<Panel>& finer)
{
    const auto& own = s.rules.own.at;
    const std::size_t terms = own.size();
    const Layer on = [&] {
        Layer layer = layer_on(s.rules, s.G, s.tolerance, std::move(of.panels), 1);
        layer.coefficients = std::move(of.coefficients);
        return layer;
    }();
    std::vector<std::size_t> parents;
    std::size_t parent = 0;
    for (const Panel& p : finer) {
        while (parent + 1 < on.panels.size() && on.panels[parent + 1].z0 <= p.z0) ++parent;
        parents.push_back(parent);
    }
    Wide nodal(finer.size() * terms);
    in_parallel(finer.size(), [&](std::size_t j) {
        const Panel &p = finer[j], &from = on.panels[parents[j]];
        for (std::size_t i = 0; i < terms; ++i)
            nodal.set(j * terms + i, on.value(parents[j], 0, (p.centre + p.half * own[i] - from.centre) / from.half));
    });
    return series_of(s.rules, nodal);
}

} // namespace

std::unique_ptr<Layer> collocate(const Rules& rules, const First& first, const Real& G, double highest, double tolerance, int levels,
                                 const Spoiled& spoiled)
{
    const Search s{rules, first, G, tolerance};
    std::vector<Series> found = level_by_level(s, highest, levels);
    auto all = std::make_unique<Layer>(rules.orders, rules.gauss, rules.kernel_points, rules.exact, G, tolerance, found.back().panels,
                                       columns_for(levels));
    for (int m = 0; m < levels; ++m) {
        Wide series = on_finer_panels(s, std::move(found[m]), all->panels);
        if (spoiled)
            for (std::size_t j = 0; j < all->panels.size(); ++j) {
                const std::size_t constant = j * static_cast<std::size_t>(rules.orders.terms);
                series.set(constant, series[constant] + spoiled(m, double(all->panels[j].y0), double(all->panels[j].y1)));
            }
        all->set(m, series);
    }
    return all;
}

} // namespace touchstone::transfer::levels
