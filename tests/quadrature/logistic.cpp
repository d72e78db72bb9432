// SPDX-License-Identifier: MIT
// The trapezoidal rule in log(u/r): its map, its lemmas, what functions do in a sector, and integrals that no rule which winds around
// infinity can take; log(1 + v) where v vanishes.
#include "touchstone/quadrature/endpoint_functions.hpp"
#include "touchstone/quadrature/integrate.hpp"
#include "touchstone/quadrature/lemmas.hpp"
#include "touchstone/quadrature/nodes.hpp"
#include "touchstone/quadrature/special.hpp"
#include "touchstone/quadrature/tanh_sinh.hpp"

#include <doctest/doctest.h>

#include <random>

using namespace touchstone;
using namespace touchstone::quadrature;

namespace {

using Complex = EndpointNumber<ComplexBall>;
constexpr double endless = std::numeric_limits<double>::infinity();

Ball decimal(const char* text) { return Ball(*parse_rational(text)); }

void attains(const Ball& truth, const Ball& bound, const Rational& share)
{
    CHECK_MESSAGE(arb_le(truth.get(), bound.get()), truth.to_string(10), " is over ", bound.to_string(10));
    const Ball less = bound * Ball(share);
    CHECK_MESSAGE(arb_ge(truth.get(), less.get()), truth.to_string(10), " is far below ", bound.to_string(10));
}

/// exp(w), x on a half-line.
ComplexBall at(double re, double im) { return exp(ComplexBall(Ball::exactly(re), Ball::exactly(im))); }

/// x = u/r times c on a piece.
Complex abscissa(const StripPiece& piece, const ComplexBall& c = ComplexBall(1)) { return {&piece, {1, 0}, {-1, 0}, c}; }

/// What the number claims of |f| where the distance to the right end has that size.
Ball claimed(const Complex& f, const Ball& distance)
{
    Ball top;
    const Ball size = abs(f.factor());
    arb_get_ubound_arf(arb_midref(top.get()), size.get(), 53);
    return top * exp(f.right().power.ball() * log(distance));
}

Integral integral(const std::string& formula, const char* from, const char* to, long digits)
{
    IntegralOptions o;
    o.digits = digits;
    return integrate(parse_expression(formula), parse_limit(from), parse_limit(to), o);
}

void is_proved(const std::string& formula, const char* from, const char* to, const std::string& value, bool by_logarithm)
{
    const Ball exact = [&] {
        const WorkingPrecision precision(400);
        return evaluate_at(*parse_expression(value), Ball(0));
    }();
    for (const long digits : {12L, 40L}) {
        const Integral i = integral(formula, from, to, digits);
        INFO(formula, " ", i.reason);
        CHECK(i.status == Status::certified);
        CHECK(i.digits == digits);
        CHECK(i.value.overlaps(exact));
        if (i.parts.empty()) continue;
        const bool found =
            std::any_of(i.parts.begin(), i.parts.end(), [](const Part& p) { return p.rule == "trapezoidal in the logarithm"; });
        CHECK(found == by_logarithm);
    }
}

} // namespace

TEST_CASE("logistic: a piece encloses the map at each of its points, and winds around no end")
{
    const unsigned seed = 1976;
    MESSAGE("seed " << seed);
    std::mt19937_64 random(seed);
    const auto uniform = [&](double a, double b) { return a + (b - a) * static_cast<double>(random() >> 11) * 0x1p-53; };
    for (int i = 0; i < 1000; ++i) {
        const bool far_out = i % 3 == 0;
        const Side side = i % 2 ? Side::left : Side::right;
        const double x1 = uniform(far_out ? 1 : 0, 3), x2 = far_out ? endless : x1 + uniform(0, 0.2), y1 = far_out ? 0 : uniform(0, 1.4),
                     y2 = far_out ? uniform(0.5, 1.5) : y1 + uniform(0, 0.1);
        const StripPiece piece = StripPiece::at(side, x1, x2, y1, y2, Transformation::logistic);
        const double x = far_out ? x1 + uniform(0, 4) : uniform(x1, x2), y = uniform(y1, y2);
        const ComplexBall one(1), u = one / (one + at(side == Side::left ? x : -x, -y)), r = one - u;
        CHECK(piece.distance(Side::left).overlaps(u));
        CHECK(piece.distance(Side::right).overlaps(r));
        const ComplexBall near = side == Side::left ? u : r, far = side == Side::left ? r : u;
        const Side other = side == Side::left ? Side::right : Side::left;
        CHECK(piece.logarithm(other).overlaps(log(far)));
        if (!far_out) {
            CHECK(piece.logarithm(side).overlaps(log(near)));
            CHECK(piece.stretch().contains(Rational(1)));
            CHECK_FALSE(piece.turn(side));
            continue;
        }
        CHECK(piece.depth().contains(Rational(x1)));
        const Ball rho = Ball::exactly(x);
        CHECK(piece.logarithm_over_rho(side).overlaps(log(near) / ComplexBall(rho)));
        for (const auto& [p, k] : {std::pair(Exponent(1), Exponent(0)), {Exponent(1, 3), Exponent(2)}, {Exponent(0), Exponent(-2)}})
            CHECK(piece.vanishing(side, p.ball(), k).overlaps(exp(ComplexBall(p.ball()) * log(near)) * ComplexBall(pow(rho, k.ball()))));
        REQUIRE(piece.turn(side));
        const Ball angle = abs(log(near).imag());
        CHECK(arb_le(angle.get(), piece.turn(side)->get()));
        CHECK_FALSE(piece.turn(other));
    }
    // a piece of the other map says nothing of angles; the bound is as large as some angle is
    CHECK_FALSE(StripPiece::at(Side::right, 1, endless, 0, 0.5).turn(Side::right));
    const StripPiece piece = StripPiece::at(Side::right, 4, endless, 0, 1.25, Transformation::logistic);
    attains(decimal("1.25"), *piece.turn(Side::right), Rational(999, 1000));
}

TEST_CASE("logistic: nodes are the map at t = k h")
{
    for (const long m : {3L, 7L, 40L}) {
        const auto table = NodeTable::get(m, 9 * m, 300, 0.5, Transformation::logistic);
        const WorkingPrecision precision(400);
        for (long k = 0; k <= 9 * m; k += 5) {
            const Node node(*table, k, Side::right);
            Ball log2;
            arb_const_log2(log2.get(), 400);
            const Ball w = log2 * k / m;
            CHECK(node.distance(Side::right).overlaps(1 / (1 + exp(w))));
            CHECK(node.distance(Side::left).overlaps(1 / (1 + exp(-w))));
            CHECK(node.logarithm(Side::right).overlaps(-log(1 + exp(w))));
            CHECK(node.logarithm(Side::left).overlaps(-log(1 + exp(-w))));
            CHECK(node.cosh().contains(Rational(1)));
            CHECK(node.distance(Side::right).relative_bits() > 280);
            const Exponent p(5, 4), q(-2, 7);
            CHECK(node.weighted(p, q).overlaps(
                exp((p + Exponent(1)).ball() * node.logarithm(Side::left) + (q + Exponent(1)).ball() * node.logarithm(Side::right))));
        }
    }
    CHECK(NodeTable::get(7, 20, 100, 0.5) != NodeTable::get(7, 20, 100, 0.5, Transformation::logistic));
}

TEST_CASE("logistic: truncation and the strip's tail are what the lemmas sum")
{
    const WorkingPrecision precision(100);
    const Ball alpha = decimal("0.3"), h = decimal("0.001"), A = decimal("3");
    Ball beyond(0), tail(0);
    constexpr long n = 3000;
    for (long k = n + 1; k < n + 60000; ++k) {
        beyond += h * exp(-alpha * h * Ball(k));
        tail += h * exp(-alpha * h * (Ball(k) - Ball(1) / Ball(2)));
    }
    attains(beyond, lemma::logistic_truncation(Ball(1), alpha, Ball(0), A, h * Ball(n)), Rational(99, 100));
    const Ball factor = lemma::far_factor(alpha, A);
    attains(tail * factor, lemma::logistic_strip_tail(Ball(1), alpha, Ball(0), A), Rational(99, 100));
    for (const char* beta : {"0.7", "-0.7"}) { // the other end's distance, (1 + E)^-1, at E = -exp(-A) or exp(-A)
        const Ball far = lemma::far_factor(decimal(beta), A);
        CHECK(lemma::logistic_truncation(Ball(1), alpha, decimal(beta), A, h * Ball(n))
                  .overlaps(lemma::logistic_truncation(Ball(1), alpha, Ball(0), A, h * Ball(n)) * far));
    }
}

TEST_CASE("logistic: functions in a sector are as small as is claimed, and nearly as large")
{
    const WorkingPrecision precision(120);
    const double x1 = 3.5, d = 0.625;
    const StripPiece piece = StripPiece::at(Side::right, x1, endless, 0, d, Transformation::logistic);
    const Complex x = abscissa(piece);
    struct Function {
        std::string name;
        Complex f;
        std::function<Ball(const ComplexBall&)> size;
        Rational share; // of the claim, at the point where it is nearest
    };
    const Ball n(2);
    const auto of = [](Op op) { return [op](const ComplexBall& z) { return abs(special_function(op, z)); }; };
    const Complex part = x * Complex(Rational(1, 16));
    const auto of_part = [](const std::function<Ball(const ComplexBall&)>& f) {
        return [=](const ComplexBall& z) { return f(z / ComplexBall(16)); };
    };
    const auto ordered = [](Op op, long order) { return [=](const ComplexBall& z) { return abs(special_function(op, Ball(order), z)); }; };
    // the disc of a bound is the square about it, and the bound is taken at the least cosine of the sector at once with the least |x|
    const std::vector<Function> all{
        {"exp(-x)", function_of(Op::exp, -x), [](const ComplexBall& z) { return abs(exp(-z)); }, Rational(1, 100)},
        {"exp(-4x)", function_of(Op::exp, x * Complex(-4)), [](const ComplexBall& z) { return abs(exp(z * ComplexBall(-4))); },
         Rational(0)},
        {"exp(-x^2)", function_of(Op::exp, -(x * x)), [](const ComplexBall& z) { return abs(exp(-z * z)); }, Rational(0)},
        {"erfc", function_of(Op::erfc, x), of(Op::erfc), Rational(0)},
        {"K", function_of(Op::bessel_k, n, x), ordered(Op::bessel_k, 2), Rational(1, 1000)},
        {"scaled I", function_of(Op::bessel_i_scaled, n, x), ordered(Op::bessel_i_scaled, 2), Rational(1, 4)},
        {"scaled K", function_of(Op::bessel_k_scaled, n, x), ordered(Op::bessel_k_scaled, 2), Rational(1, 5)},
        {"scaled erfc", function_of(Op::erfc_scaled, x), of(Op::erfc_scaled), Rational(1, 3)},
        // of x/16: what x is beside its distance, and not 1, enters the bounds
        {"K of x/16", function_of(Op::bessel_k, Ball(0), part), of_part(ordered(Op::bessel_k, 0)), Rational(1, 100)},
        {"scaled I of x/16", function_of(Op::bessel_i_scaled, Ball(0), part), of_part(ordered(Op::bessel_i_scaled, 0)), Rational(1, 4)},
        {"scaled K of x/16", function_of(Op::bessel_k_scaled, Ball(0), part), of_part(ordered(Op::bessel_k_scaled, 0)), Rational(1, 4)},
        {"scaled erfc of x/16", function_of(Op::erfc_scaled, part), of_part(of(Op::erfc_scaled)), Rational(1, 4)},
    };
    for (const Function& g : all) {
        INFO(g.name);
        REQUIRE(g.f.factor().is_finite());
        CHECK(Exponent(0) < g.f.right().power);
        Ball nearest(0);
        for (const double re : {3.5, 3.6, 4.0, 5.0, 8.0})
            for (const double im : {0.0, 0.25, 0.5, 0.625}) {
                const Ball truth = g.size(at(re, im)), r = abs(ComplexBall(1) / (ComplexBall(1) + at(re, im))), claim = claimed(g.f, r);
                CHECK_MESSAGE(arb_le(truth.get(), claim.get()), re, " ", im, ": ", truth.to_string(5), " is over ", claim.to_string(5));
                const Ball share = truth / claim;
                if (arb_gt(share.get(), nearest.get())) nearest = share;
            }
        CHECK_MESSAGE(arb_ge(nearest.get(), Ball(g.share).get()), nearest.to_string(5));
    }
    // to the left they grow, beyond a right angle too, and where the strip winds nothing is known
    CHECK_FALSE(function_of(Op::exp, x).factor().is_finite());
    CHECK_FALSE(function_of(Op::bessel_k, n, -x).factor().is_finite());
    CHECK_FALSE(function_of(Op::bessel_i_scaled, Ball(Rational(1, 3)), x).factor().is_finite());
    const StripPiece wide = StripPiece::at(Side::right, x1, endless, 0, 1.4375, Transformation::logistic);
    CHECK(function_of(Op::exp, -abscissa(wide)).factor().is_finite());
    CHECK_FALSE(function_of(Op::exp, -(abscissa(wide) * abscissa(wide))).factor().is_finite());
    CHECK_FALSE(function_of(Op::erfc, abscissa(wide, ComplexBall(Ball(1), Ball(1)))).factor().is_finite());
    const StripPiece winding = StripPiece::at(Side::right, 2, endless, 0, d);
    CHECK_FALSE(function_of(Op::exp, -abscissa(winding)).factor().is_finite());
}

TEST_CASE("scaled functions: the constants are attained")
{
    const WorkingPrecision precision(200);
    const ComplexBall far(Ball(Rational("1000000000000")));
    // 1 - cos t >= 2 (t/pi)^2 costs pi/2 of the square root's value
    const Ball i = abs(special_function(Op::bessel_i_scaled, Ball(0), far)) * sqrt(abs(far));
    attains(i, lemma::scaled_bessel_i(Ball(1)), Rational(63, 100));
    attains(lemma::scaled_bessel_i(Ball(1)) * Rational(63, 100), i, Rational(98, 100));
    const Ball e = abs(special_function(Op::erfc_scaled, far)) * abs(far);
    attains(e, lemma::scaled_erfc(Ball(1)), Rational(999, 1000));
    // one function on either side of where another way to it is taken
    for (const char* z : {"0.3", "2", "9", "40", "3000"}) {
        const Ball x = decimal(z);
        const auto same = [&](const Ball& a, const Ball& b) {
            CHECK(a.overlaps(b));
            CHECK(a.relative_bits() > 150);
        };
        same(special_function(Op::bessel_i_scaled, Ball(1), x), exp(-x) * special_function(Op::bessel_i, Ball(1), x));
        same(special_function(Op::bessel_k_scaled, Ball(1), x), exp(x) * special_function(Op::bessel_k, Ball(1), x));
        same(special_function(Op::erfc_scaled, x), exp(x * x) * special_function(Op::erfc, x));
    }
}

TEST_CASE("exp(x) K far out is as large as is claimed, where x grows as a power and where it grows as a logarithm")
{
    const WorkingPrecision precision(120);
    const auto radius_of_disc = [](const Complex& f) { // not of the square about it
        Ball radius;
        arb_get_rad_arb(radius.get(), f.factor().real().get());
        return radius;
    };
    const Ball order(1);
    for (const auto& [x1, share] : {std::pair(9., Rational(998, 1000)), std::pair(1.5, Rational(1, 2))}) {
        const StripPiece piece = StripPiece::at(Side::right, x1, endless, 0, 0x1p-12, Transformation::logistic);
        const Complex f = function_of(Op::bessel_k_scaled, order, abscissa(piece));
        const ComplexBall x = at(x1, 0);
        attains(abs(special_function(Op::bessel_k_scaled, order, x)), radius_of_disc(f) * exp(f.right().power.ball() * -log(1 + abs(x))),
                share);
    }
    const StripPiece piece = StripPiece::at(Side::right, 2.5, endless, 0, 0x1p-12);
    const Complex rho(&piece, {}, {0, 1}, ComplexBall(1));
    const Complex f = function_of(Op::bessel_k_scaled, order, rho);
    attains(special_function(Op::bessel_k_scaled, order, piece.depth()), radius_of_disc(f), Rational(97, 100));
}

TEST_CASE("integrals of what is analytic in a sector only")
{
    is_proved("exp(-x)*besseli(1,x)/x", "0", "inf", "1", true);
    is_proved("exp(-x)*besseli(0,x)*x^(-3/4)", "0", "inf", "gamma(1/4)^2/(sqrt(pi)*2^(1/4)*gamma(3/4))", true);
    is_proved("x^(-3/4)*besseli(0,2*x)/exp(2*x)", "0", "inf", "2^(-1/4)*gamma(1/4)^2/(sqrt(pi)*2^(1/4)*gamma(3/4))", true);
    is_proved("exp(x^2)*erfc(x)/sqrt(x)", "0", "inf", "gamma(1/4)/sqrt(2)", true);
    is_proved("exp(x)*besselk(0,x)*x^(-3/4)", "0", "inf", "2^(-1/4)*gamma(1/4)^3/sqrt(pi)", true);
    is_proved("tanh(x)/x^(3/2)", "0", "inf", "4*sqrt(2*pi)*(1-2*sqrt(2))*zeta(-1/2)", true);
    is_proved("erf(x)/x^(3/2)", "0", "inf", "2*gamma(1/4)/sqrt(pi)", true);
    is_proved("tanh(x)/x/(-x)^(1/2)", "-inf", "0", "4*sqrt(2*pi)*(1-2*sqrt(2))*zeta(-1/2)", true);
    is_proved("tanh(-x)/x/(-x)^(1/2)", "-inf", "0", "-4*sqrt(2*pi)*(1-2*sqrt(2))*zeta(-1/2)", true);
    is_proved("tanh(1-x)/(1+x)^2+tanh(x-1)/(1+x)^2+exp(-x)", "0", "inf", "1", true);
    is_proved("x*tanh(x)/(1+x^4)-abs(x)*tanh(abs(x))/(1+x^4)+exp(-x^2)", "-inf", "inf", "sqrt(pi)", true);
    // by the old rules too, now with the scaled functions in them
    is_proved("besseli(0,x)*exp(-2*x)", "0", "inf", "1/sqrt(3)", false);
    is_proved("exp(-x)*besseli(0,x)*exp(-x)", "0", "inf", "1/sqrt(3)", false);
    is_proved("exp(x)*besselk(0,x)*exp(-2*x)", "0", "inf", "1", false);
    is_proved("x*exp(x^2)*erfc(x)*exp(-x^2)", "0", "inf", "1/4", false);
}

TEST_CASE("log(1 + v) where v vanishes far out")
{
    is_proved("log(1+1/x^2)", "0", "inf", "pi", false);
    is_proved("log(1+exp(-x))", "0", "inf", "pi^2/12", false);
    is_proved("log(1-exp(-x))", "0", "inf", "-pi^2/6", false);
    is_proved("log1p(exp(-x))", "0", "inf", "pi^2/12", false);
    is_proved("log(1+exp(x))", "-inf", "0", "pi^2/12", false);
    is_proved("log(tanh(x))", "0", "inf", "-pi^2/8", false);
    is_proved("log(coth(x))", "0", "inf", "pi^2/8", false);
    is_proved("log((x^2+1)/(x^2+4))", "0", "inf", "-pi", false);
    is_proved("log(-exp(-x)+1)", "0", "inf", "-pi^2/6", false);
    is_proved("log(1-exp(-x^2))", "0", "inf", "-sqrt(pi)*zeta(3/2)/2", false);
    is_proved("(1+i)*log(1+1/x^2)", "0", "inf", "pi", false);
    is_proved("log(1+i/x^2)", "0", "inf", "pi/sqrt(2)", false);
}

TEST_CASE("log(1 + v) on pieces encloses the logarithm, and falls as v does")
{
    const WorkingPrecision precision(80);
    const Integrand f(parse_expression("log(1+1/x^2)"), Range{parse_limit("0"), parse_limit("inf"), Map::right_algebraic});
    const auto on = [&](const StripPiece& piece) {
        return f.at(abscissa(piece), Complex(&piece, {1, 0}, {-1, 0}, ComplexBall(1)), Complex(&piece, {}, {1, 0}, ComplexBall(1)));
    };
    for (const double re : {0.0, 0.2, 0.375, 0.5, 1.0, 2.0})
        for (const double im : {0.0, 0.25, 0.5, 1.0}) {
            const ComplexBall x = at(re, im), v = ComplexBall(1) / (x * x);
            const StripPiece piece = StripPiece::at(Side::right, re, re, im, im, Transformation::logistic);
            const Complex value = on(piece);
            CHECK(value.value().overlaps(log(ComplexBall(1) + v)));
            CHECK(value.right().power == Exponent(2)); // on every piece, |v| < 1/2 or not: roots of it are one function then
            CHECK(value.left().is_zero());
        }
    const Complex far = on(StripPiece::at(Side::right, 3, endless, 0, 1, Transformation::logistic));
    CHECK(far.right().power == Exponent(2));
    CHECK(far.factor().is_finite());
}

TEST_CASE("what diverges or is not analytic stays refused")
{
    for (const char* formula : {"exp(-x)*besseli(0,x)", "tanh(x)/(1+x)", "exp(x)*besselk(0,x)/sqrt(1+x)", "log(1+1/x)", "exp(x^2)*erfc(-x)",
                                "erf(x)", "tanh(x)/abs(x-pi)^(3/2)", "exp(-x)*besseli(0,x)/(x-1)^2"}) {
        const Integral i = integral(formula, "0", "inf", 12);
        INFO(formula);
        CHECK_FALSE(i.value.is_finite());
        CHECK_FALSE(i.reason.empty());
    }
}
