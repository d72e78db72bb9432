// SPDX-License-Identifier: MIT
/// \file
/// Upper bounds of balls, and what is told of them. Internal to quadrature/.
#pragma once

#include "touchstone/scalar/ball.hpp"

#include <cmath>
#include <limits>
#include <string>

namespace touchstone::quadrature {

namespace detail {
/// What `get` sets a magnitude to, of x, as an exact number.
template <class X>
Ball magnitude(void (*get)(mag_t, const X*), const X* x)
{
    mag_t m;
    mag_init(m);
    get(m, x);
    Ball r;
    arf_set_mag(arb_midref(r.get()), m);
    mag_clear(m);
    return r;
}
} // namespace detail

/// An upper bound of |x|, exact.
inline Ball upper_ball(const Ball& x)
{
    return detail::magnitude<arb_struct>([](mag_t m, const arb_struct* b) { arb_get_mag(m, b); }, x.get());
}
inline Ball upper_ball(const ComplexBall& z)
{
    return detail::magnitude<acb_struct>([](mag_t m, const acb_struct* b) { acb_get_mag(m, b); }, z.get());
}

/// The same as a number, infinite where it is none.
inline double upper(const Ball& x)
{
    mag_t m;
    mag_init(m);
    arb_get_mag(m, x.get());
    const double d = mag_get_d(m);
    mag_clear(m);
    return d;
}
inline double upper(const ComplexBall& z)
{
    mag_t m;
    mag_init(m);
    acb_get_mag(m, z.get());
    const double d = mag_get_d(m);
    mag_clear(m);
    return d;
}

/// log2 of an upper bound of |x|, which may be far outside the range of double.
inline double log2_upper(const Ball& x)
{
    mag_t m;
    mag_init(m);
    arb_get_mag(m, x.get());
    const double d = mag_is_inf(m) ? std::numeric_limits<double>::infinity() : mag_is_zero(m) ? -1e18 : mag_get_d_log2_approx(m);
    mag_clear(m);
    return d;
}

inline Ball radius_of(const Ball& x)
{
    Ball r;
    arf_set_mag(arb_midref(r.get()), arb_radref(x.get()));
    return r;
}
/// |s - m| is at most that for s in the ball, m its middle.
inline Ball radius_of(const ComplexBall& z) { return radius_of(z.real()) + radius_of(z.imag()); }

/// An upper bound as a short decimal, rounded up: "1.3e-105".
std::string bound_text(const Ball& x);

} // namespace touchstone::quadrature
