// SPDX-License-Identifier: MIT
/// \file
/// C(G) and the limiting distributions for any G > 1, full contact included: docs/limit.md, theorem 4.
///
/// For any bounded Phi and any number c, |E_pi[f/x] - c| <= G^(2+k) sup T^k|R|, k >= 0, R = f - c x - Phi + G T Phi. Phi is sought near the
/// solution of R = 0, which is Poisson's equation of the chain, and then R is bounded.
#pragma once

#include "touchstone/scalar/accuracy.hpp"
#include "touchstone/scalar/ball.hpp"
#include "touchstone/scalar/double_double.hpp"

#include <functional>
#include <string>
#include <vector>

namespace touchstone::limit {

/// What is asked of the limit, as the mean E_pi[f/x] over the ratio x that a unit of force meets.
struct Question {
    enum class Of {
        contact,  ///< f: B_0, the share of one wave in contact,
        pressure, ///< above a pressure,
        force,    ///< what force is carried above it,
        density   ///< or the density D_1 of that pressure after two waves, theorem 6: f may be infinite at a few points
    } of = Of::contact;
    Ball pressure{}; ///< in p*_n, known to 101 bits
};

/// The most digits by this.
constexpr long most_digits_by_poisson = 15;

/// C(G) for contact; the limits of G^n/load times the share of lambda_0 where p_n is above that pressure; of the share of the force that is
/// carried there; and of G^(n-1)/load times the density of p_n/p*_n.
/// \param G known to 101 bits, at least 1.02
/// \throws BeyondReach where the mesh would be too large, or the residual is not small enough for the digits asked for
Ball mean_by_poisson(const Question&, const std::function<Ball()>& G, Accuracy);

/// What bounds its error.
std::string mean_by_poisson_certificate(const Question&, const std::function<Ball()>& G, Accuracy);

/// What the search finds, of which nothing is proven: G Phi on panels, and c. A certificate says it (docs/certificate.md).
struct PoissonSearch {
    using Real = DoubleDouble<double>;
    struct Panel {
        Real y0, y1, centre, half;
        std::vector<Real> coefficients; ///< G Phi = sum c_k T_k((y^2 - centre)/half) for y0 <= y <= y1
    };
    std::vector<Panel> panels; ///< up to beyond the highest ratio of the limit law
    Real c;
};
/// \param of_mean about how far c and the functions may be off
PoissonSearch search_poisson(const Question&, const Ball& G, double of_mean);

/// For tests: what Phi is made worse by on the panel y0 <= y <= y1. Phi may be anything; the proof has to see it.
using SpoiledPhi = std::function<double(double y0, double y1)>;
struct Poisson {
    Ball c;        ///< near the mean
    double error;  ///< at least |mean - c|
    /// Of R: sup T|f - P| (of a density T^2), sup T^2|T V_0 - V_1|, the rest on the mesh, sup T of what is below it.
    double level_zero, step, polynomial, below;
    std::size_t panels;
};
Poisson solve_poisson(const Question&, const Ball& G, double tolerance, const SpoiledPhi& = {});

} // namespace touchstone::limit
