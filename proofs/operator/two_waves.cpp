// SPDX-License-Identifier: GPL-3.0-or-later
/// The density after two waves (transfer/two_waves.hpp): how it grows on a disc, and what it counts for next to its singular points.
/// d(y) is the density of P after the second wave, (2.15), (2.19), as a function of its ratio y; k(x, y) the kernel of the first.
#include "proofs/operator/own.hpp"
#include "proofs/symbolic/symbolic.hpp"

#include "touchstone/wave/lemmas.hpp"

namespace touchstone::proofs {
namespace {

Ball root(const Ball& x) { return ScalarTraits<Ball>::sqrt_positive_part(x); }

Finding on_disc(const Constants& k)
{
    const Ball s = k.ball(0);
    const Ball change = s * (2 + s), kept = sqrt(1 - change),
               grown = 1 + (1 - kept); // |R/R_c - 1| <= 1 - (1 - q)^(1/2) on the disc |t| <= q
    const Ball distances = 1 / ((1 - 2 * s) * (1 - s)), dy = 1 + 2 * s;
    const Ball second = sqrt(grown / kept) / kept;              // P/(2 pi R) ((1 + y + R)/(1 - y + R))^(1/2)
    const Ball first = (1 + s) * sqrt(grown / ((1 - s) * kept)) / kept; // (G y/R) ((1 + x + R)/((1 - x + R)(hi + y)))^(1/2)
    return Argument("balls")
        .note("|(1 + t)^(1/2) - 1| <= 1 - (1 - |t|)^(1/2): the Taylor coefficients of 1 - (1 - q)^(1/2), with ratios (2j - 1)/(2j + 2), "
              "are positive")
        .add("share (2 + share) < 1", less_than(change, Ball(1), "share (2 + share)"))
        .add("two distances that keep 1 - 2 share and 1 - share, dy, and the factors of the two waves",
             less_than(distances * dy * second * first, k.ball(1), "the density grows by"))
        .conclude("D_1 on a disc about x_c, by its value there");
}

/// P/(2 pi R) ((1 + y + R)/(1 - y + R))^(1/2): d (y - P^2/4)^(1/2), y < 1.
Ball partial_rest(const Ball& P, const Ball& y)
{
    const Ball R = sqrt((1 - y) * (1 - y) + P * P);
    return P / (2 * pi<Ball>() * R) * sqrt((1 + y + R) / (1 - y + R));
}
/// The same over P, for P down to 0.
Ball partial_rest_over_P(const Ball& P, const Ball& y)
{
    const Ball R = ScalarTraits<Ball>::sqrt_positive_part((1 - y) * (1 - y) + P * P);
    return sqrt((1 + y + R) / (1 - y + R)) / (2 * pi<Ball>() * R);
}

Finding near_lower(const Constants& k)
{
    return Argument("subdivision in balls")
        .add("P < 1/2, P^2/4 <= y <= 3 P^2/8: d (y - P^2/4)^(1/2) < constant P",
             positive_over([&](const std::vector<Ball>& v) { return k.ball(0) - partial_rest_over_P(v[0], v[0] * v[0] * v[1] / 4); },
                           {{"P", 0, Rational(1, 2)}, {"4y/P^2", 1, Rational(3, 2)}}))
        .conclude("next to the edge of contact of the second wave");
}

Finding up_to_half(const Constants& k)
{
    return Argument("subdivision in balls")
        .add("P < 1/2, y <= 1/2: d (y - P^2/4)^(1/2) < constant P",
             positive_over([&](const std::vector<Ball>& v) { return k.ball(0) - partial_rest_over_P(v[0], v[1]); },
                           {{"P", 0, Rational(1, 2)}, {"y", 0, Rational(1, 2)}}))
        .conclude("away from it");
}

Finding next_to_seam(const Constants& k)
{
    return Argument("subdivision in balls; integration over levels")
        .add("P < 1/2, 1/2 <= y <= 1: d < first constant P R^(-3/2); 1 - y + R >= R",
             positive_over(
                 [&](const std::vector<Ball>& v) {
                     const Ball R = ScalarTraits<Ball>::sqrt_positive_part((1 - v[1]) * (1 - v[1]) + v[0] * v[0]);
                     return k.ball(0) - sqrt((1 + v[1] + R) / (v[1] - v[0] * v[0] / 4)) / (2 * pi<Ball>());
                 },
                 {{"P", 0, Rational(1, 2)}, {"y", Rational(1, 2), 1}}))
        .note("d > t needs 1 - y <= R < (b P/t)^(2/3), t <= b P^(-1/2), b the first constant: int (G/2)^(1/2) (b P/t)^(1/3) dt = (3/2) b "
              "(G/2)^(1/2) (wave::share_of)")
        .add("(3/2) first constant < second", less_than(3 * k.ball(0) / 2, k.ball(1), "3 b/2"))
        .conclude("the density next to y = 1 counts for second (G/2)^(1/2) on average, however small P is");
}

Finding full_small(const Constants& k)
{
    return Argument("balls")
        .add("P < 1/2, y >= 1: y - P + 1 >= 3/2, and 1/(pi (3/2)^(1/2)) < constant",
             less_than(1 / (pi<Ball>() * sqrt(Ball(3) / 2)), k.ball(0), "1/(pi 1.5^(1/2))"))
        .conclude("next to the upper end");
}

Finding partial_large(const Constants& k)
{
    const Ball constant = k.ball(0) / sqrt(Ball(5));
    return Argument("subdivision in balls")
        .note("R >= P, and (1 + y + R)/(1 - y + R) <= (2 + R)/R")
        .add("1/2 <= P <= 2, y < 1: d (y - P^2/4)^(1/2) <= (1/2 pi)(1 + 2/P)^(1/2) < constant ((1 + 2/P)/5)^(1/2)",
             less_than(1 / (2 * pi<Ball>()), constant, "1/(2 pi)"))
        .add("and in balls",
             positive_over([&](const std::vector<Ball>& v) { return constant * sqrt(1 + 2 / v[0]) - partial_rest(v[0], v[1]); },
                           {{"P", Rational(1, 2), 2}, {"y", 0, Rational(15, 16)}}))
        .conclude("next to the edge of contact of the second wave, P of order 1");
}

Finding full_ends(const Constants& k)
{
    return Argument("balls")
        .add("u + v = 2: 1/(u v)^(1/2) <= u^(-1/2) + v^(-1/2), for u^(1/2) + v^(1/2) >= 2^(1/2) >= 1",
             positive_over([](const std::vector<Ball>& v) { return root(v[0]) + root(2 - v[0]) - 1; }, {{"u", 0, 2}}))
        .add("1/pi < constant", less_than(1 / pi<Ball>(), k.ball(0), "1/pi"))
        .conclude("the arcsine density by its two ends");
}

Finding full_middle(const Constants& k)
{
    return Argument("balls")
        .add("1/2 <= P <= 5/4, y >= 1: y - P + 1 >= 3/4, and 1/(pi (3/4)^(1/2)) < constant",
             less_than(1 / (pi<Ball>() * sqrt(Ball(3) / 4)), k.ball(0), "1/(pi 0.75^(1/2))"))
        .conclude("the lower end lies below 1: bounded");
}

Finding first_wave(const Constants& k)
{
    // t = G y/2: k (hi - y)^(1/2) pi (G)^(1/2) y is at most ((2t)/R) ..., largest at x = 1, t = 1
    return Argument("subdivision in balls")
        .add("x < 1: k |hi - y|^(1/2) pi G^(1/2) y < constant", positive_over([&](const std::vector<Ball>& v) {
                 const Ball root_x = v[0], x = root_x * root_x, t = v[1] * root_x, R = sqrt((1 - x) * (1 - x) + 4 * t * t);
                 // with y = 2t/G, hi = 2 root_x/G: G^(1/2) y (2t/R) ((1+x+R)/((1-x+R)(hi + y)))^(1/2) = 2^(1/2) t ... ; 2t/R <= 1
                 const Ball cap(1), q = at_most(2 * t / R, cap);
                 return k.ball(0) - q * sqrt(2 * t * ((1 + x + R) / (1 - x + R)) * (t / (root_x + t)));
             }, {{"x^(1/2)", Rational(1, 100), Rational(999, 1000)}, {"y/hi", Rational(1, 100), 1}}, 60'000))
        .note("x >= 1: the farther end is at least 1/G away, so k <= (G^(1/2)/pi)|y - e|^(-1/2)")
        .conclude("the first wave next to its end");
}

Finding logarithm(const Constants& k)
{
    return Argument("balls")
        .note("int_0^near dt/(t (t + delta))^(1/2) = 2 log(a^(1/2) + (1 + a)^(1/2)), a = near/delta, on either side, and pi between the "
              "two points")
        .add("(a^(1/2) + (1 + a)^(1/2))^2 <= constant (1 + a): with t = a/(1 + a), (t^(1/2) + 1)^2 < constant",
             positive_over([&](const std::vector<Ball>& v) { return k.ball(0) - (root(v[0]) + 1) * (root(v[0]) + 1); },
                           {{"t", 0, Rational(9999, 10'000)}}))
        .conclude("two inverse square roots a distance delta apart");
}

Finding levels_of_logarithm(const Constants& k)
{
    const ex B = sym("B"), t = sym("t"), F = -2 * B * exp(-t / (2 * B));
    return Argument("symbolic identity")
        .note("{B log(w/delta) > t} has length at most 2 G w e^(-t/B); s(l) <= s(w)(l/w)^(1/2) for l <= w: B log 2G up to where that is w")
        .add("int_0^inf e^(-t/2B) dt = 2 B: its antiderivative",
             identity(F.diff(GiNaC::ex_to<GiNaC::symbol>(t)), exp(-t / (2 * B)), Points{"B=1/2 t=1/3"}))
        .add("at 0 it is -2 B", identity(F.subs(t == 0), -k.exact(0) * B, Points{"B=1/2 t=1/3"}))
        .conclude("a logarithm counts as B (log 2G + 2)");
}

} // namespace

std::vector<OwnClaim> two_waves_claims()
{
    const char* const file = "transfer/two_waves.cpp";
    constexpr wave::DiscTwoWaves disc;
    return {
        {"wave::disc_two_waves",
         "distances that change by less than {0} of themselves: |D_1| <= {1} D_1(x_c)",
         file,
         {{"share", disc.share}, {"most", disc.most}},
         on_disc,
         {{0, 0.302}, {1, 74}}},
        {"two_waves.near_lower",
         "P < 1/2: d <= {0} P |y - P^2/4|^(-1/2) up to 3 P^2/8",
         file,
         {{"constant", 0.2}},
         near_lower,
         {{0, 0.159}}},
        {"two_waves.up_to_half", "P < 1/2: d <= {0} P |y - P^2/4|^(-1/2) up to 1/2", file, {{"constant", 0.52}}, up_to_half, {{0, 0.44}}},
        {"two_waves.next_to_seam",
         "P < 1/2, 1/2 <= y <= 1: d <= {0} P R^(-3/2), which counts for {1} (G/2)^(1/2)",
         file,
         {{"factor", 0.434}, {"on average", 0.66}},
         next_to_seam,
         {{0, 0.33}, {1, 0.65}}},
        {"two_waves.full_small", "P < 1/2, y >= 1: d <= {0} |P + 1 - y|^(-1/2)", file, {{"constant", 0.26}}, full_small, {{0, 0.259}}},
        {"two_waves.partial_large",
         "1/2 <= P <= 2: d <= {0} ((1 + 2/P)/5)^(1/2) |y - P^2/4|^(-1/2)",
         file,
         {{"constant", 0.36}},
         partial_large,
         {{0, 0.355}}},
        {"two_waves.full_ends",
         "y >= 1: d <= {0} (|y - P + 1|^(-1/2) + |P + 1 - y|^(-1/2))",
         file,
         {{"constant", 0.32}},
         full_ends,
         {{0, 0.318}}},
        {"two_waves.full_middle",
         "1/2 <= P <= 5/4, y >= 1: the lower end gives {0} at most",
         file,
         {{"constant", 0.38}},
         full_middle,
         {{0, 0.36}}},
        {"two_waves.first_wave",
         "x < 1: k <= {0} (pi G^(1/2) y)^(-1) |hi - y|^(-1/2)",
         file,
         {{"constant", 1.4142135623730951}},
         first_wave,
         {{0, 1.38}}},
        {"two_waves.logarithm",
         "two inverse roots delta apart: 2 log({0} (1 + near/delta)) + pi",
         file,
         {{"constant", 4}},
         logarithm,
         {{0, 3.9}}},
        {"two_waves.levels_of_logarithm", "int_0^inf e^(-t/2B) dt = {0} B", file, {{"constant", 2}}, levels_of_logarithm, {{0, 1.9}}},
    };
}

} // namespace touchstone::proofs
