// SPDX-License-Identifier: MIT
/// How far the distribution of pressure at a scale still is from the limiting one: docs/limit.md, theorem 7.
#include "touchstone/catalogue/limit_distributions.hpp"
#include "touchstone/limit/approach.hpp"
#include "touchstone/limit/limit_law.hpp"
#include "touchstone/recursion/methods.hpp"
#include "touchstone/transfer/level_zero.hpp"

#include <fmt/format.h>

#include <cmath>

namespace touchstone {
namespace {

using recursion::Asked, recursion::Problem;

constexpr long largest_n = 100;
constexpr slong input_bits = 384; // G^n loses as many bits as n has

std::optional<Exact> exact_G(const Inputs& in)
{
    try {
        return in.G_exact();
    }
    catch (const NotExact&) {
        return std::nullopt;
    }
}

/// A_n, or the share of lambda_0 above p p*_n.
Problem problem(Asked asked, const Inputs& in)
{
    const long n = in.integer("n");
    Problem p{asked, n, in.real("load"), {[in] { return in.G_ball(); }, exact_G(in)}, [in](const Rational& r) { return in.compare_G(r); }};
    if (asked == Asked::exceedance) p.p = {[in, n] { return in.ball("p") * pow(in.G_ball(), Ball(n)); }, std::nullopt};
    return p;
}

/// The uniform bound of theorem 7: at least the largest |difference| over all p.
Ball bound_for_all_pressures(const Inputs& in)
{
    const WorkingPrecision precision(input_bits);
    const Ball G = in.G_ball(), least = in.compare_G(2) >= 0 ? G / 4 : (G - 1) / G; // of C(G) = E[1/x]/G
    return 2 * limit::distance_from_limit(in.integer("n"), G, in.ball("load")) / least;
}

/// Digits that the difference takes: it falls by about 1/2 a scale.
long digits_of_difference(const Inputs& in) { return 2 + in.integer("n") * 3 / 10; }

Plan plan(const Inputs& in, Accuracy wanted)
{
    Plan result = plan_of_limiting_exceedance(in);
    if (result.proofs.empty()) return result;
    const auto share = std::make_shared<const Problem>(problem(Asked::exceedance, in)),
               area = std::make_shared<const Problem>(problem(Asked::area, in));
    const Accuracy needed{wanted.digits + digits_of_difference(in)};
    for (const auto& p : {share, area}) {
        const recursion::Choice choice = recursion::choose(*p, needed);
        if (choice.method) continue;
        result = {};
        result.refusal = choice.refusal;
        return result;
    }
    const Proof limiting = result.proofs.front();
    const long most = result.most_digits;
    result.proofs.front() = {"both-shares", [=](Accuracy a) {
                                 const Accuracy more{a.digits + digits_of_difference(in)};
                                 const auto enclosed = [&](const Problem& p) {
                                     const recursion::Choice choice = recursion::choose(p, more);
                                     return choice.method->enclose(p, {std::min(more.digits, choice.digits)});
                                 };
                                 const WorkingPrecision precision(input_bits);
                                 return enclosed(*share) / enclosed(*area) - limiting.ball({std::min(more.digits, most)});
                             }};
    result.most_digits = std::max(1L, most - digits_of_difference(in));
    result.dear = true;
    result.own_witness = Look{"limit-law", [=](Accuracy) {
                                  const WorkingPrecision precision(input_bits);
                                  const Ball p = in.ball("p");
                                  const double P = in.real("p").get_d();
                                  const auto [low, high] = transfer::levels::ends_of_exceeding(p);
                                  return limit::distance_in_the_mean(
                                      in.G_ball(), in.real("load").get_d(), in.integer("n"), {low, high},
                                      [P](double x) { return limit::exceedance_over_x(P, x); }, contact_over_x);
                              }};
    result.shares =
        "the wave (2.2), (2.4) and where it is not smooth: both distributions forwards on one grid; grid, quadrature and arithmetic are others";
    return result;
}

void check(const Inputs& in)
{
    require_integer(in, "n", 0, largest_n);
    require_load(in);
    require_surface(in);
    require(in.real("p") > 0, in, "p", "> 0");
}

} // namespace

void add_distance_from_limit(std::vector<Quantity>& all)
{
    all.push_back(
        {.name = "limit.distance",
         .equation = "6.1",
         .unit = "1",
         .domain = "n from 0 to 100, p > 0, load > 0, G > 1; certified where limit.exceedance and contact.exceedance are",
         .inputs = {"n", "p", "load", "G"},
         .description =
             "share of the contact area at scale n where p_n > p, p in p*_n, less the share that this tends to (limit.exceedance)",
         .check = check,
         .exact = {},
         .routes = {},
         .explain =
             [](const Inputs& in, long) {
                 return fmt::format(
                     "the quotient of contact.exceedance and contact.area at scale n, less limit.exceedance; whatever p is, it is at most {} (docs/limit.md, theorem 7)\n",
                     bound_for_all_pressures(in).to_string(3));
             },
         .costly = true,
         .plan = plan,
         .certified = {{"1.02 <= G <= 1000, load <= 1000", "what 15 digits of both shares leave", "both-shares", "witness limit-law",
                        "the wave and its singular points"}}});
}

} // namespace touchstone
