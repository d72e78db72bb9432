// SPDX-License-Identifier: MIT
#include "touchstone/paper/archard_interpolation.hpp"

#include "touchstone/paper/archard.hpp"
#include "touchstone/scalar/flint_headers.hpp"
#if __has_include(<flint/acb.h>)
#include <flint/acb.h>
#else
#include <acb.h>
#endif

#include <doctest/doctest.h>

using namespace touchstone;

namespace {

/// A complex ball, for as long as a test needs one.
struct Disc {
    acb_t value;
    Disc() { acb_init(value); }
    ~Disc() { acb_clear(value); }
    Disc(const Disc&) = delete;
    Disc& operator=(const Disc&) = delete;
};

/// |log F(x)| for all x of an arc of |x| = 1 about e^(2 pi i turn), so wide that `arcs` of them are the circle: log Gamma has no singularity near 3/2 - x, 2 - x.
Ball size_of_log_factor(const Rational& turn, long arcs)
{
    const slong bits = WorkingPrecision::bits();
    Disc x, argument, gamma, log_factor;
    Ball angle{2 * turn};
    const Ball half_arc = Ball(1) / arcs; // of a turn of 2
    arb_add_error(angle.get(), half_arc.get());
    acb_set_arb(x.value, angle.get());
    acb_exp_pi_i(x.value, x.value, bits);
    acb_mul_si(log_factor.value, x.value, -2, bits);
    acb_add_ui(log_factor.value, log_factor.value, 1, bits);
    acb_mul_arb(log_factor.value, log_factor.value, log(Ball(2)).get(), bits);
    acb_sub_arb(log_factor.value, log_factor.value, (log(pi<Ball>()) / 2).get(), bits);
    for (const long halves : {3L, 4L}) {
        acb_set_arb(argument.value, Ball(Rational(halves, 2)).get());
        acb_sub(argument.value, argument.value, x.value, bits);
        acb_lgamma(gamma.value, argument.value, bits);
        if (halves == 3) acb_add(log_factor.value, log_factor.value, gamma.value, bits);
        else acb_sub(log_factor.value, log_factor.value, gamma.value, bits);
    }
    Ball size;
    acb_abs(size.get(), log_factor.value, bits);
    return size;
}

} // namespace

TEST_CASE(
    "the logarithm of a factor of K is below 1.44 on |x| = 1, so by Schwarz's lemma below 1.44 |x| inside: what the interpolation's error rests on")
{
    const WorkingPrecision precision(80);
    constexpr long arcs = 256;
    Ball largest(0);
    for (long arc = 0; arc < arcs; ++arc) {
        CAPTURE(arc);
        const Ball size = size_of_log_factor(Rational(arc, arcs), arcs);
        CHECK(certainly(less(size, Ball(Rational(36, 25)))));
        largest = at_least(largest, size);
    }
    CHECK(largest.overlaps(log(Ball(3)))); // F(-1) = 3
    const WorkingPrecision more(200);
    CHECK(certainly(less(archard::K_gamma_product(archard::infinity) * exp(Ball(Rational(72, 25))), Ball(7))));
}

TEST_CASE("the interpolation's error is what Cauchy's integral on |w| = 4 leaves of 7, and less than 4 times that")
{
    const WorkingPrecision precision(200);
    for (const long M : {1L, 2L, 3L, 10L, 50L, 300L}) {
        CAPTURE(M);
        Ball cauchy = Ball(7) * 4 / 3; // 4/|w - u|
        for (long i = 0; i <= M; ++i) cauchy *= power_of_two<Ball>(-i) / (4 - power_of_two<Ball>(-i));
        const Ball bound = power_of_two<Ball>(archard::interpolation_error(M));
        CHECK(certainly(less(cauchy, bound)));
        CHECK(certainly(less(bound, 4 * cauchy)));
    }
}

TEST_CASE(
    "a polynomial through the first K_n is off by no more than its bound at all later ones, and as near to it as a circle of half the radius of analyticity allows")
{
    const WorkingPrecision precision(2000);
    for (const long M : {1L, 2L, 3L, 7L, 20L, 40L})
        for (const long after : {1L, 2L, 5L, 60L, 0L}) {
            const long n = after == 0 ? archard::infinity : M + after;
            CAPTURE(M);
            CAPTURE(n);
            const Ball off = abs(archard::K_polynomial(M, n) - archard::K_gamma_product(n)),
                       bound = power_of_two<Ball>(archard::interpolation_error(M));
            CHECK(certainly(less(off, bound)));
            CHECK(certainly(less(bound * power_of_two<Ball>(-(M + 11)), off))); // |u| = 4 was taken, kappa is analytic for |u| < 8
        }
}

TEST_CASE("K by interpolation encloses the plain recursion (7.13), tightly, before, at and after the last node")
{
    for (const slong bits : {2L, 53L, 200L, 1000L}) {
        const WorkingPrecision precision(bits);
        for (const long n :
             {0L, 1L, 2L, 3L, 7L, 12L, 13L, 14L, 15L, 16L, 17L, 18L, 19L, 20L, 21L, 22L, 23L, 24L, 40L, 43L, 44L, 45L, 46L, 64L, 200L}) {
            CAPTURE(bits);
            CAPTURE(n);
            Ball plain;
            {
                const WorkingPrecision more(bits + 256);
                plain = archard::K_by_recursion<Ball>(n);
            }
            const Ball K = archard::K_interpolated(n);
            CHECK(arb_contains(K.get(), plain.get()));
            CHECK(K.relative_bits() > bits + 16);
        }
    }
}
