// SPDX-License-Identifier: MIT
#include "touchstone/quadrature/real_formula.hpp"

#include "touchstone/quadrature/elliptic.hpp"
#include "touchstone/quadrature/exact_series.hpp"

#include <unordered_map>

namespace touchstone::quadrature {

namespace {

/// y = f(x) of arb's functions of one argument, which are NaN where no real value is.
using RealFunction = void (*)(arb_t, const arb_t, slong);

Ball one_minus(const arb_t m, slong bits)
{
    Ball v;
    arb_sub_si(v.get(), m, 1, bits);
    return -v;
}
void first_kind(arb_t y, const arb_t m, slong bits) { arb_set(y, first_kind_of_complement(one_minus(m, bits)).get()); }
void second_kind(arb_t y, const arb_t m, slong bits) { arb_set(y, elliptic_of_complement(one_minus(m, bits)).e.get()); }

RealFunction function_of(Op op)
{
    switch (op) {
    case Op::sqrt: return arb_sqrt;
    case Op::exp: return arb_exp;
    case Op::log: return arb_log;
    case Op::sin: return arb_sin;
    case Op::cos: return arb_cos;
    case Op::tan: return arb_tan;
    case Op::sinh: return arb_sinh;
    case Op::cosh: return arb_cosh;
    case Op::tanh: return arb_tanh;
    case Op::asin: return arb_asin;
    case Op::acos: return arb_acos;
    case Op::atan: return arb_atan;
    case Op::asinh: return arb_asinh;
    case Op::acosh: return arb_acosh;
    case Op::atanh: return arb_atanh;
    case Op::expm1: return arb_expm1;
    case Op::log1p: return arb_log1p;
    case Op::elliptic_k: return first_kind;
    case Op::elliptic_e: return second_kind;
    default: return nullptr;
    }
}

/// x^(n/d): x may be negative or zero where d is 1, and must be positive, or for d = 2 and n > 0 not negative, elsewhere.
void set_power(Ball& y, const Ball& x, long n, long d, slong bits)
{
    if (d == 1 || d == 2) {
        if (d == 2) arb_sqrt(y.get(), x.get(), bits);
        else arb_set(y.get(), x.get());
        const auto size = static_cast<ulong>(std::labs(n));
        if (size == 0 && !y.is_finite()) return; // of what has no value there is no power
        if (size == 2) arb_sqr(y.get(), y.get(), bits);
        else if (size != 1) arb_pow_ui(y.get(), y.get(), size, bits);
        if (n < 0) arb_inv(y.get(), y.get(), bits);
        return;
    }
    arb_log(y.get(), x.get(), bits);
    arb_mul_si(y.get(), y.get(), n, bits);
    arb_div_si(y.get(), y.get(), d, bits);
    arb_exp(y.get(), y.get(), bits);
}

} // namespace

/// Values in the order they are needed; equal parts of a formula, one and the same node, once.
class RealFormula::Builder {
public:
    std::vector<Step> steps;

    /// The number of the value, none if it cannot be had.
    std::optional<std::size_t> value_of(const ExpressionPtr& e)
    {
        if (const auto known = done_.find(e.get()); known != done_.end()) return known->second;
        const auto found = depends_on_x(*e) ? of_x(e) : constant(e);
        if (found) done_.emplace(e.get(), *found);
        return found;
    }

private:
    std::optional<std::size_t> constant(const ExpressionPtr& e)
    {
        if (!is_real(*e) || has_complex_point(*e)) return std::nullopt;
        return add({.op = Op::number, .constant = e});
    }
    std::optional<std::size_t> of_x(const ExpressionPtr& e)
    {
        if (e->op == Op::variable) return 0;
        if (e->op == Op::power) return power(e);
        if (e->op == Op::add || e->op == Op::multiply || e->op == Op::divide) return folded(e);
        if (e->op != Op::negate && function_of(e->op) == nullptr) return std::nullopt;
        const auto argument = value_of(e->args[0]);
        return argument ? add({.op = e->op, .first = *argument}) : std::nullopt;
    }
    std::optional<std::size_t> power(const ExpressionPtr& e)
    {
        if (!depends_on_x(*e->args[0])) {
            const ExpressionPtr by_log = make(Op::multiply, {e->args[1], make(Op::log, {e->args[0]})});
            const ExpressionPtr exponential = make(Op::exp, {e->args[0]->op == Op::e ? e->args[1] : by_log});
            alive_.push_back(exponential); // and no reference into alive_, which grows where powers stand in the exponent
            return value_of(exponential);
        }
        const auto base = value_of(e->args[0]);
        const auto exact = depends_on_x(*e->args[1]) ? std::nullopt : exact_value(*e->args[1]);
        const auto exponent = exact ? exact->rational() : std::nullopt;
        if (!base || !exponent || !exponent->get_num().fits_slong_p() || !exponent->get_den().fits_slong_p()) return std::nullopt;
        return add(
            {.op = Op::power, .first = *base, .numerator = exponent->get_num().get_si(), .denominator = exponent->get_den().get_si()});
    }
    std::optional<std::size_t> folded(const ExpressionPtr& e)
    {
        auto total = value_of(e->args[0]);
        for (std::size_t k = 1; k < e->args.size() && total; ++k) {
            const auto next = value_of(e->args[k]);
            total = next ? add({.op = e->op, .first = *total, .second = *next}) : std::nullopt;
        }
        return total;
    }
    std::optional<std::size_t> add(Step step)
    {
        constexpr std::size_t most = 1000; // of a formula that is worth it
        if (steps.size() == most) return std::nullopt;
        steps.push_back(std::move(step));
        return steps.size();
    }

    std::unordered_map<const Expression*, std::size_t> done_;
    std::vector<ExpressionPtr> alive_; // what done_ points to beside parts of the formula
};

std::optional<RealFormula> RealFormula::of(const ExpressionPtr& e)
{
    Builder builder;
    const auto last = builder.value_of(e);
    if (!last || *last != builder.steps.size() || *last == 0) return std::nullopt; // x alone, or a part that came before
    RealFormula f;
    f.steps_ = std::move(builder.steps);
    f.values_.resize(f.steps_.size() + 1);
    return f;
}

namespace {
/// What is kept to so many bits and must have more is given some for the next who asks.
slong enough_bits(slong kept, slong wanted)
{
    constexpr slong step = 64;
    return kept == 0 ? wanted : std::max(wanted, kept + step);
}
}

/// Constants to the working precision at least.
void RealFormula::prepare() const
{
    if (bits_ >= WorkingPrecision::bits()) return;
    const WorkingPrecision precision(enough_bits(bits_, WorkingPrecision::bits()));
    bits_ = 0; // a constant that is refused by an exception is asked for again
    for (std::size_t k = 0; k < steps_.size(); ++k)
        if (steps_[k].op == Op::number) values_[k + 1] = evaluate_at(*steps_[k].constant, Ball(0));
    bits_ = WorkingPrecision::bits();
}

const Ball& RealFormula::at(const Ball& x) const
{
    prepare();
    const slong bits = WorkingPrecision::bits();
    values_[0] = x;
    for (std::size_t k = 0; k < steps_.size(); ++k) {
        const Step& s = steps_[k];
        const Ball &a = values_[s.first], &b = values_[s.second];
        Ball& y = values_[k + 1];
        switch (s.op) {
        case Op::number: break; // prepared
        case Op::add: arb_add(y.get(), a.get(), b.get(), bits); break;
        case Op::multiply: arb_mul(y.get(), a.get(), b.get(), bits); break;
        case Op::divide: arb_div(y.get(), a.get(), b.get(), bits); break;
        case Op::negate: arb_neg(y.get(), a.get()); break;
        case Op::power: set_power(y, a, s.numerator, s.denominator, bits); break;
        default: function_of(s.op)(y.get(), a.get(), bits);
        }
    }
    return values_.back();
}

namespace {
constexpr slong spare_bits = 48; // may cancel
constexpr slong lost_bits = 6;   // that every value may be off by
constexpr slong few_spare_bits = 8;   // where those that an end takes are counted
constexpr slong most_taken_bits = 64; // beyond the working precision
}

StraightValues::StraightValues(const RealFormula& formula, const Range& range)
    : formula_(formula)
    , range_(range)
{
}

void StraightValues::prepare()
{
    if (bits_ >= WorkingPrecision::bits()) return;
    const WorkingPrecision precision(enough_bits(bits_, WorkingPrecision::bits()));
    bits_ = WorkingPrecision::bits();
    from_ = range_.from.ball();
    to_ = range_.to.ball();
    width_ = to_ - from_;
    twice_width_ = width_ + width_;
    middle_ = (from_ + to_) / Ball(2);
    half_ = width_ / Ball(2);
}

/// At x_, if it has as many bits but for a few.
std::optional<Ball> StraightValues::value(slong bits) const
{
    const Ball& y = formula_.at(x_);
    if (!y.is_finite() || arb_rel_accuracy_bits(y.get()) < bits - lost_bits) return std::nullopt;
    return y;
}

std::optional<Ball> StraightValues::in_angle(const Ball& sine, const Ball& cosine)
{
    const slong bits = WorkingPrecision::bits();
    const WorkingPrecision precision(bits + spare_bits);
    prepare();
    const bool from_left = arf_cmpabs(arb_midref(sine.get()), arb_midref(cosine.get())) < 0; // where the nearer end is
    x_ = from_left ? sine : cosine;
    arb_sqr(x_.get(), x_.get(), WorkingPrecision::bits());
    x_ *= width_;
    if (from_left) x_ += from_;
    else arb_sub(x_.get(), to_.get(), x_.get(), WorkingPrecision::bits());
    auto y = value(bits);
    if (y) ((*y *= twice_width_) *= sine) *= cosine;
    return y;
}

std::optional<Ball> StraightValues::on_the_line(const Ball& z, bool mirrored)
{
    const slong bits = WorkingPrecision::bits();
    const WorkingPrecision precision(bits + spare_bits);
    prepare();
    x_ = half_;
    x_ *= z;
    if (mirrored) arb_neg(x_.get(), x_.get());
    x_ += middle_;
    return value(bits);
}

std::optional<Ball> StraightValues::in_fraction(const Ball& z, bool mirrored)
{
    auto y = on_the_line(z, mirrored);
    if (y) *y *= width_;
    return y;
}

void StraightValues::prepare_part(const Rational& from, const Rational& to)
{
    if (part_.bits == WorkingPrecision::bits() && part_.from == from && part_.to == to) return;
    part_ = {from, to, Ball(to - from), Ball(from + to - 1), WorkingPrecision::bits()};
}

std::optional<Ball> StraightValues::in_part(const Rational& from, const Rational& to, const Ball& z, bool mirrored)
{
    Ball of_the_range;
    {
        const WorkingPrecision precision(WorkingPrecision::bits() + spare_bits);
        prepare_part(from, to);
        of_the_range = part_.share * z;
        if (mirrored) arb_neg(of_the_range.get(), of_the_range.get());
        of_the_range += part_.place;
    }
    auto y = in_fraction(of_the_range, false);
    if (y) *y *= part_.share;
    return y;
}

std::optional<Ball> StraightValues::beside(Side end, const Ball& fraction)
{
    const slong bits = WorkingPrecision::bits();
    const Limit& nearest = end == Side::left ? range_.from : range_.to;
    const bool is_at_zero = nearest.exact && nearest.exact->is_zero();
    const slong taken = is_at_zero ? 0 : std::max<slong>(0, -arf_abs_bound_lt_2exp_si(arb_midref(fraction.get()))); // by the end's own size
    if (taken > most_taken_bits + bits) return std::nullopt;
    const WorkingPrecision precision(bits + few_spare_bits + taken);
    prepare();
    x_ = width_;
    x_ *= fraction;
    if (end == Side::left) x_ += from_;
    else arb_sub(x_.get(), to_.get(), x_.get(), WorkingPrecision::bits());
    auto y = value(bits);
    if (y) *y *= width_;
    return y;
}

} // namespace touchstone::quadrature
