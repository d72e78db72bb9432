// SPDX-License-Identifier: MIT
#include "touchstone/rounding/ulp.hpp"

#include <doctest/doctest.h>

using namespace touchstone;

TEST_CASE("ulps of a value")
{
    CHECK(ulp_at(Rational(1)) == exact_rational(0x1p-52));
    CHECK(ulp_at(Rational(1) - exact_rational(0x1p-60)) == exact_rational(0x1p-53)); // just below a power of two
    CHECK(ulp_at(exact_rational(0x1p-1022)) == exact_rational(0x1p-1074));
    CHECK(ulp_at(exact_rational(0x1p-1030)) == exact_rational(0x1p-1074));
    CHECK(ulp_at(*parse_rational("1e400")) == exact_rational(0x1p971));
    CHECK(ulp_at(Rational(7, 3)) == exact_rational(0x1p-51));
    CHECK(ulp_at(Rational(-3)) == exact_rational(0x1p-51));
}
