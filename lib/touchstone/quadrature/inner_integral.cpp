// SPDX-License-Identifier: MIT
#include "touchstone/quadrature/inner_integral.hpp"

#include "touchstone/quadrature/expression_tree.hpp"
#include "touchstone/quadrature/integrate.hpp"

#include <algorithm>

namespace touchstone::quadrature {

bool is_infinite_end(const Expression& e)
{
    return e.op == Op::infinity || (e.op == Op::negate && e.args[0]->op == Op::infinity);
}

namespace compiled {
namespace {

std::optional<Limit> fixed_end(const ExpressionPtr& e)
{
    if (is_infinite_end(*e)) return parse_limit(e->op == Op::negate ? "-inf" : "inf");
    if (depends_on_x(*e)) return std::nullopt;
    Limit l;
    l.formula = e;
    l.exact = exact_value(*e);
    if (l.exact && !l.exact->is_real()) throw ExpressionError(e->column, "an end of an inner integral must be real or depend on x");
    l.text = "end";
    return l;
}

ExpressionPtr with_outer(const ExpressionPtr& f, const ComplexBall& x)
{
    const ExpressionPtr point = make_ball(x);
    return rebuilt(f, [&](const ExpressionPtr& e) { return e->op == Op::outer ? point : nullptr; });
}

ExpressionPtr with_variable(const ExpressionPtr& f, const ExpressionPtr& y)
{
    return rebuilt(f, [&](const ExpressionPtr& e) { return e->op == Op::variable ? y : nullptr; });
}

/// Digits that a ball of x supports, and a few.
long digits_for(const ComplexBall& x)
{
    constexpr double bits_per_digit = 3.3219281;
    constexpr slong least = 16, spare = 10;
    const slong known = acb_is_exact(x.get()) ? WorkingPrecision::bits() : acb_rel_accuracy_bits(x.get());
    const slong bits = std::clamp(known + spare, least, WorkingPrecision::bits() + spare);
    return static_cast<long>(static_cast<double>(bits) / bits_per_digit);
}

/// Whether what a function makes of a number is no analytic function of it, or another one for complex numbers than for real ones.
bool needs_real_argument(Op op)
{
    switch (op) {
    case Op::conjugate:
    case Op::real_part:
    case Op::imaginary_part:
    case Op::real_value:
    case Op::imaginary_value:
    case Op::abs:
    case Op::sign:
    case Op::floor:
    case Op::ceil:
    case Op::max:
    case Op::min:
    case Op::ei: return true;
    default: return false;
    }
}

/// Formulas are compiled as if their variable were real. The inner one is, between ends that are real for a real x; on the way to or from
/// another end it is not. \throws ExpressionError where that makes a difference
void require_analytic_between_complex_ends(const Expression& e)
{
    const auto is_complex = [](const ExpressionPtr& end) { return !is_real(*end) || has_complex_point(*end); };
    if (std::none_of(e.args.begin(), e.args.end(), is_complex)) return;
    const auto offends = [](const Expression& n) { return needs_real_argument(n.op) && depends_on_x(n); };
    if (any_node(*e.integrand, offends))
        throw ExpressionError(e.column, "between ends that are not real an inner integral is of analytic functions: no abs, conj, re, im, "
                                        "sign, floor, ceil, max, min or ei of its variable");
}

/// What is proved is proved for an x in the plane, where an order that depends on it is no real number.
void require_orders_without_outer_variable(const Expression& integrand)
{
    const auto is_outer = [](const Expression& n) { return n.op == Op::outer; };
    const auto offends = [&](const Expression& n) { return has_order(n.op) && any_node(*n.args[0], is_outer); };
    if (any_node(integrand, offends))
        throw ExpressionError(integrand.column, "the order of a Bessel function or polylogarithm must not depend on x");
}

/// y = from + (to - from) t over [0, 1], or from + t (to + t) where the other end is infinite, which is nothing.
Integral over_moving_ends(const InnerIntegral& inner, const ExpressionPtr& f, const std::optional<ComplexBall>& from,
                          const std::optional<ComplexBall>& to, const IntegralOptions& options)
{
    const ExpressionPtr t = make_variable();
    if (from && to) {
        const ExpressionPtr a = make_ball(*from), width = make_ball(*to - *from), step = make(Op::multiply, {width, t});
        const bool at_zero = acb_is_zero(from->get()) != 0;
        const ExpressionPtr y = at_zero ? step : make(Op::add, {a, step});
        return integrate(make(Op::multiply, {with_variable(f, y), width}), parse_limit("0"), parse_limit("1"), options);
    }
    const ExpressionPtr y = make(Op::add, {make_ball(from ? *from : *to), t});
    return from ? integrate(with_variable(f, y), parse_limit("0"), *inner.fixed[1], options)
                : integrate(with_variable(f, y), *inner.fixed[0], parse_limit("0"), options);
}

} // namespace

std::shared_ptr<const InnerIntegral> inner_integral(const Expression& e)
{
    const WorkingPrecision precision(256);
    require_analytic_between_complex_ends(e);
    require_orders_without_outer_variable(*e.integrand);
    auto inner = std::make_shared<InnerIntegral>();
    inner->integrand = e.integrand;
    for (const std::size_t k : {0, 1}) inner->fixed[k] = fixed_end(e.args[k]);
    inner->depends_on_outer = any_node(*e.integrand, [](const Expression& n) { return n.op == Op::outer; });
    return inner;
}

template <class V>
V value_of_inner(const InnerIntegral& inner, const V& at, const std::optional<V>& from, const std::optional<V>& to, bool conjugated)
{
    const auto placed = [&](const V& v) {
        ComplexBall z(v);
        if (conjugated) acb_conj(z.get(), z.get());
        return z;
    };
    const auto placed_end = [&](const std::optional<V>& v) { return v ? std::optional(placed(*v)) : std::nullopt; };
    const ComplexBall x = placed(at);
    const auto a = placed_end(from), b = placed_end(to);
    if ((inner.depends_on_outer && !x.is_finite()) || (a && !a->is_finite()) || (b && !b->is_finite())) return V::indeterminate();
    IntegralOptions options;
    options.quick = true;
    options.digits = digits_for(x);
    const ExpressionPtr f = with_outer(inner.integrand, x);
    try {
        const Integral i = inner.fixed[0] && inner.fixed[1] ? integrate(f, *inner.fixed[0], *inner.fixed[1], options)
                                                             : over_moving_ends(inner, f, a, b, options);
        if (!i.value.is_finite() || !i.imaginary.is_finite()) return V::indeterminate();
        if constexpr (std::same_as<V, Ball>)
            return arb_is_zero(i.imaginary.get()) ? i.value : Ball::indeterminate();
        else {
            ComplexBall z(i.value, i.imaginary);
            if (conjugated) acb_conj(z.get(), z.get());
            return z;
        }
    }
    catch (const DomainError&) {
        return V::indeterminate();
    }
}

template Ball value_of_inner(const InnerIntegral&, const Ball&, const std::optional<Ball>&, const std::optional<Ball>&, bool);
template ComplexBall value_of_inner(const InnerIntegral&, const ComplexBall&, const std::optional<ComplexBall>&,
                                    const std::optional<ComplexBall>&, bool);

} // namespace compiled
} // namespace touchstone::quadrature
