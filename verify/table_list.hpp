// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// `touchstone table` without a name.
#pragma once

#include <string>

namespace touchstone::program {

/// Prints every table there is, and what the checker, which shares nothing with this program, has confirmed of the one stored in this
/// folder: coverage.json there is what checker/check.py --coverage kept, and counts while the rows have the hash they had then.
int list_tables(const std::string& folder);

} // namespace touchstone::program
