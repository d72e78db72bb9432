// SPDX-License-Identifier: MIT
#include "touchstone/quadrature/integrand.hpp"

#include "touchstone/quadrature/compiled.hpp"
#include "touchstone/quadrature/real_formula.hpp"
#include "touchstone/scalar/floor.hpp"

#include <algorithm>
#include <cmath>

namespace touchstone::quadrature {

using compiled::Place;
using compiled::Point;

Ball Limit::ball() const
{
    const slong bits = WorkingPrecision::bits();
    if (kept_bits_ < bits) {
        kept_ = exact ? exact->ball() : evaluate_at(*formula, Ball(0));
        kept_bits_ = bits;
    }
    Ball x;
    arb_set_round(x.get(), kept_.get(), bits);
    return x;
}

Endpoint Limit::endpoint() const
{
    if (exact)
        if (const auto q = exact->rational()) return Endpoint(*q);
    return Endpoint([copy = *this] { return copy.ball(); });
}

Limit limit_at(const ExactSum& value, std::string text)
{
    Limit l;
    l.exact = value;
    l.text = std::move(text);
    return l;
}

std::string text_of(const ExactSum& x)
{
    if (const auto q = x.rational()) return q->get_str();
    if (const auto q = x.times_pi()) return (*q == 1 ? "" : q->get_str() + "*") + std::string("pi");
    return x.ball().to_string(10);
}

Limit parse_limit(std::string_view text)
{
    while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
    while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
    Limit l;
    l.text = text;
    const auto sign = text.empty() ? '+' : text.front();
    const std::string_view word = sign == '-' || sign == '+' ? text.substr(1) : text;
    if (word == "inf" || word == "infinity" || word == "oo") {
        l.infinite = sign == '-' ? -1 : 1;
        return l;
    }
    l.formula = parse_expression(text);
    if (depends_on_x(*l.formula)) throw ExpressionError(1, "an end of the interval must not depend on x");
    l.exact = exact_value(*l.formula);
    if (!l.ball().is_finite()) throw ExpressionError(l.formula->column, "'" + l.text + "' is no real number");
    return l;
}

Interval Range::interval() const
{
    switch (map) {
    case Map::finite: return Interval::finite(from.endpoint(), to.endpoint());
    case Map::right_algebraic: return Interval::right_half_line(from.endpoint(), Decay::algebraic);
    case Map::right_exponential: return Interval::right_half_line(from.endpoint(), Decay::exponential);
    case Map::left_algebraic: return Interval::left_half_line(to.endpoint(), Decay::algebraic);
    case Map::left_exponential: return Interval::left_half_line(to.endpoint(), Decay::exponential);
    case Map::line_algebraic: return Interval::whole_line(Decay::algebraic);
    case Map::line_exponential: break;
    }
    return Interval::whole_line(Decay::exponential);
}

Ball evaluate_at(const Expression& e, const Ball& x)
{
    const Place nowhere;
    const auto shared = std::make_shared<const Expression>(e);
    const Point<Ball> p{x, Ball::indeterminate(), Ball::indeterminate(), std::nullopt};
    return compiled::evaluate(*compiled::compile(shared, nowhere), p, nowhere).value();
}

PlainFormula::PlainFormula(const ExpressionPtr& e)
    : root_(compiled::compile(e, Place{}))
{
}

ComplexBall PlainFormula::at(const ComplexBall& z) const
{
    const EndpointNumber<ComplexBall> nowhere(ComplexBall::indeterminate());
    return compiled::evaluate(*root_, Point<ComplexBall>{z, nowhere, nowhere, std::nullopt}, Place{}).value();
}

struct Integrand::Body {
    Range range;
    Place place;
    compiled::NodePtr root;
    double width = 1;
    bool has_inner_integral = false;
    std::optional<RealFormula> straight;

    /// The value at z, as it goes on from that end.
    ComplexBall about(Side side, const ComplexBall& z, const Place& there) const
    {
        const Ball from = range.from.ball(), to = range.to.ball();
        const compiled::Disc<ComplexBall> disc(side, side == Side::left ? z - ComplexBall(from) : ComplexBall(to) - z);
        return compiled::evaluate(*root, compiled::point_about(disc, there), there).value();
    }
};

Integrand::Integrand(const ExpressionPtr& e, Range range)
    : body_(std::make_unique<Body>())
{
    const WorkingPrecision precision(64);
    body_->range = std::move(range);
    body_->place.range = &body_->range;
    body_->root = compiled::compile(e, body_->place);
    body_->has_inner_integral = any_node(*e, [](const Expression& n) { return n.op == Op::integral; });
    body_->straight = RealFormula::of(e);
    if (body_->range.map == Map::finite)
        body_->width = arf_get_d(arb_midref((body_->range.to.ball() - body_->range.from.ball()).get()), ARF_RND_NEAR);
}
Integrand::~Integrand() = default;
Integrand::Integrand(Integrand&&) noexcept = default;

const Range& Integrand::range() const { return body_->range; }
bool Integrand::has_inner_integral() const { return body_->has_inner_integral; }
const RealFormula* Integrand::straight() const { return body_->straight ? &*body_->straight : nullptr; }

EndpointNumber<Ball> Integrand::at(const EndpointNumber<Ball>& x, const EndpointNumber<Ball>& left, const EndpointNumber<Ball>& right) const
{
    return compiled::evaluate(*body_->root, Point<Ball>{x, left, right, body_->place.exp_x(left, right)}, body_->place);
}

EndpointNumber<ComplexBall> Integrand::at(const EndpointNumber<ComplexBall>& x, const EndpointNumber<ComplexBall>& left,
                                          const EndpointNumber<ComplexBall>& right) const
{
    return compiled::evaluate(*body_->root, Point<ComplexBall>{x, left, right, body_->place.exp_x(left, right)}, body_->place);
}

template <class V>
std::array<EndpointNumber<V>, 2> Integrand::both_parts(const EndpointNumber<V>& x, const EndpointNumber<V>& left,
                                                       const EndpointNumber<V>& right) const
{
    return compiled::both_parts(*body_->root, Point<V>{x, left, right, body_->place.exp_x(left, right)}, body_->place);
}
template std::array<EndpointNumber<Ball>, 2> Integrand::both_parts(const EndpointNumber<Ball>&, const EndpointNumber<Ball>&,
                                                                   const EndpointNumber<Ball>&) const;
template std::array<EndpointNumber<ComplexBall>, 2> Integrand::both_parts(const EndpointNumber<ComplexBall>&,
                                                                          const EndpointNumber<ComplexBall>&,
                                                                          const EndpointNumber<ComplexBall>&) const;

ComplexBall Integrand::in_plane(const ComplexBall& z) const { return about_an_end(z, false); }
ComplexBall Integrand::on_the_line(const ComplexBall& z) const { return about_an_end(z, arb_is_zero(acb_imagref(z.get())) != 0); }

ComplexBall Integrand::in_plane_from(std::optional<Side> end, const ComplexBall& z) const
{
    if (end) return body_->about(*end, z, body_->place);
    ComplexBall left = body_->about(Side::left, z, body_->place);
    if (!left.is_finite()) return left;
    ComplexBall right = body_->about(Side::right, z, body_->place);
    return !right.is_finite() || acb_rel_accuracy_bits(right.get()) > acb_rel_accuracy_bits(left.get()) ? right : left;
}

Ball Integrand::at_real(const Ball& x) const
{
    const Ball from_left = x - body_->range.from.ball();
    const bool at_left = arf_get_d(arb_midref(from_left.get()), ARF_RND_NEAR) < body_->width / 2;
    const compiled::Disc<Ball> disc(at_left ? Side::left : Side::right, at_left ? from_left : body_->range.to.ball() - x);
    return compiled::evaluate(*body_->root, compiled::point_about(disc, body_->place), body_->place).value();
}

ComplexBall Integrand::about_an_end(const ComplexBall& z, bool on_the_line) const
{
    Place place = body_->place;
    place.on_the_line = on_the_line;
    const ComplexBall from_left = z - ComplexBall(body_->range.from.ball());
    const double l =
        mag_get_d(arb_radref(acb_realref(from_left.get()))) + std::fabs(arf_get_d(arb_midref(acb_realref(from_left.get())), ARF_RND_NEAR));
    return body_->about(l < body_->width / 2 ? Side::left : Side::right, z, place);
}

bool Integrand::is_regular_at_ends() const
{
    const WorkingPrecision precision(64);
    if (body_->range.map != Map::finite) return false;
    for (const Limit* end : {&body_->range.from, &body_->range.to}) {
        ComplexBall z(end->ball());
        mag_t m;
        mag_init(m);
        mag_set_d(m, body_->width * 1e-4);
        acb_add_error_mag(z.get(), m);
        mag_clear(m);
        if (!in_plane(z).is_finite()) return false;
    }
    return true;
}

namespace {

constexpr std::size_t most_branches = 400;

class Branches {
public:
    Branches(const Limit& from, const Limit& to)
        : from_(from)
        , to_(to)
    {
    }
    void collect(const Expression& e)
    {
        for (const ExpressionPtr& a : e.args) collect(*a);
        switch (e.op) {
        case Op::abs:
        case Op::sign: zeros(*e.args[0]); break;
        case Op::max:
        case Op::min:
            for (std::size_t i = 0; i < e.args.size(); ++i)
                for (std::size_t j = 0; j < i; ++j) zeros(*make(Op::add, {e.args[j], make(Op::negate, {e.args[i]})}));
            break;
        case Op::floor:
        case Op::ceil: steps(*e.args[0]); break;
        default: break;
        }
    }
    std::vector<ExactSum> sorted()
    {
        std::sort(points_.begin(), points_.end(),
                  [](const ExactSum& a, const ExactSum& b) { return arb_is_negative((a - b).ball().get()) != 0; });
        points_.erase(std::unique(points_.begin(), points_.end()), points_.end());
        return points_;
    }

private:
    /// Where a linear argument takes each of the values base + k step.
    void multiples(const Expression& argument, const ExactSum& base, const ExactSum& step)
    {
        const auto p = polynomial(argument);
        if (!p || p->size() != 2 || !(*p)[0].is_real() || !(*p)[1].is_real() || from_.infinite || to_.infinite) return;
        const auto slope = (*p)[1].inverse(), over = step.inverse();
        if (!slope || !over) return;
        const auto index = [&](const Limit& end) { // within 1 of it, however far out
            constexpr slong most_bits = 1 << 16;
            Ball v;
            for (slong bits = WorkingPrecision::bits(); bits <= most_bits; bits *= 2) {
                const WorkingPrecision precision(bits);
                v = ((*p)[1].ball() * end.ball() + (*p)[0].ball() - base.ball()) / step.ball();
                if (v.is_finite() && v.radius_bound() < 0.5) return v;
            }
            return Ball::indeterminate();
        };
        const Ball a = index(from_), b = index(to_);
        const WorkingPrecision precision(std::max<slong>(WorkingPrecision::bits(), arb_bits(a.get()) + arb_bits(b.get())));
        if (!certainly(less(abs(b - a), Ball(static_cast<long>(most_branches)))))
            throw DomainError("the formula has more than " + std::to_string(most_branches) +
                              " branches on the interval: integrate it in parts");
        const bool rises = arf_cmp(arb_midref(a.get()), arb_midref(b.get())) <= 0;
        const Rational last = floor_of_middle(rises ? b : a) + 2;
        for (Rational k = floor_of_middle(rises ? a : b) - 1; k <= last; k += 1) add((base + ExactSum(k) * step - (*p)[0]) * *slope);
    }
    void steps(const Expression& argument)
    {
        if (argument.op == Op::max || argument.op == Op::min)
            for (const ExpressionPtr& a : argument.args) steps(*a);
        else
            multiples(argument, ExactSum(0), ExactSum(1));
    }
    void zeros(const Expression& e)
    {
        if (e.op == Op::multiply || e.op == Op::divide) {
            for (const ExpressionPtr& a : e.args) zeros(*a);
            return;
        }
        if (e.op == Op::power || e.op == Op::sqrt || e.op == Op::negate) return zeros(*e.args[0]);
        if (e.op == Op::sin || e.op == Op::tan) return multiples(*e.args[0], ExactSum(0), ExactSum::pi());
        if (e.op == Op::cos) return multiples(*e.args[0], ExactSum(Rational(1, 2)) * ExactSum::pi(), ExactSum::pi());
        if (e.op == Op::log) return zeros(*make(Op::add, {e.args[0], make_number(Rational(-1))}));
        const auto p = polynomial(e);
        if (!p) return;
        if (p->size() == 2) {
            if (const auto slope = (*p)[1].inverse()) add(-(*p)[0] * *slope);
        }
        else if (p->size() == 3) {
            const auto twice = (ExactSum(2) * (*p)[2]).inverse();
            const ExactSum discriminant = (*p)[1] * (*p)[1] - ExactSum(4) * (*p)[2] * (*p)[0];
            const auto root = discriminant.sqrt();
            if (!twice || !root) return;
            add((*root - (*p)[1]) * *twice);
            add((-*root - (*p)[1]) * *twice);
        }
    }
    void add(const ExactSum& x)
    {
        const auto beyond = [&](const Limit& end, bool right) {
            if (end.infinite) return true;
            const Ball gap = end.exact ? (*end.exact - x).ball() : end.ball() - x.ball();
            return (right ? arb_is_positive(gap.get()) : arb_is_negative(gap.get())) != 0;
        };
        if (!beyond(from_, false) || !beyond(to_, true)) return;
        points_.push_back(x);
        if (points_.size() > 2 * most_branches)
            throw DomainError("the formula has too many branches on the interval: integrate it in parts");
    }

    const Limit &from_, &to_;
    std::vector<ExactSum> points_;
};

} // namespace

std::vector<ExactSum> branch_points(const Expression& e, const Limit& from, const Limit& to)
{
    const WorkingPrecision precision(256);
    Branches b(from, to);
    b.collect(e);
    return b.sorted();
}

} // namespace touchstone::quadrature
