// SPDX-License-Identifier: GPL-3.0-or-later
/// The operator: that each spelling of it in lib/touchstone/wave/wave.hpp is the same one, run here on symbols, and the lemmas of
/// wave/lemmas.hpp that hold at every load.
#include "proofs/operator/own.hpp"
#include "proofs/symbolic/symbolic.hpp"

#include "touchstone/scalar/symbol.hpp"
#include "touchstone/wave/lemmas.hpp"
#include "touchstone/wave/wave.hpp"

namespace touchstone::proofs {
namespace {

using GiNaC::pow, GiNaC::sqrt;

const char* const in_wave = "wave/wave.hpp";
const char* const in_lemmas = "wave/lemmas.hpp";

ex x() { return sym("x"); }
ex c() { return sym("c"); }
ex G() { return sym("G"); }
ex P() { return sym("P"); }
ex y() { return sym("y"); }
GiNaC::symbol symbol_of(const ex& e) { return GiNaC::ex_to<GiNaC::symbol>(e); }

const Points full_points{"x=3/2 c=1/3 G=5/4 P=2 y=3/2 s=7/5 u=1/3 q=1/7 h=1/9 m=3 w=2/5",
                         "x=5 c=-2/3 G=3 P=1/2 y=5/3 s=1/2 u=2/3 q=2/7 h=1/3 m=2 w=3/5"};
const Points partial_points{"x=1/2 c=2/3 G=5/4 P=1/4 y=1/5 s=1/2 u=1/3 q=1/7", "x=4/5 c=1/9 G=3 P=1/2 y=1/8 s=1/3 u=2/3 q=2/9"};

/// A claim that is one identity times a factor of 1: perturbed, it has to fail.
OwnClaim identity_claim(const std::string& id, const std::string& statement, const std::string& used_in,
                        std::function<Finding(const ex& one)> judge)
{
    return {id,         statement, used_in, {{"factor", 1}}, [judge = std::move(judge)](const Constants& k) { return judge(k.exact(0)); },
            {{0, 0.99}}};
}

Finding place(const ex& one)
{
    const ex u2 = sym("u"); // the square of the place
    return Argument("symbolic identity")
        .add("P^2 of (2.4) at c = 1 - 2 x u^2 is 4 x (1 - u^2)(1 - x u^2)",
             identity(wave::pressure_partial_squared<ex>(x(), 1 - 2 * x() * u2),
                      one * 4 * wave::quarter_pressure_squared<ex>(x(), u2, 1 - u2), partial_points))
        .conclude("the wave by its phase and by the place in its contact");
}

Finding seam(const ex& one)
{
    return Argument("symbolic identity")
        .add("at x = 1 (2.4) and (2.2) are one",
             identity(wave::pressure_partial_squared<ex>(1, c()), one * pow(wave::pressure_full<ex>(1, c()), 2), full_points))
        .conclude("y is continuous across x = 1");
}

Finding radius(const ex& one)
{
    const ex R = x() + c(), P2 = wave::pressure_partial_squared<ex>(x(), c());
    return Argument("symbolic identity")
        .add("R = x + c, R^2 = (1-x)^2 + P^2", identity(pow(wave::radius<ex>(1 - x(), P2), 2), one * pow(R, 2), partial_points))
        .add("1 - c = (4x - P^2)/(1 + x + R)", identity(wave::one_minus_c_partial<ex>(x(), R, P2), one * (1 - c()), partial_points))
        .add("1 + c = R + 1 - x", identity(wave::one_plus_c_partial<ex>(1 - x(), R), one * (1 + c()), partial_points))
        .conclude("theta from the pressure, without cancellation");
}

/// Squares of positive numbers are compared, so that no root is left but R.
Finding kernels(const ex& one)
{
    const ex sine2 = 1 - pow(c(), 2); // of theta
    const ex full = pow(G(), 2) / sine2;
    Ring ring;
    const ex gy = G() * y(), R = ring.root("R", pow(1 - x(), 2) + pow(gy, 2)), cos_theta = R - x();
    const ex partial = pow(G() * gy / R, 2) / (1 - pow(cos_theta, 2)); // (dR/dy)^2/sin^2
    const ex hi2 = 4 * x() / pow(G(), 2);
    const ex y_full = wave::pressure_full<ex>(x(), c()) / G();
    return Argument("symbolic identities")
        .add("x >= 1: |dtheta/dy| = G/sin theta by the distances from the ends",
             identity(pow(wave::kernel_full<ex>(wave::highest_full<ex>(x(), G()) - y_full, y_full - wave::lowest_full<ex>(x(), G())), 2),
                      one * full, full_points))
        .add("x < 1: |dtheta/dy| = (G^2 y/R)/sin theta",
             identity(pow(wave::kernel_partial<ex>(x(), 1 - x(), R, gy, hi2 - pow(y(), 2), 1), 2), one * partial, partial_points, ring))
        .add(
            "x < 1, the rest beside the end's root",
            identity(pow(wave::kernel_partial_rest<ex>(x(), 1 - x(), R, gy), 2) / (hi2 - pow(y(), 2)), one * partial, partial_points, ring))
        .add("x >= 1: |dtheta/dz|, z = y^2, is that over 2y",
             identity(pow(wave::kernel_full_squared<ex>(x(), G(), pow(y(), 2)), 2),
                      one * pow(G() / (2 * y()), 2) / (1 - pow(G() * y() - x(), 2)), full_points))
        .add("x < 1: |dtheta/dz|", identity(pow(wave::kernel_partial_squared<ex>(x(), pow(G(), 2), pow(y(), 2)), 2),
                                            one * partial / (4 * pow(y(), 2)), partial_points, ring))
        .conclude("the kernel in its five spellings is dtheta of one wave");
}

Finding squares(const ex& one)
{
    const ex q = (1 - c()) / 2, from_below = (1 + c()) / 2;
    const ex full = pow(wave::pressure_full<ex>(x(), c()), 2), partial = wave::pressure_partial_squared<ex>(x(), c());
    return Argument("symbolic identities")
        .add("x >= 1, sin^2(theta/2)", identity(wave::square_full_from_above<ex>(x(), q), one * full, full_points))
        .add("x >= 1, cos^2(theta/2)", identity(wave::square_full_from_below<ex>(x(), from_below), one * full, full_points))
        .add("x < 1, sin^2(theta/2)", identity(wave::square_partial_from_above<ex>(x(), q), one * partial, partial_points))
        .add("x < 1, cos^2(theta/2)", identity(wave::square_partial_from_below<ex>(1 - x(), from_below), one * partial, partial_points))
        .conclude("z G^2 = P^2 as a polynomial of sin or cos of theta/2");
}

Finding needed(const ex& one)
{
    const ex needs = wave::needed_partial<ex>(P(), c());
    Ring ring;
    const ex R = ring.root("R", pow(1 - x(), 2) + pow(P(), 2)), cos_theta = R - x();
    const ex dx_dc = needs.diff(symbol_of(c())), dx_dP = needs.diff(symbol_of(P()));
    return Argument("symbolic identities")
        .add("the ratio needed gets there: P^2 at it",
             identity(wave::pressure_partial_squared<ex>(needs, c()), one * pow(P(), 2), partial_points))
        .add("and in full contact", identity(wave::pressure_full<ex>(wave::needed_full<ex>(P(), c()), c()), one * P(), full_points))
        .add("|dtheta/dx| at constant P",
             identity(pow(wave::needed_kernel_partial_rest<ex>(x(), 1 - x(), R), 2) / (x() - pow(P(), 2) / 4),
                      one / ((1 - pow(cos_theta, 2)) * pow(dx_dc.subs(c() == cos_theta), 2)), partial_points, ring))
        .add("dx/dP at constant theta",
             identity(wave::needed_slope_partial<ex>(P(), 1 - x(), R), one * dx_dP.subs(c() == cos_theta), partial_points, ring))
        .conclude("the wave read backwards, (W3) and (W4)");
}

Finding equilibrium(const ex& one)
{
    Ring ring;
    const ex u = sym("u"), w = ring.root("w", 1 - pow(u, 2)), root_x = ring.root("v", x()), rest = ring.root("r", 1 - x() * pow(u, 2));
    const ex y_of = 2 * root_x * w * rest / G(), dtheta = 2 * root_x * w / rest; // u = sin psi, w = cos psi
    const ex psi = sym("psi"), mean = psi / 2 + sin(2 * psi) / 4;
    const ex theta = sym("theta"), full = (x() * theta + sin(theta)) / G();
    Ring angles;
    angles.angle("a", psi);
    return Argument("symbolic identities")
        .add("y of that is the wave's",
             identity(pow(y_of, 2), wave::pressure_partial_squared<ex>(x(), 1 - 2 * x() * pow(u, 2)) / pow(G(), 2), partial_points, ring))
        .add("sin(theta) dtheta/dpsi = -dc/dpsi = 4 x sin(psi) cos(psi)",
             identity(pow(dtheta, 2) * (1 - pow(1 - 2 * x() * pow(u, 2), 2)), pow(4 * x() * u * w, 2), partial_points, ring))
        .add("x < 1: y dtheta = (4x/G) cos^2(psi) dpsi",
             identity(y_of * dtheta, 4 * wave::equilibrium<ex>(x(), G()) * pow(w, 2), partial_points, ring))
        .add("cos^2 is the derivative of psi/2 + sin(2 psi)/4",
             identity(mean.diff(symbol_of(psi)), pow(cos(psi), 2), Points{"psi=1/3"}, angles))
        .add("which is 0 at psi = 0", identity(mean.subs(psi == 0), 0, Points{"psi=1/3"}))
        .add("and pi/4 at psi = pi/2: T y = x/G", identity(4 / GiNaC::Pi * mean.subs(psi == GiNaC::Pi / 2), one, Points{"psi=1/3"}))
        .add("x >= 1: (x theta + sin theta)/G has the derivative y",
             identity(full.diff(symbol_of(theta)), wave::pressure_full<ex>(x(), cos(theta)) / G(), Points{"x=3/2 G=5/4 theta=1/3"}))
        .add("is 0 at theta = 0", identity(full.subs(theta == 0), 0, full_points))
        .add("and pi x/G at theta = pi",
             identity(full.subs(theta == GiNaC::Pi) / GiNaC::Pi, one * wave::equilibrium<ex>(x(), G()), full_points))
        .conclude("the mean pressure is the load, at every scale: id is an eigenfunction of T, of eigenvalue 1/G");
}

Finding positivity(const Constants& k)
{
    const ex w = sym("w"), q = sym("q");
    return Argument("convexity, and subdivision")
        .add("arcsin'' = w/(1 - w^2)^(3/2)",
             identity(pow(asin(w).diff(symbol_of(w), 2), 2), pow(w, 2) / pow(1 - pow(w, 2), 3), full_points))
        .add("which is positive in (0, 1), w = 1/(1 + q): 1 - w^2 = q(2 + q)/(1 + q)^2; arcsin is below its chord from 0 to pi/2",
             identity((1 - pow(w, 2)).subs(w == 1 / (1 + q)), q * (2 + q) / pow(1 + q, 2), full_points))
        .add("T 1 = (2/pi) arcsin x^(1/2) < factor x^(1/2), in balls",
             positive_over(
                 [&](const std::vector<Ball>& v) { return k.ball(0) * wave::positivity(v[0] * v[0]) - 2 * asin(v[0]) / pi<Ball>(); },
                 {{"x^(1/2)", Rational(1, 1000), Rational(999'999, 1'000'000)}}))
        .conclude("T is a mean with a positive kernel, of mass T 1: errors are averaged, not amplified");
}

Finding monotone(const ex& one)
{
    const ex slope = wave::pressure_partial_squared<ex>(x(), c()).diff(symbol_of(x()));
    return Argument("symbolic identity")
        .add("d(P^2)/dx = 2 (1 + c), x < 1, not negative as c is a cosine", identity(slope, one * wave::monotone<ex>(c()), partial_points))
        .add("dP/dx = 1, x >= 1", identity(wave::pressure_full<ex>(x(), c()).diff(symbol_of(x())), one, full_points))
        .add("arcsin(x^(1/2)) rises: the square of its derivative is 1/(4 x (1 - x))",
             identity(pow(asin(sqrt(x())).diff(symbol_of(x())), 2), 1 / (4 * x() * (1 - x())), partial_points))
        .conclude("B_m increases with x where B_0 does");
}

Finding after_the_fact(const ex& one)
{
    const ex T1 = sym("u"), T2 = sym("w"), d0 = sym("h"), d1 = sym("q"), d2 = sym("s"); // T2 = T T1
    const ex e1 = wave::after_the_fact<ex>(T1 * d0, d1), e2 = wave::after_the_fact<ex>(T2 * d0 + T1 * d1, d2);
    return Argument("induction")
        .add("the errors after one level: T D_0 + D_1", identity(e1, one * (T1 * d0 + d1), full_points))
        .add("after two: T^2 D_0 + T D_1 + D_2", identity(e2, one * (T2 * d0 + T1 * d1 + d2), full_points))
        .note(
            "|B_m - V_m| = |T(B_{m-1} - V_{m-1}) + (T V_{m-1} - V_m)|, T linear and positive: the triangle inequality, then induction on m")
        .conclude("defects add, and T averages them");
}

Finding share_of(const Constants& k)
{
    const ex w = sym("w");
    Ring ring;
    return Argument("symbolic identity, and subdivision")
        .add("an interval at an end of [-1, 1] has arccos(1 - w) = 2 arcsin (w/2)^(1/2): derivatives",
             identity(pow(acos(1 - w).diff(symbol_of(w)), 2), pow((2 * asin(sqrt(w / 2))).diff(symbol_of(w)), 2), full_points, ring))
        .add("1/(1 - c^2)^(1/2) has the sign of c for derivative: it falls, then rises, and a window of given length has most at an end",
             identity((1 / sqrt(1 - pow(c(), 2))).diff(symbol_of(c())) * pow(sqrt(1 - pow(c(), 2)), 3), c(), full_points, ring))
        .add("(2/pi) arcsin (w/2)^(1/2) < factor (w/2)^(1/2), in balls",
             positive_over(
                 [&](const std::vector<Ball>& v) { return k.ball(0) * wave::share_of(v[0]) - 2 * asin(wave::share_of(v[0])) / pi<Ball>(); },
                 {{"w", Rational(1, 1000), Rational(1999, 1000)}}))
        .add("dc/dy = G y G/R <= G, x < 1: R^2 - (G y)^2 = (1 - x)^2",
             identity(pow(wave::radius<ex>(1 - x(), pow(P(), 2)), 2) - pow(P(), 2), pow(1 - x(), 2), partial_points))
        .conclude("what a narrow interval of ratios can count for, whatever x is");
}

Finding share_of_twice(const Constants& k)
{
    const ex t = sym("u"), f = t * (1 - log(t)); // G = (pi^2/8) t^2
    const ex l = sym("h"), level = sym("q"), per_length = sqrt(8 * G()) / GiNaC::Pi; // t0/l
    return Argument("symbolic identities, and a maximum")
        .add("between the levels t0 and (l/2)^(1/2): int 4 (G/2)^(1/2) (l^(1/2) + l/(pi t)) dt, its first part 2 G^(1/2) l up to "
             "(l/2)^(1/2)",
             identity(pow(4 * sqrt(G() / 2) * sqrt(l) * sqrt(l / 2), 2), pow(2 * sqrt(G()) * l, 2), Points{"G=5/4 h=1/9", "G=3 h=1/3"}))
        .add("d at the level t0 = l (8G)^(1/2)/pi is 1/(8G): (l/(pi t0))^2",
             identity(pow(l / (GiNaC::Pi * level), 2).subs(level == l * per_length), 1 / (8 * G()), Points{"G=5/4 h=1/9"}))
        .add("t (1 - log t) rises up to t = 1 and falls then: its derivative is -log t",
             identity(f.diff(symbol_of(t)), -log(t), full_points))
        .add("G^(1/2) (8^(1/2)/pi)(1 + (1/2) log(pi^2/(8 G))) <= the constant: at its largest, G = pi^2/8, it is 1",
             exactly(k.number(0) >= 1, "1 against " + std::to_string(k.number(0))))
        .add("and in balls, with G to 400", positive_on(k.exact(0) - f.subs(t == per_length), {{"G", Rational(3, 2), Rational(400)}}))
        .conclude("two waves spread an interval's share in proportion to its length");
}

/// Upper sums over a fine grid of theta: T y^a at x, in balls.
Ball upper_mean_of_power(const Ball& x, const Ball& a, bool full)
{
    constexpr long cells = 96;
    Ball sum(0);
    for (long i = 0; i < cells; ++i) {
        const Ball angle = hull(Ball(Rational(i, cells)), Ball(Rational(i + 1, cells)));
        const Ball cosine = cos_pi(angle);
        const Ball P2 = full ? wave::pressure_full(x, cosine) * wave::pressure_full(x, cosine) : wave::pressure_partial_squared(x, cosine);
        Ball top;
        arb_get_ubound_arf(arb_midref(top.get()), P2.get(), 60);
        if (arb_is_nonpositive(top.get())) continue;
        sum += pow(top, a / 2);
    }
    return sum / cells;
}

Finding after_steps(const Constants& k)
{
    const ex a = sym("u");
    const wave::Power next = wave::after_steps({1, 0.5}, 4);
    Argument argument("Hoelder's inequality; subdivision");
    argument.add("a + (1 - a)/2 = (1 + a)/2", identity(a + (1 - a) / 2, (1 + a) / 2, full_points))
        .add("the code's second step at G = 4 has the exponent 3/4 and the factor 4^(-1/2)",
             exactly(next.exponent == 0.75 && next.factor == 0.5, "3/4, 1/2"))
        .note("T(y^a 1^(1-a)) <= (T y)^a (T 1)^(1-a), Hoelder's inequality; T y by equilibrium, T 1 by positivity");
    for (const Rational& exponent : {Rational(1, 2), Rational(3, 4)})
        for (const bool full : {false, true})
            argument.add("G^a T y^a <= factor x^((1+a)/2), a = " + exponent.get_str() + (full ? ", x >= 1" : ", x < 1"),
                         positive_over(
                             [&](const std::vector<Ball>& v) {
                                 const WorkingPrecision low(60);
                                 return k.ball(0) * pow(v[0], Ball(Rational((1 + exponent) / 2))) -
                                        upper_mean_of_power(v[0], Ball(exponent), full);
                             },
                             {{"x", full ? Rational(1) : Rational(1, 8), full ? Rational(3) : Rational(1)}}));
    return argument.conclude("how little of a late level reaches a small load");
}

Finding singular_set(const ex& one)
{
    const ex s = sym("s");
    const Points at{"G=5/4 s=7/5", "G=3 s=1/3"};
    return Argument("symbolic identities")
        .add("the lower end of the wave at G s + 1 is s",
             identity(wave::lowest_full<ex>(wave::meets_lower_end<ex>(s, G()), G()), one * s, at))
        .add("the upper end of the wave at G s - 1 is s",
             identity(wave::highest_full<ex>(wave::meets_upper_end_full<ex>(s, G()), G()), one * s, at))
        .add("the upper end at G^2 s^2/4, partial contact, is s",
             identity(pow(wave::highest_partial<ex>(wave::meets_upper_end_partial<ex>(s, G()), G()), 2), one * pow(s, 2), at))
        .add("one of the two: G^2 s^2/4 - 1 = ((G s - 1) - 1)(G s/2 + 1)/2",
             identity(wave::meets_upper_end_partial<ex>(s, G()) - 1,
                      one * (wave::meets_upper_end_full<ex>(s, G()) - 1) * (G() * s / 2 + 1) / 2, at))
        .note("away from these x no singular point is at an end of the path of integration, which may then be moved into the complex plane")
        .conclude("where the functions of the recursion are not analytic");
}

Finding continuity(const Constants& k)
{
    const ex t = sym("u");
    Ring ring;
    return Argument("symbolic identities, and subdivision")
        .add("d arcsin(t^(1/2))/dt = 1/(2 (t(1-t))^(1/2)), which falls, then rises",
             identity(pow(asin(sqrt(t)).diff(symbol_of(t)), 2), 1 / (4 * t * (1 - t)), full_points, ring))
        .add("t(1-t) has the derivative 1 - 2t: so a window of length h has most at an end of [0, 1]",
             identity((t * (1 - t)).diff(symbol_of(t)), 1 - 2 * t, full_points))
        .add(
            "which is (2/pi) arcsin h^(1/2) < factor h^(1/2), in balls",
            positive_over(
                [&](const std::vector<Ball>& v) { return k.ball(0) * wave::continuity(v[0], Ball(1)) - 2 * asin(sqrt(v[0])) / pi<Ball>(); },
                {{"h", Rational(1, 1000), Rational(999, 1000)}}))
        .note("m -> m + 1: monotone, equilibrium, and Jensen's inequality for the square root")
        .conclude("B_m has a modulus of continuity that no level makes worse");
}

Finding shift(const Constants& k)
{
    return Argument("counting, in exact arithmetic")
        .note("two shifts (R, and R^2 against it; one for x >= 1) of 4 times the mass (h/2)^(1/2) each: (2 * 4)^2 h/2 = 32 h")
        .add("8 (h/2)^(1/2) <= (constant h)^(1/2)",
             exactly(Rational(64, 2) <= Rational(k.number(0)), "32 against " + std::to_string(k.number(0))))
        .add("x >= 1, in balls: the two laws of c, h apart, differ in all by less than (constant h)^(1/2)/2",
             positive_over(
                 [&](const std::vector<Ball>& v) {
                     // no more than 4 times the mass within h of an end: equal to it at h = 2
                     const Ball& h = v[0];
                     return sqrt(k.ball(0) * h) / 2 - 4 * (2 * asin(wave::share_of(h)) / pi<Ball>());
                 },
                 {{"h", Rational(1, 100), Rational(199, 100)}}))
        .conclude("what a shift of the load can change, V being no more than bounded");
}

} // namespace

std::vector<OwnClaim> operator_claims()
{
    return {
        identity_claim("wave::place", "P^2 = (1 + c)(2x - 1 + c) = 4x (1 - u^2)(1 - x u^2), c = 1 - 2 x u^2", in_wave, place),
        identity_claim("wave::seam", "(2.2) and (2.4) agree at x = 1", in_wave, seam),
        identity_claim("wave::radius", "R = x + c, R^2 = (1-x)^2 + P^2; 1 - c = (4x - P^2)/(1 + x + R)", in_wave, radius),
        identity_claim("wave::kernel", "five spellings of |dtheta/dy|, |dtheta/dy^2| in full and partial contact are one", in_wave,
                       kernels),
        identity_claim("wave::square", "G^2 y^2 as polynomials of sin(theta/2)^2 and cos(theta/2)^2", in_wave, squares),
        identity_claim("wave::needed", "the ratio that a wave needs at theta to get to P, its density and its slope", in_wave, needed),
        identity_claim("wave::equilibrium", "T y = x/G in both regimes", in_lemmas, equilibrium),
        {"wave::positivity",
         "T 1 <= {0} x^(1/2), and phi <= chi implies T phi <= T chi",
         "every method",
         {{"factor", 1}},
         positivity,
         {{0, 0.99}}},
        identity_claim("wave::monotone", "y increases with x at constant theta", in_lemmas, monotone),
        identity_claim("wave::after_the_fact", "|B_n - T V_{n-1}| <= sum T^(n-m) D_m", "transfer/proven_levels.cpp", after_the_fact),
        {"wave::share_of",
         "an interval of c of length w has a share of theta of at most {0} (w/2)^(1/2)",
         "transfer/proven_levels.cpp, layer.cpp",
         {{"factor", 1}},
         share_of,
         {{0, 0.95}}},
        {"wave::share_of_twice",
         "T^2 1_J <= l ({0} + 2 G^(1/2) + ((2G)^(1/2)/pi) log+(1/(2l))), l = G |J|",
         "transfer/proven_levels.cpp",
         {{"constant", 1}},
         share_of_twice,
         {{0, 0.999}}},
        {"wave::after_steps",
         "T^k 1 <= {0} C_k x^(a_k), a_{k+1} = (1 + a_k)/2, C_{k+1} = C_k G^(-a_k)",
         "transfer/proven_levels.cpp",
         {{"factor", 1}},
         after_steps,
         {{0, 0.85}}},
        identity_claim("wave::singular_set", "singular points go to G s + 1, and to G s - 1 or G^2 s^2/4",
                       "transfer/singular_points.cpp, heavy_load.cpp", singular_set),
        {"wave::continuity",
         "0 <= B_m(x+h) - B_m(x) <= {0} (h/G^m)^(1/2)",
         "transfer/heavy_load.cpp",
         {{"factor", 1}},
         continuity,
         {{0, 0.95}}},
        {"wave::shift",
         "|T V(x) - T V(x')| <= ({0} |x - x'|)^(1/2) sup|V|, on one side of 1",
         "transfer/proven_levels.cpp",
         {{"constant", wave::shift}},
         shift,
         {{0, 31.9}}},
    };
}

} // namespace touchstone::proofs
