// SPDX-License-Identifier: MIT
/// \file
/// Numbers for a reader's eye.
#pragma once

#include <string>

namespace touchstone {

/// A decimal number rounded to `digits` significant digits if it has more: never cut off, its exponent kept.
std::string shown_decimal(const std::string& number, long digits = 20);

} // namespace touchstone
