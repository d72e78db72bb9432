// SPDX-License-Identifier: MIT
/// \file
/// Sums of W_q T_k(tau_q) in fixed-point numbers, each term with the words that it needs. Internal to transfer/.
///
/// V_0 = W, V_1 = tau W, V_{k+1} = 2 tau V_k - V_{k-1}. A moment of order k only meets a coefficient below a multiple of rho^-k, so it is
/// summed in units u rho^k at most, words below that let go. In units of the lowest word kept a step is off by less than 2: the product by
/// 1, and by hardly more than 1/2 since of tau only as many words are taken as V has. What is let go before it, less than a unit of V_k and
/// of V_{k-1} each, moves V_{k+m} by less than |U_m| + |U_{m-1}| <= 2 m + 1 units, U_m(tau) being Chebyshev's polynomials of the second
/// kind. Each step is worth less than 5 m units of V_{k+m}, the first 2 m, and order k is off by less than 3 k^2 units, apart from what W
/// and tau as rounded are off by.
#pragma once

#include "touchstone/transfer/fixed.hpp"

#include <cstddef>
#include <vector>

namespace touchstone::transfer {

/// How many of its lowest words a moment of order k < points can do without: 2^(64 words) <= rho^k.
std::vector<std::size_t> words_to_spare(double rho, long points);

class Moments {
public:
    explicit Moments(const FixedFormat& format);
    /// Adds W T_k(tau) to sum[k limbs], k below the number of `spare`. W >= 0, |tau| <= 1; midpoints are taken, rounded down to the format.
    void add(const Ball& weight, const Ball& tau, const std::vector<std::size_t>& spare, mp_limb_t* sum);

    /// How many of `limbs` words, from the lowest, hold a number that is not negative with 18 bits to spare, if that many are there.
    static std::size_t significant(const mp_limb_t* number, std::size_t limbs);
    /// sum += 2^(64 gone) u, in two's complement of `limbs` and `words` words. \pre gone + words <= limbs
    static void add_at(mp_limb_t* sum, std::size_t limbs, const mp_limb_t* u, std::size_t words, std::size_t gone);

private:
    void multiply(mp_limb_t* out, const mp_limb_t* u, std::size_t words, unsigned shift);

    const FixedFormat& format_;
    std::size_t limbs_;
    std::vector<FixedFormat> formats_; ///< of so many words
    std::vector<mp_limb_t> tau_, a_, b_, c_, scratch_;
};

} // namespace touchstone::transfer
