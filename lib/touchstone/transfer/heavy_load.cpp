// SPDX-License-Identifier: MIT
#include "touchstone/transfer/heavy_load.hpp"

#include "touchstone/scalar/refusal.hpp"
#include "touchstone/transfer/heavy_load_panels.hpp"
#include "touchstone/wave/lemmas.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <numbers>

namespace touchstone::transfer {

using Traits = ScalarTraits<Ball>;

namespace heavy_load {

Ball largest_size(const Ball& G)
{
    return wave::size(G, 64).back() * (1 + Traits::power_of_two(-30));
}

Ball largest_real(const Ball& X, const Ball& G, const Ball& c)
{
    return is_below(X, Ball(1)) || arb_is_one(X.get()) ? c : G * largest_real((X + 1) / G, G, c);
}

Ball largest_in_disc(const Ball& X, const Ball& G, const Ball& c)
{
    if (is_below(X, Ball(1)) || arb_is_one(X.get())) return c;
    return upper(largest_real(X, G, c) + 2 / Traits::pi() * sqrt(X) * G * largest_in_disc(upper((X + 1) / G), G, c));
}

std::vector<Bracket> singular_points(const Ball& top, const Ball& G)
{
    std::vector<Bracket> all{{Ball(0), Ball(0)}, {Ball(1), Ball(1)}};
    const Ball limit = above(G * (top + 2) + 2);
    std::vector<Ball> generation{Ball(0), Ball(1)};
    while (!generation.empty()) {
        std::vector<Ball> next;
        for (const Ball& s : generation)
            for (const Ball& t : {wave::meets_upper_end_full(s, G), wave::meets_lower_end(s, G)}) {
                if (!is_below(Ball(1), t) || !is_below(t, limit)) continue; // 1 itself is there; G s - 1 = 1 only for G s = 2, s = 1
                next.push_back(t);
                all.push_back({below(t), above(t)});
            }
        generation = std::move(next);
        if (all.size() > 5000) throw BeyondReach("the load has too many singular points below it");
    }
    std::sort(all.begin(), all.end(), [](const Bracket& a, const Bracket& b) { return arb_lt(a.lo.get(), b.lo.get()) != 0; });
    std::vector<Bracket> merged;
    for (const Bracket& b : all)
        if (!merged.empty() && !is_below(merged.back().hi, b.lo))
            merged.back().hi = is_below(merged.back().hi, b.hi) ? b.hi : merged.back().hi;
        else merged.push_back(b);
    return merged;
}

Cuts cuts_between(const Ball& lo, const Ball& hi, const std::vector<Bracket>& S)
{
    Cuts c{{{below(lo), above(lo)}}, 0, 0};
    std::vector<Bracket>& cuts = c.at;
    for (const Bracket& s : S) {
        if (is_below(s.hi, cuts.front().lo)) {
            c.room_lo = room_between(s.hi, lo);
            continue;
        }
        if (is_below(hi, s.lo)) {
            c.room_hi = room_between(hi, s.lo);
            break;
        }
        if (is_below(cuts.back().hi, s.lo)) cuts.push_back(s);
        else {
            cuts.back().hi = is_below(cuts.back().hi, s.hi) ? s.hi : cuts.back().hi;
            if (cuts.size() == 1) c.room_lo = 0;
        }
    }
    if (is_below(cuts.back().hi, hi)) cuts.push_back({below(hi), above(hi)});
    else {
        cuts.back().hi = above(hi);
        c.room_hi = 0;
    }
    return c;
}

Grid::Grid(const Ball& lo, const Ball& hi, const Shape& shape_, double last, double wanted, const Ball& bound_, const FixedFormat& format_)
    : g(graded(lo, hi, shape_.ratio, last)), shape(shape_), bound(bound_), format(format_)
{
    const double log_bound = std::log(4 * upper_double(bound) / (shape.rho - 1));
    Ball far = g.reach;
    for (long k = 0; k < g.depth; ++k) {
        const Ball near = g.reach * g.power(-k - 1), half = (far - near) / 2, at = (far + near) / 2;
        // what enters a panel weighs about the root of its width
        const double need = wanted + 2 + log_bound + std::min(0.0, std::log(approximate(far)) / 2);
        const long p = 2 + std::max(0L, static_cast<long>(std::ceil(need / std::log(shape.rho))));
        left.push_back({lo + at, half, p, nodes});
        right.push_back({hi - at, half, p, nodes + static_cast<std::size_t>(p)});
        nodes += 2 * static_cast<std::size_t>(p);
        most_points = std::max(most_points, p);
        far = near;
    }
    moments.assign(nodes * static_cast<std::size_t>(format.limbs()), 0);
    buffer.resize(6 * static_cast<std::size_t>(format.limbs()));
}

void Grid::enter(const Ball& y, const Ball& w)
{
    const bool on_left = arf_cmp(arb_midref(y.get()), arb_midref(g.middle.get())) < 0;
    std::vector<Panel>& side = on_left ? left : right;
    const double weight = upper_double(abs(w)), away = approximate(on_left ? y - g.lo : g.hi - y);
    const double guess = away > 0 ? std::log(approximate(g.reach) / away) / std::log(shape.ratio) : 1e9;
    auto k = static_cast<std::size_t>(std::clamp(guess, 0.0, static_cast<double>(side.size() - 1)));
    Ball tau = (y - side[k].mid) / side[k].half;
    if (!on_left) tau = -tau; // tau = -1 is next to the end of the interval
    if (is_below(Ball(1), tau) && k > 0) --k;
    else if (is_below(tau, Ball(-1)) && k + 1 < side.size()) ++k;
    Panel& p = side[k];
    tau = (y - p.mid) / p.half;
    if (is_below(abs(tau), Ball(1))) ;
    else {
        const Ball edge = arf_sgn(arb_midref(tau.get())) < 0 ? Ball(-1) : Ball(1), moved = abs(tau - edge) * p.half;
        held += weight * upper_double(ScalarTraits<Ball>::sqrt_positive_part(moved));
        tau = edge;
    }
    if (!(tau.radius_bound() < 0x1p-100)) throw BeyondReach("a singular point and a node are too close to be told apart");
    p.entered += weight;
    loose += entry_error(weight, w.radius_bound(), tau.radius_bound(), p.points);
    ++terms;

    const auto limbs = static_cast<std::size_t>(format.limbs());
    const auto n = static_cast<mp_size_t>(limbs);
    mp_limb_t *t = &buffer[0], *before = t + n, *now = before + n, *next = now + n, *scratch = next + n;
    format.put(t, tau);
    format.put(before, w);
    format.multiply(now, before, t, 0, scratch);
    mp_limb_t* sum = &moments[p.first * limbs];
    mpn_add_n(sum, sum, before, n);
    sum += n;
    mpn_add_n(sum, sum, now, n);
    for (long k2 = 2; k2 < p.points; ++k2) {
        sum += n;
        format.multiply(next, now, t, 1, scratch);
        mpn_sub_n(next, next, before, n);
        mpn_add_n(sum, sum, next, n);
        mp_limb_t* const free = before;
        before = now, now = next, next = free;
    }
}

double Grid::lost() const
{
    double interpolated = 0, entered = 0;
    for (const std::vector<Panel>* side : {&left, &right})
        for (const Panel& p : *side) {
            interpolated += p.entered * interpolation_error(p.points, shape.rho);
            entered += p.entered;
        }
    return upper_double(bound) * (loose + interpolated + rounding_error(entered, terms, most_points, upper_double(format.unit())));
}

std::vector<Node> Grid::as_nodes(const std::function<const std::vector<Ball>&(long)>& cosines_for) const
{
    std::vector<Node> all;
    const auto limbs = static_cast<std::size_t>(format.limbs());
    fmpz_t units;
    fmpz_init(units);
    for (const std::vector<Panel>* side : {&left, &right})
        for (const Panel& p : *side) {
            if (p.entered == 0) continue;
            const std::vector<Ball>& cosines = cosines_for(p.points);
            std::vector<Ball> mu(static_cast<std::size_t>(p.points));
            for (std::size_t k = 0; k < mu.size(); ++k) {
                format.get(units, &moments[(p.first + k) * limbs]);
                arb_set_fmpz(mu[k].get(), units);
                mu[k] = mu[k] * format.unit();
            }
            for (long j = 0; j < p.points; ++j) {
                Ball w = mu[0] / 2;
                for (long k = 1; k < p.points; ++k)
                    w += mu[static_cast<std::size_t>(k)] * cosines[static_cast<std::size_t>(k * (2 * j + 1) % (4 * p.points))];
                all.push_back({p.mid + p.half * cosines[static_cast<std::size_t>(2 * j + 1)], 2 * w / Ball(p.points)});
            }
        }
    fmpz_clear(units);
    return all;
}

std::vector<Ball> cosines(long p)
{
    std::vector<Ball> all;
    for (long k = 0; k < 4 * p; ++k) all.push_back(ScalarTraits<Ball>::cos_pi(Ball(k) / Ball(2 * p)));
    return all;
}

} // namespace heavy_load

namespace {

using namespace heavy_load;

/// How many nats the weights are wanted to, for a value to so many.
double nats_wanted(double accuracy, double G) { return accuracy + 2 + std::log(G); }
/// The scales that the first steps are made for: few numbers, so that scales share them.
long scales_for(long n) { return n <= 5 ? 5 : 20 * ((n + 19) / 20); }
/// The accuracy of a value of so many digits, in nats.
double nats_of(Accuracy wanted) { return std::max(44.0, static_cast<double>(bits_for_digits(wanted.digits) - 8) * std::numbers::ln2); }

/// Width of the finest panels: what is left out next to an end is worth its root at scale 0, and values are about G^-n.
double finest_panel(double wanted, double G, long scales) { return std::exp(-wanted) * std::pow(G, -static_cast<double>(scales) / 2); }

constexpr double narrowest_panel = 1e-300; ///< below are no binary64 numbers of full accuracy

/// One load and one G.
class HeavyLoad {
public:
    HeavyLoad(Scheme scheme, const Arguments& a, double accuracy, long scales_asked)
        : scales(scales_asked), wanted(nats_wanted(accuracy, approximate(a.G()))),
          last(finest_panel(wanted, approximate(a.G()), scales)), format(static_cast<long>(100 + wanted / std::numbers::ln2)),
          bits(static_cast<slong>(170 - std::log2(std::max(last, narrowest_panel))))
    {
        if (!(last >= narrowest_panel))
            throw BeyondReach("for load > 1 panels about G^(-n/2) wide would be needed, too narrow for binary64 numbers");
        const WorkingPrecision precision(bits);
        G = a.G();
        load = a.load();
        if (!is_below(Ball(2), G)) throw BeyondReach("G = gamma^(D-1) must be above 2");
        if (!is_below(Ball(Rational(2019, 1000)), G))
            throw BeyondReach("for load > 1 so near G = 2 it would take hours: many scales have ratios about 1");
        if (!is_below(Ball(1), load) || !is_below(load, Ball(1001))) throw BeyondReach("load must be above 1 and below 1001");
        shape = scheme == Scheme::force_weighted ? Shape{4, 2.9} : Shape{6, 2.3};
        if (!shape.stays_in_disc()) throw std::logic_error("full contact: an ellipse leaves its disc");
        chain = std::make_shared<Discretisation>(scheme, a.G, std::max(wanted + 8, -std::log(last) / 0.95));
        c = largest_size(G);
        spread_measure();
    }

    Ball Q(const Ball& X) const { return largest_real(X, G, c); }
    Ball M(const Ball& X) const { return largest_in_disc(X, G, c); }

    // ---- measures on the ratios of one scale

    Grid grid(const Ball& lo, const Ball& hi) const { return Grid(lo, hi, shape, last, wanted, M(hi), format); }
    /// The grid as weighted points; its errors are added up for level j.
    std::vector<Node> nodes_of(Grid& g, long level)
    {
        add_error(level, g.lost());
        moved[level] += g.held;
        return g.as_nodes([this](long p) -> const std::vector<Ball>& { return cosines_for(p); });
    }
    const std::vector<Ball>& cosines_for(long p)
    {
        auto& c_p = cosines[p];
        if (c_p.empty()) c_p = heavy_load::cosines(p);
        return c_p;
    }
    const Gauss& gauss(long n)
    {
        Gauss& g = rules[n];
        if (g.root.empty())
            for (long k = 0; k < n; ++k) {
                Ball root, weight;
                arb_hypgeom_legendre_p_ui_root(root.get(), weight.get(), static_cast<ulong>(n), static_cast<ulong>(k),
                                               WorkingPrecision::bits());
                g.root.push_back(root);
                g.weight.push_back(weight);
            }
        return g;
    }
    /// e times G^-(n - level) in A_n
    void add_error(long level, double e) { errors[level] += e; }

    // ---- one scale

    /// The grids that serve the ratios of one scale: (0, 1), and the intervals above 1 within the range.
    struct Scale {
        Ball lo, hi; ///< range of the ratios
        std::vector<Grid> grids; ///< the first is (0, 1)
    };
    Scale scale(const Ball& lo, const Ball& hi) const
    {
        Scale s{lo, hi, {}};
        s.grids.push_back(grid(Ball(0), Ball(1)));
        if (!is_below(hi, Ball(1)))
            for (std::size_t i = 1; i + 1 < S.size(); ++i)
                if (!is_below(S[i + 1].lo, lo) && !is_below(hi, S[i].hi)) s.grids.push_back(grid(S[i].hi, S[i + 1].lo));
        return s;
    }
    void enter(Scale& s, const Ball& y, const Ball& w)
    {
        for (Grid& g : s.grids)
            if (arf_cmp(arb_midref(y.get()), arb_midref(g.g.hi.get())) <= 0) return g.enter(y, w);
        s.grids.back().enter(y, w);
    }

    /// A piece of the wave of weight w to the next scale (heavy_load_panels.hpp).
    template <class Kernel, class Bound, class KernelAtEnd, class BoundAtEnd>
    void integrate(Scale& to, long level, Piece& piece, const Ball& w, const Kernel& kernel, const Bound& bound,
                   const KernelAtEnd& kernel_at_end, const BoundAtEnd& bound_at_end)
    {
        const double weight = upper_double(abs(w)), most = upper_double(M(piece.farthest()));
        const auto rules_by_size = [this](long n) -> const Gauss& { return gauss(n); };
        const auto take = [&](const Ball& y, const Ball& share) { enter(to, y, w * share); };
        const auto note = [&](double error) { add_error(level + 1, weight * error); };
        heavy_load::integrate(piece, shape, most, rules_by_size, take, note, kernel, bound, kernel_at_end, bound_at_end);
    }

    double negligible() const { return std::exp(-wanted - 12); } ///< weights that are not followed
    double finest_for(double tolerance) const { return std::min(0.01, tolerance) * last * std::exp(wanted); } ///< where panels end
    double tolerance_for(const Ball& w) const
    {
        return std::exp(-wanted) * std::max(1.0, 1 / (5000 * std::max(approximate(abs(w)), 1e-300)));
    }

    /// (F1): the weight w at x >= 1 goes to the next scale.
    void full(Scale& to, long level, const Ball& x, const Ball& w)
    {
        const double weight = upper_double(abs(w)), tolerance = tolerance_for(w);
        const double finest = finest_for(tolerance);
        const Ball lo = wave::lowest_full(x, G), hi = wave::highest_full(x, G);
        const auto [cuts, room_lo, room_hi] = cuts_between(lo, hi, S);
        const auto share = [&](const Ball& y) { // of the wave, below y
            const Ball t = at_least(at_most(G * y - x, Ball(1)), Ball(-1));
            return 1 - acos(t) / Traits::pi();
        };
        const Ball one_over_pi = 1 / Traits::pi();
        Ball done = cuts.front().lo; // up to here
        Ball share_done(0);
        for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
            const Ball &a = cuts[i].hi, &b = cuts[i + 1].lo;
            if (!is_below(a + Ball::exactly(4 * finest), b)) continue; // part of what is left out
            const bool is_first = i == 0 && room_lo > 0, is_last = i + 2 == cuts.size() && room_hi > 0;
            Piece piece{is_first ? lo : a,
                        is_last ? hi : b,
                        tolerance,
                        finest,
                        is_first ? room_lo : 0,
                        is_last ? std::min(room_hi, 1.0) : 0,
                        {},
                        {}};
            const double off_a = is_first ? 0 : distance(lo, a), off_b = is_last ? 0 : distance(b, hi);
            integrate(
                to, level, piece, w, [&](const Ball& y) { return one_over_pi * wave::kernel_full(Ball(hi - y), Ball(y - lo)); },
                [&](double from_a, double from_b, double) { return full_kernel_bound(from_a + off_a, from_b + off_b); },
                [&](bool left, const Ball& y) { return 2 * one_over_pi / sqrt(left ? hi - y : y - lo); },
                [&](bool left, double, double other) { return full_kernel_end_bound(other + (left ? off_b : off_a)); });
            const Ball share_from = is_first && arb_equal(piece.from.get(), lo.get()) ? Ball(0) : share(piece.from);
            if (!is_first || !arb_equal(piece.from.get(), lo.get()))
                leave(to, level, piece.from, piece.from - done, w, share_from - share_done, weight);
            done = piece.to;
            share_done = is_last && arb_equal(done.get(), hi.get()) ? Ball(1) : share(done);
        }
        if (arb_is_one(share_done.get())) return;
        leave(to, level, done, above(hi) - done, w, 1 - share_done, weight);
    }
    /// A stretch of the wave's ratios no rule covers, `width` long beside y, all taken at y.
    void leave(Scale& to, long level, const Ball& y, const Ball& width, const Ball& w, const Ball& measure, double weight)
    {
        moved[level + 1] += weight * upper_double(abs(measure)) * upper_double(Traits::sqrt_positive_part(width));
        enter(to, y, w * measure);
    }

    /// (F2): the weight w at x in (2/G, 1) goes to the next scale.
    void partial(Scale& to, long level, const Ball& x, const Ball& w)
    {
        const double weight = upper_double(abs(w)), tolerance = tolerance_for(w), g = approximate(G), root_x = approximate(sqrt(x));
        const double finest = finest_for(tolerance);
        const Ball hi = wave::highest_partial(x, G), gap = 1 - x;
        Piece piece{Ball(0), hi, tolerance, finest, 0, room_to_one(hi), {}, {}};
        integrate(
            to, level, piece, w,
            [&](const Ball& y) {
                const Ball Gy = G * y;
                return G * wave::kernel_partial_rest(x, gap, wave::radius(gap, Ball(Gy * Gy)), Gy) /
                       (2 * Traits::pi() * sqrt(x - Gy * Gy / 4));
            },
            [&](double from_a, double from_b, double largest) { return partial_kernel_bound(g, root_x, from_a, from_b, largest); },
            [&](bool, const Ball& y) {
                const Ball Gy = G * y;
                return G * wave::kernel_partial_rest(x, gap, wave::radius(gap, Ball(Gy * Gy)), Gy) /
                       (Traits::pi() * sqrt(G / 2 * (sqrt(x) + Gy / 2)));
            },
            // the ellipse reaches less than twice as far as the wave
            [&](bool, double, double from_a) { return partial_kernel_end_bound(g, root_x, from_a, 2 * approximate(hi)); });
        const double start = upper_double(piece.from);
        if (!is_dropped_below(g, approximate(x), start))
            throw std::logic_error("full contact: what is left out below a partial wave's panels is too wide");
        moved[level + 1] += weight * dropped_below(g, start);
        // room is above 0.009, and finest below 0.01 G^(-5/2)
        if (!arb_equal(piece.to.get(), hi.get())) throw std::logic_error("full contact: the end of a partial wave is not reached");
    }

    void spread_measure()
    {
        S = singular_points(load, G);
        Scale now{load, load, {}};
        std::vector<Node> above_one{{load, Ball(1)}}, between;
        for (long level = 0; !above_one.empty() || !between.empty(); ++level) {
            if (level > 60) throw std::logic_error("full contact: the chain does not end");
            Ball total(0);
            for (const Node& v : above_one) total += v.weight;
            in_full.push_back(total);
            between_nodes.push_back(between);
            const Ball lo = at_least((now.lo - 1) / G, Ball(0)), hi = at_least((now.hi + 1) / G, 2 / G);
            Scale next = scale(below(lo), above(hi));
            for (const bool is_full : {true, false})
                for (const Node& v : is_full ? above_one : between) {
                    const double weight = upper_double(abs(v.weight));
                    if (weight < negligible()) add_error(level, weight * upper_double(Q(upper(now.hi))));
                    else if (is_full) full(next, level, v.x, v.weight);
                    else partial(next, level, v.x, v.weight);
                }
            above_one.clear();
            between.clear();
            std::vector<Node> ends;
            for (std::size_t i = 0; i < next.grids.size(); ++i)
                for (Node& v : nodes_of(next.grids[i], level + 1)) {
                    if (i > 0) above_one.push_back(std::move(v));
                    else if (is_below(v.x, edge_of_chain())) ends.push_back(std::move(v));
                    else between.push_back(std::move(v));
                }
            terminal.push_back(std::move(ends));
            now.lo = next.lo;
            now.hi = next.hi;
        }
    }
    /// Nodes up to here are served by the discretisation: 2/G or, where a panel of (0, 1) goes across it, that panel's end.
    Ball edge_of_chain() const
    {
        const Graded g = graded(Ball(0), Ball(1), shape.ratio, last);
        Ball edge = g.middle;
        for (long k = 0; k < g.depth && is_below(edge, 2 / G); ++k) edge = g.hi - g.reach * g.power(-k - 1);
        return edge;
    }

    Ball area(long n)
    {
        const WorkingPrecision precision(bits);
        if (n == 0) return Ball(1);
        Ball sum(0);
        const auto at = static_cast<std::size_t>(n);
        if (at < in_full.size()) {
            sum += in_full[at];
            for (const Node& v : between_nodes[at]) sum += v.weight * (2 / Traits::pi()) * asin(sqrt(v.x));
        }
        while (rows.size() < std::min(at, terminal.size())) { // sqrt(x) F_m is G^m B_m
            std::vector<Discretisation::Point> points;
            const std::size_t j = rows.size();
            for (const Node& v : terminal[j]) {
                const double weight = upper_double(abs(v.weight));
                if (weight < negligible()) add_error(static_cast<long>(j) + 1, weight * upper_double(c));
                else points.push_back({v.x, v.weight * sqrt(v.x)});
            }
            rows.push_back(chain->functional(points));
        }
        for (std::size_t j = 1; j <= std::min(at, terminal.size()); ++j)
            sum += chain->apply(rows[j - 1], n - static_cast<long>(j)) * pow(G, Ball(static_cast<long>(j) - n));
        Ball error(0);
        for (const auto& [level, e] : errors)
            if (level <= n) error += Ball::exactly(e) * pow(G, Ball(level));
        error = error * pow(G, Ball(-n));
        for (const auto& [level, e] : moved)
            if (level <= n) error += Ball::exactly(e) * pow(G, Ball(level - n) / 2);
        arb_add_error(sum.get(), upper(error * Ball::exactly(margin)).get()); // summed up in binary64
        return sum;
    }
    const std::map<long, double>& errors_by_level() const { return errors; }
    const std::map<long, double>& moved_by_level() const { return moved; }
    std::string certificate(long n)
    {
        std::string text = fmt::format("full contact: {} points of S, panels shrink by {} to {:.2g}, ellipse rho = {}\n", S.size(),
                                       shape.ratio, last, shape.rho);
        for (std::size_t j = 1; j <= terminal.size(); ++j)
            text += fmt::format("  scale {}: {} nodes below 1; error <= {:.2g} G^-(n-{}) + {:.2g} G^-(n-{})/2\n", j, terminal[j - 1].size(),
                                errors[static_cast<long>(j)], j, moved[static_cast<long>(j)], j);
        return text + chain->certificate(n);
    }

private:
    long scales;
    double wanted, last; ///< accuracy in nats; width of the finest panels
    FixedFormat format;
    slong bits;
    Ball G, load, c;
    Shape shape;
    std::vector<Bracket> S;
    std::vector<Ball> in_full;                    ///< by level: the sum of weights above 1
    std::vector<std::vector<Node>> between_nodes; ///< by level: weights in (2/G, 1)
    std::vector<std::vector<Node>> terminal;      ///< by level, from 1: weights below
    std::vector<Discretisation::Functional> rows; ///< of the terminal weights
    std::map<long, double> errors, moved;         ///< by level: times G^-(n - level), times G^-(n - level)/2
    std::map<long, std::vector<Ball>> cosines;
    std::map<long, Gauss> rules;
    std::shared_ptr<Discretisation> chain;
};

} // namespace

heavy_load::Made heavy_load::made(Scheme scheme, long n, const Arguments& a, double accuracy, long scales)
{
    HeavyLoad f(scheme, a, accuracy, scales);
    const Ball area = f.area(n);
    return {area, f.errors_by_level(), f.moved_by_level()};
}

namespace {

/// The last few, most recently used first.
struct Kept {
    std::string key;
    std::mutex making;
    std::shared_ptr<HeavyLoad> made;
};
std::mutex kept_mutex;
std::list<std::shared_ptr<Kept>> kept;
constexpr std::size_t most_kept = 8;

template <class F>
auto with_heavy_load(Scheme scheme, long n, const Arguments& a, Accuracy wanted, F f)
{
    const double accuracy = nats_of(wanted);
    if (accuracy > 160) throw BeyondReach("so many digits would cost too much for load > 1");
    const long scales = scales_for(n);
    const WorkingPrecision precision(1024);
    const Arguments same{[load = a.load()] { return load; },
                         [G = a.G()] { return G; }}; // what is kept holds for all G and loads in these balls
    const std::string key = fmt::format("{} {} {} {} {}", static_cast<int>(scheme), accuracy, scales, same.load().dump(), same.G().dump());
    std::shared_ptr<Kept> mine;
    {
        const std::lock_guard lock(kept_mutex);
        const auto found = std::find_if(kept.begin(), kept.end(), [&](const auto& k) { return k->key == key; });
        if (found != kept.end()) kept.splice(kept.begin(), kept, found);
        else {
            kept.push_front(std::make_shared<Kept>());
            kept.front()->key = key;
            if (kept.size() > most_kept) kept.pop_back();
        }
        mine = kept.front();
    }
    const std::lock_guard lock(mine->making);
    if (!mine->made) mine->made = std::make_shared<HeavyLoad>(scheme, same, accuracy, scales);
    return f(*mine->made);
}

} // namespace

bool heavy_load_has_panels(long n, const Ball& G)
{
    const double g = approximate(G);
    return finest_panel(nats_wanted(nats_of({1}), g), g, scales_for(n)) >= narrowest_panel;
}

Ball area_at_heavy_load(Scheme scheme, long n, const Arguments& a, Accuracy wanted)
{
    return with_heavy_load(scheme, n, a, wanted, [n](HeavyLoad& f) { return f.area(n); });
}

std::string heavy_load_certificate(Scheme scheme, long n, const Arguments& a, Accuracy wanted)
{
    return with_heavy_load(scheme, n, a, wanted, [n](HeavyLoad& f) { return f.certificate(n); });
}

} // namespace touchstone::transfer
