// SPDX-License-Identifier: MIT
#include "touchstone/certificate/discrete_operator.hpp"

#include "touchstone/certificate/text.hpp"
#include "touchstone/transfer/parallel.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace touchstone::certificate {
namespace {

using Traits = ScalarTraits<Ball>;
constexpr long guard_bits = 64;

Ball from_units(const mpz_class& n, long bits)
{
    Ball r;
    fmpz_t f;
    fmpz_init(f);
    fmpz_set_mpz(f, n.get_mpz_t());
    arb_set_fmpz(r.get(), f);
    fmpz_clear(f);
    arb_mul_2exp_si(r.get(), r.get(), -bits);
    return r;
}

Rational dyadic_floor(double x, int bits)
{
    Rational r(mpz_class(std::floor(std::ldexp(x, bits))));
    mpz_mul_2exp(r.get_den_mpz_t(), r.get_den_mpz_t(), static_cast<mp_bitcnt_t>(bits));
    r.canonicalize();
    return r;
}

/// sum += weight T_i(t), all i
void add_chebyshev(std::vector<mpz_class>& sum, const mpz_class& t, const mpz_class& weight, long bits)
{
    const auto shift = static_cast<mp_bitcnt_t>(bits);
    mpz_class u = weight, before, next;
    sum[0] += u;
    if (sum.size() < 2) return;
    before = u;
    u = weight * t;
    mpz_fdiv_q_2exp(u.get_mpz_t(), u.get_mpz_t(), shift);
    sum[1] += u;
    for (std::size_t i = 2; i < sum.size(); ++i) {
        mpz_mul(next.get_mpz_t(), t.get_mpz_t(), u.get_mpz_t());
        mpz_fdiv_q_2exp(next.get_mpz_t(), next.get_mpz_t(), shift - 1);
        next -= before;
        swap(before, u);
        swap(u, next);
        sum[i] += u;
    }
}

/// What is claimed of x: somewhat more, for x was found in binary64, and a number of 12 bits.
double few_bits_above(double x)
{
    constexpr double more = 1.002;
    int e = 0;
    const double m = std::frexp(more * x, &e);
    return std::ldexp(std::ceil(std::ldexp(m, 12)), e - 12);
}

double lebesgue(long terms) { return 1 + 0.45 * std::floor(std::log2(static_cast<double>(terms)) + 1); }
/// At least exp(t) as the checker has it: the next power of two.
double power_above(double t) { return std::exp2(std::ceil(1.4431 * t)); }
double growth(long m) { return std::exp2(-static_cast<double>(m) - 1); } ///< |h_m| <= G exp(growth s)

} // namespace

Ball Grid::G() const { return root.degree == 1 ? Ball(root.base) : pow(Ball(root.base), 1 / Ball(static_cast<long>(root.degree))); }

Grid grid_for(const Root& root, long n, double digits, const Rational& least_load, const Rational& largest_load)
{
    constexpr double spare = 5, per_level = 1.44, step_bits = 12, edge_bits = 20;
    Grid g;
    g.root = root;
    const double G = nearest(g.G()), L = std::log(G / 2), s_load = -std::log(least_load.get_d());
    const double nats = digits * std::numbers::ln10 + per_level * static_cast<double>(n) + spare + 2 * L + s_load / 4;
    g.bits = static_cast<long>(nats / std::numbers::ln2) + 90;
    g.kept_bits = static_cast<long>(nats / std::numbers::ln2) + 24;
    const double strip = std::acos(std::sqrt(std::max(0.75, 2 / G)));
    g.step = dyadic_floor(2 * std::numbers::pi * strip / nats, static_cast<int>(step_bits));
    g.points = static_cast<long>(nats / 2 / g.step.get_d()) + 1;
    g.terms = static_cast<long>(nats / std::log(ellipse().get_d())) + 3;
    g.edges = {dyadic_floor(L - 1e-5, static_cast<int>(edge_bits))};
    const Rational rest = 1 - largest_load; // towards load = 1 the last points of the rule come to twice the s they have elsewhere
    const double farther = rest > 0 ? std::min(nats / 2, -std::log(rest.get_d()) / 2) : nats / 2;
    while (g.edges.back().get_d() < 2 * L + nats / 2 + s_load / 2 + farther) g.edges.push_back(2 * g.edges.back());
    return g;
}

DiscreteOperator::DiscreteOperator(const Grid& grid)
    : grid_(grid)
{
    // one precision serves loads next to 1 too, where 1 - x u^2 becomes as small as the last q
    const double v = grid.step.get_d() * static_cast<double>(grid.points);
    const WorkingPrecision precision(grid.bits + static_cast<long>(3 * v) + guard_bits);
    G_ = nearest(grid.G());
    log_half_G_ = std::log(G_ / 2);
    const Ball step(grid.step), weight = 4 / Traits::pi() * step;
    for (long k = 0; k <= grid.points; ++k) {
        Node node;
        arb_sech(node.q.get(), (k * step).get(), WorkingPrecision::bits());
        const Ball sech = node.q;
        node.q = sech * sech;
        node.minus_log_q = -log(node.q);
        node.real_weight = k == 0 ? weight / 2 : weight * node.q * sech;
        node.weight = units(node.real_weight, grid.bits);
        nodes_.push_back(std::move(node));
    }
    const double strip = std::acos(std::sqrt(std::max(0.75, 2 / G_)));
    quadrature_ = G_ * (9 * std::exp(-2 * std::numbers::pi * strip / grid.step.get_d()) + 3 * std::exp(-2 * v));
    for (long j = 0; j < grid.terms; ++j) {
        points_.push_back(units(Traits::cos_pi(Ball(2 * j + 1) / Ball(2 * grid.terms)), grid.bits));
        std::vector<mpz_class> T(static_cast<std::size_t>(grid.terms));
        add_chebyshev(T, points_.back(), mpz_class(1) << static_cast<unsigned long>(grid.bits), grid.bits);
        powers_.push_back(std::move(T));
    }
}

Row DiscreteOperator::row(const Ball& s, const Ball& x, const Ball& rest, long bits) const
{
    Row r;
    r.s = nearest(s);
    r.bits = bits;
    const std::size_t panels = grid_.edges.size() - 1;
    r.sums.assign(panels, std::vector<mpz_class>(static_cast<std::size_t>(grid_.terms)));
    const WorkingPrecision precision(bits + guard_bits);
    const Ball base = s + 2 * log(grid_.G() / 2);
    std::vector<double> high;
    std::vector<mpz_class> middle, half;
    for (std::size_t p = 0; p < panels; ++p) {
        high.push_back(grid_.edges[p + 1].get_d());
        middle.push_back(units(Ball((grid_.edges[p] + grid_.edges[p + 1]) / 2), bits));
        half.push_back(units(Ball((grid_.edges[p + 1] - grid_.edges[p]) / 2), bits));
    }
    for (const Node& node : nodes_) {
        const mpz_class weight = bits == grid_.bits ? node.weight : units(node.real_weight, bits);
        const Ball s_y = (base + node.minus_log_q - log(rest + x * node.q)) / 2;
        const double place = nearest(s_y);
        const auto p = static_cast<std::size_t>(std::lower_bound(high.begin(), high.end(), place) - high.begin());
        if (p == panels) {
            r.beyond += std::ldexp(weight.get_d() + 1, -static_cast<int>(bits)) * power_above((std::floor(place) + 1) / 2);
            continue;
        }
        if (weight == 0) continue;
        mpz_class t = units(s_y, bits) - middle[p];
        t <<= static_cast<unsigned long>(bits);
        mpz_fdiv_q(t.get_mpz_t(), t.get_mpz_t(), half[p].get_mpz_t());
        add_chebyshev(r.sums[p], t, weight, bits);
    }
    const double lowest = std::max(nearest(rest), nearest(nodes_.back().q));
    r.moved = std::ldexp(32 + static_cast<double>(bits) + 8 / lowest + high.back(), -static_cast<int>(bits));
    return r;
}

Row DiscreteOperator::row_at(const Rational& load) const
{
    constexpr double near = 1.0 / (1 << 16); // the checker, too, then counts with more bits
    const double v = grid_.step.get_d() * static_cast<double>(grid_.points);
    const Rational rest = 1 - load;
    const long bits = grid_.bits + (rest.get_d() > near ? 0 : static_cast<long>(std::ceil(3 * v)));
    const WorkingPrecision precision(bits + guard_bits);
    return row(-log(Ball(load)), Ball(load), Ball(rest), bits);
}

Applied DiscreteOperator::apply(const Row& r, const Level& level) const
{
    Applied a{Ball(0), 0};
    mpz_class total;
    double rounding = 0;
    const double unit = std::ldexp(1.0, -static_cast<int>(r.bits)), points = static_cast<double>(grid_.points);
    for (std::size_t p = 0; p < r.sums.size(); ++p) {
        const auto& c = level.panels[p].coefficients;
        for (std::size_t i = 0; i < c.size(); ++i) {
            mpz_addmul(total.get_mpz_t(), c[i].get_mpz_t(), r.sums[p][i].get_mpz_t());
            rounding += std::fabs(c[i].get_d()) * std::ldexp(1.0, -static_cast<int>(grid_.kept_bits));
        }
        a.error += (r.sums[p][0].get_d() + points) * unit * level.panels[p].error;
    }
    a.value = from_units(total, r.bits + grid_.kept_bits);
    const double growing = growth(level.m), terms = static_cast<double>(grid_.terms);
    const double first = grid_.edges.front().get_d(), last = grid_.edges.back().get_d();
    a.error += unit * (points + 1) * (rounding * terms * terms + G_ * power_above(growing * last)) + r.beyond * G_;
    a.error += 2 * r.moved * G_ * power_above(growing * (last + 1)) / std::min(first / 2, 0.5);
    a.error += quadrature_ * power_above(growing / 2 * (r.s + 2 * log_half_G_));
    return a;
}

Polynomial DiscreteOperator::interpolate(std::size_t panel, long m, const std::vector<mpz_class>& values, double error) const
{
    Polynomial v;
    const auto terms = static_cast<std::size_t>(grid_.terms);
    double sum = 0;
    for (std::size_t i = 0; i < terms; ++i) {
        mpz_class c;
        for (std::size_t j = 0; j < terms; ++j) mpz_addmul(c.get_mpz_t(), values[j].get_mpz_t(), powers_[j][i].get_mpz_t());
        if (i > 0) c *= 2;
        c /= static_cast<long>(terms);
        mpz_fdiv_q_2exp(c.get_mpz_t(), c.get_mpz_t(), static_cast<mp_bitcnt_t>(2 * grid_.bits - grid_.kept_bits));
        sum += std::fabs(c.get_d());
        v.coefficients.push_back(std::move(c));
    }
    const double kept = std::ldexp(1.0, -static_cast<int>(grid_.kept_bits)), unit = std::ldexp(1.0, -static_cast<int>(grid_.bits));
    error += static_cast<double>(terms) * kept + (sum * kept + 1) * unit * static_cast<double>(terms * terms);
    const double rho = ellipse().get_d(), low = grid_.edges[panel].get_d(), high = grid_.edges[panel + 1].get_d();
    const double beyond = G_ * power_above(growth(m) * (low + high)) * 2 * rho / ((rho - 1) * std::pow(rho, static_cast<double>(terms)));
    v.error = few_bits_above(lebesgue(grid_.terms) * (error + beyond) + beyond);
    return v;
}

std::vector<Level> DiscreteOperator::levels(long n) const
{
    const std::size_t panels = grid_.edges.size() - 1, terms = points_.size();
    const long bits = grid_.bits;
    std::vector<Ball> s(panels * terms);
    for (std::size_t i = 0; i < s.size(); ++i) {
        const WorkingPrecision precision(bits + guard_bits);
        const Rational &low = grid_.edges[i / terms], &high = grid_.edges[i / terms + 1];
        s[i] = Ball((low + high) / 2) + Ball((high - low) / 2) * from_units(points_[i % terms], bits);
    }
    std::vector<Row> rows(n > 1 ? s.size() : 0);
    transfer::in_parallel(rows.size(), [&](std::size_t i) {
        const WorkingPrecision precision(bits + guard_bits);
        const Ball x = exp(-s[i]);
        rows[i] = row(s[i], x, 1 - x, bits);
    });
    std::vector<Level> all;
    for (long m = 0; m < n; ++m) {
        Level level{m, std::vector<Polynomial>(panels)};
        transfer::in_parallel(panels, [&](std::size_t p) {
            const WorkingPrecision precision(bits + guard_bits);
            std::vector<mpz_class> values;
            double error = 0;
            for (std::size_t j = 0; j < terms; ++j) {
                if (m == 0) { // h_0 = (2/pi) arcsin(sqrt x)/x
                    const Ball x = exp(-s[p * terms + j]);
                    values.push_back(units(2 / Traits::pi() * asin(sqrt(x)) / x, bits));
                    continue;
                }
                const Applied a = apply(rows[p * terms + j], all.back());
                values.push_back(units(a.value, bits));
                error = std::max(error, a.error);
            }
            level.panels[p] = interpolate(p, m, values, error);
        });
        all.push_back(std::move(level));
    }
    return all;
}

} // namespace touchstone::certificate
