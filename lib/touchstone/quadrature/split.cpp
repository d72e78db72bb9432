// SPDX-License-Identifier: MIT
#include "touchstone/quadrature/split.hpp"

namespace touchstone::quadrature {
namespace {

using Parts = std::pair<ExpressionPtr, ExpressionPtr>;
using Maybe = std::optional<Parts>;

ExpressionPtr number(long n) { return make_number(Rational(n)); }

ExpressionPtr sum(const ExpressionPtr& a, const ExpressionPtr& b) { return !a ? b : !b ? a : make(Op::add, {a, b}); }
ExpressionPtr negative(const ExpressionPtr& a) { return a ? make(Op::negate, {a}) : a; }
ExpressionPtr difference(const ExpressionPtr& a, const ExpressionPtr& b) { return sum(a, negative(b)); }
ExpressionPtr product(const ExpressionPtr& a, const ExpressionPtr& b)
{
    const auto is_one = [](const ExpressionPtr& e) { return e->op == Op::number && e->number == 1; };
    if (!a || !b) return nullptr;
    return is_one(a) ? b : is_one(b) ? a : make(Op::multiply, {a, b});
}
ExpressionPtr quotient(const ExpressionPtr& a, const ExpressionPtr& b) { return a ? make(Op::divide, {a, b}) : a; }
ExpressionPtr of(Op op, const ExpressionPtr& a) { return make(op, {a ? a : number(0)}); }

Parts product(const Parts& a, const Parts& b)
{
    return {difference(product(a.first, b.first), product(a.second, b.second)),
            sum(product(a.first, b.second), product(a.second, b.first))};
}

Parts quotient(const Parts& a, const Parts& b)
{
    if (!b.second) return {quotient(a.first, b.first ? b.first : number(0)), quotient(a.second, b.first ? b.first : number(0))};
    const ExpressionPtr square = sum(product(b.first, b.first), product(b.second, b.second));
    const Parts top = product(a, {b.first, negative(b.second)});
    return {quotient(top.first, square), quotient(top.second, square)};
}

Maybe power(const Expression& e)
{
    constexpr long highest = 8;
    const Expression& exponent = *e.args[1];
    const bool negated = exponent.op == Op::negate;
    const Expression& size = negated ? *exponent.args[0] : exponent;
    if (size.op != Op::number || size.number.get_den() != 1 || size.number < 1 || size.number > highest) return std::nullopt;
    const auto base = real_and_imaginary(e.args[0]);
    if (!base) return std::nullopt;
    Parts r = *base;
    for (long k = 1; k < size.number.get_num().get_si(); ++k) r = product(r, *base);
    return negated ? quotient({number(1), nullptr}, r) : r;
}

/// exp(a + ib) = exp(a) (cos b + i sin b) and its kin.
Maybe of_one_argument(const Expression& e)
{
    const auto z = real_and_imaginary(e.args[0]);
    if (!z || !z.value().second) return std::nullopt;
    const ExpressionPtr &a = z->first, &b = z->second;
    const ExpressionPtr c = of(Op::cos, b), s = of(Op::sin, b);
    switch (e.op) {
    case Op::exp: {
        const ExpressionPtr size = a ? of(Op::exp, a) : number(1);
        return Parts{product(size, c), product(size, s)};
    }
    case Op::cos: return Parts{product(of(Op::cos, a), of(Op::cosh, b)), negative(product(of(Op::sin, a), of(Op::sinh, b)))};
    case Op::sin: return Parts{product(of(Op::sin, a), of(Op::cosh, b)), product(of(Op::cos, a), of(Op::sinh, b))};
    case Op::cosh: return Parts{product(of(Op::cosh, a), c), product(of(Op::sinh, a), s)};
    case Op::sinh: return Parts{product(of(Op::sinh, a), c), product(of(Op::cosh, a), s)};
    default: return std::nullopt;
    }
}

} // namespace

Maybe real_and_imaginary(const ExpressionPtr& e)
{
    if (has_complex_point(*e)) return std::nullopt;
    if (is_real(*e)) return Parts{e, nullptr};
    const auto of_arg = [&](std::size_t k) { return real_and_imaginary(e->args[k]); };
    switch (e->op) {
    case Op::imaginary_unit: return Parts{nullptr, number(1)};
    case Op::add:
    case Op::multiply:
    case Op::divide: {
        const auto a = of_arg(0), b = of_arg(1);
        if (!a || !b) return std::nullopt;
        if (e->op == Op::add) return Parts{sum(a->first, b->first), sum(a->second, b->second)};
        return e->op == Op::multiply ? product(*a, *b) : quotient(*a, *b);
    }
    case Op::negate: {
        const auto a = of_arg(0);
        return a ? Maybe(Parts{negative(a->first), negative(a->second)}) : std::nullopt;
    }
    case Op::conjugate: {
        const auto a = of_arg(0);
        return a ? Maybe(Parts{a->first, negative(a->second)}) : std::nullopt;
    }
    case Op::power:
        if (e->args[0]->op == Op::e) return of_one_argument(*make(Op::exp, {e->args[1]}));
        return power(*e);
    default: return e->args.size() == 1 ? of_one_argument(*e) : std::nullopt;
    }
}

} // namespace touchstone::quadrature
