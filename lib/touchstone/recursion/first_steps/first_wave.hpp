// SPDX-License-Identifier: MIT
/// \file
/// The first wave, of known mean: E(x), the share of lambda_0 with a ratio p_0/p*_1 above x, (2.17) in products of roots of distances,
/// and its density -E'(x), (2.19).
///
///     load >= 1:  E = (2/pi) arctan((high - x)/(x - low))^(1/2),  low, high = (load -+ 1)/G
///     load < 1:   E = (2/pi) arctan(G (high^2 - x^2)/(2 (1 - load + R + G^2 x^2/2)))^(1/2),
///                 R^2 = (1 - load)^2 + G^2 x^2,  high = 2 load^(1/2)/G
///
/// Internal to recursion/first_steps/.
#pragma once

#include "touchstone/recursion/first_steps/pieces.hpp"

namespace touchstone::transfer::first_steps {

class FirstWave {
public:
    /// load > 0, G > 1; the latter also as a rational number if it is one.
    FirstWave(const Rational& load, const Ball& G, const std::optional<Exact>& exact_G);

    bool full() const { return full_; }
    /// Of the support of -E'; low is 0 in partial contact.
    const End& low() const { return low_; }
    const End& high() const { return high_; }

    /// -E' is `density` over the roots of the distances of x from these.
    std::vector<Piece::Beyond> roots(const Piece&) const;
    ComplexBall density(const ComplexBall& x, const Piece::Point& at) const;
    /// E(x) for load < 1, from the root of high - x
    ComplexBall partial_share(const ComplexBall& x, const ComplexBall& to_high, const Piece::Point& at) const;
    /// The share above, in full contact, from the roots of the distances to where none is above, on the left, and all, on the right.
    static ComplexBall share(const ComplexBall& to_none, const ComplexBall& to_all, const Piece::Point& at);

    /// E in complex balls: a disc about 0 that holds it, indeterminate where it is not proved analytic.
    ComplexBall bounded_share(const ComplexBall& x, const ComplexBall& to_high, const ComplexBall& to_low) const;

private:
    bool full_;
    Ball load_, out_, G_; ///< out: 1 - load
    End low_, high_;
};

/// r/G
End over_G(const Exact& r, const Ball& G, const std::optional<Exact>& exact_G);

} // namespace touchstone::transfer::first_steps
