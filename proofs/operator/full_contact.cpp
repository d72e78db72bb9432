// SPDX-License-Identifier: GPL-3.0-or-later
/// Full contact, after the fact: the discs on which T V~ - V is analytic, bounds of B_0 in the complex plane, and what rounding moves
/// (transfer/proven_levels.md, heavy_load.hpp).
#include "proofs/operator/own.hpp"
#include "proofs/symbolic/symbolic.hpp"

#include "touchstone/scalar/symbol.hpp"
#include "touchstone/wave/lemmas.hpp"

namespace touchstone::proofs {
namespace {

using GiNaC::pow, GiNaC::sqrt;

const Points points{"x=1/2 c=1/3 h=1/9 d=1/7 P=1/4 G=5/4", "x=4/5 c=-1/5 h=2/7 d=-1/8 P=2/3 G=3"};
ComplexBall polar(const Ball& modulus, const Ball& turn) { return {modulus * cos_pi(turn), modulus * sin_pi(turn)}; }

Finding disc_full(const Constants& k)
{
    const Ball reach = k.ball(0), middle = k.ball(1), grown = k.ball(2);
    return Argument("balls")
        .note("c = G y - x moves by |x - x_c| <= reach g at constant y, and g <= |1 -+ c| on the middle part")
        .add("both |1 -+ c| keep 1 - reach of themselves: their root grows the kernel by less than middle",
             less_than(1 / (1 - reach), middle, "1/(1 - reach)"))
        .add("|1 -+ c| grows to less than grown g at the end", less_than(1 + reach, grown, "1 + reach"))
        .add("an end's integral: (grown g)^(1/2) int_0^1 dt/t^(1/2) = 2 (grown g)^(1/2), and 1 + c >= 2 - grown g > 0 for g <= 0.9",
             less_than(grown * Ball(9) / 10, Ball(2), "0.9 grown"))
        .conclude("T V~ is analytic on the disc and bounded there");
}

Finding disc_partial(const Constants& k)
{
    const Ball reach = k.ball(0), kept = k.ball(1), moves = k.ball(2), cosine = k.ball(3), one_plus = k.ball(4), middle = k.ball(5);
    const ex x = sym("x"), c = sym("c"), dx = sym("h"), dc = sym("d");
    // x_c = 0 and 1 - x_c = 1 by scaling: R^2/R_c^2 = 1 + s (2 t + t^2), t = -(x - x_c)/(1 - x_c), s = (1 - x_c)^2/R_c^2
    const auto ratio = [](const Ball& s, const ComplexBall& t) { return 1 + ComplexBall(s) * (2 * t + t * t); };
    const std::vector<Range> domain{{"s", 0, 1}, {"|t|/reach", Rational(1, 64), 1}, {"arg t/pi", 0, 1}};
    return Argument("subdivision in complex balls")
        .add("Re R^2 > 0: R is analytic",
             positive_over([&](const std::vector<Ball>& v) { return ratio(v[0], polar(reach * v[1], v[2])).real(); }, domain))
        .add("|R| > radius_kept R_c",
             positive_over([&](const std::vector<Ball>& v) { return abs(ratio(v[0], polar(reach * v[1], v[2]))) - kept * kept; }, domain))
        .add("|R - R_c| = s^(1/2) |2 t + t^2|/|1 + R/R_c| (1 - x_c) < radius_moves r, r = |t| (1 - x_c)",
             positive_over(
                 [&](const std::vector<Ball>& v) {
                     const ComplexBall t = polar(reach * v[1], v[2]);
                     return moves - ScalarTraits<Ball>::sqrt_positive_part(v[0]) * abs(2 + t) / abs(1 + sqrt(ratio(v[0], t)));
                 },
                 domain))
        .add("c = R - x: radius_moves + 1 <= cosine_moves",
             exactly(Rational(k.number(2)) + 1 <= Rational(k.number(3)) * (1 + Rational(1, 1'000'000'000'000)),
                     std::to_string(k.number(2)) + " + 1 against " + std::to_string(k.number(3))))
        .add("1 + c >= 2 (1 - x_c) keeps 1 - cosine_moves reach/2 of itself",
             less_than(one_plus, 1 - cosine * reach / 2, "one_plus_c_kept"))
        .add("1/(radius_kept (one_plus_c_kept/5)^(1/2)) < middle",
             less_than(1 / (kept * sqrt(one_plus / 5)), middle, "the kernel grows by"))
        .add("(1+c)(2x-1+c) moves by (1+c)(2 dx + dc) + dc (2x - 1 + c + 2 dx + dc)",
             identity(wave::pressure_partial_squared<ex>(x + dx, c + dc) - wave::pressure_partial_squared<ex>(x, c),
                      (1 + c) * (2 * dx + dc) + dc * (2 * x - 1 + c + 2 * dx + dc), points))
        .conclude("T V~ is analytic on the disc and bounded there");
}

Finding arccos_near_1(const Constants& k)
{
    return Argument("maximum principle; subdivision in complex balls")
        .note("w = 1 - 2 s^2: arccos w = 2 arcsin s and |1 - w| = 2|s|^2; arcsin(s)/s is analytic for |s| < 1, so largest on the edge of "
              "|s| <= 2^(-1/2), |1 - w| <= 1")
        .add("2|arcsin s| < constant for |s| = 2^(-1/2)",
             positive_over([&](const std::vector<Ball>& v) { return k.ball(0) - 2 * abs(asin(polar(1 / sqrt(Ball(2)), v[0]))); },
                           {{"arg s/pi", 0, Rational(1, 2)}}))
        .conclude("|arccos w| <= constant |1 - w|^(1/2) where |1 - w| <= 1");
}

Finding arccos_far(const Constants& k)
{
    const ex a = sym("G"); // any number above 1
    Worst at_points;
    for (long i = -4; i < 32; ++i)
        for (long j = 0; j < 16; ++j) {
            const Ball size = pow(Ball(2), Ball(i) / 4);
            const ComplexBall w = polar(size, Ball(Rational(4 * j + 1, 64)));
            const Ball l = log(k.ball(0) * (size + 1)), value = abs(acos(w));
            at_points.below(value * value, pi<Ball>() * pi<Ball>() + l * l,
                            "|w| = 2^" + std::to_string(i) + "/4, arg w = (4 " + std::to_string(j) + " + 1) pi/64");
        }
    return Argument("symbols; points in complex balls")
        .note("|Im arccos w| = log(a + (a^2 - 1)^(1/2)), 2a = |w + 1| + |w - 1| <= 2|w| + 2; 0 <= Re arccos w <= pi")
        .add("(a + (a^2-1)^(1/2)) < 2a: (2a - a)^2 - (a^2 - 1) = 1", identity(pow(2 * a - a, 2) - (pow(a, 2) - 1), 1, points))
        .add("2a <= constant (|w| + 1)", exactly(k.number(0) >= 2, "2 against " + std::to_string(k.number(0))))
        .add("|arccos w|^2 < pi^2 + log^2(constant |w| + constant) at points", at_points.result())
        .conclude("the share above a pressure, wherever it is analytic");
}

Finding edge_of_contact(const Constants& k)
{
    const ex x = sym("x"), P2 = pow(sym("P"), 2);
    Ring ring;
    const ex R = ring.root("R", pow(1 - x, 2) + P2);
    return Argument("symbolic identities")
        .add("(1 - w)(1 + x + R) = 4x - P^2, w = R - x", identity((1 - (R - x)) * (1 + x + R), k.exact(0) * 4 * x - P2, points, ring))
        .add("w is real for real x only: x = (1 + P^2 - w^2)/(2 (1 + w))",
             identity(wave::needed_partial<ex>(sym("P"), R - x), x, points, ring))
        .note("|1 + x + R| >= 1: Re x > 0, Re R > 0")
        .conclude("no branch of arccos is crossed, and the edge of contact is a square root");
}

Finding blur(const Constants& k)
{
    // (x + c)^2 moves by 2 (x + c) dx, (1 + c)(2x - 1 + c) by 2 (1 + c) dx, dx = 4 u x; second order below 1e-9 of that: twice the first is
    // far more than both
    const Ball enough = k.ball(0);
    return Argument("subdivision in balls")
        .add("x >= 1: 8 (x + c) x < constant x (1 + x)",
             positive_over([&](const std::vector<Ball>& v) { return enough - 2 * 8 * (1 + v[0] * v[1]) / (1 + v[0]); },
                           {{"1/x", 0, 1}, {"c", -1, 1}}))
        .add("x < 1: 8 (1 + c) x < constant x (1 + x)",
             positive_over([&](const std::vector<Ball>& v) { return enough - 2 * 8 * (1 + v[1]) / (1 + v[0]); },
                           {{"x", 0, 1}, {"c", -1, 1}}))
        .conclude("what a load known to 4 u moves G^2 y^2 by, in units of u x (1 + x)");
}

Finding sliver(const Constants& k)
{
    return Argument("balls")
        .note("an edge moved by `moved` in c, at least 2 moved away from the ends: 1 -+ c keep half of themselves, and the share is at "
              "most moved/(pi ((1-c)(1+c)/4)^(1/2))")
        .add("1/(1/4)^(1/2) <= constant", exactly(Rational(k.number(0)) >= 2, "2 against " + std::to_string(k.number(0))))
        .conclude("the share of theta between an edge and where rounding puts it");
}

/// M(X) of lemma 3: the two upright parts of the path.
Finding upright(const Constants& k)
{
    const ex im = sym("h"), G = sym("G"); // |Im x|
    // (1/pi) int_0^(im/G) dt/(t 2/G)^(1/2) = (1/pi) 2 (im/G)^(1/2) (G/2)^(1/2), twice; im <= X/2
    return Argument("symbolic identity")
        .add("2 (1/pi) 2 (im/G)^(1/2) (G/2)^(1/2), squared, is (16/pi^2) im/2",
             identity(pow(4 / GiNaC::Pi, 2) * (im / G) * (G / 2), pow(k.exact(0) / GiNaC::Pi, 2) * im / 2, points))
        .note("on the real part the kernel at complex x is at most that at Re x, so B_m(Re x) <= Q(X) G^-m bounds it")
        .conclude("Lemma 3: M(X) = Q(X) + (4/pi)(X/4)^(1/2) G M((X+1)/G)");
}

/// k of (F2) below the first panel.
Finding below_first(const Constants& k)
{
    // with t = G y <= 1, R >= t and 1 - x + R >= R: k <= (G^2 y/(2 pi)) (2 + R)^(1/2)/(R^(3/2) (x/2)^(1/2)), falling with R
    return Argument("subdivision in balls")
        .add("k y^(1/2) (x/G)^(1/2) pi = (t/R)^(3/2) ((1+x+R)/(1-x+R) R)^(1/2)/(2 (1 - t^2/4x)^(1/2)) < constant where t^2 <= 2x, t <= 1",
             positive_over(
                 [&](const std::vector<Ball>& v) {
                     const Ball x = v[0], t = v[1] * sqrt(2 * x), R = sqrt((1 - x) * (1 - x) + t * t);
                     if (certainly(less(Ball(1), t))) return k.ball(0); // beyond what is claimed
                     const Ball cap(1), q = at_most(t / R, cap);
                     const Ball rest = at_most(R / (1 - x + R), cap);
                     return k.ball(0) - q * sqrt(q) * sqrt((1 + x + R) * rest) / (2 * sqrt(1 - v[1] * v[1] / 2));
                 },
                 {{"x", Rational(1, 10'000), Rational(9999, 10'000)}, {"t/(2x)^(1/2)", Rational(1, 1000), 1}}, 60'000))
        .conclude("(F2) below its first panel: the density of small ratios; the code doubles it");
}

} // namespace

std::vector<OwnClaim> full_contact_claims()
{
    constexpr wave::DiscFull full;
    constexpr wave::DiscPartial partial;
    return {
        {"wave::disc_full",
         "x_c > 1, |x - x_c| <= {0} g: the kernel grows by less than {1}, |1 -+ c| at the end to less than {2} g",
         "transfer/defects.cpp",
         {{"reach", full.reach}, {"middle", full.middle}, {"grown", full.grown}},
         disc_full,
         {{0, 0.81}, {1, 4.7}, {2, 1.78}}},
        {"wave::disc_partial",
         "x_c < 1, |x - x_c| <= r <= {0} (1 - x_c): |R| > {1} R_c, |R - R_c| < {2} r, c moves by {3} r, 1 + c keeps {4}, the kernel grows "
         "by less than {5}",
         "transfer/defects.cpp",
         {{"reach", partial.reach},
          {"radius_kept", partial.radius_kept},
          {"radius_moves", partial.radius_moves},
          {"cosine_moves", partial.cosine_moves},
          {"one_plus_c_kept", partial.one_plus_c_kept},
          {"middle", partial.middle}},
         disc_partial,
         {{0, 0.36}, {1, 0.77}, {2, 0.98}, {3, 2.35}, {4, 0.72}, {5, 4.0}}},
        {"levels.arccos_near_1",
         "|arccos w| <= {0} |1 - w|^(1/2) where |1 - w| <= 1",
         "transfer/level_zero.cpp",
         {{"constant", 2}},
         arccos_near_1,
         {{0, 1.57}}},
        {"levels.arccos_far",
         "|arccos w|^2 <= pi^2 + log^2({0}|w| + {0})",
         "transfer/level_zero.cpp",
         {{"constant", 2}},
         arccos_far,
         {{0, 1}}},
        {"levels.edge_of_contact",
         "1 - w = ({0} 4x - P^2)/(1 + x + R), w = R - x",
         "transfer/level_zero.cpp",
         {{"factor", 1}},
         edge_of_contact,
         {{0, 1.01}}},
        {"levels.blur",
         "a load known to 4 u moves G^2 y^2 by less than {0} u x (1 + x)",
         "transfer/defects.cpp",
         {{"constant", 40}},
         blur,
         {{0, 7.9}}},
        {"layer.sliver",
         "an edge moved by `moved` in c counts for {0} moved/(pi ((1-c)(1+c))^(1/2))",
         "transfer/layer.cpp",
         {{"constant", 2}},
         sliver,
         {{0, 1.9}}},
        {"heavy_load.upright",
         "Lemma 3, the path's upright parts: ({0}/pi)(X/4)^(1/2) G M((X+1)/G)",
         "transfer/heavy_load.cpp",
         {{"constant", 4}},
         upright,
         {{0, 3.9}}},
        {"heavy_load.below_first",
         "the kernel of (F2) is at most {0} (G/(x y))^(1/2)/pi where 2x >= (G y)^2, G y <= 1",
         "transfer/heavy_load.cpp",
         {{"constant", 1.2247448713915892}},
         below_first,
         {{0, 0.9}}},
    };
}

} // namespace touchstone::proofs
