// SPDX-License-Identifier: MIT
#include "touchstone/quadrature/half_powers.hpp"

#include "touchstone/quadrature/ellipse_rule.hpp"
#include "touchstone/quadrature/product_rule.hpp"
#include "touchstone/quadrature/strip.hpp"
#include "touchstone/quadrature/upper.hpp"
#include "touchstone/quadrature/widen.hpp"

#include <algorithm>
#include <array>

namespace touchstone::quadrature::detail {
namespace {

/// A ball of angles a: u = sin^2 a, r = cos^2 a, u^(k/2) = sin^k a.
template <class V>
class Angle : public Frame<V> {
public:
    Angle(V sine, V cosine)
        : root_{std::move(sine), std::move(cosine)}
    {
    }
    V distance(Side s) const override { return analytic::integer_power(root(s), 2); }
    /// Of the angle about the end it is no analytic function.
    V logarithm(Side) const override { return V::indeterminate(); }
    const V& root(Side s) const { return root_[s == Side::left ? 0 : 1]; }

private:
    V power_by_log(Side s, const Exponent& e) const override
    {
        return e.den() == 2 ? analytic::integer_power(root(s), e.num()) : V::indeterminate();
    }
    std::array<V, 2> root_;
};

Angle<ComplexBall> angle_of(const ComplexBall& a)
{
    ComplexBall sine, cosine;
    acb_sin_cos(sine.get(), cosine.get(), a.get(), WorkingPrecision::bits());
    return {std::move(sine), std::move(cosine)};
}

/// f (dx/du) 2 sin a cos a: non-finite where that is not proved analytic.
template <class V>
V times_slope(const EndpointNumber<V>& g, const Angle<V>& a)
{
    V y = g.factor();
    for (const Side s : {Side::left, Side::right}) {
        if (!g.order(s).logs.is_zero()) return V::indeterminate();
        const Exponent power = g.order(s).power + g.order(s).power + Exponent(1); // of the sine or cosine
        if (!power.is_integer()) return V::indeterminate();
        if (!power.is_zero()) y *= analytic::integer_power(a.root(s), power.num());
    }
    return y + y;
}

constexpr double bits_per_digit = 3.3219281;

/// The integral over u by Gauss-Legendre in the angle.
std::optional<ProductIntegral> integrate_in_the_angle(const PanelIntegrand& f, const Options& options)
{
    // More nodes than that cost more than tanh-sinh's, and so does a table of them where the digits are many.
    const long most_nodes = options.digits <= 100 ? std::min(400L, 100 + 5 * options.digits) : 200;
    if (!is_analytic_in_the_angle(f)) return std::nullopt;
    EllipseFunction g;
    g.is_even = f.is_even;
    g.in_plane = [&](const EllipseBox& box, std::vector<ComplexBall>& c) {
        const Angle<ComplexBall> a(box.sine, box.cosine);
        c.assign(1, times_slope(f.on_strip(a), a));
    };
    std::vector<EndpointNumber<Ball>> values;
    slong prepared = 0;
    g.at_node = [&](const GaussNodes::Entry& e, bool mirrored, std::vector<Ball>& c) {
        if (f.straight) {
            const Ball &sine = mirrored ? e.cosine : e.sine, &cosine = mirrored ? e.sine : e.cosine;
            if (auto y = f.straight(sine, cosine)) {
                c.assign(1, std::move(*y));
                return;
            }
        }
        if (prepared != WorkingPrecision::bits()) f.prepare();
        prepared = WorkingPrecision::bits();
        const Angle<Ball> a(mirrored ? e.cosine : e.sine, mirrored ? e.sine : e.cosine);
        f.at_node(a, values);
        c.assign(1, times_slope(values.front(), a));
    };
    const double wanted = static_cast<double>(options.digits) * bits_per_digit + 1;
    const auto found = by_ellipse(g, wanted, options.of_absolute, most_nodes);
    if (!found) return std::nullopt;
    const WorkingPrecision precision(static_cast<slong>(wanted) + 64);
    const Ball quarter_turn = pi<Ball>() / Ball(4); // du = (pi/4) dt
    const Ball value = found->value * quarter_turn;
    if (static_cast<double>(value.relative_bits()) < wanted - 1 && !options.of_absolute) return std::nullopt;
    return ProductIntegral{value, found->nodes + found->pieces, found->proof(quarter_turn)};
}

} // namespace

bool is_analytic_in_the_angle(const PanelIntegrand& f)
{
    const WorkingPrecision precision(strip_bits);
    f.prepare();
    for (const bool at_left : {true, false}) {
        ComplexBall a(at_left ? Ball(0) : pi<Ball>() / Ball(2));
        constexpr double beside = 1e-3;
        widen(a, Ball::exactly(beside));
        const Angle<ComplexBall> angle = angle_of(a);
        if (!times_slope(f.on_strip(angle), angle).is_finite()) return false;
    }
    return true;
}

std::optional<HalfPowers> integrate_half_powers(const PanelIntegrand& f, const Interval& interval, const Options& options)
{
    auto found = integrate_by_chebyshev(f, options);
    const bool by_chebyshev = found.has_value();
    if (!by_chebyshev) found = integrate_in_the_angle(f, options);
    if (!found) return std::nullopt;
    HalfPowers e;
    e.value = found->value;
    e.rule = by_chebyshev ? "gauss-chebyshev" : "gauss-legendre in the angle";
    e.proof = found->proof;
    e.evaluations = found->evaluations;
    const double have = static_cast<double>(e.value.relative_bits());
    e.digits = std::min(options.digits, static_cast<long>(have / bits_per_digit));
    e.status = e.digits == options.digits ? Status::certified : Status::undecided;
    e.certificate.interval = interval.to_string();
    e.certificate.digits = options.digits;
    return e;
}

} // namespace touchstone::quadrature::detail
