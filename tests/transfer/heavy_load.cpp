// SPDX-License-Identifier: MIT
/// The area for load > 1, against integrals nested by hand, the partial-contact routes, and what is exact.
#include "touchstone/transfer/heavy_load.hpp"

#include "touchstone/catalogue/evaluate.hpp"

#include <doctest/doctest.h>

#include <tuple>

using namespace touchstone;
using namespace touchstone::transfer;

namespace {

/// What the precision of these balls is meant for.
Accuracy wanted() { return {accuracy_of(WorkingPrecision::bits()).digits + 1}; }

using Traits = ScalarTraits<Ball>;
constexpr slong bits = 56 + 64; // about 19 digits

Rational exactly(const char* text) { return *parse_rational(text); }

Arguments at(const char* load, const char* G)
{
    return {[load] { return Ball(exactly(load)); }, [G] { return Ball(exactly(G)); }};
}

Ball first_area(const Ball& x) { return certainly(less(x, Ball(1))) ? 2 / Traits::pi() * asin(sqrt(x)) : Ball(1); }

/// n = 1, 2 as midpoint sums over the angles (periodic and analytic while no ratio reaches 1 on its way), (F1) twice.
Ball nested(long n, const Ball& x, const Ball& G, long points)
{
    if (n == 0) return first_area(x);
    Ball sum(0);
    for (long i = 0; i < points; ++i) sum += nested(n - 1, (x + Traits::cos_pi(Ball(2 * i + 1) / Ball(2 * points))) / G, G, points);
    return sum / Ball(points);
}

bool near(const Ball& a, const Ball& b, const char* within) { return certainly(less(abs(a - b), Ball(exactly(within)))); }

} // namespace

TEST_CASE("two grids, two schemes, one area, and tight balls")
{
    const WorkingPrecision precision(bits);
    for (const auto& [load, G, n] : {std::tuple{"10", "4", 20L}, {"1.5", "16", 3L}, {"100", "12", 1L}}) {
        CAPTURE(load);
        CAPTURE(G);
        CAPTURE(n);
        const Ball a = area_at_heavy_load(Scheme::force_weighted, n, at(load, G), wanted()),
                   b = area_at_heavy_load(Scheme::area, n, at(load, G), wanted());
        CHECK(a.overlaps(b));
        CHECK(a.relative_bits() > 62);
        CHECK(b.relative_bits() > 62);
    }
}

TEST_CASE("nested by hand, n = 1 and 2")
{
    const WorkingPrecision precision(bits);
    // x_1 in (0.31, 0.94) of 16: load 10, all of scale 1 below 1, nothing singular on the way
    const Ball one = area_at_heavy_load(Scheme::force_weighted, 1, at("10", "16"), wanted());
    CHECK(near(one, nested(1, Ball(10), Ball(16), 80), "1e-19"));
    const Ball two = area_at_heavy_load(Scheme::force_weighted, 2, at("10", "4"), wanted());
    CHECK(near(two, nested(2, Ball(10), Ball(4), 80), "1e-17"));
    // ratio 1, a point of S, is crossed: mpmath's quad over the last angle, split where the ratio is 1, midpoint sum over the first
    CHECK(near(area_at_heavy_load(Scheme::area, 1, at("1.5", "2.2"), wanted()), Ball(exactly("0.65525095502097439462")), "2e-19"));
}

TEST_CASE("slow: nested, n = 2, where a ratio of 1 is crossed" * doctest::skip())
{
    const WorkingPrecision precision(bits);
    CHECK(near(area_at_heavy_load(Scheme::force_weighted, 2, at("10", "3.2"), wanted()), Ball(exactly("0.8447896421110701457823348")), "2e-19"));
}

TEST_CASE("load -> 1 from above meets the partial-contact route, no faster than Lemma 4 allows")
{
    const WorkingPrecision precision(bits);
    for (const long n : {1L, 5L}) {
        const Ball below = area(Scheme::force_weighted, n, at("1", "4"), wanted());
        for (const char* beyond : {"1.0000000001", "1.0001"}) {
            CAPTURE(n); CAPTURE(beyond);
            const Ball rise = area_at_heavy_load(Scheme::force_weighted, n, at(beyond, "4"), wanted()) - below;
            CHECK_FALSE(certainly(less(rise, Ball(0))));
            CHECK(certainly(less(rise, sqrt((Ball(exactly(beyond)) - 1) / pow(Ball(4), Ball(n))))));
        }
    }
}

TEST_CASE("areas increase with the load")
{
    const WorkingPrecision precision(bits);
    for (const long n : {2L, 10L}) {
        Ball last = area(Scheme::force_weighted, n, at("1", "16"), wanted());
        for (const char* load : {"1.5", "5", "10"}) {
            const Ball a = area_at_heavy_load(Scheme::force_weighted, n, at(load, "16"), wanted());
            CHECK(certainly(less(last, a)));
            last = a;
        }
    }
}

TEST_CASE("full contact everywhere is exact, to the last load that keeps it; then it is certified")
{
    const auto eval = [](const char* name, std::map<std::string, Rational> in) { return evaluate(*find_quantity(name), Inputs(std::move(in)), {.digits = 17}); };
    for (const char* G : {"4", "1.5"}) { // 1 + G + G^2
        const Rational g = exactly(G), load = 1 + g + g * g;
        CHECK(eval("contact.area", {{"n", 2}, {"load", load}, {"G", g}}).status == Status::exact);
        CHECK(eval("contact.area", {{"n", 2}, {"load", load}, {"G", g}}).value == "1");
        CHECK(eval("contact.area", {{"n", 0}, {"load", 1}, {"G", g}}).status == Status::exact);
    }
    CHECK(eval("segments.count", {{"n", 2}, {"load", 5}, {"D", exactly("1.5")}, {"gamma", 16}}).value == "256");
    const auto e = eval("contact.area", {{"n", 1}, {"load", exactly("16.9")}, {"G", 16}});
    CHECK(e.status == Status::certified);
    CHECK(e.value < "1");
}

TEST_CASE("(1.5, 16) and (1.25, 256) give the same area, digit for digit")
{
    const auto eval = [](const char* D, long gamma) {
        return evaluate(*find_quantity("contact.area"), Inputs({{"n", 3}, {"load", 10}, {"D", exactly(D)}, {"gamma", gamma}}), {.digits = 17});
    };
    const auto a = eval("1.5", 16), b = eval("1.25", 256);
    CHECK(a.status == Status::certified);
    CHECK(a.value == b.value);
}

TEST_CASE("out of reach is said")
{
    CHECK_THROWS_AS(area_at_heavy_load(Scheme::area, 1, at("10", "2"), wanted()), std::runtime_error);
    CHECK_THROWS_AS(area_at_heavy_load(Scheme::area, 1, at("1", "4"), wanted()), std::runtime_error);
    CHECK_THROWS_AS(area_at_heavy_load(Scheme::area, 1, at("1e6", "4"), wanted()), std::runtime_error);
}
