// SPDX-License-Identifier: MIT
#include "touchstone/table/forced.hpp"

#include "touchstone/catalogue/evaluate.hpp"
#include "touchstone/paper/peaks.hpp"
#include "touchstone/rounding/ulp.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace touchstone {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr slong ball_bits = 192;     ///< half an ulp of an input is 2^-54 of it
constexpr long corner_digits = 24;   ///< a value correctly rounded to them gives the change by half an ulp to six digits
constexpr double negligible = 1e-6;  ///< ulps
/// Half an ulp from load 1 the areas of scale 2 and beyond, which have a slope there, are dear; this far below they are not.
constexpr int wide = 20;             ///< a step of 2^-20, whose change is divided by 2^33 to be that of half an ulp

bool of_the_recursion(const Quantity& q)
{
    return q.plan && (q.name.starts_with("contact.") || q.name == "segments.count" || q.name == "segments.density");
}

/// Half-way from x to its neighbour in that direction: the farthest number that still rounds to x.
Rational end_towards(double x, double direction)
{
    const double neighbour = std::nextafter(x, direction);
    return std::isinf(neighbour) ? exact_rational(x) : Rational((exact_rational(x) + exact_rational(neighbour)) / 2);
}

double midpoint(const Ball& b) { return arf_get_d(arb_midref(b.get()), ARF_RND_NEAR); }

/// The value at some inputs, in units of `unit`; nothing if they are out of domain or it is not known well enough.
class Values {
public:
    Values(const Quantity& q, bool rounded) : q_(q), rounded_(rounded) {}

    std::optional<Ball> at(const std::map<std::string, Rational>& values) const
    {
        const Inputs in(values);
        try {
            q_.check(in);
            if (!rounded_) {
                Ball b = first_ball(q_, in);
                return b.is_finite() ? std::optional(std::move(b)) : std::nullopt;
            }
            const Evaluation e = evaluate(q_, in, {.digits = corner_digits});
            if (e.status != Status::exact && e.status != Status::certified) return std::nullopt;
            return Ball(*parse_rational(e.value));
        }
        catch (const DomainError&) {
            return std::nullopt;
        }
        catch (const BeyondReach&) {
            return std::nullopt;
        }
    }

private:
    const Quantity& q_;
    bool rounded_;
};

/// The larger change within half an ulp of each input, summed. Another load or G is a solution of its own: one end is enough there.
std::optional<double> by_ends(const Quantity& q, const std::vector<double>& inputs, const Rational& unit, bool rounded)
{
    std::map<std::string, Rational> centre;
    for (std::size_t k = 0; k < inputs.size(); ++k) centre[q.inputs[k]] = exact_rational(inputs[k]);
    const Values value(q, rounded);
    const auto here = value.at(centre);
    if (!here) return std::nullopt;
    double sum = 0;
    for (std::size_t k = 0; k < inputs.size(); ++k) {
        if (q.inputs[k] == "n") continue;
        const bool one_end = rounded && inputs.front() > 0;
        if (one_end && inputs.front() >= 2 && q.inputs[k] == "load" && inputs[k] == 1) {
            auto below = centre;
            below["load"] -= power(Rational(2), -wide);
            const auto there = value.at(below);
            if (!there) return std::nullopt;
            sum += std::ldexp(midpoint(abs((*here - *there) / Ball(unit))), wide - 53);
            continue;
        }
        std::optional<double> larger;
        for (const double direction : {infinity, -infinity}) {
            if (one_end && larger) break;
            auto moved = centre;
            moved[q.inputs[k]] = end_towards(inputs[k], direction);
            if (const auto there = value.at(moved)) larger = std::max(larger.value_or(0), midpoint(abs((*there - *here) / Ball(unit))));
        }
        if (!larger) return std::nullopt;
        sum += *larger;
    }
    return sum;
}

/// The largest change at the corners of the box of half ulps: just outside a contact only both inputs together reach it.
double at_the_corners(const Quantity& q, const std::vector<double>& inputs, const Rational& unit)
{
    std::map<std::string, Rational> centre;
    std::vector<std::size_t> real; // an integer (n) is not rounded
    for (std::size_t k = 0; k < inputs.size(); ++k) {
        centre[q.inputs[k]] = exact_rational(inputs[k]);
        if (q.inputs[k] != "n") real.push_back(k);
    }
    const Values value(q, false);
    const auto here = value.at(centre);
    if (!here || real.size() < 2) return 0;
    double largest = 0;
    for (unsigned corner = 0; corner < 1U << real.size(); ++corner) {
        auto moved = centre;
        for (std::size_t i = 0; i < real.size(); ++i)
            moved[q.inputs[real[i]]] = end_towards(inputs[real[i]], (corner >> i & 1U) != 0 ? infinity : -infinity);
        if (const auto there = value.at(moved)) largest = std::max(largest, midpoint(abs((*there - *here) / Ball(unit))));
    }
    return largest;
}

/// Half an ulp of x over x.
double half_ulp(double x) { return x == 0 ? 0 : midpoint(abs(Ball(end_towards(x, infinity)) / Ball(exact_rational(x)) - Ball(1))); }

/// How much faster than its arguments a distribution changes beside its upper edge, and how fast the edge itself moves.
double at_the_upper_edge(const Quantity& q, double n, Ball p, const Ball& load, const Ball& G, double from_p, double from_load,
                         double from_G)
{
    long scale = std::lround(n);
    double power = q.name == "contact.exceedance" ? (n + 1) / 2 : std::fabs(n - 1) / 2;
    if (q.name == "segments.density") { // of the half-width: p = G^n sin^2(pi a) at the scale before
        --scale;
        power = std::fabs(n - 2) / 2;
        const Ball root = ScalarTraits<Ball>::sin_pi(p);
        p = pow(G, Ball(std::lround(n))) * root * root;
        from_p *= 2;
    }
    const Ball edge = pow(G, Ball(scale + 1)) * peaks::iterate(scale, load, G);
    const double y = midpoint(p / edge), short_of = midpoint(abs(Ball(1) - p / edge));
    if (!(y > 0) || short_of == 0) return 0;
    const double share = std::ldexp(1.0, -static_cast<int>(std::min(scale, 1000L)) - 1);
    return power * y / short_of * (from_p + share * from_load + (static_cast<double>(scale) - 1 + 2 * share) * from_G);
}

double by_condition_number(const Quantity& q, const std::vector<double>& inputs, const Rational& value, const Rational& unit)
{
    if (value == 0) return 0;
    const auto input = [&](std::string_view name) -> std::optional<double> {
        const auto it = std::find(q.inputs.begin(), q.inputs.end(), name);
        return it == q.inputs.end() ? std::nullopt : std::optional(inputs[static_cast<std::size_t>(it - q.inputs.begin())]);
    };
    const double n = inputs.front(), from_load = half_ulp(*input("load"));
    double relative = from_load;
    if (const auto gamma = input("gamma")) { // of a count: gamma^n times an area that goes as G^-n, G = gamma^(D-1)
        const double D = *input("D");
        relative += n * ((2 - D) * half_ulp(*gamma) + D * half_ulp(D) * std::log(*gamma));
    }
    else {
        const double G = *input("G"), from_G = half_ulp(G);
        relative += n * from_G;
        const auto p = input("p"), a = input("a");
        if (p || a) {
            const double argument = p ? *p : *a, from_p = half_ulp(argument);
            relative += from_p + at_the_upper_edge(q, n, Ball(exact_rational(argument)), Ball(exact_rational(*input("load"))),
                                                   Ball(exact_rational(G)), from_p, from_load, from_G);
        }
    }
    return relative * midpoint(abs(Ball(value) / Ball(unit)));
}

} // namespace

std::optional<ForcedUlps> forced_ulps(const Quantity& q, const std::vector<double>& inputs, const Rational& value)
{
    const WorkingPrecision precision(ball_bits);
    const Rational unit = value == 0 ? Rational(1) : ulp_at(value);
    if (q.name.starts_with("limit.")) { // another G is another solution: C(G) goes with about G (docs/limit.md), the ratio changes less
        if (!q.name.starts_with("limit.area_")) return std::nullopt;
        return ForcedUlps{half_ulp(inputs.front()) * midpoint(abs(Ball(value) / Ball(unit))), true};
    }
    if (!of_the_recursion(q)) {
        const auto ulps = by_ends(q, inputs, unit, false);
        return ulps ? std::optional(ForcedUlps{std::max(*ulps, at_the_corners(q, inputs, unit)), false}) : std::nullopt;
    }
    const auto load = inputs[static_cast<std::size_t>(std::find(q.inputs.begin(), q.inputs.end(), "load") - q.inputs.begin())];
    const bool partial = q.name == "contact.area" && load <= 1 && inputs.back() > 2;
    if (partial || inputs.front() == 0)
        if (const auto ulps = by_ends(q, inputs, unit, true)) return ForcedUlps{*ulps, false};
    return ForcedUlps{by_condition_number(q, inputs, value, unit), true};
}

std::string forced_text(double ulps)
{
    if (ulps < negligible) return "0";
    // first to twelve digits: a last bit must not decide a tie of the third
    return fmt::format("{:.3g}", std::strtod(fmt::format("{:.11e}", ulps).c_str(), nullptr));
}

} // namespace touchstone
