// SPDX-License-Identifier: MIT
#include "touchstone/transfer/graded.hpp"

#include "touchstone/scalar/log_factorial.hpp"
#include "touchstone/scalar/refusal.hpp"
#include "touchstone/transfer/parallel.hpp"

namespace touchstone::transfer {
namespace {

/// log c_g
double strength(int g) { return g * std::log(0.4) - 0.5 * log_factorial(g); }

double floor_of(int g, const GradedRule& rule)
{
    return std::exp((std::log(rule.tolerance) + (g + 1) * std::log(static_cast<double>(rule.degree)) - strength(g)) / (0.5 * g + 1));
}

/// The longest interval that may have a point of generation g inside.
double longest(int g, const GradedRule& rule)
{
    return std::exp((std::log(rule.tolerance) + 0.5 * (g + 1) * std::log(2.0 * rule.degree) - strength(g)) / (0.5 * g + 1));
}

} // namespace

template <class Real>
int GradedGrid<Real>::generations(const GradedRule& rule)
{
    int g = 0;
    while (g < 30 && floor_of(g, rule) < 0.5) ++g;
    return g;
}

template <class Real>
GradedGrid<Real>::GradedGrid(const GradedRule& rule, const std::vector<SingularPoint>& points, const Ball& reach) : rule_(rule)
{
    using std::cos, std::cosh, std::exp, std::sinh;
    const Real b = Real(3) / 2;
    struct Mark {
        Real at, floor;
    };
    std::vector<Mark> marks{{Real(0), Real(rule.smallest)}};
    const Real end = extended_pair(reach).high;
    for (const SingularPoint& s : points) {
        const Real at = extended_pair(s.position).high;
        if (at > rule.smallest) marks.push_back({at, Real(floor_of(s.generation, rule)) * (at < 1 ? at : Real(1))});
    }
    const Real most_ever = longest(generations(rule), rule);
    for (Real y = 0; y < end;) {
        Real h = end - y < most_ever ? Real(end - y) : most_ever, stop = end, last = end;
        for (const Mark& m : marks) {
            const Real d = m.at <= y ? Real(b * (y - m.at)) : Real(b / (1 + b) * (m.at - y));
            Real most = d > m.floor ? d : m.floor;
            if (most < 8 * y * std::numeric_limits<Real>::epsilon()) most = 8 * y * std::numeric_limits<Real>::epsilon();
            if (m.at > y && m.at < stop) {
                stop = m.at;
                last = m.floor;
            }
            h = most < h ? most : h;
        }
        const Real rest = last / 2 < h / 8 ? last / 2 : h / 8; // no splinter before the point
        if (y + h >= stop - rest) h = stop - y;
        const Real right = h == stop - y ? stop : Real(y + h);
        if (cells_.size() > 40'000) throw BeyondReach("too many singular points for a grid");
        cells_.push_back({y, right, right - y});
        y = right;
    }

    const int N = rule.degree;
    const WorkingPrecision precision(256);
    const auto real = [](const Ball& x) { return extended_pair(x).high; };
    const auto cos_pi = [](long p, long q) { return ScalarTraits<Ball>::cos_pi(Ball(p) / Ball(q)); };
    for (int j = 0; j <= N; ++j) {
        const Ball c = cos_pi(N - j, N); // ascending
        nodes_.push_back(real((1 + c) / 2));
        mirrored_.push_back(real((1 - c) / 2));
        Ball w(1);
        for (int k = 1; k <= N / 2; ++k) w = w - Ball(k == N / 2 ? 1 : 2) * cos_pi(2L * j * k, N) / (4L * k * k - 1);
        weights_.push_back(real(w / static_cast<long>(j == 0 || j == N ? 2 * N : N)));
    }
    for (int k = 0; k <= N; ++k)
        for (int j = 0; j <= N; ++j) // coefficient of T_k from the value at node j
            cosines_.push_back(real(cos_pi(static_cast<long>(N - j) * k, N) * static_cast<long>(2) /
                                    static_cast<long>((j == 0 || j == N ? 2 : 1) * (k == 0 || k == N ? 2 : 1) * N)));

    const Ball step = Ball(1) / 10;
    for (int i = -34; i <= 34; ++i) {
        const Ball s = step * i, q = exp(pi<Ball>() * (exp(s) - exp(-s)) / 2); // t = q/(1+q)
        const Ball t = q / (1 + q);
        angle_.push_back({real(t), real(step * pi<Ball>() * (exp(s) + exp(-s)) / 2 * t / (1 + q))});
    }
}

template <class Real>
auto GradedGrid<Real>::sample(const std::function<Real(const Pair<Real>&)>& f) const -> Function
{
    const std::size_t n = nodes_.size();
    Function v;
    v.moments.resize(n * cells_.size());
    v.coefficients.assign(n * cells_.size(), Real(0));
    in_parallel(cells_.size(), [&](std::size_t i) {
        const Cell& c = cells_[i];
        std::vector<Real> values(n);
        for (std::size_t j = 0; j < n; ++j) { // a point at an end is seen from inside its interval, never from the next one
            const bool left = nodes_[j] < Real(0.5);
            values[j] =
                f(sum(Pair<Real>{left ? c.left : c.right, Real(0)}, left ? Real(c.width * nodes_[j]) : Real(-c.width * mirrored_[j])));
        }
        for (std::size_t j = 0; j < n; ++j) v.moments[i * n + j] = weights_[j] * c.width * values[j];
        for (std::size_t k = 0; k < n; ++k) {
            Real sum = 0;
            for (std::size_t j = 0; j < n; ++j) sum += cosines_[k * n + j] * values[j];
            v.coefficients[i * n + k] = sum;
        }
    });
    return v;
}

template <class Real>
Real GradedGrid<Real>::series(const Function& v, std::size_t cell, const Real& t) const
{
    const std::size_t n = nodes_.size();
    const Real* c = &v.coefficients[cell * n];
    const Real z = 2 * t - 1, z2 = 2 * z;
    Real b1 = 0, b2 = 0;
    for (std::size_t k = n - 1; k > 0; --k) {
        const Real b0 = c[k] + (z2 * b1 - b2);
        b2 = b1;
        b1 = b0;
    }
    return c[0] + (z * b1 - b2);
}

template <class Real>
auto GradedGrid<Real>::derivative(const Function& v) const -> Function
{
    const std::size_t n = nodes_.size();
    Function d = v;
    for (std::size_t i = 0; i < cells_.size(); ++i) {
        const Real* c = &v.coefficients[i * n];
        Real* b = &d.coefficients[i * n];
        b[n - 1] = 0;
        for (std::size_t k = n - 1; k > 0; --k) // b_{k-1} = b_{k+1} + 2 k c_k, T_0 halved
            b[k - 1] = (k + 1 < n ? b[k + 1] : Real(0)) + static_cast<Real>(2 * k) * c[k];
        b[0] /= 2;
        for (std::size_t k = 0; k < n; ++k) b[k] *= 2 / cells_[i].width;
        for (std::size_t j = 0; j < n; ++j) d.moments[i * n + j] = weights_[j] * cells_[i].width * series(d, i, nodes_[j]);
    }
    return d;
}

template <class Real>
auto GradedGrid<Real>::shortened(const Function& v) const -> Function
{
    const std::size_t n = nodes_.size();
    Function d = v;
    for (std::size_t i = 0; i < cells_.size(); ++i) {
        for (std::size_t k = n - 1; k >= n - 3; --k) { // T_k and T_{k-2} are the same at both ends
            d.coefficients[i * n + k - 2] += d.coefficients[i * n + k];
            d.coefficients[i * n + k] = 0;
        }
        for (std::size_t j = 0; j < n; ++j) d.moments[i * n + j] = weights_[j] * cells_[i].width * series(d, i, nodes_[j]);
    }
    return d;
}

template <class Real>
Real GradedGrid<Real>::near(const Function& v, std::size_t cell, const Arc<Real>& arc) const
{
    const Cell& c = cells_[cell];
    Real total = 0;
    const auto over_angle = [&](bool from_lo, const Real& first, const Real& last) {
        const Real from = arc.angle(first), to = arc.angle(last), offset = from_lo ? Real(-arc.above_lo(c.left)) : arc.below_hi(c.left);
        Real sum = 0;
        for (const AngleNode& q : angle_) {
            const Real d = arc.distance(from + (to - from) * q.t), beyond = from_lo ? Real(offset + d) : Real(offset - d);
            sum += q.weight * arc.angular_density(c.left + beyond, (1 - c.left) - beyond) * series(v, cell, beyond / c.width);
        }
        total += (to - from) * sum;
    };
    const auto over_distance_from_one = [&](const Real& first, const Real& last) {
        Real sum = 0;
        for (const AngleNode& q : angle_) {
            const Real d = first + (last - first) * q.t, y = 1 - d;
            sum += q.weight * arc.density(y, Real(1), arc.above_lo(y), d) * series(v, cell, 1 - d / c.width);
        }
        total += (last - first) * sum;
    };
    arc.stretches(c.left, c.right, over_angle, over_distance_from_one);
    return total;
}

template <class Real>
Real GradedGrid<Real>::after(const Function& v, const Wave<Real>& wave) const
{
    const std::size_t n = nodes_.size();
    Real total = 0;
    for (int k = 0; k < wave.count; ++k) {
        const Arc<Real>& arc = wave.arcs[k];
        // the first interval that reaches beyond lo
        auto cell =
            std::upper_bound(cells_.begin(), cells_.end(), arc, [](const Arc<Real>& w, const Cell& c) { return w.above_lo(c.right) > 0; });
        for (; cell != cells_.end() && arc.below_hi(cell->left) > 0 && cell->left < arc.end; ++cell) {
            if (!arc.meets(cell->left, cell->right)) continue;
            const auto i = static_cast<std::size_t>(cell - cells_.begin());
            if (arc.clearance(cell->left, cell->right) * 3 < cell->width * 2 * Real(0.999)) {
                total += near(v, i, arc);
                continue;
            }
            const Real up_l = arc.below_hi(cell->left), up_r = arc.below_hi(cell->right), down_l = arc.above_lo(cell->left),
                       down_r = arc.above_lo(cell->right);
            Real sum = 0;
            for (std::size_t j = 0; j < n; ++j) {
                const bool left = nodes_[j] < Real(0.5);
                const Real ahead = cell->width * nodes_[j], behind = cell->width * mirrored_[j];
                sum += v.moments[i * n + j] * arc.density(cell->left + ahead, left ? up_l - ahead : up_r + behind,
                                                          left ? down_l + ahead : down_r - behind,
                                                          left ? (1 - cell->left) - ahead : (1 - cell->right) + behind);
            }
            total += sum;
        }
    }
    return total;
}

template class GradedGrid<Extended>;

} // namespace touchstone::transfer
