// SPDX-License-Identifier: MIT
#include "touchstone/quadrature/oscillation.hpp"

#include "touchstone/quadrature/lemmas.hpp"
#include "touchstone/quadrature/quadrant.hpp"
#include "touchstone/quadrature/special.hpp"
#include "touchstone/quadrature/split.hpp"
#include "touchstone/quadrature/strip.hpp"
#include "touchstone/quadrature/widen.hpp"

#include <algorithm>
#include <cmath>

namespace touchstone::quadrature {
namespace {

using Waves = std::optional<std::vector<Wave>>;
using Linear = std::optional<std::pair<ExactSum, ExactSum>>; // value at 0, slope

constexpr std::size_t most_waves = 256;

bool oscillates(const Expression& e)
{
    if (e.op == Op::real_value || e.op == Op::imaginary_value) return true;
    const bool kernel = e.op == Op::sin || e.op == Op::cos || e.op == Op::sinc || e.op == Op::bessel_j || e.op == Op::bessel_y;
    if (kernel && depends_on_x(*e.args.back())) return true;
    return std::any_of(e.args.begin(), e.args.end(), [](const ExpressionPtr& a) { return oscillates(*a); });
}

Linear linear(const Expression& e)
{
    const auto p = polynomial(e);
    if (!p || p->size() != 2) return std::nullopt;
    return std::pair((*p)[0], (*p)[1]);
}

bool is_trigonometric(const Wave& w) { return w.kernel == Op::sin || w.kernel == Op::cos; }

/// With a positive frequency; without one, a sine or cosine of the phase is a constant that must be exact.
Waves normalised(Wave w)
{
    if (w.frequency.is_zero()) {
        if (!w.phase.is_zero()) return std::nullopt;
        if (w.kernel == Op::sin) return std::vector<Wave>{};
        w.kernel = Op::number;
        return std::vector{w};
    }
    if (arb_is_negative(w.frequency.ball().get())) {
        w.frequency = -w.frequency;
        w.phase = -w.phase;
        if (w.kernel == Op::sin) w.amplitude = make(Op::negate, {w.amplitude});
    }
    return std::vector{w};
}

/// Products of sines and cosines as sums: 2 cos a cos b = cos(a - b) + cos(a + b) and its kin.
Waves product(const Wave& a, const Wave& b)
{
    const ExpressionPtr amplitude = make(Op::multiply, {a.amplitude, b.amplitude});
    if (a.kernel == Op::number || b.kernel == Op::number) {
        Wave r = a.kernel == Op::number ? b : a;
        r.amplitude = amplitude;
        return std::vector{r};
    }
    if (!is_trigonometric(a) || !is_trigonometric(b)) return std::nullopt;
    const bool both_sines = a.kernel == Op::sin && b.kernel == Op::sin, mixed = a.kernel != b.kernel;
    const Op kernel = mixed ? Op::sin : Op::cos;
    // sin a cos b = (sin(a + b) + sin(a - b))/2 with a the sine
    const Wave &first = mixed && b.kernel == Op::sin ? b : a, &second = mixed && b.kernel == Op::sin ? a : b;
    std::vector<Wave> all;
    for (const long sign : {1L, -1L}) {
        const ExpressionPtr weight = make_number(both_sines && sign > 0 ? Rational(-1, 2) : Rational(1, 2));
        const auto part = normalised({make(Op::multiply, {weight, amplitude}), kernel, first.phase + ExactSum(sign) * second.phase,
                                      first.frequency + ExactSum(sign) * second.frequency, nullptr});
        if (!part) return std::nullopt;
        all.insert(all.end(), part->begin(), part->end());
    }
    return all;
}

Waves product(const Waves& a, const Waves& b)
{
    if (!a || !b) return std::nullopt;
    const std::vector<Wave>&left = a.value(), &right = b.value();
    if (left.size() * right.size() > most_waves) return std::nullopt;
    std::vector<Wave> all;
    for (const Wave& v : left)
        for (const Wave& w : right) {
            const auto part = product(v, w);
            if (!part) return std::nullopt;
            all.insert(all.end(), part->begin(), part->end());
        }
    return all;
}

Waves split(const ExpressionPtr& e);

Waves trigonometric(const Expression& e)
{
    const auto argument = linear(*e.args[0]);
    if (!argument) return std::nullopt;
    const bool quotient = e.op == Op::sinc;
    const ExpressionPtr one = make_number(1);
    return normalised(
        {quotient ? make(Op::divide, {one, e.args[0]}) : one, quotient ? Op::sin : e.op, argument->first, argument->second, nullptr});
}

Waves bessel(const Expression& e)
{
    const auto argument = linear(*e.args[1]);
    if (!argument || !argument->first.is_zero() || depends_on_x(*e.args[0]) || !arb_is_positive(argument->second.ball().get()))
        return std::nullopt;
    return std::vector{Wave{make_number(1), e.op, ExactSum(0), argument->second, e.args[0]}};
}

Waves power(const Expression& e)
{
    constexpr long highest = 8;
    const auto exponent = exact_value(*e.args[1]);
    const auto n = exponent ? exponent->rational() : std::nullopt;
    if (!n || n->get_den() != 1 || *n < 1 || *n > highest) return std::nullopt;
    const Waves base = split(e.args[0]);
    Waves all = base;
    for (long k = 1; all && k < n->get_num().get_si(); ++k) all = product(all, base);
    return all;
}

Waves split(const ExpressionPtr& e)
{
    if (!oscillates(*e)) return std::vector{Wave{e, Op::number, {}, {}, nullptr}};
    switch (e->op) {
    case Op::real_value:
    case Op::imaginary_value: {
        const auto parts = real_and_imaginary(e->args[0]);
        if (!parts) return std::nullopt;
        const ExpressionPtr& part = e->op == Op::real_value ? parts->first : parts->second;
        return part ? split(part) : Waves(std::vector<Wave>{});
    }
    case Op::add: {
        Waves a = split(e->args[0]);
        const Waves b = split(e->args[1]);
        if (!a || !b) return std::nullopt;
        std::vector<Wave>& all = a.value();
        const std::vector<Wave>& more = b.value();
        if (all.size() + more.size() > most_waves) return std::nullopt;
        all.insert(all.end(), more.begin(), more.end());
        return a;
    }
    case Op::negate: return product(split(make_number(-1)), split(e->args[0]));
    case Op::multiply: return product(split(e->args[0]), split(e->args[1]));
    case Op::divide:
        if (oscillates(*e->args[1])) return std::nullopt;
        return product(split(e->args[0]), split(make(Op::divide, {make_number(1), e->args[1]})));
    case Op::power: return power(*e);
    case Op::sin:
    case Op::cos:
    case Op::sinc: return trigonometric(*e);
    case Op::bessel_j:
    case Op::bessel_y: return bessel(*e);
    default: return std::nullopt;
    }
}

Limit plain_limit(long at)
{
    Limit l; // no exact end: nothing is expanded there
    l.formula = make_number(Rational(at));
    l.text = std::to_string(at);
    return l;
}

bool is_bessel(const Wave& w) { return w.kernel == Op::bessel_j || w.kernel == Op::bessel_y; }

/// K_n over a ball of any width.
ComplexBall bessel_k(const Ball& order, const ComplexBall& z)
{
    constexpr slong bits_of_a_node = 16;
    if (arb_contains_zero(acb_imagref(z.get())) && !arb_is_positive(acb_realref(z.get()))) return ComplexBall::indeterminate(); // the cut
    return acb_rel_accuracy_bits(z.get()) <= bits_of_a_node ? bessel_k_by_its_size(order, z) : special_function(Op::bessel_k, order, z);
}

/// The term at a point of the plane: f(z) with cos replaced by exp(i .), J by H^(1).
class Turned {
public:
    explicit Turned(const Wave& w)
        : wave_(w)
        , amplitude_(w.amplitude)
    {
    }
    ComplexBall at(const ComplexBall& z)
    {
        ++evaluations;
        const ComplexBall i(Ball(0), Ball(1)), g = amplitude_.at(z), wz = ComplexBall(wave_.frequency.ball()) * z;
        if (!is_bessel(wave_)) return g * analytic::exp(i * (wz + ComplexBall(wave_.phase.ball())));
        // H_n^(1)(z) = 2/(pi i) exp(-i pi n/2) K_n(-i z)
        const Ball order = evaluate_at(*wave_.order, Ball(0));
        const ComplexBall turned = -(i * wz), k = bessel_k(order, turned);
        const Ball quarter_turns = pi<Ball>() * order / Ball(2);
        return g * k * analytic::exp(-(i * ComplexBall(quarter_turns))) * ComplexBall(Ball(0), Ball(-2) / pi<Ball>());
    }
    long evaluations = 0;

private:
    const Wave& wave_;
    PlainFormula amplitude_;
};

} // namespace

std::optional<std::vector<Wave>> waves(const ExpressionPtr& e)
{
    const WorkingPrecision precision(256);
    auto all = split(e);
    if (!all || std::all_of(all->begin(), all->end(), [](const Wave& w) { return w.kernel == Op::number; })) return std::nullopt;
    return all;
}

std::optional<Ball> supremum_in_quadrant(const Wave& wave, long base, long distance)
{
    const WorkingPrecision precision(strip_bits);
    using N = EndpointNumber<ComplexBall>;
    const Range range{plain_limit(base), parse_limit("inf"), Map::right_algebraic};
    const Integrand amplitude(wave.amplitude, range);
    Interval interval = range.interval();
    interval.prepare();
    const Quadrant quadrant(distance);
    const auto p = interval.at(N(&quadrant, {1, 0}, {}, ComplexBall(1)), N(&quadrant, {}, {1, 0}, ComplexBall(1)));
    N g = amplitude.at(p.x, p.left, p.right);
    Ball factor(1);
    if (is_bessel(wave)) {
        const Ball order = evaluate_at(*wave.order, Ball(0)), w = wave.frequency.ball(), least = w * Ball(base + distance);
        if (!arb_is_positive(least.get())) return std::nullopt;
        g = g / sqrt(p.x);
        factor = sqrt(Ball(2) / (pi<Ball>() * w)) * (Ball(1) + lemma::bessel_remainder(order, least, Ball(1)));
    }
    const Order& order = g.right();
    const bool decays = Exponent(0) < order.power || (order.power.is_zero() && order.logs < Exponent(0));
    const ComplexBall value = g.value();
    if (!decays || !value.is_finite() || !factor.is_finite()) return std::nullopt;
    Ball most = touchstone::abs(value) * factor, top;
    arb_get_ubound_arf(arb_midref(top.get()), most.get(), strip_bits);
    return top;
}

std::optional<Tail> tail(const Wave& wave, long base, long distance, const Ball& supremum, long digits)
{
    constexpr slong spare = 10;
    const slong bits = bits_for_digits(digits);
    const WorkingPrecision precision(bits + spare);
    const Ball w = wave.frequency.ball();
    const double length = std::ceil(static_cast<double>(bits + spare) * M_LN2 / arf_get_d(arb_midref(w.get()), ARF_RND_DOWN) * 16) / 16;
    if (!(length < 1e15)) return std::nullopt;
    const ComplexBall from(Ball(base + distance)), to(Ball(base + distance), Ball::exactly(length));
    Turned turned(wave);
    const auto evaluate = [](acb_ptr out, const acb_t z, void* data, slong, slong working) -> int {
        const WorkingPrecision here(working);
        ComplexBall argument;
        acb_set(argument.get(), z);
        acb_set(out, static_cast<Turned*>(data)->at(argument).get());
        return 0;
    };
    acb_calc_integrate_opt_t options;
    acb_calc_integrate_opt_init(options);
    options->eval_limit = 4000 + 200 * digits;
    mag_t tolerance;
    mag_init(tolerance);
    mag_set_ui_2exp_si(tolerance, 1, -bits - spare);
    ComplexBall value;
    acb_calc_integrate(value.get(), evaluate, &turned, from.get(), to.get(), bits, tolerance, options, bits + spare);
    mag_clear(tolerance);
    if (!value.is_finite()) return std::nullopt;
    widen(value, lemma::beyond(supremum, w, Ball::exactly(length)));
    const bool imaginary = wave.kernel == Op::sin || wave.kernel == Op::bessel_y;
    return Tail{imaginary ? value.imag() : value.real(), turned.evaluations};
}

} // namespace touchstone::quadrature
