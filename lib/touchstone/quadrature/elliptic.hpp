// SPDX-License-Identifier: MIT
/// \file
/// The complete elliptic integrals K(m), E(m) by the arithmetic-geometric mean (internal to quadrature/).
#pragma once

#include "touchstone/scalar/ball.hpp"

namespace touchstone::quadrature {

template <class V>
struct Elliptic {
    V k, e;
};

/// K and E of m = 1 - v, principal: v off the cut (-oo, 0], else indeterminate. (tanh_sinh.md, section 18)
Elliptic<Ball> elliptic_of_complement(const Ball& v);
Elliptic<ComplexBall> elliptic_of_complement(const ComplexBall& v);
/// K alone, of a number by Arb's mean at half the cost.
Ball first_kind_of_complement(const Ball& v);
ComplexBall first_kind_of_complement(const ComplexBall& v);

} // namespace touchstone::quadrature
