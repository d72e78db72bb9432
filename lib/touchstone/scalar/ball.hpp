// SPDX-License-Identifier: MIT
/// \file
/// Balls: real and complex numbers known to lie in mid +- radius.
///
/// The contract of every function here and of every formula run on a `Ball`: if the
/// arguments enclose x, y, ... then the result encloses f(x, y, ...). Failure is a
/// value: an argument that may leave the domain gives an indeterminate ball (radius
/// infinite), never an exception and never a wrong enclosure.
///
/// Operations work at the calling thread's precision in bits, set for a scope by
/// `WorkingPrecision`. Rounding is part of the radius, so the precision affects
/// how tight a result is, not whether it is right.
#pragma once

#include "touchstone/scalar/flint_headers.hpp"
#include "touchstone/scalar/rational.hpp"
#include "touchstone/scalar/scalar.hpp"

#include <concepts>
#include <iosfwd>
#include <string>
#include <utility>

namespace touchstone {

/// Sets the calling thread's ball precision (bits, >= 2) until the scope ends.
class WorkingPrecision {
public:
    explicit WorkingPrecision(slong bits) : previous_(current_) { current_ = bits; }
    ~WorkingPrecision() { current_ = previous_; }
    WorkingPrecision(const WorkingPrecision&) = delete;
    WorkingPrecision& operator=(const WorkingPrecision&) = delete;
    static slong bits() { return current_; }

private:
    static inline thread_local slong current_ = 128;
    slong previous_;
};

/// Bits that carry `digits` decimal digits, with a few to spare.
constexpr slong bits_for_digits(long digits) { return digits * 3322 / 1000 + 16; }

/// A real ball, by value, over Arb's arb_t.
class Ball {
public:
    Ball() { arb_init(x_); }
    template <std::integral I>
    Ball(I n) { arb_init(x_); arb_set_si(x_, static_cast<slong>(n)); }
    /// Encloses r at the working precision (exact where r is a short dyadic number).
    Ball(const Rational& r);
    Ball(double) = delete; ///< a decimal literal in a formula does not compile; see exactly()
    Ball(float) = delete;
    Ball(const Ball& o) { arb_init(x_); arb_set(x_, o.x_); }
    Ball(Ball&& o) noexcept { arb_init(x_); arb_swap(x_, o.x_); }
    Ball& operator=(const Ball& o) { arb_set(x_, o.x_); return *this; }
    Ball& operator=(Ball&& o) noexcept { arb_swap(x_, o.x_); return *this; }
    ~Ball() { arb_clear(x_); }

    static Ball exactly(double x) { Ball b; arb_set_d(b.x_, x); return b; }
    static Ball indeterminate() { Ball b; arb_indeterminate(b.x_); return b; }

    arb_ptr get() { return x_; }
    arb_srcptr get() const { return x_; }

    bool is_finite() const { return arb_is_finite(x_) != 0; }
    bool is_exact() const { return arb_is_exact(x_) != 0; }
    bool overlaps(const Ball& o) const { return arb_overlaps(x_, o.x_) != 0; }
    bool contains(const Ball& o) const { return arb_contains(x_, o.x_) != 0; }
    bool contains(const Rational& r) const;
    bool contains_zero() const { return arb_contains_zero(x_) != 0; }
    /// log2 of midpoint over radius: how many bits the ball knows (large when exact).
    slong relative_bits() const { return arb_rel_accuracy_bits(x_); }
    /// An upper bound of the radius.
    double radius_bound() const { return mag_get_d(arb_radref(x_)); }
    /// mid +- rad with up to `digits` digits, for a person.
    std::string to_string(long digits = 20) const;
    /// Every bit of the ball as text (Arb's dump format); see parse().
    std::string dump() const;
    static Ball parse(const std::string& dumped);

    Ball& operator+=(const Ball& o) { arb_add(x_, x_, o.x_, WorkingPrecision::bits()); return *this; }
    Ball& operator-=(const Ball& o) { arb_sub(x_, x_, o.x_, WorkingPrecision::bits()); return *this; }
    Ball& operator*=(const Ball& o) { arb_mul(x_, x_, o.x_, WorkingPrecision::bits()); return *this; }
    Ball& operator/=(const Ball& o) { arb_div(x_, x_, o.x_, WorkingPrecision::bits()); return *this; }
    friend Ball operator+(Ball a, const Ball& b) { return std::move(a += b); }
    friend Ball operator-(Ball a, const Ball& b) { return std::move(a -= b); }
    friend Ball operator*(Ball a, const Ball& b) { return std::move(a *= b); }
    friend Ball operator/(Ball a, const Ball& b) { return std::move(a /= b); }
    Ball operator-() const { Ball r; arb_neg(r.x_, x_); return r; }

private:
    arb_t x_;
};

namespace detail {
template <class F>
Ball ball_of(F&& f, const Ball& x) { Ball r; f(r.get(), x.get(), WorkingPrecision::bits()); return r; }
template <class F>
Ball ball_of(F&& f, const Ball& x, const Ball& y) { Ball r; f(r.get(), x.get(), y.get(), WorkingPrecision::bits()); return r; }
} // namespace detail

inline Ball sqrt(const Ball& x) { return detail::ball_of(arb_sqrt, x); }
inline Ball exp(const Ball& x) { return detail::ball_of(arb_exp, x); }
inline Ball log(const Ball& x) { return detail::ball_of(arb_log, x); }
inline Ball sin(const Ball& x) { return detail::ball_of(arb_sin, x); }
inline Ball cos(const Ball& x) { return detail::ball_of(arb_cos, x); }
inline Ball asin(const Ball& x) { return detail::ball_of(arb_asin, x); }
inline Ball acos(const Ball& x) { return detail::ball_of(arb_acos, x); }
inline Ball atan2(const Ball& y, const Ball& x) { return detail::ball_of(arb_atan2, y, x); }
inline Ball pow(const Ball& x, const Ball& y) { return detail::ball_of(arb_pow, x, y); }
inline Ball abs(const Ball& x) { Ball r; arb_abs(r.get(), x.get()); return r; }

inline Truth less(const Ball& x, const Ball& y)
{
    if (arb_lt(x.get(), y.get())) return Truth::yes;
    return arb_ge(x.get(), y.get()) ? Truth::no : Truth::unknown;
}
/// The smallest ball (up to rounding) that contains both.
inline Ball hull(const Ball& x, const Ball& y) { return detail::ball_of(arb_union, x, y); }
Ball at_most(const Ball& x, const Ball& bound);  ///< encloses min(x, bound)
Ball at_least(const Ball& x, const Ball& bound); ///< encloses max(x, bound)

std::ostream& operator<<(std::ostream&, const Ball&);

template <>
struct ScalarTraits<Ball> : ComposedTraits<Ball> {
    static Ball integer(long n) { return Ball(n); }
    static Ball quotient(long p, long q) { return Ball(p) / Ball(q); }
    static Ball pi() { Ball r; arb_const_pi(r.get(), WorkingPrecision::bits()); return r; }
    static Ball sin_pi(const Ball& x) { return detail::ball_of(arb_sin_pi, x); }
    static Ball cos_pi(const Ball& x) { return detail::ball_of(arb_cos_pi, x); }
    static Ball powm1(const Ball& x, const Ball& y) { return detail::ball_of(arb_expm1, y * log(x)); }
    static Ball sqrt_positive_part(const Ball& x) { return detail::ball_of(arb_sqrtpos, at_least(x, Ball(0))); }
    static Ball hypot(const Ball& a, const Ball& b) { return detail::ball_of(arb_hypot, a, b); }
    static Ball power_of_two(long e) { Ball r(1); arb_mul_2exp_si(r.get(), r.get(), e); return r; }
    static Ball gamma(const Ball& x) { return detail::ball_of(arb_gamma, x); }
};

/// A rectangular complex ball, by value, over Arb's acb_t.
class ComplexBall {
public:
    ComplexBall() { acb_init(z_); }
    template <std::integral I>
    ComplexBall(I n) { acb_init(z_); acb_set_si(z_, static_cast<slong>(n)); }
    ComplexBall(const Ball& re) { acb_init(z_); acb_set_arb(z_, re.get()); }
    ComplexBall(const Ball& re, const Ball& im) { acb_init(z_); acb_set_arb_arb(z_, re.get(), im.get()); }
    ComplexBall(const Rational& r) : ComplexBall(Ball(r)) {}
    ComplexBall(double) = delete;
    ComplexBall(const ComplexBall& o) { acb_init(z_); acb_set(z_, o.z_); }
    ComplexBall(ComplexBall&& o) noexcept { acb_init(z_); acb_swap(z_, o.z_); }
    ComplexBall& operator=(const ComplexBall& o) { acb_set(z_, o.z_); return *this; }
    ComplexBall& operator=(ComplexBall&& o) noexcept { acb_swap(z_, o.z_); return *this; }
    ~ComplexBall() { acb_clear(z_); }

    static ComplexBall indeterminate() { ComplexBall r; acb_indeterminate(r.z_); return r; }

    acb_ptr get() { return z_; }
    acb_srcptr get() const { return z_; }
    Ball real() const { Ball r; arb_set(r.get(), acb_realref(z_)); return r; }
    Ball imag() const { Ball r; arb_set(r.get(), acb_imagref(z_)); return r; }
    bool is_finite() const { return acb_is_finite(z_) != 0; }
    bool overlaps(const ComplexBall& o) const { return acb_overlaps(z_, o.z_) != 0; }

    ComplexBall& operator+=(const ComplexBall& o) { acb_add(z_, z_, o.z_, WorkingPrecision::bits()); return *this; }
    ComplexBall& operator-=(const ComplexBall& o) { acb_sub(z_, z_, o.z_, WorkingPrecision::bits()); return *this; }
    ComplexBall& operator*=(const ComplexBall& o) { acb_mul(z_, z_, o.z_, WorkingPrecision::bits()); return *this; }
    ComplexBall& operator/=(const ComplexBall& o) { acb_div(z_, z_, o.z_, WorkingPrecision::bits()); return *this; }
    friend ComplexBall operator+(ComplexBall a, const ComplexBall& b) { return std::move(a += b); }
    friend ComplexBall operator-(ComplexBall a, const ComplexBall& b) { return std::move(a -= b); }
    friend ComplexBall operator*(ComplexBall a, const ComplexBall& b) { return std::move(a *= b); }
    friend ComplexBall operator/(ComplexBall a, const ComplexBall& b) { return std::move(a /= b); }
    ComplexBall operator-() const { ComplexBall r; acb_neg(r.z_, z_); return r; }

private:
    acb_t z_;
};

namespace detail {
template <class F>
ComplexBall complex_ball_of(F&& f, const ComplexBall& z) { ComplexBall r; f(r.get(), z.get(), WorkingPrecision::bits()); return r; }
} // namespace detail

inline ComplexBall sqrt(const ComplexBall& z) { return detail::complex_ball_of(acb_sqrt, z); }
inline ComplexBall exp(const ComplexBall& z) { return detail::complex_ball_of(acb_exp, z); }
inline ComplexBall log(const ComplexBall& z) { return detail::complex_ball_of(acb_log, z); }
inline ComplexBall sin(const ComplexBall& z) { return detail::complex_ball_of(acb_sin, z); }
inline ComplexBall cos(const ComplexBall& z) { return detail::complex_ball_of(acb_cos, z); }
inline ComplexBall asin(const ComplexBall& z) { return detail::complex_ball_of(acb_asin, z); }
inline ComplexBall acos(const ComplexBall& z) { return detail::complex_ball_of(acb_acos, z); }
inline ComplexBall pow(const ComplexBall& z, const ComplexBall& w)
{
    ComplexBall r;
    acb_pow(r.get(), z.get(), w.get(), WorkingPrecision::bits());
    return r;
}
/// |z|
inline Ball abs(const ComplexBall& z) { Ball r; acb_abs(r.get(), z.get(), WorkingPrecision::bits()); return r; }
/// atan(y/x), which is atan2(y, x) where Re x > 0; indeterminate on the branch cuts of atan.
ComplexBall atan2(const ComplexBall& y, const ComplexBall& x);

template <>
struct ScalarTraits<ComplexBall> : ComposedTraits<ComplexBall> {
    static ComplexBall integer(long n) { return ComplexBall(n); }
    static ComplexBall quotient(long p, long q) { return ComplexBall(Ball(p) / Ball(q)); }
    static ComplexBall pi() { return ComplexBall(ScalarTraits<Ball>::pi()); }
    static ComplexBall sin_pi(const ComplexBall& z) { return detail::complex_ball_of(acb_sin_pi, z); }
    static ComplexBall cos_pi(const ComplexBall& z) { return detail::complex_ball_of(acb_cos_pi, z); }
    static ComplexBall powm1(const ComplexBall& z, const ComplexBall& w) { return detail::complex_ball_of(acb_expm1, w * log(z)); }
    /// For complex arguments there is no part to cut off: the square root itself.
    static ComplexBall sqrt_positive_part(const ComplexBall& z) { return sqrt(z); }
    static ComplexBall hypot(const ComplexBall& a, const ComplexBall& b) { return sqrt(a * a + b * b); }
    static ComplexBall power_of_two(long e) { return ComplexBall(ScalarTraits<Ball>::power_of_two(e)); }
    static ComplexBall gamma(const ComplexBall& z) { return detail::complex_ball_of(acb_gamma, z); }
};

} // namespace touchstone
