// SPDX-License-Identifier: MIT
/// Correctly rounded values in numbers of 106 bits, against the catalogue's (two proofs in balls) and operation by operation against balls.
/// TOUCHSTONE_SEED and TOUCHSTONE_COUNT choose the points (ctest -R westergaard_nearest_campaign -V).
#include "touchstone/catalogue/evaluate.hpp"
#include "touchstone/scalar/pair_ball.hpp"

#include <doctest/doctest.h>

#include <cfenv>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <random>

using namespace touchstone;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity(), not_a_number = std::numeric_limits<double>::quiet_NaN();

unsigned long setting(const char* name, unsigned long otherwise)
{
    const char* text = std::getenv(name);
    return text == nullptr ? otherwise : std::strtoul(text, nullptr, 10);
}

Ball ball(const PairBall& x)
{
    Ball b = Ball::exactly(x.middle().high) + Ball::exactly(x.middle().low);
    arb_add_error(b.get(), Ball::exactly(x.radius()).get());
    return b;
}

/// What the catalogue says of a row: nothing if it refuses it.
std::optional<Evaluation> by_catalogue(const Quantity& q, const std::vector<double>& row)
{
    std::map<std::string, Rational> values;
    for (std::size_t k = 0; k < row.size(); ++k) {
        if (!std::isfinite(row[k])) return std::nullopt;
        values[q.inputs[k]] = exact_rational(row[k]);
    }
    try {
        return evaluate(q, Inputs(values), {.digits = 20});
    }
    catch (const DomainError&) {
        return std::nullopt;
    }
}

/// Held against the catalogue wherever it answers. \returns whether it does.
bool answers_rightly(const Quantity& q, const std::vector<double>& row)
{
    const auto quick = q.nearest(row.data());
    if (!quick) return false;
    CAPTURE(q.name);
    CAPTURE(row);
    const auto truth = by_catalogue(q, row);
    REQUIRE(truth.has_value());
    CHECK(*quick == truth->binary64);
    CHECK(truth->status == (*quick == 0 ? Status::exact : Status::certified));
    return true;
}

struct Points {
    std::mt19937_64 random;
    std::uniform_real_distribution<double> unit{0, 1};
    /// Half of the loads in (0, 1), some next to 1, some above, some tiny.
    double load(int i)
    {
        switch (i % 10) {
        case 0: return 1 - std::ldexp(unit(random), -20 - i / 10 % 34);
        case 1: return 1 + std::ldexp(unit(random), -i / 10 % 53);
        case 2: return std::ldexp(unit(random), 5);
        case 3: return std::ldexp(unit(random), -i / 10 % 60);
        default: return unit(random);
        }
    }
    /// Pressures of the range, many next to its ends, some beyond.
    double pressure(int i, double load)
    {
        const double lowest = load < 1 ? 0 : load - 1, highest = load < 1 ? 2 * std::sqrt(load) : load + 1, length = highest - lowest;
        switch (i % 7) {
        case 0: return highest - length * std::ldexp(unit(random), -i / 7 % 53);
        case 1: return lowest + length * std::ldexp(unit(random), -i / 7 % 60);
        case 2: return std::nextafter(highest, i % 2 == 0 ? 0 : infinity);
        default: return lowest + length * 1.02 * unit(random);
        }
    }
};

} // namespace

TEST_CASE("every operation on balls of pairs encloses what it does to each number of its operands")
{
    const WorkingPrecision precision(600);
    std::mt19937_64 random(20261123);
    std::uniform_real_distribution<double> mantissa(1, 2), signed_unit(-1, 1);
    std::uniform_int_distribution<int> exponent(-30, 30), accuracy(-110, -40), sign(0, 1);
    const auto number = [&](int i) {
        const Ball x = Ball::exactly((sign(random) != 0 ? 1 : -1) * std::ldexp(mantissa(random), exponent(random)));
        if (i % 5 == 0) return PairBall::around(x);
        Ball wide = x + Ball::exactly(std::ldexp(signed_unit(random), -25)) * x / 3;
        if (i % 3 != 0) arb_add_error(wide.get(), (abs(wide) * Ball::exactly(std::ldexp(1.0, accuracy(random)))).get());
        return PairBall::around(wide);
    };
    int tight = 0, cancelled = 0;
    const int count = 20'000;
    for (int i = 0; i < count; ++i) {
        const PairBall x = number(i), y = i % 11 == 0 ? -x : number(i / 2);
        const Ball X = ball(x), Y = ball(y);
        // the least and the largest number and the middle of each operand
        for (const int a : {-1, 0, 1})
            for (const int b : {-1, 0, 1}) {
                const Ball u = Ball::exactly(x.middle().high) + Ball::exactly(x.middle().low) + Ball(a) * Ball::exactly(x.radius());
                const Ball v = Ball::exactly(y.middle().high) + Ball::exactly(y.middle().low) + Ball(b) * Ball::exactly(y.radius());
                CHECK(ball(x + y).contains(u + v));
                CHECK(ball(x * y).contains(u * v));
                CHECK(ball(x / y).overlaps(u / v));
                CHECK(ball(PairBall::root(x)).overlaps(ScalarTraits<Ball>::sqrt_positive_part(u)));
                if (certainly(less(Ball(0), X)) && certainly(less(Ball(0), Y)))
                    CHECK(ball(angle_over_pi(x, y)).overlaps(atan2(u, v) / pi<Ball>()));
                if (less(x, y) != Truth::unknown) CHECK(less(x, y) == less(u, v));
            }
        tight += ball(x * y).relative_bits() > std::min({X.relative_bits(), Y.relative_bits(), slong(102)}) - 4;
        cancelled += ball(x + y).contains_zero() ? 1 : 0;
    }
    CHECK(tight > count * 9 / 10); // a ball that holds every number would pass the rest
    CHECK(cancelled > count / 20);
    CHECK(ball(ScalarTraits<PairBall>::pi()).contains(pi<Ball>()));
    // roots of what may be negative, and an order that is not decided
    const auto about_minus_one = [](double radius) {
        Ball b(-1);
        arb_add_error(b.get(), Ball::exactly(radius).get());
        return PairBall::around(b);
    };
    CHECK(PairBall::root(PairBall(0)).radius() == 0);
    CHECK(PairBall::root(about_minus_one(0.4)).radius() == 0);
    CHECK(PairBall::root(about_minus_one(0.4)).middle().high == 0);
    CHECK(std::isinf(PairBall::root(about_minus_one(1.5)).radius()));
    CHECK(less(PairBall(1), PairBall(1)) == Truth::no);
    CHECK(less(PairBall(2), PairBall(1)) == Truth::no);
    CHECK(less(about_minus_one(0.4), PairBall(0)) == Truth::yes);
    CHECK(less(about_minus_one(1.5), PairBall(0)) == Truth::unknown);
    // what would lose bits to underflow knows nothing
    const PairBall least = PairBall::exactly(0x1p-430);
    CHECK(least.radius() == 0);
    CHECK_FALSE(nearest_double(least * least).has_value());
    CHECK_FALSE(nearest_double(PairBall::exactly(0x1p-431) + PairBall(0)).has_value());
    CHECK(less(PairBall::exactly(not_a_number), PairBall(0)) == Truth::unknown);
    CHECK(less(PairBall::exactly(infinity), PairBall(0)) == Truth::unknown);
}

TEST_CASE("a ball of pairs rounds to a binary64 number only where all of it does")
{
    const WorkingPrecision precision(300);
    const Ball third = Ball(1) / Ball(3);
    CHECK(nearest_double(PairBall::around(third)) == 1.0 / 3);
    for (const double x : {1.0, 1.5, 1 + 0x1p-52, 2.0, 0x1p-300})
        for (const double other : {std::nextafter(x, 0), std::nextafter(x, infinity)}) {
            const Ball middle = (Ball::exactly(x) + Ball::exactly(other)) / 2, tiny = Ball::exactly(std::ldexp(x, -104));
            CHECK_FALSE(nearest_double(PairBall::around(middle)).has_value()); // a tie
            for (const Ball& from : {middle + tiny, middle - tiny}) {
                CHECK(nearest_double(PairBall::around(from)) == nearest_double(from)); // exact pairs, on one side of the tie
                Ball wide = from;
                arb_add_error(wide.get(), (tiny * 2).get());
                CHECK_FALSE(nearest_double(PairBall::around(wide)).has_value());
            }
            CHECK_FALSE(nearest_double(PairBall::exactly(x)).has_value()); // exact: the catalogue says so
        }
    CHECK(nearest_double(PairBall(0)) == 0.0);
    CHECK_FALSE(nearest_double(PairBall::indeterminate()).has_value());
    // it reaches 2^-109 beyond the tie at 1 - 2^-54, but the sum of its low part and its radius is rounded to the tie
    Ball just_beyond = Ball::exactly(1) - Ball::exactly(0x1p-54) + Ball::exactly(0x1p-107);
    arb_add_error(just_beyond.get(), Ball::exactly(0x1p-107 + 0x1p-109).get());
    CHECK_FALSE(nearest_double(PairBall::around(just_beyond)).has_value());
}

TEST_CASE("balls of pairs with one midpoint are in no order, and the diagonal is an eighth of a turn")
{
    CHECK(less(PairBall::pi(), PairBall::pi()) == Truth::unknown);
    CHECK(less(PairBall(3), PairBall(3)) == Truth::no);
    CHECK(sqrt(PairBall(0)).radius() == 0);
    const PairBall eighth = angle_over_pi(PairBall(3), PairBall(3));
    CHECK(ball(eighth).contains(Rational(1, 4)));
    CHECK(eighth.radius() < 0x1p-90);
}

TEST_CASE("wide balls of pairs: products hold their corners, overlapping ones have no order, and a wide divisor says nothing")
{
    const auto wide = [](double middle, double radius) {
        Ball b = Ball::exactly(middle);
        arb_add_error(b.get(), Ball::exactly(radius).get());
        return PairBall::around(b);
    };
    CHECK(ball(wide(3, 1) * wide(2, 1)).contains(Rational(12)));
    CHECK(less(wide(3, 0.625), wide(2, 0.625)) == Truth::unknown);
    CHECK(less(wide(2, 0.625), wide(3, 0.625)) == Truth::unknown);
    CHECK(less(wide(3, 0.125), wide(2, 0.125)) == Truth::no);
    CHECK_FALSE(std::isfinite((PairBall(1) / wide(0x1p-20, 0x1p-40)).radius()));
}

TEST_CASE("many points: the nearest binary64 number is the catalogue's")
{
    const unsigned long seed = setting("TOUCHSTONE_SEED", 20261123), count = setting("TOUCHSTONE_COUNT", 5000);
    Points points{std::mt19937_64(seed)};
    for (const char* name : {"westergaard.half_width", "westergaard.exceedance", "westergaard.density"}) {
        const Quantity& q = *find_quantity(name);
        unsigned long evaluated = 0;
        for (unsigned long n = 0; n < count; ++n) {
            const int i = static_cast<int>(n);
            const double load = points.load(i);
            evaluated += !answers_rightly(q, q.inputs.size() == 1 ? std::vector{load > 1 ? 1 / load : load}
                                                                  : std::vector{points.pressure(i, load), load});
        }
        std::cout << name << ", seed " << seed << ": " << evaluated << " of " << count << " points took an evaluation in balls\n";
        CHECK(evaluated < count / 50);
    }
}

TEST_CASE("edges of the domain: the catalogue's answer, or none")
{
    std::vector<double> numbers{0,         -0.0,      -1,     1,      2,      4,     0.25, 0.5,   0.75,  1.5,  3, infinity, not_a_number,
                                0x1p-1074, 0x1p-1022, 1e-300, 1e-160, 1e-100, 1e-30, 1e30, 1e100, 1e200, 1e308};
    for (const double x : {1.0, 0.25, 0.5, 2.0})
        for (const double off : {0x1p-53, 0x1p-52, 1e-15, 0x1p-40}) numbers.insert(numbers.end(), {x * (1 - off), x * (1 + off)});
    int answered = 0;
    for (const char* name : {"westergaard.exceedance", "westergaard.density"})
        for (const double load : numbers)
            for (const double p : numbers) answered += answers_rightly(*find_quantity(name), {p, load});
    for (const double load : numbers) answered += answers_rightly(*find_quantity("westergaard.half_width"), {load});
    CHECK(answered > 500);
    const Quantity& density = *find_quantity("westergaard.density");
    for (const auto& [p, load] : std::vector<std::pair<double, double>>{{1, 0.25}, {0, 1}, {2, 1}, {1, 2}, {3, 2}}) {
        const std::vector<double> at_edge{p, load};
        CHECK_FALSE(density.nearest(at_edge.data()).has_value()); // unbounded there: for the catalogue to refuse
    }
    CHECK(density.nearest(std::vector{1.5, 0.25}.data()) == 0.0);
}

TEST_CASE("another rounding mode proves nothing")
{
    const std::vector<double> row{0.5, 0.75};
    const Quantity& q = *find_quantity("westergaard.exceedance");
    CHECK(q.nearest(row.data()).has_value());
    std::fesetround(FE_UPWARD);
    const bool answered = q.nearest(row.data()).has_value();
    std::fesetround(FE_TONEAREST);
    CHECK_FALSE(answered);
}
