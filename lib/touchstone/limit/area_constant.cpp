// SPDX-License-Identifier: MIT
#include "touchstone/limit/area_constant.hpp"

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
    return fmt::format("C(G) = h_n(1/2)/(1 + d), n = {}, |d| <= delta_n = {} (docs/limit.md, theorem 2)\n{}", n, relative_error(n, G(), load()).to_string(3),
                       transfer::area_certificate(scheme, n, {load, G}, {wanted.digits + spare_digits}));
}

Ball area_in_the_limit(transfer::Scheme scheme, long n, const transfer::Arguments& a, Accuracy wanted)
{
    constexpr long bits_of_n = 64; // G^n loses as many bits of G as n has
    const WorkingPrecision precision(working_bits({wanted.digits + spare_digits}) + bits_of_n);
    const Ball G = a.G(), load = a.load();
    Ball one(1), scale;
    arb_add_error(one.get(), relative_error(std::min(n, most_contractions), G, load).get()); // delta decreases
    arb_pow_ui(scale.get(), G.get(), static_cast<ulong>(n), precision.bits());
    return area_constant(scheme, a.G, wanted) * load * one / scale;
}

long most_digits_of_area_in_the_limit(long n, const Ball& load, const Ball& G)
{
    const Ball digits = -log(relative_error(std::min(n, most_contractions), G, load)) / log(Ball(10));
    const long left = static_cast<long>(arf_get_d(arb_midref(digits.get()), ARF_RND_FLOOR)) - spare_digits;
    return std::max(0L, std::min(left, most_digits_of_area_constant(G)));
}

} // namespace touchstone::limit
