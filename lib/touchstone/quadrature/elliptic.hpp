// SPDX-License-Identifier: MIT
/// \file
/// The complete elliptic integrals K(m), E(m) by the arithmetic-geometric mean (internal to quadrature/).
#pragma once

#include "touchstone/scalar/ball.hpp"

namespace touchstone::quadrature {

/// K and E, or both over pi, as whoever gives them says.
template <class V>
struct Elliptic {
    V k, e;
};

/// K and E of m = 1 - v, principal: v off the cut (-oo, 0], else indeterminate. (tanh_sinh.md, section 18)
Elliptic<Ball> elliptic_of_complement(const Ball& v);
Elliptic<ComplexBall> elliptic_of_complement(const ComplexBall& v);
/// K alone.
Ball first_kind_of_complement(const Ball& v);
ComplexBall first_kind_of_complement(const ComplexBall& v);
/// K/pi and, where it is asked for, E/pi, which the means give.
Elliptic<Ball> elliptic_over_pi(const Ball& v, bool with_e);
Elliptic<ComplexBall> elliptic_over_pi(const ComplexBall& v, bool with_e);

/// Whether a ball in abs(u) < 31/32 is so wide that what its size says of K(u), E(u) and their like is as good as means and series.
bool is_known_by_size(const ComplexBall& u);

} // namespace touchstone::quadrature
