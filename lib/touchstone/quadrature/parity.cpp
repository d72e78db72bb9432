// SPDX-License-Identifier: MIT
#include "touchstone/quadrature/parity.hpp"

#include <algorithm>
#include <unordered_map>

namespace touchstone::quadrature {

namespace {

bool is_even_function(Op op)
{
    return op == Op::abs || op == Op::cos || op == Op::sec || op == Op::cosh || op == Op::sech || op == Op::sinc;
}

bool is_odd_function(Op op)
{
    switch (op) {
    case Op::negate:
    case Op::sin:
    case Op::tan:
    case Op::cot:
    case Op::csc:
    case Op::sinh:
    case Op::tanh:
    case Op::coth:
    case Op::csch:
    case Op::asin:
    case Op::atan:
    case Op::asinh:
    case Op::atanh:
    case Op::erf:
    case Op::erfi: return true;
    default: return false;
    }
}

/// What is an integer for every x: the number that the node is.
std::optional<Rational> integer(const Expression& e)
{
    if (e.op == Op::negate) {
        const auto of = integer(*e.args[0]);
        return of ? std::optional<Rational>(-*of) : std::nullopt;
    }
    return e.op == Op::number && e.number.get_den() == 1 ? std::optional(e.number) : std::nullopt;
}

/// Equal parts of a formula may be one and the same node, which is looked at once.
class Parities {
public:
    Parity of(const Expression& e)
    {
        if (const auto known = known_.find(&e); known != known_.end()) return known->second;
        const Parity p = by_arguments(e);
        known_.emplace(&e, p);
        return p;
    }

private:
    Parity by_arguments(const Expression& e)
    {
        if (e.op == Op::variable) return Parity::odd;
        if (e.op == Op::integral) return depends_on_x(e) ? Parity::unknown : Parity::even;
        const auto all = [&](Parity p) {
            return std::all_of(e.args.begin(), e.args.end(), [&](const ExpressionPtr& a) { return of(*a) == p; });
        };
        if (e.op != Op::odd_difference && all(Parity::even)) return Parity::even; // of numbers too
        switch (e.op) {
        case Op::add: return all(Parity::odd) ? Parity::odd : Parity::unknown;
        case Op::multiply:
        case Op::divide: return product(e);
        case Op::power: return power(e);
        default: break;
        }
        if (e.args.size() != 1 || of(*e.args[0]) != Parity::odd) return Parity::unknown;
        return is_even_function(e.op) ? Parity::even : is_odd_function(e.op) ? Parity::odd : Parity::unknown;
    }
    Parity product(const Expression& e)
    {
        bool odd = false;
        for (const ExpressionPtr& a : e.args) {
            if (of(*a) == Parity::unknown) return Parity::unknown;
            odd ^= of(*a) == Parity::odd;
        }
        return odd ? Parity::odd : Parity::even;
    }
    Parity power(const Expression& e)
    {
        const auto n = integer(*e.args[1]);
        if (!n || of(*e.args[0]) != Parity::odd) return Parity::unknown;
        return mpz_even_p(n->get_num_mpz_t()) != 0 ? Parity::even : Parity::odd;
    }
    std::unordered_map<const Expression*, Parity> known_;
};

} // namespace

Parity parity(const Expression& e) { return Parities().of(e); }

} // namespace touchstone::quadrature
