// SPDX-License-Identifier: MIT
/// \file
/// Gauss-Legendre rules on [0, 1] and the Legendre series on them, rounded from Arb's.
#pragma once

#include <vector>

namespace touchstone::transfer {

template <class Real>
struct GaussRule {
    std::vector<Real> nodes, weights;    ///< on [0, 1]
    std::vector<Real> to_coefficients;   ///< row k: the coefficient of P_k(2t - 1) from the values at the nodes
    std::vector<Real> lower, upper;      ///< [j + n i] = l_j at the i-th node of [0, 1/2], [1/2, 1]
};

/// The n-point rule; made once, kept. Thread-safe.
template <class Real>
const GaussRule<Real>& gauss_rule(int n);

} // namespace touchstone::transfer
