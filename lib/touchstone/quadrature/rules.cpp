// SPDX-License-Identifier: MIT
#include "touchstone/quadrature/rules.hpp"

#include "touchstone/quadrature/ellipse_rule.hpp"
#include "touchstone/quadrature/half_powers.hpp"
#include "touchstone/quadrature/parity.hpp"
#include "touchstone/quadrature/product_rule.hpp"
#include "touchstone/quadrature/real_formula.hpp"
#include "touchstone/quadrature/strip.hpp"
#include "touchstone/quadrature/upper.hpp"
#include "touchstone/quadrature/widen.hpp"

#include <algorithm>
#include <cmath>

namespace touchstone::quadrature {
namespace {

constexpr double bits_per_digit = 3.3219281;

double to_double(const Ball& x) { return arf_get_d(arb_midref(x.get()), ARF_RND_NEAR); }

/// x where the fraction of the range is u.
double place_of(const Range& r, double u)
{
    switch (r.map) {
    case Map::finite: return to_double(r.from.ball()) + u * to_double(r.to.ball() - r.from.ball());
    case Map::right_algebraic: return to_double(r.from.ball()) + u / (1 - u);
    case Map::right_exponential: return to_double(r.from.ball()) - std::log1p(-u);
    case Map::left_algebraic: return to_double(r.to.ball()) - u / (1 - u); // mirrored: u = 0 is the finite end
    case Map::left_exponential: return to_double(r.to.ball()) + std::log1p(-u);
    case Map::line_algebraic: return (u / (1 - u) - (1 - u) / u) / 2;
    case Map::line_exponential: break;
    }
    return std::log(u / (1 - u));
}

/// A proof calls left what is at u = 0, which on a half-line to -oo is the right end of the range.
std::string with_ends_of_the_range(std::string reason, Map map)
{
    if (map != Map::left_algebraic && map != Map::left_exponential) return reason;
    const std::string left = "left end", right = "right end";
    if (const auto at = reason.find(left); at != std::string::npos) return reason.replace(at, left.size(), right);
    if (const auto at = reason.find(right); at != std::string::npos) return reason.replace(at, right.size(), left);
    return reason;
}

Attempt attempt_of(const Enclosure& e, const Range& range)
{
    Attempt a;
    a.value = e.value;
    a.reason = with_ends_of_the_range(e.reason, range.map);
    const auto& panels = e.certificate.panels;
    a.part.rule =
        !panels.empty() && panels.front().transformation == Transformation::logistic ? "trapezoidal in the logarithm" : "tanh-sinh";
    a.part.certificate = e.certificate;
    a.part.evaluations = e.certificate.points();
    if (e.fraction)
        if (const double x = place_of(range, *e.fraction); std::isfinite(x)) a.at = x; // the range may end beyond all doubles
    return a;
}

} // namespace

std::optional<Attempt> by_gauss_legendre(const Integrand& f, bool complex, long digits, bool kinks, bool quick)
{
    struct Call {
        const Integrand* f;
        bool in_real_numbers, with_kinks;
        long evaluations = 0;
    } call{&f, !complex && !kinks, kinks};
    constexpr slong for_kinks = 16; // each kink adds an enclosure as wide as the tolerance
    const slong bits = bits_for_digits(digits) + (kinks ? for_kinks : 0);
    const WorkingPrecision precision(bits);
    const auto evaluate = [](acb_ptr out, const acb_t z, void* data, slong order, slong working) -> int {
        auto& c = *static_cast<Call*>(data);
        ++c.evaluations;
        // a box across which f varies in its first digits needs few bits (beside a step each bit tells on which side the box is)
        constexpr slong least = 64, spare = 40;
        const slong enough = std::max(least, std::min(acb_rel_accuracy_bits(z), working) + spare);
        const WorkingPrecision here(c.with_kinks ? working : std::min(working, enough));
        if (order == 0 && c.in_real_numbers && arb_is_zero(acb_imagref(z)) != 0) {
            Ball x;
            arb_set(x.get(), acb_realref(z));
            if (const Ball y = c.f->at_real(x); y.is_finite()) { // else about an end, where the powers of its distance must be kept
                acb_set_arb(out, y.get());
                return 0;
            }
        }
        ComplexBall argument;
        acb_set(argument.get(), z);
        acb_set(out, (order == 0 ? c.f->on_the_line(argument) : c.f->in_plane(argument)).get());
        return 0;
    };
    acb_calc_integrate_opt_t options;
    acb_calc_integrate_opt_init(options);
    // beyond these limits tanh-sinh, with a proof of its own, may still do better; each kink takes as many halvings as there are bits
    options->eval_limit = (4000 + 200 * digits) * (kinks ? 16 : 1);
    if (quick || f.has_inner_integral()) options->eval_limit = 400 + 20 * digits;
    options->depth_limit = kinks ? 2 * bits : 200;
    mag_t tolerance;
    mag_init(tolerance);
    mag_set_ui_2exp_si(tolerance, 1, -bits);
    ComplexBall value;
    const int status = acb_calc_integrate(value.get(), evaluate, &call, ComplexBall(f.range().from.ball()).get(),
                                          ComplexBall(f.range().to.ball()).get(), bits, tolerance, options, bits);
    mag_clear(tolerance);
    if (status != ARB_CALC_SUCCESS || !value.is_finite()) return std::nullopt;
    Attempt a;
    a.value = value.real();
    if (complex) a.imaginary = value.imag();
    a.part.rule = "gauss-legendre";
    a.part.evaluations = call.evaluations;
    return a;
}

std::optional<Attempt> by_one_ellipse(const Integrand& f, bool even, long digits, bool of_absolute)
{
    constexpr long most_nodes = 700; // the table of more costs too much
    const Range& range = f.range();
    struct Ends {
        Ball middle, half;
        slong bits = 0;
    } ends;
    const auto prepare = [&] {
        if (ends.bits == WorkingPrecision::bits()) return;
        const Ball from = range.from.ball(), to = range.to.ball();
        ends = {(from + to) / Ball(2), (to - from) / Ball(2), WorkingPrecision::bits()};
    };
    std::optional<StraightValues> straight;
    if (f.straight() != nullptr) straight.emplace(*f.straight(), range);
    EllipseFunction g;
    g.is_even = even;
    g.in_plane = [&](const EllipseBox& box, std::vector<ComplexBall>& c) {
        prepare();
        c.assign(1, f.in_plane_from(box.side, ComplexBall(ends.middle) + ComplexBall(ends.half) * box.z));
    };
    g.at_node = [&](const GaussNodes::Entry& e, bool mirrored, std::vector<Ball>& c) {
        prepare();
        if (straight)
            if (auto y = straight->on_the_line(e.z, mirrored)) {
                c.assign(1, std::move(*y));
                return;
            }
        c.assign(1, f.at_real(mirrored ? ends.middle - ends.half * e.z : ends.middle + ends.half * e.z));
    };
    const auto found = by_ellipse(g, static_cast<double>(digits) * bits_per_digit + 1, of_absolute, most_nodes);
    if (!found) return std::nullopt;
    const WorkingPrecision precision(bits_for_digits(digits) + 64);
    prepare();
    Attempt a;
    a.value = found->value * ends.half;
    a.part.proof = found->proof(ends.half);
    a.part.rule = "gauss-legendre on one ellipse";
    a.part.evaluations = found->nodes + found->pieces;
    return a;
}

std::optional<Attempt> by_half_powers(const std::shared_ptr<const Integrand>& f, bool even, long digits, bool of_absolute)
{
    Options options;
    options.digits = digits;
    options.of_absolute = of_absolute;
    const auto at = [f](const auto& x, const auto& left, const auto& right) { return f->at(x, left, right); };
    const auto interval = std::make_shared<Interval>(f->range().interval());
    detail::PanelIntegrand whole = detail::panel_integrand(at, interval, 0, 1);
    std::optional<StraightValues> straight;
    if (f->straight() != nullptr && f->range().map == Map::finite) {
        straight.emplace(*f->straight(), f->range());
        whole.straight = [&straight](const Ball& sine, const Ball& cosine) { return straight->in_angle(sine, cosine); };
    }
    whole.is_even = even;
    const auto e = detail::integrate_half_powers(whole, *interval, options);
    if (!e) return std::nullopt;
    Attempt a = attempt_of(*e, f->range());
    a.part.rule = e->rule;
    a.part.evaluations = e->evaluations;
    a.part.proof = e->proof;
    return a;
}

bool is_even_about_the_middle(const Expression& e, const Range& r)
{
    if (!r.from.exact || !r.to.exact) return false; // an end at infinity too
    return parity(e, (*r.from.exact + *r.to.exact) * ExactSum(Rational(1, 2))) == Parity::even;
}

bool begins_or_ends_at_zero(const Range& r)
{
    if (!r.from.exact || !r.to.exact) return false;
    return r.from.exact->is_zero() || r.to.exact->is_zero();
}

bool may_have_half_powers_alone(const std::shared_ptr<const Integrand>& f)
{
    const auto at = [f](const auto& x, const auto& left, const auto& right) { return f->at(x, left, right); };
    return detail::is_analytic_in_the_angle(detail::panel_integrand(at, std::make_shared<Interval>(f->range().interval()), 0, 1));
}

std::optional<Attempt> by_half_powers_on_both_sides(const ExpressionPtr& e, const Range& range, long digits, bool of_absolute)
{
    const Limit& far = range.from.exact->is_zero() ? range.to : range.from;
    const Limit mirrored = limit_at(-*far.exact, "-(" + far.text + ")");
    const bool to_the_right = range.from.exact->is_zero();
    const Range both{to_the_right ? mirrored : far, to_the_right ? far : mirrored, Map::finite};
    auto a = by_half_powers(std::make_shared<const Integrand>(e, both), true, digits, of_absolute);
    if (!a) return std::nullopt;
    arb_mul_2exp_si(a->value.get(), a->value.get(), -1);
    a->part.rule += ", both sides of 0";
    return a;
}

std::optional<PlainFormula> even_and_analytic_about_zero(const ExpressionPtr& e, const Range& r)
{
    if (!begins_or_ends_at_zero(r) || parity(*e) != Parity::even) return std::nullopt;
    constexpr double beside = 1e-3; // of the range
    const WorkingPrecision precision(strip_bits);
    const Ball nearby = upper_ball(r.to.ball() - r.from.ball()) * Ball::exactly(beside);
    PlainFormula plain(e);
    return plain.at(disc(nearby)).is_finite() ? std::optional(std::move(plain)) : std::nullopt;
}

std::optional<Attempt> by_product_rule(const std::shared_ptr<const Integrand>& f, bool even,
                                       const std::optional<PlainFormula>& even_about_zero, long digits, bool of_absolute)
{
    Options options;
    options.digits = digits;
    options.of_absolute = of_absolute;
    const auto at = [f](const auto& x, const auto& left, const auto& right) { return f->at(x, left, right); };
    const auto interval = std::make_shared<Interval>(f->range().interval());
    std::optional<StraightValues> straight;
    if (f->straight() != nullptr && f->range().map == Map::finite) straight.emplace(*f->straight(), f->range());
    const Side zero = even_about_zero && f->range().from.exact->is_zero() ? Side::left : Side::right;
    const detail::MakePanel make = [&](const Rational& from, const Rational& to) {
        detail::PanelIntegrand panel = detail::panel_integrand(at, interval, from, to);
        const bool is_whole = from == 0 && to == 1;
        panel.is_even = even && is_whole;
        if (even_about_zero && (zero == Side::left ? from == 0 : to == 1)) {
            const ComplexBall width((f->range().to.ball() - f->range().from.ball()) * Ball(Rational(to - from)));
            panel.even = {zero, [&even_about_zero, width](const ComplexBall& z) { return even_about_zero->at(z * width) * width; }};
        }
        if (straight && is_whole)
            panel.straight_in_fraction = [&straight](const Ball& z, bool mirrored) { return straight->in_fraction(z, mirrored); };
        else if (straight)
            panel.straight_in_fraction = [&straight, from, to](const Ball& z, bool mirrored) {
                return straight->in_part(from, to, z, mirrored);
            };
        return panel;
    };
    const auto e = detail::integrate_by_product_rule(make, options);
    if (!e) return std::nullopt;
    Attempt a;
    a.value = e->value;
    a.part.rule = "product integration";
    a.part.evaluations = e->evaluations;
    a.part.proof = e->proof;
    return a;
}

Attempt by_tanh_sinh(const std::shared_ptr<const Integrand>& f, bool complex, long digits, const IntegralOptions& wanted,
                     Transformation transformation)
{
    constexpr long quick_budget = 3000; // pieces, of an integrand that is itself an integral or stands inside one
    constexpr int quick_bisections = 2;
    Options options;
    options.digits = digits;
    options.of_absolute = wanted.of_absolute || wanted.quick || complex; // with_enough_digits looks at the modulus
    options.patient = wanted.patient;
    options.transformation = transformation;
    if (wanted.quick || f->has_inner_integral()) {
        options.proof_budget = quick_budget;
        options.bisections = quick_bisections;
    }
    if (!complex) {
        const auto at = [f](const auto& x, const auto& left, const auto& right) { return f->at(x, left, right); };
        const auto interval = std::make_shared<Interval>(f->range().interval());
        std::optional<StraightValues> straight;
        if (f->straight() != nullptr && f->range().map == Map::finite) straight.emplace(*f->straight(), f->range());
        const detail::MakePanel make = [&](const Rational& from, const Rational& to) {
            detail::PanelIntegrand panel = detail::panel_integrand(at, interval, from, to);
            if (straight && from == 0 && to == 1)
                panel.straight_beside = [&straight](Side end, const Ball& fraction) { return straight->beside(end, fraction); };
            return panel;
        };
        return attempt_of(detail::integrate(make, 1, *interval, options).front(), f->range());
    }
    const auto parts = [f](const auto& x, const auto& left, const auto& right) { return f->both_parts(x, left, right); };
    const std::vector<Enclosure> both = tanh_sinh_of_several(parts, 2, f->range().interval(), options);
    Attempt a = attempt_of(both[0], f->range());
    a.imaginary = both[1].value;
    if (!a.imaginary.is_finite()) a.value = Ball::indeterminate();
    return a;
}

std::vector<Attempt> by_one_tanh_sinh(const std::vector<std::shared_ptr<const Integrand>>& all, long digits)
{
    Options options;
    options.digits = digits;
    const auto values = [all](const auto& x, const auto& left, const auto& right) {
        std::vector<std::decay_t<decltype(x)>> r;
        for (const auto& f : all) r.push_back(f->at(x, left, right));
        return r;
    };
    std::vector<Attempt> attempts;
    const Range& range = all.front()->range();
    for (const Enclosure& e : tanh_sinh_of_several(values, all.size(), range.interval(), options)) attempts.push_back(attempt_of(e, range));
    return attempts;
}

std::vector<Map> maps_for(const Limit& from, const Limit& to, bool exponential)
{
    const auto either = [&](Map algebraic_map, Map exponential_map) {
        return exponential ? std::vector{exponential_map, algebraic_map} : std::vector{algebraic_map, exponential_map};
    };
    if (from.infinite && to.infinite) return either(Map::line_algebraic, Map::line_exponential);
    if (to.infinite) return either(Map::right_algebraic, Map::right_exponential);
    if (from.infinite) return either(Map::left_algebraic, Map::left_exponential);
    return {Map::finite};
}

bool names_exponential(const Expression& e)
{
    switch (e.op) {
    case Op::exp:
    case Op::expm1:
    case Op::sinh:
    case Op::cosh:
    case Op::tanh:
    case Op::coth:
    case Op::sech:
    case Op::csch:
    case Op::erf:
    case Op::erfc:
    case Op::airy_ai:
    case Op::bessel_k: return depends_on_x(e);
    case Op::power:
        if (depends_on_x(*e.args[1])) return true;
        break;
    default: break;
    }
    return std::any_of(e.args.begin(), e.args.end(), [](const ExpressionPtr& a) { return names_exponential(*a); });
}

bool names_logarithm(const Expression& e)
{
    const bool is_one = e.op == Op::log || e.op == Op::log1p || e.op == Op::elliptic_k || e.op == Op::elliptic_e ||
                        e.op == Op::bessel_k || e.op == Op::bessel_y;
    return is_one || std::any_of(e.args.begin(), e.args.end(), [](const ExpressionPtr& a) { return names_logarithm(*a); });
}

bool has_kinks(const Expression& e)
{
    if (e.op == Op::abs || e.op == Op::sign || e.op == Op::floor || e.op == Op::ceil || e.op == Op::max || e.op == Op::min) return true;
    return std::any_of(e.args.begin(), e.args.end(), [](const ExpressionPtr& a) { return has_kinks(*a); });
}

} // namespace touchstone::quadrature
