// SPDX-License-Identifier: MIT
#include "touchstone/quadrature/compiled.hpp"

#include "touchstone/quadrature/endpoint_functions.hpp"
#include "touchstone/quadrature/inner_integral.hpp"
#include "touchstone/quadrature/lemmas.hpp"
#include "touchstone/quadrature/upper.hpp"
#include "touchstone/quadrature/widen.hpp"

#include <cmath>

namespace touchstone::quadrature::compiled {
namespace {

template <class V>
using N = EndpointNumber<V>;

/// z or its conjugate; no real number encloses an imaginary one.
template <class V>
V as_placed(const ComplexBall& z, bool conjugated)
{
    if constexpr (std::same_as<V, ComplexBall>) {
        ComplexBall w;
        acb_set_round(w.get(), z.get(), WorkingPrecision::bits());
        if (conjugated) acb_conj(w.get(), w.get());
        return w;
    }
    else {
        Ball x;
        arb_set_round(x.get(), acb_realref(z.get()), WorkingPrecision::bits());
        return acb_is_real(z.get()) ? x : Ball::indeterminate();
    }
}

/// The i-th constant of the node, at the working precision.
template <class V>
V kept(const Node& node, std::size_t i, const ExactSum& exact, const Place& place)
{
    const slong bits = WorkingPrecision::bits();
    if (node.kept.size() <= i) node.kept.resize(i + 1);
    Node::Kept& k = node.kept[i];
    if (k.bits < bits) k = {exact.complex_ball(), bits};
    return as_placed<V>(k.value, place.conjugated);
}

/// A parameter that is a ball, or the point of an outer integral.
template <class V>
V ball(const Node& node, const Place& place)
{
    if (node.source->ball) return as_placed<V>(*node.source->ball, place.mirrored);
    Ball x(node.source->number);
    widen(x, Ball(node.source->radius));
    return V(x);
}

double log2_size(const Ball& x)
{
    mag_t m;
    mag_init(m);
    arb_get_mag(m, x.get());
    const double d = mag_is_zero(m) ? -1e15 : mag_is_inf(m) ? 1e15 : mag_get_d_log2_approx(m);
    mag_clear(m);
    return d;
}

template <class V>
N<V> factored(const Node& node, const Point<V>& p, const Place& place)
{
    const auto coefficient = [&](std::size_t i) { return N<V>(kept<V>(node, i, node.rest[i], place)); };
    N<V> r = coefficient(node.rest.size() - 1);
    for (std::size_t i = node.rest.size() - 1; i-- > 0;) r = node.rest[i].is_zero() ? r * p.x : r * p.x + coefficient(i);
    if (node.order[0] != 0) r = r * to_power(p.left, Exponent(node.order[0]));
    if (node.order[1] != 0) r = r * to_power(p.right, Exponent(node.order[1]));
    return r;
}

bool is_exactly_zero(const Ball& x) { return arb_is_zero(x.get()) != 0; }
bool is_exactly_zero(const ComplexBall& z) { return acb_is_zero(z.get()) != 0; }

template <class V>
N<V> sum(const Node& node, const Point<V>& p, const Place& place)
{
    N<V> r = evaluate(*node.args[0], p, place);
    for (std::size_t i = 1; i < node.args.size(); ++i) r = r + evaluate(*node.args[i], p, place);
    if (is_exactly_zero(r.factor())) return N<V>(0); // whatever its orders: 1/x + 1/(-x)
    return r;
}

bool has_kinks(Op op) { return op == Op::abs || op == Op::sign || op == Op::floor || op == Op::ceil; }

/// All values that a function with kinks or steps takes on the ball.
Ball values_on_the_line(Op op, const Ball& x)
{
    Ball y;
    switch (op) {
    case Op::abs: return touchstone::abs(x);
    case Op::sign: arb_sgn(y.get(), x.get()); return y;
    case Op::floor: arb_floor(y.get(), x.get(), WorkingPrecision::bits()); return y;
    default: arb_ceil(y.get(), x.get(), WorkingPrecision::bits()); return y;
    }
}

/// The numbers of a node of the rule as complex ones.
class Lifted : public Frame<ComplexBall> {
public:
    explicit Lifted(const Frame<Ball>* real)
        : real_(real)
    {
    }
    ComplexBall distance(Side s) const override { return real_->distance(s); }
    ComplexBall logarithm(Side s) const override { return real_->logarithm(s); }
    ComplexBall monomial(const Exponent& p, const Exponent& q) const override { return real_->monomial(p, q); }

private:
    ComplexBall power_by_log(Side s, const Exponent& e) const override { return real_->power(s, e); }
    const Frame<Ball>* real_;
};

N<ComplexBall> lifted(const N<Ball>& x, const Lifted& frame)
{
    return {x.frame() ? &frame : nullptr, x.left(), x.right(), ComplexBall(x.factor())};
}

/// The value at a real point, complex, and the frame of the point.
std::pair<N<ComplexBall>, const Frame<Ball>*> complex_value(const Node& node, const Point<Ball>& p, const Place& place)
{
    const Frame<Ball>* real = p.x.frame() ? p.x.frame() : p.left.frame() ? p.left.frame() : p.right.frame();
    const Lifted frame(real);
    Point<ComplexBall> q{lifted(p.x, frame), lifted(p.left, frame), lifted(p.right, frame), std::nullopt};
    if (p.exp_x) q.exp_x = lifted(*p.exp_x, frame);
    const N<ComplexBall> f = evaluate(node, q, place);
    return {N<ComplexBall>(nullptr, f.left(), f.right(), f.factor()), real};
}

/// (f + f*)/2, (f - f*)/(2i) or f*: tanh_sinh.md, section 13.
template <class V>
N<V> part(const Node& node, const Point<V>& p, const Place& place)
{
    if constexpr (std::same_as<V, Ball>) {
        const auto [f, real] = complex_value(*node.args[0], p, place);
        if (node.kind == Kind::conjugate && !acb_is_real(f.factor().get())) return N<V>(Ball::indeterminate());
        return {real, f.left(), f.right(), node.kind == Kind::imaginary_part ? f.factor().imag() : f.factor().real()};
    }
    else {
        const bool of_value = node.op == Op::real_value || node.op == Op::imaginary_value;
        const bool real_part = node.kind == Kind::real_part;
        const auto at = [&](bool conjugated) {
            Place there = place;
            there.conjugated = conjugated;
            if (of_value) there.mirrored = conjugated;
            return evaluate(*node.args[0], p, there);
        };
        if (node.kind == Kind::conjugate) return at(!place.conjugated);
        const N<V> f = at(false);
        if (place.on_the_line && of_value) return N<V>(ComplexBall(real_part ? f.value().real() : f.value().imag()));
        const N<V> g = at(true), two(2);
        return real_part ? (f + g) / two : (f - g) / N<V>(ComplexBall(Ball(0), Ball(2)));
    }
}

Ball middle_of(const Ball& s)
{
    Ball m;
    arb_set_arf(m.get(), arb_midref(s.get()));
    return m;
}
ComplexBall middle_of(const ComplexBall& s) { return {middle_of(s.real()), middle_of(s.imag())}; }

/// log x for x + y = 1, with the zero where y has one, on the half of the strip where that end is. There the logarithm is principal, as
/// Re x > 0; so it is in the angle where |y| < 1.
template <class V>
N<V> logarithm_of_fraction(const N<V>& x, const N<V>& y)
{
    const bool keeps = x.frame() && x.frame()->keeps_logarithms();
    const V v = y.value();
    const Ball size = upper_ball(v), far = Ball::exactly(0.75);
    const bool near = !keeps && arb_lt(size.get(), far.get());
    if constexpr (std::same_as<V, Ball>) {
        if (!near) return log(x);
        Ball l;
        const Ball minus = -v;
        arb_log1p(l.get(), minus.get(), WorkingPrecision::bits());
        return N<V>(l);
    }
    else {
        const Side zero = y.left().power.is_zero() ? Side::right : Side::left;
        if (y.is_plain() || keeps || (y.frame() && y.frame()->is_on_the_half_away_from(zero))) return log(x); // no zero to keep
        const auto times = [&](const N<V>& l) { return y * N<V>(y.frame(), l.left(), l.right(), l.factor() / v); };
        if (!near) return times(log(x));
        // log(1 - y)/y from the middle of the ball over the ball
        const V middle = middle_of(v);
        V ratio(-1);
        if (!is_exactly_zero(middle)) {
            const V minus = -middle;
            acb_log1p(ratio.get(), minus.get(), WorkingPrecision::bits());
            ratio = ratio / middle;
        }
        widen(ratio, lemma::slope_of_logarithm(size) * radius_of(v));
        return y * N<V>(y.frame(), {}, {}, ratio);
    }
}

/// log(1 + v)/v = 1 - v/2 + ... for the principal logarithm, |v| <= size < 1; by its own values where those know more, as at a node.
ComplexBall logarithm_over_argument(const ComplexBall& v, const Ball& size)
{
    ComplexBall ratio(1), l;
    widen(ratio, lemma::logarithm_over_argument(size));
    acb_log1p(l.get(), v.get(), WorkingPrecision::bits());
    l = l / v;
    return l.is_finite() && acb_rel_accuracy_bits(l.get()) > acb_rel_accuracy_bits(ratio.get()) ? l : ratio;
}

/// log x for x = 1 + v, with the zero where v has one. For |v| < 1/2 that is the principal logarithm; so is the continued one where its
/// imaginary part is below pi in size, and on all of the strip where x shows no powers. Elsewhere too the powers with which v vanishes
/// stand beside the factor: which root of it is taken must not depend on the piece.
template <class V>
N<V> logarithm_near_one(const N<V>& x, const N<V>& v)
{
    const N<V> continued = function_of(Op::log, x);
    if (x.frame() && x.frame()->keeps_logarithms()) return continued;
    const V value = v.value();
    const Ball size = upper_ball(value), twice = size + size;
    const bool near = arb_lt(twice.get(), Ball(1).get()) != 0;
    if constexpr (std::same_as<V, Ball>) {
        if (!near) return continued;
        Ball l;
        arb_log1p(l.get(), value.get(), WorkingPrecision::bits());
        return N<V>(l);
    }
    else {
        if (v.is_plain()) return continued;
        const auto vanishing = [](const Order& o) { return o.power < Exponent(0) ? Order{} : o; };
        const Order left = vanishing(v.left()), right = vanishing(v.right());
        const Ball turn = touchstone::abs(continued.value().imag()); // not finite is not below pi
        if (near && (x.is_plain() || arb_lt(turn.get(), pi<Ball>().get()))) {
            const N<V> rest(v.frame(), v.left() - left, v.right() - right, v.factor());
            return N<V>(v.frame(), left, right, rest.value() * logarithm_over_argument(value, size));
        }
        const N<V> quotient = continued / N<V>(v.frame(), left, right, V(1));
        const bool in_left = !left.is_zero(), in_right = !right.is_zero();
        const N<V> hidden(v.frame(), in_left ? quotient.left() : Order{}, in_right ? quotient.right() : Order{}, quotient.factor());
        return N<V>(v.frame(), in_left ? left : continued.left(), in_right ? right : continued.right(), hidden.value());
    }
}

/// (a b)^e or (a/b)^e for an e that is no integer. Where a and b lie in the right half plane it is a^e b^e or a^e/b^e, since log(a b) =
/// log a + log b and log(a/b) = log a - log b there; a product of wide balls may meet the cut although neither of them comes near it.
N<ComplexBall> power_of_two_factors(Kind kind, const N<ComplexBall>& a, const N<ComplexBall>& b, const Exponent& e)
{
    using C = N<ComplexBall>;
    const C whole = to_power(C(kind == Kind::divide ? a / b : a * b), e);
    const auto is_to_the_right = [](const C& x) { return !x.has_logarithms() && arb_is_positive(acb_realref(x.factor().get())) != 0; };
    if (!whole.factor().is_finite() && is_to_the_right(a) && is_to_the_right(b))
        return kind == Kind::divide ? to_power(a, e) / to_power(b, e) : to_power(a, e) * to_power(b, e);
    return whole;
}

/// Whether the value is a product or a quotient as it stands.
bool has_two_factors(const Node& node)
{
    return (node.kind == Kind::divide || node.kind == Kind::multiply) && !node.zero[0] && !node.zero[1];
}

template <class V>
N<V> ordinary(const Node& node, const Point<V>& p, const Place& place)
{
    const auto arg = [&](std::size_t i) { return evaluate(*node.args[i], p, place); };
    switch (node.kind) {
    case Kind::constant: return N<V>(kept<V>(node, 0, *node.exact, place));
    case Kind::ball: return N<V>(ball<V>(node, place));
    case Kind::real_part:
    case Kind::imaginary_part:
    case Kind::conjugate: return part(node, p, place);
    case Kind::inner_integral: {
        const auto end = [&](std::size_t k) { return node.args[k] ? std::optional(arg(k).value()) : std::nullopt; };
        return N<V>(value_of_inner<V>(*node.inner, p.x.value(), end(0), end(1), place.conjugated));
    }
    case Kind::variable: return p.x;
    case Kind::factored: return factored(node, p, place);
    case Kind::add: return sum(node, p, place);
    case Kind::multiply: return arg(0) * arg(1);
    case Kind::divide: return arg(0) / arg(1);
    case Kind::power:
        if constexpr (std::same_as<V, ComplexBall>) // a real base that stands elsewhere too is not computed again
            if (const Node& base = *node.args[0]; !node.exponent.is_integer() && has_two_factors(base))
                return power_of_two_factors(base.kind, evaluate(*base.args[0], p, place), evaluate(*base.args[1], p, place), node.exponent);
        return to_power(arg(0), node.exponent);
    case Kind::ball_power: {
        const N<V> exponent = arg(1);
        if constexpr (std::same_as<V, Ball>)
            return pow(arg(0), exponent.factor());
        else if (arb_is_zero(acb_imagref(exponent.factor().get())))
            return pow(arg(0), exponent.factor().real());
        else
            return function_of(Op::exp, N<V>(exponent * function_of(Op::log, arg(0))));
    }
    case Kind::general_power: return function_of(Op::exp, N<V>(arg(1) * log(arg(0))));
    case Kind::function:
        if constexpr (std::same_as<V, ComplexBall>)
            if (place.on_the_line && has_kinks(node.op))
                if (const ComplexBall z = arg(0).value(); arb_is_zero(acb_imagref(z.get())))
                    return N<V>(ComplexBall(values_on_the_line(node.op, z.real())));
        return function_of(node.op, arg(0));
    case Kind::ordered_function: {
        const N<V> order = arg(0);
        if constexpr (std::same_as<V, Ball>)
            return function_of(node.op, order.factor(), arg(1));
        else if (acb_is_real(order.factor().get()))
            return function_of(node.op, order.factor().real(), arg(1));
        else
            return N<V>(V::indeterminate()); // the order of an inner integral's function at a complex x
    }
    case Kind::logarithm_of_fraction: {
        const N<V> over(kept<V>(node, 0, node.rest[0], place));
        const Side own = node.order[0] != 0 ? Side::left : Side::right;
        return logarithm_of_fraction(N<V>(over * p.distance(own)), N<V>(over * p.distance(own == Side::left ? Side::right : Side::left)));
    }
    case Kind::logarithm_near_one: return logarithm_near_one(arg(0), arg(1));
    case Kind::exponential:
        return p.exp_x ? to_power(*p.exp_x, node.exponent) : function_of(Op::exp, N<V>(N<V>(node.exponent.ball()) * p.x));
    }
    return {};
}

/// T by its first coefficients and Cauchy's bound of the others.
template <class V>
V series(const Node& node, const Zero& zero, std::size_t first_kept, const V& s, const Place& place)
{
    V r(0);
    if (!zero.c.empty()) r = kept<V>(node, first_kept + zero.c.size() - 1, zero.c.back(), place);
    for (std::size_t i = zero.c.empty() ? 0 : zero.c.size() - 1; i-- > 0;) r = r * s + kept<V>(node, first_kept + i, zero.c[i], place);
    const Ball q = upper_ball(s) / zero.radius;
    widen(r, lemma::remainder(zero.bound, q, static_cast<long>(zero.c.size())));
    return r;
}

/// How many bits the ball knows of its number, at most those at work.
template <class V>
double bits_known(const V& s)
{
    return std::clamp(log2_size(upper_ball(s)) - log2_size(radius_of(s)), 1.0, static_cast<double>(WorkingPrecision::bits()));
}

/// T where s is too far for the series and too near for a quotient at the working precision: at the exact midpoint of s with the bits that
/// cancel added, then over the ball by the bound of T' for |s| <= R/4 (lemma::slope).
template <class V>
V at_midpoint(const Node& node, const Zero& zero, Side side, const V& s, const Place& place)
{
    const V middle = middle_of(s);
    const slong bits = WorkingPrecision::bits();
    V t;
    {
        const double lost =
            static_cast<double>(zero.order + 2) * std::max(1.0, -log2_size(upper_ball(middle))); // what the terms of the sum have in common
        const WorkingPrecision more(bits + static_cast<slong>(lost) + 20);
        const Disc<V> disc(side, middle); // as it goes on from the range: a root left of the end is not the principal one
        t = ordinary(node, point_about(disc, place), place).value() / analytic::integer_power(middle, zero.order);
    }
    widen(t, lemma::slope(zero.bound, zero.radius, radius_of(s)));
    return t;
}

/// Whether s is surely within the radius times 2^-halvings.
bool within(const Ball& size, Ball r, double halvings)
{
    arb_mul_2exp_si(r.get(), r.get(), -static_cast<slong>(std::ceil(halvings)));
    return arb_lt(size.get(), r.get()) != 0;
}

/// Whether u, the fraction to the finite end of a half-line, is the distance to the right one.
bool is_mirrored(const Place& place)
{
    return place.range && (place.range->map == Map::left_algebraic || place.range->map == Map::left_exponential);
}

/// The order at the far end that a quotient shows, which the series has to show too: which root of T is taken must not depend on the piece.
template <class V>
Order order_beyond(const Node& node, const Point<V>& p, const Place& place, const N<V>& front, Side far, Side in_frame)
{
    const auto* frame = p.distance(far).frame();
    if (std::same_as<V, Ball> || p.distance(far).is_plain() || (frame && frame->keeps_logarithms())) return {};
    return (ordinary(node, p, place) / front).order(in_frame);
}

constexpr double least_known = 12;    // bits: a ball that knows less of its place is served by the series
constexpr std::size_t other_end = 16; // where the kept coefficients of the right end begin

template <class V>
N<V> with_zeros(const Node& node, const Point<V>& p, const Place& place)
{
    if (const auto* frame = p.x.frame() ? p.x.frame() : p.left.frame(); frame && frame->keeps_logarithms())
        if (N<V> r = ordinary(node, p, place); r.has_logarithms())
            return r; // the zero of a sum with logarithms is none of what stands beside them
    N<V> front(1);
    for (const Side s : {Side::left, Side::right})
        if (const auto& zero = node.zero[s == Side::left ? 0 : 1]; zero && zero->order != 0)
            front = front * to_power(p.distance(s), Exponent(zero->order));
    for (const Side s : {Side::left, Side::right}) {
        const auto& zero = node.zero[s == Side::left ? 0 : 1];
        if (!zero) continue;
        const V distance = p.distance(s).value();
        const Ball size = upper_ball(distance);
        if (!within(size, zero->radius, 2)) continue;
        const double halvings = (bits_known(distance) + 10) / std::max(0.01, static_cast<double>(zero->c.size()));
        V t = within(size, zero->radius, std::max(2.0, halvings)) || bits_known(distance) < least_known
                  ? series(node, *zero, s == Side::left ? 0 : other_end, distance, place)
                  : at_midpoint(node, *zero, s, distance, place);
        const Side far = s == Side::left ? Side::right : Side::left;
        const auto& other = node.zero[far == Side::left ? 0 : 1];
        if (other && other->order != 0) t = t / to_power(p.distance(far), Exponent(other->order)).value();
        const Side at = is_mirrored(place) ? s : far; // in the frame
        const Order shown = other ? Order{} : order_beyond(node, p, place, front, far, at);
        const N<V> beyond(p.distance(far).frame(), at == Side::left ? shown : Order{}, at == Side::right ? shown : Order{}, V(1));
        return front * beyond * N<V>(shown.is_zero() ? t : t / beyond.value());
    }
    const N<V> quotient = ordinary(node, p, place) / front;
    // The orders that the sum shows at an end with a zero belong to the factor: T has none there. Where logarithms are kept the other end's
    // do too, as in T: what stands beside a logarithm must be one function, whichever way it was enclosed.
    const bool all = quotient.frame() && quotient.frame()->keeps_logarithms();
    const bool mirrored = is_mirrored(place);
    const bool in_left = node.zero[mirrored ? 1 : 0] || all, in_right = node.zero[mirrored ? 0 : 1] || all;
    const Order left = in_left ? Order{} : quotient.left(), right = in_right ? Order{} : quotient.right();
    const N<V> hidden(quotient.frame(), in_left ? quotient.left() : Order{}, in_right ? quotient.right() : Order{}, V(1));
    return front * N<V>(quotient.frame(), left, right, quotient.factor() * hidden.value());
}

} // namespace

namespace {

template <class V>
Last<V>& last_of(const Node& node)
{
    if constexpr (std::same_as<V, Ball>)
        return node.last_real;
    else
        return node.last_complex;
}

} // namespace

template <class V>
EndpointNumber<V> evaluate(const Node& node, const Point<V>& p, const Place& place)
{
    const auto value = [&] { return node.zero[0] || node.zero[1] ? with_zeros(node, p, place) : ordinary(node, p, place); };
    if (!node.is_shared) return value();
    Last<V>& last = last_of<V>(node);
    const bool same_place = last.conjugated == place.conjugated && last.mirrored == place.mirrored && last.on_the_line == place.on_the_line;
    if (last.point != p.id || !same_place) last = {p.id, place.conjugated, place.mirrored, place.on_the_line, value()};
    return last.value;
}

std::array<N<Ball>, 2> both_parts(const Node& node, const Point<Ball>& p, const Place& place)
{
    const auto [f, frame] = complex_value(node, p, place);
    return {N<Ball>(frame, f.left(), f.right(), f.factor().real()), N<Ball>(frame, f.left(), f.right(), f.factor().imag())};
}

std::array<N<ComplexBall>, 2> both_parts(const Node& node, const Point<ComplexBall>& p, const Place& place)
{
    Place mirrored = place;
    mirrored.conjugated = mirrored.mirrored = true;
    return {evaluate(node, p, place), evaluate(node, p, mirrored)};
}

template EndpointNumber<Ball> evaluate(const Node&, const Point<Ball>&, const Place&);
template EndpointNumber<ComplexBall> evaluate(const Node&, const Point<ComplexBall>&, const Place&);

template <class V>
std::optional<EndpointNumber<V>> Place::exp_x(const EndpointNumber<V>& left, const EndpointNumber<V>& right) const
{
    if (!range) return std::nullopt;
    switch (range->map) {
    case Map::right_exponential: return EndpointNumber<V>(exp(range->from.ball())) / right;
    case Map::left_exponential: return EndpointNumber<V>(exp(range->to.ball())) * left;
    case Map::line_exponential: return left / right;
    default: return std::nullopt;
    }
}
template std::optional<EndpointNumber<Ball>> Place::exp_x(const EndpointNumber<Ball>&, const EndpointNumber<Ball>&) const;
template std::optional<EndpointNumber<ComplexBall>> Place::exp_x(const EndpointNumber<ComplexBall>&,
                                                                 const EndpointNumber<ComplexBall>&) const;

namespace {

/// The point at distance s from an end, and the other distance, for numbers of either kind.
template <class V, class Number>
Point<V> about(const Range& range, Side side, const Number& s)
{
    Point<V> p;
    const bool at_left = side == Side::left;
    const EndpointNumber<V> end((at_left ? range.from : range.to).ball());
    const EndpointNumber<V> far = [&]() -> EndpointNumber<V> {
        const V plain = s.value();
        switch (range.map) {
        case Map::finite: return EndpointNumber<V>(range.to.ball() - range.from.ball()) - s;
        case Map::right_exponential:
        case Map::left_exponential: return EndpointNumber<V>(analytic::exp(-plain));
        case Map::right_algebraic:
        case Map::left_algebraic: return EndpointNumber<V>(V(1) / (V(1) + plain));
        default: return EndpointNumber<V>(V::indeterminate());
        }
    }();
    p.x = at_left ? end + s : end - s;
    if (arb_is_zero((at_left ? range.from : range.to).ball().get())) p.x = at_left ? s : -s;
    (at_left ? p.left : p.right) = s;
    (at_left ? p.right : p.left) = EndpointNumber<V>(far.value());
    return p;
}

} // namespace

template <class V>
Point<V> point_about(const Disc<V>& disc, const Place& place)
{
    const Order one{1, 0};
    const bool at_left = disc.side() == Side::left;
    const EndpointNumber<V> s(&disc, at_left ? one : Order{}, at_left ? Order{} : one, V(1));
    Point<V> p = about<V>(*place.range, disc.side(), s);
    p.exp_x = place.exp_x(p.left, p.right);
    return p;
}

template Point<Ball> point_about(const Disc<Ball>&, const Place&);
template Point<ComplexBall> point_about(const Disc<ComplexBall>&, const Place&);

} // namespace touchstone::quadrature::compiled
