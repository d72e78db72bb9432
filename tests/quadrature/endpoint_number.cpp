// SPDX-License-Identifier: MIT
#include "touchstone/quadrature/tanh_sinh.hpp"
#include "touchstone/quadrature/strip.hpp"
#include "touchstone/quadrature/nodes.hpp"
#include "touchstone/quadrature/upper.hpp"

#include <doctest/doctest.h>

#include <random>

using namespace touchstone;
using namespace touchstone::quadrature;

namespace {

using N = EndpointNumber<ComplexBall>;

static_assert(Scalar<EndpointNumber<Ball>> && Scalar<EndpointNumber<ComplexBall>>, "formulas written over Scalar are integrands");

N left(const Frame<ComplexBall>& frame) { return {&frame, {1, 0}, {}, ComplexBall(1)}; }
N right(const Frame<ComplexBall>& frame) { return {&frame, {}, {1, 0}, ComplexBall(1)}; }

ComplexBall at(double x, double y) { return {Ball::exactly(x), Ball::exactly(y)}; }

/// u, r, log u, log r at the point t, from the definition, following log(1 + E) from the real axis.
struct Point {
    ComplexBall u, r, log_u, log_r;
    Point(double x, double y)
    {
        const WorkingPrecision precision(200);
        const ComplexBall t = at(x, y);
        const ComplexBall w = ComplexBall(pi<Ball>()) * (exp(t) - exp(-t)) / 2;
        u = 1 / (1 + exp(-w));
        r = 1 / (1 + exp(w));
        log_u = x >= 0 ? -log(1 + exp(-w)) : w - log(1 + exp(w));
        log_r = log_u - w;
    }
};

} // namespace

TEST_CASE("a piece of the strip encloses the map at each of its points")
{
    const unsigned seed = 1974;
    MESSAGE("seed " << seed);
    std::mt19937_64 random(seed);
    const auto uniform = [&](double a, double b) { return a + (b - a) * static_cast<double>(random() >> 11) * 0x1p-53; };
    int finite = 0;
    for (int i = 0; i < 2000; ++i) {
        const Side side = i % 2 ? Side::left : Side::right;
        const double x1 = uniform(0, 3), x2 = x1 + uniform(0, 0.2), y1 = uniform(0, 1.4), y2 = y1 + uniform(0, 0.1);
        const StripPiece& piece = StripPiece::at(side, x1, x2, y1, y2);
        const Point p((side == Side::left ? -1 : 1) * uniform(x1, x2), uniform(y1, y2));
        CHECK(piece.distance(Side::left).overlaps(p.u));
        CHECK(piece.distance(Side::right).overlaps(p.r));
        CHECK(piece.logarithm(Side::left).overlaps(p.log_u));
        CHECK(piece.logarithm(Side::right).overlaps(p.log_r));
        // |dw/dt| = |pi cosh t| is largest at the corner that is farthest out and lowest
        const ComplexBall corner(Ball::exactly(x2), Ball::exactly(y1));
        const Ball largest = touchstone::abs(exp(corner) + exp(-corner)) * pi<Ball>() / Ball(2);
        CHECK(piece.stretch().overlaps(largest));
        CHECK(piece.stretch().relative_bits() > 40);
        // tight: pieces this small are bounded away from nothing but the singular points +-i pi/2
        if (piece.distance(Side::left).is_finite() && piece.distance(Side::right).is_finite()) ++finite;
    }
    CHECK(finite > 1900);
}

TEST_CASE("wide pieces enclose the map on a grid of their points, and are not much wider than that")
{
    const unsigned seed = 1975;
    MESSAGE("seed " << seed);
    std::mt19937_64 random(seed);
    const auto uniform = [&](double a, double b) { return a + (b - a) * static_cast<double>(random() >> 11) * 0x1p-53; };
    constexpr int steps = 24;
    const WorkingPrecision precision(64);
    double widest = 0;
    int seen = 0;
    for (int i = 0; i < 250; ++i) {
        const double x1 = i % 5 ? uniform(0, 1.5) : 0, x2 = x1 + uniform(0, 0.6), y1 = i % 3 ? uniform(0, 1.3) : 0,
                     y2 = std::min(1.45, y1 + uniform(0, 0.5));
        const StripPiece piece = StripPiece::at(Side::right, x1, x2, y1, y2);
        const ComplexBall near = piece.distance(Side::right), far = piece.distance(Side::left), log_far = piece.logarithm(Side::left);
        if (!near.is_finite()) continue;
        ++seen;
        Ball parts[4], sampled[4];
        for (int k = 0; k <= steps * steps; ++k) {
            const double x = x1 + (x2 - x1) * (k / steps) / steps, y = y1 + (y2 - y1) * (k % steps) / (steps - 1);
            if (x > x2 || y > y2) continue;
            const ComplexBall t(Ball::exactly(x), Ball::exactly(y)), w = ComplexBall(pi<Ball>()) * (exp(t) - exp(-t)) / 2, e = exp(-w);
            const ComplexBall u = 1 / (1 + e), r = e / (1 + e), l = -log(1 + e);
            CHECK(far.overlaps(u));
            CHECK(near.overlaps(r));
            CHECK(log_far.overlaps(l));
            const Ball at[4] = {u.real(), u.imag(), l.real(), l.imag()};
            for (int j = 0; j < 4; ++j) sampled[j] = k == 0 ? at[j] : touchstone::hull(sampled[j], at[j]);
        }
        parts[0] = far.real();
        parts[1] = far.imag();
        parts[2] = log_far.real();
        parts[3] = log_far.imag();
        // the box of w that the piece is enclosed by is itself wider than its image
        for (int j = 0; j < 4; ++j)
            if (x2 - x1 < 0.1 && y2 - y1 < 0.1) widest = std::max(widest, parts[j].radius_bound() / (sampled[j].radius_bound() + 1e-3));
    }
    CHECK(seen > 60);
    CHECK(widest < 6);
    MESSAGE(seen << " pieces, at most " << widest << " times too wide");
}

TEST_CASE("pieces beside the pole +i pi/2 enclose the map where it is steepest")
{
    // |E| and arg E are within 1e-6 to 1e-10 of 1 and pi: stationary places of the parts are found by arccos of numbers next to 1
    std::mt19937_64 random(1976);
    const auto uniform = [&](double a, double b) { return a + (b - a) * static_cast<double>(random() >> 11) * 0x1p-53; };
    const WorkingPrecision precision(128);
    int seen = 0;
    for (int i = 0; i < 4000; ++i) {
        const double off = std::pow(10, uniform(-5, -3)), x1 = off * uniform(0.1, 1), x2 = x1 * (1 + uniform(0, 1e-3));
        const double y1 = M_PI / 2 - off, y2 = y1 + off * uniform(0, 0.3);
        const StripPiece piece = StripPiece::at(Side::right, x1, x2, y1, y2);
        const ComplexBall far = piece.distance(Side::left), log_far = piece.logarithm(Side::left);
        if (!far.is_finite()) continue;
        ++seen;
        for (int k = 0; k <= 40; ++k) {
            const double y = std::min(y2, y1 + (y2 - y1) * k / 40);
            for (const double x : {x1, x2}) {
                const ComplexBall t(Ball::exactly(x), Ball::exactly(y)), e = exp(ComplexBall(pi<Ball>()) * (exp(-t) - exp(t)) / 2);
                CHECK(far.overlaps(1 / (1 + e)));
                CHECK(log_far.overlaps(-log(1 + e)));
            }
        }
    }
    CHECK(seen > 1000);
}

TEST_CASE("a half-infinite piece encloses powers and logarithms at points however far out")
{
    std::mt19937_64 random(5);
    const auto uniform = [&](double a, double b) { return a + (b - a) * static_cast<double>(random() >> 11) * 0x1p-53; };
    const WorkingPrecision precision(128);
    for (int i = 0; i < 400; ++i) {
        const double edge = uniform(1, 2.5), d = uniform(0.1, 1.2);
        const Side side = i % 2 ? Side::left : Side::right;
        const StripPiece& piece = StripPiece::at(side, edge, std::numeric_limits<double>::infinity(), 0, d);
        const double x = edge + (i % 3 ? uniform(0, 0.01) : uniform(0, 2)), y = uniform(0, d);
        const Point p(side == Side::left ? -x : x, y);
        const ComplexBall near_log = side == Side::left ? p.log_u : p.log_r;
        Ball sinh_x;
        arb_sinh(sinh_x.get(), Ball::exactly(x).get(), 128);
        const Ball rho = pi<Ball>() * sinh_x * cos(Ball::exactly(y));
        for (const auto& [e, k] : {std::pair(Exponent(1), Exponent(0)),
                                   {Exponent(1, 3), Exponent(2)},
                                   {Exponent(2), Exponent(-1, 2)},
                                   {Exponent(1, 50), Exponent(3)},
                                   {Exponent(0), Exponent(-2)}}) {
            const ComplexBall exact = exp(ComplexBall(e.ball()) * near_log) * ComplexBall(pow(rho, k.ball()));
            CHECK(piece.vanishing(side, e.ball(), k).overlaps(exact));
        }
        CHECK(piece.logarithm_over_rho(side).overlaps(near_log / ComplexBall(rho)));
        CHECK(piece.distance(side).overlaps(side == Side::left ? p.u : p.r));
        const Side other = side == Side::left ? Side::right : Side::left;
        CHECK(piece.distance(other).overlaps(other == Side::left ? p.u : p.r));
        CHECK(piece.logarithm(other).overlaps(other == Side::left ? p.log_u : p.log_r));
    }
}

TEST_CASE("a formula of the distances encloses its continuation along the strip, not its principal value")
{
    // far out on the strip the image has wound once around the right end
    const double x = 1.5, y = 1.2;
    const StripPiece& piece = StripPiece::at(Side::right, x, x, y, y);
    const Point p(x, y);
    CHECK(arb_gt(touchstone::abs(p.log_r.imag()).get(), pi<Ball>().get()));
    const ComplexBall continued = exp(p.log_r / 2);
    CHECK(sqrt(right(piece)).value().overlaps(continued));
    CHECK_FALSE(touchstone::sqrt(p.r).overlaps(continued)); // here the principal root has the other sign
    CHECK(sqrt(right(piece) * (1 + left(piece))).value().overlaps(continued * touchstone::sqrt(1 + p.u)));
}

TEST_CASE("sums keep the smaller exponent, products add, all exactly")
{
    const StripPiece& piece = StripPiece::at(Side::left, 0.5, 0.6, 0, 0.1);
    const N l = left(piece), r = right(piece);
    const N s = to_power(l, Rational(1, 3)) + to_power(l, Rational(1, 2)) * r;
    CHECK(s.left().power == Exponent(1, 3));
    CHECK(s.right().power == Exponent(0));
    const N q = sqrt(l * l * l / r);
    CHECK(q.left().power == Exponent(3, 2));
    CHECK(q.right().power == Exponent(-1, 2));
    CHECK(sin(l).left().power == Exponent(1));
    CHECK(cos(l).left().power == Exponent(0));
    CHECK_THROWS_AS(Exponent(1L << 62) * Exponent(4), DomainError);
}

TEST_CASE("a number without powers of distances is the ball it has, to every operation and function of a scalar")
{
    const WorkingPrecision precision(120);
    using Traits = ScalarTraits<N>;
    const ComplexBall x = at(0.75, 0.25), y = at(-1.5, 0.5);
    const auto is = [](const N& found, const ComplexBall& expected) {
        CHECK(found.value().overlaps(expected));
        CHECK(acb_rel_accuracy_bits(found.value().get()) > 90);
    };
    N z(x);
    is(z *= N(y), x * y);
    is(z += N(3), x * y + ComplexBall(3));
    is(z -= N(y), x * y + ComplexBall(3) - y);
    is(z /= N(x), (x * y + ComplexBall(3) - y) / x);
    is(atan2(N(x), N(3)), analytic::atan(x / ComplexBall(3)));
    is(acos(N(x)), ComplexBall(pi<Ball>() / Ball(2)) - analytic::asin(x));
    is(pow(N(x), N(y)), analytic::exp(y * analytic::log(x)));
    is(Traits::sin_pi(N(x)), sin(ComplexBall(pi<Ball>()) * x));
    is(Traits::cos_pi(N(x)), cos(ComplexBall(pi<Ball>()) * x));
    is(Traits::powm1(N(x), N(y)), analytic::exp(y * analytic::log(x)) - ComplexBall(1));
    is(Traits::hypot(N(x), N(2)), analytic::sqrt(x * x + ComplexBall(4)));
    is(Traits::sqrt_positive_part(N(x)), analytic::sqrt(x));
    is(Traits::quotient(3, 8) * Traits::integer(4), ComplexBall(Ball(3) / Ball(2)));
    is(Traits::power_of_two(-3) + Traits::pi(), ComplexBall(Ball(1) / Ball(8) + pi<Ball>()));
}

TEST_CASE("nothing finite comes from nothing: every function of an unknown number is unknown")
{
    for (const N& x :
         {left(StripPiece::everywhere()).map([](const ComplexBall& v) { return v; }), N(ComplexBall(Ball::indeterminate())), N([] {
              ComplexBall z;
              mag_inf(arb_radref(acb_realref(z.get())));
              mag_inf(arb_radref(acb_imagref(z.get())));
              return z;
          }())}) {
        CHECK_FALSE(x.factor().is_finite());
        for (const N& y : {exp(x),
                           sin(x),
                           cos(x),
                           sqrt(x),
                           log(x),
                           abs(x),
                           sgn(x),
                           atan(x),
                           asin(x),
                           acos(x),
                           x * 0,
                           x - x,
                           x / x,
                           1 / x,
                           x + 1,
                           to_power(x, Rational(1, 3)),
                           to_power(x, Rational(-2)),
                           pow(x, Ball(1) / Ball(3)),
                           gamma_function(x),
                           sin_pi(x),
                           cos_pi(x)})
            CHECK_FALSE(y.value().is_finite());
    }
}

TEST_CASE("functions are non-finite on balls that meet their cuts, finite just beside them")
{
    const auto ball = [](double re, double im, double radius) {
        ComplexBall z = at(re, im);
        mag_t m;
        mag_init(m);
        mag_set_d(m, radius);
        acb_add_error_mag(z.get(), m);
        mag_clear(m);
        return N(z);
    };
    for (const bool on : {true, false}) {
        const double off = on ? 0.05 : 0.15;
        CHECK(sqrt(ball(-1, off, 0.1)).factor().is_finite() != on);
        CHECK(log(ball(-1, off, 0.1)).factor().is_finite() != on);
        CHECK(to_power(ball(-1, off, 0.1), Rational(1, 3)).factor().is_finite() != on);
        CHECK(asin(ball(2, off, 0.1)).factor().is_finite() != on);
        CHECK(asin(ball(-2, -off, 0.1)).factor().is_finite() != on);
        CHECK(acos(ball(2, off, 0.1)).factor().is_finite() != on);
        CHECK(atan(ball(off, 2, 0.1)).factor().is_finite() != on);
        CHECK(atan(ball(-off, -2, 0.1)).factor().is_finite() != on);
        CHECK(abs(ball(off, 1, 0.1)).factor().is_finite() != on);
        CHECK(sgn(ball(off, 1, 0.1)).factor().is_finite() != on);
        CHECK((1 / ball(off, 0, 0.1)).factor().is_finite() != on);
    }
}

TEST_CASE("cached nodes are the map at t = k h")
{
    for (const long m : {3L, 7L, 40L}) {
        const auto table = NodeTable::get(m, 3 * m, 300, 0.5);
        const WorkingPrecision precision(400);
        for (long k = 0; k <= 3 * m; k += 5) {
            const Node node(*table, k, Side::right);
            Ball log2;
            arb_const_log2(log2.get(), 400);
            const Ball t = log2 * k / m;
            const Ball w = pi<Ball>() * (exp(t) - exp(-t)) / 2;
            CHECK(node.distance(Side::right).overlaps(1 / (1 + exp(w))));
            CHECK(node.distance(Side::left).overlaps(1 / (1 + exp(-w))));
            CHECK(node.logarithm(Side::right).overlaps(-log(1 + exp(w))));
            CHECK(node.cosh().overlaps((exp(t) + exp(-t)) / 2));
            CHECK(node.distance(Side::right).relative_bits() > 60);
            if (k < m) CHECK(node.distance(Side::right).relative_bits() > 290);
            const Exponent p(5, 4), q(-2, 7);
            CHECK(node.monomial(p, q).overlaps(exp(p.ball() * node.logarithm(Side::left) + q.ball() * node.logarithm(Side::right))));
        }
    }
}

TEST_CASE(
    "powers at a node, whatever their size, are the exponential of the logarithm, and the table that is given serves what was asked for")
{
    for (const long m : {2L, 5L})
        for (const auto& [count, bits, decay] :
             {std::tuple{4L, 100L, 1.0}, {12L, 100L, 1.0}, {12L, 900L, 0.25}, {4L, 300L, 0.5}, {12L, 300L, 1.0}}) {
            const auto table = NodeTable::get(m, count, bits, decay);
            CHECK(table->m() == m);
            CHECK(table->count() >= count);
            const WorkingPrecision precision(bits);
            const Node node(*table, count, Side::left);
            for (const auto& [p, q] : {std::pair(Exponent(64), Exponent(1, 2)),
                                       {Exponent(65), Exponent(0)},
                                       {Exponent(131, 2), Exponent(1, 3)},
                                       {Exponent(0), Exponent(-201, 4)},
                                       {Exponent(3, 7), Exponent(-70)},
                                       {Exponent(-1, 16), Exponent(3, 32)}}) {
                const Ball power = node.monomial(p, q),
                           other = exp(p.ball() * node.logarithm(Side::left) + q.ball() * node.logarithm(Side::right));
                CHECK(power.overlaps(other));
                CHECK(power.relative_bits() > 40);
                CHECK(node.power(Side::left, p).overlaps(exp(p.ball() * node.logarithm(Side::left))));
                CHECK(node.weighted(p, q).overlaps(power * node.cosh() * node.distance(Side::left) * node.distance(Side::right)));
            }
            const Node first(*table, 0, Side::left); // where the weight is largest, to the bits asked for
            CHECK(first.cosh().relative_bits() >= bits);
            CHECK(first.distance(Side::left).relative_bits() >= bits);
        }
}

TEST_CASE("an odd function over its argument: a disc about 0 has what it has at its points, or nothing")
{
    const WorkingPrecision precision(100);
    std::mt19937 random(20261125);
    std::uniform_real_distribution<double> part(-1, 1);
    for (const double radius : {1e-9, 0.02, 0.3, 0.49, 0.51, 0.9, 1.5, 4.0})
        for (const double height : {radius, radius / 2}) { // where the function grows is up, on the imaginary axis
            const double width = std::sqrt(radius * radius - height * height);
            ComplexBall box(0);
            arb_add_error(acb_realref(box.get()), Ball::exactly(width).get());
            arb_add_error(acb_imagref(box.get()), Ball::exactly(height).get());
            const ComplexBall w = analytic::odd_over_argument(box, [](const ComplexBall& z) { return analytic::atan(z); });
            CHECK(w.is_finite() == (radius < 0.5));
            if (!w.is_finite()) continue;
            for (int k = 0; k < 40; ++k) {
                const ComplexBall z = at(k == 0 ? 0 : part(random) * width, k % 4 == 0 ? height : part(random) * height);
                CHECK(acb_contains(w.get(), (analytic::atan(z) / z).get()));
            }
            CHECK(w.real().radius_bound() < radius * radius / 2 + 1e-25);
        }
}

TEST_CASE("a piece of the strip outlives the ones kept for later: a nested integral may ask for any number of others")
{
    const WorkingPrecision precision(strip_bits);
    const StripPiece& piece = StripPiece::at(Side::right, 1, 1.25, 0, 0.5);
    const std::string before = piece.distance(Side::right).real().dump();
    for (int i = 0; i < 40'002; ++i) StripPiece::at(Side::right, i * 0x1p-17, i * 0x1p-17, 0, 0);
    CHECK(piece.distance(Side::right).real().dump() == before);
}

TEST_CASE("exponents multiply as the rational numbers they are")
{
    const Rational values[] = {0, 1, 2, -1, Rational(1, 2), Rational(-1, 2), Rational(2, 3), Rational(3, 2)};
    for (const Rational& a : values)
        for (const Rational& b : values) {
            CAPTURE(a.get_str());
            CAPTURE(b.get_str());
            CHECK((Exponent(a) * Exponent(b)).rational() == a * b);
            CHECK((Exponent(a) + Exponent(b)).rational() == a + b);
            CHECK((Exponent(a) < Exponent(b)) == (a < b));
        }
    // up to the largest numerator there is, of either sign
    constexpr long most = std::numeric_limits<long>::max();
    CHECK((Exponent(most - 1) + Exponent(1)).num() == most);
    CHECK((Exponent(1 - most) + Exponent(-1)).num() == -most);
    CHECK_THROWS_AS(Exponent(most) + Exponent(1), DomainError);
    CHECK_THROWS_AS(Exponent(-most) + Exponent(-1), DomainError);
    CHECK((Exponent(most - 1, 14) + Exponent(most - 1, 14)).rational() == Rational(most - 1) / 7);
}

TEST_CASE("a bound is written as a decimal that is no less")
{
    CHECK(bound_text(Ball(1300)) == "1.31e3"); // rounded up
    CHECK(bound_text(Ball(Rational(13, 1000))) == "1.31e-2");
    CHECK(bound_text(Ball::indeterminate()) == "null");
    CHECK(bound_text(Ball(0)) == "0");
    CHECK(bound_text(exp(Ball(-1000000000000000000))) == "1.00e-100000000000000000"); // not 0, which it is above
    CHECK(bound_text(exp(Ball(-100000000000))) == "1.00e-43429448189");               // e^(-10^11) = 4.7e-43429448191
    CHECK(bound_text(exp(Ball(100000000000))) == "1.00e43429448192");
    CHECK(bound_text(exp(Ball(1000000000000000000))) == "null");
    Ball far(1); // 2^(33 10^15), whose exponent in binary64 is only told to within ten or so
    arb_mul_2exp_si(far.get(), far.get(), 33000000000000000);
    const std::string text = bound_text(far);
    REQUIRE(text.rfind("1.00e", 0) == 0);
    const long exponent = std::stol(text.substr(5)), least = 9933989856911380; // 33 10^15 log10(2), rounded up
    CHECK(exponent >= least);
    CHECK(exponent < least + 1000);
    Ball below_a_power = Ball(1) - Ball(Rational(1, 1L << 25));
    arb_mul_2exp_si(below_a_power.get(), below_a_power.get(), 1888145391);
    CHECK(bound_text(below_a_power) == "1.00e568388400"); // 7.34e568388398 is less: the logarithm as a double does not hold three digits
}

TEST_CASE("a certificate in JSON has a bound as a number, or as a text where binary64 could not hold it, or null")
{
    quadrature::Certificate c;
    c.panels.resize(1);
    quadrature::Panel& p = c.panels.front();
    p.bound_left = Ball::indeterminate();
    p.bound_right = exp(Ball(-2000));
    p.strip_integral = Ball(2);
    p.discretisation = p.truncation = p.rounding = Ball(0);
    const std::string text = c.to_json();
    CAPTURE(text);
    CHECK(text.find("\"K\":[null,\"") != std::string::npos);
    CHECK(text.find("e-869\"]") != std::string::npos);
    CHECK(text.find("\"truncation\":0,") != std::string::npos);
    CHECK(text.find("\"strip_integral\":2.0") != std::string::npos);
}
