// SPDX-License-Identifier: MIT
#include "touchstone/table/format.hpp"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <set>

using namespace touchstone;

namespace {

const std::string& sample()
{
    static const std::string text = format(compute(*find_table("archard_K"), 30, 2), "txt");
    return text;
}

std::string with(std::string text, const std::string& from, const std::string& to)
{
    const auto at = text.find(from);
    REQUIRE(at != std::string::npos);
    return text.replace(at, from.size(), to);
}

} // namespace

TEST_CASE("a table written and read back is the same table, however many threads made it")
{
    CHECK(sample() == format(compute(*find_table("archard_K"), 30, 1), "txt"));
    const StoredTable t = parse_table(sample(), "sample");
    CHECK(t.quantity == "archard.K");
    CHECK(t.inputs == std::vector<std::string>{"n"});
    CHECK(t.rows.size() == 70);
    CHECK(t.rows[3].value == "0.416550371832813487722720256733");
    CHECK(t.rows[3].error == "5e-31");
}

TEST_CASE("SHA-256 is SHA-256")
{
    CHECK(sha256("abc") == "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad"); // FIPS 180-2
}

TEST_CASE("a corrupt table is refused with the line and the reason")
{
    const auto refused = [](const std::string& text, const char* reason) {
        CHECK_THROWS_WITH_AS(parse_table(text, "f"), doctest::Contains(reason), CorruptTable);
    };
    refused("", "complete line");
    refused("not a table\n", "header");
    refused(with(sample(), "0.41655037", "0.41655038"), "SHA-256");    // a planted wrong digit
    refused(with(sample(), "0.41655037", "0.4165x037"), "not a number");
    refused(with(sample(), "5e-31", "nan"), "error bound");
    refused(with(sample(), "5e-31", "-5e-31"), "error bound");
    refused(with(sample(), "\n3 ", "\n3 3 "), "columns");
    refused(with(sample(), "\n3 ", "\nthree "), "input");
    refused(sample().substr(0, sample().size() - 1), "complete line");
    refused(sample().substr(0, sample().rfind("1000000")), "rows where the header says");
    refused(with(sample(), "\"rows\":70", "\"rows\":71"), "rows where the header says");
    refused(with(sample(), "# {", "# x{"), "header");
}

TEST_CASE("every view is complete and consistent with the canonical one")
{
    const Table t = compute(*find_table("westergaard_pressure"), 20, 2);
    const auto j = nlohmann::json::parse(format(t, "json"));
    CHECK(j.at("rows").size() == t.rows.size());
    CHECK(j.at("header").at("sha256") == nlohmann::json::parse(parse_table(format(t, "txt"), "t").header_json).at("sha256"));
    const std::string csv = format(t, "csv");
    CHECK(static_cast<std::size_t>(std::count(csv.begin(), csv.end(), '\n')) == t.rows.size() + 1);
    CHECK(format(t, "hpp").find("inline constexpr westergaard_pressure_row") != std::string::npos);
    CHECK(format(t, "ipp").find("SC_(") != std::string::npos);
    CHECK_THROWS_AS(format(t, "xls"), std::invalid_argument);
}

TEST_CASE("every table names a known quantity and has distinct rows of the right width")
{
    std::set<std::string> tabulated;
    for (const auto& spec : table_specs()) {
        CAPTURE(spec.name);
        const Quantity* q = find_quantity(spec.quantity);
        REQUIRE(q != nullptr);
        tabulated.insert(q->name);
        std::set<std::vector<double>> seen;
        for (const auto& row : spec.grid()) {
            CHECK(row.size() == q->inputs.size());
            CHECK(seen.insert(row).second);
        }
    }
    for (const auto& q : catalogue()) CHECK_MESSAGE(tabulated.contains(q.name), q.name << " has no table");
}
