// SPDX-License-Identifier: MIT
// A formula is compiled anew for each range, so that what it does at the ends shows: its values stay those of the text.
#include "touchstone/quadrature/compiled.hpp"
#include "touchstone/quadrature/integrand.hpp"
#include "touchstone/quadrature/nodes.hpp"

#include <doctest/doctest.h>

#include <string>
#include <vector>

using namespace touchstone;
using namespace touchstone::quadrature;

namespace {

Limit limit(const std::string& text) { return parse_limit(text); }

/// At nodes of the map from the middle to within 2^-70 of either end, the value against that of the text at the same x.
/// \param least bits of the value
void is_its_text(const char* formula, const Range& range, slong least)
{
    constexpr long m = 3, count = 15;
    constexpr slong bits = 640, more = 1400;
    const auto table = NodeTable::get(m, count, bits, 1);
    const ExpressionPtr e = parse_expression(formula);
    const Integrand f(e, range);
    Interval interval = range.interval();
    for (const Side side : {Side::left, Side::right})
        for (long k = side == Side::left ? 0 : 1; k <= count; k += k < m ? 1 : 2) {
            CAPTURE(k);
            const Node node(*table, k, side);
            const auto point = [&] {
                interval.prepare();
                return interval.at(EndpointNumber<Ball>(&node, {1, 0}, {}, Ball(1)), EndpointNumber<Ball>(&node, {}, {1, 0}, Ball(1)));
            };
            const Ball truth = [&] {
                const WorkingPrecision precision(more);
                return evaluate_at(*e, point().x.value());
            }();
            const WorkingPrecision precision(128);
            const auto p = point();
            const Ball value = f.at(p.x, p.left, p.right).value();
            CHECK(truth.is_finite());
            CHECK(value.overlaps(truth));
            const bool keeps = truth.relative_bits() > 500 && (range.map == Map::finite || k <= m); // the text is not 0, nor x far out
            if (keeps) CHECK(value.relative_bits() >= least);
        }
}

constexpr slong nearly_all = 90; // of 128

} // namespace

TEST_CASE("on a finite range a formula has its values, and their bits up to the ends where it vanishes or is singular")
{
    struct Row {
        const char *from, *to;
        std::vector<const char*> formulas;
    };
    for (const Row& row : {
             Row{"0", "pi", {"sin(x)", "csc(x)", "sin(-x)", "sin(3*x)", "sin(x/2)*cos(x/2)"}},
             Row{"-pi", "0", {"sin(x)", "sin(x+pi)", "sin(2*x)"}},
             Row{"-pi/2", "pi/2", {"cos(x)", "sec(x)", "cos(-x)", "cos(3*x)", "1/cos(x)^2"}},
             Row{"pi/2", "3*pi/2", {"cos(x)", "cos(-x)", "sin(x-pi/2)"}},
             Row{"0", "pi/2", {"cot(x)", "tan(x)", "sin(2*x)", "cos(x)"}},
             Row{"0", "3*pi", {"sin(x)", "sin(x/3)"}},
             Row{"pi", "2*pi", {"sin(x)", "sin(2*x)", "sin(-x)"}},
             Row{"-pi", "2*pi", {"sin(x)"}},
             Row{"-pi", "-pi/2", {"sin(x)", "cos(x)", "sin(2*x)"}},
             Row{"pi", "5", {"sin(x)", "sin(2*x)", "sin(x/2+pi/2)"}},
             Row{"5", "3*pi", {"sin(x)"}},
             Row{"2*pi", "7", {"sin(x)", "cos(x/4)"}},
             Row{"2-pi", "2", {"sin(2-x)", "sin(x-2)"}},
             Row{"pi/2", "2", {"cos(x)", "cos(3*x)", "cos(x+pi)"}},
             Row{"0",
                 "1",
                 {"x*(1-x)", "x^3-x", "1-x^2", "x^2-2*x+1", "log(x)", "log(1/x)", "log(1-x)", "log(1/(1-x))", "log(2*x)", "log(x^2)",
                  "log(x^3)+1", "log(1-x^2)", "log(2*x-x^2)", "log(sin(x))", "acos(x)", "asin(x)", "acos(2*x-1)", "asin(2*x-1)",
                  "acos(1-x^2)", "acos(x/3)", "ellipk(x)", "ellipe(x)", "ellipk(x/2)", "expm1(x)", "log1p(x)", "log1p(-x)", "sinh(x)",
                  "tanh(x)", "csch(x)", "coth(x)", "sech(x)", "atanh(x)", "sqrt(x-x^2)", "x^(1/3)*(1-x)^(-1/2)", "cbrt(x)", "2^x", "x^x",
                  "(x-x)+x", "sin(x)", "sin(x)^2/x", "1-cos(x)", "x-sin(x)", "besselj(0,x)", "besselj(1,x)", "erf(x)", "max(x,1-x,1/8)",
                  "abs(x-x)+x", "sign(x-x)+x", "floor(7/2)*x", "ceil(7/2)*x", "abs(-7/2)*x", "sign(-7/2)*x", "abs(7/2)+x", "floor(-7/2)*x",
                  "ceil(-7/2)*x", "floor(3)*x", "ceil(-3)*x", "floor(x/2)+x", "ceil(x/2)*x", "floor(-x)*x", "ceil(-x)+x", "floor(x)+x",
                  // of the same sign at both ends, and of another in between
                  "max((x-1/4)*(x-1/2)*(x-2),0)+1", "min(0,(x-1/4)*(x-1/2)*(2-x))-1", "max((x-1/4)*(x-1/2),0)+x",
                  "min((1/4-x)*(x-1/2),0)-x", "abs((x-1/4)*(x-1/2))+x", "sign((x-1/4)*(x-1/2)*(x-2))+3*x", "floor(4*x^2-4*x+1/2)+x",
                  "ceil(4*x-4*x^2+1/2)*x"}},
             Row{"1", "3", {"(x-1)^2*(3-x)",   "x^2-4*x+3",        "log((x-1)/2)",      "log((3-x)/2)",
                            "log(x)",          "log(2/(x-1))",     "acosh(x)",          "sin(x-1)",
                            "abs(1-x)",        "abs(x-1)",         "abs(3-x)*abs(x-3)", "sign(x-1)*x",
                            "sign(1-x)*x",     "sign(x-3)*x",      "max(x,1)",          "min(x,1)",
                            "max(1,x,2*x-1)",  "min(1,x,3)",       "min(3,2*x-2,x)+x",  "max(x,x)",
                            "min(x,2*x-x)",    "floor(x/3)+x",     "ceil((x-1)/2)*x",   "floor((1-x)/2)*x",
                            "ceil((3-x)/2)*x", "floor(x/2+1/2)*x", "1-cos(x-1)",        "sqrt(x-1)*(3-x)^(3/2)",
                            "expm1(x-1)",      "asin((x-2))",      "acos(2-x)"}},
             Row{"-1",
                 "1",
                 {"1-x^2", "acos(x)", "acos(-x)", "asin(x)", "atanh(x)", "atanh(-x)", "sqrt(1-x^2)", "abs(x-1)", "abs(-1-x)",
                  "max(x,-1)*x"}},
         })
        for (const char* formula : row.formulas) {
            CAPTURE(std::string(formula));
            CAPTURE(std::string(row.from));
            is_its_text(formula, Range{limit(row.from), limit(row.to), Map::finite}, nearly_all);
        }
}

TEST_CASE("on a range without end a formula has its values on either map")
{
    struct Row {
        const char *from, *to;
        std::vector<Map> maps;
        std::vector<const char*> formulas;
    };
    const std::vector<Map> right{Map::right_algebraic, Map::right_exponential}, left{Map::left_algebraic, Map::left_exponential},
        line{Map::line_algebraic, Map::line_exponential};
    for (const Row& row :
         {Row{"0",
              "inf",
              right,
              {"1/(1+x)",
               "(1+x)^(-7/2)",
               "x/(x^2+2*x+1)",
               "(x-1)^2/(1+x)^5",
               "exp(-3*x+1)",
               "exp(x/2-2*x)",
               "exp(-x)",
               "exp(-x^2)",
               "exp(2)/(1+x^2)",
               "tanh(x)",
               "tanh(-2*x)",
               "sech(2*x)",
               "sech(-x)",
               "cosh(x)*exp(-2*x)",
               "sinh(x)*exp(-2*x)",
               "tanh(x^2)",
               "sech(-x^3)",
               "log(1+exp(-x))",
               "log(1+1/(1+x^2))",
               "log((1+x^2)/(2+x^2))",
               "log(1+exp(-x)+exp(-2*x))",
               "log(exp(-x)+1-exp(-3*x)/2)",
               "log(2+exp(-x))",
               "log(exp(-x)+x+1-exp(-2*x))",
               "log(x+exp(x))*exp(-x)",
               "log((1+x)/(1+exp(x)))*exp(-x)",
               "log(exp(x)/(1+x))*exp(-x)",
               "log((2+x+x^2)/(1+x))/(1+x)^2",
               "log((1+x)/(1+x^3))/(1+x)^2",
               "exp(-x)*besseli(0,x)",
               "exp(-x)*besseli(1,x)/(1+x)",
               "exp(x^2)*erfc(x)",
               "2^(-x)",
               "e^(-x)",
               "sqrt(x)*exp(-x)"}},
          Row{"2",
              "inf",
              right,
              {"1/(x-1)", "(x-1)/x^4", "1/(x-3+2)^(5/2)", "1/x^2", "(x-2)/(x-1)^3", "exp(-x)", "exp(4-2*x)", "exp(x)*besselk(0,x)",
               "coth(x)", "csch(x)", "log(tanh(x))", "log(coth(x))", "acosh(x-1)/x^3", "(x-3)*exp(-x)", "tanh(2-x)", "log(x/(x-1))"}},
          Row{"-1", "inf", right, {"1/(2+x)^2", "x*exp(-x)", "(x+1)/(x+2)^3", "x/(3+x)^3"}},
          Row{"-inf",
              "0",
              left,
              {"1/(1-x)", "1/(x-1)^3", "(x-1)^(-2)*x", "(x+1)/(x-1)^5", "exp(2*x-1)", "exp(x)", "tanh(x)", "tanh(-x)", "sech(x)",
               "tanh(x^3)", "tanh(x^2)", "sech(x^2)", "cosh(x)*exp(2*x)", "log(1+exp(x))", "sqrt(-x)*exp(x)"}},
          Row{"-inf",
              "-3",
              left,
              {"1/(x+2)^2", "1/(x+2)", "1/x^2", "(x+3)/(x+2)^3", "(x+4)/x^4", "exp(x+3)", "tanh(x+3)", "csch(x)", "coth(x)"}},
          Row{"-inf",
              "inf",
              line,
              {"1/(1+x^2)", "exp(x)/(1+exp(x))^2", "exp(2*x)/(1+exp(3*x))", "exp(-x^2)", "exp(-x^2+x)", "sech(x)", "tanh(x)*exp(-x^2)",
               "sech(-x)", "exp(1-x)/(1+exp(2-2*x))", "x*exp(-x^2)", "tanh(-x)/(1+x^2)", "1/cosh(x)"}}})
        for (const Map map : row.maps)
            for (const char* formula : row.formulas) {
                CAPTURE(std::string(formula));
                CAPTURE(static_cast<int>(map));
                is_its_text(formula, Range{limit(row.from), limit(row.to), map}, 20);
            }
}
