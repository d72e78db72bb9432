// SPDX-License-Identifier: MIT
// Cauchy principal values: about a named pole c the integrand is folded, PV integral over |x - c| <= R of f = integral_0^R of
// f(c + s) + f(c - s) ds. That is the definition; nothing is assumed of the pole. Its cancellation is exact (exact_series.hpp), or that of
// an odd difference of an analytic function (tanh_sinh.md, section 11).
#include "touchstone/quadrature/integrate.hpp"
#include "touchstone/quadrature/substitution.hpp"

#include <algorithm>

namespace touchstone::quadrature {
namespace {

struct Piece {
    ExpressionPtr formula;
    Limit from, to;
    std::string in;
    ExpressionPtr otherwise; ///< the same function in another form, if there is one
};

/// A reason without the advice to name a pole that has been named.
std::string of_the_fold(const std::string& reason) { return reason.substr(0, reason.find(" (inside the range, --principal-value")); }

bool less(const ExactSum& a, const ExactSum& b) { return arb_lt(a.ball().get(), b.ball().get()) != 0; }

const ExactSum& exact_end(const Limit& end)
{
    if (!end.exact)
        throw DomainError("a principal value needs poles and ends that are sums of rational numbers, square roots and multiples of pi "
                          "(or infinite ends): not " +
                          end.text);
    return *end.exact;
}

/// How far the range about a pole may reach: to the ends and half way to its neighbours, at most 1 if it is free on both sides.
ExactSum reach(const std::vector<Limit>& poles, std::size_t i, const Limit& from, const Limit& to)
{
    const ExactSum half(Rational(1, 2)), &c = *poles[i].exact;
    std::optional<ExactSum> least;
    const auto consider = [&](const ExactSum& d) {
        if (!least || less(d, *least)) least = d;
    };
    if (i > 0)
        consider((c - *poles[i - 1].exact) * half);
    else if (!from.infinite)
        consider(c - exact_end(from));
    if (i + 1 < poles.size())
        consider((*poles[i + 1].exact - c) * half);
    else if (!to.infinite)
        consider(exact_end(to) - c);
    return least ? *least : ExactSum(1);
}

/// f(c + s) + f(c - s) on [0, reach]. With h(s) = s f(c + s) it is (h(s) - h(-s))/s: the form for a pole whose residue is no exact number.
Piece folded_about(const ExpressionPtr& e, const Limit& pole, const ExactSum& reach)
{
    const ExpressionPtr right = shifted(e, *pole.exact, 1), left = shifted(e, *pole.exact, -1), s = make_variable();
    const Limit to = limit_at(reach, text_of(reach));
    Piece p{make(Op::add, {right, left}), parse_limit("0"), to, ", folded about " + pole.text, nullptr};
    if (expand(*p.formula, ExactSum(0), 1)) return p;
    p.otherwise = make(Op::divide, {make(Op::odd_difference, {make(Op::multiply, {s, right})}), s});
    std::swap(p.formula, p.otherwise);
    return p;
}

std::vector<Piece> folded(const ExpressionPtr& e, const Limit& from, const Limit& to, std::vector<Limit> poles)
{
    const auto inside = [&](const ExactSum& c) {
        return (from.infinite || less(exact_end(from), c)) && (to.infinite || less(c, exact_end(to)));
    };
    for (const Limit& c : poles)
        if (c.infinite || !inside(exact_end(c)))
            throw DomainError("the pole " + c.text + " is not between " + from.text + " and " + to.text);
    std::sort(poles.begin(), poles.end(), [](const Limit& a, const Limit& b) { return less(*a.exact, *b.exact); });
    std::vector<Piece> pieces;
    Limit cursor = from;
    for (std::size_t i = 0; i < poles.size(); ++i) {
        const ExactSum &c = *poles[i].exact, r = reach(poles, i, from, to);
        if (r.is_zero()) throw DomainError("the pole " + poles[i].text + " is named twice");
        const ExactSum below = c - r, above = c + r;
        if (!cursor.exact || !(*cursor.exact == below))
            pieces.push_back({e, cursor, limit_at(below, text_of(below)), "", nullptr});
        pieces.push_back(folded_about(e, poles[i], r));
        cursor = limit_at(above, text_of(above));
    }
    if (to.infinite || !(*cursor.exact == *to.exact)) pieces.push_back({e, cursor, to, "", nullptr});
    return pieces;
}

} // namespace

Integral principal_value(const ExpressionPtr& e, const Limit& from, const Limit& to, const IntegralOptions& options, bool reversed)
{
    const std::vector<Piece> pieces = [&] {
        const WorkingPrecision precision(256);
        return folded(e, from, to, options.principal_value);
    }();
    IntegralOptions each = options;
    each.principal_value.clear();
    each.at.clear();
    each.of_absolute = !is_real(*e);
    if (each.tolerance) *each.tolerance /= static_cast<long>(pieces.size());
    const auto add = [&](long digits, Integral& out) {
        each.digits = digits;
        out = {};
        out.value = Ball(0);
        out.imaginary = Ball(0);
        for (const Piece& p : pieces) {
            Integral part = integrate(p.formula, p.from, p.to, each);
            if (!part.value.is_finite() && p.otherwise) part = integrate(p.otherwise, p.from, p.to, each);
            if (!part.value.is_finite()) {
                out.value = Ball::indeterminate();
                out.reason = p.in.empty() ? part.reason : of_the_fold(part.reason) + p.in + " (x is the distance from there)";
                out.divergent = part.divergent;
                return false;
            }
            const WorkingPrecision precision(bits_for_digits(digits) + 64);
            out.value += part.value;
            out.imaginary += part.imaginary;
            out.is_complex = out.is_complex || part.is_complex;
            for (Part& q : part.parts) {
                q.rule += p.in;
                out.parts.push_back(std::move(q));
            }
        }
        return true;
    };
    return with_enough_digits(options, add, reversed);
}

} // namespace touchstone::quadrature
