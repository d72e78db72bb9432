// SPDX-License-Identifier: MIT
#include "touchstone/catalogue/formula.hpp"
#include "touchstone/paper/as_printed.hpp"
#include "touchstone/paper/peaks.hpp"
#include "touchstone/paper/westergaard.hpp"
#include "touchstone/transfer/contact.hpp"
#include "touchstone/transfer/forward.hpp"

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

// ---- distributions

using transfer::Law;

/// p_n^max in p*_0: G^{n+1} x_n by (5.2), (5.6).
Ball highest_pressure(const Inputs& in, long n)
{
    const Ball G = in.G_ball();
    Ball unit;
    arb_pow_ui(unit.get(), G.get(), static_cast<ulong>(n + 1), WorkingPrecision::bits());
    return unit * peaks::iterate(n, Ball(in.real("load")), G);
}

bool above_support(const Inputs& in, long n, const Rational& p)
{
    const WorkingPrecision precision(256);
    return certainly(less(highest_pressure(in, n), Ball(p)));
}

template <class F>
std::vector<Route> by_both_laws(F f)
{
    const auto route = [f](std::string name, Law law) {
        return Route{std::move(name), [f, law](const Inputs& in) -> Ball { return f(law, in); }};
    };
    return {route("forward-density", Law::density), route("forward-exceedance", Law::exceedance)};
}

void require_distribution(const Inputs& in, long n)
{
    require_partial_contact(in);
    if (n > transfer::Forward::largest_n)
        throw BeyondReach(fmt::format("the distribution of pressures is certified for the scales n <= {} only", transfer::Forward::largest_n));
}

void check_pressure(const Inputs& in)
{
    check_contact(in);
    require(in.real("p") >= 0, in, "p", ">= 0");
}

using Pressure = std::function<Ball()>;

Ball density(Law law, const Inputs& in, long n, const Pressure& p_at)
{
    require_distribution(in, n);
    if (const Ball p = p_at(); n == 0) {
        const Ball load(in.real("load"));
        return law == Law::density ? westergaard::density(p, load) : as_printed::density_partial(p, load);
    }
    else if (certainly(less(highest_pressure(in, n), p))) return Ball(0);
    return transfer::density(law, n, p_at, arguments(in));
}

Ball exceedance(Law law, const Inputs& in)
{
    const long n = in.integer("n");
    require_partial_contact(in);
    if (in.real("p") == 0) return transfer::area(law == Law::density ? Scheme::force_weighted : Scheme::area, n, arguments(in));
    require_distribution(in, n);
    const Ball p(in.real("p")), load(in.real("load"));
    if (n == 0) return law == Law::density ? westergaard::exceedance(p, load) : as_printed::exceedance_partial(p, load);
    return transfer::exceedance(law, n, [&in] { return Ball(in.real("p")); }, arguments(in));
}

/// (9.2)  The pressure at scale n - 1 that makes a segment of half-width a (in lambda_n): G^n sin^2(pi a).
Ball pressure_of_segment(const Inputs& in)
{
    Ball unit;
    arb_pow_ui(unit.get(), in.G_ball().get(), static_cast<ulong>(in.integer("n")), WorkingPrecision::bits());
    const Ball s = ScalarTraits<Ball>::sin_pi(Ball(in.real("a")));
    return unit * s * s;
}

std::string explain_distribution(const Inputs& in, long n, const Pressure& p_at, long digits)
{
    require_distribution(in, n);
    const WorkingPrecision precision(bits_for_digits(digits) + 48);
    if (n == 0) return "n = 0: (2.17), (2.19)\n";
    if (!certainly(less(p_at(), highest_pressure(in, n)))) return "above the support\n";
    return transfer::distribution_certificate(Law::density, n, p_at, arguments(in))
         + transfer::distribution_certificate(Law::exceedance, n, p_at, arguments(in));
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

    const auto explain_p = [](const Inputs& in, long digits) {
        return explain_distribution(in, in.integer("n"), [&in] { return Ball(in.real("p")); }, digits);
    };
    all.push_back({"contact.exceedance", "6.1", "1", "n from 0 to 10^4, p >= 0, load > 0, G > 1; computed for n <= 20, or p = 0, load <= 1, G > 2",
                   {"n", "p", "load", "G"}, "share of lambda_0 on which the pressure at scale n exceeds p (in p*_0)", check_pressure,
                   [](const Inputs& in) -> Exact {
                       if (in.real("load") <= 1 && in.compare_G(2) > 0 && above_support(in, in.integer("n"), in.real("p"))) return Exact(0);
                       throw NotExact();
                   },
                   by_both_laws(exceedance), explain_p, true});

    all.push_back({"contact.density", "6.1", "1/p*_0", "n from 0 to 10^4, p >= 0, load > 0, G > 1; computed for n <= 20, load <= 1, G > 2",
                   {"n", "p", "load", "G"}, "density q_n of the pressure at scale n, at p (in p*_0)", check_pressure,
                   [](const Inputs& in) -> Exact {
                       const bool at_zero = in.real("p") == 0 && (in.integer("n") > 0 || in.real("load") < 1); // q ~ p, (2.19)
                       if (in.real("load") <= 1 && in.compare_G(2) > 0 && (at_zero || above_support(in, in.integer("n"), in.real("p"))))
                           return Exact(0);
                       throw NotExact();
                   },
                   by_both_laws([](Law law, const Inputs& in) { return density(law, in, in.integer("n"), [&in] { return Ball(in.real("p")); }); }), explain_p, true});

    all.push_back({"segments.density", "9.3", "1", "n from 1 to 10^4, 0 <= a <= 1/2, load > 0, G > 1; computed for n <= 21, load <= 1, G > 2",
                   {"n", "a", "load", "G"}, "density of segments by half-width a (in lambda_n), N^_n lambda_n",
                   [](const Inputs& in) {
                       check_contact(in);
                       require_integer(in, "n", 1, largest_n);
                       require(in.real("a") >= 0 && in.real("a") <= Rational(1, 2), in, "a", ">= 0 and <= 1/2");
                   },
                   {}, by_both_laws([](Law law, const Inputs& in) {
                       const long n = in.integer("n");
                       Ball unit;
                       arb_pow_ui(unit.get(), in.G_ball().get(), static_cast<ulong>(n), WorkingPrecision::bits());
                       return pi<Ball>() * unit * ScalarTraits<Ball>::sin_pi(2 * Ball(in.real("a")))
                            * density(law, in, n - 1, [&in] { return pressure_of_segment(in); });
                   }),
                   [](const Inputs& in, long digits) { return explain_distribution(in, in.integer("n") - 1, [&in] { return pressure_of_segment(in); }, digits); }, true});

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
