// SPDX-License-Identifier: MIT
/// \file
/// The density of pressure after two waves, as a function of the load ratio of the first: the level from which the proof of densities with
/// full contact starts (proven_levels.md, section 5).
///
///     D_1(x) = int k(x, y) d(y) dy,   k dy = dtheta/pi of the first wave (T),   d = -dF/dP of the second, (2.19):
///     d(y) = (1/pi) ((y - P + 1)(P + 1 - y))^(-1/2)                                          y >= 1
///          = P/(2 pi R) ((1 + y + R)/(1 - y + R))^(1/2) (y - P^2/4)^(-1/2),  R^2 = (1-y)^2 + P^2,   y < 1.
///
/// Both have inverse square roots at the ends of their supports; where two of those ends meet, D_1 has a logarithm (two lower or two upper
/// ends) or a jump. Pieces between the ends and the seam y = 1 are cut in the middle. In each half, with s the singular point next to its
/// end and delta the distance to the one after it, y - s = delta (tau - 1/tau)^2/4 turns dy/((y-s)(y-s+delta))^(1/2) into 2 dtau/tau:
/// analytic however small delta is, and tau grows over few doublings. All distances are differences of ends taken in 256 bits, plus
/// positive terms: x may be as near to a singular point as 106 bits can say.
///
/// Internal to transfer/.
#pragma once

#include "touchstone/scalar/ball.hpp"
#include "touchstone/transfer/wide_balls.hpp"

#include <memory>
#include <utility>
#include <vector>

namespace touchstone::transfer {

/// What of d(y) and of k(x, y) TwoWaves::weight_on counts with.
namespace second_wave {
struct Root {
    double at, factor; ///< factor |y - at|^(-1/2)
};
struct Bound {
    std::vector<Root> roots;
    double elsewhere; ///< is to be added
};
/// d(y) is at most the sum of these, all over the support of the second wave, for P >= 1/2.
Bound bound(double P);
/// For P < 1/2: d(y) <= at_lower P |y - P^2/4|^(-1/2) up to y = 3/2 (P^2/4), below_half P |y - P^2/4|^(-1/2) up to 1/2,
/// about_one P R^(-3/2) up to 1, and at_top |y - P - 1|^(-1/2) beyond.
inline constexpr double at_lower = 0.2, below_half = 0.52, about_one = 0.434, at_top = 0.26;
/// k(x, y) <= this |y - e|^(-1/2), e the end of the first wave next to y, for y >= s/2.
double first_wave(double G, double x, double s);
} // namespace second_wave

class TwoWaves {
public:
    using Real = DoubleDouble<double>;

    /// G > 1, pressure > 0 in units of p*_n. \param tolerance of the quadrature
    TwoWaves(const Ball& G, const Ball& pressure, double tolerance);
    ~TwoWaves();
    TwoWaves(TwoWaves&&) noexcept;

    /// D_1 is 0 for x below this.
    double lowest() const;
    /// D_1(x), and a bound of its error: infinite where x is too near to a singular point.
    std::pair<Real, double> value(const Real& x) const { return value(to_ball(x)); }
    /// The same at an x known to 250 bits, which may be nearer still to a singular point, or to 1.
    std::pair<Real, double> value(const Ball& x) const;
    /// At least |D_1| on the disc of radius r about x, of the function that is D_1 on low <= .. <= high; infinite where it may not be
    /// analytic there.
    double on_disc(const Real& low, const Real& high, const Real& x, double r) const
    {
        return low < 1 && high > 1 ? bounds::infinite : on_disc(low >= 1, to_ball(x), r);
    }
    /// The same where all that counts of the disc is on one side of x = 1.
    double on_disc(bool above_one, const Ball& x, double r) const;
    /// What D_1 counts for on an interval of the given width, from x on, that may hold singular points: its integral over the interval
    /// against a measure is at most this times s(width), if the measure gives at most s(l) to sets of length l, and s(l)/l^(1/2) does not
    /// decrease.
    double weight_on(double x, double width) const;

    struct Ends;

private:
    std::unique_ptr<const Ends> ends_;
};

} // namespace touchstone::transfer
