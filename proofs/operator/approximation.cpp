// SPDX-License-Identifier: GPL-3.0-or-later
/// What is used of approximation theory: interpolation in Chebyshev points and Gauss's rule, for functions bounded on a Bernstein ellipse
/// E_rho, of focal sum rho + 1/rho. Chebyshev coefficients there are at most 2 M rho^-k (Trefethen, Approximation Theory and Approximation
/// Practice, th. 8.1).
#include "proofs/operator/own.hpp"
#include "proofs/symbolic/symbolic.hpp"

#include "touchstone/scalar/flint_headers.hpp"

namespace touchstone::proofs {
namespace {

using GiNaC::pow;

const Points ellipses{"rho=3/2 d=1/5", "rho=4 d=2"};

Finding interpolation(const Constants& k)
{
    const ex rho = sym("rho"), d = sym("d"); // d stands for rho^-p
    const ex bound = k.exact(0) * d * rho / (rho - 1), next = k.exact(0) * d / (rho - 1);
    return Argument("symbolic identity")
        .note("a coefficient of order k >= p is aliased once onto a lower one: it counts twice, 2 * 2 M rho^-k")
        .add("bound(p) - bound(p + 1) is the p-th term, 4 M rho^-p", identity(bound - next, 4 * d, ellipses))
        .conclude("the bound is the sum of its geometric series");
}

/// |int T_k - rule(T_k)| of the n-point Gauss rule.
Ball gauss_defect(ulong n, ulong k)
{
    const slong bits = WorkingPrecision::bits();
    Ball sum(0), node, weight, T;
    for (ulong i = 0; i < n; ++i) {
        arb_hypgeom_legendre_p_ui_root(node.get(), weight.get(), n, i, bits);
        arb_hypgeom_chebyshev_t(T.get(), Ball(static_cast<long>(k)).get(), node.get(), bits);
        sum += weight * T;
    }
    const long kk = static_cast<long>(k);
    return abs((kk % 2 ? Ball(0) : 2 / Ball(1 - kk * kk)) - sum);
}

/// The Gauss bounds: a term of order k costs 2 M rho^-k (weights' sum 2 + |int T_k|), even k alone or all.
Finding gauss(const Constants& k, long least_k)
{
    const Ball bound = k.ball(0) / 2;
    const Rational integral(2, least_k * least_k - 1);
    Worst even;
    Check odd{Verdict::verified, ""};
    for (ulong n = 2; n <= 24; ++n)
        for (ulong order = 2 * n; order < 2 * n + 6; ++order) {
            const std::string where = "the rule of " + std::to_string(n) + " points at T_" + std::to_string(order);
            const Ball defect = gauss_defect(n, order);
            if (order % 2 == 0) even.below(defect, bound, where);
            else if (!defect.contains_zero()) odd = {Verdict::refuted, where};
        }
    const Rational exact = 2 * (2 + integral);
    Argument argument("exact arithmetic; rules in balls");
    argument
        .add("|int T_k| <= 2/(k^2 - 1), the weights add up to 2: 2 (2 + " + integral.get_str() + ") <= constant",
             exactly(exact <= Rational(k.number(0)) * (1 + Rational(1, 1'000'000'000)),
                     exact.get_str() + " against " + std::to_string(k.number(0))))
        .add("rules of 2 to 24 points are within half of it on T_k, k even", even.result())
        .add("and exact for odd k, where a symmetric rule gives 0, in balls", odd);
    return argument.conclude("Gauss's rule is exact below order 2n; coefficients beyond fall like rho^-k");
}

Finding lebesgue(const Constants& k)
{
    Worst all;
    for (long n = 2; n <= 64; ++n) {
        Ball sum(0);
        for (long i = 1; i <= n; ++i) {
            const Ball angle = Ball(2 * i - 1) / Ball(4 * n);
            sum += cos_pi(angle) / sin_pi(angle);
        }
        all.below(sum / n, k.ball(0) + 2 / pi<Ball>() * log(Ball(n)), "of " + std::to_string(n) + " points it");
    }
    return Argument("balls")
        .note("the Lebesgue constant of n Chebyshev points of the first kind is (1/n) sum cot((2i - 1) pi/(4n))")
        .add("it is below constant + (2/pi) log n for n = 2 to 64, and 1 for n = 1", all.result())
        .conclude("errors at the points, over the interval");
}

Finding lebesgue_below(const Constants& k)
{
    return Argument("balls")
        .add("1 + (2/pi) log 60", less_than(1 + 2 / pi<Ball>() * log(Ball(60)), k.ball(0), "Lebesgue constant of 60 points"))
        .conclude("up to 60 points");
}

/// Chebyshev points that rounding has moved by delta of the half-width: the text is in proven_levels.md, 4.
Finding moved_points(const Constants& k)
{
    const Ball degree(62), lambda = 1 + 2 / pi<Ball>() * log(Ball(63)), delta = k.ball(0), factor = k.ball(1);
    const Rational moved = Rational(1, 2 * 2'000'000) + Rational(1, mpz_class(1) << 100);
    return Argument("Markov's inequality, in balls")
        .note("|p| at Chebyshev's own points exceeds that at the moved ones by at most degree^2 delta sup|p|; sup|p| <= L (max + E)/(1 - L "
              "degree^2 delta)")
        .add("1/(1 - L degree^2 delta) < enlargement, at degree 62",
             less_than(1 / (1 - lambda * degree * degree * delta), factor, "1/(1 - L 62^2 delta)"))
        .add("delta is what one rounding of x, 2^-102, is of the narrowest half interval, 2e6 2^-101, and that of the point itself",
             exactly(moved <= Rational(k.number(0)), moved.get_str()))
        .conclude("values at moved points bound a polynomial as well");
}

Finding ellipse_of_distance(const Constants& k)
{
    const ex d = sym("d");
    Ring ring;
    const ex t = ring.root("t", d * (2 + d)), rho = k.exact(0) + d + t;
    return Argument("symbolic identity")
        .note("a point within d of [-1, 1] has a focal sum of at most 2 (1 + d)")
        .add("rho exceeds 1 by d + (d(2 + d))^(1/2)", identity(rho - 1, d + t, ellipses, ring))
        .add("(rho + 1/rho)/2 = 1 + d for rho = 1 + d + (d(2 + d))^(1/2)", identity((rho + 1 / rho) / 2, 1 + d, ellipses, ring))
        .conclude("the ellipse that holds a neighbourhood of the interval");
}

Finding growth(const Constants& k)
{
    const Rational rho(6);
    return Argument("exact arithmetic")
        .add("the minor half axis (rho - 1/rho)/2 of rho = 6 is at least the constant",
             exactly(Rational((rho - 1 / rho) / 2) >= Rational(k.number(0)), "35/12 against " + std::to_string(k.number(0))))
        .conclude("|T_k(local)| <= 6^k where |local| is at most that: the disc lies in the ellipse");
}

Finding cauchy(const Constants& k)
{
    const ex rho = sym("rho"), a = (rho + 1 / rho) / 2;
    const Points at{"rho=3/2", "rho=101"};
    return Argument("symbolic identities")
        .note("beyond the ends the nearest of [-1, 1] is a focus, and the ellipse is at least a - 1 from it; between them |Im z| >= b (1 - "
              "1/a^2)^(1/2) = (a^2 - 1)/a")
        .add("(a^2 - 1)/a exceeds a - 1 by (a - 1)/a", identity((pow(a, 2) - 1) / a - (a - 1), (a - 1) / a, at))
        .add("a > 1: a - 1 = (rho - 1)^2/(2 rho)", identity(a - 1, pow(rho - 1, 2) / (2 * rho), at))
        .add("and factor (a - 1) is no more than a - 1", exactly(k.number(0) <= 1, "1 against " + std::to_string(k.number(0))))
        .conclude("a derivative on [-1, 1] is at most M/(a - 1), a the major half axis");
}

} // namespace

std::vector<OwnClaim> approximation_claims()
{
    return {
        {"approximation.interpolation",
         "a polynomial through p Chebyshev points is off by at most {0} M rho^-(p-1)/(rho - 1)",
         "row_budget.cpp, from_the_edge/levels.cpp, heavy_load.cpp, layer.cpp",
         {{"constant", 4}},
         interpolation,
         {{0, 3.9}}},
        {"approximation.gauss",
         "n points of Gauss's rule on a half-length l are off by at most l {0} M rho^(-2n)/(1 - 1/rho)",
         "rule.cpp, heavy_load.cpp, from_the_edge/rows.cpp",
         {{"constant", 16.0 / 3}},
         [](const Constants& k) { return gauss(k, 2); },
         {{0, 5.3}}},
        {"approximation.gauss_even",
         "n >= 2 points of Gauss's rule are off by at most l {0} M rho^(-2n)/(1 - rho^-2)",
         "layer.cpp, two_waves.cpp",
         {{"constant", 64.0 / 15}},
         [](const Constants& k) { return gauss(k, 4); },
         {{0, 4.26}}},
        {"approximation.lebesgue",
         "n Chebyshev points have a Lebesgue constant below {0} + (2/pi) log n",
         "transfer/defects.cpp, from_the_edge/whole_support.cpp",
         {{"constant", 1}},
         lebesgue,
         {{0, 0.96}}},
        {"approximation.lebesgue_60", "which is below {0} up to 60 points", "layer.cpp", {{"constant", 4}}, lebesgue_below, {{0, 3.6}}},
        {"approximation.moved_points",
         "points moved by {0} of the half-width enlarge it by {1} at most",
         "transfer/defects.cpp",
         {{"delta", 3e-7}, {"enlargement", 1.01}},
         moved_points,
         {{0, 1e-6}, {0, 2e-7}, {1, 1.004}}},
        {"approximation.ellipse_of_distance",
         "what lies within d of [-1, 1] is in the ellipse of rho = {0} + d + (d(2+d))^(1/2)",
         "transfer/defects.cpp",
         {{"constant", 1}},
         ellipse_of_distance,
         {{0, 1.01}}},
        {"approximation.growth", "|local| <= {0} is inside the ellipse of rho = 6", "layer.cpp", {{"radius", 2.916}}, growth, {{0, 2.917}}},
        {"approximation.cauchy",
         "the ellipse is at least {0} ((rho + 1/rho)/2 - 1) away from [-1, 1]",
         "row_budget.cpp, heavy_load.cpp",
         {{"factor", 1}},
         cauchy,
         {{0, 2.1}}},
    };
}

} // namespace touchstone::proofs
