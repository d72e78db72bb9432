// SPDX-License-Identifier: MIT
/// \file
/// Formulas in one variable as they are typed: `x^(-1/2)*log(1/x)/(1+x^2)`.
///
/// Numbers are exact (`0.1` is 1/10, `1e-4` is 1/10000). Operators: + - * / ^ (also **), ^ binds to the right and before the sign, so
/// -x^2 is -(x^2). Constants: pi, e, i. The variable is x. Functions: function_names(), and one whose second argument is a name,
/// integral(f, y, a, b), an integral over y of a formula in x and y. Any other name must be among the parameters, which are numbers or
/// balls.
#pragma once

#include "touchstone/scalar/ball.hpp"

#include <functional>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace touchstone::quadrature {

/// What a node of a formula computes from its arguments.
enum class Op {
    number,
    variable,
    pi,
    e,
    imaginary_unit,
    parameter, ///< a name; only while a text is read
    outer,     ///< inside an integral, the variable of the formula around it
    infinity,  ///< an end of an integral
    ball,      ///< any of the numbers in it
    add,
    multiply,
    divide,
    power,
    negate,
    exp,
    log,
    sqrt,
    cbrt,
    abs,
    sign,
    floor,
    ceil,
    max,
    min,
    sin,
    cos,
    tan,
    cot,
    sec,
    csc,
    sinh,
    cosh,
    tanh,
    coth,
    sech,
    csch,
    asin,
    acos,
    atan,
    asinh,
    acosh,
    atanh,
    expm1,
    log1p,
    sinc,
    gamma,
    rgamma,
    lgamma,
    digamma,
    zeta,
    erf,
    erfc,
    erfi,
    ei,
    si,
    ci,
    li,
    dilog,
    airy_ai,
    airy_bi,
    lambert_w,
    elliptic_k,
    elliptic_e,
    elliptic_k_of_complement, ///< ellipk(1 - u), ellipe(1 - u): what they are replaced by where they reach 1
    elliptic_e_of_complement,
    bessel_j,
    bessel_y,
    bessel_i,
    bessel_k,
    bessel_i_scaled, ///< exp(-x) besseli(n, x), exp(x) besselk(nu, x), exp(x^2) erfc(x): what these products are replaced by on half-lines
    bessel_k_scaled,
    erfc_scaled,
    polylog,
    real_part, ///< (f + f*)/2, f* the formula with i replaced by -i: analytic where f and f* are, Re f for real arguments
    imaginary_part,
    conjugate,  ///< f*
    real_value, ///< of the value for a real x, whatever points of other variables stand in the formula
    imaginary_value,
    odd_difference, ///< h(x) - h(-x), h its argument: what a principal value is folded to
    integral,       ///< of `integrand`; its ends are the arguments
};

struct Expression;
using ExpressionPtr = std::shared_ptr<const Expression>;

/// A node of the tree. Immutable, shared.
struct Expression {
    Op op = Op::number;
    Rational number; ///< of Op::number; the middle of Op::ball
    Rational radius; ///< of Op::ball
    std::shared_ptr<const ComplexBall> ball; ///< of Op::ball where it is no ball about a rational number
    std::string name;                        ///< of Op::parameter
    std::vector<ExpressionPtr> args;
    ExpressionPtr integrand; ///< of Op::integral: its own variable is Op::variable, x is Op::outer
    std::size_t column = 1; ///< where it starts in the text, from 1
};

/// A text that is no formula. what() is one line that names the column.
class ExpressionError : public std::runtime_error {
public:
    ExpressionError(std::size_t column, const std::string& what);
    std::size_t column() const { return column_; }

private:
    std::size_t column_;
};

/// All of the numbers middle - radius .. middle + radius.
struct Parameter {
    Rational middle, radius;
};
using Parameters = std::map<std::string, Parameter, std::less<>>;

/// `0.5`, `1/3+/-1e-20`. \throws ExpressionError
Parameter parse_parameter(std::string_view text);
/// Whether formulas may use it for a parameter.
bool is_free_name(std::string_view name);

/// \throws ExpressionError saying where and what would be right.
ExpressionPtr parse_expression(std::string_view text, const Parameters& = {});

/// Of all functions, in alphabetical order.
std::vector<std::string> function_names();

/// Whether x occurs in it.
bool depends_on_x(const Expression&);
/// Whether it is real for real x (and real points of an outer variable) wherever its functions are: nothing in it is imaginary.
bool is_real(const Expression&);
/// Whether the first of two arguments is an order, which must be a real number: Bessel functions, the polylogarithm.
bool has_order(Op);
/// Whether a point of an outer variable in it is not on the real line.
bool has_complex_point(const Expression&);
/// Whether a node of the tree, inside inner integrals too, is as asked.
bool any_node(const Expression&, const std::function<bool(const Expression&)>&);

ExpressionPtr make_number(const Rational&);
ExpressionPtr make(Op, std::vector<ExpressionPtr> args);
ExpressionPtr make_variable();
ExpressionPtr make_ball(const ComplexBall&);

} // namespace touchstone::quadrature
