// SPDX-License-Identifier: GPL-3.0-or-later
#include "proofs/sentences/wording.hpp"

#include "proofs/lemmas/area_bounds.hpp"
#include "proofs/lemmas/limit_values.hpp"
#include "proofs/sentences/sentences.hpp"
#include "proofs/symbolic/symbolic.hpp"

#include "touchstone/paper/peaks.hpp"

namespace touchstone::proofs {

namespace {

/// "As found by Borri-Brunetto et al.": section 1 says what they found.
Finding as_found(const Print& p)
{
    return Argument("the text compared with itself")
        .add("what section 1 says they found is a dimension below two, of an area",
             exactly(p.text("lhs") == "dimension_found_below" && p.text("relation") == "=" && p.text("rhs") == "2",
                     "printed " + p.text("relation") + " " + p.text("rhs")))
        .conclude("section 1: 'the actual contact area appears to be a fractal with dimension below two'; section 10 says why the two "
                  "differ by one");
}

/// (6.7) divides by L, A_n is defined in the segment lambda_0.
Finding segment(const Print& p)
{
    return Argument("the text compared with itself")
        .add("A_n is the sum of the contact segments 'in the segment lambda_0'",
             exactly(p.text("lhs") == "segment_of_A_n" && p.text("relation") == "=" && p.text("rhs") == "lambda_0",
                     "printed " + p.text("relation") + " " + p.text("rhs")))
        .conclude("L occurs nowhere else; figure 3 and section 7 have A_n/lambda_0");
}

/// A reference's last page comes after its first.
Finding pages(const Print& p)
{
    const Check order = less_than(evaluate(p("lhs"), Point{}), evaluate(p("rhs"), Point{}), "the pages");
    return Argument("exact arithmetic")
        .add("an article's first page is 2501", exactly(p.text("lhs") == "2501", p.text("lhs")))
        .add("and comes before its last", p.text("relation") == "<" ? order : Check{Verdict::refuted, "printed " + p.text("relation")})
        .conclude("the order only: the last page itself is the journal's to say");
}

/// N of (8.1) with the areas of the model over (8.6): A_{n-1} over (7.21).
Finding converges_on_limit(const Print& p)
{
    return Argument("bounds of the area, all n")
        .add("for G > 2, load < 1: N_n epsilon^(2-D)/load has one limit for all loads, as A_n G^n/load does", one_limiting_law())
        .add("the limit of N_n over (8.6) is at least 1 + pi/(24 G^2 K_inf)", hertz_from_below())
        .add("and at most (2/pi) (8 G/pi^2 + (pi/2 - 1) 2/G)/(K_inf G)", area_from_above())
        .add("gamma = 5, D = 3/2 (figure 4c): the limiting ratio of N_n to (8.6), certified", number_satisfies(limiting_ratio(5), p, "it"))
        .add("gamma = 10, D = 3/2 (figure 4d)", number_satisfies(limiting_ratio(10), p, "it"))
        .conclude("the slope of (8.6) is exact, its constant is that of (7.21) and not the model's (text.defines-limit)");
}

/// How many scales a whole wave can stay in full contact, in the limit: 1 + G + ... + G^m > x_P.
long scales_in_full_contact(const Ball& G)
{
    const Ball most = peaks::fixed_point(G);
    Ball sum(1), term(1);
    long m = 0;
    while (!certainly(less(most, sum))) {
        term *= G;
        sum += term;
        ++m;
    }
    return m;
}

Finding sizes_decrease(const Print&)
{
    const long a = scales_in_full_contact(pow(Ball(5), Ball(Rational(1, 20)))),
               b = scales_in_full_contact(pow(Ball(10), Ball(Rational(1, 20))));
    return Argument("the least load ratio of a wave")
        .add("a wave of load ratio x is in full contact, itself and its next m scales, only for x >= 1 + G + ... + G^m (text.starts-full)",
             identity((pow(G(), 3) - 1) / (G() - 1), 1 + G() + G() * G(), Points{"G=3"}))
        .conclude("the largest load ratio tends to x_P, so at large n no region of full contact holds a whole wave that is more than " +
                      std::to_string(a) + " scales coarser at D = 1.05, gamma = 5 (figure 3a), " + std::to_string(b) +
                      " at gamma = 10 (figure 3b): sizes decrease with lambda_n. Not 'at each scale' at first: for loads above 1 + G the "
                      "whole surface is in full contact at n = 0 and at n = 1",
                  Verdict::qualitative);
}

} // namespace

std::vector<Claim> sentences_about_the_text()
{
    return {
        {"text.as-found",
         "Borri-Brunetto et al. found a dimension below one.",
         "",
         as_found,
         {{"three", {{"rhs", "1", "3"}}}},
         Correction{"wording",
                    "'less than unity, as found by': what they found (section 1) is below two, for an area and not a line",
                    "dimension below two, for a contact area in three dimensions",
                    {{"rhs", "1", "2"}},
                    "nothing"},
         {}},
        {"text.sizes-decrease",
         "The regions of full contact become smaller at each scale.",
         the_model + ", 1 < gamma^(D-1) < 2",
         sizes_decrease,
         {},
         {},
         {"text.starts-full", "5.9"}},
        {"text.segment-L",
         "The total area is that in the segment L.",
         "",
         segment,
         {{"another wavelength", {{"rhs", "L", "lambda_n"}}}},
         Correction{"wording",
                    "L, which is not defined",
                    "lambda_0, the segment that A_n is defined for",
                    {{"rhs", "L", "lambda_0"}},
                    "nothing: A_n/lambda_0 is what is plotted and used"},
         {}},
        {"text.converges-on-8.6",
         "The numbers of segments of the model converge on (8.6).",
         the_model,
         converges_on_limit,
         {{"to half of it", {{"relation", "=", "<"}}}},
         Correction{"substance",
                    "the constant of (8.6)",
                    "N_n over (8.6) tends to a limit above one, the same as that of text.defines-limit",
                    {{"relation", "=", ">"}},
                    "the slope, the dimension 2 - D, is right; the number of segments is not"},
         {"8.1", "8.6", "text.defines-limit"}},
        {"text.lopez-pages",
         "The pages of the reference to Lopez et al. are in order.",
         "",
         pages,
         {{"the other way", {{"relation", "<", ">"}}}},
         Correction{"misprint",
                    "2501-2219: the last page comes before the first",
                    "2501-2519, if one digit is wrong",
                    {{"rhs", "2219", "2519"}},
                    "nothing"},
         {}},
    };
}

} // namespace touchstone::proofs
