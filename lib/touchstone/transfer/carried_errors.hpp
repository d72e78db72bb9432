// SPDX-License-Identifier: MIT
/// \file
/// How large the errors of a level's nodal values become over many levels, in binary64, rounded up. Internal to transfer/.
///
/// e_{m+1} = B e_m + a_{m+1} with |a_m| <= alpha, so e_n is a sum of n + 1 terms B^j a. Let W(k) bound |sum of k such terms|, in every
/// component: W(1) = alpha and W(k + p) = |B^p| W(k) + W(p), for the largest power of two p that |B^p| has been made for. |B| alone has a
/// spectral radius of 1.05 to 2 and more, for large G; high powers come down to |rank one|. No stability theory is used: the |B^p| and
/// the W(k) are computed.
///
/// Sums are of at most 4000 products: they lose less than 2^-40 of the sum of moduli, for which there is a factor, and less than 2^-1062
/// where products are below 2^-1022, which is covered since bounds of |B|^p are at least 2^-400 and those of errors at least 2^-900.
#pragma once

#include <cstddef>
#include <vector>

namespace touchstone::transfer {

/// At least |x|, for every x that is off from `near` by no more than 2^-52 of itself and `off`.
std::vector<double> moduli(const std::vector<double>& near, double off);

class CarriedErrors {
public:
    /// The next row of B: off from `near` by no more than 2^-52 of itself and `off`.
    void add_row(const std::vector<double>& near, double off);
    /// After all rows: what one level adds.
    void begin(std::vector<double> alpha);
    /// W(level + 1), what the values of this level may be off by.
    const std::vector<double>& at(std::size_t level);
    /// What a row of such moduli makes of the errors of a level.
    double into(const std::vector<double>& row, std::size_t level);
    /// From |B^p| to |B^2p|.
    void square();
    /// At least |B^(2^r)|, the last r.
    const std::vector<double>& last_power() const { return powers_.back(); }
    /// Bytes held.
    std::size_t memory() const;

private:
    std::vector<std::vector<double>> powers_; ///< at least |B^(2^r)|; r > 0 made when needed
    std::vector<double> near_;                ///< the last power itself, to a relative off_ of majorant_
    std::vector<double> majorant_;            ///< at least |B|^(2^r)
    double off_ = 0x1p-50;
    std::vector<std::vector<double>> errors_; ///< W(k + 1)
};

} // namespace touchstone::transfer
