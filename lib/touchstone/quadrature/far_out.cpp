// SPDX-License-Identifier: MIT
#include "touchstone/quadrature/far_out.hpp"

#include "touchstone/quadrature/expression_tree.hpp"
#include "touchstone/quadrature/polynomial.hpp"
#include "touchstone/quadrature/substitution.hpp"

#include <algorithm>

namespace touchstone::quadrature {
using namespace tree;

namespace {

/// p - q, without the powers whose coefficients cancel.
ExpressionPtr formula_of_difference(Polynomial p, Polynomial q)
{
    const std::size_t terms = std::max(p.size(), q.size());
    p.resize(terms);
    q.resize(terms);
    ExpressionPtr all = number(0);
    long exponent = 0;
    for (const ExactSum& c : p) {
        const ExactSum rest = c - q[static_cast<std::size_t>(exponent)];
        if (!rest.is_zero()) all = sum(all, product(formula_of(rest), make(Op::power, {make_variable(), number(exponent)})));
        ++exponent;
    }
    return all;
}

/// What stands above and below the line of a product of products and quotients.
struct Factors {
    std::vector<ExpressionPtr> above, below;
    void add(const ExpressionPtr& e, bool divides)
    {
        if (e->op == Op::multiply || e->op == Op::divide) {
            add(e->args[0], divides);
            add(e->args[1], e->op == Op::divide ? !divides : divides);
        }
        else
            (divides ? below : above).push_back(e);
    }
};

ExpressionPtr product_of(const std::vector<ExpressionPtr>& all)
{
    ExpressionPtr r = number(1);
    for (std::size_t i = 0; i < all.size(); ++i) r = i == 0 ? all[i] : product(r, all[i]);
    return r;
}

/// The exponent if e is an exponential.
ExpressionPtr exponent_of(const ExpressionPtr& e)
{
    if (e->op == Op::exp) return e->args[0];
    return e->op == Op::power && e->args[0]->op == Op::e ? e->args[1] : nullptr;
}

/// The function that is f times the exponential of the exponent, where that takes the exponential out of it.
ExpressionPtr scaled_function(const Expression& f, const ExpressionPtr& exponent)
{
    const auto opposite = [](const ExpressionPtr& a, const ExpressionPtr& b) {
        const auto p = polynomial(*sum(a, b));
        return p && std::all_of(p->begin(), p->end(), [](const ExactSum& c) { return c.is_zero(); });
    };
    const ExpressionPtr argument = f.args.empty() ? nullptr : f.args.back();
    if (f.op == Op::bessel_i && opposite(exponent, argument)) return make(Op::bessel_i_scaled, f.args);
    if (f.op == Op::bessel_k && opposite(exponent, of(Op::negate, argument))) return make(Op::bessel_k_scaled, f.args);
    if (f.op == Op::erfc && opposite(exponent, of(Op::negate, product(argument, argument)))) return make(Op::erfc_scaled, f.args);
    return nullptr;
}

} // namespace

ExpressionPtr less_one(const ExpressionPtr& e)
{
    if (e->op == Op::tanh || e->op == Op::coth) {
        const ExpressionPtr fall = of(Op::exp, product(number(-2), e->args[0])), sign = number(e->op == Op::tanh ? 1 : -1);
        const ExpressionPtr least = sum(number(1), product(sign, fall));
        return quotient(product(number(e->op == Op::tanh ? -2 : 2), fall), least);
    }
    if (e->op == Op::divide)
        if (const auto p = polynomial(*e->args[0]), q = polynomial(*e->args[1]); p && q)
            return quotient(formula_of_difference(*p, *q), e->args[1]);
    std::vector<ExpressionPtr> all = summands(e);
    const auto one = std::find_if(all.begin(), all.end(), [](const ExpressionPtr& a) { return a->op == Op::number && a->number == 1; });
    if (all.size() < 2 || one == all.end()) return nullptr;
    all.erase(one);
    return sum_of(all);
}

ExpressionPtr with_scaled_functions(const ExpressionPtr& e)
{
    if (e->op != Op::multiply && e->op != Op::divide) return nullptr;
    Factors factors;
    factors.add(e, false);
    for (const bool divides : {false, true})
        for (auto& exponential : divides ? factors.below : factors.above) {
            const ExpressionPtr found = exponent_of(exponential), exponent = found && divides ? of(Op::negate, found) : found;
            if (!exponent) continue;
            for (auto& f : factors.above)
                if (const ExpressionPtr scaled = scaled_function(*f, exponent)) {
                    f = scaled;
                    exponential = number(1);
                    return quotient(product_of(factors.above), product_of(factors.below));
                }
        }
    return nullptr;
}

} // namespace touchstone::quadrature
