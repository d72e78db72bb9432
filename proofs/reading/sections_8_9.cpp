// SPDX-License-Identifier: GPL-3.0-or-later
/// What the symbols of sections 8 and 9 stand for.
#include "proofs/enclosure/enclosure.hpp"
#include "proofs/lemmas/k_limit.hpp"
#include "proofs/reading/reading.hpp"

#include "touchstone/paper/archard.hpp"
#include "touchstone/paper/peaks.hpp"
#include "touchstone/paper/segments.hpp"
#include "touchstone/paper/westergaard.hpp"
#include "touchstone/scalar/symbol.hpp"

namespace touchstone::proofs {

namespace {

Rational q(long a, long b) { return Rational(a, b); }

struct Parameters {
    Rational gamma, D, load;
};
const std::vector<Parameters> cases{{q(5, 1), q(3, 2), q(1, 6)}, {q(7, 1), q(5, 4), q(1, 17)}};

/// Scale n of the Hertzian approximation, or with any area at the scale before.
Situation scale(const Parameters& c, long n, bool hertz)
{
    Situation s;
    const Ball gamma(c.gamma), D(c.D), load(c.load), lambda_0(2), K = archard::K_by_recursion<Ball>(n - 1);
    s["n"] = Ball(n);
    s["gamma"] = gamma;
    s["D"] = D;
    s["ptilde"] = load;
    s["lambda_0"] = lambda_0;
    s["lambda_n"] = lambda_0 / pow(gamma, Ball(n));
    s["epsilon"] = s["lambda_n"] / lambda_0;
    s["K_nm1"] = K;
    s["K_n"] = K * archard::step(archard::delta<Ball>(n - 1));
    s["K_infinity"] = K_infinity();
    if (!hertz) s["A_nm1"] = Ball(q(3, 7));
    s["N"] = hertz ? archard::segments<Ball>(n, load, D, gamma, K) : Ball(s["A_nm1"] / s["lambda_n"]);
    s["Nlim"] = archard::segments_limit<Ball>(n, load, D, gamma, K_infinity());
    s["d_A"] = log(archard::segments_limit<Ball>(n + 1, load, D, gamma, K_infinity()) / s["Nlim"]) / log(gamma);
    s.large_n = n > 30;
    return s;
}

Meaning scales(const std::vector<long>& ns, bool hertz)
{
    Meaning m;
    for (const Parameters& c : cases)
        for (const long n : ns) m.situations.push_back(scale(c, n, hertz));
    return m;
}

/// A wave of scale n under the pressure p, and Westergaard's law at another load as an example of a law at scale n - 1.
Situation segment(const Rational& p, const Rational& threshold, long n)
{
    Situation s;
    const Ball pstar(q(3, 2)), lambda(q(7, 5)), load_before(q(1, 3)), unit(q(9, 4)); // unit: p*_{n-1}
    s["n"] = Ball(n);
    s["pstar_n"] = pstar;
    s["lambda_n"] = lambda;
    s["p_nm1"] = Ball(threshold) * pstar;
    s["a"] = lambda * westergaard::half_width(Ball(p));
    s["a_n"] = lambda * westergaard::half_width(Ball(threshold));
    s.wanted = p > threshold;
    s.function["Q_nm1"] = [=](const Ball& at) { return westergaard::exceedance(Ball(at / unit), load_before); };
    s.function["q_nm1"] = [=](const Ball& at) { return Ball(westergaard::density(Ball(at / unit), load_before) / unit); };
    s["N_n"] = s.function["Q_nm1"](s["p_nm1"]) / lambda;
    // d p/d a from the library's half-width
    const ex S = sym("S");
    const Ball slope = evaluate(westergaard::half_width<Symbol>(S).diff(GiNaC::ex_to<GiNaC::symbol>(S)), Point{{"S", threshold}});
    const Ball dN = -s.function["q_nm1"](s["p_nm1"]) * pstar / (slope * lambda) / lambda;
    s.derivative[{"N_n", "a_n"}] = dN;
    s["Nhat_n"] = -lambda * dN;
    return s;
}

Meaning segments()
{
    Meaning m;
    for (const Rational& p : {q(1, 20), q(1, 3), q(3, 5), q(9, 10)})
        for (const Rational& threshold : {q(1, 10), q(2, 5), q(7, 10)}) m.situations.push_back(segment(p, threshold, 3));
    return m;
}

Meaning longest()
{
    Meaning m;
    for (const Rational& G : {q(5, 2), q(4, 1)}) {
        Situation s;
        const Ball g(G), lambda(q(7, 5));
        s["x_P"] = peaks::fixed_point(g);
        s["lambda_n"] = lambda;
        s["a_n"] = Ball(q(1, 7));
        s["amax_n"] = lambda * westergaard::half_width(s["x_P"]);
        m.situations.push_back(s);
    }
    return m;
}

} // namespace

void add_meanings_of_sections_8_9(std::map<std::string, Meaning>& all)
{
    all["8.1"] = scales({1, 3}, false);
    all["8.2"] = scales({1, 2, 4}, true);
    all["8.3"] = scales({1, 2, 90}, true);
    all["8.4"] = all["8.5"] = all["8.6"] = all["8.7"] = scales({1, 2, 4}, true);
    all["9.1"] = segments();
    all["9.1"].stated = {0};
    all["9.2"] = all["9.3"] = segments();
    for (const char* id : {"9.2", "9.3"})
        for (Situation& s : all[id].situations) s.wanted.reset();
    all["9.4"] = longest();
}

} // namespace touchstone::proofs
