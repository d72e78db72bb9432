// SPDX-License-Identifier: MIT
#include "touchstone/transfer/two_waves.hpp"

#include "touchstone/catalogue/quantity.hpp"
#include "touchstone/recursion/first_steps/scale_one.hpp"
#include "touchstone/transfer/ellipse_cover.hpp"
#include "touchstone/wave/lemmas.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace touchstone;
using transfer::ScaleOne;
using transfer::to_ball;
using transfer::to_real;
using transfer::TwoWaves;
using transfer::Variable;

namespace {

/// The certified density at scale 1, in p*_1, of the pressure P p*_1.
Ball by_scale_one(const Rational& G, const Rational& P, const TwoWaves::Real& x)
{
    const ScaleOne q{[&] { return Ball(Rational(P * G)); }, Rational(x.high) + Rational(x.low), [&] { return Ball(G); }, Rational(P * G),
                     G};
    return transfer::scale_one_density(Variable::angle, q) * Ball(G);
}

struct WaveAndPressure {
    const char *G, *P;
};
void against_one_integral(std::initializer_list<WaveAndPressure> cases)
{
    const WorkingPrecision precision(200);
    for (const auto& c : cases) {
        const Rational G = *parse_rational(c.G), P = *parse_rational(c.P);
        const TwoWaves waves{Ball(G), Ball(P), 1e-22};
        const Rational top = G * (P + 1), inside = P < 2 ? Rational(G * P * P / 4) : Rational(G * (P - 1));
        std::vector<Rational> points;
        for (const char* x : {"1/50", "3/10", "999/1000", "1", "1001/1000", "7/4", "3", "9"}) points.push_back(*parse_rational(x));
        for (const char* off : {"1/100", "1e-6", "1e-14", "1e-22"}) // next to where upper, and lower, ends of the waves meet
            for (const int side : {-1, 1}) {
                points.push_back(top < 2 ? Rational(top * top / 4) : Rational(top - 1));
                points.back() += side * *parse_rational(off);
                points.push_back(inside + 1 + side * *parse_rational(off));
            }
        for (const Rational& point : points) {
            const auto x = to_real(Ball(point));
            const auto [value, error] = waves.value(x);
            INFO("G ", c.G, " P ", c.P, " x ", x.high, ": ", value.high, " +- ", error);
            REQUIRE(error < 1e-20);
            Ball own = to_ball(value);
            const Ball radius = Ball::exactly(error);
            arb_add_error(own.get(), radius.get());
            CHECK(own.overlaps(by_scale_one(G, P, x)));
        }
    }
}

} // namespace

TEST_CASE("the density after two waves against one integral over the angle, at ordinary pressures")
{
    against_one_integral({{"3/2", "1/2"}, {"6/5", "1"}});
}

TEST_CASE("the density after two waves against one integral over the angle, at a pressure near 0, and at 2, where both of its forms end")
{
    against_one_integral({{"2", "1/100"}, {"3/2", "2"}});
}

TEST_CASE("the density after two waves against one integral over the angle, next to pressure 2 and beyond it")
{
    against_one_integral({{"21/20", "3"}, {"5/2", "19/10"}});
}

TEST_CASE("a disc holds no singular point, and its bound holds")
{
    const WorkingPrecision precision(200);
    const Rational G(3, 2), P(1, 2);
    const TwoWaves waves{Ball(G), Ball(P), 1e-18};
    const auto bound = [&](const Rational& x, double r) {
        const auto at = to_real(Ball(x));
        const TwoWaves::Real half(r / 3);
        return waves.on_disc(at - half, at + half, at, r);
    };
    for (const Rational& singular :
         {Rational(5, 4) /* (x + 1)/G = P + 1 */, Rational(35, 32) /* (x-1)/G = P^2/4 */, Rational(9, 16) /* = 1 */}) {
        CHECK(std::isinf(bound(singular, 1e-6)));
        CHECK(std::isinf(bound(singular + Rational(1, 1000), 1.1e-3)));
        CHECK(bound(singular + Rational(1, 1000), 1e-4) < 1000);
    }
    for (const char* x : {"1/20", "1/3", "13/10", "2", "4"}) {
        double r = 1;
        while (std::isinf(bound(*parse_rational(x), r))) r /= 2;
        INFO("x ", x, " r ", r);
        REQUIRE(r > 1e-3);
        for (const double t : {-0.99, 0.5, 0.99})
            CHECK(waves.value(to_real(Ball(*parse_rational(x)) + Ball::exactly(t * r))).first.high <= bound(*parse_rational(x), r));
    }
}

TEST_CASE("the density is 0 up to the lowest ratio, and is not a thousandth above it")
{
    const WorkingPrecision precision(200);
    for (const auto& [G, P] : {std::pair{"3/2", "1/2"}, {"5", "19/10"}, {"3/2", "21/10"}, {"3/2", "3"}, {"4", "5/2"}}) {
        const TwoWaves waves{Ball(*parse_rational(G)), Ball(*parse_rational(P)), 1e-12};
        CAPTURE(std::string(G));
        CAPTURE(std::string(P));
        CHECK(waves.value(TwoWaves::Real(0.9999 * waves.lowest())).first.high == 0);
        CHECK(waves.value(TwoWaves::Real(1.0015 * waves.lowest())).first.high > 0);
    }
}

TEST_CASE("a disc holds no more than a share of what it may, and its bound is what the lemma says")
{
    const WorkingPrecision precision(200);
    constexpr double share = wave::disc_two_waves.share, most = wave::disc_two_waves.most;
    const TwoWaves far{Ball(10), Ball(3), 1e-12}; // from 2.5 to 2.7, the singular points at 2 and 4
    CHECK(far.on_disc(true, Ball(26), 1.99 * share) < 1000);
    CHECK(std::isinf(far.on_disc(true, Ball(26), 2.01 * share)));
    // in partial contact a disc takes a share of x and of 1 - x, however far the wave's end is from singular points
    const TwoWaves lower{Ball(10), Ball(1) / 10, 1e-12};
    CHECK(lower.on_disc(false, Ball(9) / 10, 0.099 * share) < 1e4);
    CHECK(std::isinf(lower.on_disc(false, Ball(9) / 10, 0.101 * share)));
    const TwoWaves::Real x(0.9);
    CHECK(lower.on_disc(x - 0.01, x + 0.01, x, 0.099 * share) < 1e4);
    for (const double above : {1.001, 1.5, 2.5}) // two functions
        CHECK(std::isinf(lower.on_disc(x, TwoWaves::Real(above), x, 0.099 * share)));
    const TwoWaves higher{Ball(10), Ball(9) / 5, 1e-12};
    CHECK(higher.on_disc(false, Ball(1) / 10, 0.099 * share) < 1e4);
    CHECK(std::isinf(higher.on_disc(false, Ball(1) / 10, 0.101 * share)));
    const TwoWaves coarse{Ball(3) / 2, Ball(1) / 2, 0.3};
    const auto [value, error] = coarse.value(TwoWaves::Real(2));
    CAPTURE(value.high);
    CAPTURE(error);
    REQUIRE(error > 1e-6 * value.high);
    const double bound = coarse.on_disc(true, Ball(2), 1e-3);
    CHECK(bound >= most * (value.high + error));
    CHECK(bound <= 1.001 * most * (value.high + error));
}

TEST_CASE("the bound over a cover is no less than a function on the ellipse, and comes near it; infinite where any disc's is")
{
    constexpr double rho = 3, mid = 0.7, half = 0.05;
    const std::complex<double> pole(0.9, 0);
    const auto most = [&](std::complex<double> c, double r) {
        const double away = std::abs(c - pole) - r;
        return away > 0 ? 1 / away : transfer::bounds::infinite;
    };
    double on_ellipse = 0;
    for (int k = 0; k < 400; ++k) {
        const std::complex<double> e = std::polar(rho, std::numbers::pi * k / 200), z = mid + half * (e + 1. / e) / 2.;
        on_ellipse = std::max(on_ellipse, 1 / std::abs(z - pole));
    }
    double before = transfer::bounds::infinite;
    for (const auto& [columns, rows] : {std::pair{3, 1}, {6, 3}, {40, 20}}) {
        const double bound = transfer::EllipseCover(rho, columns, rows).bound(mid, half, most);
        CAPTURE(columns);
        CHECK(bound >= on_ellipse);
        CHECK(bound < before);
        before = bound;
    }
    CHECK(before < 1.3 * on_ellipse);
    CHECK(std::isinf(transfer::EllipseCover(rho, 3, 1).bound(mid, 0.13, most)));
}

TEST_CASE("the rectangles of a cover hold the upper half of the ellipse, and none is far from it")
{
    for (const double rho : {1.5, 3., 9.})
        for (const auto& [columns, rows] : {std::pair{3, 1}, {6, 3}, {1, 4}}) {
            const transfer::EllipseCover cover(rho, columns, rows);
            const double wide = (rho + 1 / rho) / 2, high = (rho - 1 / rho) / 2;
            CAPTURE(rho);
            CAPTURE(columns);
            CHECK(cover.half_width == doctest::Approx(wide / columns));
            CHECK(cover.half_height == doctest::Approx(high / rows / 2));
            for (int k = 0; k <= 200; ++k)
                for (const double share : {0.01, 0.5, 0.8, 1 - 1e-12}) {
                    const double phi = std::numbers::pi * k / 200;
                    const std::complex<double> z(share * wide * std::cos(phi), share * high * std::sin(phi));
                    CHECK(std::any_of(cover.middles.begin(), cover.middles.end(), [&](const auto& m) {
                        const auto off = z - m;
                        return std::fabs(off.real()) <= cover.half_width * (1 + 1e-9) &&
                               std::fabs(off.imag()) <= cover.half_height * (1 + 1e-9);
                    }));
                }
            for (const auto& m : cover.middles) { // its corner next to 0 is inside
                const double across = std::max(0., std::fabs(m.real()) - cover.half_width) / wide;
                CHECK(std::hypot(across, (m.imag() - cover.half_height) / high) < 1.001);
            }
        }
}

TEST_CASE("what Gauss's rule errs by, and what moved nodes and roundings do, is within the bounds, which have their values")
{
    CHECK(transfer::gauss_error(2, 1) == doctest::Approx(256 / 45.).epsilon(1e-12));
    CHECK(transfer::gauss_error(2, 3) == doctest::Approx(16 / 45.).epsilon(1e-12));
    CHECK(transfer::gauss_error(4, 2) == doctest::Approx(64 / 225.).epsilon(1e-12));
    CHECK(transfer::semi_axis(4) == 2.125);
    const transfer::Surroundings about({3, 0x1p-60}, {3.5, 0}, 2);
    CHECK(about.half >= 0.25);
    CHECK(about.half <= 0.2503);
    CHECK(about.radius == doctest::Approx(1.25 * about.half).scale(0).epsilon(1e-12));
    CHECK(transfer::levels::magnitude({-2, 0x1p-60}) >= 2);
    CHECK(transfer::levels::magnitude({-2, 0x1p-60}) <= 2.003);
    CHECK(transfer::levels::rounding_of_sum({-0.5, 0}, 36) == doctest::Approx(50 * 0x1p-101).scale(0).epsilon(1e-12));
    CHECK(transfer::moved_nodes_error(1, 0.5, 4, 3) == doctest::Approx(1.2).epsilon(1e-12));
    CHECK(transfer::moved_nodes_error(0.5, 0.25, 1, 8) == doctest::Approx(8).epsilon(1e-12));
    for (const int count : {1, 2, 4, 7}) {
        const transfer::Gauss gauss(count);
        const auto n = static_cast<std::size_t>(count);
        for (const double pole : {1.1, 1.5, 4.}) // 1/(pole - x)
            for (const double share : {0.5, 0.9, 0.99}) {
                const double wide = 1 + share * (pole - 1), rho = wide + std::sqrt(wide * wide - 1), off = 1e-3 * (pole - 1);
                double sum = 0, moved = 0;
                for (std::size_t i = 0; i < n; ++i) {
                    const double x = gauss.nodes[i].high, w = gauss.weights[i].high;
                    sum += w / (pole - x);
                    moved += w / (pole - x - off);
                }
                CAPTURE(count);
                CAPTURE(pole);
                CAPTURE(share);
                CHECK(std::fabs(sum - std::log((pole + 1) / (pole - 1))) <= transfer::gauss_error(rho, n) / (pole - wide));
                CHECK(moved - sum <= transfer::moved_nodes_error(1, off, wide, 1 / (pole - wide)));
            }
    }
}

TEST_CASE("the bounds of the second wave's density and of the first wave's kernel hold and are not far from them")
{
    const double pi = std::numbers::pi;
    const auto density = [pi](double P, double y) { // (2.19), in p*_2
        if (y >= 1) return 1 / (pi * std::sqrt((y - P + 1) * (P + 1 - y)));
        const double R = std::hypot(1 - y, P);
        return P / (2 * pi * R) * std::sqrt((1 + y + R) / (1 - y + R) / (y - P * P / 4));
    };
    namespace second_wave = transfer::second_wave;
    for (const double P : {0.5, 0.7, 1., 1.2, 1.25, 1.3, 1.6, 1.9, 1.99, 2.1, 5.}) {
        const auto bound = second_wave::bound(P);
        CAPTURE(P);
        const double low = P < 2 ? P * P / 4 : P - 1, top = P + 1;
        double closest[2] = {}; // below y = 1, and above
        for (int k = 1; k < 4000; ++k) {
            const double y = k % 2 == 0 ? low + (top - low) * k / 4000 : 1 + (k - 2000) * 1e-9;
            if (y <= low || y >= top || y <= P - 1) continue;
            double most = y < 1 ? 0 : bound.elsewhere;
            for (const auto& r : bound.roots)
                if ((y < 1) == (r.at == P * P / 4)) most += r.factor / std::sqrt(std::fabs(y - r.at));
            CAPTURE(y);
            CHECK(density(P, y) <= most);
            closest[y >= 1] = std::max(closest[y >= 1], density(P, y) / most);
        }
        if (P < 2) CHECK(closest[0] > 0.97);
        CHECK(closest[1] > 0.6);
    }
    double nearest[4] = {};
    for (const double P : {0.001, 0.1, 0.3, 0.49}) {
        const double lower = P * P / 4;
        for (int k = 1; k < 4000; ++k) {
            const double y = k < 2000 ? lower * std::pow((P + 1) / lower, k / 2000.) : lower + (1 + P - lower) * (k - 2000) / 2000.;
            if (y <= lower * (1 + 1e-12) || y >= P + 1) continue;
            const double d = density(P, y), to_lower = std::sqrt(y - lower), R = std::hypot(1 - y, P);
            if (y <= 1.5 * lower) nearest[0] = std::max(nearest[0], d * to_lower / P);
            if (y <= 0.5) nearest[1] = std::max(nearest[1], d * to_lower / P);
            if (y >= 0.5 && y < 1) nearest[2] = std::max(nearest[2], d * R * std::sqrt(R) / P);
            if (y >= 1) nearest[3] = std::max(nearest[3], d * std::sqrt(P + 1 - y));
        }
    }
    const double claimed[4] = {second_wave::at_lower, second_wave::below_half, second_wave::about_one, second_wave::at_top};
    for (int k = 0; k < 4; ++k) {
        CAPTURE(k);
        CHECK(nearest[k] <= claimed[k]);
        CHECK(nearest[k] >= 0.6 * claimed[k]);
    }
    for (const double G : {1.2, 2., 5.})
        for (const double x : {0.05, 0.4, 0.9, 1., 1.4, 3., 9.}) {
            const double end = (x < 1 ? 2 * std::sqrt(x) : x + 1) / G, begin = x < 1 ? 0 : (x - 1) / G;
            double share = 0;
            for (int k = 1; k < 200; ++k) {
                const double y = begin + (end - begin) * k / 200, R = std::hypot(1 - x, G * y), c = x < 1 ? R - x : G * y - x;
                const double kernel = (x < 1 ? G * G * y / R : G) / (pi * std::sqrt((1 - c) * (1 + c)));
                const double to_end = x < 1 ? end - y : std::min(end - y, y - begin);
                share = std::max(share, kernel * std::sqrt(to_end) / second_wave::first_wave(G, x, y * 2)); // y >= s/2
            }
            CAPTURE(G);
            CAPTURE(x);
            CHECK(share <= 1);
            CHECK(share >= (x < 1 ? 0.1 : 0.4));
        }
}

TEST_CASE("two roots next to one another: the bounds of their integral, and where one of them moves, hold and are nearly attained")
{
    namespace levels = transfer::levels;
    constexpr double margin = transfer::bounds::margin;
    for (const double near : {0.01, 0.4})
        for (const double share : {1e-12, 1e-3, 0.1, 0.9}) {
            const double delta = share * near;
            const double exact = std::numbers::pi + 2 * std::asinh(std::sqrt(1 / share)) + 2 * std::asinh(std::sqrt(1 / share - 1));
            CAPTURE(near);
            CAPTURE(share);
            CHECK(exact <= margin * levels::two_roots(near, delta));
            CHECK(exact >= (share > 0.1 ? 0.7 : 0.97) * levels::two_roots(near, delta));
        }
    // e = s at the middle of the interval and moves by x/G; the share of the measure within l/2 of the middle is (l/width)^(1/2)
    for (const double G : {1.01, 3.})
        for (const double width : {1e-12, 1e-3}) {
            const double near = 0.2;
            double counts = 0;
            constexpr int steps = 10'000;
            for (int k = 0; k < steps; ++k) {
                const double share = (k + 0.5) / steps;
                counts += levels::two_roots(near, share * share * width / (2 * G)) / steps;
            }
            CAPTURE(G);
            CAPTURE(width);
            CHECK(counts <= margin * levels::two_roots_on(near, width, G));
            CHECK(counts >= 0.98 * levels::two_roots_on(near, width, G));
        }
    CHECK(levels::two_roots_on(0.2, 1e-3, 0.25) == doctest::Approx(levels::two_roots(0.2, 1e-3) + 4)); // e moves by more than x
}

TEST_CASE("roundings of the integrand are charged beside those of the sum")
{
    // 16 of them for the integrand's bound over half a panel, which is no less than half of what it is there; in the last three the bound's
    // factors 1 + x + r and 1 + y + R are large
    struct Case {
        double G, P, x;
    };
    for (const auto& [G, P, x] : {Case{1.5, 0.5, 0.3}, {1.5, 0.5, 1.75}, {1.5, 0.5, 3}, {2, 1.9, 0.9}, {1.01, 1.9, 0.3}, {4, 1.2, 2.5}}) {
        const auto [value, error] = TwoWaves{Ball::exactly(G), Ball::exactly(P), 1e-30}.value(TwoWaves::Real(x));
        CAPTURE(G);
        CAPTURE(P);
        CAPTURE(x);
        CHECK(error > 1.004 * 2000 * 0x1p-101 * value.high);
    }
}

TEST_CASE("what an interval counts for is the sum of what the bounds of the second wave's density do, each cut next to its singular point")
{
    namespace second_wave = transfer::second_wave;
    for (const double G : {1.2, 5., 300.})
        for (const double P : {0.3, 0.01, 0.8, 1.5, 3.})
            for (const double x : {0.2, 1.5}) {
                constexpr double width = 1e-6;
                const auto counts = [&](double s, double factor) {
                    const double near = std::min(s / 2, 1 / (2 * G));
                    const double kernel = second_wave::first_wave(G, x, s);
                    return factor / std::sqrt(near) + factor * kernel * transfer::levels::two_roots_on(near, width, G);
                };
                double all = 0;
                if (P < 0.5) {
                    // next to 1 the integral of (3/2) l^(1/2) P R^(-5/2) dR, l^2 = R^2 - P^2, is 3/4 B(1/2, 5/4) < 1.32: 1.52 is enough
                    const double lower = P * P / 4;
                    all = counts(lower, P * second_wave::at_lower) + counts(1 + P, second_wave::at_top)
                          + P * second_wave::below_half / std::sqrt(std::min(lower, 1 / G) / 2)
                          + std::sqrt(G) * 1.52 / std::numbers::sqrt2 * second_wave::about_one;
                }
                else {
                    const auto bound = second_wave::bound(P);
                    all = bound.elsewhere;
                    for (const auto& r : bound.roots) all += counts(r.at, r.factor);
                }
                const double own = TwoWaves{Ball::exactly(G), Ball::exactly(P), 1e-6}.weight_on(x, width);
                CAPTURE(G);
                CAPTURE(P);
                CAPTURE(x);
                CHECK(own >= all);
                CHECK(own <= 1.002 * all);
            }
}

TEST_CASE("what an interval with a logarithm counts for is more than its mean")
{
    const WorkingPrecision precision(200);
    struct {
        const char *G, *P, *x;
    } const cases[] = {{"3/2", "1/2", "35/32"}, {"3/2", "1/100", "1.0000375"}, {"3/2", "1/2", "5/4"}, {"3/2", "3", "4"}, {"3/2", "3", "5"}};
    for (const auto& c : cases) {
        const Rational G = *parse_rational(c.G), P = *parse_rational(c.P);
        const TwoWaves waves{Ball(G), Ball(P), 1e-12};
        const Rational x = *parse_rational(c.x);
        for (const char* width : {"1e-3", "1e-12", "1e-20"}) {
            const Rational w = *parse_rational(width);
            double mean = 0;
            for (int k = 0; k < 100; ++k) mean += waves.value(to_real(Ball(Rational(x + w * (2 * k - 99) / 200)))).first.high / 100;
            INFO("P ", c.P, " x ", x.get_d(), " width ", width, " mean ", mean);
            CHECK(mean < waves.weight_on(x.get_d() - w.get_d(), w.get_d()));
        }
    }
}
