// SPDX-License-Identifier: MIT
/// \file
/// A function near the one that the approach to the fractal limit is made of: docs/limit.md, theorem 8. Internal to limit/.
///
/// With s = -log x, the slope g = dh/ds of a function of the load ratio becomes (D g)(s) = E[psi g(s')] by one wave, where with u = tanh
/// tau
///
///     s' = s/2 + log(G/2) + log cosh tau - log(1 - v)/2,   v = exp(-s) u^2,   psi = ds'/ds = (1 - 2v)/(2(1 - v)),
///     E[f] = (4/pi) int_0^oo sech^3(tau) f dtau.
///
/// D has the eigenvalues of h -> E[h(y)] but for 1, whose function is constant.
#pragma once

#include "touchstone/scalar/accuracy.hpp"

#include <vector>

namespace touchstone::limit {

/// w(s) = sum of value[k] T_k(t), t from -1 to 1 as log s goes from `low` to `high`; constant beyond.
struct Eigenfunction {
    double low, high;
    std::vector<Ball> value; ///< exact
    std::vector<Ball> slope; ///< of dw/dt

    /// t of s; of complex s too
    template <class T>
    T place(const T& s) const
    {
        const Ball half = Ball::exactly(high) - Ball::exactly(low);
        return (2 * log(s) - (Ball::exactly(high) + Ball::exactly(low))) / half;
    }
    /// dt/d(log s)
    Ball stretch() const { return 2 / (Ball::exactly(high) - Ball::exactly(low)); }
};

/// Where the noise is cut into panels for Gauss and Legendre's rule: 0 and the ends of the panels, the last of which takes s' from the
/// largest s, that of `highest_sigma` + log(G^2/4), just there.
std::vector<double> panels_of_noise(double highest_sigma);

/// A node of the rule for E.
struct Noise {
    Ball square, log_cosh, weight; ///< tanh^2 tau, log cosh tau, (4/pi) sech^3 tau times the rule's weight
};
/// Appends Gauss and Legendre's nodes for tau in [from, to].
void add_noise(std::vector<Noise>& all, const Ball& from, const Ball& to, long nodes);

/// The largest s - log(G^2/4) on which a function is looked at.
double highest_sigma(Accuracy);

/// By collocation and inverse iteration. A search: nothing is known of the result. G > 2.
Eigenfunction approximate_eigenfunction(const Ball& G, Accuracy);

/// The sum of c[k] T_k(t) by Clenshaw's recurrence; c.size() >= 1.
Ball chebyshev_sum(const std::vector<Ball>& c, const Ball& t);
/// Coefficients of the derivative of sum c[k] T_k.
std::vector<Ball> chebyshev_derivative(const std::vector<Ball>& c);

} // namespace touchstone::limit
