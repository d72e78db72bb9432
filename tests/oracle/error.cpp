// SPDX-License-Identifier: MIT
/// The judge's arithmetic: ulps, what rounded inputs force, baselines, and that re-certifying finds a lie.
#include "touchstone/oracle/judge.hpp"
#include "touchstone/oracle/subject.hpp"
#include "touchstone/table/forced.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

using namespace touchstone;
using namespace touchstone::oracle;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

CertifiedValue value(const char* text, const char* error = "0") { return {*parse_rational(text), *parse_rational(error)}; }

const Quantity& named(const char* name) { return *find_quantity(name); }

CertifiedValue certified(const Quantity& q, const std::vector<double>& row)
{
    const Evaluation e = evaluate(q, exact_inputs(q, row), {.digits = 40});
    return value(e.value.c_str(), e.error_bound.c_str());
}

} // namespace

TEST_CASE("the error is an interval that holds the truth")
{
    CHECK(error_of(1 + 0x1p-52, value("1")).least == 1);
    CHECK(error_of(1 + 0x1p-52, value("1")).most == 1);
    const Interval third = error_of(1.0 / 3, value("0.33333333333333333333", "5e-21")); // 1/3 is 1/3 ulp off its nearest double
    CHECK(third.least < 1.0 / 3);
    CHECK(third.most > 1.0 / 3);
    CHECK(third.most - third.least < 4e-4);
    CHECK(error_of(1.0, value("1", "1e-17")).least == 0); // never below 0
    CHECK(error_of(1.0, value("1", "1e-17")).most > 0);
    CHECK(error_of(1e-30, value("0")).least == 1e-30);   // absolute at a zero
    CHECK(error_of(infinity, value("1e400")).most == 0); // rounds to infinity
    CHECK(error_of(5e-324, value("1e-400")).most <= 1);
    CHECK(error_of(-1e308, value("5e-324")).least == std::numeric_limits<double>::max());
    CHECK(is_special(std::nan(""), value("1")));
    CHECK(is_special(-infinity, value("1e400")));
    CHECK(!is_special(infinity, value("1e400")));
}

TEST_CASE("what rounded inputs force: between bounds, and the condition number where there is one")
{
    // sqrt: half an ulp of load moves sqrt(load)/pi by a quarter of its relative size
    for (const double load : {0.3, 1.0, 1.999}) {
        const auto& q = named("hertz.half_width");
        const CertifiedValue truth = certified(q, {load});
        const Forced f = forced_by_inputs(q, {load}, truth, 8);
        const double up = std::nextafter(load, infinity) - load;
        const Rational moved = truth.value * exact_rational(up / load) / 4 / ulp_at(truth.value);
        CHECK(f.least > 0);
        REQUIRE(f.most);
        CHECK(f.least <= *f.most);
        CHECK(f.least == doctest::Approx(moved.get_d()).scale(0).epsilon(1e-6));
        CHECK(*f.most == doctest::Approx(moved.get_d()).scale(0).epsilon(1e-2));
    }
    // 2^-40 off the edge of the contact the pressure is moved by 10^4 and more ulps, though the inputs are exact
    const auto& pressure = named("westergaard.pressure");
    const std::vector<double> edge{0.25 - 0x1p-42, 0.5};
    const Forced f = forced_by_inputs(pressure, edge, certified(pressure, edge), 4);
    CHECK(f.least > 1e3);
    REQUIRE(f.most);
    CHECK(*f.most < 4 * f.least);
    // next to the density's pole nothing bounds it
    const auto& density = named("westergaard.density");
    const std::vector<double> pole{std::nextafter(2 * std::sqrt(0.3), 0), 0.3};
    const auto unbounded = forced_by_inputs(density, pole, certified(density, pole), 1).most;
    CHECK((!unbounded || *unbounded > 1e6));
    // what is known needs no corners, and the bound is the same
    const Forced again = forced_by_inputs(pressure, edge, certified(pressure, edge), 4, f.least);
    CHECK(again.least == f.least);
    CHECK(again.most == f.most);
    // integers are not rounded
    const auto& K = named("archard.K");
    CHECK(*forced_by_inputs(K, {7}, certified(K, {7}), 4).most < 1e-20);
}

TEST_CASE("answers of any language, and nothing else")
{
    for (const char* text : {"0x1.8p-3", " 0.1875", "1.875E-01", "1.875D-01", "  +.1875 \r"}) CHECK(parse_answer(text) == 0.1875);
    CHECK(std::isnan(*parse_answer("nan")));
    CHECK(std::isnan(*parse_answer("-NaN")));
    CHECK(parse_answer("Infinity") == infinity);
    CHECK(parse_answer("1e999") == infinity);
    for (const char* text : {"", "apples", "0.1 0.2", "0.1,", "1e", "0x", "0.1apples"}) CHECK(!parse_answer(text));
}

TEST_CASE("baselines are finite, complete, and of one table")
{
    const Baseline b{"t", "hash", {{"0x1p-1", 0.75}, {"0x1p-2", 1e300}}};
    const Baseline back = parse_baseline(b.text(), "b");
    CHECK(back.bounds == b.bounds);
    CHECK(back.table == "t");
    for (const char* bad :
         {"", "[]", "{}", R"({"table":"t","sha256":"h","ulps":{"0x1p-1":NaN}})", R"({"table":"t","sha256":"h","ulps":{"0x1p-1":Infinity}})",
          R"({"table":"t","sha256":"h","ulps":{"0x1p-1":1e999}})", R"({"table":"t","sha256":"h","ulps":{"0x1p-1":-1}})",
          R"({"table":"t","sha256":"h","ulps":{"0x1p-1":null}})", R"({"table":"t","sha256":"h","ulps":{"0x1p-1":"1"}})",
          R"({"table":"t","sha256":"h","ulps":{"0x1p-1":1.7976931348623157e308}})",
          R"({"table":"t","sha256":"h","ulps":{"0x1p-1":1,"0x1p-1":2}})"})
        CHECK_THROWS_AS(parse_baseline(bad, "b"), BadBaseline);
    CHECK(differences(b, Baseline{"t", "hash", {{"0x1p-1", 0.8}, {"0x1p-3", 1}}}).size() == 3);
}

TEST_CASE("re-certifying finds a wrong digit")
{
    StoredTable t;
    t.digits = 20;
    const auto& q = named("hertz.half_width");
    const Evaluation e = evaluate(q, exact_inputs(q, {0.3}), {.digits = 20});
    t.rows.push_back({{0.3}, e.value, e.error_bound});
    CHECK_NOTHROW(recheck(q, t, {0}, "t"));
    t.rows[0].value.back() = t.rows[0].value.back() == '0' ? '1' : '0';
    CHECK_THROWS_AS(recheck(q, t, {0}, "t"), CorruptTable);
}

TEST_CASE("re-certifying finds what rounded inputs are wrongly said to force, for the recursion too")
{
    StoredTable t;
    t.digits = 20;
    t.has_forced = true;
    const auto& q = named("contact.area");
    const std::vector<double> inputs{1, 0.1, 4};
    const Evaluation e = evaluate(q, exact_inputs(q, inputs), {.digits = 20});
    const auto forced = forced_ulps(q, inputs, *parse_rational(e.value));
    REQUIRE(forced);
    t.rows.push_back({inputs, e.value, e.error_bound, forced->ulps});
    CHECK_NOTHROW(recheck(q, t, {0}, "t"));
    t.rows[0].forced = 1e35;
    CHECK_THROWS_AS(recheck(q, t, {0}, "t"), CorruptTable);
}

TEST_CASE("order and symmetry")
{
    const auto& q = named("westergaard.pressure");
    std::vector<Question> rows;
    std::vector<double> answers;
    for (const double x : {-0.1, 0.05, 0.1}) {
        const Evaluation e = evaluate(q, exact_inputs(q, {x, 0.5}), {.digits = 40});
        rows.push_back({{x, 0.5}, e.value, value(e.value.c_str(), e.error_bound.c_str()), false});
        answers.push_back(*e.binary64);
    }
    CHECK(judge(q, rows, answers, {}).order.empty());
    CHECK(judge(q, rows, answers, {}).verdict == Verdict::pass);
    std::swap(answers[1], answers[2]);
    const Judgement swapped = judge(q, rows, answers, {});
    CHECK(swapped.order.size() >= 2); // out of order, and no longer symmetric
    CHECK(swapped.verdict == Verdict::fail);
}
