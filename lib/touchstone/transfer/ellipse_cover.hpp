// SPDX-License-Identifier: MIT
/// \file
/// Equal rectangles that cover the upper half of the ellipse with foci +-1 and semiaxes (rho +- 1/rho)/2: a function is bounded
/// on it by its bounds on discs about them. What that bound says of Gauss's rule.
///
/// Internal to transfer/.
#pragma once

#include "touchstone/transfer/level_bounds.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <vector>

namespace touchstone::transfer {

/// Half of what the ellipse is wide.
constexpr double semi_axis(double rho) { return (rho + 1 / rho) / 2; }

/// Of an interval of numbers of 106 bits: at least half its length, and the radius of a disc about its middle that holds its ellipse.
struct Surroundings {
    double half, radius;
    Surroundings(const DoubleDouble<double>& low, const DoubleDouble<double>& high, double rho)
        : half(levels::magnitude(high - low) / 2), radius(half * semi_axis(rho))
    {
    }
};

struct EllipseCover {
    double half_width, half_height; ///< of each rectangle
    std::vector<std::complex<double>> middles;

    /// A rectangle is left out if its point next to 0 is outside of the ellipse, by more than roundings.
    EllipseCover(double rho, int columns, int rows)
    {
        constexpr double outside = 1.001;
        const double wide = semi_axis(rho), high = (rho - 1 / rho) / 2;
        half_width = wide / columns;
        half_height = high / (2 * rows);
        for (int i = 0; i < columns; ++i)
            for (int k = 0; k < rows; ++k) {
                const std::complex<double> middle((2 * i + 1) * half_width - wide, (2 * k + 1) * half_height);
                const double x = std::max(0.0, std::fabs(middle.real()) - half_width) / wide, y = (middle.imag() - half_height) / high;
                if (x * x + y * y <= outside) middles.push_back(middle);
            }
    }

    /// Above |f| on the ellipse about mid +- half, f real on the real line, where most(c, r) is above |f| on the disc |z - c| <= r;
    /// infinite where that is for any of the discs.
    template <class Most>
    double bound(double mid, double half, const Most& most) const
    {
        const double radius = half * std::hypot(half_width, half_height) * bounds::margin;
        double all = 0;
        for (const std::complex<double>& middle : middles) {
            const double here = most(mid + half * middle, radius);
            if (!(here < bounds::infinite)) return bounds::infinite;
            all = std::max(all, here);
        }
        return bounds::margin * all;
    }
};

/// Gauss-Legendre with so many nodes on [-1, 1] errs by at most this, per unit of the integrand's bound on the ellipse:
/// 64/15 rho^(-2(N-1))/(1 - rho^-2) (proven_levels.md, section 2).
inline double gauss_error(double rho, std::size_t nodes)
{
    return 64.0 / 15 / (std::pow(rho, 2.0 * static_cast<double>(nodes) - 2) * (1 - 1 / (rho * rho)));
}

/// What an integral over an interval changes by at most when each node of a rule with positive weights is off by as much as `off`: M bounds
/// the integrand on the disc of radius r about the middle, so that its slope within `off` of the interval is at most M/(r - half - off), by
/// Cauchy's bound.
inline double moved_nodes_error(double half, double off, double r, double M) { return 2 * half * off * (M / (r - half - off)); }

} // namespace touchstone::transfer
