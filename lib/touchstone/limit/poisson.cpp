// SPDX-License-Identifier: MIT
// Compiled with -ffp-contract=off, as scalar/double_double.hpp asks.
#include "touchstone/limit/poisson.hpp"

#include "touchstone/limit/chebyshev.hpp"
#include "touchstone/limit/limit_law.hpp"
#include "touchstone/limit/rough_wave.hpp"
#include "touchstone/scalar/refusal.hpp"
#include "touchstone/transfer/defects.hpp"
#include "touchstone/transfer/parallel.hpp"
#include "touchstone/transfer/progress.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <utility>

namespace touchstone::limit {
namespace {

using namespace transfer;
using namespace transfer::bounds;
using namespace transfer::levels;

// ---- the search: Phi on the panels of a graded mesh. Nothing here is trusted.

/// R = f - c x - Phi + G T Phi at the nodes.
struct Equation {
    const Rules& rules;
    const Real G;
    const double tolerance;
    const std::vector<Panel> panels;
    Wide identity; ///< x at the nodes
    Wide f;

    Equation(const Rules& rules_, const First& first, const Real& G_, double tolerance_, std::vector<Panel> panels_)
        : rules(rules_)
        , G(G_)
        , tolerance(tolerance_)
        , panels(std::move(panels_))
        , identity(panels.size() * rules.own.at.size())
        , f(identity.size())
    {
        in_parallel(identity.size(), [&](std::size_t i) {
            const Panel& p = panels[i / rules.own.at.size()];
            identity.set(i, sqrt(p.centre + p.half * rules.own.at[i % rules.own.at.size()]));
            f.set(i, first.value(identity[i]).first);
        });
    }
    std::size_t terms() const { return rules.own.at.size(); }
    /// The largest, what is large on a narrow panel with the share that has of a wave.
    double weighed(const Vector& at_nodes) const
    {
        double most = 0;
        for (std::size_t i = 0; i < at_nodes.size(); ++i)
            most = std::max(most, std::fabs(at_nodes[i]) * largest_share(double(G), panels[i / terms()].width()));
        return most;
    }
    Wide residual(const Wide& phi, const Real& c) const
    {
        Layer one = layer_on(rules, G, tolerance, panels, 1);
        one.set(0, series_of(rules, phi));
        Wide result(phi.size());
        in_parallel(phi.size(), [&](std::size_t i) {
            thread_local Result at;
            one.apply(identity[i], at);
            result.set(i, f[i] - c * identity[i] - phi[i] + G * at.value[0]);
        });
        return result;
    }
};

/// A function of x from its values at the nodes of the mesh, in binary64.
class FromNodes {
public:
    FromNodes(const Equation& e_, const Vector& nodal) : e(e_), series(nodal.size())
    {
        const std::size_t terms = e.terms();
        in_parallel(e.panels.size(), [&](std::size_t j) {
            for (std::size_t k = 0; k < terms; ++k) {
                double sum = 0;
                for (std::size_t i = 0; i < terms; ++i) sum += e.rules.own.T.high[k * terms + i] * nodal[j * terms + i];
                series[j * terms + k] = sum * (k == 0 ? 1 : 2) / static_cast<double>(terms);
            }
        });
    }
    double operator()(double x) const
    {
        const Real z = Real(x) * Real(x);
        const auto above = std::upper_bound(e.panels.begin(), e.panels.end(), z, [](const Real& v, const Panel& p) { return v < p.z0; });
        const std::size_t j = above == e.panels.begin() ? 0 : static_cast<std::size_t>(above - e.panels.begin()) - 1, terms = e.terms();
        const double local = std::clamp(double((z - e.panels[j].centre) / e.panels[j].half), -1., 1.);
        return chebyshev_sum(&series[j * terms], terms, local);
    }

private:
    const Equation& e;
    Vector series;
};

struct Solution {
    Wide phi;
    Real c = 0;
};

/// What the equation asks of a change of Phi and c whose residual has to be `rest`, in binary64: by Nystroem's method on two grids
/// (Brakhage 1960). With r = R/x and d of the coarse grid's d - M d = r - c', phi = Phi/x gets r - c' + M d. What is not smooth is in r.
class Correction {
public:
    Correction(const Equation& e_, const LimitLaw& coarse_)
        : e(e_)
        , coarse(coarse_)
        , rough(e.rules, layer_on(e.rules, e.G, e.tolerance, e.panels, 1), e.identity)
    {
    }

    /// Until the residual is that small, or falls no more. \returns what is left of it, as far as binary64 can tell
    double find(const Vector& right, double wanted)
    {
        constexpr int most_steps = 12;
        delta.assign(right.size(), 0);
        c = 0;
        Vector rest = right;
        double before = infinite;
        for (int step = 0; step < most_steps; ++step) {
            improve(rest);
            const Vector after = rough.at_nodes(delta);
            for (std::size_t i = 0; i < rest.size(); ++i) rest[i] = right[i] - c * e.identity.high[i] - delta[i] + double(e.G) * after[i];
            const double now = e.weighed(rest);
            if (!(now < before / 2) || now < wanted) return now;
            before = now;
        }
        return before;
    }
    Vector delta;
    double c = 0;

private:
    void improve(const Vector& rest)
    {
        const FromNodes r(e, rest);
        Vector at_coarse;
        for (const double x : coarse.nodes()) at_coarse.push_back(r(x) / x);
        const double mean = dot(coarse.weights(), at_coarse);
        Vector smooth = coarse.solve(at_coarse); // M d = d - r + mean
        for (std::size_t i = 0; i < smooth.size(); ++i) smooth[i] += mean - at_coarse[i];
        const LimitLaw::Interpolant of_smooth(coarse, smooth);
        c += mean;
        for (std::size_t i = 0; i < delta.size(); ++i) delta[i] += rest[i] + (of_smooth(e.identity.high[i]) - mean) * e.identity.high[i];
    }
    const Equation& e;
    const LimitLaw& coarse;
    RoughWave rough;
};

/// Corrections in binary64, residuals in 106 bits.
Solution solve(const Equation& e, const LimitLaw& coarse)
{
    constexpr int most_corrections = 6;
    constexpr double at_once = 1e-12; // what binary64 gains
    Correction correction(e, coarse);
    Solution s{Wide(e.identity.size())};
    Wide rest = e.f; // of nothing
    double before = infinite;
    for (int step = 0; step < most_corrections; ++step) {
        progress("Poisson's equation, correction", step, most_corrections);
        const double most = e.weighed(rest.high), enough = e.tolerance / 4;
        if (!(most < before / 4) || most < enough) break;
        before = most;
        const double left = correction.find(rest.high, std::max(at_once * most, enough / 4));
        s.c += correction.c;
        for (std::size_t i = 0; i < s.phi.size(); ++i) s.phi.set(i, s.phi[i] + correction.delta[i]);
        if (left < enough) break; // the proof will see whether that is so
        rest = e.residual(s.phi, s.c);
    }
    return s;
}

/// What the proof is about: polynomials on one mesh, and c. Any will do.
struct Found {
    std::unique_ptr<Layer> area;  ///< near f
    std::unique_ptr<Layer> steps; ///< column 0: G Phi; column 1: near Phi - f + c x
    Real c;
};

void add(Wide& to, const Real& factor, const Wide& v)
{
    for (std::size_t i = 0; i < to.size(); ++i) to.set(i, to[i] + factor * v[i]);
}

/// The polynomials through f, Phi and c x at the nodes.
Found found_on(const Equation& e, const Solution& s)
{
    const Rules& rules = e.rules;
    Wide scaled(s.phi.size()), next = s.phi, nothing(s.phi.size());
    add(scaled, e.G, s.phi);
    add(next, -1, e.f);
    add(next, s.c, e.identity);
    const auto layer = [&](int columns) {
        return std::make_unique<Layer>(rules.orders, rules.gauss, rules.kernel_points, rules.exact, e.G, e.tolerance, e.panels, columns);
    };
    Found found{layer(1), layer(columns_for(2)), s.c};
    found.area->set(0, series_of(rules, e.f));
    found.steps->set(0, series_of(rules, scaled));
    found.steps->set(1, series_of(rules, next));
    for (int m = 2; m < columns_for(2); ++m) found.steps->set(m, nothing);
    return found;
}

Found search(const Rules& rules, const First& first, const std::vector<Ball>& of_f, const Ball& G, double lowest, double highest,
             double tolerance, const SpoiledPhi& spoiled)
{
    constexpr double coarse_lowest = 1e-8, coarse_tolerance = 1e-4; // a finer grid gains more at a step, and takes longer than that saves
    constexpr int coarse_order = 8;
    const Equation e(rules, first, to_real(G), tolerance, graded_panels(G, {lowest, highest, tolerance, of_f}));
    Solution s = solve(e, LimitLaw(G, {coarse_lowest, highest, coarse_tolerance, of_f}, coarse_order));
    for (std::size_t i = 0; spoiled && i < s.phi.size(); ++i) {
        const Panel& p = e.panels[i / rules.own.at.size()];
        s.phi.set(i, s.phi[i] + spoiled(double(p.y0), double(p.y1)));
    }
    return found_on(e, s);
}

// ---- the proof

/// Balls side by side, for arb_dot.
class Row {
public:
    explicit Row(int count_) : count(count_), values(_arb_vec_init(count)) {}
    Row(Row&& o) noexcept : count(o.count), values(std::exchange(o.values, nullptr)) {}
    Row(const Row&) = delete;
    Row& operator=(const Row&) = delete;
    Row& operator=(Row&&) = delete;
    ~Row()
    {
        if (values) _arb_vec_clear(values, count);
    }
    arb_ptr operator[](int k) { return values + k; }
    friend Ball operator*(const Row& a, const Row& b) ///< the sum of products
    {
        Ball sum;
        arb_dot(sum.get(), nullptr, 0, a.values, 1, b.values, 1, a.count, WorkingPrecision::bits());
        return sum;
    }

private:
    slong count;
    arb_ptr values;
};

/// Chebyshev points of -reach <= local <= reach, and T_k there.
struct LocalPoints {
    Ball reach;
    std::vector<Ball> at{};
    std::vector<Row> T{};
    LocalPoints(double reach_, const Check& check, int terms) : reach(Ball::exactly(reach_))
    {
        for (std::size_t n = 0; n < check.points.at.size(); ++n) {
            at.push_back(reach * to_ball(check.points.at[n]));
            T.emplace_back(terms);
            for (int k = 0; k < terms; ++k)
                arb_chebyshev_t_ui(T.back()[k], static_cast<ulong>(k), at.back().get(), WorkingPrecision::bits());
        }
    }
};

/// sup |V_1 - V_0/G + P - c x| on the panels, V_0 = G Phi, P the polynomial near f: one polynomial of z on each of them, and c z^(1/2), at
/// Chebyshev points of an interval that holds the panel; what these leave of z^(1/2), |z^(1/2)| <= (2 z)^(1/2), z the middle, on an ellipse
/// that stays away from 0, is charged.
double polynomial_defect(const Found& f)
{
    constexpr slong bits = 160;
    constexpr double slightly_more = 1 + 0x1p-40; // than the panel, whose ends are rounded
    const WorkingPrecision precision(bits);
    const int terms = f.steps->orders.terms;
    const Check check(terms + 28, 2.5); // the polynomials have `terms` terms; the rest is for the root
    const LocalPoints of_first(slightly_more, check, terms), of_others(slightly_more / overlap, check, terms);
    const Ball G = to_ball(f.steps->G), c = to_ball(f.c);
    std::vector<double> defects(f.steps->panels.size());
    in_parallel(defects.size(), [&](std::size_t panel) {
        const WorkingPrecision here(bits);
        const Panel& p = f.steps->panels[panel];
        const LocalPoints& local = p.first ? of_first : of_others;
        const Ball middle = to_ball(p.centre), half = to_ball(p.half), radius = half * local.reach,
                   left = middle - radius * Ball::exactly(check.spread); // of the ellipse
        const bool holds_panel = certainly(less(middle - radius, to_ball(p.z0))) && certainly(less(to_ball(p.z1), middle + radius));
        defects[panel] = infinite;
        if (!holds_panel || !certainly(less(Ball(0), left))) return;
        Row series(terms);
        for (int k = 0; k < terms; ++k) {
            const auto coefficient = [&](const Layer& of, int m) {
                return to_ball(of.coefficients[of.row(panel, k) + static_cast<std::size_t>(m)]);
            };
            arb_set(series[k], (coefficient(*f.steps, 1) - coefficient(*f.steps, 0) / G + coefficient(*f.area, 0)).get());
        }
        double most = 0;
        for (std::size_t n = 0; n < local.at.size(); ++n) {
            const Ball off = abs(series * local.T[n] - c * sqrt(middle + half * local.at[n]));
            if (!off.is_finite()) return;
            most = std::max(most, arf_get_d(arb_midref(off.get()), ARF_RND_UP) * margin + off.radius_bound());
        }
        const double of_root = std::fabs(f.c.high) * std::sqrt(2 * p.centre.high) * check.tail;
        defects[panel] = margin * (check.lebesgue * most + margin * of_root);
    });
    return *std::max_element(defects.begin(), defects.end());
}

/// f, divided by `unit`, which is 1 but for densities of small pressures; where it is not smooth, apart from 1; and below which ratio the
/// mesh need not reach.
struct Function {
    std::unique_ptr<const First> f;
    double unit = 1;
    std::vector<Ball> singular{};
    double lowest;
};

/// A power of two: densities of small pressures are as small.
double unit_of(const Question& q)
{
    return q.of == Question::Of::density ? std::min(1.0, std::exp2(std::floor(std::log2(double(to_real(q.pressure)))))) : 1;
}

Function function_of(const Question& q, const Ball& G, double tolerance)
{
    const double negligible = tolerance / 100;
    if (q.of == Question::Of::contact) return {.f = in_contact(), .lowest = negligible};
    if (q.of == Question::Of::density) {
        constexpr double least_unit = 0x1p-10; // meshes below take minutes
        const double unit = unit_of(q);
        auto density = std::make_unique<Density>(G, q.pressure, unit, tolerance / 64);
        const double lowest = std::min(negligible, density->waves.lowest() / 2); // it is 0 below
        if (!(unit >= least_unit && lowest > lowest_of_densities))
            throw BeyondReach("the pressure is too low for the density of the limit");
        return {std::move(density), unit, singular_points_of_density(G, q.pressure), lowest};
    }
    const auto [low, high] = ends_of_exceeding(q.pressure);
    return {q.of == Question::Of::pressure ? exceeding(q.pressure) : force_above(q.pressure), 1, {low, high}, negligible};
}

/// Up to where a mesh is needed: no ratio above x_P, at most 4/G^2 for G >= 2 and 1/(G - 1) else, is met from one below.
double highest_ratio(double G) { return G >= 2 ? margin * 4 / (G * G) : margin / (G - 1); }

} // namespace

namespace {

/// How far the mesh goes.
double end_of_mesh(const Ball& G)
{
    require_binary64_arithmetic();
    const Real nearest = to_real(G);
    const Ball off = abs(to_ball(nearest) / G - Ball(1));
    if (!certainly(less(Ball(1), G)) || !certainly(less(off, Ball::exactly(u))))
        throw BeyondReach("G must be above 1 and known to 101 bits");
    const double highest = 1.1 * highest_ratio(double(nearest));
    if (!(highest <= 60)) throw BeyondReach("G too near 1 for the constant of the limit");
    return highest;
}

} // namespace

PoissonSearch search_poisson(const Question& q, const Ball& G, double of_mean)
{
    const WorkingPrecision precision(256);
    const double highest = end_of_mesh(G), unit = unit_of(q), tolerance = of_mean / unit;
    const Rules rules(tolerance);
    const Function function = function_of(q, G, tolerance);
    const Found found = search(rules, *function.f, function.singular, G, function.lowest, highest, tolerance, {});
    PoissonSearch result{{}, unit * found.c};
    for (std::size_t i = 0; i < found.steps->panels.size(); ++i) {
        const Panel& p = found.steps->panels[i];
        result.panels.push_back({p.y0, p.y1, p.centre, p.half, {}});
        for (int k = 0; k < found.steps->orders.terms; ++k)
            result.panels.back().coefficients.push_back(unit * Real(found.steps->coefficients[found.steps->row(i, k)]));
    }
    return result;
}

Poisson solve_poisson(const Question& q, const Ball& G, double tolerance, const SpoiledPhi& spoiled)
{
    const WorkingPrecision precision(256);
    const double highest = end_of_mesh(G), g = double(to_real(G));
    const Rules rules(tolerance);
    const Function function = function_of(q, G, tolerance);
    const First& first = *function.f;
    const Found found = search(rules, first, function.singular, G, function.lowest, highest, tolerance, spoiled);

    Defects of_zero(rules, *found.area, 1, tolerance, first.is_share()), of_step(rules, *found.steps, 2, tolerance, false);
    of_zero.prove_level_zero(first);
    of_zero.add_up();
    of_step.prove_steps();
    const double polynomial = polynomial_defect(found);
    const double reach = highest_ratio(g);                       // the limit law has no ratio above
    const double below = double(found.steps->panels.front().y0); // Phi = P = 0 there
    Poisson result{to_ball(found.c),
                   0,
                   first.is_share() ? of_zero.effect(0, reach) : of_zero.second_effect(0, reach),
                   of_step.second_effect(1, reach),
                   polynomial,
                   margin * (std::fabs(double(found.c)) * below + std::sqrt(below) * found.steps->largest[0]) * largest_share(g, below),
                   found.steps->panels.size()};
    const double sup = (first.is_share() ? 1 : g) * result.level_zero + result.polynomial + result.below + g * result.step;
    result.error = sup <= infinite ? margin * g * g * g * sup : infinite;
    result.c = result.c * Ball::exactly(function.unit);
    for (double* part : {&result.error, &result.level_zero, &result.step, &result.polynomial, &result.below})
        *part *= function.unit; // a power of two
    return result;
}

namespace {

/// Digits that G^4 and the defects' sum take from the tolerance of the mesh: that counts some fifteen times (measured), and a tenth of the
/// last digit has to decide it.
double spare_digits(const Question& q, const Ball& G)
{
    const double lost = 4 * std::log10(double(to_real(G)));
    return std::max(lost + 0.7, 2.3) + (q.of == Question::Of::density ? 0.5 : 0);
}

constexpr long least_digits_of_mesh = 6; ///< fewer cost as much
constexpr long digits_next_to_ties = 8;  ///< more than are ever proven are asked for where a value is next to a tie

/// No mesh is asked for a smaller tolerance: with 106 bits, a residual that G^4 enlarges is not sure to reach it, and the search would
/// go on.
constexpr double least_tolerance = 1e-24;

double tolerance_for(const Question& q, const Ball& G, Accuracy wanted)
{
    const double digits = static_cast<double>(std::clamp(wanted.digits, least_digits_of_mesh, most_digits_by_poisson + 2));
    return std::max(std::pow(10.0, -digits - spare_digits(q, G)), least_tolerance);
}

/// The last ones found: both what is asked for and its explanation want them, and quotients of two.
Poisson kept(const Question& q, const Ball& G, Accuracy wanted)
{
    struct Kept {
        std::string of;
        double tolerance;
        Poisson found;
    };
    constexpr std::size_t most = 4;
    static std::mutex mutex;
    static std::vector<Kept> all; // the latest last
    const std::lock_guard lock(mutex);
    const double tolerance = tolerance_for(q, G, wanted);
    const std::string which =
        fmt::format("{} {} {}", static_cast<int>(q.of), q.of == Question::Of::contact ? "" : q.pressure.dump(), G.dump());
    for (const Kept& k : all)
        if (k.of == which && k.tolerance <= tolerance) return k.found;
    std::erase_if(all, [&](const Kept& k) { return k.of == which; });
    if (all.size() == most) all.erase(all.begin());
    all.push_back({which, tolerance, solve_poisson(q, G, tolerance)});
    return all.back().found;
}

} // namespace

Ball mean_by_poisson(const Question& q, const std::function<Ball()>& G, Accuracy wanted)
{
    // a search for digits that are not decided ends here, and not in the same finest mesh again and again
    if (wanted.digits > most_digits_by_poisson + digits_next_to_ties)
        throw BeyondReach("the residual of Poisson's equation is proven in 106 bits");
    const WorkingPrecision precision(256);
    const Poisson p = kept(q, G(), wanted);
    Ball mean = p.c;
    if (!(p.error < infinite)) throw BeyondReach("the residual of Poisson's equation is too large");
    arb_add_error(mean.get(), Ball::exactly(p.error).get());
    return mean;
}

std::string mean_by_poisson_certificate(const Question& q, const std::function<Ball()>& G, Accuracy wanted)
{
    const WorkingPrecision precision(256);
    const Poisson p = kept(q, G(), wanted);
    return fmt::format(
        "mean = c +- (G^3 sup T|R_1| + G^4 sup T^2|R_2|), R_1 + R_2 = f - c x - Phi + G T Phi (docs/limit.md, theorem 4), on {} panels\n"
        "  {} of |f - its polynomial| <= {:.2e}, T^2 of the step's defect <= {:.2e}, of the rest on the mesh <= {:.2e}, below it <= {:.2e}; |mean - c| <= {:.2e}\n",
        p.panels, q.of == Question::Of::density ? "T^2" : "T", p.level_zero, p.step, p.polynomial, p.below, p.error);
}

} // namespace touchstone::limit
