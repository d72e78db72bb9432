// SPDX-License-Identifier: MIT
/// \file
/// Chebyshev series in binary64, for searches: nothing proven rests on them (internal to limit/).
#pragma once

#include <cstddef>

namespace touchstone::limit {

/// The sum of coefficients[k] T_k(t), k < terms, by Clenshaw's recurrence; terms >= 1.
inline double chebyshev_sum(const double* coefficients, std::size_t terms, double t)
{
    double before = 0, now = 0;
    for (std::size_t k = terms - 1; k > 0; --k) {
        const double next = 2 * t * now - before + coefficients[k];
        before = now;
        now = next;
    }
    return t * now - before + coefficients[0];
}

} // namespace touchstone::limit
