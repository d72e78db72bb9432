// SPDX-License-Identifier: MIT
#include "touchstone/paper/archard_constants.hpp"
#include "touchstone/paper/archard_interpolation.hpp"

#include "touchstone/paper/archard.hpp"
#include "touchstone/paper/gamma_product.hpp"

#include <doctest/doctest.h>

using namespace touchstone;

TEST_CASE("both routes of K_n enclose the plain recursion (7.13), tightly")
{
    for (const slong bits : {64L, 200L, 1000L, 3400L}) {
        const WorkingPrecision precision(bits);
        for (const long n : {0L, 1L, 2L, 3L, 7L, 19L, 64L, 200L}) {
            CAPTURE(bits);
            CAPTURE(n);
            if (n > 20 && bits > 1000) continue;
            Ball plain;
            {
                const WorkingPrecision more(bits + 256);
                plain = archard::K_by_recursion<Ball>(n);
            }
            const Ball a = archard::K_gamma_product(n), b = archard::K_interpolated(n);
            CHECK(arb_contains(a.get(), plain.get()));
            CHECK(arb_contains(b.get(), plain.get()));
            CHECK(a.relative_bits() > bits);
            CHECK(b.relative_bits() > bits);
        }
    }
}

TEST_CASE("the values of zeta that one route sums hold Arb's, and are as sharp as is said of them")
{
    for (const slong bits : {100L, 400L, 1500L})
        for (const slong step : {1L, 5L, 12L})
            for (const long last : {2L, 3L, 12L, 31L, 60L}) {
                if (last * step > bits) continue;
                const WorkingPrecision precision(bits + 64);
                const auto zeta = archard::zeta_values(last, bits, step);
                for (long k = 2; k <= last; ++k) {
                    Ball known;
                    arb_zeta_ui(known.get(), static_cast<ulong>(k), bits + 64);
                    CAPTURE(bits);
                    CAPTURE(step);
                    CAPTURE(last);
                    CAPTURE(k);
                    CHECK(arb_contains(zeta[static_cast<std::size_t>(k)].get(), known.get()));
                    CHECK(zeta[static_cast<std::size_t>(k)].relative_bits() >= bits - k * step - 3);
                }
            }
}

TEST_CASE("K_n descends to K_inf at the rate the recursion gives")
{
    const WorkingPrecision precision(400);
    const Ball limit = archard::K_gamma_product(archard::infinity);
    CHECK(limit.overlaps(archard::K_interpolated(archard::infinity)));
    Ball before = archard::K_gamma_product(0);
    for (long n = 1; n <= 100; ++n) {
        const Ball K = archard::K_gamma_product(n);
        CHECK(certainly(less(K, before)));
        CHECK(certainly(less(limit, K)));
        before = K;
    }
    // log step(delta_i) = -2^-(i+2) + ..., so log K_n - log K_inf ~ 2^-(n+1)
    const Ball rate = log(archard::K_gamma_product(100) / limit) * power_of_two<Ball>(101);
    CHECK(abs(rate - 1).relative_bits() > 0);
    CHECK(certainly(less(abs(rate - 1), power_of_two<Ball>(-90))));
}

TEST_CASE("a product of Gamma functions is that of Arb's, tightly")
{
    const auto by_arb = [](long halves, long first, const std::vector<unsigned long>& weights) {
        Ball product(1), power;
        for (std::size_t i = 0; i < weights.size(); ++i) {
            const Ball one = gamma_function(Ball(Rational(halves, 2)) - power_of_two<Ball>(-(first + static_cast<long>(i))));
            arb_pow_ui(power.get(), one.get(), weights[i], WorkingPrecision::bits());
            product *= power;
        }
        return product;
    };
    const std::vector<std::vector<unsigned long>> all{{1}, {0, 3}, {2, 1, 1}, {7, 6, 5, 4, 3, 2, 1}, std::vector<unsigned long>(70, 1)};
    for (const slong bits : {2L, 53L, 300L, 1500L, 3500L})
        for (const long halves : {2L, 3L, 4L, 11L})
            for (const long first : {1L, 2L, 60L}) // from 1/2 on; to where a numerator is longer than a word
                for (const auto& weights : all) {
                    CAPTURE(bits);
                    CAPTURE(halves);
                    CAPTURE(first);
                    CAPTURE(weights.size());
                    const WorkingPrecision precision(bits);
                    const Ball ours = archard::gamma_product(halves, first, weights);
                    const WorkingPrecision more(bits + 256);
                    CHECK(arb_contains(ours.get(), by_arb(halves, first, weights).get()));
                    CHECK(ours.relative_bits() >= bits - 12);
                }
    CHECK(archard::gamma_product(3, 2, {}).overlaps(Ball(1)));
}

TEST_CASE("what Stirling's series lacks is below its bound, and half of it where the series converges fast")
{
    const WorkingPrecision precision(300);
    for (const long y : {2L, 9L, 40L, 300L})
        for (const long L : {1L, 2L, 5L, 11L}) {
            CAPTURE(y);
            CAPTURE(L);
            Ball lacks, power = Ball(1) / y;
            arb_lgamma(lacks.get(), Ball(y).get(), 300);
            lacks -= (Ball(y) - Ball(1) / 2) * log(Ball(y)) - y + log(2 * pi<Ball>()) / 2;
            for (long l = 1; l <= L; ++l) {
                Ball bernoulli;
                arb_bernoulli_ui(bernoulli.get(), static_cast<ulong>(2 * l), 300);
                lacks -= bernoulli / (2 * l * (2 * l - 1)) * power;
                power = power / (y * y);
            }
            const Ball bound = archard::stirling_remainder(L, 2 * y + 1);
            CHECK(certainly(less(abs(lacks), bound)));
            if (y > 4 * L) CHECK(certainly(less(bound, Ball(Rational(9, 4)) * abs(lacks))));
        }
}

TEST_CASE("both routes agree, tightly, where fixed-point units grow by whole words")
{
    for (const slong bits : {4000L, 12000L}) {
        const WorkingPrecision precision(bits);
        const Ball a = archard::K_gamma_product(archard::infinity), b = archard::K_interpolated(archard::infinity);
        CHECK(a.overlaps(b));
        CHECK(a.relative_bits() > bits);
        CHECK(b.relative_bits() > bits);
    }
}

TEST_CASE("huge n costs no more and is told from the limit")
{
    const WorkingPrecision precision(128);
    CHECK(archard::K_gamma_product(1'000'000).overlaps(archard::K_interpolated(1'000'000)));
    const WorkingPrecision more(400);
    CHECK_FALSE(archard::K_gamma_product(300).overlaps(archard::K_gamma_product(archard::infinity)));
}

TEST_CASE("eta: the accelerated sum keeps its proven error bound")
{
    const WorkingPrecision precision(300);
    for (const long k : {1L, 2L, 3L, 10L})
        for (const long N : {5L, 10L, 40L, 80L}) {
            // (1 - 2^{1-k}) zeta(k) from Arb; log 2 for k = 1
            Ball eta = log(Ball(2));
            if (k > 1) {
                arb_zeta_ui(eta.get(), static_cast<ulong>(k), 300);
                eta *= 1 - power_of_two<Ball>(1 - k);
            }
            const Ball error = abs(archard::eta<Ball>(k, N) - eta);
            const Ball bound = 2 / pow(3 + sqrt(Ball(8)), Ball(N));
            CHECK(certainly(less(error, bound)));
            CHECK(possibly(less(bound / 1000000, error))); // and the bound is not empty talk
        }
}
