// SPDX-License-Identifier: GPL-3.0-or-later
/// Section 2 of the paper: one sine wave (Westergaard's solution).
#include "proofs/consequences.hpp"
#include "proofs/lemmas/elasticity.hpp"
#include "proofs/ledger.hpp"
#include "proofs/symbolic/symbolic.hpp"
#include "proofs/symbolic/units.hpp"

#include "touchstone/paper/as_printed.hpp"
#include "touchstone/paper/westergaard.hpp"
#include "touchstone/scalar/symbol.hpp"

namespace touchstone::proofs {

namespace {

using GiNaC::Pi;

ex diff_p(const ex& e) { return e.diff(GiNaC::ex_to<GiNaC::symbol>(sym("p"))); }
const ex& E() { static const ex s = sym("E"); return s; }
ex pbar() { return sym("pbar"); }
ex pstar() { return sym("pstar"); }
ex load() { return sym("pbar") / sym("pstar"); }

const Points full_points{"pbar=3/2 pstar=1 p=7/4 x=1/5 lambda=3 g=1/7 E=5 nu=1/4", "pbar=5/2 pstar=2 p=3 x=2/3 lambda=5 g=1/9 E=7 nu=1/3"};
const Points partial_points{"pbar=1/3 pstar=1 p=1/2 x=1/10 lambda=3/2 a=1/4 g=1/7 E=5 nu=1/4",
                            "pbar=3/4 pstar=2 p=3/4 x=1/8 lambda=3 a=2/5 g=1/9 E=7 nu=1/3"};

/// (2.3) from the elastic half-plane (elasticity.hpp) for the profile g cos(kx).
ex pstar_of_profile() { return amplitude_of_pressure(sym("g"), 2 * Pi / sym("lambda")); }

/// What (2.2) gives, and what (2.4) gives with (2.5) in it, as the library computes them.
ex pressure_full() { return pstar() * westergaard::pressure_full<Symbol>(sym("x") / sym("lambda"), load()); }
ex pressure_partial() { return pstar() * westergaard::pressure_partial<Symbol>(sym("x") / sym("lambda"), load()); }

Finding wave(const Print& p)
{
    const ex k = 2 * Pi / sym("lambda");
    const Points at{"g=1/7 x=1/5 lambda=3"};
    return Argument("normal form")
        .add("dimensions", units(p))
        .add("the amplitude, z(0), is g", identity(p("rhs").subs(sym("x") == 0), sym("g"), at))
        .add("the wavelength is lambda: z'' = -(2 pi/lambda)^2 z",
             identity(p("rhs").diff(GiNaC::ex_to<GiNaC::symbol>(sym("x")), 2), -k * k * p("rhs"), at))
        .conclude("the profile that section 2 presses into the half-plane", Verdict::definition);
}

Finding full_contact_pressure(const Print& p)
{
    Ring ring;
    ring.angle("w", Pi * sym("x") / sym("lambda"));
    const ex oscillating = p("rhs") - pbar();
    return Argument("symbolic identity; the half-plane solved by an Airy function")
        .add("dimensions", units(p))
        .add("a pressure c cos(kx) displaces the surface by 2(1 - nu^2) c cos(kx)/(E k): equilibrium, Hooke's law and no shear on the "
             "surface",
             half_plane_mode())
        .add("with (2.3) the oscillating part displaces the surface by the profile (2.1)",
             identity(displacement_of_pressure(oscillating, 2 * Pi / sym("lambda")).subs(pstar() == pstar_of_profile()),
                      sym("g") * cos(2 * Pi * sym("x") / sym("lambda")), full_points, ring))
        .add("the mean over a wavelength is pbar: the oscillating part is -(lambda/2 pi)^2 times its own second derivative, so its "
             "integral over a period is zero",
             identity(-pow(sym("lambda") / (2 * Pi), 2) * oscillating.diff(GiNaC::ex_to<GiNaC::symbol>(sym("x")), 2), oscillating,
                      full_points))
        .add("the least pressure, at x = lambda/2, is pbar - p*, so that nothing pulls if pbar >= p*",
             identity(p("rhs").subs(sym("x") == sym("lambda") / 2), pbar() - pstar(), full_points))
        .add("the library's form is the same", identity(pressure_full(), p("rhs"), full_points, ring))
        .conclude("linear elasticity in plane strain, no friction; the mean pressure displaces the surface uniformly");
}

Finding full_contact_amplitude(const Print& p)
{
    return Argument("symbolic identity; the half-plane solved by an Airy function")
        .add("dimensions", units(p))
        .add("a pressure c cos(kx) displaces the surface by 2(1 - nu^2) c cos(kx)/(E k)", half_plane_mode())
        .add("the amplitude that displaces the surface by g, k = 2 pi/lambda", identity(p("rhs"), pstar_of_profile(), full_points))
        .conclude("linear elasticity in plane strain, no friction");
}

/// A printed pressure with lambda = pi, pbar = 1, at x = y a: over a box of y = x/a and a inside the contact.
ex inside_contact(const ex& e)
{
    return e.subs(GiNaC::lst{sym("x") == sym("y") * sym("a")}).subs(GiNaC::lst{sym("lambda") == Pi, pbar() == 1});
}
std::vector<Range> contact_box() { return {{"y", Rational(-1, 2), Rational(1, 2)}, {"a", Rational(1, 5), Rational(6, 5)}}; }

Finding westergaard_pressure(const Print& p)
{
    const ex sa = sin(Pi * sym("a") / sym("lambda")), w = Pi * sym("x") / sym("lambda");
    const ex derived = 2 * pbar() * cos(w) / pow(sa, 2) * sqrt(pow(sa, 2) - pow(sin(w), 2));
    const ex u = sym("u"), A = 2 * pbar() / sym("S"), q = 1 / sym("u");
    // cos w sqrt(S - sin^2 w) with e^{iw} = 1/sqrt(u): (1/(4u)) (1 + u) sqrt((1 - u)^2 + 4 S u)
    const ex inner = A * q / 4 * (1 + u) * sqrt(pow(1 - u, 2) + 4 * sym("S") * u);
    const ex decaying = inner - A / 4 * (q - u);
    return Argument("Westergaard's function: its values on the surface and far below it, by normal form and series")
        .add("dimensions", units(p))
        .add("a pressure c cos(kx) displaces the surface by 2(1 - nu^2) c cos(kx)/(E k), so the pressure and E/(2(1 - nu^2)) times the "
             "surface slope are the real and imaginary part of a function analytic below the surface",
             half_plane_mode())
        .argue("take W = A cos w sqrt(S - sin^2 w) - (i A/2) sin 2w with w = pi (x - i y)/lambda, S = sin^2(pi a/lambda), A = 2 pbar/S; on "
               "|x| < a the root is real, outside it is imaginary, so the pressure Re W is A cos w sqrt(S - sin^2 w) in the contact and 0 "
               "outside")
        .add("W tends to pbar far below the surface: the mean pressure is pbar",
             limit_at_zero(decaying, u, pbar(), Points{"pbar=1/3 S=1/4"}))
        .add("in the contact Im W is -(A/2) sin 2w, and with A = 2 p* the surface slope that goes with it is that of the profile (2.1)",
             identity(displacement_of_pressure(pstar() * cos(2 * w), 2 * Pi / sym("lambda")).subs(pstar() == pstar_of_profile()),
                      sym("g") * cos(2 * w), partial_points))
        .add("outside, the gap opens at a rate with the square of A cos w sqrt(sin^2 w - S), positive up to x = lambda/2: W^2 is the same "
             "on both sides of the edge",
             identity(pow(derived, 2), pow(2 * pbar() / pow(sa, 2), 2) * pow(cos(w), 2) * (pow(sa, 2) - pow(sin(w), 2)), partial_points))
        .add("the print is Re W: equal squares, both positive for |x| < a", identity(pow(p("rhs"), 2), pow(derived, 2), partial_points))
        .add("the sign: neither has a zero inside the contact, so one sign holds there; the print is positive wherever |x|/a <= 1/2 and "
             "1/5 <= pi a/lambda <= 6/5",
             positive_on(inside_contact(p("rhs")), contact_box()))
        .add(
            "with (2.5) in it the library's form is the same",
            identity(pow(derived.subs(sym("a") == sym("lambda") / Pi * asin(sqrt(load()))), 2), pow(pressure_partial(), 2), partial_points))
        .conclude("pressure and displacement satisfy the equations and the inequalities of the contact problem, whose solution is unique");
}

Finding contact_half_width(const Print& p)
{
    const ex a = p("rhs"), sine = pow(sin(Pi * a / sym("lambda")), 2);
    const ex S = sym("S");
    return Argument("symbolic identity")
        .add("dimensions", units(p))
        .add("the slope of the surface in the contact is that of the profile if 2 pbar/sin^2(pi a/lambda) = 2 p* (see 2.4)",
             identity(2 * pbar() / sine, 2 * pstar(), partial_points))
        .add("the library's half-width has the same derivative in S = pbar/p*",
             identity(pow((a / sym("lambda")).subs(pbar() == S * pstar()).diff(GiNaC::ex_to<GiNaC::symbol>(S)), 2),
                      pow(westergaard::half_width<Symbol>(S).diff(GiNaC::ex_to<GiNaC::symbol>(S)), 2), Points{"S=1/3 pstar=1 lambda=2"}))
        .add("and the same value, 0, at S = 0",
             identity(a.subs(pbar() == 0), westergaard::half_width<Symbol>(ex(0)), Points{"pstar=2 lambda=2"}))
        .conclude("arcsin(...)^(1/2) is read as the arcsine of the square root; the other reading is a control");
}

Finding hertz_pressure(const Print& p)
{
    // ratio of the squares of (2.4) and the print at x = xi a, as a -> 0
    const ex xi = sym("xi"), a = sym("a");
    const ex exact = pow(prints().at("2.4")("rhs"), 2).subs(sym("x") == xi * a);
    const ex print = pow(p("rhs"), 2).subs(sym("x") == xi * a);
    return Argument("series")
        .add("dimensions", units(p))
        .add("the square of (2.4) over the square of the print tends to 1 as a/lambda -> 0, at each x/a",
             limit_at_zero(exact / print, a, 1, Points{"xi=1/3 pbar=1/5 lambda=2"}))
        .add("the print carries the load pbar lambda: 2 pbar lambda/(pi a) times a pi/2",
             identity(p("rhs").subs(sym("x") == 0) * sym("a") * Pi / 2, pbar() * sym("lambda"), Points{"pbar=1/3 a=1/4 lambda=2"}))
        .add("with (2.7) in it the library's form is the same",
             identity(pow(p("rhs").subs(sym("a") == sym("lambda") / Pi * sqrt(load())), 2),
                      pow(pstar() * hertz::pressure<Symbol>(sym("x") / sym("lambda"), load()), 2),
                      Points{"pbar=1/3 pstar=1 x=1/20 lambda=1"}))
        .conclude("as the limit pbar/p* -> 0 of (2.4), which is what the paper says it is");
}

Finding hertz_half_width(const Print& p)
{
    const ex t = sym("t"), at_t = p("rhs").subs(pbar() == t * t * pstar());
    const ex R = 1 / (pow(2 * Pi / sym("lambda"), 2) * sym("g")); // radius of curvature of the peak
    const ex hertz = 4 * pbar() * sym("lambda") * R * (1 - pow(sym("nu"), 2)) / (Pi * E());
    return Argument("series and normal form")
        .add("dimensions", units(p))
        .add("(2.5) over the print tends to 1 as t = sqrt(pbar/p*) -> 0",
             limit_at_zero(sym("lambda") / Pi * asin(t) / at_t, t, 1, Points{"lambda=2 pstar=3"}))
        .add("it is Hertz's half-width for the radius of curvature of the peak and the load pbar lambda, a^2 = 4 P R (1 - nu^2)/(pi E)",
             identity(pow(p("rhs"), 2).subs(pstar() == pstar_of_profile()), hertz, full_points))
        .add("the library's form is the same",
             identity(p("rhs") / sym("lambda"), hertz::half_width<Symbol>(load()), Points{"pbar=1/3 pstar=1 lambda=2"}))
        .conclude("as the limit pbar/p* -> 0 of (2.5), which is what the paper says it is");
}

Finding hertz_range(const Print& p)
{
    const Rational S(p.rational("rhs"));
    const Ball t = sqrt(Ball(S));
    const Ball error = asin(t) / t - 1; // grows with t: a ratio of a convex odd function to its tangent
    return Argument("certified evaluation")
        .add("dimensions", units(p))
        .note("the Hertzian half-width is short by " + error.to_string(4) + " of itself at pbar/p* = " + S.get_str() +
              ", and less below; the peak pressure is exact (2.10) and so is the load")
        .conclude("'acceptable' here means: half-width within " + percent(error) + ", peak pressure exact", Verdict::qualitative);
}

Finding peak_pressure_full(const Print& p)
{
    Ring ring;
    const auto [s, c] = ring.angle("w", Pi * sym("x") / sym("lambda"));
    return Argument("normal form")
        .add("dimensions", units(p))
        .add("the print less the pressure (2.2) is 2 p* sin^2(pi x/lambda), zero at x = 0 and not negative",
             identity(p("rhs") - pressure_full(), 2 * pstar() * s * s, full_points, ring))
        .add("the regime is full contact, the condition ends at pbar = p*",
             identity(p.sides("condition").front(), pbar(), full_points).verdict == Verdict::proved
                 ? identity(p.sides("condition").back(), pstar(), full_points)
                 : Check{Verdict::refuted, "another condition"})
        .conclude();
}

Finding peak_pressure_partial(const Print& p)
{
    Ring ring;
    const auto [s, c] = ring.angle("w", Pi * sym("x") / sym("lambda"));
    return Argument("normal form")
        .add("dimensions", units(p))
        .add("the square of the print less that of (2.4) is 4 p* sin^2(w) (p* - pbar + ... ), here 4 p*^2 s^2 (1 + S - s^2) with s = "
             "sin(pi x/lambda): zero at x = 0 and not negative",
             identity(pow(p("rhs"), 2) - pow(pressure_partial(), 2), 4 * pow(pstar(), 2) * s * s * (1 + load() - s * s), partial_points,
                      ring))
        .add("the library's peak pressure in partial contact is the same", identity(p("rhs"), pstar() * 2 * sqrt(load()), partial_points))
        .conclude();
}

Finding exceedance_bounds(const Print& p)
{
    Ring ring;
    const auto [s, c] = ring.angle("w", Pi * sym("x") / sym("lambda"));
    const bool below = p.text("condition").find('<') != std::string::npos;
    const ex bound = p.sides("condition").back();
    return Argument("normal form")
        .add("dimensions", units(p))
        .add(below ? "the pressure (2.2) less the bound is 2 p* cos^2(pi x/lambda) >= 0"
                   : "the bound less the pressure (2.2) is 2 p* sin^2(pi x/lambda) >= 0",
             identity(below ? ex(pressure_full() - bound) : ex(bound - pressure_full()), 2 * pstar() * (below ? c * c : s * s), full_points,
                      ring))
        .add("so the pressure exceeds p " + std::string(below ? "everywhere" : "nowhere"), identity(p("rhs"), below ? 1 : 0, Points{"p=1"}))
        .conclude();
}

Finding exceedance_segment(const Print& p)
{
    const ex end = p("1.rhs");
    Ring ring;
    ring.angle("w", Pi * sym("x") / sym("lambda"));
    return Argument("normal form")
        .add("dimensions", units(p))
        .add("at the right end the pressure (2.2) is p",
             identity(pbar() + pstar() * cos(2 * Pi * end / sym("lambda")), sym("p"), full_points))
        .add("the left end is its mirror image", identity(p("0.lhs"), -end, full_points))
        .add("between 0 and lambda/2 the pressure decreases: minus its derivative is (2 pi p*/lambda) sin(2 pi x/lambda), with x = lambda "
             "y/2 positive for y in (0, 1); arccos lies between 0 and pi",
             identity(-pressure_full().diff(GiNaC::ex_to<GiNaC::symbol>(sym("x"))),
                      2 * Pi * pstar() / sym("lambda") * sin(2 * Pi * sym("x") / sym("lambda")), full_points, ring))
        .add("the segment is -end < x < end", exactly(p.text("0.relation") == "<" && p.text("1.relation") == "<" &&
                                                          p("0.rhs").is_equal(sym("x")) && p("1.lhs").is_equal(sym("x")),
                                                      p.text("0.relation") + ", " + p.text("1.relation")))
        .conclude();
}

Finding exceedance_full(const Print& p)
{
    return Argument("normal form")
        .add("Q is a share of the wavelength: dimensions", units(p))
        .add("the length of the segment (2.13) over lambda",
             identity(p("rhs"), prints().at("2.13")("1.rhs") * 2 / sym("lambda"), full_points))
        .add("the library's share has the same derivative in p, up to sign (p* = 1)",
             identity(pow(diff_p(westergaard::exceedance_full<Symbol>(sym("p"), pbar())), 2), pow(diff_p(p("rhs").subs(pstar() == 1)), 2),
                      full_points))
        .add("and the same value at p = pbar",
             identity(westergaard::exceedance_full<Symbol>(pbar(), pbar()), p("rhs").subs(sym("p") == pbar()), full_points))
        .conclude();
}

/// -dQ/dp of the share that (2.14) should print.
Finding density_full(const Print& p)
{
    Ring ring;
    ring.root("R", pow(pstar(), 2) - pow(sym("p") - pbar(), 2));
    const ex Q = acos((sym("p") - pbar()) / pstar()) / Pi;
    return Argument("normal form, the square root adjoined")
        .add("dimensions", units(p))
        .add("minus the derivative of Q = arccos((p - pbar)/p*)/pi, the corrected (2.14)",
             identity(p("1.rhs"), -Q.diff(GiNaC::ex_to<GiNaC::symbol>(sym("p"))), full_points, ring))
        .add("the range is that of (2.13)",
             identity(p.sides("1.condition").back() - p.sides("1.condition").front(), 2 * pstar(), full_points))
        .conclude("with (2.14) as printed, -dQ/dp would be lambda times this: the error of (2.14) is not inherited");
}

Finding exceedance_partial(const Print& p)
{
    Ring ring;
    const ex P = sym("p") / pstar(), S = load();
    ring.root("R", pow(pstar() - pbar(), 2) + pow(sym("p"), 2));
    const ex s = pow(sin(Pi * p("rhs") / 2), 2); // sin^2(pi x/lambda) where the pressure is p
    const ex C = sym("R");
    return Argument("normal form, the square root adjoined")
        .add("dimensions", units(p))
        .add("with s = sin^2(pi Q/2) the square of the pressure (2.4), 4 p*^2 (1 - s)(S - s), is p^2",
             identity(4 * pow(pstar(), 2) * (1 - s) * (S - s), pow(sym("p"), 2), partial_points, ring))
        .add("of the two roots it is the one with s <= S: S - s = (R - (p* - pbar))/(2 p*), and R >= p* - pbar",
             identity(S - s, (C - (pstar() - pbar())) / (2 * pstar()), partial_points, ring))
        .add("the range ends at the peak pressure (2.10)",
             identity(p.sides("condition").back(), 2 * sqrt(pstar() * pbar()), partial_points))
        .add("the library's form has the same tangent of pi Q/2: s/(1 - s)",
             identity(s / (1 - s), (4 * S - P * P) / (2 * (1 - S) + 2 * C / pstar() + P * P), partial_points, ring))
        .conclude("Q = 2x/lambda: the pressure (2.4) decreases from the peak outwards");
}

Finding density_partial(const Print& p)
{
    Ring ring;
    // Without this root GiNaC's order of terms, by address, decides whether all reduces.
    ring.root("R", pow(sym("p"), 2) + pow(pstar() - pbar(), 2));
    const ex Q = prints().at("2.17")("rhs");
    const ex S = load();
    return Argument("normal form, the square roots adjoined")
        .add("dimensions", units(p))
        .add("its square is that of the derivative of (2.17)",
             identity(pow(p("1.rhs"), 2), pow(Q.diff(GiNaC::ex_to<GiNaC::symbol>(sym("p"))), 2), partial_points, ring))
        .add("the sign: Q decreases as p grows, and the print, which has no zero inside the range, is positive: p* = 1, pbar from 1/100 to "
             "99/100, p from 1/100 to 99/100 of the peak",
             positive_on(p("1.rhs").subs(pstar() == 1).subs(GiNaC::lst{pbar() == pow(sym("t"), 2), sym("p") == 2 * sym("y") * sym("t")}),
                         {{"t", Rational(1, 10), Rational(99, 100)}, {"y", Rational(1, 100), Rational(99, 100)}}))
        .add("the library's cancellation-free form is the same",
             identity(pow(p("1.rhs"), 2), pow(westergaard::density_partial<Symbol>(sym("p") / pstar(), S) / pstar(), 2), partial_points,
                      ring))
        .conclude();
}

/// 0 beyond the peak pressure: (2.18), (2.20).
Finding nothing_above_peak(const Print& p)
{
    Ring ring;
    const auto [s, c] = ring.angle("w", Pi * sym("x") / sym("lambda"));
    const ex u = sym("u"), peak = 2 * sqrt(pstar() * pbar());
    return Argument("normal form; positive coefficients")
        .add("dimensions", units(p))
        .add("the square of the peak less that of (2.4) is 4 p*^2 s^2 (1 + S - s^2), s = sin(pi x/lambda), S = pbar/p*",
             identity(pow(peak, 2) - pow(pressure_partial(), 2), 4 * pow(pstar(), 2) * s * s * (1 + load() - s * s), partial_points, ring))
        .add("which is not negative as s^2 = 1/(1 + u) <= 1: no point has a pressure above the peak",
             identity((1 + load() - s * s).subs(s == 1 / sqrt(1 + u)), load() + u / (1 + u), Points{"u=1 pbar=1 pstar=2"}))
        .add("the condition says: above the peak", condition_says(p, "condition", sym("p"), ">", peak, partial_points))
        .add("a share of no points is 0, and so is its derivative", identity(p("rhs"), 0, Points{"p=1"}))
        .conclude();
}

Finding outside_full(const Print& p)
{
    const std::string& c = p.text("condition");
    const std::size_t cut = c.find(" or ");
    Print low = p, high = p;
    low.fields["0.condition"] = c.substr(0, cut);
    high.fields["0.condition"] = cut == std::string::npos ? c : c.substr(cut + 4);
    Ring ring;
    const auto [s, cosine] = ring.angle("w", Pi * sym("x") / sym("lambda"));
    return Argument("normal form")
        .add("dimensions", units(p))
        .add("the pressure (2.2) less pbar - p* is 2 p* cos^2(pi x/lambda): Q = 1 below",
             identity(pressure_full() - (pbar() - pstar()), 2 * pstar() * cosine * cosine, full_points, ring))
        .add("pbar + p* less the pressure is 2 p* sin^2(pi x/lambda): Q = 0 above",
             identity(pbar() + pstar() - pressure_full(), 2 * pstar() * s * s, full_points, ring))
        .add("the lower condition", condition_says(low, "condition", sym("p"), "<", pbar() - pstar(), full_points))
        .add("the upper condition", condition_says(high, "condition", sym("p"), ">", pbar() + pstar(), full_points))
        .add("minus the derivative of a constant share is 0", identity(p("rhs"), 0, Points{"p=1"}))
        .conclude();
}

} // namespace

std::vector<Claim> section_2()
{
    const std::string elastic = "plane strain, linear elastic half-plane, rigid profile, no friction; g, lambda, E > 0, -1 < nu < 1/2";
    const std::string full = "full contact, pbar > p*", partial = "partial contact, 0 < pbar < p*";
    return {
        {"2.1", "The profile is a cosine of amplitude g and wavelength lambda.", "", wave, {}, {}, {}},
        {"2.2",
         "In full contact the pressure is the mean plus p* times the profile's cosine.",
         elastic + "; pbar >= p*",
         full_contact_pressure,
         {{"twice the amplitude", {{"rhs", "+pstar*cos", "+2*pstar*cos"}}},
          {"sine for cosine", {{"rhs", "cos", "sin"}}},
          {"minus", {{"rhs", "+", "-"}}}},
         {},
         {"2.3"}},
        {"2.3",
         "The amplitude of the pressure under a sinusoidal profile.",
         elastic,
         full_contact_amplitude,
         {{"without pi", {{"rhs", "Pi*", ""}}},
          {"peak-to-valley for amplitude", {{"rhs", "*g/", "*g/2/"}}},
          {"E for E/(1 - nu^2)", {{"rhs", "(1-nu^2)*", ""}}},
          {"nu for nu^2", {{"rhs", "nu^2", "nu"}}}},
         {},
         {}},
        {"2.4",
         "The contact pressure of Westergaard's solution.",
         elastic + "; " + partial,
         westergaard_pressure,
         {{"without the factor 2", {{"rhs", "2*pbar", "pbar"}}},
          {"without the square root", {{"rhs", "^(1/2)", ""}}},
          {"sine unsquared in the denominator", {{"rhs", "/sin(Pi*a/lambda)^2", "/sin(Pi*a/lambda)"}}},
          {"2 pi for pi", {{"rhs", "cos(Pi*x", "cos(2*Pi*x"}}}},
         {},
         {"2.3"}},
        {"2.5",
         "The half-length of the contact segment.",
         elastic + "; " + partial,
         contact_half_width,
         {{"the square root of the arcsine", {{"rhs", "asin((pbar/pstar)^(1/2))", "asin(pbar/pstar)^(1/2)"}}},
          {"lambda/(2 pi)", {{"rhs", "lambda/Pi", "lambda/(2*Pi)"}}},
          {"without the square root", {{"rhs", "^(1/2)", ""}}}},
         {},
         {"2.3", "2.4"}},
        {"2.6",
         "The Hertzian pressure, as the limit of (2.4).",
         partial + ", pbar/p* -> 0",
         hertz_pressure,
         {{"without the factor 2", {{"rhs", "2*pbar", "pbar"}}}, {"x/a unsquared", {{"rhs", "x^2/a^2", "x/a"}}}},
         {},
         {"2.4", "2.7"}},
        {"2.7",
         "The Hertzian half-width, as the limit of (2.5).",
         partial + ", pbar/p* -> 0",
         hertz_half_width,
         {{"2 lambda/pi", {{"rhs", "lambda/Pi", "2*lambda/Pi"}}},
          {"without the square root", {{"rhs", "sqrt(pbar/pstar)", "(pbar/pstar)"}}}},
         {},
         {"2.5"}},
        {"2.8", "The Hertzian formulas are acceptable for pbar/p* < 0.2.", "", hertz_range, {}, {}, {"2.5", "2.7", "2.10"}},
        {"2.9",
         "The greatest pressure in full contact.",
         full,
         peak_pressure_full,
         {{"minus", {{"rhs", "+", "-"}}}, {"2 p*", {{"rhs", "+pstar", "+2*pstar"}}}},
         {},
         {"2.2"}},
        {"2.10",
         "The greatest pressure in partial contact.",
         partial,
         peak_pressure_partial,
         {{"without the factor 2", {{"rhs", "2*", ""}}}, {"without the square root", {{"rhs", "2*sqrt(pbar*pstar)", "2*pbar"}}}},
         {},
         {"2.4", "2.5"}},
        {"2.11",
         "In full contact every point has a pressure above pbar - p*.",
         full,
         exceedance_bounds,
         {{"0 for 1", {{"rhs", "1", "0"}}}, {"the other bound", {{"condition", "pbar-pstar", "pbar+pstar"}}}},
         {},
         {"2.2"}},
        {"2.12",
         "In full contact no point has a pressure above pbar + p*.",
         full,
         exceedance_bounds,
         {{"1 for 0", {{"rhs", "0", "1"}}}, {"a lower bound", {{"condition", "pbar+pstar", "pbar"}}}},
         {},
         {"2.2"}},
        {"2.13",
         "The segment on which the pressure exceeds p in full contact.",
         full + ", pbar - p* < p < pbar + p*",
         exceedance_segment,
         {{"lambda/pi for lambda/(2 pi)", {{"1.rhs", "lambda/(2*Pi)", "lambda/Pi"}, {"0.lhs", "lambda/(2*Pi)", "lambda/Pi"}}},
          {"arcsine", {{"1.rhs", "acos", "asin"}, {"0.lhs", "acos", "asin"}}}},
         {},
         {"2.2"}},
        {"2.14",
         "The share of the wavelength on which the pressure exceeds p, in full contact.",
         full + ", pbar - p* < p < pbar + p*",
         exceedance_full,
         {{"1/(2 pi)", {{"rhs", "lambda/Pi", "1/(2*Pi)"}}}, {"arcsine", {{"rhs", "lambda/Pi*acos", "1/Pi*asin"}}}},
         Correction{"misprint",
                    "the factor lambda before arccos: a share has no dimension",
                    "Q = (1/pi) arccos((p - pbar)/p*)",
                    {{"rhs", "lambda/Pi", "1/Pi"}},
                    "(2.15) and all that follows use the right form; a code that trusts the print is wrong by the factor lambda unless it "
                    "takes lambda = 1"},
         {"2.13"}},
        {"2.15",
         "The density of the pressure in full contact.",
         full + ", pbar - p* < p < pbar + p*",
         density_full,
         {{"twice", {{"1.rhs", "1/(Pi*", "2/(Pi*"}}}, {"plus under the root", {{"1.rhs", "-(p-pbar)^2", "+(p-pbar)^2"}}}},
         {},
         {"2.14"}},
        {"2.16",
         "The density is zero outside the range of pressures, in full contact.",
         full,
         outside_full,
         {{"another range", {{"condition", "pbar+pstar", "pbar+2*pstar"}}}, {"one for zero", {{"rhs", "0", "1"}}}},
         {},
         {"2.2", "2.9"}},
        {"2.17",
         "The share of the wavelength on which the pressure exceeds p, in partial contact.",
         partial + ", 0 < p < 2 sqrt(p* pbar)",
         exceedance_partial,
         {{"plus the inner root", {{"rhs", ")-sqrt", ")+sqrt"}}},
          {"1/pi for 2/pi", {{"rhs", "2/Pi", "1/Pi"}}},
          {"without the 1/2", {{"rhs", "1/2*", ""}}},
          {"p/p* unsquared", {{"rhs", "(p/pstar)^2", "(p/pstar)"}}}},
         {},
         {"2.4", "2.5"}},
        {"2.18",
         "No point has a pressure above the peak, in partial contact.",
         partial,
         nothing_above_peak,
         {{"without the factor 2", {{"condition", "2*", ""}}}, {"one for zero", {{"rhs", "0", "1"}}}},
         {},
         {"2.10"}},
        {"2.19",
         "The density of the pressure in partial contact.",
         partial + ", 0 < p < 2 sqrt(p* pbar)",
         density_partial,
         {{"pbar for 2 pbar", {{"1.rhs", "2*pbar", "pbar"}}},
          {"plus p^2 at the end", {{"1.rhs", ")-p^2))", ")+p^2))"}}},
          {"the square left out, as in (6.2)", {{"1.rhs", "sqrt((pstar-pbar)^2+p^2))-p^2", "sqrt((pstar-pbar)+p^2))-p^2"}}}},
         {},
         {"2.17"}},
        {"2.20",
         "The density is zero above the peak, in partial contact.",
         partial,
         nothing_above_peak,
         {{"without the factor 2", {{"condition", "2*", ""}}}, {"one for zero", {{"rhs", "0", "1"}}}},
         {},
         {"2.10"}},
    };
}

} // namespace touchstone::proofs
