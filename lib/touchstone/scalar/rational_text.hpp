// SPDX-License-Identifier: MIT
/// \file
/// What to say of a text that is no exact number.
#pragma once

#include <string>
#include <string_view>

namespace touchstone {

/// What is wrong with a text that parse_rational does not take, to follow the text itself in a message:
/// "is not a number such as 12, ...", "has 0 as its denominator", "has an exponent beyond 1000000".
std::string why_not_rational(std::string_view text);

} // namespace touchstone
