// SPDX-License-Identifier: MIT
#include "touchstone/recursion/from_the_edge/levels.hpp"

#include "touchstone/recursion/from_the_edge/far_end.hpp"
#include "touchstone/scalar/refusal.hpp"
#include "touchstone/transfer/progress.hpp"

namespace touchstone::transfer::from_the_edge {

const Settings& settings(Law law)
{
    static const Settings density{
        {16, 8, 5.66, 4, 2.83, 2.4, 2, 1.75, 1.5, 1.3, 1.15, 1.07, 1.03}, 8, 76, 4, false, {14, 9, 6.5, 4.8, 3.6, 2.8, 2.2}, 64};
    static const Settings exceedance{
        {15, 7, 5, 3.5, 3, 2.5, 2.1, 1.8, 1.5, 1.3, 1.15, 1.07, 1.03}, 9, 81, 4, true, {12, 8, 5.6, 4.2, 3.2, 2.5, 2}, 72};
    return law == Law::density ? density : exceedance;
}

double Levels::far_end(Law law, double accuracy, double G, double load)
{
    const double smallness = accuracy + 12 + static_cast<double>(Forward::largest_n + 1) * std::log(G) - std::log(load);
    const double of_density = accuracy + 40 + 30 * std::max(0.0, -std::log10(1 - 4 / (G * G))) - 0.75 * std::log(load);
    return std::max(8.0, law == Law::density ? of_density : 2 * smallness);
}

Levels::Levels(Law l, const Ball& G_, const Ball& load_, double a)
    : law(l)
    , accuracy(a)
    , epsilon(std::exp(-a) / 64)
    , most_points(4 * static_cast<long>(static_cast<double>(settings(l).most_points) * std::max(a / 80, 1.0) / 4) +
                  settings(l).most_points % 4)
    , most_gauss(static_cast<long>(static_cast<double>(settings(l).most_gauss) * std::max(a / 80, 1.0)))
    , precision(WorkingPrecision::bits())
    , wide(precision + most_points * 4 / 3 + 14)
    , format(precision + most_points * 4 / 3)
    , xi_fixed(static_cast<std::size_t>(format.limbs()))
    , sum_fixed(xi_fixed)
    , product_fixed(xi_fixed)
    , scratch(2 * xi_fixed.size())
    , G(G_)
    , load(load_)
    , full(arb_is_one(load.get()))
    , G_d(about(G))
    , load_d(about(load))
    , beta(l == Law::density ? 1.5 : 0.5)
    , delta_max(far_end(l, a, G_d, load_d))
    , shells(std::exp2(-static_cast<double>(Forward::largest_n) - 5), 16 * delta_max)
{
    levels.resize(2);
    levels[1] = first_level();
}

Ball Levels::wallis(long m)
{
    return sqrt(Traits::pi()) / 2 * Traits::gamma(Traits::quotient(m + 1, 2)) / Traits::gamma(Traits::quotient(m + 2, 2));
}

const std::vector<double>& Levels::chebyshev_table(long n)
{
    auto& T = chebyshev_at[n];
    if (T.empty())
        for (long i = 0; i < n; ++i)
            for (long j = 0; j < n; ++j)
                T.push_back(std::cos(std::numbers::pi * static_cast<double>(i * (2 * j + 1) % (4 * n)) / static_cast<double>(2 * n)));
    return T;
}

const std::vector<Ball>& Levels::monomial_matrix(long n)
{
    auto& A = to_monomials[n];
    if (!A.empty()) return A;
    const auto N = static_cast<std::size_t>(n);
    A.resize(N * N);
    std::vector<Ball> t0(N), t1(N), t2(N); // coefficients of T_i
    t0[0] = 1;
    t1[std::min<std::size_t>(1, N - 1)] = 1;
    for (std::size_t i = 0; i < N; ++i) {
        for (std::size_t j = 0; j < N; ++j) {
            const Ball c = Traits::cos_pi(Traits::quotient(static_cast<long>(i * (2 * j + 1)), 2 * n)) * (i == 0 ? 1 : 2) / n;
            for (std::size_t p = i % 2; p <= i; p += 2) A[p * N + j] += t0[p] * c;
        }
        for (std::size_t p = 0; p < N; ++p) t2[p] = (p == 0 ? Ball(0) : 2 * t1[p - 1]) - t0[p];
        t0 = t1;
        t1 = t2;
    }
    return A;
}

double Levels::ellipse_bound(const Level& to, double a, double b, bool logarithmic, double rho, bool whole) const
{
    const Boxes& boxes = to.boxes;
    const double lo = logarithmic ? std::log(a) : a, hi = logarithmic ? std::log(b) : b;
    const double mid = (lo + hi) / 2, half = up((hi - lo) / 2);
    constexpr int arcs = 40;
    double most = 0;
    for (int i = 0; i < arcs && std::isfinite(most); ++i) {
        const auto [x, y, radius] = arc_of_ellipse(mid, half, rho, i, arcs);
        if (logarithmic) {
            if (y + radius > 3.1) return infinity;
            const double outer = up(std::exp(x + radius)), least = std::max(0.0, y - radius);
            const double back =
                whole ? std::exp((std::max(0.0, outer * std::cos(least)) + static_cast<double>(to.k) * (x + radius)) / 2) * (1 + 1e-6) : 1;
            most = std::max(most, back * lookup(boxes, {down(std::exp(x - radius)), outer, least, y + radius}));
        }
        else most = std::max(most, (whole ? up(std::exp((x + radius) / 2)) : 1) * lookup(boxes, polar(x, y, radius)));
    }
    return most;
}

Levels::Choice Levels::choose(const Level& from, const Level& to, double a, double b, bool logarithmic, bool whole) const
{
    static constexpr std::array rhos{12.0, 9.5, 7.6, 6.2, 5.0, 4.1, 3.4, 2.8, 2.35, 2.0, 1.75, 1.55};
    const double at_b = estimate_step(from, b);
    const double goal =
        std::max(smallest_bound, epsilon * (whole && logarithmic ? std::pow(b, static_cast<double>(to.k) / 2) * at_b
                                                                 : std::min(estimate_step(from, a == 0 ? b * 1e-3 : a), at_b)));
    const Settings& set = settings(law);
    Choice best;
    for (const double rho : rhos) {
        const double U = ellipse_bound(to, a, b, logarithmic, rho, whole);
        if (!std::isfinite(U)) continue;
        long n = 1 + static_cast<long>(std::ceil(std::max(std::log(4 * U / (rho - 1)) - std::log(goal), 0.0) / std::log(rho)));
        n = set.least_points + std::max(0L, (n - set.least_points + set.step_points - 1) / set.step_points) * set.step_points;
        if (n < best.points) best = {b, rho, U, n};
    }
    return best;
}

void Levels::extend_to(long k)
{
    while (static_cast<long>(levels.size()) <= k) {
        const WorkingPrecision scope(precision);
        levels.push_back(next(*levels.back()));
        progress("distribution, scale", static_cast<long>(levels.size()) - 1, k);
    }
}

std::unique_ptr<Level> Levels::next(const Level& from, double whole_until)
{
    const bool whole = whole_until > 0;
    auto to = std::make_unique<Level>();
    to->k = from.k + 1;
    to->edge = 2 / G * sqrt(from.edge);
    to->C = constant_after(from);
    {
        const WorkingPrecision low(bound_bits);
        to->edge_bound = to->edge + Ball(0);
    }
    to->tail = next_tail(from.k, from.edge_bound, from.tail, load_d);
    bound_boxes(from, *to);
    const Settings& set = settings(law);
    const double disc_radius = shells.radius(to->boxes.disc);
    double a = 0;
    const double end = whole ? whole_until : delta_max;
    while (a < end) {
        Choice best;
        bool logarithmic = false;
        if (a == 0) {
            for (double b = 8 * disc_radius; b > disc_radius / 64; b /= std::numbers::sqrt2) {
                best = choose(from, *to, 0, b, false, whole);
                if (best.points <= most_points) break;
            }
        }
        else {
            double merit = 0;
            for (const double ratio : set.ratios) {
                const double b = std::min(a * ratio, whole ? end : 1.5 * delta_max); // rows reach 2b, boxes 16 delta_max
                const Choice c = choose(from, *to, a, b, set.logarithmic, whole);
                if (c.points > most_points) continue;
                const double m = std::log(b / a) / static_cast<double>(c.points);
                if (m > merit) {
                    merit = m;
                    best = c;
                }
            }
            logarithmic = set.logarithmic;
        }
        if (best.points > most_points || to->panels.size() > 400)
            throw BeyondReach("the distribution's region of analyticity is too narrow here; the load is too near 1 or G too near 2");
        auto panel = std::make_unique<Panel>();
        panel->a = a;
        panel->b = best.b;
        panel->logarithmic = logarithmic;
        const Ball lo = logarithmic ? log(Ball::exactly(a)) : Ball::exactly(a),
                   hi = logarithmic ? log(Ball::exactly(best.b)) : Ball::exactly(best.b);
        panel->mid = (lo + hi) / 2;
        panel->half = (hi - lo) / 2;
        panel->mid_d = about(panel->mid);
        panel->half_d = about(panel->half);
        panel->points = best.points;
        panel->rho = best.rho;
        panel->bound = best.bound;
        const double n = static_cast<double>(best.points), r = best.rho, q = 1 / r;
        panel->interpolation = up_at_end(product_of_bounds({4 * best.bound / (r - 1), std::pow(r, 1 - n)}));
        // sum_{k >= N} 2 U rho^-k (k^2 + N^2) <= 4 U sum k^2 rho^-k
        panel->slope = up_at_end(product_of_bounds(
            {4 * best.bound * (n * n + 2 * n * q / (1 - q) + q * (1 + q) / ((1 - q) * (1 - q))) / (1 - q), std::pow(q, n)}));
        fill_panel(from, *to, *panel, whole);
        a = best.b;
        to->panels.push_back(std::move(panel));
    }
    std::vector<std::pair<double, double>> known;
    for (std::size_t i = 0; i < to->log_d.size(); ++i) known.emplace_back(to->log_d[i], to->log_v[i]);
    std::sort(known.begin(), known.end());
    for (std::size_t i = 0; i < known.size(); ++i) std::tie(to->log_d[i], to->log_v[i]) = known[i];
    return to;
}

void Levels::make_fixed(Panel& panel) const
{
    const WorkingPrecision scope(wide);
    Ball sum(0);
    for (long j = 0; j < panel.points; ++j) {
        Ball c;
        arb_abs(c.get(), panel.polynomial->coeffs + j);
        sum += c;
    }
    mag_t size;
    mag_init(size);
    arb_get_mag(size, sum.get());
    panel.scale = mag_is_zero(size) ? 0 : static_cast<long>(MAG_EXP(size)) - 14;
    mag_clear(size);
    const auto limbs = static_cast<std::size_t>(format.limbs());
    panel.fixed.resize(static_cast<std::size_t>(panel.points) * limbs);
    mag_set_ui(panel.fixed_error, static_cast<ulong>(panel.points) * (3 + (1UL << 14)));
    mag_mul_2exp_si(panel.fixed_error, panel.fixed_error, panel.scale - format.fraction());
    mag_t radius;
    mag_init(radius);
    for (long j = 0; j < panel.points; ++j) {
        Ball c;
        arb_set(c.get(), panel.polynomial->coeffs + j);
        mag_add(radius, radius, arb_radref(c.get()));
        arb_mul_2exp_si(c.get(), c.get(), -panel.scale);
        format.put(panel.fixed.data() + static_cast<std::size_t>(panel.points - 1 - j) * limbs, c);
    }
    mag_add(panel.fixed_error, panel.fixed_error, radius);
    mag_clear(radius);
}

void Levels::evaluate(const Panel& panel, const Ball& xi, Ball& u)
{
    const auto limbs = static_cast<std::size_t>(format.limbs());
    const auto size = static_cast<mp_size_t>(limbs);
    const double x = about(xi);
    if (!(std::fabs(x) < 1)) { // xi = +-1 by rounding: the rule is proven for |xi| <= 1
        arb_poly_evaluate(u.get(), panel.polynomial, xi.get(), wide);
        return;
    }
    format.put(xi_fixed.data(), xi);
    std::copy_n(panel.fixed.data(), limbs, sum_fixed.data());
    for (std::size_t j = 1; j < static_cast<std::size_t>(panel.points); ++j) {
        format.multiply(product_fixed.data(), sum_fixed.data(), xi_fixed.data(), 0, scratch.data());
        mpn_add_n(sum_fixed.data(), product_fixed.data(), panel.fixed.data() + j * limbs, size);
    }
    fmpz_t units;
    fmpz_init(units);
    format.get(units, sum_fixed.data());
    arb_set_fmpz(u.get(), units);
    fmpz_clear(units);
    arb_mul_2exp_si(u.get(), u.get(), panel.scale - format.fraction());
    mag_t e; // xi's radius times sum j |c_j|
    mag_init(e);
    mag_mul_ui(e, arb_radref(xi.get()), static_cast<ulong>(panel.points));
    mag_mul_2exp_si(e, e, panel.scale + 14);
    mag_add(e, e, panel.fixed_error);
    mag_add(arb_radref(u.get()), arb_radref(u.get()), e);
    mag_clear(e);
}

void Levels::fill_panel(const Level& from, Level& to, Panel& panel, bool whole)
{
    const long n = panel.points;
    const auto N = static_cast<std::size_t>(n);
    std::vector<Ball> values(N);
    panel.errors.resize(N);
    std::vector<Ball> at(N);
    std::vector<double> at_d(N);
    for (std::size_t j = 0; j < N; ++j) {
        at[j] = panel.mid + panel.half * Traits::cos_pi(Traits::quotient(static_cast<long>(2 * j + 1), 2 * n));
        if (panel.logarithmic) at[j] = exp(at[j]);
        at_d[j] = about(at[j]);
    }
    RowRule rule;
    for (std::size_t j = 0; j < N; ++j) { // descending d
        const double d = at_d[j];
        if (!rule.holds(at[j])) {
            const double low = panel.a == 0 && d < panel.b / 12 ? 0 : d / 1.09;
            const double relaxed = whole ? epsilon : std::min(epsilon * std::exp(std::min(beta * low, 600.0)), 1e-3);
            rule = make_rule(from, Kind::step, low, d, 0, relaxed * estimate_step(from, d));
        }
        const Row r = row(from, Kind::step, at[j], rule);
        to.row_nodes += rule.nodes.size();
        const Ball decay =
            whole ? panel.logarithmic ? half_power(at[j], to.k) : Ball(1) : exp(-at[j] * Traits::quotient(law == Law::density ? 3 : 1, 2));
        Ball u = r.value;
        widen(u, r.error);
        u *= decay;
        const double decay_d = above(decay);
        panel.errors[j] = u.is_finite() ? up(std::max(u.radius_bound(), smallest_bound)) : infinity;
        panel.worst = std::max(panel.worst, panel.errors[j]);
        arb_get_mid_arb(values[j].get(), u.get());
        if (!std::isfinite(panel.errors[j])) throw BeyondReach("the distribution is not resolved at this precision");
        to.log_d.push_back(std::log(d));
        to.log_v.push_back(std::log(std::fabs(about(r.value))));
        const double unit = std::fabs(about(whole ? values[0] : r.value));
        to.worst_row = std::max(to.worst_row, r.rule_error * decay_d / unit);
        to.worst_carried = std::max(to.worst_carried, (r.interpolation + r.carried) * decay_d / unit);
        to.worst_total = std::max(to.worst_total, panel.errors[j] / unit);
        to.worst_interpolation = std::max(to.worst_interpolation, panel.interpolation / unit);
    }
    to.nodes += N;
    const WorkingPrecision scope(wide);
    const auto& A = monomial_matrix(n);
    arb_poly_fit_length(panel.polynomial, n);
    for (std::size_t p = 0; p < N; ++p) {
        arb_ptr c = panel.polynomial->coeffs + p;
        arb_zero(c);
        for (std::size_t j = 0; j < N; ++j) arb_addmul(c, A[p * N + j].get(), values[j].get(), wide);
    }
    _arb_poly_set_length(panel.polynomial, n);
    if (!whole) make_fixed(panel);
}

} // namespace touchstone::transfer::from_the_edge
