// SPDX-License-Identifier: MIT
/// The bounds over discs that the levels of a distribution rest on (recursion/from_the_edge/boxes.cpp, binary64), held against the functions themselves at points of
/// those discs, in balls of 128 bits and written as forward.hpp has them. Nothing is shared but the formula.
#include "touchstone/recursion/from_the_edge/levels.hpp"

#include <doctest/doctest.h>

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
    std::complex<double> of(const Disc& z) { return z.centre() + std::polar(z.radius() * std::min(1.0, between(0, 3)) * (1 - 1e-12), between(-3.15, 3.15)); }
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
            const Disc d = disc(at.real(), at.imag(), reach * size), s = disc_over(points.between(0, 0.5), points.between(0.5, 0.52)), c = 1 - s;
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
                    const C R = load == 1 ? 2 * half : sqrt((1 - x) * (1 - x) + 4 * x * half * half), P = 1 + x + R, M = 1 - x + R, E = mean(2 * z);
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
