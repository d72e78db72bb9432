// SPDX-License-Identifier: MIT
#include "touchstone/quadrature/tanh_sinh.hpp"

#include "touchstone/quadrature/lemmas.hpp"
#include "touchstone/quadrature/nodes.hpp"
#include "touchstone/quadrature/strip_proof.hpp"
#include "touchstone/quadrature/upper.hpp"
#include "touchstone/quadrature/widen.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace touchstone::quadrature::detail {
namespace {

/// Bound of h sum |F(kh)| over the nodes beyond the n-th, from the End's bounds on the real line:
/// c (1 - exp(-A))^-|beta| exp(-alpha pi sinh(n h)) / alpha, if n h >= edge and alpha pi sinh(n h) >= 1.
Ball truncation_bound(const End& e, long n, long m)
{
    Ball x, s;
    arb_const_log2(x.get(), strip_bits);
    x = x * Ball(n) / Ball(m);
    if (!arb_ge(x.get(), Ball::exactly(e.edge).get())) return Ball::indeterminate();
    arb_sinh(s.get(), x.get(), strip_bits);
    const Ball alpha = e.here.ball();
    const Ball power = alpha * pi<Ball>() * s;
    if (!arb_ge(power.get(), Ball(1).get())) return Ball::indeterminate();
    return upper_ball(lemma::truncation(e.bound, alpha, e.far.ball(), e.depth, pi<Ball>() * s));
}

/// The least n whose truncation_bound is below 2^log2_tolerance (found in double, so: about).
long nodes_needed(const End& e, long m, double log2_tolerance)
{
    const double alpha = e.here.to_double();
    const double log_ratio = std::max(1.0, (log2_upper(e.bound) - log2_tolerance) * M_LN2 - std::log(alpha) + 0.1);
    const double x = std::max(std::asinh(log_ratio / (M_PI * alpha)), e.edge);
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

/// The sum over one panel, to within 2^log2_tolerance.
Ball evaluate(ProvedPanel& proved, double log2_tolerance, slong& precision)
{
    Panel& p = proved.panel;
    {
        const WorkingPrecision coarse(strip_bits);
        const double log_ratio = std::max(1.0, (log2_upper(p.strip_integral) - log2_tolerance + 2) * M_LN2);
        p.m = rounded_step(M_LN2 * log_ratio / (2 * M_PI * p.strip));
        p.left_nodes = nodes_needed(proved.left, p.m, log2_tolerance - 3);
        p.right_nodes = nodes_needed(proved.right, p.m, log2_tolerance - 3);
        p.discretisation = discretisation_bound(p);
        p.truncation = upper_ball(truncation_bound(proved.left, p.left_nodes, p.m) + truncation_bound(proved.right, p.right_nodes, p.m));
    }
    const double log2_largest = std::max({log2_upper(proved.left.bound), log2_upper(proved.right.bound), log2_upper(p.scale)});
    const double octaves = static_cast<double>(std::max(p.left_nodes, p.right_nodes)) / static_cast<double>(p.m);
    const slong bits = std::max<slong>(64, static_cast<slong>(std::ceil(log2_largest - log2_tolerance + octaves)) + 12);
    precision = std::max(precision, bits);
    const auto table =
        NodeTable::get(p.m, std::max(p.left_nodes, p.right_nodes), bits, std::min({1.0, p.alpha.to_double(), p.beta.to_double()}));

    const WorkingPrecision full(bits);
    proved.f.prepare();
    Ball sum(0);
    const double alpha = p.alpha.to_double(), beta = p.beta.to_double();
    const auto add = [&](long k, Side side) {
        const Node node(*table, k, side);
        const slong lost = static_cast<slong>((side == Side::left ? alpha : beta) * node.depth() / M_LN2);
        const WorkingPrecision here(std::max<slong>(40, std::min<slong>(bits, bits - lost + k / p.m + 4)));
        const EndpointNumber<Ball> g = proved.f.at_node(node);
        arb_addmul(sum.get(), g.factor().get(), node.weighted(g.left().power, g.right().power).get(), bits);
    };
    add(0, Side::right);
    for (long k = 1; k <= p.right_nodes; ++k) add(k, Side::right);
    for (long k = 1; k <= p.left_nodes; ++k) add(k, Side::left);
    Ball log2;
    arb_const_log2(log2.get(), bits);
    sum *= pi<Ball>() * log2 / Ball(p.m);
    p.rounding = radius_of(sum);
    widen(sum, p.discretisation);
    widen(sum, p.truncation);
    return sum;
}

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
    StripProof proof(p.f.on_strip, options.proof_budget);
    const bool proved = proof.run(p.panel, bits);
    p.panel.pieces = proof.pieces;
    p.left = proof.left;
    p.right = proof.right;
    const double at = proof.failure_u;
    const auto described = [&] {
        std::ostringstream text;
        text.precision(8);
        text << proof.reason;
        if (at >= 0)
            text << " near the fraction " << from.get_d() + (to.get_d() - from.get_d()) * at << " of the interval";
        else if (from != 0 || to != 1)
            text << " of the part from fraction " << from.get_d() << " to " << to.get_d();
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
            stopped = from.get_d() + (to.get_d() - from.get_d()) * at;
            return false;
        }
    }
    if (!proved) {
        reason = described();
        if (at >= 0) stopped = from.get_d() + (to.get_d() - from.get_d()) * at;
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
constexpr double most_bits_per_bit = 16, most_spare_bits = 8192;

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

Enclosure integrate(const MakePanel& make, const Interval& interval, const Options& options)
try {
    Enclosure result;
    result.value = Ball::indeterminate();
    result.certificate.interval = interval.to_string();
    result.certificate.digits = options.digits;
    const auto refuse = [&](std::string why) {
        result.status = Status::indeterminate;
        result.value = Ball::indeterminate();
        result.reason = std::move(why);
        return result;
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
    if (!prove_panels(make, 0, 1, options, 0, wanted, panels, reason, result.fraction)) return refuse(std::move(reason));

    const auto declared = [&](const std::optional<Rational>& e, const Exponent& proved, const char* end) {
        if (!e || !(proved < Exponent(*e))) return true;
        result.reason = std::string("declared exponent ") + e->get_str() + " at the " + end + " end, proved only " + proved.to_string();
        return false;
    };
    if (!declared(options.left_exponent, panels.front().panel.alpha, "left") ||
        !declared(options.right_exponent, panels.back().panel.beta, "right"))
        return refuse(result.reason);

    Ball scale(0);
    {
        const WorkingPrecision precision(strip_bits);
        for (const ProvedPanel& p : panels) scale += p.panel.scale;
    }
    double log2_tolerance = log2_upper(scale) - wanted - 2 - std::log2(static_cast<double>(panels.size()));
    for (int attempt = 0;; ++attempt) {
        const double bits =
            std::max(bits_against(panels) - log2_tolerance, log2_upper(scale)); // the bound of |f| may itself be all there is
        if (!(bits <= most_bits_per_bit * wanted + most_spare_bits)) {
            if (attempt > 0) break;
            std::ostringstream why;
            why << "digits against the proven bound of |f| would take " << std::llround(bits) << " bits: f is huge next to the interval";
            return refuse(why.str());
        }
        slong precision = 0;
        Ball total(0);
        for (ProvedPanel& p : panels) {
            const Ball part = evaluate(p, log2_tolerance, precision);
            const WorkingPrecision full(precision + 8);
            total += part;
        }
        result.certificate.precision = precision;
        result.value = total;
        const double shortfall = wanted - static_cast<double>(total.relative_bits());
        if (shortfall <= 0 || attempt == 3 || options.of_absolute || !total.is_finite()) break;
        // the integral is much smaller than the integral of |f|: ask for that much more
        log2_tolerance -= std::min(shortfall + 2, 2 * wanted);
    }
    result.certificate.panels.clear();
    for (ProvedPanel& p : panels) result.certificate.panels.push_back(std::move(p.panel));
    if (!result.value.is_finite()) return refuse("the integrand is not finite at a node");
    result.digits = std::clamp(digits_of(result.value), 0L, options.digits);
    result.status = result.digits == options.digits ? Status::certified : Status::undecided;
    if (result.status == Status::undecided)
        result.reason = digits_text(result.digits, options.digits) + ": the error is at most " + bound_text(radius_of(result.value)) +
                        ", where |f| integrates to at most " + bound_text(scale);
    return result;
}
catch (const DomainError& error) { // an exponent that Exponent cannot hold
    Enclosure refused;
    refused.value = Ball::indeterminate();
    refused.reason = error.what();
    return refused;
}

} // namespace touchstone::quadrature::detail
