// SPDX-License-Identifier: MIT
#include "touchstone/transfer/piecewise.hpp"

#include "touchstone/scalar/refusal.hpp"
#include "touchstone/transfer/parallel.hpp"

#include <algorithm>
#include <map>
#include <mutex>

namespace touchstone::transfer {

Pair<Extended> extended_pair(const Ball& b)
{
    using std::ldexp;
    const slong bits = std::numeric_limits<Extended>::digits;
    const auto rounded = [bits](const arf_t value, arf_t rest) { // to Extended, and what is left
        arf_t head, part;
        arf_init(head);
        arf_init(part);
        arf_set_round(head, value, bits, ARF_RND_NEAR);
        arf_sub(rest, value, head, ARF_PREC_EXACT, ARF_RND_DOWN);
        const slong exponent = arf_is_zero(head) ? 0 : arf_abs_bound_lt_2exp_si(head); // may be beyond double's
        arf_mul_2exp_si(head, head, -exponent);
        Extended sum = 0; // 32 bits at a time: exact in any type
        while (!arf_is_zero(head)) {
            arf_set_round(part, head, 32, ARF_RND_DOWN);
            sum += Extended(arf_get_d(part, ARF_RND_DOWN));
            arf_sub(head, head, part, ARF_PREC_EXACT, ARF_RND_DOWN);
        }
        arf_clear(head);
        arf_clear(part);
        return ldexp(sum, static_cast<int>(std::clamp<slong>(exponent, -20'000, 20'000)));
    };
    arf_t rest, none;
    arf_init(rest);
    arf_init(none);
    Pair<Extended> p;
    p.high = rounded(arb_midref(b.get()), rest);
    p.low = rounded(rest, none);
    arf_clear(rest);
    arf_clear(none);
    return p;
}

Ball exact_ball(const Extended& value)
{
    using std::frexp, std::isfinite;
    if (!isfinite(value)) throw BeyondReach("not a number: next to a singular point of the recursion");
    Ball sum(0);
    const WorkingPrecision precision(256);
    int exponent = 0; // may be beyond double's
    for (Extended rest = frexp(value, &exponent); rest != 0;) {
        const double part = static_cast<double>(rest);
        sum = sum + Ball::exactly(part);
        rest -= Extended(part);
    }
    arb_mul_2exp_si(sum.get(), sum.get(), exponent);
    return sum;
}

template <class Real>
const GaussRule<Real>& gauss_rule(int n)
{
    static std::mutex mutex;
    static std::map<int, GaussRule<Real>> rules;
    const std::scoped_lock lock(mutex);
    const auto [it, fresh] = rules.try_emplace(n);
    GaussRule<Real>& rule = it->second;
    if (!fresh) return rule;

    const WorkingPrecision precision(256);
    const auto N = static_cast<std::size_t>(n);
    const auto real = [](const Ball& b) { return static_cast<Real>(extended_pair(b).high); };
    std::vector<Ball> x, w; // on [-1, 1], ascending
    for (int i = n - 1; i >= 0; --i) {
        Ball node, weight;
        arb_hypgeom_legendre_p_ui_root(node.get(), weight.get(), static_cast<ulong>(n), static_cast<ulong>(i), 256);
        x.push_back(node);
        w.push_back(weight);
    }
    const auto legendre = [](std::size_t k, const Ball& t) {
        Ball p;
        arb_hypgeom_legendre_p_ui(p.get(), nullptr, static_cast<ulong>(k), t.get(), 256);
        return p;
    };
    for (std::size_t i = 0; i < N; ++i) {
        rule.nodes.push_back(real((x[i] + 1) / 2));
        rule.weights.push_back(real(w[i] / 2));
    }
    for (std::size_t k = 0; k < N; ++k)
        for (std::size_t i = 0; i < N; ++i)
            rule.to_coefficients.push_back(real(w[i] / 2 * static_cast<long>(2 * k + 1) * legendre(k, x[i])));
    for (const int side : {-1, 1})
        for (std::size_t i = 0; i < N; ++i)
            for (std::size_t j = 0; j < N; ++j) { // l_j(t) = sum_k (2k+1)/2 w_j P_k(x_j) P_k(t)
                const Ball t = (x[i] + side) / 2;
                Ball l(0);
                for (std::size_t k = 0; k < N; ++k) l = l + w[j] / 2 * static_cast<long>(2 * k + 1) * legendre(k, x[j]) * legendre(k, t);
                (side < 0 ? rule.lower : rule.upper).push_back(real(l));
            }
    return rule;
}

template <class Real>
Piecewise<Real>::Piecewise(const BlindRule& rule, const Real& reach, const std::function<Real(const Pair<Real>&)>& f)
    : rule_(rule), gauss_(&gauss_rule<Real>(rule.points)), angle_(&gauss_rule<Real>(rule.angle_points))
{
    using std::abs, std::isfinite, std::sqrt;
    const auto N = static_cast<std::size_t>(rule.points);
    nodes_.push_back({Real(0), Real(1), -1, 0});
    for (Real left = 1; left < reach; left *= 2) nodes_.push_back({left, left, -1, 0});
    roots_ = nodes_.size();
    constexpr std::size_t most_nodes = 80'000; // ordinary ones need some 1000; rounding noise would be halved without end
    struct Answer {
        std::vector<Real> values, series;
        double tail;
    };
    for (std::size_t begin = 0; begin < nodes_.size();) {
        const std::size_t end = nodes_.size();
        if (end > most_nodes) throw BeyondReach("a function of the recursion is not resolved by 40000 intervals");
        std::vector<Answer> answers(end - begin);
        in_parallel(end - begin, [&](std::size_t i) {
            const Node& node = nodes_[begin + i];
            Answer& a = answers[i];
            a.values.resize(N);
            a.series.assign(N, Real(0));
            for (std::size_t j = 0; j < N; ++j) a.values[j] = f(sum(Pair<Real>{node.left, Real(0)}, Real(node.width * gauss_->nodes[j])));
            for (std::size_t k = 0; k < N; ++k)
                for (std::size_t j = 0; j < N; ++j) a.series[k] += gauss_->to_coefficients[k * N + j] * a.values[j];
            Real tail = 0;
            for (std::size_t k = N - 3; k < N; ++k) tail = abs(a.series[k]) > tail ? Real(abs(a.series[k])) : tail;
            Real near = node.left, against = abs(a.series[0]);
            if (const Real to_end = abs(Real(rule.end) - node.left); to_end < near) near = to_end;
            if (isfinite(rule.end)) {
                for (const Real& v : a.values) against = abs(v) < against ? Real(abs(v)) : against;
                if (against < rule.negligible) against = rule.negligible;
            }
            const Real share = sqrt(node.width / (near + node.width));
            const auto weighted = [&](const Real& error) {
                return against == 0 ? (error == 0 ? 0.0 : 1.0) : static_cast<double>(Real(error * share / against));
            };
            a.tail = weighted(tail);
            if (a.tail > rule.tolerance) return;
            // what turns between an end and the point next to it, no point has seen: V = 0 from 1 + 1e-6 on, on [1, 2]
            Real at_left = 0, at_right = 0;
            for (std::size_t k = N; k-- > 0;) {
                at_left = a.series[k] - at_left;
                at_right += a.series[k];
            }
            constexpr double noise = 16; // of a series at its ends
            if (node.left > 0) a.tail = std::max(a.tail, weighted(Real(abs(f({node.left, Real(0)}) - at_left) / noise)));
            a.tail = std::max(a.tail, weighted(Real(abs(f({node.left + node.width, Real(0)}) - at_right) / noise)));
        });
        for (std::size_t i = 0; i < answers.size(); ++i) {
            Node& node = nodes_[begin + i];
            node.data = N * (begin + i);
            const bool least =
                node.left == 0 ? node.width < rule.smallest : node.width < node.left * std::numeric_limits<Real>::epsilon() * 4;
            if (answers[i].tail <= rule.tolerance || least) {
                for (std::size_t j = 0; j < N; ++j) moments_.push_back(gauss_->weights[j] * node.width * answers[i].values[j]);
                coefficients_.insert(coefficients_.end(), answers[i].series.begin(), answers[i].series.end());
                continue;
            }
            moments_.resize(moments_.size() + N);
            coefficients_.resize(coefficients_.size() + N);
            const Real half = node.width / 2, left = node.left;
            node.child = static_cast<long>(nodes_.size());
            nodes_.push_back({left, half, -1, 0});
            nodes_.push_back({left + half, half, -1, 0});
        }
        begin = end;
    }
    sum_moments();
}

template <class Real>
void Piecewise<Real>::sum_moments()
{
    const auto N = static_cast<std::size_t>(rule_.points);
    for (std::size_t i = nodes_.size(); i-- > 0;) { // halves come after their whole
        const Node& node = nodes_[i];
        if (node.child < 0) continue;
        const Real* a = &moments_[nodes_[static_cast<std::size_t>(node.child)].data];
        const Real* b = a + N;
        for (std::size_t j = 0; j < N; ++j) {
            Real sum = 0;
            for (std::size_t k = 0; k < N; ++k) sum += gauss_->lower[k * N + j] * a[k] + gauss_->upper[k * N + j] * b[k];
            moments_[node.data + j] = sum;
        }
    }
}

namespace {

/// P_{k+1} = (2k+1)/(k+1) z P_k - k/(k+1) P_{k-1}
template <class Real>
struct LegendreRatios {
    static constexpr int most = 256;
    std::vector<Real> up, down;
    LegendreRatios()
    {
        for (int k = 0; k < most; ++k) up.push_back(Real(2 * k + 1) / (k + 1)), down.push_back(Real(k) / (k + 1));
    }
};

/// Clenshaw's recurrence, at some points at once: one alone waits for each of its own sums.
template <std::size_t points, class Real>
void legendre_series(const Real* c, std::size_t terms, const Real* t, Real* out)
{
    static const LegendreRatios<Real> ratios;
    Real z[points], b1[points] = {}, b2[points] = {};
    for (std::size_t i = 0; i < points; ++i) z[i] = 2 * t[i] - 1;
    for (std::size_t k = terms; k-- > 0;) {
        const Real up = ratios.up[k], down = ratios.down[k + 1], here = c[k];
        for (std::size_t i = 0; i < points; ++i) {
            const Real b = (here - down * b2[i]) + (up * z[i]) * b1[i];
            b2[i] = b1[i];
            b1[i] = b;
        }
    }
    for (std::size_t i = 0; i < points; ++i) out[i] = b1[i];
}

} // namespace

template <class Real>
Real Piecewise<Real>::series(const Node& node, const Real& t) const
{
    Real sum;
    legendre_series<1>(&coefficients_[node.data], static_cast<std::size_t>(rule_.points), &t, &sum);
    return sum;
}

template <class Real>
void Piecewise<Real>::series(const Node& node, const std::vector<Real>& t, std::vector<Real>& out) const
{
    constexpr std::size_t together = std::is_same_v<Real, double> ? 8 : 2; // as many as there are registers for
    out.resize(t.size());
    std::size_t i = 0;
    for (; i + together <= t.size(); i += together)
        legendre_series<together>(&coefficients_[node.data], static_cast<std::size_t>(rule_.points), &t[i], &out[i]);
    for (; i < t.size(); ++i) out[i] = series(node, t[i]);
}

template <class Real>
Real Piecewise<Real>::at(const Real& x) const
{
    const Node* node = &nodes_.front();
    while (x >= node->left + node->width) ++node;
    while (node->child >= 0) {
        node = &nodes_[static_cast<std::size_t>(node->child)];
        if (x >= node->left + node->width) ++node;
    }
    return series(*node, (x - node->left) / node->width);
}

template <class Real>
Real Piecewise<Real>::integral() const
{
    Real sum = 0;
    for (std::size_t i = 0; i < roots_ * static_cast<std::size_t>(rule_.points); ++i) sum += moments_[i]; // the roots come first
    return sum;
}

template <class Real>
Piecewise<Real> Piecewise<Real>::derivative() const
{
    Piecewise d = *this;
    const auto N = static_cast<std::size_t>(rule_.points);
    std::vector<std::size_t> leaves;
    for (std::size_t i = 0; i < nodes_.size(); ++i)
        if (nodes_[i].child < 0) leaves.push_back(i);
    std::sort(leaves.begin(), leaves.end(), [this](std::size_t a, std::size_t b) { return nodes_[a].left < nodes_[b].left; });
    Real before = 0; // the share of V's step at the left end
    for (std::size_t l = 0; l < leaves.size(); ++l) {
        const Node& node = nodes_[leaves[l]];
        const Real* c = &coefficients_[node.data];
        Real* b = &d.coefficients_[node.data];
        Real above[2] = {Real(0), Real(0)}; // P'_k = sum of (2j+1) P_j over j = k-1, k-3, ...
        for (std::size_t k = N; k-- > 0;) {
            b[k] = static_cast<Real>(2 * k + 1) * above[(k + 1) % 2] * 2 / node.width;
            above[k % 2] += c[k];
        }
        const bool last = l + 1 == leaves.size();
        const Real step = (last ? Real(0) : series(nodes_[leaves[l + 1]], Real(0))) - series(node, Real(1));
        Real after = 0, next_before = 0; // the shorter interval is what is less well resolved
        (last || node.width < nodes_[leaves[l + 1]].width ? after : next_before) = step;
        b[0] += (before + after) / node.width;
        before = next_before;
        for (std::size_t j = 0; j < N; ++j) d.moments_[node.data + j] = gauss_->weights[j] * node.width * d.series(node, gauss_->nodes[j]);
    }
    d.sum_moments();
    return d;
}

template <class Real>
Piecewise<Real> Piecewise<Real>::shortened() const
{
    Piecewise d = *this;
    const auto N = static_cast<std::size_t>(rule_.points);
    for (const Node& node : nodes_) {
        if (node.child >= 0) continue;
        for (std::size_t k = N - 1; k >= N - 3; --k) { // P_k and P_{k-2} are the same at both ends
            d.coefficients_[node.data + k - 2] += d.coefficients_[node.data + k];
            d.coefficients_[node.data + k] = 0;
        }
        for (std::size_t j = 0; j < N; ++j) d.moments_[node.data + j] = gauss_->weights[j] * node.width * d.series(node, gauss_->nodes[j]);
    }
    d.sum_moments();
    return d;
}

template <class Real>
Real Piecewise<Real>::near_leaf(const Node& node, const Arc<Real>& arc) const
{
    const Real a = node.left, b = node.left + node.width;
    const std::size_t count = angle_->nodes.size();
    thread_local std::vector<Real> weight, local, V;
    weight.resize(count);
    local.resize(count);
    const auto mean = [&] {
        series(node, local, V);
        Real sum = 0;
        for (std::size_t q = 0; q < count; ++q) sum += angle_->weights[q] * weight[q] * V[q];
        return sum;
    };
    Real total = 0;
    const auto over_angle = [&](bool from_lo, const Real& first, const Real& last) {
        // y - a = offset +- the distance from that end
        const Real from = arc.angle(first), to = arc.angle(last), offset = from_lo ? Real(-arc.above_lo(a)) : arc.below_hi(a);
        for (std::size_t q = 0; q < count; ++q) {
            const Real d = arc.distance(from + (to - from) * angle_->nodes[q]), beyond = from_lo ? Real(offset + d) : Real(offset - d);
            weight[q] = arc.angular_density(a + beyond, (1 - a) - beyond);
            local[q] = beyond / node.width;
        }
        total += (to - from) * mean();
    };
    const auto over_distance_from_one = [&](const Real& first, const Real& last) {
        for (std::size_t q = 0; q < count; ++q) {
            const Real d = first + (last - first) * angle_->nodes[q], y = 1 - d;
            weight[q] = arc.density(y, Real(1), arc.above_lo(y), d);
            local[q] = 1 - d / node.width;
        }
        total += (last - first) * mean();
    };
    arc.stretches(a, b, over_angle, over_distance_from_one);
    return total;
}

template <class Real>
Real Piecewise<Real>::after(const Wave<Real>& wave) const
{
    const auto N = static_cast<std::size_t>(rule_.points);
    Real total = 0;
    std::vector<const Node*> stack;
    stack.reserve(128);
    for (int k = 0; k < wave.count; ++k) {
        const Arc<Real>& arc = wave.arcs[k];
        for (std::size_t i = 0; i < roots_; ++i) stack.push_back(&nodes_[i]);
        while (!stack.empty()) {
            const Node& node = *stack.back();
            stack.pop_back();
            const Real right = node.left + node.width;
            if (!arc.meets(node.left, right)) continue;
            if (arc.clearance(node.left, right) >= node.width) {
                const Real up = arc.below_hi(node.left), down = arc.above_lo(node.left), to_one = 1 - node.left;
                Real sum = 0;
                for (std::size_t j = 0; j < N; ++j) {
                    const Real t = node.width * gauss_->nodes[j];
                    sum += moments_[node.data + j] * arc.density(node.left + t, up - t, down + t, to_one - t);
                }
                total += sum;
            }
            else if (node.child < 0) total += near_leaf(node, arc);
            else {
                stack.push_back(&nodes_[static_cast<std::size_t>(node.child)]);
                stack.push_back(&nodes_[static_cast<std::size_t>(node.child) + 1]);
            }
        }
    }
    return total;
}

template class Piecewise<Extended>;
template class Piecewise<double>;

} // namespace touchstone::transfer
