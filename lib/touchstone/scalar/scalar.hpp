// SPDX-License-Identifier: MIT
/// \file
/// The Scalar concept: what a number must offer so that a formula of the paper,
/// written once as a template, runs on it.
///
/// | model                 | header      | what a formula returns                            |
/// |-----------------------|-------------|---------------------------------------------------|
/// | `double`              | scalar.hpp  | a binary64 number within a few ulp                 |
/// | `Mpfr`                | mpfr.hpp    | that many digits, not proven                       |
/// | `Ball`, `ComplexBall` | ball.hpp    | an enclosure of the true value: a proof            |
/// | `Symbol` (GiNaC)      | symbol.hpp  | an expression                                      |
/// | `Exact`               | exact.hpp   | the value r s^(1/m) pi^k itself, or `NotExact`     |
///
/// Formulas hold no decimal literals: constants are integers, `ratio<p, q, T>()`
/// and `pi<T>()`. `Ball`, `Symbol` and `Exact` enforce that, having no arithmetic
/// with `double`. Functions are called unqualified (`sqrt(x)`, `atan2(y, x)`): for
/// `double` the overloads below are found, for the others their own namespace's.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
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

constexpr Truth truth(bool decided) { return decided ? Truth::yes : Truth::no; }
constexpr bool certainly(Truth t) { return t == Truth::yes; }
constexpr bool possibly(Truth t) { return t != Truth::no; }

// ---------------------------------------------------------------- double

inline double sqrt(double x) { return std::sqrt(x); }
inline double exp(double x) { return std::exp(x); }
inline double log(double x) { return std::log(x); }
inline double sin(double x) { return std::sin(x); }
inline double cos(double x) { return std::cos(x); }
inline double asin(double x) { return std::asin(x); }
inline double acos(double x) { return std::acos(x); }
inline double atan2(double y, double x) { return std::atan2(y, x); }
inline double pow(double x, double y) { return std::pow(x, y); }

inline Truth less(double x, double y) { return truth(x < y); }
inline double hull(double x, double y) { return x == y ? x : std::numeric_limits<double>::quiet_NaN(); }
inline double at_most(double x, double bound) { return std::min(x, bound); }
inline double at_least(double x, double bound) { return std::max(x, bound); }

/// Customisation point: how a Scalar makes constants, and the few compound
/// operations that some arithmetics do better than by composing the others.
template <class T>
struct ScalarTraits;

template <>
struct ScalarTraits<double> {
    static double integer(long n) { return static_cast<double>(n); }
    static double quotient(long p, long q) { return static_cast<double>(p) / static_cast<double>(q); }
    static double pi() { return std::numbers::pi; }
    /// error < 1 ulp: reduced exactly to [0, 1/4], so no digit is lost near a zero.
    static double sin_pi(double x)
    {
        const double turn = std::remainder(x, 2.0); // exact
        const double a = std::fabs(turn);           // sin(pi a) = sin(pi (1 - a))
        const double r = a > 0.5 ? 1.0 - a : a;     // exact (Sterbenz)
        const double s = r > 0.25 ? std::cos(std::numbers::pi * (0.5 - r)) : std::sin(std::numbers::pi * r);
        return std::copysign(s, turn);
    }
    static double cos_pi(double x)
    {
        const double a = std::fabs(std::remainder(x, 2.0)); // exact, in [0, 1]
        const double r = a > 0.5 ? 1.0 - a : a;
        const double c = r > 0.25 ? std::sin(std::numbers::pi * (0.5 - r)) : std::cos(std::numbers::pi * r);
        return a > 0.5 ? -c : c;
    }
    static double powm1(double x, double y) { return std::expm1(y * std::log(x)); }
    /// a - b*b with one rounding.
    static double minus_square(double a, double b) { return std::fma(-b, b, a); }
    static double sqrt_positive_part(double x) { return x > 0 ? std::sqrt(x) : 0.0; }
    /// sqrt(a*a + b*b) without overflow, underflow or cancellation.
    static double hypot(double a, double b) { return std::hypot(a, b); }
    static double power_of_two(long e) { return std::ldexp(1.0, static_cast<int>(std::clamp(e, -5000L, 5000L))); }
    /// Gamma(x) for x > 0.
    static double gamma(double x) { return std::tgamma(x); }
};

/// The integer n as a T, exactly.
template <class T>
T integer(long n) { return ScalarTraits<T>::integer(n); }

/// p/q as a T: correctly rounded, enclosed or exact, as T has it.
template <long p, long q, class T>
T ratio() { return ScalarTraits<T>::quotient(p, q); }

template <class T>
T pi() { return ScalarTraits<T>::pi(); }

template <class T> T sin_pi(const T& x) { return ScalarTraits<T>::sin_pi(x); }   ///< sin(pi x)
template <class T> T cos_pi(const T& x) { return ScalarTraits<T>::cos_pi(x); }   ///< cos(pi x)
template <class T> T powm1(const T& x, const T& y) { return ScalarTraits<T>::powm1(x, y); } ///< x^y - 1
template <class T> T minus_square(const T& a, const T& b) { return ScalarTraits<T>::minus_square(a, b); } ///< a - b^2
template <class T> T sqrt_positive_part(const T& x) { return ScalarTraits<T>::sqrt_positive_part(x); } ///< sqrt(max(x, 0))
template <class T> T hypot_of(const T& a, const T& b) { return ScalarTraits<T>::hypot(a, b); } ///< sqrt(a^2 + b^2)
template <class T> T power_of_two(long e) { return ScalarTraits<T>::power_of_two(e); } ///< 2^e
template <class T> T gamma_function(const T& x) { return ScalarTraits<T>::gamma(x); }  ///< Euler's Gamma(x)

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
/// the part of x on its side, so neither leaves its domain.
template <OrderedScalar T, class Below, class Above>
T across_seam(const T& x, const T& seam, Below&& below, Above&& above)
{
    const Truth t = less(x, seam);
    if (certainly(t)) return below(x);
    if (!possibly(t)) return above(x);
    return hull(below(at_most(x, seam)), above(at_least(x, seam)));
}

} // namespace touchstone
