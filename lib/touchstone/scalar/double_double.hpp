// SPDX-License-Identifier: MIT
/// \file
/// Numbers of 106 bits as unevaluated sums of two binary64, one at a time or four side by side, with proven errors.
///
/// Each operation is one of the literature, step for step; w = 2^-53, bounds are relative and hold for pairs whose sum rounds to `high`:
///
/// | operation | algorithm | bound | proved by |
/// |---|---|---|---|
/// | sum | AccurateDWPlusDW, JMP algorithm 6 | 3 w^2 + 13 w^3 | JMP theorem 3.1; in Coq by MR (`DWPlusDW_relerr_bound`) |
/// | product | DWTimesDW1, JMP algorithm 10 | 5 w^2 | MR (`DWTimesDW1_correct_even`); JMP had 7 w^2 |
/// | quotient | DWDivDW2, JMP algorithm 17, its line 2 by algorithm 7 | 15 w^2 + 56 w^3 | JMP theorem 7.1; in Coq by MR (`DWDDW_correct`) |
/// | square root | SQRTDWtoDW, LLMPR algorithm 8 | 25/8 w^2 | LLMPR |
///
/// JMP: Joldes, Muller, Popescu, "Tight and rigorous error bounds for basic building blocks of double-word arithmetic", ACM TOMS 44, 2017.
/// MR: Muller, Rideau, "Formalization of double-word arithmetic, and comments on ...", ACM TOMS 48, 2022; in brackets the names in its Coq
/// proof. LLMPR: Lefevre, Louvet, Muller, Picot, Rideau, "Accurate calculation of Euclidean norms using double-word arithmetic", ACM TOMS
/// 49, 2023.
/// All of these need the rounding mode to nearest, and the product's bound ties to even (with other ties it is 5.5 w^2): the mode that
/// require_binary64_arithmetic() asks for. They assume that nothing overflows and no rounded result is subnormal.
/// So no operation is off by more than 2^-102, cancellation or not, while nothing leaves 1e-270 ... 1e270.
/// Results do not depend on whether the machine has a fused multiply-add: std::fma is exact by definition.
/// Not to be compiled with -ffast-math (binary64.hpp refuses); fused contraction of a * b + c by the compiler must be off.
#pragma once

#include "touchstone/scalar/binary64.hpp"

#include <cmath>
#include <type_traits>

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wpsabi" // everything with Lanes is inlined, without optimisation too: see TOUCHSTONE_INLINE
#endif

namespace touchstone {

/// Four binary64 side by side (GCC and clang; without such registers the compiler takes them apart).
using Lanes = double __attribute__((vector_size(32)));

/// Also for constructors: a clone for newer machines hands Lanes over in another register than a function that was compiled for all
/// expects.
#define TOUCHSTONE_INLINE [[gnu::always_inline]] inline
// The runtime of the thread sanitizer starts after clones are chosen.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_THREAD__)
#define TOUCHSTONE_CLONES [[gnu::target_clones("default", "arch=x86-64-v3")]] // the same results, faster
#else
#define TOUCHSTONE_CLONES
#endif

namespace double_double {

TOUCHSTONE_INLINE double fused(double a, double b, double c) { return __builtin_fma(a, b, c); }
TOUCHSTONE_INLINE Lanes fused(Lanes a, Lanes b, Lanes c)
{
    Lanes r{};
    for (int i = 0; i < 4; ++i) r[i] = __builtin_fma(a[i], b[i], c[i]);
    return r;
}
TOUCHSTONE_INLINE double root(double a) { return __builtin_sqrt(a); }
TOUCHSTONE_INLINE Lanes root(Lanes a)
{
    Lanes r{};
    for (int i = 0; i < 4; ++i) r[i] = __builtin_sqrt(a[i]);
    return r;
}
TOUCHSTONE_INLINE double divisor(double a) { return a > 0 ? a : 1; }
TOUCHSTONE_INLINE Lanes divisor(Lanes a) { return a > 0 ? a : Lanes{} + 1; }

} // namespace double_double

template <class D>
struct DoubleDouble {
    D high{}, low{};

    constexpr DoubleDouble() = default;
    TOUCHSTONE_INLINE constexpr DoubleDouble(D h, D l) : high(h), low(l) {}
    template <class T>
        requires std::is_arithmetic_v<T>
    TOUCHSTONE_INLINE constexpr DoubleDouble(T v) : high(D{} + static_cast<double>(v)) // integers: below 2^53
    {
    }
    template <class E>
        requires(std::is_same_v<E, double> && !std::is_same_v<D, double>)
    TOUCHSTONE_INLINE constexpr DoubleDouble(const DoubleDouble<E>& v) : high(D{} + v.high), low(D{} + v.low)
    {
    }

    explicit operator double() const { return high; } // D = double: the nearest

    /// a + b where |a| >= |b| or a = 0
    TOUCHSTONE_INLINE static DoubleDouble fast_two_sum(D a, D b)
    {
        const D s = a + b;
        return {s, b - (s - a)};
    }
    TOUCHSTONE_INLINE static DoubleDouble two_sum(D a, D b)
    {
        const D s = a + b, t = s - b;
        return {s, (a - t) + (b - (s - t))};
    }
    TOUCHSTONE_INLINE static DoubleDouble two_product(D a, D b)
    {
        const D p = a * b;
        return {p, double_double::fused(a, b, -p)};
    }

    TOUCHSTONE_INLINE friend DoubleDouble operator+(const DoubleDouble& x, const DoubleDouble& y)
    {
        const auto s = two_sum(x.high, y.high), t = two_sum(x.low, y.low);
        const auto v = fast_two_sum(s.high, s.low + t.high);
        return fast_two_sum(v.high, t.low + v.low);
    }
    TOUCHSTONE_INLINE DoubleDouble operator-() const { return {-high, -low}; }
    TOUCHSTONE_INLINE friend DoubleDouble operator-(const DoubleDouble& x, const DoubleDouble& y) { return x + -y; }
    TOUCHSTONE_INLINE friend DoubleDouble operator*(const DoubleDouble& x, const DoubleDouble& y)
    {
        const auto c = two_product(x.high, y.high);
        return fast_two_sum(c.high, c.low + (x.high * y.low + x.low * y.high));
    }
    TOUCHSTONE_INLINE friend DoubleDouble operator/(const DoubleDouble& x, const DoubleDouble& y)
    {
        const D t = x.high / y.high;
        const auto c = two_product(y.high, t); // t y, algorithm 7
        const auto s = fast_two_sum(c.high, y.low * t);
        const auto r = fast_two_sum(s.high, s.low + c.low);
        return fast_two_sum(t, ((x.high - r.high) + (x.low - r.low)) / y.high);
    }
    /// x >= 0
    TOUCHSTONE_INLINE friend DoubleDouble sqrt(const DoubleDouble& x)
    {
        const D s = double_double::root(x.high);
        const D rest = x.low + double_double::fused(-s, s, x.high);
        return fast_two_sum(s, rest / (2 * double_double::divisor(s)));
    }
    /// x^(-1/2), x > 0, within 2^-102 of itself. With s near the root and t near 1/s, d = x - s^2 and e = 1 - s t it is t (1 + e - d t^2/2
    /// + ...): what follows is below 7/4 2^-105 and the roundings are below 7/2 2^-105, as 1 - s t and s^2's distance from the head of x
    /// are exact.
    TOUCHSTONE_INLINE friend DoubleDouble inverse_root(const DoubleDouble& x)
    {
        using double_double::fused;
        const D s = double_double::root(x.high), t = 1 / s;
        const D d = x.low + fused(-s, s, x.high), e = fused(-s, t, D{} + 1);
        return fast_two_sum(t, t * (e - 0.5 * d * t * t));
    }
    DoubleDouble& operator+=(const DoubleDouble& y) { return *this = *this + y; }
    DoubleDouble& operator-=(const DoubleDouble& y) { return *this = *this - y; }
    DoubleDouble& operator*=(const DoubleDouble& y) { return *this = *this * y; }
    DoubleDouble& operator/=(const DoubleDouble& y) { return *this = *this / y; }

    friend bool operator==(const DoubleDouble& x, const DoubleDouble& y) { return x.high == y.high && x.low == y.low; }
    friend auto operator<=>(const DoubleDouble& x, const DoubleDouble& y)
    {
        const auto first = x.high <=> y.high;
        return first == 0 ? x.low <=> y.low : first;
    }
    friend DoubleDouble abs(const DoubleDouble& x) { return x.high < 0 ? -x : x; }
};

/// max(0, x), lane by lane
TOUCHSTONE_INLINE DoubleDouble<double> positive_part(const DoubleDouble<double>& x) { return x.high > 0 ? x : DoubleDouble<double>{}; }
TOUCHSTONE_INLINE DoubleDouble<Lanes> positive_part(const DoubleDouble<Lanes>& x)
{
    return {x.high > 0 ? x.high : Lanes{}, x.high > 0 ? x.low : Lanes{}};
}

} // namespace touchstone
