// SPDX-License-Identifier: MIT
#include "touchstone/transfer/level_zero.hpp"

#include "touchstone/wave/wave.hpp"

#include <algorithm>
#include <cmath>

namespace touchstone::transfer::levels {

using std::max, std::min;
using namespace bounds;

namespace {

/// A function known in balls.
struct Share : First {
    virtual Ball at(const Ball& x) const = 0;
    std::pair<Real, double> value(const Real& x) const override
    {
        const WorkingPrecision precision(160);
        const Ball b = at(to_ball(x));
        const Real nearest = to_real(b);
        return {nearest, b.radius_bound() + 2 * u * max(1.0, std::fabs(nearest.high))}; // forces grow with x
    }
};

/// |arccos w| = |int_w^1 (1 - t^2)^(-1/2) dt| <= 2|1 - w|^(1/2) where Re w >= 0, along the straight line; so where |1 - w| <= 1.
double arccos_bound(double from_one) { return from_one <= 1 ? 2 * std::sqrt(from_one) : infinite; }

/// (2/pi) arcsin x^(1/2), 1 from x = 1 on.
struct InContact : Share {
    bool is_area() const override { return true; }
    Ball at(const Ball& x) const override { return certainly(less(x, Ball(1))) ? 2 * asin(sqrt(x)) / pi<Ball>() : Ball(1); }
    Bounds on_disc(const Real& low, const Real&, const Real& x, double r) const override
    {
        if (low >= 1) return {1, 0};
        const double x_ = double(x), to_one = double(1 - x);
        if (!(r * margin < to_one && r * margin < x_)) return {infinite, infinite};
        // |arcsin w| <= (pi/2)|w| where |w| <= 1, and |1 - x^(1/2)| <= |1 - x|
        return {margin * std::sqrt(x_ + r), margin * 2 / pi_below * arccos_bound(min(1.0, to_one + r))};
    }
};

/// (2.17), (2.14): the exceedance of one wave, (1/pi) arccos w, w = P - x where x >= 1, w = R - x, R^2 = (1 - x)^2 + P^2, where P^2/4 <= x
/// < 1. It is analytic between low_end, 1 and high_end; from the left of 1 so far as R is. w is real for real x only: x = (1 + P^2 -
/// w^2)/(2(1 + w)).
struct Exceeding : Share {
    explicit Exceeding(const Ball& P_)
        : P(P_)
        , low_end(to_real(ends_of_exceeding(P_).first))
        , high_end(to_real(ends_of_exceeding(P_).second))
    {
    }
    Ball at(const Ball& x) const override
    {
        const auto full = [&] { return share(1 + x - P, 1 - x + P); };
        if (!certainly(less(x, Ball(1)))) return full(); // the two agree at 1
        const Ball R = sqrt((1 - x) * (1 - x) + P * P);
        return share((4 * x - P * P) / (1 + x + R), 1 - x + R);
    }
    Bounds on_disc(const Real& low, const Real& high, const Real& x, double r) const override
    {
        constexpr Bounds nothing{0, 1}, everything{1, 0}, unknown{infinite, infinite};
        const double pressure = double(to_real(P)), from_low = double(x - low_end), to_high = double(high_end - x), to_one = double(1 - x),
                     safe = r * margin;
        if (high <= low_end * Real{1, -4 * u}) return nothing;
        if (low >= high_end * Real{1, 4 * u}) return everything;
        if (!(safe < from_low)) return unknown;
        // |arccos w|^2 <= pi^2 + log^2(2|w| + 2)
        const auto either = [](double modulus, double other) {
            return margin * min(std::hypot(pi_below, std::log(2 * modulus + 2)), other) / pi_below;
        };
        if (low >= 1) {
            if (!(safe < to_high)) return unknown;
            const double w = std::fabs(pressure - double(x)) + r;
            return {either(w, arccos_bound(margin * (double(x + 1 - to_real(P)) + r))), either(w, arccos_bound(margin * (to_high + r)))};
        }
        if (high > 1 || !(safe < double(x)) || !(safe < std::hypot(to_one, pressure))) return unknown;
        const double w = std::fabs(to_one) + pressure + double(x) + 2 * r; // |1 - w| = |4x - P^2|/|1 + x + R|, the denominator above 1
        return {either(w, arccos_bound(margin * 4 * (from_low + r))), either(w, infinite)};
    }

private:
    Ball share(const Ball& one_minus_w, const Ball& one_plus_w) const
    {
        Ball sine, cosine;
        arb_sqrtpos(sine.get(), one_minus_w.get(), WorkingPrecision::bits());
        arb_sqrtpos(cosine.get(), one_plus_w.get(), WorkingPrecision::bits());
        if (certainly(less(one_minus_w, Ball(0)))) return Ball(0);
        return 2 * atan2(sine, cosine) / pi<Ball>();
    }
    Ball P;
    Real low_end, high_end; ///< below the one it is 0, from the other on 1; within 2 u
};

/// (2.2), (2.4): the integral of P dtheta/pi over pressures above P. x >= 1: (x theta + sin theta)/pi, cos theta = P - x. x < 1, in units
/// of force (wave::equilibrium): (2x/pi)(psi + sin psi cos psi), v = sin^2 psi = (4x - P^2)/(2x(1 + x + R)), where P^2 = 4x (1 - v)(1 - x
/// v). v is real and outside (0, 1) for real x only, for that is a quadratic equation in x of positive discriminant then: so no branch of
/// arcsin or of the roots is crossed.
struct ForceAbove : Share {
    explicit ForceAbove(const Ball& P_)
        : P(P_)
        , low_end(to_real(ends_of_exceeding(P_).first))
        , high_end(to_real(ends_of_exceeding(P_).second))
    {
    }
    Ball at(const Ball& x) const override
    {
        if (!certainly(less(x, Ball(1)))) {
            const Ball theta = 2 * atan2(root(1 + x - P), root(1 - x + P));
            return certainly(less(P + 1, x)) ? x
                                             : (x * theta + root((1 + x - P) * (1 - x + P))) / pi<Ball>(); // the two agree where x = P + 1
        }
        const Ball R = sqrt((1 - x) * (1 - x) + P * P), v = (4 * x - P * P) / (2 * x * (1 + x + R));
        if (certainly(less(v, Ball(0)))) return Ball(0);
        const Ball sine = root(v), cosine = P / (2 * sqrt(x * (1 - x * v)));
        return 2 * x * (atan2(sine, cosine) + sine * cosine) / pi<Ball>();
    }
    Bounds on_disc(const Real& low, const Real& high, const Real& x, double r) const override
    {
        constexpr Bounds unknown{infinite, infinite};
        const double x_ = double(x), pressure = double(to_real(P)), safe = r * margin, modulus = margin * (x_ + r);
        if (high <= low_end * Real{1, -4 * u}) return {0, infinite};
        if (low >= high_end * Real{1, 4 * u}) return {modulus, infinite};
        if (!(safe < double(x - low_end))) return unknown;
        if (low >= 1) { // |arccos w|^2 <= pi^2 + log^2(2|w| + 2), |sin theta| <= 1 + |w|
            if (!(safe < double(high_end - x))) return unknown;
            const double w = std::fabs(pressure - x_) + r;
            return {margin * (modulus * std::hypot(pi_below, std::log(2 * w + 2)) + 1 + w) / pi_below, infinite};
        }
        if (high > 1 || !(safe < x_) || !(safe < std::hypot(double(1 - x), pressure))) return unknown;
        // Re(1 + x + R) > 1; |arcsin z|^2 <= (pi/2)^2 + log^2(2|z| + 2)
        const double v = margin * (2 + pressure * pressure / (2 * (x_ - safe)));
        return {margin * 2 * modulus / pi_below * (std::hypot(pi_below / 2, std::log(2 * std::sqrt(v) + 2)) + std::sqrt(v * (1 + v))),
                infinite};
    }

private:
    static Ball root(const Ball& x)
    {
        Ball r;
        arb_sqrtpos(r.get(), x.get(), WorkingPrecision::bits());
        return r;
    }
    Ball P;
    Real low_end, high_end;
};

} // namespace

std::pair<Ball, Ball> ends_of_exceeding(const Ball& P) { return {certainly(less(P, Ball(2))) ? P * P / 4 : P - Ball(1), P + Ball(1)}; }
std::vector<Ball> singular_points_of_density(const Ball& G, const Ball& pressure)
{
    std::vector<Ball> all;
    const auto [low, high] = ends_of_exceeding(pressure);
    for (const Ball& s : {low, high}) {
        const Ball down = wave::meets_upper_end_full(s, G); // a ball that cannot tell which side of 1 it is on: both forms give 1
        all.push_back(wave::meets_lower_end(s, G));
        all.push_back(certainly(less(down, Ball(1))) ? wave::meets_upper_end_partial(s, G) : down);
    }
    return all;
}
std::unique_ptr<const First> force_above(const Ball& pressure) { return std::make_unique<ForceAbove>(pressure); }
std::unique_ptr<const First> in_contact() { return std::make_unique<InContact>(); }
std::unique_ptr<const First> exceeding(const Ball& pressure) { return std::make_unique<Exceeding>(pressure); }

Density::Density(const Ball& G, const Ball& pressure, double unit_, double tolerance)
    : waves(G, pressure, tolerance * unit_)
    , unit(unit_)
{
}

std::pair<Real, double> Density::value(const Real& x) const
{
    const auto [v, error] = waves.value(x);
    return {v / unit, error / unit};
}
First::Bounds Density::on_disc(const Real& low, const Real& high, const Real& x, double r) const
{
    return {waves.on_disc(low, high, x, r) / unit, infinite};
}
double Density::weight_on(double x, double width, double largest) const { return waves.weight_on(x, width) / unit + largest; }

} // namespace touchstone::transfer::levels
