// SPDX-License-Identifier: MIT
/// \file
/// Gauss-Legendre quadrature on one panel with a bound from an ellipse (internal to quadrature/).
///
/// F analytic on the Bernstein ellipse z = cosh(s + i phi), 0 <= s <= sigma, and |F| <= M on it: the n-point rule on [-1, 1] is off by at
/// most lemma::gauss_legendre = (64/15) M exp(-2 n sigma)/(1 - exp(-2 sigma)), n >= 2 (tanh_sinh.md, section 19). The ellipse is covered by
/// boxes in (s, phi), halved where F is not proved analytic; M is taken from the boxes of its boundary alone.
///
/// Cost: some tens of values in 53-bit complex balls, then n values in real ones.
#pragma once

#include "touchstone/scalar/ball.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace touchstone::quadrature {

/// The n nodes of Gauss and Legendre and what belongs to the angle (pi/4)(1 + z) of each; from the cache if they are there.
class GaussNodes {
public:
    static std::shared_ptr<const GaussNodes> get(long n, slong bits);

    struct Entry {
        Ball z;            ///< >= 0
        Ball weight;       ///< of z and of -z
        Ball sine, cosine; ///< of (pi/4)(1 + z); those of (pi/4)(1 - z) are exchanged
    };
    const std::vector<Entry>& entries() const { return entries_; }
    long count() const { return n_; }

private:
    GaussNodes(long n, slong bits);
    long n_;
    slong bits_;
    std::vector<Entry> entries_;
};

/// A real function of z in [-1, 1] in two arithmetics.
struct EllipseFunction {
    std::function<ComplexBall(const ComplexBall& z)> in_plane;                   ///< non-finite unless analytic on the whole ball
    std::function<Ball(const GaussNodes::Entry&, bool mirrored)> at_node;        ///< at z, or at -z
};

struct EllipseIntegral {
    Ball value;
    long nodes = 0, pieces = 0;
    double sigma = 0;
    Ball bound, discretisation; ///< of |F| on the ellipse; of the error, on [-1, 1]

    /// One line for a person; `scale`: what the integral over [-1, 1] is multiplied by.
    std::string proof(const Ball& scale) const;
};

/// The integral over [-1, 1] to `bits` bits of its size (of that of |F|, if `of_absolute`); nothing if no ellipse is proved, or more than
/// `most_nodes` are needed.
std::optional<EllipseIntegral> by_ellipse(const EllipseFunction&, double bits, bool of_absolute, long most_nodes);

} // namespace touchstone::quadrature
