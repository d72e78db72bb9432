// SPDX-License-Identifier: MIT
#include "touchstone/wave/lemmas.hpp"

namespace touchstone::wave {

std::vector<Ball> size(const Ball& G, long levels)
{
    using Traits = ScalarTraits<Ball>;
    std::vector<Ball> c{Ball(1)};
    for (long m = 0; m < levels; ++m) {
        const Ball a = Traits::power_of_two(-m - 1);
        c.push_back(c.back() * pow(G / 2, a) * 2 * Traits::gamma(Traits::quotient(3, 2) - a)
                    / (sqrt(Traits::pi()) * Traits::gamma(2 - a)));
    }
    return c;
}

} // namespace touchstone::wave
