// SPDX-License-Identifier: MIT
#include "tests/fuzz/expect.hpp"
#include "tests/fuzz/targets.hpp"
#include "touchstone/catalogue/named_inputs.hpp"
#include "touchstone/oracle/printed.hpp"
#include "touchstone/oracle/subject.hpp"
#include "touchstone/scalar/exact_text.hpp"
#include "touchstone/scalar/rational.hpp"
#include "touchstone/scalar/rational_text.hpp"
#include "touchstone/table/ranges.hpp"
#include "touchstone/table/rows.hpp"
#include "touchstone/table/shard.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <sstream>
#include <string>
#include <vector>

namespace touchstone::fuzz {
namespace {

constexpr std::size_t giant = 10'000; ///< bits of a number whose text takes as long as a thousand others

/// One text in 64: what takes longest and is the same way for all of its kind.
bool sampled(std::string_view text) { return std::hash<std::string_view>{}(text) % 64 == 0; }

std::size_t bits(const Rational& r) { return std::max(mpz_sizeinbase(r.get_num_mpz_t(), 2), mpz_sizeinbase(r.get_den_mpz_t(), 2)); }

/// An answer is a number: what it is read as, written as a hexfloat, is read as the same.
void one_answer(std::string_view text)
{
    const auto value = oracle::parse_answer(text);
    if (!value) return;
    char written[64];
    std::snprintf(written, sizeof written, "%a", *value);
    const auto again = oracle::parse_answer(written);
    expect(again && (std::isnan(*value) ? std::isnan(*again) : *again == *value), "an answer written as a hexfloat is the same answer");
}

/// Of the quantities the one whose name begins most like this: the inputs of a name that has been changed are read too, and in less time
/// than the nearest name, which is looked for in a sample, takes.
const Quantity& quantity_like(const std::string& name, bool nearest)
{
    static const std::vector<std::string> names = quantity_names();
    const auto in_common = [&name](const Quantity& q) {
        const auto ends = std::mismatch(q.name.begin(), q.name.end(), name.begin(), name.end());
        return ends.first - q.name.begin();
    };
    const Quantity* like = nearest ? find_quantity(nearest_name(name, names)) : &catalogue().front();
    expect(like != nullptr, "the nearest name is one of a quantity");
    if (!nearest)
        for (const Quantity& q : catalogue())
            if (in_common(q) > in_common(*like)) like = &q;
    return *like;
}

void domain_errors_only(std::string_view text)
{
    try {
        const Share s = share_named(text);
        expect(s.index >= 1 && s.index <= s.count && s.count <= Share::most, "a share is one of its count");
    }
    catch (const DomainError&) {
    }
}

} // namespace

void numbers(std::string_view text)
{
    const auto rational = parse_rational(text);
    if (rational && bits(*rational) > giant && !sampled(text)) return;
    if (rational) {
        expect(RowsReader::number(text).has_value(), "what the command line takes, a file of rows takes");
        constexpr std::size_t most_bits = 3'000'000; // near 10^(+-10^6), where exponents end
        const auto again = parse_rational(exact_text(*rational));
        expect(again ? *again == *rational : bits(*rational) > most_bits, "an exact number written is the same number");
    }
    else
        expect(!why_not_rational(text).empty(), "a refusal has a reason");
    if (const auto exact = parse_exact(text)) {
        try {
            const Root root = as_root(*exact);
            expect(root.degree >= 1 && (root.degree == 1 || root.base > 0), "a root is of a positive number");
        }
        catch (const NotExact&) {
        }
    }
    if (oracle::is_printed_decimal(text)) expect(rational.has_value(), "a printed decimal is a number");
    one_answer(text);
    domain_errors_only(text);
}

void inputs(std::string_view text)
{
    std::istringstream words{std::string(text)};
    std::string name;
    words >> name;
    const Quantity* q = find_quantity(name);
    if (q == nullptr) q = &quantity_like(name, sampled(text));
    NamedTexts named;
    for (std::string word; words >> word;) {
        const auto equals = word.find('=');
        named.emplace_back(word.substr(0, equals), equals == std::string::npos ? "" : word.substr(equals + 1));
    }
    try {
        q->check(read_inputs(*q, named));
    }
    catch (const WrongKeys&) {
    }
    catch (const DomainError&) {
    }
    catch (const BeyondReach&) { // G that cannot be told from a bound
    }
}

void answers(std::string_view text)
{
    std::istringstream in{std::string(text)};
    constexpr std::size_t asked = 3;
    const oracle::Answers got = oracle::read_answers(in, asked);
    expect(got.fault ? got.values.size() <= asked && !got.fault->detail.empty() : got.values.size() == asked,
           "as many answers as rows, or a fault that says why");
}

void ranges(std::string_view text)
{
    try {
        const Range range(text);
        expect(range.size() >= 1 && range.size() <= Range::most, "a range has values");
        for (const std::size_t i : {std::size_t{0}, range.size() / 2, range.size() - 1})
            expect(!range.at(i).empty(), "a value of a range has a text");
    }
    catch (const DomainError&) {
    }
}

} // namespace touchstone::fuzz
