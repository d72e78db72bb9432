// SPDX-License-Identifier: MIT
#include "touchstone/catalogue/directed.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace touchstone {
namespace {

constexpr long first_extra_digits = 3, most_extra_digits = 200;

bool magnitude_grows(bool negative, Rounding r) { return r == Rounding::away || r == (negative ? Rounding::down : Rounding::up); }

std::string unit(const Decimal& d) { return fmt::format("1e{:+03d}", d.exponent - static_cast<long>(d.digits.size())); }

/// The decimal to which every number between the ends rounds.
std::optional<Decimal> rounded(const Rational& low, const Rational& high, long digits, Rounding r)
{
    if (low <= 0 && high >= 0 && low != high) return std::nullopt;
    const Decimal d = round_to_digits(low, digits, r);
    if (d == round_to_digits(high, digits, r)) return d;
    return std::nullopt;
}

} // namespace

std::optional<Rounding> rounding_named(std::string_view name)
{
    const auto& all = rounding_names();
    const auto at = std::find(all.begin(), all.end(), name);
    if (at == all.end()) return std::nullopt;
    return static_cast<Rounding>(at - all.begin());
}

Decimal round_to_digits(const Rational& r, long digits, Rounding how)
{
    Decimal d = round_to_digits(r, digits);
    if (how == Rounding::nearest || r == 0) return d;
    const Rational off = abs(d.value()) - abs(r); // < 0: the nearest one is nearer to zero
    const bool grow = magnitude_grows(r < 0, how);
    if (off == 0 || (off > 0) == grow) return d;
    Integer units(d.digits, 10);
    if (grow) ++units;
    else --units;
    d.digits = units.get_str();
    const long length = static_cast<long>(d.digits.size());
    const bool is_shorter = length < digits || units == 0; // of one digit: 1 - 1
    if (length > digits) { // 99 + 1
        d.digits.pop_back();
        ++d.exponent;
    }
    else if (is_shorter) { // 100 - 1: the number lies below the power of ten, where units are ten times smaller
        --d.exponent;
        d.digits = std::string(static_cast<std::size_t>(digits), '9');
    }
    return d;
}

Evaluation evaluate(const Quantity& q, const Inputs& in, const EvaluationOptions& options, Rounding how)
{
    if (how == Rounding::nearest) return evaluate(q, in, options);
    Evaluation e = evaluate(q, in, options);
    if (e.status == Status::exact) return e;
    for (long extra = first_extra_digits; extra <= most_extra_digits && options.digits + extra <= any_digits; extra *= 4) {
        EvaluationOptions more = options;
        more.digits += extra;
        const Evaluation finer = evaluate(q, in, more);
        const auto value = parse_rational(finer.value), error = parse_rational(finer.error_bound);
        if (!value || !error || finer.digits < options.digits || (e.proven && !finer.proven)) break;
        if (const auto d = rounded(Rational(*value - *error), Rational(*value + *error), options.digits, how)) {
            e.value = d->text(options.digits);
            e.error_bound = unit(*d);
            if (e.status == Status::undecided) { // to nearest, that is
                e.status = finer.status;
                e.digits = options.digits;
            }
            return e;
        }
        if (finer.status == Status::undecided || finer.digits < more.digits) break;
    }
    e.status = Status::undecided;
    if (!e.note.empty()) e.note += "; ";
    e.note += "which decimal is next in that direction is not decided: shown is the value to nearest";
    return e;
}

} // namespace touchstone
