// SPDX-License-Identifier: MIT
/// \file
/// Densities of load ratios by pieces, and what one more wave makes of them, in binary64. Internal to certificate/.
///
/// x has the density x phi(T), T = 1 - (x/Y)^2, on 0 < x < Y; phi is T^(power/2) times a polynomial on each of some pieces of 0 <= T <= 1.
#pragma once

#include "touchstone/scalar/ball.hpp"
#include "touchstone/scalar/exact_text.hpp"

#include <functional>
#include <string>
#include <vector>

namespace touchstone::certificate {

/// 0 <= T <= 1 and 1 - T, which near 1 is not had from T.
struct Place {
    double T, rest;
};

struct Piece {
    double low, high, centre, radius;
    int power;
    std::vector<double> coefficients; ///< of Chebyshev's polynomials of (T - centre)/radius

    double operator()(double T) const;
};

constexpr double widest = 2.2; ///< upper over lower end of a piece
constexpr std::size_t most_pieces = 64;

/// What is read off a density: that of the next ratio, the share of the next wave above a pressure, or the force at ratios x > Y (1 - T).
enum class Read { density, share, force };

/// The integral over 0 <= v <= 1 of what is read off phi at r = T (1 - v^2); cuts are those of phi, as r = 1 - x/Y, from where it begins.
double over_pieces(double Y, const std::vector<double>& cuts, const std::function<double(Place)>& phi, Place, Read);

/// A piece for low <= T <= high, continued a little below where `least` < low; coefficients below `small` of the first are left out at its
/// end.
Piece fitted(double least, double low, double high, int power, const std::function<double(double T)>& density, double small = 1e-15);
/// From where on a piece is continued below its end: an interval of the checker begins there.
double least_of(double low, double high);
/// With which the polynomial is nearly constant between.
int power_between(double low, double high, const std::function<double(double T)>& density);
/// r = 1 - x/Y where T is.
double ratio_cut(double T);

Rational exactly(double);
/// low= high= centre= radius= power= exponent=, and the coefficients in units of 2^exponent.
std::string shape(const Piece&);
std::string coefficients(const Piece&);

} // namespace touchstone::certificate
