// SPDX-License-Identifier: MIT
/// \file
/// What surrounds the contact of section 2: the gap, its mean, and the elastic energy. Not in the paper;
/// contact codes test against them, so here is the derivation (its steps checked in proofs/beyond.cpp).
///
/// Units: lengths along the surface in lambda, gap in g (the amplitude in (2.1)), pressure in p* of
/// (2.3), energy per unit nominal area in g p*. S = load = pbar/p*; k = 2 pi.
///
/// 1. Displacement. A pressure cos(j k x) on the half-plane moves its surface by cos(j k x)/j: that is (2.2)
///    read backwards, as in full contact p* cos(kx) must produce g cos(kx). So for
///    p = S + sum_j p_j cos(j k x) the surface moves by u = sum_j (p_j/j) cos(j k x) (mean taken out),
///    and the gap is h = u - cos(kx) + C. Hence h' = -2 pi Im F + 2 pi sin(kx), where
///    F(z) = S + sum_j p_j exp(i j k z) is analytic in the upper half-plane, Re F = p on the real line.
/// 2. Slope. F(z) = 2 cos(pi z) sqrt(S - sin^2 pi z) + i sin(2 pi z) has these properties: its real
///    part is (2.4) in contact and 0 outside, its imaginary part is sin(kx) in contact (so h' = 0), and at
///    z -> i infinity the two terms' exponentials cancel and leave S. Outside the contact therefore
///        h'(x) = 4 pi cos(pi x) sqrt(sin^2 pi x - S),    a < x <= 1/2.                        (slope)
/// 3. Gap. With v = sin(pi x), dv = pi cos(pi x) dx and w = sqrt(v^2 - S):
///        h(x) = 4 int_{sqrt S}^v sqrt(t^2 - S) dt = 2 (v w - S arcosh(v/sqrt S)).            (closed form)
///    The difference cancels at the edge, like w^3. With arcosh(v/sqrt S) = artanh(w/v), S = v^2 (1 - m), m = w^2/v^2
///    and the series of artanh this is a sum of positive terms,
///        h(x) = 4 (w^3/v) sum_{j>=0} m^j/((2j+1)(2j+3)),    0 <= m < 1.                       (series)
/// 4. Mean gap. dh/dS at fixed x is the mean gap's rate of change plus what a flat punch moves; at the
///    peak, x = 0, the gap stays 0, so dC/dS = -sum_j (dp_j/dS)/j. With sum_j cos(jt)/j = -log|2 sin(t/2)|,
///    dp/dS = cos(pi x)/sqrt(S - sin^2 pi x) and sin(pi x) = sqrt(S) sin(phi) that is
///    (2/pi) int_{-pi/2}^{pi/2} log(2 sqrt S |sin phi|) dphi = log S. As C = 0 in full contact,
///        C(S) = 1 - S + S log S = sum_{j>=2} (1 - S)^j/(j (j - 1)).                          (mean gap)
/// 5. Energy. The load's work is all there is: dU = -S dC, so
///        U(S) = -int_0^S s log s ds = S^2 (1 - 2 log S)/4,   1/4 from full contact on.        (energy)
///    Independently U = 1/2 <p u> with u = cos(kx) - C on the contact.
/// Energy counts from the uniformly loaded half-plane, whose own compression is not bounded.
///
/// Hertzian limit: sin(pi x) becomes pi x in (slope), and nothing else changes in (closed form) and
/// (series). A single parabola has no mean gap, and its energy grows without bound with the distance at which
/// displacements are counted from, as in all plane contact: those two have no Hertzian counterpart.
#pragma once

#include "touchstone/scalar/ball.hpp"
#include "touchstone/scalar/scalar.hpp"

#include <array>
#include <cmath>
#include <vector>

namespace touchstone::detail {

/// Whether terms of at most 4 `power` in all, beside a sum of at least 1/3, are below what the arithmetic holds.
template <class T>
bool negligible(const T& power, long) { return T(1 + power) == 1; }
/// Powers of a ball that is too wide never fall below: after three times the terms that a point needs they end
/// the series too, and the tail is as wide as they are.
inline bool negligible(const Ball& power, long terms)
{
    return !power.is_finite() || terms > 7 * (WorkingPrecision::bits() + 8) ||
           certainly(less(power, power_of_two<Ball>(-WorkingPrecision::bits() - 8)));
}
/// What is left out becomes part of a ball's radius.
template <class T>
void add_tail(T&, const T&) {}
inline void add_tail(Ball& sum, const Ball& tail) { arb_add_error(sum.get(), tail.get()); } ///< tail >= 0: the radius grows by it

/// sum_{j>=0} x^j/coefficient(j) for 0 <= x <= 3/4 and integer coefficients, 1 <= coefficient(0) <= 3, rising: the tail
/// from x^n on is at most x^n/(1 - x) <= 4 x^n. Small terms are added first. (Not for `Exact`: there is no end to it.)
template <OrderedScalar T, class Coefficient>
T series(const T& x, Coefficient coefficient)
{
    if constexpr (requires { ScalarTraits<T>::series(x, coefficient); })
        return ScalarTraits<T>::series(x, coefficient); // written down, not summed
    else {
        std::vector<T> terms;
        T power = integer<T>(1);
        for (long j = 0; !negligible(power, j); ++j) {
            terms.push_back(power / integer<T>(coefficient(j)));
            power = power * x;
        }
        T sum = integer<T>(0);
        for (auto term = terms.rbegin(); term != terms.rend(); ++term) sum = sum + *term;
        add_tail(sum, T(4 * power));
        return sum;
    }
}

/// The first terms' coefficients of sum_j m^j/((2j+1)(2j+3)); up to m = 1/8 what they leave out is below 2^-57 of it.
inline constexpr std::array<double, 16> gap_terms = [] {
    std::array<double, 16> terms{};
    for (int j = 0; j < 16; ++j) terms[static_cast<std::size_t>(j)] = 1.0 / ((2 * j + 1) * (2 * j + 3));
    return terms;
}();

/// sum_j m^j/((2j+1)(2j+3)), the series of the gap.
template <OrderedScalar T>
T gap_series(const T& m) { return series(m, [](long j) { return (2 * j + 1) * (2 * j + 3); }); }
/// The same for 0 <= m <= 3/4 by two half angles, which leave at most 0.11: with m' = m/(1 + sqrt(1 - m))^2 artanh sqrt(m) = 2 artanh
/// sqrt(m') makes the sum (1 + m')(1 + (1 - m') sum')/4, where every term is positive.
inline double gap_series(double m)
{
    const auto half_angle = [](double of) { const double root = 1 + std::sqrt(1 - of); return of / (root * root); };
    const auto doubled = [](double half, double sum) { return (1 + half) * (1 + (1 - half) * sum) / 4; };
    const double half = half_angle(m), quarter = half_angle(half);
    return doubled(half, doubled(quarter, sum_of_powers(gap_terms, quarter)));
}

/// sum_j e^j/((j+1)(j+2)), the series of the mean gap.
template <OrderedScalar T>
T mean_gap_series(const T& e) { return series(e, [](long j) { return (j + 1) * (j + 2); }); }
/// The same for 0 <= e <= 3/4: e^2 times it is e + s log s, s = 1 - e, and log s = -4 artanh t with t = (1 - sqrt s)/(1 + sqrt s) <= 1/3.
/// As (1 - t^2) artanh t = t - 2 t^3 sum, sum = gap_series(t^2), that leaves positive terms.
inline double mean_gap_series(double e)
{
    const double root = 1 + std::sqrt(1 - e), t = e / (root * root), m = t * t;
    return (1 + t * (1 + (1 - m) * sum_of_powers(gap_terms, m))) / 2;
}

/// (closed form) and (series) of the gap for v >= w = sqrt(v^2 - S), v > 0; 0 for w = 0.
template <OrderedScalar T>
T gap_of(const T& v, const T& w, const T& load)
{
    const T slope = w / v;
    return across_seam(
        T(slope * slope), ratio<3, 4, T>(),
        [&](const T& m) -> T { return 4 * (w * w * slope) * gap_series(m); },
        [&](const T&) -> T { return 2 * (v * w - load * log((v + w) / sqrt(load))); });
}

} // namespace touchstone::detail

namespace touchstone::westergaard {

/// The slope h'(x) of the gap, in g/lambda, for a <= x <= 1/2, 0 < load <= 1: (slope) above.
template <Scalar T>
T gap_slope(const T& x, const T& load)
{
    return 4 * (pi<T>() * cos_pi(x) * sqrt_sin_pi_square_minus(x, load));
}

/// The gap h/g for a <= x <= 1/2, 0 < load <= 1, as (closed form) above has it: for symbols, and as a second opinion; it cancels at the
/// edge.
template <Scalar T>
T gap_closed_form(const T& x, const T& load)
{
    const T v = sin_pi(x);
    const T w = sqrt_sin_pi_square_minus(x, load);
    return 2 * (v * w - load * log((v + w) / sqrt(load)));
}

/// The gap h/g at distance x (in lambda) from the peak, |x| <= 1/2, load > 0, by (series) above; 0 in the contact. `double`: within 4 ulp.
template <OrderedScalar T>
T gap(const T& x, const T& load)
{
    const T v = hypot_of(sin_pi(x), integer<T>(0)); // |sin|
    return across_seam(
        load, integer<T>(1),
        [&](const T& s) { return detail::gap_of(T(at_least(v, sqrt(s))), sqrt_sin_pi_square_minus(x, s), s); },
        [](const T&) { return integer<T>(0); });
}

/// The mean gap C/g over a wavelength, load > 0: (mean gap) above, by its series from load 1/4 on; 0 from full contact on. `double`: within
/// 4 ulp.
template <OrderedScalar T>
T mean_gap(const T& load)
{
    return across_seam(
        load, ratio<1, 4, T>(),
        [](const T& s) -> T { return 1 + s * (log(s) - 1); },
        [](const T& s) {
            return across_seam(
                s, integer<T>(1),
                [](const T& t) -> T {
                    const T e = 1 - t;
                    return e * e * detail::mean_gap_series(e);
                },
                [](const T&) { return integer<T>(0); });
        });
}

/// The elastic energy U/(g p*) per unit nominal area, load > 0: (energy) above; 1/4 from full contact on. `double`: within 4 ulp.
template <OrderedScalar T>
T energy(const T& load)
{
    const T s = at_most(load, integer<T>(1));
    return s * (s * (1 - 2 * log(s))) / 4; // in this order: s * s alone may underflow
}

} // namespace touchstone::westergaard

namespace touchstone::hertz {

/// The gap h(x)/g beside the contact of the parabola 2 pi^2 x^2 that the peak of (2.1) is, load > 0; 0 in the contact.
template <OrderedScalar T>
T gap(const T& x, const T& load)
{
    const T v = hypot_of(T(pi<T>() * x), integer<T>(0)); // |pi x|
    return detail::gap_of(T(at_least(v, sqrt(load))), sqrt_pi_square_minus(x, load), load);
}

} // namespace touchstone::hertz
