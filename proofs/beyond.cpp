// SPDX-License-Identifier: GPL-3.0-or-later
/// Not in the paper: the gap around the contact of section 2, its mean and the elastic energy, which contact codes
/// test too. The derivation is written out in touchstone/paper/gap.hpp; its steps are checked here.
#include "proofs/ledger.hpp"
#include "proofs/symbolic/symbolic.hpp"

#include "touchstone/paper/gap.hpp"
#include "touchstone/scalar/symbol.hpp"

namespace touchstone::proofs {
namespace {

using GiNaC::Pi;

ex derivative(const ex& e, const char* variable) { return e.diff(GiNaC::ex_to<GiNaC::symbol>(sym(variable))); }

const Points outside{"S=1/3 v=7/10 x=2/5 q=1/10", "S=1/5 v=9/10 x=1/3 q=1/7"};

Finding slope(const Print& p)
{
    const ex far = p("F.far");
    const ex left_over = far.subs(GiNaC::lst{sym("q") == 1, sym("S") == 1});
    Argument a("Westergaard's function of a complex variable");
    a.add("far above is a statement about q and S alone", exactly(GiNaC::is_a<GiNaC::numeric>(left_over.evalf()), p.text("F.far")));
    if (!GiNaC::is_a<GiNaC::numeric>(left_over.evalf())) return a.conclude();
    const Check as_printed = identity(pow(far - (pow(sym("q"), 2) - pow(sym("q"), -2)) / 2, 2),
                                      pow(sym("q") + 1 / sym("q"), 2) * (sym("S") + pow(sym("q") - 1 / sym("q"), 2) / 4), outside);
    a.argue("p and h' are real and imaginary part of one function F(z) = 2 cos(pi z) sqrt(S - sin^2 pi z) + i sin(2 pi z), analytic above "
            "the real line (gap.hpp, 1)");
    a.add("with q = exp(i pi z) it is as printed: (F - i sin(2 pi z))^2 = 4 cos^2(pi z) (S - sin^2(pi z))", as_printed);
    if (as_printed.verdict != Verdict::proved) return a.conclude();
    return a.add("far above F tends to the mean pressure S", limit_at_zero(far, sym("q"), p("F.at_infinity"), outside))
        .add("outside the contact it is the library's slope",
             identity(westergaard::gap_slope<Symbol>(sym("x"), sym("S")), p("rhs"), outside))
        .conclude("partial contact, S < 1; no tension, no gap in the contact");
}

Finding gap(const Print& p)
{
    return Argument("symbolic identity")
        .add("its derivative by v = sin(pi x) is 4 sqrt(v^2 - S), the slope over pi cos(pi x)",
             identity(derivative(p("rhs"), "v"), 4 * sqrt(pow(sym("v"), 2) - sym("S")), outside))
        .add("at the contact edge v = sqrt(S) it vanishes", identity(p("rhs").subs(sym("v") == sqrt(sym("S"))), 0, outside))
        .conclude("partial contact, outside the contact");
}

Finding mean_gap(const Print& p)
{
    return Argument("symbolic identity")
        .argue("the gap at the peak stays zero, so dC/dS = (2/pi) int log(2 sqrt(S) |sin phi|) dphi over half a turn = log S (gap.hpp, 4)")
        .add("dC/dS = log S", identity(derivative(p("rhs"), "S"), log(sym("S")), outside))
        .add("full contact leaves no gap: C(1) = 0", identity(p("rhs").subs(sym("S") == 1), 0, outside))
        .conclude("0 < S <= 1");
}

Finding energy(const Print& p)
{
    return Argument("symbolic identity")
        .add("the load's work is all there is, dU = -S dC with dC/dS = log S",
             identity(derivative(p("rhs"), "S"), -sym("S") * log(sym("S")), outside))
        .add("full contact: half of p* g/2, the mean of p u over a wavelength, is 1/4",
             identity(p("rhs").subs(sym("S") == 1), GiNaC::numeric(1, 4), outside))
        .conclude("0 < S <= 1; counted from the uniformly loaded half-plane");
}

} // namespace

std::vector<Claim> beyond()
{
    const std::string partial =
        "partial contact, 0 < S < 1; gap in g, lengths in lambda, pressure in p*, energy per unit nominal area in g p*";
    return {
        {"beyond.slope",
         "The slope of the gap outside the contact.",
         partial,
         slope,
         {{"2 for 4", {{"rhs", "4*Pi", "2*Pi"}}},
          {"sine unsquared", {{"rhs", "sin(Pi*x)^2", "sin(Pi*x)"}}},
          {"another mean pressure", {{"F.at_infinity", "S", "2*S"}}}},
         {},
         {"2.4", "2.5"}},
        {"beyond.gap",
         "The gap outside the contact.",
         partial,
         gap,
         {{"without the logarithm", {{"rhs", "-S*log((v+sqrt(v^2-S))/sqrt(S))", ""}}},
          {"4 for 2", {{"rhs", "2*(v", "4*(v"}}},
          {"S for sqrt(S)", {{"rhs", "/sqrt(S)", "/S"}}}},
         {},
         {"beyond.slope"}},
        {"beyond.mean-gap",
         "The mean gap over a wavelength.",
         partial,
         mean_gap,
         {{"plus for minus", {{"rhs", "1-S", "1+S"}}}, {"twice the logarithm", {{"rhs", "S*log", "2*S*log"}}}},
         {},
         {"beyond.gap"}},
        {"beyond.energy",
         "The elastic energy per unit nominal area.",
         partial,
         energy,
         {{"S for S^2", {{"rhs", "S^2", "S"}}},
          {"without the logarithm", {{"rhs", "(1-2*log(S))", "1"}}},
          {"1/2 for 1/4", {{"rhs", "/4", "/2"}}}},
         {},
         {"beyond.mean-gap"}},
    };
}

} // namespace touchstone::proofs
