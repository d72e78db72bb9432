// SPDX-License-Identifier: MIT
// Compiled with -ffp-contract=off, as scalar/double_double.hpp asks.
#include "touchstone/limit/limit_law.hpp"

#include "touchstone/limit/chebyshev.hpp"
#include "touchstone/transfer/parallel.hpp"
#include "touchstone/wave/wave.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace touchstone::limit {
namespace {

using std::numbers::pi;

Vector chebyshev_points(int count)
{
    Vector at;
    for (int k = 0; k < count; ++k) at.push_back(std::cos(pi * (2 * k + 1) / (2 * count)));
    return at;
}

/// l_0(t) ... l_(order-1)(t) of the Chebyshev points of the first kind.
void lagrange(const Vector& points, double t, Vector& out)
{
    const std::size_t count = points.size();
    double sum = 0;
    for (std::size_t k = 0; k < count; ++k) {
        const double off = t - points[k];
        if (off == 0) {
            std::fill(out.begin(), out.end(), 0.);
            out[k] = 1;
            return;
        }
        out[k] = (k % 2 == 0 ? 1 : -1) * std::sin(pi * (2. * static_cast<double>(k) + 1) / (2. * static_cast<double>(count))) / off;
        sum += out[k];
    }
    for (double& l : out) l /= sum;
}

/// Gauss-Legendre on [-1, 1].
struct Rule {
    Vector at, weight;
    explicit Rule(int count)
    {
        const transfer::Gauss wide(count);
        at = wide.nodes.high;
        weight = wide.weights.high;
    }
};

/// One wave at ratio x: the angle at which y is met, y at an angle, and the weight of force there.
struct Wave {
    double x, G;
    bool full() const { return x >= 1; }
    double highest() const { return full() ? (x + 1) / G : 2 * std::sqrt(x) / G; }
    double lowest() const { return full() ? (x - 1) / G : 0; }
    double last_angle() const { return full() ? pi : pi / 2; }
    double angle(double y) const
    {
        const double P = G * y;
        if (full()) return 2 * std::atan2(std::sqrt(std::max(0., 1 + x - P)), std::sqrt(std::max(0., P - x + 1)));
        const double R = wave::radius<double>(1 - x, P * P),
                     v = std::max(0., wave::one_minus_c_partial<double>(x, R, P * P) / (2 * x)); // sin^2 psi
        return std::atan2(std::sqrt(v), std::sqrt(P * P / (4 * x * (1 - x * v))));
    }
    double ratio(double angle) const
    {
        const double c = std::cos(angle), s = std::sin(angle);
        return full() ? (x + c) / G : 2 / G * std::sqrt(wave::quarter_pressure_squared<double>(x, s * s, c * c));
    }
    double weight(double angle) const
    {
        const double c = std::cos(angle);
        return full() ? (1 + c / x) / pi : 4 / pi * c * c;
    }
};

} // namespace

LimitLaw::LimitLaw(const Ball& G, const Grading& grading, int order)
    : G_(double(transfer::to_real(G)))
    , order_(order)
    , points_(chebyshev_points(order))
{
    for (const auto& p : graded_panels(G, grading)) {
        if (edges_.empty()) edges_.push_back(double(p.y0));
        if (double(p.y1) > edges_.back()) edges_.push_back(double(p.y1));
    }
    for (std::size_t j = 0; j + 1 < edges_.size(); ++j)
        for (const double t : points_) nodes_.push_back((edges_[j] + edges_[j + 1]) / 2 + (edges_[j + 1] - edges_[j]) / 2 * t);
    matrix_.resize(nodes_.size() * nodes_.size());
    transfer::in_parallel(nodes_.size(), [&](std::size_t i) { fill_row(i); });

    // w - w M = 0, sum w = 1: a correction of equal weights
    const std::size_t n = nodes_.size();
    const auto before = [&](const Vector& w) {
        Vector result(n);
        for (std::size_t i = 0; i < n; ++i)
            for (std::size_t j = 0; j < n; ++j) result[j] += w[i] * matrix_[i * n + j];
        return result;
    };
    const auto moved = [&](const Vector& w) {
        Vector result = w;
        add(result, -1, before(w));
        return result;
    };
    weights_.assign(n, 1 / static_cast<double>(n));
    for (int again = 0; again < 2; ++again) {
        Vector off = moved(weights_);
        add(weights_, -1, gmres(moved, off, 1e-13, 200));
    }
    double sum = 0;
    for (const double w : weights_) sum += w;
    for (double& w : weights_) w /= sum;
}

void LimitLaw::fill_row(std::size_t i)
{
    const Wave wave{nodes_[i], G_};
    static const int nodes_beyond = 2;
    thread_local int made_for = 0;
    thread_local Rule rule(1);
    thread_local Vector l;
    if (made_for != order_) {
        rule = Rule(order_ + nodes_beyond);
        l.resize(points_.size());
        made_for = order_;
    }
    double* row = &matrix_[i * nodes_.size()];
    double sum = 0;
    const double low = wave.lowest(), high = wave.highest();
    for (std::size_t j = 0; j + 1 < edges_.size(); ++j) {
        const bool last = j + 2 == edges_.size();
        const double a = edges_[j], b = edges_[j + 1];
        if (b <= low || a >= high) continue;
        const double from = b >= high || last ? 0 : wave.angle(b), to = a <= low ? wave.last_angle() : wave.angle(a);
        const double middle = (from + to) / 2, half = (to - from) / 2;
        for (std::size_t q = 0; q < rule.at.size(); ++q) {
            const double at = middle + half * rule.at[q], weight = half * rule.weight[q] * wave.weight(at);
            lagrange(points_, std::clamp((2 * wave.ratio(at) - a - b) / (b - a), -1., 1.), l);
            for (std::size_t k = 0; k < l.size(); ++k) row[j * l.size() + k] += weight * l[k];
            sum += weight;
        }
    }
    for (std::size_t j = 0; j < nodes_.size(); ++j) row[j] /= sum; // what is below the first panel
}

Vector LimitLaw::after(const Vector& f) const
{
    const std::size_t n = nodes_.size();
    Vector result(n);
    for (std::size_t i = 0; i < n; ++i) {
        double sum = 0;
        for (std::size_t j = 0; j < n; ++j) sum += matrix_[i * n + j] * f[j];
        result[i] = sum;
    }
    return result;
}

double LimitLaw::mean(const std::function<double(double)>& f) const
{
    double sum = 0;
    for (std::size_t i = 0; i < nodes_.size(); ++i) sum += weights_[i] * f(nodes_[i]);
    return sum;
}

Vector LimitLaw::solve(const Vector& f) const
{
    const Vector one(nodes_.size(), 1.);
    Vector right = f;
    add(right, -dot(weights_, f), one);
    Vector d = gmres(
        [&](const Vector& v) {
            Vector result = v;
            add(result, -1, after(v));
            return result;
        },
        right, 1e-12, 200);
    add(d, -dot(weights_, d), one);
    return d;
}

std::pair<double, double> LimitLaw::second_eigenvalue() const
{
    constexpr int most = 400, first = 10;
    constexpr double settled = 1e-12;
    Vector v = nodes_;
    for (double& x : v) x = std::log(x);
    const Vector one(nodes_.size(), 1.);
    double before = 0, now = 0, change = 1;
    for (int k = 0; k < most && !(k > first && change < settled); ++k) {
        add(v, -dot(weights_, v), one);
        const Vector next = after(v);
        now = dot(v, next) / dot(v, v);
        change = std::fabs(now - before);
        before = now;
        const double size = std::sqrt(dot(next, next));
        v = next;
        for (double& x : v) x /= size;
    }
    return {now, change};
}

LimitLaw::Interpolant::Interpolant(const LimitLaw& law_, const Vector& values) : law(law_), coefficients(values.size())
{
    const std::size_t order = law.points_.size();
    for (std::size_t first = 0; first < values.size(); first += order)
        for (std::size_t k = 0; k < order; ++k) {
            double sum = 0;
            for (std::size_t i = 0; i < order; ++i)
                sum += values[first + i] *
                       std::cos(pi * static_cast<double>(k) * (2 * static_cast<double>(i) + 1) / (2 * static_cast<double>(order)));
            coefficients[first + k] = sum * (k == 0 ? 1 : 2) / static_cast<double>(order);
        }
}

double LimitLaw::Interpolant::operator()(double x) const
{
    const Vector& edges = law.edges_;
    const std::size_t order = law.points_.size(), last = edges.size() - 2;
    const auto above = static_cast<std::size_t>(std::upper_bound(edges.begin(), edges.end(), x) - edges.begin());
    const std::size_t j = std::min(last, above == 0 ? 0 : above - 1);
    const double t = std::clamp((2 * x - edges[j] - edges[j + 1]) / (edges[j + 1] - edges[j]), -1., 1.);
    return chebyshev_sum(&coefficients[j * order], order, t);
}

namespace {

/// That the chain of ratios comes back to.
double highest_ratio(const Ball& G)
{
    const double g = double(transfer::to_real(G));
    return g >= 2 ? 4 / (g * g) : 1 / (g - 1);
}

} // namespace

Witness mean_in_the_limit(const Ball& G, const std::vector<Ball>& further, const std::function<double(double)>& f)
{
    const double highest = highest_ratio(G);
    const auto by = [&](double lowest, double tolerance, int order) {
        return LimitLaw(G, {lowest, highest, tolerance, further}, order).mean(f);
    };
    const double value = by(1e-10, 1e-6, 10), coarse = by(1e-8, 1e-4, 6);
    return {Ball::exactly(value), Ball::exactly(4 * std::fabs(value - coarse)) + Ball::exactly(1e-13 * std::fabs(value))};
}

Witness distance_in_the_mean(const Ball& G, double load, long n, const std::vector<Ball>& further, const std::function<double(double)>& f,
                             const std::function<double(double)>& g)
{
    const double highest = std::max(1.01 * load, highest_ratio(G));
    const auto by = [&](double lowest, double tolerance, int order) {
        const LimitLaw law(G, {std::min(lowest, load / 4), highest, tolerance, further}, order);
        const auto over = [&](const std::function<double(double)>& of, double limit) { // the mean over x_n, less the limit
            Vector v;
            for (const double x : law.nodes()) v.push_back(of(x) - limit);
            for (long k = 0; k < n; ++k) v = law.after(v);
            return LimitLaw::Interpolant(law, v)(load);
        };
        const double of_f = law.mean(f), of_g = law.mean(g), off_f = over(f, of_f), off_g = over(g, of_g);
        return (off_f - off_g * of_f / of_g) / (of_g + off_g);
    };
    const double value = by(1e-10, 1e-6, 10), coarse = by(1e-8, 1e-4, 6);
    return {Ball::exactly(value), Ball::exactly(4 * std::fabs(value - coarse) + 1e-13)};
}

double density_after_two_waves(double G, double P, double x)
{
    constexpr int points = 240; // of the midpoint rule; inverse square roots at the ends of a part become smooth
    const Wave wave{x, G};
    const double lower = P < 2 ? P * P / 4 : P - 1, upper = P + 1;
    std::vector<double> cuts{wave.last_angle()};
    for (const double y : {lower, 1., upper})
        if (y > std::max(lower, wave.lowest()) * (1 - 1e-15) && y < wave.highest()) cuts.push_back(wave.angle(y));
    cuts.push_back(0);
    std::sort(cuts.begin(), cuts.end());
    double sum = 0;
    for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
        const double length = cuts[k + 1] - cuts[k];
        for (int i = 0; i < points; ++i) {
            const double phi = pi * (i + 0.5) / points, angle = cuts[k] + length * (1 - std::cos(phi)) / 2, y = wave.ratio(angle);
            if (!(y > lower && y < upper)) continue;
            const double R = std::hypot(1 - y, P);
            const double density = y >= 1 ? 1 / (pi * std::sqrt((y - P + 1) * (upper - y)))
                                          : P / (2 * pi * R) * std::sqrt((1 + y + R) / ((1 - y + R) * (y - P * P / 4)));
            const double share =
                wave.full() ? 1 / pi
                            : 2 / pi * std::sqrt(x) * std::cos(angle) / std::sqrt(1 - x * std::sin(angle) * std::sin(angle)); // of length
            sum += share * density * length / 2 * std::sin(phi) * pi / points;
        }
    }
    return sum;
}

double exceedance_over_x(double P, double x)
{
    const double c = x >= 1 ? P - x : std::hypot(1 - x, P) - x; // cos theta where the pressure is P
    return c >= 1 ? 0 : std::acos(std::max(-1., c)) / (pi * x);
}

Witness area_constant_by_law(const Ball& G)
{
    return mean_in_the_limit(G, {}, [](double x) { return x < 1 ? 2 / pi * std::asin(std::sqrt(x)) / x : 1 / x; });
}

} // namespace touchstone::limit
