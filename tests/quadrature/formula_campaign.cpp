// SPDX-License-Identifier: MIT
// Random formulas with integrals known in closed form: no enclosure may miss its value. TOUCHSTONE_COUNT=n sets how many (default 10000),
// TOUCHSTONE_SEED=n which, TOUCHSTONE_SECONDS=s after how much processor time to stop. ctest -R formula_campaign -V
#include "touchstone/quadrature/path.hpp"

#include <doctest/doctest.h>

#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <map>
#include <random>
#include <string>

using namespace touchstone;
using namespace touchstone::quadrature;

namespace {

struct Case {
    std::string family, formula, from, to, value, pole = {};
    std::vector<std::string> path = {}; ///< between the ends
    Parameter a = {};                   ///< the parameter a, if its radius is not 0: then the value has an a in it too
};

class Draw {
public:
    explicit Draw(unsigned long seed)
        : random_(seed)
    {
    }
    long between(long low, long high) { return low + static_cast<long>(random_() % static_cast<unsigned long>(high - low + 1)); }
    static std::string text(const Rational& r) { return std::string("(").append(r.get_str()).append(")"); }
    static Rational quotient(long n, long d)
    {
        Rational r(n, d);
        r.canonicalize();
        return r;
    }
    /// Above -1, often near it.
    Rational exponent() { return between(0, 2) ? quotient(between(-95, 300), 100) : -1 + quotient(1, between(20, 5000)); }
    Rational positive() { return quotient(between(1, 400), between(20, 100)); }
    /// 10^-6 to 10
    Rational distance() { return between(1, 99) * power(Rational(10), between(-7, -1)); }
    Rational fraction() { return quotient(between(1, 999), 1000); }
    Case next();

private:
    Case at_the_ends(long family);
    Case beside(long family);
    Case infinite(long family);
    Case not_by_one_rule(long family);
    Case in_the_plane(long family);
    Case of_several_kinds(long family);
    Case on_half_lines(long family);
    Case even_or_a_power_of_two_factors(long family);
    Case elliptic(long family);
    std::mt19937_64 random_;
};

Case Draw::at_the_ends(long family)
{
    const Rational p = exponent(), q = exponent(), c = fraction();
    const std::string P = text(p), Q = text(q), C = text(c), P1 = text(Rational(p + 1)), Q1 = text(Rational(q + 1));
    switch (family) {
    case 0: return {"beta", "x^" + P + "*(1-x)^" + Q, "0", "1", "gamma" + P1 + "*gamma" + Q1 + "*rgamma" + text(Rational(p + q + 2))};
    case 1: {
        const long k = between(1, 3);
        return {"power and logarithm", "x^" + P + "*log(1/x)^" + std::to_string(k), "0", "1",
                "gamma(" + std::to_string(k + 1) + ")/" + P1 + "^" + std::to_string(k + 1)};
    }
    case 2: return {"kink", "abs(x-" + C + ")^" + P, "0", "1", "(" + C + "^" + P1 + "+" + text(Rational(1 - c)) + "^" + P1 + ")/" + P1};
    case 3:
        return {"sine", "sin(pi*x)^" + P, "0", "1",
                "gamma" + text(Rational((p + 1) / 2)) + "/(sqrt(pi)*gamma" + text(Rational(p / 2 + 1)) + ")"};
    case 4: {
        const Rational t = quotient(between(-98, 98), 100);
        return {"tangent", "tan(x)^" + text(t), "0", "pi/2", "pi/(2*cos(pi*" + text(Rational(t / 2)) + "))"};
    }
    case 5: return {"circle", "(1-x^2)^" + P, "-1", "1", "sqrt(pi)*gamma" + P1 + "/gamma" + text(Rational(p + Rational(3, 2)))};
    default: return {"logarithm", "log(1/x)^" + P, "0", "1", "gamma" + P1};
    }
}

Case Draw::beside(long family)
{
    const Rational d = distance(), m = fraction(), a = positive();
    const std::string D = text(d), M = text(m), A = text(a);
    switch (family) {
    case 0:
        return {"poles beside", "1/((x-" + M + ")^2+" + D + "^2)", "0", "1",
                "(atan(" + M + "/" + D + ")+atan(" + text(Rational(1 - m)) + "/" + D + "))/" + D};
    case 1:
        return {"essential singularity beside", "exp(-1/(x+" + D + "))/(x+" + D + ")^2", "0", "1",
                "exp(-1/(1+" + D + "))-exp(-1/" + D + ")"};
    case 2: {
        const std::string W = std::to_string(between(1, 3000));
        return {"oscillation", "cos(" + W + "*x)", "0", "1", "sin(" + W + ")/" + W};
    }
    case 3: return {"composition", A + "*exp(" + A + "*x)*cos(exp(" + A + "*x))", "0", "1", "sin(exp(" + A + "))-sin(1)"};
    case 4: {
        const long k = between(2, 12);
        return {"steps", "floor(" + std::to_string(k) + "*x)", "0", "1", text(quotient(k - 1, 2))};
    }
    case 5: return {"logarithm beside", "log(x+" + D + ")", "0", "1", "(1+" + D + ")*log(1+" + D + ")-" + D + "*log(" + D + ")-1"};
    default: return {"branch point beside", "sqrt(x+" + D + ")", "0", "1", "2/3*((1+" + D + ")^(3/2)-" + D + "^(3/2))"};
    }
}

Case Draw::infinite(long family)
{
    const Rational s = exponent(), a = positive(), b = positive();
    const std::string S = text(s), S1 = text(Rational(s + 1)), A = text(a), B = text(b);
    switch (family) {
    case 0: return {"gamma", "x^" + S + "*exp(-" + A + "*x)", "0", "inf", "gamma" + S1 + "/" + A + "^" + S1};
    case 1: return {"damped cosine", "exp(-" + A + "*x)*cos(" + B + "*x)", "0", "inf", A + "/(" + A + "^2+" + B + "^2)"};
    case 2: {
        const std::string C = text(Rational(quotient(between(-30, 30), 10)));
        return {"gaussian", "exp(-" + A + "*x^2+" + C + "*x)", "-inf", "inf", "sqrt(pi/" + A + ")*exp(" + C + "^2/(4*" + A + "))"};
    }
    case 3: return {"removable zero", "(1-exp(-" + A + "*x))/x*exp(-" + B + "*x)", "0", "inf", "log((" + A + "+" + B + ")/" + B + ")"};
    case 4:
        return {"algebraic tail", "x^" + S + "/(1+x)^" + text(Rational(s + 1 + b)), "0", "inf",
                "gamma" + S1 + "*gamma" + B + "/gamma" + text(Rational(s + 1 + b))};
    case 5: return {"sech", "sech(" + A + "*x)", "-inf", "inf", "pi/" + A};
    default: return {"lorentzian", "1/(x^2+" + A + "^2)", "-inf", "inf", "pi/" + A};
    }
}

/// Turned paths, changes of variable, kinks without a name, principal values.
Case Draw::not_by_one_rule(long family)
{
    const Rational a = positive(), b = positive(), c = fraction();
    const std::string A = text(a), B = text(b), C = text(c);
    switch (family) {
    case 0: {
        const std::string S = text(quotient(between(1, 99), 100));
        return {"cosine tail", "cos(" + A + "*x)*x^(" + S + "-1)", "0", "inf", A + "^(-" + S + ")*gamma" + S + "*cos(pi*" + S + "/2)"};
    }
    case 1: return {"sine tail", "x*sin(" + A + "*x)/(x^2+" + B + "^2)", "0", "inf", "pi/2*exp(-" + A + "*" + B + ")"};
    case 2: return {"squared sine tail", "sin(" + A + "*x)^2/x^2", "0", "inf", "pi*" + A + "/2"};
    case 3: return {"Bessel tail", "besselj(" + std::to_string(between(0, 3)) + "," + A + "*x)", "0", "inf", "1/" + A};
    case 4: return {"essential singularity at an end", "exp(-" + A + "/x)/x^2", "0", "1", "exp(-" + A + ")/" + A};
    case 5: {
        const std::string K = text(Rational(1 + c * Rational(17, 10)));
        return {"kink without a name", "abs(exp(x)-" + K + ")", "0", "1", "2*" + K + "*log(" + K + ")-3*" + K + "+1+exp(1)"};
    }
    default:
        return {"principal value",
                "1/((x-" + C + ")*(x+" + A + "))",
                "0",
                "1",
                "(log(" + text(Rational((1 - c) / c)) + ")-log(" + text(Rational((1 + a) / a)) + "))/" + text(Rational(c + a)),
                C};
    }
}

/// Complex values and paths.
Case Draw::in_the_plane(long family)
{
    const Rational p = exponent(), q = exponent(), a = positive(), b = positive();
    const std::string P = text(p), A = text(a), B = text(b), W = std::to_string(between(1, 500));
    switch (family) {
    case 0: {
        // the strip is as low as the imaginary part of an exponent is large next to its distance from -1
        const auto turn = [&](const Rational& exponent) { return text(Rational((exponent + 1) * between(1, 30) / 10)); };
        const std::string U = "(" + P + "+i*" + turn(p) + ")", V = "(" + text(q) + "-i*" + turn(q) + ")";
        return {"complex beta", "x^" + U + "*(1-x)^" + V, "0", "1", "gamma(1+" + U + ")*gamma(1+" + V + ")/gamma(2+" + U + "+" + V + ")"};
    }
    case 1: {
        const std::string Z = "(" + A + (between(0, 1) ? "+" : "-") + "i*" + B + ")";
        return {"power on a segment", "x^" + P, "0", Z, Z + "^(1+" + P + ")/(1+" + P + ")"};
    }
    case 2: { // 10^-6 from a side at the nearest
        const std::string Z = "(1-" + text(distance() / 5) + "+i*" + text(fraction() - Rational(1, 2)) + ")";
        return {"around a pole", "1/(x-" + Z + ")", "-1-i", "-1-i", "2*pi*i", "", {"1-i", "1+i", "-1+i"}};
    }
    case 3:
        return {"around an essential singularity", "exp(" + A + "/x)", "-1-i", "-1-i", "2*pi*i*" + A, "", {"1-i", "1+i", "-1+i"}};
    case 4: return {"complex oscillation", "exp(i*" + W + "*x)", "0", "1", "(exp(i*" + W + ")-1)/(i*" + W + ")"};
    case 5: {
        const std::string S = text(quotient(between(1, 99), 100)), sign = between(0, 1) ? "" : "-";
        return {"complex tail", "exp(" + sign + "i*" + A + "*x)*x^(" + S + "-1)", "0", "inf",
                A + "^(-" + S + ")*gamma" + S + "*exp(" + sign + "i*pi*" + S + "/2)"};
    }
    default: return {"steepest descent", "exp(i*" + A + "*x^2)", "0", "(1+i)*inf", "sqrt(pi/" + A + ")/2*exp(i*pi/4)"};
    }
}

/// Principal values in the plane, frequencies of both signs, parameters that are balls, inner integrals.
Case Draw::of_several_kinds(long family)
{
    const Rational a = positive(), b = positive(), c = fraction() / 2, d = Rational(1, 2) + fraction() / 2;
    const std::string A = text(a), B = text(b), C = text(c), D = text(d);
    const Parameter ball{a, a * power(Rational(10), between(-40, -5))};
    switch (family) {
    case 0: return {"principal value of a wave", "exp(i*" + A + "*(x-" + C + "))/(x-" + C + ")", "-inf", "inf", "i*pi", C};
    case 1: {
        const auto jump = [](const std::string& pole) { return "log((1-" + pole + ")/" + pole + ")"; };
        return {"two principal values",
                "1/((x-" + C + ")*(x-" + D + "))",
                "0",
                "1",
                "(" + jump(D) + "-" + jump(C) + ")/(" + D + "-" + C + ")",
                C + "," + D};
    }
    case 2: {
        const bool high = a > b;
        return {"two frequencies", "sin(" + A + "*x)*cos(" + B + "*x)/x", "0", "inf", a == b ? "pi/4" : high ? "pi/2" : "0"};
    }
    case 3: return {"ball for an exponent", "x^(a-1)*log(1/x)^" + std::to_string(between(0, 1)) + "*a^0", "0", "1", "", "", {}, ball};
    case 4: return {"ball for a rate", "exp(-a*x)*cos(" + B + "*x)", "0", "inf", "a/(a^2+" + B + "^2)", "", {}, ball};
    case 5:
        return {"inner integral", "integral(exp(-" + A + "*x*y),y,0,1)", "0", "1",
                "(log(" + A + ")-digamma(1)-ei(-" + A + "))/" + A};
    default:
        return {"inner integral to x", "integral(cos(" + A + "*x+" + B + "*y),y,0,x)", "0", "1",
                "((1-cos(" + A + "+" + B + "))/(" + A + "+" + B + ")-(1-cos(" + A + "))/" + A + ")/" + B};
    }
}

/// Waves and exponentials of a power of x, Bessel functions under an exponential, inverse hyperbolic functions.
Case Draw::on_half_lines(long family)
{
    const Rational a = positive(), b = positive(), m = 1 + quotient(between(-3, 8), 4);
    const std::string A = text(a), B = text(b), M = text(m);
    switch (family) {
    case 0: {
        const std::string S = text(quotient(between(1, 99), 100));
        return {"wave of a power", "cos(" + A + "*x^" + M + ")*x^(" + S + "*" + M + "-1)", "0", "inf",
                "gamma" + S + "*cos(pi*" + S + "/2)/(" + M + "*" + A + "^" + S + ")"};
    }
    case 1: {
        const std::string S = text(Rational(exponent() + 1));
        return {"exponential of a power", "exp(-" + A + "*x^" + M + ")*x^(" + S + "*" + M + "-1)", "0", "inf",
                "gamma" + S + "/(" + M + "*" + A + "^" + S + ")"};
    }
    case 2: {
        const std::string N = std::to_string(between(0, 4)), R = "sqrt(" + A + "^2+" + B + "^2)";
        return {"Bessel function under an exponential", "besselj(" + N + "," + B + "*x)*exp(-" + A + "*x)", "0", "inf",
                "((" + R + "-" + A + ")/" + B + ")^" + N + "/" + R};
    }
    case 3: {
        const std::string N = std::to_string(between(0, 4)), C = text(Rational(a + b)), R = "sqrt(" + C + "^2-" + B + "^2)";
        return {"modified Bessel function under an exponential", "besseli(" + N + "," + B + "*x)*exp(-" + C + "*x)", "0", "inf",
                "((" + C + "-" + R + ")/" + B + ")^" + N + "/" + R};
    }
    case 4: return {"inverse hyperbolic cosine", "acosh(x/" + A + ")/x^2", A, "inf", "pi/(2*" + A + ")"};
    case 5: return {"inverse hyperbolic sine", "asinh(" + B + "*x)/x^2", "1", "inf", "asinh(" + B + ")+" + B + "*asinh(1/" + B + ")"};
    default: return {"quadratic phase", "cos(" + A + "*x^2+" + B + ")", "-inf", "inf", "sqrt(pi/" + A + ")*cos(pi/4+" + B + ")"};
    }
}

/// Even about 0, on one side of it and on both; powers of a product and of a quotient.
Case Draw::even_or_a_power_of_two_factors(long family)
{
    const Rational a = positive(), b = positive(), e = exponent(), half(1, 2);
    const Rational q = between(0, 1) ? quotient(between(-99, 99), 100) : between(0, 1) ? half : Rational(-half);
    const std::string A = text(a), B = text(b), D = text(distance()), E = text(e), Q = text(q);
    const auto half_beta = [](const Rational& s, const Rational& t) {
        return "gamma" + text(s) + "*gamma" + text(t) + "/(2*gamma" + text(Rational(s + t)) + ")";
    };
    switch (family) {
    case 0:
        return {"quarter of a circle", "sqrt(" + A + "^2-x^2)*cos(" + B + "*x)", "0", A,
                "pi*" + A + "/(2*" + B + ")*besselj(1," + A + "*" + B + ")"};
    case 1: return {"weight left of 0", "cos(" + B + "*x)/sqrt(" + A + "^2-x^2)", "-" + A, "0", "pi/2*besselj(0," + A + "*" + B + ")"};
    case 2: return {"even poles beside", "1/((x^2+" + D + "^2)*sqrt(1-x^2))", "0", "1", "pi/(2*" + D + "*sqrt(1+" + D + "^2))"};
    case 3: return {"power of a tangent", "tan(x)^" + Q, "0", "pi/2", "pi/(2*cos(pi*" + Q + "/2))"};
    case 4: return {"power of a quotient", "(x/(1-x^2))^" + Q, "0", "1", half_beta(Rational((q + 1) / 2), Rational(1 - q))};
    case 5: return {"power of a product", "(x*(1-x^2))^" + E, "0", "1", half_beta(Rational((e + 1) / 2), Rational(e + 1))};
    default:
        return {"even on both sides", "x*sin(" + B + "*x)", "-" + A, A,
                "2*(sin(" + A + "*" + B + ")-" + A + "*" + B + "*cos(" + A + "*" + B + "))/" + B + "^2"};
    }
}

/// Moments of K and E: n^2 K_n = (n - 1)^2 K_(n-2) + 1, (n + 2) E_n = K_n + 1.
Case Draw::elliptic(long family)
{
    const long n = 2 * between(0, 6) + 1;
    Rational k = 1;
    for (long j = 3; j <= n; j += 2) k = (k * (j - 1) * (j - 1) + 1) / (j * j);
    const Rational b = positive(), e = (k + 1) / (n + 2);
    const std::string B = text(b), power = "^" + std::to_string(n), half = "^" + std::to_string((n - 1) / 2), share = "(x/" + B + ")";
    const std::string rest = "((" + B + "-x)/" + B + ")", beside = "(1-" + share + "^2)";
    switch (family) {
    case 0: return {"moment of K", share + power + "*ellipk(" + share + "^2)", "0", B, text(b * k)};
    case 1: return {"moment of E", share + power + "*ellipe(" + share + "^2)", "0", B, text(b * e)};
    case 2: return {"moment of K, mirrored", rest + power + "*ellipk(" + rest + "^2)", "0", B, text(b * k)};
    case 3: return {"moment of E, to the left", "(-" + share + ")" + power + "*ellipe(" + share + "^2)", "-" + B, "0", text(b * e)};
    case 4: return {"moment in m", "x" + half + "*(ellipk(x)-ellipe(x))", "0", "1", text(2 * (k - e))};
    case 5: return {"complementary K", share + "*" + beside + half + "*ellipk(" + beside + ")", "0", B, text(b * k)};
    default: return {"complementary E", share + "*" + beside + half + "*ellipe(" + beside + ")", "0", B, text(b * e)};
    }
}

Case Draw::next()
{
    const long kind = between(0, 8), family = between(0, 6);
    Case c = kind == 0   ? at_the_ends(family)
             : kind == 1 ? beside(family)
             : kind == 2 ? infinite(family)
             : kind == 3 ? not_by_one_rule(family)
             : kind == 4 ? in_the_plane(family)
             : kind == 5 ? of_several_kinds(family)
             : kind == 6 ? on_half_lines(family)
             : kind == 7 ? elliptic(family)
                         : even_or_a_power_of_two_factors(family);
    if (c.value.empty()) c.value = c.formula.find(")^0") != std::string::npos ? "1/a" : "1/a^2";
    return c;
}

/// The closed form, at one end of its parameter's ball.
ComplexBall closed_form(const Case& c, const Rational& a)
{
    Parameters parameters;
    if (c.a.radius != 0) parameters["a"] = {a, 0};
    return PlainFormula(parse_expression(c.value, parameters)).at(ComplexBall(0));
}

Integral computed(const Case& c, const IntegralOptions& options)
{
    Parameters parameters;
    if (c.a.radius != 0) parameters["a"] = c.a;
    std::vector<Vertex> path{parse_vertex(c.from)};
    for (const std::string& v : c.path) path.push_back(parse_vertex(v));
    path.push_back(parse_vertex(c.to));
    return integrate_along(parse_expression(c.formula, parameters), path, options);
}

} // namespace

TEST_CASE("random formulas: no enclosure misses the closed form")
{
    const char* given = std::getenv("TOUCHSTONE_SEED");
    const char* asked = std::getenv("TOUCHSTONE_COUNT");
    const unsigned long seed = given ? std::strtoul(given, nullptr, 10) : 20261122;
    const long count = asked ? std::strtol(asked, nullptr, 10) : 10000;
    MESSAGE("seed " << seed << ", " << count << " integrals");
    const char* limit = std::getenv("TOUCHSTONE_SECONDS");
    const double seconds = limit ? std::strtod(limit, nullptr) : 1e9;
    const std::clock_t start = std::clock();
    Draw draw(seed);
    struct Family {
        long certified = 0, refused = 0;
        double seconds = 0; // of the processor
    };
    std::map<std::string, Family> families;
    for (long i = 0; i < count && static_cast<double>(std::clock() - start) < seconds * CLOCKS_PER_SEC; ++i) {
        constexpr long now_and_then = 1000;
        if (i > 0 && i % now_and_then == 0) std::fprintf(stderr, "%ld integrals, none wrong\n", i);
        const Case c = draw.next();
        CAPTURE(seed);
        CAPTURE(i);
        CAPTURE(c.formula);
        IntegralOptions options;
        options.digits = draw.between(0, 9) ? draw.between(3, 40) : draw.between(41, 100);
        CAPTURE(options.digits);
        for (std::size_t at = 0; at < c.pole.size();) {
            const std::size_t comma = std::min(c.pole.find(',', at), c.pole.size());
            options.principal_value.push_back(parse_limit(c.pole.substr(at, comma - at)));
            at = comma + 1;
        }
        const std::clock_t begun = std::clock();
        const Integral result = computed(c, options);
        auto& [certified, refused, spent] = families[c.family];
        spent += static_cast<double>(std::clock() - begun) / CLOCKS_PER_SEC;
        const bool served =
            result.status == Status::certified || (c.a.radius != 0 && result.digits > 0) || (c.value == "0" && result.value.is_finite());
        (served ? certified : refused) += 1;
        if (!result.value.is_finite()) {
            MESSAGE(c.formula << " from " << c.from << " to " << c.to << ": " << result.reason);
            continue;
        }
        const WorkingPrecision precision(bits_for_digits(options.digits) + 400);
        const ComplexBall value(result.value, result.imaginary);
        for (const Rational& a : {Rational(c.a.middle - c.a.radius), Rational(c.a.middle + c.a.radius)}) {
            const ComplexBall exact = closed_form(c, a);
            REQUIRE(exact.is_finite());
            REQUIRE_MESSAGE(acb_overlaps(value.get(), exact.get()), result.value.to_string(20), " + i ", result.imaginary.to_string(20),
                            " is not ", exact.real().to_string(20), " + i ", exact.imag().to_string(20));
        }
        if (result.status == Status::certified)
            REQUIRE(acb_rel_accuracy_bits(value.get()) >= static_cast<slong>(3.32 * static_cast<double>(options.digits)));
    }
    long all = 0, missing = 0;
    for (const auto& [name, n] : families) {
        std::printf("%-30s %6ld certified %5ld refused %8.1f s\n", name.c_str(), n.certified, n.refused, n.seconds);
        all += n.certified + n.refused;
        missing += n.refused;
    }
    std::printf("%ld integrals, %ld certified, %ld refused, none wrong\n", all, all - missing, missing);
    CHECK(missing * 20 <= all);
}
