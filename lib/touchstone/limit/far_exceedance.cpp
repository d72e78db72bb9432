// SPDX-License-Identifier: MIT
#include "touchstone/limit/far_exceedance.hpp"

#include "touchstone/limit/approach.hpp"
#include "touchstone/limit/area_constant.hpp"
#include "touchstone/limit/limit_law.hpp"
#include "touchstone/limit/poisson.hpp"
#include "touchstone/scalar/refusal.hpp"
#include "touchstone/transfer/level_zero.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace touchstone::limit {
namespace {

constexpr slong bits_of_powers = 384;    ///< G^n loses as many bits as n has
constexpr long lowest_pressure_bits = 10; ///< the mesh reaches down to P^2

Ball unit_area(long n, const transfer::Arguments& a)
{
    Ball power;
    const Ball G = a.G();
    arb_pow_ui(power.get(), G.get(), static_cast<ulong>(n), WorkingPrecision::bits());
    return a.load() / power;
}

Question question(const FarPressure& at) { return {Question::Of::pressure, at.in_own_units()}; }

} // namespace

Ball far_exceedance(const FarPressure& at, const transfer::Arguments& a, Accuracy wanted)
{
    const WorkingPrecision precision(bits_of_powers);
    Ball mean = mean_by_poisson(question(at), a.G, wanted);
    const Ball off = distance_from_limit(at.n, a.G(), a.load());
    if (!off.is_finite()) throw BeyondReach("the load or G is out of reach of the rate of approach");
    arb_add_error(mean.get(), off.get());
    return mean * unit_area(at.n, a);
}

std::string no_far_exceedance(const FarPressure& at, const Ball& G)
{
    const WorkingPrecision precision(bits_of_powers);
    const Ball pressure = at.in_own_units(), highest = certainly(less(Ball(2), G)) ? 4 / G : G / (G - 1); // (5.10)
    if (!certainly(less(Ball(Rational(51, 50)), G)) || !certainly(less(G, Ball(1000))))
        return "the limiting distributions are certified for 1.02 < G = gamma^(D-1) < 1000 only";
    if (!certainly(less(ScalarTraits<Ball>::power_of_two(-lowest_pressure_bits), pressure)))
        return "the pressure is too low for the limiting distribution: below p*_n/1024";
    return certainly(less(pressure, highest)) ? "" : "the limiting distribution has no pressure as high";
}

long most_digits_of_far_exceedance(long n, const Ball& load, const Ball& G)
{
    return std::min(most_digits_by_poisson, most_digits_of_area_in_any_limit(n, load, G));
}

Witness far_exceedance_by_limit_law(const FarPressure& at, const transfer::Arguments& a)
{
    const WorkingPrecision precision(bits_of_powers);
    const Ball P = at.in_own_units(), unit = unit_area(at.n, a);
    const double pressure = double(transfer::to_real(P));
    const auto [low, high] = transfer::levels::ends_of_exceeding(P);
    const Witness mean = mean_in_the_limit(a.G(), {low, high}, [pressure](double x) { return exceedance_over_x(pressure, x); });
    Ball value;
    arb_get_mid_arb(value.get(), (mean.value * unit).get());
    return {value, mean.error * unit + abs(value) * Ball(Rational(1, 1'000'000'000))};
}

std::string far_exceedance_certificate(const FarPressure& at, const transfer::Arguments& a, Accuracy wanted)
{
    const WorkingPrecision precision(bits_of_powers);
    return fmt::format("share = G^-n load (mean +- rho_n), rho_n <= {} (docs/limit.md, theorem 7)\n{}",
                       distance_from_limit(at.n, a.G(), a.load()).to_string(3), mean_by_poisson_certificate(question(at), a.G, wanted));
}

} // namespace touchstone::limit
