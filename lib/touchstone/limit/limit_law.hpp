// SPDX-License-Identifier: MIT
/// \file
/// The limit law of the chain of load ratios, forwards: docs/limit.md. An estimate in binary64, that looks again at what the backward route
/// proves, and a coarse solver for its search. Nothing here is trusted.
///
/// pi is the stationary law of the ratio x that a randomly chosen unit of force meets at a scale, E_pi[f(x)] = E_pi[E_x[f(y)]]. On
/// Chebyshev points of graded panels one wave is a matrix M, (M f)_i = E_{x_i}[f(y)] by Gauss-Legendre between the panels' edges; pi is its
/// left eigenvector, and
///
///     C(G) = lim A_n G^n/load = E_pi[B_0(x)/x].
#pragma once

#include "touchstone/limit/krylov.hpp"
#include "touchstone/limit/mesh.hpp"
#include "touchstone/scalar/accuracy.hpp"

#include <functional>

namespace touchstone::limit {

class LimitLaw {
public:
    /// \param order points a panel
    LimitLaw(const Ball& G, const Grading&, int order);

    const Vector& nodes() const { return nodes_; }
    /// M f
    Vector after(const Vector& f) const;
    /// The left eigenvector: weights of the nodes.
    const Vector& weights() const { return weights_; }
    /// E_pi[f]
    double mean(const std::function<double(double x)>& f) const;
    /// d with d - M d = f - E_pi[f], E_pi[d] = 0.
    Vector solve(const Vector& f) const;
    /// M's second eigenvalue in modulus, and how much that still changed.
    std::pair<double, double> second_eigenvalue() const;

    /// Of a function known at the nodes.
    class Interpolant {
    public:
        Interpolant(const LimitLaw&, const Vector& values);
        double operator()(double x) const; ///< constant beyond the first and the last panel
    private:
        const LimitLaw& law;
        Vector coefficients;
    };

private:
    void fill_row(std::size_t i);

    double G_;
    int order_;
    Vector edges_, points_, nodes_, matrix_, weights_; // points_: on [-1, 1]
};

/// E_pi[f] on a mesh graded for G and those points, and what a coarser one changes. f has to be known to few digits less than it is wanted
/// to.
Witness mean_in_the_limit(const Ball& G, const std::vector<Ball>& further, const std::function<double(double x)>& f);
/// E[f(x_n)]/E[g(x_n)] of the chain that begins at `load`, less E_pi[f]/E_pi[g]: both by the same grid, so that small differences keep
/// their digits.
Witness distance_in_the_mean(const Ball& G, double load, long n, const std::vector<Ball>& further, const std::function<double(double x)>& f,
                             const std::function<double(double x)>& g);
/// The density of p/p*_n = P after two waves, D_1(x), in binary64: by the angle of the first wave, between the angles where the second's
/// density is not smooth.
double density_after_two_waves(double G, double P, double x);
/// The share of one wave of mean x above P, over x: in binary64.
double exceedance_over_x(double P, double x);
/// C(G) by it.
Witness area_constant_by_law(const Ball& G);

} // namespace touchstone::limit
