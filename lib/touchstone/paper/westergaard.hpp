// SPDX-License-Identifier: MIT
/// \file
/// Section 2: one sine wave pressed against an elastic half-plane.
///
/// Units: lengths in wavelengths lambda, pressures in p* of (2.3). `load` is pbar/p*.
/// load < 1: partial contact, |x| < a. load >= 1: full contact. Everything here is
/// continuous across load = 1 except the density at zero pressure.
///
/// The forms are free of cancellation: each difference that vanishes at an edge
/// is formed once, from exact inputs, and everything else is a sum of positive terms.
/// For `double` this keeps every value within 4 ulp except where the rounding of the inputs
/// alone moves the true value further (tests/paper/double_accuracy.cpp measures it; proofs/coq/README.md has the bounds that are proved).
/// The forms as printed are in as_printed.hpp; proofs/ shows them equal to these.
///
/// Source: Westergaard (1939); Johnson, Contact Mechanics (1985), section 13.2.
#pragma once

#include "touchstone/scalar/scalar.hpp"

namespace touchstone::westergaard {

/// (2.5)  a/lambda = (1/pi) arcsin sqrt(load),  0 < load <= 1; in (0, 1/2].
/// As an angle with tangent sqrt(load / (1 - load)), so that load -> 1 loses nothing.
template <Scalar T>
T half_width(const T& load)
{
    return asin_sqrt_over_pi(load);
}

/// (2.2)  p/p* = load + cos(2 pi x) = (load - 1) + 2 cos^2(pi x),  load >= 1.
template <Scalar T>
T pressure_full(const T& x, const T& load)
{
    const T c = cos_pi(x);
    return (load - 1) + 2 * (c * c);
}

/// (2.4) with (2.5) in it: p/p* = 2 cos(pi x) sqrt(load - sin^2(pi x)),  load <= 1, |x| <= 1/2; 0 for |x| >= a.
template <Scalar T>
T pressure_partial(const T& x, const T& load)
{
    return 2 * (cos_pi(x) * sqrt_minus_sin_pi_square(load, x));
}

/// (2.4) at the distance d = a - x inside the contact edge, 0 <= d <= a: accurate however small d is.
/// load - sin^2(pi x) = sin(pi d) sin(pi (2a - d)).
template <Scalar T>
T pressure_at_edge_distance(const T& d, const T& load)
{
    const T a = half_width(load);
    return 2 * (cos_pi(a - d) * sqrt_positive_part(sin_pi(d) * sin_pi(2 * a - d)));
}

/// (2.2), (2.4)  p(x)/p* for any load > 0 and |x| <= 1/2 (one wavelength about a peak).
template <OrderedScalar T>
T pressure(const T& x, const T& load)
{
    return across_seam(
        load, integer<T>(1),
        [&x](const T& s) { return pressure_partial(x, s); },
        [&x](const T& s) { return pressure_full(x, s); });
}

/// (2.9), (2.10)  p^max/p*: 1 + load in full contact, 2 sqrt(load) in partial contact.
template <OrderedScalar T>
T peak_pressure(const T& load)
{
    return across_seam(
        load, integer<T>(1),
        [](const T& s) -> T { return 2 * sqrt(s); },
        [](const T& s) -> T { return 1 + s; });
}

/// The distances of p from the two ends of the range of pressures in full contact,
/// p - (load - 1) and (load + 1) - p, each with at most one rounding in `double`.
template <Scalar T>
T above_lowest(const T& p, const T& load) { return p - (load - 1); }
template <Scalar T>
T below_highest(const T& p, const T& load) { return 1 - (p - load); } ///< to the highest pressure
inline double above_lowest(double p, double load) { return load <= 2 ? p - (load - 1) : 1 + (p - load); } ///< (2.16)

/// (2.11)-(2.14)  share of the wavelength with pressure above p in full contact, load >= 1:
/// (1/pi) arccos(p - load) = (2/pi) arctan sqrt((load + 1 - p)/(p - load + 1)).
template <Scalar T>
T exceedance_full(const T& p, const T& load)
{
    return 2 * atan_sqrt_over_pi(T(below_highest(p, load)), T(above_lowest(p, load)));
}

/// (2.17), (2.18)  the same in partial contact, load <= 1, p >= 0; 0 for p >= 2 sqrt(load).
/// With R = sqrt((1 - load)^2 + p^2) the square root's argument in (2.17) is s with
/// s : 1 - s = (4 load - p^2) : (2(1 - load) + 2R + p^2), and arcsin sqrt(s) = arctan sqrt(s/(1 - s)).
template <Scalar T>
T exceedance_partial(const T& p, const T& load)
{
    const T R = hypot_of(T(1 - load), p);
    return 2 * atan_minus_square_over_pi(T(4 * load), p, T(2 * (1 - load) + (2 * R + p * p)));
}

/// (2.11)-(2.18)  Q(p), the share of the wavelength on which the pressure exceeds p >= 0.
template <OrderedScalar T>
T exceedance(const T& p, const T& load)
{
    return across_seam(
        load, integer<T>(1),
        [&p](const T& s) { return exceedance_partial(p, s); },
        [&p](const T& s) {
            return across_seam(
                p, T(s - 1),
                [](const T&) { return integer<T>(1); },
                [&s](const T& above) { return exceedance_full(above, s); });
        });
}

/// (2.15)  q p* = 1/(pi sqrt(1 - (p - load)^2)),  load >= 1, load - 1 < p < load + 1.
template <Scalar T>
T density_full(const T& p, const T& load)
{
    return 1 / (pi<T>() * sqrt(above_lowest(p, load) * below_highest(p, load)));
}

/// (2.19) q p* in partial contact, load <= 1, 0 <= p < 2 sqrt(load), with the distance to the
/// upper edge given as `root` = sqrt(4 load - p^2) by a caller who knows it better than p:
/// q p* = p/(pi R root) sqrt((1 + load + R)/(1 - load + R)).
template <Scalar T>
T density_partial(const T& p, const T& load, const T& root)
{
    const T R = hypot_of(T(1 - load), p);
    return p / (pi<T>() * R * root) * sqrt((1 + load + R) / (1 - load + R));
}
/// (2.19), (2.20) with the root formed here: q p*, load <= 1, 0 <= p < 2 sqrt(load).
template <Scalar T>
T density_partial(const T& p, const T& load)
{
    return density_partial(p, load, sqrt_minus_square(T(4 * load), p));
}

/// The same with R under the root, given sum = R^2 and room = 4 load - p^2: one quotient and one root less, but what is under it may
/// underflow.
template <Scalar T>
T density_under_one_root(const T& p, const T& load, const T& sum, const T& room)
{
    const T R = sqrt(sum);
    return p / pi<T>() * sqrt((1 + load + R) / (((1 - load) + R) * sum * room));
}
/// In binary64, where sum and load are above 2^-300 and so the product is above 2^-600: sum and room are not both small, for the one takes
/// a load next to 1 and the other a small load or a pressure next to the edge, where room is above 2^-106 load.
inline double density_partial(double p, double load)
{
    const double share = 1 - load, sum = share * share + p * p;
    if (!(sum > 0x1p-300 && load > 0x1p-300)) return density_partial<double>(p, load);
    return density_under_one_root(p, load, sum, std::max(ScalarTraits<double>::minus_square(4 * load, p), 0.0));
}

/// (2.15), (2.16), (2.19), (2.20)  the density q p* of the pressure at p >= 0; 0 outside the support.
/// Unbounded at the edges p = 2 sqrt(load) and p = load +- 1: there, and for a ball that
/// touches one, the result is not finite.
template <OrderedScalar T>
T density(const T& p, const T& load)
{
    return across_seam(
        load, integer<T>(1),
        [&p](const T& s) {
            const T root = sqrt_minus_square(T(4 * s), p); // decides on which side of the edge p lies, without rounding
            return possibly(less(integer<T>(0), root)) ? density_partial(p, s, root) : integer<T>(0);
        },
        [&p](const T& s) {
            const bool outside = certainly(less(above_lowest(p, s), integer<T>(0)))
                              || certainly(less(below_highest(p, s), integer<T>(0)));
            return outside ? integer<T>(0) : density_full(p, s);
        });
}
/// In binary64 the edge is where the distance to it, rounded once, is 0.
inline double density(double p, double load)
{
    if (!(load < 1)) return density<double>(p, load);
    return ScalarTraits<double>::minus_square(4 * load, p) > 0 ? density_partial(p, load) : density<double>(p, load);
}

} // namespace touchstone::westergaard

/// The limit load -> 0 of section 2: Hertzian contact of the parabolic peak.
namespace touchstone::hertz {

/// (2.7)  a/lambda = sqrt(load)/pi,  load > 0.
template <Scalar T>
T half_width(const T& load)
{
    return sqrt(load) / pi<T>();
}

/// (2.6) with (2.7) in it: p/p* = 2 sqrt(load - (pi x)^2); 0 for |x| >= a.
template <Scalar T>
T pressure(const T& x, const T& load)
{
    return 2 * sqrt_minus_pi_square(load, x);
}

} // namespace touchstone::hertz
