// SPDX-License-Identifier: MIT
/// \file
/// How far a second look at a proven value goes.
#pragma once

#include "touchstone/scalar/accuracy.hpp"

namespace touchstone {

/// A second look, proof or witness, looks at the first half of the digits asked for, at ten at least: a mistake in a formula or in its
/// program, which it is there to find, does not wait for the later digits, and what those rest on, precision and bounds, is the proof's own
/// matter.
constexpr Accuracy looked_at_again(Accuracy wanted)
{
    constexpr long least = 10;
    return {std::max(std::min(wanted.digits, least), (wanted.digits + 1) / 2)};
}

} // namespace touchstone
