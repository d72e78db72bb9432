// SPDX-License-Identifier: GPL-3.0-or-later
/// The checkable sentences of sections 8 to 11.
#include "proofs/lemmas/area_bounds.hpp"
#include "proofs/lemmas/fixed_point.hpp"
#include "proofs/lemmas/k_limit.hpp"
#include "proofs/lemmas/model_area.hpp"
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

Finding load_independent(const Print& p)
{
    return Argument("contraction of the force-weighted chain")
        .add("one limiting law of the load ratios for all loads", one_limiting_law())
        .add("x_n^max tends to x_P, which scales the abscissa", the_fixed_point())
        .add("the difference of the limits at two loads", identity(p("rhs"), 0, Points{"G=3"}))
        .conclude("for gamma^(D-1) > 2 and ptilde < 1, which section 9 assumes; they depend on D and gamma through gamma^(D-1) alone. (The "
                  "source text writes pbar for ptilde.)");
}

Finding beyond_20(const Print&)
{
    const auto off = [](long gamma) {
        Ball most;
        arb_get_ubound_arf(arb_midref(most.get()), abs(local_slopes(20, gamma) - 1).get(), 20);
        return most.to_string(2);
    };
    return Argument("contraction of the force-weighted chain; certified areas")
        .add("one limiting law of the load ratios", one_limiting_law())
        .conclude(
            "judged on the area, a mean over the distribution: from n = 20 to 21 the slope -log(A_21/A_20)/log G differs from its limit 1 "
            "by less than " +
                off(5) + " at D = 1.5, gamma = 5 and " + off(10) + " at gamma = 10" + at_the_loads +
                "; the densities of the first scales are in figure5",
            Verdict::qualitative);
}

Finding peak_at_centre(const Print& p)
{
    // Partition of (-lambda_0/2, lambda_0/2) into N = gamma^n parts: centres lambda_0 ((k + 1/2)/N - 1/2); phase 2 pi N x/lambda_0
    const ex N = sym("N"), k = sym("k");
    const ex phase = 2 * Pi * N * ((k + ex(1) / 2) / N - ex(1) / 2);
    Argument a("exact phases");
    a.add("the phase at the centre of the k-th part is 2 pi k + pi (1 - gamma^n)",
          identity(phase, 2 * Pi * k + Pi * (1 - N), Points{"N=3 k=1"}));
    const bool odd = p.text("condition").find("odd") != std::string::npos;
    a.add("odd gamma^n: cosine one", identity(cos(phase.subs(lst{N == 5, k == 0})), p("rhs"), Points{"N=5"}));
    if (!odd) a.add("gamma^n = 10, as in figures 3 to 5", identity(cos(phase.subs(lst{N == 10, k == 0})), p("rhs"), Points{"N=10"}));
    return a.conclude("for odd gamma^n");
}

Finding load_power(const Print& p)
{
    // A_n ~ load^delta_n; N_n of (8.2) ~ load^(1 - 2^-n)
    const ex b = sym("b");
    return Argument("exponents in normal form")
        .add("the power of the load in A_n/N_n is delta_n - (1 - 2^-n)",
             power_identity(pow(b, prints().at("7.16")("0.rhs") - (1 - pow(ex(2), -n()))), pow(b, p("rhs")), Points{"b=3 n=2"}))
        .note("it tends to zero")
        .conclude("in the Hertzian approximation");
}

Finding slope_grows(const Print& p)
{
    const ex b = sym("b");
    const ex power_of_load = -pow(ex(2), -n()); // and 1, at every scale
    return Argument("exponents in normal form")
        .add("from n to n + 1 the power of the load in (8.2) grows by 2^-(n+1)",
             power_identity(pow(b, power_of_load.subs(n() == n() + 1) - power_of_load), pow(b, p("rhs")), Points{"b=3 n=2"}))
        .conclude("in the Hertzian approximation (8.2); positive, and halved at each scale");
}

Finding several_scales(const Print& p)
{
    const ex bound = p("rhs"), m = sym("m"), gamma = sym("gamma");
    Argument a("bound of the number of segments");
    a.argue("N_n = gamma^n A_{n-1}/lambda_0 <= gamma^n A_0/lambda_0 <= gamma^n sqrt(load), as (2/pi) arcsin t <= t");
    a.add("the bound is named", exactly(p.text("relation") == "=" && p.text("lhs") == "load_below", "printed " + p.text("relation")));
    const auto b =
        positive_bound(bound, Point{{"gamma", Rational(5)}, {"D", Rational(3, 2)}, {"epsilon", Rational(1, 5)}, {"m", Rational(1)}});
    if (!b) return a.add("some load is below the bound", {Verdict::refuted, "at gamma = 5, m = 1 it is not positive"}).conclude();
    const ex excess = log_form(bound * pow(gamma, 2 * m)); // must not be positive for m >= 1, gamma > 1
    const ex per_scale = GiNaC::normal(excess.diff(GiNaC::ex_to<GiNaC::symbol>(m)) / log_form(gamma)), constant = bound.subs(m == 0);
    const bool power = GiNaC::is_a<GiNaC::numeric>(per_scale) && GiNaC::is_a<GiNaC::numeric>(constant.evalf());
    if (power && !GiNaC::ex_to<GiNaC::numeric>(per_scale).is_positive() &&
        (constant.is_equal(1) || certainly(less(evaluate(constant, Point{}), Ball(1))))) {
        a.add("below one at all n <= m for loads below the bound: gamma^m sqrt(bound) <= 1",
              exactly(true, "the bound times gamma^(2m) is a number at most 1 times a power of gamma^m that is not positive"));
    } else {
        const Ball turn = ScalarTraits<Ball>::sin_pi(Ball(Rational(1, 10)));
        Check worse =
            less_than(turn * turn, *b, "gamma = 5: the load where N_1 = 5 (2/pi) arcsin sqrt(load) passes 1, and the bound for m = 1");
        const auto at_small_gamma =
            positive_bound(bound, Point{{"gamma", Rational(3, 2)}, {"D", Rational(3, 2)}, {"epsilon", Rational(2, 3)}, {"m", Rational(1)}});
        const Ball third = ScalarTraits<Ball>::sin_pi(Ball(Rational(1, 3)));
        if (worse.verdict != Verdict::proved && at_small_gamma)
            worse = less_than(third * third, *at_small_gamma,
                              "gamma = 3/2: the load where N_1 = 3/2 (2/pi) arcsin sqrt(load) passes 1, and the bound for m = 1");
        a.add("N_1 < 1 for all loads below the bound",
              worse.verdict == Verdict::proved ? opposite(worse) : between_proof_and_counterexample());
    }
    return a.conclude("for the model itself");
}

Finding figure_5_load(const Print& p)
{
    return Argument("dimensions")
        .add("dimensions", units(p))
        .add("the value", exactly(p.text("rhs") == "0.001", p.text("rhs")))
        .conclude("the load of figure 5 is the dimensionless ptilde");
}

Finding dimension_4_D(const Print& p)
{
    return Argument("normal form")
        .add("(8.7) raised by one, D = D3 - 1",
             identity(p("rhs"), prints().at("8.7")("rhs").subs(sym("D") == sym("D3") - 1) + 1, Points{"D3=5/2"}))
        .conclude("for a profile that does not depend on the third coordinate");
}

Finding dimension_15(const Print& p)
{
    return Argument("exact arithmetic")
        .add("4 - D at D = 2.5",
             identity(p("rhs"), prints().at("text.dimension-4-D")("rhs").subs(sym("D3") == ex(5) / 2), Points{"D3=5/2"}))
        .conclude();
}

Finding apparent_lower(const Print& p)
{
    // (log N_{n+1}/N_n)/log gamma - (2 - D) = [log(K_n/K_{n-1}) + 2^-(n+1) (2 log G + log load)]/log gamma
    const ex growth = prints().at("8.2")("rhs").subs(n() == n() + 1) / prints().at("8.2")("rhs");
    Argument a("exponents in normal form; enclosure of log K_{n+1}/K_n");
    a.add("N_{n+1}/N_n = (K_n/K_{n-1}) gamma^(2-D) (G^2 load)^(2^-(n+1))",
          power_identity(
              growth, pow(sym("gamma"), 2 - sym("D")) * pow(pow(sym("gamma"), 2 * (sym("D") - 1)) * sym("ptilde"), pow(ex(2), -(n() + 1))),
              Points{"gamma=5 D=3/2 n=2 ptilde=1/3 K_nm1=1/2"}));
    a.add("K_n < K_{n-1}", K_converges());
    a.add("the bound is named", exactly(p.text("relation") == "=" && p.text("lhs") == "load_below", "printed " + p.text("relation")));
    const auto b = positive_bound(p("rhs"), Point{{"G", Rational(3)}});
    if (!b) return a.add("some load is below the bound", {Verdict::refuted, "at G = 3 it is not positive"}).conclude();
    const Rational most(2); // of G^2 load
    if (at_most_for_all_G(p("rhs"), ex(GiNaC::numeric(most.get_str().c_str())) / (G() * G()))) {
        a.add("G^2 load <= 2 for loads up to the bound", exactly(true, "the bound is at most 2/G^2 for every G > 1"));
        // log(K_n/K_{n-1}) = log step(1 - h), h = 2^-n, is at most -h times the least slope on [1/2, 1]; the load adds at most h log(2)/2
        a.add("K_n/K_{n-1} outweighs the factor 2^(2^-(n+1))", least_step_slope_exceeds(log(Ball(most)) / 2));
    } else {
        Check worse{Verdict::undecided, "no counterexample met below the bound, no proof up to it"};
        for (long k = 1; k <= 6 && worse.verdict != Verdict::proved; ++k) // G = 3, a load just below the bound
            worse = less_than(Ball(0),
                              log(archard::step<Ball>(archard::delta<Ball>(k - 1))) +
                                  log(*b * 9 * Ball(Rational(999, 1000))) * ScalarTraits<Ball>::power_of_two(-(k + 1)),
                              "at G = 3 and 999/1000 of the bound, from n = " + std::to_string(k) + " to " + std::to_string(k + 1) +
                                  ": 0 and the excess of the slope times log gamma");
        a.add("below 2 - D for every load below the bound",
              worse.verdict == Verdict::proved ? opposite(worse) : between_proof_and_counterexample());
    }
    return a.conclude("in the Hertzian approximation, for loads up to 1/G^2, and even 2/G^2");
}

Finding area_vanishes(const Print& p)
{
    return Argument("two-sided bounds of the area for every n")
        .add("A_n <= lambda_0 load G^-n max(load^(-1/2), G)", area_bounds())
        .add("which tends to zero", stated(p, 0, Points{"G=2"}))
        .conclude("in the model of sections 5 and 6, monotonically (text.area-decreases)");
}

} // namespace

std::vector<Claim> sentences_of_sections_8_11()
{
    return {
        {"text.peak-at-centre",
         "Each of the gamma^n subintervals has a peak of the n-th wave at its centre.",
         "integer gamma",
         peak_at_centre,
         {},
         Correction{"wording",
                    "'at the centre': for even gamma^n the centres are troughs",
                    "for odd gamma^n; for even gamma^n with the origin shifted by half a wavelength lambda_n",
                    {{"condition", "integer", "odd"}},
                    "nothing: the number of peaks in lambda_0 is gamma^n either way"},
         {"3.1"}},
        {"text.load-linear",
         "The mean length of the segments is almost independent of the load.",
         hertz_everywhere,
         load_power,
         {{"2^-(n-1)", {{"rhs", "n+1", "n-1"}}}},
         {},
         {"7.16", "8.2"}},
        {"text.slope-grows-with-load",
         "The apparent dimension grows with the load at the first scales.",
         hertz_everywhere,
         slope_grows,
         {{"falls", {{"rhs", "2^(-(n+1))", "-2^(-(n+1))"}}}},
         {},
         {"8.2"}},
        {"text.several-scales",
         "At small loads several scales pass before there is more than one segment.",
         the_model,
         several_scales,
         {{"at all loads up to 1", {{"rhs", "gamma^(-2*m)", "1"}}},
          {"up to gamma^-m", {{"rhs", "-2*m", "-m"}}},
          {"up to twice that", {{"rhs", "gamma^(-2*m)", "2*gamma^(-2*m)"}}}},
         {},
         {"8.1"}},
        {"text.figure-5-load",
         "The load of figure 5 is pbar = 0.001.",
         "",
         figure_5_load,
         {},
         Correction{"misprint",
                    "pbar for ptilde: a pressure is not a number",
                    "ptilde = 0.001",
                    {{"lhs", "pbar", "ptilde"}},
                    "the same slip stands twice more in the paragraph after (9.4)"},
         {"6.8"}},
        {"text.beyond-20",
         "Beyond n = 20 the normalised distributions do not change.",
         the_model + ", gamma^(D-1) > 2, ptilde < 1",
         beyond_20,
         {},
         {},
         {"6.1"}},
        {"text.distribution-load",
         "The limiting normalised distributions do not depend on the load.",
         the_model + ", gamma^(D-1) > 2, ptilde < 1",
         load_independent,
         {{"one", {{"rhs", "0", "1"}}}},
         {},
         {"5.6", "6.1"}},
        {"text.dimension-4-D",
         "For a surface that is a cylinder over the profile the dimension is 4 - D.",
         "",
         dimension_4_D,
         {{"3 - D", {{"rhs", "4", "3"}}}},
         {},
         {"8.7"}},
        {"text.dimension-1.5",
         "For a surface of dimension 2.5 it is 1.5.",
         "",
         dimension_15,
         {{"1.2", {{"rhs", "1.5", "1.2"}}}},
         {},
         {"text.dimension-4-D"}},
        {"text.apparent-lower",
         "At small loads the apparent dimension is below the limit.",
         hertz_everywhere,
         apparent_lower,
         {{"for loads up to 10/G^2", {{"rhs", "1/G^2", "10/G^2"}}}, {"for all loads up to 1", {{"rhs", "1/G^2", "1"}}}},
         {},
         {"8.2"}},
        {"text.area-vanishes", "The contact area tends to zero.", the_model, area_vanishes, {{"to one", {{"rhs", "0", "1"}}}}, {}, {"6.7"}},
    };
}

} // namespace touchstone::proofs
