// SPDX-License-Identifier: MIT
#include "touchstone/rounding/ulp.hpp"

#include <algorithm>
#include <limits>

namespace touchstone {

Rational ulp_at(const Rational& value)
{
    const Rational a = abs(value);
    if (a < exact_rational(std::numeric_limits<double>::min())) return exact_rational(std::numeric_limits<double>::denorm_min());
    long e = static_cast<long>(mpz_sizeinbase(a.get_num_mpz_t(), 2)) - static_cast<long>(mpz_sizeinbase(a.get_den_mpz_t(), 2));
    while (power(Rational(2), e) > a) --e;
    return power(Rational(2), std::min(e, 1023L) - 52);
}

} // namespace touchstone
