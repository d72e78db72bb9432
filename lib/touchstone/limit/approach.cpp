// SPDX-License-Identifier: MIT
#include "touchstone/limit/approach.hpp"

namespace touchstone::limit {
namespace {

using Traits = ScalarTraits<Ball>;

/// int_0^z t^(p-1) (1-t)^(q-1) dt
Ball incomplete_beta(const Ball& p, const Ball& q, const Ball& z)
{
    Ball r;
    arb_hypgeom_beta_lower(r.get(), p.get(), q.get(), z.get(), 0, WorkingPrecision::bits());
    return r;
}

} // namespace

Ball noise_moment(const Ball& a)
{
    return 2 * Traits::gamma(Traits::quotient(3, 2) - a) / (sqrt(Traits::pi()) * Traits::gamma(2 - a));
}

Ball contraction(const Ball& a, const Ball& top)
{
    const Ball half = Traits::quotient(1, 2);
    // |1 - 2v|/(2(1 - v)) falls from 1/2 at v = 0 to 0, and comes back to 1/2 at v = 2/3
    if (certainly(less(top, Traits::quotient(2, 3)))) return half * noise_moment(a);
    if (certainly(less(a, half))) {
        // with u = sin t and 1 - u^2 = cos^2 t = z: half of cos^(2-2a) t where z >= 1/3, and -cos 2t cos^-2a t/2 below, times 4/pi
        const Ball third = Traits::quotient(1, 3), p = half - a;
        const Ball all = Traits::gamma(p + 1) * sqrt(Traits::pi()) / Traits::gamma(p + Traits::quotient(3, 2)); // B(p + 1, 1/2)
        return (all + incomplete_beta(p, half, third) - 3 * incomplete_beta(p + 1, half, third)) / Traits::pi();
    }
    return at_least(half, (2 * top - 1) / (2 * (1 - top))) * noise_moment(a);
}

namespace {

/// delta_1 of the product above: no bound itself.
Ball before_contraction(const Ball& G, const Ball& load)
{
    const Ball quarter = Traits::quotient(1, 4), half_G = G / 2;
    return 8 / sqrt(1 - 1 / half_G) * (2 + sqrt(half_G) + 4 / (Traits::pi() * sqrt(half_G) * pow(load, quarter)));
}

} // namespace

Ball relative_error(long n, const Ball& G, const Ball& load)
{
    Ball delta = before_contraction(G, load);
    for (long j = 1; j < n; ++j) delta *= contraction(Traits::power_of_two(-j), 2 / G);
    return delta;
}

std::optional<long> scale(const Ball& tolerance, long most, const Ball& G, const Ball& load)
{
    // contraction(a) increases with a and is below 1 from a = 1/8 on: delta_n decreases from n = 3 on
    Ball delta = relative_error(3, G, load);
    for (long n = 3; n <= most; ++n) {
        if (certainly(less(delta, tolerance))) return n;
        delta *= contraction(Traits::power_of_two(-n), 2 / G);
    }
    return std::nullopt;
}

namespace {

Ball larger(const Ball& a, const Ball& b)
{
    Ball r;
    arb_max(r.get(), a.get(), b.get(), WorkingPrecision::bits());
    return r;
}

/// k(x) <= 1 - 1/(4x(x + 1)) for 1 <= x <= 2/3^(1/2), which is largest at the end: below 0.8996.
Ball rate_of_light_full_contact()
{
    const Ball x = 2 / sqrt(Ball(3));
    return 1 - 1 / (4 * x * (x + 1));
}

/// By what one step brings two chains nearer to one another in the mean, where no ratio is above `highest`.
Ball rate(const Ball& highest)
{
    if (certainly(less(highest, Ball(1)))) return contraction(Ball(0), highest);
    const Ball least = larger(Ball(1), highest); // a ball that cannot tell whether it is above 1: below 1 the rate is smaller
    Ball beyond;
    arb_sqrtpos(beyond.get(), (1 - 1 / (least * least)).get(), WorkingPrecision::bits());
    return larger(rate_of_light_full_contact(), beyond);
}

/// At least every ratio that is met after one below `highest`.
Ball next_highest(const Ball& highest, const Ball& G)
{
    return certainly(less(highest, Ball(1))) ? 2 * sqrt(highest) / G : (highest + 1) / G;
}

} // namespace

Ball distance_from_limit(long n, const Ball& G, const Ball& load)
{
    const Ball one(1), squared = G * G, in_the_limit = certainly(less(Ball(2), G)) ? 4 / squared : one / (G - 1);
    const Ball m = larger(one / load, squared);
    Ball X = larger(load, in_the_limit);
    const Ball d = abs(log(load)) + log(larger(one, X)) + log(1 + squared);
    Ball product(1);
    constexpr long most_ratios = 500;                 // scales, after which X is not made smaller
    const Ball hardly(
        Rational(999'999, 1'000'000)); // nor where it falls by less than this: it only decreases, and n rates at 1e-6 are no digit
    for (long k = 0; k < n; ++k) {
        const Ball lambda = rate(X), next = larger(in_the_limit, next_highest(X, G));
        if (k == most_ratios || certainly(less(X * hardly, next))) {
            product = product * pow(lambda, Ball(n - k));
            break;
        }
        product = product * lambda;
        X = next;
    }
    return 2 * sqrt((m + squared) * d * product);
}

} // namespace touchstone::limit
