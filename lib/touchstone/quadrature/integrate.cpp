// SPDX-License-Identifier: MIT
#include "touchstone/quadrature/integrate.hpp"

#include "touchstone/quadrature/branch_cut.hpp"
#include "touchstone/quadrature/expression_tree.hpp"
#include "touchstone/quadrature/oscillation.hpp"
#include "touchstone/quadrature/parity.hpp"
#include "touchstone/quadrature/rules.hpp"
#include "touchstone/quadrature/substitution.hpp"
#include "touchstone/quadrature/upper.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

namespace touchstone::quadrature {
namespace {

constexpr double bits_per_digit = 3.3219281;

std::string short_number(double x)
{
    std::ostringstream out;
    out.precision(10);
    out << x;
    return out.str();
}

std::string as_exponent(const Rational& q) { return q.get_den() == 1 ? q.get_str() : std::string("(").append(q.get_str()).append(")"); }

double to_double(const Ball& x) { return arf_get_d(arb_midref(x.get()), ARF_RND_NEAR); }

/// Whether something that abs, sign, max, min, a root or a logarithm is taken of vanishes there, exactly.
bool changes_branch(const Expression& e, const ExactSum& at)
{
    const auto vanishes = [&](const Expression& a) {
        const auto s = expand(a, at, 1);
        return s && s->valuation > 0;
    };
    const bool is_root = e.op == Op::sqrt || e.op == Op::cbrt || (e.op == Op::power && !depends_on_x(*e.args[1]));
    if ((e.op == Op::abs || e.op == Op::sign || e.op == Op::log || is_root) && vanishes(*e.args[0])) return true;
    if (e.op == Op::max || e.op == Op::min)
        for (std::size_t i = 1; i < e.args.size(); ++i)
            if (vanishes(*make(Op::add, {e.args[0], make(Op::negate, {e.args[i]})}))) return true;
    return std::any_of(e.args.begin(), e.args.end(), [&](const ExpressionPtr& a) { return changes_branch(*a, at); });
}

/// Whether a < b: exact numbers that differ are told apart however near they are, others by some thousand digits.
bool is_less(const Limit& a, const Limit& b)
{
    if (a.infinite || b.infinite) return a.infinite < b.infinite;
    const auto gap = a.exact && b.exact ? std::optional(*b.exact - *a.exact) : std::nullopt;
    if (gap && gap->is_zero()) return false;
    constexpr slong first_bits = 256, most_bits = 1 << 14;
    for (slong bits = first_bits; bits <= most_bits; bits *= 2) {
        const WorkingPrecision precision(bits);
        const Ball width = gap ? gap->ball() : b.ball() - a.ball();
        if (!width.contains_zero()) return arb_is_positive(width.get()) != 0;
    }
    return false;
}

/// Whether so little of the range's ends differs that x is better counted from one of them.
bool is_narrow(const Limit& from, const Limit& to)
{
    if (from.infinite || to.infinite || !from.exact || !to.exact) return false;
    constexpr slong equal_bits = 24; // of the 53 with which proofs are made
    const Ball size = abs(from.ball());
    Ball width = (*to.exact - *from.exact).ball();
    arb_mul_2exp_si(width.get(), width.get(), equal_bits);
    return arb_lt(width.get(), size.get()) != 0;
}

/// How far from the start the path is first tried to turn: a power of two. The part before it holds some waves of the highest frequency, which
/// take few points more, and the amplitude's singularities are that far from the turned path, which takes fewer. A Hankel function
/// costs the same anywhere and gains nothing.
long nearest_turn(const std::vector<Wave>& waves)
{
    constexpr double radians = 16; // of the fastest wave: two to three waves
    double most = 1; // slower ones are not waited for
    for (const Wave& w : waves) {
        if (w.kernel == Op::number) continue;
        if (w.kernel == Op::bessel_j || w.kernel == Op::bessel_y) return 1;
        most = std::max(most, std::fabs(to_double(w.frequency.ball())));
    }
    long distance = 1;
    while (2 * static_cast<double>(distance) * most <= radians) distance *= 2;
    return distance;
}

class Integration {
public:
    Integration(const ExpressionPtr& e, const IntegralOptions& o, bool substituted = false)
        : e_(with_shared_parts(e))
        , options_(o)
        , substituted_(substituted)
        , complex_(!is_real(*e) || has_complex_point(*e))
    {
    }
    Integral run(const Limit& from, const Limit& to);

private:
    Integral over(const Limit& from, const Limit& to, bool reversed);
    /// Parts between neighbouring cuts; false with a reason if one fails.
    bool add_part(const Limit& from, const Limit& to, long digits, int depth, Integral& out);
    bool add_cut(const Limit& from, const Limit& to, const ExactSum& at, long digits, int depth, Integral& out);
    bool add_oscillating_tail(const Limit& from, const Limit& to, long digits, int depth, Integral& out);
    bool add_about_infinity(const Limit& from, const Limit& to, bool left, long digits, int depth, Integral& out);
    bool add_in_a_power(const Limit& from, const Limit& to, long digits, Integral& out);
    bool add_of_another(const ExpressionPtr& e, const Limit& from, const Limit& to, const std::string& in, long digits, Integral& out,
                        bool is_substituted = true);
    bool add_counted_from_an_end(const Limit& from, const Limit& to, long digits, Integral& out);
    Attempt attempt(const Limit& from, const Limit& to, long digits) const;
    bool add_parts_by_themselves(const Limit& from, const Limit& to, long digits, int depth, Integral& out);
    std::optional<ExactSum> named_point(double x, const Limit& from, const Limit& to) const;
    bool diverges(const Limit& end, int direction, Integral& out) const;

    ExpressionPtr e_;
    const IntegralOptions& options_;
    bool substituted_; // one change of variable is enough
    bool complex_;
};

/// Whether an exact expansion at the end shows an exponent of -1 or less; at infinity, in t = 1/abs(x), of the formula with dx/dt.
bool Integration::diverges(const Limit& end, int direction, Integral& out) const
{
    if (end.infinite) {
        const ExpressionPtr t = make_variable(), x = make(Op::divide, {make_number(Rational(end.infinite)), t});
        const auto s = expand(*make(Op::divide, {substituted(e_, x), make(Op::multiply, {t, t})}), ExactSum(0), 1);
        if (!s || s->c.empty() || s->valuation > -1) return false;
        const Rational power = -s->valuation - 2;
        out.divergent = true;
        out.reason = "the integral diverges at x = " + end.text + ": the formula behaves there like |x|^" +
                     as_exponent(power);
        return true;
    }
    if (!end.exact) return false;
    const auto s = expand(*e_, *end.exact, direction);
    if (!s) return false;
    if (s->c.empty() || s->valuation > -1) return false;
    out.divergent = true;
    out.reason = "the integral diverges at x = " + end.text + ": the formula behaves there like |x - " + end.text + "|^" +
                 as_exponent(s->valuation);
    if (s->valuation == -1) out.reason += " (inside the range, --principal-value " + end.text + " gives Cauchy's value)";
    return true;
}

Attempt Integration::attempt(const Limit& from, const Limit& to, long digits) const
{
    Attempt first;
    const std::vector<Map> maps = maps_for(from, to, names_exponential(*e_));
    for (const Map map : maps) {
        const auto f = std::make_shared<const Integrand>(e_, Range{from, to, map});
        const bool regular = f->is_regular_at_ends(), kinks = has_kinks(*e_);
        const bool plain = options_.gauss_legendre && !complex_ && !kinks && !options_.quick && !f->has_inner_integral();
        if (plain) {
            const bool algebraic = map != Map::right_exponential && map != Map::left_exponential && map != Map::line_exponential;
            const bool even = is_even_about_the_middle(*e_, f->range());
            std::optional<Attempt> a;
            if (regular)
                a = by_one_ellipse(*f, even, digits, options_.of_absolute);
            else if (algebraic) {
                const bool even_about_zero = begins_or_ends_at_zero(f->range()) && parity(*e_) == Parity::even;
                // both sides are another integrand, which a glance at this one may save
                if (even_about_zero && (!names_logarithm(*e_) || may_have_half_powers_alone(f)))
                    a = by_half_powers_on_both_sides(e_, f->range(), digits, options_.of_absolute);
                if (!a || !a->value.is_finite()) a = by_half_powers(f, even, digits, options_.of_absolute);
            }
            if (a && a->value.is_finite()) return *a;
            if (!regular)
                a = by_product_rule(f, even, even_and_analytic_about_zero(e_, f->range()), digits, options_.of_absolute);
            if (a && a->value.is_finite()) return *a;
        }
        const auto gauss_legendre = [&] { return by_gauss_legendre(*f, complex_, digits, kinks, options_.quick); };
        if (options_.gauss_legendre && regular) {
            if (auto a = gauss_legendre()) return *a;
            if (options_.quick) return first; // a ball of the outer variable so wide that nothing is proved
        }
        Attempt a = by_tanh_sinh(f, complex_, digits, options_);
        if (a.value.is_finite()) return a;
        if (options_.gauss_legendre && !regular && kinks && map == Map::finite)
            if (auto b = gauss_legendre()) return *b;
        if (map == maps.front()) first = std::move(a);
    }
    return first;
}

/// Where the two parts want different cuts, or turned paths, they are two integrals.
bool Integration::add_parts_by_themselves(const Limit& from, const Limit& to, long digits, int depth, Integral& out)
{
    IntegralOptions absolute = options_;
    absolute.of_absolute = true;
    Integral whole = out;
    for (const Op op : {Op::real_value, Op::imaginary_value}) {
        Integral one;
        const bool added = Integration(make(op, {e_}), absolute, substituted_).add_part(from, to, digits, depth, one);
        if (!added) {
            out.reason = one.reason;
            out.divergent = one.divergent;
            return false;
        }
        for (Part& p : one.parts) {
            if (op == Op::imaginary_value) std::swap(p.value, p.imaginary);
            p.rule += op == Op::real_value ? " (real part)" : " (imaginary part)";
            whole.parts.push_back(std::move(p));
        }
    }
    out = std::move(whole);
    return true;
}

/// A rational number or multiple of pi close to where a proof stopped, or a simple fraction of the range: a candidate for a cut.
std::optional<ExactSum> Integration::named_point(double x, const Limit& from, const Limit& to) const
{
    const bool finite = !from.infinite && !to.infinite;
    const double scale = finite ? to_double(to.ball() - from.ball()) : std::max(1.0, std::fabs(x));
    const auto inside = [&](const ExactSum& p) {
        const Ball v = p.ball();
        return (from.infinite || arb_gt(v.get(), from.ball().get())) && (to.infinite || arb_lt(v.get(), to.ball().get()));
    };
    const auto is_singular_at = [&](const ExactSum& p) {
        if (!inside(p)) return false;
        const auto right = expand(*e_, p, 1);
        const auto plain = evaluate_at(*e_, p.ball());
        if (!plain.is_finite() || (right && right->valuation < 0)) return true; // the formula itself is singular there
        return changes_branch(*e_, p);
    };
    constexpr std::array denominators{1L, 2L, 3L, 4L, 5L, 6L, 7L, 8L, 9L, 10L, 11L, 12L, 16L, 20L, 25L, 32L, 50L, 64L, 100L, 1000L};
    /// start + n/den unit, where that is as close to x as it can be meant to be
    const auto near_x = [&](const ExactSum& start, const ExactSum& unit, long den) -> std::optional<ExactSum> {
        const double step = to_double(unit.ball()) / static_cast<double>(den), away = to_double(Ball::exactly(x) - start.ball());
        const double n = std::round(away / step);
        if (!(std::fabs(n) <= 1e6) || std::fabs(n * step - away) > 2e-2 * scale / static_cast<double>(den)) return std::nullopt;
        Rational q(static_cast<long>(n), den);
        q.canonicalize();
        return start + ExactSum(q) * unit;
    };
    std::vector<std::pair<ExactSum, ExactSum>> grids{{ExactSum(0), ExactSum(1)}, {ExactSum(0), ExactSum::pi()}};
    if (finite && from.exact && to.exact) grids.emplace_back(*from.exact, *to.exact - *from.exact);
    for (const auto& [start, unit] : grids)
        for (const long den : denominators)
            if (auto p = near_x(start, unit, den); p && is_singular_at(*p)) return p;
    return std::nullopt;
}

bool Integration::add_cut(const Limit& from, const Limit& to, const ExactSum& at, long digits, int depth, Integral& out)
{
    const Limit middle = limit_at(at, text_of(at));
    return add_part(from, middle, digits, depth + 1, out) && add_part(middle, to, digits, depth + 1, out);
}

/// The parts of another formula's integral; `in` says what its variable is.
bool Integration::add_of_another(const ExpressionPtr& e, const Limit& from, const Limit& to, const std::string& in, long digits,
                                 Integral& out, bool is_substituted)
{
    IntegralOptions options;
    options.digits = digits;
    options.gauss_legendre = options_.gauss_legendre;
    Integral other = Integration(e, options, is_substituted).run(from, to);
    if (!other.value.is_finite()) return false;
    for (Part& p : other.parts) {
        p.rule += in;
        out.parts.push_back(std::move(p));
    }
    return true;
}

/// f as a sum of waves on [from, oo): the ordinary integral up to X, from there along X + is (oscillation.hpp).
bool Integration::add_oscillating_tail(const Limit& from, const Limit& to, long digits, int depth, Integral& out)
{
    const bool has_start = from.infinite == 0, has_end = to.infinite == 0;
    if (has_start == has_end) return false;
    if (has_end) {
        if (!to.exact) return false;
        const auto mirrored = shifted(e_, ExactSum(0), -1);
        if (!waves(mirrored)) return false;
        IntegralOptions options;
        options.digits = digits;
        Integral other;
        const ExactSum start = -*to.exact;
        if (!Integration(mirrored, options, true)
                 .add_oscillating_tail(limit_at(start, text_of(start)), parse_limit("inf"), digits, depth, other))
            return false;
        for (Part& p : other.parts) {
            p.rule += " in -x";
            out.parts.push_back(std::move(p));
        }
        return true;
    }
    const auto all = waves(e_);
    if (!all) return false;
    const double start = to_double(from.ball());
    constexpr double farthest_start = 1e9;
    if (!(std::fabs(start) < farthest_start)) return false;
    const long base = static_cast<long>(std::ceil(start));
    constexpr long farthest = 4096;
    for (long distance = nearest_turn(*all); distance <= farthest; distance *= 2) {
        std::vector<std::pair<const Wave*, Ball>> turned;
        ExpressionPtr steady;
        bool proved = true;
        for (const Wave& w : *all) {
            if (w.kernel == Op::number) {
                steady = steady ? make(Op::add, {steady, w.amplitude}) : w.amplitude;
                continue;
            }
            const auto supremum = supremum_in_quadrant(w, base, distance);
            if (!(proved = supremum.has_value())) break;
            turned.emplace_back(&w, *supremum);
        }
        if (!proved) continue;
        const ExactSum x(base + distance);
        const Limit middle = limit_at(x, text_of(x));
        Integral whole = out;
        for (const auto& [wave, supremum] : turned) {
            const auto t = tail(*wave, base, distance, supremum, digits);
            if (!t) return false;
            const char* rule = "gauss-legendre on a turned path";
            whole.parts.push_back({middle.text, middle.text + "+i*inf", rule, t->value, {}, t->evaluations, {}});
        }
        if (steady && !add_of_another(steady, middle, to, "", digits, whole)) return false;
        if (!add_part(from, middle, digits, depth + 1, whole)) return false;
        out = std::move(whole);
        return true;
    }
    return false;
}

/// In t = 1/(distance to a singular end), which makes exp(-1/x) an exponential and sin(1/x) a wave: the whole range, or the half beside the
/// end with the rest as it is.
bool Integration::add_about_infinity(const Limit& from, const Limit& to, bool left, long digits, int depth, Integral& out)
{
    const Limit &end = left ? from : to, &other = left ? to : from;
    if (substituted_ || !end.exact || (!other.infinite && !other.exact)) return false;
    const std::string in =
        left ? std::string(" in 1/(x-").append(end.text).append(")") : std::string(" in 1/(").append(end.text).append("-x)");
    if (!other.infinite) // all of it, where the other end allows that
        if (const auto start = (*to.exact - *from.exact).inverse();
            start && add_of_another(about_infinity(e_, *end.exact, left ? 1 : -1), limit_at(*start, text_of(*start)), parse_limit("inf"),
                                    in, digits, out))
            return true;
    const ExactSum half = other.infinite ? *end.exact + ExactSum(left ? 1 : -1) : (*from.exact + *to.exact) * ExactSum(Rational(1, 2));
    const auto start = (left ? half - *end.exact : *end.exact - half).inverse();
    const auto f = about_infinity(e_, *end.exact, left ? 1 : -1);
    if (!start) return false;
    const Limit middle = limit_at(half, text_of(half));
    Integral whole = out;
    if (!add_of_another(f, limit_at(*start, text_of(*start)), parse_limit("inf"), in, digits, whole)) return false;
    if (!(left ? add_part(middle, to, digits, depth + 1, whole) : add_part(from, middle, digits, depth + 1, whole))) return false;
    out = std::move(whole);
    return true;
}

/// A tail with waves or exponentials of x^m, in t = x^m.
bool Integration::add_in_a_power(const Limit& from, const Limit& to, long digits, Integral& out)
{
    const Limit& end = to.infinite ? from : to;
    const ExactSum direction(to.infinite ? 1 : -1);
    if (substituted_ || !end.exact || end.infinite || arb_is_negative((direction * *end.exact).ball().get())) return false;
    const ExpressionPtr f = to.infinite ? e_ : shifted(e_, ExactSum(0), -1);
    const auto m = power_in_arguments(*f);
    const auto start = m ? exact_value(*make(Op::power, {formula_of(direction * *end.exact), make_number(*m)})) : std::nullopt;
    if (!start) return false;
    const std::string in = std::string(" in ").append(to.infinite ? "x" : "(-x)").append("^").append(
        as_exponent(*m));
    return add_of_another(in_power(f, *m), limit_at(*start, text_of(*start)), parse_limit("inf"), in, digits, out);
}

/// A narrow range in the distance to its left end: balls of x itself would hold little of where in the range they are.
bool Integration::add_counted_from_an_end(const Limit& from, const Limit& to, long digits, Integral& out)
{
    if (options_.quick || !is_narrow(from, to)) return false;
    const ExactSum width = *to.exact - *from.exact;
    const std::string in = std::string(" in x-(").append(from.text).append(")");
    return add_of_another(shifted(e_, *from.exact, 1), parse_limit("0"), limit_at(width, text_of(width)), in, digits, out, substituted_);
}

bool Integration::add_part(const Limit& from, const Limit& to, long digits, int depth, Integral& out)
{
    if (add_counted_from_an_end(from, to, digits, out)) return true;
    const auto take = [&](Attempt& done) {
        done.part.from = from.text;
        done.part.to = to.text;
        done.part.value = done.value;
        done.part.imaginary = done.imaginary;
        out.parts.push_back(std::move(done.part));
        return true;
    };
    Attempt a = attempt(from, to, digits);
    if (a.value.is_finite()) return take(a);
    if (diverges(from, 1, out) || diverges(to, -1, out)) return false;
    if (options_.quick) {
        out.reason = a.reason;
        return false;
    }
    if (any_node(*e_, [](const Expression& n) { return n.op == Op::integral; })) {
        out.reason = "not proved on [" + from.text + ", " + to.text + "]" + (a.at ? " near x = " + short_number(*a.at) : "") +
                     ": the inner integral is not proved analytic in x about the path (its integrand must be analytic in both variables, "
                     "a singular end of it must not move with x, nor may it be singular at an end of the outer range)";
        return false;
    }
    constexpr int deepest = 4;
    if (depth < deepest && a.at)
        if (const auto cut = named_point(*a.at, from, to)) return add_cut(from, to, *cut, digits, depth, out);
    if (complex_) return add_parts_by_themselves(from, to, digits, depth, out);
    if (add_oscillating_tail(from, to, digits, depth, out) || add_in_a_power(from, to, digits, out)) return true;
    for (const bool left : {true, false})
        if (depth <= deepest && a.reason.find(left ? "left end" : "right end") != std::string::npos && !(left ? from : to).infinite &&
            add_about_infinity(from, to, left, digits, depth, out))
            return true;
    if (depth < deepest) {
        if (from.infinite && to.infinite) return add_cut(from, to, ExactSum(0), digits, depth, out);
        // the two ends may ask for different maps
        if (to.infinite && from.exact && depth < 2) {
            Integral other = out;
            if (add_cut(from, to, *from.exact + ExactSum(1), digits, deepest - 1, other)) {
                out = std::move(other);
                return true;
            }
        }
    }
    // what is analytic in a sector only, as exp(-x) besseli(0, x), or has poles beside the whole range, as tanh(x)/(1 + x^2)
    if (from.infinite != to.infinite) {
        const auto f = std::make_shared<const Integrand>(e_, Range{from, to, to.infinite ? Map::right_algebraic : Map::left_algebraic});
        if (Attempt b = by_tanh_sinh(f, false, digits, options_, Transformation::logistic); b.value.is_finite()) return take(b);
    }
    const bool infinite = from.infinite || to.infinite; // on a finite range it is an oscillation, which bits do not help
    if (infinite && a.reason.find("huge next to") != std::string::npos && !options_.patient) {
        IntegralOptions patient = options_;
        patient.patient = true;
        if (Integration(e_, patient, substituted_).add_part(from, to, digits, deepest, out)) return true;
    }
    if (const auto cut = argument_on_cut(e_, from, to)) a.reason = *cut;
    else if (a.reason.find(" end ") != std::string::npos) // what can be done about an end
        a.reason +=
            from.infinite || to.infinite
                ? " (a tail that oscillates must be a sum of products of sin, cos, besselj of a linear argument, or of one power of x, "
                  "with what tends to 0 as a power; one like exp(-log(x)^2) is not taken: substitute)"
                : " (if it is singular there in another way than powers, logarithms and exp(-1/x), substitute)";
    out.reason = "not proved on [" + from.text + ", " + to.text + "]" + (a.at ? " near x = " + short_number(*a.at) : "") + ": " + a.reason;
    return false;
}

Integral Integration::run(const Limit& from, const Limit& to)
{
    {
        const WorkingPrecision precision(256);
        const bool same = (from.exact && to.exact && *from.exact == *to.exact) || (from.infinite != 0 && from.infinite == to.infinite);
        if (same && from.infinite) throw DomainError("the range from " + from.text + " to " + to.text + " holds no number");
        if (same) { // nothing to integrate over
            Integral nothing;
            nothing.value = Ball(0);
            nothing.status = Status::certified;
            nothing.digits = options_.digits;
            return nothing;
        }
    }
    return is_less(to, from) ? over(to, from, true) : over(from, to, false);
}

/// Of a range that is not empty; `reversed`: with the other sign.
Integral Integration::over(const Limit& from, const Limit& to, bool reversed)
{
    std::vector<Limit> cuts;
    {
        const WorkingPrecision precision(256);
        if (!is_less(from, to)) throw DomainError("the ends " + from.text + " and " + to.text + " cannot be told apart");
        cuts = options_.at;
        for (const Limit& c : cuts)
            if (c.infinite || !is_less(from, c) || !is_less(c, to))
                throw DomainError("the break point " + c.text + " is not between " + from.text + " and " + to.text);
        for (const ExactSum& x : branch_points(*e_, from, to)) cuts.push_back(limit_at(x, text_of(x)));
        std::sort(cuts.begin(), cuts.end(), is_less);
        const auto same = [](const Limit& a, const Limit& b) { return !is_less(a, b); };
        cuts.erase(std::unique(cuts.begin(), cuts.end(), same), cuts.end());
        cuts.insert(cuts.begin(), from);
        cuts.push_back(to);
    }
    return with_enough_digits(options_, [&](long digits, Integral& whole) {
        whole.parts.clear();
        for (std::size_t i = 0; i + 1 < cuts.size(); ++i)
            if (!add_part(cuts[i], cuts[i + 1], digits, 0, whole)) {
                whole.value = Ball::indeterminate();
                return false;
            }
        const WorkingPrecision precision(bits_for_digits(digits) + 64);
        whole.value = Ball(0);
        whole.imaginary = Ball(0);
        whole.is_complex = complex_;
        for (const Part& p : whole.parts) {
            whole.value += p.value;
            whole.imaginary += p.imaginary;
        }
        return true;
    }, reversed);
}

/// Whether the error is within the tolerance, if there is one.
bool is_within_tolerance(const Integral& i, const IntegralOptions& options)
{
    if (!options.tolerance) return false;
    const Ball error = radius_of(ComplexBall(i.value, i.imaginary));
    return arb_le(error.get(), Ball(*options.tolerance).get()) != 0;
}

/// log2 of the modulus over the error, about.
slong bits_of(const Integral& i)
{
    return i.is_complex ? acb_rel_accuracy_bits(ComplexBall(i.value, i.imaginary).get()) : i.value.relative_bits();
}

} // namespace

Integral negated(Integral i)
{
    i.value = -i.value;
    i.imaginary = -i.imaginary;
    for (Part& p : i.parts) {
        p.value = -p.value;
        p.imaginary = -p.imaginary;
        std::swap(p.from, p.to);
    }
    std::reverse(i.parts.begin(), i.parts.end());
    return i;
}

Integral with_enough_digits(const IntegralOptions& options, const std::function<bool(long, Integral&)>& attempt, bool reversed)
{
    Integral out;
    const double wanted = static_cast<double>(options.digits) * bits_per_digit + 1;
    long digits = options.digits;
    std::optional<double> last_shortfall;
    constexpr int most_rounds = 4; // parts that cancel are repeated with more digits
    for (int round = 0; round < most_rounds; ++round) {
        if (!attempt(digits, out)) return out;
        if (reversed) out = negated(std::move(out));
        const double shortfall = wanted - static_cast<double>(bits_of(out));
        if (shortfall <= 0 || is_within_tolerance(out, options) || options.of_absolute || options.quick) break;
        if (last_shortfall && shortfall > *last_shortfall - 1) break; // a parameter that is a ball: more digits don't help
        constexpr int rounds_for_zero = 2; // what they do not tell from 0 may be 0
        if (round + 1 >= rounds_for_zero && out.value.contains_zero() && out.imaginary.contains_zero()) break;
        last_shortfall = shortfall;
        digits += std::min<long>(static_cast<long>(shortfall / bits_per_digit) + 3, 2 * options.digits + 20);
    }
    const double have = static_cast<double>(bits_of(out));
    const bool exact = out.value.is_exact() && out.imaginary.is_exact();
    out.digits = exact ? options.digits : std::clamp(static_cast<long>(std::floor(have / bits_per_digit)), 0L, options.digits);
    const bool enough = out.digits == options.digits || is_within_tolerance(out, options);
    out.status = enough ? Status::certified : Status::undecided;
    const long shown = out.digits + 3;
    if (!enough)
        out.reason = (out.digits == 0 ? std::string("none") : "only " + std::to_string(out.digits)) + " of " +
                     std::to_string(options.digits) + " digits proven: the integral lies in " + out.value.to_string(shown) +
                     (out.is_complex ? " + i " + out.imaginary.to_string(shown) : "") +
                     (out.value.contains_zero() ? ", which may be 0: ask for an absolute error with --tolerance" : "");
    return out;
}

Integral integrate(const ExpressionPtr& e, const Limit& from, const Limit& to, const IntegralOptions& options)
{
    if (options.principal_value.empty()) return Integration(e, options).run(from, to);
    return is_less(to, from) ? principal_value(e, to, from, options, true) : principal_value(e, from, to, options, false);
}

} // namespace touchstone::quadrature
