// SPDX-License-Identifier: MIT
#include "touchstone/transfer/fixed.hpp"

#include <doctest/doctest.h>

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
