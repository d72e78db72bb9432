// SPDX-License-Identifier: MIT
#include "touchstone/scalar/ball.hpp"
#include "touchstone/transfer/wave_kernel.hpp"

#include <doctest/doctest.h>

#include <random>

using namespace touchstone;
using namespace touchstone::transfer;
using Real = DoubleDouble<double>;

namespace {

Ball ball(const Real& x) { return Ball::exactly(x.high) + Ball::exactly(x.low); }

/// Random heads with random, normalised tails; some nearly equal and opposite.
struct Numbers {
    std::mt19937_64 random{1};
    Real operator()()
    {
        std::uniform_real_distribution<double> mantissa(1, 2), tail(-1, 1);
        std::uniform_int_distribution<int> exponent(-40, 40);
        const double high = std::ldexp(mantissa(random), exponent(random));
        return Real::fast_two_sum(high, tail(random) * high * 0x1p-53);
    }
};

bool within(const Real& computed, const Ball& exact, int power, const Ball& scale)
{
    Ball bound;
    arb_mul_2exp_si(bound.get(), scale.get(), power);
    return certainly(less(abs(ball(computed) - exact), bound));
}
bool within(const Real& computed, const Ball& exact) { return within(computed, exact, -102, abs(exact)); }

} // namespace

TEST_CASE("operations on 106 bits are off by less than 2^-102, cancellation or not")
{
    const WorkingPrecision precision(400);
    Numbers next;
    int cancelled = 0;
    for (int i = 0; i < 20'000; ++i) {
        const Real a = next(), b = i % 4 == 0 ? Real::fast_two_sum(a.high, -a.low) : next();
        CHECK(within(a + b, ball(a) + ball(b)));
        if (!(a == b)) CHECK(within(a - b, ball(a) - ball(b)));
        cancelled += std::fabs((a - b).high) < 1e-14 * a.high;
        CHECK(within(a * b, ball(a) * ball(b)));
        CHECK(within(a / b, ball(a) / ball(b)));
        CHECK(within(sqrt(a), sqrt(ball(a))));
        CHECK(within(inverse_root(a), 1 / sqrt(ball(a))));
    }
    CHECK(cancelled > 1000);
    CHECK(sqrt(Real(0)) == Real(0));
    CHECK_FALSE(within(Real(1) / 3 + 0x1p-101, Ball(Rational(1, 3)))); // the test would see one unit more
}

TEST_CASE("four at a time give what one at a time gives")
{
    Numbers next;
    for (int i = 0; i < 1000; ++i) {
        Real a[4], b[4];
        DoubleDouble<Lanes> A, B;
        for (int k = 0; k < 4; ++k) {
            a[k] = next(), b[k] = next();
            A.high[k] = a[k].high, A.low[k] = a[k].low, B.high[k] = b[k].high, B.low[k] = b[k].low;
        }
        const auto same = [&](const DoubleDouble<Lanes>& r, auto&& one) {
            for (int k = 0; k < 4; ++k) CHECK(Real(r.high[k], r.low[k]) == one(a[k], b[k]));
        };
        same(A + B, [](Real x, Real y) { return x + y; });
        same(A * B, [](Real x, Real y) { return x * y; });
        same(A / B, [](Real x, Real y) { return x / y; });
        same(sqrt(A), [](Real x, Real) { return sqrt(x); });
        same(inverse_root(A), [](Real x, Real) { return inverse_root(x); });
        same(positive_part(A - B), [](Real x, Real y) { return positive_part(x - y); });
    }
}

TEST_CASE("a pair on all lanes, and operations in place")
{
    const DoubleDouble<double> third = DoubleDouble<double>(1) / 3, root = sqrt(DoubleDouble<double>(2));
    CHECK(third.low != 0);
    const DoubleDouble<Lanes> wide(third);
    for (int i = 0; i < 4; ++i) {
        CHECK(wide.high[i] == third.high);
        CHECK(wide.low[i] == third.low);
    }
    CHECK_FALSE(third == DoubleDouble<double>(third.high, 0));
    CHECK_FALSE(third == DoubleDouble<double>(0, third.low));
    CHECK(abs(-third) == third);
    const auto zero = sqrt(DoubleDouble<Lanes>()); // no division by 0
    for (int i = 0; i < 4; ++i) CHECK((zero.high[i] == 0 && zero.low[i] == 0));
    DoubleDouble<double> x = third;
    CHECK((x += root) == third + root);
    CHECK((x -= third) == third + root - third);
    CHECK((x *= third) == (third + root - third) * third);
    CHECK((x /= root) == (third + root - third) * third / root);
}

TEST_CASE("sums of products, moments and the kernel of a wave, within their counts")
{
    const WorkingPrecision precision(400);
    Numbers next;
    constexpr std::size_t count = 40, columns = 20;
    Wide a(count * columns), b(count), out(columns);
    for (std::size_t i = 0; i < a.size(); ++i) a.set(i, i % 3 == 0 ? -next() : next());
    for (std::size_t i = 0; i < b.size(); ++i) b.set(i, next());
    add_products(a, 0, b, columns, out);
    for (std::size_t m = 0; m < columns; ++m) {
        Ball exact(0), moduli(0);
        for (std::size_t k = 0; k < count; ++k) {
            const Ball term = ball(a[k * columns + m]) * ball(b[k]);
            exact += term;
            moduli += abs(term);
        }
        CHECK(within(out[m], exact, -95, moduli)); // 2 n u = 80 u, u = 2^-101
    }
    Ball exact(0), moduli(0);
    for (std::size_t k = 0; k < count; ++k) {
        exact += ball(a[7 + k]) * ball(b[k]);
        moduli += abs(ball(a[7 + k]) * ball(b[k]));
    }
    CHECK(within(dot(a, 7, b), exact, -95, moduli));

    constexpr std::size_t nodes = 132; // more than one block
    Wide local(nodes), weight(nodes), moments(count);
    std::uniform_real_distribution<double> in(-1, 1);
    for (std::size_t i = 0; i < nodes; ++i)
        local.set(i, Real(in(next.random)) + 1e-18), weight.set(i, Real(1) / static_cast<double>(i + 1));
    chebyshev_moments(local, weight, count, moments);
    for (const std::size_t k : {0, 1, 2, 17, 39}) {
        Ball sum(0);
        for (std::size_t i = 0; i < nodes; ++i) {
            Ball T;
            arb_chebyshev_t_ui(T.get(), k, ball(local[i]).get(), precision.bits());
            sum += ball(weight[i]) * T;
        }
        CHECK(within(moments[k], sum, -101, Ball(static_cast<long>(6 * (k * k + 40)))));
    }

    int seen = 0; // of the late ones, how often the bound is of that size
    for (const std::size_t accurate : {2, 9, 30}) {
        chebyshev_moments(local, weight, count, accurate, moments);
        Ball moduli(0);
        for (std::size_t i = 0; i < nodes; ++i) moduli += ball(weight[i]);
        for (std::size_t k = 0; k < count; ++k) {
            Ball sum(0);
            for (std::size_t i = 0; i < nodes; ++i) {
                Ball T;
                arb_chebyshev_t_ui(T.get(), k, ball(local[i]).get(), precision.bits());
                sum += ball(weight[i]) * T;
            }
            if (k < accurate) CHECK(within(moments[k], sum, -101, Ball(static_cast<long>(6 * (k * k + 40)))));
            else CHECK(within(moments[k], sum, 0, Ball::exactly(late_moment(k - accurate, nodes)) * moduli));
            seen += k >= accurate && !within(moments[k], sum, -9, Ball::exactly(late_moment(k - accurate, nodes)) * moduli);
        }
    }
    CHECK(seen > 0); // a bound 500 times smaller would fail

    const WaveKernel<Real> partial(Real(1) / 3, Real(3) / 2, false), full(Real(5) / 4, Real(3) / 2, true);
    Wide points(4), densities(4);
    for (std::size_t i = 0; i < 4; ++i) points.set(i, Real(static_cast<double>(i)) / 5 - 0.3);
    for (const auto* k : {&partial, &full}) {
        const Real mid = (positive_part(k->begin) + k->end) * 0.5, half = k->end * 0.1;
        wave_densities(*k, mid, half, points, densities);
        for (std::size_t i = 0; i < 4; ++i) { // dtheta/dz, c as a function of z: (T) of proven_levels.hpp
            const Ball z = ball(mid) + ball(half) * ball(points[i]), x = ball(k->x), G = ball(k->G);
            const Ball R = k->full ? G * sqrt(z) : sqrt((1 - x) * (1 - x) + G * G * z), c = R - x;
            const Ball dc = k->full ? G / (2 * sqrt(z)) : G * G / (2 * R);
            CHECK(within(densities[i], dc / sqrt(1 - c * c) / ScalarTraits<Ball>::pi(), -97, Ball(10)));
        }
    }
}

TEST_CASE("one wave: its ends, 1 -+ c, and the nodes and weights in each variable")
{
    const WorkingPrecision precision(400);
    const Real G = Real(3) / 2;
    Wide nodes(4), weights(4), local(4), weight(4);
    for (std::size_t i = 0; i < 4; ++i)
        nodes.set(i, Real(static_cast<double>(i)) / 2 - 0.8), weights.set(i, Real(1) / static_cast<double>(i + 3));
    for (const Real& ratio : {Real(1) / 3, Real(9) / 10, Real(5) / 4}) {
        const bool is_full = ratio >= 1;
        const WaveKernel<Real> k(ratio, G, is_full);
        const Ball x = ball(k.x), g = ball(k.G);
        const auto z_at = [&](const Ball& c) {
            return (is_full ? (x + c) * (x + c) : (1 + c) * (2 * x - 1 + c)) / (g * g);
        }; // (T) of proven_levels.hpp
        CHECK(within(k.end, z_at(Ball(1)), -98, Ball(1)));
        CHECK(within(k.begin, is_full ? z_at(Ball(-1)) : -(1 - x) * (1 - x) / (g * g), -98, Ball(1)));
        for (const double share : {0.01, 0.4, 0.97}) {
            const Real z = positive_part(k.begin) + Real(share) * (k.end - positive_part(k.begin));
            CHECK(within(z, z_at(1 - ball(k.one_minus_c(z))), -96, Ball(1)));
            CHECK(within(z, z_at(ball(k.one_plus_c(z)) - 1), -96, Ball(1)));
        }
        for (const Substitution variable : {Substitution::sine, Substitution::cosine, Substitution::square}) {
            const bool square = variable == Substitution::square;
            const Real mid = square ? (positive_part(k.begin) + k.end) * 0.5 : Real(0.4), half = square ? k.end * 0.1 : Real(0.2),
                       centre = 0.3, unit = 0.7;
            wave_nodes(k, variable, mid, half, nodes, weights, centre, unit, local, weight);
            for (std::size_t i = 0; i < 4; ++i) {
                const Ball t = ball(mid) + ball(half) * ball(nodes[i]);
                Ball z = t, slope; // dtheta/dt
                if (square) {
                    const Ball R = is_full ? g * sqrt(z) : sqrt((1 - x) * (1 - x) + g * g * z), c = R - x;
                    slope = g * g / (2 * R) / sqrt(1 - c * c);
                }
                else {
                    z = z_at(variable == Substitution::sine ? 1 - 2 * t * t : 2 * t * t - 1);
                    slope = 2 / sqrt(1 - t * t);
                }
                CHECK(within(local[i], (z - ball(centre)) / ball(unit), -95, Ball(1)));
                CHECK(within(weight[i], ball(half) * ball(weights[i]) * slope / ScalarTraits<Ball>::pi(), -97, Ball(1)));
            }
        }
    }
}
