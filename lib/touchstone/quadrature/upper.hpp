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
inline void get_magnitude(mag_t m, const Ball& x) { arb_get_mag(m, x.get()); }
inline void get_magnitude(mag_t m, const ComplexBall& z) { acb_get_mag(m, z.get()); }

/// What `use` makes of the upper bound of |x|.
template <class X, class Use>
auto of_magnitude(const X& x, const Use& use)
{
    mag_t m;
    mag_init(m);
    get_magnitude(m, x);
    auto r = use(m);
    mag_clear(m);
    return r;
}
inline Ball as_ball(const mag_t m)
{
    Ball r;
    arf_set_mag(arb_midref(r.get()), m);
    return r;
}
inline double log2_of(const mag_t m)
{
    return mag_is_inf(m) ? std::numeric_limits<double>::infinity() : mag_is_zero(m) ? -1e18 : mag_get_d_log2_approx(m);
}
} // namespace detail

/// An upper bound of |x|, exact.
inline Ball upper_ball(const Ball& x) { return detail::of_magnitude(x, detail::as_ball); }
inline Ball upper_ball(const ComplexBall& z) { return detail::of_magnitude(z, detail::as_ball); }

/// The same as a number, infinite where it is none.
inline double upper(const Ball& x) { return detail::of_magnitude(x, mag_get_d); }
inline double upper(const ComplexBall& z) { return detail::of_magnitude(z, mag_get_d); }

/// log2 of an upper bound of |x|, which may be far outside the range of double.
inline double log2_upper(const Ball& x) { return detail::of_magnitude(x, detail::log2_of); }

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
