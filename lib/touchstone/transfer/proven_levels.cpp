// SPDX-License-Identifier: MIT
#include "touchstone/transfer/proven_levels.hpp"

#include "touchstone/catalogue/quantity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <list>
#include <mutex>
#include <thread>
#include <vector>

namespace touchstone::transfer {
namespace {

using Real = long double;
static_assert(std::numeric_limits<Real>::is_iec559 && std::numeric_limits<Real>::digits >= 64,
              "the error counts below are for long double of at least 64 bits");
using std::abs, std::max, std::min, std::sqrt;

constexpr Real u = std::numeric_limits<Real>::epsilon(); // twice the largest relative error of one operation
constexpr Real infinite = std::numeric_limits<Real>::infinity();
constexpr Real pi_below = 3.14159265358979323846L;
constexpr int levels = ProvenLevels::levels;
constexpr Real margin = 1.001L; // on bounds that are themselves computed with a few roundings

Real power(Real x, int n)
{
    Real r = 1;
    for (; n > 0; n >>= 1, x *= x)
        if (n & 1) r *= x;
    return r;
}

Ball to_ball(Real x)
{
    const double high = static_cast<double>(x);
    if (!std::isfinite(high)) return Ball::indeterminate();
    const Real rest = x - static_cast<Real>(high);
    const WorkingPrecision precision(256);
    return Ball::exactly(high) + Ball::exactly(static_cast<double>(rest)); // 53 + 53 bits hold x, or all but u^2 of it
}
/// The midpoint, within a relative error of u.
Real to_real(const Ball& x)
{
    const WorkingPrecision precision(256);
    const double high = arf_get_d(arb_midref(x.get()), ARF_RND_NEAR);
    const Ball rest = x - Ball::exactly(high);
    return static_cast<Real>(high) + static_cast<Real>(arf_get_d(arb_midref(rest.get()), ARF_RND_NEAR));
}

void in_parallel(std::size_t count, const auto& work)
{
    std::atomic<std::size_t> next{0};
    const auto run = [&] {
        for (std::size_t i; (i = next++) < count;) work(i);
    };
    std::vector<std::thread> others;
    for (unsigned t = 1; t < max(1U, std::thread::hardware_concurrency()); ++t) others.emplace_back(run);
    run();
    for (auto& t : others) t.join();
}

// ---- the mesh

/// The polynomial of a panel holds on z0 <= z <= z1, z = x^2, and is a good approximation on centre +- half, a little more.
struct Panel {
    Real y0, y1, z0, z1, centre, half;
    Real left() const { return centre - half; }
    Real right() const { return centre + half; }
};

/// Where B_m cannot be smooth: 1, and with s the ratios Gs - 1, Gs + 1, G^2 s^2/4 that lead to it. Only the mesh depends on this
/// list, no proof: it may be inexact and end early.
struct Singular {
    Real s, size; ///< next to s panels may be as small as size
};

std::vector<Singular> singular_points(Real G, Real highest, Real tolerance, Real coarsest)
{
    std::vector<Singular> found{{0, tolerance / 10}};
    std::vector<Real> generation{1};
    for (int g = 0; !generation.empty(); ++g) {
        // |x - s|^((g+1)/2) with a coefficient that falls like this (measured), weighing size^(1/2) at the next scale
        const Real strength = std::pow(0.4L, g) / std::sqrt(std::tgamma(static_cast<Real>(g + 1)));
        const Real size = g == 0 ? tolerance : 4 * std::pow(tolerance / strength, 2.0L / (g + 2));
        if (size > coarsest / 2 || found.size() > 20'000) break;
        std::vector<Real> next;
        std::sort(generation.begin(), generation.end());
        Real last = -1;
        for (const Real s : generation) {
            if (abs(s - last) < 1e-15L * (1 + s)) continue;
            last = s;
            if (std::any_of(found.begin(), found.end(), [&](const Singular& f) { return f.s != 0 && abs(f.s - s) < min(f.size, 1e-13L); })) continue;
            found.push_back({s, size});
            if (G * s - 1 >= 1 && G * s - 1 < highest) next.push_back(G * s - 1);
            if (G * s + 1 < highest) next.push_back(G * s + 1);
            if (G * G * s * s <= 4) next.push_back(G * G * s * s / 4);
        }
        generation = std::move(next);
    }
    return found;
}

std::vector<Panel> mesh(Real G, Real highest, Real tolerance)
{
    constexpr Real coarsest = 0.35L, grading = 0.6L, grading_at_zero = 0.35L, overlap = 1.4L; // z = x^2 doubles relative sizes at 0
    constexpr std::size_t most = 30'000;
    const auto singular = singular_points(G, highest, tolerance, coarsest);
    const auto size = [&](Real x) {
        Real h = coarsest;
        for (const auto& p : singular) h = min(h, max(p.size, (p.s == 0 ? grading_at_zero : grading) * abs(x - p.s)));
        return h;
    };
    std::vector<Panel> panels;
    for (Real y = tolerance / 10; y < highest;) {
        Real h = size(y);
        h = min(h, size(y + h));
        h = min(h, max(size(y + h / 2), h / 3));
        Panel p{y, y + h, y * y, (y + h) * (y + h), 0, 0};
        p.centre = (p.z0 + p.z1) / 2;
        p.half = (p.z1 - p.z0) / 2 * overlap;
        if (panels.empty()) p.half = p.centre - p.z0; // nothing is known to its left
        panels.push_back(p);
        if (panels.size() > most) throw BeyondReach("the mesh would be too large");
        y = p.y1;
    }
    return panels;
}

/// A run of panels seen as one from afar: the kernel of T is interpolated on a <= z <= b.
struct Cluster {
    int first, last;         ///< panels
    int left = -1, right = -1;
    Real a, b, mid, half;
    int panels() const { return last - first + 1; }
};

int add_clusters(std::vector<Cluster>& all, const std::vector<Panel>& panels, int first, int last)
{
    const int mine = static_cast<int>(all.size());
    const Real a = panels[first].z0, b = panels[last].z1;
    all.push_back({first, last, -1, -1, a, b, (a + b) / 2, (b - a) / 2});
    if (first < last) {
        const Real middle = (panels[first].y0 + panels[last].y1) / 2;
        int cut = first;
        while (cut + 1 < last && panels[cut + 1].y0 < middle) ++cut;
        const int left = add_clusters(all, panels, first, cut), right = add_clusters(all, panels, cut + 1, last);
        all[mine].left = left;
        all[mine].right = right;
    }
    return mine;
}

struct GaussRule {
    std::vector<Real> nodes, weights;
    explicit GaussRule(int count)
    {
        const WorkingPrecision precision(160);
        for (int i = 0; i < count; ++i) {
            Ball x, w;
            arb_hypgeom_legendre_p_ui_root(x.get(), w.get(), static_cast<ulong>(count), static_cast<ulong>(i), precision.bits());
            nodes.push_back(to_real(x));
            weights.push_back(to_real(w));
        }
    }
};

/// Chebyshev points of the first kind and T_k there.
struct ChebyshevPoints {
    std::vector<Real> at;
    std::vector<Real> T; ///< T[k * count + i]
    explicit ChebyshevPoints(int count)
    {
        const WorkingPrecision precision(160);
        const auto cosine = [&](int p) { return to_real(ScalarTraits<Ball>::cos_pi(Ball(p) / Ball(2 * count))); };
        for (int i = 0; i < count; ++i) at.push_back(cosine(2 * i + 1));
        for (int k = 0; k < count; ++k)
            for (int i = 0; i < count; ++i) T.push_back(cosine(k * (2 * i + 1) % (4 * count)));
    }
};

/// The rho of the Bernstein ellipse through focal sum 2(1 + d): what lies within d of [-1, 1] lies inside.
Real ellipse_of_distance(Real d) { return 1 + d + sqrt(d * (2 + d)); }

} // namespace

struct ProvenLevels::State {
    Real G, tolerance;
    int terms, gauss_count, kernel_terms, check_count;
    std::vector<Panel> panels;
    std::vector<Cluster> clusters;
    GaussRule gauss, exact_gauss;
    ChebyshevPoints own, kernel_points, check;

    std::vector<Real> coefficients;  ///< [(panel * terms + k) * levels + m]
    std::vector<Real> weights;       ///< [(cluster * kernel_terms + q) * levels + m]: integral of V_m times the q-th Lagrange polynomial
    std::vector<Real> growth;        ///< [panel * levels + m]: sum |c_k| 6^k
    std::vector<Real> rounding;      ///< [panel * levels + m]: error of evaluating V_m on the panel, the point's own rounding included
    std::vector<Real> jump;          ///< [panel * levels + m]: at least the jumps of V_m at the panel's edges and at those of its neighbours
    std::vector<Real> size;          ///< [panel * levels + m]: sum |c_k|
    std::vector<Real> noise;         ///< [cluster * levels + m]: mean error of V_m on the cluster, from `rounding`
    std::vector<Real> largest;       ///< [m]: at least |V_m|
    std::vector<Real> defect;        ///< [panel * levels + m]: at least |T V_{m-1} - V_m|, resp. |B_0 - V_0|

    State(Real G_, Real highest, Real tolerance_, int terms_)
        : G(G_), tolerance(tolerance_), terms(terms_), gauss_count(terms_ - 4), kernel_terms(terms_), check_count(terms_ + 10),
          panels(mesh(G_, highest, tolerance_)), gauss(gauss_count), exact_gauss(terms_), own(terms_), kernel_points(kernel_terms), check(check_count)
    {
        add_clusters(clusters, panels, 0, static_cast<int>(panels.size()) - 1);
        coefficients.resize(panels.size() * terms * levels);
        weights.resize(clusters.size() * kernel_terms * levels);
        for (auto* table : {&growth, &rounding, &jump, &size, &defect}) table->resize(panels.size() * levels);
        noise.resize(clusters.size() * levels);
        largest.resize(levels);
        collocate();
        prove();
    }

    std::size_t at(std::size_t panel, int m) const { return panel * levels + m; }
    const Real* row(std::size_t panel, int k) const { return &coefficients[(panel * terms + k) * levels]; }
    int find(Real z) const
    {
        const auto it = std::upper_bound(panels.begin(), panels.end(), z, [](Real v, const Panel& p) { return v < p.z0; });
        return max(0, static_cast<int>(it - panels.begin()) - 1);
    }

    struct Values {
        Real value[levels] = {}, error[levels] = {};
    };
    void apply(Real x, int from, int to, Values&) const;
    void collocate();
    void prove();
    void prove_panel(std::size_t i, std::vector<Real>& overlap_defect, std::vector<char>& by_monotony);
    Real value(std::size_t panel, int m, Real local) const
    {
        Real b1 = 0, b2 = 0;
        for (int k = terms - 1; k > 0; --k) {
            const Real b = 2 * local * b1 - b2 + row(panel, k)[m];
            b2 = b1;
            b1 = b;
        }
        return local * b1 - b2 + row(panel, 0)[m];
    }
    Real growth_at(std::size_t panel, int m, Real rho) const
    {
        Real sum = 0, p = 1;
        for (int k = 0; k < terms; ++k, p *= rho) sum += abs(row(panel, k)[m]) * p;
        return sum;
    }
    /// Bounds T D_m on all x from which no ratio above `reach` is met.
    Real effect(int m, Real reach) const;
    std::vector<Real> sum_of_effects; ///< [m]: at least T |B_m - V_m|
    void finish_level(int m, const std::vector<Real>& nodal);
};

// ---- T V_m at a point

namespace {

/// One x: where the kernel begins and ends in z, and 1 - c, 1 + c as functions of z.
struct Kernel {
    Real x, G, G2, begin, end;
    bool full;
    Kernel(Real x_, Real G_)
        : x(x_), G(G_), G2(G_ * G_), begin(x_ < 1 ? -((1 - x_) / G_) * ((1 - x_) / G_) : ((x_ - 1) / G_) * ((x_ - 1) / G_)),
          end(x_ < 1 ? 4 * x_ / (G_ * G_) : ((x_ + 1) / G_) * ((x_ + 1) / G_)), full(x_ >= 1)
    {
    }
    /// z where 1 - c = gap, x < 1
    Real z_of(Real gap) const { return max(Real(0), (2 - gap) * (2 * x - gap)) / G2; }
    Real root(Real z) const { return sqrt((1 - x) * (1 - x) + G2 * z); }
    Real one_minus_c(Real z) const
    {
        return max(Real(0), full ? 1 + x - G * sqrt(z) : (4 * x - G2 * z) / (1 + x + root(z)));
    }
    Real one_plus_c(Real z) const { return max(Real(0), full ? G * sqrt(z) - x + 1 : root(z) + 1 - x); }
    /// dtheta/dz
    Real density(Real z) const
    {
        const Real s = sqrt(one_minus_c(z) * one_plus_c(z));
        return full ? G / (2 * sqrt(z) * s) : G2 / (2 * root(z) * s);
    }
};

struct ClusterError {
    Real total;   ///< per unit of |V|
    Real measure; ///< per unit of an error of V on average
};

/// Bounds on a cluster, interpolation of dtheta/dz and every rounding, per unit of |V|. Infinite where the cluster will not do.
ClusterError cluster_error(const Kernel& k, const Cluster& c, int terms, Real affordable)
{
    const Real e = min((c.mid - k.begin) / c.half, (k.end - c.mid) / c.half);
    if (!(e > 1.3L)) return {infinite, infinite};
    const Real axis = 1 + 0.8L * (e - 1), rho = axis + sqrt(axis * axis - 1);
    const Real far = c.mid + c.half * axis;
    const Real from_begin = c.mid - k.begin - c.half * axis, from_end = k.end - c.mid - c.half * axis;
    Real bound, cancellation;
    if (k.full) {
        bound = sqrt((sqrt(k.end) + sqrt(far)) * (sqrt(far) + sqrt(k.begin)) / (from_begin * from_end)) / (2 * sqrt(c.mid - c.half * axis));
        cancellation = (1 + k.x) / min(k.one_minus_c(c.b), k.one_plus_c(c.a));
    } else {
        const Real least = k.G * sqrt(from_begin), most = sqrt((1 - k.x) * (1 - k.x) + k.G2 * far);
        bound = k.G2 / (2 * least) * sqrt((1 + k.x + most) / (k.G2 * from_end * least));
        cancellation = 4 * k.x / (4 * k.x - k.G2 * c.b);
    }
    const Real interpolation = 4 / (power(rho, terms - 1) * (rho - 1));
    // the moments of V meet the kernel's Chebyshev coefficients, which fall like rho^-k; they are sums over the panels
    const Real roundings = u * (4 * terms * terms + 500 + 2 * terms * c.panels() * rho / (rho - 1) + 48 * cancellation);
    const Real scale = margin * bound * 2 * c.half / pi_below;
    if (scale * interpolation > affordable || scale * roundings > max(affordable, 4000 * u)) return {infinite, infinite};
    return {scale * (interpolation + roundings), 4 * scale}; // Lebesgue constant of up to 40 points below 4
}

} // namespace

void ProvenLevels::State::apply(Real x, int from, int to, Values& out) const
{
    const Kernel k(x, G);
    const Real begin = max(k.full ? k.begin : 0, panels.front().z0);
    if (!(k.end > begin)) {
        for (int m = from; m < to; ++m) out.error[m] = sqrt(16 * u * (1 + x)) * largest[m];
        return;
    }
    if (k.end > panels.back().z1) { // outside the mesh: nothing is known
        for (int m = from; m < to; ++m) out.error[m] = infinite;
        return;
    }
    std::vector<Real> moment(terms);
    enum class Variable { sine, cosine, square };
    const auto seam = [&](Real z) { // the same edge, rounded differently on its two sides
        const Real lost = margin * u * 16 * (1 + x) / sqrt(k.one_minus_c(z) * k.one_plus_c(z)) / pi_below;
        for (int m = from; m < to; ++m) out.error[m] += lost * largest[m];
    };
    // part of panel j; limits are sin(theta/2), cos(theta/2) or z
    const auto piece = [&](int j, Variable variable, Real low, Real high) {
        if (!(high > low)) return;
        const Panel& p = panels[j];
        const Real mid = (low + high) / 2, half = (high - low) / 2;
        std::fill(moment.begin(), moment.end(), Real(0));
        Real measure = 0;
        for (int i = 0; i < gauss_count; ++i) {
            const Real t = mid + half * gauss.nodes[i], q = t * t;
            Real z, w;
            switch (variable) {
            case Variable::sine: // c = 1 - 2 q
                z = k.full ? (x + 1 - 2 * q) * (x + 1 - 2 * q) / k.G2 : 4 * (1 - q) * (x - q) / k.G2;
                w = 2 / sqrt(1 - q);
                break;
            case Variable::cosine: // c = 2 q - 1
                z = k.full ? (x - 1 + 2 * q) * (x - 1 + 2 * q) / k.G2 : 4 * q * (q - (1 - x)) / k.G2;
                w = 2 / sqrt(1 - q);
                break;
            default:
                z = t;
                w = k.density(z);
            }
            w *= half * gauss.weights[i] / pi_below;
            measure += w;
            const Real local = (z - p.centre) / p.half;
            Real t0 = 1, t1 = local;
            moment[0] += w;
            moment[1] += w * local;
            for (int d = 2; d < terms; ++d) {
                const Real t2 = 2 * local * t1 - t0;
                moment[d] += w * t2;
                t0 = t1;
                t1 = t2;
            }
        }
        // Gauss: the largest disc about the middle where |local| <= 2.916, inside the ellipse of rho = 6
        const Real largest_local = 2.916L;
        Real A = 0, B = 0;
        if (variable == Variable::sine) A = k.full ? (x + 1) * (x + 1) : 4 * x, B = k.full ? -4 * (x + 1) : -4 * (1 + x);
        if (variable == Variable::cosine) A = k.full ? (x - 1) * (x - 1) : 0, B = k.full ? 4 * (x - 1) : -4 * (1 - x);
        const Real q = mid * mid; // z G^2 = A + B t^2 + 4 t^4 about t = mid
        const Real a0 = abs((A + B * q + 4 * q * q) / k.G2 - p.centre), a1 = abs(2 * B * mid + 16 * q * mid) / k.G2, a2 = abs(B + 24 * q) / k.G2,
                   a3 = 16 * mid / k.G2, a4 = 4 / k.G2;
        const auto reach = [&](Real d) {
            return margin * (variable == Variable::square ? abs(mid - p.centre) + d : a0 + d * (a1 + d * (a2 + d * (a3 + d * a4)))) / p.half;
        };
        Real d = 0, cannot = min(20 * half, variable == Variable::square ? 0.9L * mid : 0.95L - mid);
        if (variable == Variable::square) cannot = min(cannot, 0.9L * (k.end - mid));
        if (reach(cannot) <= largest_local) d = cannot;
        else
            for (int step = 0; step < 12; ++step) {
                const Real middle = (d + cannot) / 2;
                (reach(middle) <= largest_local ? d : cannot) = middle;
            }
        Real quadrature = infinite;
        if (d > 1.02L * half) {
            const Real axis = d / half, rho = axis + sqrt(axis * axis - 1);
            Real w;
            if (variable == Variable::square) {
                const Real least = k.root(mid - d), most = k.root(mid + d);
                w = k.G2 / (2 * least) * sqrt((1 + x + most) / ((4 * x - k.G2 * (mid + d)) * (0.7L * least + 1 - x)));
            } else w = 2 / sqrt(1 - (mid + d) * (mid + d));
            quadrature = margin * 64 / 15 * half * w / pi_below / (power(rho, 2 * gauss_count - 2) * (1 - 1 / (rho * rho)));
        }
        for (int m = from; m < to; ++m) out.error[m] += (growth[at(j, m)] > 0 ? quadrature * growth[at(j, m)] : 0) + margin * measure * rounding[at(j, m)];
        for (int d2 = 0; d2 < terms; ++d2) {
            const Real* c = row(j, d2);
            for (int m = from; m < to; ++m) out.value[m] += c[m] * moment[d2];
        }
    };
    const auto direct = [&](int j, Real low, Real high) {
        const Real root_half = sqrt(Real(0.5));
        if (!k.full && low < k.end / 6) { // near the edge of contact, distances are kept in z itself
            const Real cut = min(high, k.end / 4);
            piece(j, Variable::square, low, cut);
            seam(cut);
            if (high <= cut) return;
            low = cut;
        }
        const Real near = high >= k.end ? 0 : k.one_minus_c(high), far = k.one_minus_c(low);
        const Real from_below = low <= k.begin ? 0 : k.one_plus_c(low), to_above = k.one_plus_c(high);
        if (far <= 1) piece(j, Variable::sine, sqrt(near / 2), sqrt(far / 2));
        else if (near >= 1) piece(j, Variable::cosine, sqrt(from_below / 2), sqrt(to_above / 2));
        else {
            piece(j, Variable::sine, sqrt(near / 2), root_half);
            piece(j, Variable::cosine, sqrt(from_below / 2), root_half);
        }
    };
    const Real affordable = tolerance / 256;
    bool after_cluster = false, after_direct = false;
    std::vector<int> waiting{0};
    std::vector<Real> kernel(kernel_terms);
    int visits = 0; // each adds `terms` numbers to a sum of at most 2 largest[m]
    while (!waiting.empty()) {
        const int index = waiting.back();
        waiting.pop_back();
        const Cluster& c = clusters[index];
        if (c.b <= begin || c.a >= k.end) continue;
        if (c.a >= begin && c.b <= k.end) {
            const ClusterError lost = cluster_error(k, c, kernel_terms, affordable);
            if (lost.total < infinite) {
                if (after_direct) seam(c.a);
                after_cluster = true;
                ++visits;
                after_direct = false;
                for (int q = 0; q < kernel_terms; ++q) kernel[q] = k.density(c.mid + c.half * kernel_points.at[q]) / pi_below;
                for (int q = 0; q < kernel_terms; ++q) {
                    const Real* w = &weights[(static_cast<std::size_t>(index) * kernel_terms + q) * levels];
                    for (int m = from; m < to; ++m) out.value[m] += kernel[q] * w[m];
                }
                for (int m = from; m < to; ++m)
                    out.error[m] += lost.total * largest[m] + lost.measure * noise[static_cast<std::size_t>(index) * levels + m];
                continue;
            }
        }
        if (c.left >= 0) {
            waiting.push_back(c.right);
            waiting.push_back(c.left);
            continue;
        }
        if (after_cluster) seam(c.a);
        after_direct = true;
        after_cluster = false;
        visits += 3;
        direct(c.first, max(c.a, begin), min(c.b, k.end));
    }
    // edges of panels next to the kernel's ends move by their rounding, a share of at most (16 u (1 + x))^(1/2): what jumps there is lost
    const Real strip = sqrt(16 * u * (1 + x));
    const std::size_t at_end = static_cast<std::size_t>(find(k.end)), at_begin = static_cast<std::size_t>(find(begin));
    for (int m = from; m < to; ++m)
        out.error[m] += margin * (u * 2 * terms * visits * largest[m] + strip * (jump[at(at_end, m)] + jump[at(at_begin, m)]));
}

// ---- V_0 ... V_19

void ProvenLevels::State::finish_level(int m, const std::vector<Real>& nodal)
{
    in_parallel(panels.size(), [&](std::size_t j) {
        Real total = 0, squares = 0, six = 0, p = 1;
        for (int k = 0; k < terms; ++k, p *= 6) {
            Real sum = 0;
            for (int i = 0; i < terms; ++i) sum += own.T[k * terms + i] * nodal[j * terms + i];
            const Real c = (k == 0 ? 1 : 2) * sum / terms;
            coefficients[(j * terms + k) * levels + m] = c;
            total += abs(c);
            squares += static_cast<Real>(k) * k * abs(c);
            six += abs(c) * p;
        }
        size[at(j, m)] = margin * total;
        growth[at(j, m)] = margin * six;
        // z is known within 40 u z (T and the rounding of G), |T_k'| <= k^2; recurrences for T_k lose at most 2 k^2 u
        rounding[at(j, m)] = margin * u * ((40 * panels[j].right() / panels[j].half + 2) * squares + (40 + 4 * terms) * total);
    });
    std::vector<Real> edge{size[at(0, m)]}; // V is 0 below the first panel
    for (std::size_t j = 1; j < panels.size(); ++j) {
        const Panel &a = panels[j - 1], &b = panels[j];
        edge.push_back(abs(value(j - 1, m, (a.z1 - a.centre) / a.half) - value(j, m, (b.z0 - b.centre) / b.half)) + rounding[at(j - 1, m)] + rounding[at(j, m)]);
    }
    edge.push_back(size[at(panels.size() - 1, m)]);
    for (std::size_t j = 0; j < panels.size(); ++j) {
        jump[at(j, m)] = edge[j] + edge[j + 1];
        if (j > 0) jump[at(j, m)] += edge[j - 1];
        if (j + 2 < edge.size()) jump[at(j, m)] += edge[j + 2];
    }
    Real most = 0;
    for (std::size_t j = 0; j < panels.size(); ++j) most = max(most, size[at(j, m)]);
    largest[m] = most;
    // integrals of V_m against the Lagrange polynomials of every cluster: a polynomial of degree 2 terms - 2, exact by Gauss
    std::vector<Real> inside(panels.size() * terms);
    in_parallel(panels.size(), [&](std::size_t j) {
        const Panel& p = panels[j];
        for (int g = 0; g < terms; ++g) {
            const Real z = (p.z0 + p.z1) / 2 + (p.z1 - p.z0) / 2 * exact_gauss.nodes[g];
            inside[j * terms + g] = (p.z1 - p.z0) / 2 * exact_gauss.weights[g] * value(j, m, (z - p.centre) / p.half);
        }
    });
    in_parallel(clusters.size(), [&](std::size_t index) {
        const Cluster& c = clusters[index];
        std::vector<Real> moment(kernel_terms);
        Real lost = 0;
        for (int j = c.first; j <= c.last; ++j) {
            const Panel& p = panels[j];
            lost += rounding[at(j, m)] * (p.z1 - p.z0);
            for (int g = 0; g < terms; ++g) {
                const Real z = (p.z0 + p.z1) / 2 + (p.z1 - p.z0) / 2 * exact_gauss.nodes[g];
                const Real local = (z - c.mid) / c.half, w = inside[j * terms + g];
                Real t0 = 1, t1 = local;
                moment[0] += w;
                moment[1] += w * local;
                for (int k = 2; k < kernel_terms; ++k) {
                    const Real t2 = 2 * local * t1 - t0;
                    moment[k] += w * t2;
                    t0 = t1;
                    t1 = t2;
                }
            }
        }
        noise[index * levels + m] = margin * lost / (2 * c.half);
        for (int q = 0; q < kernel_terms; ++q) {
            Real sum = moment[0];
            for (int k = 1; k < kernel_terms; ++k) sum += 2 * kernel_points.T[k * kernel_terms + q] * moment[k];
            weights[(index * kernel_terms + q) * levels + m] = sum / kernel_terms;
        }
    });
}

void ProvenLevels::State::collocate()
{
    std::vector<Real> nodal(panels.size() * terms);
    in_parallel(panels.size(), [&](std::size_t j) {
        const WorkingPrecision precision(128);
        for (int i = 0; i < terms; ++i) { // B_0 = (2/pi) arcsin sqrt x, x = z^(1/2)
            const Ball z = to_ball(panels[j].centre) + to_ball(panels[j].half) * to_ball(own.at[i]);
            nodal[j * terms + i] = certainly(less(z, Ball(1))) ? to_real(2 * asin(sqrt(sqrt(z))) / pi<Ball>()) : 1;
        }
    });
    finish_level(0, nodal);
    for (int m = 0; m + 1 < levels; ++m) {
        in_parallel(nodal.size(), [&](std::size_t r) {
            const Panel& p = panels[r / terms];
            Values v;
            apply(sqrt(p.centre + p.half * own.at[r % terms]), m, m + 1, v);
            nodal[r] = v.value[m];
        });
        finish_level(m + 1, nodal);
    }
}

// ---- the proof

void ProvenLevels::State::prove_panel(std::size_t i, std::vector<Real>& overlap_defect, std::vector<char>& by_monotony)
{
    const Panel& p = panels[i];
    constexpr Real rho = 4, spread = (rho + 1 / rho) / 2;
    const Real lebesgue = 1 + 2 / pi_below * std::log(static_cast<Real>(check_count)) * margin;
    const Real tail = margin * 4 / (power(rho, check_count - 1) * (rho - 1));
    Real* D = &defect[at(i, 0)];

    { // |B_0 - V_0|
        const Real distance = min(p.centre, 1 - p.centre) / p.half * 0.999L;
        if (p.left() >= 1) D[0] = margin * (terms * terms * u + rounding[at(i, 0)]);
        else if (distance > 1.05L) {
            const Real r = distance + sqrt(distance * distance - 1);
            D[0] = margin * (4 / (power(r, terms - 1) * (r - 1)) + (terms * terms + 100) * u) + rounding[at(i, 0)];
        } else { // increasing, between its ends
            const WorkingPrecision precision(128);
            const Real low = i == 0 ? 0 : to_real(2 * asin(sqrt(sqrt(to_ball(p.left())))) / pi<Ball>()) * (1 - 4 * u);
            const Real c0 = row(i, 0)[0];
            Real rest = 2 * u;
            for (int k = 1; k < terms; ++k) rest += abs(row(i, k)[0]);
            D[0] = max(min(Real(1), sqrt(sqrt(p.right()))) - (c0 - rest), c0 + rest - low) + rounding[at(i, 0)];
        }
    }
    struct End {
        int panel = -1;
        Real factor, distance, outside;
    };
    // the polynomial to use where the kernel ends at z, and the edge where it takes over
    const auto end_panel = [&](Real z, bool upper) {
        int j = find(z);
        const int last = static_cast<int>(panels.size()) - 1;
        if (upper && j > 0 && z - panels[j].z0 < (panels[j - 1].right() - panels[j - 1].z1) / 2) --j;
        if (!upper && j < last && panels[j].z1 - z < (panels[j + 1].z0 - panels[j + 1].left()) / 2) ++j;
        return j;
    };
    const Real left = sqrt(p.left()), right = sqrt(p.right()), width = right - left;
    std::vector<std::pair<Real, Real>> waiting{{left, right}};
    while (!waiting.empty()) {
        const auto [low, high] = waiting.back();
        waiting.pop_back();
        const Real x = (low + high) / 2, half = (high - low) / 2 * (1 + 4 * u) + 2 * u * x, r = half * spread * margin;
        End ends[2];
        Real middle = 0;
        bool seam = low < 1 && high > 1, near_one = seam;
        const auto analytic = [&] {
            if (seam) return false;
            if (x >= 1) {
                if (x - r <= 1) return false;
                for (const bool upper : {false, true}) {
                    const Real y = (upper ? x + 1 : x - 1) / G, y_low = (upper ? low + 1 : low - 1) / G, y_high = (upper ? high + 1 : high - 1) / G;
                    if (y < 1.3L * panels.front().y0) {
                        near_one = true;
                        return false;
                    }
                    const int e = end_panel(y * y, upper);
                    const Panel& q = panels[e];
                    const Real inner = upper ? max(q.y0, y - 0.8L / G) : min(q.y1, y + 0.8L / G); // any point of the panel will do
                    const Real gap = upper ? 1 + x - G * inner : G * inner - x + 1;
                    if (r > 0.79L * gap || gap > 0.9L || y_low * y_low < q.left() * (1 + 8 * u) || y_high * y_high > q.right() * (1 - 8 * u)) return false;
                    ends[upper] = {e, sqrt(1.8L * gap) * 2 / sqrt(2 - 1.8L * gap) / pi_below, (2 * max(y, inner) * r + r * r / G) / G / q.half,
                                   sqrt(G * (upper ? sqrt(q.right()) - q.y1 : q.y0 - sqrt(max(Real(0), q.left()))) / 2)};
                }
                middle = 5;
            } else {
                if (r > 0.24L * (1 - x) || r > 0.5L * x) return false;
                const Real y2 = 4 * x / (G * G);
                if (y2 < 1.7L * panels.front().z0) return false;
                const int e = end_panel(y2, true);
                const Panel& q = panels[e];
                const Kernel k(x, G);
                const Real gap = k.one_minus_c(max(q.z0, k.z_of(0.8L))), dc = 2.36L * r;
                if (dc > 0.79L * gap || gap > 0.9L || 4 * low / (G * G) < q.left() * (1 + 8 * u) || 4 * high / (G * G) > q.right() * (1 - 8 * u)) return false;
                ends[1] = {e, sqrt(1.8L * gap) * 2 / sqrt(2 - 1.8L * gap) / pi_below,
                           (2 * (2 * r + dc) + 2 * x * dc + dc * (2 * r + dc)) / (G * G) / q.half, sqrt(G * (sqrt(q.right()) - q.y1) / 2)};
                middle = 4.1L;
            }
            return true;
        };
        bool ok = analytic();
        Real bounds[levels];
        const Real small = max(1e-6L * width, 1e6L * u * x); // so that rounding moves a check point by less than 1e-6 of J
        if (ok) {
            const Real own_distance = (2 * x * r + r * r) / p.half;
            for (int m = 1; m < levels; ++m) {
                Real bound = growth_at(i, m, ellipse_of_distance(own_distance)) + middle * largest[m - 1];
                for (const End& e : ends)
                    if (e.panel >= 0) bound += e.factor * growth_at(e.panel, m - 1, ellipse_of_distance(e.distance));
                bounds[m] = margin * bound * tail;
                if (bounds[m] > tolerance / 4 && half > 100 * small) ok = false;
            }
        }
        if (!ok && half > small && !(near_one && half < 0.02L * width)) {
            waiting.emplace_back(low, x);
            waiting.emplace_back(x, high);
            continue;
        }
        if (!ok) { // B_m is increasing: between its values at the ends
            by_monotony[i] = 1;
            Values a, b;
            apply(low * (1 - 4 * u), 0, levels - 1, a);
            apply(high * (1 + 4 * u), 0, levels - 1, b);
            for (int m = 1; m < levels; ++m) {
                Real slope = 0;
                for (int k = 1; k < terms; ++k) slope += abs(row(i, k)[m]) * k * k;
                const Real change = margin * min(slope * (high * high - low * low) / p.half, 2 * size[at(i, m)]);
                const Real v = value(i, m, (low * low - p.centre) / p.half);
                D[m] = max(D[m], margin * (max(abs(b.value[m - 1] - v), abs(v - a.value[m - 1])) + change + a.error[m - 1] + b.error[m - 1] + 2 * rounding[at(i, m)]));
            }
            continue;
        }
        Real most[levels] = {};
        for (const Real node : check.at) {
            const Real at_x = x + half * node, local = (at_x * at_x - p.centre) / p.half;
            Values v;
            apply(at_x, 0, levels - 1, v);
            for (int m = 1; m < levels; ++m) {
                const Real difference = abs(v.value[m - 1] - value(i, m, local)) + v.error[m - 1] + 2 * rounding[at(i, m)];
                most[m] = difference <= infinite ? max(most[m], difference) : infinite; // not a number: nothing is known
            }
        }
        for (int m = 1; m < levels; ++m) {
            Real overlap = 0;
            for (const End& e : ends)
                if (e.panel >= 0) overlap += e.outside * overlap_defect[at(e.panel, m - 1)];
            D[m] = max(D[m], margin * (lebesgue * (most[m] + overlap) + overlap + bounds[m]));
        }
    }
}

void ProvenLevels::State::prove()
{
    // how far the polynomial of a panel is from its neighbours' on their side of the edge: polynomials of terms - 1, so nodes suffice
    std::vector<Real> overlap_defect(panels.size() * levels);
    const Real lebesgue = 1 + 2 / pi_below * std::log(static_cast<Real>(terms)) * margin;
    const int count = static_cast<int>(panels.size());
    in_parallel(panels.size(), [&](std::size_t e) {
        const Panel& p = panels[e];
        for (const int step : {-1, 1})
            for (int n = static_cast<int>(e) + step; n >= 0 && n < count; n += step) {
                const Real low = max(p.left(), panels[n].z0), high = min(p.right(), panels[n].z1);
                if (!(high > low)) break;
                for (int m = 0; m < levels; ++m) {
                    Real most = 0;
                    for (const Real node : own.at) {
                        const Real z = (low + high) / 2 + (high - low) / 2 * node;
                        most = max(most, abs(value(e, m, (z - p.centre) / p.half) - value(n, m, (z - panels[n].centre) / panels[n].half)));
                    }
                    most += rounding[at(e, m)] + rounding[at(n, m)];
                    overlap_defect[at(e, m)] = max(overlap_defect[at(e, m)], margin * lebesgue * most);
                }
            }
    });
    std::vector<char> by_monotony(panels.size());
    in_parallel(panels.size(), [&](std::size_t i) { prove_panel(i, overlap_defect, by_monotony); });
    // where monotony of B_m was used, T V_{m-1} stood for T B_{m-1}
    Real so_far = 0;
    for (int m = 0; m < levels; ++m) {
        if (m > 0)
            for (std::size_t i = 0; i < panels.size(); ++i)
                if (by_monotony[i]) defect[at(i, m)] += margin * so_far;
        sum_of_effects.push_back(so_far); // of the levels before m, for effect(m)
        sum_of_effects.back() = so_far += effect(m, infinite);
    }
}

Real ProvenLevels::State::effect(int m, Real reach) const
{
    // T D <= d + sum over the panels with D > d of D times the largest share of theta a panel can have, (G width/2)^(1/2)
    std::vector<std::pair<Real, Real>> parts;
    for (std::size_t i = 0; i < panels.size() && panels[i].y0 <= reach; ++i)
        parts.emplace_back(defect[at(i, m)], sqrt(G * (panels[i].y1 - panels[i].y0) / 2));
    std::sort(parts.rbegin(), parts.rend());
    Real best = infinite, above = 0;
    for (const auto& [d, share] : parts) {
        best = min(best, above + d);
        above += d * share;
    }
    best = min(best, above);
    const Real first = panels.front().y0; // below it V = 0, and B_m(x) <= B_m(first) <= B_0(first) <= first^(1/2)
    const Real below = m == 0 ? sqrt(first) : min(sqrt(first), margin * (size[at(0, m)] + defect[at(0, m)] + sum_of_effects[m - 1]));
    return margin * (best + below * sqrt(G * first / 2));
}

// ---- values

ProvenLevels::ProvenLevels(const Ball& G, long double highest, long double tolerance)
{
    if (!(tolerance >= 1e-15L && tolerance <= 1e-5L)) throw std::invalid_argument("tolerance from 1e-15 to 1e-5");
    const WorkingPrecision precision(256);
    const Real nearest = to_real(G);
    const Ball off = abs(to_ball(nearest) / G - Ball(1));
    if (!certainly(less(Ball(1), G)) || !certainly(less(off, to_ball(u)))) throw BeyondReach("G must be above 1 and known to 64 bits");
    const Real top = max(highest, 1.1L / (nearest - 1)); // so that (x + 1)/G stays below
    if (!(top <= 400)) throw BeyondReach("G too near 1, or the load too high, for the proven levels");
    const int terms = tolerance > 1e-11L ? 20 : 26;
    state_ = std::make_unique<State>(nearest, top * 1.01L, tolerance, terms);
}
ProvenLevels::~ProvenLevels() = default;
ProvenLevels::ProvenLevels(ProvenLevels&&) noexcept = default;

std::size_t ProvenLevels::memory() const { return (state_->coefficients.size() + state_->weights.size()) * sizeof(Real) * 5 / 4; }

namespace {
struct Share {
    int level;
    Real effect, weight;
};
} // namespace

static Ball area_and_budget(const ProvenLevels::State& s, long n, const Ball& load, std::vector<Share>* budget)
{
    if (n < 1 || n > levels) throw BeyondReach(fmt::format("proven levels: n from 1 to {}", levels));
    const WorkingPrecision precision(256);
    const Real x = to_real(load), low = x * (1 - 4 * u), high = x * (1 + 4 * u);
    if (!certainly(less(to_ball(low), load)) || !certainly(less(load, to_ball(high)))) throw BeyondReach("load not known to 64 bits");
    std::vector<Real> reach{high};
    for (int k = 0; k <= levels; ++k)
        reach.push_back((reach.back() < 1 ? 2 * sqrt(reach.back()) / s.G : (reach.back() + 1) / s.G) * (1 + 16 * u));
    ProvenLevels::State::Values below, above;
    s.apply(low, 0, levels, below);
    s.apply(high, 0, levels, above);
    std::vector<Real> at_most{1, min(Real(1), sqrt(high) * (1 + 4 * u))}; // T^0 1, T 1 = B_0, ...
    Ball result;
    for (int scale = 1; scale <= n; ++scale) { // A_scale = T B_{scale-1} (load), error sum_m T^{scale-m} D_m
        Real lost = 0;
        if (budget) budget->clear();
        for (int m = 0; m < scale; ++m) {
            const Real effect = s.effect(m, reach[scale - m]), weight = at_most[scale - m - 1];
            lost += margin * effect * weight;
            if (budget) budget->push_back({m, effect, weight});
        }
        const Real least = max(Real(0), below.value[scale - 1] - margin * (below.error[scale - 1] + lost));
        const Real most = above.value[scale - 1] + margin * (above.error[scale - 1] + lost);
        at_most.push_back(min(Real(1), most));
        result = hull(to_ball(least), to_ball(most));
    }
    return result;
}

Ball ProvenLevels::area(long n, const Ball& load) const { return area_and_budget(*state_, n, load, nullptr); }

std::string ProvenLevels::certificate(long n, const Ball& load) const
{
    std::vector<Share> budget;
    const Ball value = area_and_budget(*state_, n, load, &budget);
    std::string text = fmt::format("proven levels: {} panels of {} terms, G to 64 bits; A_{} within {:.2e}\n", state_->panels.size(), state_->terms, n, value.radius_bound());
    for (const auto& b : budget)
        text += fmt::format("  level {:2}: T of its defect <= {:.2e}, share of it that reaches A_{}: {:.2e}\n", b.level, static_cast<double>(b.effect), n, static_cast<double>(b.weight));
    return text;
}

// ---- kept meshes

namespace {

struct Mesh {
    std::string G;
    Real highest, tolerance;
    std::mutex making;
    std::shared_ptr<const ProvenLevels> made;
};
std::mutex meshes_mutex;
std::list<std::shared_ptr<Mesh>> meshes; // most recently used first

std::shared_ptr<const ProvenLevels> proven_levels(const Arguments& a)
{
    const slong bits = WorkingPrecision::bits();
    if (bits > 98) throw BeyondReach("with full contact areas are certified to about ten digits");
    const Real tolerance = bits <= 91 ? 1e-12L : 1e-14L;
    const WorkingPrecision precision(192);
    const Ball G = a.G();
    const Real load = to_real(a.load());
    const Real highest = load <= 10 ? 10 : 100; // one mesh for the loads of figure 3
    if (!(load <= 100)) throw BeyondReach("load above 100");
    std::shared_ptr<Mesh> mine;
    {
        const std::lock_guard lock(meshes_mutex);
        const auto found = std::find_if(meshes.begin(), meshes.end(), [&](const auto& m) {
            return m->tolerance <= tolerance && m->highest >= highest && m->G == G.dump();
        });
        if (found != meshes.end()) meshes.splice(meshes.begin(), meshes, found);
        else {
            meshes.push_front(std::make_shared<Mesh>());
            meshes.front()->G = G.dump();
            meshes.front()->highest = highest;
            meshes.front()->tolerance = tolerance;
        }
        mine = meshes.front();
        if (meshes.size() > 6) meshes.pop_back(); // about 50 MB each
    }
    const std::lock_guard lock(mine->making);
    if (!mine->made) mine->made = std::make_shared<const ProvenLevels>(G, mine->highest, mine->tolerance);
    return mine->made;
}

} // namespace

Ball area_by_proven_levels(long n, const Arguments& a)
{
    if (n > levels) throw BeyondReach(fmt::format("with full contact areas are certified for n <= {} only", levels));
    return proven_levels(a)->area(n, a.load());
}

std::string proven_levels_certificate(long n, const Arguments& a)
{
    return proven_levels(a)->certificate(n, a.load());
}

} // namespace touchstone::transfer
