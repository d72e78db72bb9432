// SPDX-License-Identifier: MIT
#include "touchstone/recursion/from_the_edge/forward.hpp"

#include "touchstone/recursion/from_the_edge/far_end.hpp"
#include "touchstone/recursion/from_the_edge/levels.hpp"
#include "touchstone/scalar/binary64.hpp"
#include "touchstone/scalar/refusal.hpp"
#include "touchstone/transfer/chain.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <list>
#include <mutex>
#include <numbers>

namespace touchstone::transfer {

using namespace from_the_edge;

struct Forward::Implementation : from_the_edge::Levels {
    using Levels::Levels;
};

Forward::Forward(Law law, const std::function<Ball()>& G_at, const std::function<Ball()>& load_at, double accuracy)
{
    require_binary64_arithmetic();
    const WorkingPrecision scope(Implementation::precision_for(accuracy));
    implementation_ = std::make_unique<Implementation>(law, G_at(), load_at(), accuracy);
}
Forward::~Forward() = default;

slong Forward::bits() const { return implementation_->precision; }

Ball Forward::density(long n, const Ball& p, const Ball& d)
{
    const std::lock_guard lock(implementation_->mutex);
    const WorkingPrecision scope(implementation_->precision);
    return implementation_->density(n, p, d).value;
}

Ball Forward::exceedance(long n, const Ball& d)
{
    const std::lock_guard lock(implementation_->mutex);
    const WorkingPrecision scope(implementation_->precision);
    return implementation_->exceedance(n, d).value;
}

Ball Forward::force(long n)
{
    const std::lock_guard lock(implementation_->mutex);
    const WorkingPrecision scope(implementation_->precision);
    return implementation_->force(n);
}

Ball Forward::mass(long n)
{
    const std::lock_guard lock(implementation_->mutex);
    const WorkingPrecision scope(implementation_->precision);
    return implementation_->mass(n);
}

std::string Forward::certificate(long n, const Ball& p, const Ball& d)
{
    Implementation& in = *implementation_;
    const std::lock_guard lock(in.mutex);
    const WorkingPrecision scope(in.precision);
    const auto q = in.density(n, p, d);
    const double v = std::fabs(about(q.row.value));
    std::string text = fmt::format("{} law: {} bits, far end from delta = {:.0f}\n", in.law == Law::density ? "density" : "exceedance",
                                   in.precision, in.delta_max);
    for (long k = 2; k <= n; ++k) {
        const Level& l = q.cut > 0 && k == n ? *in.whole[n] : *in.levels[static_cast<std::size_t>(k)];
        text += fmt::format(
            "  scale {:2}: {:2} panels, {:4} nodes, {:4} points a row; of v: rows {:.1e}, carried {:.1e}, all {:.1e}; interpolation {:.1e}\n",
            k - 1, l.panels.size(), l.nodes, l.row_nodes / l.nodes, l.worst_row, l.worst_carried, l.worst_total, l.worst_interpolation);
    }
    if (q.cut > 0)
        text += fmt::format(
            "  at p: small, by parts over E_{} up to delta = {:.1f}; of q: beyond {:.1e}, interpolation {:.1e}, carried {:.1e}\n", n, q.cut,
            q.row.rule_error / v, q.row.interpolation / v, q.row.carried / v);
    else
        text += fmt::format("  at p: {} points; of v: rule {:.1e}, interpolation {:.1e}, carried {:.1e}\n", q.nodes, q.row.rule_error / v,
                            q.row.interpolation / v, q.row.carried / v);
    return text;
}

std::size_t Forward::memory() const
{
    const std::lock_guard lock(implementation_->mutex);
    std::size_t n = 0;
    const auto word = static_cast<std::size_t>(implementation_->precision / 8 + 40);
    for (const auto& [size, matrix] : implementation_->to_monomials) n += matrix.size() * word;
    for (const auto& level : implementation_->levels)
        if (level) n += level->nodes * (word + 24) + level->boxes.bound.size() * 8;
    for (const auto& [k, level] : implementation_->whole) n += level->nodes * (word + 24) + level->boxes.bound.size() * 8;
    return n;
}

// ---- kept levels

namespace {

constexpr std::size_t memory_limit = 300'000'000;

struct Kept {
    Law law;
    double accuracy;
    std::string G, load; ///< their balls: levels are valid for every pair in them
    std::shared_ptr<Forward> made;
};
std::mutex kept_mutex;
std::list<Kept> kept; // most recently used first

/// The balls of G and load that tell levels of this accuracy from others.
std::pair<std::string, std::string> told_apart(double accuracy, const Arguments& a)
{
    const WorkingPrecision precision(static_cast<slong>(accuracy * 1.5) + 80);
    return {a.G().dump(), a.load().dump()};
}

/// More accurate levels cost more a value: they serve where they are not much more accurate, as those of a neighbouring p are.
constexpr double most_spare = 100; // nats

std::atomic<long> made{0};

/// Levels of at least this accuracy: kept ones if there are any that serve, or else new ones.
std::shared_ptr<Forward> levels_for(Law law, double accuracy, const Arguments& a, const std::function<bool(double)>& serves)
{
    const std::lock_guard lock(kept_mutex);
    auto best = kept.end();
    for (auto it = kept.begin(); it != kept.end(); ++it) {
        if (it->law != law || it->accuracy < accuracy || it->accuracy > accuracy + most_spare) continue;
        if ((best != kept.end() && best->accuracy <= it->accuracy) || (it->accuracy > accuracy && !serves(it->accuracy))) continue;
        if (const auto [G, load] = told_apart(it->accuracy, a); it->G == G && it->load == load) best = it;
    }
    if (best != kept.end()) kept.splice(kept.begin(), kept, best);
    else {
        const auto [G, load] = told_apart(accuracy, a);
        kept.push_front({law, accuracy, G, load, std::make_shared<Forward>(law, a.G, a.load, accuracy)});
        ++made;
    }
    std::size_t held = 0, count = 0;
    for (auto it = kept.begin(); it != kept.end();) {
        held += it->made.use_count() > 1 ? 0 : it->made->memory(); // one in use elsewhere may be busy for long
        it = ++count > 4 && held > memory_limit ? kept.erase(it) : std::next(it);
    }
    return kept.front().made;
}

void require_proven(const Ball& G, const Ball& load)
{
    if (!certainly(less(Ball(2), G)) || !certainly(less(Ball(0), load)) || !(arb_is_one(load.get()) || certainly(less(load, Ball(1)))))
        throw BeyondReach("needs G > 2 and 0 < load <= 1");
}

/// Accuracies in use are few, so that levels are shared.
double accuracy_for(Accuracy wanted)
{
    return 4 * std::ceil(std::max(30.0, static_cast<double>(bits_for_digits(wanted.digits) - 4) * std::numbers::ln2) / 4);
}

/// Nats, asked for at all scales, so that exceedances and densities of all of them share their levels. Only what is tried first, as all of
/// this.
constexpr double carried_to_the_last_scale = 4;

struct Needed {
    double accuracy; ///< of levels
    bool small;      ///< whether the value is to be had by the form for small p
};

/// What a value of a law at distance d = log(p_n^max/p) needs of the levels: it loses some of their accuracy.
Needed needed_at(Law law, long n, double d, const Arguments& a, Accuracy wanted, bool for_density)
{
    const double accuracy = accuracy_for(wanted);
    if (law == Law::density) return {accuracy, false};
    if (!for_density) return {accuracy + 12 + carried_to_the_last_scale, false};
    if (const double small = accuracy_for_small(accuracy, n, d, a.G(), a.load()); small > 0) return {small, true};
    // q_n ~ p, the slope of an exceedance ~ 1: 2d nats cancel
    return {accuracy + 12 * std::max(1.0, std::ceil(d / 6)) + carried_to_the_last_scale, false};
}

struct Asked {
    std::shared_ptr<Forward> levels;
    Ball p, d;
};

/// log(p_n^max/p), p_n^max = G^(n+1) e_{n+1}, log e_{k+1} = log(2/G) + log(e_k)/2
Ball distance_from_edge(long n, const std::function<Ball()>& p_at, const Arguments& a, slong bits)
{
    const WorkingPrecision precision(bits);
    const Ball G = a.G(), load = a.load();
    require_proven(G, load);
    Ball log_edge = log(load);
    for (long k = 0; k <= n; ++k) log_edge = log(2 / G) + log_edge / 2;
    return log_edge + (n + 1) * log(G) - log(p_at());
}

/// The same, once it is certainly > 0.
double positive_distance(long n, const std::function<Ball()>& p_at, const Arguments& a)
{
    for (slong bits = 128;; bits *= 2) {
        const Ball ball = distance_from_edge(n, p_at, a, bits);
        if (certainly(less(Ball(0), ball))) return about(ball);
        if (bits > 40'000) throw BeyondReach("p cannot be told from the upper edge of the support");
    }
}

Asked prepare(Law law, long n, const std::function<Ball()>& p_at, const Arguments& a, Accuracy wanted, bool for_density)
{
    require_binary64_arithmetic();
    const double d = positive_distance(n, p_at, a);
    const auto [accuracy, small] = needed_at(law, n, d, a, wanted, for_density);
    if (accuracy > most_accuracy && accuracy_for(wanted) < most_accuracy - 100)
        throw BeyondReach("p is too small against the highest pressure for two laws to give the density");
    if (accuracy > most_accuracy) throw BeyondReach("so many digits of a distribution would cost too much");
    // the form for small p needs a p that is small for the levels, too
    const auto serves = [&, by_parts = small](double levels) { return !by_parts || small_for(levels, n, d, a.G(), a.load()); };
    Asked asked{levels_for(law, accuracy, a, serves), {}, {}};
    const slong bits = asked.levels->bits();
    asked.d = distance_from_edge(n, p_at, a, bits + 40 + static_cast<slong>(std::max(0.0, -std::log2(d))));
    const WorkingPrecision precision(bits);
    asked.p = p_at();
    return asked;
}

} // namespace

long levels_made() { return made; }

Ball density(Law law, long n, const std::function<Ball()>& p, const Arguments& a, Accuracy wanted)
{
    const Asked asked = prepare(law, n, p, a, wanted, true);
    return asked.levels->density(n, asked.p, asked.d);
}

Ball exceedance(Law law, long n, const std::function<Ball()>& p, const Arguments& a, Accuracy wanted)
{
    const Asked asked = prepare(law, n, p, a, wanted, false);
    return asked.levels->exceedance(n, asked.d);
}

long most_digits_of_distribution(long n, const std::function<Ball()>& p, const Arguments& a, bool for_density)
{
    const WorkingPrecision precision(128);
    const double d = positive_distance(n, p, a);
    long least = 0, most = 400; // serves(least), not serves(most)
    while (most - least > 1) {
        const long middle = (least + most) / 2;
        (needed_at(Law::exceedance, n, d, a, {middle}, for_density).accuracy <= most_accuracy ? least : most) = middle;
    }
    return least;
}

static bool always(double) { return true; }

Ball force(Law law, long n, const Arguments& a, Accuracy wanted)
{
    require_proven(a.G(), a.load());
    return levels_for(law, accuracy_for(wanted) + (law == Law::exceedance ? 12 : 0), a, always)->force(n);
}

Ball mass(long n, const Arguments& a, Accuracy wanted)
{
    require_proven(a.G(), a.load());
    return levels_for(Law::density, accuracy_for(wanted), a, always)->mass(n);
}

std::string distribution_certificate(Law law, long n, const std::function<Ball()>& p, const Arguments& a, Accuracy wanted)
{
    const Asked asked = prepare(law, n, p, a, wanted, true);
    return asked.levels->certificate(n, asked.p, asked.d);
}

} // namespace touchstone::transfer
