// SPDX-License-Identifier: MIT
/// \file
/// f~: T V on a disc of complex x, V continued at each end of the wave by the polynomial of one panel. proven_levels.md, 4. Internal to
/// transfer/.
#pragma once

#include "touchstone/transfer/layer.hpp"

namespace touchstone::transfer::levels {

/// J, low <= x <= high, with a margin for the rounding of its ends.
struct Interval {
    Real low, high, x, half;
    double h;
    Interval(const Real& low_, const Real& high_)
        : low(low_), high(high_), x((low + high) * 0.5), half((high - low) * (0.5 + 0x1p-30) + 2 * bounds::u * x), h(size_of(half))
    {
    }
};

/// f~ on a disc about the middle of J.
struct Continuation {
    /// From `inner` to an end of the wave V is the polynomial of one panel.
    struct End {
        int panel = -1; ///< none: V is real up to there
        Real inner;     ///< any y of that polynomial's interval
        double gap = 0; ///< 1 - c there, resp. 1 + c, at the middle of J
        double factor = 0;   ///< |the end's part of f~| per unit of |V_e|
        double distance = 0; ///< of the arguments of V_e from its interval, in halves of that
        double overlap = 0;  ///< share of theta where V is a neighbour's polynomial, anywhere in J
    };
    End ends[2];       ///< the lower and the upper
    double middle = 0; ///< |the middle part of f~| per unit of |V|
    /// At least |f~| on the disc, of V_m.
    double bound(const Layer&, int m) const;
};

enum class Fit { yes, no, never }; ///< never: no narrower J would do

/// f~ on the disc of radius r about the middle of J, where that is known to be analytic.
Fit continue_wave(const Layer&, const Interval&, double r, Continuation&);

/// At least |f~ - V_m| on that disc, f~ of V_(m-1), V_m the polynomial of the panel J is on.
double size_on_disc(const Layer&, std::size_t panel, int m, const Interval& J, double r, const Continuation&);
/// At least |T V_(m-1) - V_m| at a point of a panel. \param next T V there \param v V_m there
double off(const Layer& V, const Result& next, std::size_t panel, int m, const Real& v);

/// At least |y'^2 - y^2| where |y' - y| <= r.
inline double square_moves(double y, double r) { return (2 * y + r) * r; }
/// At least what (1 + c)(2 x - 1 + c) moves by where x moves by r and c, no more than 1, by dc: attained at c = 1.
inline double force_moves(double x, double r, double dc) { return 2 * (2 * r + dc) + dc * (2 * x + 2 * r + dc); }
/// At least (1/pi) int |dtheta| over an end where |1 -+ c| <= g < 2: there 1 -+ c = t w, |w| <= g, 0 <= t <= 1.
inline double end_share(double g) { return 2 / bounds::pi_below * std::sqrt(g / (2 - g)); }

} // namespace touchstone::transfer::levels
