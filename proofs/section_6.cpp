// SPDX-License-Identifier: GPL-3.0-or-later
/// Section 6 of the paper: the recursion for the pressure distribution and the contact area.
#include "proofs/consequences.hpp"
#include "proofs/lemmas/area_bounds.hpp"
#include "proofs/ledger.hpp"
#include "proofs/symbolic/symbolic.hpp"
#include "proofs/symbolic/units.hpp"

#include "touchstone/paper/westergaard.hpp"
#include "touchstone/scalar/symbol.hpp"

namespace touchstone::proofs {

namespace {

using GiNaC::lst;
using GiNaC::Pi;

/// Section 2 with the substitutions (5.1).
ex at_scale_n(const ex& e) { return e.subs(lst{sym("p") == sym("p_n"), sym("pbar") == sym("p_nm1"), sym("pstar") == sym("pstar_n")}); }

const Points partial{"p_n=1/2 p_nm1=1/3 pstar_n=1 q_nm1=1", "p_n=3/4 p_nm1=1/2 pstar_n=3/2 q_nm1=2"};
const Points full{"p_n=7/4 p_nm1=3/2 pstar_n=1 q_nm1=1", "p_n=3 p_nm1=5/2 pstar_n=2 q_nm1=2"};
const Points any{"p_n=1/2 p_nm1=1/3 pstar_n=2 L=3 lambda=3 lambda_0=3"};

Finding recursion(const Print& p)
{
    return Argument("law of total probability")
        .add("dimensions", units(p))
        .add("the two ranges join at p*_n", identity(p("J1.to") - p("J2.from"), 0, any))
        .add("and cover all positive pressures",
             exactly(p("J1.from").is_zero() && p.text("J2.to") == "infinity", "from " + p.text("J1.from") + " to " + p.text("J2.to")))
        .add("both sum the conditional density times the density before",
             identity(p("J1.integrand") * p("J2.integrand"), pow(sym("q") * sym("q_nm1"), 2), Points{"q=2 q_nm1=3"}))
        .add("in partial contact the conditional law keeps the mean: with sin(pi x/lambda) = sqrt(load) sin psi in (2.4) pressure times "
             "weight is (4/pi) load cos^2 psi, whose integral over (0, pi/2) is load",
             force_weighting())
        .note("the model's recursion: it says how the densities of two scales are related under (5.1); out of contact the pressure stays "
              "zero")
        .conclude("the densities miss the share of the surface out of contact, which stays at zero pressure", Verdict::definition);
}

Finding partial_integral(const Print& p)
{
    Ring ring;
    ring.root("R", pow(sym("pstar_n") - sym("p_nm1"), 2) + pow(sym("p_n"), 2));
    const ex q = at_scale_n(prints().at("2.19")("1.rhs"));
    return Argument("normal form, the square root adjoined")
        .add("dimensions", units(p))
        .add("the integrand over pi is the density (2.19) under (5.1) times q_{n-1}: their squares",
             identity(pow(p("J.integrand") * p("rhs").coeff(sym("J"), 1), 2), pow(q * sym("q_nm1"), 2), partial, ring))
        .add("the range begins where the peak pressure 2 sqrt(p*_n p_{n-1}) is p_n",
             identity(4 * sym("pstar_n") * p("J.from"), pow(sym("p_n"), 2), any))
        .add("and ends with partial contact", identity(p("J.to"), sym("pstar_n"), any))
        .add("it is not empty if p_n < 2 p*_n", identity(p.sides("condition").back(), 2 * sym("pstar_n"), any))
        .conclude();
}

Finding no_partial_above(const Print& p)
{
    const ex highest = at_scale_n(prints().at("2.10")("rhs"));
    return Argument("normal form; positive coefficients")
        .add("dimensions", units(p))
        .add("the highest pressure in partial contact, 2 sqrt(p*_n p_{n-1}), is below 2 p*_n: the difference of the squares is 4 p*_n u at "
             "p*_n = p_{n-1} + u",
             identity((pow(2 * sym("pstar_n"), 2) - pow(highest, 2)).subs(sym("pstar_n") == sym("p_nm1") + sym("u")),
                      4 * (sym("p_nm1") + sym("u")) * sym("u"), Points{"p_nm1=1 u=1"}))
        .add("the condition says: above 2 p*_n", condition_says(p, "condition", sym("p_n"), ">", 2 * sym("pstar_n"), any))
        .add("so the conditional density (2.20) is 0 throughout the range of I_1, and there is nothing to sum",
             identity(p("rhs"), prints().at("2.20")("rhs"), any))
        .conclude();
}

/// (6.4), (6.5): the range of the full-contact integral.
Finding full_integral(const Print& p, bool above)
{
    const ex q = at_scale_n(prints().at("2.15")("1.rhs"));
    const ex s = sym("pstar_n");
    return Argument("normal form")
        .add("dimensions", units(p))
        .add("the integrand over pi is the density (2.15) under (5.1) times q_{n-1}",
             identity(pow(p("J.integrand") * p("rhs").coeff(sym("J"), 1), 2), pow(q * sym("q_nm1"), 2), full))
        .add("the upper end is where the least pressure p_{n-1} - p*_n is p_n", identity(p("J.to") - s, sym("p_n"), any))
        .add(above ? "the lower end is where the greatest pressure p_{n-1} + p*_n is p_n, above p*_n as p_n > 2 p*_n"
                   : "the lower end is where full contact begins, as p_n - p*_n < p*_n",
             identity(p("J.from"), above ? ex(sym("p_n") - s) : s, any))
        .add("the condition separates the two cases", identity(p.sides("condition").back(), 2 * s, any))
        .add("on its right side", exactly((p.text("condition").find('>') != std::string::npos) == above, p.text("condition")))
        .conclude();
}

Finding share_partial(const Print& p)
{
    const ex a = prints().at("2.5")("rhs").subs(lst{sym("pbar") == sym("p_nm1"), sym("pstar") == sym("pstar_n")});
    return Argument("normal form")
        .add("dimensions", units(p))
        .add("twice (2.5) over lambda under (5.1)", identity(p("rhs"), 2 * a / sym("lambda"), any))
        .add("the left side is 2a/lambda", identity(p("lhs"), 2 * sym("a") / sym("lambda"), Points{"a=1 lambda=3"}))
        .conclude("lambda stands for lambda_n; arcsin(...)^(1/2) is the arcsine of the square root");
}

Finding area(const Print& p)
{
    const ex share = prints().at("6.6")("rhs") * sym("q_nm1");
    return Argument("law of total probability")
        .add("dimensions", units(p))
        .add("the partial contacts are weighted by (6.6)", identity(p("rhs").coeff(sym("J1"), 1) * p("J1.integrand"), share, partial))
        .add("over 0 to p*_n", identity(p("J1.from") + p("J1.to"), sym("pstar_n"), any))
        .add("the full contacts by one", identity(p("rhs").coeff(sym("J2"), 1) * p("J2.integrand"), sym("q_nm1"), partial))
        .add("from p*_n on", identity(p("J2.from"), sym("pstar_n"), any))
        .add("for all higher pressures", exactly(p.text("J2.to") == "infinity", "to " + p.text("J2.to")))
        .add("the weight (6.6) is one at p_{n-1} = p*_n, so the two join",
             identity(prints().at("6.6")("rhs").subs(sym("p_nm1") == sym("pstar_n")), 1, any))
        .conclude("the letter L is not defined in the source text; as the words before say, it is the segment lambda_0");
}

Finding load(const Print& p)
{
    return Argument("normal form")
        .add("dimensions", units(p))
        .add("as in (5.12)", identity(p("rhs"), prints().at("5.12")("0.rhs"), Points{"pbar=2 pstar_0=3"}))
        .conclude("names the dimensionless load", Verdict::definition);
}

} // namespace

std::vector<Claim> section_6()
{
    const std::string decoupled = "scales decoupled by (5.1)";
    return {
        {"6.1",
         "The density at scale n sums the conditional densities over the pressures at scale n - 1.",
         decoupled,
         recursion,
         {{"a gap between the ranges", {{"J2.from", "pstar_n", "2*pstar_n"}}}},
         {},
         {"5.1"}},
        {"6.2",
         "The partial-contact integral written out.",
         decoupled + "; p_n < 2 p*_n",
         partial_integral,
         {{"another lower limit, the rest corrected",
           {{"J.integrand", "sqrt((pstar_n-p_nm1)+", "sqrt((pstar_n-p_nm1)^2+"}, {"J.from", "4*", "2*"}}}},
         Correction{"misprint",
                    "the inner square root: (p*_n - p_{n-1}) lacks its square",
                    "sqrt((p*_n - p_{n-1})^2 + p_n^2) inside the second brace",
                    {{"J.integrand", "sqrt((pstar_n-p_nm1)+", "sqrt((pstar_n-p_nm1)^2+"}},
                    consequence_of("6.2")},
         {"2.19", "5.1"}},
        {"6.3",
         "No partial contact gives a pressure above 2 p*_n.",
         decoupled,
         no_partial_above,
         {{"p*_n for 2 p*_n", {{"condition", "2*", ""}}}, {"one for zero", {{"rhs", "0", "1"}}}},
         {},
         {"2.10", "2.20", "5.1"}},
        {"6.4",
         "The full-contact integral written out, p_n < 2 p*_n.",
         decoupled,
         [](const Print& p) { return full_integral(p, false); },
         {{"another upper limit", {{"J.to", "p_n+pstar_n", "p_n"}}},
          {"the lower limit of (6.5)", {{"J.from", "pstar_n", "p_n-pstar_n"}}},
          {"plus under the root", {{"J.integrand", "-(p_n", "+(p_n"}}}},
         {},
         {"2.15", "5.1"}},
        {"6.5",
         "The full-contact integral written out, p_n > 2 p*_n.",
         decoupled,
         [](const Print& p) { return full_integral(p, true); },
         {{"the lower limit of (6.4)", {{"J.from", "p_n-pstar_n", "pstar_n"}}}, {"without 1/pi", {{"rhs", "1/Pi*", ""}}}},
         {},
         {"2.15", "5.1"}},
        {"6.6",
         "The share of a wave in contact, in partial contact.",
         decoupled + "; p_{n-1} < p*_n",
         share_partial,
         {{"1/pi for 2/pi", {{"rhs", "2/Pi", "1/Pi"}}},
          {"the square root of the arcsine", {{"rhs", "asin((p_nm1/pstar_n)^(1/2))", "asin(p_nm1/pstar_n)^(1/2)"}}}},
         {},
         {"2.5", "5.1"}},
        {"6.7",
         "The contact area sums the shares over the pressures at scale n - 1.",
         decoupled,
         area,
         {{"1/pi for 2/pi", {{"rhs", "2/Pi", "1/Pi"}}},
          {"full contact counted twice", {{"rhs", "+J2", "+2*J2"}}},
          {"from zero", {{"J2.from", "pstar_n", "0"}}}},
         {},
         {"6.6"}},
        {"6.8", "The dimensionless load.", "", load, {{"the inverse", {{"rhs", "pbar/pstar_0", "pstar_0/pbar"}}}}, {}, {}},
    };
}

} // namespace touchstone::proofs
