// SPDX-License-Identifier: MIT
/// \file
/// The one door to printed values: a quantity, correctly rounded to the digits asked for.
#pragma once

#include "touchstone/catalogue/quantity.hpp"
#include "touchstone/rounding/decimal.hpp"

namespace touchstone {
/// What is known of the digits printed: the value itself; proven; two witnesses agree, no proof; fewer than asked for.
enum class Status { exact, certified, estimated, undecided };
std::string_view to_string(Status); ///< its name in lower case
/// How many digits, and with which working precisions they may be looked for.
struct EvaluationOptions {
    long digits = 20;            ///< 1 to 10 000
    slong start_bits = 0;        ///< first precision tried, limit_bits at most; 0: from the digits. Does not change the result.
    slong limit_bits = 0;        ///< no precision above this is tried; 0: 16 times the first plus 8192
};

/// What looked at a proven value beside the proof whose digits are shown.
struct SecondLook {
    std::string name; ///< of the proof or witness
    bool is_proof = false;  ///< else a witness: a value and its own idea of its error, neither proven
    bool agrees = false;    ///< a proof that does not agree throws; a witness that does not is reported
    long digits = 0;        ///< of a proof: that it decides alone; of a witness: to which it agrees
    std::string shares;     ///< what it has in common with the proof, where that is known
};
/// A value as it may be printed, with what is known of it.
struct Evaluation {
    std::string value;                 ///< correctly rounded decimal, or what could be had
    std::string error_bound;           ///< proven bound of |value - true value|; not `proven`: the same half unit, which proves nothing
    long digits = 0;                   ///< significant digits in `value`
    Status status = Status::undecided; ///< what is known of the digits
    bool proven = false;               ///< every digit of `value`; always so if exact or certified
    std::optional<double> binary64;    ///< nearest double to the true value, if every proof that was asked decides it
    std::vector<std::string> routes;   ///< the proofs, and a witness marked as such
    std::optional<SecondLook> second_look; ///< of a proven value
    Ball ball;                         ///< encloses the true value; not `proven`: believed to
    slong bits = 0;                    ///< working precision at which it was decided
    std::string note;                  ///< why undecided, or why only estimated, or that a witness disagrees; else empty
};

/// Two proofs of a value gave disjoint balls: a bug here, never a result.
class RoutesDisagree : public std::logic_error {
    using std::logic_error::logic_error;
};

/// No more digits than this are ever given as `estimated`.
constexpr long most_estimated_digits = 15;

/// The true value rounded to nearest at `digits` significant digits. Accuracy is raised until every proof's ball rounds to the same digits
/// (a ball of radius zero is the value itself, which the other proofs' balls must contain). Exact rational values (and so all ties this
/// toolkit can recognise) are rounded exactly, ties to even.
/// Where there is one proof, a witness is the second look: if it disagrees, that is said, and the proof stands.
/// Where fewer digits are certified than asked for, those are given, `undecided`, with the reason.
/// Where nothing is, and the plan has two witnesses, the value is `estimated`: the hull of all
/// of them, each widened by 8 times the larger of their difference and their own errors, rounds to the digits asked for,
/// or, next to a tie of the last one, to one fewer.
/// If it does not, or more than `most_estimated_digits` are asked for, those that it decides are given, `undecided` and not `proven`.
/// \throws DomainError, RoutesDisagree
Evaluation evaluate(const Quantity&, const Inputs&, const EvaluationOptions& = {});

} // namespace touchstone
