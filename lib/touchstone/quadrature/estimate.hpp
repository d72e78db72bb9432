// SPDX-License-Identifier: MIT
/// \file
/// Tanh-sinh quadrature in `double` and `Mpfr`: fast, and only estimated.
///
///     const auto I = estimate<double>([](double x, double l, double r) { return std::sqrt(r); }, Interval::finite(0, 1));
///
/// The integrand gets x and its distances to both ends (see interval.hpp), each with full
/// relative accuracy down to the smallest normal number, so that x^-0.9 or 1/sqrt(1 - x)
/// lose nothing at the ends.
///
/// Errors: none is proved. In `double` the rule is Boost.Math's tanh_sinh (measured to be the
/// faster one), and `error` is what it says, the difference of its last two levels. In `Mpfr`
/// the rule is ours (faster at 50 and 300 digits, and cached for every precision in use):
/// levels h = 1/2, 1/4, ... are added until the differences shrink as those of a
/// double-exponential rule do, and `error` is extrapolated from them. Either way the result is
/// `estimated`: where two levels agree by accident it is wrong. Use tanh_sinh() where that matters.
/// Cost: abscissas and weights are computed once per process (`double`), or per thread and
/// precision (`Mpfr`); then one evaluation of f a node.
#pragma once

#include "touchstone/quadrature/interval.hpp"
#include "touchstone/scalar/mpfr.hpp"

#include <boost/math/quadrature/tanh_sinh.hpp>

#include <map>
#include <memory>
#include <vector>

namespace touchstone::quadrature {

template <class Real>
struct Estimated {
    Real value;
    Real error;       ///< estimated, not proved
    Real magnitude;   ///< estimate of the integral of |f|
    long evaluations = 0;
    bool converged = false; ///< whether error reached the tolerance
    static constexpr const char* status = "estimated";
};

namespace detail {

template <class Real>
struct RealArithmetic;

template <>
struct RealArithmetic<double> {
    static double read(const Endpoint& e)
    {
        return e.exact() ? nearest_double(*e.exact()) : arf_get_d(arb_midref(e.ball().get()), ARF_RND_NEAR);
    }
    static double epsilon() { return std::numeric_limits<double>::epsilon(); }
};

template <>
struct RealArithmetic<Mpfr> {
    static Mpfr read(const Endpoint& e)
    {
        const WorkingPrecision precision(precision_key() + 8);
        const Ball b = e.ball();
        Mpfr r;
        arf_get_mpfr(r.backend().data(), arb_midref(b.get()), MPFR_RNDN);
        return r;
    }
    static long precision_key() { return static_cast<long>(mpfr_get_prec(Mpfr(0).backend().data())); }
    static Mpfr epsilon()
    {
        Mpfr e(1);
        mpfr_mul_2si(e.backend().data(), e.backend().data(), 1 - precision_key(), MPFR_RNDN);
        return e;
    }
    /// Exponents of the ends down to about 1/20 are resolved.
    static double log_smallest() { return -20 * M_LN2 * static_cast<double>(precision_key()) - 100; }
    static Mpfr from_double(double x) { return Mpfr(x); }
};

/// The nodes that level j adds: t = 0, 1/2, 1, ... (j = 0), then odd multiples of 2^-(j+1).
template <class Real>
struct LevelNode {
    Real near, far; ///< distances as fractions: E/(1 + E), 1/(1 + E), E = exp(-pi sinh t)
    Real weight;    ///< pi cosh(t) near far
};

template <class Real>
const std::vector<LevelNode<Real>>& level(int j)
{
    using std::cosh;
    using std::exp;
    using std::sinh;
    using A = RealArithmetic<Real>;
    thread_local std::map<std::pair<long, int>, std::vector<LevelNode<Real>>> cache;
    std::vector<LevelNode<Real>>& nodes = cache[{A::precision_key(), j}];
    if (!nodes.empty()) return nodes;
    const Real pi = touchstone::pi<Real>();
    const double step = std::ldexp(1.0, -(j + 1));
    const double last = std::asinh(-A::log_smallest() / M_PI);
    for (double t = j == 0 ? 0 : step; t < last; t += j == 0 ? step : 2 * step) {
        const Real exp_t = exp(A::from_double(t)), inverse = 1 / exp_t;
        const Real e = exp(Real(-pi * (exp_t - inverse) / 2));
        const Real far = 1 / (1 + e), near = e * far;
        nodes.push_back({near, far, Real(pi * (exp_t + inverse) / 2 * near * far)});
    }
    return nodes;
}

template <class F>
Estimated<double> boost_estimate(F&& f, const Interval& interval, double tolerance)
{
    static boost::math::quadrature::tanh_sinh<double> rule;
    const double a = RealArithmetic<double>::read(interval.left()), b = RealArithmetic<double>::read(interval.right());
    Estimated<double> result{std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(), 0.0};
    // Boost hands over the signed distance to the nearer end: negative on the left.
    // On an infinite interval x and dx/du overflow further out; what is cut off is (1e-150)^beta.
    const double closest = interval.is_finite() ? 0 : 1e-150;
    auto g = [&](double, double nearest) -> double {
        ++result.evaluations;
        if (std::fabs(nearest) < closest) return 0;
        const auto p = nearest < 0 ? interval.at_real(a, b, -nearest, 1 + nearest) : interval.at_real(a, b, 1 - nearest, nearest);
        return f(p.x, p.left, p.right) * p.slope;
    };
    try {
        double difference = 0;
        std::size_t levels = 0;
        result.value = rule.integrate(g, 0.0, 1.0, std::max(std::sqrt(RealArithmetic<double>::epsilon()), tolerance), &difference,
                                      &result.magnitude, &levels);
        result.error = difference + 8 * RealArithmetic<double>::epsilon() * result.magnitude;
        result.converged = true;
    }
    catch (const std::exception&) { // Boost's word for a value that is not finite, or no convergence
    }
    return result;
}

template <class Real, class F>
Estimated<Real> own_estimate(F&& f, const Interval& interval, Real tolerance, int levels)
{
    using std::abs;
    using std::isfinite;
    using std::sqrt;
    using A = detail::RealArithmetic<Real>;
    const Real a = A::read(interval.left()), b = A::read(interval.right());
    const Real floor = A::epsilon() * 4;
    if (tolerance < floor) tolerance = floor;
    Estimated<Real> result{Real(0), Real(0), Real(0)};
    Real sum(0), absolute(0), cut(0), previous(0), difference(1);

    const auto value_at = [&](const Real& u, const Real& r, const Real& weight) {
        const auto p = interval.at_real(a, b, u, r);
        ++result.evaluations;
        return Real(f(p.x, p.left, p.right) * p.slope * weight);
    };
    // how far along the nodes either side still matters, in t
    double reach[2] = {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    for (int j = 0; j < levels; ++j) {
        const double h = std::ldexp(1.0, -(j + 1)), stride = j == 0 ? h : 2 * h;
        const auto& nodes = level<Real>(j);
        for (int side = 0; side < 2; ++side) {
            double t = j == 0 ? 0 : h;
            int small = 0;
            for (std::size_t i = 0; i < nodes.size() && t <= reach[side]; ++i, t += stride) {
                if (side == 1 && j == 0 && i == 0) continue;
                const auto& n = nodes[i];
                const Real term = side == 0 ? value_at(n.far, n.near, n.weight) : value_at(n.near, n.far, n.weight);
                if (!isfinite(term)) {
                    result.value = result.error = std::numeric_limits<Real>::quiet_NaN();
                    return result;
                }
                sum += term;
                const Real size = abs(term);
                absolute += size;
                if (j == 0) { // set the reach where two terms in a row have died away
                    small = size <= absolute * A::epsilon() / 1000 ? small + 1 : 0;
                    if (small == 2) reach[side] = t;
                    if (i + 1 == nodes.size()) cut += size;
                }
            }
        }
        const Real step = A::from_double(h);
        const Real value = step * sum;
        result.magnitude = step * absolute;
        const Real last = difference;
        difference = result.magnitude > 0 ? Real(abs(value - previous) / result.magnitude) : Real(0);
        previous = value;
        result.value = value;
        if (j < 2) continue;
        // A double-exponential rule about doubles its digits with each level: claim half of that.
        const bool quadratic = difference * difference <= last * last * last;
        const Real predicted = quadratic ? Real(difference * sqrt(difference)) : difference;
        result.error = result.magnitude * (predicted + 16 * floor) + step * cut; // 64 ulp for rounding
        if (predicted <= tolerance) {
            result.converged = step * cut <= tolerance * result.magnitude;
            break;
        }
    }
    return result;
}

} // namespace detail

/// The integral of f over the interval, to about `tolerance` relative to the integral of |f|
/// (by default what the type can carry). NaN and not converged if f is not finite at a node.
template <class Real, class F>
Estimated<Real> estimate(F&& f, const Interval& interval, Real tolerance = Real(0), int levels = 16)
{
    if constexpr (std::same_as<Real, double>) return detail::boost_estimate(f, interval, tolerance);
    else return detail::own_estimate<Real>(f, interval, tolerance, levels);
}

} // namespace touchstone::quadrature
