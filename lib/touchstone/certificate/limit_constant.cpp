// SPDX-License-Identifier: MIT
#include "touchstone/certificate/limit_constant.hpp"

#include "touchstone/certificate/contact.hpp"
#include "touchstone/certificate/poisson.hpp"
#include "touchstone/certificate/written_levels.hpp"
#include "touchstone/scalar/refusal.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <utility>

namespace touchstone::certificate {
namespace {

constexpr long precision = 512;
using Number = mpf_class;

/// V on the panel at the place -1 <= t <= 1, in units of the coefficients
Number sum_of(const Polynomial& v, const Number& t)
{
    Number before(1, precision), T(t, precision), sum(v.coefficients[0], precision), next(0, precision);
    for (std::size_t i = 1; i < v.coefficients.size(); ++i) {
        sum += v.coefficients[i] * T;
        next = 2 * t * T - before;
        before = std::exchange(T, next);
    }
    return sum;
}

Number level_at(const Grid& g, const Level& level, double s)
{
    std::size_t p = 0;
    while (p + 2 < g.edges.size() && g.edges[p + 1].get_d() < s) ++p;
    const double low = g.edges[p].get_d(), high = g.edges[p + 1].get_d();
    return sum_of(level.panels[p], Number((2 * s - low - high) / (high - low), precision));
}

/// The solution of A w = b, with pivots.
std::vector<Number> solved(std::vector<std::vector<Number>> A, std::vector<Number> b)
{
    const std::size_t n = b.size();
    for (std::size_t k = 0; k < n; ++k) {
        std::size_t largest = k;
        for (std::size_t i = k + 1; i < n; ++i)
            if (abs(A[i][k]) > abs(A[largest][k])) largest = i;
        std::swap(A[k], A[largest]);
        std::swap(b[k], b[largest]);
        for (std::size_t i = k + 1; i < n; ++i) {
            const Number f = A[i][k] / A[k][k];
            for (std::size_t j = k; j < n; ++j) A[i][j] -= f * A[k][j];
            b[i] -= f * b[k];
        }
    }
    for (std::size_t k = n; k-- > 0;) {
        for (std::size_t j = k + 1; j < n; ++j) b[k] -= A[k][j] * b[j];
        b[k] /= A[k][k];
    }
    return b;
}

/// Dyadic w_j of sum 1 with which the last levels add up to about the same at some ratios, in units of 2^-bits.
std::vector<mpz_class> flat_sum(const Grid& g, const std::vector<Level>& levels, std::size_t from, double least, double most, long bits)
{
    const std::size_t count = levels.size() - from;
    std::vector<std::vector<Number>> A(count, std::vector<Number>(count, Number(1, precision)));
    std::vector<Number> b(count, Number(0, precision));
    b.back() = 1;
    std::vector<Number> first;
    for (std::size_t j = 0; j < count; ++j) first.push_back(level_at(g, levels[from + j], least));
    for (std::size_t i = 0; i + 1 < count; ++i) {
        const double s = least * std::pow(most / least, static_cast<double>(i + 1) / static_cast<double>(count - 1));
        for (std::size_t j = 0; j < count; ++j) A[i][j] = level_at(g, levels[from + j], s) - first[j];
    }
    std::vector<mpz_class> w;
    mpz_class rest = mpz_class(1) << static_cast<unsigned long>(bits);
    for (const Number& x : solved(A, b)) {
        Number scaled(x, precision);
        mpf_mul_2exp(scaled.get_mpf_t(), scaled.get_mpf_t(), static_cast<mp_bitcnt_t>(bits));
        w.emplace_back(scaled);
        rest -= w.back();
    }
    w.back() += rest;
    return w;
}

/// What the checker finds: the panel's sum and its spread about v, in units of 2^-bits of the weights and of the coefficients.
struct Combined {
    mpz_class middle, spread;
    double error;
};
Combined combined(const std::vector<Level>& levels, std::size_t from, const std::vector<mpz_class>& w, std::size_t panel, long bits)
{
    Combined c{0, 0, 0};
    for (std::size_t i = 0; i < levels[from].panels[panel].coefficients.size(); ++i) {
        mpz_class sum;
        for (std::size_t j = 0; j < w.size(); ++j) sum += w[j] * levels[from + j].panels[panel].coefficients[i];
        if (i == 0)
            c.middle = sum;
        else
            c.spread += abs(sum);
    }
    for (std::size_t j = 0; j < w.size(); ++j)
        c.error += std::fabs(std::ldexp(w[j].get_d(), -static_cast<int>(bits))) * levels[from + j].panels[panel].error;
    return c;
}

struct Limit {
    Grid grid;
    std::vector<Level> levels;
    std::size_t from = 0;
    std::vector<mpz_class> weights;
    long bits = 0;
    mpz_class value; ///< in units of 2^-(bits + kept_bits)
    double error = 0;
};

/// The last `count` of 2 count levels: what depends on the ratio falls by about 2^-count a level taken in, count times over.
Limit find(const Root& root, long count, double digits)
{
    Limit r;
    r.grid = grid_for(root, 2 * count, digits, Rational(1, 2), Rational(1, 2));
    const double log_G = std::log(arf_get_d(arb_midref(r.grid.G().get()), ARF_RND_NEAR));
    const double least = 2 * (log_G - std::numbers::ln2), wanted = digits * std::numbers::ln10 + 4 * log_G + 5;
    while (r.grid.edges.back().get_d() < wanted) r.grid.edges.push_back(2 * r.grid.edges.back());
    const DiscreteOperator T(r.grid);
    r.levels = T.levels(2 * count);
    r.from = static_cast<std::size_t>(count);
    r.bits = r.grid.kept_bits;
    r.weights = flat_sum(r.grid, r.levels, r.from, std::max(least, r.grid.edges[1].get_d()), wanted / 2, r.bits);

    const double unit = std::ldexp(1.0, -static_cast<int>(r.bits + r.grid.kept_bits)), a = std::exp2(-static_cast<double>(count) - 1);
    double sizes = 0;
    for (const auto& w : r.weights) sizes += std::fabs(std::ldexp(w.get_d(), -static_cast<int>(r.bits)));
    r.value = combined(r.levels, r.from, r.weights, 1, r.bits).middle;
    const double G = std::exp(log_G), last = r.grid.edges.back().get_d();
    r.error = (sizes * G + std::fabs(r.value.get_d() * unit)) * G * G * std::exp2(-std::floor((1 - a) * last * 1.4426));
    for (std::size_t p = 0; p + 1 < r.grid.edges.size(); ++p) {
        if (r.grid.edges[p + 1].get_d() < least) continue;
        const Combined c = combined(r.levels, r.from, r.weights, p, r.bits);
        const mpz_class off = abs(c.middle - r.value) + c.spread;
        r.error += std::min(1.0, G * G * std::exp2(-std::floor(r.grid.edges[p].get_d() * 1.4426))) * (off.get_d() * unit + c.error);
    }
    return r;
}

} // namespace

std::string refusal_of_limit(const Root& G) { return refusal({1, Rational(1), G}); }

namespace {

bool is_partial(const Root& G) { return power(Rational(2009, 1000), static_cast<long>(G.degree)) <= G.base; }

} // namespace

std::string limit_constants(const std::vector<Root>& all, Accuracy wanted)
{
    std::string head;
    Lines lines;
    const double goal = std::pow(10.0, -static_cast<double>(wanted.digits)) / 2;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (!is_partial(all[i])) {
            write_poisson(all[i], std::min(wanted.digits, most_digits_by_poisson), i + 1, i + 1, head, lines);
            continue;
        }
        auto digits = static_cast<double>(wanted.digits) + 1;
        auto count = static_cast<long>(std::ceil(std::sqrt(digits * 3.33))) + 1;
        Limit r = find(all[i], count, digits);
        const auto relative = [&r] { return r.error / std::ldexp(r.value.get_d(), -static_cast<int>(r.bits + r.grid.kept_bits)); };
        for (int attempt = 0; relative() > goal; ++attempt) {
            if (attempt == 3) throw BeyondReach(fmt::format("the certificate's errors do not come below {:.1e}", goal));
            digits += std::max(0.0, std::log10(relative() / goal)) + 1;
            r = find(all[i], ++count, digits);
        }
        const WrittenSection written = write_levels(r.grid, r.levels, lines);
        std::vector<std::size_t> rests_on{written.grid};
        for (std::size_t m = r.from; m < r.levels.size(); ++m)
            rests_on.insert(rests_on.end(), written.levels[m].begin(), written.levels[m].end());
        std::string data = fmt::format("claim={} m={:x} exponent={}", i + 1, r.from, -r.bits);
        for (const auto& w : r.weights) data += ' ' + hex(w);
        lines.add("limit", rests_on, data);
        head += fmt::format("claim {} G={} value={} error={}\n", i + 1, named(all[i]), dyadic(r.value, -r.bits - r.grid.kept_bits),
                            dyadic(rounded_up(narrow * r.error)));
        Counts counts = written.counts();
        counts.emplace_back("limits", 1);
        head += section_line(i + 1, written.grid, lines.count(), counts);
    }
    return certificate_text("limit.area_constant", all.size(), all.size(), head, lines);
}

} // namespace touchstone::certificate
