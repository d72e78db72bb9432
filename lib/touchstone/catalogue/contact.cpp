// SPDX-License-Identifier: MIT
/// The quantities of sections 6 to 9 that rest on the recursion (6.1)-(6.7). Which proof serves which inputs: recursion/methods.hpp.
#include "touchstone/catalogue/contact_exact.hpp"
#include "touchstone/recursion/methods.hpp"

#include <fmt/format.h>

namespace touchstone {
namespace {

using recursion::Asked, recursion::Problem;

constexpr long largest_n = 10'000;
constexpr long largest_n_of_areas = 1'000'000;
const char* const surface_domain = "load > 0, G > 1";

void check_surface(const Inputs& in)
{
    require_load(in);
    require_surface(in);
}

void check_contact(const Inputs& in)
{
    require_integer(in, "n", 0, largest_n);
    check_surface(in);
}

void check_area(const Inputs& in)
{
    require_integer(in, "n", 0, largest_n_of_areas);
    check_surface(in);
}

void check_count(const Inputs& in)
{
    require_integer(in, "n", 1, largest_n_of_areas);
    check_surface(in);
}

void check_pressure(const Inputs& in)
{
    check_contact(in);
    require(in.real("p") >= 0, in, "p", ">= 0");
}

void check_segments(const Inputs& in)
{
    check_contact(in);
    require_integer(in, "n", 1, largest_n);
}

void check_half_width(const Inputs& in)
{
    check_segments(in);
    require(in.real("a") >= 0 && in.real("a") <= Rational(1, 2), in, "a", ">= 0 and <= 1/2");
}

std::optional<Exact> exact(const std::function<Exact()>& number)
{
    try {
        return number();
    }
    catch (const NotExact&) {
        return std::nullopt;
    }
}

Problem problem(Asked asked, long n, const Inputs& in)
{
    return {asked, n, in.real("load"), {[in] { return in.G_ball(); }, exact([&in] { return in.G_exact(); })}, [in](const Rational& r) {
                return in.compare_G(r);
            }};
}

Problem of_area(const Inputs& in) { return problem(Asked::area, in.integer("n"), in); }

Problem at_pressure(Asked asked, const Inputs& in)
{
    Problem p = problem(asked, in.integer("n"), in);
    p.p = {[value = in.real("p")] { return Ball(value); }, in.real("p")};
    return p;
}

Problem of_exceedance(const Inputs& in) { return in.real("p") == 0 ? of_area(in) : at_pressure(Asked::exceedance, in); }
Problem of_density(const Inputs& in) { return at_pressure(Asked::density, in); }

/// Segments of scale n end where p_{n-1} < p*_n ends contact. (Regions in full contact at scale n, p_{n-1} >= p*_n, have no ends there, a =
/// 1/2 and beyond: they are in no segment.)
Problem of_segments(const Inputs& in)
{
    Problem p = problem(Asked::density, in.integer("n") - 1, in);
    p.p = {[in] {
               const Ball s = ScalarTraits<Ball>::sin_pi(in.ball("a"));
               return pow(in.G_ball(), Ball(in.integer("n"))) * s * s;
           },
           exact([&in] { return contact_exact::pressure_of_segments(in); })};
    return p;
}
/// dp/da of that pressure, (9.3)
Ball pressure_by_half_width(const Inputs& in)
{
    return pi<Ball>() * pow(in.G_ball(), Ball(in.integer("n"))) * ScalarTraits<Ball>::sin_pi(2 * in.ball("a"));
}

Problem of_count(const Inputs& in) { return problem(Asked::area, in.integer("n") - 1, in); }
/// lambda_0/lambda_n = gamma^n
Ball potential_segments(const Inputs& in) { return pow(in.ball("gamma"), Ball(in.integer("n"))); }

Ball one(const Inputs&) { return Ball(1); }

using Ask = Problem (*)(const Inputs&);
using Factor = Ball (*)(const Inputs&);

/// The method chosen, its second look, and what estimates where there is none; all times `factor`.
Plan plan(Ask ask, Factor factor, const Inputs& in, Accuracy wanted)
{
    const auto p = std::make_shared<const Problem>(ask(in));
    const recursion::Choice choice = recursion::choose(*p, wanted);
    const auto times = [in, factor](slong bits, const Ball& value) {
        const WorkingPrecision precision(bits);
        return value * factor(in);
    };
    Plan result;
    result.most_digits = choice.digits;
    result.refusal = choice.refusal;
    if (const recursion::Method* m = choice.method) {
        const auto proof = [&](const std::string& name, const auto& enclose, Accuracy most) {
            result.proofs.push_back({name, [=](Accuracy a) { return times(working_bits(a), enclose(*p, a)); }, most.digits});
        };
        proof(m->name, m->enclose, {any_digits});
        if (m->enclose_again) proof(m->second, m->enclose_again, looked_at_again({std::min(wanted.digits, choice.digits)}));
        result.shares = m->shares;
        // levels of a distribution cost seconds even for few digits
        result.dear = m->cost(*p, wanted) > dear_seconds || (p->asked != Asked::area && p->n > 1);
    }
    if (p->asked == Asked::density && p->n <= 1) return result; // what the closed form and the one integral refuse there has no value
    const auto seen = [=](const recursion::Observer& o, Accuracy a) {
        const Witness w = o.look(*p, a);
        return Witness{times(256, w.value), times(256, w.error)};
    };
    if (choice.method && choice.method->witness)
        result.own_witness = Look{choice.method->witness->name, [=, o = *choice.method->witness](Accuracy a) { return seen(o, a); }};
    for (const recursion::Observer& o : recursion::observers())
        result.witnesses.push_back({o.name, [=](Accuracy a) {
                                        if (const std::string refused = recursion::observers_refusal(*p); !refused.empty())
                                            throw BeyondReach(refused);
                                        return seen(o, a);
                                    }});
    return result;
}

/// One quantity of the recursion: `asked` of scale n - before.
Quantity quantity(Quantity q, Asked asked, Ask ask, Factor factor = one, long before = 0)
{
    for (recursion::Reach& r : recursion::reach(asked))
        q.certified.push_back(
            {before ? fmt::format("n - {} for n: {}", before, r.where) : r.where, r.digits, r.proof, r.second_look, r.shares});
    q.explain = [ask](const Inputs& in, long digits) {
        const Problem p = ask(in);
        const recursion::Choice choice = recursion::choose(p, {digits});
        return choice.method ? to_text(choice.method->budget(p, {std::min(digits, choice.digits)})) : std::string();
    };
    q.plan = [ask, factor](const Inputs& in, Accuracy wanted) { return plan(ask, factor, in, wanted); };
    return q;
}

} // namespace

void add_contact(std::vector<Quantity>& all)
{
    all.push_back(quantity({.name = "contact.area",
                            .equation = "6.7",
                            .unit = "lambda0",
                            .domain = fmt::format("n from 0 to 10^6, {}; {}", surface_domain, reach_in_words(Asked::area)),
                            .inputs = {"n", "load", "G"},
                            .description = "total contact area at scale n in one wavelength of the largest scale",
                            .check = check_area,
                            .exact = [](const Inputs& in) { return contact_exact::area(in, in.integer("n")); },
                            .routes = {}},
                           Asked::area, of_area));

    all.push_back(quantity({.name = "contact.exceedance",
                            .equation = "6.1",
                            .unit = "1",
                            .domain = fmt::format("n from 0 to 10^4, p >= 0, {}; p = 0 as contact.area, p > 0 {}", surface_domain,
                                                  reach_in_words(Asked::exceedance)),
                            .inputs = {"n", "p", "load", "G"},
                            .description = "share of lambda_0 on which the pressure at scale n exceeds p (in p*_0)",
                            .check = check_pressure,
                            .exact = contact_exact::exceedance,
                            .routes = {},
                            .costly = true},
                           Asked::exceedance, of_exceedance));

    all.push_back(quantity({.name = "contact.density",
                            .equation = "6.1",
                            .unit = "1/p*_0",
                            .domain = fmt::format("n from 0 to 10^4, p >= 0, {}; {}", surface_domain, reach_in_words(Asked::density)),
                            .inputs = {"n", "p", "load", "G"},
                            .description = "density q_n of the pressure at scale n, at p (in p*_0)",
                            .check = check_pressure,
                            .exact = contact_exact::density,
                            .routes = {},
                            .costly = true},
                           Asked::density, of_density));

    all.push_back(
        quantity({.name = "segments.density",
                  .equation = "9.3",
                  .unit = "1",
                  .domain = fmt::format(
                      "n from 1 to 10^4, 0 <= a <= 1/2, {}; certified or estimated where contact.density is at n - 1, p = G^n sin^2(pi a)",
                      surface_domain),
                  .inputs = {"n", "a", "load", "G"},
                  .description = "density of segments by half-width a (in lambda_n), N^_n lambda_n",
                  .check = check_half_width,
                  .exact = contact_exact::segment_density,
                  .routes = {},
                  .costly = true},
                 Asked::density, of_segments, pressure_by_half_width, 1));

    all.push_back(
        quantity({.name = "segments.count",
                  .equation = "8.1",
                  .unit = "1",
                  .domain = "n from 1 to 10^6, load > 0, 1 < D < 2, gamma > 1; certified or estimated where contact.area is at n - 1",
                  .inputs = {"n", "load", "D", "gamma"},
                  .description = "expected number of contact segments at scale n in one wavelength, A_{n-1}/lambda_n",
                  .check = check_count,
                  .exact = contact_exact::segment_count,
                  .routes = {}},
                 Asked::area, of_count, potential_segments, 1));
}

} // namespace touchstone
