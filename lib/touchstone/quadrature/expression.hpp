// SPDX-License-Identifier: MIT
/// \file
/// Formulas in one variable as they are typed: `x^(-1/2)*log(1/x)/(1+x^2)`.
///
/// Numbers are exact (`0.1` is 1/10, `1e-4` is 1/10000). Operators: + - * / ^ (also **), ^ binds to the right and before the sign, so
/// -x^2 is -(x^2). Constants: pi, e. The variable is x. Functions: function_names().
#pragma once

#include "touchstone/scalar/rational.hpp"

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
    bessel_j,
    bessel_y,
    bessel_i,
    bessel_k,
    polylog,
};

struct Expression;
using ExpressionPtr = std::shared_ptr<const Expression>;

/// A node of the tree. Immutable, shared.
struct Expression {
    Op op = Op::number;
    Rational number; ///< of Op::number
    std::vector<ExpressionPtr> args;
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

/// \throws ExpressionError saying where and what would be right.
ExpressionPtr parse_expression(std::string_view text);

/// Of all functions, in alphabetical order.
std::vector<std::string> function_names();

/// Whether x occurs in it.
bool depends_on_x(const Expression&);

ExpressionPtr make_number(const Rational&);
ExpressionPtr make(Op, std::vector<ExpressionPtr> args);
ExpressionPtr make_variable();

} // namespace touchstone::quadrature
