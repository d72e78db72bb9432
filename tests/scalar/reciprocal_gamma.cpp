// SPDX-License-Identifier: MIT
#include "touchstone/scalar/reciprocal_gamma.hpp"

#include "touchstone/scalar/flint_headers.hpp"
#if __has_include(<flint/arb_poly.h>)
#include <flint/arb_poly.h>
#else
#include <arb_poly.h>
#endif

#include <doctest/doctest.h>

using namespace touchstone;

TEST_CASE("1/Gamma just below 1 encloses Arb's, tightly, where its table serves and where it ends")
{
    for (const slong bits : {2L, 53L, 64L, 200L, 1000L, 3000L, 3400L, 3430L, 3445L, 3460L, 5000L})
        for (const slong e : {2L, 3L, 4L, 5L, 7L, 12L, 30L, 63L, 64L, 65L, 100L, 700L}) {
            CAPTURE(bits);
            CAPTURE(e);
            Ball exact;
            {
                const WorkingPrecision more(bits + 100 + e);
                arb_rgamma(exact.get(), (1 - power_of_two<Ball>(-e)).get(), WorkingPrecision::bits());
            }
            const WorkingPrecision precision(bits);
            const Ball value = reciprocal_gamma_below_one(e);
            CHECK(arb_contains(value.get(), exact.get()));
            CHECK(value.relative_bits() >= bits);
        }
}

TEST_CASE("the bounds of Taylor's coefficients of 1/Gamma(1 + x) are what the estimate on their circles gives, and hold")
{
    constexpr slong count = 600;
    const WorkingPrecision precision(4000);
    arb_poly_t one_plus_x, series;
    arb_poly_init(one_plus_x);
    arb_poly_init(series);
    arb_poly_set_coeff_si(one_plus_x, 0, 1);
    arb_poly_set_coeff_si(one_plus_x, 1, 1);
    arb_poly_rgamma_series(series, one_plus_x, count, WorkingPrecision::bits());
    for (const auto& [log_radius, log_size] : reciprocal_gamma_bounds) {
        CAPTURE(log_radius);
        const long R = 1L << log_radius;
        Ball quotient(1); // (2R)!/R!
        for (long j = R + 1; j <= 2 * R; ++j) quotient *= j;
        const Ball on_circle = Ball(25) / 22 * exp(pi<Ball>() * R / 2) * quotient, size = power_of_two<Ball>(log_size);
        CHECK(certainly(less(on_circle, size)));
        CHECK(certainly(less(size, 2 * on_circle)));
        for (slong k = 0; k < count; ++k) {
            Ball c;
            arb_poly_get_coeff_arb(c.get(), series, k);
            CHECK(certainly(less(abs(c), power_of_two<Ball>(log_size - k * log_radius))));
        }
    }
    arb_poly_clear(series);
    arb_poly_clear(one_plus_x);
}

TEST_CASE("what is left out of the series is below the sum of the least bounds, and told within twice that")
{
    const WorkingPrecision precision(200);
    for (const slong e : {2L, 3L, 10L, 100L})
        for (const slong K : {1L, 2L, 9L, 40L, 200L, 536L}) {
            CAPTURE(e);
            CAPTURE(K);
            Ball least = Ball::indeterminate();
            for (const auto& [log_radius, log_size] : reciprocal_gamma_bounds) {
                const Ball sum = power_of_two<Ball>(log_size - (e + log_radius) * K) / (1 - power_of_two<Ball>(-e - log_radius));
                if (!least.is_finite() || certainly(less(sum, least))) least = sum;
            }
            const Ball rest = power_of_two<Ball>(reciprocal_gamma_rest(e, K));
            CHECK(certainly(less(least, rest)));
            CHECK(certainly(less(rest, 2 * least)));
        }
}
