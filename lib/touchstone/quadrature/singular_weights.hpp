// SPDX-License-Identifier: MIT
/// \file
/// Nodes of Gauss, and the weights that integrate functions singular at the ends by values at them (internal to quadrature/).
///
/// With u = (1 + z)/2, r = (1 - z)/2 and w = u^p r^q (log u)^i (log r)^j, p, q > -1, the weights W_k with
///
///     sum of W_k F(z_k) = integral of w F over [-1, 1]        for every polynomial F of degree n - 1 at most
///
/// are W_k = lambda_k (sum over m < n of (2m + 1) M_m P_m(z_k)), where lambda_k are those of Gauss and M_m is the integral of w P_m du. For
/// i = j = 0 the moments obey (m + 1)(m + p + q + 2) M_(m+1) = (p - q)(2m + 1) M_m - m(p + q + 1 - m) M_(m-1); their derivatives in p and q
/// are those with logarithms (tanh_sinh.md, section 19).
///
/// Cost: n^2/2 steps of Legendre's recursion for a table; kept. Chebyshev's nodes: n products of complex numbers.
#pragma once

#include "touchstone/quadrature/endpoint_number.hpp"

#include <memory>
#include <optional>
#include <vector>

namespace touchstone::quadrature {

/// Whose nodes: of the weight 1, or of 1/sqrt(1 - z^2).
enum class GaussRule { legendre, chebyshev };

/// The n nodes of Gauss in [-1, 1] and the sine and cosine of an angle of each; from the cache if they are there.
class GaussNodes {
public:
    static std::shared_ptr<const GaussNodes> get(long n, slong bits, GaussRule = GaussRule::legendre);

    struct Entry {
        Ball z;      ///< >= 0
        Ball weight; ///< of z and of -z
        /// Of Legendre's the angle is (pi/4)(1 + z), of Chebyshev's sine^2 = (1 + z)/2 as well. Those of -z are exchanged.
        Ball sine, cosine;
        slong bits; ///< of the rule

        /// log((1 + z)/2), or log((1 - z)/2), to as many bits: kept from the first call on.
        const Ball& log_of_share(Side from) const;

    private:
        mutable std::optional<Ball> log_of_left_, log_of_right_;
    };
    const std::vector<Entry>& entries() const { return entries_; }
    long count() const { return n_; }

private:
    GaussNodes(long n, slong bits, GaussRule);
    void fill_legendre();
    void fill_chebyshev();
    long n_;
    slong bits_;
    GaussRule rule_;
    std::vector<Entry> entries_;
};

/// u^left r^right (log u)^left_logarithms (log r)^right_logarithms
struct SingularWeight {
    Exponent left, right;
    int left_logarithms = 0, right_logarithms = 0;

    bool has_integral() const { return Exponent(-1) < left && Exponent(-1) < right; }
    /// What u and r make of it when they change places.
    SingularWeight mirrored() const { return {right, left, right_logarithms, left_logarithms}; }
    bool is_one() const { return left.is_zero() && right.is_zero() && left_logarithms == 0 && right_logarithms == 0; }
    friend bool operator==(const SingularWeight&, const SingularWeight&) = default;
};

/// w at a point inside, where r = 1 - u.
Ball value_of(const SingularWeight&, const Ball& u, const Ball& r);

/// Integrals of w P_m over u in (0, 1), P_m(2u - 1), for m < n; non-finite where w has no integral.
std::vector<Ball> moments(const SingularWeight&, long n);

class WeightedNodes {
public:
    /// From the cache if they are there.
    static std::shared_ptr<const WeightedNodes> get(const SingularWeight&, long n, slong bits);

    /// Of the k-th entry of GaussNodes, or of its mirror image.
    const Ball& at(std::size_t k, bool mirrored) const { return (mirrored ? at_mirrored_ : at_)[k]; }
    /// 1/w there.
    const Ball& reciprocal(std::size_t k, bool mirrored) const;
    /// Upper bound of the integral of |w| over [-1, 1] and the sum of the |W_k|.
    const Ball& size() const { return size_; }

private:
    WeightedNodes(const SingularWeight&, long n, slong bits);
    SingularWeight weight_;
    long n_;
    slong bits_;
    std::vector<Ball> at_, at_mirrored_;
    mutable std::vector<Ball> reciprocal_, reciprocal_mirrored_; // empty until one is asked for
    Ball size_;
};

} // namespace touchstone::quadrature
