// SPDX-License-Identifier: MIT
/// Full contact at every load and scale of figures 3 and 4, and where the chain stays long in full contact.
#include "touchstone/transfer/full_contact.hpp"

#include <doctest/doctest.h>

using namespace touchstone;
using namespace touchstone::transfer;

TEST_CASE("the two grids agree to 1e-17 up to n = 20")
{
    const WorkingPrecision precision(256);
    for (const char* G : {"1.0838", "1.12", "1.01", "1.9", "2", "2.2360679774997896"})
        for (const char* load : {"1e-12", "0.001", "0.1", "1", "10"})
            for (long n = 1; n <= 20; ++n) {
                CAPTURE(G); CAPTURE(load); CAPTURE(n);
                const Ball x(*parse_rational(load)), g(*parse_rational(G));
                const Ball off = abs(estimated_area(Grid::blind, n, x, g).value / estimated_area(Grid::tracked, n, x, g).value - 1);
                CHECK(certainly(less(off, Ball::exactly(1e-17))));
            }
}
