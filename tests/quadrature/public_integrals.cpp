// SPDX-License-Identifier: MIT
// The integrals of public_integrals.txt, as their authors type them: which are taken, which refused, how long each takes. No ball may be
// wrong. `ctest -R public_integrals -V` prints the table.
#include "tests/quadrature/public_integrals.hpp"
#include "touchstone/quadrature/integrate.hpp"

#include <doctest/doctest.h>

#include <chrono>
#include <cstdio>
#include <string>

using namespace touchstone;
using namespace touchstone::quadrature;

namespace {

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
    for (const PublicIntegral& row : public_integrals(TOUCHSTONE_SOURCE "/tests/quadrature/public_integrals.txt")) {
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
    CHECK(literal >= 166);
}
