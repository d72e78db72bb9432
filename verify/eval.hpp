// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// What `touchstone eval` is asked for, and its two ways: one value, or rows of them.
#pragma once

#include "touchstone/catalogue/directed.hpp"
#include "touchstone/catalogue/named_inputs.hpp"

#include <algorithm>
#include <string>
#include <thread>
#include <vector>

namespace touchstone::program {

struct EvalOptions {
    std::string quantity;
    std::vector<std::string> assignments;
    long digits = 20;
    long start_precision = 0;
    long max_precision = 0;
    std::string round = "nearest";
    bool json = false;
    bool explain = false;
    std::string rows, out, shard;
    bool resume = false;
    bool binary64 = false;
    unsigned jobs = std::max(1u, std::thread::hardware_concurrency());
};

/// \returns the exit code
int evaluate_rows(const EvalOptions&, const Quantity&, const NamedTexts&);

} // namespace touchstone::program
