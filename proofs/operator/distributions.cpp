// SPDX-License-Identifier: GPL-3.0-or-later
/// Distributions in partial contact (recursion/from_the_edge/forward.hpp): the far end of the support, and small pressures. D = 2d - delta;
/// R, M/2 >= 1 - x and P >= 2 for P = 1 + x + R, M = 1 - x + R.
#include "proofs/operator/own.hpp"
#include "proofs/symbolic/symbolic.hpp"

namespace touchstone::proofs {
namespace {

using GiNaC::pow, GiNaC::sqrt;

/// (1 - e^-D)^(-1/2)
Ball root_kernel(const Ball& D) { return 1 / sqrt(1 - exp(-D)); }

Finding above_1(const Constants& k)
{
    return Argument("balls")
        .note("it falls with D")
        .add("(1 - 1/e)^(-1/2) < constant", less_than(root_kernel(Ball(1)), k.ball(0), "at D = 1"))
        .conclude("D >= 1");
}

Finding remainder(const Constants& k)
{
    const Ball far = k.ball(0), near = k.ball(1), all = k.ball(2);
    return Argument("balls")
        .add("D >= 1: the root is below the first constant", less_than(root_kernel(Ball(1)), far, "at D = 1"))
        .add("D < 1: 1 - e^-D >= D (1 - 1/e), concave, so int_0^1 < second constant",
             less_than(2 * root_kernel(Ball(1)), near, "2 (1 - 1/e)^(-1/2)"))
        .note("int_c^inf e^(-3 delta/2) = (2/3) e^(-3c/2), and with w = (delta + 1.2)/5.2 it is at most (2/3) w(c + 1) e^(-3c/2)")
        .add("2/3 first + second < third", less_than(2 * far / 3 + near, all, "sum"))
        .conclude("what is left out of q_n beyond the cut");
}

Finding next_tail(const Constants& k)
{
    const Ball lower = k.ball(0), far = k.ball(1), near = k.ball(2), upper = k.ball(3);
    return Argument("balls")
        .add("delta < 4 <= d: D > 4, (1 - e^-4)^(-1/2) < first", less_than(root_kernel(Ball(4)), lower, "at D = 4"))
        .add("delta >= 4, D >= 1: int e^-delta (1 - 1/e)^(-1/2) < second e^-4", less_than(root_kernel(Ball(1)), far, "at D = 1"))
        .add("delta >= 4, D < 1: e^-delta <= e^-4 and int_0^1 (1 - e^-D)^(-1/2) < third",
             less_than(2 * root_kernel(Ball(1)), near, "2 (1 - 1/e)^(-1/2)"))
        .add("second + third < fourth", less_than(far + near, upper, "sum"))
        .note("e^(-3d) <= e^(-2) e^(-5d/2) for d >= 4; and e^(-3D/2) = e^(-3d) e^(3 delta/2) <= e^(-3d + 6) for delta < 4")
        .conclude("T_{k+1} <= e^-2 k2 (first e^6 + fourth e^-4 T_k): the density of force far from the edge");
}

Finding first_tail(const Constants& k)
{
    const ex u = sym("u");
    const ex s = sqrt(1 - exp(-u));
    const Ball slope = k.ball(0), offset = k.ball(1), most = k.ball(2);
    const Ball ln2 = log(Ball(2)), cross = (root_kernel(Ball(4)) - 1) * ln2 + (root_kernel(Ball(8)) - 1) * 2 * ln2;
    return Argument("symbolic identity, and balls")
        .add("s^2 = 1 - e^-u", identity(((1 - s) * (1 + s)).subs(exp(-u) == sym("q")), sym("q"), Points{"q=1/3"}))
        .add("int ((1 - e^-u)^(-1/2) - 1) du = 2 log(1 + (1 - e^-u)^(1/2)), 2 log 2 in all: its derivative, times the root",
             identity(((2 * log(1 + s)).diff(GiNaC::ex_to<GiNaC::symbol>(u)) * s * (1 + s)).subs(exp(-u) == sym("q")), sym("q"),
                      Points{"q=1/3 u=1"}))
        .add("int_0^2d of both roots <= 2d + 3 log 2 + cross < first (d + second), at d = 4; it falls behind from there on",
             less_than(8 + 3 * ln2 + cross, slope * (4 + offset), "at d = 4"))
        .add("its slope is above 2", less_than(Ball(2), slope, "2"))
        .add("first (d + second) e^(-d/2) < third at d = 4, falling: d + second > 2",
             less_than(slope * (4 + offset) * exp(Ball(-2)), most, "at d = 4"))
        .conclude("T_2, where the induction starts");
}

Finding slope(const Constants& k)
{
    const Rational chain = 1 + Rational(1, 4) + Rational(1, 2);
    const auto g = [](const Ball& x, const Ball& v) { // v = e^-D; dlog(q)/ddelta less 1/2 e^..., see SmallKernel
        const Ball gap = 1 - x, R = sqrt(gap * gap + 4 * x * v), P = 1 + x + R, M = gap + R, R_delta = gap * x / R;
        return 1 / (2 * (1 - v)) - R_delta / R + ((R_delta - x) / P - (R_delta + x) / M) / 2;
    };
    return Argument("exact arithmetic; subdivision in balls")
        .add("1/(2(1 - e^-D)) < first, D >= 1", less_than(1 / (2 * (1 - exp(Ball(-1)))), k.ball(0), "at D = 1"))
        .note("R_delta = (1-x)x/R <= x: R_delta/R <= x/(1-x), |R_delta - x|/2P <= x/4, (R_delta + x)/2M <= x/(2(1-x))")
        .add("1 + 1/4 + 1/2 <= second", exactly(chain <= Rational(k.number(1)), "7/4 against " + std::to_string(k.number(1))))
        .add("and the whole in balls, times 1 - x", positive_over([&](const std::vector<Ball>& v) {
                 return k.ball(0) * (1 - v[0]) + k.ball(1) * v[0] - abs(g(v[0], v[1])) * (1 - v[0]);
             }, {{"x", 0, Rational(63, 64)}, {"e^-D", 0, Rational(367, 1000)}}, 60'000))
        .conclude("|H'| <= 1.26 (1-x)^(-3/2) (first + second x/(1-x)) e^(delta/2)");
}

Finding size_of_h(const Constants& k)
{
    return Argument("subdivision in balls").add("h (1-x)^(3/2) < constant, D >= 1", positive_over([&](const std::vector<Ball>& v) {
        // R = (1-x) r, r >= 1: (P/M)^(1/2) (1-x)^(3/2)/R = ((2 - g + g r)/(1 + r))^(1/2)/r, g = 1 - x
        const Ball q = v[1], g = v[0]; // q = 1/r
        return k.ball(0) - ScalarTraits<Ball>::sqrt_positive_part(((2 - g) * q + g) / (1 + q)) * q * root_kernel(Ball(1));
    }, {{"1-x", 0, 1}, {"(1-x)/R", 0, 1}})).conclude("the kernel of small pressures");
}

Finding mean(const Constants& k)
{
    const auto taylor = [](const Ball& m) { return Ball(1) / 2 + m / 6 + m * m / 24 * exp(m); };
    const Ball end(Rational(1, 1000));
    return Argument("subdivision in balls")
        .note("|E - 1| <= sum |z|^j/(j+1)! = (e^m - 1 - m)/m, m = |z|; over m that is at most 1/2 + m/6 + m^2/24 e^m, by Taylor's theorem")
        .add("no term of which is lost: at m = 1/1000 it is (e^m - 1 - m)/m^2 within m^2/100",
             less_than(abs(taylor(end) - (exp(end) - 1 - end) / (end * end)), end * end / 100, "what Taylor's bound is off"))
        .add("it is < constant, m < 1/1000",
             positive_over([&](const std::vector<Ball>& v) { return k.ball(0) - taylor(v[0]); }, {{"m", 0, Rational(1, 1000)}}))
        .conclude("E(z) = (1 - e^-z)/z next to 0");
}

Finding far_kernel(const Constants& k)
{
    return Argument("subdivision in complex balls")
        .add("|(1 + t)^(1/2) - 1| < constant |t|, |t| < 1/1000: |t|/|1 + (1 + t)^(1/2)|", positive_over([&](const std::vector<Ball>& v) {
                 return k.ball(0) - 1 / abs(1 + sqrt(1 + ComplexBall(v[0] * cos_pi(v[1]), v[0] * sin_pi(v[1]))));
             }, {{"|t|", 0, Rational(1, 1000)}, {"arg t/pi", 0, 1}}))
        .conclude("R = (1-x)(1 + t)^(1/2) beyond the last shell: P <= 2 + 2 eta, |R| >= (1-e)(1 - eta), |M| >= (1-e)(2 - eta)");
}

} // namespace

std::vector<OwnClaim> distribution_claims()
{
    const char* const file = "recursion/from_the_edge/far_end.cpp";
    return {
        {"forward.above_1", "(1 - e^-D)^(-1/2) <= {0}, D >= 1", file, {{"constant", 1.26}}, above_1, {{0, 1.25}}},
        {"forward.remainder",
         "beyond the cut: {0} from D >= 1, {1} from D < 1, {2} in all",
         file,
         {{"far", 1.26}, {"near", 2.52}, {"all", 3.5}},
         remainder,
         {{0, 1.25}, {1, 2.51}, {2, 3.3}}},
        {"forward.next_tail",
         "T_{k+1} <= e^-2 k2 ({0} e^6 + {3} e^-4 T_k), {3} > {1} + {2}",
         file,
         {{"below 4", 1.01}, {"far", 1.26}, {"near", 2.83}, {"all", 4.1}},
         next_tail,
         {{0, 1.009}, {1, 1.25}, {2, 2.51}, {3, 4.08}}},
        {"forward.first_tail",
         "f_2 <= (8a/pi) k2 e^(-3d) {0} (d + {1}), and {2} e^(-5d/2)",
         file,
         {{"slope", 2.02}, {"offset", 1.2}, {"all", 1.43}},
         first_tail,
         {{0, 1.99}, {1, 0.9}, {2, 1.42}}},
        {"forward.slope", "|(log)'| <= {0} + {1} x/(1-x)", file, {{"at the edge", 0.8}, {"slope", 1.75}}, slope, {{0, 0.79}, {1, 1.74}}},
        {"forward.size_of_h", "h <= {0} (1-x)^(-3/2), D >= 1", file, {{"constant", 1.26}}, size_of_h, {{0, 1.25}}},
        {"forward.mean", "|E(z) - 1| <= {0} |z|, |z| < 1/1000", file, {{"constant", 1}}, mean, {{0, 0.5}}},
        {"forward.far_kernel", "|(1 + t)^(1/2) - 1| <= {0} |t|, |t| < 1/1000", file, {{"constant", 1}}, far_kernel, {{0, 0.5}}},
    };
}

} // namespace touchstone::proofs
