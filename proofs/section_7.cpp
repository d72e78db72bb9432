// SPDX-License-Identifier: GPL-3.0-or-later
/// Section 7 of the paper: Archard's recursion with Hertzian contacts.
#include "proofs/consequences.hpp"
#include "proofs/lemmas/k_limit.hpp"
#include "proofs/ledger.hpp"
#include "proofs/symbolic/symbolic.hpp"
#include "proofs/symbolic/units.hpp"

#include "touchstone/paper/archard.hpp"
#include "touchstone/scalar/symbol.hpp"

namespace touchstone::proofs {

namespace {

using GiNaC::lst;
using GiNaC::Pi;

ex n() { return sym("n"); }
/// 1 - 2^-(n+1), what delta_n must be (7.12), (7.15).
ex delta(const ex& n) { return 1 - pow(ex(2), -(n + 1)); }
ex alpha(const ex& n) { return (1 - sym("D")) * (n - 1 + pow(ex(2), -n)); }
ex K_factor(const ex& d) { return archard::step<Symbol>(d); }
/// (1 - nu^2) F/(pi E g)
ex load_of(const char* F, const char* g) { return (1 - pow(sym("nu"), 2)) * sym(F) / (Pi * sym("E") * sym(g)); }

const Points physical{"gamma=5 D=3/2 n=2 K_n=1/2 alpha_n=-1 beta_n=1/3 delta_n=3/4 lambda_0=2 g_0=1/3 E=5 nu=1/4 F_0=1/7 F_1=1/9 p_0=2/7 "
                      "a_0=1/2 x=1/5 ptilde=1/6 lambda_1=2/5 g_1=1/8 rho=-1/2 J=3/2"};
const Points scales{"n=1 D=3/2 gamma=5 ptilde=1/3 K_n=1/2 y=1/3", "n=3 D=5/4 gamma=7 ptilde=1/7 K_n=1/2 y=1/3"};

/// The printed g_1, lambda_1 of (3.2).
lst first_level()
{
    return {sym("g_1") == prints().at("3.2")("0.rhs").subs(n() == 1), sym("lambda_1") == prints().at("3.2")("1.rhs").subs(n() == 1)};
}

Finding force(const Print& p)
{
    return Argument("dimensions")
        .add("dimensions", units(p))
        .conclude("the force per unit depth on one wave of level n + 1, the pressure being nearly constant over it", Verdict::definition);
}

Finding ansatz(const Print& p)
{
    // Base case (7.14) and step (7.10) with the exponents (7.12) reproduce the form.
    const ex load = load_of("F_0", "g_0");
    const ex base = p("rhs").subs(lst{sym("K_n") == 2 / Pi, sym("alpha_n") == 0, sym("beta_n") == 0, sym("delta_n") == ex(1) / 2});
    // The step: each wave of level 1 under the Hertzian pressure p_0(x) has this form with g_1, lambda_1 and F_1 = p_0 lambda_1; 1/lambda_1
    // of them per unit length, summed over x = a_0 xi. J is the integral of (1 - xi^2)^(delta_n/2).
    const ex d = sym("delta_n"),
             peak = prints().at("2.6")("rhs").subs(
                 lst{sym("x") == 0, sym("a") == sym("a_0"), sym("lambda") == sym("lambda_0"), sym("pbar") == sym("F_0") / sym("lambda_0")});
    const ex pstar_0 = prints().at("2.3")("rhs").subs(lst{sym("g") == sym("g_0"), sym("lambda") == sym("lambda_0")});
    const ex a_0 = prints().at("2.7")("rhs").subs(
        lst{sym("lambda") == sym("lambda_0"), sym("pbar") == sym("F_0") / sym("lambda_0"), sym("pstar") == pstar_0});
    const ex of_one =
        p("rhs").subs(lst{sym("lambda_0") == sym("lambda_1"), sym("g_0") == sym("g_1"), sym("F_0") == sym("F_1")}); // A/lambda_1
    const ex at_peak = of_one.subs(sym("F_1") == peak * sym("lambda_1")).subs(first_level()).subs(sym("a_0") == a_0);
    const ex sum = a_0 / sym("lambda_0") * at_peak * sym("J");
    const ex next = p("rhs").subs(lst{sym("K_n") == sym("K_n") * pow(ex(2), d) * sym("J") / Pi,
                                      sym("alpha_n") == sym("alpha_n") + (1 - sym("D")) * (sym("beta_n") + d), d == (d + 1) / 2},
                                  GiNaC::subs_options::no_pattern);
    return Argument("induction on n, logarithms in normal form")
        .add("dimensions", units(p))
        .add("n to n + 1: the sum of the contacts of level 1 under the Hertzian pressure (2.6), (2.7) has the same form in g_0, lambda_0, "
             "F_0 and gamma, with K_n 2^delta J/pi, alpha_n + (1 - D)(beta_n + delta_n), beta_n, (delta_n + 1)/2 for the constants",
             power_identity(sum, next, physical))
        .add("the shape of the pressure over the contact is (1 - xi^2)^(1/2), whose power delta_n is under the integral J",
             power_identity(prints().at("2.6")("rhs").subs(lst{sym("x") == sym("xi") * sym("a")}) /
                                prints().at("2.6")("rhs").subs(sym("x") == 0),
                            sqrt(1 - pow(sym("xi"), 2)), Points{"xi=1/3 a=1/2 lambda=2 pbar=1"}))
        .add("n = 0: with (7.15) it is (2/pi) load^(1/2), twice the Hertzian half-width (7.9)",
             power_identity(base, 2 / Pi * pow(load, ex(1) / 2), physical))
        .add("the load enters as (1 - nu^2) F_0/(pi E g_0)",
             power_identity(p("rhs").subs(sym("delta_n") == sym("delta_n") + 1) / p("rhs"), load, physical))
        .add("the profile enters as lambda_0/g_0",
             power_identity(p("rhs").subs(sym("beta_n") == sym("beta_n") + 1) / p("rhs"), sym("lambda_0") / sym("g_0"), physical))
        .add("and gamma", power_identity(p("rhs").subs(sym("alpha_n") == sym("alpha_n") + 1) / p("rhs"), sym("gamma"), physical))
        .conclude("under the Hertzian formulas (2.6), (2.7) at every scale, with the exponents (7.16) and the corrected (7.17)");
}

Finding load_parameter(const Print& p)
{
    const ex pstar_0 = prints().at("2.3")("rhs").subs(lst{sym("g") == sym("g_0"), sym("lambda") == sym("lambda_0")});
    return Argument("normal form")
        .add("dimensions", units(p))
        .add("with F_0 = pbar lambda_0 and (2.3) the left side is pbar/p*_0",
             identity(p("lhs").subs(sym("F_0") == sym("pbar") * sym("lambda_0")), sym("pbar") / pstar_0,
                      Points{"pbar=1/3 lambda_0=2 g_0=1/3 E=5 nu=1/4"}))
        .add("which is the right side", identity(p("rhs"), sym("ptilde"), Points{"ptilde=1"}))
        .conclude("with F_0 = pbar lambda_0, as the text says above (7.8); the reason given at (7.3) itself is false (text.load-force)");
}

Finding one_asperity(const Print& p)
{
    const ex from =
        prints().at("7.2")("rhs").subs(lst{sym("lambda_0") == sym("lambda_1"), sym("g_0") == sym("g_1"), sym("F_0") == sym("F_1")});
    return Argument("logarithms in normal form")
        .add("dimensions", units(p))
        .add("(7.2) with g_1, lambda_1, F_1", power_identity(p("rhs"), from, physical))
        .add("per lambda_1", identity(p("lhs") * sym("lambda_1"), sym("A"), Points{"A=1 lambda_1=2"}))
        .conclude();
}

/// (7.4) in terms of level 0, with F_1 = p_0 lambda_1.
ex one_asperity_over_lambda_0()
{
    return (prints().at("7.4")("rhs").subs(sym("F_1") == sym("p_0") * sym("lambda_1")) * sym("lambda_1") / sym("lambda_0"))
        .subs(first_level());
}

Finding one_asperity_level_0(const Print& p)
{
    return Argument("logarithms in normal form")
        .add("dimensions", units(p))
        .add("(7.4) with F_1 = p_0 lambda_1 and (3.2), rho from (7.6)",
             power_identity(p("rhs").subs(sym("rho") == prints().at("7.6")("rhs")), one_asperity_over_lambda_0(), physical))
        .conclude();
}

Finding exponent_rho(const Print& p)
{
    return Argument("logarithms in normal form")
        .add("dimensions", units(p))
        .add("the power of gamma in (7.4) over lambda_0 with (3.2): at gamma = 1 it leaves the rest",
             power_identity(one_asperity_over_lambda_0() / pow(sym("gamma"), p("rhs")),
                            one_asperity_over_lambda_0().subs(sym("gamma") == 1), physical))
        .conclude();
}

Finding summed(const Print& p)
{
    const ex each = p("J.integrand") * p("rhs").coeff(sym("J"), 1);
    return Argument("logarithms in normal form")
        .add("dimensions", units(p))
        .add("the contributions (7.5) of the waves of level 1, gamma/lambda_0 of them per unit length",
             power_identity(each, prints().at("7.5")("rhs") * sym("gamma") / sym("lambda_0"), physical))
        .add("over the contact at level 0", exactly((p("J.from") + p("J.to")).is_zero() && p("J.to").is_equal(sym("a_0")),
                                                    "from " + p.text("J.from") + " to " + p.text("J.to")))
        .conclude();
}

Finding hertz_pressure_of_force(const Print& p)
{
    const ex from = prints().at("2.6")("rhs").subs(
        lst{sym("pbar") == sym("F_0") / sym("lambda_0"), sym("lambda") == sym("lambda_0"), sym("a") == sym("a_0")});
    return Argument("normal form")
        .add("dimensions", units(p))
        .add("(2.6) with pbar = F_0/lambda_0", identity(pow(p("rhs"), 2), pow(from, 2), physical))
        .add("it has no zero inside the contact and is positive over 99/100 of it",
             positive_on(p("rhs").subs(lst{sym("x") == sym("y"), sym("F_0") == 1, sym("a_0") == 1}),
                         {{"y", Rational(-99, 100), Rational(99, 100)}}))
        .conclude();
}

Finding hertz_width_of_force(const Print& p)
{
    const ex pstar_0 = prints().at("2.3")("rhs").subs(lst{sym("g") == sym("g_0"), sym("lambda") == sym("lambda_0")});
    const ex from = prints().at("2.7")("rhs").subs(
        lst{sym("pbar") == sym("F_0") / sym("lambda_0"), sym("lambda") == sym("lambda_0"), sym("pstar") == pstar_0});
    return Argument("logarithms in normal form")
        .add("dimensions", units(p))
        .add("(2.7) with pbar = F_0/lambda_0 and (2.3)", power_identity(pow(p("0.rhs"), 2), pow(from, 2), physical))
        .add("in the load ptilde of (7.3)",
             power_identity(pow(p("0.rhs"), 2) / load_of("F_0", "g_0"), pow(p("1.rhs"), 2) / sym("ptilde"), physical))
        .conclude();
}

Finding area_at_next_scale(const Print& p)
{
    // (7.8), (7.9) in (7.7), x = a_0 xi: the integrand is (2 ptilde^(1/2))^delta (1 - xi^2)^(delta/2) a_0/lambda_0
    const ex d = sym("delta_n");
    const ex a_0 = sym("lambda_0") * sqrt(sym("ptilde")) / Pi;
    const ex peak = 2 / (Pi * a_0) * sym("lambda_0") * sym("ptilde"); // (1 - nu^2) p_0(0) lambda_0/(pi E g_0), F_0 -> load
    const ex derived = sym("K_n") * pow(sym("gamma"), sym("rho") + 1) * pow(sym("lambda_0") / sym("g_0"), sym("beta_n")) * pow(peak, d) *
                       a_0 / sym("lambda_0");
    return Argument("logarithms in normal form")
        .add("dimensions", units(p))
        .add("the peak of (7.8) in the load: (1 - nu^2) p_0(0) lambda_0/(pi E g_0) = 2 ptilde^(1/2) with (7.9)",
             power_identity((load_of("p_0", "g_0") * sym("lambda_0"))
                                .subs(sym("p_0") == prints().at("7.8")("rhs").subs(lst{sym("x") == 0}))
                                .subs(sym("a_0") == a_0)
                                .subs(sym("F_0") == sym("ptilde") * Pi * sym("E") * sym("g_0") / (1 - pow(sym("nu"), 2))),
                            2 * sqrt(sym("ptilde")), physical))
        .add("the factor before the integral, from (7.7), (7.8), (7.9) with x = a_0 xi",
             power_identity(p("rhs").coeff(sym("J"), 1), derived, physical))
        .add("the shape under the integral is that of (7.8) to the power delta_n",
             power_identity(p("J.integrand"), pow(1 - pow(sym("xi"), 2), d / 2), Points{"xi=1/3 delta_n=3/4"}))
        .conclude();
}

Finding analogy(const Print& p)
{
    const ex from = prints().at("7.2")("rhs").subs(lst{sym("K_n") == sym("K_np1"), sym("alpha_n") == sym("alpha_np1"),
                                                       sym("beta_n") == sym("beta_np1"), sym("delta_n") == sym("delta_np1")});
    const Points at{"K_np1=1/2 gamma=5 alpha_np1=-1 beta_np1=1/3 delta_np1=7/8 lambda_0=2 g_0=1/3 ptilde=1/6 F_0=1/7 E=5 nu=1/4"};
    return Argument("logarithms in normal form")
        .add("dimensions", units(p))
        .add("(7.2) for n + 1, with (7.3)",
             power_identity(from / pow(load_of("F_0", "g_0"), sym("delta_np1")), p("rhs") / pow(sym("ptilde"), sym("delta_np1")), at))
        .conclude("names the constants of scale n + 1", Verdict::definition);
}

Finding recurrences(const Print& p)
{
    // compare (7.10) with (7.11): powers of gamma, lambda_0/g_0, ptilde
    const ex power_of_gamma = prints().at("7.6")("rhs") + 1;
    return Argument("comparison of exponents, normal form")
        .add("dimensions", units(p))
        .add("the power of gamma, rho + 1 with (7.6)", identity(p("0.rhs"), power_of_gamma, physical))
        .add("the power of lambda_0/g_0", identity(p("1.rhs"), sym("beta_n"), physical))
        .add("the power of ptilde: delta_n/2 from the pressure, 1/2 from the width",
             identity(p("2.rhs"), sym("delta_n") / 2 + ex(1) / 2, physical))
        .conclude();
}

Finding K_recurrence(const Print& p)
{
    const ex d = sym("delta_n"), m = sym("m");
    // the numerical factor of (7.10), corrected: 2^delta K_n/pi
    const ex factor = p("0.rhs").coeff(sym("J"), 1);
    const ex closed = p("1.rhs") / factor; // what the integral must be
    return Argument("the Beta integral; logarithms in normal form; certified quadrature")
        .add("dimensions", units(p))
        .add("the factor is that of the corrected (7.10)", power_identity(factor, pow(ex(2), d) * sym("K_n") / Pi, physical))
        .add("with t = xi^2 the integral is B(1/2, 1 + delta/2) = Gamma(1/2) Gamma(1 + delta/2)/Gamma(3/2 + delta/2)",
             power_identity(closed, sqrt(Pi) * GiNaC::tgamma(1 + d / 2) / GiNaC::tgamma(ex(3) / 2 + d / 2), physical))
        .add("Euler's Beta integral itself, at delta = 1/2, 3/4, 7/8, 1",
             beta_integral(p("J.integrand"), p("J.from"), p("J.to"), p("1.rhs") / factor))
        .add("the library's recursion is the same", power_identity(p("1.rhs") / sym("K_n"), K_factor(d), physical))
        .conclude();
}

Finding zeroth(const Print& p)
{
    return Argument("normal form")
        .add("dimensions", units(p))
        .add("twice the half-width", identity(p("0.rhs"), 2 * sym("a_0") / sym("lambda_0"), physical))
        .add("(7.9)", identity(p("1.rhs"), 2 * prints().at("7.9")("1.rhs") / sym("lambda_0"), physical))
        .conclude();
}

Finding initial(const Print& p)
{
    const ex form = prints().at("7.2")("rhs").subs(
        lst{sym("K_n") == p("3.rhs"), sym("alpha_n") == p("0.rhs"), sym("beta_n") == p("1.rhs"), sym("delta_n") == p("2.rhs")});
    return Argument("logarithms in normal form")
        .add("dimensions", units(p))
        .add("(7.2) with them is (7.14)",
             power_identity(form.subs(sym("F_0") == sym("ptilde") * Pi * sym("E") * sym("g_0") / (1 - pow(sym("nu"), 2))),
                            prints().at("7.14")("1.rhs"), physical))
        .conclude("the power of lambda_0/g_0 and of gamma must vanish, since (7.14) has neither");
}

Finding exponents(const Print& p)
{
    const ex d = p("0.rhs"), b = p("1.rhs"), a = p("2.rhs");
    const auto next = [](const ex& e) { return e.subs(n() == n() + 1); };
    const auto rule = [&](int part) {
        return prints().at("7.12")(std::to_string(part) + ".rhs").subs(lst{sym("delta_n") == d, sym("beta_n") == b, sym("alpha_n") == a});
    };
    Argument arg("induction on n, normal form with 2^-n adjoined");
    arg.add("dimensions", units(p));
    const auto same = [](const ex& l, const ex& r) { return power_identity(pow(sym("gamma"), l), pow(sym("gamma"), r), scales); };
    arg.add("n = 0: delta_0 of (7.15)", same(d.subs(n() == 0), prints().at("7.15")("2.rhs")));
    arg.add("n = 0: beta_0", same(b.subs(n() == 0), prints().at("7.15")("1.rhs")));
    arg.add("n = 0: alpha_0", same(a.subs(n() == 0), prints().at("7.15")("0.rhs")));
    arg.add("step of delta (7.12)", same(next(d), rule(2)));
    arg.add("step of beta", same(next(b), rule(1)));
    arg.add("step of alpha", same(next(a), rule(0)));
    for (long k : {0L, 1L, 5L}) {
        arg.add("the library's delta and alpha at n = " + std::to_string(k),
                same(d.subs(n() == k) + sym("y") * a.subs(n() == k),
                     archard::delta<Symbol>(k) + sym("y") * archard::alpha<Symbol>(k, sym("D"))));
    }
    return arg.conclude();
}

/// K_n in closed form; the factor of the product at i = n is its share of K_{n+1}/K_n.
Finding closed_K(const Print& p)
{
    const ex before = p("rhs").coeff(sym("M"), 1), term = p("M.term");
    const ex ratio = before.subs(n() == n() + 1) / before * term.subs(sym("i") == n());
    Argument a("induction on n, logarithms in normal form with 2^-n adjoined");
    a.add("dimensions", units(p));
    a.add("the product runs over i = 0, ..., n - 1",
          exactly(p("M.from").is_zero() && p("M.to").is_equal(n() - 1), "i = " + p.text("M.from") + " to " + p.text("M.to")));
    a.add("n = 0, empty product: K_0 of (7.15)", power_identity(before.subs(n() == 0), prints().at("7.15")("3.rhs"), scales));
    a.add("K_{n+1}/K_n is that of (7.13) with (7.16)", power_identity(ratio, K_factor(delta(n())), Points{"n=0", "n=1", "n=5"}));
    return a.conclude();
}

Finding closed_area(const Print& p)
{
    const ex printed = p("rhs").coeff(sym("M"), 1);
    const ex rest = printed / prints().at("7.17")("rhs").coeff(sym("M"), 1);
    const ex term = p("M.term");
    const ex K_part = prints().at("7.17")("rhs").coeff(sym("M"), 1);
    const ex ratio = K_part.subs(n() == n() + 1) / K_part * term.subs(sym("i") == n());
    return Argument("induction on n, logarithms in normal form with 2^-n adjoined")
        .add("dimensions", units(p))
        .add("the factor of K_n steps as (7.13) does", power_identity(ratio, K_factor(delta(n())), Points{"n=0", "n=1", "n=5"}))
        .add("the rest is gamma^alpha_n ptilde^delta_n of (7.16)",
             power_identity(rest, pow(sym("gamma"), alpha(n())) * pow(sym("ptilde"), delta(n())), scales))
        .add("n = 0: (7.14)", power_identity(printed.subs(n() == 0), prints().at("7.14")("1.rhs"), scales))
        .add("the library's area at n = 2 is the same form",
             power_identity(rest.subs(n() == 2), archard::area<Symbol>(2, sym("ptilde"), pow(sym("gamma"), sym("D") - 1), ex(1)), scales))
        .conclude();
}

Finding gamma_power(const Print& p)
{
    return Argument("normal form")
        .add("dimensions", units(p))
        .add("(7.16)", power_identity(p("rhs"), pow(sym("gamma"), prints().at("7.16")("2.rhs")), scales))
        .conclude();
}

Finding K_limit_digits(const Print& p)
{
    const Ball K = K_infinity();
    const std::string shown = p.text("1.digits");
    const std::string digits = shown.substr(0, shown.find("..."));
    const Rational low = *parse_rational(digits);
    const long places = static_cast<long>(digits.size()) - 2; // after "0."
    const Rational high = low + power(Rational(10), -places);
    Argument a("certified evaluation");
    a.add("dimensions", units(p));
    a.add("K_n converges", K_converges());
    const bool dots = shown.find("...") != std::string::npos;
    if (dots) {
        a.add("the digits before the dots are the first ones: K_inf >= " + digits, less_than(Ball(low), K, "K_inf"));
        a.add("K_inf < " + high.get_str(), less_than(K, Ball(high), "K_inf"));
    } else {
        const Rational half = power(Rational(10), -places) / 2;
        a.add("the digits are K_inf rounded", less_than(Ball(Rational(low - half)), K, "K_inf"));
        a.add("from above", less_than(K, Ball(Rational(low + half)), "K_inf"));
    }
    return a.conclude("K_inf = " + K.to_string(20));
}

Finding limiting_area(const Print& p)
{
    // (7.18), corrected, over the print: K_n/K_inf gamma^{alpha_n + (D-1)(n-1)} ptilde^{-2^-(n+1)}
    const ex hertz = sym("K_n") * pow(sym("gamma"), alpha(n())) * pow(sym("ptilde"), delta(n()));
    const ex t = sym("t");
    const ex ratio = hertz / p("rhs") * sym("K_infinity") / sym("K_n");
    return Argument("logarithms in normal form; the limit of K_n")
        .add("dimensions", units(p))
        .add("K_n/K_inf -> 1", K_converges())
        .add("the rest of the ratio of (7.18), corrected, to the print is (gamma^(1-D) ptilde^(-1/2))^(2^-n), a fixed number to a power "
             "that tends to zero",
             power_identity(ratio, pow(pow(sym("gamma"), 1 - sym("D")) / sqrt(sym("ptilde")), pow(ex(2), -n())),
                            Points{"n=2 D=3/2 gamma=5 ptilde=1/3 K_n=1/2 K_infinity=2/5"}))
        .add("the library's form is the same at n = 3",
             power_identity(p("rhs").subs(n() == 3),
                            archard::area_limit<Symbol>(3, sym("ptilde"), pow(sym("gamma"), sym("D") - 1), sym("K_infinity")),
                            Points{"D=3/2 gamma=5 ptilde=1/3 K_infinity=2/5"}))
        .conclude("as the limiting form of the Hertzian area (7.18), corrected: the ratio tends to 1. It is not the limiting form of the "
                  "area (6.7) of the model (text.defines-limit)");
}

} // namespace

std::vector<Claim> section_7()
{
    const std::string hertz = "Hertzian contact (2.6), (2.7) at every scale, scales decoupled";
    const Edit right_gammas_1{"M.term", "tgamma(1-2^(-(i+2)))", "tgamma(3/2-2^(-(i+2)))"};
    const Edit right_gammas_2{"M.term", "/tgamma(3/2-2^(-(i+2)))", "/tgamma(2-2^(-(i+2)))"};
    return {
        {"7.1", "The force on one wave of level n + 1.", "gamma >> 1", force, {}, {}, {}},
        {"7.2",
         "The contact area is a power law in the load and the profile's parameters.",
         hertz,
         ansatz,
         {{"the inverse of lambda_0/g_0", {{"rhs", "(lambda_0/g_0)", "(g_0/lambda_0)"}}}, {"without pi", {{"rhs", "Pi*", ""}}}},
         {},
         {"2.3", "2.6", "2.7", "3.2", "7.1"}},
        {"7.3",
         "The dimensionless load from the force.",
         "",
         load_parameter,
         {{"without pi", {{"lhs", "Pi*", ""}}}, {"nu for nu^2", {{"lhs", "nu^2", "nu"}}}},
         {},
         {"2.3", "6.8"}},
        {"7.4",
         "The contact area of one asperity of level 1.",
         hertz,
         one_asperity,
         {{"g_0 for g_1", {{"rhs", "*g_1)", "*g_0)"}}}},
         {},
         {"7.2"}},
        {"7.5",
         "The same in the quantities of level 0.",
         hertz,
         one_asperity_level_0,
         {{"lambda_0 left out", {{"rhs", "*p_0*lambda_0", "*p_0"}}}, {"rho + 1", {{"rhs", "gamma^rho", "gamma^(rho+1)"}}}},
         {},
         {"3.2", "7.1", "7.4", "7.6"}},
        {"7.6",
         "The power of gamma.",
         hertz,
         exponent_rho,
         {{"without the -1", {{"rhs", "-1+", "+"}}}, {"D - 1 for 1 - D", {{"rhs", "1-D", "D-1"}}}},
         {},
         {"3.2", "7.1", "7.4"}},
        {"7.7",
         "The area of scale n + 1 summed over the asperities of level 1.",
         hertz,
         summed,
         {{"rho for rho + 1", {{"rhs", "rho+1", "rho"}}}, {"half the contact", {{"J.from", "-a_0", "0"}}}},
         {},
         {"7.5"}},
        {"7.8",
         "The Hertzian pressure from the force.",
         hertz,
         hertz_pressure_of_force,
         {{"without the factor 2", {{"rhs", "2*F_0", "F_0"}}}},
         {},
         {"2.6"}},
        {"7.9",
         "The Hertzian half-width from the force.",
         hertz,
         hertz_width_of_force,
         {{"without the power 1/2", {{"0.rhs", "^(1/2)", ""}}}, {"without pi in the second form", {{"1.rhs", "/Pi", ""}}}},
         {},
         {"2.3", "2.7", "7.3"}},
        {"7.10",
         "The area of scale n + 1 as a power of the load.",
         hertz,
         area_at_next_scale,
         {{"pi^0, the rest as printed", {{"rhs", "Pi^((delta_n-3)/2)", "1"}}},
          {"2^(delta_n/2), the power of pi corrected", {{"rhs", "Pi^((delta_n-3)/2)", "Pi^(-1)"}, {"rhs", "2^delta_n", "2^(delta_n/2)"}}}},
         Correction{
             "misprint",
             "the power of pi: (delta_n - 3)/2 should be -1",
             "A_{n+1}/lambda_0 = 2^delta_n K_n gamma^(rho+1) pi^(-1) (lambda_0/g_0)^beta_n ptilde^((delta_n+1)/2) times the integral",
             {{"rhs", "Pi^((delta_n-3)/2)", "Pi^(-1)"}},
             consequence_of("7.10")},
         {"7.7", "7.8", "7.9"}},
        {"7.11", "Names of the constants at scale n + 1.", hertz, analogy, {{"without K", {{"rhs", "K_np1*", ""}}}}, {}, {"7.2", "7.3"}},
        {"7.12",
         "The recurrences of the exponents.",
         hertz,
         recurrences,
         {{"D - 1 for 1 - D", {{"0.rhs", "1-D", "D-1"}}}, {"delta_n - 1", {{"2.rhs", "delta_n+1", "delta_n-1"}}}},
         {},
         {"7.6", "7.10", "7.11"}},
        {"7.13",
         "The recurrence of K_n.",
         hertz,
         K_recurrence,
         {{"2 for 3/2", {{"1.rhs", "3/2+", "2+"}}},
          {"without the root of pi", {{"1.rhs", "sqrt(Pi)", "Pi"}}},
          {"delta_n for delta_n/2 in the integral", {{"J.integrand", "delta_n/2", "delta_n"}}}},
         {},
         {"7.10", "7.11"}},
        {"7.14",
         "The area at scale 0.",
         hertz,
         zeroth,
         {{"1/pi for 2/pi", {{"1.rhs", "2/Pi", "1/Pi"}}}, {"without the power 1/2", {{"1.rhs", "^(1/2)", ""}}}},
         {},
         {"7.9"}},
        {"7.15",
         "The constants at scale 0.",
         hertz,
         initial,
         {{"1/pi", {{"3.rhs", "2/Pi", "1/Pi"}}}, {"delta_0 = 1", {{"2.rhs", "1/2", "1"}}}, {"alpha_0 = 1", {{"0.rhs", "0", "1"}}}},
         {},
         {"7.2", "7.14"}},
        {"7.16",
         "The exponents in closed form.",
         hertz,
         exponents,
         {{"2^-n for 2^-(n+1)", {{"0.rhs", "n+1", "n"}}},
          {"n for n - 1", {{"2.rhs", "n-1", "n"}}},
          {"minus 2^-n", {{"2.rhs", "+2^(-n)", "-2^(-n)"}}}},
         {},
         {"7.12", "7.15"}},
        {"7.17",
         "K_n in closed form.",
         hertz,
         closed_K,
         {{"only the first argument corrected", {right_gammas_1}},
          {"only the second argument corrected", {right_gammas_2}},
          {"corrected, but i + 1 for i + 2",
           {right_gammas_1, right_gammas_2, {"M.term", "tgamma(3/2-2^(-(i+2)))", "tgamma(3/2-2^(-(i+1)))"}}},
          {"corrected, but pi^(n/2)", {right_gammas_1, right_gammas_2, {"rhs", "(n+2)/2", "n/2"}}}},
         Correction{"misprint",
                    "both arguments of Gamma are too small by 1/2",
                    "K_n = 2^(n+2^-n)/pi^((n+2)/2) prod_{i=0}^{n-1} Gamma(3/2 - 2^-(i+2))/Gamma(2 - 2^-(i+2))",
                    {right_gammas_1, right_gammas_2},
                    consequence_of("7.17")},
         {"7.13", "7.15", "7.16"}},
        {"7.18",
         "The contact area in closed form.",
         hertz,
         closed_area,
         {{"corrected, but delta_n with 2^-n", {right_gammas_1, right_gammas_2, {"rhs", "ptilde^(1-2^(-(n+1)))", "ptilde^(1-2^(-n))"}}},
          {"corrected, but gamma^(-(D-1) n)", {right_gammas_1, right_gammas_2, {"rhs", "(n-1+2^(-n))", "n"}}}},
         Correction{"misprint",
                    "both arguments of Gamma are too small by 1/2, as in (7.17)",
                    "A_n/lambda_0 = 2^(n+2^-n)/pi^((n+2)/2) prod_{i=0}^{n-1} Gamma(3/2 - 2^-(i+2))/Gamma(2 - 2^-(i+2)) "
                    "gamma^(-(D-1)(n-1+2^-n)) ptilde^(1-2^-(n+1))",
                    {right_gammas_1, right_gammas_2},
                    consequence_of("7.18")},
         {"7.16", "7.17"}},
        {"7.19", "The power of gamma in (7.18).", hertz, gamma_power, {{"n for n - 1", {{"rhs", "n-1", "n"}}}}, {}, {"7.16"}},
        {"7.20",
         "The limit of K_n, its decimals begin 0.39139.",
         hertz,
         K_limit_digits,
         {{"0.39138 without dots", {{"1.digits", "0.39139...", "0.39138"}}}, {"0.40 without dots", {{"1.digits", "0.39139...", "0.40"}}}},
         Correction{"wording",
                    "the dots: the decimals of K_inf = 0.3913876963... do not begin 0.39139",
                    "K_inf = 0.39139 to five places, 0.391388 to six",
                    {{"1.digits", "...", ""}},
                    "nothing: 0.39139 is the correctly rounded value (text.limit-0.39139)"},
         {"7.13", "7.16"}},
        {"7.21",
         "The Hertzian area at large n.",
         hertz,
         limiting_area,
         {{"n for n - 1", {{"rhs", "(n-1)", "n"}}}, {"the square root of the load", {{"rhs", "*ptilde", "*ptilde^(1/2)"}}}},
         {},
         {"7.18", "7.20"}},
    };
}

} // namespace touchstone::proofs
