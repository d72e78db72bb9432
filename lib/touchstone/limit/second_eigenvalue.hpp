// SPDX-License-Identifier: MIT
/// \file
/// The ratio at which the fractal limit is approached, with proof: docs/limit.md, theorem 8.
#pragma once

#include "touchstone/scalar/accuracy.hpp"

#include <functional>
#include <string>
#include <vector>

namespace touchstone::limit {

struct Eigenfunction;

/// What is proven about D (eigenfunction.hpp) by a function w near its first eigenfunction.
struct EigenvalueProof {
    Ball lambda;    ///< (D w)/w at one place
    Ball defect;    ///< at least sup |(D w)' - lambda w'|/W
    Ball coupling;  ///< at least |(D k)| there, for every k that is 0 there and has |k'| <= W
    Ball remainder; ///< at least the norm of D on those k, less their part along w
};

/// The weight W of a slope at sigma = s - log(G^2/4), of r = exp(-2 sigma), and its integral over sigma up to a constant.
Ball weight_of_slopes(const Ball& r);
Ball integral_of_weight(const Ball& r);

/// What the noise beyond `last` has at most: its mass (4/pi) int sech^3 <= (32/(3 pi)) exp(-3 last), and the sizes of psi and d psi/ds
/// there, at every ratio from 0 to 4/G^2.
struct NoiseBeyond {
    Ball mass, psi, bend;
};
NoiseBeyond beyond_the_noise(const Ball& G, const Ball& last);

/// Bounds of w' on intervals, to a precision of its own.
class Slopes {
public:
    Slopes(const Ball& G, const Eigenfunction& w, slong bits);
    /// At least |w'(s)| for from <= s - log(G^2/4) <= to.
    Ball steepest(double from, double to) const;

private:
    const Eigenfunction& w;
    const slong bits;
    const Ball lowest;
    std::vector<Ball> bend; ///< d^2 w/dt^2
    Ball third;
};

/// The four numbers for any w; nothing is assumed of it. G > 2.
/// \throws BeyondReach if w is not analytic enough about the real line for its rule to be proven
EigenvalueProof prove_eigenvalue(const Ball& G, const Eigenfunction& w, Accuracy);

/// The second eigenvalue of T over its first, 1/G, for G > 2: simple and real, all others smaller. \throws BeyondReach where that is not
/// proven, which it is from G = 2.2 on (next to 2.17 two eigenvalues meet, and below they are complex)
Ball second_eigenvalue(const std::function<Ball()>& G, Accuracy);
/// One line for a person.
std::string second_eigenvalue_certificate(const std::function<Ball()>& G, Accuracy);
/// (1 - m_0(1)/G^2)/2, m_0 of area_series.hpp, which is off by about G^-4: what looks again where G is large.
Witness second_eigenvalue_to_first_order(const Ball& G);

} // namespace touchstone::limit
