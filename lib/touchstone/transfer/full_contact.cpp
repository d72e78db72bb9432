// SPDX-License-Identifier: MIT
#include "touchstone/transfer/full_contact.hpp"

#include "touchstone/paper/peaks.hpp"
#include "touchstone/scalar/refusal.hpp"
#include "touchstone/transfer/graded.hpp"
#include "touchstone/transfer/piecewise.hpp"
#include "touchstone/transfer/progress.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <list>
#include <map>
#include <memory>
#include <mutex>

namespace touchstone::transfer {
namespace {

/// (6.6)
template <class Real>
Real first_area(const Pair<Real>& x)
{
    using std::atan2, std::sqrt, std::atan;
    static const Real half_pi = 2 * atan(Real(1));
    const Real lost = (1 - x.high) - x.low;
    return lost <= 0 ? Real(1) : Real(atan2(sqrt(x.high), sqrt(lost)) / half_pi);
}

/// F(x; P), the share of a wave above P, from the distances to the highest and the lowest pressure: rounding noise
/// at a square root would be halved without end by a blind grid.
template <class Real>
class FirstExceedance {
public:
    FirstExceedance(const Pair<Real>& x, const Pair<Real>& G)
        : x_(x)
        , G_(G)
        , highest_(wave_from(x, G).arcs[0].hi)
        , lowest_(wave_from(x, G).arcs[0].lo)
        , full_(wave_from(x, G).arcs[0].kind == Arc<Real>::Kind::full)
    {
    }
    /// P = G y
    Real operator()(const Pair<Real>& y) const
    {
        using std::asin, std::sqrt, std::atan;
        const Real below = G_.high * ((highest_.high - y.high) + (highest_.low - y.low)); // x + 1 - P, or 2 sqrt(x) - P
        if (below <= 0) return Real(0);
        static const Real half_pi = 2 * atan(Real(1));
        const Real P = G_.high * y.high;
        if (full_) {
            const Real above = G_.high * ((y.high - lowest_.high) + (y.low - lowest_.low)); // P - (x - 1)
            if (above <= 0) return Real(1);
            return above < below ? Real(1 - asin(sqrt(above / 2)) / half_pi) : Real(asin(sqrt(below / 2)) / half_pi);
        }
        const Real one_minus_x = (1 - x_.high) - x_.low, R = sqrt(one_minus_x * one_minus_x + P * P);
        return atan(sqrt(below * (G_.high * highest_.high + P) / (2 * (one_minus_x + R) + P * P))) /
               half_pi; // arcsin would lose digits next to x = 1, P = 0
    }

private:
    Pair<Real> x_, G_, highest_, lowest_;
    bool full_;
};

/// Functions V_0, V_1, ..., each from the one before it, on one of the two grids.
template <class Real>
class Levels {
public:
    using First = std::function<Real(const Pair<Real>&)>;
    using Step = std::function<Wave<Real>(const Pair<Real>&)>; ///< V_{m+1}(x) is the mean of V_m over this wave
    Levels(First first, Step step) : first_(std::move(first)), step_(std::move(step)) {}
    virtual ~Levels() = default;

    struct Mean {
        Real value;
        Real change; ///< by the last terms of the series
    };
    /// The mean of V_m, or of its derivative, over a wave.
    Mean mean(long m, const Wave<Real>& wave, bool derivative)
    {
        std::function<Mean(const Wave<Real>&)> mean;
        {
            const std::scoped_lock lock(mutex_);
            for (long k = size(); k <= m; ++k) {
                if (!failure_.empty()) throw BeyondReach(failure_); // it cost seconds to find out
                progress("estimate, scale", k, m + 1);
                try {
                    extend();
                }
                catch (const BeyondReach& reason) {
                    failure_ = reason.what();
                    throw;
                }
            }
            progress("estimate, scale", m + 1, m + 1);
            mean = mean_of(m, derivative);
        }
        return mean(wave);
    }

protected:
    virtual long size() const = 0;
    virtual void extend() = 0;
    /// A function that stays valid without the lock.
    virtual std::function<Mean(const Wave<Real>&)> mean_of(long m, bool derivative) = 0;

    First first_;
    Step step_;

private:
    std::mutex mutex_;
    std::string failure_;
};

template <class Real>
class BlindLevels final : public Levels<Real> {
public:
    using typename Levels<Real>::First, typename Levels<Real>::Step, typename Levels<Real>::Mean;
    /// \param ends where V_0, V_1, ... fall to 0; empty: nowhere
    BlindLevels(const BlindRule& rule, const Real& reach, First first, Step step, std::function<Extended(long m)> ends)
        : Levels<Real>(std::move(first), std::move(step)), rule_(rule), reach_(reach), ends_(std::move(ends))
    {
    }

private:
    long size() const override { return static_cast<long>(levels_.size()); }
    void extend() override
    {
        if (ends_) rule_.end = ends_(size());
        if (levels_.empty()) levels_.emplace_back(rule_, reach_, this->first_);
        else
            levels_.emplace_back(rule_, reach_, [this, &last = levels_.back()](const Pair<Real>& x) { return last.after(this->step_(x)); });
    }
    std::function<Mean(const Wave<Real>&)> mean_of(long m, bool derivative) override
    {
        auto it = finals_.find({m, derivative});
        if (it == finals_.end()) {
            const Piecewise<Real>& v = *std::next(levels_.begin(), m);
            it = finals_
                     .try_emplace({m, derivative},
                                  derivative ? std::pair(v.derivative(), v.shortened().derivative()) : std::pair(v, v.shortened()))
                     .first;
        }
        return [&f = it->second](const Wave<Real>& w) {
            const Real whole = f.first.after(w);
            return Mean{whole, whole - f.second.after(w)};
        };
    }

    BlindRule rule_;
    Real reach_;
    std::function<Extended(long)> ends_;
    std::list<Piecewise<Real>> levels_;
    std::map<std::pair<long, bool>, std::pair<Piecewise<Real>, Piecewise<Real>>> finals_;
};

class TrackedLevels final : public Levels<Extended> {
    using Real = Extended;

public:
    TrackedLevels(const Ball& reach, const std::vector<SingularPoint>& points, const GradedRule& rule, First first, Step step)
        : Levels(std::move(first), std::move(step)), grid_(rule, points, reach) {}

private:
    using Function = GradedGrid<Real>::Function;
    long size() const override { return static_cast<long>(levels_.size()); }
    void extend() override
    {
        levels_.push_back(levels_.empty() ? grid_.sample(first_)
                                          : grid_.sample([this](const Pair<Real>& x) { return grid_.after(levels_.back(), step_(x)); }));
    }
    std::function<Mean(const Wave<Real>&)> mean_of(long m, bool derivative) override
    {
        auto [it, fresh] = finals_.try_emplace({m, derivative});
        if (fresh) {
            const Function& v = *std::next(levels_.begin(), m);
            it->second =
                derivative ? std::pair(grid_.derivative(v), grid_.derivative(grid_.shortened(v))) : std::pair(v, grid_.shortened(v));
        }
        return [this, &f = it->second](const Wave<Real>& w) {
            const Real whole = grid_.after(f.first, w);
            return Mean{whole, whole - grid_.after(f.second, w)};
        };
    }

    GradedGrid<Real> grid_;
    std::list<Function> levels_;
    std::map<std::pair<long, bool>, std::pair<Function, Function>> finals_;
};

/// The range [0, reach] that the chain does not leave once it is there, and enters with the first wave: y <= f(x)/G, (5.6).
Ball reach_of(const Ball& load, const Ball& G)
{
    Ball reach(1), end;
    for (const Ball& b : {Ball((load + 1) / G), Ball(1 / (G - 1)), Ball(2 / G)})
        if (!certainly(less(b, reach))) reach = b;
    arb_get_ubound_arf(arb_midref(end.get()), reach.get(), 60);
    return end;
}

/// What is kept: the most recently used first.
template <class Real>
class Store {
public:
    using Kept = std::shared_ptr<Levels<Real>>;
    Kept get(const std::string& key, const std::function<Kept()>& make)
    {
        const std::scoped_lock lock(mutex_);
        for (auto it = kept_.begin(); it != kept_.end(); ++it)
            if (it->first == key) {
                kept_.splice(kept_.begin(), kept_, it);
                return kept_.front().second;
            }
        kept_.emplace_front(key, make());
        if (kept_.size() > 12) kept_.pop_back();
        return kept_.front().second;
    }

private:
    std::mutex mutex_;
    std::list<std::pair<std::string, Kept>> kept_;
};

template <class Real>
Store<Real>& store()
{
    static Store<Real> s;
    return s;
}

/// The midpoint.
template <class Real>
Pair<Real> rounded_pair(const Ball& b)
{
    const Pair<Extended> p = extended_pair(b);
    const auto high = static_cast<Real>(p.high);
    return {high, static_cast<Real>((p.high - Extended(high)) + p.low)};
}

/// Up to so many digits the blind grid is in binary64, with a tolerance of some fifty roundings.
constexpr long digits_in_binary64 = 12;

/// The blind grid's rule for so many digits; the finest from finest_estimate on, and for the other grid, which has a rule of its own.
BlindRule blind_rule(Grid grid, Accuracy wanted)
{
    constexpr double least_share = 0.4; // of the finest rule's digits: below, an interval would have too few points
    const double spare_digits = wanted.digits <= digits_in_binary64 ? 2 : 3;
    BlindRule rule;
    const double share = std::max(least_share, (static_cast<double>(wanted.digits) + spare_digits) / -std::log10(rule.tolerance));
    if (grid == Grid::tracked || wanted.digits >= finest_estimate.digits || share >= 1) return rule;
    rule.tolerance = std::pow(rule.tolerance, share);
    rule.points = static_cast<int>(std::ceil(rule.points * share));
    rule.angle_points = static_cast<int>(std::ceil(rule.angle_points * share));
    return rule;
}

/// Squares of very small loads and pressures need more than its range.
bool binary64_will_do(Grid grid, Accuracy wanted, const Ball& smallest)
{
    return grid == Grid::blind && wanted.digits <= digits_in_binary64 && certainly(less(Ball::exactly(1e-100), smallest));
}

Tracking tracking(const Ball& reach, const GradedRule& rule) { return {reach, GradedGrid<Extended>::generations(rule), 1e-18}; }

/// B_0, B_1, ... of chain.hpp
template <class Real>
std::shared_ptr<Levels<Real>> areas_of(Grid grid, const Ball& G, const Ball& load, const BlindRule& blind)
{
    const Ball heaviest = certainly(less(load, Ball(10))) ? Ball(10) : load; // loads up to 10 share a grid
    // what lies below sqrt(load) 1e-17 reaches B(load) with a weight of less than 1e-34
    const double magnitude = static_cast<double>(arf_abs_bound_lt_2exp_si(arb_midref(load.get()))) * 0.30103 / 2;
    const int decade = magnitude > -3 ? -20 : -20 - 10 * static_cast<int>(-magnitude / 10 + 1);
    const Ball reach = reach_of(heaviest, G);
    const std::string key =
        fmt::format("areas {} {} {} {} {}", static_cast<int>(grid), G.to_string(40), reach.to_string(25), decade, blind.tolerance);
    return store<Real>().get(key, [&]() -> std::shared_ptr<Levels<Real>> {
        const auto step = [g = rounded_pair<Real>(G)](const Pair<Real>& x) { return wave_from(x, g); };
        const double smallest = std::pow(10.0, decade);
        if constexpr (std::is_same_v<Real, Extended>)
            if (grid == Grid::tracked) {
                const GradedRule rule{.smallest = smallest};
                return std::make_shared<TrackedLevels>(reach, area_points(G, tracking(reach, rule)), rule, first_area<Real>, step);
            }
        BlindRule rule = blind;
        rule.smallest = smallest;
        return std::make_shared<BlindLevels<Real>>(rule, rounded_pair<Real>(reach).high, first_area<Real>, step, nullptr);
    });
}

/// E_1, E_2, ...: E_k(x) is the share of lambda_0 with p_{k-1}/p*_k > x.
template <class Real>
std::shared_ptr<Levels<Real>> exceedances_of(Grid grid, const Ball& G, const Ball& load, const BlindRule& blind)
{
    const std::string key =
        fmt::format("exceedances {} {} {} {}", static_cast<int>(grid), G.to_string(40), load.to_string(40), blind.tolerance);
    return store<Real>().get(key, [&]() -> std::shared_ptr<Levels<Real>> {
        const Ball reach = reach_of(load, G);
        const Pair<Real> g = rounded_pair<Real>(G);
        const FirstExceedance<Real> first(rounded_pair<Real>(load), g);
        const auto step = [g](const Pair<Real>& y) { return wave_to(product(g, y), false); };
        const auto end = [load, G](long m) { // x_{m+1}, (5.6)
            const WorkingPrecision bits(256);
            return extended_pair(peaks::iterate(m, load, G)).high;
        };
        if constexpr (std::is_same_v<Real, Extended>)
            if (grid == Grid::tracked) {
                const GradedRule rule{.tolerance = 1e-18}; // many more points than the areas have
                return std::make_shared<TrackedLevels>(reach, exceedance_points(load, G, tracking(reach, rule)), rule, first, step);
            }
        return std::make_shared<BlindLevels<Real>>(blind, rounded_pair<Real>(reach).high, first, step, end);
    });
}

Ball pow_ui(const Ball& x, long n)
{
    Ball power;
    arb_pow_ui(power.get(), x.get(), static_cast<ulong>(n), WorkingPrecision::bits());
    return power;
}

constexpr long most_scales = 100; ///< some seconds each

void require_reach(long n, const Ball& load, const Ball& G)
{
    if (n > most_scales)
        throw BeyondReach(fmt::format("not computed for n > {} where full contact occurs (G <= 2 or load > 1)", most_scales));
    if (!certainly(less(Ball(1) + Ball::exactly(1e-6), G))) throw BeyondReach("not computed for G within 1e-6 of 1");
    if (certainly(less(Ball(1'000'000), load)) || certainly(less(load, Ball(power(Rational(10), -300)))))
        throw BeyondReach("not computed for loads outside 1e-300 to 1e6 where full contact occurs (G <= 2 or load > 1)");
}

/// What rounding does to a sum of n levels, measured (full_contact.md): the differences of the two grids are 3e-19 on average; and what the
/// last terms of the series change at this very wave, noise and what they do not resolve next to a singular point included. A coarser grid
/// leaves its tolerance at each level.
template <class Mean>
Witness estimate(const Mean& mean, long n, const BlindRule& blind)
{
    const Ball exact = exact_ball(mean.value);
    const double rounding =
        (5 + std::sqrt(static_cast<double>(n))) * static_cast<double>(std::numeric_limits<decltype(mean.value)>::epsilon());
    const double levels = blind.tolerance > BlindRule().tolerance ? 4 * blind.tolerance * static_cast<double>(n + 1) : 0;
    return {exact, abs(exact) * Ball::exactly(rounding + levels) + 4 * abs(exact_ball(mean.change))};
}

} // namespace

Witness estimated_area(Grid grid, long n, const Ball& load, const Ball& G, Accuracy wanted)
{
    const WorkingPrecision precision(256);
    require_reach(n, load, G);
    const BlindRule blind = blind_rule(grid, wanted);
    const auto in = [&]<class Real>(Real) {
        const Pair<Real> x = rounded_pair<Real>(load);
        using Mean = typename Levels<Real>::Mean;
        return estimate(n == 0 ? Mean{first_area(x), Real(0)}
                               : areas_of<Real>(grid, G, load, blind)->mean(n - 1, wave_from(x, rounded_pair<Real>(G)), false),
                        n, blind);
    };
    return binary64_will_do(grid, wanted, load) ? in(double{}) : in(Extended{});
}

Witness estimated_exceedance(Grid grid, long n, const Ball& p, const Ball& load, const Ball& G, Accuracy wanted)
{
    const WorkingPrecision precision(256);
    require_reach(n, load, G);
    const BlindRule blind = blind_rule(grid, wanted);
    const Ball P = p / pow_ui(G, n);
    const auto in = [&]<class Real>(Real) {
        return estimate(exceedances_of<Real>(grid, G, load, blind)->mean(n - 1, wave_to(rounded_pair<Real>(P), false), false), n, blind);
    };
    return binary64_will_do(grid, wanted, certainly(less(P, load)) ? P : load) ? in(double{}) : in(Extended{});
}

/// In 64 bits always: a derivative makes rounding large.
Witness estimated_density(Grid grid, long n, const Ball& p, const Ball& load, const Ball& G, Accuracy wanted)
{
    const WorkingPrecision precision(256);
    require_reach(n, load, G);
    const BlindRule blind = blind_rule(grid, wanted);
    const Ball unit = pow_ui(G, n);
    const Witness slope =
        estimate(exceedances_of<Extended>(grid, G, load, blind)->mean(n - 1, wave_to(extended_pair(p / unit), true), true), n, blind);
    return {-slope.value / unit, slope.error / unit};
}

long scales_in_full_contact(const Ball& load, const Ball& G, long most, const std::function<bool(long)>& tie)
{
    Ball needed(1), power(1);
    for (long n = 0; n < most; ++n) {
        if (certainly(less(load, needed))) return n;
        if (!certainly(less(needed, load)) && !tie(n)) return n;
        power = power * G;
        needed = needed + power;
    }
    return most;
}

} // namespace touchstone::transfer
