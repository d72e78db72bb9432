// SPDX-License-Identifier: MIT
/// \file
/// Balls and boxes made wider by a bound. Internal to quadrature/.
#pragma once

#include "touchstone/scalar/ball.hpp"

#include <concepts>

namespace touchstone::quadrature {

/// The ball x +- by; of a complex x, the square of that half side.
template <class V>
void widen(V& x, const Ball& by)
{
    mag_t m;
    mag_init(m);
    arb_get_mag(m, by.get());
    if constexpr (std::same_as<V, ComplexBall>)
        acb_add_error_mag(x.get(), m);
    else
        arb_add_error_mag(x.get(), m);
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
