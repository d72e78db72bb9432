// SPDX-License-Identifier: MIT
// Complex formulas, paths in the plane, parameters that are balls, inner integrals: against closed forms, and what must be refused.
#include "touchstone/quadrature/path.hpp"

#include <doctest/doctest.h>

#include <array>

using namespace touchstone;
using namespace touchstone::quadrature;

namespace {

ComplexBall constant(const char* text)
{
    const WorkingPrecision precision(200);
    return PlainFormula(parse_expression(text)).at(ComplexBall(0));
}

Integral along(const char* formula, const std::vector<const char*>& path, long digits = 25, const Parameters& parameters = {})
{
    std::vector<Vertex> vertices;
    for (const char* v : path) vertices.push_back(parse_vertex(v, parameters));
    IntegralOptions options;
    options.digits = digits;
    return integrate_along(parse_expression(formula, parameters), vertices, options);
}

void is_value(const Integral& i, const char* value)
{
    CHECK_MESSAGE(i.status == Status::certified, i.reason);
    const ComplexBall got(i.value, i.imaginary), truth = constant(value);
    CHECK_MESSAGE(acb_overlaps(got.get(), truth.get()), value, ": ", i.value.to_string(20), " + i ", i.imaginary.to_string(20));
    CHECK(acb_rel_accuracy_bits(got.get()) >= 80);
}

} // namespace

TEST_CASE("complex formulas on real ranges")
{
    const struct {
        const char *formula, *from, *to, *value;
    } cases[] = {{"exp(i*x)", "0", "1", "(exp(i)-1)/i"},
                 {"x^(i-1/2)", "0", "1", "1/(1/2+i)"},
                 {"x^(2+3*i)*(1-x)^(-1/3+i)", "0", "1", "gamma(3+3*i)*gamma(2/3+i)/gamma(11/3+4*i)"},
                 {"(exp(i*x)-1-i*x)/x^(5/2)", "0", "1", nullptr},
                 {"exp(-(1+i)*x)/sqrt(x)", "0", "inf", "sqrt(pi/(1+i))"},
                 {"exp(-(1+i)*x^2)", "-inf", "inf", "sqrt(pi/(1+i))"},
                 {"exp(i*x)/sqrt(x)", "0", "inf", "sqrt(pi)*exp(i*pi/4)"},
                 {"exp(-i*x)/sqrt(x)", "0", "inf", "sqrt(pi)*exp(-i*pi/4)"},
                 {"exp(i*x)/(1+x^2)", "-inf", "inf", "pi/e"},
                 {"1/(x-i/1000)", "-1", "1", "log(1-i/1000)-log(-1-i/1000)"},
                 {"abs(1+i*x)^2", "0", "1", "4/3"},
                 {"re(exp(i*x))^2+im(exp(i*x))^2", "0", "1", "1"},
                 {"conj(exp(i*x))", "0", "1", "(exp(-i)-1)/(-i)"},
                 {"(1+i)^x", "0", "1", "i/log(1+i)"}};
    for (const auto& c : cases) {
        CAPTURE(c.formula);
        const Integral i = along(c.formula, {c.from, c.to});
        if (c.value)
            is_value(i, c.value);
        else
            CHECK(i.status == Status::certified);
    }
    // the principal value of exp(ix)/x is i pi: both parts are counted
    IntegralOptions options;
    options.principal_value = {parse_limit("0")};
    is_value(integrate(parse_expression("exp(i*x)/x"), parse_limit("-inf"), parse_limit("inf"), options), "i*pi");
}

TEST_CASE("huge next to the interval: 700! to 20 digits")
{
    const Integral i = along("x^700*exp(-x)", {"0", "inf"}, 20);
    CHECK_MESSAGE(i.status == Status::certified, i.reason);
    CHECK(i.value.overlaps(constant("gamma(701)").real()));
}

TEST_CASE("paths in the plane")
{
    const struct {
        const char* formula;
        std::vector<const char*> path;
        const char* value;
    } cases[] = {{"1/x", {"1", "i", "-1", "-i", "1"}, "2*pi*i"},
                 {"1/x^2", {"1", "i", "-1", "-i", "1"}, nullptr}, // 0: no digit of it
                 {"conj(x)", {"1", "i", "-1", "-i", "1"}, "4*i"},
                 {"abs(x)", {"0", "1+i"}, "(1+i)/sqrt(2)"},
                 {"1/sqrt(1+x^2)", {"-i", "i"}, "i*pi"},
                 {"exp(i*x^2)", {"0", "(1+i)*inf"}, "sqrt(pi)/2*exp(i*pi/4)"},
                 {"exp(i*x^3)", {"0", "exp(i*pi/6)*inf"}, "gamma(4/3)*exp(i*pi/6)"},
                 {"exp(-x^2)", {"-inf", "-1+i", "1+i", "inf"}, "sqrt(pi)"},
                 {"exp(i*x)", {"1", "i*inf"}, "i*exp(i)"},
                 {"exp(i*x)", {"i*inf", "1"}, "-i*exp(i)"},
                 {"sqrt(x)", {"0", "i"}, "2/3*i*sqrt(i)"},
                 {"log(x)", {"0", "1+i"}, "(1+i)*(log(1+i)-1)"}};
    for (const auto& c : cases) {
        CAPTURE(c.formula);
        const Integral i = along(c.formula, c.path);
        if (c.value)
            is_value(i, c.value);
        else
            CHECK((i.status == Status::undecided && i.digits == 0 && i.value.contains_zero() && i.imaginary.contains_zero()));
    }
}

TEST_CASE("what has no value on a path is refused, and says why")
{
    const auto not_certified = [](const char* formula, const std::vector<const char*>& path) {
        const Integral i = along(formula, path);
        CAPTURE(formula);
        CHECK(i.status != Status::certified);
        CHECK(!i.reason.empty());
    };
    not_certified("log(x)", {"-1+i", "-1-i"});          // a cut
    not_certified("log(x)", {"1", "i", "-1", "-i", "1"}); // the same, met at a corner
    not_certified("sqrt(x)", {"-1", "-2"});             // along it
    not_certified("1/(x-i)^2", {"0", "2*i"});
    CHECK(along("1/(x-(1+i)/2)", {"0", "1+i"}).divergent);
    CHECK(along("1/x", {"0", "i"}).divergent);
    CHECK_THROWS_AS(along("sign(x)", {"0", "i"}), ExpressionError);
    CHECK_THROWS_AS(along("ei(x)", {"1", "i"}), ExpressionError);
    CHECK_THROWS_AS(along("besselj(i,x)", {"0", "1"}), ExpressionError);
    CHECK_THROWS_AS(along("x", {"-inf", "i*inf"}), DomainError);
    CHECK_THROWS_AS(along("x", {"0", "x"}), ExpressionError);
    for (const char* nowhere : {"0*inf", "(1-1)*inf", "(i*i+1)*inf"}) {
        try {
            along("x", {"0", nowhere});
            FAIL("a direction that is 0");
        }
        catch (const ExpressionError& e) {
            CHECK(e.column() == 1);
        }
    }
    CHECK_THROWS_AS(parse_limit("i"), ExpressionError);
}

TEST_CASE("the imaginary part of a real formula is 0 where that has a value, and none elsewhere")
{
    for (const char* formula : {"im(sqrt(x^2-1))", "im(log(-1-x))", "x+im(acos(x+3))"}) {
        CAPTURE(formula);
        CHECK(along(formula, {"0", "1"}).status != Status::certified); // with a logarithm of -1 of i*pi they would not be 0
    }
    for (const char* formula : {"im(x^2)", "im(sqrt(x))", "im(log(x))", "im(abs(x-1/2))"}) {
        CAPTURE(formula);
        const Integral i = along(formula, {"0", "1"});
        CHECK(i.status == Status::certified);
        CHECK(i.value.is_exact());
        CHECK(i.value.contains_zero());
    }
}

TEST_CASE("parameters that are balls: the integral for every number of the ball, and not much more")
{
    const Parameters parameters{{"a", {Rational(1, 2), Rational(1, 1000000)}}, {"b", {Rational(3), Rational(0)}}};
    const struct {
        const char *formula, *from, *to, *low, *high;
    } cases[] = {{"x^a", "0", "1", "1/1.500001", "1/1.499999"},
                 {"exp(-a*x)", "0", "inf", "1/0.500001", "1/0.499999"},
                 {"cos(a*x)", "0", "b", "sin(1.500003)/0.500001", "sin(1.499997)/0.499999"},
                 {"1/(x+a)", "0", "1", "log(1.500001/0.500001)", "log(1.499999/0.499999)"},
                 {"x^(-a)*(1-x)^(a-1)", "0", "1", "pi/sin(0.500000*pi)", "pi/sin(0.500001*pi)"}};
    for (const auto& c : cases) {
        CAPTURE(c.formula);
        const Integral i = along(c.formula, {c.from, c.to}, 20, parameters);
        CHECK(i.status == Status::undecided);
        CHECK(i.digits >= 4);
        CHECK(i.value.contains(constant(c.low).real()));
        CHECK(i.value.contains(constant(c.high).real()));
    }
    CHECK(along("x^b", {"0", "1"}, 20, parameters).status == Status::certified);
    CHECK(parse_parameter("1/3+/-1e-20").radius == *parse_rational("1e-20"));
    CHECK(parse_parameter("1/3+/-0").radius == 0);
    CHECK_THROWS_AS(parse_parameter("1+/-"), ExpressionError);
    CHECK_THROWS_AS(parse_parameter("1+/--1"), ExpressionError);
    CHECK_THROWS_AS(parse_expression("c*x", parameters), ExpressionError);
    for (const auto& [text, column] : {std::pair("one", "1"), {"1+/-z", "5"}, {"1/3+/--1", "7"}})
        CHECK_THROWS_WITH_AS(parse_parameter(text), doctest::Contains((std::string("column ") + column).c_str()), ExpressionError);
    is_value(along("integral(b*y,y,0,1)", {"0", "1"}, 20, parameters), "3/2"); // not the integral's own variable
    CHECK(!is_free_name("x"));
    CHECK(!is_free_name("sin"));
    CHECK(!is_free_name("1a"));
    CHECK(is_free_name("alpha_1"));
}

TEST_CASE("inner integrals")
{
    const struct {
        const char *formula, *from, *to, *value;
    } cases[] = {{"integral(x*y,y,0,x)", "0", "1", "1/8"},
                 {"integral(exp(i*x*y),y,0,1)", "0", "1", "si(1)+i*(-ci(1)+0.57721566490153286060651209008240243104215933593992)"},
                 {"re(integral(exp(i*x*y),y,0,1))", "0", "1", "si(1)"},
                 {"integral(re(exp(i*x*y)),y,0,1)", "0", "1", "si(1)"},
                 {"integral(exp(-y*(1+x^2)),y,0,inf)", "0", "1", "pi/4"},
                 {"integral(y^(-1/2)*exp(-x*y),y,0,1)", "0", "1", "2*(sqrt(pi)*erf(1)+exp(-1)-1)"},
                 {"x^(-1/2)*integral(exp(x*y),y,0,0)+1", "0", "1", "1"},
                 {"integral(x*y,y,0,x)", "0", "1+i", "(1+i)^4/8"}};
    for (const auto& c : cases) {
        CAPTURE(c.formula);
        is_value(along(c.formula, {c.from, c.to}), c.value);
    }
}

TEST_CASE("inner integrals that are not analytic in x, or not proved, have no value")
{
    // each is a continuous function of x; what is asked of it is that it be analytic, so nothing may be certified from a rule
    for (const char* formula : {"integral(abs(x-y),y,0,1)", "integral(floor(x+y),y,0,1)", "integral(sign(x-y),y,0,1)",
                                "integral(1/(x-y),y,0,1)", "integral(max(x,y),y,0,1)"}) {
        CAPTURE(formula);
        const Integral i = along(formula, {"0", "1"}, 10);
        CHECK(i.status != Status::certified);
        CHECK(i.reason.find("inner integral") != std::string::npos);
    }
    CHECK_THROWS_AS(parse_expression("integral(x,x,0,1)"), ExpressionError);
    CHECK_THROWS_AS(parse_expression("integral(y,y,0)"), ExpressionError);
    CHECK_THROWS_AS(parse_expression("integral(y,y,0,1,2)"), ExpressionError);
    CHECK_THROWS_AS(parse_expression("integral(integral(y*z,z,0,1),y,0,1)"), ExpressionError);
    CHECK_THROWS_AS(parse_expression("y"), ExpressionError);
    CHECK_THROWS_AS(parse_expression("1+inf"), ExpressionError);
}

TEST_CASE("an order is real: an inner integral's must not depend on the outer variable, of which complex values are taken")
{
    for (const char* formula :
         {"integral(besselj(20*x,y),y,1,2)", "integral(polylog(1+x,y/2),y,0,1)", "1+re(integral(y*besselk(x,y),y,1,2))"})
        CHECK_THROWS_AS(along(formula, {"0", "1"}), ExpressionError);
    is_value(along("integral(besselj(1,x*y)*x,y,0,1)", {"0", "1"}), "1-integral(besselj(0,y),y,0,1)");
    // and if one gets there all the same it has no value
    const auto of_order = [](const ComplexBall& order) {
        return PlainFormula(make(Op::bessel_j, {make_ball(order), make_variable()})).at(ComplexBall(2));
    };
    CHECK(of_order(ComplexBall(Ball(1) / Ball(2))).is_finite());
    CHECK_FALSE(of_order(ComplexBall(Ball(1), Ball(1) / Ball(2))).is_finite());
}

TEST_CASE("asinh of what crosses its cut, beyond +-i, where it goes to infinity at an end")
{
    for (const auto& [formula, from, to] :
         {std::array{"asinh(i*x+(3-x)/x)/x^2", "2", "inf"}, std::array{"re(asinh(i*x+(3-x)/x))/x^2", "2", "inf"},
          std::array{"asinh(i*exp(x)+4-x)*exp(-x)", "0", "inf"}, std::array{"asinh(i/x+(1/3-x))", "0", "1/2"},
          std::array{"asinh(i*x)/x^2", "2", "inf"}})
        for (const long digits : {3L, 10L}) {
            CAPTURE(formula);
            CHECK(along(formula, {from, to}, digits).status != Status::certified);
        }
    const Parameters about_zero{{"a", parse_parameter("0+/-1e-20")}};
    CHECK(along("asinh((i+a)*x)/x^2", {"2", "inf"}, 10, about_zero).status != Status::certified);
    // on one side of it; by parts, an odd function of the factor
    is_value(along("asinh((1+i)*x)/x^2", {"2", "inf"}), "asinh(2+2*i)/2+(1+i)*asinh(1/(2+2*i))");
    is_value(along("asinh((i-1)*x)/x^2", {"2", "inf"}), "-asinh(2-2*i)/2-(1-i)*asinh(1/(2-2*i))");
}

TEST_CASE("an inner integral at points of the plane is the analytic continuation, in a formula's real part too")
{
    const char* both = "(sqrt(pi/(i*x))*erf(sqrt(i*x))+sqrt(pi/(-i*x))*erf(sqrt(-i*x)))/2"; // of exp(ixy) and exp(-ixy)
    const struct {
        const char *formula, *value;
    } cases[] = {{"integral(exp(-x*y)/sqrt(y),y,0,1)", "sqrt(pi/x)*erf(sqrt(x))"},
                 {"integral(re(exp(i*x*y))/sqrt(y),y,0,1)", both},
                 {"re(integral(exp(i*x*y)/sqrt(y),y,0,1))", both},
                 {"integral(im(i*exp(i*x*y))/sqrt(y),y,0,1)", both},
                 {"conj(integral(exp(i*x*y)/sqrt(y),y,0,1))", "sqrt(pi/(i*x))*erf(sqrt(i*x))"},
                 {"integral(abs(exp(i*x*y))/sqrt(y),y,0,1)", "2"},
                 {"integral(exp(i*x*y),y,0,x)", "(exp(i*x^2)-1)/(i*x)"}};
    const WorkingPrecision precision(100);
    for (const auto& c : cases) {
        CAPTURE(c.formula);
        for (const ComplexBall& z : {ComplexBall(Ball(1), Ball(1) / Ball(2)), ComplexBall(Ball(2), Ball(-1) / Ball(3))}) {
            const ComplexBall got = PlainFormula(parse_expression(c.formula)).at(z), truth = PlainFormula(parse_expression(c.value)).at(z);
            CHECK(got.is_finite());
            CHECK(acb_overlaps(got.get(), truth.get()));
        }
    }
}

TEST_CASE("the real part of a value mirrors i and the points of an outer variable; that of a formula, i alone")
{
    const WorkingPrecision precision(100);
    const ComplexBall outer(Ball(2), Ball(3)), z(Ball(5), Ball(7)), i(Ball(0), Ball(1));
    const ExpressionPtr f = make(Op::multiply, {make_ball(outer), make(Op::multiply, {make(Op::imaginary_unit, {}), make_variable()})});
    const auto at_z = [&](Op op) { return PlainFormula(make(op, {f})).at(z); };
    const auto is = [](const ComplexBall& got, const ComplexBall& truth) { return acb_overlaps(got.get(), truth.get()) != 0; };
    CHECK(is(at_z(Op::real_value), ComplexBall(-3) * z)); // Re(2i - 3)
    CHECK(is(at_z(Op::imaginary_value), ComplexBall(2) * z));
    CHECK(is(at_z(Op::real_part), ComplexBall(0)));
    CHECK(is(at_z(Op::imaginary_part), outer * z));
    CHECK(is(at_z(Op::conjugate), -i * outer * z));
    // without i in it only the point is mirrored
    const ExpressionPtr g = make(Op::multiply, {make_ball(outer), make_variable()});
    const auto of_g = [&](Op op) { return PlainFormula(make(op, {g})).at(z); };
    CHECK(is(of_g(Op::real_value), ComplexBall(2) * z));
    CHECK(is(of_g(Op::imaginary_value), ComplexBall(3) * z));
    CHECK(is(of_g(Op::real_part), outer * z));
    CHECK(is(of_g(Op::imaginary_part), ComplexBall(0)));
    CHECK(is(of_g(Op::conjugate), outer * z));
    for (const Op op : {Op::real_value, Op::imaginary_value, Op::real_part, Op::imaginary_part, Op::conjugate})
        CHECK((at_z(op).is_finite() && of_g(op).is_finite()));
}

TEST_CASE(
    "between ends that are not real an inner integral is of analytic functions of its variable: what asks for real numbers is refused")
{
    const std::vector<const char*> of_y{"abs(y+3)",   "conj(y)",   "re(y)",     "im(y)",    "sign(y+5)",
                                        "floor(y+5)", "ceil(y+5)", "max(y,-5)", "min(y,5)", "ei(y+2)"};
    for (const char* f : of_y) {
        CAPTURE(f);
        const std::string inner = std::string("integral(") + f + ",y,0,";
        CHECK_THROWS_AS(along((inner + "i*x)").c_str(), {"0", "1"}), ExpressionError);
        CHECK_THROWS_AS(along((inner + "x)").c_str(), {"0", "1+i"}), ExpressionError);
        CHECK_NOTHROW(along((inner + "x)").c_str(), {"0", "1"}));
    }
    // int_0^(ix) e^y dy = e^(ix) - 1; the inner integral is abs(x + i) y^2/2 at y = x
    CHECK(along("integral(exp(y),y,0,i*x)", {"0", "1"}).status == Status::certified);
    CHECK(along("integral(abs(x+i)*y,y,0,x)", {"0", "1+i"}).status == Status::certified);
}

TEST_CASE("an inner integral between ends that move: both, one of them, one of them infinite")
{
    struct Case {
        const char *formula, *from, *to, *value;
    };
    for (const Case& c : {Case{"integral(exp(y),y,x,2*x)", "1", "2", "(exp(4)-exp(2))/2-exp(2)+exp(1)"},
                          {"integral(exp(y),y,1,x)", "2", "3", "exp(3)-exp(2)-exp(1)"},
                          {"integral(exp(y),y,x,1)", "2", "3", "exp(1)+exp(2)-exp(3)"},
                          {"integral(exp(-y),y,x,inf)", "0", "1", "1-exp(-1)"},
                          {"integral(exp(y),y,-inf,x)", "0", "1", "exp(1)-1"}}) {
        CAPTURE(c.formula);
        const Integral i = along(c.formula, {c.from, c.to}, 15);
        CHECK_MESSAGE(i.status == Status::certified, i.reason);
        CHECK(i.value.overlaps(parse_limit(c.value).ball()));
    }
}

TEST_CASE("a path is told by its points, whatever spaces stand about them: each side counts once, a point that is named twice for nothing")
{
    const struct {
        std::vector<const char*> path;
        const char* value;
        std::size_t parts;
    } cases[] = {
        {{"0", "1", "1+i"}, "exp(1+i)-1", 2},    {{"0", "1", "2"}, "exp(2)-1", 2},     {{" 0", "1 "}, "exp(1)-1", 1},
        {{"i", "1", "3"}, "exp(3)-exp(i)", 2},   {{"0", "0", "1+i"}, "exp(1+i)-1", 1}, {{"0", "1+i", "1+i", "2", "2"}, "exp(2)-1", 2},
        {{"i*i", "1+i"}, "exp(1+i)-exp(-1)", 1}, {{"-inf", "i"}, "exp(i)", 1},         {{"i", "-inf"}, "-exp(i)", 1},
        {{" -oo ", "1+i", "2"}, "exp(2)", 2},    {{"(-2+i)*inf", "i"}, "exp(i)", 1}};
    for (const auto& c : cases) {
        CAPTURE(std::string(c.path.front()));
        CAPTURE(std::string(c.path.back()));
        const Integral i = along("exp(x)", c.path);
        is_value(i, c.value);
        CHECK(i.parts.size() == c.parts);
        CHECK(i.digits == 25);
    }
    is_value(along("exp(-x)", {"1", " infinity"}), "exp(-1)");
    is_value(along("exp(-x)", {"1", "+inf"}), "exp(-1)");
    CHECK(parse_vertex("  1+i ").text == "1+i");
    CHECK(parse_vertex("1 + i").text == "1 + i");
    CHECK(along("exp(x)", {"0", "i"}).parts.front().rule.find(" on the path from 0 to i as a fraction of it") != std::string::npos);
    CHECK(along("exp(x)", {"-inf", "i"}).parts.front().rule.find(" on the path from -inf to i in units of its direction") !=
          std::string::npos);
    for (const char* nothing : {"", " ", "    "}) CHECK_THROWS_AS(parse_vertex(nothing), ExpressionError);
    for (const std::vector<const char*>& short_path : {std::vector<const char*>{}, {"0"}})
        CHECK_THROWS_AS(along("x", short_path), DomainError);
    const Integral nowhere = along("exp(x)", {"1+i", "1+i"});
    CHECK(nowhere.status == Status::certified);
    CHECK((nowhere.value.is_exact() && nowhere.value.contains_zero() && nowhere.imaginary.contains_zero()));
    for (const char* point : {"x", "1+i*x"}) {
        CAPTURE(point);
        try {
            parse_vertex(point);
            FAIL("a point that depends on x");
        }
        catch (const ExpressionError& e) {
            CHECK(e.column() == 1);
        }
    }
}
