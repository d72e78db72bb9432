// SPDX-License-Identifier: MIT
#include "touchstone/catalogue/formula.hpp"
#include "touchstone/paper/as_printed.hpp"
#include "touchstone/paper/peaks.hpp"
#include "touchstone/paper/westergaard.hpp"
#include "touchstone/transfer/contact.hpp"
#include "touchstone/transfer/forward.hpp"
#include "touchstone/transfer/full_contact.hpp"
#include "touchstone/transfer/heavy_load.hpp"
#include "touchstone/transfer/proven_levels.hpp"
#include "touchstone/recursion/first_steps/area_by_slope.hpp"
#include "touchstone/recursion/first_steps/nested.hpp"
#include "touchstone/recursion/first_steps/scale_one.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace touchstone {
namespace {

using transfer::Scheme;

constexpr long largest_n = 10'000;

/// What transfer/ is proven for; the rest of the domain is not out of bounds, only out of reach.
void require_G_above_2(const Inputs& in)
{
    if (in.compare_G(2) <= 0)
        throw BeyondReach("no proof for G = gamma^(D-1) <= 2, where some regions stay in full contact at every scale");
}
void require_partial_contact(const Inputs& in)
{
    require_G_above_2(in);
    if (in.real("load") > 1)
        throw BeyondReach("no proof for load > 1, where the first scale is in full contact");
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
                         return f(scheme, in);
                     }};
    };
    return {route("force-weighted-chebyshev", Scheme::force_weighted), route("area-gauss-panels", Scheme::area)};
}

using Pressure = std::function<Ball()>;

transfer::ScaleOne at_scale_one(const Inputs& in, const Pressure& p_at, std::optional<Rational> p = std::nullopt)
{
    transfer::ScaleOne q{p_at, in.real("load"), [&in] { return in.G_ball(); }, std::move(p), std::nullopt};
    try {
        if (const Exact G = in.G_exact(); G.is_rational()) q.exact_G = G.rational();
    }
    catch (const NotExact&) {
    }
    return q;
}

/// Where some regions may be in full contact: the proven levels, and a grid of full_contact.hpp, which they do not share anything with. The
/// latter's radius is an estimate; the proof is the former's alone, and so are the digits.
bool full_contact(const Inputs& in)
{
    return in.compare_G(2) <= 0 || in.real("load") > 1;
}
/// A_1 is one integral between known points, whatever the load and G.
bool area_by_first_steps(long n) { return n == 1; }
Ball area_at_scale_one(Scheme scheme, const Inputs& in)
{
    const auto variable = scheme == Scheme::force_weighted ? transfer::Variable::ratio : transfer::Variable::angle;
    return transfer::scale_one_exceedance(variable, at_scale_one(in, [] { return Ball(0); }, Rational(0)));
}
/// A_n, n >= 1. Above load 1 heavy_load.hpp has two proofs, but is slow, or does not apply, towards G = 2.
/// A_2 is one integral over closed forms; where no region is in full contact there are two proofs already.
bool area_by_slope(const Inputs& in, long n) { return n == 2 && (in.real("load") > 1 || in.compare_G(Rational(2'000'001, 1'000'000)) < 0); }
bool area_by_proven_levels(const Inputs& in, long n)
{
    if (area_by_first_steps(n) || area_by_slope(in, n)) return false;
    if (in.compare_G(Rational(2'000'001, 1'000'000)) < 0) return true;
    if (in.real("load") <= 1) return false;
    return in.compare_G(n <= transfer::ProvenLevels::levels && in.real("load") <= 100 ? Rational(16, 5) : Rational(101, 50)) <= 0;
}

Ball with_radius(const Estimate& e)
{
    Ball result = e.value;
    arb_add_error(result.get(), (64 * e.error + abs(e.value) * Ball(Rational(1, 1'000'000'000'000'000))).get());
    return result;
}

/// A_n, n >= 1
Ball area_with_full_contact(Scheme scheme, long n, const Inputs& in)
{
    if (scheme == Scheme::force_weighted) return transfer::area_by_proven_levels(n, arguments(in));
    return with_radius(transfer::estimated_area(transfer::Grid::blind, n, Ball(in.real("load")), in.G_ball()));
}

/// A_n, certified: both schemes; n = 0 is (6.6) for any G.
Ball certified_area(Scheme scheme, long n, const Inputs& in)
{
    if (area_by_first_steps(n)) return area_at_scale_one(scheme, in);
    if (area_by_slope(in, n)) {
        constexpr slong guard = 40; // of the 48 bits that evaluate() adds to the digits
        const transfer::ScaleOne q = at_scale_one(in, [] { return Ball(0); }, Rational(0));
        if (scheme == Scheme::force_weighted) return transfer::area_by_slope(n, {q.load, q.G, q.exact_G}, WorkingPrecision::bits() - guard);
        const auto [value, error] = transfer::nested_area(q.load.get_d(), arf_get_d(arb_midref(in.G_ball().get()), ARF_RND_NEAR));
        return with_radius({Ball::exactly(value), Ball::exactly(error)});
    }
    if (n > 0 || in.real("load") > 1) {
        if (area_by_proven_levels(in, n)) return area_with_full_contact(scheme, n, in);
        return in.real("load") > 1 ? transfer::area_at_heavy_load(scheme, n, arguments(in)) : transfer::area(scheme, n, arguments(in));
    }
    const Ball x(in.real("load"));
    if (scheme == Scheme::area) return 2 * westergaard::half_width(x);
    Ball angle; // the other inverse function
    arb_atan2(angle.get(), sqrt(x).get(), sqrt(1 - x).get(), WorkingPrecision::bits());
    return 2 * angle / pi<Ball>();
}

/// Whether p_n > p almost everywhere, p >= 0: load - (1 + G + ... + G^n) >= p, by (5.2), (5.4).
bool everywhere_above(const Inputs& in, long n, const Rational& p)
{
    const Rational load = in.real("load") - p;
    if (load < 1) return false;
    const WorkingPrecision precision(256);
    const auto tie = [&](long scale) { // G irrational: G^k = r with r rational, and no sum of such powers is rational
        try {
            const Exact G = in.G_exact();
            if (!G.is_rational()) return false;
            Rational sum = 1, power = 1;
            for (long k = 0; k < scale; ++k) sum += power *= G.rational();
            return load >= sum;
        }
        catch (const NotExact&) {
            return false;
        }
    };
    return transfer::scales_in_full_contact(Ball(load), in.G_ball(), n + 1, tie) > n;
}

/// lambda_0/lambda_n = gamma^n
Ball potential_segments(const Inputs& in)
{
    Ball power(in.real("gamma"));
    arb_pow_ui(power.get(), power.get(), static_cast<ulong>(in.integer("n")), WorkingPrecision::bits());
    return power;
}

/// The two grids where full contact occurs as estimates f(grid, inputs).
template <class F>
std::vector<EstimateRoute> by_both_grids(F f)
{
    const auto route = [f](std::string name, transfer::Grid grid) {
        return EstimateRoute{std::move(name), [f, grid](const Inputs& in) -> Estimate { return f(grid, in); }};
    };
    return {route("blind-halving", transfer::Grid::blind), route("tracked-singular-points", transfer::Grid::tracked)};
}

Estimate scaled(const Estimate& e, const Ball& factor) { return {e.value * factor, e.error * factor}; }

Estimate estimated_area(transfer::Grid grid, long n, const Inputs& in)
{
    return transfer::estimated_area(grid, n, Ball(in.real("load")), in.G_ball());
}

/// Beyond, the grids do not resolve the functions, and take minutes to find out.
void require_estimated(long n)
{
    if (n > transfer::Forward::largest_n) throw BeyondReach(fmt::format("distributions of pressure are computed for the scales n <= {} only", transfer::Forward::largest_n));
}

Quantity::Limits proven_levels_limits(bool reached) { return reached ? Quantity::Limits{20, true} : Quantity::Limits{}; }

Quantity::Limits area_limits(const Inputs& in, long n)
{
    if (area_by_slope(in, n)) return {.first_decides = true};
    return proven_levels_limits(n > 0 && area_by_proven_levels(in, n));
}

const std::vector<std::string> proven_route_names{"proven-levels", "blind-halving (overlaps, estimated)"};

std::vector<std::string> area_route_names(const Inputs& in, long n)
{
    if (area_by_first_steps(n)) return {"scale-one-by-ratio", "scale-one-by-angle"};
    if (area_by_slope(in, n)) return {"slope-of-two-waves", "nested-quadrature (overlaps, estimated)"};
    if (n > 0 && area_by_proven_levels(in, n)) return proven_route_names;
    return {"force-weighted-chebyshev", "area-gauss-panels"};
}

std::string explain_area(const Inputs& in, long n, long digits)
{
    if (n == 0) return "A_0 = (2/pi) arcsin sqrt(load), (6.6)\n";
    if (area_by_slope(in, n)) return "n = 2: one integral of the share above each pressure at scale 0 times the slope of A_1, a complete integral of genus 1 or 2 (recursion/first_steps/area_by_slope.hpp)\n";
    if (area_by_first_steps(n)) return "n = 1: one integral by the pressure at scale 0 and by the angle of the wave of scale 1, in complex balls (recursion/first_steps/scale_one.hpp)\n";
    const WorkingPrecision precision(bits_for_digits(digits) + 48);
    if (area_by_proven_levels(in, n)) return transfer::area_by_proven_levels_certificate(n, arguments(in));
    if (in.real("load") > 1)
        return transfer::heavy_load_certificate(Scheme::force_weighted, n, arguments(in))
             + transfer::heavy_load_certificate(Scheme::area, n, arguments(in));
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

/// Whether p = p_n^max exactly: f(x) = (x + 1)/G for x >= 1, 2 x^(1/2)/G for x < 1 (5.5), once irrational, stays so while G is rational.
bool at_edge(const Inputs& in, long n, const Rational& p)
{
    {
        const WorkingPrecision precision(512);
        if (!highest_pressure(in, n).contains(p)) return false;
    }
    const Exact G_exact = in.G_exact();
    if (!G_exact.is_rational()) throw NotExact();
    const Rational G = G_exact.rational();
    Rational x = in.real("load"), unit = 1;
    for (long k = 0; k <= n; ++k, unit *= G) {
        if (x < 1) {
            if (!mpz_perfect_square_p(x.get_num_mpz_t()) || !mpz_perfect_square_p(x.get_den_mpz_t())) return false;
            x = 2 * Rational(mpz_class(sqrt(x.get_num())), mpz_class(sqrt(x.get_den())));
        }
        else x += 1;
        x /= G;
    }
    return p == x * unit;
}

/// Whether the share above p, or for n >= 2 the density (which goes with (p_n^max - p)^((n-1)/2) there), is exactly 0.
bool nothing_at(const Inputs& in, long n, bool edge_too)
{
    if (above_support(in, n, in.real("p"))) return true;
    return edge_too && at_edge(in, n, in.real("p"));
}

/// p certainly less than p_n^min > 0, in full contact everywhere.
bool below_support(const Inputs& in, long n, const Rational& p)
{
    const WorkingPrecision precision(256);
    return transfer::scales_in_full_contact(Ball(Rational(in.real("load") - p)), in.G_ball(), n + 1, [](long) { return false; }) > n;
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
        throw BeyondReach(fmt::format("distributions of pressure are computed for the scales n <= {} only", transfer::Forward::largest_n));
}

void check_pressure(const Inputs& in)
{
    check_contact(in);
    require(in.real("p") >= 0, in, "p", ">= 0");
}

/// Whether the forward levels serve: partial contact at every scale, and no highest ratio e_k, (5.6), k <= n, so near 1 that what is left of
/// their sector is too narrow (measured: from 0.999 on they refuse). Only a choice between proofs, hence in binary64.
bool by_forward_levels(const Inputs& in, long n)
{
    if (full_contact(in)) return false;
    const double G = arf_get_d(arb_midref(in.G_ball().get()), ARF_RND_NEAR);
    double e = in.real("load").get_d();
    for (long k = 0; k <= std::min(n, transfer::Forward::largest_n); ++k, e = 2 * std::sqrt(e) / G)
        if (e > 0.998 && e < 1) return false;
    return true;
}

/// Scale 1 has a certified route of its own where they don't, and far below p_1^max, where the exceedance law's density cancels.
bool by_scale_one(const Inputs& in, long n, const Ball& p)
{
    if (n != 1 || !by_forward_levels(in, n)) return n == 1;
    return certainly(less(Ball(0), p)) && certainly(less(Ball(Rational("100000000000000000000")) * p, highest_pressure(in, 1)));
}

transfer::Variable variable(Law law) { return law == Law::density ? transfer::Variable::ratio : transfer::Variable::angle; }

std::vector<std::string> law_names(const Inputs& in, long n, const Ball& p)
{
    if (by_scale_one(in, n, p)) return {"scale-one-by-ratio", "scale-one-by-angle"};
    return {"forward-density", "forward-exceedance"};
}

void require_pressure(const Ball& p)
{
    if (!certainly(less(Ball(0), p))) throw BeyondReach("not computed at p = 0, where q_n is 0 unless a singular point lies there; ask for p > 0");
}

/// At p_0^max, and at p_0^min > 0 and load = 1, p = 0, where (2.19) goes with p^(-1/2).
bool infinite_first_density(const Rational& p, const Rational& load)
{
    return load < 1 ? p * p == 4 * load : p == load + 1 || p == load - 1;
}

/// p*_n/p*_0
Ball unit_pressure(const Inputs& in, long n)
{
    Ball unit;
    arb_pow_ui(unit.get(), in.G_ball().get(), static_cast<ulong>(n), WorkingPrecision::bits());
    return unit;
}
Ball pressure_ratio(const Inputs& in, long n) { return Ball(in.real("p")) / unit_pressure(in, n); }

/// Scales from 2 on where the forward levels don't serve.
bool density_by_proven_levels(const Inputs& in, long n) { return n > 1 && !by_forward_levels(in, n); }

Ball density(Law law, const Inputs& in, long n, const Pressure& p_at, std::optional<Rational> exact_p = std::nullopt)
{
    if (by_scale_one(in, n, p_at())) {
        require_pressure(p_at());
        return transfer::scale_one_density(variable(law), at_scale_one(in, p_at, std::move(exact_p)));
    }
    const bool proven = density_by_proven_levels(in, n);
    if (n > 0 && !proven) require_distribution(in, n);
    const Ball p = p_at();
    if (certainly(less(highest_pressure(in, n), p))) return Ball(0);
    if (proven) {
        require_pressure(p);
        if (law == Law::density) return transfer::density_by_proven_levels(n, [&] { return p_at() / unit_pressure(in, n); }, arguments(in)) / unit_pressure(in, n);
        return with_radius(transfer::estimated_density(transfer::Grid::blind, n, p, Ball(in.real("load")), in.G_ball()));
    }
    if (n == 0) {
        const Ball load(in.real("load"));
        if (exact_p && infinite_first_density(*exact_p, in.real("load"))) throw BeyondReach("q_0 is infinite at this pressure, an end of its support");
        if (certainly(less(p, load - 1))) return Ball(0);
        if (law == Law::density) return westergaard::density(p, load);
        return in.real("load") < 1 ? as_printed::density_partial(p, load) : as_printed::density_full(p, load);
    }
    return transfer::density(law, n, p_at, arguments(in));
}

std::vector<std::string> density_route_names(const Inputs& in, long n, const Ball& p)
{
    return density_by_proven_levels(in, n) ? proven_route_names : law_names(in, n, p);
}

/// Beyond 15 digits the meshes of densities grow without end (proven_levels.md).
Quantity::Limits density_limits(const Inputs& in, long n) { return density_by_proven_levels(in, n) ? Quantity::Limits{15, true} : Quantity::Limits{}; }

/// The share above p is by the proven levels.
bool exceedance_by_proven_levels(const Inputs& in)
{
    const long n = in.integer("n");
    return in.real("p") == 0 ? n > 0 && area_by_proven_levels(in, n) : n > 1 && !by_forward_levels(in, n);
}

Estimate estimated_density(transfer::Grid grid, long n, const Inputs& in, const Pressure& p_at, std::optional<Rational> exact_p = std::nullopt)
{
    require_estimated(n);
    if (n == 1 && !full_contact(in) && highest_pressure(in, n).overlaps(p_at())) throw BeyondReach("q_1 jumps at p = p_1^max: it has no value there");
    if (n == 0) density(Law::density, in, n, p_at, std::move(exact_p)); // as below
    require_pressure(p_at());
    if (by_scale_one(in, n, p_at())) density(Law::density, in, n, p_at, std::move(exact_p)); // refuses, and says why: no estimate is better
    return transfer::estimated_density(grid, n, p_at(), Ball(in.real("load")), in.G_ball());
}

Ball exceedance(Law law, const Inputs& in)
{
    const long n = in.integer("n");
    if (in.real("p") == 0) return certified_area(law == Law::density ? Scheme::force_weighted : Scheme::area, n, in);
    if (n == 0) {
        const Ball p(in.real("p")), load(in.real("load"));
        if (law == Law::density) return westergaard::exceedance(p, load);
        return in.real("load") < 1 ? as_printed::exceedance_partial(p, load) : as_printed::exceedance_full(p, load);
    }
    const Pressure p_at = [&in] { return Ball(in.real("p")); };
    if (by_scale_one(in, n, p_at())) return transfer::scale_one_exceedance(variable(law), at_scale_one(in, p_at, in.real("p")));
    if (exceedance_by_proven_levels(in)) {
        if (law == Law::density) return transfer::exceedance_by_proven_levels(n, [&] { return pressure_ratio(in, n); }, arguments(in));
        return with_radius(transfer::estimated_exceedance(transfer::Grid::blind, n, Ball(in.real("p")), Ball(in.real("load")), in.G_ball()));
    }
    require_distribution(in, n);
    return transfer::exceedance(law, n, p_at, arguments(in));
}

std::string explain_distribution(const Inputs& in, long n, const Pressure& p_at, long digits)
{
    if (by_scale_one(in, n, p_at())) return "n = 1: one integral by the pressure at scale 0 and by the angle of the wave of scale 1, in complex balls (recursion/first_steps/scale_one.hpp)\n";
    if (n == 0) return "n = 0: (2.14) to (2.19)\n";
    const WorkingPrecision precision(bits_for_digits(digits) + 48);
    if (density_by_proven_levels(in, n)) return transfer::density_by_proven_levels_certificate(n, [&] { return p_at() / unit_pressure(in, n); }, arguments(in));
    require_distribution(in, n);
    if (!certainly(less(p_at(), highest_pressure(in, n)))) return "above the support\n";
    return transfer::distribution_certificate(Law::density, n, p_at, arguments(in))
         + transfer::distribution_certificate(Law::exceedance, n, p_at, arguments(in));
}

/// (9.3): the pressure at scale n - 1 under which segments have half-width a, and what q_{n-1} is multiplied by.
/// Regions in full contact at scale n, p_{n-1} >= p*_n, have no ends there, a = 1/2 and beyond: they are in no segment.
std::pair<Ball, Ball> of_segments(const Inputs& in)
{
    const Ball a(in.real("a")), s = ScalarTraits<Ball>::sin_pi(a);
    Ball unit;
    arb_pow_ui(unit.get(), in.G_ball().get(), static_cast<ulong>(in.integer("n")), WorkingPrecision::bits());
    return {unit * s * s, pi<Ball>() * unit * ScalarTraits<Ball>::sin_pi(2 * a)};
}

} // namespace

void add_contact(std::vector<Quantity>& all)
{
    all.push_back({"contact.area", "6.7", "lambda0", "n from 0 to 10^4, load > 0, G > 1; certified for load <= 1, G >= 2.000001; and for n <= 2; to 20 digits for load < 1000, G > 2.02 and n <= 20, load <= 100, G > 1.003 elsewhere; else estimated for n <= 100", {"n", "load", "G"},
                   "total contact area at scale n in one wavelength of the largest scale", check_contact,
                   [](const Inputs& in) -> Exact {
                       if (everywhere_above(in, in.integer("n"), 0)) return Exact(1);
                       if (in.integer("n") > 0) throw NotExact();
                       return 2 * westergaard::half_width(Exact(in.real("load")));
                   },
                   by_both_schemes([](Scheme s, const Inputs& in) { return certified_area(s, in.integer("n"), in); }),
                   [](const Inputs& in, long digits) { return explain_area(in, in.integer("n"), digits); }, false,
                   by_both_grids([](transfer::Grid g, const Inputs& in) { return estimated_area(g, in.integer("n"), in); }),
                   [](const Inputs& in) { return area_route_names(in, in.integer("n")); }, [](const Inputs& in) { return area_limits(in, in.integer("n")); }});

    const auto explain_p = [](const Inputs& in, long digits) {
        const long n = in.integer("n");
        if (n > 0 && in.real("p") == 0) return explain_area(in, n, digits);
        return explain_distribution(in, in.integer("n"), [&in] { return Ball(in.real("p")); }, digits);
    };
    const auto explain_exceedance = [explain_p](const Inputs& in, long digits) {
        const long n = in.integer("n");
        if (!exceedance_by_proven_levels(in) || in.real("p") == 0) return explain_p(in, digits);
        const WorkingPrecision precision(bits_for_digits(digits) + 48);
        return transfer::exceedance_by_proven_levels_certificate(n, [&] { return pressure_ratio(in, n); }, arguments(in));
    };
    all.push_back({"contact.exceedance", "6.1", "1", "n from 0 to 10^4, p >= 0, load > 0, G > 1; certified for n <= 1, or n <= 20, load <= 1, G > 2; to 20 digits for n <= 20, load <= 100, G > 1.003; else estimated for n <= 20",
                   {"n", "p", "load", "G"}, "share of lambda_0 on which the pressure at scale n exceeds p (in p*_0)", check_pressure,
                   [](const Inputs& in) -> Exact {
                       if (nothing_at(in, in.integer("n"), true)) return Exact(0);
                       if (everywhere_above(in, in.integer("n"), in.real("p"))) return Exact(1);
                       throw NotExact();
                   },
                   by_both_laws(exceedance), explain_exceedance, true,
                   by_both_grids([](transfer::Grid g, const Inputs& in) {
                       const long n = in.integer("n");
                       if (in.real("p") == 0) return estimated_area(g, n, in);
                       require_estimated(n);
                       return transfer::estimated_exceedance(g, n, Ball(in.real("p")), Ball(in.real("load")), in.G_ball());
                   }),
                   [](const Inputs& in) -> std::vector<std::string> {
                       if (exceedance_by_proven_levels(in)) return proven_route_names;
                       return law_names(in, in.integer("n"), Ball(in.real("p")));
                   },
                   [](const Inputs& in) { return proven_levels_limits(exceedance_by_proven_levels(in)); }});


    all.push_back({"contact.density", "6.1", "1/p*_0", "n from 0 to 10^4, p >= 0, load > 0, G > 1; certified for n <= 1, or n <= 20, load <= 1, G > 2; to 15 digits for n <= 20, load <= 100, G > 1.003, p >= p*_n/1024; else estimated for n <= 20",
                   {"n", "p", "load", "G"}, "density q_n of the pressure at scale n, at p (in p*_0)", check_pressure,
                   [](const Inputs& in) -> Exact {
                       const bool partial = in.real("load") <= 1 && in.compare_G(2) > 0;
                       const bool at_zero = in.real("p") == 0 && ((partial && in.integer("n") > 0) || (in.integer("n") == 0 && in.real("load") < 1)); // q ~ p, (2.19)
                       if (at_zero || nothing_at(in, in.integer("n"), in.integer("n") >= 2) || below_support(in, in.integer("n"), in.real("p"))) return Exact(0);
                       if (in.integer("n") >= 2 && everywhere_above(in, in.integer("n"), in.real("p"))) return Exact(0); // p_n^min, as at p_n^max
                       throw NotExact();
                   },
                   by_both_laws([](Law law, const Inputs& in) { return density(law, in, in.integer("n"), [&in] { return Ball(in.real("p")); }, in.real("p")); }), explain_p, true,
                   by_both_grids([](transfer::Grid g, const Inputs& in) { return estimated_density(g, in.integer("n"), in, [&in] { return Ball(in.real("p")); }, in.real("p")); }),
                   [](const Inputs& in) { return density_route_names(in, in.integer("n"), Ball(in.real("p"))); },
                   [](const Inputs& in) { return density_limits(in, in.integer("n")); }});

    all.push_back({"segments.density", "9.3", "1", "n from 1 to 10^4, 0 <= a <= 1/2, load > 0, G > 1; certified for n <= 2, or n <= 21, load <= 1, G > 2; to 15 digits for n <= 21, load <= 100, G > 1.003; else estimated for n <= 21",
                   {"n", "a", "load", "G"}, "density of segments by half-width a (in lambda_n), N^_n lambda_n",
                   [](const Inputs& in) {
                       check_contact(in);
                       require_integer(in, "n", 1, largest_n);
                       require(in.real("a") >= 0 && in.real("a") <= Rational(1, 2), in, "a", ">= 0 and <= 1/2");
                   },
                   [](const Inputs& in) -> Exact { // no pressures, no segments
                       const WorkingPrecision precision(256);
                       const long n = in.integer("n");
                       if (n > 2 && in.real("a") == Rational(1, 2)) return Exact(0); // sin(2 pi a) = 0, and q_{n-1} is finite
                       const Ball p = of_segments(in).first;
                       if (certainly(less(highest_pressure(in, n - 1), p))) return Exact(0);
                       const auto none = [](long) { return false; };
                       if (transfer::scales_in_full_contact(Ball(in.real("load")) - p, in.G_ball(), n, none) >= n) return Exact(0);
                       throw NotExact();
                   },
                   by_both_laws([](Law law, const Inputs& in) {
                       return of_segments(in).second * density(law, in, in.integer("n") - 1, [&in] { return of_segments(in).first; });
                   }),
                   [](const Inputs& in, long digits) { return explain_distribution(in, in.integer("n") - 1, [&in] { return of_segments(in).first; }, digits); }, true,
                   by_both_grids([](transfer::Grid g, const Inputs& in) {
                       return scaled(estimated_density(g, in.integer("n") - 1, in, [&in] { return of_segments(in).first; }), of_segments(in).second);
                   }),
                   [](const Inputs& in) { return density_route_names(in, in.integer("n") - 1, of_segments(in).first); },
                   [](const Inputs& in) { return density_limits(in, in.integer("n") - 1); }});

    all.push_back({"segments.count", "8.1", "1", "n from 1 to 10^4, load > 0, 1 < D < 2, gamma > 1; certified or estimated where contact.area is at n - 1",
                   {"n", "load", "D", "gamma"}, "expected number of contact segments at scale n in one wavelength, A_{n-1}/lambda_n",
                   [](const Inputs& in) { check_contact(in); require_integer(in, "n", 1, largest_n); },
                   [](const Inputs& in) -> Exact {
                       const long n = in.integer("n");
                       if (everywhere_above(in, n - 1, 0)) return Exact(power(in.real("gamma"), n));
                       if (n > 1) throw NotExact();
                       return 2 * (westergaard::half_width(Exact(in.real("load"))) * Exact(in.real("gamma")));
                   },
                   by_both_schemes([](Scheme s, const Inputs& in) { return certified_area(s, in.integer("n") - 1, in) * potential_segments(in); }),
                   [](const Inputs& in, long digits) { return explain_area(in, in.integer("n") - 1, digits); }, false,
                   by_both_grids([](transfer::Grid g, const Inputs& in) {
                       return scaled(estimated_area(g, in.integer("n") - 1, in), potential_segments(in));
                   }),
                   [](const Inputs& in) { return area_route_names(in, in.integer("n") - 1); }, [](const Inputs& in) { return area_limits(in, in.integer("n") - 1); }});
}

} // namespace touchstone
