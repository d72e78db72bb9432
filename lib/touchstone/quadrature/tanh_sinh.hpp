// SPDX-License-Identifier: MIT
/// \file
/// Tanh-sinh quadrature with a proven error.
///
///     Enclosure I = tanh_sinh(f, Interval::finite(0, 1), {.digits = 100});
///
/// f(x, left, right) is a generic callable: the same formula is run on `EndpointNumber<Ball>`
/// at the nodes and on `EndpointNumber<ComplexBall>` on pieces of a strip in the complex plane
/// (see interval.hpp for its arguments, endpoint_number.hpp for what it may do).
///
/// Domain: f real on the interval, analytic on the image of some strip |Im t| < d under
/// x = tanh-sinh(t) after at most a few bisections of the interval, and there
/// |f| <= K u^(alpha-1) r^(beta-1) with alpha, beta > 0 (times powers of logarithms).
/// All of this is *proved* by the call, from f alone. What is not proved is not integrated:
/// the result is then `indeterminate`, with the reason. An enclosure that lacks the digits asked for (the integral is 0, or far below what
/// bounds the integrand on the strip) is `undecided`, and says how many it has.
/// Contract on f: both instantiations are the same function, made of operations on its
/// arguments (no look at midpoints, no branch on their values).
///
/// Errors, all rigorous, proofs in tanh_sinh.md. With F(t) = f(x(t)) x'(t), step h,
///   discretisation   N_d / (exp(2 pi d/h) - 1),  N_d >= integral of |F(t+id)| + |F(t-id)| dt,
///   truncation       K (...) exp(-alpha pi sinh(n h))/alpha at either end,
///   rounding         the radius of the sum in ball arithmetic.
/// h, n and the precision follow from the digits asked and the proven N_d, alpha, beta, K
/// before any node is evaluated. No comparison of two levels enters.
///
/// Cost: some tens to hundreds of evaluations of f in 53-bit complex balls, then about
/// 0.37 D log D evaluations for D digits where the strip is wide (d near pi/2).
/// Source: Takahasi & Mori (1974); error terms after Okayama, Matsuo & Sugihara, Numer. Math. 124
/// (2013) 361-394 and Yamanaka, Okayama, Oishi & Ogita, NOLTA 1 (2010) 119-132, with N_d
/// computed in balls instead of bounded by a closed form.
#pragma once

#include "touchstone/quadrature/interval.hpp"
#include "touchstone/quadrature/strip.hpp"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace touchstone::quadrature {

/// certified: the digits asked for are proven. undecided: a proven enclosure with fewer digits, `digits` of them. indeterminate: nothing is
/// proven.
enum class Status { certified, undecided, indeterminate };
std::string to_string(Status);

struct Options {
    /// Significant decimal digits wanted of the integral.
    long digits = 30;
    /// Whether digits of the integral of |f| will do, where the integral itself is smaller.
    bool of_absolute = false;
    /// Whether many bits may be spent where f is huge next to its integral (x^1000 exp(-x) takes 12000).
    bool patient = false;
    /// tanh_sinh, or logistic: the trapezoidal rule in log(u/r), for what is analytic in a sector only. It takes some D^2 values of f for D
    /// digits.
    Transformation transformation = Transformation::tanh_sinh;
    /// If given, the integrand is refused unless |f| <= K u^(alpha-1), resp. r^(beta-1), is proved for it.
    std::optional<Rational> left_exponent, right_exponent;
    /// How often the interval may be bisected near a singularity that is close to it.
    int bisections = 6;
    /// Evaluations of f in complex balls that the proof may spend on one panel.
    long proof_budget = 20000;
};

/// What was proved about one panel, and what was done with it.
struct Panel {
    Rational from, to;            ///< fractions of the interval (in u)
    Exponent alpha, beta;         ///< |F| <= K ... with these exponents
    double strip = 0;             ///< d
    Transformation transformation = Transformation::tanh_sinh;
    Ball bound_left, bound_right; ///< K at either end: |f dx/du| <= K u^(alpha-1) r^(beta-1) there
    Ball strip_integral;          ///< N_d
    Ball scale;                   ///< bound of the integral of |F| over the real line
    long pieces = 0;              ///< evaluations of f that the proof took
    long m = 0;                   ///< step h = (log 2)/m
    long left_nodes = 0, right_nodes = 0;
    Ball discretisation, truncation, rounding; ///< the three error terms
};

struct Certificate {
    std::string interval;
    long digits = 0;
    slong precision = 0; ///< bits of the sum
    std::vector<Panel> panels;

    /// Sum over the panels.
    Ball discretisation() const;
    Ball truncation() const;
    Ball rounding() const;
    long points() const;
    std::string to_json() const;
};

struct Enclosure {
    Ball value;      ///< contains the integral, if certified or undecided
    Status status = Status::indeterminate;
    long digits = 0;    ///< proven: |error| <= 10^-digits |integral|; at most those asked for
    std::string reason; ///< unless certified: what could not be proved, and where
    std::optional<double> fraction; ///< if indeterminate: where the proof stopped inside the interval, as the fraction u
    Certificate certificate;
    explicit operator bool() const = delete;
};

namespace detail {

template <class V>
using PanelFunction = std::function<EndpointNumber<V>(const Frame<V>&)>;

/// f dx/du on a panel, as a function of the panel's own u and r: of one integrand or several.
struct PanelIntegrand {
    PanelFunction<ComplexBall> on_strip; ///< of several, what bounds them all
    std::function<void(const Frame<Ball>&, std::vector<EndpointNumber<Ball>>&)> at_node;
    std::function<void()> prepare; ///< to be called after each change of precision
    /// f dx/da where the fractions of the range are u = sin^2 a, r = cos^2 a, straight in balls, if about the working precision is left of
    /// it; there may be none.
    std::function<std::optional<Ball>(const Ball& sine, const Ball& cosine)> straight;
    /// f dx/du where u = (1 + z)/2 of the panel, or, mirrored, (1 - z)/2, in the same way.
    std::function<std::optional<Ball>(const Ball& z, bool mirrored)> straight_in_fraction;
    /// f dx/du at the fraction u next to the left end, or r next to the right one, in the same way.
    std::function<std::optional<Ball>(Side end, const Ball& fraction)> straight_beside;
    bool is_even = false; ///< the same where u and r change places
    /// Of an f that is even about an end of the panel, and analytic there: f dx/dz at the share z of the panel from that end, as the
    /// text has it; non-finite where that is not analytic.
    struct Even {
        Side about;
        std::function<ComplexBall(const ComplexBall& z)> in_plane;
    };
    std::optional<Even> even;
};

using MakePanel = std::function<PanelIntegrand(const Rational& from, const Rational& to)>;

/// One enclosure for each of `count` integrands; the certificates are one and the same.
std::vector<Enclosure> integrate(const MakePanel&, std::size_t count, const Interval&, const Options&);

/// u^p r^q c with |g| <= |u^p r^q| c for each g of them: the orders of the largest at either end.
EndpointNumber<ComplexBall> majorant(const std::vector<EndpointNumber<ComplexBall>>&, const Frame<ComplexBall>&);

/// A panel's share of the whole interval, and what lies before and after it.
struct Share {
    Share(const Rational& from, const Rational& to) : before(from), width(to - from), after(1 - to) {}
    Rational before, width, after;
};

/// f dx/du and its factors on the panel; f returns a number or a range of them.
template <class V, class F, class Take>
void panel_values(const F& f, const Interval& interval, const Frame<V>& frame, const Share& share, const Take& take)
{
    using N = EndpointNumber<V>;
    const N v(&frame, {1, 0}, {}, V(1)), s(&frame, {}, {1, 0}, V(1));
    const bool whole = share.before == 0 && share.after == 0;
    const N width = whole ? N() : N(share.width);
    const N u = whole ? v : share.before == 0 ? width * v : N(share.before) + width * v;
    const N r = whole ? s : share.after == 0 ? width * s : N(share.after) + width * s;
    const auto p = interval.at(u, r);
    const N slope = whole ? N() : p.slope * width;
    const auto scaled = [&](const N& g) { return g * (whole ? p.slope : slope); };
    const auto values = f(p.x, p.left, p.right);
    if constexpr (requires { values.begin(); })
        for (const auto& g : values) take(scaled(N(g)));
    else
        take(scaled(N(values)));
}

/// The two instantiations of f on a panel.
template <class F>
PanelIntegrand panel_integrand(const F& f, const std::shared_ptr<Interval>& interval, const Rational& from, const Rational& to)
{
    PanelIntegrand g;
    const auto share = std::make_shared<const Share>(from, to);
    g.on_strip = [f, interval, share](const Frame<ComplexBall>& frame) {
        std::vector<EndpointNumber<ComplexBall>> all;
        panel_values<ComplexBall>(f, *interval, frame, *share, [&](auto&& v) { all.push_back(v); });
        return all.size() == 1 ? all.front() : majorant(all, frame);
    };
    g.at_node = [f, interval, share](const Frame<Ball>& frame, std::vector<EndpointNumber<Ball>>& out) {
        out.clear();
        panel_values<Ball>(f, *interval, frame, *share, [&](auto&& v) { out.push_back(v); });
    };
    g.prepare = [interval] { interval->prepare(); };
    return g;
}

} // namespace detail

/// The integrals of `count` functions of the same singular structure: f returns a range of numbers in place of one. The strip is proved
/// once, for all of them together, and they share their nodes; each has an enclosure of its own. What is singular for one is taken to be
/// so for all: functions that differ in that cost each other nodes, never digits.
template <class F>
std::vector<Enclosure> tanh_sinh_of_several(F f, std::size_t count, Interval interval, const Options& options = {})
{
    const auto shared = std::make_shared<Interval>(std::move(interval));
    const detail::MakePanel make = [f, shared](const Rational& from, const Rational& to) {
        return detail::panel_integrand(f, shared, from, to);
    };
    return detail::integrate(make, count, *shared, options);
}

/// The integral of f over the interval. See the head of this file.
template <class F>
Enclosure tanh_sinh(F f, Interval interval, const Options& options = {})
{
    return tanh_sinh_of_several(std::move(f), 1, std::move(interval), options).front();
}

} // namespace touchstone::quadrature
