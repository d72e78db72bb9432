// SPDX-License-Identifier: MIT
#include "touchstone/quadrature/path.hpp"

#include "touchstone/quadrature/substitution.hpp"

#include <algorithm>

namespace touchstone::quadrature {
namespace {

ComplexBall value_of(const ExpressionPtr& e)
{
    const WorkingPrecision precision(256);
    return PlainFormula(e).at(ComplexBall(0));
}

std::string_view trimmed(std::string_view text)
{
    while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
    while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
    return text;
}

ExpressionPtr constant_of(std::string_view text, const Parameters& parameters)
{
    ExpressionPtr e = parse_expression(text, parameters);
    if (depends_on_x(*e)) throw ExpressionError(1, "a point of the path must not depend on x");
    if (!value_of(e).is_finite()) throw ExpressionError(e->column, "'" + std::string(text) + "' is no number");
    return e;
}

/// One side of the polygon as an integral over a real variable.
struct Stretch {
    ExpressionPtr formula;
    Limit from, to;
    std::string in; ///< what the variable is, if it is not x
    bool reversed = false;
};

bool coincide(const Vertex& a, const Vertex& b)
{
    if (!a.point || !b.point) return false;
    const auto d = exact_value(*make(Op::add, {b.point, make(Op::negate, {a.point})}));
    return d && d->is_zero();
}

ExpressionPtr sum(const ExpressionPtr& a, const ExpressionPtr& b)
{
    const auto zero = exact_value(*a);
    return zero && zero->is_zero() ? b : make(Op::add, {a, b});
}

Stretch stretch_between(const ExpressionPtr& e, const Vertex& a, const Vertex& b)
{
    if (a.is_real && b.is_real) return {e, limit_of(a), limit_of(b), "", false};
    if (!a.point && !b.point) throw DomainError("the path needs a point between its ends at infinity " + a.text + " and " + b.text);
    const ExpressionPtr t = make_variable();
    const std::string in = " on the path from " + a.text + " to " + b.text;
    if (a.point && b.point) {
        const ExpressionPtr along = make(Op::add, {b.point, make(Op::negate, {a.point})});
        const ExpressionPtr x = sum(a.point, make(Op::multiply, {along, t}));
        return {make(Op::multiply, {along, substituted(e, x)}), parse_limit("0"), parse_limit("1"), in + " as a fraction of it", false};
    }
    const Vertex &finite = a.point ? a : b, &infinite = a.point ? b : a;
    const ExpressionPtr x = sum(finite.point, make(Op::multiply, {infinite.direction, t}));
    return {make(Op::multiply, {infinite.direction, substituted(e, x)}), parse_limit("0"), parse_limit("inf"),
            in + " in units of its direction", !a.point};
}

} // namespace

Limit limit_of(const Vertex& v)
{
    if (!v.point) return parse_limit(v.text);
    Limit l;
    l.formula = v.point;
    l.exact = exact_value(*v.point);
    l.text = v.text;
    return l;
}

Vertex parse_vertex(std::string_view text, const Parameters& parameters)
{
    text = trimmed(text);
    Vertex v;
    v.text = text;
    const std::string_view word = !text.empty() && (text.front() == '-' || text.front() == '+') ? text.substr(1) : text;
    constexpr std::string_view times_infinity = "*inf";
    if (word == "inf" || word == "infinity" || word == "oo") {
        v.direction = make_number(Rational(text.front() == '-' ? -1 : 1));
        v.is_real = true;
    }
    else if (text.ends_with(times_infinity)) {
        v.direction = constant_of(text.substr(0, text.size() - times_infinity.size()), parameters);
        if (acb_contains_zero(value_of(v.direction).get())) throw ExpressionError(1, "the direction of " + v.text + " is 0");
    }
    else {
        v.point = constant_of(text, parameters);
        v.is_real = is_real(*v.point);
        if (const auto exact = exact_value(*v.point)) v.is_real = exact->is_real(); // i^2
    }
    return v;
}

Integral integrate_along(const ExpressionPtr& e, const std::vector<Vertex>& path, const IntegralOptions& options)
{
    if (path.size() < 2) throw DomainError("a path has two points at least");
    if (path.size() == 2 && path[0].is_real && path[1].is_real) return integrate(e, limit_of(path[0]), limit_of(path[1]), options);
    if (!options.at.empty() || !options.principal_value.empty())
        throw DomainError("break points and principal values are for real ranges: on a path, name a break point as one of its points");
    std::vector<Stretch> sides;
    {
        const WorkingPrecision precision(256);
        for (std::size_t k = 0; k + 1 < path.size(); ++k)
            if (!coincide(path[k], path[k + 1])) sides.push_back(stretch_between(e, path[k], path[k + 1]));
    }
    IntegralOptions each;
    each.gauss_legendre = options.gauss_legendre;
    each.of_absolute = true;
    return with_enough_digits(options, [&](long digits, Integral& whole) {
        each.digits = digits;
        whole = {};
        whole.value = whole.imaginary = Ball(0);
        whole.is_complex = true;
        for (const Stretch& s : sides) {
            Integral part = integrate(s.formula, s.from, s.to, each);
            if (!part.value.is_finite()) {
                whole.value = Ball::indeterminate();
                whole.divergent = part.divergent;
                whole.reason = part.reason + (s.in.empty() ? "" : " (x" + s.in + ")");
                return false;
            }
            if (s.reversed) part = negated(std::move(part));
            const WorkingPrecision precision(bits_for_digits(digits) + 64);
            whole.value += part.value;
            whole.imaginary += part.imaginary;
            for (Part& p : part.parts) {
                p.rule += s.in;
                whole.parts.push_back(std::move(p));
            }
        }
        return true;
    });
}

} // namespace touchstone::quadrature
