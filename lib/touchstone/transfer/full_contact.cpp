// SPDX-License-Identifier: MIT
#include "touchstone/transfer/full_contact.hpp"

#include "touchstone/transfer/graded.hpp"
#include "touchstone/transfer/piecewise.hpp"

#include <list>
#include <memory>
#include <mutex>

namespace touchstone::transfer {
namespace {

using Real = Extended;

std::mutex progress_mutex;
Progress progress_hook;

void progress(std::string_view what, long done, long total)
{
    const std::scoped_lock lock(progress_mutex);
    if (progress_hook) progress_hook(what, done, total);
}

/// (6.6)
Real first_area(const Real& x)
{
    using std::atan2, std::sqrt, std::atan;
    static const Real half_pi = 2 * atan(Real(1));
    return x >= 1 ? Real(1) : Real(atan2(sqrt(x), sqrt(1 - x)) / half_pi);
}

/// B_0, B_1, ... of one G on [0, reach], made as they are asked for.
class Areas {
public:
    Areas(const Ball& G, const Ball& reach) : G_(extended_pair(G)), reach_(extended_pair(reach).high) {}
    virtual ~Areas() = default;
    /// B_n(load) = T B_{n-1} (load), n >= 1
    Real area(long n, const Pair<Real>& load)
    {
        std::function<Real(const Wave<Real>&)> last;
        {
            const std::scoped_lock lock(mutex_);
            for (long m = levels(); m < n; ++m) {
                progress("scale", m, n);
                extend();
            }
            progress("scale", n, n);
            last = after(n - 1);
        }
        return last(wave_from(load, G_));
    }
    bool serves(const Ball& reach) const { return extended_pair(reach).high <= reach_; }

protected:
    virtual long levels() const = 0;
    virtual void extend() = 0;
    virtual std::function<Real(const Wave<Real>&)> after(long m) const = 0;

    Pair<Real> G_;
    Real reach_;

private:
    std::mutex mutex_;
};

class BlindAreas final : public Areas {
public:
    BlindAreas(const Ball& G, const Ball& reach, double smallest) : Areas(G, reach) { rule_.smallest = smallest; }

private:
    long levels() const override { return static_cast<long>(levels_.size()); }
    void extend() override
    {
        if (levels_.empty()) levels_.emplace_back(rule_, reach_, first_area);
        else levels_.emplace_back(rule_, reach_, [this, &last = levels_.back()](const Real& x) { return last.after(wave_from(Pair<Real>{x, Real(0)}, G_)); });
    }
    std::function<Real(const Wave<Real>&)> after(long m) const override
    {
        return [&v = *std::next(levels_.begin(), m)](const Wave<Real>& w) { return v.after(w); };
    }

    BlindRule rule_;
    std::list<Piecewise<Real>> levels_;
};

class TrackedAreas final : public Areas {
public:
    TrackedAreas(const Ball& G, const Ball& reach, double smallest) : Areas(G, reach), grid_(rule(smallest), singular_points(G, reach, GradedGrid<Real>::generations(rule(smallest)) - 1, 1e-18), reach) {}

private:
    long levels() const override { return static_cast<long>(levels_.size()); }
    void extend() override
    {
        levels_.push_back(levels_.empty() ? grid_.sample(first_area)
                                          : grid_.sample([this](const Real& x) { return grid_.after(levels_.back(), wave_from(Pair<Real>{x, Real(0)}, G_)); }));
    }
    std::function<Real(const Wave<Real>&)> after(long m) const override
    {
        return [this, &v = *std::next(levels_.begin(), m)](const Wave<Real>& w) { return grid_.after(v, w); };
    }

    static GradedRule rule(double smallest) { return {.smallest = smallest}; }

    GradedGrid<Real> grid_;
    std::list<GradedGrid<Real>::Function> levels_;
};

/// What is kept: the most recently used first.
std::shared_ptr<Areas> areas_of(Grid grid, const Ball& G, const Ball& load)
{
    struct Entry {
        Grid grid;
        std::string G;
        int decade; ///< of the smallest load served
        std::shared_ptr<Areas> areas;
    };
    static std::mutex mutex;
    static std::list<Entry> kept;
    // The functions are wanted where the chain can get to: y <= f(x)/G, (5.6), and the range must hold its own image.
    // Loads up to 10 share a grid.
    const Ball heaviest = certainly(less(load, Ball(10))) ? Ball(10) : load;
    const Ball first = (heaviest + 1) / G, fixed = 1 / (G - 1), partial = 2 / G;
    Ball reach(1);
    for (const Ball& b : {first, fixed, partial})
        if (!certainly(less(b, reach))) reach = b;
    Ball end;
    arb_get_ubound_arf(arb_midref(end.get()), reach.get(), 64);
    // what lies below sqrt(load) 1e-17 reaches B(load) with a weight of less than 1e-34
    const double magnitude = static_cast<double>(arf_abs_bound_lt_2exp_si(arb_midref(load.get()))) * 0.30103 / 2;
    const int decade = magnitude > -3 ? -20 : -20 + static_cast<int>(magnitude);
    const std::string name = G.to_string(40);

    const std::scoped_lock lock(mutex);
    for (auto it = kept.begin(); it != kept.end(); ++it)
        if (it->grid == grid && it->G == name && it->decade <= decade && it->areas->serves(end)) {
            kept.splice(kept.begin(), kept, it);
            return kept.front().areas;
        }
    const double smallest = std::pow(10.0, decade);
    std::shared_ptr<Areas> areas;
    if (grid == Grid::blind) areas = std::make_shared<BlindAreas>(G, end, smallest);
    else areas = std::make_shared<TrackedAreas>(G, end, smallest);
    kept.push_front({grid, name, decade, areas});
    if (kept.size() > 8) kept.pop_back();
    return areas;
}

} // namespace

void report_progress_to(Progress hook)
{
    const std::scoped_lock lock(progress_mutex);
    progress_hook = std::move(hook);
}

Estimate estimated_area(Grid grid, long n, const Ball& load, const Ball& G)
{
    const WorkingPrecision precision(256);
    if (n > 200) throw BeyondReach("not computed for n > 200 where full contact occurs (G <= 2 or load > 1)");
    if (!certainly(less(Ball(1), G * (1 << 20) / ((1 << 20) + 1)))) throw BeyondReach("not computed for G within 1e-6 of 1");
    if (!certainly(less(load, Ball(1'000'000))) || !certainly(less(Ball::exactly(1e-300), load)))
        throw BeyondReach("not computed for loads outside 1e-300 to 1e6 where full contact occurs (G <= 2 or load > 1)");
    const Pair<Real> x = extended_pair(load);
    const Real value = n == 0 ? first_area(x.high) : areas_of(grid, G, load)->area(n, x);
    const Ball exact = exact_ball(value);
    // Measured (bench_full_contact): halving every tolerance changes values by less than this.
    return {exact, exact * Ball::exactly(5e-19 + 1e-19 * std::sqrt(static_cast<double>(n)))};
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
