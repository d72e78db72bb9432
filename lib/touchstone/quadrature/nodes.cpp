// SPDX-License-Identifier: MIT
#include "touchstone/quadrature/nodes.hpp"

#include <algorithm>
#include <cmath>
#include <list>

namespace touchstone::quadrature {
namespace {

Ball shifted(const Ball& x, slong e)
{
    Ball y;
    arb_mul_2exp_si(y.get(), x.get(), e);
    return y;
}

/// x^(1/2^j)
Ball repeated_root(Ball x, int j)
{
    for (; j > 0; --j) x = sqrt(x);
    return x;
}

/// j with d = 2^j <= 16, or -1.
int dyadic_degree(long d)
{
    for (int j = 0; j <= 4; ++j) if (d == 1L << j) return j;
    return -1;
}

/// floor(e) and e - floor(e).
std::pair<long, Exponent> split(const Exponent& e)
{
    if (e.is_integer()) return {e.num(), Exponent(0)};
    long whole = e.num() / e.den();
    if (whole * e.den() > e.num()) --whole;
    return {whole, e - Exponent(whole)};
}

} // namespace

NodeTable::NodeTable(long m, long count, slong bits, double decay, Transformation transformation)
    : m_(m)
    , count_(count)
    , bits_(bits)
    , decay_(decay)
    , transformation_(transformation)
{
    // each octave of the tanh-sinh rule is a squaring, which doubles the relative error; powers of the root of 2 lose log2 m bits
    constexpr long for_powers = 16;
    const long octaves = transformation == Transformation::logistic ? for_powers : count / m + 2;
    const slong full = bits + 2 * octaves + 32;
    const WorkingPrecision precision(full);
    Ball log2;
    arb_const_log2(log2.get(), full + 10);
    root_.resize(static_cast<std::size_t>(m));
    root_[0] = Ball(1);
    if (m > 1) root_[1] = exp(log2 / Ball(m));
    for (long i = 2; i < m; ++i)
        root_[static_cast<std::size_t>(i)] = i % 2 == 0 ? root_[static_cast<std::size_t>(i / 2)] * root_[static_cast<std::size_t>(i / 2)]
                                                        : root_[static_cast<std::size_t>(i - 1)] * root_[1];
    entries_.resize(static_cast<std::size_t>(count + 1));
    transformation == Transformation::logistic ? fill_logistic() : fill_tanh_sinh(full, octaves);
}

/// What of the bits a node with that weight keeps; `growth` are those that dw/dt adds.
slong NodeTable::bits_of(double depth, long growth) const
{
    const slong lost = static_cast<slong>(decay_ * depth / M_LN2);
    return std::max<slong>(64, std::min<slong>(bits_, bits_ - lost + growth + 16) + 8);
}

void NodeTable::fill_tanh_sinh(slong full, long octaves)
{
    const long m = m_, count = count_;
    const Ball half_pi = shifted(pi<Ball>(), -1);
    // up[j] = exp((pi/2) 2^(j/m)) for -octaves*m <= j < m
    const long lowest = -octaves * m;
    std::vector<Ball> up(static_cast<std::size_t>((octaves + 1) * m));
    for (long i = 0; i < m; ++i) up[static_cast<std::size_t>(i)] = exp(shifted(half_pi * root_[static_cast<std::size_t>(i)], -octaves));
    for (std::size_t j = static_cast<std::size_t>(m); j < up.size(); ++j)
        arb_sqr(up[j].get(), up[j - static_cast<std::size_t>(m)].get(), full);
    const auto up_at = [&](long j) -> const Ball& { return up[static_cast<std::size_t>(j - lowest)]; };

    std::vector<Ball> down(static_cast<std::size_t>(std::max(m, count + 1))); // exp(-(pi/2) 2^(k/m)), k >= 0
    for (long k = 0; k < m; ++k) down[static_cast<std::size_t>(k)] = Ball(1) / up_at(k);
    for (long k = 0; k <= count; ++k) {
        Entry& entry = entries_[static_cast<std::size_t>(k)];
        entry.depth = M_PI * std::sinh(static_cast<double>(k) * M_LN2 / static_cast<double>(m));
        entry.bits = bits_of(entry.depth, k / m);
        if (k >= m)
            arb_sqr(down[static_cast<std::size_t>(k)].get(), down[static_cast<std::size_t>(k - m)].get(), entry.bits + 2 * octaves + 8);
        const WorkingPrecision p(entry.bits + 8);
        entry.e = down[static_cast<std::size_t>(k)] * up_at(-k);
        entry.far = Ball(1) / (Ball(1) + entry.e);
        entry.near = entry.e * entry.far;
        entry.cosh = shifted(power_of_two_at(k) + power_of_two_at(-k), -1);
        entry.weight = entry.cosh * (entry.near * entry.far);
    }
}

void NodeTable::fill_logistic()
{
    for (long k = 0; k <= count_; ++k) {
        Entry& entry = entries_[static_cast<std::size_t>(k)];
        entry.depth = static_cast<double>(k) * M_LN2 / static_cast<double>(m_);
        entry.bits = bits_of(entry.depth, 0);
        const WorkingPrecision p(entry.bits + 8);
        arb_set_round(entry.e.get(), power_of_two_at(-k).get(), entry.bits + 8);
        entry.far = Ball(1) / (Ball(1) + entry.e);
        entry.near = entry.e * entry.far;
        entry.cosh = Ball(1);
        entry.weight = entry.near * entry.far;
    }
}

void NodeTable::logs(long k) const
{
    const Entry& entry = entries_[static_cast<std::size_t>(k)];
    if (entry.has_log) return;
    const WorkingPrecision p(entry.bits + 8);
    Ball l;
    arb_log1p(l.get(), entry.e.get(), entry.bits + 8);
    entry.log_far = -l;
    if (transformation_ == Transformation::logistic) {
        arb_const_log2(entry.minus_w.get(), entry.bits + 8);
        entry.minus_w = entry.minus_w * Ball(-k) / Ball(m_);
    }
    else {
        const Ball up = power_of_two_at(k), low = power_of_two_at(-k);
        entry.minus_w = shifted(pi<Ball>(), -1) * (low - up);
    }
    entry.has_log = true;
}

Ball Node::distance(Side s) const
{
    const auto& entry = table_.entries_[static_cast<std::size_t>(k_)];
    return s == side_ ? entry.near : entry.far;
}

Ball Node::logarithm(Side s) const
{
    table_.logs(k_);
    const auto& entry = table_.entries_[static_cast<std::size_t>(k_)];
    return s == side_ ? entry.minus_w + entry.log_far : entry.log_far;
}

const Ball& Node::cosh() const { return table_.entries_[static_cast<std::size_t>(k_)].cosh; }

double Node::depth() const { return table_.entries_[static_cast<std::size_t>(k_)].depth; }

Ball NodeTable::power_of_two_at(long k) const
{
    long q = k / m_, i = k % m_;
    if (i < 0) {
        i += m_;
        --q;
    }
    return shifted(root_[static_cast<std::size_t>(i)], q);
}

Ball Node::weighted(const Exponent& p, const Exponent& q) const
{
    // u^(p+1) r^(q+1) costs no division where p or q is negative
    if (p < Exponent(0) || q < Exponent(0)) return monomial(p + Exponent(1), q + Exponent(1)) * cosh();
    const Ball& weight = table_.entries_[static_cast<std::size_t>(k_)].weight;
    return p.is_zero() && q.is_zero() ? weight : monomial(p, q) * weight;
}

Ball Node::power_by_log(Side s, const Exponent& e) const
{
    const auto [whole, rest] = split(e);
    if (const int j = dyadic_degree(rest.den()); j >= 0 && std::labs(whole) <= 64)
        return analytic::integer_power(distance(s), whole) * repeated_root(analytic::integer_power(distance(s), rest.num()), j);
    return exp(e.ball() * logarithm(s));
}

Ball Node::monomial(const Exponent& p, const Exponent& q) const
{
    const auto [wp, fp] = split(p);
    const auto [wq, fq] = split(q);
    if (std::labs(wp) > 64 || std::labs(wq) > 64) return exp(p.ball() * logarithm(Side::left) + q.ball() * logarithm(Side::right));
    Ball y(1);
    if (wp != 0) y *= analytic::integer_power(distance(Side::left), wp);
    if (wq != 0) y *= analytic::integer_power(distance(Side::right), wq);
    const int jp = dyadic_degree(fp.den()), jq = dyadic_degree(fq.den());
    const int j = std::max(jp, jq);
    Ball radicand(1), exponent(0);
    if (!fp.is_zero()) {
        if (jp >= 0) radicand *= analytic::integer_power(distance(Side::left), fp.num() << (j - jp));
        else exponent += fp.ball() * logarithm(Side::left);
    }
    if (!fq.is_zero()) {
        if (jq >= 0) radicand *= analytic::integer_power(distance(Side::right), fq.num() << (j - jq));
        else exponent += fq.ball() * logarithm(Side::right);
    }
    if (j > 0) y *= repeated_root(std::move(radicand), j);
    if (jp < 0 || jq < 0) y *= exp(exponent);
    return y;
}

std::shared_ptr<const NodeTable> NodeTable::get(long m, long count, slong bits, double decay, Transformation transformation)
{
    thread_local std::list<std::shared_ptr<const NodeTable>> cache;
    for (auto it = cache.begin(); it != cache.end(); ++it) {
        const NodeTable& t = **it;
        if (t.transformation_ == transformation && t.m_ == m && t.count_ >= count && t.bits_ >= bits && t.decay_ <= decay &&
            t.bits_ <= bits + bits / 4 + 64) {
            cache.splice(cache.begin(), cache, it);
            return cache.front();
        }
    }
    const slong rounded = (bits + 63) / 64 * 64;
    double quantum = 1;
    while (quantum > decay) quantum /= 2;
    cache.push_front(std::shared_ptr<const NodeTable>(new NodeTable(m, count + count / 16, rounded, quantum, transformation)));
    if (cache.size() > 12) cache.pop_back();
    return cache.front();
}

} // namespace touchstone::quadrature
