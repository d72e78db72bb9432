// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// What a code that trusts a false print gets wrong, in numbers that are computed here from the print and its correction.
#pragma once

#include "touchstone/scalar/ball.hpp"

#include <string>

namespace touchstone::proofs {

/// \throws std::out_of_range for an entry whose consequence has no number.
std::string consequence_of(const std::string& id);

/// "3.6 percent": a share that is known to far more than the three digits shown.
std::string percent(const Ball& share);

} // namespace touchstone::proofs
