// SPDX-License-Identifier: MIT
/// \file
/// T in partial contact as a matrix: the trapezoid rule over v, u = tanh v, of polynomials in s = -log x on panels. Internal to
/// certificate/.
///
/// The rule, the panels and every bound are those of docs/certificate.md, which proves them; here bounds are found in binary64, for the
/// checker to find again. h_m(x) = G^m A_m(x)/(x lambda_0).
#pragma once

#include "touchstone/scalar/ball.hpp"
#include "touchstone/scalar/exact_text.hpp"

#include <gmpxx.h>

#include <vector>

namespace touchstone::certificate {

/// Of the ellipses on which polynomials are bounded: the largest short dyadic number below 3 + sqrt 8, for panels low <= s <= 2 low.
inline Rational ellipse() { return Rational(93, 16); }

/// The choices of one section.
struct Grid {
    Root root;
    long bits = 0;               ///< of fixed point
    long kept_bits = 0;          ///< coefficients are kept to 2^-kept_bits
    Rational step;               ///< of the trapezoid rule, dyadic
    long points = 0;             ///< v = 0, step ... points * step
    long terms = 0;              ///< of a polynomial
    std::vector<Rational> edges; ///< of the panels, dyadic, each twice the one before

    Ball G() const; ///< at the working precision
};
/// For areas up to scale n.
Grid grid_for(const Root& G, long n, double digits, const Rational& least_load, const Rational& largest_load);

/// sum c_i T_i on one panel, coefficients in units of 2^-kept_bits, and a bound of its distance from h_m as it is claimed, a short number.
struct Polynomial {
    std::vector<mpz_class> coefficients;
    double error = 0;
};
struct Level {
    long m = 0;
    std::vector<Polynomial> panels;
};

/// What T at one x makes of polynomials: the weights of their coefficients, in units of 2^-bits.
struct Row {
    double s = 0;
    long bits = 0;
    std::vector<std::vector<mpz_class>> sums; ///< a panel, a coefficient
    double beyond = 0;                        ///< sum of weights exp(s_y/2) beyond the last panel
    double moved = 0;                         ///< how far a point may be off
};
struct Applied {
    Ball value;
    double error;
};

class DiscreteOperator {
public:
    explicit DiscreteOperator(const Grid&);
    /// V_0 ... V_(n-1)
    std::vector<Level> levels(long n) const;
    /// At x = load <= 1.
    Row row_at(const Rational& load) const;
    Applied apply(const Row&, const Level&) const;

private:
    struct Node {
        Ball q, minus_log_q, real_weight;
        mpz_class weight;
    };
    Row row(const Ball& s, const Ball& x, const Ball& rest, long bits) const;
    Polynomial interpolate(std::size_t panel, long m, const std::vector<mpz_class>& values, double error) const;

    const Grid& grid_;
    std::vector<Node> nodes_;
    std::vector<mpz_class> points_;              ///< Chebyshev's on [-1, 1], in units of 2^-bits
    std::vector<std::vector<mpz_class>> powers_; ///< T_i at them
    double log_half_G_ = 0, G_ = 0, quadrature_ = 0;
};

} // namespace touchstone::certificate
