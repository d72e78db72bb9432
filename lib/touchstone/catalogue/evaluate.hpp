// SPDX-License-Identifier: MIT
/// \file
/// The one door to printed values: a quantity, correctly rounded to the digits asked for.
#pragma once

#include "touchstone/catalogue/quantity.hpp"
#include "touchstone/rounding/decimal.hpp"

namespace touchstone {

enum class Status { exact, certified, estimated, undecided };
std::string_view to_string(Status);

struct EvaluationOptions {
    long digits = 20;            ///< 1 to 10 000
    slong start_bits = 0;        ///< first precision tried, limit_bits at most; 0: from the digits. Does not change the result.
    slong limit_bits = 0;        ///< no precision above this is tried; 0: 16 times the first plus 8192
};

struct Evaluation {
    std::string value;                 ///< correctly rounded decimal, or what could be had
    std::string error_bound;           ///< proven bound of |value - true value|; `estimated`: the same half unit, not proven
    long digits = 0;                   ///< significant digits in `value`
    Status status = Status::undecided;
    std::optional<double> binary64;    ///< nearest double to the true value, if decided
    std::vector<std::string> routes;
    Ball ball;                         ///< encloses the true value; `estimated`: believed to
    slong bits = 0;                    ///< working precision at which it was decided
    std::string note;                  ///< why undecided, or why only estimated; else empty
};

/// Two routes of a certified value gave disjoint balls: a bug here, never a result.
class RoutesDisagree : public std::logic_error {
    using std::logic_error::logic_error;
};

/// No more digits than this are ever given as `estimated`.
constexpr long most_estimated_digits = 15;

/// The true value rounded to nearest at `digits` significant digits. Precision is raised until
/// every route's ball rounds to the same digits (a ball of radius zero is the value itself, which the other routes' balls must contain). Exact rational values (and so all ties this
/// toolkit can recognise) are rounded exactly, ties to even.
/// Where the certified routes refuse (BeyondReach) and the quantity has `estimates`, the value is `estimated`: the hull of all
/// of them, each widened by 8 times the larger of their difference and their own errors, rounds to the digits asked for,
/// or, next to a tie of the last one, to one fewer.
/// If it does not, or more than `most_estimated_digits` are asked for, those that it decides are given, `undecided`.
/// \throws DomainError, RoutesDisagree
Evaluation evaluate(const Quantity&, const Inputs&, const EvaluationOptions& = {});

} // namespace touchstone
