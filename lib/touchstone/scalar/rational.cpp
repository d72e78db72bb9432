// SPDX-License-Identifier: MIT
#include "touchstone/scalar/rational.hpp"

#include "touchstone/scalar/rational_text.hpp"

#include <mpfr.h>

#include <cctype>
#include <cmath>
#include <cstdlib>

namespace touchstone {
namespace {

constexpr long exponent_limit = 1'000'000;

bool is_digit(char c, int base)
{
    const auto u = static_cast<unsigned char>(c);
    return base == 16 ? std::isxdigit(u) != 0 : std::isdigit(u) != 0;
}

/// [sign] digits [. digits] [e|p [sign] digits], in base 10 or (after 0x) 16.
std::optional<Rational> parse_number(std::string_view s)
{
    bool negative = false;
    if (!s.empty() && (s.front() == '-' || s.front() == '+')) {
        negative = s.front() == '-';
        s.remove_prefix(1);
    }
    int base = 10;
    if (s.size() > 2 && s[0] == '0' && (s[1] == 'x' || s[1] == 'X')) {
        base = 16;
        s.remove_prefix(2);
    }
    std::string digits;
    long scale = 0; // digits after the point
    bool point = false;
    std::size_t i = 0;
    for (; i < s.size() && (is_digit(s[i], base) || (s[i] == '.' && !point)); ++i) {
        if (s[i] == '.') { point = true; continue; }
        digits += s[i];
        scale += point ? 1 : 0;
    }
    if (digits.empty()) return std::nullopt;
    long exponent = 0;
    if (i < s.size()) {
        const char mark = static_cast<char>(std::tolower(static_cast<unsigned char>(s[i])));
        if (mark != (base == 16 ? 'p' : 'e')) return std::nullopt;
        std::string e(s.substr(i + 1));
        const std::size_t first = !e.empty() && (e[0] == '-' || e[0] == '+') ? 1 : 0;
        if (e.size() == first || e.size() > first + 7) return std::nullopt;
        for (std::size_t k = first; k < e.size(); ++k)
            if (!is_digit(e[k], 10)) return std::nullopt;
        exponent = std::strtol(e.c_str(), nullptr, 10);
        if (std::labs(exponent) > exponent_limit) return std::nullopt;
    }
    Rational value{Integer(digits, base), 1};
    const auto scaled = [&](unsigned long b, long e) {
        Integer p;
        mpz_ui_pow_ui(p.get_mpz_t(), b, static_cast<unsigned long>(std::labs(e)));
        if (e >= 0) value *= p; else value /= p;
    };
    if (base == 16) scaled(2, exponent - 4 * scale);
    else scaled(10, exponent - scale);
    if (negative) value = -value;
    return value;
}

} // namespace

std::string why_not_rational(std::string_view text)
{
    const std::string other = "is not a number such as 12, 0.1, 1e-300, 1/3 or 0x1.8p-3";
    if (text.empty()) return "is empty; right is a number such as 12, 0.1, 1e-300, 1/3 or 0x1.8p-3";
    if (const auto slash = text.find('/'); slash != std::string_view::npos) {
        const auto numerator = text.substr(0, slash), denominator = text.substr(slash + 1);
        if (!parse_number(numerator)) return numerator.empty() ? other : why_not_rational(numerator);
        const auto q = parse_number(denominator);
        if (!q) return denominator.empty() || denominator.find('/') != std::string_view::npos ? other : why_not_rational(denominator);
        return *q == 0 ? "has 0 as its denominator" : "has a negative denominator; the sign goes in front";
    }
    // a number but for the size of its exponent?
    const bool hexadecimal = text.find_first_of("xX") != std::string_view::npos;
    const auto mark = text.find_first_of(hexadecimal ? "pP" : "eE");
    if (mark == std::string_view::npos || !parse_number(text.substr(0, mark))) return other;
    std::string_view exponent = text.substr(mark + 1);
    if (!exponent.empty() && (exponent.front() == '-' || exponent.front() == '+')) exponent.remove_prefix(1);
    const bool digits = !exponent.empty() && exponent.find_first_not_of("0123456789") == std::string_view::npos;
    return digits ? "has an exponent beyond " + std::to_string(exponent_limit) : other;
}

std::optional<Rational> parse_rational(std::string_view text)
{
    const auto slash = text.find('/');
    if (slash == std::string_view::npos) return parse_number(text);
    const auto p = parse_number(text.substr(0, slash));
    const auto q = parse_number(text.substr(slash + 1));
    if (!p || !q || *q <= 0) return std::nullopt;
    return Rational(*p / *q);
}

Rational exact_rational(double x)
{
    Rational r;
    mpq_set_d(r.get_mpq_t(), x);
    return r;
}

double nearest_double(const Rational& r)
{
    // mpfr's rounding at 53 bits, then its own subnormal rounding, which undoes the double rounding.
    const mpfr_exp_t low = mpfr_get_emin();
    const mpfr_exp_t high = mpfr_get_emax();
    mpfr_t x;
    mpfr_init2(x, 53);
    mpfr_set_emin(-1073);
    mpfr_set_emax(1024);
    int ternary = mpfr_set_q(x, r.get_mpq_t(), MPFR_RNDN);
    ternary = mpfr_subnormalize(x, ternary, MPFR_RNDN);
    const double d = mpfr_get_d(x, MPFR_RNDN);
    mpfr_clear(x);
    mpfr_set_emin(low);
    mpfr_set_emax(high);
    return d;
}

std::optional<long> terminating_digits(const Rational& r)
{
    Integer q = r.get_den();
    const auto strip = [&q](unsigned long prime) {
        const Integer p(prime);
        return static_cast<long>(mpz_remove(q.get_mpz_t(), q.get_mpz_t(), p.get_mpz_t()));
    };
    const long twos = strip(2);
    const long fives = strip(5);
    if (q != 1) return std::nullopt;
    Integer scale;
    mpz_ui_pow_ui(scale.get_mpz_t(), 10, static_cast<unsigned long>(std::max(twos, fives)));
    Integer digits = r.get_num() * scale / r.get_den();
    if (digits == 0) return 1;
    const Integer ten(10);
    mpz_remove(digits.get_mpz_t(), digits.get_mpz_t(), ten.get_mpz_t());
    return static_cast<long>(Integer(abs(digits)).get_str().size());
}

std::optional<Rational> exact_root(const Rational& r, unsigned long m)
{
    Integer p, q;
    if (r < 0) return std::nullopt;
    if (mpz_root(p.get_mpz_t(), r.get_num_mpz_t(), m) == 0) return std::nullopt;
    if (mpz_root(q.get_mpz_t(), r.get_den_mpz_t(), m) == 0) return std::nullopt;
    return Rational(p, q);
}

Rational power(const Rational& r, long e)
{
    const auto k = static_cast<unsigned long>(std::labs(e));
    Integer p, q;
    mpz_pow_ui(p.get_mpz_t(), r.get_num_mpz_t(), k);
    mpz_pow_ui(q.get_mpz_t(), r.get_den_mpz_t(), k);
    if (e < 0) swap(p, q);
    Rational result(p, q);
    result.canonicalize();
    return result;
}

} // namespace touchstone
