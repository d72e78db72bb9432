// SPDX-License-Identifier: MIT
#include "touchstone/quadrature/strip.hpp"

#include "touchstone/quadrature/widen.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <cstdint>
#include <optional>
#include <unordered_map>

namespace touchstone::quadrature {
namespace {

Ball exactly(double x) { return Ball::exactly(x); }

ComplexBall conjugate(ComplexBall z)
{
    acb_conj(z.get(), z.get());
    return z;
}

/// Two functions at an exact place, kept: pieces share their sides.
template <class F>
const std::pair<Ball, Ball>& kept_at(double x, F&& both)
{
    thread_local std::unordered_map<double, std::pair<Ball, Ball>> known;
    constexpr std::size_t most = 4000;
    if (const auto found = known.find(x); found != known.end()) return found->second;
    if (known.size() > most) known.clear();
    std::pair<Ball, Ball> pair;
    both(pair.first.get(), pair.second.get(), exactly(x).get(), strip_bits);
    return known.emplace(x, std::move(pair)).first->second;
}
std::pair<Ball, Ball> sin_cos(double y)
{
    return kept_at(y, [](auto... a) { arb_sin_cos(a...); });
}
std::pair<Ball, Ball> sinh_cosh(double x)
{
    return kept_at(x, [](auto... a) { arb_sinh_cosh(a...); });
}

struct FarAndNear {
    ComplexBall far, near, log_one_plus_e; // 1/(1 + E), E/(1 + E), log(1 + E)
};

/// An interval of real numbers with binary64 ends. Each operation rounds to nearest, so to within 2^-53 of its result (2^-1075 where that
/// is subnormal), and the ends are moved outwards by more.
struct Span {
    double low = 0, high = 0;

    explicit Span(double x)
        : low(x)
        , high(x)
    {
    }
    Span(double l, double h)
        : low(l)
        , high(h)
    {
    }
    explicit Span(const Ball& x)
    {
        Ball end;
        arb_get_lbound_arf(arb_midref(end.get()), x.get(), strip_bits);
        low = arf_get_d(arb_midref(end.get()), ARF_RND_FLOOR);
        arb_get_ubound_arf(arb_midref(end.get()), x.get(), strip_bits);
        high = arf_get_d(arb_midref(end.get()), ARF_RND_CEIL);
    }
    Ball ball() const
    {
        const double middle = low / 2 + high / 2;
        Ball x = exactly(middle);
        mag_set_d(arb_radref(x.get()), std::nextafter(std::max(high - middle, middle - low), std::numeric_limits<double>::infinity()));
        if (!std::isfinite(high - low)) return Ball::indeterminate();
        return x;
    }
    friend Span operator-(const Span& a) { return {-a.high, -a.low}; }
    friend Span operator+(const Span& a, const Span& b) { return outwards(a.low + b.low, a.high + b.high); }
    friend Span operator-(const Span& a, const Span& b) { return a + (-b); }
    friend Span operator*(const Span& a, const Span& b)
    {
        const double p = a.low * b.low, q = a.low * b.high, r = a.high * b.low, t = a.high * b.high;
        return outwards(std::min({p, q, r, t}), std::max({p, q, r, t}));
    }
    /// b > 0
    friend Span operator/(const Span& a, const Span& b)
    {
        if (!(b.low > 0)) return {-HUGE_VAL, HUGE_VAL};
        return outwards(std::min(a.low / b.low, a.low / b.high), std::max(a.high / b.low, a.high / b.high));
    }
    friend Span sqrt(const Span& a) { return outwards(std::sqrt(std::max(0.0, a.low)), std::sqrt(std::max(0.0, a.high))); }

private:
    static Span outwards(double low, double high)
    {
        return {low - (std::fabs(low) * 0x1p-51 + 0x1p-1060), high + (std::fabs(high) * 0x1p-51 + 0x1p-1060)};
    }
};

/// The least interval that has all values of a function on a box, from those at its corners and at the places where it may be largest.
class Range {
public:
    void take(const Span& v)
    {
        all_ = empty_ ? v : Span(std::min(all_.low, v.low), std::max(all_.high, v.high));
        empty_ = false;
    }
    const Span& span() const { return all_; }
    Span low() const { return Span(all_.low); }
    Span high() const { return Span(all_.high); }

private:
    Span all_{0};
    bool empty_ = true;
};

/// Whether an angle of [low, high] may be congruent to `at` modulo 2 pi. In double with room to spare: where in doubt, yes.
/// arccos of a number that is off by 2^-52 is off by 3e-8 at most, next to 1, where it is steepest.
bool may_meet(double low, double high, double at)
{
    constexpr double spare = 1e-7;
    const double k = std::ceil((low - at) / (2 * M_PI) - spare);
    return !(at + 2 * M_PI * k > high + spare * (1 + std::fabs(high)));
}

/// For E = exp(-w), w = x + iy, 0 <= re1 <= x <= re2, im1 <= y <= im2. With e = exp(-x), c = cos y, s = sin y,
/// D = |1 + E|^2 = 1 + 2ec + e^2: 1/(1 + E) = (1 + ec + i es)/D = (1 + tanh(w/2))/2, E/(1 + E) = (e(c + e) - i es)/D,
/// log(1 + E) = log(D)/2 - i atan2(es, 1 + ec). Their parts are monotone in x and in c (or s) but at the places named below, so corners and
/// those places bound them (tanh_sinh.md, section 2).
FarAndNear far_and_near(const Ball& re1, const Ball& re2, const Ball& im1, const Ball& im2)
{
    const FarAndNear nothing{ComplexBall::indeterminate(), ComplexBall::indeterminate(), ComplexBall::indeterminate()};
    const double y1 = arf_get_d(arb_midref(im1.get()), ARF_RND_DOWN), y2 = arf_get_d(arb_midref(im2.get()), ARF_RND_UP);
    constexpr double farthest = 1e5; // beyond, angles in double are too coarse
    if (!(y2 < farthest)) return nothing;
    const std::array<Ball, 2> size{exp(-re2), exp(-re1)};
    std::array<Ball, 2> sine, cosine;
    arb_sin_cos(sine[0].get(), cosine[0].get(), im1.get(), strip_bits);
    arb_sin_cos(sine[1].get(), cosine[1].get(), im2.get(), strip_bits);
    const std::array<Span, 2> e{Span(size[0]), Span(size[1])}, s{Span(sine[0]), Span(sine[1])}, cos_y{Span(cosine[0]), Span(cosine[1])};
    const Span one(1);
    Range c;
    for (const Span& v : cos_y) c.take(v);
    if (may_meet(y1, y2, 0)) c.take(one);
    if (may_meet(y1, y2, M_PI)) c.take(-one);

    Range d, far_real, near_real, imaginary;
    for (const Span& r : e)
        for (const Span& v : {c.low(), c.high()}) {
            const Span modulus = one + r * (v + v + r);
            d.take(modulus);
            far_real.take((one + r * v) / modulus);
            near_real.take(r * (v + r) / modulus);
        }
    const Span opposite = -c.low(), square = one - opposite * opposite;
    const auto may_be_between = [&](const Span& low, const Span& high) { return opposite.high >= low.low && opposite.low <= high.high; };
    if (may_be_between(e[0], e[1])) d.take(square); // D is least at e = -c
    const auto secant = [&](const Span& r) { return (r + r) / (one + r * r); }; // 1/cosh x
    if (may_be_between(secant(e[0]), secant(e[1]))) { // where c cosh x = -1 the real parts are (1 +- 1/sqrt(1 - c^2))/2, beyond 1 and 0
        const Span root = sqrt(square), beyond = opposite * opposite / (root * (one + root) * Span(2));
        far_real.take(one + beyond);
        near_real.take(-beyond);
    }
    if (!(d.span().low > 0)) return nothing;

    std::optional<Ball> angle;
    const auto take_angle = [&](const Ball& v) { angle = angle ? touchstone::hull(*angle, v) : v; };
    for (const std::size_t i : {0, 1}) {
        for (const std::size_t k : {0, 1}) {
            const Span along = one + e[i] * cos_y[k], across = e[i] * s[k];
            imaginary.take(across / (along * along + across * across));
            take_angle(atan2(across.ball(), along.ball()));
        }
        // for fixed e the angle is extreme where cos y = -e, the imaginary part where cos y = -2e/(1 + e^2)
        const double middle = std::min(1.0, e[i].high);
        for (const double sign : {1.0, -1.0}) {
            if (may_meet(y1, y2, M_PI - sign * std::acos(middle)))
                take_angle(Ball(static_cast<long>(sign)) * asin(at_most(size[i], Ball(1))));
            if (may_meet(y1, y2, M_PI - sign * std::acos(2 * middle / (1 + middle * middle))))
                imaginary.take(Span(sign) * e[i] / (one - e[i] * e[i]));
        }
    }
    const Ball half_log = touchstone::hull(log(exactly(d.span().low)), log(exactly(d.span().high))) / Ball(2);
    const Ball across = imaginary.span().ball();
    return {ComplexBall(far_real.span().ball(), across), ComplexBall(near_real.span().ball(), -across), ComplexBall(half_log, -*angle)};
}

struct Key {
    std::array<double, 4> corner;
    Side side;
    Transformation transformation;
    bool operator==(const Key&) const = default;
};
struct KeyHash {
    std::size_t operator()(const Key& k) const
    {
        std::uint64_t h =
            (k.side == Side::left ? 0x9e3779b97f4a7c15u : 0) + (k.transformation == Transformation::logistic ? 0x7f4a7c15u : 0);
        for (const double c : k.corner) h = (h ^ std::bit_cast<std::uint64_t>(c)) * 0xff51afd7ed558ccdu + (h >> 29);
        return static_cast<std::size_t>(h ^ (h >> 32));
    }
};

/// The box that w is in, and an upper bound of |dw/dt|.
struct Image {
    Ball re1, re2, im1, im2, stretch;
};
Image image(double x1, double x2, double y1, double y2, Transformation transformation)
{
    if (transformation == Transformation::logistic) return {exactly(x1), exactly(x2), exactly(y1), exactly(y2), Ball(1)};
    const Ball pi = touchstone::pi<Ball>();
    const auto [s1, c1] = sin_cos(y1);
    const auto [s2, c2] = sin_cos(y2);
    const auto [sh1, ch1] = sinh_cosh(x1);
    const auto [sh2, ch2] = sinh_cosh(x2);
    // every factor is monotone and non-negative on the piece; |cosh(x + iy)|^2 = sinh^2 x + cos^2 y
    return {pi * sh1 * c2, pi * sh2 * c1, pi * ch1 * s1, pi * ch2 * s2, pi * sqrt(sh2 * sh2 + c1 * c1)};
}

} // namespace

StripPiece StripPiece::finite(Side side, double x1, double x2, double y1, double y2, Transformation transformation)
{
    StripPiece piece;
    piece.side_ = side;
    piece.x1_ = x1;
    piece.x2_ = x2;
    const auto [re1, re2, im1, im2, size_of_slope] = image(x1, x2, y1, y2, transformation);
    const ComplexBall w(hull(re1, re2), hull(im1, im2));
    const FarAndNear map = far_and_near(re1, re2, im1, im2);
    const ComplexBall &far = map.far, &near = map.near;
    const ComplexBall log_far = -map.log_one_plus_e;
    const ComplexBall log_near = log_far - w;
    const bool left = side == Side::left;
    piece.far_ = left ? conjugate(far) : far;
    piece.near_ = left ? conjugate(near) : near;
    piece.log_far_ = left ? conjugate(log_far) : log_far;
    piece.log_near_ = left ? conjugate(log_near) : log_near;
    piece.stretch_ = size_of_slope;
    return piece;
}

StripPiece StripPiece::endless(Side side, double x1, double y2, Transformation transformation)
{
    StripPiece piece;
    piece.side_ = side;
    piece.endless_ = true;
    piece.x1_ = x1;
    piece.x2_ = std::numeric_limits<double>::infinity();
    if (transformation == Transformation::logistic) {
        piece.depth_ = exactly(x1);
        piece.slope_ = exactly(y2) / piece.depth_; // |Im w| <= y2
    }
    else {
        const auto [s, c] = sin_cos(y2);
        const auto [sinh, cosh] = sinh_cosh(x1);
        piece.depth_ = touchstone::pi<Ball>() * sinh * c;
        piece.slope_ = s / c * cosh / sinh; // |Im w| = pi cosh x sin y <= rho tan d coth x1
    }
    const Ball e = exp(-piece.depth_);            // |E| <= e < 1
    const Ball near = e / (Ball(1) - e);          // |E/(1 + E)|
    const Ball log_far = -log(Ball(1) - e);       // |log(1 + E)|
    piece.near_ = disc(near);
    piece.far_ = ComplexBall(1) + disc(near);
    piece.log_near_ = ComplexBall::indeterminate();
    piece.log_far_ = disc(log_far);
    if (transformation == Transformation::logistic) piece.turn_ = exactly(y2); // arg(1 + E) is between 0 and arg E
    return piece;
}

/// The distance is exp(-w') times 1/(1 + E), with Re w' = rho >= A = depth: |u|^e rho^k is at most
/// (1 - exp(-A))^-e times the sup of exp(-e rho) rho^k, taken at A or at rho = k/e.
ComplexBall StripPiece::vanishing(Side s, const Ball& e, const Exponent& k) const
{
    if (!reaches(s) || !arb_is_nonnegative(e.get())) return ComplexBall::indeterminate();
    const Ball exponent = k.ball();
    const auto size = [&](const Ball& rho) { return exp(exponent * log(rho) - e * rho); };
    if (arb_is_zero(e.get())) { // rho^k alone: real, from 0 to A^k
        if (Exponent(0) < k) return ComplexBall::indeterminate();
        return ComplexBall(hull(Ball(0), size(depth_)));
    }
    Ball top = size(depth_);
    if (Exponent(0) < k) top = size(at_least(exponent / e, depth_)); // decreasing from there on
    return disc(top * exp(-e * log(Ball(1) - exp(-depth_))));
}

/// log u = -w' - log(1 + E): over rho it is -1 + i[-slope, slope] + (log_far)/A.
ComplexBall StripPiece::logarithm_over_rho(Side s) const
{
    if (!reaches(s)) return ComplexBall::indeterminate();
    const Ball log_far = -log(Ball(1) - exp(-depth_));
    return ComplexBall(Ball(-1), hull(-slope_, slope_)) + disc(log_far / depth_);
}

std::optional<Ball> StripPiece::turn(Side s) const { return reaches(s) ? turn_ : std::nullopt; }

StripPiece StripPiece::at(Side side, double x1, double x2, double y1, double y2, Transformation transformation)
{
    thread_local std::unordered_map<Key, StripPiece, KeyHash> cache;
    const Key key{{x1, x2, y1, y2}, side, transformation};
    if (const auto found = cache.find(key); found != cache.end()) return found->second;
    if (cache.size() > 40000) cache.clear();
    const WorkingPrecision precision(strip_bits);
    return cache.emplace(key, std::isinf(x2) ? endless(side, x1, y2, transformation) : finite(side, x1, x2, y1, y2, transformation))
        .first->second;
}

const StripPiece& StripPiece::everywhere()
{
    thread_local const StripPiece piece = [] {
        StripPiece p;
        p.near_ = p.far_ = p.log_near_ = p.log_far_ = ComplexBall::indeterminate();
        p.stretch_ = p.depth_ = Ball::indeterminate();
        return p;
    }();
    return piece;
}

} // namespace touchstone::quadrature
