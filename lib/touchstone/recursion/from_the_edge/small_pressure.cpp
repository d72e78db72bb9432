// SPDX-License-Identifier: MIT
#include "touchstone/recursion/from_the_edge/levels.hpp"

#include "touchstone/recursion/from_the_edge/far_end.hpp"
#include "touchstone/scalar/refusal.hpp"

#include <stdexcept>

#if __has_include(<flint/acb_calc.h>)
#include <flint/acb_calc.h>
#else
#include <acb_calc.h>
#endif

namespace touchstone::transfer::from_the_edge {

namespace {

/// h and h g at delta, D = 2d - delta: q(P; x) = (e^-d/pi) e^(delta/2) h, dq/ddelta = q g; see the header.
struct SmallKernel {
    Ball edge, w4, e2d; ///< e_n, P^2, e^(-2d)
    std::pair<C, C> at(const C& delta, bool analytic) const
    {
        const slong bits = WorkingPrecision::bits();
        const auto root = [&](const C& z) {
            C r;
            acb_sqrt_analytic(r.get(), z.get(), analytic, bits);
            return r;
        };
        const C x = C(edge) * exp(-delta), one_minus = 1 - x, R = root(one_minus * one_minus + C(w4)), P = 1 + x + R, M = one_minus + R;
        const C rest = 1 - C(e2d) * exp(delta), h = root(P) / (root(M) * R * root(rest)), R_delta = one_minus * x / R;
        return {h, h * (1 / (2 * rest) - R_delta / R + ((R_delta - x) / P - (R_delta + x) / M) / 2)};
    }
};

struct SmallIntegrand {
    const Panel* panel;
    const SmallKernel* kernel;
    long k;
    slong wide;
};

int small_integrand(acb_ptr out, const acb_t at, void* param, slong order, slong)
{
    const SmallIntegrand& w = *static_cast<const SmallIntegrand*>(param);
    const WorkingPrecision scope(w.wide);
    C x;
    acb_set(x.get(), at);
    const auto [delta, E] = on_panel(*w.panel, x, w.wide);
    const C measure = w.panel->logarithmic ? delta : root_measure(x, w.k, w.wide); // ddelta = delta dy
    const C value = E * w.kernel->at(delta, order != 0).second * exp(delta / 2) * measure;
    acb_set(out, value.get());
    return 0;
}

} // namespace

bool Levels::is_small(long n, const Ball& d) const
{
    return law == Law::exceedance && n >= 2 && 2 * about(d) > cut_for_small(accuracy, n, G, load) + 1.01;
}

Levels::Value Levels::small_density(long n, const Ball& d)
{
    extend_to(n - 1);
    auto& kept = whole[n];
    const double end = std::ldexp(std::floor(std::ldexp(cut_for_small(accuracy, n, G, load), 10)), -10);
    if (!kept) kept = next(*levels[static_cast<std::size_t>(n) - 1], end);
    const Level& level = *kept;
    const WorkingPrecision scope(wide);
    SmallKernel kernel{level.edge, 4 * level.edge * exp(-2 * d), exp(-2 * d)};
    const double e = above(level.edge_bound);
    const auto most = [e](double delta) { return 1.26 * std::pow(1 - up(e * std::exp(-delta)), -1.5); }; // of h
    Ball sum(0);
    double error = 0, interpolation = 0, carried = 0;
    mag_t tolerance;
    mag_init(tolerance);
    mag_set_ui_2exp_si(tolerance, 1, -2 * precision);
    for (const auto& panel : level.panels) {
        const Ball lo = Ball::exactly(panel->a), hi = Ball::exactly(panel->b);
        const C from = C(panel->logarithmic ? log(lo) : sqrt(lo)), to = C(panel->logarithmic ? log(hi) : sqrt(hi));
        SmallIntegrand w{panel.get(), &kernel, n, wide};
        C part;
        acb_calc_integrate(part.get(), small_integrand, &w, from.get(), to.get(), precision, tolerance, nullptr, wide);
        sum -= part.real();
        const double x = e * std::exp(-panel->a), slope = 0.8 + 1.75 * x / (1 - x);
        double weight = most(panel->a) * slope * 2 * (std::exp(panel->b / 2) - std::exp(panel->a / 2));
        if (!panel->logarithmic) weight *= std::pow(panel->b, static_cast<double>(n) / 2);
        if (panel == level.panels.back()) {
            if (!panel->logarithmic) throw std::logic_error("the last panel of exceedances is one in log d: only the first is not");
            Ball whole_at_end;
            const Ball xi = (log(hi) - panel->mid) / panel->half;
            arb_poly_evaluate(whole_at_end.get(), panel->polynomial, xi.get(), wide);
            sum += whole_at_end * kernel.at(C(hi), false).first.real() * exp(hi / 2);
            weight += most(panel->b) * std::exp(panel->b / 2);
        }
        interpolation += weight * panel->interpolation * (1 + 1e-6);
        carried += weight * (2 / std::numbers::pi * std::log(static_cast<double>(panel->points)) + 1) * panel->worst * (1 + 1e-6);
    }
    mag_clear(tolerance);
    error = up_at_end(std::max(interpolation + carried, smallest_bound));
    Row r;
    r.value = sum * level.C;
    const double C_d = above(level.C);
    Ball unit;
    arb_pow_ui(unit.get(), G.get(), static_cast<ulong>(n), precision);
    const Ball beyond = load / (unit * level.edge) * exp(2 - 3 * Ball::exactly(end) / 2) * Ball::exactly(level.tail) *
                        Ball::exactly(most(end) / 1.26 * 3.5 * (n == 2 ? (end + 2.2) / 5.2 : 1) * (1 + 1e-6));
    r.interpolation = interpolation * C_d;
    r.carried = carried * C_d;
    r.rule_error = above(beyond);
    widen(r.value, up(error * C_d));
    arb_add_error(r.value.get(), beyond.get());
    return {exp(-d) / (Traits::pi() * unit) * r.value, r, level.nodes, end};
}

} // namespace touchstone::transfer::from_the_edge
