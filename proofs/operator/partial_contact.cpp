// SPDX-License-Identifier: GPL-3.0-or-later
/// Partial contact at every scale, G > 2, load <= 1: lemmas 1 and 2, and what the quadrature rules of transfer/rule.cpp rest on.
#include "proofs/operator/own.hpp"
#include "proofs/symbolic/symbolic.hpp"

#include "touchstone/quadrature/endpoint_functions.hpp"
#include "touchstone/quadrature/tanh_sinh.hpp"
#include "touchstone/scalar/symbol.hpp"
#include "touchstone/transfer/chain.hpp"
#include "touchstone/wave/lemmas.hpp"

namespace touchstone::proofs {
namespace {

using GiNaC::pow, GiNaC::sqrt;

const Points points{"x=1/2 u=1/3 q=1/4 h=2/3 G=5/2 C=3/2", "x=4/5 u=2/3 q=1/9 h=1/5 G=7 C=4"};
GiNaC::symbol symbol_of(const ex& e) { return GiNaC::ex_to<GiNaC::symbol>(e); }

Finding half_plane(const Constants& k)
{
    const ex q = sym("q"), r = sym("h"); // u^2 and |e^-s|, both in [0, 1]
    return Argument("symbolic identity, and subdivision")
        .add("1 - (1 - q)(1 + q r) = q (1 - r + q r), q = u^2, r = |e^-s|: not negative for r <= 1",
             identity(1 - (1 - q) * (1 + q * r), q * (1 - r + q * r), points))
        .add("(1 - q)|1 - q r e^(i phi)| < constant for q >= 1/8, in complex balls",
             positive_over(
                 [&](const std::vector<Ball>& v) {
                     const ComplexBall z(v[0] * v[1] * cos_pi(v[2]), v[0] * v[1] * sin_pi(v[2]));
                     return k.ball(0) - (1 - v[0]) * abs(1 - z);
                 },
                 {{"q", Rational(1, 8), 1}, {"r", 0, 1}, {"phi/pi", 0, 1}}))
        .add("Re s_y - log(G/2) - Re(s)/2 = -log((1 - u^2)|1 - u^2 e^-s|)/2 for real s",
             identity(pow(wave::quarter_pressure_squared<ex>(sym("x"), pow(sym("u"), 2), 1 - pow(sym("u"), 2)), 1),
                      sym("x") * (1 - pow(sym("u"), 2)) * (1 - sym("x") * pow(sym("u"), 2)), points))
        .conclude("with |u^2 e^-s| < 1 the logarithm of 1 - u^2 e^-s is analytic: the chain stays in the half plane");
}

Finding force_weighted(const Constants& k)
{
    Ring ring;
    const ex u = sym("u"), x = sym("x"), root_x = ring.root("v", x), w = ring.root("w", 1 - pow(u, 2)),
             rest = ring.root("r", 1 - x * pow(u, 2)), G = sym("G");
    const ex y = 2 * root_x * w * rest / G, antiderivative = (u * sqrt(1 - pow(u, 2)) + asin(u)) / 2;
    return Argument("symbolic identities")
        .add("y is the wave's, at c = 1 - 2 x u^2",
             identity(pow(y, 2), 4 * wave::quarter_pressure_squared<ex>(x, pow(u, 2), 1 - pow(u, 2)) / pow(G, 2), points, ring))
        .add("y/(1 - x u^2)^(1/2) = (2/G)(x (1 - u^2))^(1/2), of (C1)", identity(y / rest, k.exact(0) * 2 / G * root_x * w, points, ring))
        .add("(1 - u^2)^(1/2) is the derivative of (u (1 - u^2)^(1/2) + arcsin u)/2",
             identity(antiderivative.diff(symbol_of(u)), sqrt(1 - pow(u, 2)), points, ring))
        .add("which is pi/4 at 1", identity(antiderivative.subs(u == 1), GiNaC::Pi / 4, points))
        .add("and 0 at 0", identity(antiderivative.subs(u == 0), 0, points))
        .conclude("the noise of the force-weighted chain is the semicircle law, whatever x is");
}

Finding size(const Constants& k)
{
    Check beta{Verdict::verified, "a_0 ... a_11, by certified quadrature"};
    Rational a(1, 2);
    for (long m = 0; m < 12; ++m, a = a / 2) {
        if (m == 0 || m == 11) beta.detail += ", a_" + std::to_string(m) + " = " + Ball(a).to_string(3);
        const Ball exact = sqrt(pi<Ball>()) / 2 * ScalarTraits<Ball>::gamma(Ball(3) / 2 - Ball(a)) / ScalarTraits<Ball>::gamma(2 - Ball(a));
        const Rational power = Rational(1, 2) - a;
        const auto f = [power](auto u, auto, auto right) { return to_power(right, power) * to_power(1 + u, power); };
        const Ball value = quadrature::tanh_sinh(f, quadrature::Interval::finite(0, 1), {.digits = 10}).value;
        if (value.relative_bits() < 20 || exact.relative_bits() < 20) // a value that is none would overlap whatever it is held against
            beta = {Verdict::undecided,
                    "at a = 2^-" + std::to_string(m + 1) + " it is " + value.to_string(9) + " and " + exact.to_string(9)};
        else if (!value.overlaps(k.ball(0) * exact))
            beta = {Verdict::refuted, "at a = 2^-" + std::to_string(m + 1) + " it is " + value.to_string(9)};
    }
    const Ball first = wave::size(Ball(10), 1).back();
    const Ball step = pow(Ball(5), Ball(1) / 2) * 2 / sqrt(pi<Ball>()) / (sqrt(pi<Ball>()) / 2); // Gamma(1) = 1, Gamma(3/2) = pi^(1/2)/2
    return Argument("Taylor coefficients; subdivision in complex balls")
        .note("arcsin's Taylor coefficients (2k)!/(4^k k!^2 (2k+1)) are positive: |arcsin z| <= arcsin |z|, and arcsin is below its chord "
              "(wave::positivity)")
        .add("|arcsin z| < factor (pi/2)|z|, in complex balls",
             positive_over(
                 [&](const std::vector<Ball>& v) {
                     const ComplexBall z(v[0] * cos_pi(v[1]), v[0] * sin_pi(v[1]));
                     return k.ball(0) * pi<Ball>() / 2 * v[0] - abs(asin(z));
                 },
                 {{"|z|", Rational(1, 8), Rational(31, 32)}, {"arg z/pi", 0, Rational(1, 2)}}))
        .add("int_0^1 (1 - u^2)^(1/2 - a) du = factor (pi^(1/2)/2) Gamma(3/2 - a)/Gamma(2 - a)", beta)
        .add("the code's c_1 at G = 10 is (G/2)^(1/2) 4/pi",
             exactly(first.overlaps(step) && first.relative_bits() > 80, first.to_string(9)))
        .conclude("|y| >= (2/G)|x|^(1/2)(1 - u^2), since |1 - x u^2| >= 1 - u^2 for |x| <= 1: c_m and a_m by induction");
}

Finding sizes_converge(const Constants& k)
{
    // log c_{m+1} - log c_m = a log(G/2) + log((2/pi^(1/2)) Gamma(3/2-a)/Gamma(2-a))
    return Argument("balls")
        .add("log((2/pi^(1/2)) Gamma(3/2 - a)/Gamma(2 - a)) < 3a/4 for 0 < a <= 1/2: it is 0 at a = 0, and its derivative psi(2 - a) - "
             "psi(3/2 - a) is below 3/4 there",
             positive_over(
                 [](const std::vector<Ball>& v) {
                     Ball one, other;
                     arb_digamma(one.get(), (2 - v[0]).get(), 64);
                     arb_digamma(other.get(), (Ball(3) / 2 - v[0]).get(), 64);
                     return Ball(3) / 4 - (one - other);
                 },
                 {{"a", 0, Rational(1, 2)}}))
        .add("from c_128 on the logarithm grows by at most 2^-128 (log(10^9/2) + 3/4)",
             less_than(ScalarTraits<Ball>::power_of_two(-128) * (log(Ball(500'000'000)) + 1), k.ball(0), "growth"))
        .conclude("c_m increases to a limit that the code's last one, enlarged, bounds");
}

Finding integrand(const Constants& k)
{
    const ex x = sym("x"), C = sym("C"); // C = cosh v
    const ex root2 = 1 + (1 - x) * (pow(C, 2) - 1), factor = 1 - x * (pow(C, 2) - 1) / pow(C, 2);
    return Argument("symbolic identities")
        .add("u = tanh v: 1 + (1 - x) sinh^2 v = cosh^2 v (1 - x tanh^2 v)", identity(root2, k.exact(0) * pow(C, 2) * factor, points))
        .add("y^2 = (4/G^2) x (1 + (1-x) sinh^2 v)/cosh^4 v",
             identity(4 * wave::quarter_pressure_squared<ex>(x, 1 - 1 / pow(C, 2), 1 / pow(C, 2)), k.exact(0) * 4 * x * root2 / pow(C, 4),
                      points))
        .add("sech^3 (x/y)^(1/2), to the fourth power: (G/2)^2 x cosh^-10 over 1 - x tanh^2 v",
             identity(pow(C, -12) * pow(x, 2) / (4 / pow(sym("G"), 2) * x * root2 / pow(C, 4)),
                      k.exact(0) * pow(sym("G") / 2, 2) * x * pow(C, -10) / factor, points))
        .conclude("(R2): |g| <= c_m (4/pi)(G/2)^(1/2) x^(1/4) |cosh v|^(-5/2) |1 - x tanh^2 v|^(-1/4)");
}

Finding cut_off(const Constants& k)
{
    const ex x = sym("x"), C = sym("C");
    return Argument("symbolic identity, and balls")
        .add("1 - x tanh^2 v - sech^2 v = (1 - x) tanh^2 v: not negative",
             identity(1 - x * (1 - 1 / pow(C, 2)) - 1 / pow(C, 2), (1 - x) * (1 - 1 / pow(C, 2)), points))
        .add("int_V^inf sech^2 = 1 - tanh V = 2/(e^(2V) + 1) < constant e^(-2V), V to 40",
             positive_over([&](const std::vector<Ball>& v) { return k.ball(0) - 2 / (1 + exp(-2 * v[0])); }, {{"V", 0, 40}}))
        .note("for x < 1 also int_V^inf (cosh v)^(-5/2) <= 2^(5/2) e^(-5V/2)/(5/2), from cosh v >= e^v/2")
        .conclude("(R3), what the cut-off at V leaves out");
}

Finding squaring(const Constants& k)
{
    return Argument("balls")
        .add("2 e + e^2 < constant e for 0 < e < 1/16",
             positive_over([&](const std::vector<Ball>& v) { return k.ball(0) - (2 + v[0]); }, {{"e", 0, Rational(1, 16)}}))
        .conclude("the product of two matrices, each off by e of its majorant");
}

Finding recurrence(const Constants& k)
{
    Check all{Verdict::proved, "p = 1 ... 200, exactly"};
    for (long p = 1; p <= 200; ++p) {
        long sum = 0;
        for (long j = 1; j < p; ++j) sum += p - j + 1;
        if (Rational(sum) > Rational(k.number(0)) * p * p) all = {Verdict::refuted, "p = " + std::to_string(p)};
    }
    return Argument("exact arithmetic")
        .note("an error made in step j of U_{k+1} = 2 tau U_k - U_{k-1} is carried on by Chebyshev polynomials of the second kind, |U_k| "
              "<= k + 1")
        .add("sum of the steps' p - j + 1 <= constant p^2", all)
        .conclude("a moment's rounding");
}

} // namespace

std::vector<OwnClaim> partial_contact_claims()
{
    return {
        {"wave::half_plane",
         "(1 - u^2)|1 - u^2 e^-s| <= {0}: Re s_y > log(G/2) + Re(s)/2 where Re s > 0",
         "discretisation.cpp, rule.cpp, series.cpp",
         {{"constant", 1}},
         half_plane,
         {{0, 0.98}}},
        {"wave::force_weighted",
         "in units of force T is an average over the semicircle law, times {0}",
         "discretisation.cpp",
         {{"factor", 1}},
         force_weighted,
         {{0, 0.99}}},
        {"wave::size",
         "|h_m| <= c_m |x|^(-a_m) in the half plane; arcsin and Beta integral to a factor {0}",
         "discretisation.cpp, heavy_load.cpp, series.cpp",
         {{"factor", 1}},
         size,
         {{0, 0.9}}},
        {"wave::size_limit",
         "c_m grows from m = 128 on by less than {0}, G < 10^9",
         "discretisation.cpp",
         {{"growth", 0x1p-60}},
         sizes_converge,
         {{0, 0x1p-124}}},
        {"rule.integrand",
         "the integrand of the step at complex v, (R2), to a factor {0}",
         "rule.cpp",
         {{"factor", 1}},
         integrand,
         {{0, 0.99}}},
        {"rule.cut_off", "beyond V it is at most {0} e^(-2V), (R3)", "rule.cpp", {{"constant", 2}}, cut_off, {{0, 1.9}}},
        {"discretisation.square_power",
         "an error e of a matrix is at most {0} e of its square",
         "carried_errors.cpp",
         {{"constant", 2.1}},
         squaring,
         {{0, 2.0}}},
        {"discretisation.recurrence",
         "p Chebyshev moments lose at most {0} u p^2",
         "moments.cpp, row_budget.cpp, heavy_load.cpp",
         {{"constant", 1}},
         recurrence,
         {{0, 0.4}}},
    };
}

} // namespace touchstone::proofs
