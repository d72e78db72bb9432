// SPDX-License-Identifier: GPL-3.0-or-later
#include "proofs/lemmas/model_area.hpp"

#include "proofs/lemmas/non_hertzian.hpp"
#include "proofs/lemmas/stored_values.hpp"

#include "touchstone/paper/archard.hpp"
#include "touchstone/paper/peaks.hpp"
#include "touchstone/paper/westergaard.hpp"
#include "touchstone/transfer/contact.hpp"
#include "touchstone/recursion/from_the_edge/forward.hpp"
#include "touchstone/transfer/proven_levels.hpp"

#include <map>

namespace touchstone::proofs {

/// What the precision of these balls is meant for.
static Accuracy wanted() { return {accuracy_of(WorkingPrecision::bits()).digits + 1}; }

const std::vector<Rational>& loads_tried()
{
    static const std::vector<Rational> loads{Rational(1, 1000), Rational(1, 100), Rational(1, 10), Rational(1)};
    return loads;
}

Ball model_area(long n, const Rational& load, long gamma)
{
    return transfer::area(transfer::Scheme::force_weighted, n, {[load] { return Ball(load); }, [gamma] { return sqrt(Ball(gamma)); }},
                          wanted());
}

Ball hertz_area(long n, const Rational& load, long gamma)
{
    return archard::area<Ball>(n, Ball(load), sqrt(Ball(gamma)), archard::K_by_recursion<Ball>(n));
}

namespace {


/// The hull of f over the loads tried.
template <class F>
Ball over_loads(const std::vector<Rational>& loads, F&& f)
{
    Ball all = f(loads.front());
    for (const Rational& load : loads) all = hull(all, f(load));
    return all;
}

} // namespace

namespace {

transfer::Arguments figure_5(const Rational& load)
{
    return {[load] { return Ball(load); }, [] { return sqrt(Ball(10)); }};
}
constexpr slong figure_5_bits = 84;

} // namespace

Ball normalised_density(long n, const Rational& load, const Rational& share)
{
    return stored_value("figure5.density n=" + std::to_string(n) + " load=" + load.get_str() + " share=" + share.get_str(), [&] {
        const WorkingPrecision precision(figure_5_bits);
        const auto highest = [&] {
            Ball unit;
            arb_pow_ui(unit.get(), sqrt(Ball(10)).get(), static_cast<ulong>(n + 1), WorkingPrecision::bits());
            return unit * peaks::iterate(n, Ball(load), sqrt(Ball(10)));
        };
        const auto p = [&] { return highest() * Ball(share); };
        const Ball q =
            n == 0 ? westergaard::density(p(), Ball(load)) : transfer::density(transfer::Law::density, n, p, figure_5(load), wanted());
        return Ball(q * highest() / model_area(n, load, 10));
    });
}

Ball share_outside_hertz(long n, const Rational& load, long gamma)
{
    const Rational p = power(Rational(gamma), (n + 1) / 2) / 5; // 0.2 p*_{n+1}, n odd
    return stored_value("contact.exceedance/contact.area n=" + std::to_string(n) + " p=" + p.get_str() + " load=" + load.get_str() +
                            " D=3/2 gamma=" + std::to_string(gamma),
                        [&] {
                            const WorkingPrecision precision(figure_5_bits);
                            const transfer::Arguments at{[load] { return Ball(load); }, [gamma] { return sqrt(Ball(gamma)); }};
                            return Ball(transfer::exceedance(
                                            transfer::Law::exceedance, n, [p] { return Ball(p); }, at, wanted()) /
                                        model_area(n, load, gamma));
                        });
}

Ball under_normalised_density(long n, const Rational& load)
{
    return stored_value("figure5.area_under_density n=" + std::to_string(n) + " load=" + load.get_str(), [&] {
        const WorkingPrecision precision(figure_5_bits);
        return Ball(transfer::mass(n, figure_5(load), wanted()) / model_area(n, load, 10));
    });
}

namespace {

Ball G_low_D(long gamma) { return pow(Ball(gamma), Ball(Rational(1, 20))); }

template <class Ratio>
Ball over_scales(long first, long last, const std::vector<Rational>& loads, Ratio&& ratio)
{
    Ball all = ratio(first, loads.front());
    for (long n = first; n <= last; ++n) all = hull(all, over_loads(loads, [&](const Rational& load) { return ratio(n, load); }));
    return all;
}

} // namespace

Ball model_area_low_D(long n, const Rational& load, long gamma)
{
    return stored_value("contact.area n=" + std::to_string(n) + " load=" + load.get_str() + " D=21/20 gamma=" + std::to_string(gamma), [&] {
        static std::map<long, transfer::ProvenLevels> kept; // the ledger judges one entry at a time
        auto it = kept.find(gamma);
        if (it == kept.end()) {
            const WorkingPrecision precision(160);
            it = kept.emplace(gamma, transfer::ProvenLevels(G_low_D(gamma), 10, 1e-8)).first;
        }
        return it->second.share(n, Ball(load));
    });
}

Ball hertz_area_low_D(long n, const Rational& load, long gamma)
{
    return archard::area<Ball>(n, Ball(load), G_low_D(gamma), archard::K_by_recursion<Ball>(n));
}

Ball ratios_to_hertz_low_D(long first, long last, long gamma, const std::vector<Rational>& loads)
{
    return over_scales(first, last, loads, [gamma](long n, const Rational& load) {
        return model_area_low_D(n, load, gamma) / hertz_area_low_D(n, load, gamma);
    });
}

Ball local_slope_low_D(long n, const Rational& load, long gamma)
{
    const Ball now = n > 0 ? model_area_low_D(n, load, gamma) : load >= 1 ? Ball(1) : 2 * westergaard::half_width(Ball(load));
    return -log(model_area_low_D(n + 1, load, gamma) / now) / log(G_low_D(gamma));
}

Ball ratios_to_hertz(long first, long last, long gamma, const std::vector<Rational>& loads)
{
    return over_scales(first, last, loads,
                       [gamma](long n, const Rational& load) { return model_area(n, load, gamma) / hertz_area(n, load, gamma); });
}

Ball local_slope(long n, const Rational& load, long gamma)
{
    return -log(model_area(n + 1, load, gamma) / model_area(n, load, gamma)) / log(sqrt(Ball(gamma)));
}

Ball local_slopes(long n, long gamma)
{
    return over_loads(loads_tried(), [&](const Rational& load) { return local_slope(n, load, gamma); });
}

} // namespace touchstone::proofs
