// SPDX-License-Identifier: MIT
// Compiled with -O3 -fno-math-errno -ffp-contract=off, as wave_kernel.cpp.
#include "touchstone/transfer/two_waves.hpp"

#include "touchstone/scalar/refusal.hpp"
#include "touchstone/transfer/disc.hpp"
#include "touchstone/transfer/ellipse_cover.hpp"
#include "touchstone/wave/lemmas.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

namespace touchstone::transfer {
namespace {

using Real = TwoWaves::Real;
using std::max, std::min;

using namespace bounds;
constexpr double rho = 3;              // of the ellipse on which the integrand of a panel is bounded
constexpr std::size_t most_cuts = 200; // panels of one half
constexpr slong end_bits = 384; // 106 bits are left of distances down to 1e-70, the square of the finest tolerance and its shares

/// Where the integrand is not smooth. lower: P^2/4, bottom: P - 1, top: P + 1 (second wave); begin, end: of the first; seam: 1.
enum class Point { lower, bottom, top, begin, end, seam };

struct Unclear {}; ///< two points cannot be told from one another

/// One half of a piece of the integral.
struct Side {
    bool full, left; ///< y >= 1; seen from its left end
    Point from;      ///< the end
    Point near[2];   ///< singular points at it and beyond, the nearest first
    int nears;
    bool paired;     ///< near[1] is delta away from near[0]; else a point is made up
    double delta;
    Point to;        ///< the other end of the piece
    Point far[2];    ///< singular points there and beyond
    int fars;
};

/// The numbers of a half at one x.
template <class S>
struct Half {
    bool full_first, full, left, made_up, second;
    int fars;
    S x, one_minus_x, G, P;
    S from, to_one, wave_end; ///< the end, 1 - end, and where the first wave ends
    S quarter, beyond;        ///< delta/4; distance of the made-up point from the end
    S gap, far[2];            ///< distances from the end
    S tau0, s0, length;       ///< the variable runs from tau0 to tau0 + length; s = tau - 1/tau
};

template <class S>
struct Roots { ///< of a quotient of products
    S above{1}, below{1};
    TOUCHSTONE_INLINE void up(const S& v) { above = above * v; }
    TOUCHSTONE_INLINE void down(const S& v) { below = below * v; }
    TOUCHSTONE_INLINE S value() const { return sqrt(above / below); }
};
template <>
struct Roots<Disc> {
    Disc above{1}, below{1};
    void up(const Disc& v) { above = above * sqrt(v); }
    void down(const Disc& v) { below = below * sqrt(v); }
    Disc value() const { return above / below; }
};

/// pi^2 times the integrand, at tau0 + eta.
template <class S>
TOUCHSTONE_INLINE S integrand(const Half<S>& h, const S& eta)
{
    const S tau = h.tau0 + eta, step = eta * (1 + 1 / (tau * h.tau0)), v = h.quarter * (step * (step + h.s0 + h.s0));
    const S y = h.left ? h.from + v : h.from - v;
    Roots<S> roots;
    S factor = 2 / tau;
    if (h.made_up) roots.up(h.beyond + v);
    if (h.second) roots.down(h.gap + v);
    for (int k = 0; k < h.fars; ++k) roots.down(h.far[k] - v);
    if (!h.full_first) {
        const S gy = h.G * y, r = sqrt(h.one_minus_x * h.one_minus_x + gy * gy);
        roots.up(1 + h.x + r);
        roots.down(h.wave_end + y);
        roots.down(r + h.one_minus_x);
        factor = factor * (gy / r);
    }
    if (!h.full) {
        const S rest = h.left ? h.to_one - v : h.to_one + v, r = sqrt(rest * rest + h.P * h.P);
        roots.up(1 + y + r);
        roots.down(rest + r);
        factor = factor * (h.P / (r + r));
    }
    return factor * roots.value();
}

TOUCHSTONE_INLINE Half<Four> spread(const Half<Real>& h)
{
    return {h.full_first,
            h.full,
            h.left,
            h.made_up,
            h.second,
            h.fars,
            Four(h.x),
            Four(h.one_minus_x),
            Four(h.G),
            Four(h.P),
            Four(h.from),
            Four(h.to_one),
            Four(h.wave_end),
            Four(h.quarter),
            Four(h.beyond),
            Four(h.gap),
            {Four(h.far[0]), Four(h.far[1])},
            Four(h.tau0),
            Four(h.s0),
            Four(h.length)};
}

TOUCHSTONE_CLONES
Real integral(const Half<Real>& half, const std::vector<double>& cuts, const Gauss& gauss)
{
    const Half<Four> h = spread(half);
    Four total{};
    for (std::size_t c = 0; c + 1 < cuts.size(); ++c) {
        const Real width = half.length * (Real(cuts[c + 1]) - Real(cuts[c])) * 0.5;
        const Four first(half.length * cuts[c]), unit(width);
        for (std::size_t i = 0; i < gauss.nodes.size(); i += 4) {
            total += unit * load(gauss.weights, i) * integrand(h, first + unit * (1 + load(gauss.nodes, i)));
        }
    }
    return sum(total);
}

} // namespace

struct TwoWaves::Ends {
    Ball G, P;
    Real G_near, P_near;
    double tolerance;
    Gauss gauss;
    double rule; ///< error of the rule on [-1, 1], per unit of the integrand on the ellipse
    Ball lower, bottom, top;

    Ends(const Ball& G_, const Ball& P_, double tolerance_)
        : G(G_), P(P_), G_near(to_real(G_)), P_near(to_real(P_)), tolerance(tolerance_),
          gauss(4 * static_cast<int>(std::ceil((4 - std::log10(tolerance_)) * std::log(10.0) / (2 * std::log(rho)) / 4)))
    {
        const WorkingPrecision precision(end_bits);
        lower = P * P / 4;
        bottom = P - 1;
        top = P + 1;
        rule = margin * gauss_error(rho, gauss.nodes.size());
    }

    Ball at(Point p, const Ball& x, bool full_first) const
    {
        switch (p) {
        case Point::lower: return lower;
        case Point::bottom: return bottom;
        case Point::top: return top;
        case Point::begin: return (x - 1) / G;
        case Point::end: return full_first ? (x + 1) / G : 2 * sqrt(x) / G;
        case Point::seam: break;
        }
        return Ball(1);
    }
};

namespace {

/// The integral at one x.
class AtX {
public:
    AtX(const TwoWaves::Ends& ends, const Ball& x) : ends_(ends), x_(x), full_(!certainly(less(x, Ball(1))))
    {
        if (full_ && possibly(less(x, Ball(1)))) throw Unclear();
        // y < 1
        if (sign(Point::lower, Point::seam) < 0 && sign(Point::bottom, Point::seam) < 0 && sign(Point::end, Point::lower) > 0
            && !(full_ && sign(Point::begin, Point::seam) >= 0)) {
            std::vector<Point> left{Point::lower};
            if (full_) left.insert(sign(Point::begin, Point::lower) > 0 ? left.begin() : left.end(), Point::begin);
            add(false, left.front(), left, sign(Point::end, Point::seam) >= 0 ? Point::seam : Point::end, {Point::end});
        }
        // y >= 1
        if (sign(Point::end, Point::seam) > 0 && sign(Point::end, Point::bottom) > 0 && !(full_ && sign(Point::begin, Point::top) >= 0)) {
            std::vector<Point> left{Point::bottom}, right{Point::top};
            if (full_) left.insert(sign(Point::begin, Point::bottom) > 0 ? left.begin() : left.end(), Point::begin);
            right.insert(sign(Point::end, Point::top) < 0 ? right.begin() : right.end(), Point::end);
            add(true, sign(left.front(), Point::seam) >= 0 ? left.front() : Point::seam, left, right.front(), right);
        }
    }

    /// The value, and a bound of its error.
    std::pair<Real, double> value() const
    {
        Real sum = 0;
        double error = 0;
        for (const Side& side : sides_) {
            const Half<Real> h = half(side);
            const auto [cuts, lost] = panels(h);
            if (!(lost < infinite)) return {sum, infinite};
            sum += integral(h, cuts, ends_.gauss);
            error += lost;
        }
        sum = sum * inverse_pi * inverse_pi;
        return {sum, margin * (error / (pi_below * pi_below) +
                               2000 * u * std::fabs(sum.high))}; // all terms are positive, distances are sums of positive terms
    }

private:
    /// of p - q
    int sign(Point p, Point q) const
    {
        const WorkingPrecision precision(end_bits);
        const Ball d = ends_.at(p, x_, full_) - ends_.at(q, x_, full_);
        if (certainly(less(Ball(0), d))) return 1;
        if (certainly(less(d, Ball(0)))) return -1;
        if (arb_is_zero(d.get())) return 0;
        throw Unclear();
    }
    Ball difference(Point p, Point q) const
    {
        if (p == q) return Ball(0);
        const WorkingPrecision precision(end_bits);
        return ends_.at(p, x_, full_) - ends_.at(q, x_, full_);
    }
    Real distance(Point p, Point q) const
    {
        const Ball d = difference(p, q);
        if (!d.is_exact() && d.relative_bits() < 110) throw Unclear();
        return abs(to_real(d));
    }

    void add(bool full, Point a, const std::vector<Point>& left, Point b, const std::vector<Point>& right)
    {
        for (const bool from_left : {true, false}) {
            const auto &near = from_left ? left : right, &far = from_left ? right : left;
            Side s{};
            s.full = full;
            s.left = from_left;
            s.from = from_left ? a : b;
            s.to = from_left ? b : a;
            s.nears = static_cast<int>(near.size());
            s.fars = static_cast<int>(far.size());
            std::copy(near.begin(), near.end(), s.near);
            std::copy(far.begin(), far.end(), s.far);
            const double first = double(distance(near[0], s.from));
            if (near.size() == 2) s.paired = near[0] == s.from || double(distance(near[1], s.from)) >= 2 * first;
            if (!s.paired) {
                const double P = double(ends_.P_near);
                s.delta = near.size() == 2 ? first
                          : full           ? 1
                          : from_left      ? P * P / 4
                                           : std::hypot(double(distance(Point::seam, Point::end)), P);
            }
            sides_.push_back(s);
        }
    }

    Half<Real> half(const Side& side) const
    {
        const WorkingPrecision precision(end_bits);
        Half<Real> h;
        h.full_first = full_;
        h.full = side.full;
        h.left = side.left;
        h.made_up = !side.paired;
        h.second = side.nears == 2 && !side.paired;
        h.fars = side.fars;
        const Real first = distance(side.near[0], side.from), length = distance(side.to, side.from) * 0.5;
        const Real delta = side.paired ? distance(side.near[1], side.near[0]) : Real(side.delta);
        h.x = to_real(x_);
        h.one_minus_x = full_ ? Real(0) : to_real(1 - x_); // not used where x >= 1
        h.G = ends_.G_near;
        h.P = ends_.P_near;
        h.from = to_real(ends_.at(side.from, x_, full_));
        h.to_one = side.full ? Real(0) : distance(Point::seam, side.from); // y <= 1
        h.wave_end = to_real(ends_.at(Point::end, x_, full_));
        h.beyond = first + delta;
        h.gap = side.nears == 2 ? distance(side.near[1], side.from) : Real(0);
        for (int k = 0; k < 2; ++k) h.far[k] = k < side.fars ? distance(side.far[k], side.from) : Real(1);
        h.quarter = delta / 4;
        h.s0 = 2 * sqrt(first / delta);
        const Real ratio = length / delta, s1 = sqrt(h.s0 * h.s0 + 4 * ratio), r0 = sqrt(1 + h.s0 * h.s0 / 4), r1 = sqrt(1 + s1 * s1 / 4);
        h.tau0 = h.s0 / 2 + r0;
        h.length = 2 * ratio / (s1 + h.s0) + ratio / (r0 + r1);
        return h;
    }

    /// Cuts of the variable, 0 ... 1, on which Gauss's rule will do, and its error.
    std::pair<std::vector<double>, double> panels(const Half<Real>& half) const
    {
        static const EllipseCover coarse(rho, 3, 1), fine(rho, 6, 3);
        const Half<Disc> h = in_discs(half);
        const double length = double(half.length), tau0 = double(half.tau0), share = ends_.tolerance / 512;
        std::vector<double> edges{1}, cuts{0};
        double t = tau0;
        while (t < 0.75 * length) t *= 2; // tau = 2 tau0, 4 tau0, ...
        for (t /= 2; t >= 0.99 * tau0 && length > tau0; t /= 2) edges.push_back(t / length);
        edges.push_back(0);
        double lost = 0;
        while (edges.size() > 1) {
            const double from = edges.back(), to = edges[edges.size() - 2], width = length * (to - from) / 2;
            double size = infinite; // of the integrand, times the width
            for (const EllipseCover* cover : {&coarse, &fine}) // three discs do for most panels
                if (!(ends_.rule * size <= share)) size = bound(h, length * (from + to) / 2, width, *cover) * width;
            if (ends_.rule * size <= share) {
                lost += margin * (ends_.rule + 16 * u) *
                        size; // halving makes the rule better, but not what rounding takes: that is charged, and asks for nothing
                cuts.push_back(to);
                edges.pop_back();
                continue;
            }
            if (cuts.size() + edges.size() > most_cuts) return {cuts, infinite};
            edges.insert(edges.end() - 1, (from + to) / 2);
        }
        return {cuts, lost};
    }
    /// Bounds the integrand on the ellipse about mid +- half.
    static double bound(const Half<Disc>& h, double mid, double half, const EllipseCover& cover)
    {
        const auto most = [&h](std::complex<double> centre, double radius) { return integrand(h, Disc(centre, radius)).most(); };
        return cover.bound(mid, half, most);
    }
    static Half<Disc> in_discs(const Half<Real>& h)
    {
        const auto d = [](const Real& v) { return Disc(std::complex<double>(v.high), 0); };
        return {h.full_first, h.full, h.left, h.made_up, h.second, h.fars, d(h.x), d(h.one_minus_x), d(h.G), d(h.P), d(h.from), d(h.to_one),
                d(h.wave_end), d(h.quarter), d(h.beyond), d(h.gap), {d(h.far[0]), d(h.far[1])}, d(h.tau0), d(h.s0), d(h.length)};
    }

    const TwoWaves::Ends& ends_;
    Ball x_;
    bool full_;
    std::vector<Side> sides_;
};

} // namespace

TwoWaves::TwoWaves(const Ball& G, const Ball& pressure, double tolerance) : ends_(std::make_unique<const Ends>(G, pressure, tolerance)) {}
TwoWaves::~TwoWaves() = default;
TwoWaves::TwoWaves(TwoWaves&&) noexcept = default;

double TwoWaves::lowest() const
{
    const double G = double(ends_->G_near), P = double(ends_->P_near),
                 x = G * (P < 2 ? P * P / 4 : P - 1); // the first wave has to reach the second's support
    return 0.999 * (x < 2 ? x * x / 4 : x - 1);
}

std::pair<Real, double> TwoWaves::value(const Ball& x) const
{
    try {
        return AtX(*ends_, x).value();
    }
    catch (const Unclear&) {
        return {0, infinite};
    }
}

double TwoWaves::on_disc(bool full_first, const Ball& x, double r) const
{
    // the ends of the first wave move by less than 0.3 of their distance from every point that matters
    constexpr double share = wave::disc_two_waves.share, most = wave::disc_two_waves.most;
    const WorkingPrecision precision(end_bits);
    const double x_ = double(to_real(x)), G = double(ends_->G_near);
    if (!full_first && (!(r < share * double(to_real(1 - x))) || !(r < share * x_))) return infinite;
    const double moved = margin * (full_first ? r / G : 2 * r / (G * std::sqrt(x_)));
    double nearest = full_first ? 2 / G : infinite;
    for (const Point end : {Point::begin, Point::end}) {
        if (end == Point::begin && !full_first) continue;
        const Ball y = ends_->at(end, x, full_first);
        const auto consider = [&](const Ball& s) { nearest = min(nearest, std::fabs(double(to_real(y - s)))); };
        if (ends_->P_near <= 2) {
            consider(ends_->lower);
            consider(Ball(1));
        }
        if (ends_->P_near >= 2) consider(ends_->bottom);
        consider(ends_->top);
    }
    if (!(moved < share * nearest)) return infinite;
    const auto [v, error] = value(x);
    return margin * most * (std::fabs(v.high) + error);
}

second_wave::Bound second_wave::bound(double P)
{
    Bound b{{{P + 1, 0.32}}, P > 1.25 ? 0 : 0.38};
    if (P <= 2) b.roots.push_back({P * P / 4, 0.36 * std::sqrt((1 + 2 / P) / 5)}); // R >= P
    if (P > 1.25) b.roots.push_back({P - 1, 0.32}); // 1/(u v)^(1/2) <= u^(-1/2) + v^(-1/2), u + v = 2
    return b;
}

double second_wave::first_wave(double G, double x, double s)
{
    return x >= 1 ? 2 * std::sqrt(G) / pi_below : 2 * std::sqrt(2.0) / (pi_below * std::sqrt(G) * s); // both ends, resp. one
}

double TwoWaves::weight_on(double x, double width) const
{
    // d(y) <= sum of c |y - s|^(-1/2); within `near` of s also k(x, y) <= c_k |y - e|^(-1/2), e the ends of the first wave
    const double G = double(ends_->G_near), P = double(ends_->P_near);
    double sum = 0;
    const auto singular = [&](double s, double c) {
        const double near = min({s / 2, 1 / (2 * G)}), c_k = second_wave::first_wave(G, x, s);
        sum += c * (1 / std::sqrt(near) + c_k * levels::two_roots_on(near, width, G));
    };
    if (P < 0.5) {
        const double lower = P * P / 4, near = min(lower / 2, 1 / (2 * G));
        singular(lower, second_wave::at_lower * P);          // y <= 3/2 lower < 0.1: 1 - y <= R <= 1.12
        sum += second_wave::below_half * P / std::sqrt(near); // y <= 1/2: R >= 1/2
        sum += 1.52 * second_wave::about_one * std::sqrt(G / 2); // 1/2 <= y <= 1: R >= 1 - y, P; over t as about_one P/t = R^(3/2)
        singular(P + 1, second_wave::at_top);                // y >= 1: y - P + 1 >= 3/2
    }
    else {
        const auto d = second_wave::bound(P);
        for (const auto& [at, factor] : d.roots) singular(at, factor);
        sum += d.elsewhere;
    }
    return margin * sum;
}

} // namespace touchstone::transfer
