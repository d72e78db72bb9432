// SPDX-License-Identifier: MIT
/// \file
/// THE OPERATOR: what one wave does to the load ratio of a region, and so to any function of it. Everything in section 6 is a power of it.
///
/// Put G = gamma^(D-1), so that p*_{n+1} = G p*_n by (3.8), and let x = p_{n-1}/p*_n be the load ratio that scale n sees. On a wave of mean
/// x, with theta uniform on [0, pi], c = cos theta, and P the pressure in units of its own p*,
///
///     P = x + c                   where x >= 1,                                                       (2.2)
///     P^2 = (1 + c)(2x - 1 + c)   where x < 1, and no contact where that is not positive,              (2.4)
///
/// and the next scale sees y = P/G. The operator is the mean over the wave, contact lost counting nothing:
///
///     (T phi)(x) = (1/pi) int_0^pi phi(y(x, theta)) dtheta,     A_n/lambda_0 = (T^(n+1) 1)(load).                (T)
///
/// Each function below is a template over the arithmetic: `double`, `long double`, pairs of binary64, Mpfr, balls, complex balls and discs,
/// and GiNaC's symbols, which is how proofs/operator.cpp proves that all these spellings are one operator. Nothing but + - * / and square
/// roots occurs. All are inlined, into vector code too. The branch is the caller's: a ball may not know its own. Lemmas are in lemmas.hpp.
#pragma once

#include <cmath>
#include <concepts>

namespace touchstone::wave {

/// All that one wave needs.
template <class T>
concept Field = std::copyable<T> && requires(const T a, const T b) {
    { a + b } -> std::convertible_to<T>;
    { a - b } -> std::convertible_to<T>;
    { a * b } -> std::convertible_to<T>;
    { a / b } -> std::convertible_to<T>;
    { 1 - a } -> std::convertible_to<T>;
};

// ---- y(x, theta)

/// (2.2), x >= 1: P.
template <Field T>
[[gnu::always_inline]] inline T pressure_full(const T& x, const T& c)
{
    return x + c;
}
/// (2.4), x < 1: P^2; contact where it is positive.
template <Field T>
[[gnu::always_inline]] inline T pressure_partial_squared(const T& x, const T& c)
{
    return (1 + c) * (2 * x - 1 + c);
}
/// The same by a place in the contact: 1 - c = 2 x u^2, u = sin psi the share of the half-width, rest = 1 - u^2. P^2/4.
template <Field T>
[[gnu::always_inline]] inline T quarter_pressure_squared(const T& x, const T& u_squared, const T& rest)
{
    return x * rest * (1 - x * u_squared);
}

// ---- R, and theta from the pressure; gy = G y = P

/// R = x + c in partial contact: R^2 = (1 - x)^2 + P^2. The argument is 1 - x, so that it need not be a difference.
template <Field T>
[[gnu::always_inline]] inline T radius(const T& one_minus_x, const T& gy_squared)
{
    using std::sqrt;
    return sqrt(one_minus_x * one_minus_x + gy_squared);
}
/// 1 - c, x < 1, without cancellation at the centre of the contact.
template <Field T>
[[gnu::always_inline]] inline T one_minus_c_partial(const T& x, const T& R, const T& gy_squared)
{
    return (4 * x - gy_squared) / (1 + x + R);
}
/// 1 + c, x < 1.
template <Field T>
[[gnu::always_inline]] inline T one_plus_c_partial(const T& one_minus_x, const T& R)
{
    return R + one_minus_x;
}

// ---- the kernel: how theta moves with y, and with z = y^2

/// dtheta/dy = -G/sin(theta) of (2.2) as a function of the distances of y from the two ends of the wave, (x -+ 1)/G.
template <Field T>
[[gnu::always_inline]] inline T kernel_full(const T& to_high, const T& to_low)
{
    using std::sqrt;
    return 1 / sqrt(to_high * to_low);
}
/// The factor that is left of |dtheta/dy| of (2.4) when 1/((hi - y)(hi + y))^(1/2) is taken out, hi = 2 x^(1/2)/G the end of the wave:
/// dP/dR times the root of (1 + x + R)/(1 - x + R).
template <Field T>
[[gnu::always_inline]] inline T kernel_partial_rest(const T& x, const T& one_minus_x, const T& R, const T& gy)
{
    using std::sqrt;
    return gy / R * sqrt((1 + x + R) / (one_minus_x + R));
}
/// |dtheta/dy| of (2.4).
template <Field T>
[[gnu::always_inline]] inline T kernel_partial(const T& x, const T& one_minus_x, const T& R, const T& gy, const T& to_high,
                                               const T& high_plus_y)
{
    using std::sqrt;
    return gy / R * sqrt((1 + x + R) / ((one_minus_x + R) * to_high * high_plus_y));
}
/// x^(-1/2). An arithmetic may bring its own, cheaper than a root and a quotient.
template <class T>
[[gnu::always_inline]] inline T inverse_root(const T& x)
{
    using std::sqrt;
    return 1 / sqrt(x);
}
/// |dtheta/dz|, z = y^2, x >= 1.
template <Field T>
[[gnu::always_inline]] inline T kernel_full_squared(const T& x, const T& G, const T& z)
{
    using std::sqrt;
    const T gy = G * sqrt(z);
    return G / 2 * inverse_root(T(z * ((1 + x - gy) * (gy - (x - 1)))));
}
/// |dtheta/dz|, z = y^2, x < 1. R + (1 - x), not (R + 1) - x, which loses every digit next to x = 1 at small z.
template <Field T>
[[gnu::always_inline]] inline T kernel_partial_squared(const T& x, const T& G_squared, const T& z)
{
    using std::sqrt;
    const T one_minus_x = 1 - x, R_squared = one_minus_x * one_minus_x + G_squared * z, R = sqrt(R_squared), up = 1 + x + R;
    return G_squared / 2 * up * inverse_root(T(R_squared * up * ((4 * x - G_squared * z) * (R + one_minus_x))));
}

// ---- z = y^2 at sin(theta/2)^2 = q (from above) or cos(theta/2)^2 = q (from below): times G^2
/// P^2 of (2.2), x >= 1, at sin(theta/2)^2 = q: (x + 1 - 2 q)^2.
template <Field T>
[[gnu::always_inline]] inline T square_full_from_above(const T& x, const T& q)
{
    const T P = x + 1 - 2 * q;
    return P * P;
} /// P^2 of (2.2), x >= 1, at cos(theta/2)^2 = q: (x - 1 + 2 q)^2.
template <Field T>
[[gnu::always_inline]] inline T square_full_from_below(const T& x, const T& q)
{
    const T P = x - 1 + 2 * q;
    return P * P;
} /// P^2 of (2.4), x < 1, at sin(theta/2)^2 = q <= x.
template <Field T>
[[gnu::always_inline]] inline T square_partial_from_above(const T& x, const T& q)
{
    return 4 * ((1 - q) * (x - q));
} /// P^2 of (2.4), x < 1, at cos(theta/2)^2 = q >= 1 - x.
template <Field T>
[[gnu::always_inline]] inline T square_partial_from_below(const T& one_minus_x, const T& q)
{
    return 4 * (q * (q - one_minus_x));
}

// ---- backwards: the ratio x that the wave needs at theta to get to the pressure P, and its density

/// P <= 2 - u or so, full contact: x = P - c.
template <Field T>
[[gnu::always_inline]] inline T needed_full(const T& P, const T& c)
{
    return P - c;
}
/// Partial contact: x = (1 + P^2 - c^2)/(2(1 + c)).
template <Field T>
[[gnu::always_inline]] inline T needed_partial(const T& P, const T& c)
{
    return (1 + P * P - c * c) / (2 * (1 + c));
}
/// |dtheta/dx| at constant P, x < 1, less the factor 1/(x - P^2/4)^(1/2): ((1 + R - x)(1 + R + x))^(1/2)/(2 R), R^2 = (1-x)^2 + P^2.
template <Field T>
[[gnu::always_inline]] inline T needed_kernel_partial_rest(const T& x, const T& one_minus_x, const T& R)
{
    using std::sqrt;
    return sqrt((R + one_minus_x) * (1 + R + x)) / (2 * R);
}
/// dx/dP at constant theta, x < 1 (1 where x >= 1).
template <Field T>
[[gnu::always_inline]] inline T needed_slope_partial(const T& P, const T& one_minus_x, const T& R)
{
    return P / (one_minus_x + R);
}

// ---- the singular set

/// The ends of the wave of ratio x: y is within [lowest, highest].
template <Field T>
[[gnu::always_inline]] inline T highest_full(const T& x, const T& G) { return (x + 1) / G; } ///< of (2.2), x >= 1
template <Field T>
[[gnu::always_inline]] inline T lowest_full(const T& x, const T& G) { return (x - 1) / G; } ///< of (2.2), x >= 1
template <Field T>
[[gnu::always_inline]] inline T highest_partial(const T& x, const T& G)
{
    using std::sqrt;
    return 2 * sqrt(x) / G;
} ///< of (2.4), x < 1, whose lowest y is 0
/// If phi is singular at s, T phi is singular where s meets an end of the wave: at x = G s + 1 (the lower end); at G s - 1 where that is >=
/// 1, else at G^2 s^2/4 (the upper end); and at x = 1, where (2.2) and (2.4) meet. Going back, s of an exceedance goes to (s +- 1)/G, or 2
/// s^(1/2)/G where s < 1.
template <Field T>
[[gnu::always_inline]] inline T meets_lower_end(const T& s, const T& G) { return G * s + 1; } ///< x where s = lowest_full(x)
template <Field T>
[[gnu::always_inline]] inline T meets_upper_end_full(const T& s, const T& G) { return G * s - 1; } ///< x where s = highest_full(x)
template <Field T>
[[gnu::always_inline]] inline T meets_upper_end_partial(const T& s, const T& G)
{
    return G * G * s * s / 4;
} ///< x where s = highest_partial(x)

} // namespace touchstone::wave
