// SPDX-License-Identifier: MIT
#include "touchstone/quadrature/parity.hpp"

#include "touchstone/quadrature/exact_series.hpp"

#include <algorithm>
#include <optional>
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

/// With period 2 pi, sign changed by pi.
bool is_wave(Op op) { return op == Op::sin || op == Op::cos || op == Op::sec || op == Op::csc || op == Op::tan || op == Op::cot; }

/// A formula about the centre: even, or odd but for a constant, or unknown.
struct Shape {
    Parity parity = Parity::unknown;
    ExactSum constant{}; ///< of what is odd but for it

    bool is_odd() const { return parity == Parity::odd && constant.is_zero(); }
};

/// Of a wave of m pi/2 + t, t odd.
Parity of_wave(Op op, const Integer& m)
{
    if (op == Op::tan || op == Op::cot) return Parity::odd; // those of t and -1 over them change places
    const bool is_sine = op == Op::sin || op == Op::csc, is_shifted = mpz_odd_p(m.get_mpz_t()) != 0;
    return is_sine == is_shifted ? Parity::even : Parity::odd;
}

/// Equal parts of a formula may be one and the same node, which is looked at once.
class Parities {
public:
    explicit Parities(const ExactSum& centre)
        : centre_(centre)
    {
    }
    Parity of(const Expression& e)
    {
        const Shape& s = shape(e);
        return s.parity == Parity::even || s.is_odd() ? s.parity : Parity::unknown;
    }

private:
    const Shape& shape(const Expression& e)
    {
        if (const auto known = known_.find(&e); known != known_.end()) return known->second;
        Shape s = by_arguments(e);
        return known_.emplace(&e, std::move(s)).first->second;
    }
    Shape by_arguments(const Expression& e)
    {
        if (e.op == Op::variable) return {Parity::odd, centre_};
        if (e.op == Op::integral) return {depends_on_x(e) ? Parity::unknown : Parity::even};
        const bool all_even =
            std::all_of(e.args.begin(), e.args.end(), [&](const ExpressionPtr& a) { return shape(*a).parity == Parity::even; });
        if (e.op != Op::odd_difference && all_even) return {Parity::even}; // of numbers too
        switch (e.op) {
        case Op::add: return sum(e);
        case Op::negate:
            if (shape(*e.args[0]).parity != Parity::odd) return {};
            return {Parity::odd, -shape(*e.args[0]).constant};
        case Op::multiply:
        case Op::divide: return product(e);
        case Op::power: return {power(e)};
        default: break;
        }
        return {e.args.size() == 1 ? function(e.op, shape(*e.args[0])) : Parity::unknown};
    }
    /// What is odd, and numbers.
    Shape sum(const Expression& e)
    {
        Shape all{Parity::odd};
        for (const ExpressionPtr& a : e.args) {
            const Shape& s = shape(*a);
            const auto number = s.parity == Parity::odd ? std::optional(s.constant) : exact_number(*a);
            if (!number) return {};
            all.constant = all.constant + *number;
        }
        return all;
    }
    Shape product(const Expression& e)
    {
        if (const auto scaled = multiple(e)) return *scaled;
        bool odd = false;
        for (const ExpressionPtr& a : e.args) {
            const Parity p = of(*a);
            if (p == Parity::unknown) return {};
            odd ^= p == Parity::odd;
        }
        return {odd ? Parity::odd : Parity::even};
    }
    /// A number times what is odd but for a constant, or that over a rational number.
    std::optional<Shape> multiple(const Expression& e)
    {
        if (e.args.size() != 2) return std::nullopt;
        const bool first = e.op == Op::multiply && !depends_on_x(*e.args[0]);
        const Shape& s = shape(*e.args[first ? 1 : 0]);
        const auto number = exact_number(*e.args[first ? 0 : 1]);
        if (s.parity != Parity::odd || !number || number->is_zero()) return std::nullopt;
        if (e.op == Op::multiply) return Shape{Parity::odd, s.constant * *number};
        const auto rational = number->rational();
        return rational ? std::optional(Shape{Parity::odd, s.constant * ExactSum(Rational(1 / *rational))}) : std::nullopt;
    }
    Parity power(const Expression& e)
    {
        const auto n = integer(*e.args[1]);
        if (!n || of(*e.args[0]) != Parity::odd) return Parity::unknown;
        return mpz_even_p(n->get_num_mpz_t()) != 0 ? Parity::even : Parity::odd;
    }
    static Parity function(Op op, const Shape& argument)
    {
        if (argument.parity != Parity::odd) return Parity::unknown;
        const auto turns = argument.constant.times_pi();
        if (is_wave(op) && turns)
            if (const Rational quarters = *turns * 2; quarters.get_den() == 1) return of_wave(op, quarters.get_num());
        if (!argument.is_odd()) return Parity::unknown;
        return is_even_function(op) ? Parity::even : is_odd_function(op) ? Parity::odd : Parity::unknown;
    }
    static std::optional<ExactSum> exact_number(const Expression& e) { return depends_on_x(e) ? std::nullopt : exact_value(e); }

    ExactSum centre_;
    std::unordered_map<const Expression*, Shape> known_;
};

} // namespace

Parity parity(const Expression& e, const ExactSum& centre) { return Parities(centre).of(e); }

} // namespace touchstone::quadrature
