// SPDX-License-Identifier: MIT
/// \file
/// Balls whose midpoint is a pair of binary64 numbers and whose radius is one: enclosures of some 100 bits at the price of tens of
/// floating-point operations, for a formula of the paper at many points.
///
/// Nothing is counted by hand: each operation carries the radii of its operands through (a running error analysis), adds 2^-102 of its
/// result for its own rounding (the theorems cited in double_double.hpp), and multiplies the radius by 1 + 2^-40, more than the rounding of
/// the few binary64 operations that made it. Midpoints stay between 2^-430 and 2^430 or are zero, so that no product of two loses a bit to
/// underflow; beyond, and for what is not provided here, the radius is infinite: a ball that knows nothing and decides nothing.
/// Compile with -ffp-contract=off. The theorems need the rounding mode to nearest, ties to even.
#pragma once

#include "touchstone/scalar/ball.hpp"
#include "touchstone/scalar/double_double.hpp"

#include <array>
#include <optional>

namespace touchstone {

/// What is enclosed is within `radius()` of `middle()`.
class PairBall {
public:
    using Pair = DoubleDouble<double>;

    PairBall() = default;
    template <std::integral I>
    PairBall(I n) : PairBall(exactly(static_cast<double>(n))) {} ///< n, exactly: integers of a formula are below 2^53
    PairBall(double) = delete; ///< a decimal literal in a formula does not compile; see exactly()
    TOUCHSTONE_INLINE static PairBall exactly(double x) { return {Pair(x), 0}; } ///< radius 0, where x is neither too large nor too small
    static PairBall around(const Ball&); ///< encloses all of it
    static PairBall indeterminate() { return {Pair(0), unknown}; } ///< holds every number

    const Pair& middle() const { return middle_; } ///< a number of 106 bits
    double radius() const { return radius_; } ///< infinite or NaN where nothing is known

    /// Exact of two binary64 numbers, as their product is: a - b^2 then loses nothing where it vanishes.
    TOUCHSTONE_INLINE friend PairBall operator+(const PairBall& x, const PairBall& y)
    {
        const Pair m = x.middle_ + y.middle_;
        return {m, rounded_up(x.radius_ + y.radius_ + (both_short(x, y) ? 0 : rounding(m)))};
    }
    TOUCHSTONE_INLINE PairBall operator-() const { return {-middle_, radius_}; }
    TOUCHSTONE_INLINE friend PairBall operator-(const PairBall& x, const PairBall& y) { return x + -y; }
    TOUCHSTONE_INLINE friend PairBall operator*(const PairBall& x, const PairBall& y)
    {
        const Pair m = x.middle_ * y.middle_;
        return {m, rounded_up(size(x) * y.radius_ + (size(y) + y.radius_) * x.radius_ + (both_short(x, y) ? 0 : rounding(m)))};
    }
    /// With y of relative radius 2^-50 at most, dividing by the midpoint instead of by the least |y| is within rounded_up().
    TOUCHSTONE_INLINE friend PairBall operator/(const PairBall& x, const PairBall& y)
    {
        const Pair m = x.middle_ / y.middle_;
        const double r = (x.radius_ + std::fabs(m.high) * y.radius_) / size(y) + rounding(m);
        return {m, y.radius_ <= 0x1p-50 * size(y) ? rounded_up(r) : unknown};
    }
    /// sqrt(max(x, 0)): |sqrt x - sqrt m| <= |x - m|/sqrt m.
    TOUCHSTONE_INLINE static PairBall root(const PairBall& x)
    {
        if (x.middle_.high > 0) {
            const Pair m = sqrt(x.middle_);
            return {m, rounded_up(x.radius_ / m.high + rounding(m))};
        }
        return x.radius_ <= -x.middle_.high * 0.5 ? PairBall() : indeterminate();
    }
    TOUCHSTONE_INLINE friend PairBall sqrt(const PairBall& x) { return x.middle_.high >= 0 ? root(x) : indeterminate(); } ///< x >= 0

    TOUCHSTONE_INLINE friend Truth less(const PairBall& x, const PairBall& y)
    {
        const PairBall d = y - x;
        if (d.middle_.high * 0.5 > d.radius_) return Truth::yes; // |low| is far below half of |high|
        return -d.middle_.high * 0.5 > d.radius_ || (d.middle_.high == 0 && d.radius_ == 0) ? Truth::no : Truth::unknown;
    }
    friend PairBall hull(const PairBall&, const PairBall&) { return indeterminate(); } ///< across a seam that the midpoints are too near to
    TOUCHSTONE_INLINE friend PairBall at_most(const PairBall& x, const PairBall& bound) { return certainly(less(bound, x)) ? bound : x; }
    TOUCHSTONE_INLINE friend PairBall at_least(const PairBall& x, const PairBall& bound) { return certainly(less(x, bound)) ? bound : x; }

    /// The binary64 number that every number of the ball rounds to, if there is one; nothing too where the value may be a binary64 number
    /// itself, as a value in exact arithmetic is, but for zero. Rounding is monotonic, so that the two ends decide (Ziv's test).
    TOUCHSTONE_INLINE friend std::optional<double> nearest_double(const PairBall& x)
    {
        const Pair& m = x.middle_;
        const double r = rounded_up(x.radius_ + 0x1p-52 * std::fabs(m.low)); // the two sums below are rounded too
        if (m.high == 0 && r == 0) return 0.0;
        const bool decided = m.high + (m.low - r) == m.high && m.high + (m.low + r) == m.high && std::fabs(m.low) > r;
        return decided ? std::optional(m.high) : std::nullopt;
    }

    friend PairBall angle_over_pi(const PairBall& y, const PairBall& x);
    static PairBall pi(); ///< encloses pi

private:
    static constexpr double unknown = std::numeric_limits<double>::infinity();
    struct Kept;
    static const Kept& kept();

    TOUCHSTONE_INLINE PairBall(const Pair& m, double radius) : middle_(m), radius_(in_range(m.high) ? radius : unknown) {}
    TOUCHSTONE_INLINE static bool in_range(double x)
    {
        return x == 0 || (std::fabs(x) >= 0x1p-430 && std::fabs(x) <= 0x1p430);
    } // no for a NaN
    TOUCHSTONE_INLINE static double size(const PairBall& x) { return std::fabs(x.middle_.high); }
    TOUCHSTONE_INLINE static bool both_short(const PairBall& x, const PairBall& y) { return x.middle_.low == 0 && y.middle_.low == 0; }
    TOUCHSTONE_INLINE static double rounding(const Pair& m) { return 0x1p-102 * std::fabs(m.high); }
    TOUCHSTONE_INLINE static double rounded_up(double r) { return r * (1 + 0x1p-40); }

    Pair middle_;
    double radius_ = 0;
};

/// Constants, computed in balls when they are first asked for.
struct PairBall::Kept {
    std::array<PairBall, 257> angles; ///< arctan(k/256)/pi
    std::array<PairBall, 5> odd;      ///< 1/(2j + 1)
    PairBall pi, one_over_pi, half;
    Kept();
};
inline const PairBall::Kept& PairBall::kept()
{
    static const Kept constants;
    return constants;
}
inline PairBall PairBall::pi() { return kept().pi; }

/// The angle of (x, y), both >= 0, in half turns: with k/256 near y/x <= 1 that of (256, k), and arctan t, t = (256 y - k x)/(256 x + k y).
/// What arctan t = t - t^3/3 + ... leaves out after five terms is the integral of x^10/(1 + x^2) to t, at most |t|^11/11.
TOUCHSTONE_INLINE PairBall angle_over_pi(const PairBall& y, const PairBall& x)
{
    const PairBall::Kept& kept = PairBall::kept();
    const bool steep = y.middle_.high > x.middle_.high;
    const PairBall &n = steep ? x : y, &d = steep ? y : x;
    const double slope = 256 * (n.middle_.high / d.middle_.high);
    if (!(slope >= 0 && slope <= 256)) return PairBall::indeterminate(); // 0/0, or a midpoint that knows nothing
    const int k = static_cast<int>(slope + 0.5); // any k would be right
    const PairBall t = k == 0 ? n / d : (256 * n - k * d) / (256 * d + k * n), square = t * t;
    PairBall sum = kept.odd.back();
    for (std::size_t j = kept.odd.size() - 1; j-- > 0;) sum = kept.odd[j] - square * sum;
    const double w = square.middle_.high + square.radius_;
    sum.radius_ = PairBall::rounded_up(sum.radius_ + w * w * w * w * w / 11);
    const PairBall angle = kept.angles[static_cast<std::size_t>(k)] + t * sum * kept.one_over_pi;
    return steep ? kept.half - angle : angle;
}

/// What section 2 needs of it; the rest is left open.
template <>
struct ScalarTraits<PairBall> : ComposedTraits<PairBall> {
    static PairBall integer(long n) { return PairBall(n); } ///< n, exactly
    static PairBall quotient(long p, long q) { return PairBall(p) / PairBall(q); } ///< encloses p/q
    static PairBall pi() { return PairBall::pi(); } ///< encloses pi
    static PairBall sin_pi(const PairBall&) { return PairBall::indeterminate(); } ///< not provided
    static PairBall sqrt_positive_part(const PairBall& x) { return PairBall::root(x); } ///< sqrt(max(x, 0))
    static PairBall hypot(const PairBall& a, const PairBall& b) { return sqrt(a * a + b * b); } ///< sqrt(a^2 + b^2)
    static PairBall asin_sqrt_over_pi(const PairBall& s) { return atan_sqrt_over_pi(s, 1 - s); } ///< arcsin(sqrt s)/pi
    static PairBall atan_sqrt_over_pi(const PairBall& n, const PairBall& d)
    {
        return angle_over_pi(sqrt_positive_part(n), sqrt_positive_part(d));
    } ///< arctan(sqrt(n/d))/pi
    static PairBall atan_minus_square_over_pi(const PairBall& a, const PairBall& b, const PairBall& d)
    {
        return atan_sqrt_over_pi(a - b * b, d);
    } ///< n = a - b^2
};
inline PairBall atan2(const PairBall&, const PairBall&) { return PairBall::indeterminate(); } ///< not provided
inline PairBall pow(const PairBall&, const PairBall&) { return PairBall::indeterminate(); } ///< not provided

} // namespace touchstone
