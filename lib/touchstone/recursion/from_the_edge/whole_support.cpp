// SPDX-License-Identifier: MIT
#include "touchstone/recursion/from_the_edge/levels.hpp"

#include "touchstone/scalar/refusal.hpp"

#if __has_include(<flint/acb_calc.h>)
#include <flint/acb_calc.h>
#else
#include <acb_calc.h>
#endif

namespace touchstone::transfer::from_the_edge {

std::pair<C, C> on_panel(const Panel& panel, const C& x, slong bits)
{
    C delta = panel.logarithmic ? exp(x) : x * x, value;
    const C xi = ((panel.logarithmic ? x : delta) - C(panel.mid)) / C(panel.half);
    arb_poly_evaluate_acb(value.get(), panel.polynomial, xi.get(), bits);
    return {std::move(delta), std::move(value)};
}

C root_measure(const C& t, long twice, slong bits)
{
    C power;
    acb_pow_ui(power.get(), t.get(), static_cast<ulong>(twice + 1), bits);
    return 2 * power;
}

namespace {

/// d^(twice/2) e^(-c d) u_k on one panel: with d = t^2 (or d = e^y where the panel is logarithmic) the integrand is entire.
struct Weighted {
    const Panel* panel;
    long twice;
    Ball c;
    slong wide;
};

int integrand(acb_ptr out, const acb_t at, void* param, slong, slong)
{
    const Weighted& w = *static_cast<const Weighted*>(param);
    const WorkingPrecision scope(w.wide);
    C x;
    acb_set(x.get(), at);
    const auto [d, u] = on_panel(*w.panel, x, w.wide);
    const C measure = w.panel->logarithmic ? exp(x * C(Ball(w.twice + 2) / 2)) : root_measure(x, w.twice, w.wide); // dd = d dy
    const C value = u * exp(-d * C(w.c)) * measure;
    acb_set(out, value.get());
    return 0;
}

} // namespace

std::pair<Ball, double> Levels::over_level(const Level& level, long twice, const Ball& c) const
{
    Ball sum(0);
    for (const auto& panel : level.panels) {
        const WorkingPrecision scope(wide);
        const Ball lo = Ball::exactly(panel->a), hi = Ball::exactly(panel->b);
        const C from = C(panel->logarithmic ? log(lo) : sqrt(lo)), to = C(panel->logarithmic ? log(hi) : sqrt(hi));
        Weighted w{panel.get(), twice, c, wide};
        C part;
        mag_t tolerance;
        mag_init(tolerance);
        mag_set_ui_2exp_si(tolerance, 1, -precision);
        acb_calc_integrate(part.get(), integrand, &w, from.get(), to.get(), precision, tolerance, nullptr, wide);
        mag_clear(tolerance);
        // where d^(twice/2) e^(-c d) is largest
        const double c_d = about(c), half = static_cast<double>(twice) / 2, peak = std::clamp(half / c_d, panel->a, panel->b);
        const double off =
            up_at_end(panel->interpolation + (2 / std::numbers::pi * std::log(static_cast<double>(panel->points)) + 1) * panel->worst);
        Ball real = part.real();
        widen(real, up(product_of_bounds({off, std::pow(peak, half), std::exp(-c_d * peak), panel->b - panel->a})));
        sum += real;
    }
    return {sum, level.panels.back()->b};
}

Ball Levels::highest(const Level& level) const
{
    Ball unit;
    arb_pow_ui(unit.get(), G.get(), static_cast<ulong>(level.k), precision);
    return unit * level.edge;
}

Ball Levels::force(long n)
{
    extend_to(n + 1);
    const Level& level = *levels[static_cast<std::size_t>(n) + 1];
    if (law == Law::density) { // load int f_k dd
        auto [sum, end] = over_level(level, level.k - 2, Ball(3) / 2);
        sum *= level.C;
        widen(sum, up(level.tail * std::exp(-2.5 * end) / 2.5));
        return load * sum;
    }
    auto [sum, end] = over_level(level, level.k, Ball(1) / 2); // int Q_n dp = p_max int e^-d E_k dd
    sum *= level.C;
    widen(sum, up(std::exp(-end)));
    return highest(level) * sum;
}

Ball Levels::mass(long n)
{
    if (law != Law::density) throw BeyondReach("the exceedance law has A_n as a limit, not as an integral");
    extend_to(n + 1);
    const Level& level = *levels[static_cast<std::size_t>(n) + 1];
    auto [sum, end] = over_level(level, level.k - 2, Ball(1) / 2); // load int f_k/p dd
    sum *= level.C;
    widen(sum, up(level.tail * std::exp(-1.5 * end) / 1.5));
    return load * sum / highest(level);
}

} // namespace touchstone::transfer::from_the_edge
