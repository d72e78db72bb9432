// SPDX-License-Identifier: MIT
/// \file
/// Quadrature at the nodes of Gauss with a bound from an ellipse (internal to quadrature/).
///
/// F = sum of w_k c_k on [-1, 1], each c_k analytic on the Bernstein ellipse z = cosh(s + i phi), 0 <= s <= sigma, and |c_k - m_k| <= M_k
/// on it, m_k a constant. Where w_k is 1 the n-point rule of Gauss and Legendre is off by at most lemma::gauss_legendre; where it is a
/// weight that is singular at an end (singular_weights.hpp) the rule at the same nodes that has its moments, by lemma::interpolation;
/// where it is 1/sqrt(1 - z^2), alone, the rule of Gauss and Chebyshev, by lemma::gauss_chebyshev (tanh_sinh.md, sections 19 and 20). The
/// ellipse is covered by boxes in (s, phi), halved where F is not proved analytic; M_k is taken from the boxes of its boundary alone. Which
/// ellipse is tried is a guess from few values (guessed_ellipse); nothing of the bound rests on it.
///
/// Cost: some tens of values in 53-bit complex balls, then n values in real ones; of an even F half of both.
#pragma once

#include "touchstone/quadrature/singular_weights.hpp"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace touchstone::quadrature {

/// A box about the ellipse: z, and the sine and cosine of (pi/4)(1 + z).
struct EllipseBox {
    ComplexBall z, sine, cosine;
    std::optional<Side> side; ///< of the curve phi = pi/2 through the middle, z = cosh(s + i phi); none where it is on both
};

/// A real function of z in [-1, 1] in two arithmetics: the c_k beside its weights, in their order.
struct EllipseFunction {
    /// Whether F is even, and with each weight its mirror image is there: c_k(-z) is then what stands beside the mirror image at z, and half
    /// of the ellipse and of the nodes are enough.
    bool is_even = false;
    GaussRule rule = GaussRule::legendre; ///< of Chebyshev's 1/sqrt(1 - z^2) is the weight, and `weights` is 1
    std::vector<SingularWeight> weights{SingularWeight{}};
    /// Of an even F: which weight is the mirror image of the k-th; else k.
    std::size_t partner(std::size_t k) const;
    std::function<void(const EllipseBox&, std::vector<ComplexBall>& c)> in_plane; ///< non-finite unless analytic on the whole ball
    std::function<void(const GaussNodes::Entry&, bool mirrored, std::vector<Ball>& c)> at_node; ///< at z, or at -z
    /// Of one weight that is not 1: F itself there, w c, if it can be had to about the working precision; there may be none.
    std::function<std::optional<Ball>(const GaussNodes::Entry&, bool mirrored)> with_weight;
    double nodes_a_box = 3; ///< a value in the plane costs about as much as so many at nodes: how long a larger ellipse is looked for
};

struct EllipseIntegral {
    Ball value;
    long nodes = 0, pieces = 0; ///< values at nodes, and in boxes
    double sigma = 0;
    Ball bound, discretisation; ///< the largest M_k; of the error, on [-1, 1]

    /// One line for a person; `scale`: what the integral over [-1, 1] is multiplied by.
    std::string proof(const Ball& scale) const;
};

/// The integral over [-1, 1] to `bits` bits of its size (of that of |F|, if `of_absolute`); nothing if no ellipse is proved, or more than
/// `most_nodes` are needed.
std::optional<EllipseIntegral> by_ellipse(const EllipseFunction&, double bits, bool of_absolute, long most_nodes);

} // namespace touchstone::quadrature
