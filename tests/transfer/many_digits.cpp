// SPDX-License-Identifier: MIT
#include "touchstone/catalogue/evaluate.hpp"

#include <doctest/doctest.h>

using namespace touchstone;

namespace {

Rational exactly(const char* text) { return *parse_rational(text); }

Evaluation eval(const char* name, std::map<std::string, Rational> in, long digits)
{
    return evaluate(*find_quantity(name), Inputs(std::move(in)), {.digits = digits});
}

} // namespace

TEST_CASE("50 digits at n = 100 next to G = 2, 100 digits at n = 20")
{
    CHECK(eval("contact.area", {{"n", 100}, {"load", exactly("1e-12")}, {"G", exactly("2.05")}}, 50).status == Status::certified);
    CHECK(eval("contact.area", {{"n", 20}, {"load", 1}, {"G", 4}}, 100).status == Status::certified);
}
