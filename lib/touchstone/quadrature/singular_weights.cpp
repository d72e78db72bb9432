// SPDX-License-Identifier: MIT
#include "touchstone/quadrature/singular_weights.hpp"

#include "touchstone/quadrature/upper.hpp"

#include <algorithm>
#include <array>
#include <list>

#if __has_include(<flint/arb_hypgeom.h>)
#include <flint/arb_hypgeom.h>
#include <flint/arb_poly.h>
#else
#include <arb_hypgeom.h>
#include <arb_poly.h>
#endif

namespace touchstone::quadrature {

GaussNodes::GaussNodes(long n, slong bits, GaussRule rule)
    : n_(n)
    , bits_(bits)
    , rule_(rule)
{
    entries_.resize(static_cast<std::size_t>((n + 1) / 2));
    for (Entry& e : entries_) e.bits = bits;
    rule == GaussRule::legendre ? fill_legendre() : fill_chebyshev();
}

const Ball& GaussNodes::Entry::log_of_share(Side from) const
{
    std::optional<Ball>& kept = from == Side::left ? log_of_left_ : log_of_right_;
    if (!kept) {
        const WorkingPrecision precision(std::max(WorkingPrecision::bits(), bits));
        kept = log((from == Side::left ? Ball(1) + z : Ball(1) - z) / Ball(2));
    }
    return *kept;
}

void GaussNodes::fill_legendre()
{
    const WorkingPrecision precision(bits_);
    const Ball quarter = pi<Ball>() / Ball(4);
    for (std::size_t k = 0; k < entries_.size(); ++k) { // roots in descending order
        Entry& e = entries_[k];
        arb_hypgeom_legendre_p_ui_root(e.z.get(), e.weight.get(), static_cast<ulong>(n_), k, bits_);
        const Ball angle = quarter + quarter * e.z;
        arb_sin_cos(e.sine.get(), e.cosine.get(), angle.get(), bits_);
    }
}

/// z_k = cos(2 b_k), b_k = (2k + 1) pi/(4n): from one to the next by a turn through pi/(2n).
void GaussNodes::fill_chebyshev()
{
    constexpr slong for_turns = 32; // bits that n products may lose
    const WorkingPrecision precision(bits_ + for_turns);
    const Ball weight = pi<Ball>() / Ball(n_), first = weight / Ball(4);
    ComplexBall at, turn;
    arb_sin_cos(acb_imagref(at.get()), acb_realref(at.get()), first.get(), WorkingPrecision::bits());
    acb_sqr(turn.get(), at.get(), WorkingPrecision::bits());
    for (Entry& e : entries_) {
        const Ball cosine = at.real(), sine = at.imag(), z = (cosine - sine) * (cosine + sine);
        arb_set_round(e.z.get(), z.get(), bits_);
        arb_set_round(e.weight.get(), weight.get(), bits_);
        arb_set_round(e.sine.get(), cosine.get(), bits_); // the sine of pi/2 - b_k
        arb_set_round(e.cosine.get(), sine.get(), bits_);
        at *= turn;
    }
}

std::shared_ptr<const GaussNodes> GaussNodes::get(long n, slong bits, GaussRule rule)
{
    thread_local std::list<std::shared_ptr<const GaussNodes>> cache;
    for (auto it = cache.begin(); it != cache.end(); ++it)
        if ((*it)->rule_ == rule && (*it)->n_ == n && (*it)->bits_ >= bits && (*it)->bits_ <= bits + bits / 4 + 64) {
            cache.splice(cache.begin(), cache, it);
            return cache.front();
        }
    constexpr std::size_t most = 24;
    cache.push_front(std::shared_ptr<const GaussNodes>(new GaussNodes(n, (bits + 63) / 64 * 64, rule)));
    if (cache.size() > most) cache.pop_back();
    return cache.front();
}

namespace {

/// Power series in a and b, cut off after a^i and b^j: how the moments depend on p + a and q + b.
class TwoSeries {
public:
    TwoSeries(int i, int j, const Ball& constant = Ball(0))
        : rows_(i + 1)
        , columns_(j + 1)
        , c_(static_cast<std::size_t>(rows_ * columns_), Ball(0))
    {
        at(0, 0) = constant;
    }
    Ball& at(int i, int j) { return c_[static_cast<std::size_t>(i * columns_ + j)]; }
    const Ball& at(int i, int j) const { return c_[static_cast<std::size_t>(i * columns_ + j)]; }
    int rows() const { return rows_; }
    int columns() const { return columns_; }

    /// this += x (c + s a + t b)
    void add_product(const TwoSeries& x, const Ball& c, long s, long t)
    {
        for (int i = 0; i < rows_; ++i)
            for (int j = 0; j < columns_; ++j) {
                Ball sum = c * x.at(i, j);
                if (i > 0 && s != 0) sum += Ball(s) * x.at(i - 1, j);
                if (j > 0 && t != 0) sum += Ball(t) * x.at(i, j - 1);
                at(i, j) += sum;
            }
    }
    /// this/(c + s a + t b)
    void divide(const Ball& c, long s, long t)
    {
        for (int i = 0; i < rows_; ++i)
            for (int j = 0; j < columns_; ++j) {
                if (i > 0 && s != 0) at(i, j) -= Ball(s) * at(i - 1, j);
                if (j > 0 && t != 0) at(i, j) -= Ball(t) * at(i, j - 1);
                at(i, j) /= c;
            }
    }
    friend TwoSeries operator*(const TwoSeries& x, const TwoSeries& y)
    {
        TwoSeries z(x.rows_ - 1, x.columns_ - 1);
        for (int i = 0; i < x.rows_; ++i)
            for (int j = 0; j < x.columns_; ++j)
                for (int k = 0; k <= i; ++k)
                    for (int l = 0; l <= j; ++l) z.at(i, j) += x.at(k, l) * y.at(i - k, j - l);
        return z;
    }

private:
    int rows_, columns_;
    std::vector<Ball> c_;
};

/// First coefficients of log Gamma(x + t), without the constant one.
std::vector<Ball> log_gamma_series(const Ball& x, int length)
{
    arb_poly_t argument, series;
    arb_poly_init(argument);
    arb_poly_init(series);
    arb_poly_set_coeff_arb(argument, 0, x.get());
    arb_poly_set_coeff_si(argument, 1, 1);
    arb_poly_lgamma_series(series, argument, length, WorkingPrecision::bits());
    std::vector<Ball> c(static_cast<std::size_t>(length), Ball(0));
    for (int k = 1; k < length; ++k) arb_poly_get_coeff_arb(c[static_cast<std::size_t>(k)].get(), series, k);
    arb_poly_clear(series);
    arb_poly_clear(argument);
    return c;
}

/// Gamma(p + 1 + a) Gamma(q + 1 + b)/Gamma(p + q + 2 + a + b)
TwoSeries beta_series(const Ball& p, const Ball& q, int i, int j)
{
    const auto constant = [](const Ball& x) { return touchstone::detail::ball_of(arb_gamma, x); };
    const Ball one(1), x = p + one, y = q + one, z = x + y;
    const int length = i + j + 1;
    const std::vector<Ball> of_x = log_gamma_series(x, length), of_y = log_gamma_series(y, length), of_z = log_gamma_series(z, length);
    TwoSeries exponent(i, j);
    for (int k = 0; k <= i; ++k)
        for (int l = 0; l <= j; ++l) {
            if (k + l == 0) continue;
            Ball binomial(1); // (k + l)!/(k! l!)
            for (int m = 1; m <= k; ++m) binomial = binomial * Ball(l + m) / Ball(m);
            Ball c = -binomial * of_z[static_cast<std::size_t>(k + l)];
            if (l == 0) c += of_x[static_cast<std::size_t>(k)];
            if (k == 0) c += of_y[static_cast<std::size_t>(l)];
            exponent.at(k, l) = c;
        }
    TwoSeries sum(i, j, one), power(i, j, one);
    for (int k = 1; k < length; ++k) {
        power = power * exponent;
        for (int s = 0; s <= i; ++s)
            for (int t = 0; t <= j; ++t) {
                power.at(s, t) /= Ball(k);
                sum.at(s, t) += power.at(s, t);
            }
    }
    return sum * TwoSeries(i, j, constant(x) * constant(y) / constant(z));
}

/// The first moment of w, as a series.
TwoSeries first_moment(const SingularWeight& w)
{
    const int i = w.left_logarithms, j = w.right_logarithms;
    const bool at_left_only = w.right.is_zero() && j == 0, at_right_only = w.left.is_zero() && i == 0;
    if (!at_left_only && !at_right_only) return beta_series(w.left.ball(), w.right.ball(), i, j);
    TwoSeries m(i, j, Ball(1)); // 1/(p + 1 + a)
    m.divide((w.left + w.right + Exponent(1)).ball(), at_left_only ? 1 : 0, at_left_only ? 0 : 1);
    return m;
}

Ball factorial(int n)
{
    Ball f(1);
    for (int k = 2; k <= n; ++k) f *= Ball(k);
    return f;
}

/// What Legendre's recursion loses in balls, about (1 + sqrt 2)^n.
slong lost_by_recursion(long n) { return 16 + n * 13 / 10; }

} // namespace

Ball value_of(const SingularWeight& w, const Ball& u, const Ball& r)
{
    const auto one_side = [](const Ball& x, const Exponent& power, int logarithms) {
        Ball y(1);
        if (!power.is_zero()) arb_pow(y.get(), x.get(), power.ball().get(), WorkingPrecision::bits());
        return logarithms == 0 ? y : y * analytic::integer_power(log(x), logarithms);
    };
    return one_side(u, w.left, w.left_logarithms) * one_side(r, w.right, w.right_logarithms);
}

std::vector<Ball> moments(const SingularWeight& w, long n)
{
    // The formulas below are finite there too: they continue the integral to powers for which there is none.
    if (!w.has_integral()) return std::vector<Ball>(static_cast<std::size_t>(n), Ball::indeterminate());
    const int i = w.left_logarithms, j = w.right_logarithms;
    const Ball p = w.left.ball(), q = w.right.ball();
    const Ball scale = factorial(i) * factorial(j);
    std::vector<Ball> all;
    TwoSeries before(i, j), now = first_moment(w);
    for (long m = 0; m < n; ++m) {
        all.push_back(now.at(i, j) * scale);
        TwoSeries next(i, j);
        next.add_product(now, (p - q) * Ball(2 * m + 1), 2 * m + 1, -(2 * m + 1));
        next.add_product(before, Ball(-m) * (p + q + Ball(1 - m)), -m, -m);
        next.divide((p + q + Ball(m + 2)) * Ball(m + 1), m + 1, m + 1);
        before = std::move(now);
        now = std::move(next);
    }
    return all;
}

WeightedNodes::WeightedNodes(const SingularWeight& w, long n, slong bits)
    : weight_(w)
    , n_(n)
    , bits_(bits)
{
    const slong full = bits + lost_by_recursion(n);
    const auto nodes = GaussNodes::get(n, full);
    const WorkingPrecision precision(full);
    std::vector<Ball> c = moments(w, n);               // (2m + 1) M_m
    Ball total = touchstone::abs(c.front()) * Ball(2); // w has one sign, and dz = 2 du
    for (long m = 0; m < n; ++m) c[static_cast<std::size_t>(m)] *= Ball(2 * m + 1);
    for (const GaussNodes::Entry& e : nodes->entries()) {
        std::array<Ball, 2> sum{Ball(0), Ball(0)}; // over even and odd m
        Ball before(0), now(1);
        for (long m = 0; m < n; ++m) {
            arb_addmul(sum[static_cast<std::size_t>(m % 2)].get(), c[static_cast<std::size_t>(m)].get(), now.get(), full);
            const Ball next = (Ball(2 * m + 1) * e.z * now - Ball(m) * before) / Ball(m + 1);
            before = std::move(now);
            now = next;
        }
        const auto kept = [&](const Ball& x) {
            Ball y;
            arb_set_round(y.get(), x.get(), bits);
            return y;
        };
        at_.push_back(kept(e.weight * (sum[0] + sum[1])));
        at_mirrored_.push_back(kept(e.weight * (sum[0] - sum[1])));
        const bool is_middle = n % 2 != 0 && at_.size() == nodes->entries().size();
        total += touchstone::abs(at_.back());
        if (!is_middle) total += touchstone::abs(at_mirrored_.back());
    }
    size_ = upper_ball(total);
}

const Ball& WeightedNodes::reciprocal(std::size_t k, bool mirrored) const
{
    if (reciprocal_.empty()) {
        const WorkingPrecision precision(bits_);
        for (const GaussNodes::Entry& e : GaussNodes::get(n_, bits_)->entries()) {
            const Ball near = (Ball(1) - e.z) / Ball(2), far = (Ball(1) + e.z) / Ball(2);
            reciprocal_.push_back(Ball(1) / value_of(weight_, far, near));
            reciprocal_mirrored_.push_back(Ball(1) / value_of(weight_, near, far));
        }
    }
    return (mirrored ? reciprocal_mirrored_ : reciprocal_)[k];
}

std::shared_ptr<const WeightedNodes> WeightedNodes::get(const SingularWeight& w, long n, slong bits)
{
    thread_local std::list<std::shared_ptr<const WeightedNodes>> cache;
    for (auto it = cache.begin(); it != cache.end(); ++it)
        if ((*it)->n_ == n && (*it)->weight_ == w && (*it)->bits_ >= bits && (*it)->bits_ <= bits + bits / 4 + 64) {
            cache.splice(cache.begin(), cache, it);
            return cache.front();
        }
    constexpr std::size_t most = 24;
    cache.push_front(std::shared_ptr<const WeightedNodes>(new WeightedNodes(w, n, (bits + 63) / 64 * 64)));
    if (cache.size() > most) cache.pop_back();
    return cache.front();
}

} // namespace touchstone::quadrature
