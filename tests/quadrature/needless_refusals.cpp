// SPDX-License-Identifier: MIT
// What was once refused, or took a minute, for no good reason: each against a value that was had in another way (mpmath, 50 digits).
#include "touchstone/quadrature/integrate.hpp"

#include <doctest/doctest.h>

using namespace touchstone;
using namespace touchstone::quadrature;

namespace {

Integral over(const char* formula, const char* from, const char* to, long digits = 15)
{
    IntegralOptions options;
    options.digits = digits;
    return integrate(parse_expression(formula), parse_limit(from), parse_limit(to), options);
}

/// Certified, and within 1e-20 (relative) of a value whose decimals are right that far.
Integral check(const char* formula, const char* from, const char* to, const char* decimals)
{
    const Integral found = over(formula, from, to);
    CAPTURE(std::string(formula));
    INFO(found.reason);
    CHECK(found.status == Status::certified);
    const WorkingPrecision precision(256);
    const Ball known = parse_limit(decimals).ball();
    Ball about = known;
    const Ball slack = abs(known) * pow(Ball(10), Ball(-20));
    arb_add_error(about.get(), slack.get());
    CHECK(found.value.overlaps(about));
    return found;
}

} // namespace

TEST_CASE("a range is cut at a simple fraction of it where the formula is singular there, whatever the scale of x")
{
    const Integral scaled = over("(7*x)^(-2/3)*ellipe(28*x*(1-7*x))^(1/3)", "0", "1/7");
    const Integral plain = over("x^(-2/3)*ellipe(4*x*(1-x))^(1/3)", "0", "1");
    CHECK(scaled.status == Status::certified);
    CHECK(scaled.parts.size() == 2);
    CHECK((7 * scaled.value).overlaps(plain.value));
    // the singular point is where a bisection cuts: what a part says of its end is not said of the range's
    const Integral shifted =
        check("log(ellipk(2*(1000*(x-1000))/(1+(1000*(x-1000))^2)))", "1000", "1000.002", "0.00195614843293699883253661681877");
    CHECK(shifted.parts.size() == 2);
}
