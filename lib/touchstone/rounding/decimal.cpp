// SPDX-License-Identifier: MIT
#include "touchstone/rounding/decimal.hpp"

#include "touchstone/rounding/shown.hpp"

#include <fmt/format.h>
#include <mpfr.h>

#include <algorithm>
#include <cmath>

namespace touchstone {
namespace {

class Mpfr_ {
public:
    Mpfr_() { mpfr_init2(x_, 53); }
    ~Mpfr_() { mpfr_clear(x_); }
    Mpfr_(const Mpfr_&) = delete;
    Mpfr_& operator=(const Mpfr_&) = delete;
    mpfr_ptr get() { return x_; }

private:
    mpfr_t x_;
};

/// The two ends of the ball, widened by less than a part in 2^64 of it.
void ends(Mpfr_& low, Mpfr_& high, const Ball& b)
{
    // a short midpoint (1/2) may have a tiny radius: the ends need bits for both
    const slong accuracy = b.is_exact() ? 0 : std::max<slong>(b.relative_bits(), 0);
    const slong bits = std::max<slong>(arf_bits(arb_midref(b.get())), accuracy) + 128;
    mpfr_set_prec(low.get(), bits);
    mpfr_set_prec(high.get(), bits);
    arb_get_interval_mpfr(low.get(), high.get(), b.get());
}

Decimal decimal_of(mpfr_srcptr x, long digits)
{
    mpfr_exp_t exponent = 0;
    char* text = mpfr_get_str(nullptr, &exponent, 10, static_cast<std::size_t>(digits), x, MPFR_RNDN);
    std::string d(text);
    mpfr_free_str(text);
    const bool negative = d.front() == '-';
    if (negative) d.erase(0, 1);
    return {negative, d, exponent};
}

/// x as binary64 with IEEE 754's gradual underflow.
double double_of(mpfr_srcptr x) { return mpfr_get_d(x, MPFR_RNDN); }

} // namespace

std::string Decimal::text(long width) const
{
    if (digits.empty()) return "0";
    const std::string_view sign = negative ? "-" : "";
    const std::string_view all = digits;
    const long n = static_cast<long>(digits.size());
    const long e = exponent - 1; // as in d.ddd x 10^e
    const auto at = static_cast<std::size_t>(std::clamp(exponent, 0L, n));
    if (e < -5 || e >= std::max(width, n))
        return fmt::format("{}{}{}{}e{:+03d}", sign, all[0], n > 1 ? "." : "", all.substr(1), e);
    if (exponent <= 0) return fmt::format("{}0.{:0>{}}{}", sign, "", -exponent, all);
    if (exponent >= n) return fmt::format("{}{}{:0>{}}", sign, all, "", exponent - n);
    return fmt::format("{}{}.{}", sign, all.substr(0, at), all.substr(at));
}

std::string Decimal::half_unit() const
{
    if (digits.empty()) return "0";
    return fmt::format("5e{:+03d}", exponent - static_cast<long>(digits.size()) - 1);
}

Rational Decimal::value() const
{
    if (digits.empty()) return Rational(0);
    const Rational v = Rational(Integer(digits, 10)) * power(Rational(10), exponent - static_cast<long>(digits.size()));
    return negative ? Rational(-v) : v;
}

std::optional<Decimal> round_to_digits(const Ball& b, long digits)
{
    if (!b.is_finite()) return std::nullopt;
    if (arb_is_zero(b.get())) return Decimal{};
    if (b.contains_zero()) return std::nullopt;
    Mpfr_ low, high;
    ends(low, high, b);
    if (mpfr_zero_p(low.get()) || mpfr_zero_p(high.get())) return std::nullopt;
    Decimal l = decimal_of(low.get(), digits);
    if (l == decimal_of(high.get(), digits)) return l;
    return std::nullopt;
}

Decimal round_to_digits(const Rational& r, long digits)
{
    if (r == 0) return {};
    const Rational a = abs(r);
    // A guess of the exponent from the sizes, which is not too large and at most two too small: a is within a factor of two of the quotient
    // of the powers of two, and 0.30103 exceeds log10(2) by so little that it counts for numbers of 10^8 bits alone.
    long e = static_cast<long>(std::floor((static_cast<double>(mpz_sizeinbase(a.get_num_mpz_t(), 2))
                                           - static_cast<double>(mpz_sizeinbase(a.get_den_mpz_t(), 2))) * 0.30103));
    while (a >= power(Rational(10), e)) ++e;
    const Rational scaled = a * power(Rational(10), digits - e);
    Integer q, rest;
    mpz_fdiv_qr(q.get_mpz_t(), rest.get_mpz_t(), scaled.get_num_mpz_t(), scaled.get_den_mpz_t());
    const int half = cmp(2 * rest, scaled.get_den());
    if (half > 0 || (half == 0 && mpz_odd_p(q.get_mpz_t()))) ++q;
    std::string d = q.get_str();
    if (static_cast<long>(d.size()) > digits) { // 9.99... carried to 10.00...
        d.pop_back();
        ++e;
    }
    return {r < 0, d, e};
}

std::optional<double> nearest_double(const Ball& b)
{
    if (!b.is_finite()) return std::nullopt;
    Mpfr_ low, high;
    ends(low, high, b);
    const double l = double_of(low.get());
    const double h = double_of(high.get());
    if (l != h || (l == 0.0 && !arb_is_zero(b.get()) && b.contains_zero())) return std::nullopt;
    return l == 0.0 && !arb_is_zero(b.get()) ? std::copysign(0.0, mpfr_get_d(high.get(), MPFR_RNDA)) : h;
}

std::optional<Rational> exact_value(const Ball& b)
{
    if (!b.is_finite() || !b.is_exact()) return std::nullopt;
    if (arf_cmpabs_2exp_si(arb_midref(b.get()), 4096) > 0) return std::nullopt;
    if (!arb_is_zero(b.get()) && arf_cmpabs_2exp_si(arb_midref(b.get()), -4096) < 0) return std::nullopt;
    fmpq_t q;
    fmpq_init(q);
    arf_get_fmpq(q, arb_midref(b.get()));
    Rational r;
    fmpq_get_mpq(r.get_mpq_t(), q);
    fmpq_clear(q);
    return r;
}

std::string hexfloat(double x)
{
    if (std::isnan(x)) return "nan";
    if (std::isinf(x)) return x < 0 ? "-inf" : "inf";
    return fmt::format("{:a}", x);
}

std::string shown_decimal(const std::string& number, long digits)
{
    const std::size_t mantissa = std::min(number.find_first_of("eE"), number.size());
    const auto value = parse_rational(number);
    if (static_cast<long>(mantissa) <= digits || !value) return number;
    return round_to_digits(*value, digits).text();
}

std::string shortest(double x) { return fmt::format("{}", x); }

} // namespace touchstone
