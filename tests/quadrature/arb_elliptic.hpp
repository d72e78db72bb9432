// SPDX-License-Identifier: MIT
/// \file
/// K and E by Arb, which the library does not ask for them.
#pragma once

#include "touchstone/scalar/ball.hpp"

#if __has_include(<flint/acb_elliptic.h>)
#include <flint/acb_elliptic.h>
#else
#include <acb_elliptic.h>
#endif

inline touchstone::ComplexBall elliptic_k(const touchstone::ComplexBall& m, slong bits)
{
    touchstone::ComplexBall w;
    acb_elliptic_k(w.get(), m.get(), bits);
    return w;
}
inline touchstone::ComplexBall elliptic_e(const touchstone::ComplexBall& m, slong bits)
{
    touchstone::ComplexBall w;
    acb_elliptic_e(w.get(), m.get(), bits);
    return w;
}
