// SPDX-License-Identifier: MIT
#include "touchstone/limit/area_constant.hpp"

#include "touchstone/limit/limit_law.hpp"
#include "touchstone/limit/poisson.hpp"
#include "touchstone/scalar/refusal.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace touchstone::limit {
namespace {

constexpr long spare_digits = 4;     ///< of delta_n, below the digits asked for
constexpr long last_scale = 10'000;  ///< transfer::area serves scales up to there
constexpr long most_contractions = 2'000; ///< of them delta_n is made at most: 10^-240 and less
const Rational start(1, 2);          ///< the load the limit is approached from: C does not depend on it

Ball load() { return Ball(start); }

long scale_for(const Ball& G, Accuracy wanted)
{
    const WorkingPrecision precision(128);
    const auto n = scale(pow(Ball(10), Ball(-wanted.digits - spare_digits)), last_scale, G, load());
    if (!n) throw BeyondReach("the limit is not reached within 10^4 scales");
    return *n;
}

} // namespace

Ball area_constant(transfer::Scheme scheme, const std::function<Ball()>& G, Accuracy wanted)
{
    const WorkingPrecision precision(working_bits({wanted.digits + spare_digits}));
    const Ball at = G();
    if (!certainly(less(Ball(2), at))) throw BeyondReach("G = gamma^(D-1) must be above 2");
    const long n = scale_for(at, wanted);
    const Ball area = transfer::area(scheme, n, {load, G}, {wanted.digits + spare_digits});
    const Ball h = area * pow(at, Ball(n)) / load();
    // h = C (1 +- delta)
    Ball one(1);
    arb_add_error(one.get(), relative_error(n, at, load()).get());
    return h / one;
}

long most_digits_of_area_constant(const Ball& G) { return transfer::most_digits_of_area(load(), G) - spare_digits; }

std::string area_constant_certificate(transfer::Scheme scheme, const std::function<Ball()>& G, Accuracy wanted)
{
    const WorkingPrecision precision(128);
    const long n = scale_for(G(), wanted);
    return fmt::format("C(G) = h_n(1/2)/(1 + d), n = {}, |d| <= delta_n = {} (docs/limit.md, theorem 2)\n{}", n,
                       relative_error(n, G(), load()).to_string(3),
                       transfer::area_certificate(scheme, n, {load, G}, {wanted.digits + spare_digits}));
}

Ball area_in_the_limit(transfer::Scheme scheme, long n, const transfer::Arguments& a, Accuracy wanted)
{
    constexpr long bits_of_n = 64; // G^n loses as many bits of G as n has
    const WorkingPrecision precision(working_bits({wanted.digits + spare_digits}) + bits_of_n);
    const Ball G = a.G(), load = a.load();
    Ball scale;
    arb_pow_ui(scale.get(), G.get(), static_cast<ulong>(n), precision.bits());
    Ball area = area_constant(scheme, a.G, wanted) * load / scale;
    const Ball off = area * relative_error(std::min(n, most_contractions), G, load); // delta decreases
    arb_add_error(area.get(), off.get());
    return area;
}

long most_digits_of_area_in_the_limit(long n, const Ball& load, const Ball& G)
{
    const Ball digits = -log(relative_error(std::min(n, most_contractions), G, load)) / log(Ball(10));
    const long left = static_cast<long>(arf_get_d(arb_midref(digits.get()), ARF_RND_FLOOR)) - spare_digits;
    return std::max(0L, std::min(left, most_digits_of_area_constant(G)));
}

namespace {

constexpr slong bits_of_G = 320; ///< G^n loses as many bits as n has

bool two_sided(const Ball& G) { return certainly(less(Ball(Rational(2'000'001, 1'000'000)), G)); }

Ball power_of(const Ball& G, long n)
{
    Ball r;
    arb_pow_ui(r.get(), G.get(), static_cast<ulong>(n), WorkingPrecision::bits());
    return r;
}

} // namespace

Ball area_in_any_limit(long n, const transfer::Arguments& a, Accuracy wanted)
{
    const WorkingPrecision precision(bits_of_G + working_bits(wanted));
    const Ball G = a.G(), load = a.load();
    Ball h = two_sided(G) ? area_constant(transfer::Scheme::force_weighted, a.G, {wanted.digits + 1}) : mean_by_poisson({}, a.G, wanted);
    const Ball off = distance_from_limit(n, G, load);
    if (!off.is_finite()) throw BeyondReach("the load or G is out of reach of the rate of approach");
    arb_add_error(h.get(), off.get());
    return h * load / power_of(G, n);
}

long most_digits_of_area_in_any_limit(long n, const Ball& load, const Ball& G)
{
    const Ball least = certainly(less(Ball(2), G)) ? G / 4 : (G - 1) / G; // of C = E[1/x]/G
    const Ball digits = -log(distance_from_limit(n, G, load) / least) / log(Ball(10));
    if (!digits.is_finite()) return 0;
    const double left = std::min(1e6, arf_get_d(arb_midref(digits.get()), ARF_RND_FLOOR));
    return std::clamp(static_cast<long>(left) - spare_digits, 0L, two_sided(G) ? most_digits_of_area_constant(G) : most_digits_by_poisson);
}

Witness area_by_limit_law(long n, const transfer::Arguments& a)
{
    const WorkingPrecision precision(bits_of_G);
    const Witness C = area_constant_by_law(a.G());
    const Ball factor = a.load() / power_of(a.G(), n);
    Ball value;
    arb_get_mid_arb(value.get(), (C.value * factor).get());
    return {value, C.error * factor + abs(value) * Ball(Rational(1, 1'000'000'000))};
}

} // namespace touchstone::limit
