// SPDX-License-Identifier: MIT
#include "touchstone/oracle/mistakes.hpp"

#include "touchstone/paper/archard.hpp"
#include "touchstone/paper/segments.hpp"
#include "touchstone/paper/weierstrass.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace touchstone::oracle {
namespace {

using Values = std::map<std::string, Rational>;

/// pi as a rational number close enough that nobody can tell at a part in 2^20.
Rational rational_pi() { return Rational(245850922, 78256779); }

struct Factor {
    std::string name;
    Rational value;
};

/// Factors that conventions differ by, of a length measured across the contact or of anything else. nu = 0.3 is steel's;
/// other ratios are found by fitting.
std::vector<Factor> convention_factors(bool width)
{
    const Rational pi = rational_pi();
    const std::string two = width ? "2: full width for half width" : "2: peak-to-valley for amplitude, or 2E* for E*";
    const std::string half = width ? "1/2: quarter width for half width" : "1/2: amplitude for peak-to-valley, or E* for 2E*";
    return {{two, 2}, {half, Rational(1, 2)}, {"pi", pi}, {"1/pi", 1 / pi}, {"2 pi", 2 * pi}, {"1/(2 pi)", 1 / (2 * pi)},
            {"4", 4}, {"1/4", Rational(1, 4)}, {"1 - nu^2: E for E/(1 - nu^2), nu = 0.3", Rational(91, 100)},
            {"1/(1 - nu^2): E/(1 - nu^2) for E, nu = 0.3", Rational(100, 91)},
            {"2 (1 - nu^2): E for 2E*, nu = 0.3", Rational(182, 100)}, {"1/(2 (1 - nu^2)): 2E* for E, nu = 0.3", Rational(100, 182)},
            {"sqrt 2", Rational(1855077841, 1311738121)}, {"1/sqrt 2", Rational(1311738121, 1855077841)}};
}

/// Factors that positions along the wave differ by.
std::vector<Factor> position_factors()
{
    const Rational pi = rational_pi();
    return {{"2", 2}, {"1/2: pi x where 2 pi x is right", Rational(1, 2)}, {"4", 4}, {"1/4", Rational(1, 4)}, {"pi", pi}, {"1/pi", 1 / pi},
            {"2 pi: x where the phase 2 pi x is right", 2 * pi}, {"1/(2 pi): the phase 2 pi x where x is right", 1 / (2 * pi)}};
}

bool takes(const Quantity& q, const std::string& key) { return std::find(q.inputs.begin(), q.inputs.end(), key) != q.inputs.end(); }

/// (7.17) as printed, with the exponent n + 2^-n and the product of Gamma(1 - h)/Gamma(3/2 - h), whose factors soon are 2/sqrt(pi).
Ball K_as_printed(long n)
{
    constexpr long telling_factors = 64; ///< h is 2^-66 then: nothing that a binary64 answer could tell from 0
    Ball K = pow(Ball(2), Ball(Rational(n)) + power_of_two<Ball>(-n)) / pow(pi<Ball>(), Ball(Rational(n + 2, 2)));
    if (n > telling_factors) K = K * pow(2 / sqrt(pi<Ball>()), Ball(Rational(n - telling_factors)));
    for (long i = 0; i < std::min(n, telling_factors); ++i) {
        const Ball h = power_of_two<Ball>(-(i + 2));
        K = K * gamma_function(Ball(1 - h)) / gamma_function(Ball(Ball(Rational(3, 2)) - h));
    }
    return K;
}

} // namespace

std::vector<InputMistake> input_mistakes(const Quantity& q)
{
    std::vector<InputMistake> all{{"", 0, [](Values&) { return true; }}};
    const auto scaled = [&all](const std::string& what, const std::vector<std::string>& keys, const Factor& f, int cost) {
        all.push_back({fmt::format("{} taken times {}", what, f.name), cost, [keys, c = f.value](Values& v) {
                           for (const auto& key : keys) v[key] *= c;
                           return true;
                       }});
    };
    for (const Factor& f : convention_factors(false)) {
        if (takes(q, "load") && takes(q, "p")) scaled("load and p (that is, p*)", {"load", "p"}, f, 2);
        if (takes(q, "load")) scaled("load", {"load"}, f, 2);
        if (takes(q, "p")) scaled("p", {"p"}, f, 2);
    }
    if (takes(q, "x"))
        for (const Factor& f : position_factors()) scaled("x (that is, lambda)", {"x"}, f, 2);
    if (takes(q, "a")) // the half-width of a contact
        for (const Factor& f : convention_factors(true)) scaled("a (that is, lambda)", {"a"}, f, 2);
    if (takes(q, "p") && takes(q, "load")) {
        all.push_back({"p taken in units of the mean pressure, not of p*", 1, [](Values& v) { v["p"] *= v["load"]; return true; }});
        all.push_back({"p divided by the mean pressure", 1, [](Values& v) { v["p"] /= v["load"]; return true; }});
    }
    if (takes(q, "x"))
        all.push_back({"origin at the valley, not at the peak", 1, [](Values& v) { v["x"] = Rational(1, 2) - abs(v["x"]); return true; }});
    if (takes(q, "n")) {
        all.push_back({"n counted from 1, not from 0", 1, [](Values& v) { v["n"] -= 1; return v["n"] >= 0; }});
        all.push_back({"n + 1 for n", 1, [](Values& v) { v["n"] += 1; return true; }});
    }
    return all;
}

std::vector<OutputMistake> output_mistakes(const Quantity& q)
{
    std::vector<OutputMistake> all{{"", 0, [](const Inputs&) { return 1.0; }}};
    for (const Factor& f : convention_factors(q.name.ends_with("half_width")))
        all.push_back({"factor " + f.name, 1, [c = f.value.get_d()](const Inputs&) { return c; }});
    all.push_back({"opposite sign", 1, [](const Inputs&) { return -1.0; }});
    if (takes(q, "load")) {
        all.push_back({"in units of the mean pressure, p/pbar for p/p*", 1, [](const Inputs& in) { return 1 / in.real("load").get_d(); }});
        all.push_back({"multiplied by the load", 1, [](const Inputs& in) { return in.real("load").get_d(); }});
    }
    return all;
}

/// Sums of the profile and of its bound that stop early: what a code with a fixed number of terms computes.
void add_sums_cut_off(const Quantity& q, std::vector<OtherFormula>& chosen)
{
    constexpr long most_terms = 40;
    for (long terms = 1; terms <= most_terms; ++terms) {
        const std::string name = fmt::format("the series cut off after {} term{}", terms, terms == 1 ? "" : "s");
        if (q.name == "weierstrass.profile")
            chosen.push_back({name, [terms](const Inputs& in) {
                                  return weierstrass::profile_sum(in.ball("x"), in.ball("D"), in.ball("gamma"), terms);
                              }});
        if (q.name == "weierstrass.bound")
            chosen.push_back({name, [terms](const Inputs& in) {
                                  const Ball r = weierstrass::amplitude_ratio(in.ball("D"), in.ball("gamma"));
                                  return (1 - pow(r, Ball(Rational(terms)))) / (1 - r);
                              }});
    }
}

std::vector<OtherFormula> other_formulas(const Quantity& q)
{
    struct Named {
        std::string quantity;
        OtherFormula formula;
    };
    static const std::vector<Named> all{
        {"archard.K", {"(7.17) as the paper prints it", [](const Inputs& in) { return K_as_printed(in.integer("n")); }}},
        {"archard.area",
         {"(7.18) as the paper prints it",
          [](const Inputs& in) { return archard::area(in.integer("n"), in.ball("load"), in.G_ball(), K_as_printed(in.integer("n"))); }}},
        {"archard.segments",
         {"(8.2) with K of (7.17) as the paper prints it",
          [](const Inputs& in) {
              return archard::segments(in.integer("n"), in.ball("load"), in.ball("D"), in.ball("gamma"), K_as_printed(in.integer("n") - 1));
          }}},
        {"segments.max_half_width",
         {"(9.4) as the paper prints it, without the square root",
          [](const Inputs& in) {
              const long n = in.integer("n");
              const Ball x = n == 0 ? in.ball("load") : peaks::iterate(n - 1, in.ball("load"), in.G_ball());
              return asin(at_most(x, Ball(1))) / pi<Ball>();
          }}},
        {"westergaard.half_width", {"the Hertzian half-width (2.7)", [](const Inputs& in) { return hertz::half_width(in.ball("load")); }}},
        {"westergaard.pressure",
         {"the Hertzian pressure (2.6)", [](const Inputs& in) { return hertz::pressure(in.ball("x"), in.ball("load")); }}},
        {"westergaard.pressure",
         {"(2.2) cut off at zero: the full-contact pressure where contact is partial",
          [](const Inputs& in) { return at_least(westergaard::pressure_full(in.ball("x"), in.ball("load")), Ball(0)); }}},
        {"westergaard.pressure",
         {"(2.2) of full contact where contact is partial: nothing keeps the pressure from tension",
          [](const Inputs& in) { return westergaard::pressure_full(in.ball("x"), in.ball("load")); }}},
        {"hertz.half_width", {"Westergaard's half-width (2.5)", [](const Inputs& in) { return westergaard::half_width(in.ball("load")); }}},
        {"hertz.pressure",
         {"Westergaard's pressure (2.4)", [](const Inputs& in) { return westergaard::pressure(in.ball("x"), in.ball("load")); }}},
    };
    std::vector<OtherFormula> chosen;
    for (const Named& n : all)
        if (n.quantity == q.name) chosen.push_back(n.formula);
    add_sums_cut_off(q, chosen);
    return chosen;
}

} // namespace touchstone::oracle
