// SPDX-License-Identifier: MIT
/// \file
/// The unit in the last place.
#pragma once

#include "touchstone/scalar/rational.hpp"

namespace touchstone {

/// The distance of neighbouring binary64 numbers at this value: 2^(e-52) for 2^e <= |value| < 2^(e+1), never less than 2^-1074.
Rational ulp_at(const Rational& value);

} // namespace touchstone
