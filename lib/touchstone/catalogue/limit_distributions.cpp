// SPDX-License-Identifier: MIT
/// The limiting distributions of section 9 and figure 5: docs/limit.md, theorem 5.
#include "touchstone/catalogue/limit_distributions.hpp"

#include "touchstone/limit/area_constant.hpp"
#include "touchstone/limit/limit_law.hpp"
#include "touchstone/limit/poisson.hpp"
#include "touchstone/transfer/level_zero.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace touchstone {
namespace {

using limit::Question;

const Rational lowest_G(102, 100);              ///< ratios up to 1/(G - 1) are met: the mesh grows with that
const Rational nearest_G(2'000'001, 1'000'000); ///< from there on C(G) has two proofs of its own
const Rational highest_G(1000);                 ///< the bound's G^3 leaves few digits beyond
const Rational lowest_pressure_of_density(1, 512); ///< the mesh reaches down to p^4
constexpr slong input_bits = 256;

std::function<Ball()> G_of(const Inputs& in)
{
    return [in] { return in.G_ball(); };
}

/// The pressure in p*_n above which contact, or force, is asked for.
using Pressure = std::function<Ball(const Inputs&)>;

Ball given(const Inputs& in) { return in.ball("p"); }

/// Contact segments of scale n + 1 are wider than a where p_n > p*_{n+1} sin^2(pi a/lambda_{n+1}), (9.2).
Ball of_half_width(const Inputs& in)
{
    const Ball s = ScalarTraits<Ball>::sin_pi(in.ball("a"));
    return in.G_ball() * s * s;
}

/// Whether certainly no pressure above p is met: p_n^max/p*_n tends to 4/G from below for G >= 2, and to G/(G - 1) else, (5.10).
bool never_met(const Ball& p, const Inputs& in)
{
    if (in.has("p")) { // exactly
        const Rational& at = in.real("p");
        return in.compare_G(2) >= 0 ? in.compare_G(4 / at) >= 0 : at > 1 && in.compare_G(at / (at - 1)) >= 0;
    }
    const Ball G = in.G_ball();
    const Ball highest = in.compare_G(2) >= 0 ? 4 / G : G / (G - 1);
    return certainly(less(highest, p));
}

/// The force of one wave of mean x that is carried above P, over x: in binary64.
double force_over_x(double P, double x)
{
    using std::numbers::pi;
    const double c = x >= 1 ? P - x : std::hypot(1 - x, P) - x; // cos theta where the pressure is P
    if (c >= 1) return 0;
    if (x >= 1) return c <= -1 ? 1 : (x * std::acos(c) + std::sqrt(1 - c * c)) / (pi * x);
    const double v = (1 - c) / (2 * x);
    return 2 / pi * (std::asin(std::sqrt(v)) + std::sqrt(v * (1 - v)));
}

/// f/x of what is asked.
double over_x(Question::Of of, double G, double P, double x)
{
    if (of == Question::Of::density) return G * limit::density_after_two_waves(G, P, x) / x;
    return of == Question::Of::force ? force_over_x(P, x) : limit::exceedance_over_x(P, x);
}

Witness look(const Question& q, const Inputs& in)
{
    const Ball G = in.G_ball();
    const auto near = [](const Ball& b) { return arf_get_d(arb_midref(b.get()), ARF_RND_NEAR); };
    const double P = near(q.pressure), g = near(G);
    const bool density = q.of == Question::Of::density;
    const auto [low, high] = transfer::levels::ends_of_exceeding(q.pressure);
    const Witness w =
        limit::mean_in_the_limit(G, density ? transfer::levels::singular_points_of_density(G, q.pressure) : std::vector<Ball>{low, high},
                                 [&](double x) { return over_x(q.of, g, P, x); });
    if (q.of == Question::Of::force) return w;
    const Witness C = limit::area_constant_by_law(G);
    return {w.value / C.value, w.error / C.value + C.error * w.value / (C.value * C.value)};
}

Ball area_constant(const Inputs& in, Accuracy a)
{
    if (in.compare_G(nearest_G) >= 0) return limit::area_constant(transfer::Scheme::force_weighted, G_of(in), a);
    return limit::mean_by_poisson({}, G_of(in), a);
}

/// Why there is no proof; empty: there is one.
std::string refused(Question::Of of, const Inputs& in)
{
    if (in.compare_G(lowest_G) < 0 || in.compare_G(highest_G) > 0)
        return "the limiting distributions are certified for 1.02 <= G = gamma^(D-1) <= 1000 only";
    if (of == Question::Of::density && in.real("p") < lowest_pressure_of_density)
        return "the density of the limit is certified for p >= 2^-9 only";
    return "";
}

Plan plan(Question::Of of, const Pressure& pressure, const Inputs& in)
{
    Plan result;
    const WorkingPrecision precision(input_bits);
    if (never_met(pressure(in), in)) {
        result.proofs.push_back({"highest-pressure", [](Accuracy) { return Ball(0); }});
        result.own_witness = Look{"highest-pressure", [](Accuracy) { return Witness{Ball(0), Ball(0)}; }};
        return result;
    }
    result.refusal = refused(of, in);
    if (!result.refusal.empty()) return result;
    const auto question = [=] {
        const WorkingPrecision precision(input_bits);
        return Question{of, pressure(in)};
    };
    result.most_digits = limit::most_digits_by_poisson;
    result.refusal = "the residual of Poisson's equation is proven in 106 bits, and counts G^3 times";
    result.dear = true;
    result.proofs.push_back({"poisson", [=](Accuracy a) {
                                 const WorkingPrecision bits(input_bits);
                                 const Question q = question();
                                 const Ball mean = limit::mean_by_poisson(q, G_of(in), a);
                                 if (of == Question::Of::force) return mean;
                                 return (of == Question::Of::density ? in.G_ball() * mean : mean) / area_constant(in, a);
                             }});
    result.own_witness = Look{"limit-law", [=](Accuracy) {
                                  const WorkingPrecision bits(input_bits);
                                  return look(question(), in);
                              }};
    result.shares =
        "the wave (2.2), (2.4) and where it is not smooth: it goes forwards, to the limiting distribution; grid, quadrature and arithmetic are others";
    return result;
}

Quantity of_limit(Quantity q, Question::Of of, const Pressure& pressure)
{
    q.plan = [of, pressure](const Inputs& in, Accuracy) { return plan(of, pressure, in); };
    q.explain = [of, pressure](const Inputs& in, long digits) {
        const WorkingPrecision precision(input_bits);
        const Question asked{of, pressure(in)};
        if (never_met(asked.pressure, in)) return std::string("no pressure as high is met in the limit, (5.10)\n");
        if (!refused(of, in).empty()) return std::string();
        return limit::mean_by_poisson_certificate(asked, G_of(in), {digits});
    };
    q.costly = true;
    q.certified = {{"1.02 <= G <= 1000", fmt::format("{}, fewer next to pressure 0 and at large G", limit::most_digits_by_poisson),
                    "poisson", "witness limit-law", "the wave and its singular points"}};
    return q;
}

} // namespace

Plan plan_of_limiting_exceedance(const Inputs& in) { return plan(Question::Of::pressure, given, in); }
double contact_over_x(double x) { return (x < 1 ? 2 / std::numbers::pi * std::asin(std::sqrt(x)) : 1) / x; }

namespace {

void check_pressure(const Inputs& in)
{
    require_surface(in);
    require(in.real("p") > 0, in, "p", "> 0");
}

void check_half_width(const Inputs& in)
{
    require_surface(in);
    require(in.real("a") > 0 && in.real("a") <= Rational(1, 2), in, "a", "> 0 and <= 1/2, in wavelengths of its scale");
}

} // namespace

void add_limiting_distributions(std::vector<Quantity>& all)
{
    const auto add = [&](const char* name, const char* equation, const char* input, const char* domain, const char* description,
                         Question::Of of, const Pressure& pressure, void (*check)(const Inputs&)) {
        all.push_back(of_limit({.name = name,
                                .equation = equation,
                                .unit = "1",
                                .domain = domain,
                                .inputs = {input, "G"},
                                .description = description,
                                .check = check,
                                .exact = {},
                                .routes = {}},
                               of, pressure));
    };
    add("limit.exceedance", "6.1", "p", "p > 0, G > 1; certified for 1.02 <= G <= 1000",
        "share of the contact area where p_n > p, p in p*_n, as n tends to infinity; at p = x G, of the contacts of the next scale of load ratio above x",
        Question::Of::pressure, given, check_pressure);
    add("limit.force", "6.1", "p", "p > 0, G > 1; certified for 1.02 <= G <= 1000",
        "share of the force that is carried where p_n > p, p in p*_n, as n tends to infinity", Question::Of::force, given, check_pressure);
    add("limit.density", "6.1", "p", "p > 0, G > 1; certified for 1.02 <= G <= 1000, p >= 2^-9",
        "density of p_n/p*_n in the contact area at p, as n tends to infinity: minus the slope of limit.exceedance", Question::Of::density,
        given, check_pressure);
    add("limit.segments", "9.2", "a", "0 < a <= 1/2, G > 1; certified for 1.02 <= G <= 1000",
        "share of the contact segments whose half-width is above a, a in lambda_n, as n tends to infinity; at a = 1/2, of full contacts",
        Question::Of::pressure, of_half_width, check_half_width);
}

} // namespace touchstone
