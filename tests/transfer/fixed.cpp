// SPDX-License-Identifier: MIT
#include "touchstone/transfer/coefficients.hpp"
#include "touchstone/transfer/fixed.hpp"

#include <doctest/doctest.h>
#include <malloc.h>

#include <random>

using namespace touchstone;
using namespace touchstone::transfer;

namespace {

/// Random value in (-2^exponent, 2^exponent) with all the bits the format has.
Ball random_value(std::mt19937_64& engine, const FixedFormat& f, long exponent)
{
    Ball r(0);
    for (int i = 0; i < f.limbs() + 1; ++i) {
        arb_mul_2exp_si(r.get(), r.get(), -32);
        r += Ball(static_cast<long>(engine() >> 32));
    }
    arb_mul_2exp_si(r.get(), r.get(), exponent - 32);
    return engine() & 1 ? r : -r;
}

Ball value(const FixedFormat& f, const mp_limb_t* in)
{
    fmpz_t units;
    fmpz_init(units);
    f.get(units, in);
    Ball r;
    arb_set_fmpz(r.get(), units);
    fmpz_clear(units);
    arb_mul_2exp_si(r.get(), r.get(), -f.fraction());
    return r;
}

} // namespace

TEST_CASE("fixed-point products are rounded down by less than a unit, dot products are exact")
{
    const unsigned long seed = 20241;
    CAPTURE(seed);
    std::mt19937_64 engine(seed);
    const WorkingPrecision precision(2000);
    for (const long fraction : {40L, 48L, 112L, 230L, 500L}) {
        const FixedFormat f(fraction);
        CHECK(f.fraction() >= fraction);
        const auto n = static_cast<std::size_t>(f.limbs());
        std::vector<mp_limb_t> a(n), b(n), c(n), scratch(2 * n);
        for (int trial = 0; trial < 300; ++trial) {
            f.put(a.data(), random_value(engine, f, trial % 7));
            f.put(b.data(), random_value(engine, f, trial % 5));
            const Ball exact = value(f, a.data()) * value(f, b.data());
            for (const unsigned shift : {0U, 1U}) {
                f.multiply(c.data(), a.data(), b.data(), shift, scratch.data());
                const Ball lost = (shift ? 2 * exact : exact) - value(f, c.data());
                CHECK(certainly(less(lost, f.unit())));
                CHECK_FALSE(certainly(less(lost, Ball(0))));
            }
            CHECK((f.dot(a.data(), b.data(), 1) - exact).contains_zero());
            CHECK((f.dot(a.data(), b.data(), 1) - exact).is_exact());
        }
    }
}

TEST_CASE("what does not fit is refused")
{
    const FixedFormat f(100);
    std::vector<mp_limb_t> a(static_cast<std::size_t>(f.limbs()));
    CHECK_THROWS_AS(f.put(a.data(), Ball(1L << 15)), std::logic_error);
    CHECK_THROWS_AS(f.put(a.data(), Ball::indeterminate()), std::logic_error);
    f.put(a.data(), Ball((1L << 15) - 1));
    f.put(a.data(), Ball(-(1L << 15) + 1));
}

TEST_CASE("what is refused is released")
{
    // under AddressSanitizer the counters are 0, and its search for leaks is the judge
    const FixedFormat f(100);
    std::vector<mp_limb_t> a(static_cast<std::size_t>(f.limbs()));
    const auto in_use_after = [&](int refusals) {
        for (int k = 0; k < refusals; ++k) CHECK_THROWS_AS(f.put(a.data(), Ball(1L << 15)), std::logic_error);
        const auto m = mallinfo2();
        return static_cast<double>(m.uordblks + m.hblkhd);
    };
    const double before = in_use_after(2);
    CHECK(in_use_after(10'000) - before < 10'000);
}

TEST_CASE("coefficients of the polynomial through values, and a row of moments by nodal values, are off by what is counted for them")
{
    const unsigned long seed = 20261123;
    CAPTURE(seed);
    std::mt19937_64 engine(seed);
    const auto check = [&](long p, const FixedFormat& f) {
        const WorkingPrecision precision(f.fraction() + 24);
        const Coefficients C(f, p);
        const auto n = static_cast<std::size_t>(f.limbs()), terms = static_cast<std::size_t>(p);
        std::vector<mp_limb_t> values(terms * n), coefficients(values);
        for (std::size_t j = 0; j < terms; ++j) f.put(&values[j * n], random_value(engine, f, 1));
        C.of(values.data(), coefficients.data());
        // any numbers may be moments; those of a light load are small, and are had as well relative to their size
        std::vector<mp_limb_t> small(values);
        for (std::size_t j = 0; j < terms; ++j) f.put(&small[j * n], random_value(engine, f, -140));
        std::vector<double> near(terms), near_small(terms);
        const double off = C.row(values.data(), near.data()), off_small = C.row(small.data(), near_small.data());
        if (f.limbs() > 4) {
            CHECK(off < std::ldexp(1.0, -78));
            CHECK(off_small < std::ldexp(1.0, -218));
        }
        const WorkingPrecision wide(800);
        for (std::size_t k = 0; k < terms; ++k) {
            CAPTURE(p);
            CAPTURE(k);
            Ball coefficient(0), nodal(0), nodal_small(0);
            const auto entry = [&](std::size_t order, std::size_t j) {
                const Ball c = 2 * ScalarTraits<Ball>::cos_pi(Ball(static_cast<long>(order * (2 * j + 1))) / Ball(2 * p)) / Ball(p);
                return order == 0 ? c / 2 : c;
            };
            for (std::size_t j = 0; j < terms; ++j) {
                coefficient += entry(k, j) * value(f, &values[j * n]);
                nodal += entry(j, k) * value(f, &values[j * n]);
                nodal_small += entry(j, k) * value(f, &small[j * n]);
            }
            CHECK(certainly(less(abs(coefficient - value(f, &coefficients[k * n])), (4 * p + 1) * f.unit())));
            const auto within = [](double near_value, const Ball& exact, double beyond) {
                const Ball counted = abs(exact) * ScalarTraits<Ball>::power_of_two(-52) + Ball::exactly(beyond);
                return certainly(less(abs(exact - Ball::exactly(near_value)), counted));
            };
            CHECK(within(near[k], nodal, off));
            CHECK(within(near_small[k], nodal_small, off_small));
        }
    };
    for (const long p : {1L, 5L, 8L, 61L, 214L}) check(p, FixedFormat(290));
    for (const long fraction : {40L, 100L, 160L}) check(8, FixedFormat(fraction)); // words that are there, and no more
}

TEST_CASE("moments beyond what binary64 holds have a bound that does not")
{
    const FixedFormat f(3000);
    const WorkingPrecision precision(f.fraction() + 24);
    const Coefficients C(f, 5);
    std::mt19937_64 engine(1);
    std::vector<mp_limb_t> moments(5 * static_cast<std::size_t>(f.limbs()));
    for (const long exponent : {-700L, -1000L, -1060L, -2000L}) {
        CAPTURE(exponent);
        for (std::size_t j = 0; j < 5; ++j) f.put(&moments[j * static_cast<std::size_t>(f.limbs())], random_value(engine, f, exponent));
        std::vector<double> near(5);
        const double off = C.row(moments.data(), near.data());
        CHECK(off < std::ldexp(1.0, -730));
        for (std::size_t k = 0; k < 5; ++k) {
            Ball nodal(0);
            for (std::size_t j = 0; j < 5; ++j) {
                const Ball c = 2 * ScalarTraits<Ball>::cos_pi(Ball(static_cast<long>(j * (2 * k + 1))) / Ball(10)) / Ball(5);
                nodal += (j == 0 ? c / 2 : c) * value(f, &moments[j * static_cast<std::size_t>(f.limbs())]);
            }
            const Ball allowed = abs(nodal) * ScalarTraits<Ball>::power_of_two(-52) + Ball::exactly(off);
            CHECK(certainly(less(abs(nodal - Ball::exactly(near[k])), allowed)));
        }
    }
}
