// SPDX-License-Identifier: MIT
#include "touchstone/transfer/proven_levels.hpp"

#include "touchstone/scalar/refusal.hpp"
#include "touchstone/transfer/defects.hpp"
#include "touchstone/transfer/level_bounds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <list>
#include <mutex>

namespace touchstone::transfer {

using std::max, std::min;
using namespace bounds;
using namespace levels;
constexpr int most_levels = ProvenLevels::most_levels;

/// Search, then proof: the V_m are found in one line and may be anything in the next.
struct ProvenLevels::State {
    Real G;
    double tolerance;
    int levels; ///< V_0 ... V_(levels-1)
    std::unique_ptr<const First> first;
    Rules rules;
    std::unique_ptr<Layer> V;
    Defects D;

    State(Real G_, std::unique_ptr<const First> first_, double highest, double tolerance_, const Spoiled& spoiled, int scales)
        : G(G_), tolerance(tolerance_), levels(min(most_levels, scales)), first(std::move(first_)), rules(tolerance),
          V(collocate(rules, *first, G, highest, tolerance, levels, spoiled)), D(rules, *V, levels, tolerance, first->is_share())
    {
        D.prove_level_zero(*first);
        if (levels > 1) D.prove_steps();
        D.add_up();
    }
};

// ---- values

static std::unique_ptr<ProvenLevels::State> made(const Ball& G, std::unique_ptr<const First> first, double highest, double tolerance,
                                                 const ProvenLevels::Spoiled& spoiled, int scales)
{
    require_binary64_arithmetic();
    if (!(tolerance >= ProvenLevels::finest_tolerance && tolerance <= ProvenLevels::coarsest_tolerance))
        throw std::invalid_argument("tolerance from 1e-25 to 1e-5");
    const WorkingPrecision precision(256);
    const Real nearest = to_real(G);
    const Ball off = abs(to_ball(nearest) / G - Ball(1));
    if (!certainly(less(Ball(1), G)) || !certainly(less(off, Ball::exactly(u))))
        throw BeyondReach("G must be above 1 and known to 101 bits");
    const double stays_below = 1.1 / double(nearest - 1), top = max(highest, stays_below); // and (x + 1)/G with x
    constexpr double most_panels_wide = 400; // of ratios next to each of which panels are narrow, whatever the load
    if (!(stays_below <= most_panels_wide)) throw BeyondReach("G too near 1 for the proven levels");
    if (!(highest <= 1.001 * ProvenLevels::highest_load)) throw BeyondReach("the load is too high for the proven levels");
    return std::make_unique<ProvenLevels::State>(nearest, std::move(first), top * 1.01, tolerance, spoiled, scales);
}

ProvenLevels::ProvenLevels(const Ball& G, double highest, double tolerance, int scales, const Spoiled& spoiled)
    : state_(made(G, in_contact(), highest, tolerance, spoiled, scales))
{
}
ProvenLevels::ProvenLevels(const Ball& G, const Ball& pressure, double highest, double tolerance, int scales, const Spoiled& spoiled)
{
    const WorkingPrecision precision(256);
    const Real nearest = to_real(pressure);
    if (!certainly(less(Ball(0), pressure)) || !certainly(less(abs(to_ball(nearest) / pressure - Ball(1)), Ball::exactly(u))))
        throw BeyondReach("the pressure must be above 0 and known to 101 bits");
    state_ = made(G, exceeding(pressure), highest, tolerance, spoiled, scales);
}
ProvenLevels ProvenLevels::densities(const Ball& G, const Ball& pressure, double highest, double tolerance, int scales,
                                     const Spoiled& spoiled)
{
    const Ball nearest = to_ball(to_real(pressure));
    if (!certainly(less(Ball(0), pressure)) || !certainly(less(abs(nearest / pressure - Ball(1)), Ball::exactly(u))))
        throw BeyondReach("the pressure must be above 0 and known to 101 bits");
    ProvenLevels result;
    result.unit_ = std::min(1.0, std::exp2(std::floor(std::log2(double(to_real(pressure))))));
    auto first = std::make_unique<Density>(G, pressure, result.unit_, tolerance / 64);
    if (!(first->waves.lowest() > 2 * lowest_of_densities && result.unit_ >= 0x1p-10))
        throw BeyondReach("the pressure is too low for the proven levels of densities"); // minutes and more
    result.state_ = made(G, std::move(first), highest, tolerance, spoiled, scales);
    return result;
}
ProvenLevels::ProvenLevels() = default;
ProvenLevels::~ProvenLevels() = default;
ProvenLevels::ProvenLevels(ProvenLevels&&) noexcept = default;

const levels::Layer& ProvenLevels::layer() const { return *state_->V; }
std::size_t ProvenLevels::memory() const
{
    return (state_->V->coefficients.size() + state_->V->weights.size()) * 2 * sizeof(double) * 5 / 4;
}

namespace {
struct Contribution {
    int level;
    double effect, weight;
};
} // namespace

static Ball share_and_budget(const ProvenLevels::State& s, long n, const Ball& load, std::vector<Contribution>* budget)
{
    require_binary64_arithmetic();
    const int levels = s.levels;
    if (n < 1 || n > levels) throw BeyondReach(fmt::format("proven levels: n from 1 to {}", levels));
    const WorkingPrecision precision(256);
    const Real x = to_real(load), low = x * Real{1, -4 * u}, high = x * Real{1, 4 * u};
    if (!certainly(less(to_ball(low), load)) || !certainly(less(load, to_ball(high)))) throw BeyondReach("load not known to 101 bits");
    const double top = not_below(high), g = not_above(s.G);
    const std::vector<double> reach = highest_ratios(top, g, levels);
    const bool share = s.first->is_share(), exact = is_exactly(load, x);
    Result below, above;
    s.V->apply(share ? low : x, below);
    s.V->apply(share ? high : x, above);
    std::vector<double> at_most = mass_after_steps(g, top, levels);
    Ball result;
    for (int scale = 1; scale <= n; ++scale) { // B_scale = T B_{scale-1} (load), error sum_m T^{scale-m} D_m
        double lost = 0;
        if (budget) budget->clear();
        for (int m = 0; m < scale; ++m) {
            double effect, weight = at_most[scale - m - 1];
            if (share || m > 0) effect = s.D.effect(m, reach[scale - m]);
            else if (scale == 1) effect = exact ? s.D.effect_at(x, x) : s.D.effect_at(low, high);
            else {
                effect = s.D.second_effect(0, reach[scale]);
                weight = at_most[scale - 2];
            }
            lost += margin * effect * weight;
            if (budget) budget->push_back({m, effect, weight});
        }
        if (!share && !exact) lost += s.D.blur(scale - 1, x);
        const auto bound = [&](const Result& r) { return Ball::exactly(margin * (r.error[scale - 1] + lost)); };
        const Ball least = to_ball(below.value[scale - 1]) - bound(below), most = to_ball(above.value[scale - 1]) + bound(above);
        if (s.first->is_area() && scale < levels)
            at_most[scale + 1] = min(at_most[scale + 1], margin * arf_get_d(arb_midref(most.get()), ARF_RND_UP));
        result = hull(certainly(less(least, Ball(0))) ? Ball(0) : least, share && certainly(less(Ball(1), most)) ? Ball(1) : most);
    }
    return result;
}

Ball ProvenLevels::share(long n, const Ball& load) const
{
    const WorkingPrecision precision(256);
    return share_and_budget(*state_, n, load, nullptr) * Ball::exactly(unit_);
}

std::string ProvenLevels::certificate(long n, const Ball& load) const
{
    std::vector<Contribution> budget;
    const Ball value = share_and_budget(*state_, n, load, &budget);
    const bool share = state_->first->is_share();
    const long shift = share ? 0 : 1; // level 0 of densities is D_1
    std::string text =
        fmt::format("proven levels: {} panels of {} terms, G to 101 bits; T {}_{} within {:.2e}{}\n", state_->V->panels.size(),
                    state_->rules.orders.terms, share ? 'B' : 'D', n - 1 + shift, value.radius_bound() * unit_, share ? "" : ", in 1/p*_n");
    for (const auto& b : budget)
        text += fmt::format("  level {:2}: T of its defect <= {:.2e}, share of it that reaches the value: {:.2e}\n", b.level + shift,
                            b.effect * unit_, b.weight);
    return text;
}

// ---- kept meshes

namespace {

enum class Law { area, exceedance, density };

/// The tolerance of the mesh. The proven error is larger by up to a hundred at scale 20, usually by less; where it leaves a digit open,
/// more are asked for. That takes a second mesh: it is risked where meshes are cheap, not where tables of many rows stand on one.
double tolerance_for(Accuracy wanted, Law law)
{
    constexpr double least = 4, finest = 25, cheap = 8, spare_where_cheap = 3, spare_of_shares = 4, spare_of_densities = 2;
    const double digits = max(least, static_cast<double>(wanted.digits));
    const double spare = law == Law::density ? spare_of_densities : digits <= cheap ? spare_where_cheap : spare_of_shares;
    return std::pow(10.0, -min(finest, digits + spare));
}

struct Mesh {
    Law law;
    std::string G, pressure;
    double highest, tolerance;
    int scales;
    std::mutex making;
    std::shared_ptr<const ProvenLevels> made;
};
std::mutex meshes_mutex;
std::list<std::shared_ptr<Mesh>> meshes; // most recently used first

/// \param scales at least as many levels as these
std::shared_ptr<const ProvenLevels> proven_levels(Law law, long scales, const Arguments& a, Accuracy wanted,
                                                  const std::function<Ball()>& pressure = {})
{
    const double tolerance = tolerance_for(wanted, law);
    const WorkingPrecision precision(256);
    const Ball G = a.G(), P = law == Law::area ? Ball(0) : pressure();
    const double load = double(to_real(a.load()));
    if (!(load <= ProvenLevels::highest_load)) throw BeyondReach(fmt::format("load above {}", ProvenLevels::highest_load));
    const double g = double(to_real(G)); // below: the first panel of the finest mesh begins above all ratios
    if (4 * load < 1e-53 * g * g) throw BeyondReach("load too small for the proven levels");
    // one mesh of areas for the loads of figure 3 and the scales of most tables; beyond, few
    const double highest = law != Law::area ? load * (1 + 0x1p-40) : load <= 10 ? 10 : load <= 100 ? 100 : ProvenLevels::highest_load;
    constexpr long step = ProvenLevels::usual_levels;
    if (law == Law::area) scales = (scales + step - 1) / step * step;
    std::shared_ptr<Mesh> mine;
    {
        const std::lock_guard lock(meshes_mutex);
        const auto found = std::find_if(meshes.begin(), meshes.end(), [&](const auto& m) {
            return m->law == law && m->tolerance <= tolerance && m->highest >= highest && m->scales >= scales && m->G == G.dump() &&
                   m->pressure == P.dump();
        });
        if (found != meshes.end()) meshes.splice(meshes.begin(), meshes, found);
        else {
            meshes.push_front(std::make_shared<Mesh>());
            Mesh& m = *meshes.front();
            m.law = law;
            m.G = G.dump();
            m.pressure = P.dump();
            m.highest = highest;
            m.tolerance = tolerance;
            m.scales = static_cast<int>(scales);
        }
        mine = meshes.front();
        if (meshes.size() > 4) meshes.pop_back(); // up to 200 MB each
    }
    const std::lock_guard lock(mine->making);
    if (!mine->made)
        mine->made =
            law == Law::area ? std::make_shared<const ProvenLevels>(G, mine->highest, mine->tolerance, mine->scales)
            : law == Law::exceedance
                ? std::make_shared<const ProvenLevels>(G, P, mine->highest, mine->tolerance, mine->scales)
                : std::make_shared<const ProvenLevels>(ProvenLevels::densities(G, P, mine->highest, mine->tolerance, mine->scales));
    return mine->made;
}

/// The load is asked for to all bits the levels use, however few digits are wanted.
Ball share_at(const ProvenLevels& levels, long n, const Arguments& a)
{
    const WorkingPrecision precision(256);
    return levels.share(n, a.load());
}

void require_level(long n)
{
    if (n > most_levels)
        throw BeyondReach(fmt::format("with full contact, areas and exceedances are certified for n <= {} only", most_levels));
}

} // namespace

Ball area_by_proven_levels(long n, const Arguments& a, Accuracy wanted)
{
    require_level(n);
    return share_at(*proven_levels(Law::area, n, a, wanted), n, a);
}

Ball exceedance_by_proven_levels(long n, const std::function<Ball()>& pressure, const Arguments& a, Accuracy wanted)
{
    require_level(n);
    return share_at(*proven_levels(Law::exceedance, n, a, wanted, pressure), n, a);
}

Ball density_by_proven_levels(long n, const std::function<Ball()>& pressure, const Arguments& a, Accuracy wanted)
{
    require_level(n);
    return share_at(*proven_levels(Law::density, n - 1, a, wanted, pressure), n - 1, a);
}

static std::string certificate(const std::shared_ptr<const ProvenLevels>& levels, long n, const Arguments& a)
{
    const WorkingPrecision precision(256);
    return levels->certificate(n, a.load());
}

std::string area_by_proven_levels_certificate(long n, const Arguments& a, Accuracy wanted)
{
    return certificate(proven_levels(Law::area, n, a, wanted), n, a);
}
std::string exceedance_by_proven_levels_certificate(long n, const std::function<Ball()>& pressure, const Arguments& a, Accuracy wanted)
{
    return certificate(proven_levels(Law::exceedance, n, a, wanted, pressure), n, a);
}
std::string density_by_proven_levels_certificate(long n, const std::function<Ball()>& pressure, const Arguments& a, Accuracy wanted)
{
    return certificate(proven_levels(Law::density, n - 1, a, wanted, pressure), n - 1, a);
}

} // namespace touchstone::transfer
