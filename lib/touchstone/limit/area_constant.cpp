// SPDX-License-Identifier: MIT
#include "touchstone/limit/area_constant.hpp"

#include "touchstone/scalar/refusal.hpp"

#include <fmt/format.h>

namespace touchstone::limit {
namespace {

constexpr long spare_digits = 4;     ///< of delta_n, below the digits asked for
constexpr long last_scale = 10'000;  ///< transfer::area serves scales up to there
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

} // namespace touchstone::limit
