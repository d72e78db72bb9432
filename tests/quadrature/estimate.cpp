// SPDX-License-Identifier: MIT
// The unproven versions: double on Boost.Math's rule, Mpfr on ours.
#include "touchstone/quadrature/estimate.hpp"
#include "touchstone/quadrature/tanh_sinh.hpp"

#include <doctest/doctest.h>

using namespace touchstone;
using namespace touchstone::quadrature;

namespace {

template <class Real>
Real power_of(const Real& x, int n, int d)
{
    using std::pow;
    return pow(x, Real(Real(n) / d));
}

/// The estimate is labelled, converged, within its own error of the proved ball (or of rounding), and that error is small.
template <class Real, class F>
void check_estimate(const F& f, const Interval& interval, const Ball& exact, double most)
{
    const Estimated<Real> e = estimate<Real>(f, interval);
    CHECK(std::string(e.status) == "estimated");
    CHECK(e.converged);
    CHECK(e.evaluations > 10);
    Ball value;
    if constexpr (std::same_as<Real, double>) arb_set_d(value.get(), e.value);
    else arf_set_mpfr(arb_midref(value.get()), e.value.backend().data());
    const WorkingPrecision precision(2000);
    const Ball off = touchstone::abs(value - exact) / touchstone::abs(exact);
    const double relative = arf_get_d(arb_midref(off.get()), ARF_RND_UP);
    INFO("relative error " << relative << ", claimed " << e.error);
    CHECK(relative <= most);
    CHECK(relative * std::fabs(static_cast<double>(e.value)) <= static_cast<double>(e.error));
    const double size = std::fabs(static_cast<double>(e.value));
    CHECK(static_cast<double>(e.error) <= (std::same_as<Real, double> ? 1e5 : 2000) * most * size); // Boost's levels differ by more
    CHECK(std::fabs(static_cast<double>(e.magnitude) - size) <= 1e-9 * size); // no integrand here changes its sign
}

template <class Real>
void check_all(double most)
{
    using std::exp;
    using std::log;
    using std::sqrt;
    const WorkingPrecision precision(1200);
    check_estimate<Real>([](const Real&, const Real& l, const Real&) { return power_of(l, -9, 10); }, Interval::finite(0, 1), Ball(10),
                         20 * most);
    check_estimate<Real>([](const Real&, const Real&, const Real& r) { return Real(1 / sqrt(r)); }, Interval::finite(0, 1), Ball(2), most);
    check_estimate<Real>([](const Real&, const Real&, const Real& r) { return Real(sqrt(r)); }, Interval::finite(-1, 3), Ball(16) / 3,
                         most);
    check_estimate<Real>([](const Real& x, const Real&, const Real&) { return Real(exp(x)); }, Interval::finite(0, 1), exp(Ball(1)) - 1,
                         most);
    const long small = 1'000'000'000'000;
    check_estimate<Real>([small](const Real& x, const Real&, const Real&) { return Real(exp(x) / small); }, Interval::finite(0, 1),
                         (exp(Ball(1)) - 1) / Ball(small), most);
    check_estimate<Real>([](const Real&, const Real& l, const Real&) { return Real(log(l)); }, Interval::finite(0, 1), Ball(-1), most);
    check_estimate<Real>([](const Real&, const Real& l, const Real& r) { return power_of(Real(l * r), 1, 4); }, Interval::finite(-1, 1),
                         sqrt(pi<Ball>()) * gamma_function(Ball(Rational(5, 4))) / gamma_function(Ball(Rational(7, 4))), most);
    check_estimate<Real>([](const Real& x, const Real&, const Real&) { return Real(1 / (1 + x * x)); },
                         Interval::whole_line(Decay::algebraic), pi<Ball>(), most);
    check_estimate<Real>([](const Real&, const Real& l, const Real& r) { return Real(r / sqrt(l)); },
                         Interval::right_half_line(0, Decay::exponential), sqrt(pi<Ball>()), most);
    check_estimate<Real>([](const Real& x, const Real&, const Real&) { return Real(1 / (x * x)); },
                         Interval::right_half_line(2, Decay::algebraic), Ball(1) / 2, most);
}

} // namespace

TEST_CASE("double: every case to a few ulp")
{
    check_all<double>(2e-15);
}

TEST_CASE("Mpfr at 50 and 300 digits, the cache keyed by precision")
{
    const unsigned before = Mpfr::default_precision();
    for (const unsigned digits : {50U, 300U, 50U}) {
        Mpfr::default_precision(digits);
        check_all<Mpfr>(std::pow(10.0, 1.0 - digits));
    }
    Mpfr::default_precision(before);
}

TEST_CASE("what is not finite, or does not settle, is not called converged")
{
    const auto pole = estimate<double>([](double, double l, double) { return 1 / l; }, Interval::finite(0, 1));
    CHECK((!pole.converged || pole.error > 1e-3 * std::fabs(pole.value)));
    CHECK_FALSE(estimate<double>([](double, double, double) { return std::numeric_limits<double>::quiet_NaN(); }, Interval::finite(0, 1))
                    .converged);
    Mpfr::default_precision(50);
    const auto nothing = estimate<Mpfr>([](const Mpfr&, const Mpfr&, const Mpfr&) { return Mpfr(0); }, Interval::finite(0, 1));
    CHECK(nothing.converged);
    CHECK(nothing.value == 0);
    CHECK_FALSE(estimate<Mpfr>([](const Mpfr& x, const Mpfr&, const Mpfr&) { return Mpfr(abs(x - Mpfr(1) / 3)); }, Interval::finite(-1, 1),
                               Mpfr(0), 8)
                    .converged);
    // where the differences of levels shrink by a factor alone the last of them is the error, and no power of it (but for two that agree
    // by accident)
    for (const int levels : {6, 8, 10}) {
        const auto kink = estimate<Mpfr>([](const Mpfr& x, const Mpfr&, const Mpfr&) { return Mpfr(abs(x - Mpfr(1) / 3)); },
                                         Interval::finite(-1, 1), Mpfr(0), levels);
        CHECK(Mpfr(abs(kink.value - Mpfr(10) / 9)) <= kink.error);
    }
    // Beyond the last node is a part of 10^-37 of it, however small the whole: the sums agree to more than that.
    const auto cut_off = estimate<Mpfr>([](const Mpfr&, const Mpfr& l, const Mpfr&) { return Mpfr(power_of(l, -19, 20) * Mpfr("1e-30")); },
                                        Interval::finite(0, 1));
    CHECK_FALSE(cut_off.converged);
    CHECK(cut_off.error < Mpfr("1e-64"));
    CHECK(Mpfr(abs(cut_off.value - Mpfr("20e-30"))) < cut_off.error);
    CHECK_FALSE(
        estimate<Mpfr>([](const Mpfr&, const Mpfr&, const Mpfr&) { return std::numeric_limits<Mpfr>::quiet_NaN(); }, Interval::finite(0, 1))
            .converged);
}
