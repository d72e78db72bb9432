// SPDX-License-Identifier: MIT
/// \file
/// A_2/lambda_0 = (T (T B_0))(load) in binary64, by tanh-sinh quadrature within tanh-sinh quadrature: a look at the certified value that
/// shares neither formula nor code with it. Nothing is proved.
///
/// B_0 = (6.6); T as an average over the wave's angle: (T f)(x) = (1/pi) int_0^pi f((x + cos t)/G) dt for x >= 1, and (2/pi) x^(1/2)
/// int_0^(pi/2) f(y(t)) cos t/(1 - x sin^2 t)^(1/2) dt, y = (2/G) (x (1 - x sin^2 t))^(1/2) cos t, for x < 1; both cut where y passes a
/// singular point of f. Errors: about 1e-10, estimated. Cost: milliseconds.
///
/// Internal to recursion/.
#pragma once

#include <utility>

namespace touchstone::transfer {

/// The value, and how far off it may be. load > 0, G > 1
std::pair<double, double> nested_area(double load, double G);

} // namespace touchstone::transfer
