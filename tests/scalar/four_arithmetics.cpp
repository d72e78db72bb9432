// SPDX-License-Identifier: GPL-3.0-or-later
/// One formula, four arithmetics (and the exact one): what the README's first screen promises.
#include "touchstone/paper/archard.hpp"
#include "touchstone/paper/as_printed.hpp"
#include "touchstone/paper/peaks.hpp"
#include "touchstone/paper/segments.hpp"
#include "touchstone/paper/weierstrass.hpp"
#include "touchstone/paper/westergaard.hpp"
#include "touchstone/scalar/exact.hpp"
#include "touchstone/scalar/mpfr.hpp"
#include "touchstone/scalar/pair_ball.hpp"
#include "touchstone/scalar/symbol.hpp"

#include <doctest/doctest.h>

using namespace touchstone;

static_assert(Scalar<double> && Scalar<Mpfr> && Scalar<Ball> && Scalar<ComplexBall> && Scalar<Symbol> && Scalar<Exact>);
static_assert(OrderedScalar<double> && OrderedScalar<Mpfr> && OrderedScalar<Ball> && OrderedScalar<PairBall> && OrderedScalar<Exact>);
static_assert(!OrderedScalar<Symbol> && !OrderedScalar<ComplexBall>);

namespace {

/// The same formula in double, Mpfr and Ball; the ball must contain what the others approximate.
template <class Formula>
void agree(Formula f, std::initializer_list<double> arguments)
{
    const WorkingPrecision precision(256);
    Mpfr::default_precision(60);
    for (const double x : arguments) {
        CAPTURE(x);
        const Ball ball = f(Ball::exactly(x));
        REQUIRE(ball.relative_bits() > 200);
        const double in_double = f(x);
        CHECK(in_double == doctest::Approx(arf_get_d(arb_midref(ball.get()), ARF_RND_NEAR)).scale(0).epsilon(1e-14));
        Mpfr middle;
        arf_get_mpfr(middle.backend().data(), arb_midref(ball.get()), MPFR_RNDN);
        CHECK(abs(f(Mpfr(x)) - middle) <= abs(middle) * Mpfr("1e-55"));
    }
}

} // namespace

TEST_CASE("double, Mpfr and Ball agree on every formula")
{
    agree([]<class T>(const T& s) -> T { return westergaard::half_width(s); }, {1e-300, 0.1, 0.5, 0.999, 1.0});
    agree([]<class T>(const T& s) -> T { return westergaard::pressure(T(ratio<1, 8, T>()), s); }, {0.2, 0.9, 1.0, 5.0});
    agree([]<class T>(const T& s) -> T { return westergaard::exceedance(T(ratio<1, 8, T>()), s); }, {0.2, 0.9, 1.0});
    agree([]<class T>(const T& s) -> T { return westergaard::density(T(ratio<1, 8, T>()), s); }, {0.2, 0.9, 1.0});
    agree([]<class T>(const T& s) -> T { return westergaard::pressure_at_edge_distance(T(ratio<1, 1024, T>()), s); }, {0.2, 0.9});
    agree([]<class T>(const T& s) -> T { return hertz::pressure(T(ratio<1, 64, T>()), s); }, {0.2, 0.9, 1.0});
    agree([]<class T>(const T& g) -> T { return weierstrass::bound(T(ratio<3, 2, T>()), g); }, {1.0625, 5.0, 1e6});
    agree([]<class T>(const T& x) -> T { return weierstrass::profile_sum(x, T(ratio<3, 2, T>()), T(integer<T>(4)), 5); }, {0.125, 0.3});
    agree([]<class T>(const T& x) -> T { return peaks::f(x); }, {0.25, 1.0, 3.0});
    agree([]<class T>(const T& G) -> T { return peaks::fixed_point(G); }, {1.5, 2.0, 4.0});
    agree([]<class T>(const T& s) -> T { return peaks::iterate(5, s, T(integer<T>(3))); }, {0.01, 1.0, 10.0});
    agree([]<class T>(const T& s) -> T { return archard::step(s); }, {0.5, 0.75, 1.0});
    agree([]<class T>(const T& s) -> T { return archard::area(3, s, T(integer<T>(3)), archard::K_by_recursion<T>(3)); }, {0.001, 1.0});
    agree([]<class T>(const T& s) -> T { return segments::max_half_width(2, s, T(integer<T>(3))); }, {0.01, 1.0});
    agree([]<class T>(const T& s) -> T { return as_printed::exceedance_partial(T(ratio<1, 8, T>()), s); }, {0.2, 0.9});
}

TEST_CASE("a formula in symbols is an expression that can be reasoned about")
{
    const GiNaC::symbol load("load"), x("x");
    const Symbol p = westergaard::pressure_full(Symbol(x), Symbol(load));
    // (2.2) as printed, by the double-angle identity
    const Symbol printed = as_printed::pressure_full(Symbol(x), Symbol(load));
    const Symbol difference = (p - printed).subs(GiNaC::cos(2 * GiNaC::Pi * x) == 2 * GiNaC::pow(GiNaC::cos(GiNaC::Pi * x), 2) - 1);
    CHECK(difference.expand().is_zero());
    CHECK(p.diff(load) == 1);
    CHECK((archard::delta<Symbol>(3) - GiNaC::numeric(15, 16)).is_zero());
    CHECK((archard::alpha(2, Symbol(x)) - (1 - x) * GiNaC::numeric(5, 4)).expand().is_zero());
    CHECK((powm1(Symbol(x), Symbol(3)) - (x - 1) * (x * x + x + 1)).expand().is_zero());
    CHECK((hypot_of(Symbol(x), Symbol(load)) * hypot_of(Symbol(x), Symbol(load)) - x * x - load * load).expand().is_zero());
}

TEST_CASE("in exact arithmetic the formula decides what no ball can")
{
    const Exact G = weierstrass::pressure_ratio(Exact(Rational(3, 2)), Exact(4));
    CHECK(G.rational() == 2);
    CHECK(peaks::fixed_point(G).rational() == 1);
    CHECK(westergaard::half_width(Exact(Rational(1, 4))).rational() == Rational(1, 6));
    CHECK(westergaard::pressure(Exact(Rational(1, 6)), Exact(Rational(1, 4))).is_zero()); // the contact edge itself
    CHECK(westergaard::exceedance(Exact(1), Exact(Rational(1, 4))).is_zero());            // the highest pressure itself
}
