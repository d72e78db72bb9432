// SPDX-License-Identifier: MIT
#include "touchstone/recursion/from_the_edge/levels.hpp"

#include "touchstone/scalar/refusal.hpp"

namespace touchstone::transfer::from_the_edge {

void widen(Ball& b, double error)
{
    mag_t m;
    mag_init(m);
    mag_set_d(m, error);
    arb_add_error_mag(b.get(), m);
    mag_clear(m);
}

Ball half_power(const Ball& x, long twice)
{
    Ball r;
    arb_pow_ui(r.get(), x.get(), static_cast<ulong>(twice / 2), WorkingPrecision::bits());
    return twice % 2 ? r * sqrt(x) : r;
}

Levels::Value Levels::density(long n, const Ball& p, const Ball& d)
{
    if (is_small(n, d)) return small_density(n, d);
    extend_to(n);
    const Level& from = *levels[static_cast<std::size_t>(n)];
    const Ball constant = constant_after(from);
    if (law == Law::density) {
        const RowRule rule = rule_at(from, Kind::step, d, 0);
        Row r = row(from, Kind::step, d, rule);
        widen(r.value, r.error);
        // load d^((n-1)/2) e^(-3d) C v/p^2
        return {load * half_power(d, n - 1) * exp(-3 * d) * constant * r.value / (p * p), r, rule.nodes.size()};
    }
    if (2 * about(d) > delta_max) throw BeyondReach("p is too small against the highest pressure");
    const RowRule rule = rule_at(from, Kind::slope, d, 0.04);
    Row r = row(from, Kind::slope, d, rule);
    // the rule's error is analytic in d: Cauchy's bound of its derivative
    Ball v_d = r.slope;
    widen(v_d, up(rule.error / rule.around) + r.interpolation + r.carried);
    const Row plain = row(from, Kind::step, d, rule);
    Ball v = plain.value;
    widen(v, plain.error);
    return {half_power(d, n - 1) * constant * ((n + 1) * v / 2 + d * v_d) / p, r, rule.nodes.size()};
}

Levels::Value Levels::exceedance(long n, const Ball& d)
{
    extend_to(n);
    const Level& from = *levels[static_cast<std::size_t>(n)];
    if (law == Law::exceedance) {
        const RowRule rule = rule_at(from, Kind::step, d, 0);
        Row r = row(from, Kind::step, d, rule);
        widen(r.value, r.error);
        return {half_power(d, n + 1) * constant_after(from) * r.value, r, rule.nodes.size()};
    }
    // load/(G^n e_n) int delta^(n/2-1) e^(-2 delta) C_n v_n(delta) Q ddelta, Q = (2/pi) arcsin z, delta = 2 d sin^2 theta:
    // (2d)^(n/2) 2 wallis <sin^(n-1)| cos(theta) arcsin(z) e^(-delta/2) u_n>
    const RowRule rule = rule_at(from, Kind::share, d, 0);
    RowRule whole = rule;
    whole.reach = infinity;
    Row r = row(from, Kind::share, d, whole);
    widen(r.value, r.error);
    Ball unit;
    arb_pow_ui(unit.get(), G.get(), static_cast<ulong>(n), precision);
    const Ball front = load / (unit * from.edge);
    Ball value = front * half_power(2 * d, n) * 2 * wallis(power(n)) * from.C * 2 / Traits::pi() * r.value;
    if (std::isfinite(rule.reach)) widen(value, up(product_of_bounds({above(front), from.tail, std::exp(-1.5 * rule.reach) / 1.5})));
    return {value, r, rule.nodes.size()};
}

} // namespace touchstone::transfer::from_the_edge
