// SPDX-License-Identifier: MIT
#include "touchstone/transfer/forward.hpp"

#include "touchstone/scalar/refusal.hpp"
#include "touchstone/transfer/binary64.hpp"
#include "touchstone/transfer/chain.hpp"
#include "touchstone/transfer/fixed.hpp"
#include "touchstone/transfer/progress.hpp"

#include <fmt/format.h>

#if __has_include(<flint/arb_poly.h>)
#include <flint/acb_calc.h>
#include <flint/arb_poly.h>
#else
#include <acb_calc.h>
#include <arb_poly.h>
#endif

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <list>
#include <map>
#include <mutex>
#include <numbers>

namespace touchstone::transfer {
namespace {

using C = ComplexBall;
using Traits = ScalarTraits<Ball>;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr slong bound_bits = 40;
/// Covers the rounding of a few `double` operations on bounds and polar coordinates.
constexpr double slack = 1e-9;
/// A point may lie outside its panel by a relative 1e-15 of it: polynomials and errors there grow by (1 + 5e-8)^points at most.
constexpr double at_panel_end = 1e-5;
/// No bound is kept below this: a product of two that underflows would otherwise claim that nothing is lost.
constexpr double smallest_bound = 1e-300;
/// Above, the tolerances, 1e-6 e^-accuracy and less, would come down to smallest_bound.
constexpr double most_accuracy = 660;

double product_of_bounds(std::initializer_list<double> factors)
{
    double r = 1;
    for (const double f : factors) {
        r *= std::max(f, smallest_bound);
        r = r <= infinity ? std::max(r, smallest_bound) : infinity; // inf 0 is not a number
    }
    return r;
}

double above(const Ball& x)
{
    if (!x.is_finite()) return infinity;
    return arf_get_d(arb_midref(upper(x).get()), ARF_RND_UP);
}
double about(const Ball& x) { return arf_get_d(arb_midref(x.get()), ARF_RND_NEAR); }

double at_most_modulus(const C& z)
{
    if (!z.is_finite()) return infinity;
    mag_t m;
    mag_init(m);
    acb_get_mag(m, z.get());
    const double r = mag_get_d(m); // 0 below 2^-1000
    mag_clear(m);
    return std::max(r, smallest_bound);
}
double at_least_modulus(const C& z)
{
    if (!z.is_finite()) return 0;
    mag_t m;
    mag_init(m);
    acb_get_mag_lower(m, z.get());
    const double r = mag_get_d(m); // infinite above 2^1000
    mag_clear(m);
    return std::min(r, 1 / smallest_bound);
}

/// Whether z may touch (-inf, 0].
bool meets_cut(const C& z)
{
    return !z.is_finite() || (arb_contains_zero(acb_imagref(z.get())) && !arb_is_positive(acb_realref(z.get())));
}

/// Whether E(D) may touch (-inf, 0], mean an enclosure of it. It does not where Re D > 0: there |arg D| < pi/2, and |e^-D| < 1 makes
/// |arg(1 - e^-D)| < pi/2, so |arg E(D)| < pi. Its zeros, D = 2 pi i k, are on the imaginary axis.
bool mean_meets_cut(const C& D, const C& mean) { return !arb_is_positive(acb_realref(D.get())) && meets_cut(mean); }

C disc(double re, double im, double radius)
{
    Ball x = Ball::exactly(re), y = Ball::exactly(im);
    mag_set_d(arb_radref(x.get()), radius);
    mag_set_d(arb_radref(y.get()), radius);
    return C(x, y);
}

/// E(z) = (1 - e^-z)/z; |E - 1| <= sum |z|^k/(k+1)! = (e^|z| - 1 - |z|)/|z|.
C exponential_mean(const C& z)
{
    const double m = at_most_modulus(z);
    if (m > 0.8) {
        C r;
        const C minus = -z;
        acb_expm1(r.get(), minus.get(), WorkingPrecision::bits());
        return -r / z;
    }
    return disc(1, 0, m < 1e-3 ? m : (std::expm1(m) / m - 1) * (1 + slack));
}

// ---- the plane of d, cut into boxes by direction (arg d, symmetric) and shell (|d|)

constexpr std::array directions{0.0, 0.02, 0.05, 0.1, 0.16, 0.23, 0.31, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0,
                                1.1, 1.2,  1.3,  1.4, 1.5,  1.57, 1.75, 2.0, 2.3, 2.7, 3.1416};
constexpr int n_directions = static_cast<int>(directions.size()) - 1;

/// Shell 0 is |d| <= inner, shell j up to radius(j) = inner 2^(j/density).
class Shells {
public:
    static constexpr int density = 6;
    Shells(double inner, double outer) : inner_(inner), count_(static_cast<int>(std::ceil(density * std::log2(outer / inner)))) {}
    int count() const { return count_; } ///< shells 0 ... count
    double radius(int j) const { return inner_ * std::exp2(static_cast<double>(j) / density); }
    /// The shell of |d| = r; callers widen r by more than this rounds.
    int shell(double r) const { return r <= inner_ ? 0 : std::max(0, static_cast<int>(std::ceil(density * std::log2(r / inner_)))); }

private:
    double inner_;
    int count_;
};

/// Bounds of |u| on the boxes; infinite where nothing is proven.
struct Boxes {
    std::vector<double> bound; ///< [shell][direction]
    std::vector<double> far;   ///< |u| <= far |d|^(1/2) outside the last shell, by direction
    int disc = 0;              ///< shells up to this one form one full disc
    double& at(int j, int m) { return bound[static_cast<std::size_t>(j) * n_directions + static_cast<std::size_t>(m)]; }
    double at(int j, int m) const { return bound[static_cast<std::size_t>(j) * n_directions + static_cast<std::size_t>(m)]; }
};

struct PolarRange {
    double inner, outer, from, to; ///< |d|, |arg d|
};

/// What a disc about (re, im) of this radius covers.
PolarRange polar(double re, double im, double radius)
{
    const double r = std::hypot(re, im);
    radius = radius * (1 + slack) + r * slack;
    if (radius >= r) return {0, r + radius, 0, 3.1415};
    const double a = std::fabs(std::atan2(im, re)), half = std::asin(radius / r) + slack;
    return {r - radius, r + radius, std::max(0.0, a - half), std::min(3.1415, a + half)};
}
PolarRange polar(const C& z)
{
    if (!z.is_finite()) return {0, infinity, 0, 3.1415};
    const double x = mag_get_d(arb_radref(acb_realref(z.get()))), y = mag_get_d(arb_radref(acb_imagref(z.get())));
    return polar(about(z.real()), about(z.imag()), std::hypot(x, y));
}

// ---- level data

/// Polynomial on a panel [a, b] of d, in xi = (coordinate - mid)/half.
struct Panel {
    double a = 0, b = 0;
    bool logarithmic = false;
    Ball mid, half;
    double mid_d = 0, half_d = 0; ///< about
    long points = 0;
    double rho = 0, bound = 0;     ///< |u| <= bound on the ellipse rho
    double interpolation = 0;      ///< error of the interpolant of exact values
    double slope = 0;              ///< and of its derivative, with respect to xi
    std::vector<double> errors;    ///< of the nodal values
    double worst = 0;              ///< largest of errors
    arb_poly_t polynomial;
    std::vector<mp_limb_t> fixed; ///< its coefficients over 2^scale, highest first
    long scale = 0;
    mag_t fixed_error;            ///< of a value by Horner's rule from these
    Panel() { arb_poly_init(polynomial); mag_init(fixed_error); }
    ~Panel() { arb_poly_clear(polynomial); mag_clear(fixed_error); }
    Panel(const Panel&) = delete;
    Panel& operator=(const Panel&) = delete;
};

struct Level {
    long k = 0;
    Ball edge;   ///< e_k
    Ball edge_bound; ///< the same at bound_bits
    Ball C;
    Boxes boxes;
    std::vector<std::unique_ptr<Panel>> panels; ///< none at k = 1
    std::vector<double> log_d, log_v;           ///< about, for tolerances
    double tail = 0;                            ///< T_k
    // for the certificate
    std::size_t nodes = 0, row_nodes = 0;
    double worst_interpolation = 0, worst_row = 0, worst_carried = 0, worst_total = 0;
};

enum class Kind { step, share, slope };

struct RuleNode {
    Ball s, c, weight;
};
struct RowRule {
    std::vector<RuleNode> nodes;
    double error = 0;
    double reach = infinity; ///< delta from here on is left out
};

/// What differs between the routes beside the law.
struct Settings {
    std::vector<double> ratios;
    long least_points, most_points, step_points; ///< most at accuracy 80, more in proportion
    bool logarithmic;
    std::vector<double> piece_rhos;
    long most_gauss;
};
const Settings& settings(Law law)
{
    static const Settings density{{16, 8, 5.66, 4, 2.83, 2.4, 2, 1.75, 1.5, 1.3, 1.15, 1.07, 1.03}, 8, 76, 4, false, {14, 9, 6.5, 4.8, 3.6, 2.8, 2.2}, 64};
    static const Settings exceedance{{15, 7, 5, 3.5, 3, 2.5, 2.1, 1.8, 1.5, 1.3, 1.15, 1.07, 1.03}, 9, 81, 4, true, {12, 8, 5.6, 4.2, 3.2, 2.5, 2}, 72};
    return law == Law::density ? density : exceedance;
}

/// T_{k+1} from T_k; see the header. Force density f_k <= T_k e^(-5 delta/2) for delta >= 4; so also T_k e^(2-3 delta), with (delta+1.2)/5.2 more at k = 2.
///
/// f_{k+1}(d) = int_0^2d f_k(delta) e^(-3D/2) K dD-part, K <= k2 (1 - e^-D)^(-1/2), k2 = (4/pi)(1-e_k)^(-3/2) since R, M/2 >= 1 - x and
/// (1+x+R)/(1-x+R) falls with R. Let d >= 4. The part delta < 4 (total force 1) gives at most 1.01 k2 e^(-3d+6); the part delta >= 4
/// T_k k2 e^(-3d) int e^-delta (1-e^-D)^(-1/2) ddelta <= 4.1 T_k k2 e^(-3d-4): D >= 1 weighs at most 1.26 e^-4, D < 1 at most 2.83 e^-4.
/// First, f_1 <= (8/pi) a e^(-3 delta/2) (1 - e^(-2 delta))^(-1/2), a = min((2 load^(1/2))^(-3/2), (1-load)^(-3/2)), from R >= 2 load^(1/2) e^-delta,
/// R >= 1 - load and (1+x+R)/(1-x+R) <= (R+2)/R <= 4/R; so f_2(d) <= (8a/pi) k2 e^(-3d) 2.02 (d + 1.2).
double next_tail(long k, const Ball& edge_bound, double tail, double load)
{
    const double k2 = 4 / std::numbers::pi * std::pow(1 - above(edge_bound), -1.5) * (1 + slack);
    if (k == 1) {
        const double a = std::min(std::pow(2 * std::sqrt(load), -1.5), std::pow(std::max(0.0, 1 - load), -1.5)) * (1 + slack);
        return 8 * a / std::numbers::pi * k2 * 1.43;
    }
    return std::exp(-2.0) * k2 * (1.01 * std::exp(6.0) + 4.1 * std::exp(-4.0) * tail) * (1 + slack);
}

/// Where E_n is cut off for small p, so that what is left out, relative to q_n, and what the cut makes of the levels' errors, e^(cut/2),
/// both come to about e^-a where levels have the accuracy a + cut/2.
double cut_for_small(double accuracy, long n, const Ball& G, const Ball& load)
{
    const WorkingPrecision low(bound_bits);
    Ball edge = 2 / G * sqrt(load);
    double tail = infinity;
    for (long k = 1; k < n; ++k) {
        tail = next_tail(k, edge, tail, about(load));
        edge = 2 / G * sqrt(edge);
    }
    return (accuracy + std::log(3.5 * std::exp(2.0) * tail) + (n == 2 ? std::log(accuracy) - 1 : 0)) / 2;
}

/// The accuracy of levels for q_n to e^-accuracy by the form for small p, or 0 where p is not small.
double accuracy_for_small(double accuracy, long n, double d, const Ball& G, const Ball& load)
{
    const double cut = 4.0 / 3 * cut_for_small(accuracy, n, G, load), levels = 4 * std::ceil((accuracy + cut / 2) / 4);
    return 2 * d > cut_for_small(levels, n, G, load) + 1.02 ? levels : 0;
}

} // namespace

struct Forward::Implementation {
    Law law;
    double accuracy, epsilon;
    long most_points, most_gauss; ///< on a panel, on a piece
    slong precision;      ///< of the rows
    slong wide;           ///< of polynomials: powers of xi cancel up to (1 + 2^(1/2))^points
    FixedFormat format;
    std::vector<mp_limb_t> xi_fixed, sum_fixed, product_fixed, scratch;
    Ball G, load;
    bool full; ///< load = 1 exactly
    double G_d, load_d, beta;
    double delta_max;
    Shells shells;
    std::vector<std::unique_ptr<Level>> levels; ///< index k, from 1
    std::map<long, std::unique_ptr<Level>> whole;  ///< E_k up to the cut, for small p
    std::map<long, std::vector<std::pair<Ball, Ball>>> gauss;
    std::map<long, std::vector<Ball>> to_monomials;      ///< [power][node]
    std::map<long, std::vector<double>> chebyshev_at;    ///< T_m(x_j), [m][j]
    std::mutex mutex;

    static slong precision_for(double accuracy) { return static_cast<slong>(accuracy / std::numbers::ln2) + 66; }
    /// Where the far end begins: what it holds is negligible even for a light load at the last scale.
    static double far_end(Law law, double accuracy, double G, double load)
    {
        const double smallness = accuracy + 12 + static_cast<double>(largest_n + 1) * std::log(G) - std::log(load);
        return law == Law::density ? accuracy + 40 + 30 * std::max(0.0, -std::log10(1 - 4 / (G * G))) - 0.75 * std::log(load) : 2 * smallness;
    }

    Implementation(Law l, const Ball& G_, const Ball& load_, double a)
        : law(l), accuracy(a), epsilon(std::exp(-a) / 64), most_points(4 * static_cast<long>(static_cast<double>(settings(l).most_points) * std::max(a / 80, 1.0) / 4) + settings(l).most_points % 4),
          most_gauss(static_cast<long>(static_cast<double>(settings(l).most_gauss) * std::max(a / 80, 1.0))), precision(WorkingPrecision::bits()),
          wide(precision + most_points * 4 / 3 + 14), format(precision + most_points * 4 / 3),
          xi_fixed(static_cast<std::size_t>(format.limbs())), sum_fixed(xi_fixed), product_fixed(xi_fixed), scratch(2 * xi_fixed.size()), G(G_), load(load_), full(arb_is_one(load.get())), G_d(about(G)),
          load_d(about(load)), beta(l == Law::density ? 1.5 : 0.5), delta_max(far_end(l, a, G_d, load_d)),
          shells(std::exp2(-static_cast<double>(largest_n) - 5), 16 * delta_max)
    {
        levels.resize(2);
        levels[1] = first_level();
    }

    // ---- kernels, bounds

    long power(long k) const { return law == Law::density ? k - 1 : k + 1; }

    /// int_0^(pi/2) sin^m
    static Ball wallis(long m)
    {
        return sqrt(Traits::pi()) / 2 * Traits::gamma(Traits::quotient(m + 1, 2)) / Traits::gamma(Traits::quotient(m + 2, 2));
    }

    /// Bound of the step's kernel, or infinity. \param direct a bound of |1/E| known otherwise, E proven off its cut
    double kernel_bound(const Ball& e, const C& d, const C& s, const C& c, double direct = infinity, Kind kind = Kind::step) const
    {
        const C x = e * exp(-2 * d * s), D = 2 * d * c, one_minus = 1 - x;
        return modulus(x, one_minus, 4 * e * exp(-2 * d), D, direct, kind);
    }
    double modulus(const C& x, const C& one_minus, const C& w4, const C& D, double direct, Kind kind) const
    {
        const C R2 = one_minus * one_minus + w4;
        if (meets_cut(R2)) return infinity;
        const C R = sqrt(R2), P = 1 + x + R, M = one_minus + R;
        if (meets_cut(P) || meets_cut(M)) return infinity;
        const C E = exponential_mean(D);
        if (kind == Kind::share) { // z^2 = 2 x (1 - e^-D)/P = 2 x D E/P, and D's root is cos theta: E must have one too, however small z is
            if (mean_meets_cut(D, E)) return infinity;
            const double z2 = 2 * at_most_modulus(x) * at_most_modulus(1 - exp(-D)) / at_least_modulus(P) * (1 + slack);
            return z2 < 1 ? std::numbers::pi / 2 * std::sqrt(z2) * (1 + slack) : infinity; // |arcsin z| <= (pi/2)|z| for |z| < 1
        }
        double inverse = meets_cut(E) ? infinity : 1 / at_least_modulus(E) * (1 + slack);
        inverse = std::min(inverse, direct);
        const double square = law == Law::density ? at_most_modulus(P) / at_least_modulus(M) * inverse
                                                  : at_most_modulus(P) * at_most_modulus(M) * inverse;
        return std::sqrt(square) / at_least_modulus(R) * (1 + slack);
    }

    /// Bound of |u_1| on a disc of d.
    double first_bound(const C& d) const
    {
        const Ball x = load;
        if (full && law == Law::density) { // R = 2 e^-d: v_1 = e^(3d/2) (1 + e^-d)^(1/2)/2 / E(2d)^(1/2)
            const C P = 1 + exp(-d), E = exponential_mean(2 * d);
            if (meets_cut(P) || meets_cut(E)) return infinity;
            return std::sqrt(at_most_modulus(P) / at_least_modulus(E)) / 2 * (1 + slack);
        }
        const double decay = at_most_modulus(exp(-d * C(Ball::exactly(beta))));
        if (full && certainly(less(Ball::exactly(0.5), d.real()))) // arccos(e^(-d/2)), |e^(-d/2)| < 1: at most pi
            return decay * std::numbers::pi / std::sqrt(2 * at_least_modulus(d)) * (1 + slack);
        const C w4 = 4 * x * exp(-2 * d), one_minus = C(1 - x);
        if (law == Law::density) return decay * modulus(C(x), one_minus, w4, 2 * d, infinity, Kind::step);
        C R2 = one_minus * one_minus + w4;
        C R;
        if (full) R = 2 * exp(-d);
        else {
            if (meets_cut(R2)) return infinity;
            R = sqrt(R2);
        }
        const C P = 1 + C(x) + R;
        if (meets_cut(P)) return infinity;
        const C E = exponential_mean(2 * d); // z^2 = 4 d x E/P: as in `modulus`, E must have a root
        if (mean_meets_cut(2 * d, E)) return infinity;
        const double z2 = 2 * above(x) * at_most_modulus(1 - exp(-2 * d)) / at_least_modulus(P) * (1 + slack);
        if (!(z2 < 1)) return infinity;
        return decay * std::numbers::pi / 2 * std::sqrt(2 * above(x) * at_most_modulus(E) / at_least_modulus(P)) * (1 + slack);
    }

    /// Largest bound of boxes that meet the range; infinite if one of them is not proven.
    double lookup(const Boxes& boxes, const PolarRange& p) const
    {
        const int from = shells.shell(p.inner * (1 - slack)), to = shells.shell(p.outer * (1 + slack));
        if (to > shells.count()) return infinity;
        double most = 0;
        for (int m = 0; m < n_directions; ++m) {
            if (directions[static_cast<std::size_t>(m) + 1] < p.from || directions[static_cast<std::size_t>(m)] > p.to) continue;
            for (int j = from; j <= to; ++j) most = std::max(most, boxes.at(j, m));
        }
        return most;
    }

    template <class F> ///< f(disc of d, depth left)
    double over_box(double inner, double outer, double from, double to, int depth, const F& f) const
    {
        const double r = (inner + outer) / 2, a = (from + to) / 2;
        const double radius = (outer - inner) / 2 + outer * (to - from) / 2;
        const double b = f(disc(r * std::cos(a), r * std::sin(a), radius * (1 + slack)));
        if (std::isfinite(b) || depth == 0) return b;
        double most = 0;
        for (int i = 0; i < 4 && std::isfinite(most); ++i) {
            const double r0 = i & 1 ? r : inner, r1 = i & 1 ? outer : r, a0 = i & 2 ? a : from, a1 = i & 2 ? to : a;
            most = std::max(most, over_box(r0, r1, a0, a1, depth - 1, f));
        }
        return most;
    }

    void fill(Boxes& boxes, double disc_radius, const std::function<double(const C&, int shell, int direction, double outer)>& f) const
    {
        boxes.bound.assign(static_cast<std::size_t>(shells.count() + 1) * n_directions, infinity);
        boxes.disc = shells.shell(disc_radius * (1 - 1e-6));
        const double whole = f(disc(0, 0, shells.radius(boxes.disc)), boxes.disc, -1, shells.radius(boxes.disc));
        for (int m = 0; m < n_directions; ++m) {
            for (int j = 0; j <= boxes.disc; ++j) boxes.at(j, m) = whole;
            for (int j = boxes.disc + 1; j <= shells.count(); ++j) {
                const double outer = shells.radius(j);
                if (directions[static_cast<std::size_t>(m) + 1] > 1.571 && outer > 2) break;
                const double b = over_box(shells.radius(j - 1), outer, directions[static_cast<std::size_t>(m)], directions[static_cast<std::size_t>(m) + 1], 2,
                                          [&](const C& d) { return f(d, j, m, outer); });
                if (!(b < 1e200)) break; // the set stays star-shaped
                boxes.at(j, m) = std::max(b, smallest_bound);
            }
        }
    }

    std::unique_ptr<Level> first_level() const
    {
        auto level = std::make_unique<Level>();
        level->k = 1;
        level->edge = 2 / G * sqrt(load);
        // (4/pi)/2^(1/2), and (2/pi) 2^(1/2): the same
        level->C = 2 * sqrt(Ball(2)) / Traits::pi();
        level->tail = infinity;
        const WorkingPrecision low(bound_bits);
        level->edge_bound = level->edge + Ball(0);
        fill(level->boxes, 0.25, [this](const C& d, int, int, double) { return first_bound(d); });
        // outside: |1/E| <= |D| + 1/cos, R -> 1 - load
        level->boxes.far.assign(n_directions, infinity);
        const double r = shells.radius(shells.count());
        for (int m = 0; m < n_directions; ++m) {
            const double cosine = std::cos(directions[static_cast<std::size_t>(m) + 1]);
            if (cosine <= 0.001 || beta * r * cosine < 4) continue;
            double b = infinity;
            const double decay = std::max(std::exp(-beta * r * cosine), smallest_bound);
            if (full) b = law == Law::density ? std::sqrt(2 * (2 * r + 1 / cosine)) / 2 : 4 * decay;
            else {
                const double eta = 4 * std::exp(-2 * r * cosine) * load_d / ((1 - load_d) * (1 - load_d)) * (1 + slack);
                if (eta < 1e-3 * (1 - load_d)) b = decay * far_kernel(load_d, eta) * std::sqrt(2 * r + 1 / cosine) * 2;
            }
            level->boxes.far[static_cast<std::size_t>(m)] = std::max(b / std::sqrt(r) * (1 + slack), smallest_bound);
        }
        estimate_first(*level);
        return level;
    }

    /// |kernel| E^(1/2) where |x| <= e and |4w| <= eta (1-e)^2: R = (1-x)(1 + eta')^(1/2).
    double far_kernel(double e, double eta) const
    {
        const double P = 2 + 2 * eta, R = (1 - e) * (1 - eta);
        return (law == Law::density ? std::sqrt(P / ((1 - e) * (2 - eta))) : std::sqrt(P * (1 + e) * (2 + eta))) / R * (1 + 1e-6);
    }

    static constexpr int sectors = 32;
    /// Shares of int sin^m over theta in the sectors of [0, pi/2], rounded up (upper sums).
    static std::array<double, sectors> sector_shares(long m)
    {
        std::array<double, sectors> share{};
        constexpr int fine = 48;
        const double h = std::numbers::pi / 2 / (sectors * fine);
        for (int i = 0; i < sectors * fine; ++i) share[static_cast<std::size_t>(i / fine)] += std::pow(std::sin((i + 1) * h), static_cast<double>(m)) * h;
        const WorkingPrecision low(bound_bits);
        const double whole = about(wallis(m));
        for (double& s : share) s *= (1 + slack) / whole;
        return share;
    }

    void bound_boxes(const Level& from, Level& to) const
    {
        const WorkingPrecision low(bound_bits);
        const auto share = sector_shares(power(from.k));
        const Ball e = from.edge_bound;
        const double e_d = above(e);
        std::vector<double> most(n_directions, 0);
        for (int m = 0; m < n_directions; ++m)
            for (int j = 0; j <= shells.count(); ++j) most[static_cast<std::size_t>(m)] = std::max(most[static_cast<std::size_t>(m)], from.boxes.at(j, m));
        const double end = shells.radius(shells.count());

        const std::function<double(const C&, double, double, double, int)> kernel_over =
            [&](const C& d, double a, double b, double direct, int depth) -> double { // theta in [a, b]
            const double s0 = std::pow(std::sin(a), 2) * (1 - slack), s1 = std::min(1.0, std::pow(std::sin(b), 2) * (1 + slack));
            const double c0 = std::pow(std::cos(b), 2) * (1 - slack), c1 = std::min(1.0, std::pow(std::cos(a), 2) * (1 + slack));
            const Ball s = hull(Ball::exactly(s0), Ball::exactly(s1)), c = hull(Ball::exactly(c0), Ball::exactly(c1));
            const double bound = kernel_bound(e, d, C(s), C(c), direct);
            if (std::isfinite(bound) || depth == 0) return bound;
            const double mid = (a + b) / 2;
            const double left = kernel_over(d, a, mid, direct, depth - 1);
            return std::isfinite(left) ? std::max(left, kernel_over(d, mid, b, direct, depth - 1)) : left;
        };

        fill(to.boxes, shells.radius(from.boxes.disc) / 2, [&](const C& d, int j, int m, double outer) {
            const double decay = at_most_modulus(exp(-d * C(Ball::exactly(beta))));
            const double cosine = m < 0 ? -1 : std::cos(directions[static_cast<std::size_t>(m) + 1]);
            double sum = 0;
            for (int i = 0; i < sectors; ++i) {
                const double a = std::numbers::pi / 2 * i / sectors, b = std::numbers::pi / 2 * (i + 1) / sectors;
                const double s0 = std::pow(std::sin(a), 2), s1 = std::min(1.0, std::pow(std::sin(b), 2) * (1 + slack)), c1 = std::pow(std::cos(a), 2) * (1 + slack);
                double u = 0;
                if (m < 0) u = from.boxes.at(from.boxes.disc, 0);
                else {
                    const double near = 2 * (j == 0 ? 0 : shells.radius(j - 1)) * s0, far = 2 * outer * s1;
                    const int j0 = shells.shell(near * (1 - slack)), j1 = std::min(shells.shell(far * (1 + slack)), j + Shells::density); // |2 d s| <= 2 |d|
                    for (int q = j0; q <= std::min(j1, shells.count()); ++q) u = std::max(u, from.boxes.at(q, m));
                    if (far > end) u = std::max(u, from.boxes.far[static_cast<std::size_t>(m)] * std::sqrt(far));
                }
                if (!std::isfinite(u)) return infinity;
                const double direct = cosine > 0.001 ? 2 * outer * c1 + 1 / cosine : infinity;
                const double k = kernel_over(d, a, b, direct * (1 + slack), 5);
                if (!std::isfinite(k)) return infinity;
                sum += product_of_bounds({share[static_cast<std::size_t>(i)], k, u});
            }
            return decay * sum * (1 + slack);
        });
        to.boxes.far.assign(n_directions, infinity);
        for (int m = 0; m < n_directions; ++m) {
            const double cosine = std::cos(directions[static_cast<std::size_t>(m) + 1]);
            if (cosine <= 0.001 || beta * end * cosine < 4) continue;
            const double eta = 4 * std::exp(-2 * end * cosine) * e_d / ((1 - e_d) * (1 - e_d)) * (1 + slack);
            if (!(eta < 1e-3) || e_d > 0.99999) continue; // R^2 = (1-x)^2 (1 + eta') off its cut: 2 arcsin e + eta < pi
            const double u = std::max(most[static_cast<std::size_t>(m)], from.boxes.far[static_cast<std::size_t>(m)] * std::sqrt(2 * end));
            to.boxes.far[static_cast<std::size_t>(m)] =
                product_of_bounds({std::exp(-beta * end * cosine), far_kernel(e_d, eta) * std::sqrt(2 * end + 1 / cosine) / std::sqrt(end) * (1 + 1e-6), u});
        }
    }

    // ---- estimates, for tolerances only

    double kernel_d(double e, double d, double s) const
    {
        const double x = e * std::exp(-2 * d * s), D = 2 * d * (1 - s), R = std::sqrt((1 - x) * (1 - x) + 4 * e * std::exp(-2 * d));
        const double E = D > 1e-9 ? -std::expm1(-D) / D : 1, P = 1 + x + R, M = 1 - x + R;
        return std::sqrt(law == Law::density ? P / (M * E) : P * M / E) / R;
    }
    void estimate_first(Level& level) const
    {
        for (int i = -60; i <= 60; ++i) {
            const double d = std::exp2(0.5 * i);
            if (d > 2 * delta_max) break;
            const double x = load_d, R = full ? 2 * std::exp(-d) : std::sqrt((1 - x) * (1 - x) + 4 * x * std::exp(-2 * d));
            const double E = -std::expm1(-2 * d) / (2 * d), P = 1 + x + R;
            const double v = law == Law::density ? std::sqrt(P / ((1 - x + R) * E)) / R : std::asin(std::min(1.0, std::sqrt(2 * x * 2 * d * E / P))) / std::sqrt(2 * d);
            if (!std::isfinite(v)) break;
            level.log_d.push_back(std::log(d));
            level.log_v.push_back(std::log(v));
        }
    }
    double estimate(const Level& level, double d) const
    {
        const double t = std::log(std::max(d, 1e-300));
        const auto it = std::lower_bound(level.log_d.begin(), level.log_d.end(), t);
        if (it == level.log_d.begin()) return std::exp(level.log_v.front());
        if (it == level.log_d.end()) return std::exp(level.log_v.back());
        const auto i = static_cast<std::size_t>(it - level.log_d.begin());
        const double f = (t - level.log_d[i - 1]) / (level.log_d[i] - level.log_d[i - 1]);
        return std::exp(level.log_v[i - 1] + f * (level.log_v[i] - level.log_v[i - 1]));
    }
    double estimate_step(const Level& from, double d) const
    {
        const double e = about(from.edge);
        const long m = power(from.k);
        double sum = 0, weight = 0;
        for (int i = 0; i < 60; ++i) {
            const double theta = std::numbers::pi / 2 * (i + 0.5) / 60, s = std::pow(std::sin(theta), 2), w = std::pow(std::sin(theta), static_cast<double>(m));
            weight += w;
            sum += w * kernel_d(e, d, s) * std::exp(-beta * 2 * d * s) * estimate(from, 2 * d * s);
        }
        return sum / weight;
    }

    // ---- rules

    const std::vector<std::pair<Ball, Ball>>& legendre(long n)
    {
        auto& rule = gauss[n];
        if (rule.empty()) {
            rule.resize(static_cast<std::size_t>(n));
            for (long i = 0; i < n; ++i)
                arb_hypgeom_legendre_p_ui_root(rule[static_cast<std::size_t>(i)].first.get(), rule[static_cast<std::size_t>(i)].second.get(), static_cast<ulong>(n),
                                               static_cast<ulong>(i), precision);
        }
        return rule;
    }

    /// Largest |integrand| over a disc of t: 2/(1+t^2) sin^m kernel u.
    double integrand_bound(const Level& from, Kind kind, const C& d, const C& t) const
    {
        const C q = 1 + t * t;
        const double q_least = at_least_modulus(q);
        if (q_least == 0) return infinity;
        const C sine = 2 * t / q, cosine = (1 - t * t) / q, s = sine * sine, c = cosine * cosine;
        const C delta = 2 * d * s;
        double u = lookup(from.boxes, polar(delta));
        if (!std::isfinite(u)) return infinity;
        if (kind == Kind::share) u *= at_most_modulus(cosine) * at_most_modulus(exp(-delta * C(Ball::exactly(0.5))));
        const double k = kernel_bound(from.edge_bound, d, s, c, infinity, kind);
        return product_of_bounds({2 / q_least, std::pow(at_most_modulus(sine), static_cast<double>(power(from.k))), k, u}) * (1 + slack);
    }

    /// Rule for all real d in [low, high], or for the disc of radius `around` about it.
    RowRule make_rule(const Level& from, Kind kind, double low, double high, double around, double tolerance)
    {
        RowRule rule;
        double t_end = 1;
        if (from.k >= 2 && 2 * high > delta_max) {
            const double s = delta_max / (2 * high) * (1 - 1e-6);
            int exponent = 0; // to 20 bits: then 30 bisections leave ends, middles and half-lengths exact, and no gap
            t_end = std::frexp(std::tan(std::asin(std::sqrt(s)) / 2), &exponent);
            t_end = std::ldexp(std::floor(std::ldexp(t_end, 20)), exponent - 20);
            const double sine = 2 * t_end / (1 + t_end * t_end);
            rule.reach = 2 * low * sine * sine * (1 - slack);
        }
        const Settings& set = settings(law);
        const long m = power(from.k);
        Ball norm;
        {
            const WorkingPrecision full_precision(precision);
            norm = wallis(m);
        }
        const double norm_d = about(norm);
        if (!(tolerance > 8 * smallest_bound)) throw BeyondReach("so many digits of a distribution would cost too much");
        const auto d_disc = [&] {
            Ball x = hull(Ball::exactly(low * (1 - slack) - around), Ball::exactly(high * (1 + slack) + around)), y(0);
            mag_set_d(arb_radref(y.get()), around);
            return C(x, y);
        };
        std::function<void(double, double, int)> pieces = [&](double a, double b, int depth) {
            const WorkingPrecision low_precision(bound_bits);
            const C d = d_disc();
            const double l = (b - a) / 2, mid = (a + b) / 2, goal = tolerance / 8;
            if (std::pow(2 * b, static_cast<double>(m)) < 1e-6) { // perhaps negligible
                const double most = integrand_bound(from, kind, d, disc(mid, 0, l * (1 + slack)));
                const double whole = product_of_bounds({2 * l / norm_d, most}) * (1 + slack);
                if (whole < goal) {
                    rule.error += whole;
                    return;
                }
            }
            long best = std::numeric_limits<long>::max();
            double best_error = infinity;
            int finite = 0;
            for (const double r : set.piece_rhos) {
                const double A = (r + 1 / r) / 2, B = (r - 1 / r) / 2;
                if (B * l >= 1) continue;
                constexpr int arcs = 14;
                double most = 0;
                for (int i = 0; i < arcs && std::isfinite(most); ++i) {
                    const double phi = std::numbers::pi * (i + 0.5) / arcs;
                    const C t = disc(mid + l * A * std::cos(phi), l * B * std::sin(phi), l * A * std::numbers::pi / (2 * arcs) * (1 + slack));
                    most = std::max(most, integrand_bound(from, kind, d, t));
                }
                if (!std::isfinite(most)) continue;
                const double front = product_of_bounds({16.0 / 3 * l / (norm_d * (1 - 1 / r)), most}) * (1 + slack);
                const long n = std::max(4L, static_cast<long>(std::ceil((std::log(front) - std::log(goal)) / (2 * std::log(r)))));
                if (n < best) {
                    best = n;
                    best_error = product_of_bounds({front, std::pow(r, -2.0 * static_cast<double>(n))}) * (1 + slack);
                }
                if (++finite == 3) break;
            }
            if (best > most_gauss) {
                if (depth == 0) throw BeyondReach("the distribution's integrand could not be bounded; the load is too near 1 or G too near 2");
                pieces(mid, b, depth - 1);
                pieces(a, mid, depth - 1);
                return;
            }
            rule.error += best_error;
            const WorkingPrecision full_precision(precision);
            const Ball centre = Ball::exactly(mid), half = Ball::exactly(l);
            for (const auto& [node, weight] : legendre(best)) {
                const Ball t = centre + half * node, q = 1 / (1 + t * t), sine = 2 * t * q, cosine = (1 - t * t) * q;
                Ball w;
                arb_pow_ui(w.get(), sine.get(), static_cast<ulong>(m), precision);
                w = w * half * weight * 2 * q / norm;
                if (kind == Kind::share) w *= cosine;
                rule.nodes.push_back({sine * sine, cosine * cosine, std::move(w)});
            }
        };
        pieces(0, t_end, 30);
        return rule;
    }

    // ---- rows

    struct Row {
        Ball value, slope; ///< v_{k+1}(d), and its derivative where asked
        double error = 0;  ///< of value (or of slope, where asked) beyond its radius: rule and levels
        double rule_error = 0, interpolation = 0, carried = 0;
    };

    /// u_1 and, if asked, its derivative.
    void first(const Ball& d, Ball& u, Ball* slope) const
    {
        const Ball w = exp(-2 * d), one_minus = 1 - load;
        const Ball R = full ? 2 * exp(-d) : sqrt(one_minus * one_minus + 4 * load * w);
        Ball minus_b;
        {
            const Ball z = -2 * d;
            arb_expm1(minus_b.get(), z.get(), WorkingPrecision::bits());
            minus_b = -minus_b; // 1 - w
        }
        const Ball P = 1 + load + R, M = one_minus + R;
        if (law == Law::density) {
            u = full ? sqrt((1 + exp(-d)) * 2 * d / minus_b) / 2 : exp(-d * 3 / 2) * sqrt(P * 2 * d / (M * minus_b)) / R;
            return;
        }
        const Ball top = 2 * load * minus_b, rest = M + 2 * load * w; // z^2 : 1 - z^2
        const Ball angle = atan2(sqrt(top), sqrt(rest)), v = angle / sqrt(2 * d), decay = exp(-d / 2);
        u = decay * v;
        if (slope) {
            const Ball R_d = -4 * load * w / R, z2_d = 2 * load * (2 * w / P - minus_b * R_d / (P * P));
            const Ball angle_d = z2_d / (2 * sqrt(top * rest) / P);
            *slope = decay * (angle_d / sqrt(2 * d) - v / (2 * d) - v / 2);
        }
    }

    Row row(const Level& from, Kind kind, const Ball& d, const RowRule& rule)
    {
        Row out;
        const Ball &e = from.edge, w4 = 4 * e * exp(-2 * d), two_d = 2 * d, one(1);
        const double d_d = about(d);
        double interpolation = 0;
        const Panel* panel = nullptr;
        std::map<const Panel*, std::pair<std::vector<double>, double>> moments;
        Ball u, u_d, a, b, k_d, sum(0), sum_d(0);
        const bool with_slope = kind == Kind::slope;
        for (const RuleNode& node : rule.nodes) {
            const Ball delta = two_d * node.s, D = two_d * node.c;
            Ball minus = -delta;
            arb_expm1(a.get(), minus.get(), precision);
            minus = -D;
            arb_expm1(b.get(), minus.get(), precision);
            Ball root; // e^(-delta/2), where x itself is to keep its sign
            if (kind == Kind::share) root = exp(-delta / 2);
            const Ball x = kind == Kind::share ? e * root * root : e * (one + a), one_minus = one - x, R = sqrt(one_minus * one_minus + w4), P = one + x + R;
            Ball k;
            if (kind == Kind::share) {
                // z^2 : 1 - z^2
                k = atan2(sqrt(-2 * x * b), sqrt(one_minus + R + 2 * x * (one + b))) * root;
            }
            else {
                const Ball M = one_minus + R;
                k = law == Law::density ? sqrt(-P * D / (M * b)) / R : sqrt(-P * M * D / b) / R;
            }
            k *= node.weight;
            if (with_slope) { // (log k)' at fixed s
                const Ball s2 = 2 * node.s, M = one_minus + R, x_d = -x * s2, R_d = (-one_minus * x_d - w4) / R;
                const Ball E_d = 2 * node.c * (-(one + b) / b - one / D); // of log E
                k_d = ((x_d + R_d) / P + (R_d - x_d) / M - E_d) / 2 - R_d / R;
            }
            const double k_d_d = with_slope ? about(k_d) : 0;
            if (from.k == 1) first(delta, u, with_slope ? &u_d : nullptr);
            else {
                const double at = about(delta);
                if (!panel || at < panel->a || at > panel->b) {
                    const auto it = std::lower_bound(from.panels.begin(), from.panels.end(), at, [](const auto& p, double y) { return p->b < y; });
                    panel = it == from.panels.end() ? from.panels.back().get() : it->get();
                }
                const Ball xi = ((panel->logarithmic ? log(delta) : delta) - panel->mid) / panel->half;
                if (with_slope) {
                    arb_poly_evaluate2(u.get(), u_d.get(), panel->polynomial, xi.get(), wide);
                    u_d = u_d / panel->half;
                    if (panel->logarithmic) u_d = u_d / delta;
                }
                else evaluate(*panel, xi, u);
                // what the values of the level do to this row
                auto& [moment, weight] = moments[panel];
                moment.resize(static_cast<std::size_t>(panel->points));
                const double size = std::fabs(about(k)), x_d = std::clamp(about(xi), -1.0, 1.0);
                interpolation += size * std::max(1.0, std::fabs(k_d_d)) * panel->interpolation;
                weight += size * (with_slope ? 1 + std::fabs(k_d_d) + 2 / panel->half_d / (panel->logarithmic ? at : 1) : 1);
                // the row as a functional of T_j: k T_j, or k (2s T_j' + (log k)' T_j)
                const double per = with_slope ? 2 * about(node.s) / panel->half_d / (panel->logarithmic ? at : 1) : 0;
                if (with_slope) out.interpolation += size * per * panel->slope;
                double t0 = 1, t1 = x_d, u0 = 0, u1 = 1; // T_j, T_{j+1}, U_{j-1}, U_j
                for (std::size_t j = 0; j < moment.size(); ++j) {
                    moment[j] += with_slope ? about(k) * (per * static_cast<double>(j) * u0 + k_d_d * t0) : size * t0;
                    const double t2 = 2 * x_d * t1 - t0, u2 = 2 * x_d * u1 - u0;
                    t0 = t1;
                    t1 = t2;
                    u0 = u1;
                    u1 = u2;
                }
            }
            if (with_slope) sum_d += k * (u_d * 2 * node.s + u * k_d);
            sum += k * u;
        }
        for (auto& [p, entry] : moments) {
            auto& [moment, weight] = entry;
            const auto& T = chebyshev_table(p->points);
            const auto n = static_cast<std::size_t>(p->points);
            for (std::size_t j = 0; j < n; ++j) {
                double B = moment[0];
                for (std::size_t i = 1; i < n; ++i) B += 2 * moment[i] * T[i * n + j];
                out.carried += std::fabs(B) / static_cast<double>(n) * p->errors[j];
            }
            out.carried += (at_panel_end + slack * static_cast<double>(n)) * weight * p->worst * static_cast<double>(with_slope ? n * n : 1); // this arithmetic's own rounding
        }
        out.value = sum;
        out.slope = sum_d;
        out.rule_error = rule.error + dropped(from, kind, d_d, rule.reach);
        out.interpolation = (out.interpolation + interpolation) * (1 + slack);
        out.error = (out.rule_error + out.interpolation + out.carried + smallest_bound) * (1 + slack); // what underflowed in the sums above is less
        return out;
    }

    /// What the far end, delta >= reach, can hold of v_{k+1}(d).
    double dropped(const Level& from, Kind kind, double d, double reach) const
    {
        if (!std::isfinite(reach)) return 0;
        const auto k = static_cast<double>(from.k);
        const double next = log_constant(from); // log(C_{k+1})
        if (law == Law::exceedance) // E_{k+1} = d^((k+1)/2) C_{k+1} v_{k+1}; the derivative is never asked for here
            return kind == Kind::slope ? infinity
                                       : std::exp(0.5 * std::log(about(from.edge)) - reach / 2 - (k + 1) / 2 * std::log(d) - next) * (1 + 1e-6);
        if (kind == Kind::share) return infinity; // its caller adds its own
        const double k2 = 4 / std::numbers::pi * std::pow(1 - above(from.edge_bound), -1.5);
        return product_of_bounds({4.1 * k2 * from.tail, std::exp(-reach - (k - 1) / 2 * std::log(d) - next)}) * (1 + 1e-6);
    }
    double log_constant(const Level& from) const
    {
        const WorkingPrecision low(60);
        return about(log(constant_after(from)));
    }
    Ball constant_after(const Level& from) const
    {
        const long k = from.k;
        Ball step = sqrt(Traits::power_of_two(k + 1)) * wallis(power(k));
        step = law == Law::density ? step * 4 / Traits::pi() : step * sqrt(from.edge) / Traits::pi();
        return from.C * step;
    }

    const std::vector<double>& chebyshev_table(long n)
    {
        auto& T = chebyshev_at[n];
        if (T.empty())
            for (long i = 0; i < n; ++i)
                for (long j = 0; j < n; ++j)
                    T.push_back(std::cos(std::numbers::pi * static_cast<double>(i * (2 * j + 1) % (4 * n)) / static_cast<double>(2 * n)));
        return T;
    }
    /// Values at the n Chebyshev points to coefficients of powers.
    const std::vector<Ball>& monomial_matrix(long n)
    {
        auto& A = to_monomials[n];
        if (!A.empty()) return A;
        const auto N = static_cast<std::size_t>(n);
        A.resize(N * N);
        std::vector<Ball> t0(N), t1(N), t2(N); // coefficients of T_i
        t0[0] = 1;
        t1[std::min<std::size_t>(1, N - 1)] = 1;
        for (std::size_t i = 0; i < N; ++i) {
            for (std::size_t j = 0; j < N; ++j) {
                const Ball c = Traits::cos_pi(Traits::quotient(static_cast<long>(i * (2 * j + 1)), 2 * n)) * (i == 0 ? 1 : 2) / n;
                for (std::size_t p = i % 2; p <= i; p += 2) A[p * N + j] += t0[p] * c;
            }
            for (std::size_t p = 0; p < N; ++p) t2[p] = (p == 0 ? Ball(0) : 2 * t1[p - 1]) - t0[p];
            t0 = t1;
            t1 = t2;
        }
        return A;
    }

    // ---- building a level

    /// Bound of |u| on the ellipse rho of [a, b], in d or in log d; whole: of |v|, or in log d of |d^(k/2) v|, b = 1/2.
    double ellipse_bound(const Level& to, double a, double b, bool logarithmic, double rho, bool whole) const
    {
        const Boxes& boxes = to.boxes;
        const double lo = logarithmic ? std::log(a) : a, hi = logarithmic ? std::log(b) : b;
        const double mid = (lo + hi) / 2, half = (hi - lo) / 2 * (1 + slack), A = (rho + 1 / rho) / 2, B = (rho - 1 / rho) / 2;
        constexpr int arcs = 40;
        const double radius = half * A * std::numbers::pi / (2 * arcs) * (1 + slack);
        double most = 0;
        for (int i = 0; i < arcs && std::isfinite(most); ++i) {
            const double phi = std::numbers::pi * (i + 0.5) / arcs, x = mid + half * A * std::cos(phi), y = half * B * std::sin(phi);
            if (logarithmic) {
                if (y + radius > 3.1) return infinity;
                const double outer = std::exp(x + radius) * (1 + slack), least = std::max(0.0, y - radius);
                const double back = whole ? std::exp((std::max(0.0, outer * std::cos(least)) + static_cast<double>(to.k) * (x + radius)) / 2) * (1 + 1e-6) : 1;
                most = std::max(most, back * lookup(boxes, {std::exp(x - radius) * (1 - slack), outer, least, y + radius}));
            }
            else most = std::max(most, (whole ? std::exp((x + radius) / 2) * (1 + slack) : 1) * lookup(boxes, polar(x, y, radius)));
        }
        return most;
    }

    struct Choice {
        double b = 0, rho = 0, bound = 0;
        long points = std::numeric_limits<long>::max();
    };
    Choice choose(const Level& from, const Level& to, double a, double b, bool logarithmic, bool whole) const
    {
        static constexpr std::array rhos{12.0, 9.5, 7.6, 6.2, 5.0, 4.1, 3.4, 2.8, 2.35, 2.0, 1.75, 1.55};
        const double at_b = estimate_step(from, b);
        const double goal = std::max(smallest_bound, epsilon * (whole && logarithmic ? std::pow(b, static_cast<double>(to.k) / 2) * at_b : std::min(estimate_step(from, a == 0 ? b * 1e-3 : a), at_b)));
        const Settings& set = settings(law);
        Choice best;
        for (const double rho : rhos) {
            const double U = ellipse_bound(to, a, b, logarithmic, rho, whole);
            if (!std::isfinite(U)) continue;
            long n = 1 + static_cast<long>(std::ceil(std::max(std::log(4 * U / (rho - 1)) - std::log(goal), 0.0) / std::log(rho)));
            n = set.least_points + std::max(0L, (n - set.least_points + set.step_points - 1) / set.step_points) * set.step_points;
            if (n < best.points) best = {b, rho, U, n};
        }
        return best;
    }

    void extend_to(long k)
    {
        while (static_cast<long>(levels.size()) <= k) {
            const WorkingPrecision scope(precision);
            levels.push_back(next(*levels.back()));
            progress("distribution, scale", static_cast<long>(levels.size()) - 1, k);
        }
    }

    /// \param whole_until 0, or where E_{k+1}, kept in place of u_{k+1}, is to end: for small p
    std::unique_ptr<Level> next(const Level& from, double whole_until = 0)
    {
        const bool whole = whole_until > 0;
        auto to = std::make_unique<Level>();
        to->k = from.k + 1;
        to->edge = 2 / G * sqrt(from.edge);
        to->C = constant_after(from);
        {
            const WorkingPrecision low(bound_bits);
            to->edge_bound = to->edge + Ball(0);
        }
        to->tail = next_tail(from.k, from.edge_bound, from.tail, load_d);
        bound_boxes(from, *to);
        const Settings& set = settings(law);
        const double disc_radius = shells.radius(to->boxes.disc);
        double a = 0;
        const double end = whole ? whole_until : delta_max;
        while (a < end) {
            Choice best;
            bool logarithmic = false;
            if (a == 0) {
                for (double b = 8 * disc_radius; b > disc_radius / 64; b /= std::numbers::sqrt2) {
                    best = choose(from, *to, 0, b, false, whole);
                    if (best.points <= most_points) break;
                }
            }
            else {
                double merit = 0;
                for (const double ratio : set.ratios) {
                    const double b = std::min(a * ratio, whole ? end : 1.5 * delta_max); // rows reach 2b, boxes 16 delta_max
                    const Choice c = choose(from, *to, a, b, set.logarithmic, whole);
                    if (c.points > most_points) continue;
                    const double m = std::log(b / a) / static_cast<double>(c.points);
                    if (m > merit) {
                        merit = m;
                        best = c;
                    }
                }
                logarithmic = set.logarithmic;
            }
            if (best.points > most_points || to->panels.size() > 400)
                throw BeyondReach("the distribution's region of analyticity is too narrow here; the load is too near 1 or G too near 2");
            auto panel = std::make_unique<Panel>();
            panel->a = a;
            panel->b = best.b;
            panel->logarithmic = logarithmic;
            const Ball lo = logarithmic ? log(Ball::exactly(a)) : Ball::exactly(a), hi = logarithmic ? log(Ball::exactly(best.b)) : Ball::exactly(best.b);
            panel->mid = (lo + hi) / 2;
            panel->half = (hi - lo) / 2;
            panel->mid_d = about(panel->mid);
            panel->half_d = about(panel->half);
            panel->points = best.points;
            panel->rho = best.rho;
            panel->bound = best.bound;
            const double n = static_cast<double>(best.points), r = best.rho, q = 1 / r;
            panel->interpolation = product_of_bounds({4 * best.bound / (r - 1), std::pow(r, 1 - n)}) * (1 + at_panel_end);
            // sum_{k >= N} 2 U rho^-k (k^2 + N^2) <= 4 U sum k^2 rho^-k
            panel->slope = product_of_bounds({4 * best.bound * (n * n + 2 * n * q / (1 - q) + q * (1 + q) / ((1 - q) * (1 - q))) / (1 - q), std::pow(q, n)}) * (1 + at_panel_end);
            fill_panel(from, *to, *panel, whole);
            a = best.b;
            to->panels.push_back(std::move(panel));
        }
        std::vector<std::pair<double, double>> known;
        for (std::size_t i = 0; i < to->log_d.size(); ++i) known.emplace_back(to->log_d[i], to->log_v[i]);
        std::sort(known.begin(), known.end());
        for (std::size_t i = 0; i < known.size(); ++i) std::tie(to->log_d[i], to->log_v[i]) = known[i];
        return to;
    }

    /// Fixed-point form of the panel's polynomial: sum |c| < 2^14 units of 2^scale.
    ///
    /// A value is off by at most: each of `points` coefficients one unit, each product one unit (both carried on by |xi| <= 1), and xi's own
    /// unit times sum j |c_j| <= points 2^14. The radius of xi is added where it is used.
    void make_fixed(Panel& panel) const
    {
        const WorkingPrecision scope(wide);
        Ball sum(0);
        for (long j = 0; j < panel.points; ++j) {
            Ball c;
            arb_abs(c.get(), panel.polynomial->coeffs + j);
            sum += c;
        }
        mag_t size;
        mag_init(size);
        arb_get_mag(size, sum.get());
        panel.scale = mag_is_zero(size) ? 0 : static_cast<long>(MAG_EXP(size)) - 14;
        mag_clear(size);
        const auto limbs = static_cast<std::size_t>(format.limbs());
        panel.fixed.resize(static_cast<std::size_t>(panel.points) * limbs);
        mag_set_ui(panel.fixed_error, static_cast<ulong>(panel.points) * (3 + (1UL << 14)));
        mag_mul_2exp_si(panel.fixed_error, panel.fixed_error, panel.scale - format.fraction());
        mag_t radius;
        mag_init(radius);
        for (long j = 0; j < panel.points; ++j) {
            Ball c;
            arb_set(c.get(), panel.polynomial->coeffs + j);
            mag_add(radius, radius, arb_radref(c.get()));
            arb_mul_2exp_si(c.get(), c.get(), -panel.scale);
            format.put(panel.fixed.data() + static_cast<std::size_t>(panel.points - 1 - j) * limbs, c);
        }
        mag_add(panel.fixed_error, panel.fixed_error, radius);
        mag_clear(radius);
    }
    void evaluate(const Panel& panel, const Ball& xi, Ball& u)
    {
        const auto limbs = static_cast<std::size_t>(format.limbs());
        const auto size = static_cast<mp_size_t>(limbs);
        const double x = about(xi);
        if (!(std::fabs(x) < 1)) { // xi = +-1 by rounding: the rule is proven for |xi| <= 1
            arb_poly_evaluate(u.get(), panel.polynomial, xi.get(), wide);
            return;
        }
        format.put(xi_fixed.data(), xi);
        std::copy_n(panel.fixed.data(), limbs, sum_fixed.data());
        for (std::size_t j = 1; j < static_cast<std::size_t>(panel.points); ++j) {
            format.multiply(product_fixed.data(), sum_fixed.data(), xi_fixed.data(), 0, scratch.data());
            mpn_add_n(sum_fixed.data(), product_fixed.data(), panel.fixed.data() + j * limbs, size);
        }
        fmpz_t units;
        fmpz_init(units);
        format.get(units, sum_fixed.data());
        arb_set_fmpz(u.get(), units);
        fmpz_clear(units);
        arb_mul_2exp_si(u.get(), u.get(), panel.scale - format.fraction());
        mag_t e; // xi's radius times sum j |c_j|
        mag_init(e);
        mag_mul_ui(e, arb_radref(xi.get()), static_cast<ulong>(panel.points));
        mag_mul_2exp_si(e, e, panel.scale + 14);
        mag_add(e, e, panel.fixed_error);
        mag_add(arb_radref(u.get()), arb_radref(u.get()), e);
        mag_clear(e);
    }

    void fill_panel(const Level& from, Level& to, Panel& panel, bool whole)
    {
        const long n = panel.points;
        const auto N = static_cast<std::size_t>(n);
        std::vector<Ball> values(N);
        panel.errors.resize(N);
        std::vector<Ball> at(N);
        std::vector<double> at_d(N);
        for (std::size_t j = 0; j < N; ++j) {
            at[j] = panel.mid + panel.half * Traits::cos_pi(Traits::quotient(static_cast<long>(2 * j + 1), 2 * n));
            if (panel.logarithmic) at[j] = exp(at[j]);
            at_d[j] = about(at[j]);
        }
        RowRule rule;
        double rule_from = infinity;
        for (std::size_t j = 0; j < N; ++j) { // descending d
            const double d = at_d[j];
            if (d * (1 + 1e-12) < rule_from || j == 0) {
                const double low = panel.a == 0 && d < panel.b / 12 ? 0 : d / 1.13;
                const double relaxed = whole ? epsilon : std::min(epsilon * std::exp(std::min(beta * low, 600.0)), 1e-3);
                rule = make_rule(from, Kind::step, low, d * (1 + 1e-12), 0, relaxed * estimate_step(from, d));
                rule_from = low;
            }
            const Row r = row(from, Kind::step, at[j], rule);
            to.row_nodes += rule.nodes.size();
            const Ball decay = whole ? panel.logarithmic ? half_power(at[j], to.k) : Ball(1) : exp(-at[j] * Traits::quotient(law == Law::density ? 3 : 1, 2));
            const Ball u = r.value * decay;
            const double decay_d = above(decay), scale = epsilon * std::fabs(about(r.value));
            panel.errors[j] = (product_of_bounds({r.error, decay_d}) + mag_get_d(arb_radref(u.get())) + smallest_bound) * (1 + slack);
            panel.worst = std::max(panel.worst, panel.errors[j]);
            arb_get_mid_arb(values[j].get(), u.get());
            if (!u.is_finite() || !std::isfinite(panel.errors[j])) throw BeyondReach("the distribution is not resolved at this precision");
            to.log_d.push_back(std::log(d));
            to.log_v.push_back(std::log(std::fabs(about(r.value))));
            const double unit = whole ? std::fabs(about(values[0])) : scale / epsilon;
            to.worst_row = std::max(to.worst_row, r.rule_error * decay_d / unit);
            to.worst_carried = std::max(to.worst_carried, (r.interpolation + r.carried) * decay_d / unit);
            to.worst_total = std::max(to.worst_total, panel.errors[j] / unit);
            to.worst_interpolation = std::max(to.worst_interpolation, panel.interpolation / unit);
        }
        to.nodes += N;
        const WorkingPrecision scope(wide);
        const auto& A = monomial_matrix(n);
        arb_poly_fit_length(panel.polynomial, n);
        for (std::size_t p = 0; p < N; ++p) {
            arb_ptr c = panel.polynomial->coeffs + p;
            arb_zero(c);
            for (std::size_t j = 0; j < N; ++j) arb_addmul(c, A[p * N + j].get(), values[j].get(), wide);
        }
        _arb_poly_set_length(panel.polynomial, n);
        if (!whole) make_fixed(panel);
    }

    // ---- values

    static void widen(Ball& b, double error)
    {
        mag_t m;
        mag_init(m);
        mag_set_d(m, error);
        arb_add_error_mag(b.get(), m);
        mag_clear(m);
    }
    static Ball half_power(const Ball& x, long twice)
    {
        Ball r;
        arb_pow_ui(r.get(), x.get(), static_cast<ulong>(twice / 2), WorkingPrecision::bits());
        return twice % 2 ? r * sqrt(x) : r;
    }

    RowRule rule_at(const Level& from, Kind kind, const Ball& d, double around)
    {
        const double x = about(d);
        const double size = kind == Kind::share ? estimate_share(from, x) : estimate_step(from, x);
        return make_rule(from, kind, x, x, around * x, epsilon * size * (kind == Kind::slope ? around : 1));
    }
    double estimate_share(const Level& from, double d) const
    {
        const double e = about(from.edge);
        double sum = 0, weight = 0;
        for (int i = 0; i < 60; ++i) {
            const double theta = std::numbers::pi / 2 * (i + 0.5) / 60, s = std::pow(std::sin(theta), 2), w = std::pow(std::sin(theta), static_cast<double>(power(from.k)));
            const double delta = 2 * d * s, x = e * std::exp(-delta), R = std::sqrt((1 - x) * (1 - x) + 4 * e * std::exp(-2 * d));
            const double z2 = -2 * x * std::expm1(-2 * d * (1 - s)) / (1 + x + R);
            weight += w;
            sum += w * std::cos(theta) * std::asin(std::sqrt(std::min(z2, 1.0))) * std::exp(-2 * delta) * estimate(from, delta);
        }
        return sum / weight;
    }

    struct Value {
        Ball value;
        Row row;
        std::size_t nodes;
        double cut = 0; ///< where E_n ends, if by the form for small p
    };

    Value density(long n, const Ball& p, const Ball& d)
    {
        if (is_small(n, d)) return small_density(n, d);
        extend_to(n);
        const Level& from = *levels[static_cast<std::size_t>(n)];
        const Ball constant = constant_after(from);
        if (law == Law::density) {
            const RowRule rule = rule_at(from, Kind::step, d, 0);
            Row r = row(from, Kind::step, d, rule);
            widen(r.value, r.error);
            // load d^((n-1)/2) e^(-3d) C v/p^2
            return {load * half_power(d, n - 1) * exp(-3 * d) * constant * r.value / (p * p), r, rule.nodes.size()};
        }
        if (2 * about(d) > delta_max) throw BeyondReach("p is too small against the highest pressure");
        const double around = 0.04;
        const RowRule rule = rule_at(from, Kind::slope, d, around);
        Row r = row(from, Kind::slope, d, rule);
        // the rule's error is analytic in d: Cauchy's bound of its derivative
        Ball v_d = r.slope;
        widen(v_d, rule.error / (around * about(d)) * (1 + slack) + r.interpolation + r.carried);
        const Row plain = row(from, Kind::step, d, rule);
        Ball v = plain.value;
        widen(v, plain.error);
        return {half_power(d, n - 1) * constant * ((n + 1) * v / 2 + d * v_d) / p, r, rule.nodes.size()};
    }

    // ---- small p by the exceedance law

    bool is_small(long n, const Ball& d) const { return law == Law::exceedance && n >= 2 && 2 * about(d) > cut_for_small(accuracy, n, G, load) + 1.01; }

    /// h and h g at delta, D = 2d - delta: q(P; x) = (e^-d/pi) e^(delta/2) h, dq/ddelta = q g; see the header.
    struct SmallKernel {
        Ball edge, w4, e2d; ///< e_n, P^2, e^(-2d)
        std::pair<C, C> at(const C& delta, bool analytic) const
        {
            const slong bits = WorkingPrecision::bits();
            const auto root = [&](const C& z) {
                C r;
                acb_sqrt_analytic(r.get(), z.get(), analytic, bits);
                return r;
            };
            const C x = C(edge) * exp(-delta), one_minus = 1 - x, R = root(one_minus * one_minus + C(w4)), P = 1 + x + R, M = one_minus + R;
            const C rest = 1 - C(e2d) * exp(delta), h = root(P) / (root(M) * R * root(rest)), R_delta = one_minus * x / R;
            return {h, h * (1 / (2 * rest) - R_delta / R + ((R_delta - x) / P - (R_delta + x) / M) / 2)};
        }
    };
    /// Where the variable of integration over a panel, t with delta = t^2 or y with delta = e^y, is x: delta, and the panel's polynomial.
    static std::pair<C, C> on_panel(const Panel& panel, const C& x, slong bits)
    {
        C delta = panel.logarithmic ? exp(x) : x * x, value;
        const C xi = ((panel.logarithmic ? x : delta) - C(panel.mid)) / C(panel.half);
        arb_poly_evaluate_acb(value.get(), panel.polynomial, xi.get(), bits);
        return {std::move(delta), std::move(value)};
    }
    /// delta^(twice/2) ddelta = 2 t^(twice+1) dt
    static C root_measure(const C& t, long twice, slong bits)
    {
        C power;
        acb_pow_ui(power.get(), t.get(), static_cast<ulong>(twice + 1), bits);
        return 2 * power;
    }
    struct SmallIntegrand {
        const Panel* panel;
        const SmallKernel* kernel;
        long k;
        slong wide;
    };
    static int small_integrand(acb_ptr out, const acb_t at, void* param, slong order, slong)
    {
        const SmallIntegrand& w = *static_cast<const SmallIntegrand*>(param);
        const WorkingPrecision scope(w.wide);
        C x;
        acb_set(x.get(), at);
        const auto [delta, E] = on_panel(*w.panel, x, w.wide);
        const C measure = w.panel->logarithmic ? delta : root_measure(x, w.k, w.wide); // ddelta = delta dy
        const C value = E * w.kernel->at(delta, order != 0).second * exp(delta / 2) * measure;
        acb_set(out, value.get());
        return 0;
    }

    Value small_density(long n, const Ball& d)
    {
        extend_to(n - 1);
        auto& kept = whole[n];
        const double end = std::ldexp(std::floor(std::ldexp(cut_for_small(accuracy, n, G, load), 10)), -10);
        if (!kept) kept = next(*levels[static_cast<std::size_t>(n) - 1], end);
        const Level& level = *kept;
        const WorkingPrecision scope(wide);
        SmallKernel kernel{level.edge, 4 * level.edge * exp(-2 * d), exp(-2 * d)};
        const double e = above(level.edge_bound);
        const auto most = [e](double delta) { return 1.26 * std::pow(1 - e * std::exp(-delta) * (1 + slack), -1.5); }; // of h
        Ball sum(0);
        double error = 0, interpolation = 0, carried = 0;
        mag_t tolerance;
        mag_init(tolerance);
        mag_set_ui_2exp_si(tolerance, 1, -2 * precision);
        for (const auto& panel : level.panels) {
            const Ball lo = Ball::exactly(panel->a), hi = Ball::exactly(panel->b);
            const C from = C(panel->logarithmic ? log(lo) : sqrt(lo)), to = C(panel->logarithmic ? log(hi) : sqrt(hi));
            SmallIntegrand w{panel.get(), &kernel, n, wide};
            C part;
            acb_calc_integrate(part.get(), small_integrand, &w, from.get(), to.get(), precision, tolerance, nullptr, wide);
            sum -= part.real();
            const double x = e * std::exp(-panel->a), slope = 0.8 + 1.75 * x / (1 - x);
            double weight = most(panel->a) * slope * 2 * (std::exp(panel->b / 2) - std::exp(panel->a / 2));
            if (!panel->logarithmic) weight *= std::pow(panel->b, static_cast<double>(n) / 2);
            if (panel == level.panels.back()) {
                Ball whole_at_end;
                const Ball xi = ((panel->logarithmic ? log(hi) : hi) - panel->mid) / panel->half;
                arb_poly_evaluate(whole_at_end.get(), panel->polynomial, xi.get(), wide);
                if (!panel->logarithmic) whole_at_end *= half_power(hi, n);
                sum += whole_at_end * kernel.at(C(hi), false).first.real() * exp(hi / 2);
                weight += most(panel->b) * std::exp(panel->b / 2) * (panel->logarithmic ? 1 : std::pow(panel->b, static_cast<double>(n) / 2));
            }
            interpolation += weight * panel->interpolation * (1 + 1e-6);
            carried += weight * (2 / std::numbers::pi * std::log(static_cast<double>(panel->points)) + 1) * panel->worst * (1 + 1e-6);
        }
        mag_clear(tolerance);
        error = (interpolation + carried + smallest_bound) * (1 + at_panel_end);
        Row r;
        r.value = sum * level.C;
        const double C_d = above(level.C);
        Ball unit;
        arb_pow_ui(unit.get(), G.get(), static_cast<ulong>(n), precision);
        const Ball beyond = load / (unit * level.edge) * exp(2 - 3 * Ball::exactly(end) / 2) * Ball::exactly(level.tail) * Ball::exactly(most(end) / 1.26 * 3.5 * (n == 2 ? (end + 2.2) / 5.2 : 1) * (1 + 1e-6));
        r.interpolation = interpolation * C_d;
        r.carried = carried * C_d;
        r.rule_error = above(beyond);
        widen(r.value, error * C_d * (1 + slack));
        arb_add_error(r.value.get(), beyond.get());
        return {exp(-d) / (Traits::pi() * unit) * r.value, r, level.nodes, end};
    }

    Value exceedance(long n, const Ball& d)
    {
        extend_to(n);
        const Level& from = *levels[static_cast<std::size_t>(n)];
        if (law == Law::exceedance) {
            const RowRule rule = rule_at(from, Kind::step, d, 0);
            Row r = row(from, Kind::step, d, rule);
            widen(r.value, r.error);
            return {half_power(d, n + 1) * constant_after(from) * r.value, r, rule.nodes.size()};
        }
        // load/(G^n e_n) int delta^(n/2-1) e^(-2 delta) C_n v_n(delta) Q ddelta, Q = (2/pi) arcsin z, delta = 2 d sin^2 theta:
        // (2d)^(n/2) 2 wallis <sin^(n-1)| cos(theta) arcsin(z) e^(-delta/2) u_n>
        const RowRule rule = rule_at(from, Kind::share, d, 0);
        RowRule whole = rule;
        whole.reach = infinity;
        Row r = row(from, Kind::share, d, whole);
        widen(r.value, r.error);
        Ball unit;
        arb_pow_ui(unit.get(), G.get(), static_cast<ulong>(n), precision);
        const Ball front = load / (unit * from.edge);
        Ball value = front * half_power(2 * d, n) * 2 * wallis(power(n)) * from.C * 2 / Traits::pi() * r.value;
        if (std::isfinite(rule.reach)) widen(value, product_of_bounds({above(front), from.tail, std::exp(-1.5 * rule.reach) / 1.5}) * (1 + slack));
        return {value, r, rule.nodes.size()};
    }

    // ---- integrals over a level

    /// d^(twice/2) e^(-c d) u_k on one panel: with d = t^2 (or d = e^y where the panel is logarithmic) the integrand is entire.
    struct Weighted {
        const Panel* panel;
        long twice;
        Ball c;
        slong wide;
    };
    static int integrand(acb_ptr out, const acb_t at, void* param, slong, slong)
    {
        const Weighted& w = *static_cast<const Weighted*>(param);
        const WorkingPrecision scope(w.wide);
        C x;
        acb_set(x.get(), at);
        const auto [d, u] = on_panel(*w.panel, x, w.wide);
        const C measure = w.panel->logarithmic ? exp(x * C(Ball(w.twice + 2) / 2)) : root_measure(x, w.twice, w.wide); // dd = d dy
        const C value = u * exp(-d * C(w.c)) * measure;
        acb_set(out, value.get());
        return 0;
    }
    /// int d^(twice/2) e^(-c d) u_k over the panels of a level, and where they end.
    ///
    /// |u - polynomial| <= interpolation + Lebesgue constant (2/pi) log N + 1 times the worst node's error.
    std::pair<Ball, double> over_level(const Level& level, long twice, const Ball& c) const
    {
        Ball sum(0);
        for (const auto& panel : level.panels) {
            const WorkingPrecision scope(wide);
            const Ball lo = Ball::exactly(panel->a), hi = Ball::exactly(panel->b);
            const C from = C(panel->logarithmic ? log(lo) : sqrt(lo)), to = C(panel->logarithmic ? log(hi) : sqrt(hi));
            Weighted w{panel.get(), twice, c, wide};
            C part;
            mag_t tolerance;
            mag_init(tolerance);
            mag_set_ui_2exp_si(tolerance, 1, -precision);
            acb_calc_integrate(part.get(), integrand, &w, from.get(), to.get(), precision, tolerance, nullptr, wide);
            mag_clear(tolerance);
            // where d^(twice/2) e^(-c d) is largest
            const double c_d = about(c), half = static_cast<double>(twice) / 2, peak = std::clamp(half / c_d, panel->a, panel->b);
            const double largest = std::exp((half > 0 ? half * std::log(peak) : 0) - c_d * peak) * (1 + 1e-6);
            const double off = (panel->interpolation + (2 / std::numbers::pi * std::log(static_cast<double>(panel->points)) + 1) * panel->worst) * (1 + at_panel_end);
            Ball real = part.real();
            widen(real, off * largest * (panel->b - panel->a) * (1 + slack));
            sum += real;
        }
        return {sum, level.panels.back()->b};
    }

    /// p_n^max = G^k e_k, k = n + 1
    Ball highest(const Level& level) const
    {
        Ball unit;
        arb_pow_ui(unit.get(), G.get(), static_cast<ulong>(level.k), precision);
        return unit * level.edge;
    }
    Ball force(long n)
    {
        extend_to(n + 1);
        const Level& level = *levels[static_cast<std::size_t>(n) + 1];
        if (law == Law::density) { // load int f_k dd
            auto [sum, end] = over_level(level, level.k - 2, Ball(3) / 2);
            sum *= level.C;
            widen(sum, level.tail * std::exp(-2.5 * end) / 2.5 * (1 + slack));
            return load * sum;
        }
        auto [sum, end] = over_level(level, level.k, Ball(1) / 2); // int Q_n dp = p_max int e^-d E_k dd
        sum *= level.C;
        widen(sum, std::exp(-end) * (1 + slack));
        return highest(level) * sum;
    }
    Ball mass(long n)
    {
        if (law != Law::density) throw BeyondReach("the exceedance law has A_n as a limit, not as an integral");
        extend_to(n + 1);
        const Level& level = *levels[static_cast<std::size_t>(n) + 1];
        auto [sum, end] = over_level(level, level.k - 2, Ball(1) / 2); // load int f_k/p dd
        sum *= level.C;
        widen(sum, level.tail * std::exp(-1.5 * end) / 1.5 * (1 + slack));
        return load * sum / highest(level);
    }
};

Forward::Forward(Law law, const std::function<Ball()>& G_at, const std::function<Ball()>& load_at, double accuracy)
{
    require_binary64_arithmetic();
    const WorkingPrecision scope(Implementation::precision_for(accuracy));
    implementation_ = std::make_unique<Implementation>(law, G_at(), load_at(), accuracy);
}
Forward::~Forward() = default;

slong Forward::bits() const { return implementation_->precision; }

Ball Forward::density(long n, const Ball& p, const Ball& d)
{
    const std::lock_guard lock(implementation_->mutex);
    const WorkingPrecision scope(implementation_->precision);
    return implementation_->density(n, p, d).value;
}

Ball Forward::exceedance(long n, const Ball& d)
{
    const std::lock_guard lock(implementation_->mutex);
    const WorkingPrecision scope(implementation_->precision);
    return implementation_->exceedance(n, d).value;
}

Ball Forward::force(long n)
{
    const std::lock_guard lock(implementation_->mutex);
    const WorkingPrecision scope(implementation_->precision);
    return implementation_->force(n);
}

Ball Forward::mass(long n)
{
    const std::lock_guard lock(implementation_->mutex);
    const WorkingPrecision scope(implementation_->precision);
    return implementation_->mass(n);
}

std::string Forward::certificate(long n, const Ball& p, const Ball& d)
{
    Implementation& in = *implementation_;
    const std::lock_guard lock(in.mutex);
    const WorkingPrecision scope(in.precision);
    const auto q = in.density(n, p, d);
    const double v = std::fabs(about(q.row.value));
    std::string text = fmt::format("{} law: {} bits, far end from delta = {:.0f}\n", in.law == Law::density ? "density" : "exceedance", in.precision, in.delta_max);
    for (long k = 2; k <= n; ++k) {
        const Level& l = q.cut > 0 && k == n ? *in.whole[n] : *in.levels[static_cast<std::size_t>(k)];
        text += fmt::format("  scale {:2}: {:2} panels, {:4} nodes, {:4} points a row; of v: rows {:.1e}, carried {:.1e}, all {:.1e}; interpolation {:.1e}\n", k - 1, l.panels.size(),
                            l.nodes, l.row_nodes / l.nodes, l.worst_row, l.worst_carried, l.worst_total, l.worst_interpolation);
    }
    if (q.cut > 0)
        text += fmt::format("  at p: small, by parts over E_{} up to delta = {:.1f}; of q: beyond {:.1e}, interpolation {:.1e}, carried {:.1e}\n", n, q.cut, q.row.rule_error / v,
                            q.row.interpolation / v, q.row.carried / v);
    else text += fmt::format("  at p: {} points; of v: rule {:.1e}, interpolation {:.1e}, carried {:.1e}\n", q.nodes, q.row.rule_error / v, q.row.interpolation / v, q.row.carried / v);
    return text;
}

std::size_t Forward::memory() const
{
    const std::lock_guard lock(implementation_->mutex);
    std::size_t n = 0;
    const auto word = static_cast<std::size_t>(implementation_->precision / 8 + 40);
    for (const auto& [size, matrix] : implementation_->to_monomials) n += matrix.size() * word;
    for (const auto& level : implementation_->levels)
        if (level) n += level->nodes * (word + 24) + level->boxes.bound.size() * 8;
    for (const auto& [k, level] : implementation_->whole) n += level->nodes * (word + 24) + level->boxes.bound.size() * 8;
    return n;
}

// ---- kept levels

namespace {

constexpr std::size_t memory_limit = 300'000'000;

struct Kept {
    Law law;
    double accuracy;
    std::string G, load; ///< their balls: levels are valid for every pair in them
    std::shared_ptr<Forward> made;
};
std::mutex kept_mutex;
std::list<Kept> kept; // most recently used first

/// The balls of G and load that tell levels of this accuracy from others.
std::pair<std::string, std::string> told_apart(double accuracy, const Arguments& a)
{
    const WorkingPrecision precision(static_cast<slong>(accuracy * 1.5) + 80);
    return {a.G().dump(), a.load().dump()};
}

/// More accurate levels cost more a value: they serve where they are not much more accurate, as those of a neighbouring p are.
constexpr double most_spare = 100; // nats

std::atomic<long> made{0};

/// Levels of at least this accuracy: kept ones if there are any that serve, or else new ones.
std::shared_ptr<Forward> levels_for(Law law, double accuracy, const Arguments& a, const std::function<bool(double)>& serves)
{
    const std::lock_guard lock(kept_mutex);
    auto best = kept.end();
    for (auto it = kept.begin(); it != kept.end(); ++it) {
        if (it->law != law || it->accuracy < accuracy || it->accuracy > accuracy + most_spare) continue;
        if ((best != kept.end() && best->accuracy <= it->accuracy) || (it->accuracy > accuracy && !serves(it->accuracy))) continue;
        if (const auto [G, load] = told_apart(it->accuracy, a); it->G == G && it->load == load) best = it;
    }
    if (best != kept.end()) kept.splice(kept.begin(), kept, best);
    else {
        const auto [G, load] = told_apart(accuracy, a);
        kept.push_front({law, accuracy, G, load, std::make_shared<Forward>(law, a.G, a.load, accuracy)});
        ++made;
    }
    std::size_t held = 0, count = 0;
    for (auto it = kept.begin(); it != kept.end();) {
        held += it->made.use_count() > 1 ? 0 : it->made->memory(); // one in use elsewhere may be busy for long
        it = ++count > 4 && held > memory_limit ? kept.erase(it) : std::next(it);
    }
    return kept.front().made;
}

void require_proven(const Ball& G, const Ball& load)
{
    if (!certainly(less(Ball(2), G)) || !certainly(less(Ball(0), load)) || !(arb_is_one(load.get()) || certainly(less(load, Ball(1)))))
        throw BeyondReach("needs G > 2 and 0 < load <= 1");
}

/// Accuracies in use are few, so that levels are shared.
double accuracy_for(Accuracy wanted) { return 4 * std::ceil(std::max(30.0, static_cast<double>(bits_for_digits(wanted.digits) - 4) * std::numbers::ln2) / 4); }

/// That of the levels, of a law, which a value at distance d = log(p_n^max/p) needs: it loses some of it.
double accuracy_at(Law law, long n, double d, const Arguments& a, Accuracy wanted, bool for_density)
{
    const double accuracy = accuracy_for(wanted);
    if (law == Law::density) return accuracy;
    const double cancelling = 12 * (for_density ? std::max(1.0, std::ceil(d / 6)) : 1); // q_n ~ p, the slope of an exceedance ~ 1: 2d nats cancel
    const double small = for_density && n >= 2 ? accuracy_for_small(accuracy, n, d, a.G(), a.load()) : 0;
    return small > 0 ? small : accuracy + cancelling;
}

struct Asked {
    std::shared_ptr<Forward> levels;
    Ball p, d;
};

/// log(p_n^max/p), p_n^max = G^(n+1) e_{n+1}, log e_{k+1} = log(2/G) + log(e_k)/2
Ball distance_from_edge(long n, const std::function<Ball()>& p_at, const Arguments& a, slong bits)
{
    const WorkingPrecision precision(bits);
    const Ball G = a.G(), load = a.load();
    require_proven(G, load);
    Ball log_edge = log(load);
    for (long k = 0; k <= n; ++k) log_edge = log(2 / G) + log_edge / 2;
    return log_edge + (n + 1) * log(G) - log(p_at());
}

/// The same, once it is certainly > 0.
double positive_distance(long n, const std::function<Ball()>& p_at, const Arguments& a)
{
    for (slong bits = 128;; bits *= 2) {
        const Ball ball = distance_from_edge(n, p_at, a, bits);
        if (certainly(less(Ball(0), ball))) return about(ball);
        if (bits > 40'000) throw BeyondReach("p cannot be told from the upper edge of the support");
    }
}

Asked prepare(Law law, long n, const std::function<Ball()>& p_at, const Arguments& a, Accuracy wanted, bool for_density)
{
    require_binary64_arithmetic();
    const double d = positive_distance(n, p_at, a), accuracy = accuracy_at(law, n, d, a, wanted, for_density);
    if (accuracy > most_accuracy && accuracy_for(wanted) < most_accuracy - 100) throw BeyondReach("p is too small against the highest pressure for two laws to give the density");
    if (accuracy > most_accuracy) throw BeyondReach("so many digits of a distribution would cost too much");
    // the form for small p needs a p that is small for the levels, too
    const bool small = law == Law::exceedance && for_density && n >= 2 && accuracy_for_small(accuracy_for(wanted), n, d, a.G(), a.load()) > 0;
    const auto serves = [&](double levels) { return !small || 2 * d > cut_for_small(levels, n, a.G(), a.load()) + 1.02; };
    Asked asked{levels_for(law, accuracy, a, serves), {}, {}};
    const slong bits = asked.levels->bits();
    asked.d = distance_from_edge(n, p_at, a, bits + 40 + static_cast<slong>(std::max(0.0, -std::log2(d))));
    const WorkingPrecision precision(bits);
    asked.p = p_at();
    return asked;
}

} // namespace

long levels_made() { return made; }

Ball density(Law law, long n, const std::function<Ball()>& p, const Arguments& a, Accuracy wanted)
{
    const Asked asked = prepare(law, n, p, a, wanted, true);
    return asked.levels->density(n, asked.p, asked.d);
}

Ball exceedance(Law law, long n, const std::function<Ball()>& p, const Arguments& a, Accuracy wanted)
{
    const Asked asked = prepare(law, n, p, a, wanted, false);
    return asked.levels->exceedance(n, asked.d);
}

long most_digits_of_distribution(long n, const std::function<Ball()>& p, const Arguments& a, bool for_density)
{
    const WorkingPrecision precision(128);
    const double d = positive_distance(n, p, a);
    long least = 0, most = 400; // serves(least), not serves(most)
    while (most - least > 1) {
        const long middle = (least + most) / 2;
        (accuracy_at(Law::exceedance, n, d, a, {middle}, for_density) <= most_accuracy ? least : most) = middle;
    }
    return least;
}

static bool always(double) { return true; }

Ball force(Law law, long n, const Arguments& a, Accuracy wanted)
{
    require_proven(a.G(), a.load());
    return levels_for(law, accuracy_for(wanted) + (law == Law::exceedance ? 12 : 0), a, always)->force(n);
}

Ball mass(long n, const Arguments& a, Accuracy wanted)
{
    require_proven(a.G(), a.load());
    return levels_for(Law::density, accuracy_for(wanted), a, always)->mass(n);
}

std::string distribution_certificate(Law law, long n, const std::function<Ball()>& p, const Arguments& a, Accuracy wanted)
{
    const Asked asked = prepare(law, n, p, a, wanted, true);
    return asked.levels->certificate(n, asked.p, asked.d);
}

} // namespace touchstone::transfer
