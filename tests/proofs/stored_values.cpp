// SPDX-License-Identifier: GPL-3.0-or-later
// The values the ledger takes from a table: the table is whole, and its hash guards it.
#include "proofs/lemmas/limit_values.hpp"
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
    CHECK_THROWS_WITH_AS(stored_value("contact.area n=99", [] { return Ball(0); }), doctest::Contains("contact.area n=99"),
                         std::out_of_range);
    values_used();
    stored_value("contact.area n=1 load=1 D=21/20 gamma=5", [] { return Ball(0); });
    CHECK(values_used() == std::vector<std::string>{"contact.area n=1 load=1 D=21/20 gamma=5"});
    CHECK(values_used().empty());
}

// Skipped here, since it takes a quarter of a minute; `touchstone paper --recompute` (ctest -R paper_recompute) computes all values, and
// the campaign over our own proofs (mutate_sources.py) runs this one.
TEST_CASE("values of the limit, computed anew, are the stored ones" * doctest::skip())
{
    using touchstone::Rational;
    recompute_values();
    limiting_ratio(5);
    limiting_share_outside_hertz(10);
    limiting_share_outside_hertz_low_D(10);
    limiting_full_share(5);
    limiting_normalised_density(Rational(1, 2));
    for (const std::string& line : values_that_differ()) {
        CAPTURE(line);
        CHECK(line.ends_with("no verdict asks for it"));
    }
    recompute_values(false);
}

TEST_CASE("what is computed otherwise, or less precisely, than stored does not confirm it")
{
    using touchstone::Rational;
    const Ball third = Ball(1) / 3, thousandth(Rational(1, 1000));
    CHECK(difference(third, third).empty());
    CHECK(difference(third, Ball(1) / 2).find("computed only") == std::string::npos);
    CHECK(difference(third, Ball(1) / 2).find("0.5") != std::string::npos);
    CHECK(difference(third, touchstone::hull(third - thousandth, third + thousandth)).starts_with("computed only to"));
    CHECK(difference(third, Ball(1) / 0).starts_with("computed only to"));
    recompute_values();
    CHECK_THROWS_WITH_AS(stored_value("any", [] { return Ball(Ball(1) / 0); }), doctest::Contains("no enclosure"), std::runtime_error);
    recompute_values(false);
}
