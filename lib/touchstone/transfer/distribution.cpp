// SPDX-License-Identifier: MIT
#include "touchstone/transfer/distribution.hpp"

#if __has_include(<flint/acb_calc.h>)
#include <flint/acb_calc.h>
#else
#include <acb_calc.h>
#endif

#include <algorithm>
#include <functional>

namespace touchstone::transfer {
namespace {

using C = ComplexBall;
using Traits = ScalarTraits<Ball>;
/// An integrand; `analytic` asks for an indeterminate result unless it is analytic on the whole ball.
using Integrand = std::function<C(const C& theta, bool analytic)>;

slong bits() { return WorkingPrecision::bits(); }

C root(const C& z, bool analytic)
{
    C r;
    acb_sqrt_analytic(r.get(), z.get(), analytic, bits());
    return r;
}

/// arcsin where |z| < 1 is proven, as far as analyticity is asked for.
C arcsine(const C& z, bool analytic)
{
    if (analytic && !certainly(less(abs(z), Ball(1)))) return C::indeterminate();
    return asin(z);
}

/// (e^z - 1)/z, also on balls that contain 0.
C exponential_quotient(const C& z)
{
    if (!certainly(less(abs(z), Traits::quotient(1, 4)))) {
        C r;
        acb_expm1(r.get(), z.get(), bits());
        return r / z;
    }
    C sum(0), term(1); // terms z^k/(k+1)!, the rest below twice the first omitted
    long k = 0;
    for (; !certainly(less(abs(term), Traits::power_of_two(-bits() - 4))); ++k) {
        sum += term;
        term = term * z / C(k + 2);
    }
    Ball rest = 2 * abs(term);
    arb_get_ubound_arf(arb_midref(rest.get()), rest.get(), 30);
    mag_zero(arb_radref(rest.get()));
    arb_add_error(acb_realref(sum.get()), rest.get());
    arb_add_error(acb_imagref(sum.get()), rest.get());
    return sum;
}

int call(acb_ptr result, const acb_t theta, void* f, slong order, slong precision)
{
    const WorkingPrecision scope(precision);
    C t;
    acb_set(t.get(), theta);
    const C r = (*static_cast<const Integrand*>(f))(t, order != 0);
    acb_set(result, r.get());
    return 0;
}

/// int_0^(pi/2) f
C quarter_turn(const Integrand& f, slong goal)
{
    C sum(0);
    acb_calc_integrate_opt_t options;
    acb_calc_integrate_opt_init(options);
    mag_t tolerance;
    mag_init(tolerance);
    mag_set_ui_2exp_si(tolerance, 1, -4 * bits());
    acb_calc_integrate(sum.get(), call, const_cast<Integrand*>(&f), C(0).get(), C(Traits::pi() / 2).get(), goal, tolerance, options, bits());
    mag_clear(tolerance);
    return sum;
}

/// R = sqrt((1-x)^2 + P^2)
C distance(const C& x, const C& P, bool analytic) { return root((1 - x) * (1 - x) + P * P, analytic); }

/// Q of (2.17) from edge = sqrt(4x - P^2): (2/pi) arcsin(edge/sqrt(2(1 + x + R)))
C share_above(const C& x, const C& P, const C& edge, bool analytic)
{
    const C R = distance(x, P, analytic);
    return 2 / C(Traits::pi()) * arcsine(edge / root(2 * (1 + x + R), analytic), analytic);
}

// ---- pressures

struct Pressures {
    C load, G, highest; ///< p_0^max
    slong goal;

    C A(const C& x, const C& P, bool analytic) const
    {
        const C R = distance(x, P, analytic);
        return P / (C(Traits::pi()) * R) * root((1 + x + R) / (1 - x + R), analytic);
    }

    C density(const C& p) const
    {
        const C P = p / G, lo = p * P / 4;
        return quarter_turn(
                   [&](const C& theta, bool analytic) {
                       const C s = sin(theta), p_0 = lo + (highest - lo) * s * s;
                       return A(p_0 / G, P, analytic) * A(load, p_0, analytic) / root(highest + p_0, analytic);
                   },
                   goal)
             / sqrt(G);
    }

    C exceedance(const C& p) const
    {
        const C P = p / G, lo = p * P / 4, width = highest - lo, edge = sqrt(4 * width / G);
        return 2 * sqrt(width)
             * quarter_turn(
                   [&](const C& theta, bool analytic) {
                       const C s = sin(theta), p_0 = lo + width * s * s;
                       return share_above(p_0 / G, P, edge * s, analytic) * A(load, p_0, analytic) * s / root(highest + p_0, analytic);
                   },
                   goal);
    }
};

// ---- force chain

struct ForceChain {
    C load, G;
    C start[3]; ///< s_0, s_1, s_2
    slong goal;

    C K(const C& D, const C& s, bool analytic) const
    {
        const C x = exp(-s);
        const C R = root((1 - x) * (1 - x) + 4 * x * exp(-D), analytic);
        return 4 / C(Traits::pi()) * root((1 + x + R) / (1 - x + R), analytic) / (R * root(exponential_quotient(-D), analytic));
    }

    C g_1(const C& d, bool analytic) const { return K(2 * d, start[0], analytic) / C(sqrt(Ball(2))); }

    C density(const C& p) const
    {
        const C d = log(G * G / p) - start[2];
        const C g_2 = 2 * quarter_turn(
                              [&](const C& theta, bool analytic) {
                                  const C s = sin(theta), c = cos(theta), from = 2 * d * s * s;
                                  return exp(-3 * d * s * s) * g_1(from, analytic) * K(2 * d * c * c, start[1] + from, analytic);
                              },
                              goal);
        return load * exp(-3 * d) * g_2 / (p * p);
    }

    C exceedance(const C& p) const
    {
        const C P = p / G, length = -2 * log(P / 2) - start[1]; // from s_1 to the edge x = P^2/4
        return load / G * 2 * sqrt(length)
             * quarter_turn(
                   [&](const C& theta, bool analytic) {
                       const C s = sin(theta), c = cos(theta), d = length * s * s, left = length * c * c;
                       const C at = start[1] + d;
                       const C edge = P * c * root(length * exponential_quotient(left), analytic); // 4x - P^2 = P^2 (e^left - 1)
                       return exp(at - 3 * d) * g_1(d, analytic) * share_above(exp(-at), P, edge, analytic) * c;
                   },
                   goal);
    }
};

template <class F>
Ball by_law(Law law, const Ball& p, const Ball& load, const Ball& G, const F& f)
{
    const slong goal = std::max(bits() - 30, slong{10});
    const WorkingPrecision guard(bits() + 40);
    const Ball highest = 2 * sqrt(load);
    const bool proven = certainly(less(Ball(2), G)) && certainly(less(Ball(0), load))
                     && (arb_is_one(load.get()) || certainly(less(load, Ball(1))))
                     && certainly(less(Ball(0), p)) && certainly(less(p, 2 * sqrt(highest * G)));
    if (!proven) return Ball::indeterminate();
    if (law == Law::pressures) return f(Pressures{load, G, highest, goal}).real();
    const Ball shift = log(G / 2), s_0 = -log(load), s_1 = shift + s_0 / 2;
    return f(ForceChain{load, G, {s_0, s_1, shift + s_1 / 2}, goal}).real();
}

} // namespace

Ball density_1(Law law, const Ball& p, const Ball& load, const Ball& G)
{
    return by_law(law, p, load, G, [&](const auto& by) { return by.density(C(p)); });
}

Ball exceedance_1(Law law, const Ball& p, const Ball& load, const Ball& G)
{
    return by_law(law, p, load, G, [&](const auto& by) { return by.exceedance(C(p)); });
}

} // namespace touchstone::transfer
