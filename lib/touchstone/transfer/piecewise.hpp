// SPDX-License-Identifier: MIT
/// \file
/// Functions on a line kept as polynomials on intervals that are halved where needed, and one wave applied to them.
///
/// The grid is blind: an interval is halved until the tail of its Legendre series, and what the series is off at the ends, no longer
/// matter. Nothing is told where the function is not smooth. Points x, and so intervals, are binary fractions: their ends and the distances
/// between them are exact in `Real`.
///
/// **When an interval is fine.** An error e on an interval [a, a + h] reaches a later value with at most the share of
/// a wave that falls there. The densities (W1), (W2) have square-root ends, so that share is about sqrt(h/(a+h)) and less;
/// errors relative to the (increasing) function itself add up over levels (positivity). So: |tail| min(1, sqrt(h/(a+h))) <= tolerance |V|.
/// An exceedance falls to 0 at the end of its support, and what is near the end of the next one comes from there alone: the distance
/// from that end counts for a if it is less, and the least of V on the interval for V.
///
/// **One wave applied.** Sum over intervals of int V density dy. For an interval, leaf or not, that is at least its
/// length away from the singular points of the density, the density is replaced by its interpolant at the N Gauss points: the
/// moments c_j = int V l_j, which are sums over the two halves, do the rest. Intervals next to an end of the density
/// are integrated over the angle instead. So a value costs some 20 N evaluations however many intervals there are.
#pragma once

#include "touchstone/transfer/gauss.hpp"
#include "touchstone/transfer/wave.hpp"

#include <functional>
#include <vector>

namespace touchstone::transfer {

struct BlindRule {
    int points = 24;           ///< Gauss points of an interval
    int angle_points = 48;     ///< Gauss points of an angle
    double tolerance = 1e-18;
    double smallest = 1e-20;   ///< an interval that begins at 0 is not halved below this
    Extended end = std::numeric_limits<Extended>::infinity(); ///< V falls to 0 there
    double negligible = 1e-25; ///< what is less, next to the end, need not be right in its relative digits
};

template <class Real>
class Piecewise {
public:
    /// V on [0, 1], [1, 2], [2, 4], ... until `reach` is covered, from its values at points that
    /// are given to twice the digits. `f` is called from several threads.
    Piecewise(const BlindRule&, const Real& reach, const std::function<Real(const Pair<Real>&)>& f);

    /// Expectation of V after one wave: int V density dy. V is 0 outside the grid.
    Real after(const Wave<Real>&) const;
    /// dV/dx on the same intervals, of V made continuous, 0 beyond the grid: its steps from one to the next are small, but as point masses
    /// they would be met by an end of a density, where it is infinite. A step is spread over the shorter of the two intervals.
    Piecewise derivative() const;
    /// Without the last three terms of each series, the ends kept: what that changes says how far off the whole may be.
    Piecewise shortened() const;
    Real at(const Real& x) const;
    Real integral() const;

private:
    struct Node {
        Real left, width;
        long child = -1; ///< index of the left half, the right half follows; -1: a leaf
        std::size_t data; ///< where its N moments, and N coefficients, begin
    };
    Real near_leaf(const Node&, const Arc<Real>&) const;
    void sum_moments();
    Real series(const Node&, const Real& t) const;
    void series(const Node&, const std::vector<Real>& t, std::vector<Real>& out) const;

    BlindRule rule_;
    const GaussRule<Real>* gauss_;
    const GaussRule<Real>* angle_;
    std::size_t roots_ = 0;
    std::vector<Node> nodes_;
    std::vector<Real> moments_, coefficients_;
};

extern template class Piecewise<Extended>;
extern template class Piecewise<double>;

} // namespace touchstone::transfer
