// SPDX-License-Identifier: MIT
/// \file
/// Functions of endpoint numbers beyond those of endpoint_number.hpp: what they are where a logarithmic variable goes to infinity.
///
/// On a piece of the strip that reaches an end, x = -log r and the like are rho c, rho = |Re w| >= A > 0 (tanh_sinh.md, section 2). There
///
///     |exp(kappa rho)| = |r|^-kappa |1 + E|^-kappa,    |1 + E|^-kappa <= (1 - exp(-A))^-|kappa|,
///
/// so exp(rho c) is r^-kappa times a bounded factor with kappa >= Re c; exp(rho^k c), k > 1, needs Re c < 0 and is smaller than r^K with
/// K = |Re c| A^(k-1); |cos z|, |sin z| <= exp(|Im z|).
#pragma once

#include "touchstone/quadrature/endpoint_number.hpp"
#include "touchstone/quadrature/special.hpp"

namespace touchstone::quadrature {

/// op of an endpoint number.
EndpointNumber<Ball> function_of(Op op, const EndpointNumber<Ball>& x);
EndpointNumber<ComplexBall> function_of(Op op, const EndpointNumber<ComplexBall>& x);
/// bessel*(order, x), polylog(order, x).
EndpointNumber<Ball> function_of(Op op, const Ball& order, const EndpointNumber<Ball>& x);
EndpointNumber<ComplexBall> function_of(Op op, const Ball& order, const EndpointNumber<ComplexBall>& x);

} // namespace touchstone::quadrature
