// SPDX-License-Identifier: MIT
#include "touchstone/quadrature/substitution.hpp"

#include "touchstone/quadrature/exact_series.hpp"
#include "touchstone/quadrature/expression_tree.hpp"
#include "touchstone/quadrature/polynomial.hpp"

#include <cstdlib>

namespace touchstone::quadrature {
namespace {

ExpressionPtr number(const Rational& q) { return make_number(q); }

bool is_number(const Expression& e, long n) { return e.op == Op::number && e.number == n; }

ExpressionPtr product(const ExpressionPtr& a, const ExpressionPtr& b)
{
    if (is_number(*a, 1)) return b;
    if (is_number(*b, 1)) return a;
    return make(Op::multiply, {a, b});
}

/// a/b with quotients of quotients cleared.
ExpressionPtr quotient(const ExpressionPtr& a, const ExpressionPtr& b)
{
    if (is_number(*b, 1)) return a;
    if (b->op == Op::divide) return quotient(product(a, b->args[1]), b->args[0]);
    return make(Op::divide, {a, b});
}

/// (1/b)^e = 1/b^e for b > 0.
ExpressionPtr power(const ExpressionPtr& base, const ExpressionPtr& exponent)
{
    if (base->op != Op::divide || !is_number(*base->args[0], 1)) return make(Op::power, {base, exponent});
    return quotient(number(1), make(Op::power, {base->args[1], exponent}));
}

/// The formula as it is written inside an inner integral.
ExpressionPtr with_variable_outside(const ExpressionPtr& e)
{
    return rebuilt(e, [](const ExpressionPtr& n) { return n->op == Op::variable ? make(Op::outer, {}) : nullptr; });
}

/// Every x replaced; `linear` gives what a polynomial of degree 1 becomes, if it is better than that.
template <class Linear>
ExpressionPtr replaced(const ExpressionPtr& e, const ExpressionPtr& x, const Linear& linear)
{
    if (!depends_on_x(*e)) return e;
    if (const auto better = linear(*e)) return *better;
    if (e->op == Op::variable) return x;
    if (e->op == Op::odd_difference) { // of another variable it is no longer one
        const ExpressionPtr mirrored = substituted(e->args[0], make(Op::negate, {make_variable()}));
        return make(Op::add, {replaced(e->args[0], x, linear), make(Op::negate, {replaced(mirrored, x, linear)})});
    }
    std::vector<ExpressionPtr> args;
    for (const ExpressionPtr& a : e->args) args.push_back(replaced(a, x, linear));
    if (e->op == Op::integral) {
        const ExpressionPtr outer = with_variable_outside(x);
        Expression copy = *e;
        copy.args = std::move(args);
        copy.integrand = rebuilt(e->integrand, [&](const ExpressionPtr& n) { return n->op == Op::outer ? outer : nullptr; });
        return std::make_shared<const Expression>(std::move(copy));
    }
    if (e->op == Op::divide) return quotient(args[0], args[1]);
    if (e->op == Op::power) return power(args[0], args[1]);
    return make(e->op, std::move(args));
}

} // namespace

ExpressionPtr formula_of(const ExactSum& c)
{
    ExpressionPtr sum;
    for (const auto& [key, q] : c.terms()) {
        const auto& [halves_of_pi, radicand] = key;
        ExpressionPtr term = number(q);
        if (halves_of_pi == 2)
            term = product(term, make(Op::pi, {}));
        else if (halves_of_pi != 0)
            term = product(term, make(Op::power, {make(Op::pi, {}), number(Rational(halves_of_pi) / 2)}));
        if (radicand < 0) term = product(term, make(Op::imaginary_unit, {}));
        if (std::labs(radicand) != 1) term = product(term, make(Op::sqrt, {number(Rational(std::labs(radicand)))}));
        sum = sum ? make(Op::add, {sum, term}) : term;
    }
    return sum ? sum : number(0);
}

ExpressionPtr shifted(const ExpressionPtr& e, const ExactSum& centre, int direction)
{
    const ExpressionPtr step = product(number(direction), make_variable());
    const auto as_it_is = [](const Expression&) -> std::optional<ExpressionPtr> { return std::nullopt; };
    return replaced(e, centre.is_zero() ? step : make(Op::add, {formula_of(centre), step}), as_it_is);
}

ExpressionPtr substituted(const ExpressionPtr& e, const ExpressionPtr& x)
{
    return replaced(e, x, [](const Expression&) -> std::optional<ExpressionPtr> { return std::nullopt; });
}

ExpressionPtr about_infinity(const ExpressionPtr& e, const ExactSum& end, int direction)
{
    const ExpressionPtr step = quotient(number(direction), make_variable());
    const auto linear = [&](const Expression& a) -> std::optional<ExpressionPtr> { // k (x - end) is k direction/x
        const auto p = polynomial(a);
        if (!p || p->size() != 2 || !value(*p, end).is_zero()) return std::nullopt;
        return quotient(formula_of((*p)[1] * ExactSum(direction)), make_variable());
    };
    const ExpressionPtr f = replaced(e, end.is_zero() ? step : make(Op::add, {formula_of(end), step}), linear);
    return quotient(f, make(Op::power, {make_variable(), number(2)}));
}

} // namespace touchstone::quadrature
