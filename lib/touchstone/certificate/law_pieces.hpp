// SPDX-License-Identifier: MIT
/// \file
/// Densities of load ratios by pieces, and what one more wave makes of them, in binary64 or, for more than ten digits or so, in pairs of
/// it. Internal to certificate/.
///
/// x has the density x phi(T), T = 1 - (x/Y)^2, on 0 < x < Y; phi is T^(power/2) times a polynomial on each of some pieces of 0 <= T <= 1.
#pragma once

#include "touchstone/scalar/ball.hpp"
#include "touchstone/scalar/double_double.hpp"
#include "touchstone/scalar/exact_text.hpp"

#include <functional>
#include <numbers>
#include <string>
#include <type_traits>
#include <vector>

namespace touchstone::certificate {

using Wide = DoubleDouble<double>; ///< the Real of what follows, if not double

/// 0 <= T <= 1 and 1 - T, which near 1 is not had from T.
template <class Real>
struct Place {
    Real T, rest;
};

template <class Real>
struct Piece {
    double low, high, centre, radius;
    int power;
    std::vector<Real> coefficients; ///< of Chebyshev's polynomials of (T - centre)/radius

    Real operator()(const Real& T) const;
};

constexpr double widest = 2.2; ///< upper over lower end of a piece
constexpr std::size_t most_pieces = 64;
/// Of the first coefficient: those below it at a piece's end are left out, where nothing is said of that.
constexpr double smallest_coefficient = 1e-15;

/// What is read off a density: that of the next ratio, the share of the next wave above a pressure, or the force at ratios x > Y (1 - T).
enum class Read { density, share, force };

/// The integral over 0 <= v <= 1 of what is read off phi at r = T (1 - v^2); cuts are those of phi, as r = 1 - x/Y, from where it begins.
template <class Real>
Real over_pieces(const Real& Y, const std::vector<Real>& cuts, const std::function<Real(const Place<Real>&)>& phi, const Place<Real>&,
                 Read);

/// A piece for low <= T <= high, continued a little below where `least` < low, and shortened.
/// \throws BeyondReach where T^(power/2) is below the numbers of binary64, from level 42 on, or 38 in pairs
template <class Real>
Piece<Real> fitted(double least, double low, double high, int power, const std::function<Real(const Real& T)>& density, double small);
/// Without the coefficients at its end that are below `small` of the first.
template <class Real>
Piece<Real> shortened(Piece<Real>, double small);
/// From where on a piece is continued below its end: an interval of the checker begins there.
double least_of(double low, double high);
/// With which the polynomial is nearly constant between.
template <class Real>
int power_between(double low, double high, const std::function<Real(const Real& T)>& density);
/// r = 1 - x/Y where T is.
template <class Real>
Real ratio_cut(const Real& T);

double root(double);
Wide root(const Wide&);
template <class Real>
constexpr Real pi_number()
{
    if constexpr (std::is_same_v<Real, double>)
        return std::numbers::pi;
    else
        return {std::numbers::pi, 0x1.1a62633145c07p-53};
}
double half_power(double x, int power); ///< x^(power/2)
Wide half_power(const Wide& x, int power);
/// The midpoint.
template <class Real>
Real rounded(const Ball&);
template <>
double rounded(const Ball&);
template <>
Wide rounded(const Ball&);
template <class Real>
Real rounded(const Rational& x)
{
    if constexpr (std::is_same_v<Real, double>)
        return x.get_d();
    else
        return rounded<Real>(Ball(x));
}

Rational exactly(double);
Rational exactly(const Wide&);
/// low= high= centre= radius= power= exponent=, and the coefficients in units of 2^exponent.
template <class Real>
std::string shape(const Piece<Real>&);
template <class Real>
std::string coefficients(const Piece<Real>&);

} // namespace touchstone::certificate
