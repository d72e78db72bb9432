// SPDX-License-Identifier: MIT
// What each operation on fractions counts, against the same operation on numbers that are off by as much as is said.
#include "touchstone/quadrature/fractions.hpp"

#include <doctest/doctest.h>

#include <random>

using namespace touchstone;
using namespace touchstone::quadrature;

namespace {

constexpr slong precise = 2000;

/// A fraction of random limbs, its first ones 0, and a number that it is off by as much as it says, or by less.
struct Known {
    Fraction x;
    Ball number;
};

class Numbers {
public:
    explicit Numbers(Fractions& fractions) : on_(fractions) {}

    /// In [2^-zeros/2, 2^-zeros), above or below its number.
    Known next(int zeros)
    {
        Known k{on_.zero(), {}};
        for (mp_limb_t& limb : k.x.n) limb = random_();
        k.x.n.back() = (k.x.n.back() | (mp_limb_t{1} << 63)) >> zeros;
        const std::uint64_t off = random_() >> (33 + random_() % 31);
        k.x.off = Units(off);
        const std::uint64_t by = random_() % 2 == 0 ? off : off / 3;
        const Ball unit = ScalarTraits<Ball>::power_of_two(-on_.bits());
        k.number = exact(k.x) + (random_() % 2 == 0 ? Ball(static_cast<slong>(by)) : -Ball(static_cast<slong>(by))) * unit;
        return k;
    }
    Ball exact(Fraction x) const
    {
        x.off = Units();
        return on_.ball(x);
    }

private:
    Fractions& on_;
    std::mt19937_64 random_{20261130};
};

/// |found - truth| over what it says, at least that somewhere: no other constant would be much smaller.
struct Tightness {
    double largest = 0;
    void add(const Fractions& on, const Fraction& found, const Ball& truth)
    {
        CHECK(arb_contains(on.ball(found).get(), truth.get()) != 0);
        if (!found.off.is_known()) return;
        Ball middle;
        arb_set_arf(middle.get(), arb_midref(on.ball(found).get()));
        const Ball share = touchstone::abs(truth - middle) / (ScalarTraits<Ball>::power_of_two(-on.bits()) * Ball(found.off.count()));
        largest = std::max(largest, arf_get_d(arb_midref(share.get()), ARF_RND_NEAR));
    }
};

} // namespace

TEST_CASE("fractions: what an operation counts holds what it is off by, and is not much more")
{
    const WorkingPrecision precision(precise);
    for (const std::size_t limbs : {2U, 3U, 9U}) {
        Fractions on(limbs);
        Numbers numbers(on);
        Fraction r = on.zero();
        Tightness sum, difference, product, root, quotient, half;
        for (int k = 0; k < 4000; ++k) {
            const Known a = numbers.next(1 + k % 7), b = numbers.next(1 + k % 11);
            on.add(r, a.x, b.x);
            sum.add(on, r, a.number + b.number);
            const bool is_less = arb_lt(b.number.get(), a.number.get()) != 0;
            const Known &large = is_less ? a : b, &small = is_less ? b : a;
            on.subtract(r, large.x, small.x);
            difference.add(on, r, large.number - small.number);
            on.multiply(r, a.x, b.x);
            product.add(on, r, a.number * b.number);
            // in place, as a sum by Horner's rule is
            Known left = a, right = b;
            on.multiply(left.x, left.x, b.x);
            product.add(on, left.x, a.number * b.number);
            on.multiply(right.x, a.x, right.x);
            product.add(on, right.x, a.number * b.number);
            on.root(r, a.x);
            root.add(on, r, sqrt(a.number));
            Known in_place = a;
            on.root(in_place.x, in_place.x);
            root.add(on, in_place.x, sqrt(a.number));
            if (mpn_cmp(small.x.n.data(), large.x.n.data(), static_cast<mp_size_t>(limbs)) < 0) {
                on.divide(r, small.x, large.x);
                quotient.add(on, r, small.number / large.number);
                Known d = small;
                on.divide(d.x, d.x, large.x);
                quotient.add(on, d.x, small.number / large.number);
            }
            Known h = a;
            on.halve(h.x);
            half.add(on, h.x, a.number / Ball(2));
        }
        CAPTURE(limbs);
        CHECK(sum.largest > 0.99);
        CHECK(difference.largest > 0.99);
        CHECK(product.largest > 0.9);
        CHECK(root.largest > 0.9);
        CHECK(quotient.largest > 0.9);
        CHECK(half.largest > 0.9);
    }
}

TEST_CASE("fractions: of exact arguments the one rounding is counted; zeros are those of all that it may be; what is lost stays so")
{
    const WorkingPrecision precision(precise);
    Fractions on(3);
    Fraction third = on.of(Ball(1) / Ball(3));
    CHECK(third.off.count() == 1);
    CHECK(arb_contains(on.ball(third).get(), (Ball(1) / Ball(3)).get()) != 0);
    third.off = Units();
    Fraction r = on.zero();
    on.multiply(r, third, third);
    CHECK(on.ball(r).contains(Rational(0)) == false);
    const auto exact = [&](const Fraction& x) {
        Fraction y = x;
        y.off = Units();
        return on.ball(y);
    };
    CHECK(arb_contains(on.ball(r).get(), (exact(third) * exact(third)).get()) != 0);
    on.root(r, third);
    CHECK(arb_contains(on.ball(r).get(), sqrt(exact(third)).get()) != 0);
    on.divide(r, third, on.half());
    CHECK(arb_contains(on.ball(r).get(), (exact(third) / exact(on.half())).get()) != 0);

    Fraction tiny = on.zero();
    CHECK(on.ball(tiny).contains(Rational(0)));
    CHECK(on.ball(tiny).is_exact());
    CHECK(on.zeros(tiny) == 192);
    tiny.off = Units(1);
    CHECK(on.zeros(tiny) == 191);
    tiny.n[0] = 7;
    CHECK(on.zeros(tiny) == 188);
    CHECK(on.zeros(on.half()) == 0);
    on.add_integer(tiny, 3, 70);
    const auto two_to = [](slong e) { return ScalarTraits<Ball>::power_of_two(e); };
    CHECK(arb_contains(on.ball(tiny).get(), (Ball(3) * two_to(-70) + Ball(7) * two_to(-192)).get()) != 0);
    Fraction high = on.zero();
    on.add_integer(high, 0xFFFFFFFFFFFFFFFF, 70); // across two limbs
    CHECK(arb_contains(on.ball(high).get(), ((two_to(64) - Ball(1)) * two_to(-70)).get()) != 0);

    // below in all that they may be
    Fraction half = on.half(), below = on.half();
    below.n.back() -= 2ULL << 32;
    CHECK_FALSE(Fractions::is_clearly_below(below, half));
    CHECK_FALSE(Fractions::is_clearly_below(half, below));
    below.n.back() -= 1ULL << 32;
    CHECK(Fractions::is_clearly_below(below, half));

    CHECK_FALSE(Units(1ULL << 31).is_known());
    CHECK_FALSE((Units((1ULL << 31) - 1) + Units(1)).is_known());
    CHECK_FALSE(Units(1ULL << 31).times(1).is_known());
    CHECK_FALSE(Units(1ULL << 31).over(1ULL << 32).is_known());
    CHECK_FALSE(Units(1).over(0).is_known());
    third.off = Units(1ULL << 31);
    on.halve(third);
    CHECK_FALSE(on.ball(third).is_finite());
}
