// SPDX-License-Identifier: MIT
#include "touchstone/quadrature/interval.hpp"

#include "touchstone/quadrature/upper.hpp"

namespace touchstone::quadrature {
namespace {

/// b - a to the working precision, by as many more bits as cancel: ends that are balls have no more.
Ball difference(const Endpoint& a, const Endpoint& b)
{
    if (a.exact() && b.exact()) return Ball(Rational(*b.exact() - *a.exact()));
    constexpr slong spare = 8, most_bits = 1 << 14;
    const slong bits = WorkingPrecision::bits();
    Ball width = b.ball() - a.ball();
    for (slong more = 2 * bits; width.is_finite() && width.relative_bits() < bits - spare && more <= most_bits; more *= 2) {
        const WorkingPrecision precision(more);
        const Ball sharper = b.ball() - a.ball(), twice = radius_of(sharper) * Ball(2);
        if (!arb_lt(twice.get(), radius_of(width).get())) break;
        width = sharper;
    }
    Ball rounded;
    arb_set_round(rounded.get(), width.get(), bits);
    return rounded;
}

} // namespace

void Interval::prepare()
{
    start_ = a_.ball();
    end_ = b_.ball();
    width_ = difference(a_, b_);
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
    case Kind::ray_exponential:
        return (mirrored_ ? "(-oo, " + text(a_) + "]" : "[" + text(a_) + ", oo)") +
               (kind_ == Kind::ray_algebraic ? " algebraic" : " exponential");
    case Kind::line_algebraic: return "(-oo, oo) algebraic";
    case Kind::line_exponential: return "(-oo, oo) exponential";
    }
    return {};
}

} // namespace touchstone::quadrature
