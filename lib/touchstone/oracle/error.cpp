// SPDX-License-Identifier: MIT
#include "touchstone/oracle/error.hpp"

#include "touchstone/rounding/decimal.hpp"
#include "touchstone/table/forced.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace touchstone::oracle {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double largest = std::numeric_limits<double>::max();

/// mpq_get_d cuts towards zero; past the largest number it is not defined.
double rounded_down(const Rational& r) { return r >= exact_rational(largest) ? largest : r.get_d(); }
double rounded_up(const Rational& r)
{
    if (r >= exact_rational(largest)) return largest;
    const double d = r.get_d();
    return exact_rational(d) < r ? std::nextafter(d, infinity) : d;
}

/// One side of the box of inputs that round to x, cut in `pieces`; the first entry is its outer end.
struct Side {
    Rational end;
    std::vector<std::pair<Rational, Rational>> pieces; // centre, half-width
};

Side side(double x, double neighbour, int pieces)
{
    Side s;
    const Rational from = exact_rational(x);
    const Rational width = (exact_rational(neighbour) - from) / 2;
    s.end = from + width;
    for (int k = 0; k < pieces; ++k)
        s.pieces.emplace_back(from + width * Rational(2 * k + 1, 2 * pieces), abs(Rational(width / (2 * pieces))));
    return s;
}

bool in_domain(const Quantity& q, const Inputs& in)
{
    try {
        q.check(in);
        return true;
    }
    catch (const DomainError&) {
        return false;
    }
}

/// What cannot be had is an indeterminate ball here: it bounds nothing, and says so.
Ball enclosure(const Quantity& q, const Inputs& in)
{
    try {
        return first_ball(q, in);
    }
    catch (const BeyondReach&) {
        return Ball::indeterminate();
    }
}

/// Calls visit(one index for each choice) for all combinations.
template <class Visit>
void combinations(const std::vector<std::size_t>& choices, Visit visit)
{
    std::vector<std::size_t> at(choices.size(), 0);
    for (bool more = true; more;) {
        visit(at);
        more = false;
        for (std::size_t i = 0; i < at.size() && !more; ++i) {
            if (++at[i] < choices[i]) more = true;
            else at[i] = 0;
        }
    }
}

} // namespace

bool is_special(double answer, const CertifiedValue& truth)
{
    return std::isnan(answer) || (std::isinf(answer) && nearest_double(truth.value) != answer);
}

Interval error_of(double answer, const CertifiedValue& truth)
{
    if (std::isinf(answer)) return nearest_double(truth.value) == answer ? Interval{0, 0} : Interval{largest, largest};
    const Rational distance = abs(Rational(exact_rational(answer) - truth.value));
    const Rational unit = truth.is_zero() ? Rational(1) : ulp_at(truth.value);
    const Rational least = distance > truth.error ? Rational((distance - truth.error) / unit) : Rational(0);
    return {rounded_down(least), rounded_up(Rational((distance + truth.error) / unit))};
}

bool of_the_recursion(const Quantity& q) { return q.costly || q.name.starts_with("contact.") || q.name == "segments.count"; }

Inputs exact_inputs(const Quantity& q, const std::vector<double>& row)
{
    std::map<std::string, Rational> values;
    for (std::size_t k = 0; k < row.size(); ++k) values[q.inputs[k]] = exact_rational(row[k]);
    return Inputs(std::move(values));
}

bool quickly_certified(const Quantity& q, const std::vector<double>& row)
{
    if (!of_the_recursion(q)) return true;
    const bool segments = q.name.starts_with("segments.");
    if (row.front() <= (segments ? 2 : 1)) return true;
    const Inputs in = exact_inputs(q, row);
    return !q.costly && in.compare_G(2) > 0 && in.real("load") <= 1;
}

Forced forced_by_inputs(const Quantity& q, const std::vector<double>& row, const CertifiedValue& truth, int pieces,
                        std::optional<double> known)
{
    if (of_the_recursion(q)) {
        const auto ulps = forced_ulps(q, row, truth.value);
        if (!ulps) return {};
        return {ulps->ulps, ulps->estimated ? std::optional(estimate_slack * ulps->ulps) : std::nullopt};
    }
    const WorkingPrecision precision(192);
    const Inputs centre = exact_inputs(q, row);
    std::vector<std::string> real; // n counts, and is never rounded
    std::vector<std::vector<Side>> sides;
    for (std::size_t k = 0; k < row.size(); ++k)
        if (q.inputs[k] != "n") real.push_back(q.inputs[k]);
    for (const auto& name : real) {
        const double x = row[static_cast<std::size_t>(std::find(q.inputs.begin(), q.inputs.end(), name) - q.inputs.begin())];
        std::vector<Side> both;
        for (const double neighbour : {std::nextafter(x, -infinity), std::nextafter(x, infinity)}) {
            auto values = centre.values();
            Side s = side(x, std::isinf(neighbour) ? x : neighbour, pieces);
            values[name] = s.end;
            if (in_domain(q, Inputs(std::move(values)))) both.push_back(std::move(s));
        }
        sides.push_back(std::move(both));
    }
    const Rational unit = truth.is_zero() ? Rational(1) : ulp_at(truth.value);
    // from where it moves is computed here and not taken from the table: a wrong entry must not excuse itself
    const Ball value = enclosure(q, centre);

    Forced forced{known.value_or(0), {}};
    if (!value.is_finite()) return forced;
    std::vector<std::size_t> corners;
    for (const auto& s : sides) corners.push_back(s.size() + 1); // the first choice is x itself
    if (!known) combinations(corners, [&](const std::vector<std::size_t>& at) {
        auto values = centre.values();
        for (std::size_t i = 0; i < at.size(); ++i)
            if (at[i] > 0) values[real[i]] = sides[i][at[i] - 1].end;
        const Inputs corner(std::move(values));
        if (!in_domain(q, corner)) return;
        const Ball there = enclosure(q, corner);
        if (!there.is_finite()) return;
        const Ball moved = abs((there - value) / Ball(unit));
        Ball low;
        arb_get_lbound_arf(arb_midref(low.get()), moved.get(), 64);
        forced.least = std::max(forced.least, arf_get_d(arb_midref(low.get()), ARF_RND_DOWN));
    });

    if (q.plan || !q.routes.front().takes_boxes) return forced;
    double most = 0;
    std::vector<std::size_t> cells;
    for (const auto& s : sides) cells.push_back(std::max<std::size_t>(1, s.size() * static_cast<std::size_t>(pieces)));
    combinations(cells, [&](const std::vector<std::size_t>& at) {
        auto values = centre.values();
        std::map<std::string, Rational> half_widths;
        for (std::size_t i = 0; i < at.size(); ++i) {
            if (sides[i].empty()) continue;
            const auto n = static_cast<std::size_t>(pieces);
            const auto& [middle, half] = sides[i][at[i] / n].pieces[at[i] % n];
            values[real[i]] = middle;
            half_widths[real[i]] = half;
        }
        const Ball moved = abs((enclosure(q, Inputs(std::move(values)).box(std::move(half_widths))) - value) / Ball(unit));
        double here = infinity;
        if (moved.is_finite()) {
            Ball high;
            arb_get_ubound_arf(arb_midref(high.get()), moved.get(), 64);
            here = arf_get_d(arb_midref(high.get()), ARF_RND_UP);
        }
        most = std::max(most, here);
    });
    forced.most = std::max(most, forced.least);
    return forced;
}

} // namespace touchstone::oracle
