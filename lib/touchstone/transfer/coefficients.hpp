// SPDX-License-Identifier: MIT
/// \file
/// From values at Chebyshev points to coefficients of the polynomial through them, C_kj = (2 - [k = 0]) T_k(tau_j)/p
/// with tau_j = cos((2j + 1) pi/2p): applied to fixed-point values, and from the right to a row of moments. Internal to transfer/.
#pragma once

#include "touchstone/transfer/fixed.hpp"
#include "touchstone/transfer/wave_kernel.hpp"

#include <vector>

namespace touchstone::transfer {

class Coefficients {
public:
    Coefficients() : format_(0) {}
    /// To p <= 4000 terms, at the thread's precision: some bits more than the format's.
    Coefficients(const FixedFormat&, long p);

    /// coefficients = C values, p numbers each, |values| < 2^13. Off by less than (2 p max|values| + 1) u: cosines by less than 2 u, and
    /// the sum is rounded down.
    void of(const mp_limb_t* values, mp_limb_t* coefficients) const;
    /// near = moments C, p numbers each. \returns by how much they are off beyond 2^-52 of themselves: row_error(the largest |moment|)
    double row(const mp_limb_t* moments, double* near) const;
    /// Moments are taken by three words from the highest that any of them has, off by less than 2^-100 of themselves, 2^-126 of the largest
    /// and a unit, or 2^-736 where a unit is less than that: it covers what binary64 loses of numbers below 2^-1022. Sums of p products in
    /// 106 bits are off by (p^2/2 + 5 p + 10) 2^-106 < 2^-83 of the sum of moduli (wave_kernel.cpp), which is at most 2 most, for |C_kj| <=
    /// 2/p; all other roundings are less.
    double row_error(double most) const;

private:
    FixedFormat format_;
    std::size_t terms_ = 0, columns_ = 0; ///< p, and what makes it a multiple of four
    std::vector<mp_limb_t> cosines_;      ///< 2 cos(pi m/2p)/p, m < 4p
    Wide near_;                           ///< C_kj, [k columns_ + j]
};

} // namespace touchstone::transfer
