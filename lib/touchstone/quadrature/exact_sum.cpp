// SPDX-License-Identifier: MIT
#include "touchstone/quadrature/exact_sum.hpp"

#include "touchstone/scalar/scalar.hpp"

#include <algorithm>

namespace touchstone::quadrature {
namespace {

/// n = s^2 f with f squarefree, for n small enough to be tried out.
std::optional<std::pair<Rational, long>> square_and_rest(const Rational& r)
{
    constexpr long largest = 1'000'000'000; // its trial divisors end at some 32000
    const Integer product = r.get_num() * r.get_den();
    if (const auto root = exact_root(r, 2)) return std::pair(*root, 1L);
    if (product > largest) return std::nullopt;
    long rest = product.get_si(), square = 1;
    for (long d = 2; d * d <= rest; ++d)
        while (rest % (d * d) == 0) {
            rest /= d * d;
            square *= d;
        }
    return std::pair(Rational(square) / Rational(r.get_den()), rest);
}

/// Of sqrt(pi), powers of powers included.
long sum_of_powers(long a, long b)
{
    long sum = 0;
    if (__builtin_add_overflow(a, b, &sum)) throw DomainError("a power of pi with an exponent beyond 2^62");
    return sum;
}

} // namespace

void ExactSum::add(const Key& key, const Rational& q)
{
    if (q == 0) return;
    Rational& have = terms_[key];
    have += q;
    if (have == 0) terms_.erase(key);
}

std::optional<Rational> ExactSum::rational() const
{
    if (terms_.empty()) return Rational(0);
    if (terms_.size() > 1 || terms_.begin()->first != Key{0, 1}) return std::nullopt;
    return terms_.begin()->second;
}

std::optional<Rational> ExactSum::times_pi() const
{
    if (terms_.empty()) return Rational(0);
    if (terms_.size() > 1 || terms_.begin()->first != Key{2, 1}) return std::nullopt;
    return terms_.begin()->second;
}

bool ExactSum::is_real() const
{
    return std::all_of(terms_.begin(), terms_.end(), [](const auto& t) { return t.first.second > 0; });
}

ExactSum ExactSum::real() const
{
    ExactSum r;
    for (const auto& [key, q] : terms_)
        if (key.second > 0) r.add(key, q);
    return r;
}

ExactSum ExactSum::imaginary() const
{
    ExactSum r;
    for (const auto& [key, q] : terms_)
        if (key.second < 0) r.add({key.first, Integer(-key.second)}, q);
    return r;
}

ExactSum ExactSum::conjugate() const
{
    ExactSum r = *this;
    for (auto& [key, q] : r.terms_)
        if (key.second < 0) q = -q;
    return r;
}

Ball ExactSum::ball() const
{
    if (!is_real()) return Ball::indeterminate();
    Ball sum(0);
    for (const auto& [key, q] : terms_) {
        Ball term(q);
        if (key.first != 0) {
            Ball root = touchstone::pi<Ball>();
            if (key.first % 2 != 0) root = touchstone::sqrt(root);
            const long n = key.first % 2 != 0 ? key.first : key.first / 2;
            Ball power;
            arb_pow_ui(power.get(), root.get(), static_cast<ulong>(n < 0 ? -n : n), WorkingPrecision::bits());
            term = n < 0 ? term / power : term * power;
        }
        if (key.second != 1) term *= touchstone::sqrt(Ball(Rational(key.second)));
        sum += term;
    }
    return sum;
}

ExactSum ExactSum::operator-() const
{
    ExactSum r = *this;
    for (auto& [key, q] : r.terms_) q = -q;
    return r;
}

ExactSum operator+(const ExactSum& a, const ExactSum& b)
{
    ExactSum r = a;
    for (const auto& [key, q] : b.terms_) r.add(key, q);
    return r;
}

ExactSum operator*(const ExactSum& a, const ExactSum& b)
{
    ExactSum r;
    for (const auto& [ka, qa] : a.terms_)
        for (const auto& [kb, qb] : b.terms_) { // sqrt(m) sqrt(n) = g sqrt(m n/g^2), its sign changed if both are imaginary
            const Integer g = gcd(ka.second, kb.second);
            const long sign = ka.second < 0 && kb.second < 0 ? -1 : 1;
            r.add({sum_of_powers(ka.first, kb.first), Integer((ka.second / g) * (kb.second / g))}, Rational(qa * qb * g * sign));
        }
    return r;
}

std::optional<ExactSum> ExactSum::inverse() const
{
    if (terms_.empty()) return std::nullopt;
    if (terms_.size() > 1) { // 1/z = conj(z)/|z|^2
        const auto square = is_real() ? std::nullopt : (*this * conjugate()).inverse();
        return square ? std::optional(conjugate() * *square) : std::nullopt;
    }
    const auto& [key, q] = *terms_.begin();
    ExactSum r;
    r.add({-key.first, key.second}, Rational(1 / (q * key.second)));
    return r;
}

std::optional<ExactSum> ExactSum::power(long n) const
{
    constexpr long largest = 64;
    if (n < -largest || n > largest) return std::nullopt;
    if (n < 0) {
        const auto i = inverse();
        return i ? i->power(-n) : std::nullopt;
    }
    ExactSum r(1);
    for (long k = 0; k < n; ++k) r = r * *this;
    return r;
}

std::optional<ExactSum> ExactSum::sqrt() const
{
    if (terms_.empty()) return ExactSum();
    if (terms_.size() != 1) return std::nullopt;
    const auto& [key, q] = *terms_.begin();
    if (key.second != 1 || q < 0 || key.first % 2 != 0) return std::nullopt;
    const auto root = square_and_rest(q);
    if (!root) return std::nullopt;
    ExactSum r;
    r.add({key.first / 2, root->second}, root->first);
    return r;
}

} // namespace touchstone::quadrature
