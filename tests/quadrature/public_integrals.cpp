// SPDX-License-Identifier: MIT
// The integrals of public_integrals.txt, as their authors type them: which are taken, which refused, how long each takes. No ball may be
// wrong, and none may take half as many evaluations again as public_integrals_work.txt says (TOUCHSTONE_WRITE=1 writes it anew).
// `ctest -R public_integrals -V` prints the table.
#include "tests/quadrature/public_integrals.hpp"
#include "touchstone/quadrature/integrate.hpp"

#include <doctest/doctest.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <string>

using namespace touchstone;
using namespace touchstone::quadrature;

namespace {

const char* const work_file = TOUCHSTONE_SOURCE "/tests/quadrature/public_integrals_work.txt";

/// Evaluations of the formula, at nodes and for the proof: the same on every machine.
long work_of(const Integral& i)
{
    long work = 0;
    for (const Part& p : i.parts) {
        work += p.evaluations;
        for (const Panel& panel : p.certificate.panels) work += panel.pieces;
    }
    return work;
}

/// name and work of each integral taken, as they were last written.
std::map<std::string, long> stored_work()
{
    std::ifstream in(work_file);
    std::map<std::string, long> all;
    std::string name;
    for (long work = 0; in >> name >> work;) all[name] = work;
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
    constexpr double slower_by_half = 1.5, spare = 20;
    const std::map<std::string, long> stored = stored_work();
    std::map<std::string, long> works;
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
        const long work = work_of(result);
        if (as_typed) works[row.name] = work;
        if (const auto known = stored.find(row.name); as_typed && known != stored.end())
            CHECK_MESSAGE(static_cast<double>(work) <= slower_by_half * static_cast<double>(known->second) + spare, work,
                          " evaluations, not ", known->second);
        std::printf("%-14s %-9s %8.1f ms %6ld  %s%s\n", row.name.c_str(), verdict, ms, work, row.formula.c_str(),
                    as_typed ? "" : ("   -- " + why).c_str());
    }
    std::printf("%ld literal, %ld rewritten, %ld refused, %.1f s\n", literal, rewritten, refused, total / 1000);
    CHECK(literal >= 170);
    if (std::getenv("TOUCHSTONE_WRITE")) {
        std::ofstream out(work_file);
        for (const auto& [name, work] : works) out << name << " " << work << "\n";
    }
    else
        CHECK(stored.size() == static_cast<std::size_t>(literal));
}
