// SPDX-License-Identifier: GPL-3.0-or-later
/// What the symbols of section 7 stand for. Up to (7.12) the constants K_n, alpha_n, beta_n, delta_n are any numbers, as they are
/// when the paper introduces them; from (7.13) on those of the library.
#include "proofs/enclosure/enclosure.hpp"
#include "proofs/lemmas/elasticity.hpp"
#include "proofs/lemmas/k_limit.hpp"
#include "proofs/reading/reading.hpp"

#include "touchstone/paper/archard.hpp"
#include "touchstone/paper/weierstrass.hpp"
#include "touchstone/paper/westergaard.hpp"

namespace touchstone::proofs {

namespace {

Rational q(long a, long b) { return Rational(a, b); }

struct Parameters {
    Rational gamma, D, load, x; ///< x as a share of the contact half-width
};
const std::vector<Parameters> cases{{q(5, 1), q(3, 2), q(1, 6), q(0, 1)},    {q(5, 1), q(3, 2), q(1, 6), q(3, 7)},
                                    {q(7, 1), q(5, 4), q(1, 17), q(-2, 3)},  {q(7, 1), q(5, 4), q(1, 17), q(11, 10)},
                                    {q(5, 1), q(3, 2), q(1, 6), q(-16, 10)}, {q(5, 1), q(3, 2), q(1, 6), q(16, 10)}};

/// A single Hertzian wave at level 0, one wave of level 1 below it, and constants K, alpha, beta, delta that nothing restricts.
Situation hertz_wave(const Parameters& c)
{
    Situation s;
    const Ball E(5), nu(q(1, 4)), g_0(q(1, 3)), lambda_0(2), gamma(c.gamma), D(c.D), load(c.load);
    const auto pstar = [&](const Ball& g, const Ball& lambda) {
        return evaluate(amplitude_of_pressure(sym("g"), 2 * GiNaC::Pi / sym("lambda")),
                        std::map<std::string, Ball>{{"g", g}, {"lambda", lambda}, {"E", E}, {"nu", nu}});
    };
    const Ball pstar_0 = pstar(g_0, lambda_0);
    s["E"] = E;
    s["nu"] = nu;
    s["g_0"] = g_0;
    s["lambda_0"] = lambda_0;
    s["gamma"] = gamma;
    s["D"] = D;
    s["ptilde"] = load;
    s["pbar"] = load * pstar_0;
    s["F_0"] = s["pbar"] * lambda_0;
    s["a_0"] = lambda_0 * hertz::half_width(load);
    s["x"] = Ball(c.x) * s["a_0"];
    const bool inside = c.x * c.x < 1;
    s["p_0"] = inside ? Ball(pstar_0 * hertz::pressure(s["x"] / lambda_0, load)) : Ball::indeterminate(); // (7.8) is defined in the contact
    s["p_n"] = Ball(q(4, 9));
    s["lambda_np1"] = Ball(q(5, 8));
    s["F_np1"] = s["p_n"] * s["lambda_np1"];
    const Ball lambda_1 = lambda_0 / gamma, g_1 = g_0 * weierstrass::amplitude_ratio(D, gamma), pstar_1 = pstar(g_1, lambda_1);
    s["lambda_1"] = lambda_1;
    s["g_1"] = g_1;
    s["F_1"] = Ball(q(1, 9));
    const Ball K(q(1, 2)), alpha(q(-13, 10)), beta(q(1, 3)), delta(q(3, 4));
    s["K_n"] = K;
    s["alpha_n"] = alpha;
    s["beta_n"] = beta;
    s["delta_n"] = delta;
    const auto area = [&](const Ball& lambda, const Ball& g, const Ball& share) {
        return lambda * K * pow(gamma, alpha) * pow(lambda / g, beta) * pow(share, delta);
    };
    s["A_n"] = area(lambda_0, g_0, load);
    s["A"] = area(lambda_1, g_1, s["F_1"] / (lambda_1 * pstar_1));
    // the power of gamma that the area of one wave of level 1 under a pressure has in the quantities of level 0
    const Ball pressed(q(2, 7));
    s["rho"] = log(area(lambda_1, g_1, pressed / pstar_1) / (lambda_0 * K * pow(lambda_0 / g_0, beta) * pow(pressed / pstar_0, delta))) /
               log(gamma);
    // summed over the contact: (2 sqrt(load))^delta (1 - xi^2)^(delta/2) over xi, as in the library's step of K
    s["A_np1"] = lambda_0 * K * pow(gamma, s["rho"] + 1) * pow(lambda_0 / g_0, beta) * archard::step(delta) * pow(load, (delta + 1) / 2);
    s["alpha_np1"] = s["rho"] + 1;
    s["beta_np1"] = beta;
    s["delta_np1"] =
        log(s["A_np1"] / (lambda_0 * K * pow(gamma, s["rho"] + 1) * pow(lambda_0 / g_0, beta) * archard::step(delta))) / log(load);
    s["A_0"] = 2 * s["a_0"];
    return s;
}

Meaning hertz_waves(const std::function<void(Situation&)>& change = {})
{
    Meaning m;
    for (const Parameters& c : cases) {
        m.situations.push_back(hertz_wave(c));
        if (change) change(m.situations.back());
    }
    return m;
}

/// (7.5), (7.7): one wave of level 1 under the pressure p_0(x).
void press_level_1(Situation& s)
{
    const Ball pstar_1 = evaluate(amplitude_of_pressure(sym("g_1"), 2 * GiNaC::Pi / sym("lambda_1")), s.value);
    s["F_1"] = s["p_0"] * s["lambda_1"];
    s["A"] = s["lambda_1"] * s["K_n"] * pow(s["gamma"], s["alpha_n"]) * pow(s["lambda_1"] / s["g_1"], s["beta_n"]) *
             pow(s["p_0"] / pstar_1, s["delta_n"]);
}

/// The sequence of section 7 at scale n.
Situation sequence(const Parameters& c, long n)
{
    Situation s;
    const Ball gamma(c.gamma), D(c.D), load(c.load), G = pow(gamma, D - 1);
    const Ball K = archard::K_by_recursion<Ball>(n);
    s["n"] = Ball(n);
    s["gamma"] = gamma;
    s["D"] = D;
    s["ptilde"] = load;
    s["lambda_0"] = Ball(2);
    s["K_n"] = K;
    s["K_np1"] = archard::K_by_recursion<Ball>(n + 1);
    s["delta_n"] = archard::delta<Ball>(n);
    s["delta_np1"] = archard::delta<Ball>(n + 1);
    s["beta_n"] = Ball(0);
    s["alpha_n"] = archard::alpha<Ball>(n, D);
    s["A_n"] = 2 * archard::area<Ball>(n, load, G, K);
    s["K_infinity"] = K_infinity();
    s.limit["K_n"] = K_infinity();
    s["alpha_0"] = archard::alpha<Ball>(0, D);
    s["beta_0"] = Ball(0);
    s["delta_0"] = archard::delta<Ball>(0);
    s["K_0"] = archard::K_by_recursion<Ball>(0);
    s.large_n = n > 30;
    return s;
}

Meaning sequences(const std::vector<long>& ns)
{
    Meaning m;
    for (const Parameters& c : {cases[0], cases[2]})
        for (const long n : ns) m.situations.push_back(sequence(c, n));
    return m;
}

} // namespace

void add_meanings_of_section_7(std::map<std::string, Meaning>& all)
{
    const auto inside = [](Meaning m) {
        std::erase_if(m.situations, [](const Situation& s) { return !s.value.at("p_0").is_finite(); });
        return m;
    };
    for (const char* id : {"7.1", "7.2", "7.3", "7.4", "7.6", "7.9", "7.11", "7.14"}) all[id] = inside(hertz_waves());
    all["7.12"] = all["7.6"];
    for (const char* id : {"7.2", "7.4", "7.6"})
        for (Situation& s : all[id].situations) s.value.erase("beta_np1"); // equal to beta_n, which only (7.12) says
    for (Situation& s : all["7.11"].situations) { // the names of the constants: any numbers
        s["K_np1"] = Ball(q(2, 7));
        s["alpha_np1"] = Ball(q(-17, 9));
        s["beta_np1"] = Ball(q(5, 11));
        s["delta_np1"] = Ball(q(8, 9));
        s["A_np1"] = s["lambda_0"] * s["K_np1"] * pow(s["gamma"], s["alpha_np1"]) * pow(s["lambda_0"] / s["g_0"], s["beta_np1"]) *
                     pow(s["ptilde"], s["delta_np1"]);
    }
    all["7.5"] = inside(hertz_waves(press_level_1));
    for (Situation& s : all["7.5"].situations) s.value.erase("beta_np1");
    all["7.7"] = hertz_waves([](Situation& s) {
        press_level_1(s);
        s["A_np1"] = s["p_0"].is_finite() ? s["A"] / s["lambda_1"] : Ball(0); // per unit length, within the contact
        s.value.erase("beta_np1");
        s.pointwise = "x";
    });
    all["7.8"] = inside(hertz_waves());
    // the integral over xi depends on delta alone: two situations are enough for it
    all["7.10"] = all["7.6"];
    all["7.10"].situations.resize(1);
    all["7.13"] = sequences({0, 2});
    all["7.13"].situations.resize(2);
    all["7.15"] = sequences({0});
    all["7.16"] = all["7.17"] = all["7.18"] = all["7.19"] = sequences({0, 1, 2, 5});
    for (Situation& s : all["7.15"].situations)
        for (const char* name : {"alpha_n", "beta_n", "delta_n", "K_n"}) s.value.erase(name); // at every n, not at 0 alone
    for (Situation& s : all["7.16"].situations) s.value.erase("beta_0");
    all["7.20"] = sequences({0});
    all["7.20"].situations.resize(1);
    all["7.21"] = sequences({1, 2, 90});
}

} // namespace touchstone::proofs
