// SPDX-License-Identifier: GPL-3.0-or-later
#include "proofs/lemmas/limit_values.hpp"

#include "proofs/lemmas/stored_values.hpp"

#include "touchstone/limit/area_constant.hpp"
#include "touchstone/limit/poisson.hpp"
#include "touchstone/paper/archard_constants.hpp"

namespace touchstone::proofs {
namespace {

constexpr slong bits_of_inputs = 256;
constexpr Accuracy ten_digits{10}, five_digits{5};

using limit::Question;

/// E_pi[f/x]/C(G) for G > 2.
Ball over_area(Question::Of of, const std::function<Ball()>& G, const Ball& pressure)
{
    return limit::mean_by_poisson({of, pressure}, G, five_digits) / limit::area_constant(transfer::Scheme::force_weighted, G, ten_digits);
}

} // namespace

Ball limiting_ratio(long gamma)
{
    return stored_value("limit.area_ratio D=3/2 gamma=" + std::to_string(gamma), [&] {
        const WorkingPrecision precision(bits_of_inputs);
        const auto G = [gamma] { return sqrt(Ball(gamma)); };
        return Ball(limit::area_constant(transfer::Scheme::force_weighted, G, ten_digits) /
                    (archard::K_gamma_product(archard::infinity) * G()));
    });
}

Ball limiting_share_outside_hertz(long gamma)
{
    return stored_value("limit.exceedance p=G/5 D=3/2 gamma=" + std::to_string(gamma), [&] {
        const WorkingPrecision precision(bits_of_inputs);
        const auto G = [gamma] { return sqrt(Ball(gamma)); };
        return over_area(Question::Of::pressure, G, G() / 5);
    });
}

namespace {

/// The share of the contacts with p_{n-1}/p*_n above a number at D = 1.05, where G < 2: E_pi[f/x] over E_pi[1/x], both by Poisson's
/// equation.
Ball share_above_at_low_D(const Ball& load_ratio, long gamma)
{
    const auto G = [gamma] { return pow(Ball(gamma), Ball(Rational(1, 20))); };
    return limit::mean_by_poisson({Question::Of::pressure, G() * load_ratio}, G, five_digits) / limit::mean_by_poisson({}, G, five_digits);
}

} // namespace

Ball limiting_share_outside_hertz_low_D(long gamma)
{
    return stored_value("limit.exceedance p=G/5 D=21/20 gamma=" + std::to_string(gamma), [&] {
        const WorkingPrecision precision(bits_of_inputs);
        return share_above_at_low_D(Ball(1) / 5, gamma);
    });
}

Ball limiting_full_share(long gamma)
{
    return stored_value("limit.exceedance p=G D=21/20 gamma=" + std::to_string(gamma), [&] {
        const WorkingPrecision precision(bits_of_inputs);
        return share_above_at_low_D(Ball(1), gamma);
    });
}

Ball limiting_normalised_density(const Rational& share)
{
    return stored_value("limit.density p=4/G*" + share.get_str() + " times 4/G, D=3/2 gamma=10", [&] {
        const WorkingPrecision precision(bits_of_inputs);
        const auto G = [] { return sqrt(Ball(10)); };
        const Ball highest = 4 / G(); // in p*_n
        return Ball(G() * over_area(Question::Of::density, G, highest * Ball(share)) * highest);
    });
}

} // namespace touchstone::proofs
