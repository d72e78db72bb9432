// SPDX-License-Identifier: MIT
/// What proofs in binary64 stand on: the machine's arithmetic, discs, loops on all cores.
#include "touchstone/scalar/ball.hpp"
#include "touchstone/scalar/binary64.hpp"
#include "touchstone/transfer/chain.hpp"
#include "touchstone/transfer/disc.hpp"
#include "touchstone/transfer/discretisation.hpp"
#include "touchstone/transfer/parallel.hpp"
#include "touchstone/transfer/proven_levels.hpp"

#include <doctest/doctest.h>

#include <cfenv>
#include <random>
#if defined(__SSE2__)
#include <pmmintrin.h>
#endif

using namespace touchstone;
using namespace touchstone::transfer;

TEST_CASE("another rounding mode, and subnormal numbers flushed to zero, are refused where an engine is entered")
{
    const auto engines = [] {
        CHECK_THROWS_AS(require_binary64_arithmetic(), std::runtime_error);
        CHECK_THROWS_AS(Discretisation(Scheme::area, [] { return Ball(3); }, 30), std::runtime_error);
        CHECK_THROWS_AS(ProvenLevels(Ball(3), 1, 1e-6), std::runtime_error);
    };
    CHECK_NOTHROW(require_binary64_arithmetic());
    for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
        std::fesetround(mode);
        engines();
        std::fesetround(FE_TONEAREST);
    }
#if defined(__SSE2__)
    const auto flush = _MM_GET_FLUSH_ZERO_MODE();
    _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_ON);
    engines();
    _MM_SET_FLUSH_ZERO_MODE(flush);
    const auto zero = _MM_GET_DENORMALS_ZERO_MODE();
    _MM_SET_DENORMALS_ZERO_MODE(_MM_DENORMALS_ZERO_ON);
    engines();
    _MM_SET_DENORMALS_ZERO_MODE(zero);
#endif
    CHECK_NOTHROW(require_binary64_arithmetic());
}

TEST_CASE("what a worker thread throws reaches the caller")
{
    struct Special {};
    CHECK_THROWS_AS(in_parallel(64, [](std::size_t i) { if (i == 63) throw Special(); }), Special);
    CHECK_THROWS_AS(in_parallel(64, [](std::size_t) { throw Special(); }), Special);
    std::atomic<int> done{0};
    in_parallel(64, [&](std::size_t) { ++done; });
    CHECK(done == 64);
}

namespace {
/// Points of the disc's rim in balls, and whether `inside` holds those that `image` makes of them.
template <class Image>
bool holds(const Disc& of, const Disc& inside, const Image& image)
{
    const WorkingPrecision precision(200);
    const auto ball = [](std::complex<double> z) { return ComplexBall(Ball::exactly(z.real()), Ball::exactly(z.imag())); };
    bool yes = true;
    for (int k = 0; k < 16; ++k) {
        const Ball angle = 2 * pi<Ball>() * k / 16;
        // from the direction of the centre, where 1/z and z^(1/2) go farthest
        const ComplexBall towards = ball(of.centre()) / ComplexBall(abs(ball(of.centre())));
        const ComplexBall z = ball(of.centre()) + ComplexBall(Ball::exactly(of.radius()) * (1 - Ball::exactly(0x1p-100))) * towards *
                                                      ComplexBall(cos(angle), sin(angle));
        yes = yes && !certainly(less(Ball::exactly(inside.radius()), abs(image(z) - ball(inside.centre()))));
    }
    return yes;
}
} // namespace

TEST_CASE("discs: reciprocals and roots of discs that nearly reach 0")
{
    const unsigned seed = 1974;
    MESSAGE("seed " << seed);
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> unit(0, 1);
    int finite = 0;
    for (int i = 0; i < 2000; ++i) {
        const double angle = 1.5 * (2 * unit(random) - 1), size = std::exp(10 * (2 * unit(random) - 1));
        const std::complex<double> c = std::polar(size, angle);
        const double near = std::exp2(-1 - 52 * unit(random));
        const Disc b(c, std::sqrt(std::norm(c)) * (1 - near) / (1 + 0x1p-47));
        const Disc one_over = Disc(1.0) / b, root = sqrt(b);
        finite += std::isfinite(one_over.radius());
        CAPTURE(i);
        CAPTURE(near);
        if (near < 0x1p-43) CHECK_FALSE(std::isfinite(one_over.radius())); // too near 0 for the bound of its roundings
        if (std::isfinite(one_over.radius())) CHECK(holds(b, one_over, [](const ComplexBall& z) { return ComplexBall(1) / z; }));
        if (std::isfinite(root.radius())) CHECK(holds(b, root, [](const ComplexBall& z) { return sqrt(z); }));
        const double q = b.radius() / std::abs(c); // towards 0 a root of the disc is as far away as this
        if (std::isfinite(root.radius()))
            CHECK(root.radius() <= 1.01 * std::sqrt(std::abs(c)) * (1 - std::sqrt(std::max(0.0, 1 - q))) + 1e-6 * std::sqrt(std::abs(c)));
    }
    CHECK(finite > 1000);
}

TEST_CASE("discs: real numbers so small that their squares are subnormal")
{
    for (const double c : {0x1.4p-530, 0x1.c443012ed9d4p-524, 0x1.3b85c260276a8p-519, 0x1.6p-513})
        for (const double radius : {0.0, c / 64, c / 2}) {
            const Disc z(c, radius), root = sqrt(z), one_over = 1 / z, by_large = z * Disc({1e150, 1e150}, 1e149);
            CAPTURE(c);
            // what is to be held has the radius given, not the one enlarged
            const auto on_rim = [&](const Disc& of, const auto& image) {
                const WorkingPrecision precision(1200);
                for (const int sign : {-1, 0, 1}) {
                    const ComplexBall at(Ball::exactly(c) + sign * Ball::exactly(radius)),
                        centre(Ball::exactly(of.centre().real()), Ball::exactly(of.centre().imag()));
                    CHECK_FALSE(certainly(less(Ball::exactly(of.radius()), abs(image(at) - centre))));
                }
            };
            if (std::isfinite(root.radius())) on_rim(root, [](const ComplexBall& x) { return sqrt(x); });
            if (std::isfinite(one_over.radius())) on_rim(one_over, [](const ComplexBall& x) { return ComplexBall(1) / x; });
            on_rim(by_large, [](const ComplexBall& x) { return x * ComplexBall(Ball::exactly(1e150), Ball::exactly(1e150)); });
        }
}

TEST_CASE("discs: sums, differences and products hold those of their points")
{
    const WorkingPrecision precision(200);
    const unsigned seed = 1835;
    MESSAGE("seed " << seed);
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> unit(-1, 1);
    const auto any = [&](double size) { return std::polar(std::exp(size * unit(random)), 3.2 * unit(random)); };
    const auto ball = [](std::complex<double> z) { return ComplexBall(Ball::exactly(z.real()), Ball::exactly(z.imag())); };
    for (int i = 0; i < 500; ++i) {
        const Disc a(any(5), std::exp(20 * unit(random) - 15)), b(any(5), std::exp(20 * unit(random) - 15));
        // b's point where it is farthest along a's direction, so that the product's rim is met
        const ComplexBall other =
            ball(b.centre()) * ComplexBall(1 + Ball::exactly(b.radius()) / abs(ball(b.centre())) * (1 - Ball::exactly(0x1p-100)));
        CAPTURE(i);
        CHECK(holds(a, a + b, [&](const ComplexBall& z) { return z + other; }));
        CHECK(holds(a, a - b, [&](const ComplexBall& z) { return z - other; }));
        CHECK(holds(a, a * b, [&](const ComplexBall& z) { return z * other; }));
        CHECK((a * b).radius() <=
              1.001 * (std::abs(a.centre()) * b.radius() + std::abs(b.centre()) * a.radius() + a.radius() * b.radius()) +
                  1e-12 * std::abs((a * b).centre()));
    }
}

TEST_CASE("discs: exponentials, from those that underflow to those of which nothing is said")
{
    const unsigned seed = 1882;
    MESSAGE("seed " << seed);
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> unit(0, 1);
    const auto image = [](const ComplexBall& z) { return exp(z); };
    for (int i = 0; i < 2000; ++i) {
        const Disc z({800 * unit(random) - 500, std::exp(20 * unit(random) - 10)}, std::exp2(8 - 60 * unit(random)));
        CAPTURE(i);
        const Disc image_of_it = exp(z);
        if (!std::isfinite(image_of_it.radius())) CHECK(z.centre().real() + z.radius() > 299);
        else CHECK(holds(z, image_of_it, image));
    }
    CHECK(exp(Disc({-1000, 1}, 0.5)).most() > 0);
    // e^c is subnormal, with few bits of its own, and e^r large
    for (int i = 0; i < 400; ++i) {
        const Disc z({-745 + i / 16., 1}, 460 + unit(random));
        CAPTURE(i);
        CHECK(holds(z, exp(z), image));
    }
    CHECK_FALSE(std::isfinite(exp(Disc({1, 0}, std::numeric_limits<double>::quiet_NaN())).most()));
    // the largest e^z of the disc is on its rim, and all that is held
    for (int i = 0; i < 200; ++i) {
        const Disc z({-301 - 50 * unit(random), 0}, 360 * unit(random)), of_it = exp(z);
        CAPTURE(i);
        CHECK(holds(z, of_it, image));
        const double most = z.centre().real() + z.radius();
        if (most > -299) CHECK(of_it.most() <= std::exp(most) * (1 + 1e-10));
    }
    // as small as can be: a product of two still holds it
    const Disc small = exp(Disc({-295, 0.3}, 1e-20)), smaller = small * small * small;
    CHECK(smaller.most() > 0);
}

TEST_CASE("the most of x|1 - xz| over ratios x and a ball of z: tried at points, and where the ball is wide")
{
    const WorkingPrecision precision(64);
    const unsigned seed = 2000;
    MESSAGE("seed " << seed);
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> unit(0, 1);
    const auto tried = [&](double re0, double re1, double im0, double im1, double X) {
        const ComplexBall z(hull(Ball::exactly(re0), Ball::exactly(re1)), hull(Ball::exactly(im0), Ball::exactly(im1)));
        const Ball most = upper(largest_product(z, Ball::exactly(X)));
        for (const double f : {0.0, 0.5, 1.0})
            for (const double g : {0.0, 1.0})
                for (int k = 1; k <= 24; ++k) {
                    const double x = X * k / 24;
                    const std::complex<double> at(re0 + f * (re1 - re0), im0 + g * (im1 - im0));
                    CHECK_FALSE(certainly(less(most * (1 + Ball::exactly(1e-12)), Ball::exactly(x * std::abs(1.0 - x * at)))));
                }
    };
    tried(1, 2.1, 0, 0, 0.6); // the most is 1/4, at x = 1/2, z = 1
    for (int i = 0; i < 300; ++i) {
        const double re = 4 * unit(random) - 1, im = 2 * unit(random) - 1;
        tried(re, re + unit(random), im, im + unit(random), unit(random));
    }
}
