// SPDX-License-Identifier: MIT
#include "touchstone/limit/area_series.hpp"

#include "touchstone/limit/approach.hpp"
#include "touchstone/limit/moment_interpolation.hpp"
#include "touchstone/scalar/refusal.hpp"

namespace touchstone::limit {
namespace {

using Traits = ScalarTraits<Ball>;
constexpr int most_terms = 24; ///< a minute
constexpr int quick_terms = 8; ///< a second: what values are made from
constexpr long spare_digits = 4;

Ball beta(const Ball& a) { return noise_moment(-a / 2); }

Ball dot(const Balls& a, const Balls& b)
{
    Ball sum(0);
    for (std::size_t k = 0; k < a.size(); ++k) arb_addmul(sum.get(), a[k].get(), b[k].get(), WorkingPrecision::bits());
    return sum;
}

/// |m_N(a)| <= moment_bound/(1/2)^N on the ellipse, theorem 3: with |e| = 1/2 the angle of w stays below pi/6, and with q = to_pole
/// E|w|^-q <= ((1/2)^(-q/2) beta(-q))^2.
Ball moment_bound(const Ball& height)
{
    const Ball q = Ball::exactly(to_pole), growth = pow(Ball(2), q / 2) * beta(-q);
    return growth * growth * exp(height * Traits::pi() / 6);
}

} // namespace

Ball hertzian_moment(const Ball& a)
{
    // |log beta(s)| <= |s| where |s| <= 1, since log beta is convex, 0 at 0, and both log beta(-1) and its slope there are below 1
    const long factors = WorkingPrecision::bits() + 8;
    Ball product(1), at = a;
    for (long k = 0; k < factors; ++k, at = at / 2) product *= beta(at);
    return product * exp(within(Ball(0), 2 * abs(at)));
}

namespace {

/// All that the steps from m_0 ... m_{N-1} to m_N need.
class Moments {
public:
    Moments(int last, double digits) : last_(last), grid_(2 * last, digits), bound_(moment_bound(grid_.height()))
    {
        for (int i = 0; i < grid_.points(); ++i) add_point(grid_.point(i));
        series_.push_back(grid_.series(hertzian_));
        ratio_.push_back(Ball(1));
        for (int N = 1; N <= last; ++N) next(N);
    }
    const Balls& ratios() const { return ratio_; }

private:
    void add_point(const Ball& a)
    {
        const long halvings = WorkingPrecision::bits() + 8;
        Balls share{Ball(1)}; // m_0(a)/m_0(a/2^k)
        Balls sum(static_cast<std::size_t>(grid_.points()), Ball(0));
        Ball at = a, total(0);
        for (long k = 0; k < halvings; ++k) {
            const Balls T = grid_.polynomials(at);
            const Ball weight = share.back() * at;
            total += abs(weight);
            for (std::size_t c = 0; c < sum.size(); ++c) arb_addmul(sum[c].get(), weight.get(), T[c].get(), WorkingPrecision::bits());
            share.push_back(share.back() * beta(at));
            at = at / 2;
        }
        sums_.push_back(std::move(sum));
        rest_.push_back(4 * share.back() *
                        abs(at)); // the rest of that sum: |a/2^k| halves, and the shares change by less than a factor 2 in all
        total_.push_back(total);
        hertzian_.push_back(share.back() * exp(within(Ball(0), 2 * abs(at))));
        beta_.push_back(beta(a));
        points_.push_back(a);
        steps_.emplace_back();
        for (int j = 1; j <= last_; ++j) steps_.back().push_back(grid_.polynomials(a / 2 + j));
    }

    void next(int N)
    {
        Balls g;
        for (std::size_t i = 0; i < points_.size(); ++i) {
            const Ball half = points_[i] / 2;
            Ball delta(1), sum(0);
            for (int j = 1; j <= N; ++j) {
                delta *= (Ball(j - 1) - half) * (2 * j - 1) / (2 * j * (Ball(j + 1) + half));
                const auto& lower = series_[static_cast<std::size_t>(N - j)];
                sum += delta * within(dot(steps_[i][static_cast<std::size_t>(j - 1)], lower.c),
                                      bound_ * Traits::power_of_two(N - j) * grid_.error() + lower.error);
            }
            g.push_back(beta_[i] * sum / points_[i]);
        }
        const auto by_a = grid_.series(g);
        // g_N(a) = m_N(a) - beta(a) m_N(a/2), |beta| <= beta(-to_pole) there. It vanishes at 0, which is more than 1 away from the ellipse.
        const Ball bound = (1 + beta(-Ball::exactly(to_pole))) * bound_ * Traits::power_of_two(N);
        Balls m;
        for (std::size_t i = 0; i < sums_.size(); ++i)
            m.push_back(within(dot(sums_[i], by_a.c), (bound * grid_.error() + by_a.error) * total_[i] + bound * rest_[i]));
        ratio_.push_back(m.front() / hertzian_.front());
        series_.push_back(grid_.series(m));
    }

    int last_;
    MomentInterpolation grid_;
    Ball bound_;
    Balls points_, beta_, hertzian_, rest_, total_, ratio_;
    std::vector<std::vector<Balls>> steps_;
    std::vector<Balls> sums_;
    std::vector<MomentInterpolation::Series> series_;
};

} // namespace

Balls area_coefficients(int last, Accuracy wanted)
{
    if (last < 1) return {Ball(1)};
    if (last > most_terms) throw BeyondReach("no more than 24 coefficients are computed");
    // what is lost: the bound of the moments, 2^last, and alternating sums of about that size again
    const double digits = static_cast<double>(wanted.digits) + 10 + 1.8 * last;
    const WorkingPrecision precision(bits_for_digits(static_cast<long>(digits)) + 64);
    return Moments(last, digits).ratios();
}

namespace {

double log10_of_e(const Ball& G) { return std::log10(4.0) - 2 * std::log10(arf_get_d(arb_midref(G.get()), ARF_RND_NEAR)); }

} // namespace

long most_digits_of_series(const Ball& G)
{
    if (!certainly(less(Ball(2), G))) return 0;
    return std::max(0L, static_cast<long>(-(quick_terms + 1) * log10_of_e(G)) - spare_digits);
}

Ball area_ratio_by_series(const Ball& G, Accuracy wanted)
{
    if (wanted.digits > most_digits_of_series(G)) throw BeyondReach("the series would take too many terms");
    const int last = std::min(quick_terms, static_cast<int>(static_cast<double>(wanted.digits + spare_digits) / -log10_of_e(G)) + 1);
    const Balls R = area_coefficients(last, {wanted.digits + spare_digits});
    const Ball e = 4 / (G * G);
    Ball sum(0), power(1);
    for (const Ball& r : R) {
        sum += r * power;
        power *= e;
    }
    return within(sum, 2 * power / (1 - e)); // |R_N| <= 2
}

Witness area_ratio_to_first_order(const Ball& G)
{
    const WorkingPrecision precision(72);
    Ball first(0), b(1);
    for (long k = 0; k < precision.bits(); ++k, b = b / 2)
        first += b / (2 * (4 - b)) * hertzian_moment(1 - b / 2) / hertzian_moment(-b / 2);
    const Ball e = 4 / (G * G);
    return {1 + first * e, e * e / 16};
}

} // namespace touchstone::limit
