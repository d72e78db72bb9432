// SPDX-License-Identifier: MIT
#include "touchstone/catalogue/formula.hpp"
#include "touchstone/paper/westergaard.hpp"
#include "touchstone/transfer/contact.hpp"

#include <fmt/format.h>

namespace touchstone {
namespace {

using transfer::Scheme;

constexpr long largest_n = 10'000;

/// What transfer/ is proven for; the rest of the domain is not out of bounds, only out of reach.
void require_partial_contact(const Inputs& in)
{
    if (in.compare_G(2) <= 0)
        throw BeyondReach("not computed yet for G = gamma^(D-1) <= 2, where some regions stay in full contact at every scale");
    if (in.real("load") > 1)
        throw BeyondReach("not computed yet for load > 1, where the first scale is in full contact");
}

transfer::Arguments arguments(const Inputs& in)
{
    return {[&in] { return Ball(in.real("load")); }, [&in] { return in.G_ball(); }};
}

/// The two discretisations of the transfer operator as routes of f(scheme, inputs).
template <class F>
std::vector<Route> by_both_schemes(F f)
{
    const auto route = [f](std::string name, Scheme scheme) {
        return Route{std::move(name), [f, scheme](const Inputs& in) -> Ball {
                         require_partial_contact(in);
                         return f(scheme, in);
                     }};
    };
    return {route("force-weighted-chebyshev", Scheme::force_weighted), route("area-gauss-panels", Scheme::area)};
}

std::string explain_area(const Inputs& in, long n, long digits)
{
    require_partial_contact(in);
    if (n == 0) return "A_0 = (2/pi) arcsin sqrt(load), (6.6)\n";
    const WorkingPrecision precision(bits_for_digits(digits) + 48);
    return transfer::area_certificate(Scheme::force_weighted, n, arguments(in))
         + transfer::area_certificate(Scheme::area, n, arguments(in));
}

void check_contact(const Inputs& in)
{
    require_integer(in, "n", 0, largest_n);
    require_load(in);
    require_surface(in);
}

} // namespace

void add_contact(std::vector<Quantity>& all)
{
    all.push_back({"contact.area", "6.7", "lambda0", "n from 0 to 10^4, load > 0, G > 1; computed for load <= 1, G > 2", {"n", "load", "G"},
                   "total contact area at scale n in one wavelength of the largest scale", check_contact,
                   [](const Inputs& in) -> Exact {
                       if (in.integer("n") > 0 || in.real("load") > 1) throw NotExact();
                       return 2 * westergaard::half_width(Exact(in.real("load")));
                   },
                   by_both_schemes([](Scheme s, const Inputs& in) { return transfer::area(s, in.integer("n"), arguments(in)); }),
                   [](const Inputs& in, long digits) { return explain_area(in, in.integer("n"), digits); }});

    all.push_back({"segments.count", "8.1", "1", "n from 1 to 10^4, load > 0, 1 < D < 2, gamma > 1; computed for load <= 1, G > 2",
                   {"n", "load", "D", "gamma"}, "expected number of contact segments at scale n in one wavelength, A_{n-1}/lambda_n",
                   [](const Inputs& in) { check_contact(in); require_integer(in, "n", 1, largest_n); },
                   [](const Inputs& in) -> Exact {
                       if (in.integer("n") > 1 || in.real("load") > 1) throw NotExact();
                       return 2 * (westergaard::half_width(Exact(in.real("load"))) * Exact(in.real("gamma")));
                   },
                   by_both_schemes([](Scheme s, const Inputs& in) {
                       const long n = in.integer("n");
                       Ball power(in.real("gamma"));
                       arb_pow_ui(power.get(), power.get(), static_cast<ulong>(n), WorkingPrecision::bits());
                       return transfer::area(s, n - 1, arguments(in)) * power;
                   }),
                   [](const Inputs& in, long digits) { return explain_area(in, in.integer("n") - 1, digits); }});
}

} // namespace touchstone
