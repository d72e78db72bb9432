// SPDX-License-Identifier: MIT
/// The single header as another project's test suite uses it, here doctest in C++17.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include "touchstone_reference.hpp"

#include <doctest/doctest.h>

#include <cstdio>
#include <sstream>

namespace ref = touchstone_reference;

namespace {

double half_width(double load) { return std::atan2(std::sqrt(load), std::sqrt(1 - load)) / 3.14159265358979323846; }

std::string table_file() { return std::getenv("TOUCHSTONE_TABLE"); }

std::string contents()
{
    std::ifstream in(table_file());
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

std::string written(const std::string& text)
{
    const std::string file = table_file() + ".damaged";
    std::ofstream(file) << text;
    return file;
}

bool close(ref::Interval i, double expected)
{
    return i.least <= expected && expected <= i.most && i.most - i.least <= 1e-10 * (expected + 1);
}

} // namespace

static_assert(__cplusplus == 201703L, "the header's promise is C++17");

TEST_CASE("one call judges a function")
{
    const auto table = ref::load(table_file());
    CHECK(table.name == "westergaard_half_width");
    CHECK(table.rows.size() > 300);
    const auto good = table.worst([](const auto& x) { return half_width(x[0]); });
    INFO(good.message());
    CHECK(good.ulps > 0.5);
    CHECK(good.ulps <= 4);
    const auto bad = table.worst([](const auto& x) { return 2 * half_width(x[0]); });
    CHECK(bad.ulps > 1e15);
    CHECK(bad.message().find("answer 0x") != std::string::npos);
}

TEST_CASE("all failing rows, beyond what rounded inputs force")
{
    const auto table = ref::load(table_file());
    const auto good = [](const auto& x) { return half_width(x[0]); };
    INFO(ref::message(table.failing(good)));
    CHECK(table.failing(good).empty());
    for (const auto& row : table.rows) CHECK(row.forced >= 0);
    // next to full contact half an ulp of the load moves the edge by many
    const auto forced = [](const ref::Row& row) { return row.forced > 1e3; };
    CHECK(std::any_of(table.rows.begin(), table.rows.end(), forced));
    const auto rounded = [](const auto& x) { return half_width(std::nextafter(x[0], 0)); };
    ref::Tolerance strict;
    strict.forgive_inputs = false;
    CHECK(table.failing(rounded, strict).size() > 20);
    ref::Tolerance wide;
    wide.rtol = 1e-6;
    const auto off = [](const auto& x) { return half_width(x[0]) * (1 + 1e-9); };
    CHECK(table.failing(off).size() > 0.9 * static_cast<double>(table.rows.size()));
    CHECK(table.failing(off, wide).empty());
    CHECK(table.failing([](const auto&) { return std::nan(""); }, wide).size() == table.rows.size());
    const auto some = table.failing([](const auto&) { return 1.0; }, {}, [](const auto& x) { return x[0] < 0.25; });
    REQUIRE(!some.empty());
    for (const auto& w : some) CHECK(w.row->inputs[0] < 0.25);
    CHECK(ref::message(some).find(std::to_string(some.size()) + " rows fail") == 0);
}

TEST_CASE("estimates of what inputs force are forgiven four times")
{
    std::string text = contents();
    const std::string exact = "\"forced\":\"first order\"";
    text.replace(text.find(exact), exact.size(), "\"forced\":\"estimated\"");
    const ref::Table once = ref::load(table_file()), four = ref::load(written(text));
    for (std::size_t i = 0; i < once.rows.size(); ++i) CHECK(four.rows[i].forced == 4 * once.rows[i].forced);
    std::remove((table_file() + ".damaged").c_str());
}

TEST_CASE("ulps against known distances")
{
    CHECK(close(ref::ulps(1.0, "1.000000000000000000000", "5e-22"), 0));
    CHECK(close(ref::ulps(1 + 0x1p-52, "1.000000000000000000000", "5e-22"), 1));
    CHECK(close(ref::ulps(1 + 0x1p-52, "0.9999999999999999999999999999999999", "5e-35"), 2)); // below 1 an ulp is 2^-53
    CHECK(close(ref::ulps(5e-324, "1.482196937523740e-323", "5e-348"), 2));       // 3 x 2^-1074
    CHECK(close(ref::ulps(0.1, "0.1000000000000000000000", "5e-23"), 0.4));       // the double is 0.4 ulp above
    CHECK(close(ref::ulps(-1.0, "1.000000000000000000000", "5e-22"), 0x1p53));
    CHECK(ref::ulps(std::nan(""), "1.0", "5e-22").least > 1e300);
    CHECK(ref::ulps(INFINITY, "1.0", "5e-22").least > 1e300);
    CHECK(ref::ulps(INFINITY, "1.000000000000000000000e+400", "5e+378").most == 0);
    CHECK(ref::ulps(0.0, "0", "0").most == 0);
    CHECK(ref::ulps(1e-300, "0", "0").least > 1e300);
}

TEST_CASE("damaged tables are refused")
{
    const std::string text = contents();
    CHECK_THROWS(ref::load(table_file() + ".missing"));
    CHECK_THROWS(ref::load(written("")));
    CHECK_THROWS(ref::load(written(text.substr(0, text.size() - 200))));
    for (const char* bound : {" nan ", " inf ", " -5e-41 ", " 0.1 ", " "}) { // before the last column
        std::string damaged = text;
        const auto line_end = damaged.rfind('\n', damaged.rfind('\n', damaged.size() - 2) - 1);
        const auto end = damaged.rfind(' ', damaged.rfind('\n', damaged.size() - 2));
        const auto bound_begin = damaged.rfind(' ', end - 1);
        REQUIRE(bound_begin > line_end);
        damaged.replace(bound_begin, end - bound_begin + 1, bound);
        CHECK_THROWS(ref::load(written(damaged)));
    }
    const auto row = text.rfind('\n', text.size() - 2) + 1, value = text.find(' ', row) + 1, after = text.find(' ', value);
    for (const char* other :
         {"0.5E306952043666", "1e-99999", "0x1p-1", "1e", "1.5.0", "+-1", "inf", "e5", "1e+"}) // the first two had no end
        CHECK_THROWS(ref::load(written(text.substr(0, value) + other + text.substr(after))));
    for (const char* forced : {"nan", "inf", "-2", "x"})
        CHECK_THROWS(ref::load(written(text.substr(0, text.rfind(' ') + 1) + forced + "\n")));
    std::remove((table_file() + ".damaged").c_str());
}
