// SPDX-License-Identifier: GPL-3.0-or-later
#include "proofs/lemmas/model_area.hpp"

#include "touchstone/paper/archard.hpp"
#include "touchstone/transfer/contact.hpp"

namespace touchstone::proofs {

const std::vector<Rational>& loads_tried()
{
    static const std::vector<Rational> loads{Rational(1, 1000), Rational(1, 100), Rational(1, 10), Rational(1)};
    return loads;
}

Ball model_area(long n, const Rational& load, long gamma)
{
    return transfer::area(transfer::Scheme::force_weighted, n, {[load] { return Ball(load); }, [gamma] { return sqrt(Ball(gamma)); }});
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

Ball ratios_to_hertz(long first, long last, long gamma, const std::vector<Rational>& loads)
{
    const auto ratio = [gamma](long n, const Rational& load) { return model_area(n, load, gamma) / hertz_area(n, load, gamma); };
    Ball all = ratio(first, loads.front());
    for (long n = first; n <= last; ++n) all = hull(all, over_loads(loads, [&](const Rational& load) { return ratio(n, load); }));
    return all;
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
