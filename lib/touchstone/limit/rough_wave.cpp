// SPDX-License-Identifier: MIT
// Compiled with -O3 -fno-math-errno -ffp-contract=off: loops become vector instructions.
#include "touchstone/limit/rough_wave.hpp"

#include "touchstone/transfer/parallel.hpp"
#include "touchstone/wave/wave.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace touchstone::limit {
namespace {

using std::numbers::pi;
constexpr double digits_of_clusters = 15;
constexpr int most_terms = 64;

/// How far off an end of the wave has to be for the Chebyshev points of a cluster to carry these digits, in half widths.
double admissible_distance(int terms)
{
    const double rho = std::pow(10., digits_of_clusters / (terms - 1));
    return (rho + 1 / rho) / 2;
}

/// One wave at a ratio, as a function of z = y^2.
struct Wave {
    double x, rest, G, begin, end; ///< rest = 1 - x
    bool full;
    Wave(double x_, double rest_, double G_) : x(x_), rest(rest_), G(G_), full(rest_ <= 0)
    {
        const double low = rest / G, high = (x + 1) / G;
        begin = full ? low * low : -low * low;
        end = full ? high * high : 4 * x / (G * G);
    }
    double one_minus_c(double z) const
    {
        const double gz = G * G * z;
        return std::max(0., full ? 1 + x - std::sqrt(gz) : wave::one_minus_c_partial<double>(x, wave::radius<double>(rest, gz), gz));
    }
    double one_plus_c(double z) const
    {
        return std::max(0.,
                        full ? std::sqrt(G * G * z) + rest : wave::one_plus_c_partial<double>(rest, wave::radius<double>(rest, G * G * z)));
    }
};

/// The sum of weights[q] dtheta/dz at middle + half at[q], over pi.
TOUCHSTONE_CLONES
double by_kernel(const Wave& w, double middle, double half, const double* at, const double* weights, int count)
{
    const double G = w.G, G2 = G * G, x = w.x, rest = w.rest;
    double value[most_terms];
    if (w.full)
        for (int q = 0; q < count; ++q) {
            const double y = std::sqrt(middle + half * at[q]);
            value[q] = G / (2 * y * std::sqrt((1 + x - G * y) * (G * y + rest)));
        }
    else
        for (int q = 0; q < count; ++q) {
            const double gz = G2 * (middle + half * at[q]), R = std::sqrt(rest * rest + gz), up = 1 + x + R;
            value[q] = G2 * up / (2 * R * std::sqrt(up * (4 * x - gz) * (R + rest)));
        }
    double sum = 0;
    for (int q = 0; q < count; ++q) sum += value[q] * weights[q];
    return sum / pi;
}

/// The sum of weight[i] times the series at local[i].
TOUCHSTONE_CLONES
double by_series(const double* coefficients, int terms, const double* local, const double* weight, int count)
{
    double before[most_terms], now[most_terms] = {};
    std::fill_n(before, count, 0.);
    for (int k = terms - 1; k > 0; --k)
        for (int i = 0; i < count; ++i) {
            const double next = 2 * local[i] * now[i] - before[i] + coefficients[k];
            before[i] = now[i];
            now[i] = next;
        }
    double sum = 0;
    for (int i = 0; i < count; ++i) sum += weight[i] * (local[i] * now[i] - before[i] + coefficients[0]);
    return sum;
}

/// sums[k] += the sum of weight[i] T_k(local[i]).
TOUCHSTONE_CLONES
void add_moments(const double* local, const double* weight, int count, int terms, double* sums)
{
    double before[most_terms], now[most_terms];
    for (int i = 0; i < count; ++i) {
        before[i] = weight[i];
        now[i] = local[i] * weight[i];
    }
    for (int k = 0; k < terms; ++k) {
        double sum = 0;
        for (int i = 0; i < count; ++i) {
            sum += before[i];
            const double next = 2 * local[i] * now[i] - before[i];
            before[i] = now[i];
            now[i] = next;
        }
        sums[k] += sum;
    }
}

} // namespace

RoughWave::RoughWave(const transfer::levels::Rules& rules, const transfer::levels::Layer& mesh, const transfer::Wide& nodes)
    : terms(rules.orders.terms)
    , G(double(mesh.G))
    , admissible(admissible_distance(terms))
    , x(nodes.high)
    , chebyshev(rules.own.at.high)
    , gauss_at(rules.gauss.nodes.high)
    , gauss_weight(rules.gauss.weights.high)
    , exact_at(rules.exact.nodes.high)
    , exact_weight(rules.exact.weights.high)
    , cosines(rules.own.T.high)
    , coefficients(mesh.panels.size() * static_cast<std::size_t>(terms))
    , weights(mesh.clusters.size() * static_cast<std::size_t>(terms))
{
    for (const auto& p : mesh.panels) panels.push_back({double(p.z0), double(p.z1), double(p.centre), double(p.half)});
    for (const auto& c : mesh.clusters) {
        clusters.push_back({c.first, c.left, c.right, double(c.a), double(c.b), double(c.mid), double(c.half)});
        spans.emplace_back(c.first, c.last);
    }
    for (std::size_t i = 0; i < nodes.size(); ++i) rest.push_back(double(1 - nodes[i]));
}

void RoughWave::read(const Vector& values)
{
    const auto count = static_cast<std::size_t>(terms), exact = exact_at.size();
    Vector z(panels.size() * exact), inside(z.size());
    transfer::in_parallel(panels.size(), [&](std::size_t j) {
        double* c = &coefficients[j * count];
        for (std::size_t k = 0; k < count; ++k) {
            double sum = 0;
            for (std::size_t i = 0; i < count; ++i) sum += cosines[k * count + i] * values[j * count + i];
            c[k] = sum * (k == 0 ? 1 : 2) / terms;
        }
        const Panel& p = panels[j];
        const double half = (p.z1 - p.z0) / 2, one = 1;
        for (std::size_t g = 0; g < exact; ++g) {
            z[j * exact + g] = (p.z0 + p.z1) / 2 + half * exact_at[g];
            const double local = std::clamp((z[j * exact + g] - p.centre) / p.half, -1., 1.);
            inside[j * exact + g] = half * exact_weight[g] * by_series(c, terms, &local, &one, 1);
        }
    });
    transfer::in_parallel(clusters.size(), [&](std::size_t index) {
        const Cluster& c = clusters[index];
        Vector local(exact), moments(count);
        for (int j = spans[index].first; j <= spans[index].second; ++j) {
            const std::size_t from = static_cast<std::size_t>(j) * exact;
            for (std::size_t g = 0; g < exact; ++g) local[g] = std::clamp((z[from + g] - c.middle) / c.half, -1., 1.);
            add_moments(local.data(), &inside[from], static_cast<int>(exact), terms, moments.data());
        }
        for (std::size_t q = 0; q < count; ++q) {
            double sum = moments[0];
            for (std::size_t k = 1; k < count; ++k) sum += 2 * cosines[k * count + q] * moments[k];
            weights[index * count + q] = sum / terms;
        }
    });
}

double RoughWave::at(std::size_t node) const
{
    const Wave w(x[node], rest[node], G);
    const double begin = std::max(w.full ? w.begin : 0., panels.front().z0), G2 = G * G;
    const int points = static_cast<int>(gauss_at.size());
    double total = 0;
    enum class By { sine, cosine, square }; // of theta/2, or z itself
    const auto piece = [&](int j, By variable, double low, double high) {
        if (!(high > low)) return;
        const Panel& p = panels[static_cast<std::size_t>(j)];
        const double middle = (low + high) / 2, half = (high - low) / 2;
        double local[most_terms], weight[most_terms];
        for (int i = 0; i < points; ++i) {
            const double t = middle + half * gauss_at[static_cast<std::size_t>(i)], q = t * t;
            double z = t, density;
            if (variable == By::square) {
                const double gz = G2 * z, R = std::sqrt(w.rest * w.rest + gz), up = 1 + w.x + R;
                density = G2 * up / (2 * R * std::sqrt(up * (4 * w.x - gz) * (R + w.rest)));
            }
            else {
                if (w.full)
                    z = (variable == By::sine ? wave::square_full_from_above<double>(w.x, q)
                                              : wave::square_full_from_below<double>(w.x, q)) /
                        G2;
                else
                    z = (variable == By::sine ? wave::square_partial_from_above<double>(w.x, q)
                                              : wave::square_partial_from_below<double>(w.rest, q)) /
                        G2;
                density = 2 / std::sqrt(1 - q);
            }
            local[i] = std::clamp((z - p.centre) / p.half, -1., 1.);
            weight[i] = half * gauss_weight[static_cast<std::size_t>(i)] * density / pi;
        }
        total += by_series(&coefficients[static_cast<std::size_t>(j * terms)], terms, local, weight, points);
    };
    const auto direct = [&](int j, double low, double high) {
        if (!w.full && low < w.end / 6) { // near the edge of contact
            const double cut = std::min(high, w.end / 4);
            piece(j, By::square, low, cut);
            if (high <= cut) return;
            low = cut;
        }
        const double near = high >= w.end ? 0 : w.one_minus_c(high), far = w.one_minus_c(low);
        const double from_below = low <= w.begin ? 0 : w.one_plus_c(low), to_above = w.one_plus_c(high);
        if (far > 1 && near < 1) {
            piece(j, By::sine, std::sqrt(near / 2), std::sqrt(0.5));
            piece(j, By::cosine, std::sqrt(from_below / 2), std::sqrt(0.5));
        }
        else if (near < 1) piece(j, By::sine, std::sqrt(near / 2), std::sqrt(far / 2));
        else piece(j, By::cosine, std::sqrt(from_below / 2), std::sqrt(to_above / 2));
    };
    int waiting[512], depth = 0; // of a tree that halves lengths above 1e-31
    waiting[depth++] = 0;
    while (depth > 0) {
        const auto index = static_cast<std::size_t>(waiting[--depth]);
        const Cluster& c = clusters[index];
        if (c.b <= begin || c.a >= w.end) continue;
        if (c.a >= begin && std::min(c.middle - w.begin, w.end - c.middle) > admissible * c.half && c.half > 0)
            total += by_kernel(w, c.middle, c.half, chebyshev.data(), &weights[index * static_cast<std::size_t>(terms)], terms);
        else if (c.left >= 0) {
            waiting[depth++] = c.right;
            waiting[depth++] = c.left;
        }
        else direct(c.panel, std::max(c.a, begin), std::min(c.b, w.end));
    }
    return total;
}

Vector RoughWave::at_nodes(const Vector& values)
{
    read(values);
    Vector result(values.size());
    transfer::in_parallel(values.size(), [&](std::size_t i) { result[i] = at(i); });
    return result;
}

} // namespace touchstone::limit
