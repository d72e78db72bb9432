// SPDX-License-Identifier: GPL-3.0-or-later
#include "proofs/lemmas/area_bounds.hpp"

#include "proofs/lemmas/fixed_point.hpp"
#include "proofs/lemmas/k_limit.hpp"
#include "proofs/symbolic/symbolic.hpp"

#include "touchstone/paper/archard.hpp"
#include "touchstone/scalar/symbol.hpp"
#include "touchstone/wave/wave.hpp"

namespace touchstone::proofs {

namespace {

using GiNaC::lst;
using GiNaC::Pi;

const ex x = sym("x_load"), G = sym("G"), u = sym("u");

/// The first check that does not prove, or the summary: argued if a step is. Said by the lemma that calls this.
Check all_of(std::initializer_list<Check> checks, const std::string& summary,
             const std::source_location& at = std::source_location::current())
{
    Verdict least = Verdict::proved;
    for (const Check& c : checks) {
        if (c.verdict == Verdict::argued) least = Verdict::argued;
        else if (c.verdict != Verdict::proved) return as_lemma(c, at);
    }
    return as_lemma({least, summary}, at);
}

/// A step that words carry.
Check words(const std::string& text) { return {Verdict::argued, text}; }

/// sqrt(v) <= sqrt(m) + (v - m)/(2 sqrt(m)), by a square: in the mean over v with mean m, Jensen's E[sqrt(v)] <= sqrt(E[v]).
Check mean_of_roots()
{
    const ex v = sym("v_root"), m = sym("m_root"); // the roots
    return identity(m + (v * v - m * m) / (2 * m) - v, pow(v - m, 2) / (2 * m), Points{"v_root=1/3 m_root=2"});
}

/// v >= 2 c - c^2/v, by a square: in the mean with c = 1/E[1/v], Cauchy and Schwarz's E[v] >= 1/E[1/v].
Check mean_of_inverses()
{
    const ex v = sym("v_root"), c = sym("m_root");
    return identity(v - 2 * c + c * c / v, pow(v - c, 2) / v, Points{"v_root=1/3 m_root=2"});
}

/// sqrt(t/x) > 1 for x < t and sqrt(t/x) > 0 beyond: in the mean, Markov's P(x < t) <= sqrt(t) E[x^(-1/2)].
Check share_below()
{
    const ex t = sym("t"), below = t / pow(1 + u, 2); // every x < t
    return power_identity(sqrt(t / below), 1 + u, Points{"u=1 t=1/3"});
}

Check fixed_point() { return unique_fixed_point(prints().at("5.4")("rhs"), prints().at("5.5")("rhs")); }

const Points points{"x_load=1/3 G=3 u=1/2 sin_psi=1/2 cos_theta=1/3"};
/// G in (1, 2) as 2/(1 + v), v = 1/(1 + u) in (0, 1), u > 0.
const ex G_below_2 = 2 / (1 + 1 / (1 + u));

} // namespace

Check force_weighting()
{
    const ex s = sym("sin_psi"), ct = sym("cos_theta");
    Ring ring;
    const ex c = ring.root("cos_psi", 1 - s * s);
    const ex w = ring.root("w", 1 - x * s * s);
    const ex wave = prints().at("2.4")("rhs");
    // sin(pi x/lambda) = sqrt(load) s, sin(pi a/lambda) = sqrt(load) (2.5); pressure in p*_n, then over p*_{n+1}
    const ex squared = pow(wave, 2);
    Ring angles;
    const auto [sine, cosine] = angles.angle("w", Pi * sym("x") / sym("lambda"));
    const auto [edge, edge_cosine] = angles.angle("e", Pi * sym("a") / sym("lambda"));
    const ex pressure_squared =
        angles.rewrite(squared).subs(cosine == sqrt(1 - sine * sine)).subs(lst{sine == sqrt(x) * s, edge == sqrt(x), sym("pbar") == x});
    const ex y = 2 / G * sqrt(x) * c * w;
    const ex weight = 2 / Pi * sqrt(x) * c / w;
    const ex psi = sym("psi");
    const ex position = asin(sqrt(x) * sin(psi)); // pi x/lambda
    const ex full_y = (x + ct) / G;
    return all_of(
        {
            identity(pressure_squared, pow(G * y, 2), points, ring), // (2.4) is y
            identity(pow(2 / Pi * position.diff(GiNaC::ex_to<GiNaC::symbol>(psi)), 2),
                     (pow(weight, 2)).subs(lst{s == sin(psi), c == cos(psi), w == sqrt(1 - x * pow(sin(psi), 2))}),
                     Points{"x_load=1/3 psi=1/2"}),                     // share of the wave
            identity(weight * y * G / x, 4 / Pi * c * c, points, ring), // force-weighted: semicircle law
            identity(full_y * G / x, 1 + ct / x, points),               // full contact
            identity(prints().at("2.2")("rhs").subs(lst{sym("pbar") == x, sym("pstar") == 1, cos(2 * Pi * sym("x") / sym("lambda")) == ct}),
                     full_y * G, points),
        },
        "five identities by normal form; integrals of (4/pi) cos^2 over (0, pi/2) and of 1 + cos/x over (0, pi) with weight 1/pi are one");
}

Check inverse_root_moment()
{
    const Check constant = less_than(4 / (pi<Ball>() * sqrt(Ball(2))), Ball(1), "4/(pi 2^(1/2))");
    return all_of(
        {
            force_weighting(),
            identity((1 - x * u * u) - (1 - u * u), (1 - x) * u * u, points), // so y >= (2/G) sqrt(x) (1 - u^2) in partial contact
            // E[y^(-1/2)] <= (G/2)^(1/2) x^(-1/4) times the integral of (4/pi) sqrt(1 - u^2) (1 - u^2)^(-1/2), which is 4/pi
            identity(pow(4 / Pi * sqrt(G / 2), 2), 8 * G / (Pi * Pi), Points{"G=3"}),
            constant, // so E[y^(-1/2)] <= sqrt(G) x^(-1/4)
            // full contact: sqrt(G)/x times the mean of (x + cos theta)^(1/2), at most sqrt(x) as that of x + cos theta is x; x^(-1/2) <=
            // x^(-1/4)
            mean_of_roots(),
            power_identity(sqrt(G) / x * sqrt(x), sqrt(G) * pow(x, -ex(1) / 2), points),
            // m_{n+1} <= sqrt(G m_n) (mean_of_roots again, v = x^(-1/2)), which keeps m <= M for M >= G and drives m below every M > G: the
            // fixed point is G
            power_identity(sqrt(G * G), G, points),
        },
        "y >= (2/G) sqrt(x)(1 - u^2) in partial contact, the mean of a root is at most the root of the mean: m_{n+1} <= sqrt(G m_n) with "
        "m_n = E[x_n^(-1/2)], in partial contact with 8 G/pi^2 in place of G; " +
            constant.detail);
}

Check area_bounds()
{
    return all_of(
        {
            force_weighting(),
            inverse_root_moment(),
            fixed_point(), // x_n <= X = max(load, x_P)
            // h(x) <= x^(-1/2): arcsin is convex on (0, 1), arcsin'' = t/(1 - t^2)^(3/2), so below its chord from 0 to arcsin 1 = pi/2
            power_identity(asin(sym("t")).diff(GiNaC::ex_to<GiNaC::symbol>(sym("t")), 2),
                           sym("t") * pow(1 - sym("t") * sym("t"), -ex(3) / 2), Points{"t=1/2"}),
            identity(asin(ex(1)), Pi / 2, Points{}),
            // h(x) >= 2/pi for x < 1, as arcsin(sqrt x) >= sqrt x >= x (convex, above its tangent at 0); h(x) = 1/x >= 1/X for 1 <= x <= X
            limit_at_zero(asin(sym("t")) / sym("t"), sym("t"), 1, Points{}),
        },
        "A_n = load G^-n E[h(x_n)] with min(2/pi, 1/X) <= h(x) <= x^(-1/2)");
}

Check hertz_from_below()
{
    const ex s = sym("s"), t = sym("t");
    // (2/pi)(arcsin sqrt(x))/x >= (2/pi)(x^(-1/2) + x^(1/2)/6): the Taylor coefficients of arcsin are positive
    const ex arcsine = GiNaC::series_to_poly(asin(t).series(t == 0, 5));
    // one Hertzian step multiplies x^s by G^-s and the factor of (7.13) with delta = s
    const ex integral = prints().at("7.13")("J.integrand").subs(sym("delta_n") == s);
    const ex step_of_power = pow(2 / G, s) / Pi; // times the integral, x^((1+s)/2)
    const ex from_chain = (1 / G) * pow(2 / G, s - 1) * 2 / Pi; // x/G (2/G)^(s-1) x^((s-1)/2), half the symmetric integral of (4/pi)
    return all_of(
        {
            force_weighting(),
            inverse_root_moment(),
            K_converges(),
            identity(arcsine, t + pow(t, 3) / 6, Points{"t=1/2"}),
            power_identity(step_of_power, from_chain, Points{"G=3 s=1/2"}),
            power_identity(integral, pow(1 - pow(sym("xi"), 2), s / 2), Points{"s=1/2 xi=1/3"}),
            power_identity(prints().at("7.13")("0.rhs").coeff(sym("J"), 1).subs(sym("delta_n") == s) / sym("K_n"),
                           step_of_power * pow(G, s), Points{"G=3 s=1/2 K_n=1"}),
            // (2/pi)(1/6) times the least limit of E[x_n^(1/2)] >= 1/E[x_n^(-1/2)] >= pi^2/(8 G)
            identity(2 / Pi / 6 * Pi * Pi / (8 * G), Pi / (24 * G), points),
            mean_of_inverses(),
            words("T keeps order, so by induction the area is above the Hertzian one at every scale, and the limits may be taken term by "
                  "term"),
        },
        "T keeps order; on x^s with 0 < s <= 1 it is at least its Hertzian limit since (1 - x u^2)^((s-1)/2) >= 1; arcsin t >= t + t^3/6 "
        "and E[x^(1/2)] >= 1/E[x^(-1/2)]");
}

Ball least_excess(const Ball& G_value)
{
    return 1 + pi<Ball>() / (24 * G_value * G_value * K_infinity());
}

Check area_from_above()
{
    const ex t = sym("t");
    return all_of(
        {
            force_weighting(),
            inverse_root_moment(),
            fixed_point(),
            // (arcsin t - t)/t^3 grows with t, its Taylor coefficients being positive (5!!/6!! and so on), so it is below its value at 1
            identity((asin(t) - t).subs(t == 1), Pi / 2 - 1, Points{}),
            identity(GiNaC::series_to_poly(asin(t).series(t == 0, 8)), t + pow(t, 3) / 6 + 3 * pow(t, 5) / 40 + 5 * pow(t, 7) / 112,
                     Points{"t=1/2"}),
            // x_P of (5.8) for G > 2
            power_identity(sqrt(prints().at("5.8")("rhs")), 2 / pow(sym("gamma"), sym("D") - 1), Points{"gamma=9 D=3/2"}),
        },
        "h(x) <= (2/pi) (x^(-1/2) + (pi/2 - 1) x^(1/2)) with E[x^(-1/2)] <= 8 G/pi^2 and x <= 4/G^2 in the limit");
}

Ball most_excess(const Ball& G_value)
{
    const Ball p = pi<Ball>();
    return 2 / p * (8 * G_value / (p * p) + (p / 2 - 1) * 2 / G_value) / (K_infinity() * G_value);
}

Ball contraction() { return (sqrt(Ball(2)) + asin(sqrt(Ball(2) / 3))) / pi<Ball>(); }

Check one_limiting_law()
{
    const ex t = sym("t"), psi = sym("psi");
    const ex square = wave::quarter_pressure_squared<ex>(x, u * u, sym("rest")); // y^2, but for what does not depend on x = exp(-s)
    const ex slope = (1 - 2 * t) / (2 * (1 - t));
    // (2t - 1)/(1 - t) grows with t < 1: its derivative is 1/(1 - t)^2; it is 1 at t = 2/3
    const ex growth = ((2 * t - 1) / (1 - t)).diff(GiNaC::ex_to<GiNaC::symbol>(t));
    // u = sin psi: half the share of u^2 <= 2/3, and (2/pi) times the integral of -cos(2 psi) beyond, sin^2 psi_0 = 2/3
    const ex share = 2 / Pi * (sin(psi) * cos(psi) + psi);   // of u <= sin psi, semicircle law
    const ex beyond = 2 / Pi * sin(2 * psi) / 2;
    Ring ring;
    const auto [sine, cosine] = ring.angle("psi", psi);
    const ex at_psi_0 = (share / 2 + beyond).subs(psi == asin(sqrt(ex(2) / 3)));
    const GiNaC::symbol& psi_symbol = GiNaC::ex_to<GiNaC::symbol>(psi);
    const Check contracts = less_than(contraction(), Ball(1), "by the factor");
    const Points at{"x_load=1/3 rest=3/4 u=1/2 G=3 t=1/3 psi=1/2"};
    return all_of(
        {
            force_weighting(),
            identity(x * square.diff(GiNaC::ex_to<GiNaC::symbol>(x)) / (2 * square), slope.subs(t == u * u * x), at), // of -log y by s
            identity(growth, 1 / pow(1 - t, 2), at),
            identity(((2 * t - 1) / (1 - t)).subs(t == ex(2) / 3), 1, at),
            identity(share.diff(psi_symbol), 4 / Pi * pow(cosine, 2), at, ring), // the semicircle law in psi
            identity(-beyond.diff(psi_symbol), (2 * pow(sine, 2) - 1) / (1 - pow(sine, 2)) / 2 * 4 / Pi * pow(cosine, 2), at,
                     ring), // what remains beyond psi
            less_than(abs(evaluate(at_psi_0, Point{}) - contraction()), ScalarTraits<Ball>::power_of_two(-100),
                      "the bound in closed form: difference"),
            contracts,
            // E[y^-a] <= (G/2)^a x^(-a/2) times the integral of (4/pi)(1 - u^2)^(1/2 - a), finite for a < 3/2, so for a = 1
            words("a contraction in the Wasserstein distance has one limiting law, and bounded moments carry the limit to functions that "
                  "grow like 1/x"),
        },
        "one step contracts the distance of -log x in the mean, for all G >= 2 and loads up to 1; " + contracts.detail);
}

Check full_contact_share_stays()
{
    // e = (2 - G)/4, q = (2/G)(1 - e) = (2 + G)/(2G) > 1: a step with u^2 <= e takes x <= 1 at least to q sqrt(x)
    const ex q = (2 + G) / (2 * G), e = (2 - G) / 4;
    return all_of(
        {
            inverse_root_moment(),
            identity(2 / G * (1 - e), q, points),
            identity((q - 1).subs(G == G_below_2), 1 / (2 * (1 + u)), Points{"u=1"}),
            identity(e.subs(G == G_below_2), 1 / (2 * (2 + u)), Points{"u=1"}),
            // P(x < t) <= sqrt(t) G in the limit, one half at sqrt(t) = 1/(2G)
            share_below(),
            identity(G / (2 * G), ex(1) / 2, points),
            // the fixed point q^2 of q sqrt(x) is above 1, so a fixed number of such steps takes t above 1
            power_identity(q * sqrt(pow(sym("y"), 2)), q * sym("y"), Points{"G=3/2 y=2"}),
            // full contact persists with probability at least arccos(G - 1)/pi: (x + cos theta)/G >= 1 where cos theta >= G - 1
            identity((1 + (G - 1)) / G, 1, points),
            words("a fixed number of steps that each have positive probability has positive probability"),
            // the share by number is E[1/x; x >= 1]/E[1/x], E[1/x_n] = G E[h(x_{n-1})] <= G^2 in the limit, 1/x >= 1/x_P
            force_weighting(),
        },
        "half the force sits at x >= 1/(4G^2) in the limit (Markov); a fixed number of steps with u^2 <= (2 - G)/4 takes it above 1 with "
        "positive probability, where it stays with positive probability; the share by number is at least that probability over x_P G^2");
}

Ball least_full_share(const Ball& G_value, const Ball& root_of_t)
{
    const Ball one(1);
    const Ball p_t = one - G_value * root_of_t;                       // P(x >= t) in the limit
    const Ball u0_squared = one - G_value / (2 * root_of_t);          // (1 - u^2)^2 >= G^2/(4t) for u below u0
    const Ball u0 = sqrt(u0_squared);
    const Ball climb = 2 / pi<Ball>() * (u0 * sqrt(one - u0_squared) + asin(u0)); // semicircle law of u < u0
    const Ball stay = acos(G_value - 1) / pi<Ball>();
    const Ball step = at_most(climb, stay);
    const Ball x_P = 1 / (G_value - 1);
    return p_t * step / (x_P * G_value * G_value);
}

Check non_hertzian_share_stays()
{
    const ex r = sym("r"); // G = r sqrt(20), 0 < r < 1; 1 - e = (1 + r)/2 > r
    const ex e = (1 - r) / 2;
    const ex r_below_1 = 1 / (1 + u);
    return all_of(
        {
            inverse_root_moment(),
            identity(((1 - e) - r).subs(r == r_below_1), u / (2 * (1 + u)), Points{"u=1"}),
            identity(e.subs(r == r_below_1), u / (2 * (1 + u)), Points{"u=1"}),
            // a step with u^2 <= e takes x <= 1 at least to q sqrt(x), q = (2/G)(1 - e) > (2/G) r = 1/sqrt(5): fixed point q^2 > 1/5
            identity(pow(2 / (r * sqrt(ex(20))) * r, 2), ex(1) / 5, Points{"r=1/2"}),
            // and keeps x >= 1/5 there: q sqrt(1/5) > 1/5
            identity(sqrt(ex(1) / 5) * sqrt(ex(1) / 5), ex(1) / 5, Points{}),
            // from x >= 1 half of the theta give y >= 1/G > 1/5, as G^2 < 20 < 25
            exactly(Rational(20) < Rational(25), "20 < 25"),
            share_below(),
            words("a fixed number of steps that each have positive probability has positive probability"),
            identity(G / (2 * G), ex(1) / 2, points),
            force_weighting(),
        },
        "half the force sits at x >= 1/(4G^2) in the limit (Markov); a fixed number of steps with small u takes it to x >= 1/5 and keeps "
        "it there with positive probability; by number the share is at least that over X G^2");
}

Ball least_non_hertzian_share(const Ball& G_value)
{
    const Ball pi2 = pi<Ball>() * pi<Ball>();
    return pi2 / 32 * (1 - 8 * G_value / (pi2 * sqrt(Ball(5))));
}

} // namespace touchstone::proofs
