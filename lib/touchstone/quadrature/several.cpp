// SPDX-License-Identifier: MIT
// Several formulas over one range. Where tanh-sinh is the rule, one proof of the strip and the same nodes serve them all.
#include "touchstone/quadrature/integrate.hpp"
#include "touchstone/quadrature/rules.hpp"

#include <algorithm>

namespace touchstone::quadrature {
namespace {

using Formulas = std::vector<ExpressionPtr>;

/// The points where the range is cut for any of the formulas.
std::vector<Limit> cuts_for(const Formulas& all, const Limit& from, const Limit& to, const std::vector<Limit>& at)
{
    const WorkingPrecision precision(256);
    const auto less = [](const Limit& a, const Limit& b) { return arb_lt(a.ball().get(), b.ball().get()) != 0; };
    std::vector<Limit> cuts = at;
    for (const ExpressionPtr& e : all)
        for (const ExactSum& x : branch_points(*e, from, to)) cuts.push_back(limit_at(x, x.ball().to_string(10)));
    std::sort(cuts.begin(), cuts.end(), less);
    cuts.erase(std::unique(cuts.begin(), cuts.end(), [&](const Limit& a, const Limit& b) { return !less(a, b); }), cuts.end());
    cuts.insert(cuts.begin(), from);
    cuts.push_back(to);
    return cuts;
}

/// By one proof, if tanh-sinh takes them all: nothing else.
std::vector<Attempt> together(const Formulas& all, const Limit& from, const Limit& to, long digits)
{
    const bool exponential = std::any_of(all.begin(), all.end(), [](const ExpressionPtr& e) { return names_exponential(*e); });
    for (const Map map : maps_for(from, to, exponential)) {
        std::vector<std::shared_ptr<const Integrand>> integrands;
        for (const ExpressionPtr& e : all) integrands.push_back(std::make_shared<const Integrand>(e, Range{from, to, map}));
        const auto regular = [](const auto& f) { return f->is_regular_at_ends(); };
        if (std::all_of(integrands.begin(), integrands.end(), regular)) return {}; // each by Gauss-Legendre
        std::vector<Attempt> attempts = by_one_tanh_sinh(integrands, digits);
        if (attempts.front().value.is_finite()) return attempts;
    }
    return {};
}

bool can_be_together(const Formulas& all)
{
    const auto plain = [](const ExpressionPtr& e) {
        return is_real(*e) && !has_complex_point(*e) && !any_node(*e, [](const Expression& n) { return n.op == Op::integral; });
    };
    return all.size() > 1 && std::all_of(all.begin(), all.end(), plain);
}

/// Over one stretch, added to each result; false in `done` for those that failed.
void add_stretch(const Formulas& all, const Limit& from, const Limit& to, long digits, const IntegralOptions& options,
                 std::vector<Integral>& out)
{
    std::vector<Attempt> shared = can_be_together(all) ? together(all, from, to, digits) : std::vector<Attempt>{};
    IntegralOptions each = options;
    each.at.clear();
    each.tolerance.reset();
    each.digits = digits;
    each.of_absolute = true;
    const WorkingPrecision precision(bits_for_digits(digits) + 64);
    for (std::size_t k = 0; k < all.size(); ++k) {
        if (!out[k].value.is_finite()) continue;
        if (!shared.empty() && shared[k].value.is_finite()) {
            Part p = std::move(shared[k].part);
            p.from = from.text;
            p.to = to.text;
            p.value = shared[k].value;
            p.rule += ", the strip proved for all formulas";
            out[k].value += p.value;
            out[k].parts.push_back(std::move(p));
            continue;
        }
        Integral one = integrate(all[k], from, to, each);
        out[k].value += one.value;
        out[k].imaginary += one.imaginary;
        out[k].is_complex = out[k].is_complex || one.is_complex;
        out[k].divergent = one.divergent;
        out[k].reason = one.value.is_finite() ? "" : one.reason;
        for (Part& p : one.parts) out[k].parts.push_back(std::move(p));
    }
}

} // namespace

std::vector<Integral> integrate_several(const Formulas& all, const Limit& from, const Limit& to, const IntegralOptions& options)
{
    const WorkingPrecision precision(256);
    const bool ascending =
        from.infinite < 0 || to.infinite > 0 || (!from.infinite && !to.infinite && arb_lt(from.ball().get(), to.ball().get()));
    std::vector<Integral> results;
    if (!ascending || from.infinite > 0 || to.infinite < 0 || !options.principal_value.empty()) {
        for (const ExpressionPtr& e : all) results.push_back(integrate(e, from, to, options));
        return results;
    }
    for (const Limit& c : options.at)
        if (c.infinite || !(from.infinite || arb_lt(from.ball().get(), c.ball().get())) ||
            !(to.infinite || arb_lt(c.ball().get(), to.ball().get())))
            throw DomainError("the break point " + c.text + " is not between " + from.text + " and " + to.text);
    const std::vector<Limit> cuts = cuts_for(all, from, to, options.at);
    // all are repeated together while one lacks digits: each keeps the digits it was certified with
    std::vector<Integral> latest;
    long computed = 0;
    for (std::size_t k = 0; k < all.size(); ++k)
        results.push_back(with_enough_digits(options, [&](long digits, Integral& out) {
            if (digits > computed) {
                latest.assign(all.size(), Integral{});
                for (std::size_t i = 0; i + 1 < cuts.size(); ++i) add_stretch(all, cuts[i], cuts[i + 1], digits, options, latest);
                computed = digits;
            }
            out = latest[k];
            return out.value.is_finite();
        }));
    return results;
}

} // namespace touchstone::quadrature
