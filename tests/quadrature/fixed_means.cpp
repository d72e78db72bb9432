// SPDX-License-Identifier: MIT
// K and E in fixed point against Arb's series, which share nothing with them.
#include "touchstone/quadrature/fixed_means.hpp"
#include "touchstone/scalar/flint_headers.hpp"

#include "arb_elliptic.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>
#include <string>

using namespace touchstone;
using namespace touchstone::quadrature;

namespace {

/// K/pi and E/pi of 1 - v by Arb, with bits to spare.
Elliptic<Ball> by_arb(const Ball& v, slong bits)
{
    const WorkingPrecision precise(2 * bits + 200);
    const ComplexBall m = ComplexBall(1) - ComplexBall(v);
    const slong more = WorkingPrecision::bits();
    return {elliptic_k(m, more).real() / pi<Ball>(), elliptic_e(m, more).real() / pi<Ball>()};
}

/// Inside the ball, which has not lost more than some bits.
void holds(const Ball& found, const Ball& truth, slong bits)
{
    CHECK(found.contains(truth));
    CHECK(found.relative_bits() > bits - 6);
}

void holds_at(const Ball& v, slong bits)
{
    const WorkingPrecision precision(bits);
    CAPTURE(v.to_string());
    CAPTURE(bits);
    const auto both = by_fixed_means(v, true), first = by_fixed_means(v, false);
    REQUIRE(both);
    REQUIRE(first);
    CHECK_FALSE(first->e.is_finite()); // which was not asked for
    const Elliptic<Ball> truth = by_arb(v, bits);
    holds(first->k, truth.k, bits);
    holds(both->k, truth.k, bits);
    holds(both->e, truth.e, bits);
}

} // namespace

TEST_CASE("K and E in fixed point hold their values, at every size and precision")
{
    std::mt19937 random(20261128);
    std::uniform_real_distribution<double> share(0, 1), exponent(-32, 0);
    for (const slong bits : {20, 53, 64, 128, 200, 333, 1000, 5000})
        for (int k = 0; k < (bits < 1000 ? 200 : 20); ++k) {
            holds_at(Ball::exactly(std::exp2(exponent(random))), bits);
            holds_at(Ball::exactly(share(random)), bits);
            holds_at(Ball::exactly(std::exp2(-exponent(random))), bits);
            holds_at(Ball::exactly(1 - std::exp2(exponent(random))), bits);
        }
    // the ends of its domain, and numbers with more bits than are kept
    for (const slong bits : {53, 200, 1000}) {
        holds_at(ScalarTraits<Ball>::power_of_two(-32), bits);
        holds_at(ScalarTraits<Ball>::power_of_two(32), bits);
        holds_at(ScalarTraits<Ball>::power_of_two(-1), bits);
        for (const long near : {-10, -60, -200, -3000}) {
            const WorkingPrecision precise(4000);
            holds_at(Ball(1) - ScalarTraits<Ball>::power_of_two(near), bits);
            holds_at(Ball(1) / Ball(2) + ScalarTraits<Ball>::power_of_two(near - 2), bits);
        }
    }
}

TEST_CASE("a ball of K and E in fixed point holds what is said at its ends; none is said of other numbers")
{
    std::mt19937 random(20261129);
    std::uniform_real_distribution<double> share(0.01, 0.99), place(0.01, 3);
    for (int k = 0; k < 300; ++k) {
        const double middle = place(random), radius = middle * share(random);
        const WorkingPrecision precision(100);
        const Ball low = Ball::exactly(middle) - Ball::exactly(radius), high = Ball::exactly(middle) + Ball::exactly(radius);
        Ball v = Ball::exactly(middle);
        arb_add_error(v.get(), Ball::exactly(radius).get());
        const auto found = by_fixed_means(v, true);
        REQUIRE(found);
        for (const Ball& end : {low, high}) {
            const Elliptic<Ball> truth = by_arb(end, 100);
            CHECK(found->k.overlaps(truth.k));
            CHECK(found->e.overlaps(truth.e));
        }
    }
    { // next to 1, where 1/v is rounded
        const WorkingPrecision precise(400);
        const Ball v = Ball(1) + ScalarTraits<Ball>::power_of_two(-300);
        const WorkingPrecision precision(64);
        const Elliptic<Ball> found = elliptic_of_complement(v), over_pi = elliptic_over_pi(v, true), truth = by_arb(v, 64);
        holds(over_pi.k, truth.k, 64);
        holds(over_pi.e, truth.e, 64);
        const WorkingPrecision more(400);
        holds(found.k, truth.k * pi<Ball>(), 64);
        holds(found.e, truth.e * pi<Ball>(), 64);
    }
    Ball beyond(1);
    mag_set_ui(arb_radref(beyond.get()), 2);
    const Ball tiny = ScalarTraits<Ball>::power_of_two(-33), huge = ScalarTraits<Ball>::power_of_two(33);
    for (const Ball& v : {Ball(0), Ball(-1), Ball(1), tiny, huge, Ball::indeterminate(), beyond})
        CHECK_FALSE(by_fixed_means(v, true));
}
