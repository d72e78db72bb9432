// SPDX-License-Identifier: GPL-3.0-or-later
#include "proofs/consequences.hpp"

#include "proofs/enclosure/enclosure.hpp"
#include "proofs/lemmas/limit_values.hpp"
#include "proofs/lemmas/model_area.hpp"

#include "touchstone/paper/archard.hpp"
#include "touchstone/paper/peaks.hpp"
#include "touchstone/paper/westergaard.hpp"

#include <stdexcept>

namespace touchstone::proofs {
namespace {

/// The midpoint of an enclosure that is far tighter than the digits shown.
std::string shown(const Ball& b, int digits)
{
    const std::string t = b.to_string(digits + 2);
    const std::string middle = t.substr(t[0] == '[' ? 1 : 0, t.find(' '));
    Ball rounded;
    arb_set_str(rounded.get(), middle.c_str(), 64);
    char* text = arb_get_str(rounded.get(), digits, ARB_STR_NO_RADIUS);
    const std::string out = text;
    flint_free(text);
    return out;
}

} // namespace

std::string percent(const Ball& share) { return shown(100 * share, 3) + " percent"; }

namespace {

/// K_n of (7.17) as printed.
Ball K_as_printed(long n)
{
    const Print& p = prints().at("7.17");
    Ball product(1);
    for (long i = 0; i < n; ++i) product *= evaluate(p("M.term"), Point{{"i", Rational(i)}});
    return evaluate(p("rhs"), std::map<std::string, Ball>{{"n", Ball(n)}, {"M", product}});
}

Ball K_as_printed_over_right(long n) { return K_as_printed(n) / archard::K_by_recursion<Ball>(n); }

/// The case of figure 5: load 0.001, G^2 = 10.
Ball figure_5_x_P() { return peaks::fixed_point(sqrt(Ball(10))); }

std::string peak_pressure()
{
    const auto off = [](long n) {
        return Ball(1 - pow(Ball(Rational(1, 1000)) / figure_5_x_P(), ScalarTraits<Ball>::power_of_two(-(n + 1))));
    };
    return "the scale of figure 5 and (9.4) inherit it: at scale n they are off by the factor (load/x_P)^(2^-(n+1)) in partial contact, "
           "for the case of figure 5 (load 0.001, x_P = " +
           shown(figure_5_x_P(), 1) + ") " + percent(off(5)) + " at n = 5 and " + percent(off(20)) + " at n = 20";
}

std::string partial_contact()
{
    const Print& p = prints().at("6.2");
    const auto low = [&](const Rational& p_n, const Rational& before) { // p*_n = 1
        const Print right = p.edited({{"J.integrand", "sqrt((pstar_n-p_nm1)+p_n^2)", "sqrt((pstar_n-p_nm1)^2+p_n^2)"}});
        const Point at{{"pstar_n", Rational(1)}, {"q_nm1", Rational(1)}, {"p_n", p_n}, {"p_nm1", before}};
        return percent(1 - evaluate(p("J.integrand"), at) / evaluate(right("J.integrand"), at));
    };
    return "(6.1) with (2.19) has the right form; a code written from (6.2) adds a pressure to a squared pressure, and with p*_n = 1 its "
           "integrand is low by " +
           low(Rational(1, 2), Rational(1, 2)) + " at p_n = p_{n-1} = 1/2, " + low(Rational(1), Rational(1, 2)) +
           " at p_n = 1 and p_{n-1} = 1/2, and " + low(Rational(3, 2), Rational(57, 100)) +
           " near the lower limit at p_n = 1.5, p_{n-1} = 0.57";
}

std::string power_of_pi()
{
    const auto factor = [](long n) { return pow(pi<Ball>(), Ball((archard::delta<Ball>(n) - 1) / 2)); };
    return "(7.13) has the right 1/pi and does not inherit it; a code that trusts (7.10) has K_{n+1}/K_n wrong by the factor "
           "pi^((delta_n-1)/2): " +
           shown(factor(0), 2) + " at n = 0, " + shown(factor(1), 2) +
           " at n = 1, and K_inf by the product of all, pi^(-1/2) = " + shown(1 / sqrt(pi<Ball>()), 2);
}

std::string product_of_gammas()
{
    return "(7.18) inherits it; Table 1 and (7.20) were computed from the right form. As printed K_1 = " + shown(K_as_printed(1), 3) +
           " for " + shown(archard::K_by_recursion<Ball>(1), 3) + ", and K_n grows like (4/pi)^n instead of converging";
}

std::string hertzian_area()
{
    return "the dashed curves of figure 3 as described; (7.21), (8.2) use K_n and are not affected. A code that trusts the print is high "
           "by " +
           percent(K_as_printed_over_right(1) - 1) + " at n = 1, and by a factor of " + shown(K_as_printed_over_right(10), 3) +
           " at n = 10";
}

std::string longest_segment()
{
    const Ball x = figure_5_x_P();
    return "the scale of figure 5b, if drawn from the print; for its case (x_P = " + shown(x, 1) + ") the print gives " +
           shown(asin(x) / pi<Ball>(), 3) + " lambda_n, the right form " + shown(westergaard::half_width(x), 3) + " lambda_n";
}

std::string limit_of_area()
{
    return "(8.3), (8.6) inherit the constant; the slopes and dimensions are right. A code that takes (7.21) for the limit of the model is "
           "low by " +
           percent(1 - 1 / limiting_ratio(5)) + " at D = 1.5, gamma = 5 and " + percent(1 - 1 / limiting_ratio(10)) + " at gamma = 10";
}

} // namespace

std::string consequence_of(const std::string& id)
{
    static const std::map<std::string, std::string (*)()> all{{"5.10", peak_pressure},
                                                              {"6.2", partial_contact},
                                                              {"7.10", power_of_pi},
                                                              {"7.17", product_of_gammas},
                                                              {"7.18", hertzian_area},
                                                              {"9.4", longest_segment},
                                                              {"text.defines-limit", limit_of_area}};
    return all.at(id)();
}

} // namespace touchstone::proofs
