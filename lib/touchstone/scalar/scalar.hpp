// SPDX-License-Identifier: MIT
/// \file
/// The Scalar concept: what a number must offer so that a formula of the paper,
/// written once as a template, runs on it.
///
/// | model                 | header      | what a formula returns                            |
/// |-----------------------|-------------|---------------------------------------------------|
/// | `double`              | scalar.hpp  | a binary64 number within a few ulp                 |
/// | `Mpfr`                | mpfr.hpp    | that many digits, not proven                       |
/// | `Ball`, `ComplexBall` | ball.hpp    | an enclosure, a proof; `PairBall`, pair_ball.hpp: in 100 bits |
/// | `Symbol` (GiNaC)      | symbol.hpp  | an expression                                      |
/// | `Exact`               | exact.hpp   | the value r s^(1/m) pi^k itself, or `NotExact`     |
///
/// Formulas hold no decimal literals: constants are integers, `ratio<p, q, T>()`
/// and `pi<T>()`. `Ball`, `Symbol` and `Exact` enforce that, having no arithmetic
/// with `double`. Functions are called unqualified (`sqrt(x)`, `atan2(y, x)`): for
/// `double` the overloads below are found, for the others their own namespace's.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <type_traits>
#include <utility>

namespace touchstone {

/// An argument outside the domain of a quantity. `what()` is one line that says
/// what was wrong and what would be right.
class DomainError : public std::domain_error {
    using std::domain_error::domain_error;
};

/// What a comparison of enclosures can say.
enum class Truth { no, unknown, yes };

constexpr Truth truth(bool decided) { return decided ? Truth::yes : Truth::no; } ///< of what a plain comparison says
constexpr bool certainly(Truth t) { return t == Truth::yes; } ///< proven
constexpr bool possibly(Truth t) { return t != Truth::no; } ///< not disproven

// ---------------------------------------------------------------- double

/// sum_j terms[j] x^j, even and odd powers side by side, so that a processor can work on both.
template <std::size_t n>
constexpr double sum_of_powers(const std::array<double, n>& terms, double x)
{
    static_assert(n % 2 == 0);
    const double square = x * x;
    double even = terms[n - 2], odd = terms[n - 1];
    for (std::size_t j = n - 2; j != 0; j -= 2) {
        even = even * square + terms[j - 2];
        odd = odd * square + terms[j - 1];
    }
    return even + x * odd;
}

/// 2^(2k-1)/(2k)! for k = 2, ..., 11 with alternating signs: sin^2 y = y^2 - y^4 sum_of_powers(sine_terms, y^2); at y = pi/4 the next adds
/// less than 2^-64.
inline constexpr std::array<double, 10> sine_terms = [] {
    std::array<double, 10> terms{};
    double term = 1.0 / 3;
    for (int j = 0; j < 10; ++j) {
        terms[static_cast<std::size_t>(j)] = term;
        term *= -4.0 / ((2 * j + 5) * (2 * j + 6));
    }
    return terms;
}();

inline double sqrt(double x) { return std::sqrt(x); } ///< square root
inline double exp(double x) { return std::exp(x); } ///< e^x
inline double log(double x) { return std::log(x); } ///< natural logarithm
inline double sin(double x) { return std::sin(x); } ///< sine, x in radians
inline double cos(double x) { return std::cos(x); } ///< cosine, x in radians
inline double asin(double x) { return std::asin(x); } ///< in [-pi/2, pi/2]
inline double acos(double x) { return std::acos(x); } ///< in [0, pi]
inline double atan2(double y, double x) { return std::atan2(y, x); } ///< the angle of (x, y), in [-pi, pi]
inline double pow(double x, double y) { return std::pow(x, y); } ///< x^y


/// Customisation point: how a Scalar makes constants, and the few compound
/// operations that some arithmetics do better than by composing the others.
template <class T>
struct ScalarTraits;

/// The compound operations as their composition: what an arithmetic gets that has no better way.
template <class T>
struct ComposedTraits {
    static T pow_product(const T& x, const T& a, const T& b) { return pow(x, T(a * b)); } ///< x^(a b)
    static T sqrt_minus_square(const T& a, const T& b) { return ScalarTraits<T>::sqrt_positive_part(a - b * b); } ///< sqrt(max(a - b^2, 0))
    static T sqrt_minus_pi_square(const T& a, const T& x) { return sqrt_minus_square(a, T(ScalarTraits<T>::pi() * x)); } ///< b = pi x
    static T sqrt_minus_sin_pi_square(const T& a, const T& x) { return sqrt_minus_square(a, ScalarTraits<T>::sin_pi(x)); } ///< b = sin pi x
    static T sqrt_square_minus(const T& b, const T& a) { return ScalarTraits<T>::sqrt_positive_part(b * b - a); } ///< sqrt(max(b^2 - a, 0))
    static T sqrt_pi_square_minus(const T& x, const T& a) { return sqrt_square_minus(T(ScalarTraits<T>::pi() * x), a); } ///< b = pi x
    static T sqrt_sin_pi_square_minus(const T& x, const T& a) { return sqrt_square_minus(ScalarTraits<T>::sin_pi(x), a); } ///< b = sin pi x
    static T asin_sqrt_over_pi(const T& s)
    {
        return atan2(sqrt(s), ScalarTraits<T>::sqrt_positive_part(T(1 - s))) / ScalarTraits<T>::pi();
    } ///< arcsin(sqrt s)/pi
    static T atan_sqrt_over_pi(const T& n, const T& d)
    {
        return atan2(ScalarTraits<T>::sqrt_positive_part(n), ScalarTraits<T>::sqrt_positive_part(d)) / ScalarTraits<T>::pi();
    } ///< arctan(sqrt(n/d))/pi
    static T atan_minus_square_over_pi(const T& a, const T& b, const T& d)
    {
        return atan2(ScalarTraits<T>::sqrt_minus_square(a, b), sqrt(d)) / ScalarTraits<T>::pi();
    } ///< n = a - b^2
};
/// binary64: the formulas lose a few ulp, at the edges of the contact too.
template <>
struct ScalarTraits<double> {
    static double integer(long n) { return static_cast<double>(n); } ///< n, exact up to 2^53
    static double quotient(long p, long q) { return static_cast<double>(p) / static_cast<double>(q); } ///< p/q rounded to nearest
    static double pi() { return std::numbers::pi; } ///< the double nearest to pi
    static Truth less(double x, double y) { return truth(x < y); } ///< always decided; no for a NaN
    static double hull(double x, double y) { return x == y ? x : std::numeric_limits<double>::quiet_NaN(); } ///< NaN unless equal
    /// error < 2 ulp: reduced exactly to [0, 1/2], where a relative error of the angle becomes no larger one of the sine.
    static double sin_pi(double x)
    {
        const double turn = within_a_turn(x);       // exact
        const double a = std::fabs(turn);           // sin(pi a) = sin(pi (1 - a))
        return std::copysign(std::sin(std::numbers::pi * std::min(a, 1.0 - a)), turn); // exact (Sterbenz) where it is taken
    }
    /// cos(pi x) = sin(pi (1/2 - x)), error < 2 ulp; the difference is exact from 1/4 on, below it is as good as a rounded angle.
    static double cos_pi(double x) { return std::sin(std::numbers::pi * (0.5 - std::fabs(within_a_turn(x)))); }
    static double powm1(double x, double y) { return std::expm1(y * std::log(x)); } ///< x^y - 1 for x > 0
    static double sqrt_positive_part(double x) { return x > 0 ? std::sqrt(x) : 0.0; } ///< sqrt(max(x, 0))
    /// a - b^2 within an ulp and a half, and with one rounding below 2^-40 a: the sign is right. Where fma is a call of the C library,
    /// which takes longer than all the rest, the first 24 bits of b are squared by themselves: that and twice their product with the
    /// others are exact.
    static double minus_square(double a, double b)
    {
#ifndef FP_FAST_FMA
        const double head = static_cast<float>(b), tail = b - head;
        const double difference = ((a - head * head) - 2 * head * tail) - tail * tail;
        if (a > 0x1p-200 && std::fabs(difference) > 0x1p-40 * a)
            return difference; // else float may have too few bits, or the square of the tail
#endif
        return std::fma(-b, b, a);
    }
    /// sqrt(max(a - b^2, 0)), the difference with one rounding and safe from underflow.
    static double sqrt_minus_square(double a, double b)
    {
        const int e = scale(a);
        if (e == 0) return sqrt_positive_part(std::fma(-b, b, a));
        return std::ldexp(sqrt_positive_part(std::fma(-std::ldexp(b, e), std::ldexp(b, e), std::ldexp(a, 2 * e))), -e);
    }
    /// sqrt(max(a - (pi x)^2, 0)) with pi x carried to twice the precision.
    static double sqrt_minus_pi_square(double a, double x)
    {
        const int e = scale(a);
        if (e == 0) return sqrt_positive_part(minus_pi_square(a, x));
        return std::ldexp(sqrt_positive_part(minus_pi_square(std::ldexp(a, 2 * e), std::ldexp(x, e))), -e);
    }
    /// sqrt(max(a - sin^2(pi x), 0)) for 0 <= a <= 1, |x| <= 1/2. Above x = 1/4 as cos^2 - (1 - a), below as
    /// a - y^2 + (y^2 - sin^2 y), y = pi x: each difference that can cancel is taken between accurate terms.
    static double sqrt_minus_sin_pi_square(double a, double x)
    {
        const double r = std::fabs(x);
        const bool far = r > 0.25;
        if (!far && scale(a) != 0) return sqrt_minus_pi_square(a, x); // sin y = y to all digits
        const double difference = minus_sin_square(far ? 1.0 - a : a, far ? 0.5 - r : r); // 1 - a exact where it matters: a > 1/2
        return sqrt_positive_part(far ? -difference : difference);
    }
    /// sqrt(max((pi x)^2 - a, 0)), as above.
    static double sqrt_pi_square_minus(double x, double a)
    {
        const int e = scale(a);
        if (e == 0) return sqrt_positive_part(-minus_pi_square(a, x));
        if (std::fabs(x) > 0x1p-300) return std::numbers::pi * std::fabs(x); // a is below all its digits
        return std::ldexp(sqrt_positive_part(-minus_pi_square(std::ldexp(a, 2 * e), std::ldexp(x, e))), -e);
    }
    /// sqrt(max(sin^2(pi x) - a, 0)) for 0 <= a <= 1, |x| <= 1/2, as above; 1 - a is exact or the difference no small one.
    static double sqrt_sin_pi_square_minus(double x, double a)
    {
        const double r = std::fabs(x);
        const bool far = r > 0.25 && (a >= 0.5 || r > 0.3);
        if (!far && scale(a) != 0) return r > 0x1p-300 ? sin_pi(r) : sqrt_pi_square_minus(x, a);
        const double difference = minus_sin_square(far ? 1.0 - a : a, far ? 0.5 - r : r);
        return sqrt_positive_part(far ? difference : -difference);
    }
    /// arcsin(sqrt s)/pi for 0 <= s <= 1, 1/2 beyond. Of s and 1 - s (exact where it is taken) the one whose arcsine is at most pi/4, where
    /// it is well conditioned; so too in the next two.
    static double asin_sqrt_over_pi(double s)
    {
        const double r = std::asin(std::sqrt(std::min(std::max(1.0 - s, 0.0), s))) / std::numbers::pi;
        return (s > 0.5 ? 0.5 : 0.0) + std::copysign(r, 0.5 - s); // s may lie on either side at random: no branch
    }
    /// arctan(sqrt(n/d))/pi, where a negative n or d counts as 0; not both.
    static double atan_sqrt_over_pi(double n, double d)
    {
        n = std::max(n, 0.0);
        d = std::max(d, 0.0);
        const double r = std::asin(std::sqrt(std::min(n, d) / (n + d))) / std::numbers::pi;
        return (n > d ? 0.5 : 0.0) + std::copysign(r, d - n);
    }
    /// arctan(sqrt((a - b^2)/d))/pi for d >= 0, the difference with one rounding and safe from underflow.
    static double atan_minus_square_over_pi(double a, double b, double d)
    {
        if (scale(a) != 0) return std::atan2(sqrt_minus_square(a, b), std::sqrt(d)) / std::numbers::pi;
        return atan_sqrt_over_pi(std::fma(-b, b, a), d);
    }
    /// sqrt(a*a + b*b) without overflow, underflow or cancellation; error < 1.5 ulp.
    static double hypot(double a, double b)
    {
        if (b == 0) return std::fabs(a);
        const double square = a * a + b * b;
        return square > 0x1p-900 && square < 0x1p900 ? std::sqrt(square)
                                                     : std::hypot(a, b); // what underflows beside 2^-900 is below its digits
    }
    static double power_of_two(long e) { return std::ldexp(1.0, static_cast<int>(std::clamp(e, -5000L, 5000L))); } ///< 2^e
    /// Gamma(x) for x > 0.
    static double gamma(double x) { return std::tgamma(x); }
    /// x^(a b): what the rounded exponent leaves out is put back to first order.
    static double pow_product(double x, double a, double b)
    {
        const double e = a * b;
        return std::pow(x, e) * (1.0 + std::fma(a, b, -e) * std::log(x));
    }

private:
    /// x less its nearest even number, exactly.
    static double within_a_turn(double x) { return std::fabs(x) <= 1.0 ? x : std::remainder(x, 2.0); }
    /// A power of two (its exponent) by which numbers whose square is near tiny `a` are scaled, 0 where none is needed.
    static int scale(double a) { return a > 0 && a < 0x1p-800 ? 500 : 0; }
    /// a - (pi x)^2
    static double minus_pi_square(double a, double x)
    {
        const double y = std::numbers::pi * x;
        const double low = std::fma(std::numbers::pi, x, -y) + std::sin(std::numbers::pi) * x; // sin(fl(pi)) = pi - fl(pi) to all digits
        return std::fma(-y, y, a) - 2 * y * low;
    }
    /// a - sin^2(pi x) for |x| <= 1/4: y^2 - sin^2 y = y^4/3 - 2 y^6/45 + ..., the terms 2^(2k-1) y^(2k)/(2k)!
    static double minus_sin_square(double a, double x)
    {
        const double z = (std::numbers::pi * x) * (std::numbers::pi * x);
        return minus_pi_square(a, x) + z * z * sum_of_powers(sine_terms, z);
    }
};

/// The integer n as a T, exactly.
template <class T>
T integer(long n) { return ScalarTraits<T>::integer(n); }

/// p/q as a T: correctly rounded, enclosed or exact, as T has it.
template <long p, long q, class T>
T ratio() { return ScalarTraits<T>::quotient(p, q); }
/// pi as a T.
template <class T>
T pi() { return ScalarTraits<T>::pi(); }

template <class T> T sin_pi(const T& x) { return ScalarTraits<T>::sin_pi(x); }   ///< sin(pi x)
template <class T> T cos_pi(const T& x) { return ScalarTraits<T>::cos_pi(x); }   ///< cos(pi x)
template <class T> T powm1(const T& x, const T& y) { return ScalarTraits<T>::powm1(x, y); } ///< x^y - 1
template <class T> T pow_product(const T& x, const T& a, const T& b) { return ScalarTraits<T>::pow_product(x, a, b); } ///< x^(a b)
template <class T>
T sqrt_minus_square(const T& a, const T& b)
{
    return ScalarTraits<T>::sqrt_minus_square(a, b);
} ///< sqrt(max(a - b^2, 0))
template <class T>
T sqrt_minus_pi_square(const T& a, const T& x)
{
    return ScalarTraits<T>::sqrt_minus_pi_square(a, x);
} ///< sqrt(max(a - (pi x)^2, 0))
template <class T>
T sqrt_pi_square_minus(const T& x, const T& a)
{
    return ScalarTraits<T>::sqrt_pi_square_minus(x, a);
} ///< sqrt(max((pi x)^2 - a, 0))
template <class T>
T sqrt_sin_pi_square_minus(const T& x, const T& a)
{
    return ScalarTraits<T>::sqrt_sin_pi_square_minus(x, a);
} ///< sqrt(max(sin(pi x)^2 - a, 0))
template <class T>
T sqrt_minus_sin_pi_square(const T& a, const T& x)
{
    return ScalarTraits<T>::sqrt_minus_sin_pi_square(a, x);
} ///< sqrt(max(a - sin(pi x)^2, 0))
template <class T> T asin_sqrt_over_pi(const T& s) { return ScalarTraits<T>::asin_sqrt_over_pi(s); } ///< arcsin(sqrt s)/pi
template <class T>
T atan_sqrt_over_pi(const T& n, const T& d)
{
    return ScalarTraits<T>::atan_sqrt_over_pi(n, d);
} ///< arctan(sqrt(n/d))/pi
template <class T>
T atan_minus_square_over_pi(const T& a, const T& b, const T& d)
{
    return ScalarTraits<T>::atan_minus_square_over_pi(a, b, d);
} ///< arctan(sqrt((a - b^2)/d))/pi
template <class T> T sqrt_positive_part(const T& x) { return ScalarTraits<T>::sqrt_positive_part(x); } ///< sqrt(max(x, 0))
template <class T> T hypot_of(const T& a, const T& b) { return ScalarTraits<T>::hypot(a, b); } ///< sqrt(a^2 + b^2)
template <class T> T power_of_two(long e) { return ScalarTraits<T>::power_of_two(e); } ///< 2^e
template <class T> T gamma_function(const T& x) { return ScalarTraits<T>::gamma(x); }  ///< Euler's Gamma(x)

// Order, for arithmetics whose type is not of this namespace (ADL would not find overloads).
template <class T>
concept OrderedByTraits = requires(const T x, const T y) { { ScalarTraits<T>::less(x, y) } -> std::same_as<Truth>; };
template <OrderedByTraits T> Truth less(const T& x, const T& y) { return ScalarTraits<T>::less(x, y); } ///< x < y
template <OrderedByTraits T> T hull(const T& x, const T& y) { return ScalarTraits<T>::hull(x, y); } ///< both
template <OrderedByTraits T>
T at_most(const T& x, const T& bound)
{
    return ScalarTraits<T>::less(bound, x) == Truth::yes ? bound : x;
} ///< min
template <OrderedByTraits T>
T at_least(const T& x, const T& bound)
{
    return ScalarTraits<T>::less(x, bound) == Truth::yes ? bound : x;
} ///< max

template <class T>
concept Scalar = std::copyable<T> && requires(const T x, const T y, long n) {
    { x + y } -> std::convertible_to<T>;
    { x - y } -> std::convertible_to<T>;
    { x * y } -> std::convertible_to<T>;
    { x / y } -> std::convertible_to<T>;
    { -x } -> std::convertible_to<T>;
    { sqrt(x) } -> std::convertible_to<T>;
    { atan2(y, x) } -> std::convertible_to<T>;
    { pow(x, y) } -> std::convertible_to<T>;
    { ScalarTraits<T>::integer(n) } -> std::convertible_to<T>;
    { ScalarTraits<T>::pi() } -> std::convertible_to<T>;
    { ScalarTraits<T>::sin_pi(x) } -> std::convertible_to<T>;
};

/// A Scalar whose order can be asked for. Symbols have none: for them call the
/// formula of one regime (`pressure_partial`), not the one that chooses.
template <class T>
concept OrderedScalar = Scalar<T> && requires(const T x, const T y) {
    { less(x, y) } -> std::same_as<Truth>;
    { hull(x, y) } -> std::convertible_to<T>;
    { at_most(x, y) } -> std::convertible_to<T>;
    { at_least(x, y) } -> std::convertible_to<T>;
};

/// The value of a function that is given by `below()` where x < seam and by
/// `above()` where x >= seam, and is **continuous** at the seam. An enclosure
/// that straddles the seam gets the hull of both branches; each branch is handed
/// the part of x on its side, rounded outward (so a branch that ends at the seam
/// takes its root with sqrt_positive_part).
template <OrderedScalar T, class Below, class Above>
T across_seam(const T& x, const T& seam, Below&& below, Above&& above)
{
    const Truth t = less(x, seam);
    if (certainly(t)) return below(x);
    if (!possibly(t)) return above(x);
    return hull(below(at_most(x, seam)), above(at_least(x, seam)));
}

} // namespace touchstone
