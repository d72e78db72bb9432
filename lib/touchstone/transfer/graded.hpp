// SPDX-License-Identifier: MIT
/// \file
/// Functions on a line kept as Chebyshev series on a fixed grid, graded towards known singular points, and one wave
/// applied to them: the second discretisation of the recursion where full contact occurs.
///
/// It shares with piecewise.hpp the density of one wave (wave.hpp) and nothing else: the grid comes from the singular points
/// (singular_points.hpp), not from the function; one grid serves all levels; Chebyshev points of the second kind, degree
/// 32; every interval is summed by itself (Clenshaw-Curtis), those next to an end of the density by tanh-sinh over the angle.
///
/// **Grid.** Every singular point s is an end of intervals. An interval [y, y + h] obeys h <= b (y - s) for the points below,
/// h <= b/(1+b) (s - y) for those above it, b = 3/2, so that a singular point is never nearer than h/b, but for
/// the intervals that end at s: those have the length floor(g), g the generation of s, below which the singular part
/// c_g eps^((g+1)/2) interpolated in degree N and weighted with the share sqrt(h) of a wave is below the tolerance,
///
///     c_g floor^(g/2 + 1) N^-(g+1) = tolerance,   c_g = 0.4^g/sqrt(g!) (measured for G = 1.08; smaller for larger G).
///
/// Lengths are relative to s for s < 1. The generations with a floor below 1/2 are marked; no interval is so long that a
/// point of the first generation left out, g, inside it matters: c_g (h/2N)^((g+1)/2) h^(1/2) <= tolerance.
#pragma once

#include "touchstone/transfer/singular_points.hpp"
#include "touchstone/transfer/wave.hpp"

#include <functional>
#include <vector>

namespace touchstone::transfer {

struct GradedRule {
    int degree = 32;
    double tolerance = 1e-19;
    double smallest = 1e-20; ///< the interval at 0
};

template <class Real>
class GradedGrid {
public:
    /// On [0, reach], graded towards points ascending, and 0. \pre reach > 1
    GradedGrid(const GradedRule&, const std::vector<SingularPoint>& points, const Ball& reach);
    /// How many generations matter.
    static int generations(const GradedRule&);

    /// A function's Chebyshev data on this grid.
    struct Function {
        std::vector<Real> moments;      ///< values times Clenshaw-Curtis weights and interval length
        std::vector<Real> coefficients;
    };
    /// From its values at points given to twice the digits; `f` is called from several threads.
    Function sample(const std::function<Real(const Pair<Real>&)>& f) const;
    Function derivative(const Function&) const;
    /// Without the last three terms of each series, the ends kept: what that changes says how far off the whole may be.
    Function shortened(const Function&) const;
    /// Expectation after one wave.
    Real after(const Function&, const Wave<Real>&) const;

    std::size_t intervals() const { return cells_.size(); }

private:
    struct Cell {
        Real left, right, width;
    };
    Real near(const Function&, std::size_t cell, const Arc<Real>&) const;
    Real series(const Function&, std::size_t cell, const Real& t) const;

    GradedRule rule_;
    std::vector<Cell> cells_;
    std::vector<Real> nodes_, mirrored_, weights_, cosines_; ///< t, 1 - t on [0, 1]; Clenshaw-Curtis; cos(pi j k/N)
    struct AngleNode {
        Real t, weight; ///< tanh-sinh on [0, 1]
    };
    std::vector<AngleNode> angle_;
};

extern template class GradedGrid<Extended>;

} // namespace touchstone::transfer
