// SPDX-License-Identifier: MIT
#include "touchstone/quadrature/strip_proof.hpp"

#include "touchstone/quadrature/lemmas.hpp"
#include "touchstone/quadrature/upper.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <sstream>
#include <tuple>

namespace touchstone::quadrature::detail {
namespace {

/// How much of the exponent is spent on rho^k: the more, the smaller is (k/(e epsilon))^k; only efficiency depends on it.
Exponent share_for_logarithms(const Exponent& k)
{
    constexpr long few = 4, many = 64;
    return k < Exponent(few) ? Exponent(1, 32) : k < Exponent(many) ? Exponent(1, 8) : Exponent(1, 2);
}

/// x with pi sinh(x) cos(d) >= depth, or x >= depth, up to rounding (only efficiency depends on it).
double edge(double depth, double d, Transformation transformation)
{
    return transformation == Transformation::logistic ? depth : std::ceil(std::asinh(depth / (M_PI * std::cos(d))) * 64) / 64;
}

} // namespace

void StripProof::fail(const StripPiece& piece, const char* what)
{
    const ComplexBall u = piece.distance(Side::left);
    failure_u = arf_get_d(arb_midref(acb_realref(u.get())), ARF_RND_NEAR);
    reason = what;
}

End StripProof::end(Side side, double d)
{
    // A singular point beyond the end, at a distance of 10^-k of the interval, wants a depth of 2.3 k; and farther out the exponent may be
    // better, where a growing factor bounds it.
    constexpr std::array depths{4.0, 10.0, 24.0, 60.0, 150.0, 400.0, 1000.0, 2500.0, 6000.0};
    End e = end_at(side, depths.front(), d);
    if (e.is_integrable()) return e;
    const End deepest = end_at(side, depths.back(), d); // where that fails nothing is expected of what is not as deep
    for (std::size_t k = 1; k < depths.size() && deepest.is_integrable() && !e.is_integrable(); ++k) e = end_at(side, depths[k], d);
    return deepest.is_integrable() ? e : deepest;
}

End StripProof::end_at(Side side, double depth, double d)
{
    End e;
    e.edge = edge(depth, d, transformation_);
    const StripPiece piece = endless(side, e.edge, d);
    const EndpointNumber<ComplexBall> c = is_constant_ ? constant_ : value(piece);
    e.depth = piece.depth();
    const Order own = c.order(side);
    e.here = own.power + Exponent(1);
    e.far = c.order(side == Side::left ? Side::right : Side::left).power + Exponent(1);
    e.bound = upper_ball(c.factor());
    if (!own.logs.is_zero()) { // rho^k <= (sup of |u|^epsilon rho^k) |u|^-epsilon
        const Exponent epsilon = Exponent(0) < own.logs ? e.here * share_for_logarithms(own.logs) : Exponent(0);
        e.bound = e.bound * upper_ball(piece.vanishing(side, epsilon.ball(), own.logs));
        e.here = e.here - epsilon;
    }
    return e;
}

bool StripProof::layer(Side side, double x1, double x2, double y1, double y2, double smallest)
{
    const StripPiece piece = this->piece(side, x1, x2, y1, y2);
    if (pieces >= budget_) {
        fail(piece, "the integrand was not proved analytic within the proof budget");
        return false;
    }
    if (value(piece).factor().is_finite()) return true;
    const double width = x2 - x1, height = y2 - y1;
    if (width <= smallest && height <= smallest) {
        failed_side_ = side;
        failed_from_ = x1;
        failed_to_ = x2;
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
    const StripPiece piece = this->piece(side, x1, x2, d, d);
    const EndpointNumber<ComplexBall> c = is_constant_ ? constant_ : value(piece);
    const Ball exponent = (c.left().power + Exponent(1)).ball() * piece.logarithm(Side::left).real() +
                          (c.right().power + Exponent(1)).ball() * piece.logarithm(Side::right).real();
    return upper_ball(upper_ball(c.factor()) * exp(exponent) * piece.stretch() * Ball::exactly(x2 - x1));
}

/// The bound of the integral over 0 <= Re t <= edge enters through its logarithm: the piece with the largest share is halved while that
/// promises more bits, each of which saves nodes, than the two values of f cost.
Ball StripProof::line(Side side, double edge, double d)
{
    struct Piece {
        double x1, x2;
        Ball bound;
        double bits; // log2 of the bound
    };
    constexpr int at_first = 4;
    constexpr double to_a_quarter = 0.75; // what a half of a box takes off its bound, about
    std::vector<Piece> all;
    const auto add = [&](double x1, double x2) {
        Ball bound = piece_bound(side, x1, x2, d);
        const double bits = bound.is_finite() ? log2_upper(bound) : std::numeric_limits<double>::infinity();
        all.push_back({x1, x2, std::move(bound), bits});
    };
    const auto total = [&] {
        Ball sum(0);
        for (const Piece& p : all) sum += p.bound;
        return upper_ball(sum);
    };
    for (int k = 0; k < at_first; ++k) add(edge * k / at_first, edge * (k + 1) / at_first);
    constexpr double narrowest = 1.0 / 1024;
    while (pieces < budget_) {
        const auto largest = std::max_element(all.begin(), all.end(), [](const Piece& p, const Piece& q) { return p.bits < q.bits; });
        const double share = std::exp2(largest->bits - log2_upper(total()));
        const bool worth_while = !(share <= 1) || -std::log2(1 - to_a_quarter * share) * pieces_per_bit_ > 2;
        if (!worth_while || largest->x2 - largest->x1 < edge * narrowest) break;
        const Piece halved = *largest;
        all.erase(largest);
        const double x = (halved.x1 + halved.x2) / 2;
        add(halved.x1, x);
        add(x, halved.x2);
    }
    return total();
}

/// The integral of |F| over |Re t| >= edge on the line Im t = d, for every d up to the end's own:
/// c (1 - exp(-A))^-(|alpha|+|beta|) exp(-alpha A) / (alpha cos d), without the cosine where dw/dt = 1.
Ball StripProof::tail(const End& e, double d) const
{
    if (!e.is_integrable()) return Ball::indeterminate();
    const Ball alpha = e.here.ball();
    if (transformation_ == Transformation::logistic) return upper_ball(lemma::logistic_strip_tail(e.bound, alpha, e.far.ball(), e.depth));
    return upper_ball(lemma::strip_tail(e.bound, alpha, e.far.ball(), e.depth, Ball::exactly(d)));
}

Ball StripProof::strip_integral(double d, const End& left, const End& right)
{
    if (!is_constant_) return strip_integral_by_pieces(d, left, right);
    // |c| times an integral that depends on the exponents alone: keep it for the next integrand of this kind
    using Key = std::tuple<long, long, long, long, double, double, double, double, Transformation>;
    thread_local std::map<Key, Ball> known;
    const auto& p = constant_.left().power;
    const auto& q = constant_.right().power;
    const Key key{p.num(), p.den(), q.num(), q.den(), d, left.edge, right.edge, pieces_per_bit_, transformation_};
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
    const Ball half =
        line(Side::left, left.edge, d) + line(Side::right, right.edge, d) + tail(left, d) + tail(right, d);
    return upper_ball(half);
}

bool StripProof::run(Panel& panel, double bits, double cost_of_nodes)
{
    const WorkingPrecision precision(strip_bits);
    // What a piece costs against a node at this precision: the proof may cost about as much as the nodes it saves.
    const double nodes_cost = cost_of_nodes * 1.1 * bits * (1 + std::pow(bits / 500, 1.3));
    pieces_per_bit_ = nodes_cost / bits;
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
        if (!e.is_proved())
            out << "the integrand is not proved to be a power times a bounded analytic function";
        else
            out << "the exponent " << (e.here - Exponent(1)).to_string() << " is all that is proved, and the integral needs one above -1";
        reason = out.str();
        failure_u = -1;
    };
    // what an end does not show on the lowest strip it shows on none
    constexpr double lowest_height = 1e-4;
    for (const Side s : {Side::left, Side::right})
        if (const End e = end(s, lowest_height); !e.is_integrable()) {
            report_end(e, s);
            return false;
        }
    struct Candidate {
        double d;
        End left, right;
    };
    const long total = budget_;
    const auto holds = [&](Candidate& c, double below, long allowance) {
        for (const Side s : {Side::left, Side::right}) {
            End& e = s == Side::left ? c.left : c.right;
            e = end(s, c.d);
            if (!e.is_integrable()) {
                report_end(e, s);
                return false;
            }
        }
        budget_ = std::min(total, pieces + allowance);
        const double smallest = (c.d - below) / 32;
        // where the one before failed this one will fail first
        const double reach = (failed_side_ == Side::left ? c.left : c.right).edge;
        const bool likely = is_constant_ || failed_to_ <= failed_from_ || failed_to_ > reach ||
                            layer(failed_side_, failed_from_, failed_to_, below, c.d, smallest);
        const bool yes = is_constant_ || (likely && layer(Side::left, 0, c.left.edge, below, c.d, smallest) &&
                                          layer(Side::right, 0, c.right.edge, below, c.d, smallest));
        budget_ = total;
        return yes;
    };
    std::vector<Candidate> proved;
    double failed = 1.5;
    const auto descend = [&](double from, double to, long allowance) {
        for (double d = from; proved.empty() && d >= to; d /= 2) {
            Candidate c{d, {}, {}};
            if (holds(c, 0, allowance))
                proved.push_back(c);
            else
                failed = d;
        }
    };
    const long first_allowance = 150 + static_cast<long>(nodes_cost / 4);
    descend(0.75, 0.75, first_allowance);
    descend(0.5, 1.0 / 64, first_allowance);
    // lower: a singularity may be close; or a factor such as cos x, which grows with the height of the strip, needs a low one
    if (proved.empty()) descend(failure_u >= 0 ? 0.125 : 1.0 / 128, failure_u >= 0 ? 1e-4 : 1e-3, total);
    if (proved.empty()) return false;
    constexpr double least_gain = 60; // in pieces: what the proof of a higher strip costs
    while (proved.size() < 6) {
        const double d0 = proved.back().d, d = (d0 + failed) / 2;
        const double gain = nodes_cost * (d - d0) / d0;
        if (!is_constant_ && (gain < least_gain || (d - d0) / d0 < 0.04)) break;
        Candidate c{d, {}, {}};
        if (holds(c, d0, static_cast<long>(gain)))
            proved.push_back(c);
        else if ((failed = d) - d0 < 0.1 * d0)
            break;
    }

    // scale: the integral of |F| over the real line
    const Candidate& lowest = proved.front();
    panel.scale = strip_integral(0, lowest.left, lowest.right);
    if (!panel.scale.is_finite()) {
        reason = "the integral of |f| was not bounded within the proof budget";
        return false;
    }
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
    const auto may_gain = [&](double d) { return best == 0 || best < d / (wanted + 4); }; // if N_d were the scale
    for (auto c = proved.rbegin(); c != proved.rend(); ++c)
        if (!may_gain(c->d) || !consider(*c)) break;
    // F may grow so fast away from the line that a part of the proved strip serves better.
    for (double d = lowest.d / 2; d > lowest.d / 100 && may_gain(d); d /= 2)
        if (!consider({d, end(Side::left, d), end(Side::right, d)})) break;
    if (best == 0) {
        reason = "the integral of |F| along the strip was not bounded";
        return false;
    }
    return true;
}

} // namespace touchstone::quadrature::detail
