// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/row_reader.hpp"

#include "touchstone/catalogue/named_inputs.hpp"
#include "touchstone/rounding/decimal.hpp"
#include "touchstone/scalar/exact_text.hpp"
#include "touchstone/table/format.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace touchstone::program {
namespace {

constexpr std::size_t longest_exponent = 15; ///< digits; beyond it no value of ours has been, and none fits a long

bool all_digits(std::string_view text) { return text.find_first_not_of("0123456789") == std::string_view::npos; }

std::vector<std::string> split(std::string_view text)
{
    std::vector<std::string> words;
    for (std::size_t end = 0; end != std::string_view::npos; text.remove_prefix(std::min(end + 1, text.size()))) {
        end = text.find(' '); // one blank, so that an input that was refused because nothing was given has its place
        words.emplace_back(text.substr(0, end));
    }
    return words;
}

/// A printed number with all the digits that stand there; nothing: no decimal number. Whether it is written as we do shows by writing it.
std::optional<Decimal> decimal_of(std::string_view text)
{
    Decimal d;
    if (text.starts_with('-')) {
        d.negative = true;
        text.remove_prefix(1);
    }
    const auto e = text.find('e');
    long tens = 0;
    if (e != std::string_view::npos) {
        std::string_view exponent = text.substr(e + 1);
        if (exponent.starts_with('+')) exponent.remove_prefix(1);
        const auto [end, error] = std::from_chars(exponent.data(), exponent.data() + exponent.size(), tens);
        if (error != std::errc() || end != exponent.data() + exponent.size() || exponent.size() > longest_exponent) return std::nullopt;
        text = text.substr(0, e);
    }
    const auto point = text.find('.');
    const std::string_view whole = text.substr(0, point), part = point == std::string_view::npos ? "" : text.substr(point + 1);
    if (whole.empty() || !all_digits(whole) || !all_digits(part)) return std::nullopt;
    const std::string all = std::string(whole) + std::string(part);
    const auto first = all.find_first_not_of('0');
    if (first == std::string::npos) return Decimal{};
    d.digits = all.substr(first);
    d.exponent = tens + static_cast<long>(whole.size()) - static_cast<long>(first);
    return d;
}

std::string unit(const Decimal& d) { return fmt::format("1e{:+03d}", d.exponent - static_cast<long>(d.digits.size())); }

/// Whether a value of so many digits, as it is written, and its error are what evaluate() gives with this status.
bool may_stand(const Decimal& d, const RowTableKind& k, const WrittenRow& row)
{
    const long n = static_cast<long>(d.digits.size()), most = std::min(k.digits, most_estimated_digits);
    const bool nearest = k.rounding == Rounding::nearest;
    const auto written = [&](long width) { return d.text(width) == row.value; };
    const bool half = row.error == d.half_unit(), whole = row.error == unit(d);
    if (n == 0) return row.value == "0" && row.error == "0";
    if (row.status == "exact") return n <= k.digits && d.digits.back() != '0' && row.error == "0" && written(k.digits);
    if (row.status == "certified") return n == k.digits && written(k.digits) && (nearest ? half : whole);
    if (row.status == "estimated")
        return k.digits <= most_estimated_digits && written(nearest ? n : k.digits) &&
               (nearest ? half && n >= k.digits - 1 && n <= k.digits : whole && n == k.digits); // one fewer next to a tie
    return n <= k.digits && (half || (whole && !nearest)) && (written(k.digits) || written(most));
}

/// In a whole number, zeros at the end may be digits or hold their places.
bool value_may_stand(const RowTableKind& k, const WrittenRow& row)
{
    if (row.status == "undecided" && row.value == "nan") return row.error == "inf";
    auto d = decimal_of(row.value);
    const bool is_whole = row.value.find_first_of(".e") == std::string::npos;
    for (; d; d->digits.pop_back()) {
        if (may_stand(*d, k, row)) return true;
        if (!is_whole || d->digits.empty() || d->digits.back() != '0') return false;
    }
    return false;
}

Inputs inputs_of(const RowTableKind& k, const std::vector<std::string>& words)
{
    NamedTexts named;
    for (std::size_t i = 0; i < words.size(); ++i) {
        const auto exact = k.binary64 ? parse_rational(words[i]) : std::nullopt;
        if (k.binary64 && (!exact || shortest(nearest_double(*exact)) != words[i]))
            throw CorruptTable(fmt::format("{} = '{:.40}' is no binary64 number in shortest decimal", k.columns[i], words[i]));
        named.emplace_back(k.columns[i], words[i]);
    }
    try {
        Inputs in = read_inputs(*k.quantity, named);
        k.quantity->check(in);
        return in;
    }
    catch (const DomainError& e) {
        throw CorruptTable(fmt::format("it has a value where there is none: {}", e.what()));
    }
    catch (const WrongKeys& e) {
        throw CorruptTable(e.what());
    }
}

} // namespace

WrittenRow read_row(const RowTableKind& k, std::string_view line)
{
    const auto mark = line.find(status_mark);
    if (mark == std::string_view::npos) throw CorruptTable("has no status");
    if (std::any_of(line.begin(), line.end(), [](unsigned char c) { return c < 0x20; })) throw CorruptTable("has a control character");
    WrittenRow row;
    std::string_view rest = line.substr(mark + status_mark.size());
    const auto colon = rest.find(':');
    row.status = rest.substr(0, colon);
    if (std::find(statuses.begin(), statuses.end(), row.status) == statuses.end())
        throw CorruptTable(fmt::format("has the status '{:.40}'", row.status));
    const bool refused = row.status == "refused", told = refused || row.status == "undecided";
    if (told != (colon != std::string_view::npos && rest.substr(colon).starts_with(": ")) || (!told && colon != std::string_view::npos))
        throw CorruptTable(fmt::format("is {} {}", row.status, told ? "and does not say why" : "and has more to say"));
    row.words = split(line.substr(0, mark));
    if (row.words.size() != k.columns.size() + 2)
        throw CorruptTable(fmt::format("has {} columns where {} are right", row.words.size(), k.columns.size() + 2));
    row.error = std::move(row.words.back());
    row.words.pop_back();
    row.value = std::move(row.words.back());
    row.words.pop_back();
    if (refused ? row.value != "nan" || row.error != "inf" : !value_may_stand(k, row))
        throw CorruptTable(fmt::format("has a value that is none of ours: '{:.40} {:.40}', {}, where {} digits were asked for", row.value,
                                       row.error, row.status, k.digits));
    try {
        row.inputs = inputs_of(k, row.words);
    }
    catch (const CorruptTable&) {
        if (!refused) throw;
    }
    return row;
}

} // namespace touchstone::program
