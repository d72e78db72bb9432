// SPDX-License-Identifier: MIT
/// What rounded inputs force: against derivatives known by hand, against values at the ends, and as tables carry it.
#include "touchstone/table/forced.hpp"

#include "touchstone/catalogue/evaluate.hpp"
#include "touchstone/rounding/ulp.hpp"
#include "touchstone/table/format.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace touchstone;

namespace {

Rational value_at(const Quantity& q, const std::map<std::string, Rational>& in, long digits = 24)
{
    return *parse_rational(evaluate(q, Inputs(in), {.digits = digits}).value);
}

ForcedUlps forced(const char* name, const std::vector<double>& inputs)
{
    const Quantity& q = *find_quantity(name);
    std::map<std::string, Rational> in;
    for (std::size_t k = 0; k < inputs.size(); ++k) in[q.inputs[k]] = exact_rational(inputs[k]);
    const auto f = forced_ulps(q, inputs, value_at(q, in));
    REQUIRE(f);
    return *f;
}

/// Moves every input by a relative 2^-53 (half an ulp of a number just above a power of two) and adds up the changes.
double by_hand(const char* name, const std::vector<double>& inputs, long digits)
{
    const Quantity& q = *find_quantity(name);
    std::map<std::string, Rational> in;
    for (std::size_t k = 0; k < inputs.size(); ++k) in[q.inputs[k]] = exact_rational(inputs[k]);
    const Rational here = value_at(q, in, digits);
    double sum = 0;
    for (std::size_t k = 0; k < inputs.size(); ++k) {
        if (q.inputs[k] == "n") continue;
        auto moved = in;
        moved[q.inputs[k]] += exact_rational(std::nextafter(inputs[k], INFINITY) - inputs[k]) / 2;
        sum += std::fabs(Rational((value_at(q, moved, digits) - here) / ulp_at(here)).get_d());
    }
    return sum;
}

} // namespace

TEST_CASE("half an ulp times the condition number")
{
    // hertz.half_width goes as sqrt(load): half the relative change
    for (const double load : {0.3, 1.5, 1.999}) {
        const double value = value_at(*find_quantity("hertz.half_width"), {{"load", exact_rational(load)}}).get_d();
        const double half_ulp = (std::nextafter(load, 2) - load) / 2;
        CHECK(forced("hertz.half_width", {load}).ulps ==
              doctest::Approx(value / 2 * half_ulp / load / ulp_at(exact_rational(value)).get_d()).scale(0).epsilon(1e-6));
    }
    CHECK(forced("archard.K", {7}).ulps == 0);
    CHECK(!forced("westergaard.pressure", {0.1, 0.5}).estimated);
    // beside the edge there is no derivative: the whole square root is forced
    CHECK(forced("westergaard.half_width", {1 - 0x1p-53}).ulps > 1e6);
}

TEST_CASE("areas in partial contact: as certified values at the ends say")
{
    for (const std::vector<double>& row : {std::vector<double>{3, 0.1, std::sqrt(10.0)}, {8, 0.01, std::sqrt(5.0)}, {1, 0.5, 4}}) {
        CAPTURE(row[0]);
        const ForcedUlps f = forced("contact.area", row);
        CHECK(!f.estimated);
        CHECK(f.ulps == doctest::Approx(by_hand("contact.area", row, 26)).scale(0).epsilon(1e-3));
    }
}

TEST_CASE("distributions: the estimate is within the factor that the judge allows it")
{
    for (const std::vector<double>& row : {std::vector<double>{1, 0.5, 0.01, std::sqrt(10.0)},
                                           {1, 1.2, 0.1, std::sqrt(10.0)},
                                           {1, 1.999, 0.1, std::sqrt(10.0)},
                                           {1, 0.3, 0.5, 2.5}})
        for (const char* name : {"contact.exceedance", "contact.density"}) {
            CAPTURE(name);
            CAPTURE(row[1]);
            const ForcedUlps f = forced(name, row);
            CHECK(f.estimated);
            const double right = by_hand(name, row, 26);
            CHECK(right < 4 * f.ulps);
            CHECK(f.ulps < 16 * right + 4);
        }
}

TEST_CASE("three digits, the same whatever the last bit")
{
    CHECK(forced_text(0.03125) == "0.0312");
    CHECK(forced_text(std::nextafter(0.03125, 0)) == "0.0312");
    CHECK(forced_text(std::nextafter(0.03125, 1)) == "0.0312");
    CHECK(forced_text(0.5) == "0.5");
    CHECK(forced_text(123456) == "1.23e+05");
    CHECK(forced_text(1e-9) == "0");
}

TEST_CASE("a table carries it, and is read with it or without")
{
    const Table t = compute(*find_table("hertz_half_width"), 20, 2);
    const std::string text = format(t, "txt");
    const StoredTable back = parse_table(text, "t");
    CHECK(back.has_forced);
    for (std::size_t i = 0; i < t.rows.size(); ++i) {
        REQUIRE(back.rows[i].forced);
        CHECK(*back.rows[i].forced == doctest::Approx(t.rows[i].forced->ulps).scale(0).epsilon(5e-3));
    }
    for (const char* wrong : {"x", "nan", "-0.5", "1e999"}) {
        std::string bad = text;
        bad.replace(bad.rfind(' ') + 1, bad.size() - bad.rfind(' ') - 2, wrong);
        CHECK_THROWS_WITH_AS(parse_table(bad, "t"), doctest::Contains("what inputs force"), CorruptTable);
    }
    TableSpec plain = *find_table("hertz_half_width");
    plain.forced = false;
    CHECK(!parse_table(format(compute(plain, 20, 2), "txt"), "t").has_forced);
}
