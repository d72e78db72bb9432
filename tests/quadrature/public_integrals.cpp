// SPDX-License-Identifier: MIT
// The integrals of public_integrals.txt, as their authors type them: which are taken, which refused, how long each takes. No ball may be
// wrong. `ctest -R public_integrals -V` prints the table.
#include "touchstone/quadrature/integrate.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

using namespace touchstone;
using namespace touchstone::quadrature;

namespace {

struct Row {
    std::string name, formula, from, to, value, expected;
};

std::string trimmed(const std::string& s)
{
    const auto first = s.find_first_not_of(" \t\r");
    return first == std::string::npos ? "" : s.substr(first, s.find_last_not_of(" \t\r") - first + 1);
}

std::vector<Row> rows()
{
    std::ifstream in(TOUCHSTONE_SOURCE "/tests/quadrature/public_integrals.txt");
    std::vector<Row> all;
    for (std::string line; std::getline(in, line);) {
        if (line.empty() || line[0] == '#') continue;
        std::vector<std::string> f;
        for (std::size_t start = 0; start <= line.size();) {
            const std::size_t stop = std::min(line.find(';', start), line.size());
            f.push_back(trimmed(line.substr(start, stop - start)));
            start = stop + 1;
        }
        REQUIRE(f.size() >= 5);
        f.resize(6);
        all.push_back({f[0], f[1], f[2], f[3], f[4], f[5]});
    }
    return all;
}

/// The reference as a ball: a formula, or decimals of which the last may be one off.
Ball reference(const std::string& text)
{
    const auto point = text.find('.');
    const bool decimals = text.find_first_not_of("-0123456789.") == std::string::npos && point != std::string::npos;
    Ball value = parse_limit(text).ball();
    if (decimals) {
        const Ball unit(Rational(1 / power(Rational(10), static_cast<long>(text.size() - point - 1))));
        arb_add_error(value.get(), unit.get());
    }
    return value;
}

} // namespace

TEST_CASE("public test integrals as typed: taken or refused as the table says, never wrong")
{
    constexpr long digits = 25;
    long literal = 0, rewritten = 0, refused = 0;
    double total = 0;
    for (const Row& row : rows()) {
        CAPTURE(row.name);
        CAPTURE(row.formula);
        IntegralOptions options;
        options.digits = digits;
        const auto start = std::chrono::steady_clock::now();
        Integral result = integrate(parse_expression(row.formula), parse_limit(row.from), parse_limit(row.to), options);
        const double ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
        total += ms;
        const bool as_typed = result.status == Status::certified;
        const std::string why = result.reason;
        const char* verdict = as_typed ? "literal" : "refused";
        if (!as_typed && !row.expected.empty() && row.expected != "refused") {
            result = integrate(parse_expression(row.expected), parse_limit(row.from), parse_limit(row.to), options);
            verdict = "rewritten";
            CHECK_MESSAGE(result.status == Status::certified, result.reason);
        }
        CHECK_MESSAGE(as_typed == row.expected.empty(), why);
        (as_typed ? literal : result.status == Status::certified ? rewritten : refused) += 1;
        const WorkingPrecision precision(300);
        if (result.value.is_finite())
            CHECK_MESSAGE(result.value.overlaps(reference(row.value)), result.value.to_string(25), " is not ",
                          reference(row.value).to_string(25));
        if (result.status == Status::certified) CHECK(result.value.relative_bits() >= 83);
        std::printf("%-14s %-9s %8.1f ms  %s%s\n", row.name.c_str(), verdict, ms, row.formula.c_str(),
                    as_typed ? "" : ("   -- " + why).c_str());
    }
    std::printf("%ld literal, %ld rewritten, %ld refused, %.1f s\n", literal, rewritten, refused, total / 1000);
    CHECK(literal >= 145);
}
