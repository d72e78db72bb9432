// SPDX-License-Identifier: MIT
/// \file
/// Numbers u^p r^q c that keep their endpoint behaviour apart.
///
/// Under x = tanh-sinh(t) the image of a strip |Im t| < d winds around both ends of the
/// interval infinitely often: it is a domain on the Riemann surface of the logarithm, where
/// `sqrt(x - a)` taken with the principal branch is the wrong function. An
/// `EndpointNumber` therefore is a triple (p, q, c) that stands for
///
///     u^p r^q c,      u = (fraction of the interval to the left end), r = 1 - u,
///
/// with exact rational p, q, a ball c, and u^p = exp(p log u) with the logarithm that is
/// continued along the strip. Products, quotients and powers act on p and q exactly;
/// a sum factors out the smaller exponents. So an integrand written as an ordinary
/// generic formula in x and its distances l = x - a, r = b - x
///
///     [](auto x, auto l, auto r) { return to_power(l, Rational(-9, 10)) * exp(x); }
///
/// comes back from each piece of the strip, and from a whole neighbourhood of each end, as
/// (exponents, enclosure of the regular factor): its endpoint exponents are *found and
/// proved*, not declared.
///
/// Errors: c is non-finite wherever the formula is not proved analytic. Roots, powers,
/// logarithms, absolute values and inverse functions of a ball that meets their branch
/// cut, and quotients by a ball that contains zero, are non-finite.
/// Cost: that of the same operations on c, plus a few machine integers.
#pragma once

#include "touchstone/scalar/ball.hpp"

#include <cmath>
#include <limits>
#include <memory>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

namespace touchstone::quadrature {

namespace detail {
__extension__ typedef __int128 Wide; // products of two 64-bit integers
}

/// A small exact rational. Arithmetic that leaves 64 bits throws DomainError.
class Exponent {
public:
    constexpr Exponent() = default;
    template <std::integral I>
    constexpr Exponent(I n) : n_(static_cast<long>(n)) {}
    Exponent(long n, long d) : n_(n), d_(d) { reduce(); }
    explicit Exponent(const Rational& r)
    {
        if (!r.get_num().fits_slong_p() || !r.get_den().fits_slong_p())
            throw DomainError("exponents of the integrand, and what is made of them, need numerators and denominators below 2^63");
        n_ = r.get_num().get_si();
        d_ = r.get_den().get_si();
    }
    constexpr long num() const { return n_; }
    constexpr long den() const { return d_; }
    constexpr bool is_zero() const { return n_ == 0; }
    constexpr bool is_integer() const { return d_ == 1; }
    double to_double() const { return static_cast<double>(n_) / static_cast<double>(d_); }
    Rational rational() const { Rational r(n_, d_); return r; }
    Ball ball() const { return d_ == 1 ? Ball(n_) : Ball(n_) / Ball(d_); }
    std::string to_string() const { return d_ == 1 ? std::to_string(n_) : std::to_string(n_) + "/" + std::to_string(d_); }

    friend Exponent operator+(const Exponent& a, const Exponent& b)
    {
        if (b.n_ == 0) return a;
        if (a.n_ == 0) return b;
        if (a.d_ == 1 && b.d_ == 1) return Exponent(checked(static_cast<Wide>(a.n_) + b.n_));
        return make(static_cast<Wide>(a.n_) * b.d_ + static_cast<Wide>(b.n_) * a.d_, static_cast<Wide>(a.d_) * b.d_);
    }
    friend Exponent operator-(const Exponent& a) { return raw(-a.n_, a.d_); }
    friend Exponent operator-(const Exponent& a, const Exponent& b) { return a + (-b); }
    friend Exponent operator*(const Exponent& a, const Exponent& b)
    {
        if (a.n_ == 0 || b.n_ == 0) return Exponent(0);
        if (a.n_ == 1 && a.d_ == 1) return b;
        if (b.n_ == 1 && b.d_ == 1) return a;
        return make(static_cast<Wide>(a.n_) * b.n_, static_cast<Wide>(a.d_) * b.d_);
    }
    friend bool operator==(const Exponent& a, const Exponent& b) { return a.n_ == b.n_ && a.d_ == b.d_; }
    friend bool operator<(const Exponent& a, const Exponent& b)
    {
        return a.d_ == b.d_ ? a.n_ < b.n_ : static_cast<Wide>(a.n_) * b.d_ < static_cast<Wide>(b.n_) * a.d_;
    }

private:
    using Wide = detail::Wide;
    static constexpr Exponent raw(long n, long d) { Exponent e; e.n_ = n; e.d_ = d; return e; }
    static long checked(Wide v)
    {
        if (v > std::numeric_limits<long>::max() || v < -std::numeric_limits<long>::max())
            throw DomainError("exponents of the integrand, and what is made of them, need numerators and denominators below 2^63");
        return static_cast<long>(v);
    }
    static Exponent make(Wide n, Wide d)
    {
        constexpr Wide small = Wide(1) << 62;
        if (n < small && n > -small && d < small) {
            const long g = std::gcd(static_cast<long>(n), static_cast<long>(d));
            return raw(static_cast<long>(n) / g, static_cast<long>(d) / g);
        }
        Wide x = n < 0 ? -n : n, y = d;
        while (y != 0) { const Wide t = x % y; x = y; y = t; }
        if (x == 0) return Exponent(0);
        return raw(checked(n / x), checked(d / x));
    }
    void reduce() { *this = make(d_ < 0 ? -static_cast<Wide>(n_) : n_, d_ < 0 ? -static_cast<Wide>(d_) : d_); }

    long n_ = 0;
    long d_ = 1;
};

enum class Side { left, right };

/// Functions of one ball that are non-finite unless analytic on the whole of it.
namespace analytic {
inline ComplexBall sqrt(const ComplexBall& z) { ComplexBall w; acb_sqrt_analytic(w.get(), z.get(), 1, WorkingPrecision::bits()); return w; }
inline Ball sqrt(const Ball& x) { return touchstone::sqrt(x); }
inline ComplexBall log(const ComplexBall& z) { ComplexBall w; acb_log_analytic(w.get(), z.get(), 1, WorkingPrecision::bits()); return w; }
inline Ball log(const Ball& x) { return touchstone::log(x); }
inline ComplexBall abs(const ComplexBall& z) { ComplexBall w; acb_real_abs(w.get(), z.get(), 1, WorkingPrecision::bits()); return w; }
inline Ball abs(const Ball& x) { return touchstone::abs(x); }
inline ComplexBall sgn(const ComplexBall& z) { ComplexBall w; acb_real_sgn(w.get(), z.get(), 1, WorkingPrecision::bits()); return w; }
inline Ball sgn(const Ball& x) { Ball s; arb_sgn(s.get(), x.get()); return s; }
inline ComplexBall exp(const ComplexBall& z) { ComplexBall w; acb_exp(w.get(), z.get(), WorkingPrecision::bits()); return w; }
inline Ball exp(const Ball& x) { return touchstone::exp(x); }
inline ComplexBall integer_power(const ComplexBall& z, long n)
{
    ComplexBall w;
    acb_pow_si(w.get(), z.get(), n, WorkingPrecision::bits());
    return w;
}
inline Ball integer_power(const Ball& x, long n)
{
    Ball y;
    arb_pow_ui(y.get(), x.get(), static_cast<ulong>(n < 0 ? -n : n), WorkingPrecision::bits());
    return n < 0 ? Ball(1) / y : y;
}
/// atan z off its cuts i[1, oo), -i[1, oo).
inline ComplexBall atan(const ComplexBall& z)
{
    ComplexBall w;
    if (arb_contains_zero(acb_realref(z.get()))) {
        Ball y = touchstone::abs(z.imag());
        if (!arb_lt(y.get(), Ball(1).get())) return ComplexBall::indeterminate();
    }
    acb_atan(w.get(), z.get(), WorkingPrecision::bits());
    return w;
}
inline Ball atan(const Ball& x) { Ball y; arb_atan(y.get(), x.get(), WorkingPrecision::bits()); return y; }
/// asin z off its cuts (-oo, -1], [1, oo).
inline ComplexBall asin(const ComplexBall& z)
{
    if (arb_contains_zero(acb_imagref(z.get()))) {
        Ball x = touchstone::abs(z.real());
        if (!arb_lt(x.get(), Ball(1).get())) return ComplexBall::indeterminate();
    }
    return touchstone::asin(z);
}
inline Ball asin(const Ball& x) { return touchstone::asin(x); }
/// f(z)/z for odd f(z) = z (1 + c_1 z^2 + c_2 z^4 + ...), |c_k| <= 1/3: f is atan or asin. A ball
/// about zero gets 1 + disc(|z|^2 / (3 (1 - |z|^2))).
template <class V, class F>
V odd_over_argument(const V& z, F&& f)
{
    if constexpr (std::same_as<V, ComplexBall>) {
        const Ball size = touchstone::abs(z), square = size * size, four = square * Ball(4);
        if (acb_contains_zero(z.get()) && arb_lt(four.get(), Ball(1).get())) {
            const Ball bound = square / (Ball(3) * (Ball(1) - square));
            V w(1);
            mag_t m;
            mag_init(m);
            arb_get_mag(m, bound.get());
            acb_add_error_mag(w.get(), m);
            mag_clear(m);
            return w;
        }
    }
    return f(z) / z;
}
ComplexBall sinc(const ComplexBall& z);
inline Ball sinc(const Ball& x) { Ball y; arb_sinc(y.get(), x.get(), WorkingPrecision::bits()); return y; }
inline bool is_one(const ComplexBall& z) { return acb_is_one(z.get()) != 0; }
inline bool is_one(const Ball& x) { return arb_is_one(x.get()) != 0; }
/// z^e for rational e, principal.
template <class V>
V rational_power(const V& z, const Exponent& e)
{
    if (is_one(z)) return z;
    if (e.is_zero()) return z.is_finite() ? V(1) : V::indeterminate(); // of what has no value there is no power
    if (e.is_integer()) return integer_power(z, e.num());
    if (e.den() == 2) return integer_power(analytic::sqrt(z), e.num());
    if constexpr (std::same_as<V, Ball>) {
        // The same constant comes back at every node of a rule: keep its last power.
        struct Memo { Ball base, power; long num = 0, den = 0; slong bits = 0; };
        thread_local Memo memo;
        if (memo.num != e.num() || memo.den != e.den() || memo.bits < WorkingPrecision::bits() || !arb_equal(memo.base.get(), z.get()))
            memo = {z, analytic::exp(e.ball() * analytic::log(z)), e.num(), e.den(), WorkingPrecision::bits()};
        Ball y;
        arb_set_round(y.get(), memo.power.get(), WorkingPrecision::bits());
        return y;
    }
    else return analytic::exp(V(e.ball()) * analytic::log(z));
}
} // namespace analytic

/// Where on the strip, or at which node, a number lives: what u and r are there.
/// `V` is ComplexBall on pieces of the strip and Ball at the nodes of the rule.
template <class V>
class Frame {
public:
    virtual ~Frame() = default;
    /// Encloses u (left) or r = 1 - u (right).
    virtual V distance(Side) const = 0;
    /// Encloses the continued logarithm of u or r; indeterminate where the piece reaches that end.
    virtual V logarithm(Side) const = 0;
    /// The principal logarithm of the distance: of a real one, at a node.
    virtual V log_of_distance(Side s) const { return analytic::log(distance(s)); }
    /// Whether the piece reaches the end, so that the distance takes values arbitrarily near 0.
    virtual bool reaches(Side) const { return false; }
    /// If it does: encloses u^e rho^k there (r^e rho^k), rho = -log|e^w| > 0 being the size of the
    /// logarithm (see log()), for real e > 0 and any k, or e = 0 and k <= 0.
    virtual V vanishing(Side, const Ball& /*e*/, const Exponent& /*k*/) const { return V::indeterminate(); }
    /// If it does: encloses log u / rho (log r / rho).
    virtual V logarithm_over_rho(Side) const { return V::indeterminate(); }
    /// If it does: a bound of |arg u| (|arg r|) there; none where the strip winds around the end for ever.
    virtual std::optional<Ball> turn(Side) const { return std::nullopt; }
    /// Whether the piece lies on the half of the strip away from that end, where its distance is not small. A form chosen by that is one
    /// and the same on each half.
    virtual bool is_on_the_half_away_from(Side) const { return false; }
    /// Whether log u and log r are kept as symbols (EndpointNumber::logarithms) and have no value here.
    virtual bool keeps_logarithms() const { return false; }

    V power(Side s, const Exponent& e) const
    {
        if (e.is_zero()) return V(1);
        if (reaches(s)) return vanishing(s, e.ball(), 0);
        if (e == Exponent(1)) return distance(s);
        if (e.is_integer() && std::labs(e.num()) <= 64) return analytic::integer_power(distance(s), e.num());
        return power_by_log(s, e);
    }
    /// u^e for a real ball e >= 0 that need not be rational.
    V power(Side s, const Ball& e) const
    {
        if (arb_is_zero(e.get())) return V(1);
        if (!arb_is_nonnegative(e.get())) return V::indeterminate();
        if (reaches(s)) return vanishing(s, e, 0);
        return analytic::exp(V(e) * logarithm(s));
    }
    /// u^p r^q; nodes override it by something faster.
    virtual V monomial(const Exponent& p, const Exponent& q) const { return power(Side::left, p) * power(Side::right, q); }

protected:
    virtual V power_by_log(Side s, const Exponent& e) const { return analytic::exp(V(e.ball()) * logarithm(s)); }
};

/// Exponents of one end: distance^power rho^logs.
struct Order {
    Exponent power;
    Exponent logs; // zero except on pieces that reach the end

    friend Order operator+(const Order& a, const Order& b) { return {a.power + b.power, a.logs + b.logs}; }
    friend Order operator-(const Order& a, const Order& b) { return {a.power - b.power, a.logs - b.logs}; }
    friend Order operator*(const Order& a, const Exponent& e) { return {a.power * e, a.logs * e}; }
    friend bool operator==(const Order&, const Order&) = default;
    bool is_zero() const { return power.is_zero() && logs.is_zero(); }
    /// The order of the larger of the two as the end is approached.
    static Order dominant(const Order& a, const Order& b)
    {
        if (a.power == b.power) return a.logs < b.logs ? b : a;
        return a.power < b.power ? a : b;
    }
};

/// c (log u)^left (log r)^right
template <class V>
struct LogarithmTerm {
    int left = 0, right = 0;
    V c;
};

/// u^p r^q c. See the head of this file.
///
/// In a frame that keeps logarithms a number is u^p r^q (c + sum of c_ij (log u)^i (log r)^j). Sums and products carry the terms along; to
/// every other operation such a number has no value, so that what is finite has its logarithms all in the terms.
template <class V>
class EndpointNumber {
public:
    EndpointNumber() = default;
    template <std::integral I>
    EndpointNumber(I n) : c_(n) {}
    EndpointNumber(const Rational& r) : c_(r) {}
    template <class E> requires(std::convertible_to<E, Rational> && !std::is_arithmetic_v<E> && !std::same_as<E, Rational>)
    EndpointNumber(const E& unevaluated) : c_(Rational(unevaluated)) {} // GMP's expression templates
    EndpointNumber(const Ball& x) : c_(x) {}
    EndpointNumber(const ComplexBall& z) requires std::same_as<V, ComplexBall> : c_(z) {}
    EndpointNumber(double) = delete;
    EndpointNumber(const Frame<V>* frame, Order p, Order q, V c) : frame_(frame), p_(p), q_(q), c_(std::move(c)) {}
    using Terms = std::vector<LogarithmTerm<V>>;
    /// The terms are of different kinds, with left + right > 0.
    EndpointNumber(const Frame<V>* frame, Order p, Order q, V c, Terms logarithms)
        : frame_(frame)
        , p_(p)
        , q_(q)
        , c_(std::move(c))
        , logarithms_(logarithms.empty() ? nullptr : std::make_shared<const Terms>(std::move(logarithms)))
    {
    }

    const Order& left() const { return p_; }
    const Order& right() const { return q_; }
    const Order& order(Side s) const { return s == Side::left ? p_ : q_; }
    /// Indeterminate if there are logarithms.
    const V& factor() const { return logarithms_ ? nothing() : c_; }
    /// What no logarithm stands beside, and the terms with one.
    const V& factor_without_logarithm() const { return c_; }
    bool has_logarithms() const { return logarithms_ != nullptr; }
    const Terms& logarithms() const
    {
        static const Terms none;
        return logarithms_ ? *logarithms_ : none;
    }
    /// Whether its factors are finite, those beside logarithms too.
    bool has_value() const
    {
        return c_.is_finite() &&
               std::all_of(logarithms().begin(), logarithms().end(), [](const LogarithmTerm<V>& t) { return t.c.is_finite(); });
    }
    const Frame<V>* frame() const { return frame_; }
    bool is_plain() const { return p_.is_zero() && q_.is_zero() && !logarithms_; }
    /// u^p r^q c as one ball: non-finite if it is unbounded here.
    V value() const { return logarithms_ ? nothing() : is_plain() ? c_ : over(frame_, {}, {}); }

    friend EndpointNumber operator*(const EndpointNumber& a, const EndpointNumber& b)
    {
        if (a.logarithms_ || b.logarithms_) return product_of_terms(a, b);
        return {common(a, b), a.p_ + b.p_, a.q_ + b.q_, analytic::is_one(b.c_) ? a.c_ : analytic::is_one(a.c_) ? b.c_ : a.c_ * b.c_};
    }
    friend EndpointNumber operator/(const EndpointNumber& a, const EndpointNumber& b)
    {
        if (a.logarithms_ || b.logarithms_) return a * EndpointNumber(b.frame_, Order{} - b.p_, Order{} - b.q_, V(1) / b.factor());
        return {common(a, b), a.p_ - b.p_, a.q_ - b.q_, a.c_ / b.c_};
    }
    friend EndpointNumber operator+(const EndpointNumber& a, const EndpointNumber& b)
    {
        if (a.logarithms_ || b.logarithms_) return sum_of_terms(a, b);
        if (a.p_ == b.p_ && a.q_ == b.q_) return {common(a, b), a.p_, a.q_, a.c_ + b.c_};
        const Order p = Order::dominant(a.p_, b.p_), q = Order::dominant(a.q_, b.q_);
        return {common(a, b), p, q, a.over(common(a, b), p, q) + b.over(common(a, b), p, q)};
    }
    EndpointNumber operator-() const { return logarithms_ ? *this * EndpointNumber(-1) : EndpointNumber(frame_, p_, q_, -c_); }
    friend EndpointNumber operator-(const EndpointNumber& a, const EndpointNumber& b) { return a + (-b); }
    EndpointNumber& operator+=(const EndpointNumber& o) { return *this = *this + o; }
    EndpointNumber& operator-=(const EndpointNumber& o) { return *this = *this - o; }
    EndpointNumber& operator*=(const EndpointNumber& o) { return *this = *this * o; }
    EndpointNumber& operator/=(const EndpointNumber& o) { return *this = *this / o; }

    /// An analytic function of the value: non-finite if the value is not bounded here.
    template <class F>
    EndpointNumber map(F&& f) const { return {frame_, {}, {}, logarithms_ ? nothing() : f(value())}; }

private:
    static const V& nothing()
    {
        static const V indeterminate = V::indeterminate();
        return indeterminate;
    }
    static void add_term(V& free, Terms& terms, int left, int right, V c)
    {
        if (left == 0 && right == 0) {
            free += c;
            return;
        }
        for (LogarithmTerm<V>& t : terms)
            if (t.left == left && t.right == right) {
                t.c += c;
                return;
            }
        terms.push_back({left, right, std::move(c)});
    }
    static EndpointNumber product_of_terms(const EndpointNumber& a, const EndpointNumber& b)
    {
        V free = a.c_ * b.c_;
        Terms terms;
        for (const auto& s : a.logarithms()) add_term(free, terms, s.left, s.right, s.c * b.c_);
        for (const auto& t : b.logarithms()) add_term(free, terms, t.left, t.right, a.c_ * t.c);
        for (const auto& s : a.logarithms())
            for (const auto& t : b.logarithms()) add_term(free, terms, s.left + t.left, s.right + t.right, s.c * t.c);
        return {common(a, b), a.p_ + b.p_, a.q_ + b.q_, std::move(free), std::move(terms)};
    }
    static EndpointNumber sum_of_terms(const EndpointNumber& a, const EndpointNumber& b)
    {
        const Frame<V>* frame = common(a, b);
        const Order p = Order::dominant(a.p_, b.p_), q = Order::dominant(a.q_, b.q_);
        V free(0);
        Terms terms;
        for (const EndpointNumber* x : {&a, &b}) {
            if (x->p_ == p && x->q_ == q) {
                free += x->c_;
                for (const auto& t : x->logarithms()) add_term(free, terms, t.left, t.right, t.c);
                continue;
            }
            const V power = EndpointNumber(x->frame_, x->p_, x->q_, V(1)).over(frame, p, q);
            free += power * x->c_;
            for (const auto& t : x->logarithms()) add_term(free, terms, t.left, t.right, power * t.c);
        }
        return {frame, p, q, std::move(free), std::move(terms)};
    }
    static const Frame<V>* common(const EndpointNumber& a, const EndpointNumber& b) { return a.frame_ ? a.frame_ : b.frame_; }
    /// this / (u^p r^q)
    V over(const Frame<V>* frame, const Order& p, const Order& q) const
    {
        V r = c_;
        for (const Side s : {Side::left, Side::right}) {
            const Order d = order(s) - (s == Side::left ? p : q);
            if (d.is_zero()) continue;
            r *= d.logs.is_zero() ? frame->power(s, d.power) : frame->vanishing(s, d.power.ball(), d.logs);
        }
        return r;
    }

    const Frame<V>* frame_ = nullptr;
    Order p_, q_;
    V c_;
    std::shared_ptr<const Terms> logarithms_;
};

template <class V>
EndpointNumber<V> sqrt(const EndpointNumber<V>& x)
{
    const Exponent half(1, 2);
    return {x.frame(), x.left() * half, x.right() * half, analytic::sqrt(x.factor())};
}
/// x^e for rational e.
template <class V>
EndpointNumber<V> to_power(const EndpointNumber<V>& x, const Exponent& e)
{
    constexpr long most = 8;
    if (x.has_logarithms() && e.is_zero()) return x.has_value() ? EndpointNumber<V>(1) : EndpointNumber<V>(V::indeterminate());
    if (x.has_logarithms() && e.is_integer() && e.num() > 0 && e.num() <= most) return e.num() == 1 ? x : x * to_power(x, e - Exponent(1));
    return {x.frame(), x.left() * e, x.right() * e, analytic::rational_power(x.factor(), e)};
}
template <class V>
EndpointNumber<V> to_power(const EndpointNumber<V>& x, const Rational& e) { return to_power(x, Exponent(e)); }
inline double to_power(double x, const Rational& e) { return std::pow(x, e.get_d()); }

/// x^s for a real ball s (not nearly as fast as to_power with a rational exponent).
/// The exponents p s, q s are split into a short dyadic part that stays exact and a remainder >= 0.
template <class V>
EndpointNumber<V> pow(const EndpointNumber<V>& x, const Ball& s)
{
    const auto split = [&](const Exponent& p) {
        const Ball ps = p.ball() * s;
        if (!arb_lt(touchstone::abs(ps).get(), Ball(1L << 30).get())) return std::pair(Exponent(0), Ball::indeterminate());
        const double at = std::floor((arf_get_d(arb_midref(ps.get()), ARF_RND_DOWN) - mag_get_d(arb_radref(ps.get()))) * 1024);
        const Exponent low(static_cast<long>(at), 1024);
        Ball rest = ps - low.ball();
        if (arb_contains_zero(rest.get()) && !arb_is_zero(rest.get())) { // exact dyadic p s: no remainder to carry
            const Exponent lower = low - Exponent(1, 1024);
            return std::pair(lower, ps - lower.ball());
        }
        return std::pair(low, rest);
    };
    const auto [p, dp] = split(x.left().power);
    const auto [q, dq] = split(x.right().power);
    if (!x.left().logs.is_zero() || !x.right().logs.is_zero()) return {x.frame(), {}, {}, V::indeterminate()};
    V w = analytic::exp(V(s) * analytic::log(x.factor()));
    if (x.frame()) w *= x.frame()->power(Side::left, dp) * x.frame()->power(Side::right, dq);
    return {x.frame(), {p, 0}, {q, 0}, std::move(w)};
}
template <class V>
EndpointNumber<V> exp(const EndpointNumber<V>& x) { return x.map([](const V& v) { return analytic::exp(v); }); }
/// Whether x has a zero at an end: then sin x, atan x, asin x are x times something without one.
template <class V>
bool vanishes_at_an_end(const EndpointNumber<V>& x)
{
    return x.left().logs.is_zero() && x.right().logs.is_zero() && !(x.left().power < Exponent(0)) && !(x.right().power < Exponent(0)) &&
           !x.is_plain();
}
template <class V>
EndpointNumber<V> sin(const EndpointNumber<V>& x)
{
    if (vanishes_at_an_end(x)) return {x.frame(), x.left(), x.right(), x.factor() * analytic::sinc(x.value())};
    return x.map([](const V& v) { return sin(v); });
}
template <class V>
EndpointNumber<V> cos(const EndpointNumber<V>& x) { return x.map([](const V& v) { return cos(v); }); }
template <class V>
EndpointNumber<V> abs(const EndpointNumber<V>& x) { return x.map([](const V& v) { return analytic::abs(v); }); }
template <class V>
EndpointNumber<V> sgn(const EndpointNumber<V>& x) { return x.map([](const V& v) { return analytic::sgn(v); }); }
template <class V>
EndpointNumber<V> atan(const EndpointNumber<V>& x)
{
    const auto f = [](const V& v) { return analytic::atan(v); };
    if (vanishes_at_an_end(x)) return {x.frame(), x.left(), x.right(), x.factor() * analytic::odd_over_argument(x.value(), f)};
    return x.map(f);
}
template <class V>
EndpointNumber<V> asin(const EndpointNumber<V>& x)
{
    const auto f = [](const V& v) { return analytic::asin(v); };
    if (vanishes_at_an_end(x)) return {x.frame(), x.left(), x.right(), x.factor() * analytic::odd_over_argument(x.value(), f)};
    return x.map(f);
}
template <class V>
EndpointNumber<V> acos(const EndpointNumber<V>& x)
{
    return x.map([](const V& v) { return V(pi<Ball>() / Ball(2)) - analytic::asin(v); });
}
/// The angle of (x, y) for x > 0: atan(y/x).
template <class V>
EndpointNumber<V> atan2(const EndpointNumber<V>& y, const EndpointNumber<V>& x) { return atan(y / x); }
/// x^y for y without endpoint behaviour.
template <class V>
EndpointNumber<V> pow(const EndpointNumber<V>& x, const EndpointNumber<V>& y)
{
    if constexpr (std::same_as<V, ComplexBall>) {
        if (y.is_plain() && arb_is_zero(acb_imagref(y.factor().get()))) return pow(x, y.factor().real());
        return exp(y * log(x));
    }
    else return y.is_plain() ? pow(x, y.factor()) : exp(y * log(x));
}

/// log(u^p r^q c) = p log u + q log r + log c, log c principal; so it is for a number without logarithms. On a piece that reaches an end
/// the logarithm there is unbounded; it is returned as rho times a bounded factor.
template <class V>
EndpointNumber<V> log(const EndpointNumber<V>& x)
{
    EndpointNumber<V> sum(x.frame(), {}, {}, analytic::log(x.factor()));
    if (!x.left().logs.is_zero() || !x.right().logs.is_zero()) return {x.frame(), {}, {}, V::indeterminate()};
    for (const Side s : {Side::left, Side::right}) {
        const Exponent& p = x.order(s).power;
        if (p.is_zero()) continue;
        if (x.frame()->reaches(s)) {
            const Order rho{0, 1};
            sum += EndpointNumber<V>(x.frame(), s == Side::left ? rho : Order{}, s == Side::right ? rho : Order{},
                                     V(p.ball()) * x.frame()->logarithm_over_rho(s));
        }
        else if (x.frame()->keeps_logarithms()) {
            const bool left = s == Side::left;
            sum += EndpointNumber<V>(x.frame(), {}, {}, V(0), {{left ? 1 : 0, left ? 0 : 1, V(p.ball())}});
        }
        else sum += EndpointNumber<V>(x.frame(), {}, {}, V(p.ball()) * x.frame()->logarithm(s));
    }
    return sum;
}

} // namespace touchstone::quadrature

namespace touchstone {

/// So that a formula written over Scalar is an integrand as it stands.
template <class V>
struct ScalarTraits<quadrature::EndpointNumber<V>> : ComposedTraits<quadrature::EndpointNumber<V>> {
    using N = quadrature::EndpointNumber<V>;
    static N integer(long n) { return N(n); }
    static N quotient(long p, long q) { return N(V(Ball(p) / Ball(q))); }
    static N pi() { return N(ScalarTraits<Ball>::pi()); }
    static N sin_pi(const N& x) { return sin(N(ScalarTraits<Ball>::pi()) * x); }
    static N cos_pi(const N& x) { return x.map([](const V& v) { return ScalarTraits<V>::cos_pi(v); }); }
    static N powm1(const N& x, const N& y) { return pow(x, y) - N(1); }
    /// Off the positive axis there is no part to cut off: the square root, continued.
    static N sqrt_positive_part(const N& x) { return sqrt(x); }
    static N hypot(const N& a, const N& b) { return sqrt(a * a + b * b); }
    static N power_of_two(long e) { return N(ScalarTraits<Ball>::power_of_two(e)); }
    static N gamma(const N& x) { return x.map([](const V& v) { return ScalarTraits<V>::gamma(v); }); }
};

} // namespace touchstone
