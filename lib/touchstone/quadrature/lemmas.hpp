// SPDX-License-Identifier: MIT
/// \file
/// The bounds of this folder's proofs, each a lemma with its constants, proved in tanh_sinh.md under the same name and held against the
/// function that attains it in tests/quadrature/lemmas.cpp: no constant can be smaller.
#pragma once

#include "touchstone/quadrature/upper.hpp"

namespace touchstone::quadrature::lemma {

/// Discretisation: |integral F - h sum F(kh)| <= N_d/(exp(2 pi d/h) - 1).
inline Ball discretisation(const Ball& strip_integral, const Ball& d, const Ball& h)
{
    Ball e;
    const Ball exponent = Ball(2) * pi<Ball>() * d / h;
    arb_expm1(e.get(), exponent.get(), WorkingPrecision::bits());
    return strip_integral / e;
}

/// Far factor: |1 + E|^-k <= (1 - exp(-A))^-|k| for |E| <= exp(-A).
inline Ball far_factor(const Ball& k, const Ball& A) { return exp(-touchstone::abs(k) * log(Ball(1) - exp(-A))); }

/// Truncation: h sum over k > n of K (1 - exp(-A))^-|beta| pi cosh(kh) exp(-alpha pi sinh(kh)), where alpha pi sinh(nh) >= 1.
inline Ball truncation(const Ball& K, const Ball& alpha, const Ball& beta, const Ball& A, const Ball& pi_sinh)
{
    return K * exp(-alpha * pi_sinh) * far_factor(beta, A) / alpha;
}

/// Logistic truncation: h sum over k > n of K (1 - exp(-A))^-|beta| exp(-alpha kh), depth = nh.
inline Ball logistic_truncation(const Ball& K, const Ball& alpha, const Ball& beta, const Ball& A, const Ball& depth)
{
    return K * exp(-alpha * depth) * far_factor(beta, A) / alpha;
}

/// Logistic strip's tail: integral over x > A of K |u|^alpha |r|^beta dx at any height of the strip.
inline Ball logistic_strip_tail(const Ball& K, const Ball& alpha, const Ball& beta, const Ball& A)
{
    return K * exp(-alpha * A) * far_factor(touchstone::abs(alpha) + touchstone::abs(beta), A) / alpha;
}

/// Strip's tail: integral over x > T of K |u|^alpha |r|^beta pi cosh x dx at height d, A = pi sinh(T) cos d.
inline Ball strip_tail(const Ball& K, const Ball& alpha, const Ball& beta, const Ball& A, const Ball& d)
{
    return K * exp(-alpha * A) * far_factor(touchstone::abs(alpha) + touchstone::abs(beta), A) / (alpha * cos(d));
}

/// Remainder: T(s) less its first n terms, |s| = q R, |T| <= bound for |s| <= R (Cauchy).
inline Ball remainder(const Ball& bound, const Ball& q, long n)
{
    Ball power;
    arb_pow_ui(power.get(), q.get(), static_cast<ulong>(n), WorkingPrecision::bits());
    return bound * power / (Ball(1) - q);
}

/// Elliptic remainder: sum over k >= n of 2 a_k s_k q^k, a_k <= 1/4, s_k < log 2, n >= 1.
inline Ball elliptic_remainder(const Ball& q, long n)
{
    Ball power;
    arb_pow_ui(power.get(), q.get(), static_cast<ulong>(n), WorkingPrecision::bits());
    return log(Ball(2)) / Ball(2) * power / (Ball(1) - q);
}

/// Means: c_n = (a_(n-1) - b_(n-1))/2 of the arithmetic-geometric mean, c_(n+1) = c_n^2/(4 a_(n+1)), real parts of the means at least delta
/// from n on, delta > 0, square at least |c_n|^2. From n + 1 on each c_k is at most half the one before: the limit is within this of a_n,
inline Ball limit_of_means(const Ball& square, const Ball& delta) { return square / (Ball(2) * delta); }
/// and what the sum of 2^(k-1) c_k^2 lacks after k = n is at most 2^(n+1) |c_n|^4/(16 delta^2).
inline Ball rest_of_means(const Ball& square, const Ball& delta, long n)
{
    return square * square / (delta * delta) * ScalarTraits<Ball>::power_of_two(n - 3);
}

/// Slope: |T(s) - T(m)|, |T| <= bound for |s| <= R, at |s|, |m| <= R/4: |T'| <= (bound/R)/(1 - |s/R|^2) (Schwarz and Pick).
inline Ball slope(const Ball& bound, const Ball& R, const Ball& distance) { return Ball(16) / Ball(15) * bound / R * distance; }

/// Slope of a logarithm: the derivative of log(1 - y)/y, |y| <= size < 1.
inline Ball slope_of_logarithm(const Ball& size) { return Ball(1) / Ball(2) + size / (Ball(1) - size); }

/// Slope of sinc: |sinc'(z)|, |z| <= size, |Im z| <= height.
inline Ball slope_of_sinc(const Ball& size, const Ball& height)
{
    const Ball half = Ball(1) / Ball(2), third = size / Ball(3);
    const Ball cosh = detail::of_magnitude(height, [](mag_ptr m) {
        mag_cosh(m, m);
        return detail::as_ball(m);
    });
    return (arb_lt(third.get(), half.get()) != 0 ? third : half) * cosh;
}

/// Logarithm over argument: |log(1 + v)/v - 1| of the principal logarithm, |v| <= size < 1.
inline Ball logarithm_over_argument(const Ball& size) { return size / (Ball(2) * (Ball(1) - size)); }

/// Odd difference: (h(s) - h(-s))/s, |h| <= supremum on |s| <= R; h(s) = s attains it.
inline Ball odd_difference(const Ball& supremum, const Ball& R) { return Ball(2) * supremum / R; }

/// Logarithm: log(rho) <= (4/e) rho^(1/4) for rho >= 1, with equality at e^4.
inline Ball logarithm_over_fourth_root() { return Ball(4) * exp(Ball(-1)); }

/// Bessel remainder: |R| of K_n(z) = (pi/(2z))^(1/2) exp(-z) (1 + R), |z| >= least; variation 1 for |arg z| <= pi/2, pi/2 for |arg z| < pi.
inline Ball bessel_remainder(const Ball& order, const Ball& least, const Ball& variation)
{
    const Ball spread = touchstone::abs(order * order - Ball(1) / Ball(4)); // 2 |a_1|
    const Ball v = spread * variation / least;
    return v * exp(v);
}

/// Scaled I: |exp(-z) I_n(z)| |z|^(1/2) for integer n and Re z >= c |z| > 0: 1 - cos t >= 2 (t/pi)^2 in its integral.
inline Ball scaled_bessel_i(const Ball& c) { return sqrt(pi<Ball>() / (Ball(8) * c)); }

/// Scaled erfc: |exp(z^2) erfc(z)| |z| for Re z >= c |z| > 0, attained by z -> oo; it is 2/sqrt(pi) times the integral of exp(-t^2 - 2zt).
inline Ball scaled_erfc(const Ball& c) { return Ball(1) / (sqrt(pi<Ball>()) * c); }

/// Gauss and Legendre: the n-point rule on [-1, 1], n >= 2, of F analytic with |F| <= M on the ellipse with rho = exp(sigma).
inline Ball gauss_legendre(const Ball& M, const Ball& sigma, long n)
{
    return Ball(64) / Ball(15) * M * exp(-Ball(2 * n) * sigma) / (Ball(1) - exp(-Ball(2) * sigma));
}

/// Gauss and Chebyshev: the n-point rule of the weight 1/sqrt(1 - z^2) on [-1, 1], n >= 1, of F with |F - m| <= M, m a constant, on the
/// ellipse with rho = exp(sigma); T_(2n) attains it.
inline Ball gauss_chebyshev(const Ball& M, const Ball& sigma, long n)
{
    Ball growth;
    const Ball exponent = Ball(2 * n) * sigma;
    arb_expm1(growth.get(), exponent.get(), WorkingPrecision::bits());
    return Ball(2) * pi<Ball>() * M / growth;
}

/// Interpolation: the rule on [-1, 1] that is exact up to degree n - 1, of a weight w; size is the integral of |w| and the sum of the sizes
/// of the rule's weights; |F - m| <= M, m a constant, on the ellipse with rho = exp(sigma), n >= 1.
inline Ball interpolation(const Ball& M, const Ball& sigma, const Ball& size, long n)
{
    return Ball(2) * M * size * exp(-Ball(n) * sigma) / (Ball(1) - exp(-sigma));
}

/// Turned path: |integral of g exp(iwz)| from X + iS upwards, |g| <= supremum.
inline Ball beyond(const Ball& supremum, const Ball& w, const Ball& S) { return supremum * exp(-w * S) / w; }

} // namespace touchstone::quadrature::lemma
