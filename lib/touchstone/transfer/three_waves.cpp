// SPDX-License-Identifier: MIT
// Compiled with -ffp-contract=off, as proven_levels.cpp.
#include "touchstone/transfer/three_waves.hpp"

#include "touchstone/scalar/refusal.hpp"
#include "touchstone/transfer/arc.hpp"
#include "touchstone/transfer/ellipse_cover.hpp"
#include "touchstone/transfer/parallel.hpp"
#include "touchstone/transfer/two_waves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace touchstone::transfer {
namespace {

using Real = TwoWaves::Real;
using std::max, std::min;
using namespace bounds;
using namespace levels;

constexpr double rho = 4;                                  // of the ellipse on which the integrand of an interval is bounded
constexpr double moved_node = 8 * u;                       // of a node, relative to t
constexpr double narrowest = 256 * u;                      // half of an interval, relative to t: its nodes stay well inside the disc
constexpr int node_steps = 4;                              // rules of a quarter of the nodes, of half of them, ...
constexpr std::size_t most_intervals = 100'000;
constexpr slong bits = 384; // as those of the ends of the two waves

class Integral {
public:
    Integral(const Ball& G, const Ball& P, const Ball& x, double tolerance)
        : unit_(min(1.0, std::exp2(std::floor(std::log2(double(to_real(P)))))))
        , tolerance_(tolerance * unit_)
        , waves_(G, P, tolerance_ / 256)
        , G_(G)
        , x_(x)
    {
        const int most = static_cast<int>(std::ceil((7 - std::log10(tolerance)) / (2 * std::log10(rho)) + 1));
        for (int k = 1; k <= node_steps; ++k) rules_.emplace_back((most * k + node_steps - 1) / node_steps);
        if (!certainly(less(x, Ball(1)))) {
            if (possibly(less(x, Ball(1)))) throw BeyondReach("the load cannot be told from 1");
            const Real half = std::sqrt(0.5); // the two meet at c = 0, but for a rounding
            const Real rest = sqrt(Real(1) - half * half);
            add(Arc(Arc::Kind::from_top, G, x), half);
            add(Arc(Arc::Kind::from_bottom, G, x), rest);
            hole(Arc(Arc::Kind::from_top, G, x), half * Real{1, -8 * u}, half);
        }
        else { // y > lowest: t^2 < (1 + x - ((1 - x)^2 + (G lowest)^2)^(1/2))/2
            const Ball edge = G * Ball::exactly(waves_.lowest()), squared = edge * edge;
            const Ball t2 = (4 * x - squared) / (2 * (1 + x + sqrt((1 - x) * (1 - x) + squared)));
            if (certainly(less(t2, Ball(0)))) return;
            add(Arc(Arc::Kind::partial, G, x), to_real(sqrt(t2)));
        }
    }

    ThreeWaves result()
    {
        std::vector<Real> sums(accepted_.size());
        std::vector<double> errors(accepted_.size());
        in_parallel(accepted_.size(), [&](std::size_t i) { integrate(accepted_[i], sums[i], errors[i]); });
        Real sum = 0;
        double error = holes_;
        for (std::size_t i = 0; i < sums.size(); ++i) {
            sum += sums[i];
            error += errors[i];
        }
        error += rounding_of_sum(sum, sums.size() + rules_.back().nodes.size());
        if (!(error < infinite)) throw BeyondReach("numbers of 106 bits do not reach so near to a singular point");
        const WorkingPrecision precision(bits);
        Ball value = to_ball(sum);
        arb_add_error(value.get(), Ball::exactly(margin * error).get());
        return {
            value,
            fmt::format(
                "three waves: {} intervals of up to {} nodes, within {:.2e}, of which {:.2e} for {} intervals about logarithms and jumps; in 1/p*_n\n",
                accepted_.size(), rules_.back().nodes.size(), margin * error, holes_, hole_count_)};
    }

private:
    struct Interval {
        Arc arc;
        Real low, high;
        const Gauss* gauss;
        double error; ///< of the rule, and what rounding of the nodes does
    };

    void add(const Arc& arc, const Real& end)
    {
        std::vector<std::pair<Real, Real>> waiting{{Real(0), end}};
        while (!waiting.empty()) {
            const auto [low, high] = waiting.back();
            waiting.pop_back();
            if (accepted_.size() + static_cast<std::size_t>(hole_count_) + waiting.size() > most_intervals)
                throw BeyondReach("too many intervals for the density after three waves");
            if (below_support(arc, low, high) || accept(arc, low, high) || hole(arc, low, high)) continue;
            const Real middle = (low + high) * 0.5;
            waiting.emplace_back(middle, high);
            waiting.emplace_back(low, middle);
        }
    }

    bool below_support(const Arc& arc, const Real& low, const Real& high) const
    {
        const WorkingPrecision precision(bits);
        const Ball lowest = Ball::exactly(waves_.lowest());
        return certainly(less(arc.ratio(to_ball(low)), lowest)) && certainly(less(arc.ratio(to_ball(high)), lowest));
    }

    bool accept(const Arc& arc, const Real& low, const Real& high)
    {
        const WorkingPrecision precision(bits);
        const Real middle = (low + high) * 0.5;
        const auto [half, r] = Surroundings(low, high, rho);
        if (!(half >= narrowest * magnitude(high))) return false;
        const Ball a = arc.ratio(to_ball(low)), b = arc.ratio(to_ball(high));
        const bool above = !possibly(less(a, Ball(1))) && !possibly(less(b, Ball(1)));
        if (!above && (possibly(less(Ball(1), a)) || possibly(less(Ball(1), b)))) return false;
        const double moved = arc.moved(middle, r), weight = Arc::weight_near(middle, r);
        if (!(moved < infinite && weight < infinite)) return false;
        const double M = waves_.on_disc(above, arc.ratio(to_ball(middle)), moved) * weight;
        if (!(M < infinite)) return false;
        for (const Gauss& gauss : rules_) {
            const double rule = half * M * gauss_error(rho, gauss.nodes.size());
            if (!(rule <= tolerance_ / 1024)) continue;
            accepted_.push_back({arc, low, high, &gauss, margin * (rule + moved_nodes_error(half, moved_node * magnitude(high), r, M))});
            return true;
        }
        return false;
    }

    /// What counts for nothing; or for what it does, where numbers of 106 bits cannot halve it.
    bool hole(const Arc& arc, const Real& low, const Real& high)
    {
        const WorkingPrecision precision(bits);
        const Ball a = arc.ratio(to_ball(low)), b = arc.ratio(to_ball(high)), length = abs(a - b);
        const double width = magnitude(to_real(length)), least = magnitude(to_real(certainly(less(a, b)) ? a : b)), most = least + width;
        const double counts = margin * max(waves_.weight_on(least, width), waves_.weight_on(most, width)) * arc.share(low, high, width);
        if (!(counts <= tolerance_ / 256) && magnitude(high - low) > 4 * narrowest * magnitude(high)) return false;
        holes_ += counts;
        ++hole_count_;
        return true;
    }

    void integrate(const Interval& on, Real& sum, double& error) const
    {
        const WorkingPrecision precision(bits);
        const Real middle = (on.low + on.high) * 0.5, half = (on.high - on.low) * 0.5;
        error = on.error;
        const Gauss& gauss = *on.gauss;
        for (std::size_t i = 0; i < gauss.nodes.size(); ++i) {
            const Real t = middle + half * gauss.nodes[i], weight = half * gauss.weights[i] * Arc::weight(t);
            const auto [value, lost] = waves_.value(on.arc.ratio(to_ball(t)));
            sum += weight * value;
            error += margin * weight.high * lost;
        }
    }

    double unit_, tolerance_;
    TwoWaves waves_;
    std::vector<Gauss> rules_; ///< the fewest nodes first
    Ball G_, x_;
    std::vector<Interval> accepted_;
    double holes_ = 0;
    long hole_count_ = 0;
};

} // namespace

ThreeWaves density_after_three_waves(const Ball& G, const Ball& pressure, const Ball& load, double tolerance)
{
    require_binary64_arithmetic();
    if (!(tolerance >= 1e-25 && tolerance <= 1e-4)) throw std::invalid_argument("tolerance from 1e-25 to 1e-4");
    const WorkingPrecision precision(bits);
    if (!certainly(less(Ball(1), G)) || !certainly(less(Ball(0), pressure)) || !certainly(less(Ball(0), load)))
        throw BeyondReach("G must be above 1, pressure and load above 0");
    return Integral(G, pressure, load, tolerance).result();
}

} // namespace touchstone::transfer
