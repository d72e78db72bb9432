// SPDX-License-Identifier: MIT
/// \file
/// A Scalar that writes down what a formula does instead of doing it: the same templates that give numbers and proofs give source code.
///
/// A computer algebra system would reorder sums and so lose what makes a form stable; a Term keeps every operation and its order.
#pragma once

#include "touchstone/scalar/scalar.hpp"

#include <memory>
#include <string>
#include <vector>

namespace touchstone {

enum class Op {
    number,   ///< p/q
    literal,  ///< a binary64 constant, `text` in decimal
    pi,
    input,    ///< `text`
    negate, add, subtract, multiply, divide,
    call,     ///< `text`(arguments)
    select    ///< arguments 0 < 1 ? 2 : 3
};

class Term {
public:
    struct Node {
        Op op;
        std::string text{};
        std::vector<Term> arguments{};
        long p = 0, q = 1;
    };

    Term() : Term(0L) {}
    template <std::integral I>
    Term(I n) : node_(std::make_shared<const Node>(Node{Op::number, {}, {}, static_cast<long>(n), 1})) {}
    Term(double) = delete;
    explicit Term(Node node) : node_(std::make_shared<const Node>(std::move(node))) {}
    static Term input(std::string name) { return Term(Node{Op::input, std::move(name)}); }
    static Term literal(std::string decimal) { return Term(Node{Op::literal, std::move(decimal)}); }
    static Term call(std::string function, std::vector<Term> arguments)
    {
        return Term(Node{Op::call, std::move(function), std::move(arguments)});
    }

    const Node& operator*() const { return *node_; }
    const Node* operator->() const { return node_.get(); }
    const Node* id() const { return node_.get(); }

    friend Term operator+(const Term& a, const Term& b) { return binary(Op::add, a, b); }
    friend Term operator-(const Term& a, const Term& b) { return binary(Op::subtract, a, b); }
    friend Term operator*(const Term& a, const Term& b) { return binary(Op::multiply, a, b); }
    friend Term operator/(const Term& a, const Term& b) { return binary(Op::divide, a, b); }
    Term operator-() const { return Term(Node{Op::negate, {}, {*this}}); }

private:
    static Term binary(Op op, const Term& a, const Term& b) { return Term(Node{op, {}, {a, b}}); }

    std::shared_ptr<const Node> node_;
};

/// below < above ? yes : no
inline Term select(const Term& below, const Term& above, const Term& yes, const Term& no)
{
    return Term(Term::Node{Op::select, {}, {below, above, yes, no}});
}

inline Term sqrt(const Term& x) { return Term::call("sqrt", {x}); }
inline Term exp(const Term& x) { return Term::call("exp", {x}); }
inline Term log(const Term& x) { return Term::call("log", {x}); }
inline Term sin(const Term& x) { return Term::call("sin", {x}); }
inline Term cos(const Term& x) { return Term::call("cos", {x}); }
inline Term asin(const Term& x) { return Term::call("asin", {x}); }
inline Term acos(const Term& x) { return Term::call("acos", {x}); }
inline Term atan2(const Term& y, const Term& x) { return Term::call("atan2", {y, x}); }
inline Term pow(const Term& x, const Term& y) { return Term::call("pow", {x, y}); }
inline Term at_most(const Term& x, const Term& bound) { return Term::call("min", {x, bound}); }
inline Term at_least(const Term& x, const Term& bound) { return Term::call("max", {x, bound}); }

/// What is not known yet has no order; formulas that choose go through across_seam below.
inline Truth less(const Term&, const Term&) { return Truth::unknown; }
inline Term hull(const Term&, const Term&) { throw std::logic_error("a formula's branches are not written down as a hull"); }

template <>
struct ScalarTraits<Term> {
    static Term integer(long n) { return Term(n); }
    static Term quotient(long p, long q) { return Term(Term::Node{Op::number, {}, {}, p, q}); }
    static Term pi() { return Term(Term::Node{Op::pi}); }
    static Term sin_pi(const Term& x) { return Term::call("sin_pi", {x}); }
    static Term cos_pi(const Term& x) { return Term::call("cos_pi", {x}); }
    static Term powm1(const Term& x, const Term& y) { return Term::call("powm1", {x, y}); }
    static Term sqrt_positive_part(const Term& x) { return Term::call("sqrt_positive_part", {x}); }
    static Term sqrt_minus_square(const Term& a, const Term& b) { return Term::call("sqrt_minus_square", {a, b}); }
    static Term sqrt_minus_pi_square(const Term& a, const Term& x) { return Term::call("sqrt_minus_pi_square", {a, x}); }
    static Term sqrt_minus_sin_pi_square(const Term& a, const Term& x) { return Term::call("sqrt_minus_sin_pi_square", {a, x}); }
    static Term sqrt_pi_square_minus(const Term& x, const Term& a) { return Term::call("sqrt_pi_square_minus", {x, a}); }
    static Term sqrt_sin_pi_square_minus(const Term& x, const Term& a) { return Term::call("sqrt_sin_pi_square_minus", {x, a}); }
    static Term asin_sqrt_over_pi(const Term& s) { return Term::call("asin_sqrt_over_pi", {s}); }
    static Term atan_sqrt_over_pi(const Term& n, const Term& d) { return Term::call("atan_sqrt_over_pi", {n, d}); }
    static Term atan_minus_square_over_pi(const Term& a, const Term& b, const Term& d)
    {
        return Term::call("atan_minus_square_over_pi", {a, b, d});
    }
    static Term pow_product(const Term& x, const Term& a, const Term& b) { return Term::call("pow_product", {x, a, b}); }
    /// sum_j x^j/coefficient(j): a helper, named after its first two coefficients.
    template <class Coefficient>
    static Term series(const Term& x, Coefficient coefficient)
    {
        return Term::call("series_" + std::to_string(coefficient(0)) + "_" + std::to_string(coefficient(1)), {x});
    }
    static Term hypot(const Term& a, const Term& b) { return Term::call("root_of_squares", {a, b}); }
    static Term gamma(const Term& x) { return Term::call("gamma", {x}); }
    static Term power_of_two(long e) { return e >= 0 ? integer(1L << e) : quotient(1, 1L << -e); }
};

/// Both branches, and the choice between them.
template <class Below, class Above>
Term across_seam(const Term& x, const Term& seam, Below&& below, Above&& above)
{
    return select(x, seam, below(x), above(x));
}

namespace westergaard {
/// As for `double`: the difference that is exact.
inline Term above_lowest(const Term& p, const Term& load) { return select(Term(2), load, 1 + (p - load), p - (load - 1)); }
} // namespace westergaard

} // namespace touchstone
