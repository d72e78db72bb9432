// SPDX-License-Identifier: GPL-3.0-or-later
/// Section 9 of the paper: the distribution of segment lengths.
#include "proofs/consequences.hpp"
#include "proofs/lemmas/fixed_point.hpp"
#include "proofs/ledger.hpp"
#include "proofs/symbolic/symbolic.hpp"
#include "proofs/symbolic/units.hpp"

namespace touchstone::proofs {

namespace {

using GiNaC::lst;
using GiNaC::Pi;

const Points at{"lambda_n=2 p_nm1=1/3 pstar_n=3/2 a_n=2/5 q_a=3 x_P=2/5"};

ex half_width()
{
    return prints().at("2.5")("rhs").subs(
        lst{sym("lambda") == sym("lambda_n"), sym("pbar") == sym("p_nm1"), sym("pstar") == sym("pstar_n")});
}

Finding longer_segments(const Print& p)
{
    const ex u = sym("u");
    return Argument("monotonicity, normal form")
        .add("dimensions", units(p))
        .add("the right side is the half-width (2.5) at p_{n-1} under (5.1)", identity(p("rhs"), half_width(), at))
        .note("arcsine and square root increase, so a higher pressure makes a longer segment")
        .add("the sign", exactly(p.text("relation") == ">", "the relation is " + p.text("relation")))
        .conclude();
}

Finding number_of_longer(const Print& p)
{
    const ex inverse = p("Q_a.argument");
    return Argument("normal form")
        .add("dimensions", units(p))
        .add("a segment per wave, where the pressure before exceeds p_{n-1}: 1/lambda_n times the share",
             identity(p("0.rhs"), sym("Q_p") / sym("lambda_n"), Points{"Q_p=1 lambda_n=2"}))
        .add("the second form has the same factor", identity(p("1.rhs").coeff(sym("Q_a"), 1), p("0.rhs").coeff(sym("Q_p"), 1), at))
        .add("its argument is (2.5) solved for the pressure: the half-width at it is a_n",
             identity(pow(sin(Pi * half_width().subs(sym("p_nm1") == inverse) / sym("lambda_n")), 2),
                      pow(sin(Pi * sym("a_n") / sym("lambda_n")), 2), at))
        .conclude();
}

Finding density_of_lengths(const Print& p)
{
    // -lambda_n d/da [Q(argument)/lambda_n] = q(argument) d(argument)/da
    const ex argument = prints().at("9.2")("Q_a.argument");
    Ring ring;
    ring.angle("w", Pi * sym("a_n") / sym("lambda_n"));
    return Argument("normal form")
        .add("dimensions", units(p))
        .add("the factor of N'_n", identity(p("0.rhs"), -sym("lambda_n") * sym("dN"), Points{"lambda_n=2 dN=3"}))
        .add("the derivative of (9.2), with q = -Q'",
             identity(p("1.rhs").coeff(sym("q_a"), 1), argument.diff(GiNaC::ex_to<GiNaC::symbol>(sym("a_n"))), at, ring))
        .add("at the same pressure", identity(p("q_a.argument"), argument, at))
        .conclude();
}

Finding longest(const Print& p)
{
    // (6.6)/(2.5) at p_{n-1}^max = p*_n x_{n-1}, x_{n-1} -> x_P
    const ex limit = half_width().subs(sym("p_nm1") == sym("x_P") * sym("pstar_n"));
    return Argument("normal form")
        .add("dimensions", units(p))
        .add("(6.6) at the highest pressure: p_{n-1}^max/p*_n = x_{n-1} tends to x_P", identity(p("rhs"), limit, at))
        .add("convergence", unique_fixed_point(prints().at("5.4")("rhs"), prints().at("5.5")("rhs")))
        .conclude("as a limit, like (5.10): at finite n it is x_{n-1} that stands under the root");
}

} // namespace

std::vector<Claim> section_9()
{
    const std::string partial = "gamma^(D-1) > 2, load < 1: partial contact at every scale";
    return {
        {"9.1",
         "Where the pressure is higher, the segments are longer.",
         partial,
         longer_segments,
         {{"without the square root", {{"rhs", "^(1/2)", ""}}}, {"the other sign", {{"relation", ">", "<"}}}},
         {},
         {"2.5", "5.1"}},
        {"9.2",
         "The number of segments longer than given.",
         partial,
         number_of_longer,
         {{"the sine unsquared", {{"Q_a.argument", "^2", ""}}}, {"2 pi", {{"Q_a.argument", "Pi*", "2*Pi*"}}}},
         {},
         {"2.5", "9.1"}},
        {"9.3",
         "The density of the half-lengths.",
         partial,
         density_of_lengths,
         {{"twice", {{"1.rhs", "Pi*pstar_n", "2*Pi*pstar_n"}}},
          {"pi for 2 pi in the sine", {{"1.rhs", "2*Pi", "Pi"}}},
          {"cosine", {{"1.rhs", "sin", "cos"}}}},
         {},
         {"9.2"}},
        {"9.4",
         "The longest segments at large n.",
         partial,
         longest,
         {{"corrected, but 2 lambda_n/pi", {{"rhs", "asin(x_P)", "asin(sqrt(x_P))"}, {"rhs", "lambda_n/Pi", "2*lambda_n/Pi"}}}},
         Correction{"misprint",
                    "the argument of arcsin lacks a square root",
                    "a_n^max = (lambda_n/pi) arcsin(sqrt(x_P)), as a limit for large n",
                    {{"rhs", "asin(x_P)", "asin(sqrt(x_P))"}},
                    consequence_of("9.4")},
         {"5.8", "5.10", "6.6"}},
    };
}

} // namespace touchstone::proofs
