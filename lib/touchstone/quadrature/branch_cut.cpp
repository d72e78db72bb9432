// SPDX-License-Identifier: MIT
#include "touchstone/quadrature/branch_cut.hpp"

#include <cmath>
#include <functional>
#include <sstream>
#include <vector>

namespace touchstone::quadrature {
namespace {

constexpr slong hint_bits = 64;

/// Points inside that are no likely places of a singular point. The whole line has been cut at 0 before anyone asks.
std::vector<Ball> points_inside(const Limit& from, const Limit& to)
{
    std::vector<Ball> points;
    if (from.infinite && to.infinite) return points;
    for (const long k : {3L, 11L, 18L}) { // of 21
        const Ball part(Rational(k, 21));
        if (to.infinite) points.push_back(from.ball() + 4 * part);
        else if (from.infinite) points.push_back(to.ball() - 4 * part);
        else points.push_back(from.ball() + (to.ball() - from.ball()) * part);
    }
    return points;
}

/// What has a cut that real numbers may lie on, and what it is called; nothing of other nodes.
const char* name_with_cut(const Expression& e)
{
    switch (e.op) {
    case Op::sqrt: return "sqrt";
    case Op::cbrt: return "cbrt";
    case Op::log: return "log";
    case Op::log1p: return "log1p";
    case Op::asin: return "asin";
    case Op::acos: return "acos";
    case Op::acosh: return "acosh";
    case Op::atanh: return "atanh";
    case Op::dilog: return "dilog";
    case Op::li: return "li";
    case Op::lgamma: return "lgamma";
    case Op::lambert_w: return "lambertw";
    case Op::elliptic_k: return "ellipk";
    case Op::elliptic_e: return "ellipe";
    case Op::bessel_y: return "bessely";
    case Op::bessel_k: return "besselk";
    case Op::power: return "the power";
    default: return nullptr;
    }
}

std::string few_digits(const Ball& x)
{
    constexpr slong digits = 4;
    const double near = arf_get_d(arb_midref(x.get()), ARF_RND_NEAR);
    if (arf_is_zero(arb_midref(x.get())) || (near != 0 && std::isfinite(near))) {
        std::ostringstream out;
        out.precision(digits);
        out << near;
        return out.str();
    }
    char* const text = arb_get_str(x.get(), digits, ARB_STR_NO_RADIUS); // beyond what doubles hold
    std::string few = text;
    flint_free(text);
    return few;
}

std::string few_digits(const ComplexBall& z)
{
    return few_digits(z.real()) + (arf_is_zero(arb_midref(acb_imagref(z.get()))) ? "" : " + i " + few_digits(z.imag()));
}

/// What is divided by, if that is 0 wherever it is looked at: 1/0, x/(x-x).
bool divides_by_zero(const Expression& n, const std::function<ComplexBall(const ExpressionPtr&)>& value)
{
    return n.op == Op::divide && acb_is_zero(value(n.args[1]).get()) != 0;
}

/// The argument of a node that has a cut.
std::size_t cut_argument(const Expression& n) { return n.op == Op::power ? 0 : n.args.size() - 1; } // besselk(n, x)

/// Whether the node has no value at this argument because of its cut: there it is not analytic, and a little above it is. A value may lack
/// because it is too large, too; and a ball may meet the cut though no number of it is meant.
bool is_on_cut(const Expression& n, const ComplexBall& argument)
{
    if (acb_is_zero(argument.get())) return true;
    if (acb_contains_zero(argument.get())) return false;
    std::vector<ExpressionPtr> args = n.args;
    args[cut_argument(n)] = make_variable();
    const ComplexBall above = argument + ComplexBall(Ball(0), abs(argument) / Ball(1000));
    return PlainFormula(make(n.op, args)).at(above).is_finite();
}

} // namespace

std::optional<std::string> argument_on_cut(const ExpressionPtr& e, const Limit& from, const Limit& to)
{
    const WorkingPrecision precision(hint_bits);
    std::optional<std::string> found;
    for (const Ball& x : points_inside(from, to)) {
        const auto value = [&](const ExpressionPtr& f) { return PlainFormula(f).at(ComplexBall(x)); };
        any_node(*e, [&](const Expression& n) {
            if (divides_by_zero(n, value)) {
                found = "what stands at column " + std::to_string(n.column) + " is divided by 0";
                return true;
            }
            const char* name = name_with_cut(n);
            if (!name) return false;
            const ComplexBall argument = value(n.args[cut_argument(n)]);
            if (!argument.is_finite() || value(std::make_shared<const Expression>(n)).is_finite() || !is_on_cut(n, argument)) return false;
            found = std::string(name) + " at column " + std::to_string(n.column) + " takes " + few_digits(argument) + " at x = " +
                    few_digits(x);
            *found += acb_is_zero(argument.get()) ? ", where it is no analytic function"
                                                  : ", on its cut (write the branch that is meant, as i*sqrt(-x) for sqrt(x) of x < 0)";
            return true;
        });
        if (found) return found;
    }
    return found;
}

} // namespace touchstone::quadrature
