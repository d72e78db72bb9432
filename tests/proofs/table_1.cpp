// SPDX-License-Identifier: GPL-3.0-or-later
#include "proofs/table_1.hpp"

#include <doctest/doctest.h>

#include <string>

using namespace touchstone::proofs;

TEST_CASE("all 20 printed K_n are the correct rounding of the true K_n")
{
    const auto entries = check_table_1(table_1_text());
    CHECK(entries.size() == 20);
    for (const auto& e : entries) {
        CAPTURE(e.id);
        CHECK(e.holds);
    }
}

TEST_CASE("a digit changed in any entry is found, in that entry alone")
{
    const std::string text(table_1_text());
    const auto honest = check_table_1(text);
    for (const auto& victim : honest) {
        std::string changed = text;
        const auto at = changed.rfind(victim.printed) + victim.printed.size() - 1;
        changed[at] = changed[at] == '9' ? '8' : static_cast<char>(changed[at] + 1);
        int wrong = 0;
        for (const auto& e : check_table_1(changed)) wrong += e.holds ? 0 : 1;
        CHECK(wrong == 1);
    }
}
