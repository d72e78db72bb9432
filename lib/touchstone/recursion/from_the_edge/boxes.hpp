// SPDX-License-Identifier: MIT
/// \file
/// The plane of d = log(e_k/x_k), the distance from the edge, cut into boxes by direction and shell, and bounds over discs. Internal to
/// from_the_edge/.
#pragma once

#include "touchstone/scalar/ball.hpp"
#include "touchstone/transfer/disc.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <initializer_list>
#include <limits>
#include <vector>

namespace touchstone::transfer::from_the_edge {

using C = ComplexBall;
using Traits = ScalarTraits<Ball>;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr slong bound_bits = 40;
/// Covers the rounding of a few `double` operations on bounds and polar coordinates.
constexpr double slack = 1e-9;
/// A point may lie outside its panel by a relative 1e-15 of it: polynomials and errors there grow by (1 + 5e-8)^points at most.
constexpr double at_panel_end = 1e-5;
/// No bound is kept below this: a product of two that underflows would otherwise claim that nothing is lost.
constexpr double smallest_bound = 1e-300;
/// Above, the tolerances, 1e-6 e^-accuracy and less, would come down to smallest_bound.
constexpr double most_accuracy = 660;

inline double up(double bound) { return bound * (1 + slack); }
inline double down(double bound) { return bound * (1 - slack); }
inline double up_at_end(double bound) { return bound * (1 + at_panel_end); }

double product_of_bounds(std::initializer_list<double> factors);

double above(const Ball& x);
inline double about(const Ball& x) { return arf_get_d(arb_midref(x.get()), ARF_RND_NEAR); }

double at_most_modulus(const Disc& z);
double at_least_modulus(const Disc& z);

/// Whether z may touch (-inf, 0].
bool meets_cut(const Disc& z);

/// Whether E(D) may touch (-inf, 0], mean an enclosure of it. It does not where Re D > 0: there |arg D| < pi/2, and |e^-D| < 1 makes
/// |arg(1 - e^-D)| < pi/2, so |arg E(D)| < pi. Its zeros, D = 2 pi i k, are on the imaginary axis.
inline bool mean_meets_cut(const Disc& D, const Disc& mean) { return !(D.centre().real() > D.radius()) && meets_cut(mean); }

Disc disc(double re, double im, double radius);
/// That holds the ball, or all real numbers between two.
Disc disc(const Ball& x);
Disc disc_over(double from, double to);

/// That holds inner <= |d| <= outer, from <= arg d <= to, about its middle: its rim goes through the two corners farther out, the farthest
/// points, since |rho e^(i phi) - r|^2 = (rho - r)^2 + 4 rho r sin^2(phi/2).
Disc disc_about(double inner, double outer, double from, double to);

/// Half the height of the ellipse rho, over half the distance of its foci.
inline double ellipse_height(double rho) { return (rho - 1 / rho) / 2; }

/// About the point of the ellipse with foci mid +- half whose angle is in the middle of the i-th of so many parts of (0, pi): together they
/// cover the upper half of the ellipse, |dz| <= half (rho + 1/rho)/2 |d phi|.
struct Arc {
    double x, y, radius;
};
Arc arc_of_ellipse(double mid, double half, double rho, int i, int arcs);

/// A bound of f on a box: of the disc about it, or the largest of its quarters' where that has none, so often.
double over_box(double inner, double outer, double from, double to, int depth, const std::function<double(const Disc&)>& f);

/// sin^2 theta in [s0, s1], cos^2 theta in [c0, c1] for 0 <= a <= theta <= b <= pi/2.
struct Sector {
    double s0, s1, c0, c1;
};
Sector sector(double a, double b);

/// E(z) = (1 - e^-z)/z; |E - 1| <= sum |z|^k/(k+1)! = (e^|z| - 1 - |z|)/|z|.
Disc exponential_mean(const Disc& z);

/// |1/E(D)| for |D| <= size, cos(arg D) >= cosine > 0, but for rounding: D + D/(e^D - 1), and |e^D - 1| >= e^Re D - 1 >= Re D.
double inverse_mean(double size, double cosine);

/// |R^2/(1 - x)^2 - 1| for |x| <= e < 1 and Re d at least the real part: R^2 = (1 - x)^2 + 4 e exp(-2d), attained by x = e.
double root_departure(double e, double real_part);

// ---- the plane of d, cut into boxes by direction (arg d, symmetric) and shell (|d|)

constexpr std::array directions{0.0, 0.02, 0.05, 0.1, 0.16, 0.23, 0.31, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0,
                                1.1, 1.2,  1.3,  1.4, 1.5,  1.57, 1.75, 2.0, 2.3, 2.7, 3.1416};
constexpr int n_directions = static_cast<int>(directions.size()) - 1;

/// Shell 0 is |d| <= inner, shell j up to radius(j) = inner 2^(j/density).
class Shells {
public:
    static constexpr int density = 6;
    Shells(double inner, double outer) : inner_(inner), count_(static_cast<int>(std::ceil(density * std::log2(outer / inner)))) {}
    int count() const { return count_; } ///< shells 0 ... count
    double radius(int j) const { return inner_ * std::exp2(static_cast<double>(j) / density); }
    /// The shell of |d| = r; callers widen r by more than this rounds.
    int shell(double r) const { return r <= inner_ ? 0 : std::max(0, static_cast<int>(std::ceil(density * std::log2(r / inner_)))); }

private:
    double inner_;
    int count_;
};

/// Bounds of |u| on the boxes; infinite where nothing is proven.
struct Boxes {
    std::vector<double> bound; ///< [shell][direction]
    std::vector<double> far;   ///< |u| <= far |d|^(1/2) outside the last shell, by direction
    int disc = 0;              ///< shells up to this one form one full disc
    double& at(int j, int m) { return bound[static_cast<std::size_t>(j) * n_directions + static_cast<std::size_t>(m)]; }
    double at(int j, int m) const { return bound[static_cast<std::size_t>(j) * n_directions + static_cast<std::size_t>(m)]; }
    /// In direction m, of the shells from one to another.
    double largest(int from, int to, int m) const
    {
        double most = 0;
        for (int j = from; j <= to; ++j) most = std::max(most, at(j, m));
        return most;
    }
};

struct PolarRange {
    double inner, outer, from, to; ///< |d|, |arg d|
};

/// What a disc about (re, im) of this radius covers.
PolarRange polar(double re, double im, double radius);
PolarRange polar(const Disc& z);

} // namespace touchstone::transfer::from_the_edge
