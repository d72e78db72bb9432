// SPDX-License-Identifier: MIT
/// \file
/// A property that holds for every text: where it fails the program ends, so that libFuzzer keeps the text.
#pragma once

#include <cstdio>
#include <cstdlib>

namespace touchstone::fuzz {

inline void expect(bool holds, const char* what)
{
    if (holds) return;
    std::fprintf(stderr, "does not hold: %s\n", what);
    std::abort();
}

} // namespace touchstone::fuzz
