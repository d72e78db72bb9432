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
    const char* what() const noexcept override { return "value is not of the form r s^(1/m) pi^k"; }
};

class Exact {
public:
    Exact() : Exact(Rational(0)) {}
    template <std::integral I>
    Exact(I n) : Exact(Rational(static_cast<long>(n))) {}
    Exact(Rational r) : factor_(std::move(r)), radicand_(1), degree_(1), pi_power_(0) {}
    Exact(double) = delete;
    /// pi^k
    static Exact pi_to(const Rational& k) { Exact r(1); r.pi_power_ = k; return r; }

    bool is_rational() const { return degree_ == 1 && pi_power_ == 0; }
    bool is_zero() const { return factor_ == 0; }
    int sign() const { return sgn(factor_); }
    /// \throws NotExact unless is_rational().
    const Rational& rational() const;
    /// Encloses the value at the working precision.
    Ball ball() const;

    friend Exact operator+(const Exact&, const Exact&);
    friend Exact operator-(const Exact& a, const Exact& b) { return a + (-b); }
    friend Exact operator*(const Exact&, const Exact&);
    friend Exact operator/(const Exact&, const Exact&);
    Exact operator-() const { Exact r = *this; r.factor_ = -r.factor_; return r; }
    friend bool operator==(const Exact& a, const Exact& b);

    /// this^e for this > 0, or this >= 0 and e > 0, or integer e.
    Exact power(const Rational& e) const;

private:
    void normalise();

    Rational factor_;        // r, carries the sign
    Rational radicand_;      // s > 0, no perfect p-th power for a prime p dividing m
    unsigned long degree_;   // m
    Rational pi_power_;      // k
};

Exact sqrt(const Exact&);
Exact exp(const Exact&);
Exact log(const Exact&);
Exact asin(const Exact&);
Exact acos(const Exact&);
Exact atan2(const Exact& y, const Exact& x);
Exact pow(const Exact& x, const Exact& y);
/// Always decided: yes or no.
Truth less(const Exact& x, const Exact& y);
inline Exact hull(const Exact& x, const Exact& y) { return x == y ? x : throw NotExact(); }
inline Exact at_most(const Exact& x, const Exact& bound) { return certainly(less(bound, x)) ? bound : x; }
inline Exact at_least(const Exact& x, const Exact& bound) { return certainly(less(x, bound)) ? bound : x; }

template <>
struct ScalarTraits<Exact> : ComposedTraits<Exact> {
    static Exact integer(long n) { return Exact(n); }
    static Exact quotient(long p, long q) { return Exact(Rational(p) / q); }
    static Exact pi();
    static Exact sin_pi(const Exact& x) { return cos_pi(Exact(Rational(1, 2)) - x); }
    static Exact cos_pi(const Exact& x);
    static Exact powm1(const Exact& x, const Exact& y) { return pow(x, y) - 1; }
    static Exact sqrt_positive_part(const Exact& x) { return x.sign() > 0 ? sqrt(x) : Exact(0); }
    static Exact hypot(const Exact& a, const Exact& b) { return sqrt(a * a + b * b); }
    static Exact power_of_two(long e);
    static Exact gamma(const Exact& x);
};

} // namespace touchstone
