// SPDX-License-Identifier: MIT
#include "touchstone/transfer/row_budget.hpp"

namespace touchstone::transfer {

using Traits = ScalarTraits<Ball>;

Ball Resolution::coefficient_bound() const
{
    const Ball r = Ball::exactly(rho);
    return upper(2 + 4 / (r * r - 1));
}

Ball Resolution::coefficient_error() const { return upper((4 * points + 1 + scale) * unit); }

Ball Resolution::moment_error(long terms) const { return upper(terms * 4 * unit * points * points); }

Budget Resolution::budget(const RowSums& r, const Rule& rule, const Ball& x) const
{
    const WorkingPrecision coarse(64);
    const Ball sum = Ball::exactly(rho), fourth_root = sqrt(sqrt(x));
    Budget b;
    b.rule = upper(rule.discretisation * fourth_root);
    b.truncation = upper(rule.truncation * fourth_root);
    b.interpolation = upper(r.total * 4 * pow(sum, Ball(1 - points)) / (sum - 1));
    b.abscissae = upper((r.tau_error + r.total * unit) / ((sum + 1 / sum) / 2 - 1 - Traits::power_of_two(-29)));
    b.weights = upper(r.terms * (r.weight_error + unit));
    // what moments are off by meets coefficients, and what coefficients are off by meets moments: p total, and what those are off by
    const Ball moment = moment_error(r.terms);
    const Ball moments = points * r.total + static_cast<long>(nodes) * moment * pow(sum, Ball(points));
    b.entries = upper(points * moment * coefficient_bound() + moments * coefficient_error());
    return b;
}

Ball Resolution::weighting(const RowSums& r, const Ball& radius) const
{
    const WorkingPrecision coarse(64);
    const Ball moment = r.total + moment_error(r.terms) * pow(Ball::exactly(rho), Ball(points));
    const Ball off = (radius + unit) * moment + unit;
    return upper(static_cast<long>(nodes) * off * (coefficient_bound() + coefficient_error()));
}

} // namespace touchstone::transfer
