// SPDX-License-Identifier: MIT
#include "touchstone/quadrature/compiled.hpp"
#include "touchstone/quadrature/expression_tree.hpp"
#include "touchstone/quadrature/far_out.hpp"
#include "touchstone/quadrature/inner_integral.hpp"
#include "touchstone/quadrature/substitution.hpp"
#include "touchstone/quadrature/zeros.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace touchstone::quadrature::compiled {
using namespace tree;

namespace {

class Compiler {
public:
    explicit Compiler(const Place& place)
        : place_(place)
    {
        for (const Side s : {Side::left, Side::right})
            if (has_range() && end(s)) expansions_[s == Side::left ? 0 : 1].emplace(*end(s), s == Side::left ? 1 : -1);
    }
    NodePtr compile(const ExpressionPtr& e) const;
    /// To be told of the whole formula first: the zeros of sinc are needed only beneath what is singular where its argument vanishes.
    void look_for_sinc_with_zeros(const Expression& e, bool beneath_singular);

private:
    NodePtr compiled_anew(const ExpressionPtr& e) const;
    std::optional<ExactSeries> expanded(const ExpressionPtr& e, Side s) const { return expansions_[s == Side::left ? 0 : 1]->of(e); }
    NodePtr by_operation(const ExpressionPtr& e) const;
    NodePtr power(const ExpressionPtr& base, const ExpressionPtr& exponent) const;
    NodePtr exponential(const ExpressionPtr& argument) const;
    NodePtr without_branch(const ExpressionPtr& e) const;
    NodePtr node(Kind kind, const std::vector<ExpressionPtr>& args, Op op = Op::number) const;
    NodePtr constant(const ExactSum& c) const;
    NodePtr factored(const Polynomial& p) const;
    std::optional<ExpressionPtr> rewritten(const Expression& e) const;
    NodePtr part_of(const ExpressionPtr& e) const;
    void find_zeros(Node& n, const ExpressionPtr& e) const;
    /// The end as an exact number, if it is finite and one.
    const std::optional<ExactSum>& end(Side s) const { return s == Side::left ? place_.range->from.exact : place_.range->to.exact; }
    bool has_range() const { return place_.range != nullptr; }
    bool is_infinite() const { return has_range() && place_.range->map != Map::finite; }
    bool reaches_one(const ExpressionPtr& e) const;
    bool tends_to_one(const ExpressionPtr& e) const;
    ExpressionPtr less_than_one(const ExpressionPtr& e) const;
    std::optional<long> zero_of_sine(const Polynomial& argument, Side s, const ExactSum& first) const;
    std::optional<ExpressionPtr> about_its_zero(const Expression& e) const;
    NodePtr logarithm(const ExpressionPtr& argument) const;
    NodePtr logarithm_near_one(const ExpressionPtr& argument) const;
    int sign_of_linear(const Expression& e) const;
    bool rises_far_out(const Expression& e) const;
    bool vanishes_at_most_at_the_end(const ExpressionPtr& e) const;
    ExpressionPtr settled(const ExpressionPtr& e) const;
    static bool is_zero(const Expression& e);

    Place place_;
    mutable std::array<std::optional<Expansions>, 2> expansions_; // about the ends that are exact
    std::unordered_map<const Expression*, bool> beneath_singular_; // whether a part is, of the whole formula
    mutable std::unordered_map<const Expression*, NodePtr> done_;
    mutable std::vector<ExpressionPtr> alive_; // what done_ points to
};

void Compiler::look_for_sinc_with_zeros(const Expression& e, bool beneath_singular)
{
    const auto [known, is_new] = beneath_singular_.emplace(&e, beneath_singular);
    if (!is_new && (known->second || !beneath_singular)) return;
    known->second = beneath_singular;
    for (std::size_t k = 0; k < e.args.size(); ++k) {
        const bool entire = e.op == Op::add || e.op == Op::multiply || e.op == Op::negate || e.op == Op::exp || e.op == Op::sin ||
                            e.op == Op::cos || (e.op == Op::divide && k == 0);
        look_for_sinc_with_zeros(*e.args[k], beneath_singular || !entire);
    }
}

NodePtr Compiler::constant(const ExactSum& c) const
{
    auto n = std::make_unique<Node>();
    n->exact = c;
    return n;
}

NodePtr Compiler::node(Kind kind, const std::vector<ExpressionPtr>& args, Op op) const
{
    auto n = std::make_unique<Node>();
    n->kind = kind;
    n->op = op;
    for (const ExpressionPtr& a : args) n->args.push_back(compile(a));
    return n;
}

/// p with its zeros at the ends taken out, exactly: (x - a)^m (b - x)^n q(x); n is negative where a half-line's distance divides it.
NodePtr Compiler::factored(const Polynomial& p) const
{
    auto n = std::make_unique<Node>();
    n->kind = Kind::factored;
    n->rest = p;
    for (const Side s : {Side::left, Side::right}) {
        if (!end(s)) continue;
        while (n->rest.size() > 1 && value(n->rest, *end(s)).is_zero()) {
            n->rest = without_root(n->rest, *end(s));
            if (s == Side::right) // b - x, not x - b
                for (ExactSum& c : n->rest) c = -c;
            ++n->order[s == Side::left ? 0 : 1];
        }
    }
    // on an algebraic half-line the far distance is 1/(1 + x - a), or 1/(1 + b - x)
    const auto take_out = [&](const ExactSum& root, std::size_t far, bool turned) {
        while (n->rest.size() > 1 && value(n->rest, root).is_zero()) {
            n->rest = without_root(n->rest, root);
            if (turned)
                for (ExactSum& c : n->rest) c = -c;
            --n->order[far];
        }
    };
    if (place_.range->map == Map::right_algebraic && end(Side::left)) take_out(*end(Side::left) - ExactSum(1), 1, false);
    if (place_.range->map == Map::left_algebraic && end(Side::right)) take_out(*end(Side::right) + ExactSum(1), 0, true);
    return n->order[0] != 0 || n->order[1] != 0 ? std::move(n) : nullptr;
}

/// Whether e is 1 or -1 at an end of the range: as 1 - sqrt(x) is, which has no expansion, by what its distance to them is.
bool Compiler::reaches_one(const ExpressionPtr& e) const
{
    const ExpressionPtr one = number(1), below = with_numbers_collected(difference(one, e)), above = with_numbers_collected(sum(one, e));
    for (const Side s : {Side::left, Side::right}) {
        if (!has_range() || !end(s)) continue;
        for (const ExpressionPtr& distance : {below, above})
            if (const auto series = expanded(distance, s); series && (series->is_exactly_zero || series->valuation > 0)) return true;
    }
    return tends_to_one(e);
}

/// Whether e may tend to 1 at an infinite end: what less_one gives vanishes there in powers of 1/x, or in another way.
bool Compiler::tends_to_one(const ExpressionPtr& e) const
{
    const ExpressionPtr v = is_infinite() ? less_one(e) : nullptr;
    if (!v) return false;
    const auto tends = [&](int direction) {
        const auto series = expand(*substituted(v, quotient(number(direction), make_variable())), ExactSum(0), 1);
        return !series || series->is_exactly_zero || series->valuation > 0;
    };
    const Map map = place_.range->map;
    const bool right_only = map == Map::right_algebraic || map == Map::right_exponential;
    const bool left_only = map == Map::left_algebraic || map == Map::left_exponential;
    return (!left_only && tends(1)) || (!right_only && tends(-1));
}

/// 1 - e, with the zero that it has far out.
ExpressionPtr Compiler::less_than_one(const ExpressionPtr& e) const
{
    const ExpressionPtr v = is_infinite() ? less_one(e) : nullptr;
    return v ? of(Op::negate, v) : difference(number(1), e);
}

/// m, if the argument is first + m pi at the end.
std::optional<long> Compiler::zero_of_sine(const Polynomial& argument, Side s, const ExactSum& first) const
{
    if (!end(s)) return std::nullopt;
    const auto m = (value(argument, *end(s)) - first).times_pi();
    return m && m->get_den() == 1 && m->get_num().fits_sint_p() ? std::optional(m->get_num().get_si()) : std::nullopt;
}

/// A sine or cosine of a linear argument that vanishes at an end where its argument does not: as the sine of one that does, and as the
/// product sin y = 2 sin(y/2) sin((pi - y)/2) where the range is half a period, so that neither end asks for an expansion.
std::optional<ExpressionPtr> Compiler::about_its_zero(const Expression& e) const
{
    const auto p = polynomial(*e.args[0]);
    if (!has_range() || place_.range->map != Map::finite || !p || p->size() != 2 || !(*p)[0].is_real() || !(*p)[1].is_real())
        return std::nullopt;
    const ExactSum first = e.op == Op::cos ? ExactSum(Rational(-1, 2)) * ExactSum::pi() : ExactSum(0); // cos y = sin(y + pi/2)
    const auto left = zero_of_sine(*p, Side::left, first), right = zero_of_sine(*p, Side::right, first);
    if (!left && !right) return std::nullopt;
    const bool half_period = left && right && std::labs(left.value() - right.value()) == 1;
    if (e.op == Op::sin && !half_period && (left ? *left : *right) == 0) return std::nullopt; // it shows as it is
    const auto formula = [](const Polynomial& q) { return sum(product(formula_of(q[1]), make_variable()), formula_of(q[0])); };
    // y, which is 0 at one end, with its sine times `sign`
    const long m = left ? *left : *right;
    Polynomial y{(*p)[0] - first - ExactSum(m) * ExactSum::pi(), (*p)[1]};
    long sign = m % 2 == 0 ? 1 : -1;
    if (!half_period) return sign == 1 ? of(Op::sin, formula(y)) : of(Op::negate, of(Op::sin, formula(y)));
    if (*right < *left) {
        y = {-y[0], -y[1]};
        sign = -sign;
    }
    const ExactSum half(Rational(1, 2));
    const Polynomial near{y[0] * half, y[1] * half}, far{half * ExactSum::pi() - near[0], -near[1]};
    return product(number(2 * sign), product(of(Op::sin, formula(near)), of(Op::sin, formula(far))));
}

/// log of the fraction that the distance to one end is of the range: its zero at the other end shows. log(1/y) is -log(y).
NodePtr Compiler::logarithm(const ExpressionPtr& argument) const
{
    const bool is_inverse = argument->op == Op::divide && argument->args[0]->op == Op::number && argument->args[0]->number == 1;
    if (is_inverse && sign_of_linear(*argument->args[1]) == 1) return compile(of(Op::negate, of(Op::log, argument->args[1])));
    const auto p = has_range() && place_.range->map == Map::finite ? polynomial(*argument) : std::nullopt;
    if (!p || p->size() != 2 || !end(Side::left) || !end(Side::right)) return nullptr;
    const ExactSum at_left = value(*p, *end(Side::left)), at_right = value(*p, *end(Side::right)), one(1);
    const bool from_left = at_left.is_zero() && at_right == one, from_right = at_right.is_zero() && at_left == one;
    if (!from_left && !from_right) return nullptr;
    auto n = std::make_unique<Node>();
    n->kind = Kind::logarithm_of_fraction;
    n->rest = {from_left ? (*p)[1] : -(*p)[1]}; // 1 over the range's length
    n->order = {from_left ? 1 : 0, from_left ? 0 : 1};
    return n;
}

/// On a range without end, where no expansion finds the zero that log(1 + v) has with v.
NodePtr Compiler::logarithm_near_one(const ExpressionPtr& argument) const
{
    const ExpressionPtr v = is_infinite() ? less_one(argument) : nullptr;
    return v ? node(Kind::logarithm_near_one, {argument, v}) : nullptr;
}

/// By what the function is replaced so that its behaviour at the ends shows.
std::optional<ExpressionPtr> Compiler::rewritten(const Expression& e) const
{
    if (e.args.size() != 1) return std::nullopt;
    const ExpressionPtr& a = e.args[0];
    const ExpressionPtr one = number(1), two = number(2);
    const auto below = [&] { return of(Op::sqrt, less_than_one(a)); };
    const auto above = [&] { return of(Op::sqrt, sum(one, a)); };
    const auto both_exponentials = [&](bool minus) {
        const ExpressionPtr up = of(Op::exp, a), down = of(Op::exp, of(Op::negate, a));
        return minus ? difference(up, down) : sum(up, down);
    };
    const bool rises = rises_far_out(*a); // else the argument falls, and tanh and sech are written with that sign
    const auto falling = [&](const ExpressionPtr& rate) { return of(Op::exp, product(rate, rises ? of(Op::negate, a) : a)); };
    switch (e.op) {
    case Op::sin:
    case Op::cos: return about_its_zero(e);
    case Op::tan: return quotient(of(Op::sin, a), of(Op::cos, a));
    case Op::cot: return quotient(of(Op::cos, a), of(Op::sin, a));
    case Op::sec: return quotient(one, of(Op::cos, a));
    case Op::csc: return quotient(one, of(Op::sin, a));
    case Op::coth: return quotient(of(Op::cosh, a), of(Op::sinh, a));
    case Op::csch: return quotient(one, of(Op::sinh, a));
    case Op::sinc: // far out the sine has a bound
        return is_infinite() && vanishes_at_most_at_the_end(a) ? std::optional(quotient(of(Op::sin, a), a)) : std::nullopt;
    case Op::sinh: return is_infinite() ? std::optional(quotient(both_exponentials(true), two)) : std::nullopt;
    case Op::cosh: return is_infinite() ? std::optional(quotient(both_exponentials(false), two)) : std::nullopt;
    case Op::tanh: {
        if (!is_infinite()) return std::nullopt;
        const ExpressionPtr size = quotient(difference(one, falling(two)), sum(one, falling(two)));
        return rises ? size : of(Op::negate, size);
    }
    case Op::sech: return is_infinite() ? std::optional(quotient(product(two, falling(one)), sum(one, falling(two)))) : std::nullopt;
    case Op::expm1: return difference(of(Op::exp, a), one);
    case Op::log1p: return of(Op::log, sum(one, a));
    case Op::acos: // cos t = a: tan(t/4) = sqrt(1 - a)/(sqrt 2 + sqrt(1 + a))
        if (!reaches_one(a)) return std::nullopt;
        return product(number(4), of(Op::atan, quotient(below(), sum(of(Op::sqrt, two), above()))));
    case Op::asin: // sin t = a: tan(t/2) = a/(1 + cos t)
        if (!reaches_one(a)) return std::nullopt;
        return product(two, of(Op::atan, quotient(a, sum(one, product(below(), above())))));
    case Op::elliptic_k:
    case Op::elliptic_e:
        if (!reaches_one(a)) return std::nullopt;
        return of(e.op == Op::elliptic_k ? Op::elliptic_k_of_complement : Op::elliptic_e_of_complement, less_than_one(a));
    case Op::acosh:
        if (!reaches_one(a)) return std::nullopt;
        return product(two, of(Op::asinh, of(Op::sqrt, quotient(of(Op::negate, less_than_one(a)), two))));
    case Op::atanh:
        if (!reaches_one(a)) return std::nullopt;
        return quotient(difference(of(Op::log, sum(one, a)), of(Op::log, less_than_one(a))), two);
    default: return std::nullopt;
    }
}

/// Re and conj of what is real are what it is, Im is 0 where that has a value: sqrt(x^2 - 1) has none on (0, 1). |f|^2 = f f*.
NodePtr Compiler::part_of(const ExpressionPtr& e) const
{
    const ExpressionPtr& a = e->args[0];
    if (e->op == Op::abs) return power(of(Op::real_part, product(a, of(Op::conjugate, a))), make_number(Rational(1, 2)));
    const bool of_value = e->op == Op::real_value || e->op == Op::imaginary_value;
    const bool imaginary = e->op == Op::imaginary_part || e->op == Op::imaginary_value;
    if (is_real(*a) && !(of_value && has_complex_point(*a))) return compile(imaginary ? product(make_number(0), a) : a);
    return node(e->op == Op::conjugate ? Kind::conjugate : imaginary ? Kind::imaginary_part : Kind::real_part, {a}, e->op);
}

/// exp(k x + c), k rational, is a power of exp(x).
NodePtr Compiler::exponential(const ExpressionPtr& argument) const
{
    const bool logarithmic = has_range() && (place_.range->map == Map::right_exponential || place_.range->map == Map::left_exponential ||
                                             place_.range->map == Map::line_exponential);
    const auto p = logarithmic ? polynomial(*argument) : std::nullopt;
    const auto slope = p && p->size() == 2 ? (*p)[1].rational() : std::nullopt;
    if (!slope) return node(Kind::function, {argument}, Op::exp);
    auto n = std::make_unique<Node>();
    n->kind = Kind::exponential;
    n->exponent = Exponent(*slope);
    if ((*p)[0].is_zero()) return n;
    auto whole = std::make_unique<Node>();
    whole->kind = Kind::multiply;
    whole->args.push_back(std::move(n));
    auto factor = std::make_unique<Node>();
    factor->kind = Kind::function;
    factor->op = Op::exp;
    factor->args.push_back(constant((*p)[0]));
    whole->args.push_back(std::move(factor));
    return whole;
}

NodePtr Compiler::power(const ExpressionPtr& base, const ExpressionPtr& exponent) const
{
    if (!depends_on_x(*exponent)) {
        const auto exact = exact_value(*exponent);
        if (const auto q = exact ? exact->rational() : std::nullopt) {
            NodePtr n = node(Kind::power, {base});
            n->exponent = Exponent(*q);
            return n;
        }
        if (const auto a = exact && !exact->is_real() ? exact->real().rational() : std::nullopt) // z^(a + ib) = z^a exp(ib log z)
            return compile(product(make(Op::power, {base, make_number(*a)}),
                                   of(Op::exp, product(difference(exponent, make_number(*a)), of(Op::log, base)))));
        if (depends_on_x(*base)) return node(Kind::ball_power, {base, exponent});
    }
    if (base->op == Op::e) return compile(of(Op::exp, exponent));
    if (!depends_on_x(*base)) return compile(of(Op::exp, product(exponent, of(Op::log, base))));
    return node(Kind::general_power, {base, exponent});
}

/// Whether it is the polynomial 0, as x - x is.
bool Compiler::is_zero(const Expression& e)
{
    const auto p = polynomial(e);
    return p && std::all_of(p->begin(), p->end(), [](const ExactSum& c) { return c.is_zero(); });
}

/// The sign that a linear function keeps on the finite range (zero at an end at most): 1, -1; 0 if it keeps none or is not linear.
int Compiler::sign_of_linear(const Expression& e) const
{
    const auto p = polynomial(e);
    if (!p || p->size() > 2 || !has_range() || place_.range->map != Map::finite || !place_.range->from.exact || !place_.range->to.exact)
        return 0;
    const auto sign_of = [](const ExactSum& v) {
        return v.is_zero() ? 0 : arb_is_positive(v.ball().get()) ? 1 : arb_is_negative(v.ball().get()) ? -1 : 2;
    };
    const int s = sign_of(value(*p, *place_.range->from.exact)), t = sign_of(value(*p, *place_.range->to.exact));
    const int sign = s == 0 ? t : t == 0 || t == s ? s : 0;
    return sign == 1 || sign == -1 ? sign : 0;
}

/// Whether a polynomial goes to +oo at the infinite end of the range, the right one if both are; yes of what is none.
bool Compiler::rises_far_out(const Expression& e) const
{
    const auto p = polynomial(e);
    if (!p || p->size() < 2) return true;
    const bool left = has_range() && (place_.range->map == Map::left_algebraic || place_.range->map == Map::left_exponential);
    const bool odd = p->size() % 2 == 0;
    return (arb_is_negative(p->back().ball().get()) != 0) == (left && odd);
}

/// Whether a polynomial has no zero inside the half-line: in the distance to its end no two coefficients differ in sign.
bool Compiler::vanishes_at_most_at_the_end(const ExpressionPtr& e) const
{
    const bool right = place_.range->map == Map::right_algebraic || place_.range->map == Map::right_exponential;
    const bool left = place_.range->map == Map::left_algebraic || place_.range->map == Map::left_exponential;
    const auto& finite_end = end(right ? Side::left : Side::right);
    const auto p = right != left && finite_end ? polynomial(*shifted(e, *finite_end, right ? 1 : -1)) : std::nullopt;
    if (!p || p->empty()) return false;
    const auto all = [&](auto has_sign) {
        return std::all_of(p->begin(), p->end(), [&](const ExactSum& c) { return c.is_zero() || has_sign(c.ball().get()) != 0; });
    };
    return all([](arb_srcptr c) { return arb_is_positive(c); }) || all([](arb_srcptr c) { return arb_is_negative(c); });
}

/// max and min of what is surely ordered on the range: the one that it is.
ExpressionPtr Compiler::settled(const ExpressionPtr& e) const
{
    if (e->op != Op::max && e->op != Op::min) return e;
    ExpressionPtr r = settled(e->args[0]);
    for (std::size_t i = 1; i < e->args.size(); ++i) {
        const ExpressionPtr other = settled(e->args[i]);
        const ExpressionPtr gap = difference(r, other);
        if (is_zero(*gap)) continue;
        const int sign = sign_of_linear(*gap);
        if (sign == 0) return e;
        if ((sign > 0) == (e->op == Op::min)) r = other;
    }
    return r;
}

/// abs and sign of what is known not to vanish inside the range; max, min by abs; floor, ceil of what stays between integers.
NodePtr Compiler::without_branch(const ExpressionPtr& e) const
{
    const ExpressionPtr a = settled(e->args[0]);
    if (e->op == Op::max || e->op == Op::min) {
        if (const ExpressionPtr one = settled(e); one != e) return compile(one);
        ExpressionPtr r = a;
        for (std::size_t i = 1; i < e->args.size(); ++i) {
            const ExpressionPtr spread = of(Op::abs, difference(r, e->args[i])), total = sum(r, e->args[i]);
            r = quotient(e->op == Op::max ? sum(total, spread) : difference(total, spread), number(2));
        }
        return compile(r);
    }
    if ((e->op == Op::abs || e->op == Op::sign) && is_zero(*a)) return constant(ExactSum(0));
    const auto p = polynomial(*a);
    const bool is_step = e->op == Op::floor || e->op == Op::ceil;
    if (is_step && !depends_on_x(*a) && p && p->size() == 1)
        if (const auto q = (*p)[0].rational()) {
            Integer n;
            (e->op == Op::floor ? mpz_fdiv_q : mpz_cdiv_q)(n.get_mpz_t(), q->get_num_mpz_t(), q->get_den_mpz_t());
            return constant(ExactSum(Rational(n)));
        }
    if (!p || p->size() != 2 || !has_range() || place_.range->map != Map::finite || !place_.range->from.exact || !place_.range->to.exact)
        return node(Kind::function, {a}, e->op);
    // linear: the values at the two ends bound it
    const ExactSum at_from = value(*p, *place_.range->from.exact), at_to = value(*p, *place_.range->to.exact);
    const Ball low = at_from.ball(), high = at_to.ball(), middle = (low + high) / Ball(2);
    if (is_step) {
        Ball n;
        (e->op == Op::floor ? arb_floor : arb_ceil)(n.get(), middle.get(), WorkingPrecision::bits());
        if (!arb_is_int(n.get()) || arf_cmpabs_2exp_si(arb_midref(n.get()), 60) > 0) return node(Kind::function, {a}, e->op);
        const long step = arf_get_si(arb_midref(n.get()), ARF_RND_NEAR);
        const ExactSum from(e->op == Op::floor ? step : step - 1), to = from + ExactSum(1);
        for (const ExactSum& end_value : {at_from, at_to}) {
            const Ball below = (end_value - from).ball(), beyond = (to - end_value).ball();
            const bool inside = ((end_value - from).is_zero() || arb_is_positive(below.get())) &&
                                ((to - end_value).is_zero() || arb_is_positive(beyond.get()));
            if (!inside) return node(Kind::function, {a}, e->op);
        }
        return constant(ExactSum(step));
    }
    const int sign = sign_of_linear(*a);
    if (sign == 0) return node(Kind::function, {a}, e->op);
    if (e->op == Op::sign) return constant(ExactSum(sign));
    return compile(sign > 0 ? a : of(Op::negate, a));
}

NodePtr Compiler::by_operation(const ExpressionPtr& e) const
{
    switch (e->op) {
    case Op::number: return constant(ExactSum(e->number));
    case Op::pi: return constant(ExactSum::pi());
    case Op::imaginary_unit: return constant(ExactSum::i());
    case Op::ball: {
        auto n = std::make_unique<Node>();
        n->kind = Kind::ball;
        n->source = e;
        return n;
    }
    case Op::real_part:
    case Op::imaginary_part:
    case Op::conjugate:
    case Op::real_value:
    case Op::imaginary_value: return part_of(e);
    case Op::integral: {
        auto n = std::make_unique<Node>();
        n->kind = Kind::inner_integral;
        n->inner = inner_integral(*e);
        for (const ExpressionPtr& end : e->args) n->args.push_back(is_infinite_end(*end) ? nullptr : compile(end));
        return n;
    }
    case Op::e: return compile(of(Op::exp, number(1)));
    case Op::variable: {
        auto n = std::make_unique<Node>();
        n->kind = Kind::variable;
        return n;
    }
    case Op::add: return node(Kind::add, e->args);
    case Op::multiply: return node(Kind::multiply, e->args);
    case Op::divide: return node(Kind::divide, e->args);
    case Op::negate: return node(Kind::multiply, {number(-1), e->args[0]});
    case Op::odd_difference: return node(Kind::add, {e->args[0], of(Op::negate, substituted(e->args[0], of(Op::negate, make_variable())))});
    case Op::sqrt:
    case Op::cbrt: return power(e->args[0], make_number(Rational(1, e->op == Op::sqrt ? 2 : 3)));
    case Op::power: return power(e->args[0], e->args[1]);
    case Op::exp: return exponential(e->args[0]);
    case Op::log:
        if (NodePtr n = logarithm(e->args[0])) return n;
        if (NodePtr n = logarithm_near_one(e->args[0])) return n;
        return node(Kind::function, e->args, e->op);
    case Op::abs:
        if (!is_real(*e->args[0])) return part_of(e);
        return without_branch(e);
    case Op::sign:
    case Op::floor:
    case Op::ceil:
    case Op::max:
    case Op::min: require_real_arguments(*e); return without_branch(e);
    case Op::ei: // left of the imaginary axis the function is another one than the usual
        require_real_arguments(*e);
        return node(Kind::function, e->args, e->op);
    default:
        if (!has_order(e->op)) return node(Kind::function, e->args, e->op);
        if (depends_on_x(*e->args[0]))
            throw ExpressionError(e->column, "the order of a Bessel function or polylogarithm must not depend on x");
        require_real_arguments(*e, true);
        return node(Kind::ordered_function, e->args, e->op);
    }
}

/// Equal parts of a formula are one node.
NodePtr Compiler::compile(const ExpressionPtr& e) const
{
    if (const auto found = done_.find(e.get()); found != done_.end()) {
        found->second->is_shared = true;
        return found->second;
    }
    NodePtr n = compiled_anew(e);
    done_.emplace(e.get(), n);
    alive_.push_back(e);
    return n;
}

NodePtr Compiler::compiled_anew(const ExpressionPtr& e) const
{
    if (!depends_on_x(*e)) {
        if (const auto exact = exact_value(*e)) return constant(*exact);
    }
    else if (has_range()) {
        if (e->op != Op::variable && e->op != Op::multiply && e->op != Op::divide && e->op != Op::power)
            if (const auto p = polynomial(*e))
                if (NodePtr n = factored(*p)) return n;
    }
    if (const ExpressionPtr shorter = with_numbers_collected(e); shorter != e) return compile(shorter);
    if (const auto better = rewritten(*e)) return compile(*better);
    if (const ExpressionPtr scaled = is_infinite() ? with_scaled_functions(e) : nullptr) return compile(scaled);
    NodePtr n = by_operation(e);
    const bool is_another = n.use_count() > 1; // its zeros are known
    const bool may_vanish = n->kind == Kind::add || n->kind == Kind::function || n->kind == Kind::ordered_function ||
                            n->kind == Kind::real_part || n->kind == Kind::imaginary_part || n->kind == Kind::logarithm_near_one;
    const auto known = e->op == Op::sinc ? beneath_singular_.find(e.get()) : beneath_singular_.end();
    const bool is_in_the_open = known != beneath_singular_.end() && !known->second;
    if (!is_another && may_vanish && has_range() && depends_on_x(*e) && !is_in_the_open) find_zeros(*n, e);
    return n;
}

void Compiler::find_zeros(Node& n, const ExpressionPtr& e) const
{
    const Zeros zeros(place_);
    if (e->op == Op::odd_difference) {
        if (end(Side::left) && end(Side::left)->is_zero()) n.zero[0] = zeros.of_odd_difference(n, *Compiler(Place{}).compile(e->args[0]));
        return;
    }
    std::array<std::optional<Zero>, 2> found;
    for (const bool beyond_the_range : {true, false}) { // where the other end is a zero too, T of a disc that has both says little there
        for (const Side s : {Side::left, Side::right})
            if (end(s)) {
                const auto expand = [&] { return expanded(e, s); };
                found[s == Side::left ? 0 : 1] = zeros.at(n, s, expand, beyond_the_range);
            }
        if (!found[0] || !found[1] || is_infinite()) break;
    }
    n.zero = std::move(found);
}

} // namespace

void require_real_arguments(const Expression& e, bool all_but_last)
{
    const std::size_t n = e.args.size() - (all_but_last ? 1 : 0);
    for (std::size_t k = 0; k < n; ++k)
        if (!is_real(*e.args[k]))
            throw ExpressionError(e.column, "this function takes real arguments: write re(...) or im(...) where a number is complex");
}

NodePtr compile(const ExpressionPtr& e, const Place& place)
{
    Compiler compiler(place);
    const ExpressionPtr shared = with_shared_parts(e);
    compiler.look_for_sinc_with_zeros(*shared, false);
    return compiler.compile(shared);
}

} // namespace touchstone::quadrature::compiled
