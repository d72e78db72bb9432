// SPDX-License-Identifier: MIT
/// \file
/// Where to integrate, and what the integrand is told about the ends.
///
/// Every interval is the image of u in (0, 1); r = 1 - u. The integrand is called with
/// three arguments (x, left, right):
///
/// | interval                          | x                  | left     | right      |
/// |-----------------------------------|--------------------|----------|------------|
/// | finite(a, b)                      | a + (b-a)u         | x - a    | b - x      |
/// | right_half_line(a, algebraic)     | a + u/r            | x - a    | 1/(1+x-a)  |
/// | right_half_line(a, exponential)   | a - log r          | x - a    | exp(a - x) |
/// | left_half_line(b, ...)            | mirrored           | mirrored | b - x      |
/// | whole_line(algebraic)             | (u/r - r/u)/2      | u        | r          |
/// | whole_line(exponential)           | log(u/r)           | u        | r          |
///
/// On an infinite interval the third (second) argument is what vanishes at the infinite
/// end, and powers of it are what the decay of the integrand is written and proved with:
/// exp(-x) cos(...) as `right * cos(...)`. On whole_line(exponential), u = 1/(1 + exp(-x)),
/// so exp(x) = left/right; on whole_line(algebraic), u/r = x + sqrt(1 + x^2), and
/// left^s ~ |2x|^-s at -oo.
#pragma once

#include "touchstone/quadrature/endpoint_number.hpp"

#include <functional>

namespace touchstone::quadrature {

enum class Decay { algebraic, exponential };

/// An end of an interval, re-evaluated at whatever precision is at work: an integer, a
/// rational, a ball (used as it is), or a function that returns a ball.
class Endpoint {
public:
    template <std::integral I>
    Endpoint(I n) : Endpoint(Rational(static_cast<long>(n))) {}
    Endpoint(const Rational& r) : exact_(r), at_([r] { return Ball(r); }) {}
    Endpoint(const Ball& x) : at_([x] { return x; }) {}
    template <std::invocable F> requires std::convertible_to<std::invoke_result_t<F>, Ball>
    Endpoint(F f) : at_(std::move(f)) {}
    Ball ball() const { return at_(); }
    const std::optional<Rational>& exact() const { return exact_; }

private:
    std::optional<Rational> exact_;
    std::function<Ball()> at_;
};

/// x, its two distances, and dx/du.
template <class N>
struct Abscissa {
    N x, left, right, slope;
};

class Interval {
public:
    static Interval finite(Endpoint a, Endpoint b) { return {Kind::finite, std::move(a), std::move(b)}; }
    static Interval right_half_line(Endpoint a, Decay d)
    {
        return {d == Decay::algebraic ? Kind::ray_algebraic : Kind::ray_exponential, std::move(a), 0};
    }
    static Interval left_half_line(Endpoint b, Decay d) { Interval i = right_half_line(std::move(b), d); i.mirrored_ = true; return i; }
    static Interval whole_line(Decay d) { return {d == Decay::algebraic ? Kind::line_algebraic : Kind::line_exponential, 0, 0}; }

    bool is_finite() const { return kind_ == Kind::finite; }
    std::string to_string() const;

    /// Evaluate the ends at the working precision; before any call of at() at that precision.
    void prepare();
    /// The point with fractions u and r = 1 - u, given as numbers that keep their endpoint powers.
    template <class V>
    Abscissa<EndpointNumber<V>> at(const EndpointNumber<V>& u, const EndpointNumber<V>& r) const;
    /// The same for a number without enclosure (double, Mpfr).
    template <class Real>
    Abscissa<Real> at_real(const Real& a, const Real& b, const Real& u, const Real& r) const;

    const Endpoint& left() const { return a_; }
    const Endpoint& right() const { return b_; }
    /// Whether a < b is certain (finite) and the ends are finite balls, as prepared.
    bool is_proper() const;

private:
    enum class Kind { finite, ray_algebraic, ray_exponential, line_algebraic, line_exponential };
    Interval(Kind k, Endpoint a, Endpoint b) : kind_(k), a_(std::move(a)), b_(std::move(b)) {}

    Kind kind_;
    bool mirrored_ = false;
    Endpoint a_, b_;
    Ball start_, end_, width_;
};

/// -log r = -log(1 - u) as u times a function without zero or pole at u = 0.
template <class V>
EndpointNumber<V> minus_log_of_complement(const EndpointNumber<V>& u, const EndpointNumber<V>& r)
{
    if (r.frame() && r.frame()->keeps_logarithms()) return -log(r);
    if constexpr (std::same_as<V, ComplexBall>) {
        // |-log(1 - u)/u - 1| <= sum |u|^k/(k + 1) <= |u| / (2 (1 - |u|)), principal branch; which it is:
        // |u| < 1/2 happens in the left half of the strip alone, where |E| <= 1 and log r = -log(1 + E) is principal.
        Ball size = touchstone::abs(u.value());
        Ball twice = size * Ball(2);
        if (!u.left().power.is_zero() && arb_lt(twice.get(), Ball(1).get())) {
            const Ball bound = size / (Ball(2) * (Ball(1) - size));
            ComplexBall ratio(1);
            mag_t m;
            mag_init(m);
            arb_get_mag(m, bound.get());
            acb_add_error_mag(ratio.get(), m);
            mag_clear(m);
            return u * EndpointNumber<V>(u.frame(), {}, {}, ratio);
        }
        const EndpointNumber<V> l = -log(r);
        return u * EndpointNumber<V>(u.frame(), l.left(), l.right(), l.factor() / u.value());
    }
    else {
        if (!r.is_plain()) return -log(r); // the frame knows log r to full relative accuracy
        const Ball v = -u.value();
        Ball l;
        arb_log1p(l.get(), v.get(), WorkingPrecision::bits());
        return EndpointNumber<V>(-l);
    }
}

template <class V>
Abscissa<EndpointNumber<V>> Interval::at(const EndpointNumber<V>& u, const EndpointNumber<V>& r) const
{
    using N = EndpointNumber<V>;
    const auto ray = [&](N distance, N nearness, N slope) -> Abscissa<N> {
        if (arb_is_zero(start_.get()))
            return mirrored_ ? Abscissa<N>{-distance, nearness, distance, slope} : Abscissa<N>{distance, distance, nearness, slope};
        if (mirrored_) return {N(start_) - distance, std::move(nearness), std::move(distance), std::move(slope)};
        return {N(start_) + distance, std::move(distance), std::move(nearness), std::move(slope)};
    };
    switch (kind_) {
    case Kind::finite: {
        const N w(width_), left = w * u, right = w * r;
        if (arb_is_zero(start_.get())) return {left, left, right, w};
        if (arb_is_zero(end_.get())) return {-right, left, right, w};
        return {N(start_) + left, left, right, w};
    }
    case Kind::ray_algebraic: return ray(u / r, r, N(1) / (r * r));
    case Kind::ray_exponential: return ray(minus_log_of_complement(u, r), r, N(1) / r);
    case Kind::line_algebraic:
        return {(u / r - r / u) * N(V(Ball(1) / Ball(2))), u, r, (u * u + r * r) * N(V(Ball(1) / Ball(2))) / (u * u * r * r)};
    case Kind::line_exponential: return {log(u) - log(r), u, r, N(1) / (u * r)};
    }
    return {};
}

template <class Real>
Abscissa<Real> Interval::at_real(const Real& a, const Real& b, const Real& u, const Real& r) const
{
    using std::log;
    using std::log1p;
    const auto ray = [&](Real distance, Real nearness, Real slope) -> Abscissa<Real> {
        if (mirrored_) return {Real(a - distance), nearness, distance, slope};
        return {Real(a + distance), distance, nearness, slope};
    };
    switch (kind_) {
    case Kind::finite: {
        const Real w = b - a;
        return {u < r ? Real(a + w * u) : Real(b - w * r), Real(w * u), Real(w * r), w};
    }
    case Kind::ray_algebraic: return ray(Real(u / r), r, Real(1 / (r * r)));
    case Kind::ray_exponential: return ray(u < r ? Real(-log1p(-u)) : Real(-log(r)), r, Real(1 / r));
    case Kind::line_algebraic: return {Real((u / r - r / u) / 2), u, r, Real((1 / (r * r) + 1 / (u * u)) / 2)};
    case Kind::line_exponential: return {Real(log(u / r)), u, r, Real(1 / (u * r))};
    }
    return {};
}

} // namespace touchstone::quadrature
