// SPDX-License-Identifier: MIT
#include "touchstone/paper/peaks.hpp"

#include "touchstone/catalogue/formula.hpp"

namespace touchstone {
namespace {

/// (5.6) by logarithms while the contact is partial: log x_n = log(x_P) + 2^-k (log x - log x_P), one
/// formula for a whole run of k partial steps; full-contact runs as x_n = x_P + G^-k (x - x_P).
Ball iterate_in_runs(const Inputs& in)
{
    const Ball G = in.G_ball();
    const Ball log_G = log(G);
    const Ball log_fixed = 2 * log(Ball(2)) - 2 * log_G;
    Ball x(in.real("load"));
    for (long left = in.integer("n") + 1; left > 0;) {
        const Truth partial = less(x, Ball(1));
        if (partial == Truth::unknown) { // f is continuous: both branches meet at 2
            x = hull(2 * sqrt(at_most(x, Ball(1))), 1 + at_least(x, Ball(1))) / G;
            --left;
            continue;
        }
        // the longest run that certainly stays on this side of 1, by doubling
        const auto after = [&](long k) {
            if (partial == Truth::yes) return exp(log_fixed + power_of_two<Ball>(-k) * (log(x) - log_fixed));
            const Ball fixed = 1 / (G - 1);
            return fixed + exp(-k * log_G) * (x - fixed);
        };
        long run = 1;
        while (2 * run <= left && less(after(2 * run - 1), Ball(1)) == partial) run *= 2;
        x = after(run);
        left -= run;
    }
    return x;
}

} // namespace

Exact exact_iterate(long n, const Inputs& in)
{
    constexpr long longest = 128; // steps in which an exact x has repeated or outgrown its use
    const Exact G = in.G_exact();
    Exact x(in.real("load"));
    for (long k = 0; k <= n; ++k) {
        const Exact next = peaks::f(x) / G;
        if (next == x) return x; // the fixed point
        if (k > longest) throw NotExact();
        x = next;
    }
    return x;
}

void add_peaks(std::vector<Quantity>& all)
{
    const auto f = [](auto a) { return peaks::f(a("x")); };
    all.push_back({"peaks.f", "5.4, 5.5", "1", "x > 0", {"x"},
                   "peak pressure p_n^max/p*_n over a region of mean pressure x p*_n",
                   [](const Inputs& in) { require(in.real("x") > 0, in, "x", "> 0"); },
                   exactly(f),
                   {through("branches", f), {"power", [](const Inputs& in) {
                        const Rational& x = in.real("x");
                        return x < 1 ? exp(log(4 * Ball(x)) / 2) : Ball(Rational(x + 1));
                    }}}});

    const auto iterate = [](auto a) { return peaks::iterate(a.integer("n"), a("load"), a.G()); };
    all.push_back({"peaks.iterate", "5.6", "1", "n from 0 to 10^6, load > 0, G > 1", {"n", "load", "G"},
                   "x_n = p_n^max/p*_{n+1} from x_{-1} = load",
                   [](const Inputs& in) { require_integer(in, "n", 0, 1'000'000); require_load(in); require_surface(in); },
                   [](const Inputs& in) { return exact_iterate(in.integer("n"), in); },
                   {through("steps", iterate), {"runs", iterate_in_runs}}});

    all.push_back({"peaks.fixed_point", "5.8, 5.9", "1", "G > 1", {"G"},
                   "x_P, the limit of the iteration (5.6)", [](const Inputs& in) { require_surface(in); },
                   exactly([](auto a) { return peaks::fixed_point(a.G()); }),
                   {through("branches", [](auto a) { return peaks::fixed_point(a.G()); }),
                    {"logarithms", [](const Inputs& in) {
                        const Ball log_G = in.has("G") ? log(Ball(in.real("G")))
                                                       : Ball(Rational(in.real("D") - 1)) * log(Ball(in.real("gamma")));
                        if (in.compare_G(2) >= 0) return exp(2 * (log(Ball(2)) - log_G));
                        return exp(-log_G) / -detail::ball_of(arb_expm1, -log_G);
                    }}}});
}

} // namespace touchstone
