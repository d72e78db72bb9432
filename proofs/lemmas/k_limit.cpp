// SPDX-License-Identifier: GPL-3.0-or-later
#include "proofs/lemmas/k_limit.hpp"

#include "proofs/enclosure/enclosure.hpp"
#include "proofs/enclosure/quadrature.hpp"
#include "proofs/symbolic/symbolic.hpp"

#include "touchstone/paper/archard.hpp"
#include "touchstone/scalar/symbol.hpp"

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

Check beta_integral(const ex& integrand, const ex& from, const ex& to, const ex& closed)
{
    constexpr slong least_bits = 30;
    for (const Rational& delta : {Rational(1, 2), Rational(3, 4), Rational(7, 8), Rational(1)}) {
        const Point at{{"delta_n", delta}};
        const Ball value = integral(integrand, sym("xi"), from, to, at), wanted = evaluate(closed, at);
        if (value.relative_bits() < least_bits) return {Verdict::undecided, "the integral is not proved at delta = " + delta.get_str()};
        if (!value.overlaps(wanted))
            return {Verdict::refuted,
                    "at delta = " + delta.get_str() + " the integral is " + value.to_string(8) + ", not " + wanted.to_string(8)};
    }
    return as_lemma(
        {Verdict::proved, "a theorem of Euler; the printed integral by certified quadrature at four delta, to 30 bits and more"});
}

} // namespace touchstone::proofs
