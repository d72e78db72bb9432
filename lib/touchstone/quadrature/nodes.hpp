// SPDX-License-Identifier: MIT
/// \file
/// Nodes of the tanh-sinh rule and of the logistic one, cached.
///
/// The step is h = (log 2)/m. Of the logistic rule E_k = exp(-kh) = 2^(-k/m). Of the tanh-sinh rule exp(kh) = 2^(k/m), and with e_k =
/// exp((pi/2) 2^(k/m)),
///
///     e_(k+m) = e_k^2,      E_k = exp(-pi sinh kh) = e_(-k) / e_k,
///
/// so m exponentials give all nodes: the rest is squaring, whatever the number of octaves.
/// A squaring doubles the relative error, so twice the number of octaves in guard bits
/// pays for it; the ball radii account for it in any case.
/// Precision falls with the weight: node k is kept to precision + log2(weight).
#pragma once

#include "touchstone/quadrature/strip.hpp"

#include <memory>
#include <vector>

namespace touchstone::quadrature {

class NodeTable;

/// The point at t = +kh (right) or -kh (left).
class Node : public Frame<Ball> {
public:
    Node(const NodeTable& table, long k, Side side) : table_(table), k_(k), side_(side) {}
    Ball distance(Side s) const override;
    Ball logarithm(Side s) const override;
    Ball monomial(const Exponent& p, const Exponent& q) const override;
    /// u^p r^q cosh(t) u r; u^p r^q u r of the logistic rule.
    Ball weighted(const Exponent& p, const Exponent& q) const;
    const Ball& cosh() const;
    /// pi sinh(kh), or kh, about.
    double depth() const;

private:
    Ball power_by_log(Side s, const Exponent& e) const override;
    const NodeTable& table_;
    long k_;
    Side side_;
};

class NodeTable {
public:
    /// Nodes |k| <= count for step (log 2)/m, good for integrands with exponents >= decay at
    /// both ends, to `bits` bits of the largest terms. From the cache if it is there.
    static std::shared_ptr<const NodeTable> get(long m, long count, slong bits, double decay, Transformation = Transformation::tanh_sinh);

    long m() const { return m_; }
    long count() const { return count_; }

private:
    friend class Node;
    NodeTable(long m, long count, slong bits, double decay, Transformation);
    void fill_tanh_sinh(slong full, long octaves);
    void fill_logistic();
    slong bits_of(double depth, long growth) const;

    struct Entry {
        Ball near, far;               // E/(1 + E), 1/(1 + E)
        Ball cosh, weight;            // cosh(kh), or 1; that times near far
        double depth = 0;             // pi sinh(kh), or kh, about
        mutable Ball minus_w, log_far;
        mutable bool has_log = false;
        Ball e;
        slong bits = 0;
    };
    void logs(long k) const;
    Ball power_of_two_at(long k) const; // 2^(k/m)

    long m_, count_;
    slong bits_;
    double decay_;
    Transformation transformation_;
    std::vector<Ball> root_;          // 2^(i/m), 0 <= i < m
    std::vector<Entry> entries_;      // k = 0 .. count
};

} // namespace touchstone::quadrature
