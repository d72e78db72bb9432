// SPDX-License-Identifier: MIT
// Other people's integrators on the same integrals: Arb's (bounded integrands, Gauss-Legendre in balls) and GSL's (double).
#include "tests/quadrature/closed_form.hpp"
#include "touchstone/paper/westergaard.hpp"

#include <doctest/doctest.h>

#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>

#if __has_include(<flint/acb_calc.h>)
#include <flint/acb_calc.h>
#else
#include <acb_calc.h>
#endif

#include <functional>
#include <memory>

using namespace touchstone;
using namespace touchstone::quadrature;
using namespace touchstone::quadrature::testing;

namespace {

using ComplexFunction = std::function<ComplexBall(const ComplexBall& z, bool analytic)>;

/// Arb's integral of f over [a, b]; nothing unless it says success *and* the ball is finite.
std::optional<Ball> arb_integral(const ComplexFunction& f, const Ball& a, const Ball& b, long digits)
{
    const slong bits = bits_for_digits(digits) + 20;
    const WorkingPrecision precision(bits);
    const auto call = [](acb_ptr out, const acb_t z, void* param, slong order, slong working) -> int {
        const WorkingPrecision here(working);
        ComplexBall argument;
        acb_set(argument.get(), z);
        const ComplexBall value = (*static_cast<const ComplexFunction*>(param))(argument, order != 0);
        acb_set(out, value.get());
        return 0;
    };
    mag_t tolerance;
    mag_init(tolerance);
    mag_set_ui_2exp_si(tolerance, 1, -bits);
    acb_calc_integrate_opt_t options;
    acb_calc_integrate_opt_init(options);
    options->eval_limit = 2000000;
    options->depth_limit = 100000;
    ComplexBall value;
    const int status = acb_calc_integrate(value.get(), call, const_cast<ComplexFunction*>(&f), ComplexBall(a).get(), ComplexBall(b).get(),
                                          bits, tolerance, options, bits);
    mag_clear(tolerance);
    if (status != ARB_CALC_SUCCESS || !value.is_finite()) return std::nullopt;
    return value.real();
}

ComplexBall root(const ComplexBall& z, bool analytic)
{
    ComplexBall w;
    acb_sqrt_analytic(w.get(), z.get(), analytic, WorkingPrecision::bits());
    return w;
}

struct GslResult {
    double value, error;
    int status;
};

GslResult qags(const std::function<double(double)>& f, double a, double b, const std::vector<double>& breaks = {})
{
    static const auto quiet = gsl_set_error_handler_off();
    (void)quiet;
    const std::unique_ptr<gsl_integration_workspace, decltype(&gsl_integration_workspace_free)> space(gsl_integration_workspace_alloc(1000),
                                                                                                      &gsl_integration_workspace_free);
    gsl_function g{[](double x, void* p) { return (*static_cast<const std::function<double(double)>*>(p))(x); },
                   const_cast<std::function<double(double)>*>(&f)};
    GslResult r{};
    if (breaks.empty()) r.status = gsl_integration_qags(&g, a, b, 0, 1e-10, 1000, space.get(), &r.value, &r.error);
    else {
        std::vector<double> points{a};
        points.insert(points.end(), breaks.begin(), breaks.end());
        points.push_back(b);
        r.status = gsl_integration_qagp(&g, points.data(), points.size(), 0, 1e-10, 1000, space.get(), &r.value, &r.error);
    }
    return r;
}

Enclosure ours(const auto& f, const Interval& interval, long digits)
{
    Options options;
    options.digits = digits;
    Enclosure e = tanh_sinh(f, interval, options);
    CHECK_MESSAGE(e.status == Status::certified, e.reason);
    return e;
}

/// GSL within its own error estimate (times ten: it is an estimate) of the ball.
void check_gsl(const GslResult& g, const Ball& ball)
{
    CHECK(g.status == GSL_SUCCESS);
    const WorkingPrecision precision(100);
    const Ball distance = touchstone::abs(Ball::exactly(g.value) - ball);
    CHECK(certainly(less(distance, Ball::exactly(10 * g.error + 1e-14))));
}

} // namespace

TEST_CASE("Arb's integrator overlaps where the integrand is bounded")
{
    for (const long digits : {30L, 100L}) {
        const auto exponential = arb_integral([](const ComplexBall& z, bool) { return exp(z * z); }, Ball(0), Ball(1), digits);
        REQUIRE(exponential);
        CHECK(exponential->overlaps(ours([](auto x, auto, auto) { return exp(x * x); }, Interval::finite(0, 1), digits).value));

        const auto near_pole = arb_integral([](const ComplexBall& z, bool) { return 1 / (z * z + ComplexBall(Rational(1, 10000))); },
                                            Ball(-1), Ball(1), digits);
        REQUIRE(near_pole);
        CHECK(near_pole->overlaps(
            ours([](auto x, auto, auto) { return 1 / (x * x + Rational(1, 10000)); }, Interval::finite(-1, 1), digits).value));

        const auto root_end =
            arb_integral([](const ComplexBall& z, bool analytic) { return root(1 - z, analytic) * cos(z); }, Ball(0), Ball(1), digits);
        REQUIRE(root_end);
        CHECK(root_end->overlaps(ours([](auto x, auto, auto r) { return sqrt(r) * cos(x); }, Interval::finite(0, 1), digits).value));

        // (7.13) at n = 0: (1 - x^2)^(1/4)
        const auto quarter = arb_integral([](const ComplexBall& z, bool analytic) { return root(root(1 - z * z, analytic), analytic); },
                                          Ball(-1), Ball(1), digits);
        REQUIRE(quarter);
        CHECK(quarter->overlaps(
            ours([](auto, auto l, auto r) { return to_power(l * r, Rational(1, 4)); }, Interval::finite(-1, 1), digits).value));
    }
}

TEST_CASE("(6.7) at n = 1: Arb's integrator on the recursion, ours on the density")
{
    const Rational load(1, 10), G(4);
    const long digits = 30;
    const auto recursion = arb_integral([&](const ComplexBall& psi, bool analytic) {
        const ComplexBall s(load), g(G);
        const ComplexBall sine = sin(psi), cosine = cos(psi), under = 1 - s * sine * sine;
        const ComplexBall r = root(under, analytic);
        const ComplexBall y = 2 / g * root(s, false) * cosine * r, root_y = root(y, analytic);
        // 2 asin(sqrt y)/pi = 1 - 2 acos(sqrt y)/pi is analytic for 0 < y < 1; refuse balls near y = 1
        if (analytic && !(arb_lt(acb_realref(root_y.get()), Ball(1).get()))) return ComplexBall::indeterminate();
        return 4 / ComplexBall(pi<Ball>() * pi<Ball>()) * root(s, false) * cosine / r * asin(root_y);
    }, Ball(0), [] { const WorkingPrecision p(200); return pi<Ball>() / 2; }(), digits);
    REQUIRE(recursion);
    const Enclosure density = ours([&](auto p, auto, auto r) {
        using T = decltype(p);
        const T s(load), edge = 2 * sqrt(s);
        return westergaard::density_partial(p, s, T(sqrt(r * (edge + p)))) * 2 * asin(sqrt(p / G)) / pi<T>();
    }, Interval::finite(0, Endpoint([&] { return 2 * sqrt(Ball(load)); })), digits);
    CHECK(recursion->overlaps(density.value));
}

TEST_CASE("Arb's integrator does not give a finite ball where the integrand is unbounded: ours does")
{
    CHECK_FALSE(arb_integral([](const ComplexBall& z, bool analytic) { return 1 / root(1 - z, analytic); }, Ball(0), Ball(1), 30));
    CHECK(ours([](auto, auto, auto r) { return 1 / sqrt(r); }, Interval::finite(0, 1), 30).value.contains(Rational(2)));
}

TEST_CASE("GSL's QAGS and QAGP agree in double")
{
    check_gsl(qags([](double x) { return std::pow(x, -0.9); }, 0, 1),
              ours([](auto, auto l, auto) { return to_power(l, Rational(-9, 10)); }, Interval::finite(0, 1), 30).value);
    check_gsl(qags([](double x) { return std::log(x) / std::sqrt(x); }, 0, 1),
              ours([](auto, auto l, auto) { return log(l) / sqrt(l); }, Interval::finite(0, 1), 30).value);
    check_gsl(qags([](double x) { return 1 / (x * x + 1e-4); }, -1, 1),
              ours([](auto x, auto, auto) { return 1 / (x * x + Rational(1, 10000)); }, Interval::finite(-1, 1), 30).value);
    check_gsl(qags([](double x) { return std::sqrt(1 - x) * std::cos(x); }, 0, 1),
              ours([](auto x, auto, auto r) { return sqrt(r) * cos(x); }, Interval::finite(0, 1), 30).value);
    // a break inside: |x - 1/3|^(-1/2), ours in two parts
    const Rational third(1, 3);
    const Ball parts = ours([](auto, auto, auto r) { return 1 / sqrt(r); }, Interval::finite(-1, third), 30).value +
                       ours([](auto, auto l, auto) { return 1 / sqrt(l); }, Interval::finite(third, 1), 30).value;
    check_gsl(qags([](double x) { return 1 / std::sqrt(std::fabs(x - 1.0 / 3)); }, -1, 1, {1.0 / 3}), parts);
}
