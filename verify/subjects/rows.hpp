// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// The loop of every judged program in C++: a row of hexadecimal numbers in, one number out.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

namespace touchstone::subjects {

using Row = std::vector<double>;

inline Row numbers(const std::string& line)
{
    Row row;
    const char* at = line.c_str();
    for (char* end = nullptr;; at = end) {
        const double x = std::strtod(at, &end);
        if (end == at) return row;
        row.push_back(x);
    }
}

/// Answers each row with f(row), in hexadecimal.
template <class F>
int answer_rows(F f)
{
    for (std::string line; std::getline(std::cin, line);) std::printf("%a\n", f(numbers(line)));
    return 0;
}

} // namespace touchstone::subjects
