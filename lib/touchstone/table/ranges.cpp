// SPDX-License-Identifier: MIT
#include "touchstone/table/ranges.hpp"

#include "touchstone/rounding/decimal.hpp"

#include <fmt/format.h>

namespace touchstone {
namespace {

constexpr long longest_decimal = 40; ///< digits; beyond, p/q is shorter
constexpr slong bits_between = 256;  ///< for a value between the ends of a log range, until its nearest binary64 number is decided

std::vector<std::string_view> split(std::string_view text, char at)
{
    std::vector<std::string_view> parts;
    for (;;) {
        const auto end = text.find(at);
        parts.push_back(text.substr(0, end));
        if (end == std::string_view::npos) return parts;
        text.remove_prefix(end + 1);
    }
}

Rational number(std::string_view word, std::string_view range)
{
    const auto value = parse_rational(word);
    if (!value) throw DomainError(fmt::format("range '{}': '{}' is not a number such as 12, 0.1, 1e-300, 1/3 or 0x1.8p-3", range, word));
    return *value;
}

} // namespace

std::string exact_text(const Rational& r)
{
    const auto digits = terminating_digits(r);
    if (!digits || *digits > longest_decimal) return r.get_str();
    Decimal d = round_to_digits(r, *digits);
    return d.text(longest_decimal / 2);
}

Range::Range(std::string_view text)
{
    if (text.starts_with("log:")) read_ratios(text);
    else if (text.find(':') != std::string_view::npos) read_steps(text);
    else {
        for (const auto word : split(text, ',')) words_.emplace_back(word);
        size_ = words_.size();
        for (const auto& word : words_)
            if (word.empty()) throw DomainError(fmt::format("'{}': a value is missing", text));
    }
    if (size_ > most) throw DomainError(fmt::format("range '{}' has {} values; at most {} are taken", text, size_, most));
}

void Range::read_steps(std::string_view text)
{
    const auto parts = split(text, ':');
    if (parts.size() != 3) throw DomainError(fmt::format("range '{}' is not first:last:step or log:first:last:count", text));
    first_ = number(parts[0], text);
    last_ = number(parts[1], text);
    step_ = number(parts[2], text);
    if (*step_ == 0) throw DomainError(fmt::format("range '{}': the step must not be 0", text));
    const Rational steps = (last_ - first_) / *step_;
    if (steps < 0) throw DomainError(fmt::format("range '{}' has no values: the step leads away from {}", text, parts[1]));
    const Integer whole = steps.get_num() / steps.get_den();
    if (whole >= Integer(most))
        throw DomainError(fmt::format("range '{}' has {} values; at most {} are taken", text, Integer(whole + 1).get_str(), most));
    size_ = whole.get_ui() + 1;
}

void Range::read_ratios(std::string_view text)
{
    const auto parts = split(text, ':');
    if (parts.size() != 4) throw DomainError(fmt::format("range '{}' is not log:first:last:count", text));
    first_ = number(parts[1], text);
    last_ = number(parts[2], text);
    const Rational count = number(parts[3], text);
    if (first_ <= 0 || last_ <= 0) throw DomainError(fmt::format("range '{}': both ends must be > 0", text));
    if (count.get_den() != 1 || count < 2 || count > Rational(Integer(most)))
        throw DomainError(fmt::format("range '{}': the count must be an integer from 2 to {}", text, most));
    size_ = count.get_num().get_ui();
}

std::string Range::at(std::size_t i) const
{
    if (!words_.empty()) return words_[i];
    if (step_) return exact_text(Rational(first_ + *step_ * Rational(Integer(i))));
    if (i == 0) return exact_text(first_);
    if (i + 1 == size_) return exact_text(last_);
    const Rational share(Integer(i), Integer(size_ - 1));
    Rational exponent = share;
    exponent.canonicalize();
    const WorkingPrecision precision(bits_between);
    const Ball value = Ball(first_) * pow(Ball(Rational(last_ / first_)), Ball(exponent));
    if (const auto x = nearest_double(value); x && *x > 0 && *x < std::numeric_limits<double>::infinity()) return shortest(*x);
    return round_to_digits(value, 17)
        .value_or(round_to_digits(Rational(first_), 17))
        .text(); // beyond binary64's range, or a perfect power on a tie of it
}

} // namespace touchstone
