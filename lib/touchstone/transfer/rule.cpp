// SPDX-License-Identifier: MIT
#include "touchstone/transfer/rule.hpp"

#include "touchstone/scalar/refusal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace touchstone::transfer {
namespace {

using Traits = ScalarTraits<Ball>;
constexpr double half_pi = std::numbers::pi / 2;

double approximate(const Ball& b) { return arf_get_d(arb_midref(b.get()), ARF_RND_NEAR); }

/// The interval [a, b] as a ball.
Ball interval(double a, double b)
{
    Ball r;
    arf_t lo, hi;
    arf_init(lo);
    arf_init(hi);
    arf_set_d(lo, a);
    arf_set_d(hi, b);
    arb_set_interval_arf(r.get(), lo, hi, 64);
    arf_clear(lo);
    arf_clear(hi);
    return r;
}

/// (R2) / (c_m x^(1/4)), an upper bound; not finite unless |y| < 1 is proven.
Ball integrand_bound(const ComplexBall& v, const Ball& G, const Ratios& x)
{
    const ChainBounds b = chain_bounds(v, G, x);
    if (!b.modulus.is_finite() || !certainly(less(b.modulus, Ball(1)))) return Ball::indeterminate();
    return upper(4 / Traits::pi() * sqrt(G / 2)
                 / (pow(b.cosh_squared, Traits::quotient(5, 4)) * pow(b.factor, Traits::quotient(1, 4))));
}

/// Subdivides [lo, hi] until f(box) is finite on every box; adds up what `use` makes of (width, bound).
template <class Bound, class Use>
void over_boxes(double lo, double hi, double widest, const Bound& f, const Use& use, int depth = 0)
{
    if (hi - lo <= widest) {
        const Ball b = f(interval(lo, hi));
        if (b.is_finite()) {
            use(hi - lo, b);
            return;
        }
        if (depth > 40)
            throw BeyondReach("the region of analyticity of the quadrature could not be proven: G or the load is too near its limit");
    }
    const double mid = lo + (hi - lo) / 2;
    ++depth;
    over_boxes(lo, mid, widest, f, use, depth);
    over_boxes(mid, hi, widest, f, use, depth);
}

/// (R3) / (c_m x^(1/4))
Ball cut_off_bound(const Ball& G, const Ratios& x, const Ball& V)
{
    const Ball scale = 4 / Traits::pi() * sqrt(G / 2);
    const Ball any = 2 * exp(-2 * V);
    const Ball gap = 1 - x.highest;
    if (!certainly(less(Ball(0), gap))) return upper(scale * any);
    const Ball below_one = pow(Ball(2), Traits::quotient(5, 2)) * exp(-Traits::quotient(5, 2) * V)
                         / (Traits::quotient(5, 2) * pow(gap, Traits::quotient(1, 4)));
    return upper(scale * at_most(below_one, any));
}

Rule::Node node_at(const Ball& v, const Ball& weight)
{
    Rule::Node n;
    n.v = v;
    Ball sh, ch;
    arb_sinh_cosh(sh.get(), ch.get(), v.get(), WorkingPrecision::bits());
    n.sinh_squared = sh * sh;
    n.sech_squared = 1 / (ch * ch);
    n.log_cosh = log(ch);
    n.area_weight = 4 * weight / (Traits::pi() * ch);
    n.force_weight = 4 * weight * n.sech_squared / Traits::pi();
    return n;
}

/// Guesses in `double`, to choose parameters by; what is chosen is proven afterwards.
struct Guess {
    double g, X, lost, A, allowed; ///< lost: 1 - X, which binary64 would not tell from 0 next to X = 1
    Guess(const Ball& G, const Ratios& x)
        : g(approximate(G))
        , X(std::min(approximate(x.highest), 1.0))
        , lost(std::max(approximate(1 - x.highest), 0.0))
        , A(approximate(x.zeros()))
    {
        allowed = 1 - (1 - 2 / g * std::sqrt(X)) / 4;
    }
    /// whether |y| keeps clear of 1 at v = re + i im
    bool allows(double re, double im) const
    {
        const double sr = std::sinh(re), cr = std::cosh(re), co = std::cos(im), si = std::sin(im);
        const double re_s = sr * sr * co * co - cr * cr * si * si, im_s = 2 * sr * cr * si * co; // sinh^2 v
        return 2 / g * std::sqrt(X * std::hypot(1 + lost * re_s, lost * im_s)) < allowed * (sr * sr + co * co);
    }
    /// the largest beta with |y| allowed on [0, i beta]
    double widest_imaginary() const
    {
        double beta = 0x1p-30; // as G -> 2 it shrinks like (G - 2)^(1/2)
        while (beta < 1.5 && allows(0, beta * 1.02)) beta *= 1.02;
        return beta;
    }
};

} // namespace

Ball proven_panel_error(const Ball& G, const Ratios& x, const Ball& mid, const Ball& half, double ellipse, bool even, long n)
{
    const Ball rho = Ball::exactly(ellipse);
    const Ball major = half * (rho + 1 / rho) / 2, minor = half * (rho - 1 / rho) / 2;
    // zeros of cosh v and of 1 + (1-x) sinh^2 v: |Im v| = pi/2, pi, ... and |Re v| <= A
    const bool below = certainly(less(minor, Traits::pi() / 2));
    const bool beyond = certainly(less(x.zeros(), mid - major)); // A >= 0
    if (!below && !beyond) throw BeyondReach("a Gauss panel's ellipse could not be shown to be free of zeros");
    Ball M(0);
    over_boxes(
        0, 1, 1.0 / 16, // the angle in units of pi; the lower half follows by conjugation
        [&](const Ball& t) {
            return integrand_bound(ComplexBall(mid + major * Traits::cos_pi(t), minor * Traits::sin_pi(t)), G, x);
        },
        [&](double, const Ball& b) { M = upper(at_least(b, M)); });
    Ball decay;
    arb_pow_ui(decay.get(), rho.get(), static_cast<ulong>(even ? 4 * n : 2 * n), 64);
    const Ball error = half * Traits::quotient(16, 3) * M / (decay * (1 - 1 / rho));
    return upper(even ? error / 2 : error);
}

Ball beyond_on_strip(const Ball& G, const Ratios& x, const Ball& alpha, const Ball& D)
{
    // |cosh v| >= sinh Re v and |1 - x tanh^2 v| >= 1 - x coth^2 Re v, or >= 1/cosh^2 Re v where x = 1
    Ball sh, ch;
    arb_sinh_cosh(sh.get(), ch.get(), alpha.get(), 64);
    const Ball coth2 = ch * ch / (sh * sh), scale = 4 / Traits::pi() * sqrt(G / 2) / cos(D);
    // |y| decreases from there on
    if (!certainly(less(4 / (G * G) * x.highest * (1 + x.highest * coth2) / (sh * sh), Ball(1)))) return Ball::indeterminate();
    const Ball shrink = pow(2 / (1 - exp(-2 * alpha)), Traits::quotient(5, 2)); // 1/sinh = 2 e^-Re v/(1 - ...)
    if (x.at_one()) return upper(scale * shrink * exp(-2 * alpha) / 2); // cosh^(1/2) <= e^(Re v/2)
    const Ball least = lower((1 - x.highest) - x.highest / (sh * sh));
    return upper(scale * shrink * exp(-Traits::quotient(5, 2) * alpha) / (Traits::quotient(5, 2) * pow(least, Traits::quotient(1, 4))));
}

Rule proven_double_exponential(const Ball& G, const Ratios& x, double accuracy, double V, double c, double d)
{
    c = std::ldexp(std::floor(std::ldexp(c, 30)), -30); // short dyadic parameters
    d = std::ldexp(std::floor(std::ldexp(d, 30)), -30);
    const double step = std::ldexp(std::floor(std::ldexp(2 * std::numbers::pi * d / (accuracy + 4), 30)), -30);
    const long last = static_cast<long>(std::floor(std::asinh(V / c) / step));

    Rule rule;
    const Ball C = Ball::exactly(c), H = Ball::exactly(step);
    for (long k = 0; k <= last; ++k) {
        Ball sh, ch;
        arb_sinh_cosh(sh.get(), ch.get(), (k * H).get(), WorkingPrecision::bits());
        const Ball weight = H * C * ch;
        rule.nodes.push_back(node_at(C * sh, k == 0 ? weight / 2 : weight));
    }

    const WorkingPrecision coarse(64);
    const Ball D = Ball::exactly(d), A = x.zeros();
    const Ball across = C * sin(D), along = C * cos(D);
    const Ball quarter = Traits::pi() / 2;
    bool proven = certainly(less(across, quarter));
    if (!x.at_one()) {
        const Ball q = quarter / across, l = A / along;
        proven = proven && certainly(less(Ball(1), q * q - l * l));
    }
    // the sums (R3) stands for must decrease from the last node on: c cosh r >= v
    const Ball& V_last = rule.nodes.back().v;
    Ball tanh_last;
    arb_tanh(tanh_last.get(), V_last.get(), 64);
    proven = proven && certainly(less(Ball(1), 2 * V_last * tanh_last));

    // along Im r = d out to Re v = far, then all at once
    const double far = std::max(30.0, approximate(x.zeros()) + 10);
    const double last_a = std::ceil(std::asinh(far / approximate(along)) * 16) / 16;
    Ball J;
    over_boxes(
        0, last_a, 1.0 / 16,
        [&](const Ball& a) {
            Ball sh, ch;
            arb_sinh_cosh(sh.get(), ch.get(), a.get(), 64);
            return C * ch * integrand_bound(ComplexBall(along * sh, across * ch), G, x);
        },
        [&](double width, const Ball& b) { J += Ball::exactly(width) * upper(b); });
    Ball sh_a;
    arb_sinh(sh_a.get(), Ball::exactly(last_a).get(), 64);
    J += beyond_on_strip(G, x, lower(along * sh_a), D);
    if (!proven || !J.is_finite())
        throw BeyondReach("the double-exponential rule's strip of analyticity could not be proven: G or the load is too near its limit");
    Ball decay;
    arb_expm1(decay.get(), (2 * Traits::pi() * D / H).get(), 64);
    rule.discretisation = upper(2 * J / decay);
    rule.truncation = cut_off_bound(G, x, V_last);
    rule.text = fmt::format("trapezoid in r, v = {:.4g} sinh r, step {:.4g}, {} nodes to v = {:.4g}, strip |Im r| < {:.3g}, J = {:.3g}",
                            c, step, rule.nodes.size(), approximate(V_last), d, approximate(2 * J));
    return rule;
}

double cut_off(const Ratios& x, double accuracy)
{
    const double gap = approximate(1 - x.highest);
    const double any = (accuracy + 3) / 2;
    return gap > 0 ? std::min(any, (accuracy + 3 - std::log(gap) / 4) / 2.5) : any;
}

Rule double_exponential_rule(const Ball& G, const Ratios& x, double accuracy, double V)
{
    const Guess guess(G, x);
    const double widest = guess.widest_imaginary();
    double c = 0, d = 0, cost = HUGE_VAL;
    for (double b = 0x1p-11; b < 1.4; b += std::min(0.02, b / 4)) { // narrow where zeros are far out, next to load = 1
        double a = widest / std::sin(b);
        if (guess.A > 0) { // the zeros stay outside, with a tenth to spare
            const double room = std::pow(half_pi / std::sin(b), 2) / 1.1 - std::pow(guess.A / std::cos(b), 2);
            if (room <= 0) continue;
            a = std::min(a, std::sqrt(room));
        }
        const auto allowed_along = [&](double scale) {
            for (double r = 0; scale * std::sinh(r) * std::cos(b) < 3; r += 0.05)
                if (!guess.allows(scale * std::sinh(r) * std::cos(b), scale * std::cosh(r) * std::sin(b))) return false;
            return true;
        };
        for (int k = 0; k < 40 && !allowed_along(a); ++k) a *= 0.93;
        if (!allowed_along(a)) continue;
        const double points = std::asinh(V / a) / b;
        if (points < cost) cost = points, c = a, d = b;
    }
    if (!(cost < 1e6)) throw BeyondReach("no double-exponential rule found: G or the load is too near its limit");
    for (int attempt = 0;; ++attempt) // a narrower strip where the guess was too bold
        try {
            return proven_double_exponential(G, x, accuracy, V, c, d);
        }
        catch (const BeyondReach&) {
            if (attempt == 8) throw;
            c *= 0.9;
        }
}

Rule gauss_panel_rule(const Ball& G, const Ratios& x, double accuracy, double V)
{
    const Guess guess(G, x);
    const double widest = guess.widest_imaginary();
    struct Panel { double lo, hi, rho; long n; bool even; };
    std::array<double, 65> cosines{}, sines{}; // of the angles at which an ellipse is looked at
    for (std::size_t k = 0; k < cosines.size(); ++k) {
        const double phi = std::numbers::pi * static_cast<double>(k) / 64;
        cosines[k] = std::cos(phi), sines[k] = std::sin(phi);
    }
    std::vector<double> sizes;
    for (double rho = 1.05; rho < 8; rho *= 1.03) sizes.push_back(rho);
    // the largest ellipse that keeps off the zeros of cosh v and 1 + (1-x) sinh^2 v, and off |y| = 1: as a smaller one does, in strides
    // first
    const auto largest_rho = [&](double lo, double hi, bool even) {
        const double mid = even ? 0 : (lo + hi) / 2, half = even ? hi : (hi - lo) / 2;
        const auto allowed = [&](double rho) {
            const double minor = half * (rho - 1 / rho) / 2, major = half * (rho + 1 / rho) / 2;
            if (!(minor < half_pi * 0.99 || (!even && mid - major > std::max(guess.A * 1.01, 0.01)))) return false;
            for (std::size_t k = 0; k < cosines.size(); ++k)
                if (!guess.allows(mid + major * cosines[k], minor * sines[k])) return false;
            return true;
        };
        std::size_t known = 0; // so many are allowed
        for (const std::size_t stride : {std::size_t{8}, std::size_t{1}})
            while (known + stride <= sizes.size() && allowed(sizes[known + stride - 1])) known += stride;
        return known == 0 ? 1.0 : sizes[known - 1];
    };
    std::vector<Panel> panels;
    double cost = HUGE_VAL;
    for (double first = widest / 4; first < 3 * widest; first *= 1.25)
        for (double ratio : {1.7, 2.2, 3.0, 4.0}) {
            std::vector<Panel> tried;
            double points = 0;
            for (double lo = 0, hi = first; lo < V; lo = hi, hi = std::min(hi * ratio, V)) {
                hi = std::ldexp(std::ceil(std::ldexp(hi, 40)), -40);
                const double rho = largest_rho(lo, hi, lo == 0);
                const double n = rho > 1 ? std::ceil((accuracy + 4) / (2 * std::log(rho))) : 1e9;
                tried.push_back({lo, hi, rho, static_cast<long>(lo == 0 ? std::ceil(n / 2) : n), lo == 0});
                points += static_cast<double>(tried.back().n);
            }
            if (points < cost) cost = points, panels = tried;
        }
    if (!(cost < 1e6)) throw BeyondReach("no Gauss rule found: G or the load is too near its limit");

    Rule rule;
    rule.discretisation = Ball(0);
    for (Panel& p : panels) {
        const Ball lo = Ball::exactly(p.lo), hi = Ball::exactly(p.hi);
        const Ball mid = p.even ? Ball(0) : (lo + hi) / 2, half = p.even ? hi : (hi - lo) / 2;
        for (int attempt = 0;; ++attempt) { // a smaller ellipse where the guess was too bold
            try {
                const WorkingPrecision coarse(64);
                rule.discretisation = upper(rule.discretisation + proven_panel_error(G, x, mid, half, p.rho, p.even, p.n));
                break;
            }
            catch (const BeyondReach&) {
                if (attempt == 8) throw;
                p.n = static_cast<long>(std::ceil(static_cast<double>(p.n) * std::log(p.rho) / std::log(1 + (p.rho - 1) * 0.8)));
                p.rho = 1 + (p.rho - 1) * 0.8;
            }
        }
        const long order = p.even ? 2 * p.n : p.n;
        for (long k = 0; k < p.n; ++k) { // k = 0 is the root nearest to 1
            Ball root, weight;
            arb_hypgeom_legendre_p_ui_root(root.get(), weight.get(), static_cast<ulong>(order), static_cast<ulong>(k),
                                           WorkingPrecision::bits());
            rule.nodes.push_back(node_at(mid + half * root, half * weight));
        }
    }
    rule.truncation = cut_off_bound(G, x, Ball::exactly(panels.back().hi));
    rule.text = fmt::format("Gauss-Legendre on {} panels to v = {:.4g}, {} nodes, first panel to {:.3g}", panels.size(), panels.back().hi,
                            rule.nodes.size(), panels.front().hi);
    return rule;
}

} // namespace touchstone::transfer
