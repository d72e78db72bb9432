// SPDX-License-Identifier: MIT
#include "touchstone/transfer/discretisation.hpp"

#include "touchstone/scalar/binary64.hpp"
#include "touchstone/scalar/refusal.hpp"
#include "touchstone/transfer/moments.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <optional>

namespace touchstone::transfer {
namespace {

using Traits = ScalarTraits<Ball>;
constexpr long longest_chain = 10'000;
constexpr std::size_t steps_kept = 16;

double approximate(const Ball& b) { return arf_get_d(arb_midref(b.get()), ARF_RND_NEAR); }
double upper_double(const Ball& b)
{
    const Ball u = upper(b);
    return arf_get_d(arb_midref(u.get()), ARF_RND_UP);
}
/// e with |b| < 2^e, about
slong exponent(const Ball& b) { return arf_abs_bound_lt_2exp_si(arb_midref(b.get())); }
/// An upper bound of the radius, as an exact ball.
Ball radius(const Ball& b)
{
    Ball r;
    arf_set_mag(arb_midref(r.get()), arb_radref(b.get()));
    return r;
}
Ball larger(const Ball& a, const Ball& b) { return certainly(less(a, b)) ? b : a; }

} // namespace

FixedFormat Discretisation::format_for(double accuracy)
{
    return FixedFormat(static_cast<long>(accuracy / std::numbers::ln2 + 40 + 3 * std::log2(std::max(accuracy / 136, 1.0))));
}
/// Moments are off by units of the format, whatever the load, and F is about x^(1/2): at x = e^-deepest half of deepest is needed on top of
/// what F is wanted to relative to 1. A quarter is in the accuracy already, since what earlier levels are off by weighs x^(1/4) in a row.
double Discretisation::accuracy_of_entries(double accuracy, double deepest) { return accuracy + deepest / 4; }

slong Discretisation::bits_for(double accuracy, double deepest)
{
    return format_for(accuracy_of_entries(accuracy, deepest)).fraction() + 24;
}

double Discretisation::rule_end(Scheme scheme, const Ball& G, double accuracy)
{
    return cut_off({2 / G, false}, accuracy) * (scheme == Scheme::area ? 1.04 : 1);
}

/// From -log x = log(G/2), a little below, to s_last.
std::vector<Discretisation::Block> Discretisation::grid(Scheme scheme, const Ball& G, double accuracy, double grid_accuracy, double V,
                                                        double deepest)
{
    const double s0 = approximate(log(G / 2));
    // -log y <= log(G/2) + s/2 + V, about: from s = deepest, and from the last node
    const double s_last = std::max((scheme == Scheme::area ? 1.1 : 1) * std::max(2 * V, accuracy + 4), deepest / 2 + V) + 2 * s0 + 2;
    const double s_first = s0 * (1 - std::ldexp(1.0, -40));
    const auto points_for = [&](double rho) {
        return 1 + static_cast<long>(std::ceil((grid_accuracy + 2 - std::log(rho - 1)) / std::log(rho)));
    };
    std::vector<Block> all;
    const auto add = [&](double lo, double hi, double half, double rho, long p) {
        all.push_back({(lo + hi) / 2, half, rho, p, all.size() * static_cast<std::size_t>(p)});
    };
    if (scheme == Scheme::area) {
        const double blocks = std::ceil(std::log(s_last / s_first) / std::log(4.0));
        const double ratio = std::pow(s_last / s_first, 1 / blocks), root = std::sqrt(ratio);
        const double rho = (root + 1) / (root - 1) * (1 - 1e-9); // the ellipse about [s, ratio s] that reaches 0
        double lo = s_first;
        for (double k = 0; k < blocks; ++k) {
            const double hi = k + 1 == blocks ? s_last : lo * ratio;
            add(lo, hi, (hi - lo) / 2, rho, points_for(rho));
            lo = hi;
        }
        return all;
    }
    // A value of the interpolant costs its block's points, and finding where it is as much as this many of them.
    constexpr double two_logarithms = 200;
    const double t0 = std::log(s_first), t1 = std::log(s_last);
    double least = HUGE_VAL;
    for (double blocks = 1; blocks <= 8; ++blocks) {
        const double width = (t1 - t0) / blocks, half = width / 2 * (1 + 1e-12);
        const double b = std::numbers::pi / 2 / half; // semi-minor axis: |Im t| < pi/2 keeps Re s > 0
        const double rho = (b + std::sqrt(1 + b * b)) * (1 - 1e-12);
        const long p = points_for(rho);
        const double nodes = blocks * static_cast<double>(p), cost = nodes * (static_cast<double>(p) + two_logarithms);
        if (blocks > 1 && (cost >= least || nodes > static_cast<double>(most_nodes))) break;
        least = cost;
        all.clear();
        for (double k = 0; k < blocks; ++k) add(t0 + k * width, t0 + (k + 1) * width, half, rho, p);
    }
    return all;
}

bool Discretisation::ellipse_is_inside(Scheme scheme, double mid, double half, double rho)
{
    const Ball length = Ball::exactly(half), sum = Ball::exactly(rho);
    return scheme == Scheme::force_weighted ? certainly(less(length * (sum - 1 / sum), Traits::pi()))
                                            : certainly(less(length * (sum + 1 / sum), 2 * Ball::exactly(mid)));
}

Discretisation::Abscissa Discretisation::abscissa(const Ball& tau)
{
    Abscissa a{tau, radius(tau)};
    if (!(std::fabs(approximate(tau)) < 1 - 0x1p-20)) { // what it is moved by to be inside counts as error
        a.tau = at_least(at_most(tau, Ball(1)), Ball(-1));
        a.moved = upper(abs(a.tau - tau));
    }
    arb_get_mid_arb(a.tau.get(), a.tau.get());
    if (!certainly(less(a.moved, Traits::power_of_two(-30)))) throw BeyondReach("the load is below the reach of the grid");
    return a;
}

/// c_m increases to its limit, from m = 128 on by less than 2^-60 of itself (wave::size_limit). 2^-20 is more than that.
std::vector<Ball> Discretisation::magnitude_bounds(const Ball& G)
{
    const WorkingPrecision coarse(96);
    std::vector<Ball> c = magnitudes(G, 128);
    for (Ball& b : c) b = upper(b * (1 + Traits::power_of_two(-20)));
    return c;
}

std::size_t Discretisation::size_for(Scheme scheme, const Ball& G, double accuracy, double deepest)
{
    const std::vector<Block> blocks = grid(scheme, G, accuracy, accuracy, rule_end(scheme, G, accuracy), deepest);
    return blocks.back().first + static_cast<std::size_t>(blocks.back().points);
}

Discretisation::Discretisation(Scheme scheme, const std::function<Ball()>& G_at, double accuracy, double grid_accuracy, double deepest)
    : scheme_(scheme), accuracy_(accuracy),
      format_(format_for(accuracy_of_entries(accuracy, deepest))), bits_(bits_for(accuracy, deepest))
{
    require_binary64_arithmetic();
    const WorkingPrecision precision(bits_);
    G_ = G_at();
    if (!certainly(less(Ball(2), G_))) throw BeyondReach("G = gamma^(D-1) must be above 2");
    if (!certainly(less(G_, Ball(1'000'000'000)))) throw BeyondReach("G = gamma^(D-1) must be below 10^9");
    log_half_G_ = log(G_ / 2);
    const Ratios all{2 / G_, false};

    c_ = magnitude_bounds(G_);
    scale_ = Ball(1);
    while (!certainly(less(c_.back(), scale_))) scale_ = scale_ * 2;
    error_unit_ = static_cast<long>(accuracy / std::numbers::ln2);

    const double V = rule_end(scheme, G_, accuracy);
    blocks_ = grid(scheme, G_, accuracy, grid_accuracy, V, deepest);
    const std::size_t N = blocks_.back().first + static_cast<std::size_t>(blocks_.back().points);
    if (N > most_nodes) throw BeyondReach("so many digits this near G = 2 would need more than 4000 nodes");
    for (const Block& b : blocks_) { // what the bounds assume of a block
        const WorkingPrecision coarse(96);
        if (!ellipse_is_inside(scheme, b.mid, b.half, b.rho))
            throw std::logic_error("transfer: an ellipse of interpolation leaves Re s > 0");
    }

    for (const Block& b : blocks_)
        for (long i = 0; i < b.points; ++i) {
            const Ball tau = Traits::cos_pi(Ball(2 * i + 1) / Ball(2 * b.points));
            Ball s = Ball::exactly(b.mid) + Ball::exactly(b.half) * tau;
            if (scheme == Scheme::force_weighted) s = exp(s);
            nodes_.push_back({exp(-s), s});
            // the blocks begin a little below log(G/2), the nodes must not: the rule is proven for ratios below 2/G
            if (!rule_serves(nodes_.back().x)) throw std::logic_error("transfer: a node's ratio is not below 2/G");
        }

    rule_ = scheme == Scheme::force_weighted ? double_exponential_rule(G_, all, accuracy, V) : gauss_panel_rule(G_, all, accuracy, V);

    to_coefficients_ = Coefficients(format_, blocks_.front().points);
    const auto limbs = static_cast<std::size_t>(format_.limbs());
    matrix_.reserve(N * N * limbs);
    const Resolution resolved = resolution();
    std::vector<double> near(N), step_error;
    for (const Node& n : nodes_) {
        const Row r = row(n.x, n.s, rule_);
        const double off = nodal(r.moments.data(), near);
        carried_.add_row(near, off);
        matrix_.insert(matrix_.end(), r.moments.begin(), r.moments.end());
        const Budget b = resolved.budget(r.sums, rule_, n.x);
        step_error.push_back(upper_double(c_.back() * b.total() * Traits::power_of_two(error_unit_)));
        worst_.rule = larger(worst_.rule, b.rule);
        worst_.truncation = larger(worst_.truncation, b.truncation);
        worst_.interpolation = larger(worst_.interpolation, b.interpolation);
        worst_.abscissae = larger(worst_.abscissae, b.abscissae);
        worst_.weights = larger(worst_.weights, b.weights);
        worst_.entries = larger(worst_.entries, b.entries);
    }
    carried_.begin(std::move(step_error));
}

Resolution Discretisation::resolution() const
{
    return {blocks_.front().points, blocks_.front().rho, nodes_.size(), format_.unit(), scale_};
}

const Ball& Discretisation::magnitude(long m) const { return c_.at(std::min(static_cast<std::size_t>(m), c_.size() - 1)); }

/// Whether the rule for all ratios below 2/G is proven for this one.
bool Discretisation::rule_serves(const Ball& x) const { return certainly(less(x, 2 / G_)); }

/// The weights and abscissae of the step (R1) at ratio x = e^-s, and its moments sum_q W_q T_k(tau_q). A node of small weight needs fewer
/// bits.
Discretisation::Row Discretisation::row(const Ball& x, const Ball& s, const Rule& rule) const
{
    const auto limbs = static_cast<std::size_t>(format_.limbs());
    Row r;
    r.moments.assign(nodes_.size() * limbs, 0);
    r.sums.tau_error = r.sums.weight_error = r.sums.total = Ball(0);
    const Ball gap = 1 - x;
    const Ball half_G = G_ / 2, root_of_x = sqrt(x), outer = half_G * root_of_x, inner = root_of_x / half_G;
    const Ball root_outer = sqrt(outer), half_inner = half_G * sqrt(inner), before_log = log_half_G_ + s / 2;
    std::vector<std::vector<std::size_t>> spare;
    for (const Block& b : blocks_) spare.push_back(words_to_spare(b.rho, b.points));
    Moments moments(format_);
    for (const Rule::Node& q : rule.nodes) {
        // of the weight, or more
        const Ball size = scheme_ == Scheme::force_weighted ? q.force_weight * root_outer : q.area_weight * half_inner;
        const WorkingPrecision needed(std::clamp(bits_ + exponent(size) + 16, slong{96}, bits_));
        const Ball root = sqrt(1 + gap * q.sinh_squared);
        Ball s_y, weight;
        if (scheme_ == Scheme::force_weighted) { // g of (R1), with x/y = (G/2) x^(1/2) cosh^2 v / root
            s_y = before_log + 2 * q.log_cosh - log(root);
            arb_rsqrt(weight.get(), root.get(), needed.bits());
            weight *= q.force_weight * root_outer;
        }
        else { // (C2) with B = G^-m y^(1/2) F and du = sech^2 v dv
            const Ball y = inner * root * q.sech_squared;
            s_y = -log(y);
            weight = q.area_weight * half_G * sqrt(y) / root;
        }
        const Ball variable = scheme_ == Scheme::force_weighted ? log(s_y) : s_y;
        const double near = approximate(variable);
        const auto at = std::find_if(blocks_.begin(), std::prev(blocks_.end()), [&](const Block& b) { return near <= b.mid + b.half; });
        const Block& block = *at; // the last if beyond it: refused below
        const Abscissa t = abscissa((variable - Ball::exactly(block.mid)) / Ball::exactly(block.half));
        const Ball most = upper(weight); // weights are positive
        r.sums.tau_error = upper(r.sums.tau_error + most * t.moved);
        r.sums.weight_error = larger(r.sums.weight_error, upper(radius(weight)));
        r.sums.total = upper(r.sums.total + most);
        ++r.sums.terms;
        moments.add(weight, t.tau, spare[static_cast<std::size_t>(std::distance(blocks_.begin(), at))], &r.moments[block.first * limbs]);
    }
    return r;
}

/// A row of moments as one of nodal values. \returns what those are off by beyond a relative 2^-52
double Discretisation::nodal(const mp_limb_t* moments, std::vector<double>& near) const
{
    double off = 0;
    for (const Block& b : blocks_)
        off = std::max(off, to_coefficients_.row(moments + b.first * static_cast<std::size_t>(format_.limbs()), &near[b.first]));
    return off;
}

void Discretisation::extend_to(long n)
{
    const WorkingPrecision precision(bits_);
    const std::size_t N = nodes_.size();
    const auto limbs = static_cast<std::size_t>(format_.limbs());
    if (n >= longest_chain) throw BeyondReach("n must be at most 10000");
    while (static_cast<long>(levels_.size()) <= n) {
        std::vector<mp_limb_t> values(N * limbs);
        for (std::size_t i = 0; i < N; ++i)
            if (levels_.empty()) { // F_0 = (2/pi) arcsin(sqrt x)/sqrt x
                const Ball root = sqrt(nodes_[i].x);
                const Ball F = 2 * asin(root) / (Traits::pi() * root) / scale_;
                format_.put(&values[i * limbs], F);
                if (!certainly(less(radius(F), format_.unit()))) throw std::logic_error("transfer: F_0 is not accurate to a unit");
            }
            else format_.put(&values[i * limbs], format_.dot(&matrix_[i * N * limbs], levels_.back().data(), N));
        const std::vector<double>& errors = carried_.at(levels_.size());
        const double most = std::ldexp(1.0, static_cast<int>(error_unit_));
        // roundings are counted for values of at most 2 c_m
        if (!std::all_of(errors.begin(), errors.end(), [&](double e) { return e < most; }))
            throw ErrorsHaveOutgrown("errors have outgrown the values over so many scales");
        std::vector<mp_limb_t> coefficients(values.size());
        for (const Block& b : blocks_) to_coefficients_.of(&values[b.first * limbs], &coefficients[b.first * limbs]);
        levels_.push_back(std::move(coefficients));
    }
}

Ratios Discretisation::ratios_of(const std::vector<Point>& points)
{
    if (points.size() == 1) return {points.front().x, true};
    Ball highest(0);
    for (const Point& point : points) highest = larger(highest, upper(point.x));
    return {highest, false};
}

/// The rows of all points, moments added up.
Discretisation::Functional Discretisation::functional(const std::vector<Point>& points)
{
    const WorkingPrecision precision(bits_);
    const auto limbs = static_cast<std::size_t>(format_.limbs());
    const std::size_t N = nodes_.size();
    const Resolution resolved = resolution();
    std::vector<mp_limb_t> moments(N * limbs), weight(limbs), product(limbs), scratch(2 * limbs);
    Functional f;
    f.first = f.budget = Ball(0);
    std::optional<Rule> beyond; // for ratios above 2/G
    for (const Point& point : points) {
        const Ball& x = point.x;
        const auto add = [&](const Rule& rule) {
            const Row r = row(x, -log(x), rule);
            format_.put(weight.data(), point.weight);
            for (std::size_t k = 0; k < N; ++k) {
                format_.multiply(product.data(), &r.moments[k * limbs], weight.data(), 0, scratch.data());
                mpn_add_n(&moments[k * limbs], &moments[k * limbs], product.data(), static_cast<mp_size_t>(limbs));
            }
            const Ball own = abs(point.weight) * resolved.budget(r.sums, rule, x).total();
            f.budget = upper(f.budget + own + resolved.weighting(r.sums, radius(point.weight)));
        };
        if (rule_serves(x)) add(rule_);
        else {
            if (!beyond) {
                const Ratios ratios = ratios_of(points);
                const double V = cut_off(ratios, accuracy_);
                beyond = scheme_ == Scheme::force_weighted ? double_exponential_rule(G_, ratios, accuracy_, V)
                                                           : gauss_panel_rule(G_, ratios, accuracy_, V);
            }
            add(*beyond);
        }
        f.first += point.weight * 2 * asin(sqrt(x)) / (Traits::pi() * sqrt(x));
    }
    std::vector<double> near(N);
    const double off = nodal(moments.data(), near);
    f.modulus = moduli(near, off);
    f.moments = std::move(moments);
    return f;
}

/// The row of one load; those of the last few loads are kept.
const Discretisation::Functional& Discretisation::step_to(const Ball& x)
{
    const std::string key = x.dump();
    const auto known = std::find_if(steps_.begin(), steps_.end(), [&](const Step& s) { return s.load == key; });
    if (known != steps_.end()) steps_.splice(steps_.begin(), steps_, known);
    else {
        steps_.push_front({key, functional({{x, Ball(1)}})});
        if (steps_.size() > steps_kept) steps_.pop_back();
    }
    return steps_.front().row;
}

Ball Discretisation::force_share(long n, const Ball& x)
{
    const WorkingPrecision precision(bits_);
    if (n == 0) return 2 * asin(sqrt(x)) / (Traits::pi() * sqrt(x));
    const std::lock_guard lock(mutex_);
    extend_to(n - 1);
    return value(step_to(x), n);
}

Ball Discretisation::apply(const Functional& f, long n)
{
    if (n == 0) return f.first;
    const WorkingPrecision precision(bits_);
    const std::lock_guard lock(mutex_);
    extend_to(n - 1);
    return value(f, n);
}

/// Level n - 1 to level n. \pre n >= 1, levels up to n - 1 are there
Ball Discretisation::value(const Functional& f, long n)
{
    const auto level = static_cast<std::size_t>(n - 1);
    Ball F = scale_ * format_.dot(f.moments.data(), levels_.at(level).data(), nodes_.size());
    const double carried = carried_.into(f.modulus, level);
    const WorkingPrecision coarse(64);
    const Ball error = magnitude(n - 1) * f.budget + Ball::exactly(carried) * Traits::power_of_two(-error_unit_);
    arb_add_error(F.get(), upper(error).get());
    return F;
}

std::size_t Discretisation::memory() const
{
    return carried_.memory() + 8 * (matrix_.size() + (levels_.empty() ? 0 : levels_.size() * levels_[0].size()));
}

std::string Discretisation::certificate(long n)
{
    const std::lock_guard lock(mutex_);
    const long levels = std::max(n, 1L);
    extend_to(levels - 1);
    const auto show = [](const Ball& b) { return Ball(b).to_string(3); };
    std::string text = fmt::format("{}: {} nodes in {} block(s) of {}, ellipse rho = {:.4g}; {}\n",
                                   scheme_ == Scheme::force_weighted ? "force-weighted" : "area", nodes_.size(), blocks_.size(),
                                   blocks_[0].points, blocks_[0].rho, rule_.text);
    text += fmt::format(
        "  one step adds at most, relative to |F_m| <= c_m: rule {}, cut-off {}, interpolation {}, abscissae {}, weights {}, entries {}\n",
        show(worst_.rule), show(worst_.truncation), show(worst_.interpolation), show(worst_.abscissae), show(worst_.weights),
        show(worst_.entries));
    for (long m = 0; m < levels; ++m) {
        const std::vector<double>& e = carried_.at(static_cast<std::size_t>(m));
        text += fmt::format("  level {}: |F_{}| <= {}, error <= {} at every node\n", m, m, show(magnitude(m)),
                            show(Ball::exactly(*std::max_element(e.begin(), e.end())) * Traits::power_of_two(-error_unit_)));
    }
    return text;
}

} // namespace touchstone::transfer
