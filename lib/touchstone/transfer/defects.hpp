// SPDX-License-Identifier: MIT
/// \file
/// How far piecewise polynomials V_m, any at all, are from B_m = T B_(m-1): D_m >= |T V_(m-1) - V_m|, panel by panel, and what they add up
/// to. proven_levels.md, 1, 3 to 5. Internal to transfer/ and limit/.
#pragma once

#include "touchstone/transfer/collocation.hpp"

#include <mutex>
#include <vector>

namespace touchstone::transfer::levels {

/// Chebyshev points of an interval inside a disc whose radius is (rho + 1/rho)/2 of its half width.
struct Check {
    double rho, spread, tail, lebesgue;
    ChebyshevPoints points;
    /// |f| <= lebesgue max |f at the points| + tail K where |f| <= K on the ellipse, the points moved by rounding: md, 4
    Check(int count, double rho_)
        : rho(rho_)
        , spread((rho + 1 / rho) / 2 * bounds::margin)
        , tail(0)
        , lebesgue(1.01 * (1 + 2 / bounds::pi_below * std::log(count)))
        , points(count)
    {
        tail = bounds::margin * 2 * (1 + lebesgue) / (power(rho, count - 1) * (rho - 1));
    }
    /// At least a function that is within `apart` of an f with |f| <= between/tail on the ellipse, and at most `most` at the points.
    double anywhere(double most, double apart, double between) const
    {
        return bounds::margin * (lebesgue * (most + apart) + apart + between);
    }
};

/// The larger, and infinite where v is not a number: nothing is known then.
inline void raise(double& bound, double v) { bound = v <= bounds::infinite ? std::max(bound, v) : bounds::infinite; }

/// The rho of the Bernstein ellipse through focal sum 2(1 + d): what lies within d of [-1, 1] lies inside.
inline double ellipse_of_distance(double d) { return 1 + d + std::sqrt(d * (2 + d)); }

/// Where a defect is known.
struct Part {
    double defect, width;
    Real y0, y1;
    bool on_average; ///< defect is no bound, but what counts for one
};

/// The least of d + sum over the parts with a defect above d, and those known on average only, of that times their weight;
/// the largest defects come first.
template <class Weight>
double least_sum(const std::vector<Part>& parts, const Weight& weight)
{
    double rest = 0; // of those known on average
    for (const Part& p : parts)
        if (p.on_average) rest += p.defect * weight(p);
    double best = bounds::infinite, above = 0;
    for (const Part& p : parts) {
        best = std::min(best, above + p.defect + rest);
        if (!p.on_average) above += p.defect * weight(p);
    }
    return std::min(best, above + rest);
}

/// At least T^k 1 on 0 < x <= highest, k = 0 ... steps: wave::after_steps. \param G at most the true one
std::vector<double> mass_after_steps(double G, double highest, int steps);

/// At least what V_m's polynomial of a panel changes by on its interval, where z changes by dz.
double change_of(const Layer&, std::size_t panel, int m, double dz);

/// [panel * V.count + m], m + 1 < levels: at least |V_e - V_n|, the polynomials of a panel e and of any other n, on n's part of e's
/// interval.
std::vector<double> overlap_defects(const Rules&, const Layer& V, int levels);

/// At least mu_x([y0, y1]) for low <= x <= high, on one side of 1.
double share_of(const Real& G, const Real& low, const Real& high, const Real& y0, const Real& y1);

class Defects {
public:
    /// \param monotone whether B_0, and B_m with it, increases from 0 to 1 and is at most x^(1/2)
    Defects(const Rules&, const Layer& V, int levels, double tolerance, bool monotone);

    /// |B_0 - V_0|.
    void prove_level_zero(const First&);
    /// |T V_(m-1) - V_m|, 1 <= m < levels.
    void prove_steps();
    /// What T of them adds up to.
    void add_up();

    /// Bounds T D_m on all x from which no ratio above `reach` is met.
    double effect(int m, double reach) const;
    /// Bounds T^2 D_m, where no ratio above `reach` is met and none below the first panel matters.
    double second_effect(int m, double reach) const;
    /// Bounds T D_0 at the x between low and high.
    double effect_at(const Real& low, const Real& high) const;
    /// Bounds what T V_m changes by between x (1 - 4 u) and x (1 + 4 u).
    double blur(int m, const Real& x) const;
    /// The panels and holes of level m up to `reach`, the largest defects first.
    std::vector<Part> parts(int m, double reach) const;

private:
    friend class StepOnPanel;
    static constexpr int most_intervals = 20'000; ///< of x, on one panel

    /// From an analytic function's values; of what increases, from those at the ends, of T V_(m-1) where T B_(m-1) is meant; or only what
    /// counts for a bound.
    enum class Known { by_values, by_monotony, on_average };
    /// Where |B_m - T V_(m-1)| is not bounded by `defect`. In all else a panel.
    struct Hole {
        Real low, high;
        double defect;
        Known known;
    };

    /// Late levels are small all over: what their defects should be.
    double tolerance_of(int m) const { return tolerance * std::min(1.0, V.largest[static_cast<std::size_t>(m)]); }
    std::size_t at(std::size_t panel, int m) const { return panel * static_cast<std::size_t>(columns) + static_cast<std::size_t>(m); }
    /// The part of x that is proven with a panel: a thousandth of its width beyond it too.
    std::pair<Real, Real> domain_of(std::size_t panel) const;
    void prove_first(const First&, std::size_t panel);
    void prove_panel(std::size_t panel, const std::vector<double>& overlap_defect);
    void add_hole(int m, const Real& low, const Real& high, double defect, Known = Known::by_values);
    /// What is known on a part of a panel: what is large is kept apart where the part is much narrower.
    void found(int m, const Real& low, const Real& high, std::size_t panel, double defect, Known = Known::by_values);

    const Rules& rules;
    const Layer& V;
    int levels, columns;
    double tolerance;
    bool monotone;
    double smallest_part; ///< of a panel's width; what increases changes by that much on it, and counts with the root of its width
    std::vector<Check> checks;
    Check first_check;                  ///< of B_0, whose bound on a disc may be far above its size
    std::vector<double> defect;         ///< [panel * columns + m]: at least |T V_{m-1} - V_m|, resp. |B_0 - V_0|
    std::vector<char> by_monotony;      ///< [panel]: whether that was used there
    std::vector<double> sum_of_effects; ///< [m]: at least T |B_m - V_m|
    std::vector<std::vector<Hole>> holes; ///< [m]
    std::mutex holes_mutex;
};

} // namespace touchstone::transfer::levels
