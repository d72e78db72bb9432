// SPDX-License-Identifier: MIT
#include "touchstone/certificate/text.hpp"

#include "touchstone/scalar/floor.hpp"
#include "touchstone/table/format.hpp"

#include <fmt/format.h>

#include <cmath>

namespace touchstone::certificate {
namespace {

std::string in_short(const std::vector<std::size_t>& numbers) // 1,4,10-17
{
    if (numbers.empty()) return "-";
    std::string text;
    for (std::size_t i = 0, j = 0; i < numbers.size(); i = j) {
        for (j = i + 1; j < numbers.size() && numbers[j] == numbers[j - 1] + 1; ++j) {
        }
        if (!text.empty()) text += ',';
        text += std::to_string(numbers[i]);
        if (j - i > 1) text += fmt::format("-{}", numbers[j - 1]);
    }
    return text;
}

} // namespace

std::string hex(const mpz_class& n) { return n.get_str(16); }

std::string dyadic(mpz_class m, long e)
{
    if (m == 0) return "0:0";
    const auto zeros = static_cast<long>(mpz_scan1(m.get_mpz_t(), 0));
    return fmt::format("{}:{}", hex(m >> static_cast<unsigned long>(zeros)), e + zeros);
}

std::string dyadic(const Rational& r) { return dyadic(r.get_num(), -static_cast<long>(mpz_sizeinbase(r.get_den_mpz_t(), 2) - 1)); }

std::string dyadic_midpoint(const Ball& x)
{
    fmpz_t mantissa, exponent;
    fmpz_init(mantissa);
    fmpz_init(exponent);
    arf_get_fmpz_2exp(mantissa, exponent, arb_midref(x.get()));
    mpz_class m;
    fmpz_get_mpz(m.get_mpz_t(), mantissa);
    std::string text = dyadic(m, fmpz_get_si(exponent));
    fmpz_clear(mantissa);
    fmpz_clear(exponent);
    return text;
}

mpz_class units(const Ball& x, long bits)
{
    Ball scaled;
    arb_mul_2exp_si(scaled.get(), x.get(), bits);
    return floor_of_middle(scaled);
}

Rational rounded_up(double x)
{
    constexpr int bound_bits = 12;
    int e = 0;
    const double m = std::frexp(x, &e);
    Rational r(mpz_class(static_cast<long>(std::ceil(std::ldexp(m, bound_bits)))));
    e -= bound_bits;
    if (e >= 0)
        mpz_mul_2exp(r.get_num_mpz_t(), r.get_num_mpz_t(), static_cast<mp_bitcnt_t>(e));
    else
        mpz_mul_2exp(r.get_den_mpz_t(), r.get_den_mpz_t(), static_cast<mp_bitcnt_t>(-e));
    r.canonicalize();
    return r;
}

std::string named(const Root& G) { return G.degree == 1 ? G.base.get_str() : fmt::format("{}^1/{}", G.base.get_str(), G.degree); }

std::size_t Lines::add(const std::string& reason, const std::vector<std::size_t>& rests_on, const std::string& data)
{
    lines_.push_back({reason, rests_on, data, 0});
    const std::size_t number = lines_.size();
    for (const std::size_t r : rests_on) lines_[r - 1].last = number;
    return number;
}

std::string Lines::text() const
{
    std::string all;
    for (std::size_t i = 0; i < lines_.size(); ++i) {
        const Line& l = lines_[i];
        all += fmt::format("{} {} {} {} {}\n", i + 1, l.reason, in_short(l.rests_on), l.last == 0 ? i + 1 : l.last, l.data);
    }
    return all;
}

Ball number(const Root& G) { return G.degree == 1 ? Ball(G.base) : pow(Ball(G.base), 1 / Ball(static_cast<long>(G.degree))); }
double nearest(const Ball& x) { return arf_get_d(arb_midref(x.get()), ARF_RND_NEAR); }

std::string section_line(std::size_t section, std::size_t first, std::size_t last, const Counts& counts)
{
    std::string line = fmt::format("section {} span={}-{}", section, first, last);
    for (const auto& [reason, count] : counts)
        if (count > 0) line += fmt::format(" {}={}", reason, count);
    return line + '\n';
}

std::string certificate_text(const std::string& quantity, std::size_t claims, std::size_t sections, const std::string& head,
                             const Lines& lines)
{
    const std::string text = fmt::format("TOUCHSTONE-CERT 1\nquantity {}\ncounts claims={} sections={} lines={}\n{}{}", quantity, claims,
                                         sections, lines.count(), head, lines.text());
    return text + fmt::format("sha256 {}\n", sha256(text));
}

} // namespace touchstone::certificate
