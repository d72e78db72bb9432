// SPDX-License-Identifier: MIT
#include "touchstone/quadrature/product_rule.hpp"

#include "touchstone/quadrature/ellipse_rule.hpp"
#include "touchstone/quadrature/strip.hpp"
#include "touchstone/quadrature/upper.hpp"
#include "touchstone/quadrature/widen.hpp"

#include <algorithm>

namespace touchstone::quadrature::detail {
namespace {

constexpr double bits_per_digit = 3.3219281;

/// A ball of z in the plane: u = (1 + z)/2, r = (1 - z)/2, their logarithms symbols.
template <class V>
class Segment : public Frame<V> {
public:
    explicit Segment(const V& z)
        : Segment(half(V(1) + z), half(V(1) - z))
    {
    }
    Segment(V u, V r)
        : u_(std::move(u))
        , r_(std::move(r))
    {
    }
    V distance(Side s) const override { return s == Side::left ? u_ : r_; }
    V logarithm(Side) const override { return V::indeterminate(); }
    bool keeps_logarithms() const override { return true; }

private:
    static V half(V x)
    {
        if constexpr (std::same_as<V, ComplexBall>)
            acb_mul_2exp_si(x.get(), x.get(), -1);
        else
            arb_mul_2exp_si(x.get(), x.get(), -1);
        return x;
    }
    /// A power that is not an integer must stand before the whole.
    V power_by_log(Side, const Exponent&) const override { return V::indeterminate(); }
    V u_, r_;
};

bool is_exactly_zero(const Ball& x) { return arb_is_zero(x.get()) != 0; }
bool is_exactly_zero(const ComplexBall& z) { return acb_is_zero(z.get()) != 0; }

/// The part of a power that is left to the weight: a multiple of the distance is analytic.
Exponent singular_part(const Exponent& e)
{
    if (e < Exponent(0)) return e;
    return e - Exponent(e.num() / e.den());
}

/// The segment at a node of the rule, or at its mirror image, whose logarithms are kept.
class NodeOfSegment : public Segment<Ball> {
public:
    NodeOfSegment(const GaussNodes::Entry& e, bool mirrored) : Segment(mirrored ? -e.z : e.z), entry_(e), mirrored_(mirrored) {}
    Ball log_of_distance(Side s) const override { return entry_.log_of_share((s == Side::left) != mirrored_ ? Side::left : Side::right); }

private:
    const GaussNodes::Entry& entry_;
    bool mirrored_;
};

/// What stands beside which weight.
class Decomposition {
public:
    /// As it is about one point, a ball, in which no factor is exactly 0 but what is so everywhere; nothing if it is not integrable or not
    /// of the kind.
    static std::optional<Decomposition> of(const PanelIntegrand& f)
    {
        const Segment<ComplexBall> somewhere{ComplexBall(Ball(Rational(5, 13)))};
        const EndpointNumber<ComplexBall> g = f.on_strip(somewhere);
        if (!g.left().logs.is_zero() || !g.right().logs.is_zero()) return std::nullopt;
        SingularWeight w{singular_part(g.left().power), singular_part(g.right().power)};
        if (!w.has_integral()) return std::nullopt;
        Decomposition d;
        if (!g.factor_without_logarithm().is_finite()) return std::nullopt;
        if (!is_exactly_zero(g.factor_without_logarithm())) d.weights_.push_back(w);
        for (const auto& t : g.logarithms()) {
            if (t.left + t.right > most_logarithms) return std::nullopt;
            w.left_logarithms = t.left;
            w.right_logarithms = t.right;
            if (!is_exactly_zero(t.c)) d.weights_.push_back(w);
        }
        if (d.weights_.empty()) return std::nullopt;
        return d;
    }
    /// The same beside 1/sqrt(u r), where the weight is that times whole powers of u and r.
    static std::optional<Decomposition> beside_chebyshev(const PanelIntegrand& f)
    {
        auto d = of(f);
        if (!d || d->weights_.size() != 1) return std::nullopt;
        SingularWeight& w = d->weights_.front();
        if (w.left_logarithms != 0 || w.right_logarithms != 0 || w.left.den() != 2 || w.right.den() != 2) return std::nullopt;
        w.left = w.right = Exponent(Rational(-1, 2));
        return d;
    }
    const std::vector<SingularWeight>& weights() const { return weights_; }
    bool is_without_weight() const { return weights_.size() == 1 && weights_.front().is_one(); }
    /// Whether with each weight its mirror image is there.
    bool is_symmetric() const
    {
        return std::all_of(weights_.begin(), weights_.end(), [&](const SingularWeight& w) {
            return std::find(weights_.begin(), weights_.end(), w.mirrored()) != weights_.end();
        });
    }

    /// The factors beside the weights; non-finite where there is anything else.
    template <class V>
    void take(const EndpointNumber<V>& g, const Frame<V>& frame, std::vector<V>& c) const
    {
        c.assign(weights_.size(), V(0));
        if (is_exactly_zero(g.factor_without_logarithm()) && !g.has_logarithms()) return;
        const V power = analytic_part(g, frame);
        std::size_t found = 0;
        bool is_left_over = false;
        const auto place = [&](int left, int right, const V& factor) {
            const auto w = std::find_if(weights_.begin(), weights_.end(), [&](const SingularWeight& own) {
                return own.left_logarithms == left && own.right_logarithms == right;
            });
            if (w != weights_.end()) {
                c[static_cast<std::size_t>(w - weights_.begin())] = factor * power;
                ++found;
            }
            else
                is_left_over = is_left_over || !is_exactly_zero(factor);
        };
        place(0, 0, g.factor_without_logarithm());
        for (const auto& t : g.logarithms()) place(t.left, t.right, t.c);
        if (is_left_over || found != weights_.size()) c.assign(weights_.size(), V::indeterminate());
    }

private:
    static constexpr int most_logarithms = 4;

    /// u^p r^q over the weights' powers: an integer power of each.
    template <class V>
    V analytic_part(const EndpointNumber<V>& g, const Frame<V>& frame) const
    {
        V y(1);
        for (const Side s : {Side::left, Side::right}) {
            const Exponent own = s == Side::left ? weights_.front().left : weights_.front().right;
            const Exponent rest = g.order(s).power - own;
            if (!g.order(s).logs.is_zero() || !rest.is_integer() || rest < Exponent(0)) return V::indeterminate();
            if (!rest.is_zero()) y *= frame.power(s, rest);
        }
        return y;
    }
    std::vector<SingularWeight> weights_;
};

/// Whether the integrand is of the kind about an end, z = -1 or 1.
bool is_of_the_kind_at(long end, const PanelIntegrand& f, const Decomposition& d)
{
    std::vector<ComplexBall> c;
    ComplexBall z(end);
    constexpr double beside = 1e-3;
    widen(z, Ball::exactly(beside));
    const Segment<ComplexBall> there(z);
    d.take(f.on_strip(there), there, c);
    return std::all_of(c.begin(), c.end(), [](const ComplexBall& x) { return x.is_finite(); });
}

bool is_of_the_kind(const PanelIntegrand& f, const Decomposition& d)
{
    return is_of_the_kind_at(-1, f, d) && is_of_the_kind_at(1, f, d);
}

/// A part of the range, and what it is there.
struct WholePanel {
    Rational from, to;
    PanelIntegrand f;
    Decomposition d;
};

/// The sum of some panels.
struct Panels {
    Ball value{0}; ///< over u
    long evaluations = 0;
    std::string proof;
};

class ProductRule {
public:
    ProductRule(const MakePanel& make, const Options& options, double bits)
        : make_(make)
        , options_(options)
        , bits_(bits)
    {
    }
    /// False if a part is not of the kind, or takes too many nodes, even when it is cut.
    bool integrate(Panels& all) const;

private:
    bool cut_until_of_the_kind(const Rational& from, const Rational& to, int cuts, std::vector<WholePanel>& panels) const;
    bool add(const WholePanel& panel, int cuts, Panels& all) const;

    static constexpr int most_cuts = 2; // one after the other
    const MakePanel& make_;
    const Options& options_;
    double bits_;
};

EllipseFunction function_of_panel(const PanelIntegrand& f, const Decomposition& d)
{
    EllipseFunction g;
    g.weights = d.weights();
    g.is_even = f.is_even && d.is_symmetric();
    g.in_plane = [&](const EllipseBox& box, std::vector<ComplexBall>& c) {
        const Segment<ComplexBall> there(box.z);
        d.take(f.on_strip(there), there, c);
    };
    g.at_node = [&, values = std::vector<EndpointNumber<Ball>>(), prepared = slong(0)](const GaussNodes::Entry& e, bool mirrored,
                                                                                       std::vector<Ball>& c) mutable {
        if (prepared != WorkingPrecision::bits()) f.prepare();
        prepared = WorkingPrecision::bits();
        const NodeOfSegment there(e, mirrored);
        f.at_node(there, values);
        d.take(values.front(), there, c);
    };
    if (d.weights().size() > 1) g.nodes_a_box = 1; // numbers that keep logarithms take as long at a node as in the plane
    if (!f.straight_in_fraction) return g;
    if (d.is_without_weight())
        g.at_node = [&, by_parts = g.at_node](const GaussNodes::Entry& e, bool mirrored, std::vector<Ball>& c) {
            if (auto y = f.straight_in_fraction(e.z, mirrored)) c.assign(1, std::move(*y));
            else by_parts(e, mirrored, c);
        };
    else
        g.with_weight = [&](const GaussNodes::Entry& e, bool mirrored) { return f.straight_in_fraction(e.z, mirrored); };
    return g;
}

/// Of a part without singular ends that is even about one of them: z is the fraction of the part from there, so that the other half of
/// [-1, 1] is its mirror image.
EllipseFunction function_of_half(const PanelIntegrand& f, const Decomposition& d)
{
    const bool at_left = f.even->about == Side::left;
    EllipseFunction g;
    g.is_even = true;
    g.in_plane = [&](const EllipseBox& box, std::vector<ComplexBall>& c) { c.assign(1, f.even->in_plane(box.z)); };
    g.at_node = [&, at_left, values = std::vector<EndpointNumber<Ball>>(), prepared = slong(0)](
                    const GaussNodes::Entry& e, bool, std::vector<Ball>& c) mutable {
        if (f.straight_in_fraction)
            if (auto y = f.straight_in_fraction(e.z + e.z - Ball(1), !at_left)) {
                c.assign(1, std::move(*y));
                return;
            }
        if (prepared != WorkingPrecision::bits()) f.prepare();
        prepared = WorkingPrecision::bits();
        const Ball other = Ball(1) - e.z;
        const Segment<Ball> there = at_left ? Segment<Ball>(e.z, other) : Segment<Ball>(other, e.z);
        f.at_node(there, values);
        d.take(values.front(), there, c);
    };
    return g;
}

/// Where a part is cut that is of the kind at these ends. At one alone: close to it, for what stands beside the weights there, as of
/// K(1 - u) and log u, takes the dearer values and is singular at the other end, while the rest is ordinary.
Rational place_of_cut(const Rational& from, const Rational& to, bool at_left, bool at_right)
{
    const Rational beside(1, 8); // of the part
    const Rational width = to - from;
    if (at_left == at_right) return from + width / 2;
    return at_left ? Rational(from + beside * width) : Rational(to - beside * width);
}

bool ProductRule::cut_until_of_the_kind(const Rational& from, const Rational& to, int cuts, std::vector<WholePanel>& panels) const
{
    PanelIntegrand f = make_(from, to);
    Rational middle;
    {
        const WorkingPrecision precision(strip_bits);
        f.prepare();
        const auto d = Decomposition::of(f);
        if (!d) return false;
        const bool at_left = is_of_the_kind_at(-1, f, *d), at_right = is_of_the_kind_at(1, f, *d);
        if (at_left && at_right) {
            panels.push_back({from, to, std::move(f), *d});
            return true;
        }
        middle = place_of_cut(from, to, at_left, at_right);
    }
    return cuts > 0 && cut_until_of_the_kind(from, middle, cuts - 1, panels) && cut_until_of_the_kind(middle, to, cuts - 1, panels);
}

bool ProductRule::add(const WholePanel& panel, int cuts, Panels& all) const
{
    constexpr long most_nodes = 250; // a table of more costs more than tanh-sinh
    const bool is_half = panel.f.even && panel.d.is_without_weight();
    const EllipseFunction function = is_half ? function_of_half(panel.f, panel.d) : function_of_panel(panel.f, panel.d);
    if (const auto found = by_ellipse(function, bits_, options_.of_absolute, most_nodes)) {
        const WorkingPrecision precision(static_cast<slong>(bits_) + 64);
        const Ball half = Ball(1) / Ball(2);
        all.value += found->value * half;
        all.evaluations += found->nodes + found->pieces;
        all.proof += (all.proof.empty() ? "" : "; ") + found->proof(half);
        return true;
    }
    std::vector<WholePanel> halves;
    const Rational middle = (panel.from + panel.to) / 2;
    return cuts > 0 && cut_until_of_the_kind(panel.from, middle, 0, halves) && cut_until_of_the_kind(middle, panel.to, 0, halves) &&
           std::all_of(halves.begin(), halves.end(), [&](const WholePanel& half) { return add(half, cuts - 1, all); });
}

bool ProductRule::integrate(Panels& all) const
{
    std::vector<WholePanel> panels;
    return cut_until_of_the_kind(0, 1, most_cuts, panels) &&
           std::all_of(panels.begin(), panels.end(), [&](const WholePanel& panel) { return add(panel, most_cuts, all); });
}

} // namespace

std::optional<ProductIntegral> integrate_by_product_rule(const MakePanel& make, const Options& options)
{
    const double wanted = static_cast<double>(options.digits) * bits_per_digit + 1;
    Panels found;
    if (!ProductRule(make, options, wanted).integrate(found)) return std::nullopt;
    if (static_cast<double>(found.value.relative_bits()) < wanted - 1 && !options.of_absolute) return std::nullopt;
    return ProductIntegral{found.value, found.evaluations, found.proof};
}

std::optional<ProductIntegral> integrate_by_chebyshev(const PanelIntegrand& f, const Options& options)
{
    const long most_nodes = 200 + 4 * options.digits; // about as many as tanh-sinh takes
    std::optional<Decomposition> d;
    {
        const WorkingPrecision precision(strip_bits);
        f.prepare();
        d = Decomposition::beside_chebyshev(f);
        if (!d || !is_of_the_kind(f, *d)) return std::nullopt;
    }
    EllipseFunction g = function_of_panel(f, *d);
    g.weights = {SingularWeight{}};
    g.rule = GaussRule::chebyshev;
    if (f.straight)
        g.at_node = [&, by_parts = g.at_node](const GaussNodes::Entry& e, bool mirrored, std::vector<Ball>& c) {
            const auto y = mirrored ? f.straight(e.cosine, e.sine) : f.straight(e.sine, e.cosine);
            if (!y) return by_parts(e, mirrored, c);
            c.assign(1, *y / Ball(2)); // f dx/da is twice what stands beside du/sqrt(u r)
        };
    const double wanted = static_cast<double>(options.digits) * bits_per_digit + 1;
    const auto found = by_ellipse(g, wanted, options.of_absolute, most_nodes);
    if (!found || (static_cast<double>(found->value.relative_bits()) < wanted - 1 && !options.of_absolute)) return std::nullopt;
    return ProductIntegral{found->value, found->nodes + found->pieces, found->proof(Ball(1))};
}

} // namespace touchstone::quadrature::detail
