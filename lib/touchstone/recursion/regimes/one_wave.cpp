// SPDX-License-Identifier: MIT
#include "touchstone/recursion/regimes/regimes.hpp"

#include "touchstone/paper/as_printed.hpp"
#include "touchstone/paper/westergaard.hpp"
#include "touchstone/recursion/first_steps/area_by_slope.hpp"
#include "touchstone/recursion/first_steps/nested.hpp"
#include "touchstone/recursion/first_steps/scale_one.hpp"
#include "touchstone/scalar/refusal.hpp"

namespace touchstone::recursion {

using transfer::Variable;

/// f at the precision that a formula needs for this accuracy.
template <class F>
static auto with_precision(Accuracy a, F f)
{
    const WorkingPrecision precision(working_bits(a));
    return f();
}

// ---- one scale: the closed forms of section 2

const char* const n_not_0 = "n must be 0";

Method single_wave_area()
{
    return {
        .name = "arcsine",
        .asked = {Asked::area},
        .reach = "n = 0",
        .refusal = [](const Problem& p) -> std::string { return p.n == 0 ? "" : n_not_0; },
        .cost = [](const Problem&, Accuracy a) { return 1e-5 * growth(a, 1); },
        .enclose =
            [](const Problem& p, Accuracy a) {
                return with_precision(a, [&] { return p.load >= 1 ? Ball(1) : 2 * westergaard::half_width(Ball(p.load)); });
            },
        .budget = [](const Problem&, Accuracy) { return Budget{"A_0 = (2/pi) arcsin sqrt(load), (6.6), in balls"}; },
        .second = "arctangent",
        .enclose_again =
            [](const Problem& p, Accuracy a) {
                return with_precision(
                    a, [&] { return p.load >= 1 ? Ball(1) : 2 * atan2(sqrt(Ball(p.load)), sqrt(1 - Ball(p.load))) / pi<Ball>(); });
            },
        .shares = "(6.6), by another inverse function",
    };
}

Method single_wave_exceedance()
{
    return {
        .name = "cancellation-free",
        .asked = {Asked::exceedance},
        .reach = "n = 0",
        .refusal = [](const Problem& p) -> std::string { return p.n == 0 ? "" : n_not_0; },
        .cost = [](const Problem&, Accuracy a) { return 1e-5 * growth(a, 1); },
        .enclose = [](const Problem& p,
                      Accuracy a) { return with_precision(a, [&] { return westergaard::exceedance(p.p.ball(), Ball(p.load)); }); },
        .budget = [](const Problem&, Accuracy) { return Budget{"(2.14), (2.17), in balls"}; },
        .second = "as-printed",
        .enclose_again =
            [](const Problem& p, Accuracy a) {
                return with_precision(a, [&] {
                    const Ball pressure = p.p.ball(), load(p.load);
                    return p.load < 1 ? as_printed::exceedance_partial(pressure, load) : as_printed::exceedance_full(pressure, load);
                });
            },
        .shares = "(2.14), (2.17), in another algebraic form",
    };
}

/// At p_0^max, and at p_0^min > 0 and load = 1, p = 0, where (2.19) goes with p^(-1/2).
static bool infinite_first_density(const Rational& p, const Rational& load)
{
    return load < 1 ? p * p == 4 * load : p == load + 1 || p == load - 1;
}

Method single_wave_density()
{
    const auto off_support = [](const Problem& p) { return certainly(less(p.p.ball(), Ball(p.load) - 1)) || above_support(p); };
    return {
        .name = "cancellation-free",
        .asked = {Asked::density},
        .reach = "n = 0",
        .refusal = [](const Problem& p) -> std::string {
            if (p.n != 0) return n_not_0;
            return p.p.exact && p.p.exact->is_rational() && infinite_first_density(p.p.exact->rational(), p.load)
                       ? "q_0 is infinite at this pressure, an end of its support"
                       : "";
        },
        .cost = [](const Problem&, Accuracy a) { return 1e-5 * growth(a, 1); },
        .enclose =
            [off_support](const Problem& p, Accuracy a) {
                return with_precision(a, [&] { return off_support(p) ? Ball(0) : westergaard::density(p.p.ball(), Ball(p.load)); });
            },
        .budget = [](const Problem&, Accuracy) { return Budget{"(2.15), (2.19), in balls"}; },
        .second = "as-printed",
        .enclose_again =
            [off_support](const Problem& p, Accuracy a) {
                return with_precision(a, [&] {
                    const Ball pressure = p.p.ball(), load(p.load);
                    if (off_support(p)) return Ball(0);
                    return p.load < 1 ? as_printed::density_partial(pressure, load) : as_printed::density_full(pressure, load);
                });
            },
        .shares = "(2.15), (2.19), in another algebraic form",
    };
}

// ---- one integral: scale 1

static Ball scale_one(Variable v, const Problem& p, Accuracy a)
{
    return with_precision(a, [&] {
        if (p.asked == Asked::area)
            return transfer::scale_one_exceedance(v, {[] { return Ball(0); }, p.load, p.G.ball, Exact(0), p.G.exact});
        const transfer::ScaleOne q{p.p.ball, p.load, p.G.ball, p.p.exact, p.G.exact};
        if (p.asked == Asked::exceedance) return transfer::scale_one_exceedance(v, q);
        return above_support(p) ? Ball(0) : transfer::scale_one_density(v, q);
    });
}

Method one_integral()
{
    return {
        .name = "scale-one-by-ratio",
        .asked = {Asked::area, Asked::exceedance, Asked::density},
        .reach = "n = 1",
        .refusal = [](const Problem& p) -> std::string { return p.n != 1    ? "n must be 1"
                                                                : p_is_0(p) ? no_density_at_0
                                                                            : ""; },
        .cost = [](const Problem&, Accuracy a) { return 0.02 * growth(a, 2); },
        .enclose = [](const Problem& p, Accuracy a) { return scale_one(Variable::ratio, p, a); },
        .budget =
            [](const Problem&, Accuracy) {
                return Budget{
                    "n = 1: one integral by the pressure at scale 0 and by the angle of the wave of scale 1, in complex balls (recursion/first_steps/scale_one.hpp)"};
            },
        .second = "scale-one-by-angle",
        .enclose_again = [](const Problem& p, Accuracy a) { return scale_one(Variable::angle, p, a); },
        .shares =
            "the closed forms of one wave; another variable, hence another integrand and other singular points, and another rule: Gauss-Legendre on one ellipse or tanh-sinh, not acb_calc_integrate (but where singular points all but meet)",
    };
}

// ---- one integral over closed forms: the area at scale 2

/// Where the discretised operator does not serve.
static bool two_waves_serve_better(const Problem& p)
{
    return p.load > 1 || p.compare_G(Rational(2'000'001, 1'000'000)) < 0 || too_near_1(p.load);
}

static Witness nested_quadrature(const Problem& p)
{
    const auto [value, error] = transfer::nested_area(p.load.get_d(), about_G(p));
    return {Ball::exactly(value), Ball::exactly(error)};
}

Method second_area()
{
    return {
        .name = "slope-of-two-waves",
        .asked = {Asked::area},
        .reach = "n = 2, and load > 1 or G < 2.000001 or 0 < 1 - load < 1e-300",
        .refusal = [](const Problem& p) -> std::string {
            if (p.n != 2) return "n must be 2";
            return two_waves_serve_better(p) ? "" : "in partial contact there are two proofs";
        },
        .cost = [](const Problem&, Accuracy a) { return 0.5 * growth(a, 2); },
        .enclose =
            [](const Problem& p, Accuracy a) {
                constexpr slong guard = 40; // of the 48 bits beyond the digits
                return with_precision(a, [&] {
                    return transfer::area_by_slope(2, {p.load, p.G.ball, p.G.exact}, working_bits(a) - guard);
                });
            },
        .budget =
            [](const Problem&, Accuracy) {
                return Budget{
                    "n = 2: one integral of the share above each pressure at scale 0 times the slope of A_1, a complete integral of genus 1 or 2 (recursion/first_steps/area_by_slope.hpp)"};
            },
        .witness = Observer{"nested-quadrature", [](const Problem& p, Accuracy) { return nested_quadrature(p); }},
        .shares =
            "the wave (2.2), (2.4) and nothing else: quadrature within quadrature in binary64, some ten digits; its error is an estimate",
    };
}

} // namespace touchstone::recursion
