// SPDX-License-Identifier: MIT
/// \file
/// What the quadrature tests share: asking for digits, and what counts as right.
#pragma once

#include "touchstone/quadrature/tanh_sinh.hpp"

#include <doctest/doctest.h>

namespace touchstone::quadrature::testing {

/// Decimal digits that the ball proves, relative to its midpoint.
inline double proven_digits(const Ball& x) { return static_cast<double>(x.relative_bits()) * 0.30103; }

/// Certified, contains `truth` (evaluated with bits to spare), and tight: N - 3 digits when N are asked.
template <class F, class Truth>
Enclosure check_integral(const F& f, const Interval& interval, long digits, const Truth& truth)
{
    Options options;
    options.digits = digits;
    const Enclosure result = tanh_sinh(f, interval, options);
    INFO("interval " << interval.to_string() << ", digits " << digits << ": " << result.reason << " " << result.certificate.to_json());
    CHECK(result.status == Status::certified);
    const WorkingPrecision precision(bits_for_digits(digits) + 160);
    const Ball exact = truth();
    CHECK(exact.relative_bits() > bits_for_digits(digits));
    CHECK_MESSAGE(result.value.overlaps(exact), result.value.to_string(digits + 5) << " against " << exact.to_string(digits + 5));
    CHECK(proven_digits(result.value) >= static_cast<double>(digits) - 3);
    return result;
}

template <class F>
Enclosure check_refused(const F& f, const Interval& interval, const Options& options = {})
{
    const Enclosure result = tanh_sinh(f, interval, options);
    INFO(result.value.to_string());
    CHECK(result.status == Status::indeterminate);
    CHECK_FALSE(result.value.is_finite());
    CHECK_FALSE(result.reason.empty());
    return result;
}

} // namespace touchstone::quadrature::testing
