// SPDX-License-Identifier: MIT
/// The fractal limit of sections 6 to 8: n without end. The theorems: docs/limit.md.
#include "touchstone/catalogue/formula.hpp"
#include "touchstone/catalogue/limit_distributions.hpp"
#include "touchstone/limit/area_constant.hpp"
#include "touchstone/limit/area_series.hpp"
#include "touchstone/limit/limit_law.hpp"
#include "touchstone/limit/poisson.hpp"
#include "touchstone/limit/scale.hpp"
#include "touchstone/limit/second_eigenvalue.hpp"
#include "touchstone/paper/archard_constants.hpp"

#include <fmt/format.h>

namespace touchstone {
namespace {

using transfer::Scheme;

const Rational lowest_G(102, 100);               ///< ratios up to 1/(G - 1) are met: the mesh grows with that
const Rational nearest_G(2'000'001, 1'000'000); ///< above 2, where the grids of transfer::area would grow without end
const Rational lowest_G_of_gap(22, 10);          ///< next to 2.17 the second and the third eigenvalue meet
constexpr long most_digits_of_gap = 25;
constexpr long spare_digits_of_gap = 2;          ///< what the distance of the other eigenvalues costs
const Rational large_G(5000);                    ///< where few terms of the series carry 30 digits
const char* const shared = "the rate of approach; grid, form, rule and arithmetic are others";

std::function<Ball()> G_of(const Inputs& in)
{
    return [in] { return in.G_ball(); };
}

/// K_inf G: what (7.21) takes for C.
Ball by_the_paper(const Inputs& in) { return archard::K_gamma_product(archard::infinity) * in.G_ball(); }

enum class Asked { constant, ratio };

/// C(G) for 2 < G < large_G, by both schemes.
Plan by_approach(Asked asked, const Inputs& in)
{
    Plan result;
    const WorkingPrecision precision(128);
    result.most_digits = limit::most_digits_of_area_constant(in.G_ball());
    result.refusal = "the grids that more digits take would be too large";
    result.dear = true;
    const auto proof = [&](const char* name, Scheme scheme) {
        result.proofs.push_back({name, [=](Accuracy a) {
                                     const Ball C = limit::area_constant(scheme, G_of(in), a);
                                     const WorkingPrecision bits(working_bits(a));
                                     return asked == Asked::constant ? C : C / by_the_paper(in);
                                 }});
    };
    proof("approach-force-weighted", Scheme::force_weighted);
    proof("approach-area", Scheme::area);
    result.shares = shared;
    return result;
}

/// From there on.
Plan by_series(Asked asked, const Inputs& in)
{
    Plan result;
    const WorkingPrecision precision(128);
    result.most_digits = limit::most_digits_of_series(in.G_ball());
    result.refusal = "more digits would take more terms of the series than are computed";
    result.dear = true;
    result.proofs.push_back({"moments-series", [=](Accuracy a) {
                                 const WorkingPrecision bits(working_bits(a));
                                 const Ball R = limit::area_ratio_by_series(in.G_ball(), a);
                                 return asked == Asked::constant ? R * by_the_paper(in) : R;
                             }});
    result.own_witness = Look{"first-order", [=](Accuracy) {
                                  const WorkingPrecision bits(256);
                                  const Witness R = limit::area_ratio_to_first_order(in.G_ball());
                                  const Ball factor = asked == Asked::constant ? by_the_paper(in) : Ball(1);
                                  return Witness{R.value * factor, R.error * factor};
                              }};
    result.shares = "the recursion of moments";
    return result;
}

/// Where full contact occurs in the limit.
Plan by_poisson(Asked asked, const Inputs& in)
{
    Plan result;
    result.most_digits = limit::most_digits_by_poisson;
    result.refusal = "the residual of Poisson's equation is proven in 106 bits";
    result.dear = true;
    result.proofs.push_back({"poisson", [=](Accuracy a) {
                                 const Ball C = limit::mean_by_poisson({}, G_of(in), a);
                                 const WorkingPrecision bits(working_bits(a) + 64);
                                 return asked == Asked::constant ? C : C / by_the_paper(in);
                             }});
    result.own_witness = Look{"limit-law", [=](Accuracy) {
                                  const WorkingPrecision bits(256);
                                  const Witness C = limit::area_constant_by_law(in.G_ball());
                                  return asked == Asked::constant ? C : Witness{C.value / by_the_paper(in), C.error / by_the_paper(in)};
                              }};
    result.shares =
        "the wave (2.2), (2.4) and where it is not smooth: it goes forwards, to the limiting distribution; grid, quadrature and arithmetic are others";
    return result;
}

Plan plan(Asked asked, const Inputs& in)
{
    if (in.compare_G(large_G) >= 0) return by_series(asked, in);
    if (in.compare_G(nearest_G) >= 0) return by_approach(asked, in);
    if (in.compare_G(lowest_G) >= 0) return by_poisson(asked, in);
    Plan result;
    result.refusal = "the constant of the limit is certified for G = gamma^(D-1) >= 1.02 only";
    return result;
}

std::string explain(const Inputs& in, long digits)
{
    if (in.compare_G(lowest_G) < 0) return {};
    if (in.compare_G(nearest_G) < 0) return limit::mean_by_poisson_certificate({}, G_of(in), {digits});
    if (in.compare_G(large_G) >= 0) return "C(G)/(K_inf G) = sum R_N (4/G^2)^N, |R_N| <= 2 (docs/limit.md, theorem 3)\n";
    return limit::area_constant_certificate(Scheme::force_weighted, G_of(in), {digits});
}

Quantity of_limit(Quantity q, Asked asked)
{
    q.check = require_surface;
    q.plan = [asked](const Inputs& in, Accuracy) { return plan(asked, in); };
    q.explain = explain;
    q.costly = true;
    q.certified = {{"1.02 <= G < 2.000001", fmt::format("{}", limit::most_digits_by_poisson), "poisson", "witness limit-law",
                    "the wave and its singular points"},
                   {"2.000001 <= G < 5000", "what 4000 nodes carry", "approach-force-weighted", "proof approach-area", shared},
                   {"G >= 5000", "what 8 terms carry, 56 and more", "moments-series", "witness first-order", "the recursion of moments"}};
    return q;
}

const char* const above_2_only = "certified for G = gamma^(D-1) >= 2.000001 and load <= 1 only";

void check_scale(const Inputs& in)
{
    require_load(in);
    require_surface(in);
    require(in.real("tolerance") > 0 && in.real("tolerance") < 1, in, "tolerance", "> 0 and < 1");
}

Plan plan_of_scale(const Inputs& in)
{
    Plan result;
    if (in.compare_G(nearest_G) < 0 || in.real("load") > 1) {
        result.refusal = above_2_only;
        return result;
    }
    const auto proof = [&](const char* name, Scheme scheme) {
        result.proofs.push_back({name, [=](Accuracy) {
                                     return Ball(limit::least_scale(
                                         scheme, G_of(in), [in] { return in.ball("load"); }, in.real("tolerance")));
                                 }});
    };
    proof("approach-force-weighted", Scheme::force_weighted);
    proof("approach-area", Scheme::area);
    result.shares = shared;
    result.dear = true;
    return result;
}

Plan plan_of_gap(const Inputs& in)
{
    Plan result;
    const auto differences = [in](Accuracy) { return limit::gap(Scheme::force_weighted, G_of(in), Rational(1, 2)); };
    if (in.compare_G(lowest_G_of_gap) < 0) {
        const bool served = in.compare_G(nearest_G) >= 0;
        result.refusal = served ? "no proof: the second eigenvalue is proven for G >= 2.2 only"
                                : "proven for G >= 2.2 and estimated for G >= 2.000001 only";
        if (!served) return result;
        result.witnesses.push_back({"differences-from-1/2", differences});
        result.witnesses.push_back({"differences-from-1/7", [=](Accuracy) { return limit::gap(Scheme::area, G_of(in), Rational(1, 7)); }});
        return result;
    }
    result.most_digits = most_digits_of_gap;
    result.refusal = "the polynomials that more digits take would be too long";
    result.dear = true;
    result.proofs.push_back(
        {"eigenfunction", [=](Accuracy a) { return limit::second_eigenvalue(G_of(in), {a.digits + spare_digits_of_gap}); }});
    if (in.compare_G(large_G) < 0)
        result.own_witness = Look{"differences-from-1/2", differences};
    else
        result.own_witness = Look{"first-order", [=](Accuracy) {
                                      const WorkingPrecision bits(256);
                                      return limit::second_eigenvalue_to_first_order(in.G_ball());
                                  }};
    result.shares = "the wave (2.4)";
    return result;
}

std::string explain_gap(const Inputs& in, long digits)
{
    return in.compare_G(lowest_G_of_gap) < 0 ? std::string()
                                             : limit::second_eigenvalue_certificate(G_of(in), {digits + spare_digits_of_gap});
}

} // namespace

void add_limit(std::vector<Quantity>& all)
{
    all.push_back(
        of_limit({.name = "limit.area_constant",
                  .equation = "7.21",
                  .unit = "1",
                  .domain = "G > 1; certified for G >= 1.02",
                  .inputs = {"G"},
                  .description = "C(G) = lim A_n G^n/(lambda0 load) of the recursion (6.7), for any load; (7.21) takes K_inf G for it",
                  .check = {},
                  .exact = {},
                  .routes = {}},
                 Asked::constant));

    all.push_back(of_limit({.name = "limit.area_ratio",
                            .equation = "7.21",
                            .unit = "1",
                            .domain = "G > 1; certified for G >= 1.02",
                            .inputs = {"G"},
                            .description = "C(G)/(K_inf G): by what (7.21) and (8.3) are to be multiplied at large n",
                            .check = {},
                            .exact = {},
                            .routes = {}},
                           Asked::ratio));

    all.push_back({.name = "limit.scale",
                   .equation = "7.21",
                   .unit = "1",
                   .domain = "0 < tolerance < 1, load > 0, G > 1; certified for load <= 1, G >= 2.000001",
                   .inputs = {"load", "tolerance", "G"},
                   .description = "least n with |A_m/(C(G) G^-m load) - 1| <= tolerance for every m >= n: from where on the limit holds",
                   .check = check_scale,
                   .exact = {},
                   .routes = {},
                   .costly = true,
                   .plan = [](const Inputs& in, Accuracy) { return plan_of_scale(in); },
                   .certified = {{"load <= 1, G >= 2.000001", "any", "approach-force-weighted", "proof approach-area", shared}}});

    all.push_back(
        {.name = "limit.gap",
         .equation = "7.21",
         .unit = "1",
         .domain = "G > 1; certified for G >= 2.2, estimated from 2.000001",
         .inputs = {"G"},
         .description =
             "second eigenvalue of one wave's operator over its first, 1/G: by what, in general, the distance from the limit shrinks at each scale",
         .check = require_surface,
         .exact = {},
         .routes = {},
         .explain = explain_gap,
         .costly = true,
         .plan = [](const Inputs& in, Accuracy) { return plan_of_gap(in); },
         .certified = {
             {"2.2 <= G < 5000", fmt::format("{}", most_digits_of_gap), "eigenfunction", "witness differences-from-1/2", "the wave (2.4)"},
             {"G >= 5000", fmt::format("{}", most_digits_of_gap), "eigenfunction", "witness first-order", "the wave (2.4)"},
             {"2.000001 <= G < 2.2", "15", "", "", ""}}});

    add_limiting_distributions(all);
    add_distance_from_limit(all);
}

} // namespace touchstone
