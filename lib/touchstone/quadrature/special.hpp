// SPDX-License-Identifier: MIT
/// \file
/// The functions a formula may name, on balls: non-finite unless analytic on the whole of the argument.
///
/// Cuts: (-oo, 0] for log, lgamma, ci, bessely, besselk and Bessel functions of other than integer order; (-oo, 1] for li; [1, oo) for
/// dilog, polylog, ellipk and ellipe (of the parameter m = k^2); (-oo, -1/e] for lambertw; (-oo, -1] and [1, oo) for asin, acos, atanh;
/// (-oo, 1] for acosh; i[1, oo) and -i[1, oo) for atan, asinh. Ei is the real function on either half line: each half plane has its own
/// continuation.
#pragma once

#include "touchstone/quadrature/expression.hpp"
#include "touchstone/scalar/ball.hpp"

#include <vector>

namespace touchstone::quadrature {

ComplexBall special_function(Op, const ComplexBall& z);
Ball special_function(Op, const Ball& x);
/// bessel*(order, z) and polylog(s, z).
ComplexBall special_function(Op, const Ball& order, const ComplexBall& z);
Ball special_function(Op, const Ball& order, const Ball& x);
/// K_n over the ball by its asymptotic form, whose enclosure is not much wider than the function varies.
ComplexBall bessel_k_by_its_size(const Ball& order, const ComplexBall& z);

} // namespace touchstone::quadrature
