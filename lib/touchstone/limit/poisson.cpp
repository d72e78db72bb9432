// SPDX-License-Identifier: MIT
// Compiled with -ffp-contract=off, as transfer/double_double.hpp asks.
#include "touchstone/limit/poisson.hpp"

#include "touchstone/scalar/refusal.hpp"
#include "touchstone/transfer/defects.hpp"
#include "touchstone/transfer/full_contact.hpp"
#include "touchstone/transfer/parallel.hpp"
#include "touchstone/transfer/progress.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <mutex>

namespace touchstone::limit {
namespace {

using namespace transfer;
using namespace transfer::bounds;
using namespace transfer::levels;

constexpr int mesh_levels = 16; ///< the mesh is the one that so many levels of areas need: Phi is smoother than those

// ---- the search: Phi by GMRES on the values at the nodes of the mesh. Nothing here is trusted.

/// (I - G T) on functions with mean(phi) = 0, which has an inverse there; c is what the projection takes away.
struct Equation {
    const Rules& rules;
    const Layer& mesh;
    double tolerance;
    Wide identity;              ///< x at the nodes
    std::vector<std::size_t> middle; ///< nodes over which mean() is taken

    Equation(const Rules& rules_, const Layer& mesh_, double tolerance_) : rules(rules_), mesh(mesh_), tolerance(tolerance_), identity(mesh.panels.size() * rules.own.at.size())
    {
        for (std::size_t i = 0; i < identity.size(); ++i) {
            identity.set(i, sqrt(z(i)));
            if (identity.high[i] > 0.25 && identity.high[i] < 1) middle.push_back(i);
        }
    }
    Real z(std::size_t i) const
    {
        const Panel& p = mesh.panels[i / rules.own.at.size()];
        return p.centre + p.half * rules.own.at[i % rules.own.at.size()];
    }
    Real mean(const Wide& v) const
    {
        Real sum = 0;
        for (const std::size_t i : middle) sum += v[i] / identity[i];
        return sum / static_cast<double>(middle.size());
    }
    /// v - mean(v) x
    Wide projected(Wide v) const
    {
        const Real off = mean(v);
        for (std::size_t i = 0; i < v.size(); ++i) v.set(i, v[i] - off * identity[i]);
        return v;
    }
    /// v - G T v
    Wide applied(const Wide& v) const
    {
        Layer one = layer_on(rules, mesh.G, tolerance, mesh.panels, 1);
        one.set(0, series_of(rules, v));
        Wide result(v.size());
        in_parallel(v.size(), [&](std::size_t i) {
            thread_local Result at;
            one.apply(identity[i], at);
            result.set(i, v[i] - mesh.G * at.value[0]);
        });
        return result;
    }
};

void add(Wide& to, const Real& factor, const Wide& v)
{
    for (std::size_t i = 0; i < to.size(); ++i) to.set(i, to[i] + factor * v[i]);
}
Real norm(const Wide& v) { return sqrt(dot(v, 0, v)); }

/// The Hessenberg matrix of Arnoldi's process, made triangular by rotations as it grows.
struct Triangle {
    std::vector<std::vector<Real>> columns;
    std::vector<std::pair<Real, Real>> rotations; ///< cosine, sine
    std::vector<Real> right;                      ///< last: the residual

    explicit Triangle(const Real& first) : right{first} {}
    void add_column(std::vector<Real> h)
    {
        for (std::size_t k = 0; k < rotations.size(); ++k) rotate(h[k], h[k + 1], rotations[k]);
        const std::size_t k = rotations.size();
        const Real r = sqrt(h[k] * h[k] + h[k + 1] * h[k + 1]);
        rotations.emplace_back(h[k] / r, h[k + 1] / r);
        h[k] = r;
        h.pop_back();
        right.emplace_back(0);
        rotate(right[k], right[k + 1], rotations.back());
        columns.push_back(std::move(h));
    }
    double residual() const { return std::fabs(right.back().high); }
    std::vector<Real> solution() const
    {
        std::vector<Real> y(columns.size());
        for (std::size_t k = y.size(); k-- > 0;) {
            Real sum = right[k];
            for (std::size_t j = k + 1; j < y.size(); ++j) sum -= columns[j][k] * y[j];
            y[k] = sum / columns[k][k];
        }
        return y;
    }

private:
    static void rotate(Real& a, Real& b, const std::pair<Real, Real>& by)
    {
        const Real old = a;
        a = by.first * a + by.second * b;
        b = by.first * b - by.second * old;
    }
};

/// phi with (I - G T) phi = right - c x on the nodes, until that is off by `left` (root mean square) or most_steps are done.
Wide gmres(const Equation& e, const Wide& right, double left)
{
    constexpr int most_steps = 200;
    Wide first = e.projected(right);
    const Real size = norm(first);
    std::vector<Wide> basis{Wide(first.size())};
    add(basis[0], 1 / size, first);
    Triangle triangle(size);
    const double enough = left * std::sqrt(static_cast<double>(first.size()));
    for (int k = 0; k < most_steps && triangle.residual() > enough; ++k) {
        progress("Poisson's equation, step", k, most_steps);
        Wide next = e.projected(e.applied(basis.back()));
        std::vector<Real> h;
        for (const Wide& q : basis) {
            h.push_back(dot(next, 0, q));
            add(next, -h.back(), q);
        }
        h.push_back(norm(next));
        Wide q(next.size());
        add(q, 1 / h.back(), next);
        basis.push_back(std::move(q));
        triangle.add_column(std::move(h));
    }
    const std::vector<Real> y = triangle.solution();
    Wide phi(first.size());
    for (std::size_t k = 0; k < y.size(); ++k) add(phi, y[k], basis[k]);
    return phi;
}

/// What the proof is about: polynomials on one mesh, and c. Any will do.
struct Found {
    std::unique_ptr<Layer> area;  ///< near B_0
    std::unique_ptr<Layer> steps; ///< column 0: G Phi; column 1: near Phi - B_0 + c x
    Real c;
};

/// The polynomials through B_0, Phi and c x at the nodes.
Found found_on(const Equation& e, const Wide& B0, const Wide& phi, const Real& c)
{
    const Rules& rules = e.rules;
    Wide scaled(phi.size()), next(phi.size()), nothing(phi.size());
    add(scaled, e.mesh.G, phi);
    add(next, 1, phi);
    add(next, -1, B0);
    add(next, c, e.identity);
    const auto layer = [&](int columns) {
        return std::make_unique<Layer>(rules.orders, rules.gauss, rules.kernel_points, rules.exact, e.mesh.G, e.tolerance, e.mesh.panels, columns);
    };
    Found found{layer(1), layer(columns_for(2)), c};
    found.area->set(0, series_of(rules, B0));
    found.steps->set(0, series_of(rules, scaled));
    found.steps->set(1, series_of(rules, next));
    for (int m = 2; m < columns_for(2); ++m) found.steps->set(m, nothing);
    return found;
}

Found search(const Rules& rules, const First& first, const Real& G, double highest, double tolerance, const SpoiledPhi& spoiled)
{
    const auto mesh = collocate(rules, first, G, highest, tolerance, mesh_levels);
    const Equation e(rules, *mesh, tolerance);
    Wide B0(e.identity.size());
    in_parallel(B0.size(), [&](std::size_t i) { B0.set(i, first.value(e.identity[i]).first); });
    Wide phi = gmres(e, B0, tolerance / 16), rest = B0;
    add(rest, -1, e.applied(phi));
    const Real c = e.mean(rest);
    for (std::size_t i = 0; spoiled && i < phi.size(); ++i) {
        const Panel& p = mesh->panels[i / rules.own.at.size()];
        phi.set(i, phi[i] + spoiled(double(p.y0), double(p.y1)));
    }
    return found_on(e, B0, phi, c);
}

// ---- the proof

/// sup |V_1 - V_0/G + P - c x| on a panel, V_0 = G Phi, P the polynomial near B_0: polynomials of z, and c z^(1/2), at Chebyshev points of
/// the panel; what these leave of z^(1/2), |z^(1/2)| <= (2 z1)^(1/2) on an ellipse that stays away from 0, is charged.
double polynomial_defect(const Found& f, std::size_t panel, const Check& check)
{
    const WorkingPrecision precision(160);
    const Panel& p = f.steps->panels[panel];
    const Ball centre = to_ball(p.centre), half = to_ball(p.half), low = to_ball(p.z0), high = to_ball(p.z1), c = to_ball(f.c), G = to_ball(f.steps->G);
    const Ball middle = (low + high) / 2, radius = (high - low) / 2;
    const Ball left = middle - radius * Ball::exactly(check.spread); // of the ellipse
    if (!certainly(less(Ball(0), left))) return infinite;
    const auto series = [&](const Layer& of, int m, const Ball& local) {
        Ball before(0), now(0);
        for (int k = of.orders.terms - 1; k > 0; --k) {
            const Ball next = 2 * local * now - before + to_ball(of.coefficients[of.row(panel, k) + static_cast<std::size_t>(m)]);
            before = now;
            now = next;
        }
        return local * now - before + to_ball(of.coefficients[of.row(panel, 0) + static_cast<std::size_t>(m)]);
    };
    double most = 0;
    for (std::size_t n = 0; n < check.points.at.size(); ++n) {
        const Ball z = middle + radius * to_ball(check.points.at[n]), local = (z - centre) / half;
        const Ball off = abs(series(*f.steps, 1, local) - series(*f.steps, 0, local) / G + series(*f.area, 0, local) - c * sqrt(z));
        most = std::max(most, arf_get_d(arb_midref(off.get()), ARF_RND_UP) * margin + off.radius_bound());
    }
    const double of_root = std::fabs(f.c.high) * std::sqrt(2 * p.z1.high) * check.tail;
    return margin * (check.lebesgue * most + of_root);
}

} // namespace

Poisson solve_poisson(const Ball& G, double tolerance, const SpoiledPhi& spoiled)
{
    require_binary64_arithmetic();
    const WorkingPrecision precision(256);
    const Real nearest = to_real(G);
    const Ball off = abs(to_ball(nearest) / G - Ball(1));
    if (!certainly(less(Ball(1), G)) || !certainly(less(off, Ball::exactly(u)))) throw BeyondReach("G must be above 1 and known to 101 bits");
    const double g = double(nearest), highest = std::max(1.0, 1.1 / (g - 1));
    if (!(highest <= 400)) throw BeyondReach("G too near 1 for the constant of the limit");
    const Rules rules(tolerance);
    const auto first = in_contact();
    const Found found = search(rules, *first, nearest, highest, tolerance, spoiled);

    Defects of_zero(rules, *found.area, 1, tolerance, true), of_step(rules, *found.steps, 2, tolerance, false);
    of_zero.prove_level_zero(*first);
    of_zero.add_up();
    of_step.prove_steps();
    const Check check(rules.orders.terms + 28, 2.5); // the polynomials have `terms` terms; the rest is for the root
    std::vector<double> rest(found.steps->panels.size());
    in_parallel(rest.size(), [&](std::size_t i) { rest[i] = polynomial_defect(found, i, check); });

    const double reach = margin / (g - 1);                               // at least x_P: the limit law has no ratio above
    const double below = double(found.steps->panels.front().y0); // Phi = P = 0 there
    Poisson result{to_ball(found.c), 0, of_zero.effect(0, reach), of_step.second_effect(1, reach), *std::max_element(rest.begin(), rest.end()),
                   margin * (std::fabs(double(found.c)) * below + std::sqrt(below) * found.steps->largest[0]) * largest_share(g, below), rest.size()};
    const double sup = result.level_zero + result.polynomial + result.below + g * result.step;
    result.error = sup <= infinite ? margin * g * g * g * sup : infinite;
    return result;
}

namespace {

/// Digits that G^3 and the defects' sum take from the tolerance of the mesh.
constexpr double spare_digits = 3;

/// The last one found: both what is asked for and its explanation want it.
Poisson kept(const Ball& G, Accuracy wanted)
{
    static std::mutex mutex;
    static std::string of;
    static double tolerance_of = 1;
    static Poisson last;
    const std::lock_guard lock(mutex);
    const double tolerance = std::pow(10.0, -static_cast<double>(std::max(6L, wanted.digits)) - spare_digits);
    const std::string which = G.dump();
    if (which != of || tolerance < tolerance_of) {
        last = solve_poisson(G, tolerance);
        of = which;
        tolerance_of = tolerance;
    }
    return last;
}

} // namespace

Ball area_constant_by_poisson(const std::function<Ball()>& G, Accuracy wanted)
{
    const WorkingPrecision precision(256);
    const Poisson p = kept(G(), wanted);
    Ball C = p.c;
    if (!(p.error < 1)) throw BeyondReach("the residual of Poisson's equation is too large");
    arb_add_error(C.get(), Ball::exactly(p.error).get());
    return C;
}

std::string area_constant_by_poisson_certificate(const std::function<Ball()>& G, Accuracy wanted)
{
    const WorkingPrecision precision(256);
    const Poisson p = kept(G(), wanted);
    return fmt::format("C(G) = c +- (G^3 sup T|R_1| + G^4 sup T^2|R_2|), R_1 + R_2 = B_0 - c x - Phi + G T Phi (docs/limit.md, theorem 4), on {} panels\n"
                       "  T of |B_0 - its polynomial| <= {:.2e}, T^2 of the step's defect <= {:.2e}, of the rest on the mesh <= {:.2e}, below it <= {:.2e}; |C - c| <= {:.2e}\n",
                       p.panels, p.level_zero, p.step, p.polynomial, p.below, p.error);
}

namespace {

/// The limit of a sequence by Wynn's epsilon-algorithm, where the last two of a column are nearest to one another.
Witness extrapolated(std::vector<Ball> now)
{
    std::vector<Ball> before(now.size() + 1, Ball(0));
    Ball best = now.back(), error = abs(now.back() - now[now.size() - 2]) * static_cast<long>(now.size());
    for (long column = 1; now.size() > 2; ++column) {
        std::vector<Ball> next;
        for (std::size_t i = 0; i + 1 < now.size(); ++i) next.push_back(before[i + 1] + 1 / (now[i + 1] - now[i]));
        before = std::move(now);
        now = std::move(next);
        if (column % 2 != 0 || now.size() < 2) continue;
        const Ball change = abs(now.back() - now[now.size() - 2]);
        if (!change.is_finite()) break;
        if (certainly(less(change, error))) {
            best = now.back();
            error = change;
        }
    }
    Ball value;
    arb_get_mid_arb(value.get(), best.get());
    return {value, error};
}

} // namespace

Witness area_constant_extrapolated(const Ball& G)
{
    constexpr long scales = 60, fewest = 16;
    const WorkingPrecision precision(256);
    const Ball load = Ball(1) / 2, settled = Ball(Rational(1, 100'000'000'000'000));
    std::vector<Ball> h;
    Witness found;
    for (long n = 0; n <= scales; ++n) {
        Ball value;
        arb_get_mid_arb(value.get(), (estimated_area(Grid::blind, n, load, G).value * pow(G, Ball(n)) / load).get());
        h.push_back(value);
        if (n < fewest || n % 4 != 0) continue;
        found = extrapolated(h);
        if (certainly(less(found.error, settled))) break;
    }
    return {found.value, 10 * found.error + abs(found.value) * Ball(Rational(1, 10'000'000'000'000'000))}; // the areas themselves are estimates
}

} // namespace touchstone::limit
