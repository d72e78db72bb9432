// SPDX-License-Identifier: MIT
#include "touchstone/transfer/contact.hpp"

#include "touchstone/scalar/refusal.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <list>
#include <memory>
#include <mutex>
#include <numbers>

namespace touchstone::transfer {
namespace {

constexpr std::size_t memory_limit = 300'000'000;

/// One G at one accuracy: made by the first thread to ask, while others go on with theirs.
struct Kept {
    Scheme scheme;
    double accuracy, deepest;
    std::string G; ///< the ball of G: a discretisation is valid for every G in it
    std::mutex making;
    std::shared_ptr<Discretisation> made;
    std::atomic<std::size_t> memory = 0;
};
std::mutex kept_mutex;
std::list<std::shared_ptr<Kept>> kept; // most recently used first

std::shared_ptr<Discretisation> discretisation(Scheme scheme, double accuracy, double deepest, const std::function<Ball()>& G_at)
{
    std::string G;
    {
        const WorkingPrecision precision(Discretisation::bits_for(accuracy, deepest));
        G = G_at().dump();
    }
    std::shared_ptr<Kept> mine;
    {
        const std::lock_guard lock(kept_mutex);
        const auto found = std::find_if(kept.begin(), kept.end(), [&](const auto& k) {
            return k->scheme == scheme && k->accuracy == accuracy && k->deepest == deepest && k->G == G;
        });
        if (found != kept.end()) kept.splice(kept.begin(), kept, found);
        else {
            kept.push_front(std::make_shared<Kept>());
            kept.front()->scheme = scheme;
            kept.front()->accuracy = accuracy;
            kept.front()->deepest = deepest;
            kept.front()->G = G;
        }
        mine = kept.front();
        std::size_t held = 0, count = 0;
        for (auto it = kept.begin(); it != kept.end();) {
            held += (*it)->memory;
            it = ++count > 2 && held > memory_limit ? kept.erase(it) : std::next(it);
        }
    }
    const std::lock_guard lock(mine->making);
    if (!mine->made) {
        mine->made = std::make_shared<Discretisation>(scheme, G_at, accuracy, accuracy, deepest);
        mine->memory = mine->made->memory();
    }
    return mine->made;
}

/// -log load
double depth(const Ball& load)
{
    const Ball minus_log = -log(load);
    return arf_get_d(arb_midref(minus_log.get()), ARF_RND_UP);
}

/// How far down rows have to reach: in steps, so that loads share a grid.
double deepest_for(const Ball& load)
{
    const double s = depth(load);
    return s > 30 ? 32 * std::ceil((s + 1) / 32) : 0;
}

/// The accuracy, in nats, that F is to be known with for the value to have these digits, and some to spare.
double nats_of_F(const Ball& load, Accuracy wanted)
{
    const double base = std::max(20.0, static_cast<double>(bits_for_digits(wanted.digits)) * std::numbers::ln2);
    const double s = depth(load);
    return base + (s <= 32 ? 10 : 8 * std::ceil((s / 4 + 2) / 8)); // an error of F weighs load^(-1/4) in the value
}

/// The load to so many bits, and to as many more as it takes to have 1 - load to these.
Ball told_from_1(const Arguments& a, slong bits)
{
    constexpr slong most = 8192;
    Ball load;
    for (slong more = 0;; more = std::max(2 * more, bits)) {
        const WorkingPrecision precision(bits + more);
        load = a.load();
        const Ball rest = 1 - load;
        if (arb_is_one(load.get()) || rest.relative_bits() >= bits / 2 || more > most) return load;
    }
}

struct Prepared {
    std::shared_ptr<Discretisation> on;
    Ball load, G;
};
Prepared prepare(Scheme scheme, const Arguments& a, Accuracy wanted)
{
    const Ball load = a.load();
    if (!certainly(less(Ball(0), load)) || !certainly(less(load, Ball(2)))) throw BeyondReach("load must be above 0 and at most 1");
    Prepared p;
    p.on = discretisation(scheme, nats_of_F(load, wanted), deepest_for(load), a.G);
    p.load = told_from_1(a, p.on->bits());
    const WorkingPrecision precision(p.on->bits());
    p.G = a.G();
    if (!arb_is_one(p.load.get()) && !certainly(less(p.load, Ball(1)))) throw BeyondReach("load must be at most 1");
    return p;
}

/// f(accuracy), with more digits than are wanted where so few do not last over all scales.
template <class F>
auto accurate_over_all_scales(Accuracy wanted, F f)
{
    constexpr int most_attempts = 5;
    for (int attempt = 1;; ++attempt) {
        try {
            return f(wanted);
        }
        catch (const ErrorsHaveOutgrown&) {
            if (attempt == most_attempts) throw;
        }
        wanted.digits = 2 * wanted.digits + 10;
    }
}

Ball area_of(const Prepared& p, long n)
{
    const Ball F = p.on->force_share(n, p.load);
    const WorkingPrecision precision(p.on->bits());
    Ball scale;
    arb_pow_ui(scale.get(), p.G.get(), static_cast<ulong>(n), precision.bits());
    return sqrt(p.load) * F / scale;
}

} // namespace

Ball area(Scheme scheme, long n, const Arguments& a, Accuracy wanted)
{
    return accurate_over_all_scales(wanted, [&](Accuracy accuracy) { return area_of(prepare(scheme, a, accuracy), n); });
}

std::string area_certificate(Scheme scheme, long n, const Arguments& a, Accuracy wanted)
{
    return accurate_over_all_scales(wanted, [&](Accuracy accuracy) { return prepare(scheme, a, accuracy).on->certificate(n); });
}

long most_digits_of_area(const Ball& load, const Ball& G)
{
    const WorkingPrecision precision(128);
    const auto serves = [&](long digits) {
        const double accuracy = nats_of_F(load, {digits}), deepest = deepest_for(load);
        return std::max(Discretisation::size_for(Scheme::force_weighted, G, accuracy, deepest),
                        Discretisation::size_for(Scheme::area, G, accuracy, deepest)) <= Discretisation::most_nodes;
    };
    long least = 0, most = 10'001; // serves(least), not serves(most)
    while (most - least > 1) {
        const long middle = (least + most) / 2;
        (serves(middle) ? least : most) = middle;
    }
    return least;
}

} // namespace touchstone::transfer
