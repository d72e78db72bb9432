// SPDX-License-Identifier: MIT
#include "touchstone/quadrature/branch_cut.hpp"

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

std::string few_digits(const ComplexBall& z)
{
    std::ostringstream out;
    out.precision(4);
    out << arf_get_d(arb_midref(acb_realref(z.get())), ARF_RND_NEAR);
    if (const double imaginary = arf_get_d(arb_midref(acb_imagref(z.get())), ARF_RND_NEAR); imaginary != 0) out << " + i " << imaginary;
    return out.str();
}

/// What is divided by, if that is 0 wherever it is looked at: 1/0, x/(x-x).
bool divides_by_zero(const Expression& n, const std::function<ComplexBall(const ExpressionPtr&)>& value)
{
    return n.op == Op::divide && acb_is_zero(value(n.args[1]).get()) != 0;
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
            const ExpressionPtr& of = n.op == Op::power ? n.args.front() : n.args.back(); // besselk(n, x)
            const ComplexBall argument = value(of);
            if (!argument.is_finite() || value(std::make_shared<const Expression>(n)).is_finite()) return false;
            found = std::string(name) + " at column " + std::to_string(n.column) + " takes " + few_digits(argument) + " at x = " +
                    few_digits(ComplexBall(x));
            *found += acb_is_zero(argument.get()) ? ", where it is no analytic function"
                                                  : ", on its cut (write the branch that is meant, as i*sqrt(-x) for sqrt(x) of x < 0)";
            return true;
        });
        if (found) return found;
    }
    return found;
}

} // namespace touchstone::quadrature
