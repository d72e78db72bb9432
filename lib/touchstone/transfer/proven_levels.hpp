// SPDX-License-Identifier: MIT
/// \file
/// Shares of length in contact, or above a pressure, and densities of pressure, for any G > 1 and any load, full contact included, each
/// with a proven error.
/// See proven_levels.md.
///
/// B_m(x) is the share after m + 1 scales that begin at load ratio x, the last of which is one wave's B_0; B_{m+1} = T B_m,
///
///     (T phi)(x) = (1/pi) int phi(y) dtheta,   y = P/G,   c = cos theta,   0 <= theta <= pi,
///     P = x + c  where x >= 1;   P^2 = (1 + c)(2x - 1 + c) where x < 1, and no contact where that is negative.             (T)
///
/// (x >= 1 is (2.10), x < 1 is (2.4) with c = cos 2 pi xi/lambda.) With B_0 the share in contact, A_n/lambda_0 = B_n(load) (6.7);
/// with B_0 the exceedance (2.14), (2.17) of p/p*_n, B_n(load) is that of p at scale n. In full contact B_m has singular points
/// that multiply with m. Nothing here needs to know them. V_m are piecewise polynomials found by collocation on a mesh that is halved
/// where needed, in 106 bits; what is proven, panel by panel, is D_m >= |T V_{m-1} - V_m|, and positivity of T turns those into
/// |B_m - V_m| <= sum T^(m-k) D_k.
///
/// Arithmetic: double_double.hpp, each operation within 2^-102, counted; the sums in wave_kernel.hpp.
#pragma once

#include "touchstone/scalar/accuracy.hpp"
#include "touchstone/transfer/contact.hpp"

#include <functional>
#include <memory>
#include <string>

namespace touchstone::transfer {

namespace levels {
struct Layer;
}

class ProvenLevels {
public:
    static constexpr int usual_levels = 20, most_levels = 100;
    static constexpr double finest_tolerance = 1e-25, coarsest_tolerance = 1e-5;
    static constexpr double highest_load = 1000;
    /// For tests: what V_m is made worse by on the panel y0 <= y <= y1. V_m may be anything; the proof has to see it.
    using Spoiled = std::function<double(int m, double y0, double y1)>;

    /// Shares in contact, for 0 < load <= highest <= highest_load and every scale n <= scales <= most_levels.
    /// tolerance: what the mesh is made for, 1e-25 ... 1e-5; the proven error comes out between it and 100 times that, and
    /// relative errors at scale 20 up to 1000 times.
    /// \throws BeyondReach where the mesh would be too large (G too near 1, highest too large)
    ProvenLevels(const Ball& G, double highest, double tolerance, int scales = usual_levels, const Spoiled& = {});
    /// Shares above `pressure` > 0 in units of p*_n, the same at every scale.
    ProvenLevels(const Ball& G, const Ball& pressure, double highest, double tolerance, int scales = usual_levels, const Spoiled& = {});
    /// Densities instead, -dB_m/dP: share(n, load) is q_{n+1} p*_{n+1} at P = pressure, n <= 19. Level 0 is two waves (two_waves.hpp),
    /// which wants G and pressure to some 200 bits.
    static ProvenLevels densities(const Ball& G, const Ball& pressure, double highest, double tolerance, int scales = usual_levels,
                                  const Spoiled& = {});
    ~ProvenLevels();
    ProvenLevels(ProvenLevels&&) noexcept;

    /// The share at scale n, 1 <= n <= scales.
    Ball share(long n, const Ball& load) const;
    /// The error of a share, scale by scale.
    std::string certificate(long n, const Ball& load) const;
    std::size_t memory() const;
    /// The V_m and their mesh (layer.hpp), for tests.
    const levels::Layer& layer() const;
    /// What the V_m there are to be multiplied by: a power of two, 1 but for densities.
    double unit() const { return unit_; }

    struct State; ///< internal

private:
    ProvenLevels();
    std::unique_ptr<State> state_;
    double unit_ = 1; ///< of the level's values and errors
};

/// A_n/lambda_0 (6.7), and the share above a pressure given in p*_n, or as far as 106 bits go, about 22 digits; meshes are
/// kept for later calls. 1 <= n <= most_levels, load <= highest_load. \throws BeyondReach as ProvenLevels
Ball area_by_proven_levels(long n, const Arguments&, Accuracy);
Ball exceedance_by_proven_levels(long n, const std::function<Ball()>& pressure, const Arguments&, Accuracy);
/// q_n p*_n at a pressure in p*_n, 2 <= n.
Ball density_by_proven_levels(long n, const std::function<Ball()>& pressure, const Arguments&, Accuracy);
/// The same, level by level.
std::string area_by_proven_levels_certificate(long n, const Arguments&, Accuracy);
std::string exceedance_by_proven_levels_certificate(long n, const std::function<Ball()>& pressure, const Arguments&, Accuracy);
std::string density_by_proven_levels_certificate(long n, const std::function<Ball()>& pressure, const Arguments&, Accuracy);

} // namespace touchstone::transfer
