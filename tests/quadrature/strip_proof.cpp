// SPDX-License-Identifier: MIT
// What is proved of a strip, beside the same integrals by a fine step in complex doubles: a bound is above the truth, and not far above it.
#include "touchstone/quadrature/integrand.hpp"
#include "touchstone/quadrature/strip_proof.hpp"
#include "touchstone/quadrature/tanh_sinh.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <complex>
#include <functional>
#include <numbers>
#include <tuple>

using namespace touchstone;
using namespace touchstone::quadrature;

namespace {

using C = std::complex<double>;
using PanelFunction = quadrature::detail::PanelFunction<ComplexBall>;

double to_double(const Ball& x) { return arf_get_d(arb_midref(x.get()), ARF_RND_NEAR); }

/// Over [0, to], to 30 digits.
Enclosure by_tanh_sinh(const std::string& formula, const std::string& to, Transformation transformation = Transformation::tanh_sinh)
{
    const Map map = to == "inf" ? Map::right_algebraic : Map::finite;
    const auto f = std::make_shared<const Integrand>(parse_expression(formula), Range{parse_limit("0"), parse_limit(to), map});
    const auto at = [f](const auto& x, const auto& left, const auto& right) { return f->at(x, left, right); };
    Options options;
    options.transformation = transformation;
    return tanh_sinh(at, f->range().interval(), options);
}

struct Case {
    std::string formula, to; ///< over [0, to]
    std::function<C(C x, C r)> f; ///< r = 1 - u
    double strip, scale; ///< how many times the truth the bounds may be, beside the line and on it
    Transformation transformation = Transformation::tanh_sinh;
};

const Case cases[] = {
    {"exp(x)", "1", [](C x, C) { return std::exp(x); }, 12, 3},
    {"exp(x)/sqrt(x)", "1", [](C x, C) { return std::exp(x) / std::sqrt(x); }, 10, 2.5},
    {"exp(-3*x)*(1-x)^(-3/4)", "1", [](C x, C r) { return std::exp(-3. * x) * std::pow(r, -0.75); }, 15, 3},
    {"x^(-1/2)*(1-x)^(-1/4)", "1", [](C x, C r) { return std::pow(x, -0.5) * std::pow(r, -0.25); }, 4, 2},
    {"x^(-9/10)", "1", [](C x, C) { return std::pow(x, -0.9); }, 3, 2},
    {"exp(x)*(1-x)^(-9/10)", "1", [](C x, C r) { return std::exp(x) * std::pow(r, -0.9); }, 3.5, 2},
    {"-5*x^(1/3)", "1", [](C x, C) { return -5. * std::pow(x, 1 / 3.); }, 4, 3},
    {"1/(1+9*(x-1/2)^2)", "1", [](C x, C) { return 1. / (1. + 9. * (x - 0.5) * (x - 0.5)); }, 12, 4},
    {"log(x)", "1", [](C x, C r) { return std::abs(r) < 1e-4 ? -r - r * r / 2. : std::log(x); }, 30, 6},
    {"1/(1+x^2)", "inf", [](C x, C) { return 1. / (1. + x * x); }, 12, 7, Transformation::logistic},
};

/// F = f dx/dt at t, u, r and du/dt.
struct Value {
    C F, u, r, slope;
};

Value value_at(const Case& c, C t)
{
    const bool logistic = c.transformation == Transformation::logistic;
    const C w = logistic ? t : std::numbers::pi * std::sinh(t), u = 1. / (1. + std::exp(-w)), r = 1. / (1. + std::exp(w));
    const C du = u * r * (logistic ? 1. : std::numbers::pi * std::cosh(t));
    const bool finite = c.to == "1";
    const C dx = finite ? du : du / (r * r);
    return {c.f(finite ? u : u / r, r) * dx, u, r, du};
}

/// The integral of |F| over the line Im t = d, by a step so fine that its error is far below a percent.
double over_line(const Case& c, double d)
{
    const double far = c.transformation == Transformation::logistic ? 60 : 4.5, h = far / 20000;
    double sum = 0;
    for (int k = -20000; k <= 20000; ++k)
        if (const double size = std::abs(value_at(c, C(k * h, d)).F); std::isfinite(size)) sum += h * size;
    return sum;
}

/// The largest |f dx/du| u^(1 - alpha) r^(1 - beta) on the boundary of the piece that reaches an end.
double largest_at_end(const Case& c, const Panel& p, bool left)
{
    constexpr double depth = 4; // where the shallowest piece begins
    const bool logistic = c.transformation == Transformation::logistic;
    const double edge = logistic ? depth : std::asinh(depth / (std::numbers::pi * std::cos(p.strip))) + 1. / 64;
    double largest = 0;
    for (int k = 0; k <= 200; ++k)
        for (const double y : {0., p.strip / 2, p.strip}) {
            const double x = edge + (logistic ? 0.1 : 0.01) * k;
            const Value v = value_at(c, C(left ? -x : x, y));
            const auto power = [](C distance, const Exponent& e) { return std::pow(std::abs(distance), e.to_double() - 1); };
            const double unit = std::abs(v.slope) * power(v.u, p.alpha) * power(v.r, p.beta);
            if (const double ratio = std::abs(v.F) / unit; std::isfinite(ratio)) largest = std::max(largest, ratio);
        }
    return largest;
}

} // namespace

TEST_CASE("bounds of a strip and of its ends are above the truth, and near to it")
{
    for (const Case& c : cases) {
        CAPTURE(c.formula);
        const Enclosure e = by_tanh_sinh(c.formula, c.to, c.transformation);
        REQUIRE(e.certificate.panels.size() == 1);
        const Panel& p = e.certificate.panels.front();
        const double strip = to_double(p.strip_integral) / (2 * over_line(c, p.strip)), scale = to_double(p.scale) / over_line(c, 0);
        CHECK(strip > 1);
        CHECK(strip < c.strip);
        CHECK(scale > 1);
        CHECK(scale < c.scale);
        for (const bool left : {true, false}) {
            CAPTURE(left);
            const double share = largest_at_end(c, p, left) / to_double(left ? p.bound_left : p.bound_right);
            CHECK(share < 1 + 1e-9);
            CHECK(share > 0.25);
        }
    }
}

TEST_CASE("an end is proved with the exponents that the integrand has here and there, and what has no integral is told with its own")
{
    const WorkingPrecision precision(strip_bits);
    const PanelFunction of_powers = [](const Frame<ComplexBall>& frame) {
        return EndpointNumber<ComplexBall>(&frame, {Exponent(-1, 2), 0}, {Exponent(-9, 5), 0}, ComplexBall(1));
    };
    quadrature::detail::StripProof proof(of_powers, 100);
    Panel panel;
    CHECK_FALSE(proof.run(panel, 100));
    CHECK(proof.reason == "at the right end the exponent -9/5 is all that is proved, and the integral needs one above -1");
    const PanelFunction of_others = [](const Frame<ComplexBall>& frame) {
        return EndpointNumber<ComplexBall>(&frame, {Exponent(-1, 2), 0}, {Exponent(-1, 5), 0}, ComplexBall(1));
    };
    quadrature::detail::StripProof other(of_others, 100);
    REQUIRE(other.run(panel, 100));
    for (const auto& [end, here, far] :
         {std::tuple(other.left, Exponent(1, 2), Exponent(4, 5)), std::tuple(other.right, Exponent(4, 5), Exponent(1, 2))}) {
        CHECK(end.here == here);
        CHECK(end.far == far);
    }
}

TEST_CASE("what is known with fewer digits than asked for is undecided, with as many as are known")
{
    const auto known_to_twelve_digits = [](const auto& x, const auto&, const auto&) {
        Ball one(1);
        mag_set_d(arb_radref(one.get()), 3e-13);
        return x * std::decay_t<decltype(x)>(one);
    };
    const Enclosure e = tanh_sinh(known_to_twelve_digits, Interval::finite(0, 1), Options{});
    CHECK(e.status == Status::undecided);
    CHECK(e.digits == 12);
    CHECK(e.value.contains(Rational(1, 2)));
    CHECK(e.reason.find("12 of 30 digits") != std::string::npos);
    CHECK(by_tanh_sinh("x^(-3/2)", "1").reason ==
          "at the left end the exponent -3/2 is all that is proved, and the integral needs one above -1");
}

TEST_CASE("where a proof stops is told: in words of the last part that was tried, in numbers of the whole")
{
    struct Stop {
        const char* formula;
        double part, whole;
    };
    const std::string near = "near the fraction ";
    for (const auto& [formula, part, whole] :
         {Stop{"1/(x-0.7)^2", 0.7, 0.7}, Stop{"1/(x-0.07)^2", 0.07, 0.07}, Stop{"1/((x-0.3)^2*(x-0.8)^2)", 0.3, 0.3},
          Stop{"1/((x-0.3)^2+10^(-10))/(x-0.8)^2", 0.8, 0.3}}) {
        CAPTURE(formula);
        const Enclosure e = by_tanh_sinh(formula, "1");
        REQUIRE(e.status == Status::indeterminate);
        REQUIRE(e.fraction);
        CHECK(std::fabs(*e.fraction - whole) < 1e-4);
        REQUIRE(e.reason.find(near) != std::string::npos);
        CHECK(std::fabs(std::stod(e.reason.substr(e.reason.find(near) + near.size())) - part) < 1e-4);
    }
}

TEST_CASE("a range is cut beside each of two poles that are close to it, and its parts are the whole")
{
    const Enclosure e = by_tanh_sinh("1/((x-0.3)^2+10^(-10))+1/((x-0.8)^2+10^(-10))", "1");
    REQUIRE(e.status == Status::certified);
    Rational reached = 0;
    for (const Panel& p : e.certificate.panels) {
        CHECK(p.from == reached);
        CHECK(p.from < p.to);
        reached = p.to;
    }
    CHECK(reached == 1);
}
