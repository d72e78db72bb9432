// SPDX-License-Identifier: MIT
#include "touchstone/transfer/proven_levels.hpp"

#include "touchstone/scalar/refusal.hpp"
#include "touchstone/transfer/layer.hpp"
#include "touchstone/transfer/parallel.hpp"
#include "touchstone/transfer/progress.hpp"
#include "touchstone/transfer/two_waves.hpp"
#include "touchstone/transfer/wave_kernel.hpp"
#include "touchstone/transfer/wide_balls.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <list>
#include <mutex>

namespace touchstone::transfer {
namespace {

using std::max, std::min;

using namespace bounds;
using namespace levels;
constexpr int most_levels = ProvenLevels::levels;

/// The larger, and infinite where v is not a number: nothing is known then.
void raise(double& bound, double v) { bound = v <= infinite ? max(bound, v) : infinite; }

/// The rho of the Bernstein ellipse through focal sum 2(1 + d): what lies within d of [-1, 1] lies inside.
double ellipse_of_distance(double d) { return 1 + d + std::sqrt(d * (2 + d)); }

/// mu_x(J) = (T 1_J)(x) for any x and |J| = width: proven_levels.md (2)
double largest_share(double G, double width) { return std::sqrt(G * width / 2); }
/// T^2 1_J: proven_levels.md, 5
double largest_second_share(double G, double width)
{
    const double l = G * width;
    return min(largest_share(G, width), margin * l * (1 + 2 * std::sqrt(G) + std::sqrt(2 * G) / pi_below * max(0.0, std::log(1 / (2 * l)))));
}
constexpr double lowest_of_densities = 1e-35; // first panel
constexpr int most_intervals = 20'000; // of x, on one panel

// ---- B_0: the share of one wave in contact, or under a pressure above P; or the density after two waves

struct First {
    virtual ~First() = default;
    virtual bool is_area() const { return false; }
    /// Whether B_0, and B_m with it, increases from 0 to 1 and is at most x^(1/2). Else it need not be bounded.
    virtual bool is_share() const { return true; }
    /// B_0(x) and a bound of the error.
    virtual std::pair<Real, double> value(const Real& x) const = 0;
    struct Bounds {
        double value, complement; ///< of |B_0| and |1 - B_0|
    };
    /// On the disc of radius r about a real x, of the function that is B_0 on low <= x <= high; infinite if it may not be analytic there.
    virtual Bounds on_disc(const Real& low, const Real& high, const Real& x, double r) const = 0;
    /// What |B_0| + largest counts for on an interval of that width from x on, singular points and all (two_waves.hpp). Only if it is no share.
    virtual double weight_on(double, double, double) const { return infinite; }
};

/// A function known in balls.
struct Share : First {
    virtual Ball at(const Ball& x) const = 0;
    std::pair<Real, double> value(const Real& x) const override
    {
        const WorkingPrecision precision(160);
        const Ball b = at(to_ball(x));
        return {to_real(b), b.radius_bound() + 2 * u};
    }
};

/// D_1/unit: D_1 goes with P where P is small.
struct Density : First {
    Density(const Ball& G, const Ball& pressure, double unit_, double tolerance) : waves(G, pressure, tolerance * unit_), unit(unit_) {}
    bool is_share() const override { return false; }
    std::pair<Real, double> value(const Real& x) const override
    {
        const auto [v, error] = waves.value(x);
        return {v / unit, error / unit};
    }
    Bounds on_disc(const Real& low, const Real& high, const Real& x, double r) const override { return {waves.on_disc(low, high, x, r) / unit, infinite}; }
    double weight_on(double x, double width, double largest) const override { return waves.weight_on(x, width) / unit + largest; }
    TwoWaves waves;
    double unit; ///< a power of two
};

/// |arccos w| = |int_w^1 (1 - t^2)^(-1/2) dt| <= 2|1 - w|^(1/2) where Re w >= 0, along the straight line; so where |1 - w| <= 1.
double arccos_bound(double from_one) { return from_one <= 1 ? 2 * std::sqrt(from_one) : infinite; }

/// (2/pi) arcsin x^(1/2), 1 from x = 1 on.
struct InContact : Share {
    bool is_area() const override { return true; }
    Ball at(const Ball& x) const override { return certainly(less(x, Ball(1))) ? 2 * asin(sqrt(x)) / pi<Ball>() : Ball(1); }
    Bounds on_disc(const Real& low, const Real&, const Real& x, double r) const override
    {
        if (low >= 1) return {1, 0};
        const double x_ = double(x), to_one = double(1 - x);
        if (!(r * margin < to_one && r * margin < x_)) return {infinite, infinite};
        // |arcsin w| <= (pi/2)|w| where |w| <= 1, and |1 - x^(1/2)| <= |1 - x|
        return {margin * std::sqrt(x_ + r), margin * 2 / pi_below * arccos_bound(min(1.0, to_one + r))};
    }
};

/// (2.17), (2.14): the exceedance of one wave, (1/pi) arccos w, w = P - x where x >= 1, w = R - x, R^2 = (1 - x)^2 + P^2, where P^2/4 <= x < 1.
/// It is analytic between low_end, 1 and high_end; from the left of 1 so far as R is. w is real for real x only: x = (1 + P^2 - w^2)/(2(1 + w)).
struct Exceeding : Share {
    explicit Exceeding(const Ball& P_)
        : P(P_), low_end(certainly(less(P_, Ball(2))) ? to_real(P_ * P_ / 4) : to_real(P_ - Ball(1))), high_end(to_real(P_ + Ball(1)))
    {
    }
    Ball at(const Ball& x) const override
    {
        const auto full = [&] { return share(1 + x - P, 1 - x + P); };
        if (!certainly(less(x, Ball(1)))) return full(); // the two agree at 1
        const Ball R = sqrt((1 - x) * (1 - x) + P * P);
        return share((4 * x - P * P) / (1 + x + R), 1 - x + R);
    }
    Bounds on_disc(const Real& low, const Real& high, const Real& x, double r) const override
    {
        constexpr Bounds nothing{0, 1}, everything{1, 0}, unknown{infinite, infinite};
        const double pressure = double(to_real(P)), from_low = double(x - low_end), to_high = double(high_end - x), to_one = double(1 - x), safe = r * margin;
        if (high <= low_end * Real{1, -4 * u}) return nothing;
        if (low >= high_end * Real{1, 4 * u}) return everything;
        if (!(safe < from_low)) return unknown;
        // |arccos w|^2 <= pi^2 + log^2(2|w| + 2)
        const auto either = [](double modulus, double other) { return margin * min(std::hypot(pi_below, std::log(2 * modulus + 2)), other) / pi_below; };
        if (low >= 1) {
            if (!(safe < to_high)) return unknown;
            const double w = std::fabs(pressure - double(x)) + r;
            return {either(w, arccos_bound(margin * (double(x + 1 - to_real(P)) + r))), either(w, arccos_bound(margin * (to_high + r)))};
        }
        if (high > 1 || !(safe < double(x)) || !(safe < std::hypot(to_one, pressure))) return unknown;
        const double w = std::fabs(to_one) + pressure + double(x) + 2 * r; // |1 - w| = |4x - P^2|/|1 + x + R|, the denominator above 1
        return {either(w, arccos_bound(margin * 4 * (from_low + r))), either(w, infinite)};
    }

private:
    Ball share(const Ball& one_minus_w, const Ball& one_plus_w) const
    {
        Ball sine, cosine;
        arb_sqrtpos(sine.get(), one_minus_w.get(), WorkingPrecision::bits());
        arb_sqrtpos(cosine.get(), one_plus_w.get(), WorkingPrecision::bits());
        if (certainly(less(one_minus_w, Ball(0)))) return Ball(0);
        return 2 * atan2(sine, cosine) / pi<Ball>();
    }
    Ball P;
    Real low_end, high_end; ///< below the one it is 0, from the other on 1; within 2 u
};

struct Check { ///< Chebyshev points of an interval inside a disc whose radius is (rho + 1/rho)/2 of its half width
    double rho, spread, tail, lebesgue;
    ChebyshevPoints points;
    /// |f| <= lebesgue max |f at the points| + tail K where |f| <= K on the ellipse, the points moved by rounding: md, 4
    Check(int count, double rho_)
        : rho(rho_), spread((rho + 1 / rho) / 2 * margin), tail(0), lebesgue(1.01 * (1 + 2 / pi_below * std::log(count))), points(count)
    {
        tail = margin * 2 * (1 + lebesgue) / (power(rho, count - 1) * (rho - 1));
    }
};

} // namespace

struct ProvenLevels::State {
    Real G;
    double tolerance;
    int levels;  ///< V_0 ... V_(levels-1)
    int columns; ///< of every array: `levels`, made a multiple of four for the sums in wave_kernel.hpp, where it is not 1
    std::unique_ptr<const First> first;
    Orders orders;
    Gauss gauss, exact;
    ChebyshevPoints own, kernel_points;
    std::vector<Check> checks;
    Check first_check; ///< of B_0, whose bound on a disc may be far above its size
    std::unique_ptr<Layer> all;
    std::vector<double> defect;          ///< [panel * columns + m]: at least |T V_{m-1} - V_m|, resp. |B_0 - V_0|
    std::vector<double> sum_of_effects;  ///< [m]: at least T |B_m - V_m|

    State(Real G_, std::unique_ptr<const First> first_, double highest, double tolerance_, const Spoiled& spoiled, int scales)
        : G(G_), tolerance(tolerance_), levels(min(most_levels, scales)), columns(levels == 1 ? 1 : (levels + 3) / 4 * 4), first(std::move(first_)), orders(tolerance_), gauss(orders.gauss), exact(orders.terms), own(orders.terms), kernel_points(orders.kernel), first_check(orders.terms + (first->is_share() ? 7 : 19), 4)
    {
        for (const auto& [share, rho] : {std::pair{0.3, 64.0}, {0.45, 24.0}, {0.65, 10.0}, {1.0, 4.0}}) checks.emplace_back(static_cast<int>(orders.terms * share) + 7, rho);
        collocate(highest, spoiled);
        prove();
    }

    struct Series {
        std::vector<Panel> panels;
        Wide coefficients; ///< [panel * terms + k]
    };
    /// Halves panels of `on` until f, a function of z, is resolved on each of them.
    template <class F>
    Series resolve(std::vector<Panel> on, const F& f, int m) const;
    /// The coefficients of the polynomials through f at the nodes of the panels.
    template <class F>
    Wide interpolate(const std::vector<Panel>& panels, const F& f) const;
    void collocate(double highest, const Spoiled&);
    void prove();
    void prove_first(std::size_t i, const Real& left, const Real& right);
    void prove_panel(std::size_t i, const std::vector<double>& overlap_defect, std::vector<char>& by_monotony);
    /// Bounds T D_m on all x from which no ratio above `reach` is met.
    double effect(int m, double reach) const;
    /// Bounds T^2 D_0, where no ratio above `reach` is met.
    double second_effect(double reach) const;
    /// Bounds T D_0 at the x between low and high.
    double effect_at(const Real& low, const Real& high) const;
    /// Bounds what T V_m changes by between x (1 - 4 u) and x (1 + 4 u).
    double blur(int m, const Real& x) const;

    /// Where |B_m - T V_(m-1)| is not bounded by `defect`. In all else a panel.
    struct Hole {
        Real low, high;
        double width, defect;
        bool on_average; ///< defect is no bound, but what counts for one
    };
    std::vector<Hole> holes[most_levels];
    std::mutex holes_mutex;
    void add_hole(int m, const Real& low, const Real& high, double defect_, bool on_average = false)
    {
        const std::lock_guard lock(holes_mutex);
        holes[m].push_back({low, high, double(high - low) * margin + 4 * u * double(high), defect_ <= infinite ? defect_ : infinite, on_average});
    }
    /// What is known on a part of a panel: of densities, what is large is kept apart, for the part may be much narrower.
    void found(int m, const Real& low, const Real& high, double panel_width, double& of_panel, double defect_)
    {
        if (!first->is_share() && defect_ > tolerance / 16 && double(high - low) < 0.3 * panel_width) add_hole(m, low, high, defect_);
        else raise(of_panel, defect_);
    }
    struct Part {
        double defect, width;
        Real y0, y1;
        bool on_average;
    };
    /// The panels and holes of level m up to `reach`, the largest defects first.
    std::vector<Part> parts(int m, double reach) const;
};

// ---- V_0 ... V_19

template <class F>
Wide ProvenLevels::State::interpolate(const std::vector<Panel>& panels, const F& f) const
{
    const std::size_t terms = static_cast<std::size_t>(orders.terms);
    Wide nodal(panels.size() * terms), series(nodal.size());
    in_parallel(nodal.size(), [&](std::size_t r) {
        const Panel& p = panels[r / terms];
        nodal.set(r, f(p.centre + p.half * own.at[r % terms]));
    });
    in_parallel(panels.size(), [&](std::size_t j) {
        Wide here(terms);
        for (std::size_t i = 0; i < terms; ++i) here.set(i, nodal[j * terms + i]);
        for (std::size_t k = 0; k < terms; ++k) series.set(j * terms + k, dot(own.T, k * terms, here) * (k == 0 ? 1 : 2) / orders.terms);
    });
    return series;
}

template <class F>
ProvenLevels::State::Series ProvenLevels::State::resolve(std::vector<Panel> on, const F& f, int m) const
{
    constexpr std::size_t most = 30'000;
    const std::size_t terms = static_cast<std::size_t>(orders.terms);
    const Real lowest = on.front().z0;
    std::vector<std::pair<Panel, std::vector<Real>>> done;
    while (!on.empty()) {
        const Wide series = interpolate(on, f);
        std::vector<Panel> halves;
        for (std::size_t j = 0; j < on.size(); ++j) {
            const auto c = [&](std::size_t k) { return std::fabs(series.high[j * terms + k]); };
            const double left = 4 * max({c(terms - 1), c(terms - 2), c(terms - 3)}), width = on[j].width();
            const bool unbounded = !first->is_share() && m == 0, resolved = left <= tolerance * max(c(0), 1e-6);
            bool negligible = left * largest_share(double(G), width) <= tolerance / 1024; // the narrow ones are many
            if (unbounded) { // a constant will do there
                double change = 0;
                for (std::size_t k = 1; k < terms; ++k) change += c(k);
                negligible = change * largest_second_share(double(G), width) <= tolerance / 1024;
            }
            if (resolved || negligible || width <= 8 * narrowest * double(on[j].y1)) {
                done.emplace_back(on[j], std::vector<Real>());
                for (std::size_t k = 0; k < terms; ++k) done.back().second.push_back(unbounded && !resolved && k > 0 ? Real(0) : series[j * terms + k]);
                continue;
            }
            const Real &z0 = on[j].z0, &z1 = on[j].z1, middle = (z0 + z1) * 0.5;
            halves.push_back(panel(z0, middle, z0 == lowest));
            halves.push_back(panel(middle, z1, false));
        }
        if (done.size() + halves.size() > most) throw BeyondReach("the mesh would be too large");
        on = std::move(halves);
    }
    std::sort(done.begin(), done.end(), [](const auto& a, const auto& b) { return a.first.z0 < b.first.z0; });
    Series result{{}, Wide(done.size() * terms)};
    for (const auto& [p, c] : done) {
        for (std::size_t k = 0; k < terms; ++k) result.coefficients.set(result.panels.size() * terms + k, c[k]);
        result.panels.push_back(p);
    }
    return result;
}

void ProvenLevels::State::collocate(double highest, const Spoiled& spoiled)
{
    std::vector<Panel> start;
    for (Real y = first->is_share() ? tolerance / 10 : lowest_of_densities; y < highest;) {
        const Real next = y * (1 + min(0.6, 0.35 / double(y)));
        start.push_back(panel(y * y, next * next, start.empty()));
        y = next;
    }
    std::vector<Series> found;
    found.push_back(resolve(start, [&](const Real& z) {
        return first->value(sqrt(z)).first;
    }, 0));
    for (int m = 1; m < levels; ++m) {
        progress("mesh, level", m, levels);
        Layer before(orders, gauss, kernel_points, exact, G, tolerance, found.back().panels, 1);
        before.set(0, found.back().coefficients);
        found.push_back(resolve(found.back().panels, [&](const Real& z) {
            thread_local Result result;
            before.apply(sqrt(z), result);
            return result.value[0];
        }, m));
    }
    all = std::make_unique<Layer>(orders, gauss, kernel_points, exact, G, tolerance, found.back().panels, columns);
    for (int m = 0; m < levels; ++m) { // on the last mesh, of which each panel is a part of one of each earlier mesh
        Layer on(orders, gauss, kernel_points, exact, G, tolerance, std::move(found[m].panels), 1);
        on.coefficients = std::move(found[m].coefficients);
        std::size_t parent = 0;
        std::vector<int> parents;
        for (const Panel& p : all->panels) {
            while (parent + 1 < on.panels.size() && on.panels[parent + 1].z0 <= p.z0) ++parent;
            parents.push_back(static_cast<int>(parent));
        }
        const std::size_t terms = static_cast<std::size_t>(orders.terms);
        Wide series(all->panels.size() * terms);
        in_parallel(all->panels.size(), [&](std::size_t j) {
            const Panel &p = all->panels[j], &of = on.panels[parents[j]];
            Wide here(terms);
            for (std::size_t i = 0; i < terms; ++i) here.set(i, on.value(parents[j], 0, (p.centre + p.half * own.at[i] - of.centre) / of.half));
            for (std::size_t k = 0; k < terms; ++k) series.set(j * terms + k, dot(own.T, k * terms, here) * (k == 0 ? 1 : 2) / orders.terms);
        });
        if (spoiled)
            for (std::size_t j = 0; j < all->panels.size(); ++j) {
                const Panel& p = all->panels[j];
                series.set(j * terms, series[j * terms] + spoiled(m, double(p.y0), double(p.y1)));
            }
        all->set(m, series);
    }
    defect.resize(all->panels.size() * columns);
}

// ---- the proof

/// |B_0 - V_0| on left <= x <= right, a part of panel i.
void ProvenLevels::State::prove_first(std::size_t i, const Real& left, const Real& right)
{
    const Panel& p = all->panels[i];
    const double rounding = all->rounding[i * columns], half_z = double(p.half), width = size_of(right - left);
    const Check& check = first_check;
    const WorkingPrecision precision(160);
    double& D = defect[i * columns];
    const double negligible = first->is_share() ? 0 : tolerance / 1024 / largest_second_share(double(G), width);
    int intervals = 0;
    std::vector<std::pair<Real, Real>> waiting{{left, right}};
    while (!waiting.empty()) {
        if (++intervals > most_intervals) D = infinite; // nothing is certified with this, nor runs for ever
        if (!(D < infinite)) return;
        const auto [low, high] = waiting.back();
        waiting.pop_back();
        const Real x = (low + high) * 0.5, half = (high - low) * (0.5 + 0x1p-30) + 2 * u * x;
        const bool share = first->is_share();
        const double x_ = double(x), h = size_of(half), r = h * check.spread, small = max(share ? 1e-6 * width : 0, 2 * narrowest * x_);
        if (low < 1 && high > 1) { // what is on either side need not be one analytic function
            waiting.emplace_back(low, Real(1));
            waiting.emplace_back(Real(1), high);
            continue;
        }
        const auto local = [&](const Real& v) { return (v * v - p.centre) / p.half; };
        const auto value = [&](const Real& v) { return first->value(v); };
        const auto [of_value, of_complement] = first->on_disc(low, high, x, r);
        const double rho = ellipse_of_distance((2 * x_ * r + r * r) / half_z), from_one = size_of(all->coefficients[all->row(i, 0)] - 1);
        const double bound = margin * min(of_value + all->growth_at(i, 0, rho), of_complement + from_one + all->growth_at(i, 0, rho, 1)) * check.tail;
        double most = infinite;
        if (bound <= (h > small || !share ? max(tolerance / 16, negligible) : infinite) && bound < infinite && h >= narrowest * x_) {
            most = 0;
            for (std::size_t n = 0; n < check.points.at.size() && most < infinite; ++n) {
                const Real at = x + half * check.points.at[n];
                const auto [v, error] = value(at);
                raise(most, size_of(v - all->value(i, 0, local(at))) + error);
            }
        }
        if (most < infinite) found(0, low, high, width, D, margin * (check.lebesgue * (most + 2 * rounding) + bound));
        else if (h > small) {
            waiting.emplace_back(low, x);
            waiting.emplace_back(x, high);
        }
        else if (!share) add_hole(0, low, high, first->weight_on(double(low), double(high - low), all->size[i * columns]), true);
        else { // increasing, between its ends
            double change = 0;
            for (int k = 1; k < orders.terms; ++k) change += all->magnitude(i, k, 0) * k * k;
            change = margin * min(change * double(high * high - low * low) / half_z, 2 * all->size[i * columns]);
            const Real v = all->value(i, 0, local(low));
            const auto [least, least_error] = value(low * Real{1, -4 * u});
            const auto [most, most_error] = value(high * Real{1, 4 * u});
            raise(D, margin * (size_of(most - v) + size_of(v - least) + least_error + most_error + change + 2 * rounding));
        }
    }
}

void ProvenLevels::State::prove_panel(std::size_t i, const std::vector<double>& overlap_defect, std::vector<char>& by_monotony)
{
    const auto& panels = all->panels;
    const auto& rounding = all->rounding;
    const auto at = [this](std::size_t panel, int m) { return panel * columns + m; };
    const Panel& p = panels[i];
    const int terms = orders.terms;
    double* D = &defect[at(i, 0)];
    const double half_z = double(p.half);
    struct End {
        int panel = -1;
        double factor = 0, distance = 0, outside = 0;
    };
    // the polynomial to use where the kernel ends at z, and the edge where it takes over
    const auto end_panel = [&](const Real& z, bool upper) {
        int j = all->find(z);
        const int last = static_cast<int>(panels.size()) - 1;
        if (upper && j > 0 && z - panels[j].z0 < (panels[j - 1].right() - panels[j - 1].z1) * 0.5) --j;
        if (!upper && j < last && panels[j].z1 - z < (panels[j + 1].z0 - panels[j + 1].left()) * 0.5) ++j;
        return j;
    };
    const double g = double(G);
    const Real slack = (p.y1 - p.y0) * 1e-3, left = max(sqrt(p.left()), p.y0 - slack), right = p.y1 + slack;
    const double width = size_of(right - left);
    prove_first(i, left, right);
    if (levels == 1) return;
    int intervals = 0;
    std::vector<std::pair<Real, Real>> waiting{{left, right}};
    Result here, a, b;
    while (!waiting.empty()) {
        if (!first->is_share() && ++intervals > most_intervals) {
            std::fill(D, D + columns, infinite);
            return;
        }
        const auto [low, high] = waiting.back();
        waiting.pop_back();
        const Real x = (low + high) * 0.5, half = (high - low) * (0.5 + 0x1p-30) + 2 * u * x;
        const double x_ = double(x), h = size_of(half), above_one = double(x - 1);
        const bool seam = low < 1 && high > 1, share = first->is_share();
        if (seam && !share) {
            waiting.emplace_back(low, Real(1));
            waiting.emplace_back(Real(1), high);
            continue;
        }
        bool hopeless = false; // halving would not help
        End ends[2];
        double middle = 0;
        const auto analytic = [&](double r) {
            if (seam) return false;
            if (above_one >= 0) {
                if (above_one <= r * margin) return false;
                for (const bool upper : {false, true}) {
                    const auto image = [&](const Real& v) { return (upper ? v + 1 : v - 1) / G; };
                    const Real y = image(x), y_low = image(low), y_high = image(high);
                    if (y < panels.front().y0 * 1.3) {
                        hopeless = true;
                        return false;
                    }
                    const int e = end_panel(y * y, upper);
                    const Panel& q = panels[e];
                    const Real inner = upper ? max(q.y0, y - 0.8 / G) : min(q.y1, y + 0.8 / G); // any point of the panel will do
                    const double gap = double(upper ? 1 + x - G * inner : G * inner - x + 1);
                    if (r > 0.79 * gap || gap > 0.9 || y_low * y_low < q.left() * Real{1, 8 * u} || y_high * y_high > q.right() * Real{1, -8 * u}) return false;
                    ends[upper] = {e, std::sqrt(1.8 * gap) * 2 / std::sqrt(2 - 1.8 * gap) / pi_below, (2 * double(max(y, inner)) * r + r * r / g) / g / double(q.half),
                                   std::sqrt(g * max(0.0, double(upper ? sqrt(q.right()) - q.y1 : q.y0 - sqrt(max(Real(0), q.left())))) / 2)};
                }
                middle = 5;
            }
            else {
                if (r > -0.24 * above_one || r > 0.5 * x_) return false;
                const Real y2 = 4 * x / (G * G);
                if (y2 < panels.front().z0 * 1.7) {
                    hopeless = true;
                    return false;
                }
                const int e = end_panel(y2, true);
                const Panel& q = panels[e];
                const Kernel k(x, G, false);
                const Real at_gap = positive_part((2 - Real(0.8)) * (2 * x - 0.8)) / k.G2; // 1 - c = 0.8
                const double gap = double(k.one_minus_c(max(q.z0, at_gap))), dc = 2.36 * r;
                if (dc > 0.79 * gap || gap > 0.9 || 4 * low / k.G2 < q.left() * Real{1, 8 * u} || 4 * high / k.G2 > q.right() * Real{1, -8 * u}) return false;
                ends[1] = {e, std::sqrt(1.8 * gap) * 2 / std::sqrt(2 - 1.8 * gap) / pi_below,
                           (2 * (2 * r + dc) + 2 * x_ * dc + dc * (2 * r + dc)) / (g * g) / double(q.half), std::sqrt(g * max(0.0, double(sqrt(q.right()) - q.y1)) / 2)};
                middle = 4.1;
            }
            return true;
        };
        double bounds[most_levels];
        const double small = max(share ? 1e-6 * width : 0, 2 * narrowest * x_);
        const Check* check = nullptr;
        for (const Check& c : checks) { // the fewest points first
            const double r = h * c.spread;
            if (h < narrowest * x_ || !analytic(r)) continue;
            const double own_rho = ellipse_of_distance((2 * x_ * r + r * r) / half_z);
            bool enough = true;
            for (int m = 1; m < levels && enough; ++m) {
                double bound = all->growth_at(i, m, own_rho) + middle * all->largest[m - 1];
                for (const End& e : ends)
                    if (e.panel >= 0) bound += e.factor * all->growth_at(e.panel, m - 1, ellipse_of_distance(e.distance));
                bounds[m] = margin * bound * c.tail;
                enough = bounds[m] <= tolerance / 4 || (share && h <= 100 * small && &c == &checks.back() && bounds[m] < infinite);
            }
            if (enough) {
                check = &c;
                break;
            }
        }
        if (!check && h > small && !(hopeless && h < 0.02 * width)) {
            waiting.emplace_back(low, x);
            waiting.emplace_back(x, high);
            continue;
        }
        if (!check && !share) { // T V at the middle, and what two laws mu_x of ratios, a distance h apart, may differ by
            all->apply(x, here);
            for (int m = 1; m < levels; ++m) {
                double slope = 0;
                for (int k = 1; k < terms; ++k) slope += all->magnitude(i, k, m) * k * k;
                const double change = min(slope * double(high * high - low * low) / half_z, 2 * all->size[at(i, m)]);
                const Real v = all->value(i, m, (x * x - p.centre) / p.half);
                add_hole(m, low, high, margin * (size_of(here.value[m - 1] - v) + here.error[m - 1] + change + 2 * rounding[at(i, m)] + std::sqrt(32 * h) * all->largest[m - 1]));
            }
            continue;
        }
        if (!check) { // B_m is increasing: between its values at the ends
            by_monotony[i] = 1;
            all->apply(low * Real{1, -4 * u}, a);
            all->apply(high * Real{1, 4 * u}, b);
            for (int m = 1; m < levels; ++m) {
                double slope = 0;
                for (int k = 1; k < terms; ++k) slope += all->magnitude(i, k, m) * k * k;
                const double change = margin * min(slope * double(high * high - low * low) / half_z, 2 * all->size[at(i, m)]);
                const Real v = all->value(i, m, (low * low - p.centre) / p.half);
                const double off = size_of(b.value[m - 1] - v) + size_of(v - a.value[m - 1]);
                raise(D[m], margin * (off + change + a.error[m - 1] + b.error[m - 1] + 2 * rounding[at(i, m)]));
            }
            continue;
        }
        double most[most_levels] = {};
        for (std::size_t n = 0; n < check->points.at.size(); ++n) {
            const Real at_x = x + half * check->points.at[n], local = (at_x * at_x - p.centre) / p.half;
            all->apply(at_x, here);
            all->values(i, local, a);
            for (int m = 1; m < levels; ++m) {
                const double difference = size_of(here.value[m - 1] - a.value[m]) + here.error[m - 1] + 2 * rounding[at(i, m)];
                raise(most[m], difference);
            }
        }
        for (int m = 1; m < levels; ++m) {
            double outside = 0;
            for (const End& e : ends)
                if (e.panel >= 0) outside += e.outside * overlap_defect[at(e.panel, m - 1)];
            found(m, low, high, width, D[m], margin * (check->lebesgue * (most[m] + outside) + outside + bounds[m]));
        }
    }
}

void ProvenLevels::State::prove()
{
    // how far the polynomial of a panel is from its neighbours' on their side of the edge: polynomials of terms - 1, so nodes suffice
    const auto& panels = all->panels;
    std::vector<double> overlap_defect(panels.size() * columns);
    const auto at = [this](std::size_t panel, int m) { return panel * columns + m; };
    const double lebesgue = 1.01 * (1 + 2 / pi_below * std::log(orders.terms));
    const int count = static_cast<int>(panels.size());
    in_parallel(panels.size(), [&](std::size_t e) {
        const Panel& p = panels[e];
        for (const int step : {-1, 1})
            for (int n = static_cast<int>(e) + step; n >= 0 && n < count; n += step) {
                Real low = max(p.left(), panels[n].z0), high = min(p.right(), panels[n].z1);
                if (!(high > low)) break;
                const Real short_of = 2 * narrowest * high - (high - low); // no narrower than points can be told apart
                if (short_of > 0) low -= short_of * 0.5, high += short_of * 0.5;
                for (int m = 0; m < levels; ++m) {
                    double most = 0;
                    for (std::size_t i = 0; i < own.at.size(); ++i) {
                        const Real z = (low + high) * 0.5 + (high - low) * 0.5 * own.at[i];
                        raise(most, size_of(all->value(e, m, (z - p.centre) / p.half) - all->value(n, m, (z - panels[n].centre) / panels[n].half)));
                    }
                    most += all->rounding[at(e, m)] + all->rounding[at(n, m)];
                    raise(overlap_defect[at(e, m)], margin * lebesgue * most);
                }
            }
    });
    std::vector<char> by_monotony(panels.size());
    std::atomic<long> proven{0};
    in_parallel(panels.size(), [&](std::size_t i) {
        prove_panel(i, overlap_defect, by_monotony);
        progress("proof, panel", ++proven, count);
    });
    // where monotony of B_m was used, T V_{m-1} stood for T B_{m-1}
    double so_far = 0;
    for (int m = 0; m < levels; ++m) {
        if (m > 0)
            for (std::size_t i = 0; i < panels.size(); ++i)
                if (by_monotony[i]) defect[at(i, m)] += margin * so_far;
        sum_of_effects.push_back(so_far); // of the levels before m, for effect(m)
        sum_of_effects.back() = so_far += effect(m, infinite);
    }
}

std::vector<ProvenLevels::State::Part> ProvenLevels::State::parts(int m, double reach) const
{
    const auto& panels = all->panels;
    std::vector<Part> found;
    for (std::size_t i = 0; i < panels.size() && double(panels[i].y0) <= reach; ++i)
        found.push_back({defect[i * columns + m], panels[i].width() + 4 * u * double(panels[i].y1), panels[i].y0, panels[i].y1, false});
    for (const Hole& h : holes[m])
        if (double(h.low) <= reach) found.push_back({h.defect, h.width, h.low * Real{1, -2 * u}, h.high * Real{1, 2 * u}, h.on_average});
    std::sort(found.begin(), found.end(), [](const Part& a, const Part& b) { return a.defect > b.defect; });
    return found;
}

/// The least of d + sum over the parts with a defect above d, and those known on average only, of that times their weight.
template <class Parts, class Weight>
static double least_sum(const Parts& parts, const Weight& weight)
{
    double rest = 0; // of those known on average
    for (const auto& p : parts)
        if (p.on_average) rest += p.defect * weight(p);
    double best = infinite, above = 0;
    for (const auto& p : parts) {
        best = min(best, above + p.defect + rest);
        if (!p.on_average) above += p.defect * weight(p);
    }
    return min(best, above + rest);
}

double ProvenLevels::State::effect(int m, double reach) const
{
    // T D <= d + sum over the parts with D > d of D times the largest share of theta a part can have
    const double best = least_sum(parts(m, reach), [&](const Part& p) { return largest_share(margin * double(G), p.width); });
    const double y = double(all->panels.front().y0); // below it V = 0
    double below;
    if (!first->is_share()) below = m == 0 ? 0 : margin * (std::sqrt(y) * all->largest[m - 1] + sum_of_effects[m - 1]); // B_m = T B_{m-1}, T 1 <= x^(1/2)
    // B_m(x) <= B_m(y) <= B_0(y) <= y^(1/2)
    else below = m == 0 ? std::sqrt(y) : min(std::sqrt(y), margin * (all->size[m] + defect[m] + sum_of_effects[m - 1]));
    return margin * (best + below * largest_share(double(G), y));
}

double ProvenLevels::State::second_effect(double reach) const
{
    return margin * least_sum(parts(0, reach), [&](const Part& p) { return largest_second_share(margin * double(G), p.width); });
}

/// At least mu_x([y0, y1]) for low <= x <= high, on one side of 1.
static double share_of(const Real& G, const Real& low, const Real& high, const Real& y0, const Real& y1)
{
    const bool full = low >= 1;
    if (!full && high > 1) return infinite; // the two sides of 1 are not compared
    const Kernel a(high, G, full), b(low, G, full); // c falls with x and rises with y
    const double slack = 64 * u * (1 + double(high)), width = double(y1 - y0) * margin + slack;
    if (full ? double(G * y0 - 1 - high) > slack || double(low - 1 - G * y1) > slack : double(y0 * y0 / a.end - 1) > slack) return 0;
    const double g = double(G), any = largest_share(g, width);
    const double to_end = double(b.one_minus_c(y1 * y1)) - slack, to_begin = double(a.one_plus_c(y0 * y0)) - slack;
    if (!(to_end > 0 && to_begin > 0)) return any;
    return min(any, margin * g * width / (pi_below * std::sqrt(min(to_end, 1.0) * min(to_begin, 1.0))));
}

double ProvenLevels::State::effect_at(const Real& low, const Real& high) const
{
    return margin * least_sum(parts(0, infinite), [&](const Part& p) { return share_of(G, low, high, p.y0, p.y1); });
}

double ProvenLevels::State::blur(int m, const Real& x) const
{
    // theta kept, z G^2 = (x + c)^2, resp. (1 + c)(2x - 1 + c), moves by less than 5 u x (1 + x); an edge that moves by dz loses the jump of V on a share
    const Real low = x * Real{1, -4 * u}, high = x * Real{1, 4 * u};
    const double x_ = double(x), dz = 40 * u * x_ * (1 + x_) / (double(G) * double(G));
    double sum = 0;
    for (std::size_t i = 0; i < all->panels.size(); ++i) {
        const Panel& p = all->panels[i];
        const double share = share_of(G, low, high, p.y0, p.y1);
        if (share == 0) continue;
        double slope = 0;
        for (int k = 1; k < orders.terms; ++k) slope += all->magnitude(i, k, m) * k * k;
        const double dy = min(std::sqrt(dz), dz / double(p.y0));
        sum += share * min(slope * dz / double(p.half), 2 * all->size[i * columns + m])
             + all->jump[i * columns + m] * share_of(G, low, high, p.y0 - Real(dy), p.y0 + Real(dy));
    }
    return margin * sum;
}

// ---- values

static std::unique_ptr<ProvenLevels::State> made(const Ball& G, std::unique_ptr<const First> first, double highest, double tolerance, const ProvenLevels::Spoiled& spoiled, int scales)
{
    require_binary64_arithmetic();
    if (!(tolerance >= 1e-25 && tolerance <= 1e-5)) throw std::invalid_argument("tolerance from 1e-25 to 1e-5");
    const WorkingPrecision precision(256);
    const Real nearest = to_real(G);
    const Ball off = abs(to_ball(nearest) / G - Ball(1));
    if (!certainly(less(Ball(1), G)) || !certainly(less(off, Ball::exactly(u)))) throw BeyondReach("G must be above 1 and known to 101 bits");
    const double top = max(highest, 1.1 / double(nearest - 1)); // so that (x + 1)/G stays below
    if (!(top <= 400)) throw BeyondReach("G too near 1, or the load too high, for the proven levels");
    return std::make_unique<ProvenLevels::State>(nearest, std::move(first), top * 1.01, tolerance, spoiled, scales);
}

ProvenLevels::ProvenLevels(const Ball& G, double highest, double tolerance, const Spoiled& spoiled)
    : state_(made(G, std::make_unique<InContact>(), highest, tolerance, spoiled, most_levels))
{
}
ProvenLevels::ProvenLevels(const Ball& G, const Ball& pressure, double highest, double tolerance, int scales, const Spoiled& spoiled)
{
    const WorkingPrecision precision(256);
    const Real nearest = to_real(pressure);
    if (!certainly(less(Ball(0), pressure)) || !certainly(less(abs(to_ball(nearest) / pressure - Ball(1)), Ball::exactly(u))))
        throw BeyondReach("the pressure must be above 0 and known to 101 bits");
    state_ = made(G, std::make_unique<Exceeding>(pressure), highest, tolerance, spoiled, scales);
}
ProvenLevels ProvenLevels::densities(const Ball& G, const Ball& pressure, double highest, double tolerance, int scales, const Spoiled& spoiled)
{
    const Ball nearest = to_ball(to_real(pressure));
    if (!certainly(less(Ball(0), pressure)) || !certainly(less(abs(nearest / pressure - Ball(1)), Ball::exactly(u))))
        throw BeyondReach("the pressure must be above 0 and known to 101 bits");
    ProvenLevels result;
    result.unit_ = std::min(1.0, std::exp2(std::floor(std::log2(double(to_real(pressure))))));
    auto first = std::make_unique<Density>(G, pressure, result.unit_, tolerance / 64);
    if (!(first->waves.lowest() > 2 * lowest_of_densities && result.unit_ >= 0x1p-10)) throw BeyondReach("the pressure is too low for the proven levels of densities"); // minutes and more
    result.state_ = made(G, std::move(first), highest, tolerance, spoiled, scales);
    return result;
}
ProvenLevels::ProvenLevels() = default;
ProvenLevels::~ProvenLevels() = default;
ProvenLevels::ProvenLevels(ProvenLevels&&) noexcept = default;

const levels::Layer& ProvenLevels::layer() const { return *state_->all; }
std::size_t ProvenLevels::memory() const { return (state_->all->coefficients.size() + state_->all->weights.size()) * 2 * sizeof(double) * 5 / 4; }

namespace {
struct Contribution {
    int level;
    double effect, weight;
};
} // namespace

static Ball share_and_budget(const ProvenLevels::State& s, long n, const Ball& load, std::vector<Contribution>* budget)
{
    require_binary64_arithmetic();
    const int levels = s.levels;
    if (n < 1 || n > levels) throw BeyondReach(fmt::format("proven levels: n from 1 to {}", levels));
    const WorkingPrecision precision(256);
    const Real x = to_real(load), low = x * Real{1, -4 * u}, high = x * Real{1, 4 * u};
    if (!certainly(less(to_ball(low), load)) || !certainly(less(load, to_ball(high)))) throw BeyondReach("load not known to 101 bits");
    const double top = double(high) * (1 + 0x1p-50), g = double(s.G) * (1 - 0x1p-50);
    std::vector<double> reach{top};
    for (int k = 0; k <= levels; ++k)
        reach.push_back((reach.back() < 1 ? 2 * std::sqrt(reach.back()) / g : (reach.back() + 1) / g) * (1 + 0x1p-50));
    const bool share = s.first->is_share(), exact = (to_ball(x) - load).is_exact() && (to_ball(x) - load).contains_zero();
    Result below, above;
    s.all->apply(share ? low : x, below);
    s.all->apply(share ? high : x, above);
    // T^k 1 <= c x^a: by Hoelder's inequality T x^a <= (T x)^a (T 1)^(1-a) <= (x/G)^a x^((1-a)/2)
    std::vector<double> at_most{1};
    for (double k = 1, c = 1, a = 0.5; k <= levels; ++k, c /= std::pow(g, a), a = (1 + a) / 2) at_most.push_back(min(at_most.back(), margin * c * std::pow(top, a)));
    Ball result;
    for (int scale = 1; scale <= n; ++scale) { // B_scale = T B_{scale-1} (load), error sum_m T^{scale-m} D_m
        double lost = 0;
        if (budget) budget->clear();
        for (int m = 0; m < scale; ++m) {
            double effect, weight = at_most[scale - m - 1];
            if (share || m > 0) effect = s.effect(m, reach[scale - m]);
            else if (scale == 1) effect = exact ? s.effect_at(x, x) : s.effect_at(low, high);
            else {
                effect = s.second_effect(reach[scale]);
                weight = at_most[scale - 2];
            }
            lost += margin * effect * weight;
            if (budget) budget->push_back({m, effect, weight});
        }
        if (!share && !exact) lost += s.blur(scale - 1, x);
        const auto bound = [&](const Result& r) { return Ball::exactly(margin * (r.error[scale - 1] + lost)); };
        const Ball least = to_ball(below.value[scale - 1]) - bound(below), most = to_ball(above.value[scale - 1]) + bound(above);
        if (s.first->is_area() && scale < levels) at_most[scale + 1] = min(at_most[scale + 1], margin * arf_get_d(arb_midref(most.get()), ARF_RND_UP));
        result = hull(certainly(less(least, Ball(0))) ? Ball(0) : least, share && certainly(less(Ball(1), most)) ? Ball(1) : most);
    }
    return result;
}

Ball ProvenLevels::share(long n, const Ball& load) const
{
    const WorkingPrecision precision(256);
    return share_and_budget(*state_, n, load, nullptr) * Ball::exactly(unit_);
}

std::string ProvenLevels::certificate(long n, const Ball& load) const
{
    std::vector<Contribution> budget;
    const Ball value = share_and_budget(*state_, n, load, &budget);
    const bool share = state_->first->is_share();
    const long shift = share ? 0 : 1; // level 0 of densities is D_1
    std::string text = fmt::format("proven levels: {} panels of {} terms, G to 101 bits; T {}_{} within {:.2e}{}\n", state_->all->panels.size(), state_->orders.terms,
                                   share ? 'B' : 'D', n - 1 + shift, value.radius_bound() * unit_, share ? "" : ", in 1/p*_n");
    for (const auto& b : budget)
        text += fmt::format("  level {:2}: T of its defect <= {:.2e}, share of it that reaches the value: {:.2e}\n", b.level + shift, b.effect * unit_, b.weight);
    return text;
}

// ---- kept meshes

namespace {

/// The tolerance of the mesh; \param spare digits it loses to the proven error
double tolerance_for(Accuracy wanted, double spare)
{
    constexpr double least = 4, finest = 25; // scale 20 loses up to two and a half
    return std::pow(10.0, -min(finest, max(least, static_cast<double>(wanted.digits)) + spare));
}

enum class Law { area, exceedance, density };

struct Mesh {
    Law law;
    std::string G, pressure;
    double highest, tolerance;
    int scales;
    std::mutex making;
    std::shared_ptr<const ProvenLevels> made;
};
std::mutex meshes_mutex;
std::list<std::shared_ptr<Mesh>> meshes; // most recently used first

/// \param scales at least as many levels as these
std::shared_ptr<const ProvenLevels> proven_levels(Law law, long scales, const Arguments& a, Accuracy wanted, const std::function<Ball()>& pressure = {})
{
    const double tolerance = tolerance_for(wanted, law == Law::density ? 2 : 4.5);
    const WorkingPrecision precision(256);
    const Ball G = a.G(), P = law == Law::area ? Ball(0) : pressure();
    const double load = double(to_real(a.load()));
    if (!(load <= 100)) throw BeyondReach("load above 100");
    const double g = double(to_real(G)); // below: the first panel of the finest mesh begins above all ratios
    if (4 * load < 1e-53 * g * g) throw BeyondReach("load too small for the proven levels");
    const double highest = law != Law::area ? load * (1 + 0x1p-40) : load <= 10 ? 10 : 100; // one mesh for the loads of figure 3
    std::shared_ptr<Mesh> mine;
    {
        const std::lock_guard lock(meshes_mutex);
        const auto found = std::find_if(meshes.begin(), meshes.end(), [&](const auto& m) {
            return m->law == law && m->tolerance <= tolerance && m->highest >= highest && m->scales >= scales && m->G == G.dump() && m->pressure == P.dump();
        });
        if (found != meshes.end()) meshes.splice(meshes.begin(), meshes, found);
        else {
            meshes.push_front(std::make_shared<Mesh>());
            Mesh& m = *meshes.front();
            m.law = law;
            m.G = G.dump();
            m.pressure = P.dump();
            m.highest = highest;
            m.tolerance = tolerance;
            m.scales = law == Law::area ? most_levels : static_cast<int>(scales);
        }
        mine = meshes.front();
        if (meshes.size() > 4) meshes.pop_back(); // up to 200 MB each
    }
    const std::lock_guard lock(mine->making);
    if (!mine->made)
        mine->made = law == Law::area       ? std::make_shared<const ProvenLevels>(G, mine->highest, mine->tolerance)
                   : law == Law::exceedance ? std::make_shared<const ProvenLevels>(G, P, mine->highest, mine->tolerance, mine->scales)
                                            : std::make_shared<const ProvenLevels>(ProvenLevels::densities(G, P, mine->highest, mine->tolerance, mine->scales));
    return mine->made;
}

/// The load is asked for to all bits the levels use, however few digits are wanted.
Ball share_at(const ProvenLevels& levels, long n, const Arguments& a)
{
    const WorkingPrecision precision(256);
    return levels.share(n, a.load());
}

void require_level(long n)
{
    if (n > most_levels) throw BeyondReach(fmt::format("with full contact, areas and distributions are certified for n <= {} only", most_levels));
}

} // namespace

Ball area_by_proven_levels(long n, const Arguments& a, Accuracy wanted)
{
    require_level(n);
    return share_at(*proven_levels(Law::area, n, a, wanted), n, a);
}

Ball exceedance_by_proven_levels(long n, const std::function<Ball()>& pressure, const Arguments& a, Accuracy wanted)
{
    require_level(n);
    return share_at(*proven_levels(Law::exceedance, n, a, wanted, pressure), n, a);
}

Ball density_by_proven_levels(long n, const std::function<Ball()>& pressure, const Arguments& a, Accuracy wanted)
{
    require_level(n);
    return share_at(*proven_levels(Law::density, n - 1, a, wanted, pressure), n - 1, a);
}

static std::string certificate(const std::shared_ptr<const ProvenLevels>& levels, long n, const Arguments& a)
{
    const WorkingPrecision precision(256);
    return levels->certificate(n, a.load());
}

std::string area_by_proven_levels_certificate(long n, const Arguments& a, Accuracy wanted) { return certificate(proven_levels(Law::area, n, a, wanted), n, a); }
std::string exceedance_by_proven_levels_certificate(long n, const std::function<Ball()>& pressure, const Arguments& a, Accuracy wanted)
{
    return certificate(proven_levels(Law::exceedance, n, a, wanted, pressure), n, a);
}
std::string density_by_proven_levels_certificate(long n, const std::function<Ball()>& pressure, const Arguments& a, Accuracy wanted)
{
    return certificate(proven_levels(Law::density, n - 1, a, wanted, pressure), n - 1, a);
}

} // namespace touchstone::transfer
