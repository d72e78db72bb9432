// SPDX-License-Identifier: MIT
#include "touchstone/limit/scale.hpp"

#include "touchstone/scalar/refusal.hpp"

namespace touchstone::limit {
namespace {

constexpr long last_scale = 10'000;    ///< transfer::area serves scales up to there
constexpr long spare_digits = 10;      ///< below the tolerance: by so much a tolerance may be missed and the scale still be decided
constexpr long settled_scale = 64;     ///< where third eigenvalues, about half of the second, are below 2^-64 of it
constexpr long digits_of_gap = 48;     ///< of h_n, whose differences are about 2^-n

Ball h(transfer::Scheme scheme, long n, const transfer::Arguments& at, Accuracy wanted)
{
    return transfer::area(scheme, n, at, wanted) * pow(at.G(), Ball(n)) / at.load();
}

} // namespace

long least_scale(transfer::Scheme scheme, const std::function<Ball()>& G, const std::function<Ball()>& load, const Rational& tolerance)
{
    long digits = spare_digits;
    for (Rational t = tolerance; t < 1 && digits < 1000; t *= 10) ++digits;
    const WorkingPrecision precision(working_bits({digits + 8}));
    const Ball allowed(tolerance);
    const auto proven = scale(allowed, last_scale, G(), load());
    if (!proven) throw BeyondReach("the limit is not reached within 10^4 scales to this tolerance");
    const Ball C = area_constant(scheme, G, {digits});
    for (long n = *proven; n > 0; --n) {
        const Ball off = abs(h(scheme, n - 1, {load, G}, {digits}) / C - 1);
        if (certainly(less(allowed, off))) return n;
        if (!certainly(less(off, allowed))) throw BeyondReach("the tolerance is met too exactly at one scale for it to be decided");
    }
    return 0;
}

Witness gap(transfer::Scheme scheme, const std::function<Ball()>& G, const Rational& load)
{
    const WorkingPrecision precision(working_bits({digits_of_gap + 8}));
    const transfer::Arguments at{[load] { return Ball(load); }, G};
    Ball before, change, ratio, ratio_before;
    for (long n = settled_scale - 3; n <= settled_scale; ++n) {
        const Ball now = h(scheme, n, at, {digits_of_gap}), change_before = change;
        change = now - before;
        before = now;
        ratio_before = ratio;
        ratio = change / change_before;
    }
    Ball value, error = abs(ratio - ratio_before) + Ball::exactly(ratio.radius_bound());
    arb_get_mid_arb(value.get(), ratio.get());
    arb_get_mid_arb(error.get(), error.get());
    return {value, error};
}

} // namespace touchstone::limit
