// SPDX-License-Identifier: MIT
#include "touchstone/catalogue/named_inputs.hpp"
#include "touchstone/oracle/printed.hpp"

#include <doctest/doctest.h>

using namespace touchstone;
using namespace touchstone::oracle;

namespace {

PrintedEntry entry(const char* quantity, const NamedTexts& inputs, const char* printed)
{
    const Quantity& q = *find_quantity(quantity);
    return check_printed(q, read_inputs(q, inputs), printed);
}
PrintedEntry K_3(const char* printed) { return entry("archard.K", {{"n", "3"}}, printed); } // 0.4165503718328134877...

} // namespace

TEST_CASE("a printed decimal is right as rounded, cut off, a unit off or wrong")
{
    CHECK(K_3("0.416550").verdict == PrintedVerdict::rounded);
    CHECK(K_3("4.1655e-1").verdict == PrintedVerdict::rounded);
    CHECK(K_3("4.16550E-01").verdict == PrintedVerdict::rounded);
    CHECK(K_3("0.41655037183").verdict == PrintedVerdict::rounded);
    CHECK(K_3("0.4165503").verdict == PrintedVerdict::cut_off);
    CHECK(K_3("0.4165503").right == "0.4165504");
    CHECK(K_3("0.416551").verdict == PrintedVerdict::one_unit_off);
    CHECK(K_3("0.416549").verdict == PrintedVerdict::one_unit_off);
    CHECK(K_3("0.416549").right == "0.416550");
    CHECK(K_3("0.416650").verdict == PrintedVerdict::wrong);
    CHECK(K_3("41655.0").right == "0.4");
    CHECK(K_3("4.16e5").right == "0e+03");
    CHECK(K_3("-0.416550").verdict == PrintedVerdict::wrong);
    CHECK(K_3("0").verdict == PrintedVerdict::rounded);
    CHECK(K_3("1").verdict == PrintedVerdict::one_unit_off);
    CHECK(K_3("0.41655037183281348772272025673273").right.substr(0, 32) == "0.416550371832813487722720256733");
}

TEST_CASE("what has more places than are looked at is said to have them")
{
    const PrintedEntry e = K_3(("0.4165503718328134877" + std::string(2100, '0')).c_str());
    CHECK(e.verdict == PrintedVerdict::undecided);
    CHECK(e.note == "more places are printed than the 2000 that are looked at");
}

TEST_CASE("a tie is right either way; an exact value too")
{
    const NamedTexts half{{"load", "1"}}; // half-width 1/2
    CHECK(entry("westergaard.half_width", half, "0").verdict == PrintedVerdict::rounded);
    CHECK(entry("westergaard.half_width", half, "1").verdict == PrintedVerdict::rounded);
    CHECK(entry("westergaard.half_width", half, "0.5").verdict == PrintedVerdict::rounded);
    CHECK(entry("westergaard.half_width", half, "0.500000").verdict == PrintedVerdict::rounded);
    CHECK(entry("westergaard.half_width", half, "0.499999").verdict == PrintedVerdict::one_unit_off);
    CHECK(entry("westergaard.half_width", half, "3").verdict == PrintedVerdict::wrong);
}

TEST_CASE("negative values are cut off towards zero")
{
    const NamedTexts at{{"x", "1/3"}, {"D", "3/2"}, {"gamma", "10"}};
    const Quantity& q = *find_quantity("weierstrass.profile");
    const Evaluation e = evaluate(q, read_inputs(q, at), {.digits = 20});
    REQUIRE(e.value.front() == '-');
    for (std::size_t length = 6; length < 16; ++length) {
        const PrintedVerdict v = check_printed(q, read_inputs(q, at), e.value.substr(0, length)).verdict;
        CHECK((v == PrintedVerdict::cut_off || v == PrintedVerdict::rounded));
        CHECK((v == PrintedVerdict::rounded) == (e.value[length] < '5'));
    }
}

TEST_CASE("what is only estimated is undecided; what is no printed decimal is refused")
{
    const PrintedEntry e = entry("contact.density", {{"n", "2"}, {"p", "0.002"}, {"load", "1"}, {"G", "2"}}, "0.001");
    CHECK(e.verdict == PrintedVerdict::undecided);
    CHECK(e.right.empty());
    CHECK_FALSE(e.note.empty());
    for (const char* text : {"", "nan", "1/3", "0x1p-3", "0.4 1", "0,4"}) CHECK_THROWS_AS(K_3(text), DomainError);
}
