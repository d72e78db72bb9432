// SPDX-License-Identifier: MIT
/// \file
/// Special functions where they have a logarithm or a branch point, on numbers that vanish at an end: K(1 - u), E(1 - u) for u -> 0, and
/// Bessel functions at 0. Near 0 each is analytic functions times log u and powers of u, so what the end does shows; farther away it is the
/// principal one, where the logarithm that is continued along the strip is principal too. (tanh_sinh.md, section 18)
#pragma once

#include "touchstone/quadrature/endpoint_number.hpp"
#include "touchstone/quadrature/expression.hpp"

#include <optional>

namespace touchstone::quadrature {

/// K(1 - u) = -(1/pi) K(u) (log u - log 16) - S(u), and what E(1 - u) takes besides (tanh_sinh.md, section 18).
struct EllipticAboutOne {
    ComplexBall k;       ///< K(u)
    ComplexBall rest;    ///< S(u)
    ComplexBall regular; ///< (K(u) - E(u))/u, or nothing where E is not asked for
};

/// On abs(u) <= q < 1, q > 0: discs about what they are at 0, as large as at q. The coefficients of these series are not negative.
EllipticAboutOne about_one_by_size(const Ball& q, bool of_k);

/// ellipk(1 - u), ellipe(1 - u).
EndpointNumber<Ball> elliptic_of_complement(Op, const EndpointNumber<Ball>& u);
EndpointNumber<ComplexBall> elliptic_of_complement(Op, const EndpointNumber<ComplexBall>& u);

/// bessely and besselk of integer order (0 to 8), besselj and besseli of half odd order; nothing for others, or where x does not vanish.
std::optional<EndpointNumber<Ball>> bessel_about_zero(Op, const Ball& order, const EndpointNumber<Ball>& x);
std::optional<EndpointNumber<ComplexBall>> bessel_about_zero(Op, const Ball& order, const EndpointNumber<ComplexBall>& x);

} // namespace touchstone::quadrature
