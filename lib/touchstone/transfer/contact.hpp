// SPDX-License-Identifier: MIT
/// \file
/// Contact area of the recursion (6.1)-(6.7) while every scale is in partial contact: G = gamma^(D-1) > 2, load <= 1.
/// (For load > 1 see heavy_load.hpp.)
///
/// A_n/lambda_0 = B_n(load) = load^(1/2) F_n(load)/G^n (chain.hpp). It depends on D and gamma through G alone.
/// Two certified routes, the two schemes of discretisation.hpp. The discretisation of a G is kept for later calls
/// (most recently used first, at most about 300 MB), so that further scales and loads cost little.
#pragma once

#include "touchstone/scalar/accuracy.hpp"
#include "touchstone/transfer/discretisation.hpp"

namespace touchstone::transfer {

/// What a computation asks for, as functions evaluated at whatever precision it turns out to need.
struct Arguments {
    std::function<Ball()> load;
    std::function<Ball()> G;
};

/// (6.7)  A_n/lambda_0, n >= 0.
/// \throws BeyondReach unless 0 < load <= 1 and G > 2 are proven, or for more than most_digits_of_area()
Ball area(Scheme, long n, const Arguments&, Accuracy);

/// How the error of `area` is made up, level by level.
std::string area_certificate(Scheme, long n, const Arguments&, Accuracy);

/// The most digits for which neither scheme would need too many nodes: fewer next to G = 2, and where the load is tiny.
long most_digits_of_area(const Ball& load, const Ball& G);

} // namespace touchstone::transfer
