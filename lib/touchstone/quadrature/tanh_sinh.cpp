// SPDX-License-Identifier: MIT
#include "touchstone/quadrature/tanh_sinh.hpp"

#include "touchstone/quadrature/nodes.hpp"
#include "touchstone/quadrature/strip.hpp"
#include "touchstone/quadrature/widen.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>
#include <tuple>

namespace touchstone::quadrature {

std::string to_string(Status s)
{
    switch (s) {
    case Status::certified: return "certified";
    case Status::undecided: return "undecided";
    case Status::indeterminate: break;
    }
    return "indeterminate";
}

// ---------------------------------------------------------------- intervals

void Interval::prepare()
{
    start_ = a_.ball();
    end_ = b_.ball();
    width_ = a_.exact() && b_.exact() ? Ball(Rational(*b_.exact() - *a_.exact())) : end_ - start_;
}

bool Interval::is_proper() const
{
    return start_.is_finite() && (kind_ != Kind::finite || (end_.is_finite() && arb_is_positive(width_.get())));
}

std::string Interval::to_string() const
{
    const auto text = [](const Endpoint& e) { return e.exact() ? e.exact()->get_str() : e.ball().to_string(15); };
    switch (kind_) {
    case Kind::finite: return "[" + text(a_) + ", " + text(b_) + "]";
    case Kind::ray_algebraic:
    case Kind::ray_exponential: return (mirrored_ ? "(-oo, " + text(a_) + "]" : "[" + text(a_) + ", oo)") + (kind_ == Kind::ray_algebraic ? " algebraic" : " exponential");
    case Kind::line_algebraic: return "(-oo, oo) algebraic";
    case Kind::line_exponential: return "(-oo, oo) exponential";
    }
    return {};
}

// ---------------------------------------------------------------- certificates

namespace {

Ball sum(const std::vector<Panel>& panels, Ball Panel::*term)
{
    const WorkingPrecision precision(strip_bits);
    Ball total(0);
    for (const Panel& p : panels) total += p.*term;
    return total;
}

double upper(const Ball& x)
{
    mag_t m;
    mag_init(m);
    arb_get_mag(m, x.get());
    const double d = mag_get_d(m);
    mag_clear(m);
    return d;
}

/// log2 of an upper bound of |x|, which may be far outside the range of double.
double log2_upper(const Ball& x)
{
    mag_t m;
    mag_init(m);
    arb_get_mag(m, x.get());
    const double d = mag_is_inf(m) ? std::numeric_limits<double>::infinity() : mag_is_zero(m) ? -1e18 : mag_get_d_log2_approx(m);
    mag_clear(m);
    return d;
}

/// An upper bound as a short decimal, rounded up: "1.3e-105".
std::string bound_text(const Ball& x)
{
    if (!x.is_finite()) return "null";
    const double l = log2_upper(x) * M_LN2 / M_LN10;
    if (l < -1e15) return "0";
    const double e = std::floor(l);
    std::ostringstream out;
    out.precision(2);
    out << std::fixed << std::ceil((std::pow(10.0, l - e) + 1e-6) * 100) / 100 << "e" << static_cast<long>(e);
    return out.str();
}

} // namespace

Ball Certificate::discretisation() const { return sum(panels, &Panel::discretisation); }
Ball Certificate::truncation() const { return sum(panels, &Panel::truncation); }
Ball Certificate::rounding() const { return sum(panels, &Panel::rounding); }
long Certificate::points() const
{
    long n = 0;
    for (const Panel& p : panels) n += p.left_nodes + p.right_nodes + 1;
    return n;
}

std::string Certificate::to_json() const
{
    std::ostringstream out;
    out << "{\"method\":\"tanh-sinh\",\"interval\":\"" << interval << "\",\"digits\":" << digits << ",\"precision_bits\":" << precision
        << ",\"points\":" << points() << ",\"discretisation\":" << bound_text(discretisation()) << ",\"truncation\":" << bound_text(truncation())
        << ",\"rounding\":" << bound_text(rounding()) << ",\"panels\":[";
    for (std::size_t i = 0; i < panels.size(); ++i) {
        const Panel& p = panels[i];
        out << (i ? "," : "") << "{\"u\":[\"" << p.from << "\",\"" << p.to << "\"],\"alpha\":\"" << p.alpha.to_string() << "\",\"beta\":\""
            << p.beta.to_string() << "\",\"d\":" << p.strip << ",\"K\":[" << bound_text(p.bound_left) << "," << bound_text(p.bound_right)
            << "],\"strip_integral\":" << bound_text(p.strip_integral) << ",\"step\":\"log(2)/" << p.m << "\",\"points\":[" << p.left_nodes << ","
            << p.right_nodes << "],\"pieces\":" << p.pieces << ",\"discretisation\":" << bound_text(p.discretisation)
            << ",\"truncation\":" << bound_text(p.truncation) << ",\"rounding\":" << bound_text(p.rounding) << "}";
    }
    out << "]}";
    return out.str();
}

// ---------------------------------------------------------------- the proof

namespace detail {
namespace {

/// x with pi sinh(x) cos(d) >= depth, up to rounding (only efficiency depends on it).
double edge(double depth, double d) { return std::ceil(std::asinh(depth / (M_PI * std::cos(d))) * 64) / 64; }

/// One end of the strip: what holds for |Re t| >= edge, 0 <= Im t <= d.
struct End {
    bool proved = false;
    double edge = 0;
    Ball depth;         // A: |distance| <= exp(-A)/(1 - exp(-A))
    Exponent here, far; // F = c pi cosh t here^... : exponents at this end and at the other
    Ball bound;         // |c|
};

class StripProof {
public:
    StripProof(const PanelFunction<ComplexBall>& f, long budget) : f_(f), budget_(budget) {}

    /// Fill alpha, beta, strip, bounds, strip_integral, scale. False if nothing was proved.
    bool run(Panel& panel, double bits);

    std::string reason;
    double failure_u = 0.5; // fraction of the panel where the proof stopped; negative: at an end
    long pieces = 0;
    End left, right;        // the ends at the chosen height

private:
    EndpointNumber<ComplexBall> value(const StripPiece& p) { ++pieces; return f_(p); }
    bool constant(Panel& panel, double bits);
    End end(Side side, double d);
    bool layer(Side side, double x1, double x2, double y1, double y2, double smallest);
    Ball line(Side side, double x1, double x2, double d, int depth, const Ball* whole);
    Ball piece_bound(Side side, double x1, double x2, double d);
    Ball tail(const End& e, double d) const;
    Ball strip_integral(double d, const End& left, const End& right);
    Ball strip_integral_by_pieces(double d, const End& left, const End& right);
    void fail(const StripPiece& piece, const char* what);

    const PanelFunction<ComplexBall>& f_;
    long budget_;
    bool is_constant_ = false;
    double slack_ = 0.5; // how much a bisection must sharpen a bound of the strip integral to be worth while
    EndpointNumber<ComplexBall> constant_;
};

Ball upper_ball(const ComplexBall& z)
{
    Ball b = touchstone::abs(z);
    mag_t m;
    mag_init(m);
    arb_get_mag(m, b.get());
    Ball r;
    arf_set_mag(arb_midref(r.get()), m);
    mag_clear(m);
    return r;
}

Ball upper_ball(const Ball& x)
{
    mag_t m;
    mag_init(m);
    arb_get_mag(m, x.get());
    Ball r;
    arf_set_mag(arb_midref(r.get()), m);
    mag_clear(m);
    return r;
}

void StripProof::fail(const StripPiece& piece, const char* what)
{
    const ComplexBall u = piece.distance(Side::left);
    failure_u = arf_get_d(arb_midref(acb_realref(u.get())), ARF_RND_NEAR);
    reason = what;
}

End StripProof::end(Side side, double d)
{
    End e;
    for (const double depth : {4.0, 10.0, 24.0, 60.0}) {
        e.proved = false;
        e.edge = edge(depth, d);
        const StripPiece piece = StripPiece::at(side, e.edge, std::numeric_limits<double>::infinity(), 0, d);
        const EndpointNumber<ComplexBall> c = is_constant_ ? constant_ : value(piece);
        e.depth = piece.depth();
        const Order own = c.order(side);
        e.here = own.power + Exponent(1);
        e.far = c.order(side == Side::left ? Side::right : Side::left).power + Exponent(1);
        if (!c.factor().is_finite()) continue;
        e.bound = upper_ball(c.factor());
        if (!own.logs.is_zero()) { // rho^k <= (sup of |u|^epsilon rho^k) |u|^-epsilon
            const Exponent epsilon = Exponent(0) < own.logs ? e.here * Exponent(1, 32) : Exponent(0);
            e.bound = e.bound * upper_ball(piece.vanishing(side, epsilon.ball(), own.logs));
            e.here = e.here - epsilon;
        }
        if (!e.bound.is_finite()) continue;
        e.proved = true;
        if (Exponent(0) < e.here) break; // else farther out the exponent may be better: where a growing factor bounds it
    }
    return e;
}

bool StripProof::layer(Side side, double x1, double x2, double y1, double y2, double smallest)
{
    const StripPiece piece = StripPiece::at(side, x1, x2, y1, y2);
    if (pieces >= budget_) { fail(piece, "the integrand was not proved analytic within the proof budget"); return false; }
    if (value(piece).factor().is_finite()) return true;
    const double width = x2 - x1, height = y2 - y1;
    if (width <= smallest && height <= smallest) {
        fail(piece, "the integrand is not proved analytic");
        return false;
    }
    if (width > height) {
        const double x = (x1 + x2) / 2;
        return layer(side, x1, x, y1, y2, smallest) && layer(side, x, x2, y1, y2, smallest);
    }
    const double y = (y1 + y2) / 2;
    return layer(side, x1, x2, y1, y, smallest) && layer(side, x1, x2, y, y2, smallest);
}

/// Upper bound of the integral of |F| over the piece of the line Im t = d.
Ball StripProof::piece_bound(Side side, double x1, double x2, double d)
{
    const StripPiece piece = StripPiece::at(side, x1, x2, d, d);
    const EndpointNumber<ComplexBall> c = is_constant_ ? constant_ : value(piece);
    const Ball exponent = (c.left().power + Exponent(1)).ball() * piece.logarithm(Side::left).real()
                          + (c.right().power + Exponent(1)).ball() * piece.logarithm(Side::right).real();
    return upper_ball(upper_ball(c.factor()) * exp(exponent) * piece.stretch() * Ball::exactly(x2 - x1));
}

Ball StripProof::line(Side side, double x1, double x2, double d, int depth, const Ball* whole)
{
    const Ball own = whole ? *whole : piece_bound(side, x1, x2, d);
    const double x = (x1 + x2) / 2;
    const Ball a = piece_bound(side, x1, x, d), b = piece_bound(side, x, x2, d);
    const Ball both = a + b;
    if (depth == 0 || pieces >= budget_) return arb_lt(both.get(), own.get()) ? both : own;
    // sharper bounds only matter through their logarithm
    if (both.is_finite() && upper(both) > slack_ * upper(own)) return both;
    return line(side, x1, x, d, depth - 1, &a) + line(side, x, x2, d, depth - 1, &b);
}

/// The integral of |F| over |Re t| >= edge on the line Im t = d, for every d up to the end's own:
/// c (1 - exp(-A))^-(|alpha|+|beta|) exp(-alpha A) / (alpha cos d).
Ball StripProof::tail(const End& e, double d) const
{
    const Ball alpha = e.here.ball();
    const Ball spread = touchstone::abs(alpha) + touchstone::abs(e.far.ball());
    return upper_ball(e.bound * exp(-alpha * e.depth - spread * log(Ball(1) - exp(-e.depth))) / (alpha * cos(Ball::exactly(d))));
}

Ball StripProof::strip_integral(double d, const End& left, const End& right)
{
    if (!is_constant_) return strip_integral_by_pieces(d, left, right);
    // |c| times an integral that depends on the exponents alone: keep it for the next integrand of this kind
    using Key = std::tuple<long, long, long, long, double, double, double, double>;
    thread_local std::map<Key, Ball> known;
    const auto& p = constant_.left().power;
    const auto& q = constant_.right().power;
    const Key key{p.num(), p.den(), q.num(), q.den(), d, left.edge, right.edge, slack_};
    const Ball size = upper_ball(constant_.factor());
    if (const auto found = known.find(key); found != known.end()) return upper_ball(size * found->second);
    if (known.size() > 1000) known.clear();
    const EndpointNumber<ComplexBall> own = constant_;
    constant_ = EndpointNumber<ComplexBall>(own.frame(), own.left(), own.right(), ComplexBall(1));
    End unit_left = left, unit_right = right;
    unit_left.bound = unit_right.bound = Ball(1);
    const Ball unit = strip_integral_by_pieces(d, unit_left, unit_right);
    constant_ = own;
    known[key] = unit;
    return upper_ball(size * unit);
}

Ball StripProof::strip_integral_by_pieces(double d, const End& left, const End& right)
{
    const Ball half = line(Side::left, 0, left.edge, d, 12, nullptr) + line(Side::right, 0, right.edge, d, 12, nullptr) + tail(left, d) + tail(right, d);
    return upper_ball(half);
}

bool StripProof::run(Panel& panel, double bits)
{
    const WorkingPrecision precision(strip_bits);
    slack_ = std::exp2(-std::max(0.6, bits / 100));
    {
        const EndpointNumber<ComplexBall> c = value(StripPiece::everywhere());
        if (c.factor().is_finite()) {
            is_constant_ = true;
            constant_ = c;
        }
    }
    const auto report_end = [&](const End& e, Side side) {
        std::ostringstream out;
        out << "at the " << (side == Side::left ? "left" : "right") << " end ";
        if (!e.proved) out << "the integrand is not proved to be a power times a bounded analytic function";
        else out << "the exponent " << (e.here - Exponent(1)).to_string() << " is all that is proved, and the integral needs one above -1";
        reason = out.str();
        failure_u = -1;
    };
    struct Candidate { double d; End left, right; };
    const long total = budget_;
    const auto holds = [&](Candidate& c, double below, long allowance) {
        for (const Side s : {Side::left, Side::right}) {
            End& e = s == Side::left ? c.left : c.right;
            e = end(s, c.d);
            if (!e.proved || !(Exponent(0) < e.here)) { report_end(e, s); return false; }
        }
        budget_ = std::min(total, pieces + allowance);
        const double smallest = (c.d - below) / 32;
        const bool yes = is_constant_ || (layer(Side::left, 0, c.left.edge, below, c.d, smallest) && layer(Side::right, 0, c.right.edge, below, c.d, smallest));
        budget_ = total;
        return yes;
    };
    // What a piece costs against a node at this precision: the proof may cost about as much as the nodes it saves.
    const double nodes_cost = 1.1 * bits * (1 + std::pow(bits / 500, 1.3));
    std::vector<Candidate> proved;
    double failed = 1.5;
    const auto descend = [&](double from, double to, long allowance) {
        for (double d = from; proved.empty() && d >= to; d /= 2) {
            Candidate c{d, {}, {}};
            if (holds(c, 0, allowance)) proved.push_back(c);
            else failed = d;
        }
    };
    descend(1, 1.0 / 64, 150 + static_cast<long>(nodes_cost / 4));
    // lower: a singularity may be close; or a factor such as cos x, which grows with the height of the strip, needs a low one
    if (proved.empty()) descend(failure_u >= 0 ? 0.125 : 1.0 / 128, failure_u >= 0 ? 1e-4 : 1e-3, total);
    if (proved.empty()) return false;
    while (proved.size() < 6) {
        const double d0 = proved.back().d, d = (d0 + failed) / 2;
        const double gain = nodes_cost * (d - d0) / d0;
        if (!is_constant_ && (gain < 150 || (d - d0) / d0 < 0.04)) break;
        Candidate c{d, {}, {}};
        if (holds(c, d0, static_cast<long>(gain))) proved.push_back(c);
        else if ((failed = d) - d0 < 0.1 * d0) break;
    }

    // scale: the integral of |F| over the real line
    const Candidate& lowest = proved.front();
    panel.scale = strip_integral(0, lowest.left, lowest.right);
    if (!panel.scale.is_finite()) { reason = "the integral of |f| was not bounded within the proof budget"; return false; }
    const double wanted = std::max(1.0, bits);
    double best = 0;
    const auto consider = [&](const Candidate& c) {
        const Ball n = Ball(2) * strip_integral(c.d, c.left, c.right);
        if (!n.is_finite()) return true;
        const double rate = c.d / (wanted + 4 + std::max(0.0, log2_upper(n) - log2_upper(panel.scale)));
        if (rate <= best) return false;
        best = rate;
        panel.strip = c.d;
        panel.strip_integral = n;
        panel.alpha = c.left.here;
        panel.beta = c.right.here;
        panel.bound_left = c.left.bound;
        panel.bound_right = c.right.bound;
        left = c.left;
        right = c.right;
        return true;
    };
    for (auto c = proved.rbegin(); c != proved.rend(); ++c)
        if (!consider(*c)) break;
    // F may grow so fast away from the line that a part of the proved strip serves better.
    for (double d = lowest.d / 2; d > lowest.d / 100; d /= 2) {
        Candidate c{d, end(Side::left, d), end(Side::right, d)};
        if (best > 0 && best >= d / (wanted + 4)) break; // nothing to gain even with N_d = scale
        if (!c.left.proved || !c.right.proved || !consider(c)) break;
    }
    if (best == 0) { reason = "the integral of |F| along the strip was not bounded"; return false; }
    return true;
}


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
    const Ball spread = touchstone::abs(e.far.ball());
    return upper_ball(e.bound * exp(-power - spread * log(Ball(1) - exp(-e.depth))) / alpha);
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
    Ball log2, e;
    arb_const_log2(log2.get(), strip_bits);
    const Ball exponent = Ball(2) * pi<Ball>() * Ball::exactly(p.strip) * Ball(p.m) / log2;
    arb_expm1(e.get(), exponent.get(), strip_bits);
    return upper_ball(p.strip_integral / e);
}

Ball radius(const Ball& x)
{
    Ball r;
    arf_set_mag(arb_midref(r.get()), arb_radref(x.get()));
    return r;
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
    const auto table = NodeTable::get(p.m, std::max(p.left_nodes, p.right_nodes), bits, std::min({1.0, p.alpha.to_double(), p.beta.to_double()}));

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
    p.rounding = radius(sum);
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
        if (at >= 0) text << " near the fraction " << from.get_d() + (to.get_d() - from.get_d()) * at << " of the interval";
        else if (from != 0 || to != 1) text << " of the part from fraction " << from.get_d() << " to " << to.get_d();
        return text.str();
    };
    if ((!proved || p.panel.strip < 0.2) && depth < options.bisections && at > 1e-3 && at < 1 - 1e-3) {
        const Rational cut = from + (to - from) * Rational(static_cast<long>(std::lround(at * 1024)), 1024);
        std::vector<ProvedPanel> parts;
        std::string why;
        if (prove_panels(make, from, cut, options, depth + 1, bits, parts, why, stopped) && prove_panels(make, cut, to, options, depth + 1, bits, parts, why, stopped)) {
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
    if (!declared(options.left_exponent, panels.front().panel.alpha, "left") || !declared(options.right_exponent, panels.back().panel.beta, "right"))
        return refuse(result.reason);

    Ball scale(0);
    {
        const WorkingPrecision precision(strip_bits);
        for (const ProvedPanel& p : panels) scale += p.panel.scale;
    }
    double log2_tolerance = log2_upper(scale) - wanted - 2 - std::log2(static_cast<double>(panels.size()));
    for (int attempt = 0;; ++attempt) {
        const double bits = std::max(bits_against(panels) - log2_tolerance, log2_upper(scale)); // the bound of |f| may itself be all there is
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
        if (shortfall <= 0 || attempt == 3 || !total.is_finite()) break;
        // the integral is much smaller than the integral of |f|: ask for that much more
        log2_tolerance -= std::min(shortfall + 2, 2 * wanted);
    }
    result.certificate.panels.clear();
    for (ProvedPanel& p : panels) result.certificate.panels.push_back(std::move(p.panel));
    if (!result.value.is_finite()) return refuse("the integrand is not finite at a node");
    result.digits = std::clamp(digits_of(result.value), 0L, options.digits);
    result.status = result.digits == options.digits ? Status::certified : Status::undecided;
    if (result.status == Status::undecided)
        result.reason = digits_text(result.digits, options.digits) + ": the error is at most " + bound_text(radius(result.value)) + ", where |f| integrates to at most " + bound_text(scale);
    return result;
}
catch (const DomainError& error) { // an exponent that Exponent cannot hold
    Enclosure refused;
    refused.value = Ball::indeterminate();
    refused.reason = error.what();
    return refused;
}

} // namespace detail
} // namespace touchstone::quadrature
