// SPDX-License-Identifier: MIT
#include "touchstone/limit/eigenfunction.hpp"

#include "touchstone/quadrature/ellipse_rule.hpp"
#include "touchstone/scalar/refusal.hpp"
#include "touchstone/transfer/parallel.hpp"

#include <algorithm>
#include <cmath>

#if __has_include(<flint/arb_mat.h>)
#include <flint/arb_mat.h>
#else
#include <arb_mat.h>
#endif

namespace touchstone::limit {
namespace {

using Traits = ScalarTraits<Ball>;

constexpr double strip = 1.3;        ///< w is analytic in log s where |Im log s| < pi/2: how much of that is counted on
constexpr int spare_terms = 8;
constexpr int most_steps = 200;      ///< of the power method, whose rate is 3/4 where G = 2.2
constexpr int inverse_steps = 4;     ///< each doubles the digits, and binary64 has 12 at least

class Matrix {
public:
    Matrix(slong rows, slong columns) { arb_mat_init(m_, rows, columns); }
    ~Matrix() { arb_mat_clear(m_); }
    Matrix(const Matrix&) = delete;
    Matrix& operator=(const Matrix&) = delete;
    arb_mat_struct* get() { return m_; }
    arb_ptr operator()(slong i, slong k) { return arb_mat_entry(m_, i, k); }

private:
    arb_mat_t m_;
};

Ball middle(arb_srcptr x)
{
    Ball m;
    arb_get_mid_arb(m.get(), x);
    return m;
}

/// T_0(t) ... T_(n-1)(t)
std::vector<Ball> chebyshev(const Ball& t, std::size_t n)
{
    std::vector<Ball> T{Ball(1), t};
    while (T.size() < n) T.push_back(middle((2 * t * T[T.size() - 1] - T[T.size() - 2]).get()));
    return T;
}

std::vector<Noise> noise(const std::vector<double>& panels, long nodes)
{
    std::vector<Noise> all;
    for (std::size_t j = 0; j + 1 < panels.size(); ++j) add_noise(all, Ball::exactly(panels[j]), Ball::exactly(panels[j + 1]), nodes);
    return all;
}

/// Coefficients c of D w = lambda w by collocation: C c = lambda c.
void fill(Matrix& C, const Ball& G, const Eigenfunction& w, const std::vector<Noise>& all)
{
    const slong n = arb_mat_nrows(C.get()), bits = WorkingPrecision::bits();
    Matrix A(n, n), B(n, n);
    const Ball log_half_G = log(G / 2), half = Ball(1) / w.stretch(), centre = (Ball::exactly(w.high) + Ball::exactly(w.low)) / 2;
    transfer::in_parallel(static_cast<std::size_t>(n), [&](std::size_t row) {
        const WorkingPrecision precision(bits);
        const slong i = static_cast<slong>(row);
        const Ball t = -Traits::cos_pi(Ball(i) / Ball(n - 1)), s = exp(centre + half * t), x = exp(-s);
        const std::vector<Ball> own = chebyshev(t, static_cast<std::size_t>(n));
        for (slong k = 0; k < n; ++k) arb_set(B(i, k), own[static_cast<std::size_t>(k)].get());
        for (const Noise& e : all) {
            const Ball remains = 1 - x * e.square, next = s / 2 + log_half_G + e.log_cosh - log(remains) / 2;
            const Ball share = e.weight * (1 - 1 / (2 * remains));
            const std::vector<Ball> T = chebyshev(middle(w.place(next).get()), static_cast<std::size_t>(n));
            for (slong k = 0; k < n; ++k) arb_addmul(A(i, k), share.get(), T[static_cast<std::size_t>(k)].get(), bits);
        }
    });
    arb_mat_approx_solve(C.get(), B.get(), A.get(), bits);
}

/// The first eigenvector, in binary64: the power method. \returns the eigenvalue
double power_method(Matrix& C, std::vector<double>& c)
{
    const std::size_t n = c.size();
    std::vector<double> entries(n * n), next(n);
    for (std::size_t i = 0; i < n * n; ++i)
        entries[i] = arf_get_d(arb_midref(C(static_cast<slong>(i / n), static_cast<slong>(i % n))), ARF_RND_NEAR);
    double lambda = 0;
    for (int step = 0; step < most_steps; ++step) {
        for (std::size_t i = 0; i < n; ++i) {
            next[i] = 0;
            for (std::size_t k = 0; k < n; ++k) next[i] += entries[i * n + k] * c[k];
        }
        lambda = next[0] / c[0];
        for (std::size_t i = 0; i < n; ++i) c[i] = next[i] / next[0];
    }
    return lambda;
}

void inverse_iteration(Matrix& C, const Ball& start, std::vector<Ball>& c)
{
    const slong n = arb_mat_nrows(C.get()), bits = WorkingPrecision::bits();
    Ball lambda = start;
    Matrix shifted(n, n), right(n, 1), solution(n, 1);
    for (int step = 0; step < inverse_steps; ++step) {
        arb_mat_set(shifted.get(), C.get());
        for (slong i = 0; i < n; ++i) {
            arb_sub(shifted(i, i), shifted(i, i), lambda.get(), bits);
            arb_set(right(i, 0), c[static_cast<std::size_t>(i)].get());
        }
        if (!arb_mat_approx_solve(solution.get(), shifted.get(), right.get(), bits)) return; // lambda is an eigenvalue to the last bit
        const Ball scale = 1 / middle(solution(0, 0));
        if (!scale.is_finite()) return;
        lambda = middle((lambda + c[0] * scale).get());
        for (slong i = 0; i < n; ++i) c[static_cast<std::size_t>(i)] = middle((middle(solution(i, 0)) * scale).get());
    }
}

} // namespace

double highest_sigma(Accuracy a)
{
    constexpr long fewest = 5; // ratios there are to be so small that the noise can be cut off
    // what is cut off is exp(-3/2 sigma) at most
    return 12 + 1.6 * static_cast<double>(std::max(a.digits, fewest));
}

std::vector<double> panels_of_noise(double sigma)
{
    // narrow next to 0, where s' is smallest; an ellipse of axes 1.25 and 0.76 half widths about a panel of width 3 stays away from i pi/2,
    // a zero of cosh
    constexpr double growth = 1.5, first = 0.8, widest = 3;
    const double last = sigma / 2 + M_LN2; // cosh(last) > exp(sigma/2)
    std::vector<double> ends{0};
    for (double width = first; ends.back() < last; width = std::min(widest, width * growth))
        ends.push_back(std::min(last, ends.back() + width));
    if (last - ends[ends.size() - 2] < first / 2) ends.erase(ends.end() - 2);
    ends.back() = std::acosh(std::exp(sigma / 2)) * (1 - 1e-12);
    return ends;
}

void add_noise(std::vector<Noise>& all, const Ball& from, const Ball& to, long nodes)
{
    const Ball half = (to - from) / 2, centre = (to + from) / 2;
    const auto rule = quadrature::GaussNodes::get(nodes, WorkingPrecision::bits());
    for (const auto& node : rule->entries())
        for (const int sign : {1, -1}) {
            if (sign < 0 && node.z.contains_zero()) continue;
            Ball cosh;
            arb_cosh(cosh.get(), (centre + sign * half * node.z).get(), WorkingPrecision::bits());
            all.push_back({1 - 1 / (cosh * cosh), log(cosh), 4 / Traits::pi() * half * node.weight / (cosh * cosh * cosh)});
        }
}

Ball chebyshev_sum(const std::vector<Ball>& c, const Ball& t)
{
    Ball before(0), now(0);
    const Ball twice = 2 * t;
    for (std::size_t k = c.size() - 1; k > 0; --k) {
        Ball next = c[k] - before;
        arb_addmul(next.get(), twice.get(), now.get(), WorkingPrecision::bits());
        before = std::move(now);
        now = std::move(next);
    }
    return t * now - before + c[0];
}

std::vector<Ball> chebyshev_derivative(const std::vector<Ball>& c)
{
    std::vector<Ball> d(std::max<std::size_t>(c.size(), 2) - 1, Ball(0));
    for (std::size_t k = c.size() - 1; k > 0; --k) {
        d[k - 1] = Ball(static_cast<long>(2 * k)) * c[k];
        if (k + 1 < d.size()) d[k - 1] += d[k + 1];
    }
    d[0] = d[0] / 2;
    return d;
}

Eigenfunction approximate_eigenfunction(const Ball& G, Accuracy wanted)
{
    const double lowest = arf_get_d(arb_midref((2 * log(G / 2)).get()), ARF_RND_NEAR),
                 sigma = highest_sigma(wanted); // G may be beyond binary64
    constexpr double enough = 1e-9; // the interval is to hold log s of the smallest s
    Eigenfunction w{std::log(lowest) - enough, std::log(lowest + sigma) + enough, {}, {}};
    const double rate = std::asinh(2 * strip / (w.high - w.low)), digits = static_cast<double>(wanted.digits + 2) * M_LN10;
    if (!(rate > 0)) throw BeyondReach("G is too large for the eigenfunction to be looked for");
    const auto terms = static_cast<std::size_t>(digits / rate) + spare_terms;
    const long nodes = static_cast<long>(digits / 1.4) + spare_terms; // exp(-2 sigma n) with the ellipse of the proof
    Matrix C(static_cast<slong>(terms), static_cast<slong>(terms));
    fill(C, G, w, noise(panels_of_noise(sigma), nodes));
    std::vector<double> rough(terms);
    rough[0] = 1;
    const double lambda = power_method(C, rough);
    for (const double c : rough) w.value.push_back(Ball::exactly(c));
    inverse_iteration(C, Ball::exactly(lambda), w.value);
    w.slope = chebyshev_derivative(w.value);
    return w;
}

} // namespace touchstone::limit
