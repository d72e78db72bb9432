// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// `touchstone judge --emit LANGUAGE QUANTITY`: the program around a function that judge can talk to.
#pragma once

#include "touchstone/catalogue/quantity.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace touchstone::program {

const std::vector<std::string>& adapter_languages();

/// Source text, ready to be compiled or run; the one place to fill in is marked.
std::string adapter(const Quantity&, std::string_view language);

} // namespace touchstone::program
