// SPDX-License-Identifier: MIT
// Exact constants, exact expansions and numbers that keep what they do at an end, each against the same computed otherwise.
#include "touchstone/quadrature/elliptic.hpp"
#include "touchstone/quadrature/exact_series.hpp"
#include "touchstone/quadrature/integrand.hpp"
#include "touchstone/quadrature/interval.hpp"
#include "touchstone/quadrature/strip.hpp"

#include "arb_elliptic.hpp"
#include "place.hpp"

#include <doctest/doctest.h>

#include <random>
#include <string>

using namespace touchstone;
using namespace touchstone::quadrature;

namespace {

ExactSum root(long n) { return *ExactSum(n).sqrt(); }
ExactSum over(long p, long q) { return ExactSum(Rational(p, q)); }

/// Numbers of few terms and of many, real and not.
std::vector<ExactSum> constants()
{
    const ExactSum i = ExactSum::i(), pi = ExactSum::pi();
    return {ExactSum(),
            ExactSum(1),
            over(-3, 4),
            pi,
            ExactSum::pi(1),
            ExactSum::pi(-3) * over(2, 7),
            ExactSum::pi(5),
            ExactSum::pi(-2),
            root(2),
            root(6) * over(5, 3),
            i,
            i * root(3) * over(-1, 2),
            i * root(10) * pi,
            ExactSum(1) + ExactSum(2) * i,
            root(2) - i * root(2),
            pi - over(1, 3) * i * ExactSum::pi(1),
            root(15) + root(10) * over(1, 2),
            ExactSum(2) + root(5) + i * root(7) * ExactSum::pi(-1)};
}

constexpr slong bits = 160;

bool is(const ExactSum& found, const ComplexBall& truth)
{
    const ComplexBall ball = found.complex_ball();
    return ball.is_finite() && truth.is_finite() && ball.overlaps(truth) &&
           (found.is_zero() || accuracy(ball) > bits - 40 || found.terms().size() > 1);
}

} // namespace

TEST_CASE("exact constants add, multiply, divide and have roots as the numbers they are")
{
    const WorkingPrecision precision(bits);
    const std::vector<ExactSum> all = constants();
    CHECK(is(ExactSum::pi(), ComplexBall(pi<Ball>())));
    CHECK(is(ExactSum::pi(3), ComplexBall(pi<Ball>() * sqrt(pi<Ball>()))));
    CHECK(is(ExactSum::pi(-1), ComplexBall(Ball(1) / sqrt(pi<Ball>()))));
    CHECK(is(ExactSum::pi(-4), ComplexBall(Ball(1) / (pi<Ball>() * pi<Ball>()))));
    CHECK(is(ExactSum::i(), ComplexBall(Ball(0), Ball(1))));
    CHECK(is(root(2), ComplexBall(sqrt(Ball(2)))));
    for (const ExactSum& a : all) {
        const ComplexBall z = a.complex_ball();
        for (const ExactSum& b : all) {
            const ComplexBall w = b.complex_ball();
            CHECK(is(a + b, z + w));
            CHECK(is(a - b, z - w));
            CHECK(is(a * b, z * w));
            CHECK(a * b == b * a);
            CHECK(((a - b).is_zero()) == (a == b));
        }
        CHECK(is(-a, -z));
        CHECK(is(a.conjugate(), ComplexBall(z.real(), -z.imag())));
        CHECK(is(a.real(), ComplexBall(z.real())));
        CHECK(is(a.imaginary(), ComplexBall(z.imag())));
        CHECK(a.real() + ExactSum::i() * a.imaginary() == a);
        CHECK(a.is_real() == a.imaginary().is_zero());
        CHECK(a.ball().is_finite() == a.is_real());
        CHECK((a - a).is_zero());
        CHECK(*a.power(0) == ExactSum(1));
        CHECK(*a.power(1) == a);
        CHECK(*a.power(3) == a * a * a);
        if (const auto inverse = a.inverse()) {
            CHECK(a * *inverse == ExactSum(1));
            CHECK(*a.power(-2) == *inverse * *inverse);
        }
        if (const auto half = a.sqrt()) {
            CHECK(*half * *half == a);
            CHECK(half->is_real());
            CHECK_FALSE(arb_is_negative(half->ball().get()));
        }
    }
}

TEST_CASE("what an exact constant has of another form is told of those alone that have it")
{
    const ExactSum i = ExactSum::i(), pi = ExactSum::pi();
    CHECK(ExactSum().rational() == Rational(0));
    CHECK(over(-3, 4).rational() == Rational(-3, 4));
    CHECK(ExactSum().times_pi() == Rational(0));
    CHECK((pi * over(2, 3)).times_pi() == Rational(2, 3));
    for (const ExactSum& a :
         {pi, root(2), i, ExactSum(1) + pi, ExactSum(1) + root(2), ExactSum(1) + i, ExactSum::pi(-1) + ExactSum(1), i + ExactSum(1)})
        CHECK_FALSE(a.rational());
    for (const ExactSum& a :
         {ExactSum(1), ExactSum(2), root(2), pi * i, pi * root(2), pi + pi * root(2), pi + ExactSum::pi(3), ExactSum::pi(1), pi + pi * i})
        CHECK_FALSE(a.times_pi());
    // sums have an inverse of this form where their modulus has
    CHECK((ExactSum(1) + ExactSum(2) * i).inverse());
    CHECK((root(2) - i * root(2)).inverse());
    for (const ExactSum& a : {ExactSum(), ExactSum(1) + pi, root(2) + root(3), ExactSum(1) + pi * i}) {
        CHECK_FALSE(a.inverse());
        CHECK_FALSE(a.power(-1));
    }
    CHECK_FALSE(ExactSum(2).power(1000)); // a number of no use
    CHECK_FALSE(ExactSum(2).power(-1000));
    // square roots, with no square left in the radicand: on it rests that a sum is zero only if its terms are
    CHECK(root(8) == ExactSum(2) * root(2));
    CHECK(root(12) == ExactSum(2) * root(3));
    CHECK(root(1800) == ExactSum(30) * root(2));
    CHECK(root(6) * root(10) == ExactSum(2) * root(15));
    CHECK(root(45) == ExactSum(3) * root(5));
    CHECK(*over(8, 9).sqrt() == over(2, 3) * root(2));
    CHECK(*over(1, 2).sqrt() == over(1, 2) * root(2));
    CHECK(*over(72, 5).sqrt() == over(6, 5) * root(10));
    CHECK(*over(3, 44).sqrt() == over(1, 22) * root(33));
    CHECK(*ExactSum(49).sqrt() == ExactSum(7));
    CHECK(*ExactSum(Rational("100000000000000000000")).sqrt() == ExactSum(10000000000));
    CHECK(*pi.sqrt() == ExactSum::pi(1));
    CHECK(*(ExactSum::pi(-4) * ExactSum(3)).sqrt() == ExactSum::pi(-2) * root(3));
    CHECK(ExactSum().sqrt()->is_zero());
    for (const ExactSum& a : {ExactSum(-2), ExactSum(-4), root(2), i, ExactSum::pi(1), ExactSum::pi(3), ExactSum(1) + pi, i * pi})
        CHECK_FALSE(a.sqrt());
    CHECK_THROWS_AS(ExactSum::pi(1L << 62) * ExactSum::pi(1L << 62), DomainError);
}

namespace {

struct Expanded {
    const char* formula;
    ExactSum centre;
    Rational valuation;
    std::size_t terms = 0; ///< that are known; 0: twelve, or eleven of what is not bounded away from 0, as there are of x

    std::size_t known() const { return terms != 0 ? terms : valuation == 0 ? 12 : 11; }
};

/// How the sum of the terms found goes on: less than some multiple of the first power left out, s = 2^-128.
void check_expansion(const Expanded& c, int direction)
{
    CAPTURE(std::string(c.formula));
    CAPTURE(direction);
    constexpr slong depth = 128;
    const WorkingPrecision precision(depth * 20);
    const auto e = parse_expression(c.formula);
    const auto found = expand(*e, c.centre, direction);
    REQUIRE(found.has_value());
    CHECK_FALSE(found->is_exactly_zero);
    CHECK(found->valuation == c.valuation);
    CHECK(found->c.size() == c.known());
    CHECK_FALSE(found->c.front().is_zero());
    const Ball s = Ball(1) / Ball(Rational(power(Rational(2), depth)));
    const ComplexBall value = PlainFormula(e).at(c.centre.complex_ball() + ComplexBall(s) * ComplexBall(direction));
    ComplexBall sum(0);
    for (std::size_t k = found->c.size(); k-- > 0;) sum = sum * ComplexBall(s) + found->c[k].complex_ball();
    const ComplexBall front(pow(s, Ball(found->valuation)));
    const Ball rest = touchstone::abs(value / front - sum);
    CHECK(arb_lt(rest.get(), pow(s, Ball(Rational(static_cast<long>(c.known())) - Rational(1, 2))).get()));
}

} // namespace

TEST_CASE("expansions at an end are those of the function, term by term")
{
    const ExactSum zero, one(1), half = over(1, 2), i = ExactSum::i(), pi = ExactSum::pi();
    for (const int direction : {1, -1})
        for (const Expanded& c : {Expanded{"3+x", zero, 0},
                                  {"x^2-x^5/7", zero, 2, 11},
                                  {"x+x^20", zero, 1, 11},
                                  {"1+x^11", zero, 0},
                                  {"x^2*(1+x)^3/(2-x)", zero, 2, 11},
                                  {"(sin(x)-x)/x^2+1", zero, 0, 10},
                                  {"1+(sin(x)-x)/x^2", zero, 0, 10},
                                  {"1+x^3*(sin(x)-x)", zero, 0},
                                  {"(x-2)*(x+1)", ExactSum(2), 1, 11},
                                  {"1/(2+3*x+x^2-5*x^3)", zero, 0},
                                  {"1/(pi-x)^2", zero, 0},
                                  {"(1+2*i+x)^(-2)", zero, 0},
                                  {"1/sin(x)-1/x", zero, 1, 9},
                                  {"sqrt(3+x)", zero, 0},
                                  {"sqrt(pi*(2+x+x^2))", zero, 0},
                                  {"(4+x-x^3)^(-3/2)", zero, 0},
                                  {"cbrt(1+x)", zero, 0},
                                  {"(1+x+x^2)^(-5/7)", zero, 0},
                                  {"(2+x)^5", zero, 0},
                                  {"(2+x)^(-3)", zero, 0},
                                  {"(2+x)^2", zero, 0},
                                  {"(1+x)^0+x", zero, 0},
                                  {"(sqrt(2)+x)^4", zero, 0},
                                  {"exp(x)", zero, 0},
                                  {"exp(sin(x))", zero, 0, 12},
                                  {"exp(i*pi/3+x)", zero, 0},
                                  {"exp(i*x+(x-3*pi/4)^2)", pi * over(3, 4), 0},
                                  {"exp(i*x)", pi * over(-7, 6), 0},
                                  {"expm1(x)", zero, 1, 11},
                                  {"log(x)", one, 1},
                                  {"log(1+x+x^2)", zero, 1},
                                  {"log1p(x-x^2)", zero, 1},
                                  {"sinh(x)", zero, 1, 11},
                                  {"cosh(x)", zero, 0},
                                  {"tanh(x)", zero, 1, 11},
                                  {"coth(x)", zero, -1, 11},
                                  {"sech(x)", zero, 0},
                                  {"csch(x)", zero, -1, 11},
                                  {"tan(x)", pi * over(1, 3), 0},
                                  {"cot(x)", pi * over(1, 4), 0},
                                  {"sec(x)", zero, 0},
                                  {"csc(x)", pi * over(1, 6), 0},
                                  {"tan(x)", pi * half, -1, 11},
                                  {"sinc(x)", zero, 0, 11},
                                  {"atan(x)", zero, 1},
                                  {"atanh(x)", zero, 1},
                                  {"asinh(x)", zero, 1},
                                  {"asin(x)", zero, 1},
                                  {"acos(x)", zero, 0},
                                  {"acos(x)-pi/2", zero, 1},
                                  {"erf(x)", zero, 1},
                                  {"erfi(x)", zero, 1},
                                  {"si(x)", zero, 1, 11},
                                  {"lambertw(x)", zero, 1},
                                  {"lambertw(sin(x))", zero, 1, 11},
                                  {"besselj(0,x)", zero, 0},
                                  {"besselj(1,x)", zero, 1},
                                  {"besselj(3,x)", zero, 3},
                                  {"besseli(0,x)", zero, 0},
                                  {"besseli(2,x+x^2)", zero, 2},
                                  {"besselj(8,x)", zero, 8},
                                  {"re(i*x^2+x+3)", zero, 0},
                                  {"im(i*x^2+x+3*i)", zero, 0},
                                  {"conj((1+i*x)^2)", zero, 0},
                                  {"re(exp(i*x))", zero, 0},
                                  {"abs(x-1/2)", zero, 0},
                                  {"abs(2+x)", zero, 0},
                                  {"sign(x-3)*cos(x)", zero, 0},
                                  {"sign(3-x)+x", zero, 0}})
            check_expansion(c, direction);
    // powers of the distance that are not whole, for which s is to be positive
    for (const Expanded& c : {Expanded{"sqrt(x)", zero, half.rational().value()},
                              {"cbrt(x)*cos(x)", zero, Rational(1, 3)},
                              {"sqrt(x)*(1+x)^(1/2)", zero, Rational(1, 2)},
                              {"sqrt(x)+x^(3/2)", zero, Rational(1, 2)},
                              {"sqrt(2*x)/(x+x^2)", zero, Rational(-1, 2)},
                              {"(x^2+x^3)^(1/3)", zero, Rational(2, 3)},
                              {"abs(x)", zero, 1},
                              {"abs(-x)", zero, 1},
                              {"asin(sqrt(x)^2)", zero, 1}})
        check_expansion(c, 1);
}

TEST_CASE("sine, cosine and exponential have an expansion at twelfths of pi, where both parts are one square root")
{
    for (long k = -25; k <= 49; ++k) {
        CAPTURE(k);
        const ExactSum centre = ExactSum::pi() * over(k, 12);
        const bool has = k % 2 == 0 || k % 3 == 0;
        for (const char* formula : {"sin(x)", "cos(x)", "exp(i*x)"}) {
            const auto found = expand(*parse_expression(formula), centre, 1);
            CHECK(found.has_value() == has);
            if (!found) continue;
            const bool vanishes = formula[0] == 's' ? k % 12 == 0 : formula[0] == 'c' && (k - 6) % 12 == 0;
            check_expansion({formula, centre, vanishes ? 1 : 0, vanishes ? 11UL : 12UL}, 1);
        }
    }
    for (const ExactSum& centre : {ExactSum::pi() * over(1, 5), ExactSum(1), ExactSum::pi(2) + ExactSum(1)})
        for (const char* formula : {"sin(x)", "cos(x)", "exp(i*x)", "exp(x)", "tan(x)"})
            CHECK_FALSE(expand(*parse_expression(formula), centre, 1).has_value());
}

TEST_CASE("a formula that has no such expansion is given none")
{
    for (const char* formula : {"log(x)",
                                "x+log(x)",
                                "log(x)+x",
                                "x*log(x)",
                                "log(x)*x",
                                "-log(x)",
                                "1/log(x)",
                                "re(log(x))",
                                "exp(2+x)",
                                "sqrt(x)+x",
                                "cbrt(2+x)",
                                "cbrt(4+x)",
                                "cbrt(8+x)",
                                "(1+x)^pi",
                                "(1+x)^x",
                                "(1+pi+x)^2",
                                "(1+pi+x)^(-1)",
                                "sqrt(1+pi+x)",
                                "sqrt(-1+x)",
                                "1/(1+pi+x)",
                                "cos(1/x)",
                                "cos(sqrt(x))",
                                "cos(log(x))",
                                "sin(1/5+x)",
                                "log(2+x)",
                                "log1p(1+x)",
                                "sinh(1+x)",
                                "cosh(1+x)",
                                "sinc(1+x)",
                                "atan(1+x)",
                                "atanh(1/2+x)",
                                "asinh(1+x)",
                                "asin(1/2+x)",
                                "acos(1/2+x)",
                                "erf(1+x)",
                                "erfi(1+x)",
                                "si(1+x)",
                                "lambertw(1+x)",
                                "besselj(0,1+x)",
                                "besselj(-1,x)",
                                "besselj(1/2,x)",
                                "besselj(pi,x)",
                                "besselj(100,x)",
                                "besselj(1,log(x))",
                                "besselj(0,1/x)",
                                "abs(1+i*x)",
                                "abs(i+x)",
                                "abs(exp(2+x))",
                                "sign(i*x)",
                                "1/(sin(x)-sin(x))",
                                "abs(sin(x)-sin(x))",
                                "exp((sin(x)-sin(x))/x^12)",
                                "gamma(1+x)",
                                "airyai(x)"}) {
        CAPTURE(formula);
        CHECK_FALSE(expand(*parse_expression(formula), ExactSum(), 1).has_value());
    }
    // zero to all orders, and zero to those known
    const auto zero = expand(*parse_expression("0*x"), ExactSum(), 1);
    REQUIRE(zero.has_value());
    CHECK(zero->is_exactly_zero);
    const auto to_some_order = expand(*parse_expression("sin(x)-sin(x)"), ExactSum(), 1);
    REQUIRE(to_some_order.has_value());
    CHECK_FALSE(to_some_order->is_exactly_zero);
    CHECK(to_some_order->c.empty());
    CHECK(to_some_order->valuation == 12);
}

TEST_CASE("constants are exact where they are of the form, and none is made up")
{
    const auto value = [](const char* text) { return exact_value(*parse_expression(text)); };
    const auto exactly_valued = [&value](const char* text) {
        const auto v = value(text);
        CAPTURE(text);
        REQUIRE(v.has_value());
        return *v;
    };
    CHECK(exactly_valued("2+3") == ExactSum(5));
    CHECK(exactly_valued("2*3-7/4") == over(17, 4));
    CHECK(exactly_valued("-pi/3") == ExactSum::pi() * over(-1, 3));
    CHECK(exactly_valued("sqrt(2)*i+pi") == root(2) * ExactSum::i() + ExactSum::pi());
    CHECK(exactly_valued("cos(pi/6)^2") == over(3, 4));
    CHECK(exactly_valued("exp(i*pi/2)") == ExactSum::i());
    CHECK(exactly_valued("abs(-3)") == ExactSum(3));
    CHECK(exactly_valued("0*sqrt(2)") == ExactSum());
    CHECK(exactly_valued("sin(pi)+1") == ExactSum(1));
    for (const char* text : {"x", "x-x", "exp(2)", "1/0", "0/0", "1/(sin(pi)*0)", "2+exp(2)", "exp(2)*3", "pi/(1+pi)", "1/(1+pi)",
                             "-exp(2)", "log(1)"}) { // log(1) is known to be 0 to some order only
        CAPTURE(text);
        CHECK_FALSE(value(text).has_value());
    }
}

namespace {

using Number = EndpointNumber<ComplexBall>;

/// u, 1 - u and their logarithms on some sheet.
struct Spot {
    ComplexBall u, log_u, log_r;
    explicit Spot(const Rational& re, const Rational& im, long sheet_u, long sheet_r)
        : u(Ball(re), Ball(im))
    {
        log_u = log(u) + turns(sheet_u);
        log_r = log(ComplexBall(1) - u) + turns(sheet_r);
    }
    ComplexBall monomial(const Exponent& p, const Exponent& q) const
    {
        return exp(ComplexBall(p.ball()) * log_u + ComplexBall(q.ball()) * log_r);
    }
    /// What a number of a frame without values for logarithms stands for here.
    ComplexBall meaning(const Number& x) const
    {
        ComplexBall sum = x.factor_without_logarithm();
        for (const auto& t : x.logarithms()) sum += t.c * analytic::integer_power(log_u, t.left) * analytic::integer_power(log_r, t.right);
        return sum * monomial(x.left().power, x.right().power);
    }
};

} // namespace

TEST_CASE("powers of the distances at a place are those of the logarithms there")
{
    const WorkingPrecision precision(bits);
    const Spot spot(Rational(-2, 3), Rational(1, 5), 1, -1);
    const Place<ComplexBall> place(spot.u, spot.log_u, spot.log_r);
    for (const Side s : {Side::left, Side::right}) {
        const ComplexBall l = s == Side::left ? spot.log_u : spot.log_r;
        for (const Exponent& e : {Exponent(0), Exponent(1), Exponent(2), Exponent(-3), Exponent(64), Exponent(-65), Exponent(1, 3),
                                  Exponent(-5, 2), Exponent(200, 3)}) {
            const ComplexBall found = place.power(s, e);
            CHECK(holds(found, exp(ComplexBall(e.ball()) * l)));
            CHECK(accuracy(found) > bits - 40);
        }
        for (const Ball& e : {Ball(0), Ball(1), Ball(Rational(7, 3)), pi<Ball>()}) CHECK(holds(place.power(s, e), exp(ComplexBall(e) * l)));
        CHECK_FALSE(place.power(s, Ball(-1)).is_finite());
    }
    const ComplexBall both = place.monomial(Exponent(-1, 3), Exponent(5, 4));
    CHECK(holds(both, spot.monomial(Exponent(-1, 3), Exponent(5, 4))));
    CHECK(accuracy(both) > bits - 40);
}

TEST_CASE("orders of an end add, scale and compare as powers of a distance and of its logarithm")
{
    const Order a{{1, 2}, {3, 1}}, b{{1, 3}, {-1, 2}};
    CHECK(a + b == Order{{5, 6}, {5, 2}});
    CHECK(a - b == Order{{1, 6}, {7, 2}});
    CHECK(a * Exponent(2, 3) == Order{{1, 3}, {2, 1}});
    CHECK(Order{}.is_zero());
    CHECK_FALSE(Order{{1, 2}, {}}.is_zero());
    CHECK_FALSE(Order{{}, {1, 1}}.is_zero());
    CHECK(Order::dominant(a, b) == b);
    CHECK(Order::dominant(b, a) == b);
    CHECK(Order::dominant({{1, 2}, {1, 1}}, a) == a); // the larger power of the logarithm
}

TEST_CASE("exponents are rational numbers of 64 bits or an error")
{
    std::mt19937_64 random(7);
    constexpr long most = std::numeric_limits<long>::max();
    const auto some = [&] {
        const int shift = static_cast<int>(random() % 62);
        const long n = static_cast<long>(random() >> 1) >> shift;
        return std::max(1L, n);
    };
    const auto fits = [](const Rational& r) {
        return r.get_num().fits_slong_p() && r.get_den().fits_slong_p() && r.get_num() != std::numeric_limits<long>::min();
    };
    const auto check = [&](const auto& operation, const Rational& truth) {
        if (fits(truth))
            CHECK(operation().rational() == truth);
        else
            CHECK_THROWS_AS(operation(), DomainError);
    };
    for (int k = 0; k < 4000; ++k) {
        Rational a(random() % 2 ? some() : -some(), k % 4 == 0 ? 1 : some()), b(random() % 2 ? some() : -some(), k % 3 == 0 ? 1 : some());
        a.canonicalize();
        b.canonicalize();
        const Exponent x(a), y(b);
        check([&] { return x * y; }, a * b);
        check([&] { return x + y; }, a + b);
        check([&] { return x - y; }, a - b);
        CHECK((x < y) == (a < b));
        CHECK((x == y) == (a == b));
        CHECK(x.is_integer() == (a.get_den() == 1));
        CHECK(x.to_string() == a.get_str());
        CHECK(x.to_double() == doctest::Approx(a.get_d()).scale(0));
        CHECK(x.ball().overlaps(Ball(a)));
        CHECK(x.ball().relative_bits() > 100);
    }
    CHECK(Exponent(6, -4).rational() == Rational(-3, 2));
    CHECK(Exponent(1, 2) < Exponent(2, 2));
    CHECK_FALSE(Exponent(1, 2) == Exponent(1, 3));
    CHECK_FALSE(Exponent(1, 2) == Exponent(3, 2));
    Rational large("1180591620717411303424"); // 2^70
    CHECK_THROWS_AS(Exponent{large}, DomainError);
    CHECK_THROWS_AS(Exponent{Rational(1 / large)}, DomainError);
    CHECK_THROWS_AS(Exponent(most) * Exponent(2), DomainError);
    CHECK_THROWS_AS(Exponent(1, most) * Exponent(1, 2), DomainError);
    CHECK((Exponent(-(most - 1), 14) + Exponent(-(most - 1), 14)).rational() == Rational(-(most - 1)) / 7);
}

TEST_CASE("numbers with logarithms kept are, summed and multiplied in any order, what they stand for")
{
    const WorkingPrecision precision(bits);
    const Spot spot(Rational(1, 5), Rational(2, 3), -1, 1);
    const Place<ComplexBall> place(spot.u);
    const Number u = place.left(), r = place.right();
    const Number pool[] = {Number(3),
                           u,
                           to_power(r, Exponent(1, 3)),
                           log(u),
                           log(r),
                           u * log(u) - Number(2),
                           to_power(u, Exponent(-1, 2)) * log(u * r),
                           log(u) * log(r) + log(u),
                           u * log(r) + r * log(u)};
    const auto is = [&](const Number& found, const ComplexBall& truth) {
        CHECK(holds(spot.meaning(found), truth));
        CHECK(accuracy(spot.meaning(found)) > bits - 60);
    };
    is(log(u), spot.log_u);
    is(log(r), spot.log_r);
    is(log(to_power(u, Exponent(2, 3)) * to_power(r, Exponent(-1, 7)) * Number(5)),
       spot.log_u * ComplexBall(Rational(2, 3)) - spot.log_r / ComplexBall(7) + log(ComplexBall(5)));
    for (const Number& x : pool) {
        const ComplexBall a = spot.meaning(x);
        is(-x, -a);
        is(to_power(x, Exponent(1)), a);
        is(to_power(x, Exponent(2)), a * a);
        is(to_power(x, Exponent(8)), a * a * a * a * a * a * a * a);
        is(x / (u * Number(2)), a / (spot.u * ComplexBall(2)));
        is(x / to_power(r, Exponent(3, 2)), a / spot.monomial(0, Exponent(3, 2)));
        for (const Number& y : pool) {
            const ComplexBall b = spot.meaning(y);
            is(x * y, a * b);
            // a power that is not whole must stand before all
            if (!(x.left().power - y.left().power).is_integer() || !(x.right().power - y.right().power).is_integer()) continue;
            is(x + y, a + b);
            is(x - y - y, a - b - b);
            if (x.left().power.is_integer() && x.right().power.is_integer()) is(x + y + Number(1), a + b + ComplexBall(1));
        }
        if (!x.has_logarithms()) continue;
        // all else has no value
        CHECK_FALSE(x.is_plain());
        CHECK_FALSE(x.value().is_finite());
        for (const Number& y : {Number(1) / x, u / x, x / x, sqrt(x), to_power(x, Exponent(1, 2)), to_power(x, Exponent(-1)), exp(x),
                                log(x), sin(x), atan(x)})
            CHECK_FALSE(y.value().is_finite());
    }
    // one term of a kind
    CHECK((log(u) + log(r)).logarithms().size() == 2);
    CHECK((log(u) * log(r) + log(r) * log(u)).logarithms().size() == 3);
    CHECK(to_power(log(u), Exponent(0)).value().overlaps(ComplexBall(1)));
    CHECK(to_power(log(u), Exponent(0)).value().is_finite());
}

TEST_CASE("numbers with powers of the distances are, added and multiplied, what they stand for, on any sheet")
{
    const WorkingPrecision precision(bits);
    for (const auto& spot : {Spot(Rational(1, 5), Rational(2, 3), -1, 1), Spot(Rational(1, 3), Rational(0), 0, 0),
                             Spot(Rational(-5, 4), Rational(3, 2), 2, 0)}) {
        const Place<ComplexBall> place(spot.u, spot.log_u, spot.log_r);
        const Number u = place.left(), r = place.right();
        const Number pool[] = {
            Number(3), u, r * Number(2), to_power(r, Exponent(1, 3)), to_power(u, Exponent(-1, 2)) * (Number(1) + u), sqrt(u * u * u / r)};
        const auto is = [&](const Number& found, const ComplexBall& truth) {
            CHECK(holds(found.value(), truth));
            CHECK(accuracy(found.value()) > bits - 60);
        };
        for (const Number& x : pool) {
            const ComplexBall a = spot.meaning(x);
            is(x, a);
            is(-x, -a);
            is(x * x * x, a * a * a);
            is(to_power(x, Exponent(-2)), ComplexBall(1) / (a * a));
            is(exp(x), exp(a));
            is(sin(x), sin(a));
            is(cos(x), cos(a));
            for (const Number& y : pool) {
                const ComplexBall b = spot.meaning(y);
                is(x * y, a * b);
                is(x / y, a / b);
                is(x + y, a + b);
                is(x - y - y, a - b - b);
            }
        }
        const ComplexBall w = spot.monomial(Exponent(1, 3), Exponent(-1, 2));
        const Number x = to_power(u, Exponent(1, 3)) / sqrt(r);
        is(log(x), spot.log_u / ComplexBall(3) - spot.log_r / ComplexBall(2));
        is(log(x * Number(7)), spot.log_u / ComplexBall(3) - spot.log_r / ComplexBall(2) + log(ComplexBall(7)));
        is(sqrt(x), spot.monomial(Exponent(1, 6), Exponent(-1, 4)));
        is(to_power(x, Exponent(3, 4)), spot.monomial(Exponent(1, 4), Exponent(-3, 8)));
        is(to_power(x * Number(2), Rational(1, 3)),
           spot.monomial(Exponent(1, 9), Exponent(-1, 6)) * ComplexBall(pow(Ball(2), Ball(Rational(1, 3)))));
        for (const Ball& s : {Ball(Rational(1, 3)), Ball(Rational(-2, 7)), Ball(Rational(1, 2)), pi<Ball>(), Ball(-2)}) {
            const ComplexBall logarithm = spot.log_u / ComplexBall(3) - spot.log_r / ComplexBall(2) + log(ComplexBall(5));
            const ComplexBall truth = exp(ComplexBall(s) * logarithm);
            is(pow(x * Number(5), s), truth);
            is(pow(x * Number(5), Number(s)), truth);
        }
        is(pow(Number(2), x), exp(w * ComplexBall(log(Ball(2)))));
        is(pow(u, Number(ComplexBall(Ball(1), Ball(2)))), exp(ComplexBall(Ball(1), Ball(2)) * spot.log_u));
        if (analytic::atan(w).is_finite()) is(atan(x), analytic::atan(w));
    }
}

TEST_CASE("a power with a ball for exponent keeps an exact part of it, and carries what is left over")
{
    const WorkingPrecision precision(bits);
    const Spot spot(Rational(1, 5), Rational(2, 3), -1, 1);
    const Place<ComplexBall> place(spot.u, spot.log_u, spot.log_r);
    const Number u = place.left(), r = place.right();
    CHECK(pow(u, Ball(Rational(1, 2))).left().power == Exponent(1, 2));
    CHECK(pow(r, Ball(Rational(-3, 4))).right().power == Exponent(-3, 4));
    CHECK(pow(u, Ball(Rational(1, 3))).left().power == Exponent(341, 1024));
    CHECK(pow(u, Ball(Rational(-1, 3))).left().power == Exponent(-342, 1024));
    for (const auto& [middle, radius] : {std::pair(Rational(1, 2), Rational(1, 1000000000000000000)),
                                         {Rational(1, 2), Rational(1, 100)},
                                         {Rational(-1, 3), Rational(1, 50)},
                                         {Rational(7, 3), Rational(1, 2000)}}) {
        Ball s(middle);
        arb_add_error(s.get(), Ball(radius).get());
        const Number found = pow(u, s);
        CHECK(found.value().is_finite());
        CHECK(found.left().power.rational() <= middle - radius);
        CHECK(found.left().power.rational() > middle - radius - Rational(3, 1024));
        for (const Rational& e : {Rational(middle - radius), middle, Rational(middle + radius)})
            CHECK(holds(found.value(), exp(ComplexBall(e) * spot.log_u)));
    }
    Ball large(1);
    arb_mul_2exp_si(large.get(), large.get(), 31);
    CHECK_FALSE(pow(u, large).value().is_finite());
    CHECK_FALSE(pow(u, -large).value().is_finite());
    Ball wide(0); // whose lower end is no number of 64 bits
    arb_add_error_2exp_si(wide.get(), 100);
    CHECK_FALSE(pow(u, wide).value().is_finite());
    CHECK_FALSE(pow(u, Ball::indeterminate()).value().is_finite());
    // powers of the size of a logarithm are not taken
    CHECK_FALSE(pow(Number(&place, {1, 1}, {}, ComplexBall(1)), Ball(2)).factor().is_finite());
    CHECK_FALSE(pow(Number(&place, {}, {1, 1}, ComplexBall(1)), Ball(2)).factor().is_finite());
    CHECK_FALSE(log(Number(&place, {1, 1}, {}, ComplexBall(1))).factor().is_finite());
    CHECK_FALSE(log(Number(&place, {}, {1, 1}, ComplexBall(1))).factor().is_finite());
}

TEST_CASE("sine, arctangent and arcsine keep a zero at an end, and take nothing for one that is none")
{
    const WorkingPrecision precision(bits);
    const Spot spot(Rational(1, 5), Rational(2, 3), 0, 0);
    const Place<ComplexBall> place(spot.u, spot.log_u, spot.log_r);
    const auto with = [&](Order p, Order q) { return Number(&place, p, q, ComplexBall(Ball(1) / Ball(4))); };
    CHECK(vanishes_at_an_end(with({1, 0}, {})));
    CHECK(vanishes_at_an_end(with({}, {{1, 2}, 0})));
    CHECK(vanishes_at_an_end(with({1, 0}, {2, 0})));
    CHECK_FALSE(vanishes_at_an_end(with({}, {})));
    CHECK_FALSE(vanishes_at_an_end(with({-1, 0}, {})));
    CHECK_FALSE(vanishes_at_an_end(with({-1, 0}, {1, 0})));
    CHECK_FALSE(vanishes_at_an_end(with({1, 0}, {{-1, 2}, 0})));
    CHECK_FALSE(vanishes_at_an_end(with({1, 1}, {})));
    CHECK_FALSE(vanishes_at_an_end(with({1, 0}, {1, -1})));
    for (const Number& x : {with({1, 0}, {}), with({}, {{1, 2}, 0}), with({2, 0}, {1, 0}), with({-1, 0}, {}), with({-1, 0}, {1, 0})}) {
        const ComplexBall a = x.value();
        const bool zero = vanishes_at_an_end(x);
        for (const auto& [found, truth] : {std::pair(sin(x), sin(a)), {atan(x), analytic::atan(a)}, {asin(x), analytic::asin(a)}}) {
            CHECK(holds(found.value(), truth));
            CHECK(accuracy(found.value()) > bits - 40);
            CHECK((found.left() == x.left()) == (zero || x.left().is_zero()));
            CHECK((found.right() == x.right()) == (zero || x.right().is_zero()));
        }
        CHECK(holds(acos(x).value(), ComplexBall(pi<Ball>() / Ball(2)) - analytic::asin(a)));
        CHECK(holds(atan2(x, Number(3)).value(), analytic::atan(a / ComplexBall(3))));
    }
    // from a little below 0 on the imaginary axis to where the function has grown most
    const Ball side = hull(Ball(Rational(-1, 1000)), Ball(Rational(49, 100)));
    const ComplexBall upwards =
        analytic::odd_over_argument(ComplexBall(Ball(0), side), [](const ComplexBall& z) { return analytic::atan(z); });
    const ComplexBall top(Ball(0), Ball(Rational(49, 100)));
    CHECK(holds(upwards, analytic::atan(top) / top));
    CHECK_FALSE(analytic::atan(ComplexBall(Ball(0), Ball(Rational(6, 5)))).is_finite());
    CHECK_FALSE(analytic::asin(ComplexBall(Rational(6, 5))).is_finite());
    CHECK(analytic::atan(ComplexBall(Ball(0), Ball(Rational(4, 5)))).is_finite());
    CHECK(analytic::asin(ComplexBall(Rational(4, 5))).is_finite());
}

TEST_CASE("real numbers at a node have the powers and functions of their value")
{
    const WorkingPrecision precision(bits);
    for (const Rational& at : {Rational(1, 7), Rational(4, 5)}) {
        const Ball v(at), w = Ball(1) - v;
        const Place<Ball> place(v, log(v), log(w));
        const auto u = place.left(), r = place.right();
        const auto is = [&](const EndpointNumber<Ball>& found, const Ball& truth) {
            CHECK(found.value().is_finite());
            CHECK(found.value().overlaps(truth));
            CHECK(found.value().relative_bits() > bits - 40);
        };
        is(pow(u, EndpointNumber<Ball>(Rational(-2, 3))), exp(Ball(Rational(-2, 3)) * log(v)));
        is(pow(u, r), exp(w * log(v)));
        is(pow(EndpointNumber<Ball>(3), r), exp(w * log(Ball(3))));
        is(to_power(u * EndpointNumber<Ball>(5), Exponent(-3)), Ball(1) / (v * v * v * Ball(125)));
        is(to_power(EndpointNumber<Ball>(v), Exponent(-3)), Ball(1) / (v * v * v));
        is(to_power(EndpointNumber<Ball>(v), Exponent(4)), v * v * v * v);
        is(to_power(EndpointNumber<Ball>(v), Exponent(3, 2)), v * sqrt(v));
        is(to_power(EndpointNumber<Ball>(v), Exponent(-2, 3)), exp(Ball(Rational(-2, 3)) * log(v)));
        is(to_power(EndpointNumber<Ball>(1), Exponent(-2, 3)), Ball(1));
        is(log(u * u / r), Ball(2) * log(v) - log(w));
        is(sqrt(u * EndpointNumber<Ball>(3)), sqrt(v * Ball(3)));
        is(sin(u), sin(v));
        is(acos(u), acos(v));
    }
}

TEST_CASE("the logarithm on a piece that reaches an end is the size of the logarithm times a bounded factor")
{
    const WorkingPrecision precision(bits);
    const StripPiece& piece = StripPiece::at(Side::left, 1, std::numeric_limits<double>::infinity(), 0, 1);
    for (const Side s : {Side::left, Side::right}) {
        const StripPiece& end = StripPiece::at(s, 1, std::numeric_limits<double>::infinity(), 0, 1);
        const Number x = s == Side::left ? Number(&end, {{2, 3}, 0}, {}, ComplexBall(1)) : Number(&end, {}, {{2, 3}, 0}, ComplexBall(1));
        const Number l = log(x);
        CHECK(l.order(s) == Order{0, 1});
        CHECK(l.order(s == Side::left ? Side::right : Side::left).is_zero());
        CHECK(l.factor().is_finite());
        CHECK(l.factor().overlaps(end.logarithm_over_rho(s) * ComplexBall(Rational(2, 3))));
        CHECK(accuracy(l.factor()) + 8 > accuracy(end.logarithm_over_rho(s)));
    }
    const Number u(&piece, {1, 0}, {}, ComplexBall(1));
    CHECK(u.value().is_finite());
    CHECK(u.value().overlaps(piece.distance(Side::left)));
    CHECK((u * log(u)).value().is_finite());
    CHECK_FALSE(log(u).value().is_finite());
    CHECK_FALSE((Number(1) / u).value().is_finite());
}

namespace {

/// The abscissa, the distances and dx/du of an interval at u, as interval.hpp has them.
struct Abscissas {
    ComplexBall x, left, right, slope;
};

Abscissas truth(int kind, const ComplexBall& a, const ComplexBall& b, bool mirrored, const Spot& at)
{
    const ComplexBall one(1), u = at.u, r = one - u;
    const auto ray = [&](const ComplexBall& distance, const ComplexBall& nearness, const ComplexBall& slope) -> Abscissas {
        if (mirrored) return {a - distance, nearness, distance, slope};
        return {a + distance, distance, nearness, slope};
    };
    switch (kind) {
    case 0: return {a + (b - a) * u, (b - a) * u, (b - a) * r, b - a};
    case 1: return ray(u / r, r, one / (r * r));
    case 2: return ray(-at.log_r, r, one / r);
    case 3: return {(u / r - r / u) / ComplexBall(2), u, r, (one / (u * u) + one / (r * r)) / ComplexBall(2)};
    default: return {at.log_u - at.log_r, u, r, one / u + one / r};
    }
}

std::vector<std::tuple<Interval, int, Endpoint, Endpoint, bool>> intervals()
{
    std::vector<std::tuple<Interval, int, Endpoint, Endpoint, bool>> all;
    const Endpoint exact[] = {0, Rational(-3, 4), Rational(7, 3)}, inexact([] { return pi<Ball>(); });
    for (const auto& [a, b] : {std::pair(exact[0], exact[2]),
                               {exact[1], exact[0]},
                               {exact[1], exact[2]},
                               {exact[1], inexact},
                               {exact[2], inexact},
                               {exact[0], inexact}})
        all.emplace_back(Interval::finite(a, b), 0, a, b, false);
    for (const Endpoint& a : {exact[0], exact[1], inexact})
        for (const Decay d : {Decay::algebraic, Decay::exponential}) {
            const int kind = d == Decay::algebraic ? 1 : 2;
            all.emplace_back(Interval::right_half_line(a, d), kind, a, 0, false);
            all.emplace_back(Interval::left_half_line(a, d), kind, a, 0, true);
        }
    all.emplace_back(Interval::whole_line(Decay::algebraic), 3, 0, 0, false);
    all.emplace_back(Interval::whole_line(Decay::exponential), 4, 0, 0, false);
    return all;
}

} // namespace

TEST_CASE("an interval is the image of the fraction u: abscissa, distances and slope")
{
    const WorkingPrecision precision(bits);
    for (auto [interval, kind, a, b, mirrored] : intervals()) {
        CAPTURE(interval.to_string());
        interval.prepare();
        CHECK(interval.is_proper());
        CHECK(interval.is_finite() == (kind == 0));
        for (const auto& spot : {Spot(Rational(1, 5), Rational(2, 3), 0, 0), Spot(Rational(1, 1000), Rational(1, 900), 0, 0),
                                 Spot(Rational(3, 10), Rational(0), 0, 0), Spot(Rational(4, 5), Rational(-1, 7), 0, 2)}) {
            const auto expected = truth(kind, a.ball(), b.ball(), mirrored, spot);
            const Place<ComplexBall> place(spot.u, spot.log_u, spot.log_r);
            const auto found = interval.at(place.left(), place.right());
            for (const auto& [x, y] : {std::pair(found.x, expected.x),
                                       {found.left, expected.left},
                                       {found.right, expected.right},
                                       {found.slope, expected.slope}}) {
                CHECK(holds(x.value(), y));
                if (kind != 2 || arb_gt(touchstone::abs(spot.u).get(), Ball(Rational(1, 2)).get())) CHECK(accuracy(x.value()) > bits - 60);
            }
            if (!arb_is_zero(acb_imagref(spot.u.get()))) continue;
            const Ball u = spot.u.real(), r = Ball(1) - u;
            const Place<Ball> node(u, log(u), log(r));
            const auto real = interval.at(node.left(), node.right());
            for (const auto& [x, y] :
                 {std::pair(real.x, expected.x), {real.left, expected.left}, {real.right, expected.right}, {real.slope, expected.slope}}) {
                CHECK(holds(x.value(), y));
                CHECK(accuracy(x.value()) > bits - 60);
            }
            const auto from_middle = interval.at(EndpointNumber<Ball>(u), EndpointNumber<Ball>(r));
            CHECK(holds(from_middle.x.value(), expected.x));
            CHECK(accuracy(from_middle.x.value()) > bits - 60);
        }
        for (const double u : {0.125, 0.5, 0.875}) {
            const Spot spot(exact_rational(u), 0, 0, 0);
            const auto expected = truth(kind, a.ball(), b.ball(), mirrored, spot);
            const auto near = [](double x, const ComplexBall& y) {
                CHECK(x == doctest::Approx(arf_get_d(arb_midref(y.real().get()), ARF_RND_NEAR)).epsilon(1e-13).scale(1e-3));
            };
            const auto at = [](const Endpoint& e) { return arf_get_d(arb_midref(e.ball().get()), ARF_RND_NEAR); };
            const auto found = interval.at_real<double>(at(a), at(b), u, 1 - u);
            near(found.x, expected.x);
            near(found.left, expected.left);
            near(found.right, expected.right);
            near(found.slope, expected.slope);
        }
        const auto tiny = interval.at_real<double>(0, 1, 0x1p-80, 1); // next to an end the distance keeps its digits
        if (kind != 0 && kind < 3) CHECK((mirrored ? tiny.right : tiny.left) == 0x1p-80);
    }
}

TEST_CASE("on a half-line the distance is u times what has no zero, on a box about the end too")
{
    const WorkingPrecision precision(bits);
    Interval ray = Interval::right_half_line(0, Decay::exponential);
    ray.prepare();
    for (const Rational& half : {Rational(1, 1000), Rational(1, 10), Rational(1, 3), Rational(69, 200)}) {
        CAPTURE(half.get_str());
        ComplexBall box(0);
        arb_add_error(acb_realref(box.get()), Ball(half).get());
        arb_add_error(acb_imagref(box.get()), Ball(half).get());
        const Place<ComplexBall> place(box, ComplexBall::indeterminate());
        const auto left = ray.at(place.left(), place.right()).left;
        CHECK(left.left().power == Exponent(1));
        REQUIRE(left.factor().is_finite());
        CHECK(arb_lt(Ball::exactly(left.factor().real().radius_bound()).get(), (Ball(half) * Ball(Rational(3, 2))).get()));
        for (const auto& [re, im] : {std::pair(half, half),
                                     {-half, half},
                                     {half, Rational(0)},
                                     {-half, -half},
                                     {Rational(half / 3), -half},
                                     {Rational(0), half}}) {
            const ComplexBall u{Ball(re), Ball(im)};
            CHECK(holds(left.factor(), -log(ComplexBall(1) - u) / u));
        }
    }
    // along the real line it is widest
    for (const Rational& half : {Rational(1, 1000), Rational(1, 10), Rational(49, 100)}) {
        ComplexBall box(0);
        arb_add_error(acb_realref(box.get()), Ball(half).get());
        const Place<ComplexBall> place(box, ComplexBall::indeterminate());
        const auto left = ray.at(place.left(), place.right()).left;
        REQUIRE(left.factor().is_finite());
        for (const Rational& u : {half, Rational(-half)})
            CHECK(holds(left.factor(), -log(ComplexBall(1) - ComplexBall(u)) / ComplexBall(u)));
    }
    // where log r is kept it is the symbol, and a number that does not vanish at the end has no zero to keep
    const Place<ComplexBall> kept(ComplexBall(Ball(Rational(1, 4)), Ball(Rational(1, 9))));
    const auto symbol = ray.at(kept.left(), kept.right()).left;
    REQUIRE(symbol.logarithms().size() == 1);
    CHECK(symbol.logarithms().front().right == 1);
    const ComplexBall quarter(Rational(1, 4));
    const auto plain = ray.at(Number(quarter), Number(ComplexBall(1) - quarter)).left;
    CHECK(plain.is_plain());
    CHECK(holds(plain.value(), -log(ComplexBall(1) - quarter)));
    CHECK(accuracy(plain.value()) > bits - 20);
}

TEST_CASE("an interval says which it is, and is proper where its ends are numbers in order")
{
    const auto proper = [](Interval i) {
        i.prepare();
        return i.is_proper();
    };
    const Endpoint nowhere(Ball::indeterminate()), about([] { return pi<Ball>(); });
    CHECK(proper(Interval::finite(0, 1)));
    CHECK(proper(Interval::finite(Rational(-1, 3), about)));
    CHECK_FALSE(proper(Interval::finite(1, 0)));
    CHECK_FALSE(proper(Interval::finite(1, 1)));
    CHECK_FALSE(proper(Interval::finite(about, about)));
    CHECK_FALSE(proper(Interval::finite(nowhere, 1)));
    CHECK_FALSE(proper(Interval::finite(0, nowhere)));
    CHECK(proper(Interval::right_half_line(about, Decay::algebraic)));
    CHECK_FALSE(proper(Interval::right_half_line(nowhere, Decay::exponential)));
    CHECK_FALSE(proper(Interval::left_half_line(nowhere, Decay::exponential)));
    CHECK(proper(Interval::whole_line(Decay::exponential)));
    CHECK(Interval::finite(0, Rational(7, 3)).to_string() == "[0, 7/3]");
    CHECK(Interval::finite(Rational(-1, 2), Ball(3)).to_string().starts_with("[-1/2, 3.00000"));
    CHECK(Interval::right_half_line(2, Decay::algebraic).to_string() == "[2, oo) algebraic");
    CHECK(Interval::right_half_line(2, Decay::exponential).to_string() == "[2, oo) exponential");
    CHECK(Interval::left_half_line(-1, Decay::algebraic).to_string() == "(-oo, -1] algebraic");
    CHECK(Interval::left_half_line(-1, Decay::exponential).to_string() == "(-oo, -1] exponential");
    CHECK(Interval::whole_line(Decay::algebraic).to_string() == "(-oo, oo) algebraic");
    CHECK(Interval::whole_line(Decay::exponential).to_string() == "(-oo, oo) exponential");
    // the width of exact ends is exact to the last bit at work
    const WorkingPrecision precision(bits);
    Interval thin = Interval::finite(Rational(1, 3), Rational(Rational(1, 3) + Rational(1, 1L << 60)));
    thin.prepare();
    const auto slope = thin.at(EndpointNumber<Ball>(Ball(Rational(1, 2))), EndpointNumber<Ball>(Ball(Rational(1, 2)))).slope.value();
    CHECK(slope.contains(Rational(1, 1L << 60)));
    CHECK(slope.relative_bits() > bits - 4);
}

TEST_CASE("the complete elliptic integrals by means are those of the library of special functions")
{
    const auto k_of = [](const ComplexBall& m) { return elliptic_k(m, 700); };
    const auto e_of = [](const ComplexBall& m) { return elliptic_e(m, 700); };
    for (const auto& [re, im] : {std::pair(Rational(1, 2), Rational(0)),
                                 {Rational(3), Rational(0)},
                                 {Rational(1, 1000000), Rational(0)},
                                 {Rational(-1), Rational(1, 5)},
                                 {Rational(-100), Rational(-1)},
                                 {Rational(1, 3), Rational(-4)},
                                 {Rational(2, 3), Rational(1, 100)},
                                 {Rational(1000), Rational(5)}})
        for (const slong digits : {10, 20, 53, 130, 500}) {
            CAPTURE(re.get_str());
            CAPTURE(digits);
            const WorkingPrecision precise(700);
            const ComplexBall v{Ball(re), Ball(im)}, k = k_of(ComplexBall(1) - v), e = e_of(ComplexBall(1) - v);
            const WorkingPrecision working(digits);
            const auto found = elliptic_of_complement(v);
            if (digits >= 53) {
                CHECK(found.k.is_finite());
                CHECK(found.e.is_finite());
                CHECK(accuracy(found.k) > digits - 20);
                CHECK(accuracy(found.e) > digits - 36);
            }
            CHECK(found.k.overlaps(k));
            CHECK(found.e.overlaps(e));
            if (im != 0) continue;
            const auto real = elliptic_of_complement(v.real());
            CHECK(real.k.overlaps(k.real()));
            CHECK(real.e.overlaps(e.real()));
            if (digits >= 53) {
                CHECK(real.k.relative_bits() > digits - 20);
                CHECK(real.e.relative_bits() > digits - 30);
            }
        }
    // boxes, narrow and wide
    for (const auto& [re, im] :
         {std::pair(Rational(1), Rational(0)), {Rational(1, 2), Rational(3)}, {Rational(-1), Rational(2)}, {Rational(40), Rational(1)}})
        for (const Rational& half : {Rational(1, 1000), Rational(1, 10), Rational(2, 5), Rational(4, 5)})
            for (const slong digits : {20, 80}) {
                const WorkingPrecision precise(700);
                ComplexBall box{Ball(re), Ball(im)};
                arb_add_error(acb_realref(box.get()), Ball(half).get());
                arb_add_error(acb_imagref(box.get()), Ball(half).get());
                const auto found = [&] {
                    const WorkingPrecision working(digits);
                    return elliptic_of_complement(box);
                }();
                if (half < Rational(1, 50)) CHECK(found.k.is_finite());
                for (const auto& [x, y] : {std::pair(half, half), {-half, half}, {half, -half}, {-half, -half}, {Rational(0), half}}) {
                    const ComplexBall v{Ball(Rational(re + x)), Ball(Rational(im + y))};
                    CHECK(found.k.overlaps(k_of(ComplexBall(1) - v)));
                    CHECK(found.e.overlaps(e_of(ComplexBall(1) - v)));
                }
            }
    CHECK_FALSE(elliptic_of_complement(ComplexBall(-1)).k.is_finite()); // the cut
    CHECK_FALSE(elliptic_of_complement(Ball(-1)).k.is_finite());
    CHECK_FALSE(elliptic_of_complement(Ball(0)).k.is_finite());
}
