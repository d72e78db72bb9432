// SPDX-License-Identifier: MIT
/// The library's formulas against the printed ones, against one another and against known
/// consequences, in balls: a residual contains zero, and is small enough to mean something.
#include "touchstone/paper/as_printed.hpp"
#include "touchstone/paper/peaks.hpp"
#include "touchstone/paper/weierstrass.hpp"
#include "touchstone/paper/weierstrass_profile.hpp"
#include "touchstone/paper/westergaard.hpp"
#include "touchstone/scalar/ball.hpp"

#include <doctest/doctest.h>

#include <random>

using namespace touchstone;

namespace {

constexpr slong bits = 300;

/// a == b as far as balls can say, and they say it to at least `least` bits.
void same(const Ball& a, const Ball& b, slong least = 200)
{
    CHECK(a.overlaps(b));
    const Ball difference = a - b;
    CHECK(mag_cmp_2exp_si(arb_radref(difference.get()), -least) < 0);
}

class Uniform {
public:
    explicit Uniform(unsigned seed) : engine_(seed) {}
    Rational operator()(const Rational& a, const Rational& b) { return a + (b - a) * Rational(engine_() >> 32) / 4294967296L; }

private:
    std::mt19937_64 engine_;
};

} // namespace

TEST_CASE("section 2: cancellation-free forms equal the printed ones")
{
    const unsigned seed = 1939;
    INFO("seed " << seed);
    Uniform random(seed);
    const WorkingPrecision precision(bits);
    for (int i = 0; i < 200; ++i) {
        const Ball load(random(Rational(1, 1000), Rational(999, 1000)));
        const Ball full(random(1, 5));
        same(westergaard::half_width(load), as_printed::half_width(load));
        const Ball a = westergaard::half_width(load);
        const Ball x = a * Ball(random(0, 1));
        same(westergaard::pressure(x, load), as_printed::pressure_partial(x, load));
        same(westergaard::pressure_at_edge_distance(a - x, load), westergaard::pressure(x, load));
        same(westergaard::pressure(x, full), as_printed::pressure_full(x, full));
        const Ball p = 2 * sqrt(load) * Ball(random(Rational(1, 1000), Rational(999, 1000)));
        same(westergaard::exceedance(p, load), as_printed::exceedance_partial(p, load));
        same(westergaard::density(p, load), as_printed::density_partial(p, load));
        const Ball t = full + Ball(random(Rational(-999, 1000), Rational(999, 1000)));
        same(westergaard::exceedance(t, full), as_printed::exceedance_full(t, full));
        same(westergaard::density(t, full), as_printed::density_full(t, full));
        same(hertz::pressure(x / 2, load), as_printed::hertz_pressure(x / 2, load));
        // Q inverts the pressure: the pressure at half the width Q is p
        same(westergaard::pressure(westergaard::exceedance(p, load) / 2, load), p, 150);
    }
}

TEST_CASE("section 2: the seam at load 1, the edges, and zero outside the contact")
{
    const WorkingPrecision precision(bits);
    const Ball one(1);
    for (const long k : {1L, 3L, 7L}) {
        const Ball x(Rational(k, 16));
        same(westergaard::pressure_partial(x, one), westergaard::pressure_full(x, one));
        same(westergaard::exceedance_partial(x, one), westergaard::exceedance_full(x, one));
        same(westergaard::density_partial(x, one), westergaard::density_full(x, one));
    }
    Ball near_one(1);
    arb_add_error(near_one.get(), power_of_two<Ball>(-100).get());
    CHECK(westergaard::pressure(Ball(Rational(1, 8)), near_one).overlaps(westergaard::pressure(Ball(Rational(1, 8)), one)));
    CHECK(westergaard::pressure(Ball(Rational(1, 8)), near_one).relative_bits() > 90);
    CHECK(arb_is_zero(westergaard::pressure(Ball(Rational(1, 2)), Ball(Rational(1, 2))).get()));
    CHECK(arb_is_zero(westergaard::exceedance(Ball(3), Ball(Rational(1, 2))).get()));
    CHECK(arb_is_zero(westergaard::density(Ball(3), Ball(Rational(1, 2))).get()));
    CHECK(arb_is_one(westergaard::exceedance(Ball(Rational(1, 2)), Ball(2)).get()));
    // a density ball that touches its edge is unbounded, not a number
    Ball edge = 2 * sqrt(Ball(Rational(1, 3)));
    CHECK_FALSE(westergaard::density(edge, Ball(Rational(1, 3))).is_finite());
}

TEST_CASE("section 2: equilibrium, the mean of the pressure is the load")
{
    // the trapezoidal rule is exact to all digits for the periodic analytic full-contact pressure ...
    const WorkingPrecision precision(bits);
    Ball mean(0);
    for (long k = 0; k < 64; ++k) mean += westergaard::pressure(Ball(Rational(k - 32, 64)), Ball(3)) / 64;
    same(mean, Ball(3));
    // ... and with sin(pi x) = sqrt(load) sin(psi) for partial contact (Gauss-Chebyshev in sin psi)
    const Ball load(Rational(3, 10));
    mean = Ball(0);
    const long N = 400;
    for (long k = 0; k < N; ++k) {
        const Ball psi = pi<Ball>() * Ball(Rational(2 * k + 1 - N, 2 * N));
        const Ball x = asin(sqrt(load) * sin(psi)) / pi<Ball>();
        const Ball stretch = sqrt(load) * cos(psi) / (pi<Ball>() * cos_pi(x));
        mean += westergaard::pressure(x, load) * stretch * pi<Ball>() / N;
    }
    same(mean, load, 190);
}

TEST_CASE("section 3: what the second route leaves out is in its ball where the last block of terms is a whole one")
{
    const Rational D(3, 2), gamma = 2;
    const WorkingPrecision precision(508);
    REQUIRE(weierstrass::terms_needed(D, gamma, 508) == 1024);
    const Ball highest = weierstrass::profile_by_scaling(0, D, gamma); // (3.4)
    CHECK(highest.relative_bits() > 500);
    const WorkingPrecision more(600);
    CHECK(arb_contains(highest.get(), (1 / (1 - sqrt(Ball(2)) / 2)).get()) != 0);
}

TEST_CASE("section 3: the two routes of the profile, the bound, the scaling relation (3.5)")
{
    for (const auto& [D, gamma] :
         {std::pair{Rational(3, 2), Rational(5)}, {Rational(21, 20), Rational(10)}, {Rational(7, 5), Rational(5, 2)}}) {
        const WorkingPrecision precision(200);
        const Ball zhat = weierstrass::bound(Ball(D), Ball(gamma));
        for (const Rational& x : {Rational(1, 10), Rational(-3, 7), Rational(123456789, 1000)}) {
            const Ball z = weierstrass::profile_by_terms(x, D, gamma);
            same(z, weierstrass::profile_by_scaling(x, D, gamma), 180);
            CHECK(certainly(less(abs(z), zhat)));
            const Ball right = pow(Ball(gamma), Ball(2 - D)) * (z - cos_pi(Ball(2 * x)));
            same(weierstrass::profile_by_terms(gamma * x, D, gamma), right, 150);
        }
        same(weierstrass::profile_by_terms(0, D, gamma), zhat, 150); // the bound is reached
    }
}

TEST_CASE("section 3: what is left out of the profile's sum is in its radius, also at x = 0, where all of it adds up")
{
    for (const auto& [D, gamma] :
         {std::pair{Rational(3, 2), Rational(5)}, {Rational(21, 20), Rational(10)}, {Rational(7, 5), Rational(5, 2)}}) {
        const WorkingPrecision precision(64);
        const Ball by_terms = weierstrass::profile_by_terms(0, D, gamma), by_scaling = weierstrass::profile_by_scaling(0, D, gamma);
        const WorkingPrecision more(256);
        const Ball zhat = weierstrass::bound(Ball(D), Ball(gamma));
        CHECK(arb_contains(by_terms.get(), zhat.get()));
        CHECK(arb_contains(by_scaling.get(), zhat.get()));
    }
}

TEST_CASE("section 3: a profile is zero where that is proven, also by hundreds of bits, and not where it is 10^-83")
{
    // cos 36 degrees = r/(1 - r), r = gamma^(D-2) = 5^(-1/2)
    CHECK(weierstrass::profile_exact(Rational(1, 10), Rational(3, 2), 5).is_zero());
    CHECK(weierstrass::profile_exact(Rational(1, 10), Rational(19, 10), 3125).is_zero());
    CHECK_THROWS_AS(weierstrass::profile_exact(Rational(1, 10), Rational(1599, 800), power(Rational(5), 400)), NotExact); // too dear
    // cos 72 degrees + r cos 144 degrees = 0 at r = phi^-2, phi the golden ratio: phi^200 is next to the Lucas number of 200
    Integer before = 2, lucas = 1;
    for (int n = 1; n < 200; ++n) {
        const Integer next = before + lucas;
        before = lucas;
        lucas = next;
    }
    CHECK_THROWS_AS(weierstrass::profile_exact(Rational(1, 5), Rational(199, 100), Rational(lucas)), NotExact);
    const WorkingPrecision precision(400);
    const Ball z = abs(weierstrass::profile_by_terms(Rational(1, 5), Rational(199, 100), Rational(lucas)));
    CHECK(certainly(less(z, power_of_two<Ball>(-270))));
    CHECK(certainly(less(power_of_two<Ball>(-300), z)));
}

TEST_CASE("section 3: the bound of conjugates exceeds the sum of the moduli of all terms, by no more than a factor of 3")
{
    const WorkingPrecision precision(64);
    // x = 1/10, gamma = 5: the phase 1/10, then 1/2 for ever; N = 2 gamma^(2 e) [(1 - r) c_0 + r c_1]
    for (const Rational& e : {Rational(1, 2), Rational(1, 20), Rational(19, 20)}) {
        const Ball r = pow(Ball(5), Ball(Rational(-e))), sum = 2 * pow(Ball(5), Ball(Rational(2 * e))) * (1 + r + r);
        const Ball most = weierstrass::conjugates_bound(2, e, 5);
        CHECK(certainly(less(sum, most)));
        CHECK(certainly(less(most, 3 * sum)));
    }
}

TEST_CASE("section 5: the fixed point is fixed, attracts, and joins at G = 2")
{
    const WorkingPrecision precision(bits);
    for (const Rational& g : {Rational(101, 100), Rational(3, 2), Rational(2), Rational(5, 2), Rational(16)}) {
        const Ball G(g);
        const Ball fixed = peaks::fixed_point(G);
        same(peaks::f(fixed) / G, fixed);
        if (g > Rational(11, 10)) {
            same(peaks::iterate(2000, Ball(10), G), fixed, 150);
            same(peaks::iterate(2000, Ball(power(Rational(10), -30)), G), fixed, 150);
        }
    }
}
