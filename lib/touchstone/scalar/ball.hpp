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
    explicit WorkingPrecision(slong bits) : previous_(current_) { current_ = bits; } ///< bits >= 2
    ~WorkingPrecision() { current_ = previous_; }
    WorkingPrecision(const WorkingPrecision&) = delete;
    WorkingPrecision& operator=(const WorkingPrecision&) = delete;
    static slong bits() { return current_; } ///< those of this thread

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
    Ball(I n) { arb_init(x_); arb_set_si(x_, static_cast<slong>(n)); } ///< n, exactly
    /// Encloses r at the working precision (exact where r is a short dyadic number).
    Ball(const Rational& r);
    Ball(double) = delete; ///< a decimal literal in a formula does not compile; see exactly()
    Ball(float) = delete;
    Ball(const Ball& o) { arb_init(x_); arb_set(x_, o.x_); } ///< a copy
    Ball(Ball&& o) noexcept { arb_init(x_); arb_swap(x_, o.x_); } ///< leaves the other zero
    Ball& operator=(const Ball& o) { arb_set(x_, o.x_); return *this; } ///< a copy
    Ball& operator=(Ball&& o) noexcept { arb_swap(x_, o.x_); return *this; } ///< exchanges the two
    ~Ball() { arb_clear(x_); }

    static Ball exactly(double x) { Ball b; arb_set_d(b.x_, x); return b; } ///< radius 0; infinite or NaN as x is
    static Ball indeterminate() { Ball b; arb_indeterminate(b.x_); return b; } ///< holds every number

    arb_ptr get() { return x_; } ///< for functions of Arb
    arb_srcptr get() const { return x_; } ///< for functions of Arb

    bool is_finite() const { return arb_is_finite(x_) != 0; } ///< midpoint and radius are
    bool is_exact() const { return arb_is_exact(x_) != 0; } ///< radius 0
    bool overlaps(const Ball& o) const { return arb_overlaps(x_, o.x_) != 0; } ///< a number is in both
    bool contains(const Ball& o) const { return arb_contains(x_, o.x_) != 0; } ///< all of o
    bool contains(const Rational& r) const; ///< r itself, not a rounding of it
    bool contains_zero() const { return arb_contains_zero(x_) != 0; } ///< whether 0 is possible
    /// log2 of midpoint over radius: how many bits the ball knows (large when exact).
    slong relative_bits() const { return arb_rel_accuracy_bits(x_); }
    /// An upper bound of the radius.
    double radius_bound() const { return mag_get_d(arb_radref(x_)); }
    /// mid +- rad with up to `digits` digits, for a person.
    std::string to_string(long digits = 20) const;
    /// Every bit of the ball as text (Arb's dump format); see parse().
    std::string dump() const;
    static Ball parse(const std::string& dumped); ///< what dump() wrote; else indeterminate

    Ball& operator+=(const Ball& o) { arb_add(x_, x_, o.x_, WorkingPrecision::bits()); return *this; } ///< encloses the sum
    Ball& operator-=(const Ball& o) { arb_sub(x_, x_, o.x_, WorkingPrecision::bits()); return *this; } ///< encloses the difference
    Ball& operator*=(const Ball& o) { arb_mul(x_, x_, o.x_, WorkingPrecision::bits()); return *this; } ///< encloses the product
    Ball& operator/=(const Ball& o) { arb_div(x_, x_, o.x_, WorkingPrecision::bits()); return *this; } ///< indeterminate if o may be 0
    friend Ball operator+(Ball a, const Ball& b) { return std::move(a += b); } ///< encloses the sum
    friend Ball operator-(Ball a, const Ball& b) { return std::move(a -= b); } ///< encloses the difference
    friend Ball operator*(Ball a, const Ball& b) { return std::move(a *= b); } ///< encloses the product
    friend Ball operator/(Ball a, const Ball& b) { return std::move(a /= b); } ///< indeterminate if b may be 0
    Ball operator-() const { Ball r; arb_neg(r.x_, x_); return r; } ///< exact

private:
    arb_t x_;
};

namespace detail {
template <class F>
Ball ball_of(F&& f, const Ball& x) { Ball r; f(r.get(), x.get(), WorkingPrecision::bits()); return r; } ///< f of Arb
template <class F>
Ball ball_of(F&& f, const Ball& x, const Ball& y)
{
    Ball r;
    f(r.get(), x.get(), y.get(), WorkingPrecision::bits());
    return r;
} ///< the same of two
} // namespace detail

inline Ball sqrt(const Ball& x) { return detail::ball_of(arb_sqrt, x); } ///< indeterminate if x may be < 0
inline Ball exp(const Ball& x) { return detail::ball_of(arb_exp, x); } ///< e^x
inline Ball log(const Ball& x) { return detail::ball_of(arb_log, x); } ///< indeterminate if x may be <= 0
inline Ball sin(const Ball& x) { return detail::ball_of(arb_sin, x); } ///< sine, x in radians
inline Ball cos(const Ball& x) { return detail::ball_of(arb_cos, x); } ///< cosine, x in radians
inline Ball asin(const Ball& x) { return detail::ball_of(arb_asin, x); } ///< indeterminate if |x| may be > 1
inline Ball acos(const Ball& x) { return detail::ball_of(arb_acos, x); } ///< indeterminate if |x| may be > 1
inline Ball atan2(const Ball& y, const Ball& x) { return detail::ball_of(arb_atan2, y, x); } ///< the angle of (x, y)
inline Ball pow(const Ball& x, const Ball& y) { return detail::ball_of(arb_pow, x, y); } ///< x^y
inline Ball abs(const Ball& x) { Ball r; arb_abs(r.get(), x.get()); return r; } ///< encloses |x|
/// x < y for all numbers of the two balls, for none, or for some.
inline Truth less(const Ball& x, const Ball& y)
{
    if (arb_lt(x.get(), y.get())) return Truth::yes;
    return arb_ge(x.get(), y.get()) ? Truth::no : Truth::unknown;
}
/// The smallest ball (up to rounding) that contains both.
inline Ball hull(const Ball& x, const Ball& y) { return detail::ball_of(arb_union, x, y); }
Ball at_most(const Ball& x, const Ball& bound);  ///< encloses min(x, bound)
Ball at_least(const Ball& x, const Ball& bound); ///< encloses max(x, bound)
/// As to_string().
std::ostream& operator<<(std::ostream&, const Ball&);
/// Real balls: every result encloses.
template <>
struct ScalarTraits<Ball> : ComposedTraits<Ball> {
    static Ball integer(long n) { return Ball(n); } ///< n, exactly
    static Ball quotient(long p, long q) { return Ball(p) / Ball(q); } ///< encloses p/q
    static Ball pi() { Ball r; arb_const_pi(r.get(), WorkingPrecision::bits()); return r; } ///< encloses pi
    static Ball sin_pi(const Ball& x) { return detail::ball_of(arb_sin_pi, x); } ///< sin(pi x)
    static Ball cos_pi(const Ball& x) { return detail::ball_of(arb_cos_pi, x); } ///< cos(pi x)
    static Ball powm1(const Ball& x, const Ball& y) { return detail::ball_of(arb_expm1, y * log(x)); } ///< x^y - 1, x > 0
    static Ball sqrt_positive_part(const Ball& x) { return detail::ball_of(arb_sqrtpos, at_least(x, Ball(0))); } ///< sqrt(max(x, 0))
    static Ball hypot(const Ball& a, const Ball& b) { return detail::ball_of(arb_hypot, a, b); } ///< sqrt(a^2 + b^2)
    static Ball power_of_two(long e) { Ball r(1); arb_mul_2exp_si(r.get(), r.get(), e); return r; } ///< 2^e, exactly
    static Ball gamma(const Ball& x) { return detail::ball_of(arb_gamma, x); } ///< Euler's Gamma(x)
};

/// A rectangular complex ball, by value, over Arb's acb_t.
class ComplexBall {
public:
    ComplexBall() { acb_init(z_); }
    template <std::integral I>
    ComplexBall(I n) { acb_init(z_); acb_set_si(z_, static_cast<slong>(n)); } ///< n, exactly
    ComplexBall(const Ball& re) { acb_init(z_); acb_set_arb(z_, re.get()); } ///< a real number
    ComplexBall(const Ball& re, const Ball& im) { acb_init(z_); acb_set_arb_arb(z_, re.get(), im.get()); } ///< re + i im
    ComplexBall(const Rational& r) : ComplexBall(Ball(r)) {} ///< encloses r
    ComplexBall(double) = delete;
    ComplexBall(const ComplexBall& o) { acb_init(z_); acb_set(z_, o.z_); } ///< a copy
    ComplexBall(ComplexBall&& o) noexcept { acb_init(z_); acb_swap(z_, o.z_); } ///< leaves the other zero
    ComplexBall& operator=(const ComplexBall& o) { acb_set(z_, o.z_); return *this; } ///< a copy
    ComplexBall& operator=(ComplexBall&& o) noexcept { acb_swap(z_, o.z_); return *this; } ///< exchanges the two
    ~ComplexBall() { acb_clear(z_); }

    static ComplexBall indeterminate() { ComplexBall r; acb_indeterminate(r.z_); return r; } ///< holds every number

    acb_ptr get() { return z_; } ///< for functions of Arb
    acb_srcptr get() const { return z_; } ///< for functions of Arb
    Ball real() const { Ball r; arb_set(r.get(), acb_realref(z_)); return r; } ///< the real part
    Ball imag() const { Ball r; arb_set(r.get(), acb_imagref(z_)); return r; } ///< the imaginary part
    bool is_finite() const { return acb_is_finite(z_) != 0; } ///< both parts are
    bool overlaps(const ComplexBall& o) const { return acb_overlaps(z_, o.z_) != 0; } ///< a number is in both

    ComplexBall& operator+=(const ComplexBall& o) { acb_add(z_, z_, o.z_, WorkingPrecision::bits()); return *this; } ///< sum
    ComplexBall& operator-=(const ComplexBall& o) { acb_sub(z_, z_, o.z_, WorkingPrecision::bits()); return *this; } ///< difference
    ComplexBall& operator*=(const ComplexBall& o) { acb_mul(z_, z_, o.z_, WorkingPrecision::bits()); return *this; } ///< product
    ComplexBall& operator/=(const ComplexBall& o) { acb_div(z_, z_, o.z_, WorkingPrecision::bits()); return *this; } ///< quotient
    friend ComplexBall operator+(ComplexBall a, const ComplexBall& b) { return std::move(a += b); } ///< encloses the sum
    friend ComplexBall operator-(ComplexBall a, const ComplexBall& b) { return std::move(a -= b); } ///< encloses the difference
    friend ComplexBall operator*(ComplexBall a, const ComplexBall& b) { return std::move(a *= b); } ///< encloses the product
    friend ComplexBall operator/(ComplexBall a, const ComplexBall& b) { return std::move(a /= b); } ///< indeterminate if b may be 0
    ComplexBall operator-() const { ComplexBall r; acb_neg(r.z_, z_); return r; } ///< exact

private:
    acb_t z_;
};

namespace detail {
template <class F>
ComplexBall complex_ball_of(F&& f, const ComplexBall& z)
{
    ComplexBall r;
    f(r.get(), z.get(), WorkingPrecision::bits());
    return r;
} ///< f of Arb
} // namespace detail

inline ComplexBall sqrt(const ComplexBall& z) { return detail::complex_ball_of(acb_sqrt, z); } ///< principal branch
inline ComplexBall exp(const ComplexBall& z) { return detail::complex_ball_of(acb_exp, z); } ///< e^z
inline ComplexBall log(const ComplexBall& z) { return detail::complex_ball_of(acb_log, z); } ///< principal branch
inline ComplexBall sin(const ComplexBall& z) { return detail::complex_ball_of(acb_sin, z); } ///< sine
inline ComplexBall cos(const ComplexBall& z) { return detail::complex_ball_of(acb_cos, z); } ///< cosine
inline ComplexBall asin(const ComplexBall& z) { return detail::complex_ball_of(acb_asin, z); } ///< principal branch
inline ComplexBall acos(const ComplexBall& z) { return detail::complex_ball_of(acb_acos, z); } ///< principal branch
inline ComplexBall pow(const ComplexBall& z, const ComplexBall& w)
{
    ComplexBall r;
    acb_pow(r.get(), z.get(), w.get(), WorkingPrecision::bits());
    return r;
} ///< z^w, principal branch
/// |z|
inline Ball abs(const ComplexBall& z) { Ball r; acb_abs(r.get(), z.get(), WorkingPrecision::bits()); return r; }
/// atan(y/x), which is atan2(y, x) where Re x > 0; indeterminate on the branch cuts of atan.
ComplexBall atan2(const ComplexBall& y, const ComplexBall& x);
/// Complex balls: every result encloses, on the principal branches.
template <>
struct ScalarTraits<ComplexBall> : ComposedTraits<ComplexBall> {
    static ComplexBall integer(long n) { return ComplexBall(n); } ///< n, exactly
    static ComplexBall quotient(long p, long q) { return ComplexBall(Ball(p) / Ball(q)); } ///< encloses p/q
    static ComplexBall pi() { return ComplexBall(ScalarTraits<Ball>::pi()); } ///< encloses pi
    static ComplexBall sin_pi(const ComplexBall& z) { return detail::complex_ball_of(acb_sin_pi, z); } ///< sin(pi z)
    static ComplexBall cos_pi(const ComplexBall& z) { return detail::complex_ball_of(acb_cos_pi, z); } ///< cos(pi z)
    static ComplexBall powm1(const ComplexBall& z, const ComplexBall& w)
    {
        return detail::complex_ball_of(acb_expm1, w * log(z));
    } ///< z^w - 1
    /// For complex arguments there is no part to cut off: the square root itself.
    static ComplexBall sqrt_positive_part(const ComplexBall& z) { return sqrt(z); }
    static ComplexBall hypot(const ComplexBall& a, const ComplexBall& b) { return sqrt(a * a + b * b); } ///< sqrt(a^2 + b^2)
    static ComplexBall power_of_two(long e) { return ComplexBall(ScalarTraits<Ball>::power_of_two(e)); } ///< 2^e, exactly
    static ComplexBall gamma(const ComplexBall& z) { return detail::complex_ball_of(acb_gamma, z); } ///< Euler's Gamma(z)
};

} // namespace touchstone
