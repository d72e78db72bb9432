// SPDX-License-Identifier: MIT
/// The tables committed in data/reference: readable, whole, and honest about their bounds.
#include "touchstone/table/format.hpp"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <sstream>

using namespace touchstone;

namespace {

std::string read(const std::string& path)
{
    std::ifstream in(path, std::ios::binary);
    REQUIRE_MESSAGE(in.good(), path);
    std::ostringstream bytes;
    bytes << in.rdbuf();
    return bytes.str();
}

} // namespace

TEST_CASE("the manifest lists every table with its hash, and every bound is finite and no smaller than the last digit allows")
{
    const std::string folder = TOUCHSTONE_DATA "/reference/";
    const auto manifest = nlohmann::json::parse(read(folder + "manifest.txt.json"));
    CHECK(manifest.at("tables").size() == table_specs().size());
    for (const auto& entry : manifest.at("tables")) {
        const std::string file = entry.at("file");
        CAPTURE(file);
        const std::string text = read(folder + file);
        CHECK(entry.at("sha256") == sha256(text));
        const bool estimated = entry.at("status") == "estimated";
        // full contact, G < 2 or n > 1: no proof of some rows
        if (estimated) CHECK(file.find("_full.") != std::string::npos);
        else CHECK((entry.at("status") == "certified" || entry.at("status") == "exact"));
        CHECK((text.find("estimated reference table") != std::string::npos) == estimated);
        const StoredTable t = parse_table(text, file);
        for (const auto& row : t.rows) {
            const Rational error = *parse_rational(row.error);
            const Rational value = *parse_rational(row.value);
            if (error == 0) continue; // exact
            Decimal d = round_to_digits(value, t.digits);
            if (estimated && d.digits.back() == '0' && error != *parse_rational(d.half_unit()))
                d = round_to_digits(value, t.digits - 1); // next to a tie
            CHECK(d.value() == value); // no more digits than claimed
            CHECK(error == *parse_rational(d.half_unit()));
        }
    }
}
