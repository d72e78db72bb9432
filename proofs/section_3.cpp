// SPDX-License-Identifier: GPL-3.0-or-later
/// Section 3 of the paper: the Weierstrass profile and why full contact is out of reach.
#include "proofs/lemmas/elasticity.hpp"
#include "proofs/ledger.hpp"
#include "proofs/symbolic/symbolic.hpp"
#include "proofs/symbolic/units.hpp"

#include "touchstone/paper/weierstrass.hpp"
#include "touchstone/scalar/symbol.hpp"

namespace touchstone::proofs {

namespace {

using GiNaC::lst;
using GiNaC::Pi;

ex gamma() { return sym("gamma"); }
ex D() { return sym("D"); }
ex n() { return sym("n"); }

const Points surfaces{"gamma=5 D=3/2 n=2 x=1/7 lambda_0=2 g_0=1/3 E=5 nu=1/4", "gamma=7/2 D=5/4 n=3 x=2/7 lambda_0=3 g_0=1/2 E=7 nu=1/3"};

/// The n-th terms of (3.1) and the quantities (3.2), from the print.
ex term_of_profile() { return prints().at("3.1")("S.term"); }
ex printed_g_n() { return prints().at("3.2")("0.rhs"); }
ex printed_lambda_n() { return prints().at("3.2")("1.rhs"); }

Check geometric_sum(const ex& ratio, const ex& sum, const Points& at)
{
    // F(N) = sum (1 - ratio^N) has F(0) = 0 and F(N+1) - F(N) = ratio^N if sum (1 - ratio) = 1.
    return identity(sum * (1 - ratio), 1, at);
}

Finding profile(const Print& p)
{
    return Argument("normal form")
        .add("dimensions", units(p))
        .add("the amplitude ratio of successive terms is the library's",
             power_identity(p("S.term").subs(sym("x") == 0).subs(n() == n() + 1) / p("S.term").subs(sym("x") == 0),
                            weierstrass::amplitude_ratio<Symbol>(D(), gamma()), surfaces))
        .conclude(
            "the profile of the paper; the series converges absolutely for D < 2, which the paper leaves unsaid (text.fractal-domain)",
            Verdict::definition);
}

Finding amplitudes(const Print& p)
{
    const ex wave = term_of_profile() * sym("g_0");
    return Argument("logarithms in normal form")
        .add("dimensions", units(p))
        .add("g_n is the n-th term of (3.1) at x = 0", power_identity(p("0.rhs"), wave.subs(sym("x") == 0), surfaces))
        .add("2 pi x/lambda_n is the argument of its cosine",
             power_identity(2 * Pi * sym("y") / p("1.rhs"), 2 * Pi * pow(gamma(), n()) * sym("y") / sym("lambda_0"),
                            Points{"gamma=5 n=2 lambda_0=2 y=1/3"}))
        .conclude();
}

Finding profile_bound(const Print& p)
{
    Argument a("geometric series and the value at x = 0");
    a.add("dimensions", units(p));
    a.add("zhat of (3.4) is the sum of the amplitudes g_n",
          geometric_sum(pow(gamma(), D() - 2), prints().at("3.4")("rhs") / sym("g_0"), surfaces));
    a.note("each cosine lies between -1 and 1, so -zhat <= z(x) <= zhat");
    const bool strict = p.text("0.relation") == "<" || p.text("1.relation") == "<";
    // at x = 0 every cosine is 1
    const ex at_zero = term_of_profile().subs(sym("x") == 0);
    const Check equal = power_identity(at_zero, printed_g_n() / sym("g_0"), surfaces);
    if (strict && equal.verdict == Verdict::proved)
        a.add("z(0) < zhat", {Verdict::refuted, "at x = 0 every cosine is 1, so z(0) is the sum of the g_n, which is zhat: equality for "
                                                "all gamma and D; -zhat is reached too, at x = lambda_0/2 if gamma is an odd integer"});
    else
        a.add("equality is allowed: z(0) is the sum of the g_n", equal);
    a.add("the bounds are -zhat and zhat", identity(p("0.lhs") + p("1.rhs"), 0, Points{"zhat=2"}));
    return a.conclude();
}

Finding bound(const Print& p)
{
    return Argument("geometric series, normal form")
        .add("dimensions", units(p))
        .add("the partial sums of the g_n are zhat (1 - r^N), r = gamma^(D-2) < 1, by induction on N",
             geometric_sum(pow(gamma(), D() - 2), p("rhs") / sym("g_0"), surfaces))
        .add("the library's form is the same", identity(p("rhs") / sym("g_0"), weierstrass::bound<Symbol>(D(), gamma()), surfaces))
        .conclude("for gamma > 1 and D < 2; at D >= 2 the series diverges");
}

Finding scaling(const Print& p)
{
    const ex term = term_of_profile();
    const ex factor = p("rhs").coeff(sym("z_x"), 1);
    const ex rest = p("rhs").coeff(sym("z_x"), 0);
    const ex amplitude = term.subs(sym("x") == 0);
    return Argument("term by term, logarithms in normal form")
        .add("dimensions", units(p))
        .add("the amplitude of the n-th term at gamma x is gamma^(2-D) times that of term n + 1 at x",
             power_identity(amplitude, factor * amplitude.subs(n() == n() + 1), surfaces))
        .add("their phases agree: gamma^n gamma x = gamma^(n+1) x",
             power_identity(pow(gamma(), n()) * p("z_gx.argument").subs(sym("x") == sym("y")), pow(gamma(), n() + 1) * sym("y"),
                            Points{"gamma=3 n=2 y=1/2"}))
        .add("so z(gamma x) is gamma^(2-D) (z(x) - first term)", identity(rest, -factor * sym("g_0") * term.subs(n() == 0), surfaces))
        .conclude();
}

Finding successive(const Print& p)
{
    const auto before = [](const ex& e) { return e.subs(n() == n() - 1); };
    return Argument("logarithms in normal form")
        .add("dimensions", units(p))
        .add("g_{n-1}/g_n from (3.2)", power_identity(p("0.rhs"), before(printed_g_n()) / printed_g_n(), surfaces))
        .add("lambda_{n-1}/lambda_n from (3.2)", power_identity(p("1.rhs"), before(printed_lambda_n()) / printed_lambda_n(), surfaces))
        .conclude();
}

Finding full_pressure(const Print& p)
{
    const ex term = p("S.term");
    return Argument("superposition, term by term")
        .add("dimensions", units(p))
        .add("the n-th term is the oscillating part of (2.2) with p*_n and lambda_n",
             identity(term,
                      (prints().at("2.2")("rhs") - sym("pbar"))
                          .subs(lst{sym("pstar") == sym("pstar_n"), sym("lambda") == sym("lambda_0") * pow(gamma(), -n())}),
                      Points{"gamma=5 n=2 x=1/7 lambda_0=2 pstar_n=3"}))
        .add("the constant part is pbar", identity(p("rhs") - p("rhs").coeff(sym("S"), 1) * sym("S"), sym("pbar"), Points{"pbar=2"}))
        .add("each term enters once", identity(p("rhs").coeff(sym("S"), 1), 1, Points{"pbar=2"}))
        .conclude("as an identity between the terms, for every truncation of the profile; as an infinite sum the right side does not "
                  "converge (3.10), which is the paper's point: the postulate of full contact fails");
}

Finding pressure_amplitudes(const Print& p)
{
    return Argument("logarithms in normal form")
        .add("dimensions", units(p))
        .add("(2.3) with g_n and lambda_n of (3.2)",
             power_identity(p("rhs"), prints().at("2.3")("rhs").subs(lst{sym("g") == printed_g_n(), sym("lambda") == printed_lambda_n()}),
                            surfaces))
        .add("p*_{n+1}/p*_n is the library's G",
             power_identity(p("rhs").subs(n() == n() + 1) / p("rhs"), weierstrass::pressure_ratio<Symbol>(D(), gamma()), surfaces))
        .conclude();
}

Finding pressure_bound(const Print& p)
{
    Argument a("term by term");
    a.add("dimensions", units(p));
    a.note("each term of (3.7) lies between -p*_n and p*_n, and phat is the sum of the p*_n, finite for every truncation (and infinite "
           "without, when the statement is empty)");
    a.add("the bounds are pbar - phat and pbar + phat: their sum is 2 pbar",
          identity(p("0.lhs") + p("1.rhs"), 2 * sym("pbar"), Points{"pbar=2 phat=1"}));
    a.add("and their difference 2 phat", identity(p("1.rhs") - p("0.lhs"), 2 * sym("phat"), Points{"pbar=2 phat=1"}));
    // at x = 0 every cosine is 1, so the upper bound is reached and must not be strict
    a.add("the upper bound is reached at x = 0, so it must allow equality",
          exactly(p.text("1.relation") == "<=" && p.text("0.relation") == "<=",
                  "relations " + p.text("0.relation") + ", " + p.text("1.relation")));
    return a.conclude();
}

Finding pressure_sum(const Print& p)
{
    const ex factor = p("1.rhs").coeff(sym("S2"), 1);
    return Argument("term by term, logarithms in normal form")
        .add("dimensions", units(p))
        .add("phat is the sum of the p*_n: the value of the sum in (3.7) at x = 0",
             identity(p("S1.term"), prints().at("3.7")("S.term").subs(sym("x") == 0), Points{"pstar_n=2"}))
        .add("each p*_n of (3.8) is the common factor times the n-th power",
             power_identity(factor * p("S2.term"), prints().at("3.8")("rhs"), surfaces))
        .conclude("as an identity of the terms; the sum itself is infinite for D >= 1 (text.series-diverges)");
}

} // namespace

std::vector<Claim> section_3()
{
    const std::string surface = "gamma > 1, 1 < D < 2, g_0, lambda_0 > 0";
    return {
        {"3.1", "The profile is a Weierstrass series.", surface, profile, {}, {}, {}},
        {"3.2",
         "Amplitude and wavelength of the n-th term of (3.1).",
         surface,
         amplitudes,
         {{"D - 1 for D - 2", {{"0.rhs", "D-2", "D-1"}}}, {"lambda_n growing", {{"1.rhs", "(-n)", "n"}}}},
         {},
         {"3.1"}},
        {"3.3",
         "The profile lies strictly between -zhat and zhat.",
         surface,
         profile_bound,
         {},
         Correction{"wording",
                    "the strict sign <",
                    "-zhat <= z(x) <= zhat, with equality at x = 0",
                    {{"0.relation", "<", "<="}, {"1.relation", "<", "<="}},
                    "nothing inherits it; (3.9) has the right sign"},
         {"3.1", "3.4"}},
        {"3.4",
         "The bound of the profile is the sum of the amplitudes.",
         surface,
         bound,
         {{"plus", {{"rhs", "1-gamma", "1+gamma"}}}, {"D - 1 for D - 2", {{"rhs", "D-2", "D-1"}}}},
         {},
         {"3.2"}},
        {"3.5",
         "The scaling relation of the profile.",
         surface,
         scaling,
         {{"plus the cosine", {{"rhs", "-g_0", "+g_0"}}},
          {"D - 2 for 2 - D", {{"rhs", "gamma^(2-D)*z_x", "gamma^(D-2)*z_x"}}},
          {"the cosine without its factor", {{"rhs", "g_0*gamma^(2-D)", "g_0"}}}},
         {},
         {"3.1"}},
        {"3.6",
         "Ratios of successive amplitudes and wavelengths.",
         surface,
         successive,
         {{"D - 2 for 2 - D", {{"0.rhs", "2-D", "D-2"}}}, {"the inverse ratio of wavelengths", {{"1.rhs", "gamma", "gamma^(-1)"}}}},
         {},
         {"3.2"}},
        {"3.7",
         "In full contact the pressures of the waves superpose.",
         surface + "; full contact postulated",
         full_pressure,
         {{"gamma^(-n) for gamma^n", {{"S.term", "gamma^n", "gamma^(-n)"}}}, {"minus", {{"rhs", "+S", "-S"}}}},
         {},
         {"2.2", "3.1"}},
        {"3.8",
         "The pressure amplitude of the n-th wave.",
         surface,
         pressure_amplitudes,
         {{"D - 2 for D - 1", {{"rhs", "D-1", "D-2"}}}, {"without pi", {{"rhs", "Pi*", ""}}}},
         {},
         {"2.3", "3.2"}},
        {"3.9",
         "The full-contact pressure lies between pbar - phat and pbar + phat.",
         surface,
         pressure_bound,
         {{"strict", {{"1.relation", "<=", "<"}}}, {"half of phat", {{"1.rhs", "phat", "phat/2"}}}},
         {},
         {"3.7"}},
        {"3.10",
         "phat is the sum of the pressure amplitudes.",
         surface,
         pressure_sum,
         {{"D - 2 for D - 1", {{"S2.term", "D-1", "D-2"}}}, {"without pi", {{"1.rhs", "Pi*", ""}}}},
         {},
         {"3.8"}},
    };
}

} // namespace touchstone::proofs
