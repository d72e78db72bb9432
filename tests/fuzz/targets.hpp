// SPDX-License-Identifier: MIT
/// \file
/// What a stranger's text can reach, a function a parser: it takes any bytes, and what it refuses it refuses with the error it promises.
/// Anything else (another exception, a check that fails, a sanitizer's complaint, seconds without end) is a find. libFuzzer drives them one
/// at a time (campaign.py, clang), the default tests all of them over the corpora and over changes of these drawn from a seed.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace touchstone::fuzz {

void numbers(std::string_view);       ///< rational and exact numbers, printed decimals, shares of a table
void inputs(std::string_view);        ///< NAME KEY=VALUE..., as `eval` takes them, and the quantity's domain
void answers(std::string_view);       ///< what a judged program writes
void rows(std::string_view);          ///< files of rows
void ranges(std::string_view);        ///< first:last:step, log:first:last:count, lists
void tables(std::string_view);        ///< canonical tables
void shards(std::string_view);        ///< shares of tables
void own_tables(std::string_view);    ///< tables of one's own, JSON
void baselines(std::string_view);     ///< baselines of judge, JSON
void expressions(std::string_view);   ///< formulas of `integrate`, and their parameters
void client_header(std::string_view); ///< touchstone_reference.hpp: tables in a test suite of others
#ifdef TOUCHSTONE_FUZZ_LEDGERS
void ledgers(std::string_view);       ///< ledger.json of one's own
#endif

struct Target {
    const char* name; ///< of the function, and of its corpus
    void (*run)(std::string_view);
    std::size_t longest; ///< of its texts; what is longer is long, and not another case
};

inline const std::vector<Target>& targets()
{
    static const std::vector<Target> all{{"numbers", numbers, 400},
                                         {"inputs", inputs, 400},
                                         {"answers", answers, 1000},
                                         {"rows", rows, 1000},
                                         {"ranges", ranges, 400},
                                         {"tables", tables, 4000},
                                         {"shards", shards, 4000},
                                         {"own_tables", own_tables, 2000},
                                         {"baselines", baselines, 2000},
                                         {"expressions", expressions, 2000},
                                         {"client_header", client_header, 4000},
#ifdef TOUCHSTONE_FUZZ_LEDGERS
                                         {"ledgers", ledgers, 4000},
#endif
    };
    return all;
}

} // namespace touchstone::fuzz
