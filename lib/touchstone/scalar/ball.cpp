// SPDX-License-Identifier: MIT
#include "touchstone/scalar/ball.hpp"

#include <cstdlib>
#include <memory>
#include <ostream>

namespace touchstone {
namespace {

/// fmpq_t with a lifetime.
class FlintRational {
public:
    explicit FlintRational(const Rational& r) { fmpq_init(q_); fmpq_set_mpq(q_, r.get_mpq_t()); }
    ~FlintRational() { fmpq_clear(q_); }
    FlintRational(const FlintRational&) = delete;
    FlintRational& operator=(const FlintRational&) = delete;
    const fmpq* get() const { return q_; }

private:
    fmpq_t q_;
};

/// Text that Arb allocated with malloc.
std::string owned(char* text)
{
    const std::unique_ptr<char, decltype(&std::free)> guard(text, &std::free);
    return std::string(guard.get());
}

} // namespace

Ball::Ball(const Rational& r)
{
    arb_init(x_);
    arb_set_fmpq(x_, FlintRational(r).get(), WorkingPrecision::bits());
}

bool Ball::contains(const Rational& r) const
{
    return arb_contains_fmpq(x_, FlintRational(r).get()) != 0;
}

std::string Ball::to_string(long digits) const { return owned(arb_get_str(x_, digits, ARB_STR_MORE)); }

std::string Ball::dump() const { return owned(arb_dump_str(x_)); }

Ball Ball::parse(const std::string& dumped)
{
    Ball b;
    if (arb_load_str(b.get(), dumped.c_str()) != 0) return indeterminate();
    return b;
}

Ball at_most(const Ball& x, const Ball& bound)
{
    if (arb_ge(x.get(), bound.get())) return bound; // itself, not a ball around it
    return arb_le(x.get(), bound.get()) ? x : detail::ball_of(arb_min, x, bound);
}

Ball at_least(const Ball& x, const Ball& bound)
{
    if (arb_le(x.get(), bound.get())) return bound;
    return arb_ge(x.get(), bound.get()) ? x : detail::ball_of(arb_max, x, bound);
}

ComplexBall atan2(const ComplexBall& y, const ComplexBall& x)
{
    return detail::complex_ball_of(acb_atan, y / x);
}

std::ostream& operator<<(std::ostream& out, const Ball& b) { return out << b.to_string(); }

} // namespace touchstone
