// SPDX-License-Identifier: MIT
/// \file
/// Exact constants: sums of q pi^(k/2) sqrt(n), q rational, k an integer, n squarefree; a negative n is i sqrt(-n).
///
/// pi is transcendental and the square roots of different squarefree integers are linearly independent over the rationals, so
/// a sum is zero only if every q is: the test for zero, on which a proven order of a zero rests, is complete. (With negative n too:
/// the real and the imaginary part are sums of this kind, each by itself.)
#pragma once

#include "touchstone/scalar/ball.hpp"

#include <map>
#include <optional>
#include <utility>

namespace touchstone::quadrature {

class ExactSum {
public:
    ExactSum() = default;
    ExactSum(const Rational& r) { add({0, 1}, r); }
    ExactSum(long n)
        : ExactSum(Rational(n))
    {
    }
    static ExactSum pi(long halves = 2)
    {
        ExactSum s;
        s.add({halves, 1}, 1);
        return s;
    } ///< pi^(halves/2)

    static ExactSum i()
    {
        ExactSum s;
        s.add({0, -1}, 1);
        return s;
    }

    using Key = std::pair<long, Integer>; ///< power of sqrt(pi), radicand
    const std::map<Key, Rational>& terms() const { return terms_; }

    bool is_zero() const { return terms_.empty(); }
    bool is_real() const;
    ExactSum real() const;
    ExactSum imaginary() const;
    ExactSum conjugate() const;
    std::optional<Rational> rational() const;
    /// q, if this is q pi.
    std::optional<Rational> times_pi() const;
    /// Indeterminate unless real.
    Ball ball() const;
    ComplexBall complex_ball() const { return {real().ball(), imaginary().ball()}; }

    ExactSum operator-() const;
    friend ExactSum operator+(const ExactSum& a, const ExactSum& b);
    friend ExactSum operator-(const ExactSum& a, const ExactSum& b) { return a + (-b); }
    friend ExactSum operator*(const ExactSum& a, const ExactSum& b);
    friend bool operator==(const ExactSum&, const ExactSum&) = default;

    /// 1/this, this^n, sqrt(this): nothing where the result is not of this form (a sum of several terms has no inverse here
    /// unless its square of modulus is one term, as that of 1 + 2i is).
    std::optional<ExactSum> inverse() const;
    std::optional<ExactSum> power(long n) const;
    std::optional<ExactSum> sqrt() const;

private:
    void add(const Key& key, const Rational& q);
    std::map<Key, Rational> terms_;
};

} // namespace touchstone::quadrature
