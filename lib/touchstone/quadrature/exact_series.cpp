// SPDX-License-Identifier: MIT
#include "touchstone/quadrature/exact_series.hpp"

#include <algorithm>
#include <unordered_map>

namespace touchstone::quadrature {
namespace {

using Series = std::optional<ExactSeries>;
using Coefficients = std::vector<ExactSum>; // of a power series with valuation 0: c_0 may be zero

constexpr std::size_t terms = 12; // coefficients kept

Series constant(const ExactSum& c)
{
    ExactSeries s;
    if (c.is_zero()) {
        s.is_exactly_zero = true;
        return s;
    }
    s.c.assign(terms, ExactSum());
    s.c[0] = c;
    return s;
}

/// Leading zeros go into the valuation.
Series normalised(ExactSeries s)
{
    const auto first = std::find_if(s.c.begin(), s.c.end(), [](const ExactSum& c) { return !c.is_zero(); });
    s.valuation += static_cast<long>(first - s.c.begin());
    s.c.erase(s.c.begin(), first);
    return s;
}

Series sum(const Series& a, const Series& b)
{
    if (!a || !b) return std::nullopt;
    if (a->is_exactly_zero) return b;
    if (b->is_exactly_zero) return a;
    const ExactSeries &low = a->valuation <= b->valuation ? *a : *b, &high = a->valuation <= b->valuation ? *b : *a;
    const Rational shift = high.valuation - low.valuation;
    if (shift.get_den() != 1) return std::nullopt;
    if (shift >= static_cast<long>(low.c.size())) return low;
    const auto k = static_cast<std::size_t>(shift.get_num().get_si());
    ExactSeries r{low.valuation, {}, false};
    const std::size_t known = std::min(low.c.size(), high.c.size() + k);
    for (std::size_t i = 0; i < known; ++i) r.c.push_back(i >= k ? low.c[i] + high.c[i - k] : low.c[i]);
    return normalised(std::move(r));
}

Coefficients product(const Coefficients& a, const Coefficients& b)
{
    Coefficients r(std::min(a.size(), b.size()));
    for (std::size_t i = 0; i < r.size(); ++i)
        for (std::size_t j = 0; i + j < r.size(); ++j)
            if (!a[i].is_zero() && !b[j].is_zero()) r[i + j] = r[i + j] + a[i] * b[j];
    return r;
}

Series product(const Series& a, const Series& b)
{
    if (!a || !b) return std::nullopt;
    if (a->is_exactly_zero) return a;
    if (b->is_exactly_zero) return b;
    return ExactSeries{a->valuation + b->valuation, product(a->c, b->c), false};
}

Series negative(Series a)
{
    if (a)
        for (ExactSum& c : a->c) c = -c;
    return a;
}

Series inverse(const Series& a)
{
    if (!a || a->c.empty()) return std::nullopt;
    const auto lead = a->c[0].inverse();
    if (!lead) return std::nullopt;
    ExactSeries r{-a->valuation, Coefficients(a->c.size()), false};
    r.c[0] = *lead;
    for (std::size_t k = 1; k < r.c.size(); ++k) {
        ExactSum s;
        for (std::size_t j = 1; j <= k; ++j)
            if (!a->c[j].is_zero() && !r.c[k - j].is_zero()) s = s + a->c[j] * r.c[k - j];
        if (!s.is_zero()) r.c[k] = -(s * *lead);
    }
    return r;
}

/// a^e: k c_0 b_k = sum over j of (e j - (k - j)) a_j b_(k-j), from a b' = e a' b.
Series power(const Series& a, const Rational& e)
{
    if (!a) return std::nullopt;
    if (e == 0) return constant(1);
    if (a->is_exactly_zero) return e > 0 ? a : std::nullopt;
    if (a->c.empty()) return std::nullopt;
    std::optional<ExactSum> lead;
    if (e.get_den() == 1 && e.get_num().fits_slong_p())
        lead = a->c[0].power(e.get_num().get_si());
    else if (e.get_den() == 2 && e.get_num().fits_slong_p()) {
        if (const auto root = a->c[0].sqrt()) lead = root->power(e.get_num().get_si());
    }
    else if (a->c[0] == ExactSum(1))
        lead = ExactSum(1);
    const auto first = a->c[0].inverse();
    if (!lead || !first) return std::nullopt;
    ExactSeries r{a->valuation * e, Coefficients(a->c.size()), false};
    r.c[0] = *lead;
    for (std::size_t k = 1; k < r.c.size(); ++k) {
        ExactSum s;
        for (std::size_t j = 1; j <= k; ++j) {
            if (a->c[j].is_zero() || r.c[k - j].is_zero()) continue;
            const Rational w = e * static_cast<long>(j) - static_cast<long>(k - j);
            s = s + ExactSum(w) * a->c[j] * r.c[k - j];
        }
        if (!s.is_zero()) r.c[k] = s * *first * ExactSum(Rational(1, static_cast<long>(k)));
    }
    return r;
}

/// As a power series, if it is bounded: c_0 may be zero.
std::optional<Coefficients> taylor(const Series& a)
{
    if (!a) return std::nullopt;
    if (a->is_exactly_zero) return Coefficients(terms);
    if (a->valuation < 0 || a->valuation.get_den() != 1 || a->valuation >= static_cast<long>(terms)) return std::nullopt;
    Coefficients r(static_cast<std::size_t>(a->valuation.get_num().get_si()));
    r.insert(r.end(), a->c.begin(), a->c.end());
    if (r.size() > terms) r.resize(terms);
    return r;
}

Series from_taylor(Coefficients c) { return normalised({0, std::move(c), false}); }

Coefficients derivative(const Coefficients& a)
{
    Coefficients r;
    for (std::size_t k = 1; k < a.size(); ++k) r.push_back(ExactSum(static_cast<long>(k)) * a[k]);
    return r;
}

Coefficients integral(const Coefficients& d, const ExactSum& start)
{
    Coefficients r{start};
    for (std::size_t k = 0; k < d.size(); ++k) r.push_back(d[k] * ExactSum(Rational(1, static_cast<long>(k + 1))));
    return r;
}

/// exp of a series without constant term: k b_k = sum j a_j b_(k-j).
Coefficients exponential(const Coefficients& a)
{
    Coefficients b(a.size());
    b[0] = 1;
    for (std::size_t k = 1; k < a.size(); ++k) {
        ExactSum s;
        for (std::size_t j = 1; j <= k; ++j) s = s + ExactSum(static_cast<long>(j)) * a[j] * b[k - j];
        b[k] = s * ExactSum(Rational(1, static_cast<long>(k)));
    }
    return b;
}

/// sin(n pi/12), if it is one square root.
std::optional<ExactSum> sine_of_twelfths(long n)
{
    n = (n % 24 + 24) % 24;
    if (n >= 12) {
        const auto s = sine_of_twelfths(n - 12);
        return s ? std::optional(-*s) : std::nullopt;
    }
    if (n > 6) n = 12 - n;
    const ExactSum half(Rational(1, 2));
    switch (n) {
    case 0: return ExactSum(0);
    case 2: return half;
    case 3: return half * *ExactSum(2).sqrt();
    case 4: return half * *ExactSum(3).sqrt();
    case 6: return ExactSum(1);
    default: return std::nullopt;
    }
}

/// exp(c) for c = i pi q, 12 q whole, where both parts are one square root.
std::optional<ExactSum> root_of_unity(const ExactSum& c)
{
    if (c.is_zero()) return ExactSum(1);
    const auto turns = c.real().is_zero() ? c.imaginary().times_pi() : std::nullopt;
    if (!turns || Rational(12 * *turns).get_den() != 1) return std::nullopt;
    const long twelfths = Integer(Rational(12 * *turns).get_num() % 24).get_si();
    const auto sine = sine_of_twelfths(twelfths), cosine = sine_of_twelfths(twelfths + 6);
    return sine && cosine ? std::optional(*cosine + ExactSum::i() * *sine) : std::nullopt;
}

/// sine and cosine of an angle that is a multiple of pi/4 or pi/6 plus a series without constant term (sign = -1), or their hyperbolic kin
/// at 0 (sign = 1).
std::optional<std::pair<Coefficients, Coefficients>> sine_cosine(const Coefficients& a, int sign)
{
    Coefficients s(a.size()), c(a.size());
    if (sign < 0) {
        const auto turns = a[0].times_pi();
        if (!turns || Rational(12 * *turns).get_den() != 1) return std::nullopt;
        const long twelfths = Integer(Rational(12 * *turns).get_num() % 24).get_si();
        const auto sine = sine_of_twelfths(twelfths), cosine = sine_of_twelfths(twelfths + 6);
        if (!sine || !cosine) return std::nullopt;
        s[0] = *sine;
        c[0] = *cosine;
    }
    else {
        if (!a[0].is_zero()) return std::nullopt;
        c[0] = 1;
    }
    for (std::size_t k = 1; k < a.size(); ++k) {
        ExactSum ds, dc;
        for (std::size_t j = 1; j <= k; ++j) {
            const ExactSum w = ExactSum(static_cast<long>(j)) * a[j];
            ds = ds + w * c[k - j];
            dc = dc + w * s[k - j];
        }
        const ExactSum over(Rational(1, static_cast<long>(k)));
        s[k] = ds * over;
        c[k] = ExactSum(static_cast<long>(sign)) * dc * over;
    }
    return std::pair(s, c);
}

/// The integral of a' g from f(a_0).
Series integrated(const Coefficients& a, const Series& g, const ExactSum& start)
{
    const auto t = taylor(g);
    if (!t) return std::nullopt;
    return from_taylor(integral(product(derivative(a), *t), start));
}

/// J_n (sign = -1) or I_n (sign = 1) of a series without constant term: sum of (sign)^k (a/2)^(2k+n) / (k! (k+n)!).
Series bessel(const Series& argument, long n, int sign)
{
    if (!argument) return std::nullopt;
    if (argument->is_exactly_zero || argument->valuation <= 0 || n < 0 || n > 8) return std::nullopt;
    const Series half = product(argument, constant(Rational(1, 2))), square = product(half, half);
    Series term = power(half, n), total;
    Rational factor = 1;
    for (long k = 2; k <= n; ++k) factor /= k;
    for (long k = 0; k < static_cast<long>(terms); ++k) {
        if (k > 0) {
            term = product(term, square);
            factor *= Rational(sign) / (k * (k + n));
        }
        const Series part = product(term, constant(factor));
        total = k == 0 ? part : sum(total, part);
    }
    return total;
}

/// K, or E, of a series without constant term: (pi/2) sum of ((1/2)_n/n!)^2 a^n, for E each over 1 - 2n.
Series elliptic(const Series& a, bool is_second_kind)
{
    const ExactSum quarter_turn = ExactSum(Rational(1, 2)) * ExactSum::pi();
    Series total = constant(quarter_turn), power = constant(1);
    Rational root = 1;
    for (long n = 1; n < static_cast<long>(terms); ++n) {
        power = product(power, a);
        root *= Rational(2 * n - 1, 2 * n);
        const Rational factor = is_second_kind ? Rational(root * root / (1 - 2 * n)) : Rational(root * root);
        total = sum(total, product(power, constant(ExactSum(factor) * quarter_turn)));
    }
    return total;
}

class Expansion {
public:
    Expansion(const ExactSum& centre, int direction)
    {
        ExactSeries s{0, Coefficients(terms), false};
        s.c[0] = centre;
        s.c[1] = direction;
        x_ = *normalised(std::move(s));
    }
    /// The expression outlives the expansion.
    Series of(const Expression& e);

private:
    Series by_operation(const Expression& e);
    Series analytic(const Expression& e, const Series& argument);
    Series x_;
    std::unordered_map<const Expression*, Series> known_;
};

/// The real (imaginary, conjugated) coefficients: s is real and positive.
template <class Map>
Series each_coefficient(Series a, const Map& map)
{
    if (!a || a->is_exactly_zero) return a;
    for (ExactSum& c : a->c) c = map(c);
    return normalised(std::move(*a));
}

Series reciprocal_of(const Series& a) { return inverse(a); }

Series Expansion::analytic(const Expression& e, const Series& argument)
{
    const auto t = taylor(argument);
    if (!t || t->empty()) return std::nullopt;
    const Coefficients& a = *t;
    const bool at_zero = a[0].is_zero();
    const Series one = constant(1), square = product(argument, argument);
    const auto trigonometric = [&](int sign) -> std::pair<Series, Series> {
        const auto both = sine_cosine(a, sign);
        if (!both) return {};
        return {from_taylor(both->first), from_taylor(both->second)};
    };
    const int sign =
        e.op == Op::sinh || e.op == Op::cosh || e.op == Op::tanh || e.op == Op::coth || e.op == Op::sech || e.op == Op::csch ? 1 : -1;
    switch (e.op) {
    case Op::exp:
    case Op::expm1: {
        const auto front = root_of_unity(a[0]);
        if (!front) return std::nullopt;
        Coefficients rest = a;
        rest[0] = ExactSum(0);
        const Series r = product(constant(*front), from_taylor(exponential(rest)));
        return e.op == Op::exp ? r : sum(r, constant(-1));
    }
    case Op::log: return a[0] == ExactSum(1) ? integrated(a, inverse(argument), 0) : std::nullopt;
    case Op::log1p: return at_zero ? integrated(a, inverse(sum(one, argument)), 0) : std::nullopt;
    case Op::sin:
    case Op::sinh: return trigonometric(sign).first;
    case Op::cos:
    case Op::cosh: return trigonometric(sign).second;
    case Op::tan:
    case Op::tanh: {
        const auto [s, c] = trigonometric(sign);
        return product(s, inverse(c));
    }
    case Op::cot:
    case Op::coth: {
        const auto [s, c] = trigonometric(sign);
        return product(c, inverse(s));
    }
    case Op::sec:
    case Op::sech: return inverse(trigonometric(sign).second);
    case Op::csc:
    case Op::csch: return inverse(trigonometric(sign).first);
    case Op::sinc: return product(trigonometric(-1).first, inverse(argument));
    case Op::atan: return at_zero ? integrated(a, inverse(sum(one, square)), 0) : std::nullopt;
    case Op::atanh: return at_zero ? integrated(a, inverse(sum(one, negative(square))), 0) : std::nullopt;
    case Op::asinh: return at_zero ? integrated(a, power(sum(one, square), Rational(-1, 2)), 0) : std::nullopt;
    case Op::asin: return at_zero ? integrated(a, power(sum(one, negative(square)), Rational(-1, 2)), 0) : std::nullopt;
    case Op::acos: {
        if (!at_zero) return std::nullopt;
        return sum(constant(ExactSum(Rational(1, 2)) * ExactSum::pi()),
                   negative(integrated(a, power(sum(one, negative(square)), Rational(-1, 2)), 0)));
    }
    case Op::erf:
    case Op::erfi: {
        if (!at_zero) return std::nullopt;
        const auto exponent = taylor(e.op == Op::erf ? negative(square) : square);
        if (!exponent) return std::nullopt;
        return integrated(a, product(constant(ExactSum(2) * ExactSum::pi(-1)), from_taylor(exponential(*exponent))), 0);
    }
    case Op::elliptic_k:
    case Op::elliptic_e: return at_zero ? elliptic(argument, e.op == Op::elliptic_e) : std::nullopt;
    case Op::si: {
        if (!at_zero) return std::nullopt;
        return integrated(a, product(trigonometric(-1).first, inverse(argument)), 0);
    }
    case Op::lambert_w: { // W' = a'/(e^W (1 + W)): each sweep makes one more coefficient right
        if (!at_zero) return std::nullopt;
        Coefficients w(a.size());
        for (std::size_t k = 0; k < a.size(); ++k) {
            const Series denominator = product(from_taylor(exponential(w)), sum(one, from_taylor(w)));
            const auto inverse_of = taylor(reciprocal_of(denominator));
            if (!inverse_of) return std::nullopt;
            w = integral(product(derivative(a), *inverse_of), 0);
            w.resize(a.size());
        }
        return from_taylor(w);
    }
    default: return std::nullopt;
    }
}

Series Expansion::of(const Expression& e)
{
    if (e.args.empty()) return by_operation(e);
    if (const auto found = known_.find(&e); found != known_.end()) return found->second;
    Series s = by_operation(e);
    known_.emplace(&e, s);
    return s;
}

Series Expansion::by_operation(const Expression& e)
{
    switch (e.op) {
    case Op::number: return constant(e.number);
    case Op::pi: return constant(ExactSum::pi());
    case Op::imaginary_unit: return constant(ExactSum::i());
    case Op::real_value:
    case Op::real_part: return each_coefficient(of(*e.args[0]), [](const ExactSum& c) { return c.real(); });
    case Op::imaginary_value:
    case Op::imaginary_part: return each_coefficient(of(*e.args[0]), [](const ExactSum& c) { return c.imaginary(); });
    case Op::conjugate: return each_coefficient(of(*e.args[0]), [](const ExactSum& c) { return c.conjugate(); });
    case Op::variable: return x_;
    case Op::add: return sum(of(*e.args[0]), of(*e.args[1]));
    case Op::multiply: return product(of(*e.args[0]), of(*e.args[1]));
    case Op::divide: return product(of(*e.args[0]), inverse(of(*e.args[1])));
    case Op::negate: return negative(of(*e.args[0]));
    case Op::sqrt: return power(of(*e.args[0]), Rational(1, 2));
    case Op::cbrt: return power(of(*e.args[0]), Rational(1, 3));
    case Op::power: {
        const auto exponent = exact_value(*e.args[1]);
        if (!exponent || !exponent->rational()) return std::nullopt;
        return power(of(*e.args[0]), *exponent->rational());
    }
    case Op::bessel_j:
    case Op::bessel_i: {
        const auto order = exact_value(*e.args[0]);
        const auto n = order ? order->rational() : std::nullopt;
        if (!n || n->get_den() != 1 || !n->get_num().fits_slong_p()) return std::nullopt;
        return bessel(of(*e.args[1]), n->get_num().get_si(), e.op == Op::bessel_j ? -1 : 1);
    }
    case Op::bessel_i_scaled: {
        Expression exponential, plain;
        exponential.op = Op::exp;
        plain.op = Op::bessel_i;
        plain.args = e.args;
        return product(analytic(exponential, negative(of(*e.args[1]))), by_operation(plain));
    }
    case Op::erfc_scaled: return std::nullopt;
    case Op::abs:
    case Op::sign: { // next to the end what it is taken of has the sign of its first term
        const auto a = of(*e.args[0]);
        if (!a || a->c.empty() || !is_real(*e.args[0]) || !a->c[0].is_real()) return std::nullopt;
        const Ball first = a->c[0].ball();
        if (first.contains_zero()) return std::nullopt;
        const bool below = arb_is_negative(first.get()) != 0;
        if (e.op == Op::sign) return constant(ExactSum(below ? -1 : 1));
        return below ? negative(a) : a;
    }
    default: return e.args.size() == 1 ? analytic(e, of(*e.args[0])) : std::nullopt;
    }
}

} // namespace

struct Expansions::Body {
    Expansion expansion;
    std::vector<ExpressionPtr> alive;
};
Expansions::Expansions(const ExactSum& centre, int direction)
    : body_(std::make_unique<Body>(Body{Expansion(centre, direction), {}}))
{
}
Expansions::~Expansions() = default;
Expansions::Expansions(Expansions&&) noexcept = default;
std::optional<ExactSeries> Expansions::of(const ExpressionPtr& e)
{
    body_->alive.push_back(e);
    return body_->expansion.of(*e);
}

std::optional<ExactSeries> expand(const Expression& e, const ExactSum& centre, int direction) { return Expansion(centre, direction).of(e); }

namespace {

/// The value by arithmetic alone; nothing where that does not give it.
std::optional<ExactSum> by_arithmetic(const Expression& e)
{
    const auto arg = [&](std::size_t k) { return by_arithmetic(*e.args[k]); };
    switch (e.op) {
    case Op::number: return ExactSum(e.number);
    case Op::pi: return ExactSum::pi();
    case Op::imaginary_unit: return ExactSum::i();
    case Op::negate: {
        const auto a = arg(0);
        return a ? std::optional(-*a) : std::nullopt;
    }
    case Op::add:
    case Op::multiply:
    case Op::divide: {
        const auto a = arg(0), b = a ? arg(1) : std::nullopt;
        if (!b) return std::nullopt;
        if (e.op == Op::add) return *a + *b;
        if (e.op == Op::multiply) return *a * *b;
        const auto inverse = b->inverse();
        return inverse ? std::optional(*a * *inverse) : std::nullopt;
    }
    default: return std::nullopt;
    }
}

} // namespace

std::optional<ExactSum> exact_value(const Expression& e)
{
    if (depends_on_x(e)) return std::nullopt;
    if (auto direct = by_arithmetic(e)) return direct;
    const auto s = Expansion(ExactSum(), 1).of(e);
    if (!s) return std::nullopt;
    if (s->is_exactly_zero || s->c.empty()) return s->is_exactly_zero ? std::optional(ExactSum()) : std::nullopt;
    if (s->valuation != 0) return std::nullopt;
    return s->c[0]; // the only term: there is no x in it
}

} // namespace touchstone::quadrature
