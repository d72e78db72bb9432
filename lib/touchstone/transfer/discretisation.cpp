// SPDX-License-Identifier: MIT
#include "touchstone/transfer/discretisation.hpp"

#include "touchstone/scalar/binary64.hpp"
#include "touchstone/scalar/refusal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <optional>

namespace touchstone::transfer {
namespace {

using Traits = ScalarTraits<Ball>;
constexpr long longest_chain = 10'000; // levels for which c_m is provided for; c_m increases to its limit
constexpr std::size_t steps_kept = 16;
constexpr std::size_t most_powers = 7;  // |B|, |B^2|, ... |B^64|
constexpr double up = 1 + 1e-9;        // covers the roundings of any of the double sums below, of < 10^6 terms

double approximate(const Ball& b) { return arf_get_d(arb_midref(b.get()), ARF_RND_NEAR); }
double upper_double(const Ball& b)
{
    const Ball u = upper(b);
    return arf_get_d(arb_midref(u.get()), ARF_RND_UP);
}
/// An upper bound of the radius, as an exact ball.
Ball radius(const Ball& b)
{
    Ball r;
    arf_set_mag(arb_midref(r.get()), arb_radref(b.get()));
    return r;
}
Ball larger(const Ball& a, const Ball& b) { return certainly(less(a, b)) ? b : a; }

} // namespace

FixedFormat Discretisation::format_for(double accuracy) { return FixedFormat(static_cast<long>(accuracy / std::numbers::ln2 + 40 + 3 * std::log2(std::max(accuracy / 136, 1.0)))); }
/// Moments are off by units of the format, whatever the load, and F is about x^(1/2): at x = e^-deepest half of deepest is needed on top of
/// what F is wanted to relative to 1. A quarter is in the accuracy already, since what earlier levels are off by weighs x^(1/4) in a row.
double Discretisation::accuracy_of_entries(double accuracy, double deepest) { return accuracy + deepest / 4; }

slong Discretisation::bits_for(double accuracy, double deepest) { return format_for(accuracy_of_entries(accuracy, deepest)).fraction() + 24; }

double Discretisation::rule_end(Scheme scheme, const Ball& G, double accuracy)
{
    return cut_off({2 / G, false}, accuracy) * (scheme == Scheme::area ? 1.04 : 1);
}

/// From -log x = log(G/2), a little below, to s_last.
std::vector<Discretisation::Block> Discretisation::grid(Scheme scheme, const Ball& G, double accuracy, double grid_accuracy, double V, double deepest)
{
    const double s0 = approximate(log(G / 2));
    // -log y <= log(G/2) + s/2 + V, about: from s = deepest, and from the last node
    const double s_last = std::max((scheme == Scheme::area ? 1.1 : 1) * std::max(2 * V, accuracy + 4), deepest / 2 + V) + 2 * s0 + 2;
    const double s_first = s0 * (1 - std::ldexp(1.0, -40));
    const auto points_for = [&](double rho) { return 1 + static_cast<long>(std::ceil((grid_accuracy + 2 - std::log(rho - 1)) / std::log(rho))); };
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

    {
        // c_m increases to its limit within 64 levels up to a relative 2^-60; later ones are bounded by that
        const WorkingPrecision coarse(96);
        c_ = magnitudes(G_, 128);
        for (Ball& c : c_) c = upper(c * (1 + Traits::power_of_two(-60)));
        scale_ = Ball(1);
        while (!certainly(less(c_.back(), scale_))) scale_ = scale_ * 2;
    }
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
            if (!certainly(less(nodes_.back().x, 2 / G_))) throw std::logic_error("transfer: a node's ratio is not below 2/G");
        }

    rule_ = scheme == Scheme::force_weighted ? double_exponential_rule(G_, all, accuracy, V) : gauss_panel_rule(G_, all, accuracy, V);

    to_coefficients_ = Coefficients(format_, blocks_.front().points);
    const auto limbs = static_cast<std::size_t>(format_.limbs());
    matrix_.reserve(N * N * limbs);
    near_power_.resize(N * N);
    majorant_.resize(N * N);
    near_error_ = std::ldexp(1.0, -50);
    std::vector<Row> rows;
    for (const Node& n : nodes_) {
        Row r = row(n.x, n.s, rule_);
        double *const near = &near_power_[rows.size() * N], *const majorant = &majorant_[rows.size() * N];
        const double off = nodal(r.moments.data(), near) / near_error_; // so that near_error_ covers it, too
        for (std::size_t j = 0; j < N; ++j) majorant[j] = std::fabs(near[j]) * up + off;
        matrix_.insert(matrix_.end(), r.moments.begin(), r.moments.end());
        r.moments = {};
        rows.push_back(std::move(r));
    }
    powers_.push_back(majorant_);
    const Ball c_limit = c_.back();
    const Ball rounding = scale_ * format_.unit();
    for (std::size_t i = 0; i < N; ++i) {
        const Budget b = budget(rows[i], nodes_[i].x, rule_);
        step_error_.push_back(to_error_units(c_limit * b.total() + 2 * rounding));
        worst_.rule = larger(worst_.rule, b.rule);
        worst_.truncation = larger(worst_.truncation, b.truncation);
        worst_.interpolation = larger(worst_.interpolation, b.interpolation);
        worst_.abscissae = larger(worst_.abscissae, b.abscissae);
        worst_.weights = larger(worst_.weights, b.weights);
        worst_.entries = larger(worst_.entries, b.entries);
    }
}

double Discretisation::to_error_units(const Ball& error) const
{
    const double d = upper_double(error * Traits::power_of_two(error_unit_));
    return (d + 1e-300) * up;
}

namespace {

/// How many of its lowest words a moment of order k can do without: coefficients of order k are below a multiple of rho^-k, so 2^(64 words) <= rho^k.
std::vector<std::size_t> words_to_spare(double rho, long points)
{
    std::vector<std::size_t> spare;
    const double bits = std::log2(rho) * (1 - 1e-12);
    for (long k = 0; k < points; ++k) spare.push_back(static_cast<std::size_t>(static_cast<double>(k) * bits / 64));
    return spare;
}

/// The sums of W T_k(tau), a node at a time, each term with the words that it needs.
class Moments {
public:
    explicit Moments(const FixedFormat& format) : format_(format), limbs_(static_cast<std::size_t>(format.limbs())), tau_(limbs_), a_(limbs_), b_(limbs_), c_(limbs_), scratch_(2 * limbs_)
    {
        for (int m = 0; m <= format.limbs(); ++m) formats_.emplace_back(64L * m - FixedFormat::headroom);
    }

    /// U_0 = W, U_1 = tau W, U_{k+1} = 2 tau U_k - U_{k-1}, added to sum[k limbs]. In units of the lowest word kept a step is off by less than 2 (the product, and tau's words below), the words let go by 2.
    void add(const Ball& weight, const Ball& tau, const std::vector<std::size_t>& spare, mp_limb_t* sum)
    {
        format_.put(tau_.data(), tau);
        format_.put(a_.data(), weight);
        std::size_t words = significant(a_.data()), gone = 0; // of U, above `gone`
        mp_limb_t *before = a_.data(), *now = b_.data(), *next = c_.data();
        multiply(now, before, words, 0);
        add_at(sum, before, words, 0);
        if (spare.size() > 1) add_at(sum + limbs_, now, words, 0);
        for (std::size_t k = 2; k < spare.size(); ++k) {
            if (const std::size_t drop = spare[k] - gone; drop > 0) {
                if (drop >= words) return; // the rest is less than a unit
                words -= drop;
                gone = spare[k];
                for (mp_limb_t* u : {before, now}) std::copy(u + drop, u + drop + words, u);
            }
            multiply(next, now, words, 1);
            mpn_sub_n(next, next, before, static_cast<mp_size_t>(words));
            add_at(sum + k * limbs_, next, words, gone);
            mp_limb_t* const free = before;
            before = now, now = next, next = free;
        }
    }

private:
    /// Words that hold it with 18 bits to spare.
    std::size_t significant(const mp_limb_t* w) const
    {
        const mp_limb_t sign = w[limbs_ - 1] >> 63 ? ~mp_limb_t{0} : 0;
        std::size_t top = limbs_;
        while (top > 1 && w[top - 1] == sign) --top;
        const mp_limb_t rest = w[top - 1] ^ sign;
        return std::min(limbs_, top + (rest >> (64 - 18) ? 1 : 0));
    }
    void multiply(mp_limb_t* out, const mp_limb_t* u, std::size_t words, unsigned shift)
    {
        formats_[words].multiply(out, u, tau_.data() + (limbs_ - words), shift, scratch_.data());
    }
    void add_at(mp_limb_t* sum, const mp_limb_t* u, std::size_t words, std::size_t gone) const
    {
        const bool negative = u[words - 1] >> 63;
        const mp_limb_t carry = mpn_add_n(sum + gone, sum + gone, u, static_cast<mp_size_t>(words));
        const std::size_t above = gone + words;
        if (above == limbs_ || negative == (carry != 0)) return;
        if (negative) mpn_sub_1(sum + above, sum + above, static_cast<mp_size_t>(limbs_ - above), 1);
        else mpn_add_1(sum + above, sum + above, static_cast<mp_size_t>(limbs_ - above), 1);
    }

    const FixedFormat& format_;
    std::size_t limbs_;
    std::vector<FixedFormat> formats_; ///< of so many words
    std::vector<mp_limb_t> tau_, a_, b_, c_, scratch_;
};

/// e with |b| < 2^e
slong exponent(const Ball& b)
{
    return arf_is_zero(arb_midref(b.get())) ? -ARF_PREC_EXACT / 2 : arf_abs_bound_lt_2exp_si(arb_midref(b.get()));
}

} // namespace

/// The weights and abscissae of the step (R1) at ratio x = e^-s, and its moments sum_q W_q T_k(tau_q). A node of small weight needs fewer bits.
Discretisation::Row Discretisation::row(const Ball& x, const Ball& s, const Rule& rule) const
{
    const auto limbs = static_cast<std::size_t>(format_.limbs());
    Row r;
    r.moments.assign(nodes_.size() * limbs, 0);
    r.tau_error = r.weight_error = r.total = Ball(0);
    const Ball gap = 1 - x;
    const Ball half_G = G_ / 2, root_of_x = sqrt(x), outer = half_G * root_of_x, inner = root_of_x / half_G;
    const Ball root_outer = sqrt(outer), half_inner = half_G * sqrt(inner), before_log = log_half_G_ + s / 2;
    std::vector<std::vector<std::size_t>> spare;
    for (const Block& b : blocks_) spare.push_back(words_to_spare(b.rho, b.points));
    Moments moments(format_);
    for (const Rule::Node& q : rule.nodes) {
        const slong size = scheme_ == Scheme::force_weighted ? exponent(q.force_weight) + exponent(root_outer) : exponent(q.area_weight) + exponent(half_inner);
        const WorkingPrecision needed(std::clamp(bits_ + size + 16, slong{96}, bits_));
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
        Ball t = (variable - Ball::exactly(block.mid)) / Ball::exactly(block.half);
        Ball moved = radius(t);
        if (!(std::fabs(approximate(t)) < 1 - 0x1p-20)) { // tau is taken inside [-1, 1]; what that moves it by counts as error
            const Ball inside = at_least(at_most(t, Ball(1)), Ball(-1));
            moved = upper(abs(inside - t));
            t = inside;
        }
        if (!certainly(less(moved, Traits::power_of_two(-30))))
            throw BeyondReach("the load is below the reach of the grid");
        const Ball most = upper(weight); // weights are positive
        r.tau_error = upper(r.tau_error + most * moved);
        r.weight_error = larger(r.weight_error, upper(radius(weight)));
        r.total = upper(r.total + most);
        ++r.terms;
        moments.add(weight, t, spare[static_cast<std::size_t>(std::distance(blocks_.begin(), at))], &r.moments[block.first * limbs]);
    }
    return r;
}

/// A row of moments as one of nodal values. \returns what those are off by beyond a relative 2^-52
double Discretisation::nodal(const mp_limb_t* moments, double* near) const
{
    double off = 0;
    for (const Block& b : blocks_)
        off = std::max(off, to_coefficients_.row(moments + b.first * static_cast<std::size_t>(format_.limbs()), near + b.first));
    return off;
}

/// Coefficients of the interpolant of what is at most 1 on the ellipses are below this times rho^-k, aliases and all.
Ball Discretisation::coefficient_bound() const
{
    const Ball rho = Ball::exactly(blocks_.front().rho);
    return upper(2 + 4 / (rho * rho - 1));
}

Budget Discretisation::budget(const Row& r, const Ball& x, const Rule& rule) const
{
    const WorkingPrecision coarse(64);
    const long p = blocks_.front().points;
    const Ball rho = Ball::exactly(blocks_.front().rho), u = format_.unit();
    const Ball total = upper(r.total + r.terms * (r.weight_error + u)); // of the weights as rounded
    Budget b;
    const Ball fourth_root = sqrt(sqrt(x));
    b.rule = upper(rule.discretisation * fourth_root);
    b.truncation = upper(rule.truncation * fourth_root);
    b.interpolation = upper(total * 4 * pow(rho, Ball(1 - p)) / (rho - 1));
    b.abscissae = upper((r.tau_error + total * u) / ((rho + 1 / rho) / 2 - 1 - Traits::power_of_two(-29)));
    b.weights = upper(r.terms * (r.weight_error + u));
    // A moment of order k is off by 4 u rho^k p^2 a term (Moments) and meets a coefficient of at most c_m coefficient_bound() rho^-k.
    // The computed coefficients are off by `rounding`, and a row's moments add up to p total and what those are off by.
    const Ball moment = r.terms * 4 * u * p * p, rounding = (4 * p + 1 + scale_) * u;
    const Ball moments = p * total + static_cast<long>(nodes_.size()) * moment * pow(rho, Ball(p));
    b.entries = upper(p * moment * coefficient_bound() + moments * rounding);
    return b;
}

/// From |B^p| to |B^2p|. near_power_ = B^p + D with |D| <= near_error_ majorant_, majorant_ = |B|^p:
/// the product of two such is off by (2 near_error_ + near_error_^2) majorant_^2 and its own rounding.
void Discretisation::square_power()
{
    const std::size_t N = nodes_.size();
    std::vector<double> near(N * N), majorant(N * N);
    for (std::size_t i = 0; i < N; ++i)
        for (std::size_t k = 0; k < N; ++k) {
            const double a = near_power_[i * N + k], b = majorant_[i * N + k];
            for (std::size_t j = 0; j < N; ++j) near[i * N + j] += a * near_power_[k * N + j];
            for (std::size_t j = 0; j < N; ++j) majorant[i * N + j] += b * majorant_[k * N + j];
        }
    near_error_ = 2.1 * near_error_ + static_cast<double>(N + 4) * std::ldexp(1.0, -52);
    std::vector<double> modulus(N * N);
    for (std::size_t k = 0; k < N * N; ++k) {
        majorant[k] *= up;
        modulus[k] = (std::fabs(near[k]) + near_error_ * majorant[k]) * up;
    }
    near_power_ = std::move(near);
    majorant_ = std::move(majorant);
    powers_.push_back(std::move(modulus));
}

/// W(level + 1)
std::vector<double> Discretisation::errors_of(std::size_t level)
{
    const std::size_t terms = level + 1, N = nodes_.size();
    if (terms == 1) return step_error_;
    // a further power is worth its cost once the bounds have grown by three digits, four, ...
    const double growth = *std::max_element(levels_.back().errors.begin(), levels_.back().errors.end())
                        / *std::max_element(step_error_.begin(), step_error_.end());
    if (powers_.size() < most_powers && growth > std::pow(10.0, static_cast<double>(powers_.size() + 2)) && terms >= (std::size_t{2} << powers_.size()))
        square_power();
    std::size_t r = powers_.size() - 1;
    while ((std::size_t{1} << r) > terms / 2) --r;
    const std::size_t p = std::size_t{1} << r;
    const std::vector<double>& rest = levels_[terms - p - 1].errors; // W(terms - p)
    const std::vector<double>& sum = levels_[p - 1].errors;          // W(p)
    std::vector<double> e(N);
    for (std::size_t i = 0; i < N; ++i) {
        double total = 0;
        for (std::size_t j = 0; j < N; ++j) total += powers_[r][i * N + j] * rest[j];
        e[i] = (total * up + sum[i]) * up;
    }
    return e;
}

void Discretisation::extend_to(long n)
{
    const WorkingPrecision precision(bits_);
    const std::size_t N = nodes_.size();
    const auto limbs = static_cast<std::size_t>(format_.limbs());
    if (n > longest_chain) throw BeyondReach("n must be at most 10000");
    while (static_cast<long>(levels_.size()) <= n) {
        Level l;
        std::vector<mp_limb_t> values(N * limbs);
        for (std::size_t i = 0; i < N; ++i)
            if (levels_.empty()) { // F_0 = (2/pi) arcsin(sqrt x)/sqrt x
                const Ball root = sqrt(nodes_[i].x);
                const Ball F = 2 * asin(root) / (Traits::pi() * root) / scale_;
                format_.put(&values[i * limbs], F);
                if (!certainly(less(radius(F), format_.unit()))) throw std::logic_error("transfer: F_0 is not accurate to a unit");
            }
            else format_.put(&values[i * limbs], format_.dot(&matrix_[i * N * limbs], levels_.back().coefficients.data(), N));
        l.errors = errors_of(levels_.size());
        const double largest = *std::max_element(l.errors.begin(), l.errors.end());
        if (!(largest < std::ldexp(1.0, static_cast<int>(error_unit_)))) // roundings are counted for values of at most 2 c_m
            throw ErrorsHaveOutgrown("errors have outgrown the values over so many scales");
        l.coefficients.resize(values.size());
        for (const Block& b : blocks_) to_coefficients_.of(&values[b.first * limbs], &l.coefficients[b.first * limbs]);
        levels_.push_back(std::move(l));
    }
}

/// The rows of all points, moments added up: a moment of the sum is off by what each w_i and each product is, (rad w_i + u) sum_q W + u.
Discretisation::Functional Discretisation::functional(const std::vector<Point>& points)
{
    const WorkingPrecision precision(bits_);
    const auto limbs = static_cast<std::size_t>(format_.limbs());
    const std::size_t N = nodes_.size();
    const Ball u = format_.unit();
    std::vector<mp_limb_t> moments(N * limbs), weight(limbs), product(limbs), scratch(2 * limbs);
    Functional f;
    f.first = f.budget = Ball(0);
    Ball rounding(0), highest(0);
    for (const Point& point : points) highest = larger(highest, point.x);
    if (points.size() > 1) highest = upper(highest);
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
            f.budget = upper(f.budget + abs(point.weight) * budget(r, x, rule).total());
            rounding += upper((radius(point.weight) + u) * (1 + r.total) + u);
        };
        if (certainly(less(x, 2 / G_))) add(rule_);
        else {
            if (!beyond) {
                const Ratios ratios{highest, points.size() == 1};
                const double V = cut_off(ratios, accuracy_);
                beyond = scheme_ == Scheme::force_weighted ? double_exponential_rule(G_, ratios, accuracy_, V) : gauss_panel_rule(G_, ratios, accuracy_, V);
            }
            add(*beyond);
        }
        f.first += point.weight * 2 * asin(sqrt(x)) / (Traits::pi() * sqrt(x));
    }
    f.budget = upper(f.budget + static_cast<long>(N) * rounding * coefficient_bound());
    f.modulus.resize(N);
    const double off = nodal(moments.data(), f.modulus.data());
    for (double& w : f.modulus) w = (std::fabs(w) + off) * up;
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

/// Level n - 1 to level n. \pre n >= 1
Ball Discretisation::value(const Functional& f, long n) const
{
    const Level& level = levels_[static_cast<std::size_t>(n - 1)];
    Ball F = scale_ * format_.dot(f.moments.data(), level.coefficients.data(), nodes_.size());
    double carried = 0;
    for (std::size_t j = 0; j < nodes_.size(); ++j) carried += f.modulus[j] * level.errors[j];
    const WorkingPrecision coarse(64);
    const std::size_t m = std::min(static_cast<std::size_t>(n - 1), c_.size() - 1);
    const Ball error = c_[m] * f.budget + Ball::exactly(carried * up) * Traits::power_of_two(-error_unit_);
    arb_add_error(F.get(), upper(error).get());
    return F;
}

std::size_t Discretisation::memory() const
{
    return 8 * (matrix_.size() + (powers_.size() + 2) * near_power_.size())
         + (levels_.empty() ? 0 : levels_.size() * 8 * (levels_[0].coefficients.size() + levels_[0].errors.size()));
}

std::string Discretisation::certificate(long n)
{
    const std::lock_guard lock(mutex_);
    extend_to(std::max(n - 1, 0L));
    const auto show = [](const Ball& b) { return Ball(b).to_string(3); };
    std::string text = fmt::format("{}: {} nodes in {} block(s) of {}, ellipse rho = {:.4g}; {}\n",
                                   scheme_ == Scheme::force_weighted ? "force-weighted" : "area", nodes_.size(), blocks_.size(),
                                   blocks_[0].points, blocks_[0].rho, rule_.text);
    text += fmt::format("  one step adds at most, relative to |F_m| <= c_m: rule {}, cut-off {}, interpolation {}, abscissae {}, weights {}, entries {}\n",
                        show(worst_.rule), show(worst_.truncation), show(worst_.interpolation), show(worst_.abscissae),
                        show(worst_.weights), show(worst_.entries));
    for (long m = 0; m < std::max(n, 1L); ++m) {
        const auto& e = levels_[static_cast<std::size_t>(m)].errors;
        text += fmt::format("  level {}: |F_{}| <= {}, error <= {} at every node\n", m, m, show(c_[std::min(static_cast<std::size_t>(m), c_.size() - 1)]),
                            show(Ball::exactly(*std::max_element(e.begin(), e.end())) * Traits::power_of_two(-error_unit_)));
    }
    return text;
}

} // namespace touchstone::transfer
