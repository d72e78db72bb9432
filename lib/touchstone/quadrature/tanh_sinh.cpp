// SPDX-License-Identifier: MIT
#include "touchstone/quadrature/tanh_sinh.hpp"

#include "touchstone/quadrature/lemmas.hpp"
#include "touchstone/quadrature/nodes.hpp"
#include "touchstone/quadrature/progress.hpp"
#include "touchstone/quadrature/strip_proof.hpp"
#include "touchstone/quadrature/upper.hpp"
#include "touchstone/quadrature/widen.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace touchstone::quadrature::detail {
namespace {

/// Bound of h sum |F(kh)| over the nodes beyond the n-th, from the End's bounds on the real line:
/// c (1 - exp(-A))^-|beta| exp(-alpha pi sinh(n h)) / alpha, if n h >= edge and alpha pi sinh(n h) >= 1; of the logistic rule exp(-alpha n
/// h) in it.
Ball truncation_bound(const End& e, long n, long m, Transformation transformation)
{
    Ball x, s;
    arb_const_log2(x.get(), strip_bits);
    x = x * Ball(n) / Ball(m);
    if (!arb_ge(x.get(), Ball::exactly(e.edge).get())) return Ball::indeterminate();
    if (transformation == Transformation::logistic)
        return upper_ball(lemma::logistic_truncation(e.bound, e.here.ball(), e.far.ball(), e.depth, x));
    arb_sinh(s.get(), x.get(), strip_bits);
    const Ball alpha = e.here.ball();
    const Ball power = alpha * pi<Ball>() * s;
    if (!arb_ge(power.get(), Ball(1).get())) return Ball::indeterminate();
    return upper_ball(lemma::truncation(e.bound, alpha, e.far.ball(), e.depth, pi<Ball>() * s));
}

/// The least n whose truncation_bound is below 2^log2_tolerance (found in double, so: about).
long nodes_needed(const End& e, long m, double log2_tolerance, Transformation transformation)
{
    const double alpha = e.here.to_double();
    const double log_ratio = std::max(1.0, (log2_upper(e.bound) - log2_tolerance) * M_LN2 - std::log(alpha) + 0.1);
    const double depth = log_ratio / alpha;
    const double x = std::max(transformation == Transformation::logistic ? depth : std::asinh(depth / M_PI), e.edge);
    return static_cast<long>(std::ceil(x * static_cast<double>(m) / M_LN2)) + 1;
}

/// m rounded up to few significant bits, so that node tables are shared.
long rounded_step(double m)
{
    long step = 1;
    while (m / static_cast<double>(step) > 64) step *= 2;
    return std::max(2L, static_cast<long>(std::ceil(m / static_cast<double>(step))) * step);
}

/// exp(2 pi d / h) - 1 divides N_d.
Ball discretisation_bound(const Panel& p)
{
    Ball log2;
    arb_const_log2(log2.get(), strip_bits);
    return upper_ball(lemma::discretisation(p.strip_integral, Ball::exactly(p.strip), log2 / Ball(p.m)));
}

struct ProvedPanel {
    Panel panel;
    PanelIntegrand f;
    End left, right;
};

/// Sums over a panel, and about the largest of those of the terms' sizes, which is compared with what was proved of it.
struct Sums {
    std::vector<Ball> values;
    Ball absolute{0};
};

/// A bound of |x w| more.
void add_size(Ball& sum, const Ball& x, const Ball& w)
{
    mag_t size, factor;
    mag_init(size), mag_init(factor);
    arb_get_mag(size, x.get());
    arb_get_mag(factor, w.get());
    mag_addmul(arb_radref(sum.get()), size, factor);
    mag_clear(size), mag_clear(factor);
}

/// Step and nodes for an error of 2^log2_tolerance.
void plan(ProvedPanel& proved, double log2_tolerance)
{
    Panel& p = proved.panel;
    const WorkingPrecision coarse(strip_bits);
    const double log_ratio = std::max(1.0, (log2_upper(p.strip_integral) - log2_tolerance + 2) * M_LN2);
    p.m = rounded_step(M_LN2 * log_ratio / (2 * M_PI * p.strip));
    p.left_nodes = nodes_needed(proved.left, p.m, log2_tolerance - 3, p.transformation);
    p.right_nodes = nodes_needed(proved.right, p.m, log2_tolerance - 3, p.transformation);
}

/// The sums over one panel as it was planned, to within 2^log2_tolerance.
Sums evaluate(ProvedPanel& proved, std::size_t count, double log2_tolerance, slong& precision, ValueCount& values)
{
    Panel& p = proved.panel;
    {
        const WorkingPrecision coarse(strip_bits);
        p.discretisation = discretisation_bound(p);
        p.truncation = upper_ball(truncation_bound(proved.left, p.left_nodes, p.m, p.transformation) +
                                  truncation_bound(proved.right, p.right_nodes, p.m, p.transformation));
    }
    const double log2_largest = std::max({log2_upper(proved.left.bound), log2_upper(proved.right.bound), log2_upper(p.scale)});
    const bool logistic = p.transformation == Transformation::logistic;
    const double octaves =
        logistic ? 0 : static_cast<double>(std::max(p.left_nodes, p.right_nodes)) / static_cast<double>(p.m); // cosh(kh) grows
    const slong bits = std::max<slong>(64, static_cast<slong>(std::ceil(log2_largest - log2_tolerance + octaves)) + 12);
    precision = std::max(precision, bits);
    const auto table = NodeTable::get(p.m, std::max(p.left_nodes, p.right_nodes), bits,
                                      std::min({1.0, p.alpha.to_double(), p.beta.to_double()}), p.transformation);

    const WorkingPrecision full(bits);
    proved.f.prepare();
    std::vector<Ball> sums(count, Ball(0));
    Ball absolute(0);
    std::vector<EndpointNumber<Ball>> g;
    const double alpha = p.alpha.to_double(), beta = p.beta.to_double();
    const auto add = [&](long k, Side side) {
        values.one_more();
        const Node node(*table, k, side);
        const slong lost = static_cast<slong>((side == Side::left ? alpha : beta) * node.depth() / M_LN2);
        const WorkingPrecision here(std::max<slong>(40, std::min<slong>(bits, bits - lost + (logistic ? 0 : k / p.m) + 4)));
        const auto add_term = [&](std::size_t i, const Ball& value, const Ball& weight) {
            arb_addmul(sums[i].get(), value.get(), weight.get(), bits);
            add_size(absolute, value, weight);
        };
        if (const auto y = proved.f.straight_beside ? proved.f.straight_beside(side, node.distance(side)) : std::nullopt) {
            add_term(0, *y, node.weighted(0, 0));
            return;
        }
        proved.f.at_node(node, g);
        Ball weight;
        for (std::size_t i = 0; i < count; ++i) {
            if (i == 0 || !(g[i].left() == g[i - 1].left()) || !(g[i].right() == g[i - 1].right()))
                weight = node.weighted(g[i].left().power, g[i].right().power);
            add_term(i, g[i].factor(), weight);
        }
    };
    add(0, Side::right);
    for (long k = 1; k <= p.right_nodes; ++k) add(k, Side::right);
    for (long k = 1; k <= p.left_nodes; ++k) add(k, Side::left);
    Ball log2;
    arb_const_log2(log2.get(), bits);
    p.rounding = Ball(0);
    for (Ball& sum : sums) {
        sum *= (logistic ? log2 : pi<Ball>() * log2) / Ball(p.m);
        const Ball rounding = radius_of(sum);
        if (!arb_le(rounding.get(), p.rounding.get())) p.rounding = rounding;
        widen(sum, p.discretisation);
        widen(sum, p.truncation);
    }
    return {std::move(sums), absolute * Ball(4) / Ball(p.m)}; // pi log 2 < 4
}

/// The end of a panel that is none of the interval's is the cut at that fraction: what can be done about an end does not help there.
std::string with_cuts_for_ends(std::string reason, const Rational& from, const Rational& to)
{
    for (const bool left : {true, false}) {
        const std::string end = left ? "at the left end" : "at the right end";
        const Rational& fraction = left ? from : to;
        const auto found = reason.find(end);
        if (found == std::string::npos || fraction == (left ? 0 : 1)) continue;
        std::ostringstream cut;
        cut.precision(8);
        cut << "at the cut at the fraction " << fraction.get_d() << " of the interval";
        reason.replace(found, end.size(), cut.str());
    }
    return reason;
}

constexpr double cost_of_straight_values = 0.5; ///< against endpoint numbers, about

/// Prove panels, bisecting near what stops a proof or makes its strip thin.
bool prove_panels(const MakePanel& make, const Rational& from, const Rational& to, const Options& options, int depth, double bits,
                  std::vector<ProvedPanel>& out, std::string& reason, std::optional<double>& stopped)
{
    ProvedPanel p;
    p.f = make(from, to);
    {
        const WorkingPrecision precision(strip_bits);
        p.f.prepare();
    }
    p.panel.from = from;
    p.panel.to = to;
    p.panel.transformation = options.transformation;
    StripProof proof(p.f.on_strip, options.proof_budget, options.transformation);
    const bool proved = proof.run(p.panel, bits, p.f.straight_beside ? cost_of_straight_values : 1);
    p.panel.pieces = proof.pieces;
    p.left = proof.left;
    p.right = proof.right;
    const double at = proof.failure_u, place = from.get_d() + (to.get_d() - from.get_d()) * at; // where it stopped, in the panel and in all
    const auto described = [&] {
        std::ostringstream text;
        text.precision(8);
        text << (at >= 0 ? proof.reason : with_cuts_for_ends(proof.reason, from, to));
        if (at >= 0) text << " near the fraction " << place << " of the interval";
        return text.str();
    };
    if ((!proved || p.panel.strip < 0.2) && depth < options.bisections && at > 1e-3 && at < 1 - 1e-3) {
        const Rational cut = from + (to - from) * Rational(static_cast<long>(std::lround(at * 1024)), 1024);
        std::vector<ProvedPanel> parts;
        std::string why;
        if (prove_panels(make, from, cut, options, depth + 1, bits, parts, why, stopped) &&
            prove_panels(make, cut, to, options, depth + 1, bits, parts, why, stopped)) {
            std::move(parts.begin(), parts.end(), std::back_inserter(out));
            return true;
        }
        if (!proved) { // the place where the whole stopped says more than where a part did
            reason = std::move(why);
            stopped = place;
            return false;
        }
    }
    if (!proved) {
        reason = described();
        if (at >= 0) stopped = place;
        return false;
    }
    out.push_back(std::move(p));
    return true;
}

} // namespace

namespace {

constexpr double bits_per_digit = 3.3219281;

/// As many d that the radius is at most 10^-d of the value.
long digits_of(const Ball& x)
{
    if (x.is_exact()) return std::numeric_limits<long>::max();
    return static_cast<long>(std::floor(static_cast<double>(x.relative_bits()) / bits_per_digit));
}

/// Sums of more bits than this are not tried: the program's limit for every other value, 16 times what the digits take.
constexpr double most_bits_per_bit = 16, most_spare_bits = 8192, most_patient_bits = 16384;
/// Some 1000 times the values that an integrand without a singularity beside the interval takes.
constexpr double most_points_per_bit = 1000, most_spare_points = 50000;

/// log2 of the largest bound that errors are held against.
double bits_against(const std::vector<ProvedPanel>& panels)
{
    double most = -std::numeric_limits<double>::infinity();
    for (const ProvedPanel& p : panels)
        for (const Ball& b : {p.panel.strip_integral, p.left.bound, p.right.bound, p.panel.scale}) most = std::max(most, log2_upper(b));
    return most;
}

std::string digits_text(long proven, long asked)
{
    return (proven == 0 ? std::string("none") : "only " + std::to_string(proven)) + " of " + std::to_string(asked) + " digits proven";
}

} // namespace

EndpointNumber<ComplexBall> majorant(const std::vector<EndpointNumber<ComplexBall>>& all, const Frame<ComplexBall>& frame)
{
    Order p = all.front().left(), q = all.front().right();
    for (const auto& g : all) {
        p = Order::dominant(p, g.left());
        q = Order::dominant(q, g.right());
    }
    const EndpointNumber<ComplexBall> common(&frame, p, q, ComplexBall(1));
    Ball most(0);
    for (const auto& g : all) {
        const Ball size = upper_ball((g / common).value());
        if (!size.is_finite()) return {&frame, p, q, ComplexBall::indeterminate()};
        if (arb_gt(size.get(), most.get())) most = size;
    }
    return {&frame, p, q, ComplexBall(most)};
}

namespace {

/// What is known of the bits that the integrands' values lack.
double largest_shortfall(const std::vector<Ball>& totals, double wanted)
{
    double most = -std::numeric_limits<double>::infinity();
    for (const Ball& t : totals) most = std::max(most, wanted - static_cast<double>(t.relative_bits()));
    return most;
}

/// The result where nothing is proven.
Enclosure refused(const Interval& interval, long digits, std::string why, const std::optional<double>& fraction = {})
{
    Enclosure r;
    r.value = Ball::indeterminate();
    r.certificate.interval = interval.to_string();
    r.certificate.digits = digits;
    r.reason = std::move(why);
    r.fraction = fraction;
    return r;
}

/// What was declared of the exponents and is not what is proved; empty if it is.
std::string not_as_declared(const Options& options, const std::vector<ProvedPanel>& panels)
{
    const auto differs = [](const std::optional<Rational>& e, const Exponent& proved, const char* end) {
        if (!e || !(proved < Exponent(*e))) return std::string();
        return std::string("declared exponent ") + e->get_str() + " at the " + end + " end, proved only " + proved.to_string();
    };
    const std::string left = differs(options.left_exponent, panels.front().panel.alpha, "left");
    return !left.empty() ? left : differs(options.right_exponent, panels.back().panel.beta, "right");
}

/// About log2 of the integral that is smallest (of that of |f|, if its digits are enough), by a few nodes of 53 bits: what the first
/// tolerance goes by. Nothing is claimed of it; sizes below 2^-6 of the integral of |f| are not believed.
double rough_log2_size(std::vector<ProvedPanel>& panels, std::size_t count, bool of_absolute)
{
    const Transformation transformation = panels.front().panel.transformation;
    constexpr long m = 2;
    const long nodes = transformation == Transformation::logistic ? 60 : 8; // up to some e^20, as far as these of the other rule reach
    constexpr double believed = 6;
    const WorkingPrecision coarse(strip_bits);
    const auto table = NodeTable::get(m, nodes, strip_bits, 1, transformation);
    std::vector<Ball> sums(count, Ball(0));
    Ball absolute(0);
    std::vector<EndpointNumber<Ball>> g;
    for (ProvedPanel& p : panels) {
        p.f.prepare();
        for (long k = -nodes; k <= nodes; ++k) {
            const Node node(*table, std::labs(k), k < 0 ? Side::left : Side::right);
            p.f.at_node(node, g);
            for (std::size_t i = 0; i < count; ++i) {
                const Ball term = g[i].factor() * node.weighted(g[i].left().power, g[i].right().power);
                sums[i] += term;
                absolute += touchstone::abs(term);
            }
        }
    }
    Ball least = absolute;
    for (const Ball& s : sums)
        if (!of_absolute && log2_upper(s) < log2_upper(least)) least = s;
    return std::max(log2_upper(least), log2_upper(absolute) - believed);
}

/// The sums over all panels, the tolerance lowered until each has its digits; the reason if that takes too many bits.
std::vector<Ball> summed(std::vector<ProvedPanel>& panels, std::size_t count, const Options& options, double wanted, const Ball& scale,
                         slong& precision, std::string& reason)
{
    constexpr int most_attempts = 4;
    const double rough = rough_log2_size(panels, count, options.of_absolute), proved = log2_upper(scale);
    const double size = std::isfinite(rough) ? std::min(rough, proved) : proved;
    double log2_tolerance = size - wanted - 2 - std::log2(static_cast<double>(panels.size()));
    std::vector<Ball> totals;
    for (int attempt = 0; attempt < most_attempts; ++attempt) {
        const double bits =
            std::max(bits_against(panels) - log2_tolerance, log2_upper(scale)); // the bound of |f| may itself be all there is
        if (!(bits <= most_bits_per_bit * wanted + (options.patient ? most_patient_bits : most_spare_bits))) {
            if (attempt > 0) break;
            std::ostringstream why;
            why << "digits against the proven bound of |f| would take " << std::llround(bits) << " bits: f is huge next to the interval";
            reason = why.str();
            return {};
        }
        double points = 0;
        for (ProvedPanel& p : panels) {
            plan(p, log2_tolerance);
            points += static_cast<double>(p.panel.left_nodes + p.panel.right_nodes + 1);
        }
        if (points > most_points_per_bit * wanted + most_spare_points) {
            if (attempt > 0) break;
            std::ostringstream why;
            why << "the sum would take " << std::llround(points)
                << " values of f: it oscillates too fast, or is singular too near, for one rule";
            reason = why.str();
            return {};
        }
        precision = 0;
        ValueCount values(static_cast<long>(points));
        Ball absolute(0);
        totals.assign(count, Ball(0));
        for (ProvedPanel& p : panels) {
            const Sums parts = evaluate(p, count, log2_tolerance, precision, values);
            const WorkingPrecision full(precision + 8);
            absolute += parts.absolute;
            for (std::size_t i = 0; i < count; ++i) totals[i] += parts.values[i];
        }
        const double shortfall = largest_shortfall(totals, wanted);
        const bool finite = std::all_of(totals.begin(), totals.end(), [](const Ball& t) { return t.is_finite(); });
        if (shortfall <= 0 || options.of_absolute || !finite) break;
        // what a tolerance of 2^(-3 wanted) does not tell from 0 may be 0
        if (attempt > 0 && std::any_of(totals.begin(), totals.end(), [](const Ball& t) { return t.contains_zero(); })) break;
        // the integral is much smaller than what bounds that of |f|, because that is or because it cancels: ask for that much more
        const double excess = options.patient ? std::max(0.0, log2_upper(scale) - log2_upper(absolute)) : 0;
        log2_tolerance -= std::min(shortfall + 2, 2 * wanted + excess);
    }
    return totals;
}

} // namespace

std::vector<Enclosure> integrate(const MakePanel& make, std::size_t count, const Interval& interval, const Options& options)
try {
    const auto refuse = [&](std::string why, const std::optional<double>& fraction = {}) {
        return std::vector<Enclosure>(count, refused(interval, options.digits, std::move(why), fraction));
    };
    if (options.digits < 1) return refuse("digits must be at least 1");
    Interval ends = interval;
    {
        const WorkingPrecision precision(strip_bits);
        ends.prepare();
        if (!ends.is_proper()) return refuse("the ends of the interval are not finite numbers a < b");
    }
    const double wanted = static_cast<double>(options.digits) * bits_per_digit + 1;
    std::vector<ProvedPanel> panels;
    std::string reason;
    std::optional<double> stopped;
    if (!prove_panels(make, 0, 1, options, 0, wanted, panels, reason, stopped)) return refuse(std::move(reason), stopped);
    if (std::string other = not_as_declared(options, panels); !other.empty()) return refuse(std::move(other));

    Ball scale(0);
    {
        const WorkingPrecision precision(strip_bits);
        for (const ProvedPanel& p : panels) scale += p.panel.scale;
    }
    Certificate certificate;
    certificate.interval = interval.to_string();
    certificate.digits = options.digits;
    const std::vector<Ball> totals = summed(panels, count, options, wanted, scale, certificate.precision, reason);
    if (totals.empty()) return refuse(std::move(reason), stopped);
    for (ProvedPanel& p : panels) certificate.panels.push_back(std::move(p.panel));
    std::vector<Enclosure> all;
    for (const Ball& total : totals) {
        Enclosure r = refused(interval, options.digits, "", stopped);
        r.certificate = certificate;
        if (!total.is_finite())
            r.reason = "the integrand is not finite at a node";
        else {
            r.value = total;
            r.digits = std::clamp(digits_of(total), 0L, options.digits);
            r.status = r.digits == options.digits ? Status::certified : Status::undecided;
            if (r.status == Status::undecided)
                r.reason = digits_text(r.digits, options.digits) + ": the error is at most " + bound_text(radius_of(total)) +
                           ", where |f| integrates to at most " + bound_text(scale);
        }
        all.push_back(std::move(r));
    }
    return all;
}
catch (const DomainError& error) { // an exponent that Exponent cannot hold
    return std::vector<Enclosure>(count, refused(interval, options.digits, error.what()));
}

} // namespace touchstone::quadrature::detail
