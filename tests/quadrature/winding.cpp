// SPDX-License-Identifier: MIT
// Where a strip winds around an end a formula goes on as the function it is on the real line: roots and logarithms of what vanishes at the
// end are continued, not principal, and which way a value was had must not show. Held against the continuation by hand, from w = log(u/r).
#include "touchstone/quadrature/integrate.hpp"
#include "touchstone/quadrature/strip.hpp"
#include "touchstone/scalar/ball.hpp"

#include <doctest/doctest.h>

#include <array>
#include <functional>
#include <limits>
#include <random>

using namespace touchstone;
using namespace touchstone::quadrature;

namespace {

/// u, r = 1 - u and their continued logarithms at w = pi sinh t.
struct Place {
    ComplexBall u, r, log_u, log_r;
    Place(double x, double y)
    {
        const ComplexBall t(Ball::exactly(x), Ball::exactly(y)), w = ComplexBall(pi<Ball>()) * (exp(t) - exp(-t)) / 2;
        // log u = -log(1 + exp(-w)) where Re w >= 0, where that is principal, w - log(1 + exp(w)) elsewhere; log r = log u - w
        log_u = x >= 0 ? -log(1 + exp(-w)) : w - log(1 + exp(w));
        log_r = log_u - w;
        u = exp(log_u);
        r = exp(log_r);
    }
};

struct Continued {
    const char* formula; ///< over [0, to]: x = u, 1 - x = r, or x = u/r
    std::function<ComplexBall(const Place&)> value;
    const char* to = "1";
    double reach = 3; ///< |u| and |r| up to here: beyond, next to the map's poles, the formula has zeros of its own, and roots have cuts
};

ComplexBall atan(const ComplexBall& z) { return touchstone::detail::complex_ball_of(acb_atan, z); }
ComplexBall half(const ComplexBall& log) { return exp(log / 2); }

const Continued cases[] = {
    {"log(x)", [](const Place& p) { return p.log_u; }},
    {"log(1-x)", [](const Place& p) { return p.log_r; }},
    {"log(x)*log(1-x)", [](const Place& p) { return p.log_u * p.log_r; }},
    {"log(x)/(1-x)", [](const Place& p) { return p.log_u / p.r; }},
    {"sqrt(x)", [](const Place& p) { return half(p.log_u); }},
    {"x^(1/3)*(1-x)^(-3/7)", [](const Place& p) { return exp(p.log_u / 3 - p.log_r * 3 / 7); }},
    {"sqrt(1-cos(x))", [](const Place& p) { return sqrt(ComplexBall(2)) * sin(p.u / 2); }},
    {"sqrt(x^2-x^3)", [](const Place& p) { return p.u * half(p.log_r); }},
    {"sqrt(exp(1-x)-1)", [](const Place& p) { return half(p.log_r) * sqrt((exp(p.r) - 1) / p.r); }},
    {"sqrt(x-sin(x))", [](const Place& p) { return p.u * half(p.log_u) * sqrt((p.u - sin(p.u)) / (p.u * p.u * p.u)); }},
    {"log(1-cos(x))", [](const Place& p) { return 2 * p.log_u + log((1 - cos(p.u)) / (p.u * p.u)); }},
    {"log(sin(pi*x))", [](const Place& p) { return p.log_u + p.log_r + log(sin(ComplexBall(pi<Ball>()) * p.u) / (p.u * p.r)); }},
    {"atan(1/x)", [](const Place& p) { return ComplexBall(pi<Ball>() / 2) - atan(p.u); }},
    {"atan(-3/(1-x)^2)", [](const Place& p) { return atan(p.r * p.r / 3) - ComplexBall(pi<Ball>() / 2); }},
    {"sqrt(sin(pi*x/2)-x)",
     [](const Place& p) { return half(p.log_u + p.log_r) * sqrt((sin(ComplexBall(pi<Ball>() / 2) * p.u) - p.u) / (p.u * p.r)); }},
    {"sqrt(1-cos(2*pi*x))", [](const Place& p) { return sqrt(ComplexBall(2)) * sin(ComplexBall(pi<Ball>()) * p.u); }, "1", 1.2},
    {"log(x)", [](const Place& p) { return p.log_u - p.log_r; }, "inf"},
    {"log(1+x)/x", [](const Place& p) { return -p.log_r * p.r / p.u; }, "inf"},
    {"log(1+1/x)", [](const Place& p) { return -p.log_u; }, "inf"},
    {"sqrt(x+x^2)", [](const Place& p) { return half(p.log_u) / p.r; }, "inf"},
    {"acos(x)", [](const Place& p) { return 2 * asin(half(p.log_r) / sqrt(ComplexBall(2))); }},
};

} // namespace

TEST_CASE("roots and logarithms go on around an end, whichever way they are had")
{
    const WorkingPrecision precision(128);
    std::mt19937_64 random(20261126);
    const auto uniform = [&](double a, double b) { return a + (b - a) * static_cast<double>(random() >> 11) * 0x1p-53; };
    for (const Continued& c : cases) {
        CAPTURE(std::string(c.formula));
        const Map map = c.to[0] == '1' ? Map::finite : Map::right_algebraic;
        const Integrand f(parse_expression(c.formula), Range{parse_limit("0"), parse_limit(c.to), map});
        Interval interval = f.range().interval();
        interval.prepare();
        int told = 0;
        for (int k = 0; k < 400; ++k) {
            const bool left = k % 2 == 0;
            const double x = uniform(0, 1.9), y = uniform(0, 1.45), width = uniform(0, 0.01);
            const StripPiece piece = StripPiece::at(left ? Side::left : Side::right, x, x + width, y, y + width);
            using N = EndpointNumber<ComplexBall>;
            const N u(&piece, {1, 0}, {}, ComplexBall(1)), r(&piece, {}, {1, 0}, ComplexBall(1));
            const Place place((left ? -1 : 1) * (x + width / 3), y + width / 2);
            const auto is_beyond = [&](const ComplexBall& z) { return arb_gt(abs(z).get(), Ball::exactly(c.reach).get()) != 0; };
            if (is_beyond(place.u) || is_beyond(place.r)) continue;
            const auto x_and_distances = interval.at(u, r);
            const ComplexBall value = f.at(x_and_distances.x, x_and_distances.left, x_and_distances.right).value(), truth = c.value(place);
            if (!value.is_finite()) continue;
            ++told;
            CAPTURE(x);
            CAPTURE(y);
            CAPTURE(left);
            CHECK_MESSAGE(value.overlaps(truth), value.real().to_string(10), " + i ", value.imag().to_string(10), " is not ",
                          truth.real().to_string(10), " + i ", truth.imag().to_string(10));
        }
        CHECK(told > 300);
    }
}

TEST_CASE("on a piece without end the logarithm of a distance is rho times what is said, at each of its points")
{
    const WorkingPrecision precision(128);
    for (const auto& [x1, d] : {std::pair(0.03125, 0.125), std::pair(0.0625, 1.25), std::pair(0.5, 0.75), std::pair(1.75, 1.25)})
        for (const Side side : {Side::left, Side::right}) {
            const StripPiece piece = StripPiece::at(side, x1, std::numeric_limits<double>::infinity(), 0, d);
            const ComplexBall claimed = piece.logarithm_over_rho(side);
            CHECK(claimed.is_finite());
            for (const double beyond : {0.0, 0.01, 0.2, 1.0})
                for (const double y : {0.0, d / 2, d}) {
                    const double x = x1 + beyond;
                    const Place at(side == Side::left ? -x : x, y);
                    const Ball e = exp(Ball::exactly(x)), rho = pi<Ball>() * (e - 1 / e) / 2 * cos(Ball::exactly(y));
                    const ComplexBall truth = (side == Side::left ? at.log_u : at.log_r) / ComplexBall(rho);
                    CAPTURE(x1);
                    CAPTURE(x);
                    CAPTURE(y);
                    CHECK(claimed.real().overlaps(truth.real()));
                    CHECK(abs(claimed.imag()).overlaps(abs(truth.imag())));
                }
        }
}

TEST_CASE("where a root goes on left of 0 it is no principal one, and the ellipse is proved of one of the two")
{
    // the pole of the root that goes on, at -c, is nearer than the ellipse that the principal root would allow
    const WorkingPrecision precision(400);
    const Ball c = Ball(51) / Ball(100);
    for (const auto& [formula, from, to] : {std::array{"1/(x+3)+1e-12*(0.51/(sqrt(x^2)+0.51))^40", "0", "1"},
                                            std::array{"1/(x+5/2)+1e-12*(0.51/(sqrt((x-1/2)^2)+0.51))^40", "1/2", "3/2"}})
        for (const long digits : {20L, 30L, 50L}) {
            CAPTURE(std::string(formula));
            CAPTURE(digits);
            IntegralOptions options;
            options.digits = digits;
            const Integral i = integrate(parse_expression(formula), parse_limit(from), parse_limit(to), options);
            const Ball small = pow(Ball(10), Ball(-12)) * (c - pow(c, Ball(40)) * pow(c + 1, Ball(-39))) / Ball(39);
            CHECK(i.status == Status::certified);
            CHECK(i.value.overlaps(log(Ball(4) / Ball(3)) + small));
        }
    // a box on both sides of the middle has to be finite in either form
    const Integrand f(parse_expression("sqrt(x^2)"), Range{parse_limit("0"), parse_limit("1"), Map::finite});
    ComplexBall beyond(Ball(Rational(-1, 2)), Ball(Rational(1, 10)));
    CHECK(f.in_plane_from(Side::left, beyond).overlaps(beyond));
    CHECK(f.in_plane_from(Side::right, beyond).overlaps(-beyond));
    mag_set_d(arb_radref(acb_realref(beyond.get())), 0.75);
    CHECK(f.in_plane_from(Side::left, beyond).is_finite());
    CHECK_FALSE(f.in_plane_from(Side::right, beyond).is_finite());
    CHECK_FALSE(f.in_plane_from(std::nullopt, beyond).is_finite());
}

TEST_CASE("the orders that a formula shows are the same on every piece, whichever way its zero is had")
{
    const Integrand f(parse_expression("1/sqrt(1-x)-1-x/2"), Range{parse_limit("0"), parse_limit("1"), Map::finite});
    const WorkingPrecision precision(64);
    for (const double x : {0.0, 0.3, 0.6, 0.9, 1.2, 1.8})
        for (const double width : {0.001, 0.1}) {
            const StripPiece piece = StripPiece::at(Side::left, x, x + width, 0.2, 0.2 + width);
            using N = EndpointNumber<ComplexBall>;
            const N u(&piece, {1, 0}, {}, ComplexBall(1)), r(&piece, {}, {1, 0}, ComplexBall(1)), value = f.at(u, u, r);
            CAPTURE(x);
            CHECK(value.left().power == Exponent(2));
            CHECK(value.right().power == Exponent(-1, 2));
        }
}

TEST_CASE("the order of a Bessel function is the same near 0 and far from it, and so is its value")
{
    // beyond |A x^k| = 8 another form is taken; what a root or a logarithm of it is must not show where
    const std::pair<const char*, Exponent> all[] = {{"besseli(15/2,61*x^(7/2))", Exponent(105, 4)},
                                                    {"besselj(-1/2,40*x)", Exponent(-1, 2)},
                                                    {"besselk(3,40*x)", Exponent(-3)},
                                                    {"bessely(2,40*x^(1/2))", Exponent(-1)}};
    for (const auto& [formula, power] : all) {
        const Integrand f(parse_expression(formula), Range{parse_limit("0"), parse_limit("1"), Map::finite});
        const WorkingPrecision precision(128);
        CAPTURE(std::string(formula));
        for (const double x : {-0.7, -0.4, -0.1, 0.2, 0.5})
            for (const double y : {0.0, 0.1}) {
                const StripPiece piece = StripPiece::at(Side::left, x, x + 0.001, y, y + 0.001);
                using N = EndpointNumber<ComplexBall>;
                const N u(&piece, {1, 0}, {}, ComplexBall(1)), r(&piece, {}, {1, 0}, ComplexBall(1)), value = f.at(u, u, r);
                CAPTURE(x);
                REQUIRE(value.factor().is_finite());
                CHECK(value.left().power == power);
                const ComplexBall plain = f.on_the_line(piece.distance(Side::left));
                CHECK(value.value().overlaps(plain));
            }
    }
}

TEST_CASE("log(x)/(1 - x) on balls about the end where both vanish")
{
    const WorkingPrecision precision(128);
    const Integrand f(parse_expression("log(x)/(1-x)"), Range{parse_limit("0"), parse_limit("1"), Map::finite});
    for (const char* middle : {"1", "0.9", "1.05"}) {
        CAPTURE(middle);
        ComplexBall ball(Ball(*parse_rational(middle)));
        mag_set_d(arb_radref(acb_realref(ball.get())), 0.1);
        mag_set_d(arb_radref(acb_imagref(ball.get())), 0.1);
        const ComplexBall value = f.in_plane(ball);
        REQUIRE(value.is_finite());
        for (const double re : {-0.09, 0.001, 0.09})
            for (const double im : {0.0, 0.09}) {
                const ComplexBall x = ComplexBall(Ball(*parse_rational(middle))) + ComplexBall(Ball::exactly(re), Ball::exactly(im));
                const ComplexBall truth = log(x) / (1 - x);
                CHECK(value.overlaps(truth));
            }
        CHECK(arb_le(abs(value + ComplexBall(1)).get(), Ball(Rational(1, 2)).get()));
    }
}
