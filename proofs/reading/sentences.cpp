// SPDX-License-Identifier: GPL-3.0-or-later
/// What the names in the machine forms of the sentences and figures stand for.
#include "proofs/lemmas/k_limit.hpp"
#include "proofs/reading/reading.hpp"

#include "touchstone/paper/archard.hpp"
#include "touchstone/paper/peaks.hpp"
#include "touchstone/paper/westergaard.hpp"

namespace touchstone::proofs {

namespace {

Rational q(long a, long b) { return Rational(a, b); }

/// One situation with these values.
Meaning just(std::map<std::string, Ball> values)
{
    Situation s;
    s.value = std::move(values);
    Meaning m;
    m.situations.push_back(std::move(s));
    return m;
}

/// A statement "if the print holds, so does this", at each gamma and D.
template <class True>
Meaning if_domain(const std::vector<Rational>& gammas, const std::vector<Rational>& Ds, std::set<std::size_t> stated, True&& is_true)
{
    Meaning m;
    m.stated = std::move(stated);
    m.one_way = true;
    for (const Rational& gamma : gammas)
        for (const Rational& D : Ds) {
            Situation s;
            s["gamma"] = Ball(gamma);
            s["D"] = Ball(D);
            s.wanted = is_true(gamma, D);
            m.situations.push_back(s);
        }
    return m;
}

/// gamma^(D-1) >= 1: the terms of (3.10) do not tend to zero.
bool terms_stay(const Rational& gamma, const Rational& D) { return (gamma - 1) * (D - 1) >= 0; }

/// Dimensions of closed sets without intervals: a point, Cantor's set, and one of positive length (text.dimension-below-one).
Meaning dimensions()
{
    Meaning m;
    for (const Ball& d : {Ball(0), Ball(log(Ball(2)) / log(Ball(3))), Ball(1)})
        m.situations.push_back(just({{"dimension", d}}).situations[0]);
    return m;
}

Meaning pressure_amplitudes()
{
    Meaning m;
    for (const Rational& G : {q(101, 100), q(3, 1)}) {
        const auto pstar = [&](long k) { return Ball(Ball(q(3, 70)) * pow(Ball(G), Ball(k))); };
        m.situations.push_back(just({{"n", Ball(2)}, {"pstar_0", pstar(0)}, {"pstar_n", pstar(2)}, {"pstar_np1", pstar(3)}}).situations[0]);
    }
    return m;
}

Meaning both_branches_of_f()
{
    Meaning m;
    for (const Rational& x : {q(1, 3), q(1, 1), q(7, 3)})
        m.situations.push_back(just({{"x", Ball(x)}, {"f_above", 1 + Ball(x)}, {"f_below", 2 * sqrt(Ball(x))}}).situations[0]);
    return m;
}

/// The largest load ratios at G = 3/2, below and above one.
Meaning largest_ratios()
{
    const Ball G(q(3, 2)), load(q(1, 10));
    const auto x = [&](long n) { return n == 0 ? load : peaks::iterate(n - 1, load, G); };
    long n_0 = 0;
    while (!certainly(less(Ball(1), x(n_0)))) ++n_0;
    Meaning m;
    for (long n = 0; n <= n_0 + 3; ++n)
        m.situations.push_back(
            just({{"n", Ball(n)}, {"n_0", Ball(n_0)}, {"x_nm1", x(n)}, {"x_n", x(n + 1)}, {"x_P", peaks::fixed_point(G)}}).situations[0]);
    return m;
}

struct Parameters {
    Rational gamma, D;
};
const std::vector<Parameters> profiles{{q(5, 1), q(3, 2)}, {q(9, 1), q(5, 4)}, {q(6, 5), q(19, 10)}, {q(101, 100), q(11, 10)}};

/// A name for the slope, with the gamma and D it depends on.
Meaning slopes(const char* name, Ball (*of)(const Ball& gamma, const Ball& D))
{
    Meaning m;
    for (const Parameters& c : profiles)
        m.situations.push_back(just({{"gamma", Ball(c.gamma)}, {"D", Ball(c.D)}, {name, of(Ball(c.gamma), Ball(c.D))}}).situations[0]);
    return m;
}

/// The full-contact thresholds 1, 1 + G, 1 + G + G^2, ... added up.
Meaning full_contact_thresholds()
{
    Meaning m;
    for (const Rational& G : {q(11, 10), q(3, 1)}) {
        Ball sum(0), term(1);
        for (long n = 0; n <= 4; ++n) {
            sum += term;
            term *= Ball(G);
            m.situations.push_back(just({{"G", Ball(G)}, {"n", Ball(n)}, {"threshold_n", sum}}).situations[0]);
        }
    }
    return m;
}

Meaning force()
{
    const Ball pbar(q(3, 8)), ptilde(q(21, 32)), lambda_0(q(7, 5)); // p*_0 = 4/7
    return just({{"pbar", pbar}, {"ptilde", ptilde}, {"lambda_0", lambda_0}, {"F_0", pbar * lambda_0}});
}

/// K_n and the exponents of (7.16) at n and its neighbours.
Meaning constants()
{
    Meaning m;
    for (const Parameters& c : profiles)
        for (const long n : {0L, 1L, 2L, 5L, 90L}) {
            Situation s;
            const Ball gamma(c.gamma), D(c.D);
            s["gamma"] = gamma;
            s["D"] = D;
            s["n"] = Ball(n);
            for (const auto& [index, k] : {std::pair{"n", n}, {"np1", n + 1}, {"0", 0L}}) {
                s[std::string("K_") + index] = archard::K_by_recursion<Ball>(k);
                s[std::string("alpha_") + index] = archard::alpha<Ball>(k, D);
                s[std::string("beta_") + index] = Ball(0);
                s[std::string("delta_") + index] = archard::delta<Ball>(k);
            }
            if (n > 0) s["K_nm1"] = archard::K_by_recursion<Ball>(n - 1);
            else s["K_nm1"] = 2 * s["K_0"]; // not defined; any number
            s["K_1"] = archard::K_by_recursion<Ball>(1);
            s["K_infinity"] = K_infinity();
            s["rho"] = s["alpha_n"] - 1 + (1 - D) * s["delta_n"];
            m.situations.push_back(s);
        }
    return m;
}

/// The centres of the gamma^n parts of (-lambda_0/2, lambda_0/2).
Meaning centres()
{
    Meaning m;
    for (const long gamma : {3L, 5L, 2L, 10L})
        for (const long n : {1L, 2L}) {
            const Rational parts = power(Rational(gamma), n);
            for (const long k : {0L, 1L}) {
                const Rational x = (Rational(k) + q(1, 2)) / parts - q(1, 2);
                const Ball lambda_0(q(7, 5));
                m.situations.push_back(just({{"gamma", Ball(gamma)},
                                             {"n", Ball(n)},
                                             {"D", Ball(q(3, 2))},
                                             {"lambda_0", lambda_0},
                                             {"x_centre", lambda_0 * Ball(x)}})
                                           .situations[0]);
            }
        }
    return m;
}

/// 2^-(n+1): what the power of the load changes by from scale to scale.
Meaning load_powers()
{
    Meaning m;
    for (const Parameters& c : profiles)
        for (const long n : {0L, 1L, 3L}) {
            const Ball gamma(c.gamma), power = ScalarTraits<Ball>::power_of_two(-(n + 1));
            m.situations.push_back(
                just({{"gamma", gamma}, {"D", Ball(c.D)}, {"n", Ball(n)}, {"load_power_of_length", power}, {"rate", power / log(gamma)}})
                    .situations[0]);
        }
    return m;
}

Ball minus_log_G(const Ball& gamma, const Ball& D) { return (1 - D) * log(gamma); }

} // namespace

void add_meanings_of_sentences(std::map<std::string, Meaning>& all)
{
    const std::vector<Rational> gammas{q(1, 2), q(1, 1), q(11, 10), q(5, 1)};
    const std::vector<Rational> Ds{q(-1, 1), q(0, 1),   q(1, 2), q(9, 10),
                                   q(1, 1),  q(11, 10), q(3, 2), q(19, 10)}; // D < 2: there is no profile beyond
    // the slope of log A from n = 0 to 1 at G^2 = 5: A_1/A_0 at a load of 1/1000 is below the bound of text.light-load-steeper, at loads
    // above 1 + G it is 1
    all["text.simple-fractal"] = just(
        {{"slope_small_load", log(sqrt(2 * sqrt(Ball(5))) * sqrt(sqrt(Ball(q(1, 1000)))) / sqrt(Ball(5)))}, {"slope_large_load", Ball(0)}});
    const Ball S(q(1, 9));
    all["text.probability"] = just({{"S", S}, {"total_full", Ball(1)}, {"total_partial", 2 * westergaard::half_width(S)}});
    all["text.fractal-domain"] = if_domain({q(5, 1)}, {q(1, 2), q(1, 1), q(11, 10), q(3, 2), q(19, 10), q(2, 1), q(3, 1)}, {0, 1},
                                           [](const Rational&, const Rational& D) { return D > 1 && D < 2; });
    all["text.series-diverges"] = if_domain(gammas, Ds, {0, 1}, terms_stay);
    all["text.divergence-D1"] = if_domain({q(3, 1)}, Ds, {0}, terms_stay);
    all["text.dimension-below-one"] = dimensions();
    all["text.pstar-increases"] = pressure_amplitudes();
    all["text.mean-pressure"] = just({{"mean_p_n", Ball(q(3, 8))}, {"pbar", Ball(q(3, 8))}});
    all["text.iteration-converges"] = both_branches_of_f();
    all["text.full-contact-persists"] = largest_ratios();
    all["text.conditional-contact"] = just({{"contact_share", Ball(1)}});
    all["text.slope-independent"] = all["text.limiting-slope"] = all["figure3"] = slopes("slope", minus_log_G);
    all["text.starts-full"] = full_contact_thresholds();
    all["text.load-force"] = all["text.force"] = force();
    all["text.delta-limit"] = just({{"delta_limit", Ball(1)}});
    all["text.constant-decreases"] = constants();
    all["text.peak-at-centre"] = centres();
    all["text.load-linear"] = all["text.slope-grows-with-load"] = load_powers();
    all["text.figure-5-load"] = just({{"ptilde", Ball(q(1, 1000))}});
    all["text.distribution-load"] = just({{"limit_at_load_1", Ball(q(3, 7))}, {"limit_at_load_2", Ball(q(3, 7))}});
    all["text.dimension-4-D"] = all["text.dimension-1.5"] = just({{"D3", Ball(q(5, 2))}, {"d_A3", Ball(q(3, 2))}});
    all["text.area-vanishes"] = just({{"A_limit", Ball(0)}});
    all["figure1"] = slopes("slope", [](const Ball& gamma, const Ball& D) { return pow(gamma, Ball(D - 1)); });
    all["figure4"] = slopes("slope", [](const Ball&, const Ball& D) { return Ball(2 - D); });
    all["figure5"] = just({{"area", Ball(1)}});
}

} // namespace touchstone::proofs
