// SPDX-License-Identifier: MIT
#include "touchstone/quadrature/substitution.hpp"

#include "touchstone/quadrature/exact_series.hpp"
#include "touchstone/quadrature/expression_tree.hpp"
#include "touchstone/quadrature/polynomial.hpp"

#include <cstdlib>
#include <set>

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

/// (1/b)^e = 1/b^e off the negative axis, where neither has a value that is proved; but (1/b)^0 has none at b = 0, where 1/b^0 has.
ExpressionPtr power(const ExpressionPtr& base, const ExpressionPtr& exponent)
{
    if (base->op != Op::divide || !is_number(*base->args[0], 1) || is_number(*exponent, 0)) return make(Op::power, {base, exponent});
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

/// c x^m.
struct Monomial {
    ExactSum c;
    Rational m;
};

/// (c x^m)^k for x > 0, if c^k is exact.
std::optional<Monomial> power(const Monomial& a, const Rational& k)
{
    if (a.c == ExactSum(1)) return Monomial{a.c, a.m * k};
    if (k.get_den() != 1 || !k.get_num().fits_slong_p()) return std::nullopt;
    const auto c = a.c.power(k.get_num().get_si());
    return c ? std::optional(Monomial{*c, a.m * k}) : std::nullopt;
}

/// The formula, if it is a monomial for x > 0.
std::optional<Monomial> monomial(const Expression& e)
{
    if (!depends_on_x(e)) {
        const auto c = exact_value(e);
        return c ? std::optional(Monomial{*c, 0}) : std::nullopt;
    }
    if (e.op == Op::variable) return Monomial{ExactSum(1), 1};
    const bool unary = e.op == Op::negate || e.op == Op::sqrt || e.op == Op::cbrt;
    const bool binary = e.op == Op::multiply || e.op == Op::divide || e.op == Op::power;
    if (!unary && !binary) return std::nullopt;
    const auto a = monomial(*e.args[0]), b = a && binary ? monomial(*e.args[1]) : std::nullopt;
    if (!a || (binary && !b)) return std::nullopt;
    switch (e.op) {
    case Op::negate: return Monomial{-a->c, a->m};
    case Op::sqrt: return power(*a, Rational(1, 2));
    case Op::cbrt: return power(*a, Rational(1, 3));
    case Op::multiply: return Monomial{a->c * b->c, a->m + b->m};
    case Op::divide: {
        const auto c = b->c.inverse();
        return c ? std::optional(Monomial{a->c * *c, a->m - b->m}) : std::nullopt;
    }
    default: {
        const auto k = b->m == 0 ? b->c.rational() : std::nullopt;
        return k ? power(*a, *k) : std::nullopt;
    }
    }
}

/// The monomials among the factors of a product or quotient, and the other factors above and below.
struct Factors {
    Monomial all{ExactSum(1), 0};
    ExpressionPtr above = number(1), below = number(1);

    void take(const ExpressionPtr& e, bool inverse)
    {
        const auto own = monomial(*e);
        if (const auto a = own ? power(*own, inverse ? -1 : 1) : std::nullopt) {
            all = {all.c * a->c, all.m + a->m};
            return;
        }
        if (e->op == Op::multiply || e->op == Op::divide) {
            take(e->args[0], inverse);
            take(e->args[1], inverse != (e->op == Op::divide));
        }
        else if (e->op == Op::negate) {
            all.c = -all.c;
            take(e->args[0], inverse);
        }
        else
            (inverse ? below : above) = product(inverse ? below : above, e);
    }
};

void collect_powers(const Expression& e, std::set<Rational>& found)
{
    if (!depends_on_x(e)) return;
    if (const auto a = monomial(e)) {
        found.insert(a->m);
        return;
    }
    for (const ExpressionPtr& a : e.args) collect_powers(*a, found);
}

bool is_wave_or_exponential(Op op)
{
    return op == Op::sin || op == Op::cos || op == Op::sinc || op == Op::exp || op == Op::bessel_j || op == Op::bessel_y;
}

void collect_powers_in_arguments(const Expression& e, std::set<Rational>& found)
{
    if (is_wave_or_exponential(e.op)) collect_powers(*e.args.back(), found);
    for (const ExpressionPtr& a : e.args) collect_powers_in_arguments(*a, found);
}

/// The same for x > 0, with one monomial before it all.
ExpressionPtr with_one_monomial(const ExpressionPtr& e)
{
    Factors f;
    f.take(e, false);
    const ExpressionPtr x = make_variable();
    const ExpressionPtr power = f.all.m == 0 ? number(1) : f.all.m == 1 ? x : make(Op::power, {x, number(f.all.m)});
    return quotient(product(product(formula_of(f.all.c), power), f.above), f.below);
}

} // namespace

std::optional<Rational> power_in_arguments(const Expression& e)
{
    std::set<Rational> found;
    collect_powers_in_arguments(e, found);
    if (found.size() != 1 || *found.begin() == 1 || *found.begin() <= 0) return std::nullopt;
    return *found.begin();
}

ExpressionPtr in_power(const ExpressionPtr& e, const Rational& m)
{
    const ExpressionPtr t = make_variable();
    const auto power_of_t = [&](const Rational& k) { return k == 1 ? t : make(Op::power, {t, number(k)}); };
    const auto as_power = [&](const Expression& a) -> std::optional<ExpressionPtr> {
        const auto k = monomial(a);
        return k ? std::optional(product(formula_of(k->c), power_of_t(k->m / m))) : std::nullopt;
    };
    const Rational inverse = 1 / m;
    return product(number(inverse), product(replaced(e, power_of_t(inverse), as_power), power_of_t(inverse - 1)));
}

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
        if (const Integer size = abs(radicand); size != 1) term = product(term, make(Op::sqrt, {number(Rational(size))}));
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
    return with_one_monomial(quotient(f, make(Op::power, {make_variable(), number(2)})));
}

} // namespace touchstone::quadrature
