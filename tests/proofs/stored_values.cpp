// SPDX-License-Identifier: GPL-3.0-or-later
// The values the ledger takes from a table: the table is whole, and its hash guards it.
#include "proofs/lemmas/stored_values.hpp"

#include <doctest/doctest.h>

#include <fstream>
#include <sstream>

using namespace touchstone::proofs;
using touchstone::Ball;

namespace {

std::string table()
{
    std::ifstream in(TOUCHSTONE_DATA "/paper/values.txt");
    std::stringstream text;
    text << in.rdbuf();
    return text.str();
}

} // namespace

TEST_CASE("the table is read whole, and a changed digit is found by its hash")
{
    const std::string text = table();
    CHECK(read_values(text).size() > 100);
    std::string changed = text;
    const std::size_t at = changed.find("= [0.6");
    REQUIRE(at != std::string::npos);
    changed[at + 5] = '7';
    CHECK_THROWS_WITH_AS(read_values(changed), doctest::Contains("hash"), std::runtime_error);
    CHECK_THROWS_WITH_AS(read_values(text + "contact.area n=1\n"), doctest::Contains("not an enclosure"), std::runtime_error);
    CHECK_THROWS(read_values("# no header\n"));
}

TEST_CASE("a value that is not stored is named")
{
    CHECK_THROWS_WITH_AS(stored_value("contact.area n=99", [] { return Ball(0); }), doctest::Contains("contact.area n=99"), std::out_of_range);
    values_used();
    stored_value("contact.area n=1 load=1 D=21/20 gamma=5", [] { return Ball(0); });
    CHECK(values_used() == std::vector<std::string>{"contact.area n=1 load=1 D=21/20 gamma=5"});
    CHECK(values_used().empty());
}
