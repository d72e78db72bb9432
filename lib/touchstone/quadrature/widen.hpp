// SPDX-License-Identifier: MIT
/// \file
/// Balls and boxes made wider by a bound. Internal to quadrature/.
#pragma once

#include "touchstone/scalar/ball.hpp"

namespace touchstone::quadrature {

/// x +- by
inline void widen(Ball& x, const Ball& by)
{
    mag_t m;
    mag_init(m);
    arb_get_mag(m, by.get());
    arb_add_error_mag(x.get(), m);
    mag_clear(m);
}

/// The square about z of that half side.
inline void widen(ComplexBall& z, const Ball& by)
{
    mag_t m;
    mag_init(m);
    arb_get_mag(m, by.get());
    acb_add_error_mag(z.get(), m);
    mag_clear(m);
}

/// It contains |z| <= radius.
inline ComplexBall disc(const Ball& radius)
{
    ComplexBall z;
    widen(z, radius);
    return z;
}

} // namespace touchstone::quadrature
