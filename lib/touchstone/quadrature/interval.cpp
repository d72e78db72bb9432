// SPDX-License-Identifier: MIT
#include "touchstone/quadrature/interval.hpp"

namespace touchstone::quadrature {

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
    case Kind::ray_exponential:
        return (mirrored_ ? "(-oo, " + text(a_) + "]" : "[" + text(a_) + ", oo)") +
               (kind_ == Kind::ray_algebraic ? " algebraic" : " exponential");
    case Kind::line_algebraic: return "(-oo, oo) algebraic";
    case Kind::line_exponential: return "(-oo, oo) exponential";
    }
    return {};
}

} // namespace touchstone::quadrature
