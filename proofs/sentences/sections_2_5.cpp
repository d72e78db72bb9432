// SPDX-License-Identifier: GPL-3.0-or-later
/// The checkable sentences up to section 5, and those that repeat them.
#include "proofs/lemmas/area_bounds.hpp"
#include "proofs/lemmas/fixed_point.hpp"
#include "proofs/lemmas/k_limit.hpp"
#include "proofs/lemmas/limit_values.hpp"
#include "proofs/lemmas/model_area.hpp"
#include "proofs/lemmas/non_hertzian.hpp"
#include "proofs/sentences/sentences.hpp"
#include "proofs/symbolic/symbolic.hpp"
#include "proofs/symbolic/units.hpp"

#include "touchstone/paper/archard.hpp"
#include "touchstone/paper/peaks.hpp"
#include "touchstone/paper/weierstrass.hpp"
#include "touchstone/scalar/symbol.hpp"

namespace touchstone::proofs {

namespace {

using GiNaC::lst;
using GiNaC::Pi;

Finding area_decreases(const Print& p)
{
    Argument a("positivity of the transfer operator");
    const ex times = GiNaC::normal(p("rhs") / sym("A_n")); // A_{n+1} and this many A_n
    const bool successive = p.text("lhs") == "A_np1" && GiNaC::is_a<GiNaC::numeric>(times.evalf());
    a.add("it speaks of successive scales", exactly(successive, p.text("lhs") + ", " + p.text("rhs")));
    if (!successive) return a.conclude();
    const Ball factor = evaluate(times, Point{});
    a.add("the share of a wave in contact is at most one, (6.6): arcsin is at most pi/2",
          identity(prints().at("6.6")("rhs").subs(lst{sym("p_nm1") == sym("pstar_n")}), 1, Points{"pstar_n=2"}));
    a.argue("with A_n/lambda_0 = (T^(n+1) 1)(load), T positive and T1 <= 1: T^(n+1) 1 - T^n 1 = T^n (T1 - 1) <= 0");
    const std::string& relation = p.text("relation");
    const std::string full = "while contact is full, load >= 1 + G + ... + G^n (text.starts-full), both are lambda_0";
    if (relation == "<" || relation == "<=") {
        if (times.is_equal(1) ? relation == "<" : !certainly(less(Ball(1), factor)))
            a.add("A_{n+1} " + relation + " " + p.text("rhs") + " at every scale", {Verdict::refuted, full});
    } else { // A_0 = 1/3 at load 1/4; A_1 <= load max(load^(-1/2), G)/G = 1/4 at G = 4
        Check worse = less_than(Ball(Rational(1, 4)), factor * 2 * asin(Ball(Rational(1, 2))) / pi<Ball>(),
                                "A_1 <= 1/4 and A_0 at G = 4, load 1/4");
        if (worse.verdict != Verdict::proved && relation == "=") worse = {Verdict::proved, full};
        a.add("A_{n+1} " + relation + " " + p.text("rhs"),
              worse.verdict == Verdict::proved ? opposite(worse) : between_proof_and_counterexample());
    }
    return a.conclude("strictly once some contact is partial; A_n stays lambda_0 while contact is full (text.starts-full)");
}

Finding slopes_at_low_n(const Print& p)
{
    return Argument("bounds of A_1/A_0")
        .add("A_1/A_0 <= sqrt(2 G) load^(1/4)/G, below 1/G for load < 1/(4 G^2) (text.light-load-steeper)", inverse_root_moment())
        .add("A_1 = A_0 = lambda_0 for load >= 1 + G (text.starts-full): slope 0",
             identity((G() * G() - 1) / (G() - 1), 1 + G(), Points{"G=3"}))
        .add("so the slope grows from the small loads to the large", says_less(p, "log A_1/A_0 < -log G < 0"))
        .conclude();
}

Finding probability(const Print& p)
{
    const ex S = sym("S");
    const ex Q = prints().at("2.17")("rhs").subs(lst{sym("p") == 0, sym("pbar") == S * sym("pstar")});
    return Argument("normal form")
        .add("full contact: the density integrates to Q(pbar - p*) = arccos(-1)/pi", identity(p("0.rhs"), acos(ex(-1)) / Pi, Points{"S=1"}))
        .add("partial contact: to Q(0+) of (2.17), where the inner root is 1 - S",
             identity(p("1.rhs"), Q.subs(sqrt(pow(1 - S, 2)) == 1 - S), Points{"S=1/3 pstar=2"}))
        .conclude("in partial contact the rest of the probability, 1 - (2/pi) arcsin sqrt(pbar/p*), sits at pressure zero and is not in "
                  "the density");
}

Finding fractal_domain(const Print& p)
{
    Argument a("geometric series");
    a.add("gamma > 1, D > 1", exactly(p.text("0.rhs") == "1", "D > " + p.text("0.rhs")));
    if (p.text("1.rhs") == "infinity" || certainly(less(Ball(2), evaluate(p("1.rhs"), Point{})))) {
        const Check ratio_one = power_identity(weierstrass::amplitude_ratio<Symbol>(ex(2), sym("gamma")), ex(1), Points{"gamma=3"});
        a.add("the series converges for every D > 1",
              opposite({ratio_one.verdict, ratio_one.detail + ": at x = 0 and D = 2 every term of (3.1) is 1, and the series diverges"}));
    } else {
        a.add("the ratio of successive amplitudes is gamma^(D-2), below one exactly for D < 2",
              power_identity(weierstrass::amplitude_ratio<Symbol>(sym("D"), sym("gamma")) * pow(sym("gamma"), 2 - sym("D")), ex(1),
                             Points{"gamma=3 D=3/2"}));
        a.add("and the print says so of all of these D", exactly(p.text("1.rhs") == "2", "D < " + p.text("1.rhs")));
    }
    return a.conclude("what is proved is that the series converges; that its graph has box dimension D is known from the literature and "
                      "not checked here");
}

Finding series_diverges(const Print& p)
{
    const Rational b = p.rational("1.rhs");
    Argument a("ratio of successive terms");
    a.add("p*_{n+1}/p*_n = gamma^(D-1)",
          power_identity(prints().at("3.10")("S2.term").subs(n() == n() + 1) / prints().at("3.10")("S2.term"),
                         pow(sym("gamma"), sym("D") - 1), Points{"gamma=5 D=3/2 n=2"}));
    if (b >= 1) {
        a.note("for D > 1 the ratio exceeds one and the terms grow");
    } else {
        const Rational D = (b + 1) / 2;
        a.add("the terms do not tend to zero",
              opposite(
                  less_than(pow(Ball(5), Ball(Rational(D - 1))), Ball(1),
                            "at gamma = 5, D = " + D.get_str() + " the ratio of successive terms is below one and the series converges")));
    }
    return a.conclude();
}

Finding no_full_contact(const Print& p)
{
    const ex a = sym("a"), b = sym("b");
    Argument arg("mean against a non-negative weight");
    Ring ring;
    const auto [sa, ca] = ring.angle("a", a);
    const auto [sb, cb] = ring.angle("b", b);
    arg.add("cos a cos b is the mean of cos(a + b) = ca cb - sa sb and cos(a - b) = ca cb + sa sb",
            identity(ca * cb, ((ca * cb - sa * sb) + (ca * cb + sa * sb)) / 2, Points{"a=1 b=2"}, ring));
    arg.argue("so over the whole line the mean of cos(2 pi gamma^i x/lambda_0) cos(2 pi gamma^j x/lambda_0) is 1/2 for i = j and 0 "
              "otherwise (gamma > 1: the frequencies differ)");
    arg.argue("the weight 1 - cos(2 pi gamma^N x/lambda_0) >= 0 has mean one; the mean of (3.7) times it is pbar - p*_N/2, for every "
              "truncation beyond N: the least pressure is at most that");
    arg.add("p*_N grows without bound: p*_{N+1}/p*_N = gamma^(D-1) > 1",
            power_identity(prints().at("3.8")("rhs").subs(n() == n() + 1) / prints().at("3.8")("rhs"), pow(sym("gamma"), sym("D") - 1),
                           Points{"gamma=5 D=3/2 n=2 E=1 nu=1/4 g_0=1 lambda_0=1"}));
    // The print: the limit of the least pressure is a multiple of infinity, or a number.
    const ex infinity = sym("infinity"), factor = p("rhs").coeff(infinity, 1);
    arg.add("it speaks of the limit of the least pressure",
            exactly(p.text("lhs") == "p_min_limit" && p.text("relation") == "=", p.text("lhs") + " " + p.text("relation")));
    if (!factor.is_zero())
        arg.add("which is minus infinity", less_than(evaluate(factor, Point{}), Ball(0), "the factor of infinity"));
    else if (!GiNaC::is_a<GiNaC::numeric>(p("rhs")))
        arg.add("which is minus infinity", {Verdict::refuted, "a limit that depends on " + p.text("rhs")});
    else
        arg.add("the least pressure stays above " + p.text("rhs"),
                opposite(less_than(Ball(10) - pow(Ball(5), Ball(2)) / 2, evaluate(p("rhs"), Point{}),
                                   "gamma = 5, D = 3/2, pbar = 10 p*_0, N = 4: pbar - p*_N/2 and the bound")));
    return arg.conclude("linear superposition (3.7) for gamma > 1, D > 1: for every pbar the truncated full-contact pressure is negative "
                        "somewhere once p*_N > 2 pbar");
}

/// The constant term of sum_{n<N} cos(3^n t) prod_{m<N} (1 - cos(3^m t)), exactly.
Rational riesz_mean(int N)
{
    std::map<long, Rational> weight{{0, Rational(1)}};
    long f = 1;
    for (int m = 0; m < N; ++m, f *= 3) {
        std::map<long, Rational> next;
        for (const auto& [k, c] : weight) {
            next[k] += c;
            next[k + f] -= c / 2;
            next[k - f] -= c / 2;
        }
        weight = std::move(next);
    }
    Rational mean = 0;
    f = 1;
    for (int m = 0; m < N; ++m, f *= 3) {
        if (weight[f] != weight[-f]) return 0; // both halves of a cosine
        mean += weight[f];
    }
    return mean;
}

Finding divergence_at_D_1(const Print& p)
{
    const Rational D = p.rational("rhs");
    Argument a("Riesz product, exact arithmetic");
    if (D < 1) {
        a.add("the series diverges at D = " + D.get_str(),
              opposite(less_than(pow(Ball(3), Ball(Rational(D - 1))), Ball(1),
                                 "the ratio of its terms at gamma = 3 is below one: a finite pbar gives full contact")));
        return a.conclude();
    }
    a.add("at D = 1 the terms of (3.10) are all one",
          power_identity(prints().at("3.10")("S2.term").subs(sym("D") == 1), ex(1), Points{"gamma=3 n=2"}));
    bool right = true;
    for (int N = 1; N <= 8; ++N) right = right && riesz_mean(N) == Rational(-N) / 2;
    a.add("gamma = 3: the weight prod_{m<N} (1 - cos 3^m t) >= 0 has mean one and gives (3.7) the mean pbar - N p*_0/2, checked exactly "
          "for N <= 8",
          exactly(right, "constant terms -N/2"));
    a.argue("for every N: each integer is in one way only a sum of distinct +-3^m, so the weight's Fourier coefficient at 3^n is -1/2");
    return a.conclude("for N > 2 pbar/p*_0 the pressure is negative somewhere: 'can be defined' is shown by gamma = 3");
}

Finding dimension_below_one(const Print& p)
{
    // Smith-Volterra-Cantor set: from each of 2^(k-1) intervals the middle 4^-k is removed.
    Rational length = 1, removed = 0;
    bool right = true;
    for (int k = 1; k <= 60; ++k) {
        const Rational middle = power(Rational(1, 4), k);
        removed += power(Rational(2), k - 1) * middle;
        length = (length - middle) / 2;
        right = right && removed == (1 - power(Rational(1, 2), k)) / 2 && length * power(Rational(2), k) == 1 - removed;
    }
    Argument a("exact counterexample");
    if (p.text("relation") == "<")
        a.add("a closed set without intervals has dimension below one",
              opposite(exactly(right,
                               "removing the middle 4^-k of each of 2^(k-1) intervals leaves a closed set without intervals (their lengths "
                               "are below 2^-k) of length 1/2, so of dimension one; lengths exact for k <= 60, by induction for all k")));
    else
        a.add("a set on a line has dimension at most one", exactly(right, "trivially; one is reached without any interval"));
    return a.conclude();
}

Finding pstar_increases(const Print& p)
{
    return Argument("logarithms in normal form")
        .add("the ratio is gamma^(D-1)",
             power_identity(prints().at("3.8")("rhs").subs(n() == n() + 1) / prints().at("3.8")("rhs"), pow(sym("gamma"), sym("D") - 1),
                            Points{"gamma=5 D=3/2 n=2 E=1 nu=1/4 g_0=1 lambda_0=1"}))
        .add("and exceeds one for gamma > 1, D > 1", says_greater(p, "the logarithm (D - 1) log gamma is positive"))
        .conclude();
}

Finding mean_pressure(const Print& p)
{
    return Argument("integrals of the one-scale law")
        .add("one scale keeps the mean: in both regimes the mean of y is x/G, so that of p_n is p_{n-1}", force_weighting())
        .add("so it is pbar at every scale", stated(p, sym("pbar"), Points{"pbar=2"}))
        .conclude("averaged over the whole surface, the parts out of contact at zero pressure included");
}

Finding hertzian_share(const Print& p)
{
    Argument a("bounds on the force-weighted chain");
    a.add("for 1 < G < sqrt(20) the share of non-Hertzian contacts stays above a positive number", non_hertzian_share_stays());
    const Ball outside_at_5 = limiting_share_outside_hertz(5), outside_at_10 = limiting_share_outside_hertz(10);
    a.add("the limiting share of contacts with p_{n-1}/p*_n < 0.2 at gamma = 5, D = 3/2 (figure 3c), certified",
          share_satisfies(1 - outside_at_5, p, "it"));
    a.add("which is above what the bounds leave", within(outside_at_5, hull(least_non_hertzian_share(root(5)), Ball(1))));
    a.add("and at gamma = 10 (figure 3d)", share_satisfies(1 - outside_at_10, p, "it"));
    const Ball low_at_5 = limiting_share_outside_hertz_low_D(5), low_at_10 = limiting_share_outside_hertz_low_D(10);
    a.add("at D = 1.05 and gamma = 5 (figure 3a), certified", share_satisfies(1 - low_at_5, p, "it"));
    a.add("and at gamma = 10 (figure 3b)", share_satisfies(1 - low_at_10, p, "it"));
    const auto outside = [](long gamma) { return share_outside_hertz(3, Rational(1, 10), gamma).to_string(4); };
    return a.conclude("at n = 4 and load 0.1 the share outside the Hertzian range is " + outside(5) + " at D = 1.5, gamma = 5 and " +
                      outside(10) +
                      " at gamma = 10, in the limit " + outside_at_5.to_string(4) + " and " + outside_at_10.to_string(4) +
                      "; at D = 1.05 in the limit " + low_at_5.to_string(4) + " and " + low_at_10.to_string(4) +
                      " (all certified). The load ratio of the contacting asperities has a limiting law that depends on G alone; its "
                      "largest value is x_P. Only for gamma^(D-1) > sqrt(20), where (5.11) holds, are all contacts Hertzian at large n");
}

Finding iteration_converges(const Print& p)
{
    return Argument("two cases, ten inequalities by normal form")
        .add("existence, uniqueness and monotone convergence for all gamma^(D-1) > 1", unique_fixed_point(p("0.rhs"), p("1.rhs")))
        .add("the branches are (5.4) and (5.5)",
             identity(p("0.rhs") - p("1.rhs"), prints().at("5.4")("rhs") - prints().at("5.5")("rhs"), Points{"x=2"}))
        .conclude("for every positive start; monotone from the first step on");
}

Finding full_contact_persists(const Print& p)
{
    Argument a("monotone iteration");
    a.add("x_n tends to x_P", the_fixed_point());
    a.add("x_P = 1/(G - 1) > 1 for 1 < G < 2", identity(1 / (G() - 1) - 1, (2 - G()) / (G() - 1), Points{"G=3/2"}));
    const ex said = p("rhs");
    const bool number = GiNaC::is_a<GiNaC::numeric>(said);
    a.add("the load ratio is compared with one, or with less", exactly(number && said <= 1, p.text("rhs")));
    if (number && said > 0 && p.text("condition").find("n_0") == std::string::npos) {
        const Ball bound = evaluate(said, Point{}), x = peaks::iterate(1, pow(bound, Ball(4)) / 10, Ball(Rational(3, 2)));
        a.add("at every scale",
              opposite(less_than(x, bound,
                                 "G = 3/2, load " + std::string(said.is_equal(1) ? "0.1" : "(" + p.text("rhs") + ")^4/10") +
                                     ": x_1, the largest load ratio at scale 2, and " + p.text("rhs"))));
    }
    return a.conclude("from some scale on, which depends on the load");
}

Finding full_share(const Print& p)
{
    Argument a("bounds on the force-weighted chain");
    a.add("for 1 < G < 2 the share of full contacts among all contacts stays above a positive number", full_contact_share_stays());
    const Ball least = least_full_share(G_of_figure_3a(), Ball(Rational(3, 5))), share = limiting_full_share(5);
    a.add("the limiting share of full contacts at gamma = 5, D = 1.05 (figure 3a), certified", share_satisfies(share, p, "it"));
    a.add("which is above what the bounds leave", within(share, hull(least, Ball(1))));
    return a.conclude("the *area* in full contact does vanish, but so does the whole contact area, at the same rate; the share of full "
                      "contacts, by number, tends to " +
                      share.to_string(4) + " for gamma = 5, D = 1.05 (certified)");
}

} // namespace

std::vector<Claim> sentences_of_sections_2_5()
{
    const auto hertzian = [&](const char* id) {
        return Claim{id,
                     "The share of Hertzian asperity contacts tends to one.",
                     the_model + ", G = gamma^(D-1) < sqrt(20), as in all of figure 3",
                     hertzian_share,
                     {},
                     Correction{"substance",
                                "'increasingly': the load ratio of the contacting asperities does not tend to zero",
                                "for gamma^(D-1) < sqrt(20) the share of non-Hertzian contacts stays above a positive number; only for "
                                "larger gamma^(D-1) all contacts become Hertzian",
                                {{"relation", "=", "<"}},
                                "it is the reason given for (7.21) and for the agreement of figure 3 at large n; the constant of (7.21) "
                                "inherits the error (text.defines-limit)"},
                     {"5.6", "5.11"}};
    };
    return {
        {"text.area-decreases",
         "The contact area decreases with n.",
         the_model,
         area_decreases,
         {{"increases", {{"relation", "<=", ">="}}}},
         {},
         {"6.7"}},
        {"text.simple-fractal",
         "At low n the slope depends on the load.",
         the_model,
         slopes_at_low_n,
         {{"the other way", {{"relation", "<", ">"}}}},
         {},
         {"6.7"}},
        {"text.probability",
         "The densities are probability densities.",
         "",
         probability,
         {{"1/2", {{"0.rhs", "1", "1/2"}}}, {"one in partial contact too", {{"1.rhs", "2/Pi*asin(sqrt(S))", "1"}}}},
         {},
         {"2.15", "2.17", "2.19"}},
        {"text.fractal-domain",
         "The profile is defined for every gamma > 1 and D > 1.",
         "",
         fractal_domain,
         {},
         Correction{"wording",
                    "the missing upper bound of D",
                    "gamma > 1 and 1 < D < 2",
                    {{"1.rhs", "infinity", "2"}},
                    "(3.4), (3.5) and all later sections need D < 2 silently; nothing else goes wrong"},
         {"3.1"}},
        {"text.series-diverges",
         "The sum of the pressure amplitudes is infinite for D > 1.",
         "",
         series_diverges,
         {{"for D > 0", {{"1.rhs", "1", "0"}}}},
         {},
         {"3.10"}},
        {"text.no-full-contact",
         "No finite mean pressure makes full contact.",
         "linear elasticity, gamma > 1, D > 1",
         no_full_contact,
         {{"bounded below by -1", {{"rhs", "-infinity", "-1"}}}},
         {},
         {"3.7", "3.8"}},
        {"text.divergence-D1",
         "Nor at D = 1, for some profiles.",
         "linear elasticity",
         divergence_at_D_1,
         {{"D = 1/2", {{"rhs", "1", "0.5"}}}},
         {},
         {"3.7", "3.8"}},
        {"text.no-finite-segments",
         "No contact segments of finite size.",
         "",
         [](const Print&) {
             return not_computed("section 4 argues it for the elastic problem itself and calls the argument ad hoc; that is not checked "
                                 "here. In the model of sections 5 and 6 it follows from text.area-vanishes, which is proved: a set that "
                                 "loses all its length holds no interval");
         },
         {},
         {},
         {}},
        {"text.dimension-below-one",
         "A set without intervals has dimension below one.",
         "",
         dimension_below_one,
         {},
         Correction{"substance",
                    "'and hence': no interval does not mean a dimension below one",
                    "the dimension is at most one; that it is below one needs another argument, which (8.7) supplies for the model",
                    {{"relation", "<", "<="}},
                    "nothing: (8.7) does not use it"},
         {}},
        {"text.pstar-increases",
         "p*_n increases with n.",
         "gamma > 1, D > 1",
         pstar_increases,
         {{"decreases", {{"relation", ">", "<"}}}},
         {},
         {"3.8"}},
        {"text.mean-pressure",
         "The mean pressure is pbar at every scale.",
         the_model,
         mean_pressure,
         {{"2 pbar", {{"rhs", "pbar", "2*pbar"}}}},
         {},
         {"2.2", "2.4"}},
        hertzian("text.increasingly-hertzian"),
        {"text.iteration-converges",
         "The iteration (5.6) converges monotonically to its one positive fixed point from every positive start.",
         "all gamma^(D-1) > 1",
         iteration_converges,
         {{"2 + x", {{"0.rhs", "1+x", "2+x"}}},
          {"3 sqrt(x)", {{"1.rhs", "2*", "3*"}}},
          {"1 + x^2, continuous", {{"0.rhs", "1+x", "1+x^2"}}},
          {"2 x, continuous", {{"1.rhs", "2*sqrt(x)", "2*x"}}}},
         {},
         {"5.4", "5.5", "5.6"}},
        {"text.full-contact-persists",
         "For gamma^(D-1) < 2 there is full contact at all scales.",
         the_model + ", 1 < gamma^(D-1) < 2",
         full_contact_persists,
         {},
         Correction{"wording",
                    "'at all scales'",
                    "at all scales from some n_0 on (n_0 = 0 for load >= 1)",
                    {{"condition", "n >= 0", "n >= n_0"}},
                    "nothing"},
         {"5.6", "5.9"}},
        {"text.full-contact-vanishes",
         "For gamma^(D-1) < 2 the share of full contacts among the asperity contacts tends to zero.",
         the_model + ", 1 < gamma^(D-1) < 2",
         full_share,
         {},
         Correction{"substance",
                    "'a vanishingly small proportion'",
                    "the share stays above a positive number that depends on gamma^(D-1) alone",
                    {{"relation", "=", ">"}},
                    "the Hertzian picture of figures 3a, 3b (gamma^(D-1) = 1.08 and 1.12): most asperity contacts there are full at every "
                    "large n"},
         {"5.6", "5.9"}},
        hertzian("text.increasingly-hertzian-2"),
        hertzian("text.hertz-dominates"),
        hertzian("text.hertz-prevalence"),
    };
}

} // namespace touchstone::proofs
