// SPDX-License-Identifier: MIT
#include "touchstone/paper/archard.hpp"

#include "touchstone/catalogue/formula.hpp"
#include "touchstone/paper/archard_constants.hpp"
#include "touchstone/paper/archard_interpolation.hpp"
#include "touchstone/paper/segments.hpp"

#include <map>
#include <tuple>

namespace touchstone {
namespace {

constexpr long largest_n = 1'000'000;
/// To here Arb has Gamma functions from tables (archard_interpolation.hpp).
constexpr long quick_gamma_digits = 1000;

using Constant = Ball (*)(long);

/// K depends on n alone: whoever asks for it at one load asks for it at the next. Each thread keeps the last ones, as they came out.
Ball kept(Constant compute, long n)
{
    constexpr std::size_t most_kept = 256;
    thread_local std::map<std::tuple<Constant, long, slong>, Ball> all;
    const std::tuple key(compute, n, WorkingPrecision::bits());
    if (const auto found = all.find(key); found != all.end()) return found->second;
    if (all.size() == most_kept) all.clear();
    return all.emplace(key, compute(n)).first->second;
}

/// A route of a quantity that needs some K, once for each of the two ways to compute K.
template <class F>
std::vector<Route> by_both_K(F f)
{
    const auto route = [f](std::string name, Constant K, long leads_up_to) {
        return Route{.name = std::move(name),
                     .ball = [f, K](const Inputs& in) -> Ball { return f(in, Arguments<Ball>(in), [K](long n) { return kept(K, n); }); },
                     .takes_boxes = true,
                     .leads_up_to = leads_up_to,
                     .halved_as_second = true};
    };
    return {route("interpolation", archard::K_interpolated, quick_gamma_digits),
            route("gamma-product", archard::K_gamma_product, any_digits)};
}

void check_n(const Inputs& in) { require_integer(in, "n", 0, largest_n); }

void check_area(const Inputs& in)
{
    check_n(in);
    require_load(in);
    require_surface(in);
}

void check_segments(const Inputs& in)
{
    require_integer(in, "n", 1, largest_n);
    require_load(in);
    require_surface(in);
}

/// 1/2 as soon as the highest peaks are certainly in full contact, else by the exact x_{n-1} of (5.6).
Exact exact_max_half_width(const Inputs& in)
{
    const long n = in.integer("n");
    try {
        const Exact x = n == 0 ? Exact(in.real("load")) : exact_iterate(n - 1, in);
        return westergaard::half_width(at_most(x, Exact(1)));
    }
    catch (const NotExact&) {
        const WorkingPrecision precision(128);
        const Ball x = n == 0 ? Ball(in.real("load")) : peaks::iterate(n - 1, Ball(in.real("load")), in.G_ball());
        if (certainly(less(Ball(1), x))) return Exact(Rational(1, 2));
        throw;
    }
}

} // namespace

void add_archard(std::vector<Quantity>& all)
{
    all.push_back({"archard.K", "7.13", "1", "n from 0 to 10^6", {"n"},
                   "K_n of Archard's area law, by the recursion (7.13); (7.17) as printed is another number", check_n, {},
                   by_both_K([](const Inputs& in, const Arguments<Ball>&, const auto& K) { return K(in.integer("n")); })});

    all.push_back({"archard.K_inf", "7.20", "1", "none", {},
                   "limit of K_n as n grows", [](const Inputs&) {}, {},
                   by_both_K([](const Inputs&, const Arguments<Ball>&, const auto& K) { return K(archard::infinity); })});

    const auto delta = [](auto a) { return archard::delta<decltype(a("n"))>(a.integer("n")); };
    all.push_back({"archard.delta", "7.16", "1", "n from 0 to 10^6", {"n"},
                   "exponent of the load in the area law, 1 - 2^-(n+1)", check_n,
                   exactly(delta),
                   {through("closed-form", delta), {"recursion-7.12", [](const Inputs& in) {
                        Ball d(Rational(1, 2));
                        for (long i = 0; i < in.integer("n"); ++i) d = (d + 1) / 2;
                        return d;
                    }}}});

    const auto alpha = [](auto a) { return archard::alpha(a.integer("n"), a("D")); };
    all.push_back({"archard.alpha", "7.16", "1", "n from 0 to 10^6, 1 < D < 2", {"n", "D"},
                   "exponent of gamma in the area law, (1 - D)(n - 1 + 2^-n)",
                   [](const Inputs& in) { check_n(in); require(in.real("D") > 1 && in.real("D") < 2, in, "D", "> 1 and < 2"); },
                   exactly(alpha),
                   {through("closed-form", alpha), {"recursion-7.12", [](const Inputs& in) {
                        const Ball slope(Rational(1 - in.real("D")));
                        Ball a(0), d(Rational(1, 2));
                        for (long i = 0; i < in.integer("n"); ++i) {
                            a += slope * d;
                            d = (d + 1) / 2;
                        }
                        return a;
                    }}}});

    all.push_back({"archard.area", "7.18", "lambda0", "n from 0 to 10^6, load > 0, G > 1", {"n", "load", "G"},
                   "contact area in the Hertzian approximation, K_n G^-(n-1+2^-n) load^(1-2^-(n+1)), with K_n of (7.13)", check_area, {},
                   by_both_K([](const Inputs& in, const Arguments<Ball>& a, const auto& K) {
                       const long n = in.integer("n");
                       return archard::area(n, a("load"), a.G(), K(n));
                   })});

    all.push_back({"archard.segments", "8.2", "1", "n from 1 to 10^6, load > 0, 1 < D < 2, gamma > 1", {"n", "load", "D", "gamma"},
                   "expected number of contact segments in the Hertzian approximation", check_segments, {},
                   by_both_K([](const Inputs& in, const Arguments<Ball>& a, const auto& K) {
                       const long n = in.integer("n");
                       return archard::segments(n, a("load"), a("D"), a("gamma"), K(n - 1));
                   })});

    all.push_back({"archard.segments_limit", "8.3", "1", "n from 1 to 10^6, load > 0, 1 < D < 2, gamma > 1", {"n", "load", "D", "gamma"},
                   "limiting form of the number of segments at large n", check_segments, {},
                   by_both_K([](const Inputs& in, const Arguments<Ball>& a, const auto& K) {
                       return archard::segments_limit(in.integer("n"), a("load"), a("D"), a("gamma"), K(archard::infinity));
                   })});
}

void add_segments(std::vector<Quantity>& all)
{
    const auto widest = [](auto a) { return segments::max_half_width(a.integer("n"), a("load"), a.G()); };
    all.push_back({"segments.max_half_width", "9.4", "lambda_n", "n from 0 to 10^6, load > 0, G > 1", {"n", "load", "G"},
                   "largest half-width of a segment at scale n (the paper's (9.4) gives its limit without the square root)", check_area,
                   exact_max_half_width,
                   {through("steps", widest), {"arcsine", [](const Inputs& in) {
                        Ball x(in.real("load"));
                        const Ball G = in.G_ball();
                        for (long k = 0; k < in.integer("n"); ++k) {
                            const Ball below = 2 * sqrt(at_most(x, Ball(1)));
                            x = (certainly(less(x, Ball(1))) ? below : below + at_least(x, Ball(1)) - 1) / G;
                        }
                        if (certainly(less(x, Ball(1) / 2))) return asin(sqrt(x)) / pi<Ball>();
                        return Ball(1) / 2 - asin(sqrt_positive_part(1 - x)) / pi<Ball>(); // for at G = 2 a ball of x meets 1
                    }}}});
}

} // namespace touchstone
