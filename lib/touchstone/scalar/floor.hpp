// SPDX-License-Identifier: MIT
/// \file
/// Whole numbers out of balls.
#pragma once

#include "touchstone/scalar/ball.hpp"

namespace touchstone {

/// The largest integer up to the middle of a ball, of any size. \pre x is finite
inline Integer floor_of_middle(const Ball& x)
{
    fmpz_t whole;
    fmpz_init(whole);
    arf_get_fmpz(whole, arb_midref(x.get()), ARF_RND_FLOOR);
    Integer r;
    fmpz_get_mpz(r.get_mpz_t(), whole);
    fmpz_clear(whole);
    return r;
}

} // namespace touchstone
