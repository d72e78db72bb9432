// SPDX-License-Identifier: MIT
#include "touchstone/oracle/printed.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace touchstone::oracle {
namespace {

constexpr long first_digits = 6, most_digits = 2000; ///< asked of the true value
constexpr long spare_digits = 4;                     ///< beyond the last place printed, at first

/// A printed number: its value, and the place of its last digit, 10^place.
struct Printed {
    Rational value;
    long place = 0;
    bool scientific = false;
};

Printed read(std::string_view text)
{
    const auto value = parse_rational(text);
    if (!value || !is_printed_decimal(text))
        throw DomainError(fmt::format("'{:.60}' is not a decimal number as it may be printed, such as 0.416550 or 4.1655e-1", text));
    const std::size_t mantissa_end = std::min(text.find_first_of("eE"), text.size());
    const auto point = text.substr(0, mantissa_end).find('.');
    const long after_point = point == std::string_view::npos ? 0 : static_cast<long>(mantissa_end - point - 1);
    const long exponent = mantissa_end < text.size() ? std::stol(std::string(text.substr(mantissa_end + 1))) : 0;
    return {*value, exponent - after_point, mantissa_end < text.size()};
}

/// Units of 10^place below x: towards minus infinity.
Integer units_below(const Rational& x, const Rational& unit)
{
    Integer whole;
    const Rational scaled = x / unit;
    mpz_fdiv_q(whole.get_mpz_t(), scaled.get_num_mpz_t(), scaled.get_den_mpz_t());
    return whole;
}
Integer units_nearest(const Rational& x, const Rational& unit) { return units_below(Rational(x + unit / 2), unit); }
Integer units_cut(const Rational& x, const Rational& unit)
{
    return x < 0 ? Integer(-units_below(Rational(-x), unit)) : units_below(x, unit);
}

/// units 10^place with its zeros, in the style of what was printed.
std::string shown(const Integer& units, const Printed& like)
{
    std::string digits = Integer(abs(units)).get_str();
    const std::string sign = units < 0 ? "-" : "";
    if (like.scientific) {
        const long exponent = like.place + static_cast<long>(digits.size()) - 1;
        return fmt::format("{}{}{}{}e{:+03d}", sign, digits[0], digits.size() > 1 ? "." : "", digits.substr(1), exponent);
    }
    if (like.place >= 0) return sign + (units == 0 ? "0" : digits + std::string(static_cast<std::size_t>(like.place), '0'));
    const auto decimals = static_cast<std::size_t>(-like.place);
    if (digits.size() <= decimals) digits.insert(0, decimals + 1 - digits.size(), '0');
    return sign + digits.substr(0, digits.size() - decimals) + "." + digits.substr(digits.size() - decimals);
}

PrintedVerdict judge(const Printed& p, const Rational& low, const Rational& high, const Rational& unit, const Integer& right)
{
    const Integer printed = units_nearest(p.value, unit); // exact: the value is a whole number of units
    if (abs(Rational(low - p.value)) * 2 <= unit && abs(Rational(high - p.value)) * 2 <= unit) return PrintedVerdict::rounded;
    if (units_cut(low, unit) == printed && units_cut(high, unit) == printed) return PrintedVerdict::cut_off;
    return abs(Integer(right - printed)) == 1 ? PrintedVerdict::one_unit_off : PrintedVerdict::wrong;
}

} // namespace

std::string_view to_string(PrintedVerdict v)
{
    switch (v) {
    case PrintedVerdict::rounded: return "right as rounded";
    case PrintedVerdict::cut_off: return "right as cut off";
    case PrintedVerdict::one_unit_off: return "one unit off";
    case PrintedVerdict::wrong: return "wrong";
    case PrintedVerdict::undecided: break;
    }
    return "undecided";
}

bool is_printed_decimal(std::string_view text)
{
    return text.find_first_of("/xX") == std::string_view::npos && parse_rational(text).has_value();
}

PrintedEntry check_printed(const Quantity& q, const Inputs& in, std::string_view text)
{
    const Printed p = read(text);
    const Rational unit = power(Rational(10), p.place);
    PrintedEntry entry;
    bool is_looked_at = false; // the last place printed, at all
    for (long digits = first_digits, spare = spare_digits; digits <= most_digits; spare *= 4) {
        const Evaluation e = evaluate(q, in, {.digits = digits});
        const auto value = parse_rational(e.value), error = parse_rational(e.error_bound);
        if (!value || !error || (e.status != Status::exact && e.status != Status::certified)) {
            entry.note = e.status == Status::estimated ? fmt::format("the value is only estimated, {}", e.value) : e.note;
            return entry;
        }
        const Rational low = *value - *error, high = *value + *error;
        const Integer right = units_nearest(low, unit);
        const bool decided = *error == 0 || (right == units_nearest(high, unit) && units_cut(low, unit) == units_cut(high, unit));
        if (decided) {
            entry.verdict = judge(p, low, high, unit, right);
            entry.right = shown(right, p);
            return entry;
        }
        // as many digits as lead to the last place printed, and some more each time
        const long magnitude =
            static_cast<long>(mpz_sizeinbase(value->get_num_mpz_t(), 10)) - static_cast<long>(mpz_sizeinbase(value->get_den_mpz_t(), 10));
        is_looked_at = is_looked_at || digits > magnitude - p.place + 1;
        digits = std::max(digits + 1, magnitude - p.place + 1 + spare);
    }
    entry.note = is_looked_at
                     ? fmt::format("not decided with {} digits: the true value is next to a place where roundings change", most_digits)
                     : fmt::format("more places are printed than the {} that are looked at", most_digits);
    return entry;
}

} // namespace touchstone::oracle
