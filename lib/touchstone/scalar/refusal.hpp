// SPDX-License-Identifier: MIT
/// \file
/// What a computation throws when it has to give up. Nothing above scalar/ is needed to refuse.
#pragma once

#include <stdexcept>

namespace touchstone {

/// A value that cannot be had at any precision in reach (series too long, regime not proven).
/// Leads to the status `undecided`, never to a guess.
class BeyondReach : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

} // namespace touchstone
