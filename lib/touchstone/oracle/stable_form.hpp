// SPDX-License-Identifier: MIT
/// \file
/// The forms in which the library computes its quantities in double precision, to tell a code that lost its digits.
#pragma once

#include <string>
#include <string_view>

namespace touchstone::oracle {

/// The form that loses no digits, in plain notation, and what it avoids; empty where the library has none to offer.
/// The library's own header is lib/touchstone/paper/ (MIT).
std::string stable_form(std::string_view quantity);

} // namespace touchstone::oracle
