// SPDX-License-Identifier: MIT
/// \file
/// The rows of public_integrals.txt.
#pragma once

#include <algorithm>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace touchstone::quadrature {

struct PublicIntegral {
    std::string name, formula, from, to, value, expected;
};

inline std::vector<PublicIntegral> public_integrals(const std::string& path)
{
    const auto trimmed = [](const std::string& s) {
        const auto first = s.find_first_not_of(" \t\r");
        return first == std::string::npos ? "" : s.substr(first, s.find_last_not_of(" \t\r") - first + 1);
    };
    std::ifstream in(path);
    if (!in) throw std::runtime_error("cannot read " + path);
    std::vector<PublicIntegral> all;
    for (std::string line; std::getline(in, line);) {
        if (line.empty() || line[0] == '#') continue;
        std::vector<std::string> f;
        for (std::size_t start = 0; start <= line.size();) {
            const std::size_t stop = std::min(line.find(';', start), line.size());
            f.push_back(trimmed(line.substr(start, stop - start)));
            start = stop + 1;
        }
        if (f.size() < 5) throw std::runtime_error("no integral: " + line);
        f.resize(6);
        all.push_back({f[0], f[1], f[2], f[3], f[4], f[5]});
    }
    return all;
}

} // namespace touchstone::quadrature
