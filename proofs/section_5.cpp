// SPDX-License-Identifier: GPL-3.0-or-later
/// Section 5 of the paper: the pressure at the highest peaks, scale after scale.
#include "proofs/consequences.hpp"
#include "proofs/lemmas/fixed_point.hpp"
#include "proofs/ledger.hpp"
#include "proofs/symbolic/symbolic.hpp"
#include "proofs/symbolic/units.hpp"

#include "touchstone/paper/peaks.hpp"
#include "touchstone/paper/weierstrass.hpp"
#include "touchstone/scalar/symbol.hpp"

namespace touchstone::proofs {

namespace {

using GiNaC::lst;

/// Substitute gamma^(D-1) = G in a printed expression: its logarithm is linear in log gamma.
ex in_G(const ex& e) { return e.subs(sym("gamma") == pow(sym("G"), 1 / (sym("D") - 1))); }

Finding substitution(const Print& p)
{
    lst printed;
    for (std::size_t i = 0; i < p.parts(); ++i) printed.append(p(std::to_string(i) + ".lhs") == p(std::to_string(i) + ".rhs"));
    const ex at_scale_n = prints().at("2.15")("1.rhs").subs(printed);
    const Points at{"p_n=7/4 p_nm1=3/2 pstar_n=1 q_nm1=2 p=7/5 pbar=4/3 pstar=6/5"};
    return Argument("normal form")
        .add("dimensions", units(p))
        .add("with it the density (2.15) is the one under the integral (6.4)",
             identity(at_scale_n, prints().at("6.4")("J.integrand") / sym("q_nm1") / GiNaC::Pi, at))
        .conclude("the model: the pressure at scale n - 1 is the mean pressure of Westergaard's problem at scale n; good where gamma is "
                  "large, exact in the limit",
                  Verdict::definition);
}

Finding peak(const Print& p)
{
    const ex x = sym("x_nm1");
    const auto f = [](const char* id) { return prints().at(id)("rhs").subs(sym("x") == sym("x_nm1")); };
    const Points at{"pstar_n=3 x_nm1=1/3"}, above{"pstar_n=3 x_nm1=7/3"};
    const auto max = [&](const char* id) {
        return prints().at(id)("rhs").subs(lst{sym("pbar") == x * sym("pstar_n"), sym("pstar") == sym("pstar_n")});
    };
    const ex value = p("rhs");
    return Argument("normal form")
        .add("dimensions", units(p))
        .add("(2.9) with the substitutions (5.1), mean pressure x p*_n, x > 1",
             identity(value.subs(sym("f_x") == f("5.4")), max("2.9"), above))
        .add("(2.10) likewise, x < 1", identity(value.subs(sym("f_x") == f("5.5")), max("2.10"), at))
        .add("f increases, so the highest peak at scale n sits on the highest at scale n - 1: f' = 1 above 1",
             identity(prints().at("5.4")("rhs").diff(GiNaC::ex_to<GiNaC::symbol>(sym("x"))), 1, Points{"x=2"}))
        .add("and f^2 = 4x below 1", identity(pow(prints().at("5.5")("rhs"), 2), 4 * sym("x"), Points{"x=1/3"}))
        .conclude();
}

Finding ratio_definition(const Print& p)
{
    return Argument("dimensions").add("dimensions", units(p)).conclude("names the ratio of the peak pressure to p*_n", Verdict::definition);
}

/// One branch of f: judged with (5.2) against (2.9), (2.10).
Finding branch(const Print& p, const char* max)
{
    const ex S = sym("x");
    return Argument("normal form")
        .add("dimensions", units(p))
        .add("it is p^max/p* at pbar/p* = x",
             identity(p("rhs"), (prints().at(max)("rhs") / sym("pstar")).subs(sym("pbar") == S * sym("pstar")),
                      Points{"x=9/4 pstar=2", "x=1/3 pstar=2"}))
        .add("both branches are 2 at x = 1, where neither is printed", identity(p("rhs").subs(S == 1), 2, Points{"x=1"}))
        .conclude("names the function; its value at x = 1 follows by continuity", Verdict::definition);
}

Finding iteration(const Print& p)
{
    const ex ratio = p("1.rhs") / sym("f_x"), last = p("2.rhs") / sym("f_x");
    const auto p_star = [](const ex& n) { return prints().at("3.8")("rhs").subs(sym("n") == n); };
    const Points at{"gamma=5 D=3/2 n=2 E=3 nu=1/4 g_0=2 lambda_0=3"};
    return Argument("logarithms in normal form")
        .add("dimensions", units(p))
        .add("x_n is the peak pressure (5.2) over p*_{n+1}",
             identity(p("0.rhs"), sym("pmax_n") / sym("pstar_np1"), Points{"pmax_n=2 pstar_np1=3"}))
        .add("(5.2) in it", identity(p("1.rhs"), prints().at("5.2")("rhs") / sym("pstar_np1"), Points{"pstar_n=2 pstar_np1=3 f_x=2"}))
        .add("p*_n/p*_{n+1} from (3.8)",
             power_identity(ratio.subs(lst{sym("pstar_n") == p_star(sym("n")), sym("pstar_np1") == p_star(sym("n") + 1)}), last, at))
        .conclude();
}

Finding fixed_point_equation(const Print& p)
{
    return Argument("existence, uniqueness and convergence for all G = gamma^(D-1) > 1 at once")
        .add("it is (5.6) with x_n = x_{n-1} = x",
             power_identity(p("rhs").subs(sym("f_x") == sym("f")), pow(sym("gamma"), 1 - sym("D")) * sym("f"), Points{"gamma=5 D=3/2 f=2"}))
        .add("it has exactly one positive solution, and (5.6) converges to it",
             unique_fixed_point(prints().at("5.4")("rhs"), prints().at("5.5")("rhs")))
        .conclude();
}

Finding fixed_point_partial(const Print& p)
{
    const ex x = in_G(p("rhs")), G = sym("G");
    return Argument("normal form")
        .add("dimensions", units(p))
        .add("in G = gamma^(D-1) it is 4/G^2", power_identity(x, 4 / (G * G), Points{"G=3 D=3/2"}))
        .add("x = f(x)/G with the branch (5.5), which is the right one since 4/G^2 < 1 for G > 2",
             power_identity(x, 2 * sqrt(x) / G, Points{"G=3 D=3/2"}))
        .add("the condition is G > 2", power_identity(in_G(p.sides("condition").front()), G, Points{"G=3 D=3/2"}))
        .add("and ends at x_P = 1", identity(4 / pow(p.sides("condition").back(), 2), 1, Points{"G=2"}))
        .conclude();
}

Finding fixed_point_full(const Print& p)
{
    const ex G = sym("G"), x = p("rhs").subs(pow(sym("gamma"), sym("D") - 1) == G);
    return Argument("normal form")
        .add("dimensions", units(p))
        .add("x = f(x)/G with the branch (5.4)", identity(x, prints().at("5.4")("rhs").subs(sym("x") == x) / G, Points{"G=3/2"}))
        .add("the branch is the right one: x_P - 1 = (2 - G)/(G - 1) > 0 for 1 < G < 2",
             identity(x - 1, (2 - G) / (G - 1), Points{"G=3/2"}))
        .add("the condition ends at x_P = 1", identity(1 / (p.sides("condition").back() - 1), 1, Points{"G=3/2"}))
        .conclude();
}

Finding peak_at_large_n(const Print& p)
{
    // x_n = x_P for some n only if x_0 = x_P, since f is injective; so equality is a limit.
    const ex G = sym("G");
    Argument a("normal form and exact iteration");
    a.add("dimensions", units(p));
    a.add("in the limit: p_n^max/p*_n = f(x_{n-1}) tends to f(x_P) = G x_P",
          power_identity(p("rhs").subs(lst{sym("pstar_n") == 1, sym("x_P") == sym("y")}).subs(sym("gamma") == pow(G, 1 / (sym("D") - 1))),
                         G * sym("y"), Points{"G=3 D=3/2 y=1/2"}));
    a.add("convergence from every positive start", unique_fixed_point(prints().at("5.4")("rhs"), prints().at("5.5")("rhs")));
    // In partial contact throughout (G > 2, load < 1) x_n/x_P = (load/x_P)^(2^-(n+1)) exactly.
    const ex r = sym("r");
    a.add("in partial contact x_n/x_P is the square root of x_{n-1}/x_P, so it equals 1 only if it always did",
          power_identity(2 * sqrt(r * 4 / (G * G)) / G / (4 / (G * G)), sqrt(r), Points{"G=3 r=1/2"}));
    if (p.text("relation") == "=") {
        const Ball G_4(4), x = peaks::iterate(4, Ball(Rational(1, 64)), G_4), x_P = peaks::fixed_point(G_4);
        Check differs = less_than(x, x_P, "x_4 and x_P at G = 4 (gamma = 16, D = 3/2), load 1/64");
        if (differs.verdict == Verdict::proved)
            differs = {Verdict::refuted,
                       differs.detail + "; x_n/x_P = 16^-(2^-(n+1)) stays below 1 for every n: (5.10) is a limit, not an equality"};
        a.add("equality for sufficiently large n", differs);
    }
    return a.conclude("the ratio of both sides tends to 1");
}

/// The inequality a x_P < bound is equivalent to G > threshold.
Finding threshold_of_bound(const Print& p, const Rational& bound)
{
    const ex G = sym("G"), t = p("rhs");
    const GiNaC::numeric b(bound.get_str().c_str());
    return Argument("normal form")
        .add("dimensions", units(p))
        .add("the left side is G", power_identity(in_G(p("lhs")), G, Points{"G=3 D=3/2"}))
        .add("at the printed threshold x_P = 4/G^2 equals the bound", identity(4 / (t * t), b, Points{"G=3"}))
        .add("x_P decreases with G, so above the threshold it is smaller",
             exactly(p.text("relation") == ">", "the relation is " + p.text("relation")))
        .add("for G < 2, x_P = 1/(G - 1) > 1 is never below the bound: x_P - 1 = (2 - G)/(G - 1)",
             identity(1 / (G - 1) - 1, (2 - G) / (G - 1), Points{"G=3/2"}))
        .conclude();
}

/// The load that keeps every x_n below a bound: x_n lies between load and x_P.
Finding load_bound(const Print& p, const std::string& field, const Rational& bound)
{
    const GiNaC::numeric b(bound.get_str().c_str());
    Argument a("monotone iteration");
    a.add("dimensions", units(p));
    a.add("each x_n lies between load = x_{-1} and x_P, both below the bound",
          unique_fixed_point(prints().at("5.4")("rhs"), prints().at("5.5")("rhs")));
    a.add("the bound of the load is that of x_P", identity(p(field), b, Points{"x=1"}));
    a.add("from above", exactly(p.text(field == "1.rhs" ? "1.relation" : "0.relation") == "<", "the relation is <"));
    return a.conclude("with the condition on gamma^(D-1) before it");
}

} // namespace

std::vector<Claim> section_5()
{
    const std::string decoupled = "gamma >> 1, scales decoupled by (5.1)", all = "all G = gamma^(D-1) > 1";
    return {
        {"5.1",
         "Westergaard's solution applies at scale n with the local pressure of scale n - 1 as mean.",
         decoupled,
         substitution,
         {},
         {},
         {}},
        {"5.2",
         "The peak pressure at scale n.",
         decoupled,
         peak,
         {{"twice", {{"rhs", "pstar_n*f_x", "2*pstar_n*f_x"}}}},
         {},
         {"2.9", "2.10", "5.1", "5.4", "5.5"}},
        {"5.3", "The ratio of the peak pressure to the next p*.", decoupled, ratio_definition, {}, {}, {}},
        {"5.4",
         "f in full contact.",
         "x > 1",
         [](const Print& p) { return branch(p, "2.9"); },
         {{"minus", {{"rhs", "1+x", "1-x"}}}},
         {},
         {"2.9"}},
        {"5.5",
         "f in partial contact.",
         "0 < x < 1",
         [](const Print& p) { return branch(p, "2.10"); },
         {{"without the factor 2", {{"rhs", "2*", ""}}}},
         {},
         {"2.10"}},
        {"5.6",
         "The peak pressure ratio at one scale from that of the scale before.",
         decoupled,
         iteration,
         {{"D - 1 for 1 - D", {{"2.rhs", "1-D", "D-1"}}},
          {"p*_{n+1}/p*_n", {{"1.rhs", "pstar_n/pstar_np1", "pstar_np1/pstar_n"}, {"2.lhs", "pstar_n/pstar_np1", "pstar_np1/pstar_n"}}}},
         {},
         {"3.8", "5.2"}},
        {"5.7",
         "The fixed point equation of (5.6) has exactly one positive solution.",
         all,
         fixed_point_equation,
         {{"D - 1 for 1 - D", {{"rhs", "1-D", "D-1"}}}},
         {},
         {"5.4", "5.5", "5.6"}},
        {"5.8",
         "The fixed point in partial contact.",
         "gamma^(D-1) > 2",
         fixed_point_partial,
         {{"2 for 4", {{"rhs", "4/", "2/"}}},
          {"D - 1 for 2D - 2", {{"rhs", "2*D-2", "D-1"}}},
          {"another threshold", {{"condition", "> 2", "> 3"}}}},
         {},
         {"5.5", "5.7"}},
        {"5.9",
         "The fixed point in full contact.",
         "gamma^(D-1) < 2",
         fixed_point_full,
         {{"plus", {{"rhs", "gamma^(D-1)-1", "gamma^(D-1)+1"}}}, {"2 for 1", {{"rhs", "1/(", "2/("}}}},
         {},
         {"5.4", "5.7"}},
        {"5.10",
         "For sufficiently large n the peak pressure is p*_n gamma^(D-1) x_P.",
         all,
         peak_at_large_n,
         {{"without the power of gamma", {{"rhs", "*gamma^(D-1)", ""}, {"relation", "=", "->"}}}},
         Correction{"wording",
                    "the equality sign",
                    "p_n^max/(p*_n gamma^(D-1) x_P) -> 1 as n grows",
                    {{"relation", "=", "->"}},
                    consequence_of("5.10")},
         {"5.2", "5.7"}},
        {"5.11",
         "x_P < 0.2 if and only if gamma^(D-1) > sqrt(20).",
         all,
         [](const Print& p) { return threshold_of_bound(p, Rational(1, 5)); },
         {{"10 for 20", {{"rhs", "20", "10"}}}, {"without the root", {{"rhs", "sqrt(20)", "20"}}}},
         {},
         {"5.8", "5.9"}},
        {"5.12",
         "With (5.11), a load below 0.2 keeps every scale in the Hertzian range.",
         "gamma^(D-1) > sqrt(20)",
         [](const Print& p) { return load_bound(p, "1.rhs", Rational(1, 5)); },
         {{"0.3 for 0.2", {{"1.rhs", "0.2", "0.3"}}}, {"the inverse load", {{"0.rhs", "pbar/pstar_0", "pstar_0/pbar"}}}},
         {},
         {"5.6", "5.11"}},
        {"5.13",
         "x_P < 1 if and only if gamma^(D-1) > 2.",
         all,
         [](const Print& p) { return threshold_of_bound(p, Rational(1)); },
         {{"3 for 2", {{"rhs", "2", "3"}}}},
         {},
         {"5.8", "5.9"}},
        {"5.14",
         "With (5.13), a load below 1 keeps every scale in partial contact.",
         "gamma^(D-1) > 2",
         [](const Print& p) { return load_bound(p, "rhs", Rational(1)); },
         {{"2 for 1", {{"rhs", "1", "2"}}}},
         {},
         {"5.6", "5.13"}},
    };
}

} // namespace touchstone::proofs
