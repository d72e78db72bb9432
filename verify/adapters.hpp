// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// What stands between a code and `touchstone judge`: rows of C99 hexfloats in, one number a line out.
#pragma once

#include "touchstone/catalogue/quantity.hpp"

#include <string>

namespace touchstone::program {

std::string python_adapter(const Quantity&);
std::string cpp_adapter(const Quantity&);
std::string fortran_adapter(const Quantity&);

} // namespace touchstone::program
