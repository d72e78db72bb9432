// SPDX-License-Identifier: MIT
/// The bounds over discs that the levels of a distribution rest on (recursion/from_the_edge/boxes.cpp, binary64), held against the
/// functions themselves at points of those discs, in balls of 128 bits and written as forward.hpp has them. Nothing is shared but the
/// formula.
#include "touchstone/recursion/first_steps/area_by_slope.hpp"
#include "touchstone/recursion/from_the_edge/far_end.hpp"
#include "touchstone/recursion/from_the_edge/levels.hpp"
#include "touchstone/scalar/refusal.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <complex>
#include <random>

using namespace touchstone;
using namespace touchstone::transfer;
using namespace touchstone::transfer::from_the_edge;

namespace {

constexpr slong bits = 128;
constexpr unsigned seed = 20261123;

C ball(std::complex<double> z) { return {Ball::exactly(z.real()), Ball::exactly(z.imag())}; }

/// E(z) = (1 - e^-z)/z
C mean(const C& z)
{
    C r;
    const C minus = -z;
    acb_expm1(r.get(), minus.get(), bits);
    return -r / z;
}

/// The step's kernel at (e, d, s, c), of the density (P/(M E))^(1/2)/R, of the exceedance (P M/E)^(1/2)/R.
Ball size_of_kernel(Law law, const C& e, const C& d, const C& s, const C& c)
{
    const C x = e * exp(-2 * d * s), R = sqrt((1 - x) * (1 - x) + 4 * e * exp(-2 * d)), P = 1 + x + R, M = 1 - x + R, E = mean(2 * d * c);
    return sqrt(abs(law == Law::density ? P / (M * E) : P * M / E)) / abs(R);
}

struct Points {
    std::mt19937_64 random{seed};
    double between(double a, double b) { return std::uniform_real_distribution<double>(a, b)(random); }
    double scale(double a, double b) { return std::exp(between(std::log(a), std::log(b))); }
    /// A point of the disc, most often of its rim.
    std::complex<double> of(const Disc& z)
    {
        return z.centre() + std::polar(z.radius() * std::min(1.0, between(0, 3)) * (1 - 1e-12), between(-3.15, 3.15));
    }
};

} // namespace

TEST_CASE("the kernel is nowhere larger than its bound over discs")
{
    const WorkingPrecision precision(bits);
    MESSAGE("seed " << seed);
    Points points;
    for (const Law law : {Law::density, Law::exceedance}) {
        const Levels levels(law, Ball(3), Ball(Rational(1, 10)), 30);
        int finite = 0;
        double tightest = 0;
        for (int i = 0; i < 3000; ++i) {
            const double size = points.scale(1e-6, 300), reach = points.scale(1e-6, 0.3);
            const std::complex<double> at = std::polar(size, points.between(-1.6, 1.6));
            const Disc d = disc(at.real(), at.imag(), reach * size), s = disc_over(points.between(0, 0.5), points.between(0.5, 0.52)),
                       c = 1 - s;
            const Disc e = disc(Ball::exactly(points.between(0, 1)));
            const double bound = levels.kernel_bound(e, d, s, c);
            if (!std::isfinite(bound)) continue;
            ++finite;
            for (int k = 0; k < 6; ++k) {
                const C d_at = ball(points.of(d)), s_at = C(Ball::exactly(points.of(s).real())), e_at = ball(e.centre());
                const Ball kernel = size_of_kernel(law, e_at, d_at, s_at, 1 - s_at);
                CAPTURE(i);
                CHECK_FALSE(certainly(less(Ball::exactly(bound), kernel)));
                tightest = std::max(tightest, about(kernel) / bound);
            }
        }
        CHECK(finite > 500);
        CHECK(tightest > 0.99); // a bound of another function would not be approached
    }
}

TEST_CASE("the first level is nowhere larger than its bound over discs")
{
    const WorkingPrecision precision(bits);
    Points points;
    for (const Law law : {Law::density, Law::exceedance})
        for (const Rational& load : {Rational(1), Rational(9, 10), Rational(1, 1000)}) {
            const Levels levels(law, Ball(3), Ball(load), 30);
            int finite = 0;
            for (int i = 0; i < 1000; ++i) {
                const double size = points.scale(1e-6, 100);
                const std::complex<double> at = std::polar(size, points.between(-1.6, 1.6));
                const Disc d = disc(at.real(), at.imag(), points.scale(1e-6, 0.3) * size);
                const double bound = levels.first_bound(d);
                if (!std::isfinite(bound)) continue;
                ++finite;
                for (int k = 0; k < 4; ++k) {
                    const C z = ball(points.of(d)), x = C(Ball(load)), half = exp(-z); // load = 1: R = 2 e^-d, and not the other root
                    const C R = load == 1 ? 2 * half : sqrt((1 - x) * (1 - x) + 4 * x * half * half), P = 1 + x + R, M = 1 - x + R,
                            E = mean(2 * z);
                    // arcsin(w)/(2d)^(1/2), w^2 = 4 d x E/P, as a power series' sum: Arb's arcsine
                    C w = sqrt(2 * x / P * (1 - exp(-2 * z))), angle;
                    acb_asin(angle.get(), w.get(), bits);
                    const Ball decay = abs(exp(-z * C(Ball::exactly(levels.beta))));
                    const Ball u = decay * (law == Law::density ? sqrt(abs(P / (M * E))) / abs(R) : abs(angle) / sqrt(abs(2 * z)));
                    CAPTURE(i);
                    CHECK_FALSE(certainly(less(Ball::exactly(bound), u)));
                }
            }
            CHECK(finite > 200);
        }
}

TEST_CASE("levels stay below the bounds of their boxes")
{
    const WorkingPrecision precision(Levels::precision_for(40));
    for (const Law law : {Law::density, Law::exceedance}) {
        Levels levels(law, Ball(3), Ball(Rational(1, 10)), 40);
        levels.extend_to(5);
        Points points;
        for (long k = 2; k <= 5; ++k) {
            const Level& level = *levels.levels[static_cast<std::size_t>(k)];
            double tightest = 0;
            for (int i = 0; i < 400; ++i) {
                const double d = points.scale(1e-4, 60);
                const auto panel = std::find_if(level.panels.begin(), level.panels.end(), [d](const auto& p) { return d <= p->b; });
                if (panel == level.panels.end()) continue;
                const Ball at = Ball::exactly(d), xi = (((*panel)->logarithmic ? log(at) : at) - (*panel)->mid) / (*panel)->half;
                Ball u;
                levels.evaluate(**panel, xi, u);
                const double bound = levels.lookup(level.boxes, {d * (1 - 1e-12), d * (1 + 1e-12), 0, 0});
                CAPTURE(k);
                CAPTURE(d);
                CHECK(about(u) <= bound * (1 + 1e-9) + (*panel)->worst + (*panel)->interpolation);
                tightest = std::max(tightest, about(u) / bound);
            }
            CHECK(tightest > 0.1);
        }
    }
}

namespace {

using Z = std::complex<double>;

Z mean_of(Z z) { return std::abs(z) < 1e-5 ? 1.0 - z / 2.0 : (1.0 - std::exp(-z)) / z; }

/// u_k in binary64 at complex d, from forward.hpp, with the integrals by the midpoint rule in theta.
struct Direct {
    Law law;
    double G, load;
    bool full;
    double beta() const { return law == Law::density ? 1.5 : 0.5; }
    double edge(long k) const
    {
        double e = load;
        for (; k > 0; --k) e = 2 / G * std::sqrt(e);
        return e;
    }
    Z first(Z d) const
    {
        if (full && law == Law::density) return std::sqrt(1.0 + std::exp(-d)) / std::sqrt(mean_of(2.0 * d)) / 2.0;
        const Z R = full ? 2.0 * std::exp(-d) : std::sqrt((1 - load) * (1 - load) + 4 * load * std::exp(-2.0 * d)), P = 1 + load + R,
                M = 1 - load + R, E = mean_of(2.0 * d);
        if (law == Law::density) return std::exp(-1.5 * d) * std::sqrt(P) / std::sqrt(M) / std::sqrt(E) / R;
        const Z z = std::sqrt(4 * load * d * E / P);
        return std::exp(-0.5 * d) * (std::abs(z) < 1e-8 ? 1.0 : std::asin(z) / z) * std::sqrt(2 * load) * std::sqrt(E) / std::sqrt(P);
    }
    Z kernel(double e, Z d, double s) const
    {
        const Z x = e * std::exp(-2.0 * d * s), R = std::sqrt((1.0 - x) * (1.0 - x) + 4 * e * std::exp(-2.0 * d)), P = 1.0 + x + R,
                M = 1.0 - x + R;
        const Z E = std::sqrt(mean_of(2.0 * d * (1 - s)));
        return (law == Law::density ? std::sqrt(P) / std::sqrt(M) : std::sqrt(P) * std::sqrt(M)) / E / R;
    }
    Z level(long k, Z d, int points = 80) const
    {
        if (k == 1) return first(d);
        const auto m = static_cast<double>(law == Law::density ? k - 2 : k);
        Z sum = 0;
        double weight = 0;
        for (int i = 0; i < points; ++i) {
            const double theta = std::numbers::pi / 2 * (i + 0.5) / points, s = std::sin(theta) * std::sin(theta),
                         w = std::pow(std::sin(theta), m);
            weight += w;
            sum += w * kernel(edge(k - 1), d, s) * level(k - 1, 2.0 * d * s, points / 2);
        }
        return std::exp(-beta() * d) * sum / weight;
    }
};

} // namespace

TEST_CASE("every box of the first three levels bounds the level at complex points, and not by much more than it is")
{
    const WorkingPrecision precision(Levels::precision_for(40));
    for (const Law law : {Law::density, Law::exceedance})
        for (const Rational& load : {Rational(1), Rational(1, 2), Rational(1, 1000)}) {
            Levels levels(law, Ball(3), Ball(load), 40);
            levels.extend_to(3);
            const Direct direct{law, 3, about(Ball(load)), load == 1};
            Points points;
            for (long k = 1; k <= 3; ++k) {
                const Boxes& boxes = levels.levels[static_cast<std::size_t>(k)]->boxes;
                std::array<double, 3> tightest{}; // in the full disc, in boxes with a positive real part, in the others
                int inside = 0, open = 0;
                for (int i = 0; i < (k == 3 ? 150 : 500); ++i) {
                    const double size = points.scale(1e-3, 60), angle = points.between(0, i % 3 == 0 ? 3.14 : 1.5);
                    const PolarRange here{size * (1 - 1e-12), size * (1 + 1e-12), angle, angle};
                    const double bound = levels.lookup(boxes, here);
                    if (!std::isfinite(bound)) {
                        ++open;
                        continue;
                    }
                    ++inside;
                    const double u = std::abs(direct.level(k, std::polar(size, angle)));
                    CAPTURE(k);
                    CAPTURE(size);
                    CAPTURE(angle);
                    if (u > 1e-200) CHECK(u <= bound * (1 + 0.01));
                    const bool disc = size < levels.shells.radius(boxes.disc);
                    double& t = tightest[disc ? 0 : angle < 1.5 ? 1 : 2];
                    t = std::max(t, u / bound);
                }
                CHECK(inside > (k == 3 ? 95 : 335)); // what is proven reaches far
                CHECK(open > 0);
                for (const double t : tightest) CHECK(t > std::array{0.28, 0.17, 0.13}[static_cast<std::size_t>(k) - 1]);
            }
        }
}

TEST_CASE("the kernel far out, E apart, is below its bound for every R that eta leaves, and comes near it")
{
    for (const Law law : {Law::density, Law::exceedance}) {
        const Levels levels(law, Ball(3), Ball(Rational(1, 10)), 10);
        for (const double e : {0.05, 0.5, 0.95})
            for (const double eta : {1e-6, 9e-4, 0.1}) {
                double most = 0;
                for (int k = 0; k < 64; ++k)
                    for (const double share : {0.3, 0.7, 1.0}) { // x -> e next to the end of the wave, |R/(1 - e) - 1| <= eta
                        const Z R = (1 - e) * (1. + share * std::polar(eta, std::numbers::pi * k / 32)), P = 1 + e + R, M = 1 - e + R;
                        most = std::max(most, std::sqrt(std::abs(law == Law::density ? P / M : P * M)) / std::abs(R));
                    }
                CAPTURE(e);
                CAPTURE(eta);
                CHECK(levels.far_kernel(e, eta) >= most);
                // that P, M and R are not at their extremes at once costs between these many eta
                const double beyond = (levels.far_kernel(e, eta) / most - 1) / eta;
                CHECK(beyond > (law == Law::density ? 0.5 : 1));
                CHECK(beyond < (law == Law::density ? 0.76 : 1.3));
            }
    }
}

TEST_CASE("the disc about a box holds it, and its rim the box's farthest corner")
{
    Points points;
    for (int i = 0; i < 200; ++i) {
        const double inner = points.scale(1e-3, 10), outer = inner * points.between(1, 1.5), from = points.between(0, 2.5),
                     to = from + points.between(0, 0.6);
        const Disc about = disc_about(inner, outer, from, to);
        double farthest = 0;
        for (const double r : {inner, (inner + outer) / 2, outer})
            for (const double angle : {from, (from + to) / 2, to})
                farthest = std::max(farthest, std::abs(std::polar(r, angle) - about.centre()));
        CHECK(farthest <= about.radius());
        CHECK(farthest >= about.radius() * (1 - 1e-6) - 1e-15 * outer);
    }
}

TEST_CASE("arcs cover the upper half of an ellipse, and two neighbours barely more than it")
{
    for (const auto& [mid, half, rho] : {std::tuple(0.0, 1.0, 2.0), std::tuple(3.0, 0.25, 1.1), std::tuple(-1.0, 2.0, 8.0)})
        for (const int arcs : {24, 40}) {
            double tightest = 0;
            for (int k = 0; k <= 2000; ++k) {
                const Z w = rho * std::polar(1.0, std::numbers::pi * k / 2000), at = mid + half * (w + 1. / w) / 2.;
                double nearest = infinity;
                for (int i = 0; i < arcs; ++i) {
                    const Arc arc = arc_of_ellipse(mid, half, rho, i, arcs);
                    nearest = std::min(nearest, std::abs(at - Z(arc.x, arc.y)) / arc.radius);
                }
                CHECK(nearest <= 1);
                tightest = std::max(tightest, nearest);
            }
            CHECK(tightest > 0.99);
        }
}

TEST_CASE("a box is bounded by its quarters where the disc about it has no bound, and they leave out nothing")
{
    Points points;
    const double inner = 1, outer = 1.3, from = 0.2, to = 0.7;
    for (const int depth : {0, 1, 2}) {
        std::vector<Disc> bounded;
        const double smallest = 0.36 * std::exp2(-depth); // the disc about the whole has a radius of 0.34
        const double bound = over_box(inner, outer, from, to, depth, [&](const Disc& d) {
            if (d.radius() > smallest) return infinity;
            bounded.push_back(d);
            return d.most();
        });
        CHECK(bounded.size() == std::size_t(1) << (2 * depth));
        double most = 0;
        for (const Disc& d : bounded) most = std::max(most, d.most());
        CHECK(bound == most);
        for (int i = 0; i < 500; ++i) {
            const Z at = std::polar(points.between(inner, outer), points.between(from, to));
            CHECK(std::any_of(bounded.begin(), bounded.end(), [&](const Disc& d) { return std::abs(at - d.centre()) <= d.radius(); }));
        }
        CHECK(std::isinf(over_box(inner, outer, from, to, depth, [&](const Disc& d) { return d.radius() > smallest / 4 ? infinity : 1; })));
    }
}

TEST_CASE("what a box reaches at 2 d s: the shells from the nearest to the farthest, and what is beyond the last")
{
    const Levels levels(Law::density, Ball(3), Ball(Rational(1, 2)), 10);
    const Shells& shells = levels.shells;
    Boxes boxes;
    boxes.bound.assign(static_cast<std::size_t>(shells.count() + 1) * n_directions, smallest_bound);
    boxes.far.assign(n_directions, 3);
    const int m = 4, last = shells.count(), middle = last / 2;
    for (int j = 0; j <= last; ++j) boxes.at(j, m) = 1 + j; // grows outwards
    CHECK(levels.reached(boxes, middle, m, 0, 0.499) == 1 + middle);               // 2 s < 1: no farther than it is itself
    CHECK(levels.reached(boxes, middle, m, 0, 1) == 1 + middle + Shells::density); // twice as far
    for (int j = 0; j <= last; ++j) boxes.at(j, m) = 1 + last - j; // falls
    CHECK(levels.reached(boxes, middle, m, 0.5, 1) == 1 + last - (middle - 1)); // from the inner rim on, where a shell ends
    CHECK(levels.reached(boxes, middle, m, 1e-30, 1) == 1 + last);
    CHECK(levels.reached(boxes, 0, m, 0.5, 1) == 1 + last);
    const double end = shells.radius(last);
    CHECK(levels.reached(boxes, last, m, 0.4, 0.499) < 50);
    CHECK(levels.reached(boxes, last, m, 0.9, 1) == doctest::Approx(3 * std::sqrt(2 * end)).scale(0).epsilon(1e-12));
    CHECK(levels.reached(boxes, last - 3, m, 0.9, 1) ==
          doctest::Approx(3 * std::sqrt(2 * shells.radius(last - 3))).scale(0).epsilon(1e-12));
}

TEST_CASE("squares of sine and cosine over a sector")
{
    for (int i = 0; i < 32; ++i) {
        const double a = std::numbers::pi / 64 * i, b = std::numbers::pi / 64 * (i + 1);
        const auto [s0, s1, c0, c1] = sector(a, b);
        for (const auto& [least, most, low, high] :
             {std::array{s0, s1, std::sin(a), std::sin(b)}, std::array{c0, c1, std::cos(b), std::cos(a)}}) {
            CHECK(least <= low * low);
            CHECK(least >= low * low * (1 - 1e-8));
            CHECK(most >= std::min(1.0, high * high));
            CHECK(most <= std::min(1.0, high * high * (1 + 1e-8)));
        }
    }
}

TEST_CASE("1/E of a D in the right half plane, nearly attained by small and large real ones")
{
    Points points;
    for (int i = 0; i < 2000; ++i) {
        const double size = points.scale(1e-6, 100), angle = points.between(-1.56, 1.56);
        CHECK(1 / std::abs(mean_of(std::polar(size, angle))) <= inverse_mean(size, std::cos(angle)) * (1 + 1e-9));
    }
    for (const double size : {1e-3, 0.01, 30., 100.})
        CHECK(1 / std::abs(mean_of(size)) >= inverse_mean(size, 1) * (size < 1 ? 0.99 : 0.96));
}

TEST_CASE("how far R^2 is from (1 - x)^2 far out, attained by x = e")
{
    for (const double e : {1e-6, 0.05, 0.5, 0.99})
        for (const double real_part : {0.5, 3.0, 20.0}) {
            const double bound = root_departure(e, real_part);
            double most = 0;
            for (const double share : {0.0, 0.5, 1.0})
                for (int k = 0; k < 16; ++k) {
                    const Z x = e * share * std::polar(1.0, std::numbers::pi * k / 8), d(real_part, 0.3 * k);
                    most = std::max(most, std::abs(4 * e * std::exp(-2.0 * d) / ((1. - x) * (1. - x))));
                }
            CHECK(most <= bound);
            CHECK(most >= bound * (1 - 1e-6));
        }
}

TEST_CASE("beyond the last shell the first two levels stay below the bounds of their directions")
{
    const WorkingPrecision precision(Levels::precision_for(10));
    for (const Law law : {Law::density, Law::exceedance})
        for (const Rational& load : {Rational(1), Rational(1, 2), Rational(1, 1000), Rational(1, 1'000'000)}) {
            Levels levels(law, Ball(3), Ball(load), 10);
            levels.extend_to(2);
            const Direct direct{law, 3, about(Ball(load)), load == 1};
            const double end = levels.shells.radius(levels.shells.count());
            for (long k = 1; k <= 2; ++k) {
                const Boxes& boxes = levels.levels[static_cast<std::size_t>(k)]->boxes;
                for (int m = 0; m < n_directions; ++m) {
                    const double far = boxes.far[static_cast<std::size_t>(m)],
                                 least = std::cos(directions[static_cast<std::size_t>(m) + 1]);
                    CAPTURE(m);
                    CAPTURE(k);
                    if (k == 1) CHECK(std::isfinite(far) == (least > 0.001));
                    else if (least < 0.001) CHECK(std::isinf(far));
                    if (!std::isfinite(far) || directions[static_cast<std::size_t>(m)] < 0.99)
                        continue; // nearer to the axis all underflows
                    double tightest = 0;
                    for (const double beyond : {1.0, 1.02, 1.5, 3.0})
                        for (const double f : {0.0, 0.5, 1.0}) {
                            const Z d = std::polar(end * beyond, directions[static_cast<std::size_t>(m)] * (1 - f) +
                                                                     directions[static_cast<std::size_t>(m) + 1] * f);
                            const double u = std::abs(direct.level(k, d, 4000)), bound = far * std::sqrt(std::abs(d));
                            if (u < 1e-280) continue; // the decay underflows
                            CHECK(u <= bound * (1 + 1e-6));
                            tightest = std::max(tightest, u / bound);
                        }
                    if (law == Law::density && k == 1 && tightest > 0 && directions[static_cast<std::size_t>(m)] < 1.35)
                        CHECK(tightest > (load == 1 ? 0.7 : 0.35));
                }
            }
            if (load > Rational(1, 100)) continue; // boxes of a direction end before the last shell
            // a level of which nothing is known but what it is far out
            Level from, to;
            from.k = 1;
            from.edge = levels.levels[1]->edge;
            from.edge_bound = levels.levels[1]->edge_bound;
            from.boxes = levels.levels[1]->boxes;
            to.boxes.disc = 0;
            for (double& b : from.boxes.bound) b = smallest_bound;
            for (double& f : from.boxes.far) f = 1;
            levels.bound_boxes(from, to);
            const double e = direct.edge(1);
            for (const int m : {15, 16, 17}) {
                const double angle = directions[static_cast<std::size_t>(m) + 1];
                const Z d = std::polar(end * (1 - 1e-9), angle);
                double sum = 0, weight = 0, power = law == Law::density ? 0 : 2;
                for (int i = 0; i < 20000; ++i) {
                    const double theta = std::numbers::pi / 2 * (i + 0.5) / 20000, s = std::pow(std::sin(theta), 2),
                                 w = std::pow(std::sin(theta), power);
                    weight += w;
                    if (2 * std::abs(d) * s > end) sum += w * std::abs(direct.kernel(e, d, s)) * std::sqrt(2 * std::abs(d) * s);
                }
                const double least = std::exp(-direct.beta() * d.real()) * sum / weight, bound = to.boxes.at(levels.shells.count(), m);
                CAPTURE(m);
                CHECK(least <= bound * (1 + 1e-6));
                // all that is far out, and what a wave makes of the whole shells
                const double far = to.boxes.far[static_cast<std::size_t>(m)] * std::sqrt(std::abs(d));
                CHECK(far >= least);
                CHECK(far <= 1e3 * least);
            }
        }
}

TEST_CASE("beyond the last shell R is 1 - load but for less than its last bits, however close the load is to 1, and so is the bound")
{
    const WorkingPrecision precision(Levels::precision_for(10));
    for (const Law law : {Law::density, Law::exceedance})
        for (double rest = 0.125; rest > 1e-15; rest /= 16) {
            const Ball load = 1 - Ball::exactly(rest);
            const Levels levels(law, Ball(3), load, 10);
            const Direct direct{law, 3, about(load), false};
            const double end = levels.shells.radius(levels.shells.count());
            for (int m = 0; directions[static_cast<std::size_t>(m) + 1] < 1.569; ++m) {
                const double far = levels.levels[1]->boxes.far[static_cast<std::size_t>(m)],
                             angle = directions[static_cast<std::size_t>(m) + 1];
                CAPTURE(rest);
                CHECK(root_departure(about(load), end * std::cos(angle)) < 1e-16 * rest);
                CHECK(std::abs(direct.first(std::polar(end, angle))) <= far * std::sqrt(end) * (1 + 1e-6));
                CHECK(std::isfinite(far));
            }
        }
}

TEST_CASE("over a narrow disc a bound of the kernel, of its share and of the first level is the value itself")
{
    const WorkingPrecision precision(bits);
    for (const Law law : {Law::density, Law::exceedance}) {
        const Direct direct{law, 3, 0.1, false};
        Points points;
        int looked_at = 0;
        for (const Rational& load : {Rational(1), Rational(1, 2), Rational(1, 1000)}) {
            const Levels levels(law, Ball(3), Ball(load), 30);
            const Direct of{law, 3, about(Ball(load)), load == 1};
            for (int i = 0; i < 400; ++i) {
                const Z at = std::polar(points.scale(1e-4, 40), points.between(0, 1.4));
                const double s = points.between(0, 1), e = points.between(0.01, 0.99), D = 2 * std::abs(at) * (1 - s),
                             least = D > 0.81 || D < 2e-3 ? 0.995 : 0.4;
                const Disc d(at, 1e-12 * std::abs(at)), edge(e), sine2(s), cosine2(1 - s);
                const double value = std::abs(direct.kernel(e, at, s)), bound = levels.kernel_bound(edge, d, sine2, cosine2);
                CAPTURE(at.real());
                CAPTURE(at.imag());
                CAPTURE(s);
                CAPTURE(e);
                if (std::isfinite(bound)) {
                    ++looked_at;
                    CHECK(value <= bound * (1 + 1e-6));
                    CHECK(value >= bound * least);
                }
                const double asked = levels.kernel_bound(edge, d, sine2, cosine2, 1e-6); // what is known otherwise, where it is less
                CHECK(asked < 1.01e-3 * std::sqrt(std::abs(mean_of(2.0 * at * (1 - s)))) * value);
                CHECK(asked > 0.99e-3 * std::sqrt(std::abs(mean_of(2.0 * at * (1 - s)))) * value);
                const Z x = e * std::exp(-2.0 * at * s), P = 1.0 + x + std::sqrt((1.0 - x) * (1.0 - x) + 4 * e * std::exp(-2.0 * at));
                const double z = std::sqrt(std::abs(2.0 * x * (1.0 - std::exp(-2.0 * at * (1 - s))) / P)),
                             share = levels.kernel_bound(edge, d, sine2, cosine2, infinity, Kind::share);
                if (z > 1.001) CHECK(std::isinf(share));
                if (std::isfinite(share)) CHECK(share == doctest::Approx(std::numbers::pi / 2 * z).scale(0).epsilon(1e-6));
                const double first = levels.first_bound(d), u = std::abs(of.first(at)), D1 = 2 * std::abs(at),
                             at_least = D1 > 0.81 || D1 < 2e-3 ? 0.995 : 0.4;
                if (std::isfinite(first) && law == Law::exceedance && D1 > 0.81 &&
                    !(of.full && at.real() > 0.5)) { // |arcsin z| <= (pi/2)|z|
                    const Z R =
                        of.full ? 2.0 * std::exp(-at) : std::sqrt((1 - of.load) * (1 - of.load) + 4 * of.load * std::exp(-2.0 * at));
                    const double of_z =
                        std::abs(std::exp(-of.beta() * at)) * std::sqrt(2 * of.load * std::abs(mean_of(2.0 * at) / (1 + of.load + R)));
                    CHECK(first == doctest::Approx(std::numbers::pi / 2 * of_z).scale(0).epsilon(1e-6));
                }
                if (std::isfinite(first)) {
                    CHECK(u <= first * (1 + 1e-6));
                    CHECK(u >= first * (law == Law::density ? at_least : std::min(at_least, of.full && at.real() > 0.5 ? 0.2 : 0.6)));
                }
                else CHECK(at.real() < 3);
            }
        }
        CHECK(looked_at > 900);
    }
}

TEST_CASE("bounds of discs: moduli, cuts, ranges of directions, and what is no number")
{
    const WorkingPrecision precision(bits);
    const double not_a_number = std::numeric_limits<double>::quiet_NaN();
    CHECK(product_of_bounds({2, 3, 0.5}) == 3);
    CHECK(product_of_bounds({}) == 1);
    CHECK(product_of_bounds({1e-200, 1e-200, 1e10}) >= smallest_bound * 1e10); // a product that underflows claims nothing
    CHECK(product_of_bounds({1e-200, 1e-200}) == smallest_bound);
    CHECK(product_of_bounds({0, 2}) == 2 * smallest_bound);
    for (const double nothing : {infinity, not_a_number}) {
        CHECK(std::isinf(product_of_bounds({nothing, 0})));
        CHECK(std::isinf(product_of_bounds({0, nothing, 1e-200})));
        CHECK(std::isinf(at_most_modulus(disc(1, 0, nothing))));
        CHECK(at_least_modulus(disc(1, 0, nothing)) == 0);
        CHECK(meets_cut(disc(1, 0, nothing)));
        CHECK(std::isinf(polar(disc(1, 0, nothing)).outer));
        const Levels levels(Law::density, Ball(3), Ball(Rational(1, 10)), 30);
        CHECK(std::isinf(levels.lookup(levels.levels[1]->boxes, polar(disc(1, 0, nothing))))); // no box holds all numbers
        CHECK(std::isinf(levels.lookup(levels.levels[1]->boxes, {0, nothing, 0, 0.1})));
        CHECK(std::isinf(levels.integrand_bound(*levels.levels[1], Kind::step, disc(1, 0, nothing), disc(0.5, 0, 0.1))));
    }
    CHECK(std::isinf(above(Ball::indeterminate())));
    CHECK(above(Ball(1) / Ball(3)) == doctest::Approx(1.0 / 3));
    CHECK(Ball::exactly(above(Ball(1) / Ball(3))).contains(Rational(1, 3)) == false);
    CHECK_FALSE(certainly(less(Ball::exactly(above(Ball(1) / Ball(3))), Ball(1) / Ball(3))));
    CHECK(at_most_modulus(disc(0, 0, 0)) <= 1.1e-160);
    CHECK(at_least_modulus(disc(3, 4, 1)) == doctest::Approx(4));
    CHECK(at_least_modulus(disc(3, 4, 1)) < 4);
    CHECK(at_most_modulus(disc(3, 4, 1)) == doctest::Approx(6));
    CHECK(at_most_modulus(disc(3, 4, 1)) > 6);
    CHECK(at_least_modulus(disc(3, 4, 5)) == 0);
    CHECK(at_least_modulus(disc(1e-100, 0, 1.1e-100)) == 0);
    CHECK_FALSE(meets_cut(disc(3, 4, 4.99999)));
    CHECK(meets_cut(disc(3, 4, 5)));
    CHECK_FALSE(meets_cut(disc(-3, 4, 3.99999)));
    CHECK_FALSE(meets_cut(disc(-3, -4, 3.99999)));
    CHECK(meets_cut(disc(-3, 4, 4)));
    CHECK(meets_cut(disc(-3, 0, 0)));
    CHECK(meets_cut(disc(0, 0, 0)));
    CHECK_FALSE(meets_cut(disc(0, 1, 0.99999)));
    CHECK(mean_meets_cut(disc(0.1, 0, 0.1), disc(-1, 0, 0.1)));
    CHECK_FALSE(mean_meets_cut(disc(0.1, 0, 0.09), disc(-1, 0, 0.1))); // Re D > 0: no need to look
    CHECK_FALSE(mean_meets_cut(disc(0, 0, 0.1), disc(1, 0, 0.1)));

    const Disc over = disc_over(2, 5);
    CHECK(over.centre() == Z(3.5));
    CHECK(over.radius() == doctest::Approx(1.5));
    CHECK(over.radius() >= 1.5);
    Ball wide = Ball(1) / Ball(3);
    arb_add_error(wide.get(), Ball(Rational(1, 7)).get());
    CHECK(disc(wide).radius() == doctest::Approx(1.0 / 7));
    CHECK(disc(wide).radius() >= 1.0 / 7);
    CHECK(disc(wide).centre().real() == 1.0 / 3);

    // a box of a full turn: what surrounds 0 has every direction, and the last box the negative axis
    const PolarRange all = polar(1, 0, 1), quarter = polar(0, 2, 1), behind = polar(-2, 1e-3, 1e-6);
    CHECK(all.inner == 0);
    CHECK(all.outer == doctest::Approx(2));
    CHECK(all.outer >= 2);
    CHECK(all.from == 0);
    CHECK(all.to > directions[n_directions - 1]);
    CHECK(quarter.inner == doctest::Approx(1));
    CHECK(quarter.inner <= 1);
    CHECK(quarter.outer >= 3);
    CHECK(quarter.from == doctest::Approx(std::numbers::pi / 3));
    CHECK(quarter.to == doctest::Approx(2 * std::numbers::pi / 3));
    CHECK(behind.to > directions[n_directions - 1]);
    CHECK(polar(2, 0, 1).from == 0);
    Points points;
    for (int i = 0; i < 2000; ++i) {
        const Disc z(std::polar(points.scale(1e-5, 1e5), points.between(-3.2, 3.2)), 0),
            with_radius(z.centre(), points.between(0, 1.2) * std::abs(z.centre()));
        const PolarRange range = polar(with_radius);
        const Z at = points.of(with_radius);
        CHECK(range.inner <= std::abs(at) * (1 + 1e-15));
        CHECK(range.outer >= std::abs(at) * (1 - 1e-15));
        CHECK(range.from <= std::fabs(std::arg(at)) + 1e-15);
        CHECK(std::min(std::fabs(std::arg(at)), 3.1415) <= range.to + 1e-15);
        // E(z) over the disc
        const Disc E = exponential_mean(with_radius);
        if (std::isfinite(E.most())) CHECK(std::abs(mean_of(at) - E.centre()) <= E.radius() * (1 + 1e-9) + 1e-10);
        const double m = at_most_modulus(with_radius);
        if (m < 0.79) {
            CHECK(E.radius() <= (m < 1e-3 ? 1.001 * m : 1.001 * (std::exp(m) - 1 - m) / m + 1e-12));
            CHECK(E.radius() >= (m < 1e-3 ? m : 0.999 * (std::exp(m) - 1 - m) / m - 1e-12));
            CHECK(E.centre() == Z(1));
        }
    }
    CHECK(exponential_mean(disc(0.9, 0, 0)).radius() < 1e-10);
    CHECK(exponential_mean(disc(0.79, 0, 0)).radius() > 0.1);
}

TEST_CASE("shares of sectors, bounds far out, boxes met by a range")
{
    const WorkingPrecision precision(bits);
    for (const long m : {0L, 1L, 2L, 7L, 20L}) {
        const auto shares = Levels::sector_shares(m);
        double sum = 0;
        for (int i = 0; i < Levels::sectors; ++i) {
            double exact = 0; // Simpson's rule, of many points
            const double a = std::numbers::pi / 2 * i / Levels::sectors, h = std::numbers::pi / 2 / Levels::sectors / 64;
            for (int j = 0; j < 64; ++j)
                for (const auto& [at, weight] : {std::pair(0.0, 1.0), {0.5, 4.0}, {1.0, 1.0}})
                    exact += weight * std::pow(std::sin(a + (j + at) * h), static_cast<double>(m)) * h / 6;
            exact /= about(Levels::wallis(m));
            sum += exact;
            CAPTURE(m);
            CAPTURE(i);
            const double share = shares[static_cast<std::size_t>(i)];
            CHECK(share >= exact * (1 - 1e-9));
            CHECK(share <= exact * (i < 3 ? 1.5 : 1.1) + 1e-9);
        }
        CHECK(sum == doctest::Approx(1));
    }
    Points points;
    for (const Law law : {Law::density, Law::exceedance}) {
        const Levels levels(law, Ball(3), Ball(Rational(1, 10)), 30);
        for (const double e : {0.01, 0.3, 0.9}) {
            const double eta = 1e-3, bound = levels.far_kernel(e, eta);
            double most = 0;
            for (int i = 0; i < 4000; ++i) {
                const Z x = std::polar(e * std::min(1.0, points.between(0, 3)), i % 4 == 0   ? 0
                                                                                : i % 4 == 1 ? std::numbers::pi
                                                                                             : points.between(-3.2, 3.2)),
                        w4 = std::polar(eta * (1 - e) * (1 - e), points.between(-3.2, 3.2));
                const Z R = std::sqrt((1.0 - x) * (1.0 - x) + w4), P = 1.0 + x + R, M = 1.0 - x + R;
                most = std::max(most, std::sqrt(std::abs(law == Law::density ? P / M : P * M)) / std::abs(R));
            }
            CHECK(most <= bound);
            if (law == Law::density) CHECK(most >= 0.997 * bound);
            else CHECK(most >= 0.997 * (1 - e) / (1 + e) * bound);
        }
        // a range of 1 box, of 2, and beyond the last
        Boxes boxes;
        boxes.bound.assign(static_cast<std::size_t>(levels.shells.count() + 1) * n_directions, 1);
        boxes.at(7, 3) = 5;
        const double inner = levels.shells.radius(6), outer = levels.shells.radius(7), from = directions[3], to = directions[4],
                     middle = (from + to) / 2;
        CHECK(levels.lookup(boxes, {inner * 1.001, outer * 0.999, middle, middle}) == 5);
        CHECK(levels.lookup(boxes, {inner * 0.5, inner * 0.999, middle, middle}) == 1);
        CHECK(levels.lookup(boxes, {outer * 1.001, outer * 1.5, middle, middle}) == 1);
        CHECK(levels.lookup(boxes, {inner * 0.5, inner * 1.001, middle, middle}) == 5);
        CHECK(levels.lookup(boxes, {outer * 0.999, outer * 2, middle, middle}) == 5);
        CHECK(levels.lookup(boxes, {outer * 1.001, outer * 1.001, 0, 3}) == 1);
        // a range that ends where a box begins meets that box
        CHECK(levels.lookup(boxes, {outer, outer, 0, from}) == 5);
        CHECK(levels.lookup(boxes, {outer, outer, to, 3}) == 5);
        CHECK(levels.lookup(boxes, {inner, inner, middle, middle}) == 5);
        CHECK(levels.lookup(boxes, {outer, outer, 0, from - 1e-6}) == 1);
        CHECK(levels.lookup(boxes, {outer, outer, to + 1e-6, 3}) == 1);
        const double end = levels.shells.radius(levels.shells.count());
        CHECK(levels.lookup(boxes, {1, end * (1 - 1e-6), 0, 1}) == 1);
        CHECK(std::isinf(levels.lookup(boxes, {1, end * (1 + 1e-6), 0, 1})));
    }
}

TEST_CASE("Chebyshev's polynomials at their points, by value and as powers")
{
    const WorkingPrecision precision(bits);
    Levels levels(Law::density, Ball(3), Ball(Rational(1, 10)), 30);
    for (const long n : {1L, 2L, 7L, 24L}) {
        CAPTURE(n);
        const auto& table = levels.chebyshev_table(n);
        const auto& powers = levels.monomial_matrix(n);
        const auto N = static_cast<std::size_t>(n);
        for (std::size_t j = 0; j < N; ++j) {
            const double angle = std::numbers::pi * (static_cast<double>(j) + 0.5) / static_cast<double>(n);
            for (std::size_t i = 0; i < N; ++i)
                CHECK(table[i * N + j] == doctest::Approx(std::cos(static_cast<double>(i) * angle)).epsilon(1e-9));
        }
        // the values of x^k for k < n are those of the polynomial that is 1 at k alone
        for (std::size_t k = 0; k < N; ++k)
            for (std::size_t p = 0; p < N; ++p) {
                Ball sum(0);
                for (std::size_t j = 0; j < N; ++j) {
                    Ball x = Traits::cos_pi(Traits::quotient(static_cast<long>(2 * j + 1), 2 * n)), power;
                    arb_pow_ui(power.get(), x.get(), k, bits);
                    sum += powers[p * N + j] * power;
                }
                CHECK(sum.overlaps(Ball(p == k ? 1 : 0)));
                CHECK(sum.radius_bound() < 1e-9);
            }
    }
}

TEST_CASE("a panel's errors of interpolation are the sums of what Chebyshev's series has beyond it")
{
    const WorkingPrecision precision(Levels::precision_for(30));
    for (const Law law : {Law::density, Law::exceedance}) {
        Levels levels(law, Ball(3), Ball(Rational(1, 10)), 30);
        levels.extend_to(3);
        for (const long k : {2L, 3L})
            for (const auto& panel : levels.levels[static_cast<std::size_t>(k)]->panels) {
                const auto N = static_cast<double>(panel->points);
                double values = 0, slopes = 0,
                       proved = 0; // |c_k| <= 2 U rho^-k, twice for the interpolant; T_k' <= k^2, and N^2 where it is folded
                for (double j = N; j < N + 2000; ++j) {
                    const double c = 2 * panel->bound * std::pow(panel->rho, -j);
                    values += 2 * c;
                    slopes += c * (j * j + N * N);
                    proved += 2 * c * j * j;
                }
                CAPTURE(panel->rho);
                CAPTURE(N);
                CHECK(panel->interpolation >= values * (1 - 1e-12));
                CHECK(panel->interpolation <= values * (1 + 1e-4));
                CHECK(proved >= slopes);
                CHECK(panel->slope >= proved * (1 - 1e-9));
                CHECK(panel->slope <= proved * (1 + 1e-4));
            }
    }
}

TEST_CASE("a bound on an ellipse is that of the boxes that it runs through, of none far from it")
{
    const WorkingPrecision precision(bits);
    const Levels levels(Law::exceedance, Ball(3), Ball(Rational(1, 10)), 30);
    Level to;
    to.k = 2;
    Points points;
    Boxes& boxes = to.boxes;
    boxes.bound.assign(static_cast<std::size_t>(levels.shells.count() + 1) * n_directions, 1);
    for (int round = 0; round < 60; ++round) {
        for (double& b : boxes.bound) b = std::exp(points.between(0, 12));
        for (const bool logarithmic : {false, true})
            for (const bool whole : {false, true}) {
                const double a = points.scale(1e-2, 5), b = a * points.between(1.2, 3), rho = points.between(1.6, 5);
                const double lo = logarithmic ? std::log(a) : a, hi = logarithmic ? std::log(b) : b, middle = (lo + hi) / 2,
                             half = (hi - lo) / 2;
                const double bound = levels.ellipse_bound(to, a, b, logarithmic, rho, whole);
                double least = 0, most = 0;
                bool far = false;
                for (int i = 0; i <= 2000; ++i) {
                    const Z w = std::polar(rho, std::numbers::pi * i / 2000), z = middle + half * (w + 1.0 / w) / 2.0;
                    const Z d = logarithmic ? std::exp(z) : z;
                    const double back =
                        whole ? std::abs(std::exp(logarithmic ? (d + 2.0 * z) / 2.0 : d / 2.0)) : 1; // times d where the variable is log d
                    const double here = std::abs(d), angle = std::fabs(std::arg(d)), near = 0.1 * half * (rho + 1 / rho) / 2,
                                 off = logarithmic ? near : std::min(3.0, near / here);
                    far = far || (logarithmic && std::fabs(z.imag()) + near > 3) || near > 0.9 * here;
                    least = std::max(least, back * levels.lookup(boxes, {here * (1 - 1e-9), here * (1 + 1e-9), angle, angle}));
                    const double wide = back * std::exp(whole ? near * (logarithmic ? 1.2 * here + 1 : 0.5) : 0);
                    most = std::max(most, wide * levels.lookup(boxes, {here * std::exp(-1.2 * off), here * std::exp(1.2 * off),
                                                                       std::max(0.0, angle - 1.2 * off), angle + 1.2 * off}));
                }
                if (far) continue;
                CAPTURE(a);
                CAPTURE(b);
                CAPTURE(rho);
                CAPTURE(logarithmic);
                CAPTURE(whole);
                CHECK(bound >= least * (1 - 1e-9));
                CHECK(bound <= most);
            }
    }
}

TEST_CASE("what a level holds far from the edge is what both of its parts come to at delta = 4")
{
    const WorkingPrecision precision(bits);
    for (const double e : {0.1, 0.5, 0.9})
        for (const double load : {0.01, 0.3, 0.9}) {
            const double k2 = 4 / std::numbers::pi * std::pow(1 - e, -1.5), d = 4,
                         a = std::min(std::pow(2 * std::sqrt(load), -1.5), std::pow(1 - load, -1.5));
            CAPTURE(e);
            CAPTURE(load);
            const auto is = [&](double found, double parts) {
                CHECK(found * std::exp(-2.5 * d) >= parts);
                CHECK(found * std::exp(-2.5 * d) <= 1.01 * parts);
            };
            is(next_tail(1, Ball::exactly(e), 0, load), 8 * a / std::numbers::pi * k2 * std::exp(-3 * d) * 2.02 * (d + 1.2));
            for (const double tail : {1e-3, 1., 1e6, 1e9})
                is(next_tail(2, Ball::exactly(e), tail, load), 1.01 * k2 * std::exp(6 - 3 * d) + 4.1 * tail * k2 * std::exp(-3 * d - 4));
        }
}

TEST_CASE("a row leaves out what lies beyond the longest distance that its rule reaches")
{
    const WorkingPrecision precision(Levels::precision_for(20));
    Levels levels(Law::density, Ball(3), Ball(Rational(1, 10)), 20);
    levels.extend_to(3);
    const Level& from = *levels.levels[2];
    for (const double d : {0.6 * levels.delta_max, 0.8 * levels.delta_max, 2 * levels.delta_max}) {
        const double low = 0.99 * d, high = 1.01 * d;
        const RowRule rule = levels.make_rule(from, Kind::step, low, high, 0, 1e-6);
        CAPTURE(d);
        CHECK(rule.reach <= levels.delta_max * low / high);
        CHECK(rule.reach >= levels.delta_max * low / high * (1 - 1e-4));
    }
    CHECK(std::isinf(levels.make_rule(from, Kind::step, 0.4 * levels.delta_max, 0.45 * levels.delta_max, 0, 1e-6).reach));
}

TEST_CASE("a rule's error holds as far around its distances as is asked: that of a range is that of its middle with half of it around")
{
    const WorkingPrecision precision(Levels::precision_for(20));
    for (const Law law : {Law::density, Law::exceedance}) {
        Levels levels(law, Ball(3), Ball(Rational(1, 10)), 20);
        levels.extend_to(2);
        for (const Kind kind : {Kind::step, Kind::slope}) {
            const Level& from = *levels.levels[2];
            const RowRule around = levels.make_rule(from, kind, 1, 1, 0.25, 1e-9),
                          range = levels.make_rule(from, kind, 0.75, 1.25, 0, 1e-9), neither = levels.make_rule(from, kind, 1, 1, 0, 1e-9);
            CHECK(around.error == doctest::Approx(range.error).scale(0).epsilon(1e-6));
            CHECK(around.nodes.size() == range.nodes.size());
            CHECK((around.nodes.size() != neither.nodes.size() || around.error != neither.error));
            REQUIRE(std::isinf(around.reach));
        }
    }
}

TEST_CASE("a density of the exceedances' law has the rule's error in its slope by Cauchy's bound, where nothing else is wrong")
{
    const WorkingPrecision precision(Levels::precision_for(20));
    Levels levels(Law::exceedance, Ball(3), Ball(Rational(1, 10)), 20);
    for (const long n : {2L, 3L}) {
        levels.extend_to(n);
        Level& from = *levels.levels[static_cast<std::size_t>(n)];
        for (const auto& panel : from.panels) {
            panel->interpolation = panel->slope = panel->worst = 0;
            std::fill(panel->errors.begin(), panel->errors.end(), 0.0);
        }
        for (const double d : {0.3, 1.5}) {
            constexpr double around = 0.04; // d of the disc on which the error is bounded
            const Levels::Value found = levels.density(n, Ball(1), Ball::exactly(d));
            const double front = std::pow(d, (static_cast<double>(n) - 1) / 2) * about(levels.constant_after(from)),
                         rule = found.row.rule_error;
            const double of_slope = front * rule / around, of_value = front * rule * static_cast<double>(n + 1) / 2;
            CAPTURE(n);
            CAPTURE(d);
            CHECK(found.row.interpolation == 0);
            CHECK(found.value.radius_bound() >= (of_slope + of_value) * (1 - 1e-6));
            CHECK(found.value.radius_bound() <= (of_slope + of_value) * 1.01);
        }
    }
}

TEST_CASE("a root whose argument meets the cut has no bound, of the two in a kernel either alone; nor has the first level")
{
    const WorkingPrecision precision(bits);
    const auto real = [](double x) { return disc(x, 0, 1e-9); };
    for (const Law law : {Law::density, Law::exceedance}) {
        const Levels levels(law, Ball(3), Ball(Rational(1, 10)), 20);
        const auto bound = [&](double x, double w4) {
            return levels.modulus(real(x), real(1 - x), real(w4), real(1), infinity, Kind::step);
        };
        CHECK(std::isfinite(bound(0.5, 0.1)));
        CHECK(std::isinf(bound(-3, -12.1))); // R = 1.97: 1 + x + R is below 0, 1 - x + R above
        CHECK(std::isinf(bound(2, -0.5)));   // R = 0.71: the other way round
    }
    const Levels full(Law::density, Ball(3), Ball(1), 20);
    CHECK(std::isfinite(full.first_bound(disc(0.5, 0, 1e-9))));
    CHECK(std::isinf(full.first_bound(disc(-0.1, std::numbers::pi, 1e-9)))); // 1 + exp(-d) is below 0
}

TEST_CASE("what the laws are proved for: G above 2, loads above 0 and up to 1, each alone")
{
    for (const Law law : {Law::density, Law::exceedance})
        for (const auto& [G, load] : {std::pair(Rational(2), Rational(1, 10)),
                                      {Rational(3, 2), Rational(1)},
                                      {Rational(3), Rational(0)},
                                      {Rational(3), Rational(-1)},
                                      {Rational(3), Rational(101, 100)}}) {
            CAPTURE(about(Ball(G)));
            CAPTURE(about(Ball(load)));
            const Arguments at{[&load = load] { return Ball(load); }, [&G = G] { return Ball(G); }};
            CHECK_THROWS_WITH_AS(transfer::density(
                                     law, 2, [] { return Ball(1) / 10; }, at, Accuracy{10}),
                                 "needs G > 2 and 0 < load <= 1", BeyondReach);
        }
}

TEST_CASE("over a narrow disc the bound of a row's integrand, of the tangent of half the angle, is that of its factors at the middle")
{
    const WorkingPrecision precision(Levels::precision_for(20));
    for (const Law law : {Law::density, Law::exceedance}) {
        Levels levels(law, Ball(3), Ball(Rational(1, 10)), 20);
        levels.extend_to(3);
        Points points;
        int looked_at = 0;
        for (int i = 0; i < 200; ++i) {
            const Level& from = *levels.levels[1 + static_cast<std::size_t>(i % 3)];
            const Z d = std::polar(points.scale(0.01, 10), points.between(0, 0.5)), t(points.between(0.1, 0.9), points.between(-0.3, 0.3));
            const Z sine = 2.0 * t / (1.0 + t * t), cosine = (1.0 - t * t) / (1.0 + t * t), delta = 2.0 * d * sine * sine;
            constexpr double narrow = 1e-11;
            const auto about_it = [](const Z& z) { return Disc(z, narrow * std::abs(z)); };
            const double u = levels.lookup(from.boxes, polar(about_it(delta)));
            for (const Kind kind : {Kind::step, Kind::share}) {
                const double kernel = levels.kernel_bound(disc(from.edge_bound), about_it(d), about_it(sine * sine),
                                                          about_it(cosine * cosine), infinity, kind);
                const double bound = levels.integrand_bound(from, kind, about_it(d), about_it(t));
                double product =
                    2 / std::abs(1.0 + t * t) * std::pow(std::abs(sine), static_cast<double>(levels.power(from.k))) * kernel * u;
                if (kind == Kind::share) product *= std::abs(cosine * std::exp(-delta / 2.0));
                if (!std::isfinite(product) || !std::isfinite(bound)) continue;
                ++looked_at;
                CAPTURE(i);
                CHECK(bound == doctest::Approx(product).scale(0).epsilon(1e-6));
            }
        }
        CHECK(looked_at > 200);
    }
}

TEST_CASE("a piece of a row that is negligible counts for its length over the norm of the sines times its largest integrand")
{
    const WorkingPrecision precision(Levels::precision_for(20));
    for (const Law law : {Law::density, Law::exceedance}) {
        Levels levels(law, Ball(3), Ball(Rational(1, 10)), 20);
        levels.extend_to(4);
        Level& from = *levels.levels[4];
        const double low = 1e5 * levels.delta_max, high = 1.01 * low;
        levels.most_gauss = 3; // fewer than any rule has: the pieces are halved until each is negligible at so little accuracy
        const double sine = std::sqrt(levels.delta_max / (2 * high));
        double end = sine / (1 + std::sqrt(1 - sine * sine));
        const auto most = [&] { return levels.integrand_bound(from, Kind::step, disc_over(low, high), disc(end / 2, 0, end / 2)); };
        while (std::isinf(most())) end /= 2;
        const double reach =
            2 * high * 4 * end * end; // of delta in the piece at 0; the others, and discs about them, keep away from a tenth of it
        for (int shell = 0; shell <= levels.shells.count(); ++shell)
            for (int m = 0; m < n_directions; ++m)
                if (double& b = from.boxes.at(shell, m); std::isfinite(b))
                    b = levels.shells.radius(shell) < 0.1 * reach ? 1 : smallest_bound;
        const double counts = end / about(Levels::wallis(levels.power(4))) * most();
        const RowRule rule = levels.make_rule(from, Kind::step, low, high, 0, 1e300);
        CHECK(rule.nodes.empty());
        CHECK(rule.error >= counts * (1 - 1e-3));
        CHECK(rule.error <= counts * (1 + 1e-3));
    }
}

TEST_CASE("over a level: the load and the contact area, and what interpolation, nodes and the far end may change of an integral")
{
    const WorkingPrecision precision(Levels::precision_for(24));
    const Rational load(1, 10);
    for (const Law law : {Law::density, Law::exceedance}) {
        Levels levels(law, Ball(3), Ball(load), 24);
        const Ball force = levels.force(1);
        CHECK(force.contains(load));
        CHECK(force.relative_bits() > 20);
        Level& level = *levels.levels[2];
        for (const auto& panel : level.panels)
            std::fill(panel->errors.begin(), panel->errors.end(), panel->interpolation = panel->worst = 0);
        for (const long twice : {0L, 3L})
            for (const bool of_nodes : {false, true}) {
                double expected = 0;
                for (const auto& panel : level.panels) {
                    (of_nodes ? panel->worst : panel->interpolation) = 1;
                    double largest = 0;
                    for (int i = 0; i <= 1000; ++i) {
                        const double d = panel->a + (panel->b - panel->a) * i / 1000;
                        largest = std::max(largest, std::pow(d, static_cast<double>(twice) / 2) * std::exp(-d / 2));
                    }
                    expected += largest * (panel->b - panel->a) *
                                (of_nodes ? 2 / std::numbers::pi * std::log(static_cast<double>(panel->points)) + 1 : 1);
                }
                const double found = levels.over_level(level, twice, Ball(1) / 2).first.radius_bound();
                for (const auto& panel : level.panels) panel->interpolation = panel->worst = 0;
                CAPTURE(twice);
                CAPTURE(of_nodes);
                CHECK(found >= expected);
                CHECK(found <= expected * 1.0001);
            }
        level.tail = 1e200; // so that the far end alone counts
        const double end = level.panels.back()->b, scale = about(level.C) * 0.1;
        if (law == Law::density) {
            CHECK(levels.force(1).radius_bound() >= scale / about(level.C) * 1e200 * std::exp(-2.5 * end) / 2.5);
            CHECK(levels.force(1).radius_bound() <= 1.0001 * scale / about(level.C) * 1e200 * std::exp(-2.5 * end) / 2.5);
            const double area_holds = scale / about(level.C) * 1e200 * std::exp(-1.5 * end) / 1.5 / about(levels.highest(level));
            CHECK(levels.mass(1).radius_bound() >= area_holds);
            CHECK(levels.mass(1).radius_bound() <= 1.0001 * area_holds);
        }
    }
    Levels levels(Law::density, Ball(3), Ball(load), 24);
    const Ball area = levels.mass(1);
    CHECK(area.overlaps(area_by_slope(1, {load, [] { return Ball(3); }, Rational(3)}, 40)));
    CHECK(area.relative_bits() > 20);
}

TEST_CASE("what the polynomials' own roundings do to a row: a share of their values' errors, and n^2 times as much of a slope's")
{
    const WorkingPrecision precision(Levels::precision_for(20));
    for (const Law law : {Law::density, Law::exceedance}) {
        Levels levels(law, Ball(3), Ball(Rational(1, 10)), 20);
        levels.extend_to(3);
        const Level& from = *levels.levels[2];
        double fewest = infinity, most = 0;
        for (const auto& panel : from.panels) { // the row's sum of |k| is then what it says of the interpolation
            panel->interpolation = panel->worst = 1;
            panel->slope = 0;
            std::fill(panel->errors.begin(), panel->errors.end(), 0);
            fewest = std::min(fewest, static_cast<double>(panel->points));
            most = std::max(most, static_cast<double>(panel->points));
        }
        for (const double d : {0.01, 0.7, 5.}) {
            const RowRule rule = levels.make_rule(from, Kind::step, d * 0.99, d * 1.01, 0, 1e-6);
            const Levels::Row values = levels.row(from, Kind::step, Ball::exactly(d), rule),
                              slopes = levels.row(from, Kind::slope, Ball::exactly(d), rule);
            CAPTURE(d);
            CHECK(values.carried >= (at_panel_end + slack * fewest) * values.interpolation * (1 - 1e-7));
            CHECK(values.carried <= (at_panel_end + slack * most) * values.interpolation * (1 + 1e-7));
            CHECK(slopes.carried >= (at_panel_end + slack * fewest) * slopes.interpolation * fewest * fewest * (1 - 1e-7));
        }
    }
}

TEST_CASE("what the form for small pressures leaves out is what the header proves of it")
{
    const WorkingPrecision precision(Levels::precision_for(20));
    Levels levels(Law::exceedance, Ball(3), Ball(Rational(1, 10)), 20);
    for (const long n : {2L, 3L}) {
        const Levels::Value found = levels.small_density(n, Ball(80));
        const Level& level = *levels.whole[n];
        const double e = about(level.edge), c = found.cut, w = n == 2 ? (c + 1 + 1.2) / 5.2 : 1;
        REQUIRE(c > 4);
        const double left_out = 0.1 / (std::pow(3., static_cast<double>(n)) * e) * std::pow(1 - e * std::exp(-c), -1.5) * 3.5 * level.tail *
                                w * std::exp(2 - 1.5 * c);
        CAPTURE(n);
        CAPTURE(c);
        CHECK(found.row.rule_error >= left_out);
        CHECK(found.row.rule_error <= 1.0001 * left_out);
    }
}

TEST_CASE("a certificate tells what each level has, and what the row at p is off by, relative to its value, and of which form it is")
{
    const WorkingPrecision precision(Levels::precision_for(20));
    for (const Law law : {Law::density, Law::exceedance}) {
        Levels levels(law, Ball(3), Ball(Rational(1, 10)), 20);
        Forward forward(law, [] { return Ball(3); }, [] { return Ball(Rational(1, 10)); }, 20);
        for (const double d : {0.01, 4., 80.}) { // v is far from 1 at the last two
            const Levels::Value q = levels.density(2, Ball(1), Ball::exactly(d));
            const double v = std::fabs(about(q.row.value));
            const std::string errors = fmt::format("{:.1e}, interpolation {:.1e}, carried {:.1e}\n", q.row.rule_error / v,
                                                   q.row.interpolation / v, q.row.carried / v);
            const bool small = law == Law::exceedance && d > 40;
            const std::string told = small ? fmt::format("  at p: small, by parts over E_2 up to delta = {:.1f}; of q: beyond ", q.cut)
                                           : fmt::format("  at p: {} points; of v: rule ", q.nodes);
            CAPTURE(d);
            CHECK((q.cut > 0) == small);
            const Level& level = small ? *levels.whole[2] : *levels.levels[2];
            std::string head = fmt::format("{} law: {} bits, far end from delta = {:.0f}\n", law == Law::density ? "density" : "exceedance",
                                           levels.precision, levels.delta_max);
            head += fmt::format("  scale {:2}: {:2} panels, {:4} nodes, {:4} points a row; of v: rows {:.1e}, ", 1, level.panels.size(),
                                level.nodes, level.row_nodes / level.nodes, level.worst_row);
            head += fmt::format("carried {:.1e}, all {:.1e}; interpolation {:.1e}\n", level.worst_carried, level.worst_total,
                                level.worst_interpolation);
            CHECK(forward.certificate(2, Ball(1), Ball::exactly(d)) == head + told + errors);
        }
    }
}

TEST_CASE("what a node's error does to a row, and to its slope, is what the row makes of the polynomial that is 1 at that node alone")
{
    const WorkingPrecision precision(Levels::precision_for(20));
    for (const Law law : {Law::density, Law::exceedance}) {
        Levels levels(law, Ball(3), Ball(Rational(1, 10)), 20);
        levels.extend_to(3);
        const Level& from = *levels.levels[3];
        const auto set = [&](Panel& panel, const std::function<Ball(std::size_t)>& coefficient) {
            for (std::size_t k = 0; k < static_cast<std::size_t>(panel.points); ++k)
                arb_set(panel.polynomial->coeffs + k, coefficient(k).get());
            levels.make_fixed(panel);
        };
        const auto nothing = [](std::size_t) { return Ball(0); };
        for (const auto& panel : from.panels) {
            set(*panel, nothing);
            panel->interpolation = panel->slope = panel->worst = 0;
            std::fill(panel->errors.begin(), panel->errors.end(), 0);
        }
        const double d = 0.8;
        const RowRule rule = levels.make_rule(from, Kind::step, d * 0.99, d * 1.01, 0, 1e-9);
        for (const std::size_t which : {std::size_t{0}, from.panels.size() / 2}) {
            Panel& panel = *from.panels[which];
            if (panel.a > d) continue;
            const auto N = static_cast<std::size_t>(panel.points);
            const auto& A = levels.monomial_matrix(panel.points);
            for (const std::size_t node : {std::size_t{0}, N / 3, N - 1}) {
                set(panel, [&](std::size_t k) { return A[k * N + node]; });
                panel.errors[node] = 1;
                const Levels::Row values = levels.row(from, Kind::step, Ball::exactly(d), rule),
                                  slopes = levels.row(from, Kind::slope, Ball::exactly(d), rule);
                panel.errors[node] = 0;
                CAPTURE(which);
                CAPTURE(node);
                CHECK(values.carried == doctest::Approx(std::fabs(about(values.value))).scale(0).epsilon(1e-6));
                CHECK(slopes.carried == doctest::Approx(std::fabs(about(slopes.slope))).scale(0).epsilon(1e-6));
            }
            set(panel, nothing);
        }
    }
}

TEST_CASE("the bound of a step is the sum over sectors of the angle, each with the shells that it reaches")
{
    const WorkingPrecision precision(bits);
    Levels levels(Law::density, Ball(3), Ball(Rational(1, 10)), 20);
    Level &from = *levels.levels[1], to;
    to.k = 2;
    from.boxes.disc = 6;
    const auto share = Levels::sector_shares(levels.power(1));
    const int shell = 20; // so near the edge that the kernel is a constant
    const auto bound = [&](int above) { // where the level is 1 up to that shell, and 2 beyond
        for (int j = 0; j <= levels.shells.count(); ++j)
            for (int m = 0; m < n_directions; ++m) from.boxes.at(j, m) = j <= above ? 1 : 2;
        levels.bound_boxes(from, to);
        return to.boxes.at(shell, 0);
    };
    const double one = bound(levels.shells.count());
    for (const int above : {shell - 4, shell + 1, shell + 3, shell + 5}) {
        double sum = 0, all = 0;
        for (std::size_t i = 0; i < share.size(); ++i) {
            const double angle = std::numbers::pi / 2 * static_cast<double>(i + 1) / static_cast<double>(share.size()); // its largest
            const double reaches = 2 * levels.shells.radius(shell) * std::pow(std::sin(angle), 2);
            sum += share[i] * (reaches > levels.shells.radius(above) * (1 + 1e-6) ? 2 : 1);
            all += share[i];
        }
        CAPTURE(above);
        CHECK(bound(above) / one == doctest::Approx(sum / all).epsilon(1e-4));
    }
}

TEST_CASE("where the level is multiplied out, its bound on an ellipse has the multiplier's at the far side of each disc")
{
    const WorkingPrecision precision(bits);
    const Levels levels(Law::exceedance, Ball(3), Ball(Rational(1, 10)), 30);
    Level to;
    to.k = 3;
    to.boxes.bound.assign(static_cast<std::size_t>(levels.shells.count() + 1) * n_directions, 1);
    const double a = 0.7, b = 1.1, rho = 2.5, A = (rho + 1 / rho) / 2, B = (rho - 1 / rho) / 2;
    const double mid = std::log(a * b) / 2, half = std::log(b / a) / 2;
    constexpr int arcs = 40;
    const double radius = half * A * std::numbers::pi / (2 * arcs);
    double most = 0; // of |e^(d/2) d^(3/2)|, d = e^z
    for (int i = 0; i < arcs; ++i) {
        const double phi = std::numbers::pi * (i + 0.5) / arcs;
        const double x = mid + half * A * std::cos(phi) + radius, y = std::max(0.0, half * B * std::sin(phi) - radius);
        most = std::max(most, std::exp((std::exp(x) * std::cos(y) + 3 * x) / 2));
    }
    const double bound = levels.ellipse_bound(to, a, b, true, rho, true);
    CHECK(bound >= most);
    CHECK(bound <= most * (1 + 2e-6));
}

TEST_CASE("the form for small pressures: what interpolation and nodes of one panel may change is what the header has of both")
{
    const WorkingPrecision precision(Levels::precision_for(20));
    Levels levels(Law::exceedance, Ball(3), Ball(Rational(1, 10)), 20);
    for (const long n : {2L, 3L}) {
        levels.small_density(n, Ball(80));
        const Level& level = *levels.whole[n];
        const double e = above(level.edge_bound), C = about(level.C);
        for (const auto& panel : level.panels) panel->interpolation = panel->worst = 0;
        for (const std::size_t which : {std::size_t{0}, level.panels.size() / 2}) {
            Panel& panel = *level.panels[which];
            panel.interpolation = panel.worst = 1;
            const Levels::Row found = levels.small_density(n, Ball(80)).row;
            panel.interpolation = panel.worst = 0;
            const double x = e * std::exp(-panel.a);
            const double back = panel.logarithmic ? 1 : std::pow(panel.b, static_cast<double>(n) / 2); // E_n is v_n times that
            const auto h = [e](double delta) { return 1.26 * std::pow(1 - e * std::exp(-delta), -1.5); };
            double off = C * h(panel.a) * (0.8 + 1.75 * x / (1 - x)) * 2 * (std::exp(panel.b / 2) - std::exp(panel.a / 2)) * back;
            if (&panel == level.panels.back().get()) off += C * h(panel.b) * std::exp(panel.b / 2);
            const double lebesgue = 2 / std::numbers::pi * std::log(static_cast<double>(panel.points)) + 1;
            CAPTURE(n);
            CAPTURE(which);
            CHECK(found.interpolation >= off);
            CHECK(found.interpolation <= off * (1 + 2e-6));
            CHECK(found.carried >= off * lebesgue);
            CHECK(found.carried <= off * lebesgue * (1 + 2e-6));
            const double together = found.interpolation + found.carried + found.rule_error, radius = found.value.radius_bound();
            CHECK(radius >= together * (1 - 1e-9));
            CHECK(radius <= together * (1 + 2e-5)); // radii have a few bits fewer
        }
    }
}

TEST_CASE("what a row leaves out beyond its reach is what both laws allow there, over the power of d and the constant of the next level")
{
    const WorkingPrecision precision(Levels::precision_for(20));
    for (const Law law : {Law::density, Law::exceedance}) {
        Levels levels(law, Ball(3), Ball(Rational(1, 10)), 20);
        levels.extend_to(3);
        for (const long k : {2L, 3L}) {
            const Level& from = *levels.levels[static_cast<std::size_t>(k)];
            const double e = about(from.edge), C = about(levels.constant_after(from)), n = static_cast<double>(k);
            for (const double d : {3., 50.})
                for (const double reach : {2., 40.}) {
                    const double kernel = 4 / std::numbers::pi * std::pow(1 - e, -1.5);
                    const double there = law == Law::density ? 4.1 * kernel * from.tail * std::exp(-reach) * std::pow(d, -(n - 1) / 2)
                                                             : std::sqrt(e) * std::exp(-reach / 2) * std::pow(d, -(n + 1) / 2);
                    const double found = levels.dropped(from, Kind::step, d, reach);
                    CAPTURE(k);
                    CHECK(found >= there / C);
                    CHECK(found <= there / C * (1 + 3e-6));
                }
        }
    }
}

TEST_CASE("no ellipse of a rule holds t = i, and the rule's error is Gauss's bound on one that does not, as small as was asked")
{
    const WorkingPrecision precision(Levels::precision_for(20));
    for (const Law law : {Law::density, Law::exceedance}) {
        Levels levels(law, Ball(3), Ball(Rational(1, 10)), 20);
        levels.extend_to(3);
        for (const long k : {1L, 3L})
            for (const double d : {1e-9, 0.01, 0.05}) {
                const Level& from = *levels.levels[static_cast<std::size_t>(k)];
                const double tolerance = 1e-9, l = 0.5; // one piece from 0 to 1
                const RowRule rule = levels.make_rule(from, Kind::step, d, d, 0, tolerance);
                const auto n = static_cast<double>(rule.nodes.size());
                double nearest = infinity;
                for (const double r : settings(law).piece_rhos) {
                    const double A = (r + 1 / r) / 2, B = (r - 1 / r) / 2;
                    if (1 / (A * l * A * l) * 0.25 + 1 / (B * l * B * l) <= 1) continue; // ((0 - mid)/(A l))^2 + (1/(B l))^2
                    double most = 0;
                    constexpr int arcs = 24;
                    for (int i = 0; i < arcs; ++i) {
                        const double phi = std::numbers::pi * (i + 0.5) / arcs;
                        const double radius = up(l * A * std::numbers::pi / (2 * arcs));
                        const Disc t = disc(l + l * A * std::cos(phi), l * B * std::sin(phi), radius);
                        most = std::max(most, levels.integrand_bound(from, Kind::step, disc_over(down(d), up(d)), t));
                    }
                    // 2 (2 + 2/3) M sum_{k >= 2n} r^-k, half the length of the piece, over the norm
                    const double error = 16.0 / 3 * most * std::pow(r, -2 * n) / (1 - 1 / r) * l / about(Levels::wallis(levels.power(k)));
                    if (std::isfinite(error)) nearest = std::min(nearest, std::fabs(rule.error / error - 1));
                }
                CAPTURE(k);
                CAPTURE(d);
                CHECK(nearest < 1e-6);
                CHECK(rule.error <= tolerance / 8 * (1 + 1e-6));
                // of the kernel and the level 1: what is left of the mean of sin^m is 1
                double sum = 0;
                for (const RuleNode& node : rule.nodes) sum += about(node.weight);
                CHECK(std::fabs(sum - 1) < 1e-8);
            }
    }
}

TEST_CASE("a rule serves the distances that it was made for and no others, and where no box is proven there is none")
{
    const WorkingPrecision precision(Levels::precision_for(20));
    for (const Law law : {Law::density, Law::exceedance}) {
        Levels levels(law, Ball(3), Ball(Rational(1, 10)), 20);
        levels.extend_to(3);
        Level& from = *levels.levels[2];
        const RowRule rule = levels.make_rule(from, Kind::step, 0.5, 0.75, 0.125, 1e-9);
        CHECK(rule.around == 0.125);
        const auto row = [&](double d) { return levels.row(from, Kind::step, Ball::exactly(d), rule); };
        for (const double d : {0.5, 0.6, 0.75}) CHECK(row(d).rule_error == rule.error);
        for (const double d : {0.25, 0.499, 0.751, 2.}) CHECK(std::isinf(row(d).error));
        for (const double share : {0.4, 0.6, 2.}) { // of the slack of bounds
            Ball d = Ball::exactly(0.625);
            widen(d, share * slack * 0.625);
            CHECK(std::isfinite(levels.row(from, Kind::step, d, rule).error) == (share < 0.5));
        }
        RowRule cut = rule; // where something is left out, too
        cut.reach = 3;
        CHECK(levels.row(from, Kind::step, Ball::exactly(0.6), cut).rule_error
              == doctest::Approx(rule.error + levels.dropped(from, Kind::step, 0.6, 3)).scale(0).epsilon(1e-9));
        std::fill(from.boxes.bound.begin(), from.boxes.bound.end(), infinity);
        CHECK_THROWS_AS(levels.make_rule(from, Kind::step, 0.5, 0.75, 0, 1e-9), BeyondReach);
    }
}

TEST_CASE("what a row says of a level's interpolation, slope and roundings is the sum over its points, each with its kernel and its slope")
{
    const WorkingPrecision precision(Levels::precision_for(20));
    for (const Law law : {Law::density, Law::exceedance}) {
        Levels levels(law, Ball(3), Ball(Rational(9, 10)), 20);
        levels.extend_to(3);
        const Direct direct{law, 3, 0.9, false};
        const Level& from = *levels.levels[2];
        for (const double d : {0.05, 0.7, 6.}) {
            const RowRule rule = levels.make_rule(from, Kind::step, d, d, 0, 1e-9);
            double values = 0, with_slope = 0, slopes = 0, rounding = 0, rounding_of_slopes = 0;
            for (const RuleNode& node : rule.nodes) {
                const double s = about(node.s), delta = 2 * d * s, h = 1e-4 * d;
                const auto kernel = [&](double at) { return std::abs(direct.kernel(direct.edge(2), at, s)); };
                const double k = about(node.weight) * kernel(d), of_log = std::fabs(std::log(kernel(d + h) / kernel(d - h)) / (2 * h));
                const Panel& panel =
                    **std::find_if(from.panels.begin(), from.panels.end(), [delta](const auto& p) { return delta <= p->b; });
                const auto n = static_cast<double>(panel.points);
                const double scale = about(panel.half) * (panel.logarithmic ? delta : 1); // delta over xi
                values += k;
                with_slope += k * of_log;
                slopes += k * 2 * s / scale;
                rounding += k * (at_panel_end + slack * n);
                rounding_of_slopes += k * (at_panel_end + slack * n) * n * n * (1 + of_log + 2 / scale);
            }
            const auto rows = [&](double interpolation, double slope, double worst) {
                for (const auto& panel : from.panels) {
                    panel->interpolation = interpolation;
                    panel->slope = slope;
                    panel->worst = worst;
                    std::fill(panel->errors.begin(), panel->errors.end(), 0);
                }
                return std::pair{levels.row(from, Kind::step, Ball::exactly(d), rule),
                                 levels.row(from, Kind::slope, Ball::exactly(d), rule)};
            };
            const auto is = [](double found, double sum) { CHECK(found == doctest::Approx(sum).scale(0).epsilon(1e-5)); };
            CAPTURE(d);
            const auto [value, slope] = rows(1, 0, 0);
            is(value.interpolation, values);
            CHECK(value.carried == 0);
            CHECK(value.error >= value.interpolation + value.rule_error);
            const auto [value_of_slopes, slope_of_slopes] = rows(0, 1, 0);
            CHECK(value_of_slopes.interpolation == 0);
            const auto [rounded, rounded_slope] = rows(0, 0, 1);
            is(rounded.carried, rounding);
            CHECK(rounded.error >= rounded.carried + rounded.rule_error);
            const auto [both, both_of_slope] = rows(1, 1, 0);
            if (law == Law::density) continue; // of which no slope is asked
            is(slope.interpolation, with_slope);
            is(slope_of_slopes.interpolation, slopes);
            is(both_of_slope.interpolation, with_slope + slopes);
            is(rounded_slope.carried, rounding_of_slopes);
        }
    }
}

TEST_CASE("a density of the exceedances' law has all that its rows say in its radius, and the other law's exceedance the far end")
{
    const WorkingPrecision precision(Levels::precision_for(20));
    Levels levels(Law::exceedance, Ball(3), Ball(Rational(1, 10)), 20);
    for (const long n : {2L, 3L}) {
        levels.extend_to(n);
        Level& from = *levels.levels[static_cast<std::size_t>(n)];
        levels.epsilon = 1e3; // so that the rule's error is seen beside these
        for (const double d : {0.3, 1.5}) {
            const RowRule rule = levels.rule_at(from, Kind::slope, Ball::exactly(d), 0.04);
            CHECK(rule.around == doctest::Approx(0.04 * d).scale(0));
            for (const auto& [interpolation, worst] : {std::pair(1.0, 0.5), {0.5, 1.0}}) {
                for (const auto& panel : from.panels) {
                    panel->interpolation = panel->slope = interpolation;
                    panel->worst = worst;
                    std::fill(panel->errors.begin(), panel->errors.end(), worst);
                }
                const Levels::Row value = levels.row(from, Kind::step, Ball::exactly(d), rule),
                                  slope = levels.row(from, Kind::slope, Ball::exactly(d), rule);
                const double front = std::pow(d, (static_cast<double>(n) - 1) / 2) * about(levels.constant_after(from));
                const double of_value = front * value.error * static_cast<double>(n + 1) / 2,
                             of_slope = front * d * (rule.error / (0.04 * d) + slope.interpolation + slope.carried);
                const double radius = levels.density(n, Ball(1), Ball::exactly(d)).value.radius_bound();
                CAPTURE(n);
                CAPTURE(d);
                CHECK(radius >= (of_value + of_slope) * (1 - 1e-6));
                CHECK(radius <= (of_value + of_slope) * (1 + 1e-6));
                CHECK(of_slope > 0.1 * of_value);
                CHECK(rule.error / rule.around > 1e-4 * slope.carried);
            }
        }
        levels.epsilon = std::exp(-20) / 64;
    }
    Levels densities(Law::density, Ball(3), Ball(Rational(1, 10)), 20);
    densities.extend_to(2);
    Level& from = *densities.levels[2];
    const Ball d = Ball::exactly(densities.delta_max);
    const double reach = densities.rule_at(from, Kind::share, d, 0).reach;
    REQUIRE(std::isfinite(reach));
    from.tail = 1e200; // so that the far end alone counts: load f/(G^n x), x = e_n e^-delta, f <= T e^(-5 delta/2)
    const double beyond = 0.1 / (9 * about(from.edge)) * 1e200 * std::exp(-1.5 * reach) / 1.5,
                 radius = densities.exceedance(2, d).value.radius_bound();
    CHECK(radius >= beyond);
    CHECK(radius <= beyond * (1 + 1e-6));
}

TEST_CASE("the form for small pressures is taken where its proof holds: 2 d more than 1 beyond where it is cut off")
{
    const WorkingPrecision precision(Levels::precision_for(20));
    const Ball load(Rational(1, 10));
    const Levels levels(Law::exceedance, Ball(3), load, 20), densities(Law::density, Ball(3), load, 20);
    for (const long n : {1L, 2L, 3L}) {
        const double cut = cut_for_small(20, n == 1 ? 2 : n, levels.G, levels.load);
        CAPTURE(n);
        CHECK(levels.is_small(n, Ball::exactly((cut + 1.02) / 2)) == (n > 1));
        CHECK_FALSE(levels.is_small(n, Ball::exactly((cut + 1) / 2)));
        CHECK_FALSE(densities.is_small(n, Ball::exactly((cut + 1.02) / 2)));
    }
}

TEST_CASE("a panel's polynomial in fixed point: its ball holds the value at every point that xi may be, and the roundings that are counted")
{
    const WorkingPrecision precision(Levels::precision_for(20));
    Levels levels(Law::density, Ball(3), Ball(Rational(1, 10)), 20);
    Points points;
    for (const long n : {8L, 12L, 40L}) {
        Panel panel;
        panel.points = n;
        arb_poly_fit_length(panel.polynomial, n);
        for (long j = 0; j < n; ++j)
            arb_set(panel.polynomial->coeffs + j, Ball::exactly(points.between(-1, 1) * (j == n - 1 ? 1e3 : 1)).get());
        _arb_poly_set_length(panel.polynomial, n);
        levels.make_fixed(panel);
        int off = 0;
        for (int i = 0; i < 200; ++i) {
            const double x = points.between(-1, 1), radius = i % 2 == 0 ? 0 : points.scale(1e-12, 1e-3) * (1 - std::fabs(x));
            Ball xi = Ball::exactly(x), u;
            widen(xi, radius);
            levels.evaluate(panel, xi, u);
            for (const double at : {x - xi.radius_bound() * (1 - 1e-9), x, x + xi.radius_bound() * (1 - 1e-9)}) {
                Ball exact; // of numbers of 53 bits
                arb_poly_evaluate(exact.get(), panel.polynomial, Ball::exactly(at).get(), 53 * 50);
                CHECK(u.contains(exact));
            }
            Ball middle = u, exact;
            arb_get_mid_arb(middle.get(), middle.get());
            arb_poly_evaluate(exact.get(), panel.polynomial, Ball::exactly(x).get(), 53 * 50);
            off += !middle.contains(exact);
            // its coefficients come to less than 2^14 in the format, and to half of that at least
            double sum = 0;
            for (long j = 0; j < n; ++j) sum += std::fabs(arf_get_d(arb_midref(panel.polynomial->coeffs + j), ARF_RND_NEAR));
            CHECK(sum < std::ldexp(1.0, static_cast<int>(panel.scale + 14)));
            CHECK(sum > std::ldexp(0.49, static_cast<int>(panel.scale + 14)));
            // units of the format times 2^scale: n coefficients, as many products, xi's own times its largest slope
            const double unit = std::ldexp(1.0, static_cast<int>(panel.scale - levels.format.fraction()));
            const double slope = static_cast<double>(n) * std::ldexp(1.0, static_cast<int>(panel.scale + 14));
            if (radius == 0) CHECK(u.radius_bound() >= static_cast<double>(n) * (2 + 0x1p14) * unit);
            CHECK(u.radius_bound() <= 1.001 * (static_cast<double>(n) * 0x1p14 * unit + slope * xi.radius_bound()));
        }
        CHECK(off > 0); // that the format rounds is seen
    }
}

TEST_CASE("an ellipse of log d has no bound where a disc may reach the negative axis, one of d has the multiplier's at the far side")
{
    const WorkingPrecision precision(bits);
    const Levels levels(Law::exceedance, Ball(3), Ball(Rational(1, 10)), 30);
    Level to;
    to.k = 3;
    to.boxes.bound.assign(static_cast<std::size_t>(levels.shells.count() + 1) * n_directions, 1);
    const double rho = 3, A = (rho + 1 / rho) / 2, B = (rho - 1 / rho) / 2;
    constexpr int arcs = 40;
    for (const double top : {3.05, 3.15}) { // of the highest disc: half (B + pi A/(2 arcs)), but for the angle of its middle
        const double half = top / (B + A * std::numbers::pi / (2 * arcs));
        CAPTURE(top);
        CHECK(std::isinf(levels.ellipse_bound(to, std::exp(-half), std::exp(half), true, rho, false)) == (top > 3.1));
        CHECK(half * B < 3.1);
    }
    for (const auto& [a, b] : {std::pair(0.0, 0.5), {0.7, 1.9}, {2.0, 2.5}}) {
        const double mid = (a + b) / 2, half = (b - a) / 2, radius = half * A * std::numbers::pi / (2 * arcs);
        const double right = mid + half * A * std::cos(std::numbers::pi / (2 * arcs)) + radius, most = std::exp(right / 2); // of |e^(d/2)|
        const double bound = levels.ellipse_bound(to, a, b, false, rho, true);
        CAPTURE(a);
        CHECK(bound >= most);
        CHECK(bound <= most * (1 + 1e-6));
        CHECK(levels.ellipse_bound(to, a, b, false, rho, false) == 1);
    }
    CHECK(ellipse_height(rho) == doctest::Approx(B).scale(0).epsilon(1e-12));
}

TEST_CASE("both laws give one density and one exceedance, near the edge, far from it and where p is small, at few digits")
{
    const WorkingPrecision precision(Levels::precision_for(20));
    const auto compare = [](const Ball& G, const Ball& load, long last) {
        Levels densities(Law::density, G, load, 20), exceedances(Law::exceedance, G, load, 20);
        exceedances.extend_to(last + 1);
        for (long n = 1; n <= last; ++n)
            for (double distance : {0.01, 0.9, 2.5, infinity, 80.}) {
                if (n == 1 && distance > 50) continue; // of which the exceedances' law has no form
                if (std::isinf(distance)) distance = (cut_for_small(20, n, G, load) + 1.02) / 2; // where that of small p begins
                CHECK(exceedances.is_small(n, Ball::exactly(distance)) == (distance > 3));
                const Ball d = Ball::exactly(distance),
                           p = exceedances.highest(*exceedances.levels[static_cast<std::size_t>(n) + 1]) * exp(-d);
                const Ball q = densities.density(n, p, d).value, by_slope = exceedances.density(n, p, d).value;
                const Ball share = exceedances.exceedance(n, d).value, by_integral = densities.exceedance(n, d).value;
                CAPTURE(n);
                CAPTURE(distance);
                CHECK(q.overlaps(by_slope));
                CHECK(share.overlaps(by_integral));
                for (const Ball& found : {q, share, by_integral}) CHECK(found.relative_bits() > 24);
                CHECK(by_slope.relative_bits() > 12);
            }
    };
    compare(Ball(3), Ball(Rational(1, 10)), 3);
    compare(Ball(3), Ball(1), 1);
}

TEST_CASE("levels that need more points than a panel may have are refused, and so are those that no precision resolves")
{
    const WorkingPrecision precision(Levels::precision_for(20));
    for (const Law law : {Law::density, Law::exceedance}) {
        Levels levels(law, Ball(3), Ball(Rational(1, 10)), 20);
        levels.most_points = settings(law).least_points - 1;
        CHECK_THROWS_AS(levels.extend_to(2), BeyondReach);
        Levels unresolved(law, Ball(3), Ball(Rational(1, 10)), 20);
        arb_indeterminate(unresolved.levels[1]->edge.get());
        CHECK_THROWS_AS(unresolved.extend_to(2), BeyondReach);
    }
}
