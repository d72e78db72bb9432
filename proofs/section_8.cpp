// SPDX-License-Identifier: GPL-3.0-or-later
/// Section 8 of the paper: the number of contact segments and the dimension of the contact area.
#include "proofs/lemmas/area_bounds.hpp"
#include "proofs/lemmas/k_limit.hpp"
#include "proofs/ledger.hpp"
#include "proofs/symbolic/symbolic.hpp"
#include "proofs/symbolic/units.hpp"

#include "touchstone/paper/segments.hpp"
#include "touchstone/scalar/symbol.hpp"

namespace touchstone::proofs {

namespace {

using GiNaC::lst;

ex n() { return sym("n"); }
const Points at{"n=2 D=3/2 gamma=5 ptilde=1/3 K_nm1=1/2 K_infinity=2/5 lambda_0=2 A_nm1=1/3 epsilon=1/25"};

Finding number(const Print& p)
{
    return Argument("normal form")
        .add("dimensions", units(p))
        .add("the expected number: the share of the lambda_n-waves whose peak lies in the contact of the scale before, times "
             "lambda_0/lambda_n",
             identity(p("0.rhs"), sym("A_nm1") / sym("lambda_n"), Points{"A_nm1=1 lambda_n=2"}))
        .add("lambda_n from (3.2)", power_identity(p("0.rhs").subs(sym("lambda_n") == prints().at("3.2")("1.rhs")), p("1.rhs"), at))
        .conclude();
}

Finding hertz_number(const Print& p)
{
    // (7.18), corrected, at n - 1, times gamma^n
    const ex m = n() - 1;
    const ex area =
        sym("K_nm1") * pow(sym("gamma"), -(sym("D") - 1) * (m - 1 + pow(ex(2), -m))) * pow(sym("ptilde"), 1 - pow(ex(2), -(m + 1)));
    return Argument("logarithms in normal form, 2^-n adjoined")
        .add("dimensions", units(p))
        .add("(8.1) with the Hertzian area (7.18), corrected, at scale n - 1", power_identity(p("rhs"), area * pow(sym("gamma"), n()), at))
        .add("the library's form is the same at n = 3",
             power_identity(p("rhs").subs(n() == 3), archard::segments<Symbol>(3, sym("ptilde"), sym("D"), sym("gamma"), sym("K_nm1")), at))
        .conclude("for n >= 1");
}

Finding limiting_number(const Print& p)
{
    const ex ratio = prints().at("8.2")("rhs") / p("1.rhs") * sym("K_infinity") / sym("K_nm1");
    return Argument("logarithms in normal form; the limit of K_n")
        .add("dimensions", units(p))
        .add("K_{n-1}/K_inf -> 1", K_converges())
        .add("the rest of the ratio of (8.2) to the print is (gamma^(2(1-D))/ptilde)^(2^-n), which tends to 1",
             power_identity(ratio, pow(pow(sym("gamma"), 2 * (1 - sym("D"))) / sym("ptilde"), pow(ex(2), -n())), at))
        .add("the library's form is the same at n = 3",
             power_identity(p("1.rhs").subs(n() == 3),
                            archard::segments_limit<Symbol>(3, sym("ptilde"), sym("D"), sym("gamma"), sym("K_infinity")), at))
        .conclude("as the limiting form of the Hertzian number (8.2); for the model itself see text.defines-limit");
}

Finding scale(const Print& p)
{
    return Argument("logarithms in normal form")
        .add("dimensions", units(p))
        .add("lambda_n/lambda_0 from (3.2)",
             power_identity(p("0.rhs").subs(sym("lambda_n") == prints().at("3.2")("1.rhs")), p("1.rhs"), at))
        .conclude("names the scale; the second form follows from (3.2)");
}

Finding scale_number(const Print& p)
{
    return Argument("logarithms in normal form")
        .add("dimensions", units(p))
        .add("(8.4) solved for n", identity(p("rhs")
                                                .subs(log(sym("epsilon")) == log_form(prints().at("8.4")("1.rhs")))
                                                .subs(log(sym("gamma")) == log_form(sym("gamma"))),
                                            n(), Points{}))
        .add("at a point",
             compare_at(p("rhs").subs(sym("epsilon") == prints().at("8.4")("1.rhs")), n(), at).verdict == Verdict::refuted
                 ? Check{Verdict::refuted, compare_at(p("rhs").subs(sym("epsilon") == prints().at("8.4")("1.rhs")), n(), at).detail}
                 : Check{Verdict::proved, "both sides overlap in balls"})
        .conclude();
}

Finding number_of_scale(const Print& p)
{
    const ex e = prints().at("8.4")("1.rhs");
    return Argument("logarithms in normal form")
        .add("dimensions", units(p))
        .add("(8.3) with epsilon = gamma^-n", power_identity(p("rhs").subs(sym("epsilon") == e), prints().at("8.3")("1.rhs"), at))
        .conclude();
}

Finding dimension(const Print& p)
{
    const ex power = -GiNaC::normal(log_form(prints().at("8.6")("rhs")).diff(GiNaC::ex_to<GiNaC::symbol>(log_form(sym("epsilon")))));
    return Argument("normal form; two-sided bounds of the area")
        .add("dimensions", units(p))
        .add("the power of 1/epsilon in (8.6)", identity(p("rhs"), power, Points{"D=5/4"}))
        .add("the area (6.7) of the model itself lies between two constants times G^-n, so log N/log(1/epsilon) has the limit 1 - (D - 1)",
             area_bounds())
        .add("which is the same", identity(p("rhs"), 1 - (sym("D") - 1), Points{"D=5/4"}))
        .conclude("as the limit of log N/log(1/epsilon), both for (8.6) and for the model (6.7), for every load");
}

} // namespace

std::vector<Claim> section_8()
{
    const std::string hertz = "Hertzian contact at every scale, scales decoupled";
    return {
        {"8.1",
         "The expected number of contact segments at scale n.",
         "",
         number,
         {{"gamma^-n", {{"1.rhs", "gamma^n", "gamma^(-n)"}}}, {"lambda_n left out", {{"0.rhs", "/lambda_n", ""}}}},
         {},
         {"3.2"}},
        {"8.2",
         "The number of segments in the Hertzian approximation.",
         hertz,
         hertz_number,
         {{"D - 1 for 2(D - 1)", {{"rhs", "2*(D-1)", "(D-1)"}}},
          {"1 - D for 2 - D", {{"rhs", "(2-D)*n", "(1-D)*n"}}},
          {"2^-(n+1)", {{"rhs", "ptilde^(1-2^(-n))", "ptilde^(1-2^(-n-1))"}}}},
         {},
         {"7.16", "7.18", "8.1"}},
        {"8.3",
         "Its limiting form.",
         hertz,
         limiting_number,
         {{"D - 1 for 2(D - 1)", {{"1.rhs", "2*(D-1)", "(D-1)"}}},
          {"the square root of the load", {{"1.rhs", "*ptilde", "*ptilde^(1/2)"}}}},
         {},
         {"7.20", "8.2"}},
        {"8.4", "The dimensionless scale.", "", scale, {{"gamma^n", {{"1.rhs", "(-n)", "n"}}}}, {}, {"3.2"}},
        {"8.5",
         "n from the scale.",
         "",
         scale_number,
         {{"plus", {{"rhs", "-log", "log"}}}, {"twice", {{"rhs", "-log", "-2*log"}}}},
         {},
         {"8.4"}},
        {"8.6",
         "The limiting number as a power of the scale.",
         hertz,
         number_of_scale,
         {{"epsilon^(2-D)", {{"rhs", "-(2-D)", "(2-D)"}}}, {"D - 1 for 2(D - 1)", {{"rhs", "2*(D-1)", "(D-1)"}}}},
         {},
         {"8.3", "8.4"}},
        {"8.7",
         "The limiting dimension of the contact area.",
         "1 < D < 2, gamma > 1, every load",
         dimension,
         {{"3 - D", {{"rhs", "2", "3"}}}, {"D - 1", {{"rhs", "2-D", "D-1"}}}},
         {},
         {"6.7", "8.1", "8.6"}},
    };
}

} // namespace touchstone::proofs
