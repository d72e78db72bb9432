// SPDX-License-Identifier: MIT
/// \file
/// Exact values of the form r s^(1/m) pi^k (r, s, k rational; s > 0; m a natural number).
///
/// They decide what no ball can: whether G = gamma^(D-1) is 2, whether a value sits on
/// a rounding tie, whether a result is rational. The set is closed under product,
/// quotient and powers; a sum stays in it only if its terms are rational multiples of
/// one another. What leaves the set throws `NotExact`, and the caller turns to balls.
#pragma once

#include "touchstone/scalar/ball.hpp"

namespace touchstone {

/// A value that `Exact` cannot hold. Not an error of the user: the signal to use balls.
class NotExact : public std::exception {
public:
    const char* what() const noexcept override { return "value is not of the form r s^(1/m) pi^k"; } ///< one line
};
/// A number r s^(1/m) pi^k, in the one form that equal numbers share.
class Exact {
public:
    Exact() : Exact(Rational(0)) {} ///< zero
    template <std::integral I>
    Exact(I n) : Exact(Rational(static_cast<long>(n))) {} ///< n
    Exact(Rational r) : factor_(std::move(r)), radicand_(1), degree_(1), pi_power_(0) {} ///< r
    Exact(double) = delete;
    /// pi^k
    static Exact pi_to(const Rational& k) { Exact r(1); r.pi_power_ = k; return r; }

    bool is_rational() const { return degree_ == 1 && pi_power_ == 0; } ///< m = 1 and k = 0
    bool is_zero() const { return factor_ == 0; } ///< r = 0
    int sign() const { return sgn(factor_); } ///< -1, 0 or 1
    unsigned long degree() const { return degree_; } ///< m
    /// \throws NotExact unless is_rational().
    const Rational& rational() const;
    /// Encloses the value at the working precision.
    Ball ball() const;

    friend Exact operator+(const Exact&, const Exact&); ///< \throws NotExact
    friend Exact operator-(const Exact& a, const Exact& b) { return a + (-b); } ///< \throws NotExact
    friend Exact operator*(const Exact&, const Exact&); ///< \throws NotExact
    friend Exact operator/(const Exact&, const Exact&); ///< \throws NotExact, also for a zero divisor
    Exact operator-() const { Exact r = *this; r.factor_ = -r.factor_; return r; } ///< the negative
    friend bool operator==(const Exact& a, const Exact& b); ///< the same number

    /// this^e for this > 0, or this >= 0 and e > 0, or integer e.
    Exact power(const Rational& e) const;

private:
    void normalise();

    Rational factor_;        // r, carries the sign
    Rational radicand_;      // s > 0, no perfect p-th power for a prime p dividing m
    unsigned long degree_;   // m
    Rational pi_power_;      // k
};

Exact sqrt(const Exact&); ///< x >= 0. \throws NotExact
Exact exp(const Exact&); ///< of 0 alone. \throws NotExact
Exact log(const Exact&); ///< of 1 alone. \throws NotExact
Exact asin(const Exact&); ///< where it is a rational multiple of pi. \throws NotExact
Exact acos(const Exact&); ///< as asin. \throws NotExact
Exact atan2(const Exact& y, const Exact& x); ///< as asin. \throws NotExact
Exact pow(const Exact& x, const Exact& y); ///< for a rational y. \throws NotExact
/// Always decided: yes or no.
Truth less(const Exact& x, const Exact& y);
inline Exact hull(const Exact& x, const Exact& y) { return x == y ? x : throw NotExact(); } ///< of equal numbers alone. \throws NotExact
inline Exact at_most(const Exact& x, const Exact& bound) { return certainly(less(bound, x)) ? bound : x; } ///< min(x, bound)
inline Exact at_least(const Exact& x, const Exact& bound) { return certainly(less(x, bound)) ? bound : x; } ///< max(x, bound)
/// Exact numbers: the value itself, or NotExact.
template <>
struct ScalarTraits<Exact> : ComposedTraits<Exact> {
    static Exact integer(long n) { return Exact(n); } ///< n
    static Exact quotient(long p, long q) { return Exact(Rational(p) / q); } ///< p/q
    static Exact pi(); ///< pi
    static Exact sin_pi(const Exact& x) { return cos_pi(Exact(Rational(1, 2)) - x); } ///< sin(pi x)
    static Exact cos_pi(const Exact& x); ///< cos(pi x), where it has the form
    static Exact powm1(const Exact& x, const Exact& y) { return pow(x, y) - 1; } ///< x^y - 1
    static Exact sqrt_positive_part(const Exact& x) { return x.sign() > 0 ? sqrt(x) : Exact(0); } ///< sqrt(max(x, 0))
    static Exact hypot(const Exact& a, const Exact& b) { return sqrt(a * a + b * b); } ///< sqrt(a^2 + b^2)
    static Exact power_of_two(long e); ///< 2^e
    static Exact gamma(const Exact& x); ///< n and n + 1/2, at most 1000
};

} // namespace touchstone
