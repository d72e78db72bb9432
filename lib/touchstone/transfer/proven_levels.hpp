// SPDX-License-Identifier: MIT
/// \file
/// B_0 ... B_19 of the recursion for any G > 1 and any load, full contact included, each with a proven error. See proven_levels.md.
///
/// B_m(x) is the share of length in contact after m + 1 scales that begin at load ratio x, A_n/lambda_0 = B_n(load), B_{m+1} = T B_m,
///
///     (T phi)(x) = (1/pi) int phi(y) dtheta,   y = P/G,   c = cos theta,   0 <= theta <= pi,
///     P = x + c  where x >= 1;   P^2 = (1 + c)(2x - 1 + c) where x < 1, and no contact where that is negative.             (T)
///
/// (x >= 1 is (2.10), x < 1 is (2.4) with c = cos 2 pi xi/lambda.) In full contact B_m has singular points that multiply with m.
/// Nothing here needs to know them. V_m are piecewise polynomials found by collocation in `long double`; what is proven, panel by
/// panel, is D_m >= |T V_{m-1} - V_m|, and positivity of T turns those into |B_m - V_m| <= sum T^(m-k) D_k.
///
/// Arithmetic: +, -, *, / and sqrt of `long double`, all correctly rounded (IEC 559) and counted; no other library function.
#pragma once

#include "touchstone/transfer/contact.hpp"

#include <functional>
#include <memory>
#include <string>

namespace touchstone::transfer {

class ProvenLevels {
public:
    static constexpr int levels = 20;

    /// Serves 0 < load <= highest and every scale n <= levels.
    /// tolerance: what the mesh is made for, 1e-8 ... 1e-15; the proven error comes out about 100 times that.
    /// \throws BeyondReach where the mesh would be too large (G too near 1, highest too large)
    ProvenLevels(const Ball& G, long double highest, long double tolerance);
    ~ProvenLevels();
    ProvenLevels(ProvenLevels&&) noexcept;

    /// (6.7)  A_n/lambda_0, 1 <= n <= levels.
    Ball area(long n, const Ball& load) const;
    /// The error of an area, scale by scale.
    std::string certificate(long n, const Ball& load) const;
    std::size_t memory() const;

    struct State; ///< internal

private:
    std::unique_ptr<State> state_;
};

/// area() of the mesh that the thread's precision asks for; meshes are kept for later calls.
/// \throws BeyondReach if it asks for more than `long double` can prove
Ball area_by_proven_levels(long n, const Arguments&);
std::string proven_levels_certificate(long n, const Arguments&);

} // namespace touchstone::transfer
