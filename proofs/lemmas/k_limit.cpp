// SPDX-License-Identifier: GPL-3.0-or-later
#include "proofs/lemmas/k_limit.hpp"

#include "proofs/enclosure/enclosure.hpp"
#include "proofs/symbolic/symbolic.hpp"

#include "touchstone/paper/archard.hpp"
#include "touchstone/scalar/symbol.hpp"

#include <acb_calc.h>

namespace touchstone::proofs {

namespace {

Ball digamma(const Ball& x)
{
    Ball r;
    arb_digamma(r.get(), x.get(), WorkingPrecision::bits());
    return r;
}

} // namespace

Ball log_step_slope(const Ball& delta)
{
    return log(Ball(2)) + (digamma(1 + delta / 2) - digamma(Ball(Rational(3, 2)) + delta / 2)) / 2;
}

namespace {

/// The slope of log step on [1/2, 1], enclosed piece by piece.
Ball log_step_slopes(long pieces)
{
    Rational low(1, 2);
    const Rational piece = (1 - low) / pieces;
    Ball slopes = log_step_slope(Ball(low));
    while (low < 1) {
        const Rational high = low + piece;
        slopes = hull(slopes, log_step_slope(hull(Ball(low), Ball(high))));
        low = high;
    }
    return slopes;
}

/// "0.34 to 0.63": both ends, to two digits.
std::string ends(const Ball& hull)
{
    Ball low, high;
    arb_get_lbound_arf(arb_midref(low.get()), hull.get(), 30);
    arb_get_ubound_arf(arb_midref(high.get()), hull.get(), 30);
    return low.to_string(2) + " to " + high.to_string(2);
}

} // namespace

Check K_converges()
{
    const Check one = identity(archard::step<GiNaC::ex>(GiNaC::ex(1)), 1, Points{"n=1"});
    if (one.verdict != Verdict::proved) return one;
    const Ball slopes = log_step_slopes(16);
    if (!certainly(less(Ball(0), slopes)) || !slopes.is_finite())
        return {Verdict::undecided, "the slope of log step is not enclosed in positive numbers"};
    return as_lemma({Verdict::proved, "log step(1) = 0 and its slope on [1/2, 1] is enclosed in positive numbers, none above a bound (" +
                                          ends(slopes) + "): each step below 1, the logarithms summable"});
}

Check least_step_slope_exceeds(const Ball& number)
{
    return less_than(number, log_step_slopes(128), "the number and the slope of log step");
}

Ball K_infinity()
{
    const long N = 64;
    const Ball h = ScalarTraits<Ball>::power_of_two(-(N + 1)); // the steps left out have delta >= 1 - h
    const Ball slope = log_step_slope(hull(archard::delta<Ball>(N), Ball(1)));
    return archard::K_by_recursion<Ball>(N) * exp(-(slope * (2 * h)));
}

namespace {


/// The integrand at xi = sin(theta), times cos(theta), on complex balls: (1 - xi^2)^m is written
/// cos(theta)^(2m), entire where cos(theta) stays in the right half plane.
int power_of_cosine(acb_ptr out, const acb_t theta, void* parameter, slong order, slong bits)
{
    const auto* m = static_cast<const Ball*>(parameter);
    acb_t c, e;
    acb_init(c);
    acb_init(e);
    acb_cos(c, theta, bits);
    acb_set_arb(e, m->get());
    // with order != 0 the function must be analytic on the ball: the power is, off the negative axis
    if (order != 0 && !arb_is_positive(acb_realref(c))) acb_indeterminate(out);
    else acb_pow(out, c, e, bits);
    acb_clear(c);
    acb_clear(e);
    return 0;
}

} // namespace

Check beta_integral(const ex& integrand, const ex& from, const ex& to, const ex& closed)
{
    // the integrand must be (1 - xi^2)^m: m is read off its logarithm at one point, then checked
    const ex xi = sym("xi"), base = 1 - pow(xi, 2);
    if (!GiNaC::is_a<GiNaC::power>(integrand) || !GiNaC::normal(integrand.op(0) - base).is_zero() || !from.is_equal(-1) || !to.is_equal(1))
        return {Verdict::undecided, "not an integral of a power of 1 - xi^2 over (-1, 1)"};
    for (const Rational& delta : {Rational(1, 2), Rational(3, 4), Rational(7, 8), Rational(1)}) {
        const Ball m = evaluate(integrand.op(1), Point{{"delta_n", delta}});
        Ball power = 2 * m + 1; // cos^(2m) from the integrand, one from d xi
        // Up to theta_0 by quadrature; beyond, 0 <= cos^power <= (pi/2 - theta)^power.
        const WorkingPrecision precision(128);
        const Ball gap = ScalarTraits<Ball>::power_of_two(-20);
        const Ball end = ScalarTraits<Ball>::pi() / 2 - gap;
        acb_t result, a, b;
        acb_init(result);
        acb_init(a);
        acb_init(b);
        acb_set_arb(b, end.get());
        mag_t tolerance;
        mag_init(tolerance);
        mag_set_ui_2exp_si(tolerance, 1, -60);
        acb_calc_integrate(result, power_of_cosine, &power, a, b, 60, tolerance, nullptr, 128);
        Ball half;
        arb_set(half.get(), acb_realref(result));
        acb_clear(result);
        acb_clear(a);
        acb_clear(b);
        mag_clear(tolerance);
        const Ball value = 2 * (half + hull(Ball(0), pow(gap, power) * gap));
        const Ball wanted = evaluate(closed, Point{{"delta_n", delta}});
        if (!value.overlaps(wanted))
            return {Verdict::refuted,
                    "at delta = " + delta.get_str() + " the integral is " + value.to_string(8) + ", not " + wanted.to_string(8)};
        if (value.relative_bits() < 20) return {Verdict::undecided, "the quadrature is too wide: " + value.to_string(8)};
    }
    return as_lemma({Verdict::proved, "a theorem of Euler; checked by certified quadrature at four delta to 20 bits and more"});
}

} // namespace touchstone::proofs
